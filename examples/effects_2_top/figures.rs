//! The drawings of the top; lengths of the scenes in millimetres.

use super::*;
use kit::draw::Camera;

/// Millimetres.
const MM: f64 = 1e3;

/// The body, its centre of mass there.
fn body(p: &Parameters, centre: SpaceVector, axis: SpaceVector) -> Solid {
    Solid::top(centre, axis, MM * LEVER, MM * p.tip)
}

/// A point of the floor or the body, seen from below the centre of mass.
fn seen(at: &Configuration, point: SpaceVector) -> SpaceVector {
    (point - SpaceVector::new(at.centre.x(), at.centre.y(), 0.0)) * MM
}

/// The tilt at these times.
fn tilt(run: &Motion<impl TipFriction>, at: impl Iterator<Item = f64>, ink: Ink) -> Result<Curve> {
    Curve::sampled(at, |t| Ok(run.configuration(t)?.tilt()), ink)
}

figures! { p: &Parameters, life = p.life(p.tolerance)?, end = life.end_time();
    /// The top leans on its ball-shaped tip. Its angular momentum L points along the axis, up
    /// and outward. At the contact with the floor friction F points sideways, and the torque of
    /// F points from the axis towards the vertical.
    setup: {
        let (s, c) = sincos(p.tilt);
        let axis = SpaceVector::new(s, 0.0, c);
        let height = MM * (p.tip + LEVER * c);
        let (centre, foot) = (SpaceVector::new(0.0, 0.0, height), SpaceVector::new(-MM * LEVER * s, 0.0, 0.0));
        let up = SpaceVector::new(0.0, 0.0, 1.0);
        let tip = centre + axis * 45.0;
        View::of(SpaceVector::new(2.0, 0.0, 38.0), 62.0)
            .camera(Camera::new(-1.4, 0.45))
            .ground(SpaceVector::zero(), 60.0)
            .dashed([foot, foot + up * 80.0], Ink::Frame)
            .solid(body(p, centre, axis), Ink::Body)
            .arrow(centre, tip, Ink::Momentum, "$L$", Side::Right)
            .arrow(tip, tip - SpaceVector::new(c, 0.0, -s) * 20.0, Ink::Force, "torque of $F$", Side::Above)
            .arrow(foot, foot - SpaceVector::new(0.0, 44.0, 0.0), Ink::Force, "$F$", Side::Below)
            .dot(foot, Ink::Velocity, "", Side::Below)
    };

    /// The whole life on a logarithmic scale of the tilt: a quick drop, then a straight fall over
    /// ten seconds, a level stretch of minutes at a thousandth of a radian, and a steep rise to
    /// about one radian at the end.
    life: {
        let span = times(0.0, 1.0, 1400).map(|u| end * u);
        Panel::over_axes(Axis::linear("$t$ / s"), Axis::log("tilt / rad"))
            .level(p.slope * (LEVER + p.tip) / LEVER, Ink::Frame, "")
            .curve(tilt(&life, span, Ink::Body)?)
            .upright(life.event("unstable")?.t, Ink::Frame, "")
    };

    /// The spin against time: it falls slowly from that of the throw, passes the least spin at
    /// which the top can sleep, and at the end goes up a little before the fall.
    spin: {
        let spins = sampled(times(0.0, end, 500), |t| Ok((t, life.configuration(t)?.spin())))?;
        Panel::over_axes("$t$ / s", Axis::linear(r"spin $\omega$ / (rad/s)").range(80.0, 160.0))
            .level(p.least_spin(), Ink::Ink, "least to sleep")
            .curve(Curve::new(spins, Ink::Velocity))
    };

    /// The tilt in the first five seconds. With the patch it falls fast at first, then ever more
    /// slowly. With a point it falls alike, then stays. Without slip it stays from the start.
    rises: {
        let point = p.toy(Dry::new(p.friction)?)?.simulate(&p.throw(), 5.0, p.tolerance)?;
        let held = p.toy(NoSlip)?.simulate(&p.throw().rolling(), 5.0, p.tolerance)?;
        let span = || times(0.0, 5.0, 700);
        let grips = point.event("grips")?;
        Panel::over_axes("$t$ / s", Axis::linear("tilt / rad").range(0.0, 1.2 * p.tilt))
            .curve(tilt(&held, span(), Ink::Wrong)?.dashed().label_at("wrong: no slip", 3.4, 1.03 * p.tilt, Side::Above))
            .curve(tilt(&point, span(), Ink::Frame)?.label_at("a point", 3.6, point.configuration(3.6)?.tilt(), Side::Above))
            .curve(tilt(&life, span(), Ink::Body)?.label_at("a patch", 2.4, life.configuration(2.4)?.tilt(), Side::Below))
            .ring(grips.t, point.configuration_at(grips).tilt(), Ink::Frame, "grips", Side::AboveRight)
    };

    /// The tilt at which a tip with dry friction at a point grips, against the coefficient of
    /// friction: simulated dots rise about in proportion, below the straight line of the estimate.
    grips: {
        let gripped = |friction| {
            let top = Top::new(p.shape()?, GRAVITY)?.on(Dry::new(friction)?);
            let run = top.simulate(&p.throw(), 5.0, 1e-9)?;
            Ok(run.configuration_at(run.event("grips")?).tilt())
        };
        Sweep::over(r"friction $\mu$", 0.0, 0.08)
            .at([0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07])
            .exact_and_simulated(Axis::linear(r"tilt $\theta_g$ / rad").range(0.0, 0.4), |mu| p.but(|p| p.friction = mu).grip_tilt(), gripped)?
    };

    /// Paths on the floor seen from above, in the first eight seconds. The contact runs round in
    /// loops that shrink; the centre of mass goes round in smaller loops inside them.
    paths: {
        let path = |f: fn(&Configuration) -> SpaceVector| sampled(times(0.0, 8.0, 1600), |t| {
            let at = f(&life.configuration(t)?);
            Ok((MM * at.x(), MM * at.y()))
        });
        Panel::over_axes("$x$ / mm", "$y$ / mm").equal_aspect()
            .curve(Curve::new(path(Configuration::contact)?, Ink::Velocity).thin().label("contact"))
            .curve(Curve::new(path(|at| at.centre)?, Ink::Body).label("centre of mass"))
    };

    /// Force and torque of a patch against the slip over the speed of its rim. The force rises in
    /// proportion and tends to one. The torque falls from its largest value towards zero.
    patch: {
        let patch = Patch::new(1.0, 1.0)?;
        let grip = |v: f64| patch.sliding(SpaceVector::new(v, 0.0, 0.0), 1.0);
        Panel::over_axes(r"$v = u/a\omega$", Axis::linear(r"over $\mu N$, $\mu Na$").range(0.0, 1.0))
            .curve(Curve::of(times(0.0, 4.0, 200), |v| -grip(v).force.x(), Ink::Force).label_at("force", 1.6, 0.93, Side::AboveLeft))
            .curve(Curve::of(times(0.0, 4.0, 200), |v| -grip(v).torque, Ink::Ink).dashed().label_at("torque", 1.1, 0.24, Side::AboveRight))
    };

    /// The normal force over the weight after a fast throw without precession: it swings about
    /// one ever more widely, until the line ends where it would be below zero.
    hops: {
        let fast = p.but(|p| (p.spin, p.tilt) = (250.0, 0.4));
        let throw = fast.throw().precessing(0.0);
        let run = fast.toy(p.rubbing()?)?.simulate(&throw, 0.5, 1e-10)?;
        let force = sampled(times(0.0, run.end_time(), 900), |t| Ok((t, run.forces(t)?.1.normal / WEIGHT)))?;
        Panel::over_axes("$t$ / s", Axis::linear("$N/mg$").range(0.0, 2.5))
            .level(1.0, Ink::Frame, "")
            .curve(Curve::new(force, Ink::Force))
    };
}

