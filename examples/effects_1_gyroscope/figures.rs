//! The drawings of the damped gyroscope.

use super::*;
use kit::draw::Camera;
use models::heavy_top::direction;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// Where the disc sits on the axle, whose length is 1; half the width of ring and fork.
const HUB: f64 = 0.6;
const HALF: f64 = 0.42;
const WIDE: f64 = 0.5;

/// The gyroscope on its stand on a table: fork, ring, and a spoked wheel.
fn on_stand(theta: f64, phi: f64, zeta: f64) -> View {
    let (o, axis) = (SpaceVector::zero(), direction(theta, phi));
    let (s, c) = sincos(phi);
    let node = SpaceVector::new(c, s, 0.0);
    let (base, low) = (UP * -0.42, UP * -0.95);
    let rod = |a: SpaceVector, b: SpaceVector| Solid::rod(a, b, 0.022);
    let fork = rod(low + UP * 0.1, base)
        .with(rod(base - node * WIDE, base + node * WIDE))
        .with(rod(base - node * WIDE, node * -WIDE))
        .with(rod(base + node * WIDE, node * WIDE));
    let ring = rod(node * -WIDE, node * WIDE)
        .with(rod(node * -HALF, axis - node * HALF))
        .with(rod(node * HALF, axis + node * HALF))
        .with(rod(axis - node * HALF, axis + node * HALF));
    let hub = axis * HUB;
    let (s, c) = sincos(zeta);
    let spoke = node * c + axis.cross(&node) * s;
    View::of(UP * 0.04, 1.19)
        .camera(Camera::new(0.1, 0.3))
        .size(340, 290)
        .table(low, 1.1)
        .solid(Solid::stand(low + UP * 0.12, 0.12, 0.34), Ink::Frame)
        .solid(fork, Ink::Frame)
        .solid(ring, Ink::Ink)
        .solid(Solid::rod(o, axis, 0.018), Ink::Frame)
        .solid(Solid::flywheel(hub, axis, spoke, 0.36), Ink::Body)
}

/// The first moments, nods and all.
fn nods(y: &Gyroscope, p: &Parameters) -> Result<(GimbalMotion, f64)> {
    let last = (2.0 * y.lasting(y.bottom()? - p.theta)?).clamp(0.5, 20.0);
    Ok((y.run(Some(p.stop), last, p.tolerance)?, last))
}

/// The tilt against time of this motion.
fn tilt(course: &GimbalMotion, end: f64, count: u32) -> Result<Vec<(f64, f64)>> {
    let end = end.min(course.end_time());
    sampled(times(0.0, end, count), |t| Ok((t, course.at(t)?.theta)))
}

/// Where the end of the axis points, in so many pieces.
fn path(course: &GimbalMotion, end: f64, pieces: u32) -> Result<Vec<(f64, SpaceVector)>> {
    sampled(times(0.0, end.min(course.end_time()), pieces), |t| {
        let at = course.at(t)?;
        Ok((t, direction(at.theta, at.phi)))
    })
}

/// How far the nods reach on either side of the bottom, by theory.
fn reach(y: &Gyroscope) -> Result<impl Fn(f64) -> f64> {
    let (f, size) = (y.fading()?, y.bottom()? - y.start.theta);
    let dry = f.shortening * f.frequency / (PI * f.decay);
    Ok(move |t: f64| ((size + dry) * exp(-f.decay * t) - dry).max(0.0))
}

/// Tilt against time with one bearing alone.
fn alone(y: &Gyroscope, bearings: Bearings, end: f64, ink: Ink) -> Result<Curve> {
    let course = y.with(bearings).run(None, end, 1e-9)?;
    Ok(Curve::new(tilt(&course, end, 900)?, ink).thin())
}

/// Gimbals of the page's shape, so many times as heavy.
fn heavier(p: &Parameters, factor: f64) -> Result<Gyroscope> {
    let y = Gyroscope::new(p)?;
    let ring = [p.ring, p.ring, p.ring_along].map(|m| m * factor);
    let gimbals = Gimbals::new(*y.gimbals.rotor(), ring, p.fork * factor)?;
    Ok(Gyroscope { gimbals, ..y })
}

