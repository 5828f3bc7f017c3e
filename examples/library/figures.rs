//! The drawings of the page on the library.

use super::*;

/// Half the length of the satellite in the drawings.
const HALF: f64 = 0.62;

/// The satellite at this angle from the vertical, seen along the normal of the orbit, which
/// points at the viewer; down is down. With what pulls its ends apart and turns it back.
fn hung(angle: f64) -> Sketch {
    let (s, c) = sincos(angle);
    let place = |along: f64, across: f64| (-along * s + across * c, along * c + across * s);
    let outline =
        [(HALF, 0.14), (HALF, -0.14), (-HALF, -0.14), (-HALF, 0.14)].map(|(a, b)| place(a, b));
    let (up, low, pull) = (place(HALF, 0.0), place(-HALF, 0.0), 0.45 * c);
    let sketch = Sketch::within((-1.25, 1.25), (-1.15, 1.15))
        .guide([(0.0, 1.12), (0.0, -1.12)])
        .body(outline, Ink::Body, 0.25)
        .arrow(up, (up.0, up.1 + pull), Ink::Force, "", Side::Left)
        .arrow(low, (low.0, low.1 - pull), Ink::Force, "", Side::Right)
        .arrow((1.0, -0.8), (1.0, -1.1), Ink::Frame, "to the Earth", Side::Left)
        .arrow((-0.75, 1.0), (-1.1, 1.0), Ink::Frame, "flies", Side::Below)
        .guide([low, up]);
    // The couple turns it back: the longer the arrow, the stronger.
    let from = 0.5 * PI + angle + 0.35 * angle.signum();
    sketch.only_if(angle.abs() >= 0.02, |sketch| {
        sketch.angle((0.0, 0.0), 0.5, (0.5 * PI, 0.5 * PI + angle), r"$\alpha$").turn(
            (0.0, 0.0),
            0.26,
            (from, from - 8.0 * s * c),
            Ink::Force,
        )
    })
}

/// The driven top's tilt for a second.
fn tilt(torque: f64, ink: Ink) -> Result<Curve> {
    let (scene, start) = driven(torque)?;
    let motion = scene.solve_along(&start, 1.0, 1e-8, &Limits::default())?;
    let tilt = |t| Ok(motion.try_state(t)?.attitude.euler_angles().theta);
    Curve::sampled(times(0.0, 1.0, 400), tilt, ink)
}

/// How far the satellite, hung askew by this angle, turns about its long axis in a day with
/// the magnet on board: the angle of e2 from the plane of the orbit, rad.
fn yaw(p: &Parameters, askew: f64, ink: Ink) -> Result<Curve> {
    let (scene, start) = satellite(&p.but(|p| p.askew = askew))?;
    let scene = scene.with(magnet(MAGNET));
    let motion = scene.solve_along(&start, DAY, 1e-6, &Limits::default())?;
    let yaw = |hour: f64| {
        let attitude = motion.try_state((3600.0 * hour).min(DAY))?.attitude;
        Ok(asin(attitude.to_space(BodyVector::new(0.0, 1.0, 0.0)).z()))
    };
    Ok(Curve::sampled(times(0.0, 24.0, 500), yaw, ink)?.label(&format!("{} rad", short(askew, 1))))
}

figures! { p: &Parameters;
    /// A satellite seen along the normal of its orbit: its long axis e1 leans from the vertical by the angle alpha. The Earth
    /// is below. Its lower end is pulled down, its upper end up, and the two turn it back to the vertical.
    setup: hung(0.5)
        .guide([(-HALF * sin(0.5), HALF * cos(0.5)), (-0.95 * sin(0.5), 0.95 * cos(0.5))])
        .text((-0.97 * sin(0.5), 0.97 * cos(0.5)), "$e_1$", Ink::Body, Side::Left);

    /// The angle of the satellite from the vertical in the first six hours: a wave of constant height; a dot at every hour lies
    /// on it.
    swing: {
        let (exact, states) = (pendulum(p)?, day(p)?);
        let angle = |hour: f64| Ok(0.5 * exact.at(3600.0 * hour)?.theta);
        let hours = (1..).map(f64::from).zip(&states).take(6);
        let solved = hours.map(|(hour, state)| (hour, swing(p, 3600.0 * hour, state)));
        Panel::over_axes("$t$ / h", r"$\alpha$ / rad")
            .curve(Curve::sampled(times(0.0, 6.0, 400), angle, Ink::Ink)?)
            .curve(Curve::new(solved, Ink::Body).dots())
    };

    /// By how much the solved angle is off at every hour of the day, on a logarithmic axis: all dots lie below the line of what
    /// was asked for.
    off: {
        let off = off(p, &day(p)?)?;
        let dots = (1..).map(f64::from).zip(off).map(|(hour, off)| (hour, off.max(1e-16)));
        Panel::over_axes(Axis::linear("$t$ / h").range(0.0, 24.0), Axis::log("off by / rad").range(1e-14, 1e-6))
            .level(p.tolerance, Ink::Frame, "asked for")
            .curve(Curve::new(dots, Ink::Body).dots())
    };

    /// The angle by which the satellite turns about its long axis during a day, with a weak magnet on board: if it swings
    /// little, a wave that stays low; if it swings wider, one that grows until it is many times as high.
    yaw: Panel::over_axes("$t$ / h", "turned about $e_1$ / rad")
        .curve(yaw(p, p.askew, Ink::Body)?)
        .curve(yaw(p, 0.1 * p.askew, Ink::Ink)?);

    /// Tilt of the top for a second, with the motor on and off: off, it goes on with deep nods; on, the nods become shallower
    /// and quicker.
    motor: Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
        .curve(tilt(0.0, Ink::Ink)?.label("motor off"))
        .curve(tilt(p.torque, Ink::Body)?.label("motor on"));
}

/// The satellite's day, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (scene, start) = satellite(p)?;
    let motion = scene.solve_along(&start, DAY, p.tolerance, &Limits::default())?;
    let columns = ["t [s]", "alpha [rad]", "omega [rad/s]"];
    Trajectory::sampled(columns, times(0.0, DAY, 720), |t| {
        let state = motion.try_state(t)?;
        Ok([t, swing(p, t, &state), scene.body().angular_velocity(&state).z()])
    })
}

/// The satellite for two swings, as a frame that goes round with it sees it.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let exact = pendulum(p)?;
    let (hour, end) = (3600.0, 2.0 * exact.period() / 3600.0);
    let angle = move |t: f64| Ok(0.5 * exact.at(hour * t)?.theta);
    let curve = Curve::sampled(times(0.0, end, 200), &angle, Ink::Body)?;
    let graph = Panel::over_axes("$t$ / h", r"$\alpha$ / rad").curve(curve);
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.125 * end, 0.25 * end], move |t| {
        let angle = angle(t)?;
        let leans = match angle {
            a if a.abs() < 0.02 => "hangs straight, and nothing turns it".to_owned(),
            a => format!("leans by {a:.2} rad, and the pulls on its two ends turn it back"),
        };
        let alt = format!("The satellite after {t:.2} h {leans}; below, its angle against time.");
        Ok((alt, hung(angle)))
    })
}