/// The life, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let life = p.life(p.tolerance)?;
    let columns =
        "t [s], tilt [rad], spin [rad/s], precession [rad/s], slip [m/s], x [m], y [m], N [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, life.end_time(), 2000), |t| {
        let (at, forces) = life.forces(t)?;
        let (slip, x, y) = (at.slip.norm(), at.centre.x(), at.centre.y());
        Ok([t, at.tilt(), at.spin(), at.precession(), slip, x, y, forces.normal])
    })
}

/// Film time at the acts' ends: the slide, the creep, the sleep, the waking, the end.
const ACTS: [f64; 6] = [0.0, 6.0, 12.0, 16.0, 21.0, 25.0];

/// The life as a film: each act at its own pace.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let life = p.life(p.tolerance)?;
    let (p, end) = (p.clone(), life.end_time());
    let wakes = life.event("wakes")?.t;
    let knots = [0.0, 1.2, life.event("sleeps")?.t, wakes - 4.0, wakes + 3.0, end];
    let pace = move |u: f64| {
        let i = (1..5).find(|&i| u <= ACTS[i]).unwrap_or(5);
        let part = (u - ACTS[i - 1]) / (ACTS[i] - ACTS[i - 1]);
        (knots[i - 1] + part * (knots[i] - knots[i - 1])).min(end)
    };
    let told = |t: f64| if t < 10.0 { format!("{t:.1}") } else { format!("{t:.0}") };
    let ticks = ACTS.into_iter().zip(knots.map(told));
    let line = sampled(times(0.0, ACTS[5], 900), |u| Ok((u, life.configuration(pace(u))?.tilt())))?;
    let time = Axis::linear("$t$ / s, each part at its own pace").range(0.0, ACTS[5]).ticks(ticks);
    let graph =
        Panel::over_axes(time, Axis::linear("tilt / rad")).curve(Curve::new(line, Ink::Body)).low();
    MovingPicture::above(graph, 0.0..=ACTS[5], [0.0, 9.0, ACTS[5]], move |u| {
        let t = pace(u);
        let (at, forces) = life.forces(t)?;
        let height = SpaceVector::new(0.0, 0.0, MM * at.centre.z());
        let tip = height + at.axis * (56.0 * at.spin() / p.spin);
        let contact = seen(&at, at.contact());
        let trail = sampled(times((t - 1.0).max(0.0), t, 120), |t| {
            Ok(seen(&at, life.configuration(t)?.contact()))
        })?;
        let friction = forces.friction * (30.0 / (p.friction * WEIGHT));
        let ribbon = if t > 0.0 {
            "On the floor a fading ribbon, the path of its contact in the last second. "
        } else {
            ""
        };
        let alt = format!(
            "The top {t:.1} s after the throw: its axis leans by {:.3} rad and it spins at {:.0} rad/s. \
             {ribbon}Below, the tilt against time.",
            at.tilt(),
            at.spin()
        );
        let mut scene = View::of(SpaceVector::new(0.0, 0.0, 38.0), 66.0)
            .camera(Camera::new(-0.5, 0.3))
            .size(340, 270)
            .ground(SpaceVector::zero(), 78.0)
            .solid(body(&p, height, at.axis), Ink::Body)
            .trail(trail, Ink::Velocity)
            .dot(contact, Ink::Velocity, "", Side::Below)
            .corner(&format!("{t:.1} s"))
            .vector(height, tip, Ink::Momentum, "$L$", Side::Right);
        if friction.norm() > 4.0 {
            scene = scene.arrow(contact, contact + friction, Ink::Force, "$F$", Side::Below);
        }
        Ok((alt, scene))
    })
}
