//! The drawings of the gyrocompass.

use super::*;
use kit::draw::Camera;

/// A body with its nutation at the rate 1, on an equator that turns slowly, and a bob.
fn stiffened(log_stiffness: f64) -> Compass {
    Compass::bare([1.0, 1.0, pow(10.0, log_stiffness)], horizon(1e-7, 0.0, 0.0))
}

/// The ship speeds up within ten minutes; azimuth in rad over minutes.
fn voyage(p: &Parameters, tuning: f64, label: &str, at: (f64, Side)) -> Result<Curve> {
    let c = Compass::new(&p.but(|p| p.tuning = tuning))?;
    let (start, end) = (axle(0.0, c.rest()[1]).to_array(), 9000.0);
    let run = Dop853::new(1e-10)?.solve(&c.slow(ship(p, p.speed, 600.0)), 0.0, &start, end, &[])?;
    let azimuth = |t: f64| Ok(angles(run.at(60.0 * t)?)[0]);
    let ink = if tuning == 1.0 { Ink::Body } else { Ink::Frame };
    let curve = Curve::sampled(times(0.0, 150.0, 300), azimuth, ink)?;
    Ok(curve.label_at(label, at.0, azimuth(at.0)?, at.1))
}

/// Time of the moving picture, s.
const END: f64 = 15000.0;

/// The damped compass let go.
fn damped(p: &Parameters) -> Result<Solution<3>> {
    let c = Compass { offset: p.offset, ..Compass::new(p)? };
    c.run([p.release, c.rest()[1]], END, p.tolerance)
}

/// Azimuth against minutes.
fn over_minutes(run: &Solution<3>) -> Result<Vec<(f64, f64)>> {
    sampled(times(0.0, END / 60.0, 300), |t| Ok((t, angles(run.at((60.0 * t).min(END))?)[0])))
}

