//! The drawings of exercise 16.2; those over w/w0, w0 = sqrt(g/l), hold for every pendulum.

use super::*;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack, View};
use rotation_dynamics::report::{Figure, MovingPicture, Trajectory, sampled, times};

/// All figures of the page.
pub fn figures(_: &Parameters) -> Result<Vec<Figure>> {
    let all = [setup, angle, reaction, potential, frequencies];
    all.into_iter().map(|draw| draw()).collect()
}

/// q at the rate w/w0.
fn q(rate: f64) -> f64 {
    1.0 / (rate * rate)
}

fn over_rate(name: &str, alt: &str, y: Axis) -> Panel {
    let x = Axis::linear(r"$\omega/\omega_0$").range(0.0, 2.6);
    Panel::new(name, alt).x(x).y(y)
}

fn exact(from: f64, f: impl Fn(f64) -> f64) -> Curve {
    Curve::of(times(from, 2.6, (260.0 - 100.0 * from) as u32), f, Ink::Ink)
}

/// Simulations at eight rates, but for the first `skipped`; three are below the threshold.
fn simulated(skipped: usize, f: impl Fn(f64) -> Result<f64>) -> Result<Curve> {
    let rates = [0.3, 0.6, 0.85, 1.1, 1.3, 1.6, 2.0, 2.4];
    Ok(Curve::sampled(rates.into_iter().skip(skipped), f, Ink::Body)?.dots())
}

fn setup() -> Result<Figure> {
    let (s, c, o) = (sin(0.62), cos(0.62), (0.0, 0.0));
    let arc = |from, to| times(from, to, 60).map(|a| (s * cos(a), 0.2 * s * sin(a) - c));
    let alt = "A string of length l hangs from the point O of a ceiling and makes the angle theta \
               with the vertical. The bob of mass M at its end runs on a horizontal circle.";
    let circle = Curve::new(arc(0.0, 2.0 * PI), Ink::Frame);
    let axis = Curve::new([o, (0.0, -1.05)], Ink::Frame);
    let (angle, down) = ((-FRAC_PI_2, 0.62 - FRAC_PI_2), (-0.65, -0.55));
    Sketch::new("setup", alt)
        .window((-0.85, 0.95), (-1.1, 0.16))
        .wall((0.5, 0.0), (-0.5, 0.0))
        .curve(circle.thin().dashed())
        .curve(axis.thin().dashed())
        .curve(Curve::new([o, (s, -c)], Ink::Ink))
        .angle(o, 0.34, angle, r"$\theta$")
        .arrow_along(arc(3.6, 5.2), Ink::Velocity)
        .text((-0.3, -1.0), r"$\omega$", Ink::Velocity, Side::Centre)
        .text((0.5 * s, -0.5 * c), "$l$", Ink::Ink, Side::Right)
        .text((0.0, 0.02), "$O$", Ink::Frame, Side::AboveLeft)
        .arrow((-0.65, -0.25), down, Ink::Frame, "$g$", Side::Left)
        .disc((s, -c), 0.05, Ink::Body, 1.0)
        .text((s + 0.05, -c), "$M$", Ink::Body, Side::Right)
        .figure()
}

fn angle() -> Result<Figure> {
    let alt = "Angle of rest against the rate: zero up to the threshold, where the line splits in \
               two that rise steeply on either side and bend towards a right angle. Zero goes on, \
               dashed. The simulated dots lie on the upper branch.";
    let hangs = Curve::new([(1.0, 0.0), (2.6, 0.0)], Ink::Ink);
    let theta = Axis::angle(r"$\theta$ / rad").range(-FRAC_PI_2, FRAC_PI_2);
    over_rate("angle", alt, theta)
        .curve(exact(0.0, |x| cone(q(x))).label_at("stable", 1.3, 0.95, Side::Left))
        .curve(exact(0.0, |x| -cone(q(x))))
        .curve(hangs.dashed().label("unstable"))
        .curve(simulated(0, |x| settled(q(x), 1e-9))?.label("simulated"))
        .figure()
}

fn reaction() -> Result<Figure> {
    let alt = "Tension over the weight against the rate: one up to the threshold, then, after a \
               corner, the square of the rate over the threshold, nearly seven at the right end.";
    let pull = |x| Ok(tension(q(x), &in_space([settled(q(x), 1e-9)?, 0.0], 0.0)) / q(x));
    over_rate("reaction", alt, Axis::linear("$T/Mg$").range(0.0, 7.0))
        .curve(exact(0.0, |x| (x * x).max(1.0)))
        .curve(simulated(0, pull)?.label("simulated"))
        .figure()
}