figures! { p: &Parameters, y = Gyroscope::new(p)?, first = nods(&y, p)?,
    whole = y.run(Some(p.stop), LONGEST, 1e-9)?;
    /// A disc on an axle, held by a ring; the ring tilts in a fork about a level axis; the fork
    /// turns on a stand about the vertical. Three bearings are marked: pivot, tilt and axle.
    setup: {
        let (theta, phi) = (0.9, 0.15);
        let (axis, node) = (direction(theta, phi), SpaceVector::new(cos(phi), sin(phi), 0.0));
        on_stand(theta, phi, 0.9)
            .camera(Camera::new(0.35, 0.3))
            .dashed([SpaceVector::zero(), UP * 0.95], Ink::Frame)
            .text(UP * 0.95, "$Z$", Ink::Frame, Side::Above)
            .turn(times(0.0, theta, 24).map(|t| direction(t, phi) * 0.8), Ink::Ink)
            .text(direction(0.5 * theta, phi) * 0.82, r"$\theta$", Ink::Ink, Side::Above)
            .dot(node * WIDE, Ink::Velocity, "tilt", Side::Left)
            .dot(UP * -0.78, Ink::Velocity, "pivot", Side::Right)
            .dot(axis, Ink::Velocity, "axle", Side::Left)
            .text(node * WIDE + UP * -0.42, "fork", Ink::Frame, Side::Left)
            .text(axis * 0.85 + node * HALF, "ring", Ink::Ink, Side::Left)
    };

    /// The path of the end of the axis on a sphere, near the start: cusp after cusp, each nod
    /// smaller than the one before, until a smooth line of latitude is left, lower than the start.
    trace: View::of(SpaceVector::zero(), 1.12)
        .camera(Camera::new(0.3, 1.25))
        .sphere()
        .trace(path(&first.0, 0.985 * TAU / y.fading()?.precession, 1500)?.into_iter().map(|(_, end)| end), Ink::Body)
        .dot(direction(p.theta, 0.0), Ink::Body, "start", Side::Left);

    /// Tilt against time in the first moments: nods between the tilt of the release and twice
    /// the drop, in an envelope that closes nearly along straight lines; then a level line.
    nods: {
        let (course, end) = &first;
        let (bottom, reach) = (y.bottom()?, reach(&y)?);
        let side = |sign: f64| Curve::of(times(0.0, *end, 200), |t| bottom + sign * reach(t), Ink::Frame);
        Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
            .curve(Curve::new(tilt(course, *end, 2400)?, Ink::Body).thin())
            .curve(side(1.0).dashed().label("theory"))
            .curve(side(-1.0).dashed())
    };

    /// Energy against time. That of the nods falls, by a curve that is steepest at first, and
    /// ends at zero; the heat of the tilt bearing mirrors it. The kinetic energy of the
    /// precession, as large as either, stays.
    energy: {
        let (course, end) = &first;
        let milli = |of: &dyn Fn(f64, &Pose) -> Result<f64>, ink: Ink| {
            Curve::sampled(times(0.0, *end, 400), |t| Ok(1e3 * of(t, &course.at(t)?)?), ink)
        };
        let smooth = |at: &Pose| -> Result<Pose> {
            let theta = y.bottom_at(at, 0.0)?;
            let phi_rate = y.gimbals.steady_rate(theta, at.axial_momentum, 0.0)?;
            Ok(Pose { theta, theta_rate: 0.0, phi_rate, ..*at })
        };
        let walks = |_: f64, at: &Pose| {
            let at = smooth(at)?;
            Ok(y.gimbals.axis_energy(&at) - y.gimbals.weight_moment() * cos(at.theta))
        };
        let nods = |_: f64, at: &Pose| Ok(y.gimbals.axis_energy(at) - y.gimbals.axis_energy(&smooth(at)?));
        let heat = |t: f64, _: &Pose| Ok(course.heat(t)?[0]);
        Panel::over_axes("$t$ / s", "energy / mJ")
            .curve(milli(&walks, Ink::Velocity)?.dashed().label("precession"))
            .curve(milli(&nods, Ink::Energy)?.label("nods"))
            .curve(milli(&heat, Ink::Force)?.label("heat"))
    };

    /// Tilt against time with one bearing at a time: dry tilt bearing, the nods shrink along
    /// straight lines; dry pivot, the nods stay and the axis sinks.
    bearings: {
        let end = 1.2 * y.lasting(y.bottom()? - p.theta)?.min(10.0);
        let b = Bearings::SMOOTH;
        let heavy = Bearing::new(0.0, 50.0 * p.pivot_dry)?;
        Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
            .curve(alone(&y, Bearings { azimuth: heavy, ..b }, end, Ink::Velocity)?.label("pivot"))
            .curve(alone(&y, Bearings { tilt: y.bearings.tilt, ..b }, end, Ink::Body)?.label("tilt bearing"))
    };

    /// Tilt against time in minutes, from the release to the stop: the axis sinks, at first
    /// slowly, then ever faster. Dots of the slow motion alone lie on the line, and so does a
    /// dashed line of the simplest formula, nearly.
    sag: {
        let minutes = |t: f64| t / 60.0;
        let end = whole.end_time();
        let line = tilt(&whole, end, 500)?.into_iter().map(|(t, theta)| (minutes(t), theta));
        let slow = Dop853::new(1e-9)?.solve(&Decay::slow(y.gimbals, y.bearings), 0.0,
            &[y.bottom()?, 0.0, y.start.axial_momentum], 0.999 * end, &[])?;
        let dots = sampled(times(0.02 * end, 0.98 * end, 12), |t| Ok((minutes(t), slow.at(t)?[0])))?;
        let formula = times(0.0, 0.95 * end, 200).filter_map(|t| Some((minutes(t), y.sunk(t)?)));
        Panel::over_axes("$t$ / min", r"tilt $\theta$ / rad")
            .level(p.stop, Ink::Frame, "stop")
            .curve(Curve::new(line, Ink::Body).label_at("simulated", minutes(0.5 * end), whole.at(0.5 * end)?.theta, Side::AboveLeft))
            .curve(Curve::new(formula, Ink::Ink).dashed().label("formula"))
            .curve(Curve::new(dots, Ink::Ink).dots())
    };

    /// How much longer a nod is than without gimbals, against the weight of the gimbals. The
    /// exact line bends below the straight one of the formula; simulated dots lie on it.
    gimbals: {
        let longer = |k: f64, period: f64| -> Result<f64> { Ok(period / measured::bare(&heavier(p, k)?)? - 1.0) };
        let exact = |k: f64| -> f64 {
            let nod = heavier(p, k).and_then(|y| Ok(NutationCycle::of(&y.gimbals, &y.start)?));
            nod.and_then(|nod| longer(k, nod.period)).unwrap_or(f64::NAN)
        };
        let small = exact(1e-4) / 1e-4;
        Sweep::over("inertia of the gimbals over that of ours", 0.0, 20.0)
            .at([1.0, 4.0, 8.0, 12.0, 16.0, 19.0])
            .exact_and_simulated("nod longer by", exact, |k| {
                let y = heavier(p, k)?;
                longer(k, measured::nod(&y, 1e-10)?[1].t)
            })?
            .curve(Curve::of(times(0.0, 20.0, 2), |k| small * k, Ink::Frame).dashed().label("first order"))
    };
}

