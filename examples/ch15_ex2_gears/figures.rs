//! The drawings of exercise 15.2.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// A gear with this many teeth, the first at `turn`.
fn gear(sketch: Sketch, (x, y): (f64, f64), radius: f64, teeth: u32, turn: f64) -> Sketch {
    let pitch = TAU / f64::from(teeth);
    let outline = (0..teeth).flat_map(|k| {
        let middle = turn + pitch * f64::from(k);
        [(-0.31, -0.045), (-0.16, 0.05), (0.16, 0.05), (0.31, -0.045)].map(|(a, d)| {
            let (s, c) = sincos(middle + pitch * a);
            (x + (radius + d) * c, y + (radius + d) * s)
        })
    });
    let (s, c) = sincos(turn);
    let spoke = [(x, y), (x + 0.8 * radius * c, y + 0.8 * radius * s)];
    let sketch = sketch.body(outline, Ink::Body, 0.2).curve(Curve::new(spoke, Ink::Body).thin());
    sketch.dot((x, y), Ink::Ink, "", Side::Above)
}

/// A with 24 teeth about the origin and B with 12 that mesh, B's axis in this direction.
fn meshed(sketch: Sketch, arm: f64) -> Sketch {
    let (s, c) = sincos(arm);
    let sketch = gear(sketch, (0.0, 0.0), 1.0, 24, arm);
    gear(sketch, (1.5 * c, 1.5 * s), 0.5, 12, arm + PI + PI / 12.0)
}

figures! { p: &Parameters;
    /// A large gear A on the left and a smaller gear B on the right, whose teeth mesh. A has the radius R1 and
    /// turns counterclockwise at Omega 1. Both axes are held by the ground.
    setup: meshed(Sketch::within((-1.3, 2.3), (-1.3, 1.45)), 0.0)
        .turn((0.0, 0.0), 1.18, (1.2, 2.0), Ink::Velocity).text((-0.2, 1.2), r"$\Omega_1$", Ink::Velocity, Side::Above)
        .arrow_along([(0.0, 0.0), (-0.55, -0.78)], Ink::Ink).text((-0.3, -0.35), "$R_1$", Ink::Ink, Side::Left)
        .arrow_along([(1.5, 0.0), (1.5, -0.47)], Ink::Ink).text((1.5, -0.25), "$R_2$", Ink::Ink, Side::Right)
        .text((-0.6, 0.35), "$A$, $I_1$", Ink::Body, Side::Centre)
        .text((1.62, 0.58), "$B$, $I_2$", Ink::Body, Side::Above)
        .ring((0.0, 0.0), Ink::Ink, "", Side::Below)
        .ring((1.5, 0.0), Ink::Ink, "", Side::Below);

    /// Forces while B is set going: at the contact the rim of A pushes that of B upward; the bearing of B
    /// pushes downward with the same force, at the distance R1 + R2 from the axis of A. The motor turns A
    /// counterclockwise.
    forces: Sketch::within((-1.3, 2.3), (-1.5, 1.4))
        .disc((0.0, 0.0), 1.0, Ink::Body, 0.15)
        .disc((1.5, 0.0), 0.5, Ink::Body, 0.15)
        .guide([(0.0, 0.0), (1.5, 0.0)])
        .arrow_to((1.0, 0.0), (1.0, 0.75), Ink::Force, "on $B$", Side::Above)
        .arrow_to((1.5, 0.0), (1.5, -0.75), Ink::Force, "bearing on $B$", Side::Below)
        .arrow_along(times(-2.4, -0.9, 30).map(|a| (0.45 * cos(a), 0.45 * sin(a))), Ink::Force)
        .text((0.0, -0.45), "motor", Ink::Force, Side::Below)
        .dot((0.0, 0.0), Ink::Ink, "$A$", Side::Above)
        .dot((1.5, 0.0), Ink::Ink, "$B$", Side::Right);

    /// Angular momentum of both over that of A, against the ratio of radii. For gears of one mass and for gears
    /// of one thickness it is zero at the ratio one, negative below and rises towards one above, for those of
    /// one thickness faster. Dots: particles.
    momentum: {
        let of = |power: i32| Curve::of(times(0.75, 4.0, 120), move |r| 1.0 - r.powi(power), Ink::Momentum);
        let simulated = |power: i32| Curve::sampled([0.8, 1.25, 1.75, 2.5, 3.5], |r| {
            let p = &like(&Parameters::default(), r, r.powi(power - 1));
            Ok(1.0 + particles(p, [0.0, rate_b(p, 0.0)], [0.0; 2]))
        }, Ink::Momentum);
        Panel::over_axes(Axis::linear("$R_1/R_2$").range(0.75, 4.0), Axis::linear(r"$L/I_1\Omega_1$").range(-1.5, 1.0))
            .level(0.0, Ink::Frame, "")
            .curve(of(-1).dashed().label_at("one mass", 2.2, 0.54, Side::BelowRight))
            .curve(of(-3).label_at("one thickness", 1.5, 0.7, Side::AboveLeft))
            .curve(simulated(-1)?.dots())
            .curve(simulated(-3)?.dots())
    };

    /// Rates against time while B is set going. Driven: A stays, B falls on a straight line to minus twice that
    /// rate. Not driven: A falls to half, B to minus what A had, and sooner.
    rates: {
        let (time, b, loose) = (time(p), rate_b(p, 0.0), undriven(p));
        let (run, free) = (spun_up(p, true, 1e-9)?, spun_up(p, false, 1e-9)?);
        let of = |run: &Run, k: usize, ink| Curve::sampled(times(0.0, 1.4 * time, 140), |t| Ok(run.at(t)?.v[k]), ink);
        Panel::over_axes("$t$ / s", r"$\Omega$ / rad/s")
            .level(0.0, Ink::Frame, "")
            .curve(of(&run, 0, Ink::Velocity)?.label_at("$A$ driven", 1.0 * time, p.rate, Side::Below))
            .curve(of(&run, 1, Ink::Velocity)?.label_at("$B$", 0.8 * time, 0.8 * b, Side::BelowLeft))
            .curve(of(&free, 0, Ink::Frame)?.dashed().label_at("$A$ left alone", 1.1 * time, loose, Side::Below))
            .curve(of(&free, 1, Ink::Frame)?.dashed().label_at("$B$", 1.0 * time, -loose * ratio(p), Side::Above))
    };

    /// The other reading: an arm turns about the axis of A at omega and carries the axis of B, so that B runs
    /// round A like a planet. Faint: where B was.
    planet: meshed(Sketch::within((-1.3, 2.3), (-1.2, 2.1)).ghost(|s| gear(s, (1.5, 0.0), 0.5, 12, PI / 12.0)), 0.75)
        .curve(Curve::new([(0.0, 0.0), (1.5 * cos(0.75), 1.5 * sin(0.75))], Ink::Ink).width(4.0))
        .turn((0.0, 0.0), 2.1, (0.1, 0.6), Ink::Velocity)
        .text((2.1 * cos(0.35), 2.1 * sin(0.35)), r"$\omega$", Ink::Velocity, Side::Right)
        .text((-0.5, 0.3), "$A$", Ink::Body, Side::Centre)
        .text((1.1, 1.58), "$B$", Ink::Body, Side::Above);
}