fn potential() -> Result<Figure> {
    let alt = "Effective potential against the angle for three rates. Slow: one well, at zero. At \
               the threshold: one well with a flat bottom. Fast: a hump at zero between two wells.";
    let axes = Panel::new("potential", alt)
        .x(Axis::angle(r"$\theta$ / rad").range(-2.0, 2.0))
        .y(Axis::linear("$U/Mgl$").range(-1.5, 0.0));
    let well = |panel: Panel, x: f64| {
        let u = |a: f64| -cos(a) - 0.5 * x * x * sin(a) * sin(a);
        let (label, rest) = (format!("{x:.1}"), cone(q(x)));
        let curve = Curve::of(times(-2.0, 2.0, 160), u, Ink::Energy);
        let curve = curve.label_at(&label, 1.0, u(1.0), Side::Right);
        panel
            .curve(curve)
            .dot(rest, u(rest), Ink::Body, "", Side::Below)
    };
    [0.6, 1.0, 1.6].into_iter().fold(axes, well).figure()
}

fn frequencies() -> Result<Figure> {
    let alt = "Angular frequency of small oscillations against the rate. With the plane kept \
               turning it falls from one to zero at the threshold and rises beyond; with the bob \
               left to itself it starts at two and grows slowly. Both approach the rate itself.";
    let y = Axis::linear(r"$\Omega/\omega_0$").range(0.0, 3.0);
    let low = exact(0.01, |x| x * driven(q(x)));
    let high = exact(1.0, |x| x * free(q(x)));
    over_rate("frequencies", alt, y)
        .curve(Curve::new([(0.0, 0.0), (2.6, 2.6)], Ink::Frame).dotted())
        .curve(low.label_at("plane kept turning", 1.35, 0.8, Side::Right))
        .curve(high.label_at("left to itself", 1.8, 2.15, Side::AboveLeft))
        .curve(simulated(0, |x| Ok(x * measured_driven(q(x))?))?)
        .curve(simulated(3, |x| Ok(x * measured_free(q(x))?))?)
        .figure()
}

/// Nine turns and a bit, so that the bob ends in profile; time in 1/w.
const END: f64 = 58.72;

/// The damped motion from the release.
fn motion(p: &Parameters) -> Result<Solution<2>> {
    swung(ratio(p)?, 0.12, p.release, END, p.tolerance)
}

/// That motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (run, columns) = (motion(p)?, ["t [s]", "theta [rad]", "omega [rad/s]"]);
    let row = |t| run.at(t).map(|y| [t / p.rate, y[0], y[1] * p.rate]);
    Trajectory::sampled(columns, times(0.0, END, 600), row)
}

/// That motion with the forces; weight and tension to scale.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (q, w, run) = (ratio(p)?, p.rate, motion(p)?);
    let angle = sampled(times(0.0, END, 300), |t| Ok((t / w, run.at(t)?[0])))?;
    let graph = Panel::new("graph", "").over("$t$ / s", r"$\theta$ / rad");
    let graph = graph.curve(Curve::new(angle, Ink::Body));
    let (top, weight) = (SpaceVector::zero(), SpaceVector::new(0.0, 0.0, -0.4));
    let draw = move |t: f64| {
        let turn = (t * w).min(END);
        let state = |turn| Ok(in_space(run.at(turn)?, turn));
        let place = |turn| Ok(vectors(&state(turn)?)[0]);
        let bob = place(turn)?;
        let pull = bob * (-0.4 * tension(q, &state(turn)?) / q);
        let path = sampled(times((turn - 6.0).max(0.0), turn, 60), place)?;
        let sum = pull + weight;
        let slant = atan2(sum.z().abs(), hypot(sum.x(), sum.y())).to_degrees();
        let been = ["", ", where it has just been"][usize::from(t > 0.0)];
        let alt = format!(
            "The bob {t:.1} s after its release{been}, its weight, the pull of the string, and \
             their sum, {slant:.0} degrees off the horizontal; below, its angle against time."
        );
        let scene = View::new("scene", &alt)
            .around(weight * 1.5, 0.9)
            .dashed([top, weight * 3.0], Ink::Frame)
            .dashed(path, Ink::Body)
            .line([top, bob], Ink::Ink)
            .dot(bob, Ink::Body, "", Side::Below)
            .arrow(bob, bob + weight, Ink::Force, "$Mg$", Side::Below)
            .arrow(bob, bob + pull, Ink::Force, "$T$", Side::Above)
            .arrow(bob, bob + sum, Ink::Force, "sum", Side::Left);
        Stack::frame(&alt, scene, &graph, t)
    };
    MovingPicture::new(0.0..=END / w, [0.0, 2.17 / w, END / w], draw)
}