figures! { p: &Parameters, compass = Compass::new(p)?;
    /// The Earth from the side, its axis upright with the angular velocity Omega. At the latitude lambda stands a wheel, its
    /// level axle along the meridian, with the angular momentum L towards the north; the north is lambda below the direction of
    /// Omega.
    setup: {
        let (s, c) = sincos(0.8);
        let at = |up: f64, north: f64| (up * c - north * s, up * s + north * c);
        let wheel = [(-0.13, -0.03), (0.13, -0.03), (0.13, 0.03), (-0.13, 0.03)];
        Sketch::within((-1.25, 1.35), (-1.2, 1.75))
            .disc((0.0, 0.0), 1.0, Ink::Frame, 0.06)
            .guide([(0.0, -1.15), (0.0, 1.15)])
            .guide([(-1.0, 0.0), (1.0, 0.0)])
            .guide([(0.0, 0.0), at(1.2, 0.0)])
            .angle((0.0, 0.0), 0.3, (0.0, 0.8), r"$\lambda$")
            .arrow((0.0, 1.15), (0.0, 1.55), Ink::Velocity, r"$\Omega$", Side::Left)
            .guide([at(1.2, 0.0), (at(1.2, 0.0).0, at(1.2, 0.0).1 + 0.7)])
            .angle(at(1.2, 0.0), 0.34, (0.5 * PI, 0.5 * PI + 0.8), r"$\lambda$")
            .body(wheel.map(|(up, north)| at(1.2 + up, north)), Ink::Body, 0.4)
            .arrow(at(1.2, -0.25), at(1.2, 0.65), Ink::Momentum, "", Side::Above)
            .text(at(1.2, 0.7), "$L$", Ink::Momentum, Side::Above)
            .text((0.62, -0.55), "Earth", Ink::Frame, Side::Centre)
    };

    /// The wheel on a piece of level ground. Its axle points between north and east, at the azimuth alpha from north, and is
    /// raised by the tilt beta. A bob hangs below.
    compass: {
        let (tip, o, low) = (axle(0.75, 0.3) * 1.05, SpaceVector::zero(), UP * -0.55);
        let flat = |from: f64, to: f64| times(from, to, 30).map(move |a| axle(a, 0.0) * 0.6 + low);
        let foot = axle(0.75, 0.0) * 1.0;
        View::of(UP * -0.2, 0.95)
            .camera(Camera::new(-0.4, 0.38))
            .ground(low, 0.95)
            .dashed([low, axle(0.0, 0.0) * 0.9 + low], Ink::Frame)
            .dashed([low, axle(0.5 * PI, 0.0) * 0.9 + low], Ink::Frame)
            .dashed([low, foot + low], Ink::Frame)
            .text(axle(0.0, 0.0) * 0.9 + low, "north", Ink::Frame, Side::Above)
            .text(axle(0.5 * PI, 0.0) * 0.9 + low, "east", Ink::Frame, Side::Left)
            .turn(flat(0.0, 0.75), Ink::Ink)
            .text(axle(0.33, 0.0) * 0.72 + low, r"$\alpha$", Ink::Ink, Side::Right)
            .dashed([o, foot], Ink::Frame)
            .turn(times(0.0, 0.3, 20).map(|b| axle(0.75, b) * 0.8), Ink::Ink)
            .text(axle(0.75, 0.12) * 0.86, r"$\beta$", Ink::Ink, Side::Right)
            .line([o, bob(tip)], Ink::Ink)
            .dot(bob(tip), Ink::Body, "$m$", Side::Left)
            .solid(wheel(axle(0.75, 0.3), 0.34), Ink::Body)
            .arrow(o, tip, Ink::Momentum, "$L$", Side::Right)
    };

    /// Period of Foucault's compass against the latitude: flat at the equator, it grows without bound towards the pole.
    /// Simulated dots on the line.
    foucault: {
        let at = |latitude| Compass::new(&p.but(|p| p.latitude = latitude));
        let period = |x| at(x).map_or(f64::NAN, |c| 2.0 * PI / c.foucault_rate());
        let simulated = |x| Ok(2.0 * PI / measured_held(at(x)?)?);
        Sweep::over("latitude / rad", 0.0, 1.5).at([0.05, 0.35, 0.65, 0.95, 1.2, 1.35, 1.46])
            .exact_and_simulated(Axis::linear("period / s").range(0.0, 60.0), period, simulated)?
    };

    /// Period over that of Foucault's compass against how stiff the bob is, both with powers of ten. It falls with the slope
    /// -1/2, bends where the stiffness is 1 and stays at 1. Simulated dots lie on the line; the compass of the ship is far to
    /// the left.
    both: {
        let ratio = |log| stiffened(log).foucault_rate() / stiffened(log).both()[0];
        let line = times(-5.5, 3.0, 200).map(|log| (pow(10.0, log), ratio(log)));
        let dots = sampled([-3.0, -2.0, -1.0, 0.0, 1.0, 2.0], |log| {
            let c = stiffened(log);
            Ok((pow(10.0, log), c.foucault_rate() / measured_whole(c)?))
        })?;
        let (stiffness, l) = (compass.pendulosity * compass.transverse, compass.momentum);
        Panel::over_axes(Axis::log("$K I_t/L^2$"), Axis::log("$T/T_F$").range(0.7, 1000.0))
            .curve(Curve::new(line, Ink::Ink))
            .curve(Curve::new(dots, Ink::Body).dots().label("simulated"))
            .dot(stiffness / (l * l), compass.foucault_rate() / compass.both()[0], Ink::Momentum, "the ship's", Side::Right)
            .note(30.0, 1.0, Ink::Ink, "Foucault's", Side::Above)
    };

    /// Tilt against azimuth. The undamped axle goes round a flat closed curve about a point straight above north; the damped
    /// one winds inward to a point beside it.
    path: {
        let rest = compass.rest();
        let over = |run: &Solution<3>| -> Result<Vec<(f64, f64)>> {
            sampled(times(0.0, run.end_time(), 400), |t| Ok(angles(run.at(t)?).into()))
        };
        let free = compass.run([p.release, rest[1]], 2.0 * PI / compass.linear()[1].sqrt() * 1.02, 1e-10)?;
        Panel::over_axes(r"azimuth $\alpha$ / rad", r"tilt $\beta$ / rad")
            .curve(Curve::new(over(&free)?, Ink::Frame).arrow(0.12).label("undamped"))
            .curve(Curve::new(over(&damped(p)?)?, Ink::Body).arrow(0.06).label("damped"))
            .dot(0.0, rest[1], Ink::Ink, "", Side::Above)
    };

    /// Azimuth against time of the damped compass, with and without a rider. Both swing a few times, ever less; one ends in the
    /// north, the other a little east of it.
    settling: {
        let c = Compass { offset: p.offset, rider: compass.momentum * compass.horizon.z(), ..compass };
        let corrected = over_minutes(&c.run([p.release, 0.0], END, 1e-10)?)?;
        Panel::over_axes("$t$ / min", r"azimuth $\alpha$ / rad")
            .level(0.0, Ink::Frame, "")
            .curve(Curve::new(over_minutes(&damped(p)?)?, Ink::Frame).dashed().label("without rider"))
            .curve(Curve::new(corrected, Ink::Body).label("with rider"))
    };

    /// Azimuth against time after the ship speeds up. Tuned, the axle goes over to its new rest in ten minutes and stays. With
    /// half and with twice the pendulosity it swings.
    ship: Panel::over_axes("$t$ / min", Axis::linear(r"azimuth $\alpha$ / rad")
            .over([0.0, 1e-3, -2.05 * p.speed / (RADIUS * compass.north())]))
        .upright(10.0, Ink::Frame, "")
        .curve(voyage(p, 0.5, "half", (60.0, Side::Below))?)
        .curve(voyage(p, 2.0, "twice", (105.0, Side::Above))?)
        .curve(voyage(p, 1.0, "tuned", (135.0, Side::Above))?);
}

