//! The drawings of exercise 16.2; those over w/w0, w0 = sqrt(g/l), hold for every pendulum.

use super::*;

/// q at the rate w/w0.
fn q(rate: f64) -> f64 {
    1.0 / (rate * rate)
}

/// Over the rate; three of those simulated are below the threshold.
fn rates() -> Sweep {
    Sweep::over(r"$\omega/\omega_0$", 0.0, 2.6).at([0.3, 0.6, 0.85, 1.1, 1.3, 1.6, 2.0, 2.4])
}

figures! { _: &Parameters;
    /// A string of length l hangs from the point O of a ceiling and makes the angle theta with the vertical.
    /// The bob of mass M at its end runs on a horizontal circle.
    setup: {
        let (s, c, o) = (sin(0.62), cos(0.62), (0.0, 0.0));
        let arc = |from, to| times(from, to, 60).map(|a| (s * cos(a), 0.2 * s * sin(a) - c));
        Sketch::within((-0.85, 0.95), (-1.1, 0.16))
            .wall((0.5, 0.0), (-0.5, 0.0))
            .guide(arc(0.0, 2.0 * PI)).guide([o, (0.0, -1.05)])
            .angle(o, 0.34, (-FRAC_PI_2, 0.62 - FRAC_PI_2), r"$\theta$")
            .arrow_along(arc(3.6, 5.2), Ink::Velocity).text((-0.3, -1.0), r"$\omega$", Ink::Velocity, Side::Centre)
            .string(o, (s, -c), "$l$", Side::Right).text((0.0, 0.02), "$O$", Ink::Frame, Side::AboveLeft)
            .gravity((-0.65, -0.25), 0.3)
            .weight((s, -c), 0.05, "$M$")
    };

    /// Angle of rest against the rate: zero up to the threshold, where the line splits in two that rise steeply
    /// on either side and bend towards a right angle. Zero goes on, dashed. The simulated dots lie on the upper
    /// branch.
    angle: rates().panel(Axis::angle(r"$\theta$ / rad").range(-FRAC_PI_2, FRAC_PI_2))
        .curve(rates().exact(|x| cone(q(x))).label_at("stable", 1.3, 0.95, Side::Left))
        .curve(rates().exact(|x| -cone(q(x))))
        .curve(Curve::new([(1.0, 0.0), (2.6, 0.0)], Ink::Ink).dashed().label("unstable"))
        .curve(rates().simulated(|x| settled(q(x), 1e-9))?.label("simulated"));

    /// Tension over the weight against the rate: one up to the threshold, then, after a corner, the square of
    /// the rate over the threshold, nearly seven at the right end.
    reaction: {
        let at_rest = |x| Ok::<_, kit::Error>(place_and_velocity(&in_space([settled(q(x), 1e-9)?, 0.0], 1.0, 0.0)));
        let simulated = |x| Ok(tension(q(x), at_rest(x)?) / squares(q(x))[1]);
        let weights = Axis::linear("$T/Mg$").range(0.0, 7.0);
        rates().exact_and_simulated(weights, |x| (x * x).max(1.0), simulated)?
    };

    /// Effective potential against the angle for three rates. Slow: one well, at zero. At the threshold: one
    /// well with a flat bottom. Fast: a hump at zero between two wells.
    potential: {
        let (x, y) = (Axis::angle(r"$\theta$ / rad").range(-2.0, 2.0), Axis::linear("$U/Mgl$"));
        let well = |panel: Panel, x: f64| {
            let u = |a: f64| -cos(a) - 0.5 * x * x * sin(a) * sin(a);
            let (label, rest) = (format!("{x:.1}"), cone(q(x)));
            let curve = Curve::of(times(-2.0, 2.0, 160), u, Ink::Energy);
            let panel = panel.curve(curve.label_at(&label, 1.0, u(1.0), Side::Right));
            panel.dot(rest, u(rest), Ink::Body, "", Side::Below)
        };
        [0.6, 1.0, 1.6].into_iter().fold(Panel::over_axes(x, y.range(-1.5, 0.0)), well)
    };

    /// Angular frequency of small oscillations against the rate. With the plane kept turning it falls from one
    /// to zero at the threshold and rises beyond; with the bob left to itself it starts at two and grows
    /// slowly. Both approach the rate itself.
    frequencies: {
        let (low, high) = (rates().beyond(0.01), rates().beyond(1.0));
        let (kept, freed) = (low.exact(|x| x.max(1.0) * driven(q(x))), high.exact(|x| x * free(q(x))));
        rates().panel(Axis::linear(r"$\Omega/\omega_0$").range(0.0, 3.0))
            .curve(Curve::new([(0.0, 0.0), (2.6, 2.6)], Ink::Frame).dotted())
            .curve(kept.label_at("plane kept turning", 1.35, 0.8, Side::Right))
            .curve(freed.label_at("left to itself", 1.8, 2.15, Side::AboveLeft))
            .curve(low.simulated(|x| Ok(x.max(1.0) * measured_driven(q(x))?))?)
            .curve(high.simulated(|x| Ok(x * measured_free(q(x))?))?)
    };
}