impl Gyroscope {
    /// The tilt at `t` in closed form: the pivot, and a rotor that the air slows and that has to
    /// precess the faster. Friction of the axle is left out.
    pub fn sunk(&self, t: f64) -> Option<f64> {
        let (axial, i3) = (self.start.axial_momentum, self.gimbals.rotor().i3());
        let drag = self.bearings.air.map_or(0.0, |air| -air.axial_torque(axial / i3));
        let (bottom, pivot) = (self.bottom().ok()?, self.bearings.azimuth);
        let (rate, half) = (self.gimbals.weight_moment() / axial, 2.0 * axial / drag);
        let grown = |k: f64| pow(1.0 + t / half, k) - 1.0;
        let taken =
            half * (pivot.dry() * grown(3.0) / 3.0 + pivot.viscous() * rate * grown(5.0) / 5.0);
        let walks = 0.5 * self.gimbals.turning(bottom) * rate * grown(4.0);
        let c = cos(bottom) - (taken + walks) / axial;
        (c > -1.0).then(|| acos(c))
    }
}

/// The whole motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (course, _) = nods(&Gyroscope::new(p)?, p)?;
    let columns = ["t [s]", "theta [rad]", "phi [rad]", "heat of the tilt [J]"];
    Trajectory::sampled(columns, times(0.0, course.end_time(), 4000), |t| {
        let at = course.at(t)?;
        Ok([t, at.theta, at.phi, course.heat(t)?[0]])
    })
}

/// The first moments, slowed down by the reader.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let y = Gyroscope::new(p)?;
    let (course, end) = nods(&y, p)?;
    let end = end.min(course.end_time());
    let graph = Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
        .curve(Curve::new(tilt(&course, end, 1500)?, Ink::Body).thin())
        .low();
    let trail = path(&course, end, 3000)?;
    // The ribbon is as long as the nods last, or most of a turn.
    let past = 0.8 * TAU / y.fading()?.precession;
    let lowest = 0.5 * TAU / y.fading()?.frequency;
    MovingPicture::above(graph, 0.0..=end, [0.0, lowest, end], move |t| {
        let at = course.at(t)?;
        let alt = format!(
            "The gyroscope {t:.2} s after the release: its axis leans by {:.3} rad and has gone \
             {:.2} rad round the vertical; a fading ribbon shows where the end of the axis has been; \
             below, the tilt against time.",
            at.theta, at.phi
        );
        // Spokes at their true place would stand still in one frame and jump in the next.
        let axis = direction(at.theta, at.phi);
        let scene = on_stand(at.theta, at.phi, 0.02 * at.zeta)
            .followed(&trail, [t, past], axis, Ink::Body)
            .vector(axis, axis * 1.34, Ink::Momentum, "$L$", Side::Above)
            .arrow(axis * HUB, axis * HUB - UP * 0.5, Ink::Force, "$mg$", Side::Left)
            .corner(&format!("{t:.2} s"));
        Ok((alt, scene))
    })
}