/// Where the bob hangs: at right angles to the axle.
fn bob(axle: SpaceVector) -> SpaceVector {
    let raised = UP - axle * (axle.z() / axle.dot(&axle));
    raised * (-0.42 / raised.norm())
}

fn wheel(axle: SpaceVector, radius: f64) -> Solid {
    let (w, r) = (0.05, radius);
    Solid::turned(SpaceVector::zero(), axle, &[(-w, 0.6 * r), (-w, r), (w, r), (w, 0.6 * r)])
}

/// The damped motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = ["t [s]", "azimuth [rad]", "tilt [rad]"];
    Trajectory::of(&damped(p)?, columns, 600, |t, state| {
        let [azimuth, tilt] = angles(state);
        [t, azimuth, tilt]
    })
}

/// The damped motion, the tilt drawn twenty times as large.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (run, compass) = (damped(p)?, Compass::new(p)?);
    let graph = Panel::over_axes("$t$ / min", r"azimuth $\alpha$ / rad")
        .level(0.0, Ink::Frame, "")
        .curve(Curve::new(over_minutes(&run)?, Ink::Body));
    let (low, quarter) = (UP * -0.55, 0.5 * PI / compass.linear()[1].sqrt() / 60.0);
    let earth = compass.horizon * (0.9 / EARTH);
    MovingPicture::above(graph, 0.0..=END / 60.0, [0.0, quarter, END / 60.0], move |t| {
        let [azimuth, tilt] = angles(run.at((60.0 * t).min(END))?);
        let (tip, side) = (axle(azimuth, 20.0 * tilt), axle(azimuth - 0.5 * PI, 0.0));
        let side_of = if azimuth < 0.0 { "west" } else { "east" };
        let raised = if tilt < 0.0 { "lowered" } else { "raised" };
        let alt = format!(
            "The compass {t:.0} minutes after it is let go: its axle points {:.1} degrees {side_of} \
             of north and is {raised} by {:.2} degrees; below, the azimuth against time.",
            azimuth.to_degrees().abs(),
            tilt.to_degrees().abs()
        );
        let scene = View::of(UP * -0.03, 0.95)
            .camera(Camera::new(0.15, 0.38))
            .ground(low, 0.95)
            .dashed([low, axle(0.0, 0.0) * 0.9 + low], Ink::Frame)
            .text(axle(0.0, 0.0) * 0.9 + low, "north", Ink::Frame, Side::Below)
            .line([SpaceVector::zero(), bob(tip)], Ink::Ink)
            .dot(bob(tip), Ink::Body, "", Side::Left)
            .solid(wheel(tip, 0.3), Ink::Body)
            .arrow(SpaceVector::zero(), earth, Ink::Velocity, r"$\Omega$", Side::Left)
            .arrow(SpaceVector::zero(), tip, Ink::Momentum, "$L$", Side::Above)
            .arrow(tip, tip + side * (20.0 * tilt), Ink::Force, "torque", Side::Below);
        Ok((alt, scene))
    })
}