/// B set going, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let run = spun_up(p, true, p.tolerance)?;
    let columns = "t [s], Omega1 [rad/s], Omega2 [rad/s], L [kg m^2/s], motor [N m]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 300), |t| {
        let ([a, b], torque) = (run.at(t)?.v, run.forces(t)?[1].normal);
        Ok([t, a, b, p.inertia_a * a + p.inertia_b * b, torque])
    })
}

/// The wheels while B is set going, slowed down; below, the speeds of the rims where they touch.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (run, p) = (spun_up(p, true, 1e-9)?, p.clone());
    let (a, b, rim) = (p.radius_a, p.radius_b, p.radius_a * p.rate);
    let (time, end) = (time(&p), run.end_time());
    let speed = |k: usize, r: f64| {
        Curve::sampled(times(0.0, end, 120), |t| Ok(r * run.at(t)?.v[k]), Ink::Velocity)
    };
    let graph = Panel::over_axes("$t$ / s", "speed of the rim / m/s")
        .curve(speed(0, a)?.label_at("$A$", 0.3 * time, rim, Side::Below))
        .curve(speed(1, -b)?.dashed().label_at("$B$", 0.5 * time, 0.5 * rim, Side::BelowRight));
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.5 * time, end], move |t| {
        let (MechanismState { q, v }, slow) = (run.at(t)?, 0.2);
        let senses = ["counterclockwise", "clockwise"];
        let [of_a, of_b] = [rim < 0.0, rim > 0.0].map(|back| senses[usize::from(back)]);
        let rims = [" without slip", ", and they slip"][usize::from(t < time)];
        let [at_a, at_b] = v.map(f64::abs);
        let alt = format!(
            "{t:.2} s after the rims have met: A turns {of_a} at {at_a:.0} rad/s, B {of_b} at {at_b:.0} rad/s{rims}. \
             Below, the speeds of the two rims where they touch."
        );
        let high = 1.15 * a.max(b);
        let scene = Sketch::within((-1.2 * a, a + 2.3 * b), (-high, high))
            .high(233)
            .roller((0.0, 0.0), a, slow * q[0], Ink::Body)
            .roller((a + b, 0.0), b, PI + slow * q[1], Ink::Body)
            .text((-0.5 * a, 0.5 * a), "$A$", Ink::Body, Side::Centre)
            .text((a + b, 0.55 * b), "$B$", Ink::Body, Side::Centre);
        // Side by side, to be told apart.
        let arrow = |scene: Sketch, (x, speed): (f64, f64)| {
            let all = [(x, 0.0), (x, 0.9 * a * speed / rim.abs())];
            scene.only_if(speed.abs() > 0.05 * rim.abs(), |s| s.arrow_along(all, Ink::Velocity))
        };
        let arrows = [(0.98 * a, a * v[0]), (1.02 * a, -b * v[1])];
        Ok((alt, arrows.into_iter().fold(scene, arrow)))
    })
}