/// Nine turns and a bit, so that the bob ends in profile.
const END: f64 = 58.72;

fn motion(p: &Parameters) -> Result<Solution<2>> {
    swung(ratio(p)?, 0.12, p.release, END, p.tolerance)
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let row = |t, [theta, rate]: [f64; 2]| [t / unit_rate(p), theta, rate * unit_rate(p)];
    Trajectory::of(&motion(p)?, ["t [s]", "theta [rad]", "omega [rad/s]"], 600, row)
}

/// That motion with the forces; weight and tension to scale.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (q, w, run) = (ratio(p)?, unit_rate(p), motion(p)?);
    let [turning, hanging] = squares(q);
    let turning = turning.sqrt().copysign(p.rate);
    let angle = sampled(times(0.0, END, 300), |t| Ok((t / w, run.at(t)?[0])))?;
    let graph = Panel::over_axes("$t$ / s", r"$\theta$ / rad").curve(Curve::new(angle, Ink::Body));
    let state = move |t: f64| -> Result<[SpaceVector; 2]> {
        Ok(place_and_velocity(&in_space(run.at(t)?, turning, turning * t)))
    };
    let all = || times(0.0, END, 600);
    let most = sampled(all(), |t| Ok(tension(q, state(t)?) / hanging))?;
    // So that the longest pull of the string fits, if it is more than three weights.
    let scale = 0.4 * (3.0 / most.into_iter().fold(3.0, f64::max));
    let highest = sampled(all(), |t| Ok(state(t)?[0].z()))?;
    let higher = 0.5 * highest.into_iter().fold(0.22, f64::max) - 0.11;
    let (top, down) = (SpaceVector::zero(), SpaceVector::new(0.0, 0.0, -0.4));
    MovingPicture::above(graph, 0.0..=END / w, [0.0, 2.17 / w, END / w], move |t| {
        let now = (t * w).min(END);
        let place = |t| Ok(state(t)?[0]);
        let bob = place(now)?;
        let weight = SpaceVector::new(0.0, 0.0, -scale);
        let pull = bob * (-scale * tension(q, state(now)?) / hanging);
        let path = sampled(times((now - 6.0).max(0.0), now, 60), place)?;
        let sum = pull + weight;
        let slant = atan2(sum.z().abs(), hypot(sum.x(), sum.y())).to_degrees();
        let been = if t > 0.0 { ", where it has just been" } else { "" };
        let alt = format!(
            "The bob {t:.1} s after its release{been}, its weight, the pull of the string, and \
             their sum, {slant:.0} degrees off the horizontal; below, its angle against time."
        );
        let centre = down * 1.5 + SpaceVector::new(0.0, 0.0, higher);
        let scene = View::of(centre, 0.9 + higher)
            .dashed([top, down * 3.0], Ink::Frame)
            .dashed(path, Ink::Body)
            .line([top, bob], Ink::Ink)
            .dot(bob, Ink::Body, "", Side::Below)
            .arrow(bob, bob + weight, Ink::Force, "$Mg$", Side::Below)
            .arrow(bob, bob + pull, Ink::Force, "$T$", Side::Above)
            .arrow(bob, bob + sum, Ink::Force, "sum", Side::Left);
        Ok((alt, scene))
    })
}
