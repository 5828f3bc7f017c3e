//! The drawings of exercise 16.3, in units of the radius.

use super::*;
use core::f64::consts::PI;
use rotation_dynamics::planar::contact::Mode;

/// Floor and wall, with room to the right for the axis to go this far.
fn corner(right: f64) -> Sketch {
    Sketch::within((-1.75, right + 1.6), (-1.2, 2.45))
        .wall((-1.0, 2.4), (-1.0, 0.0))
        .wall((-1.0, 0.0), (right + 1.5, 0.0))
}

/// The cylinder set down, with the arrow of its sense (1 is counterclockwise).
fn problem(sense: f64) -> Sketch {
    let arrow = (0.5 * PI - 1.1 * sense, 0.5 * PI + 1.1 * sense);
    corner(0.6)
        .window((-1.55, 2.2), (-0.3, 2.45))
        .roller((0.0, 1.0), 1.0, 0.25 * PI, Ink::Body)
        .text((0.42, 1.3), "$R$", Ink::Body, Side::BelowRight)
        .turn((0.0, 1.0), 0.55, arrow, Ink::Velocity)
        .text((0.0, 1.6), r"$\Omega$", Ink::Velocity, Side::Above)
        .text((0.0, 1.0), "$M$", Ink::Body, Side::Below)
        .gravity((1.75, 1.5), 0.6)
}

/// The weight and the forces `[normal, tangential]` of floor and wall on the cylinder with its
/// axis here, drawn to the points of contact; the weight is so short that it ends above the
/// floor's push.
fn pushed(sketch: Sketch, (x, y): (f64, f64), [floor, wall]: [[f64; 2]; 2]) -> Sketch {
    const WEIGHT: f64 = 0.75;
    let (low, left) = ((x, y - 1.0), (x - 1.0, y));
    [
        ((x, y), (x, y - WEIGHT), "$Mg$", Side::Right),
        ((low.0, low.1 - WEIGHT * floor[0]), low, "$N_1$", Side::Right),
        (low, (low.0 + WEIGHT * floor[1], low.1), r"$\mu N_1$", Side::AboveLeft),
        ((left.0 - WEIGHT * wall[0], left.1), left, "$N_2$", Side::Below),
        (left, (left.0, left.1 - WEIGHT * wall[1]), r"$\mu N_2$", Side::AboveRight),
    ]
    .into_iter()
    .filter(|(from, to, ..)| hypot(to.0 - from.0, to.1 - from.1) >= 0.02)
    .fold(sketch, |sketch, (from, to, name, side)| sketch.arrow(from, to, Ink::Force, name, side))
}

/// Coefficients of friction, logarithmically.
fn rough() -> impl Iterator<Item = f64> {
    times(-2.0, 2.0, 160).map(|e| pow(10.0, e))
}

/// Simulated for some of them: the floor's force and the time to the stop from the spin 1.
fn simulated(of: impl Fn(&Ride, f64) -> Result<f64>) -> Result<Curve> {
    let dot = |mu| {
        let (cylinder, stop) = (Cylinder::alike(mu), 1.0 / Cylinder::alike(mu).braking());
        of(&set_down(cylinder, 1.0, 2.0 * stop, 1e-12)?, 0.5 * stop)
    };
    Ok(Curve::sampled([0.02, 0.1, 0.25, 0.6, 1.0, 2.4, 6.0, 30.0], dot, Ink::Body)?.dots())
}

figures! { p: &Parameters, [w, time, ..] = units(p)?, rides = senses(p)?, rate = p.spin.abs();
    /// A cylinder of radius R and mass M lies in the corner of a floor and a wall on its left. It turns
    /// counterclockwise with the angular velocity Omega.
    setup: problem(1.0);

    /// The same with the arrow reversed: the cylinder turns clockwise.
    setup_other: problem(-1.0);

    /// The forces on the cylinder that turns counterclockwise. At the lowest point the floor pushes upward and
    /// rubs to the left; at the leftmost point the wall pushes to the right, as strongly as the floor rubs, and
    /// rubs upward. Its weight pulls at the centre.
    forces: {
        let (mu, [floor, wall]) = (0.6, Cylinder::alike(0.6).pressed());
        let sketch = corner(0.6)
            .disc((0.0, 1.0), 1.0, Ink::Body, 0.15)
            .turn((0.0, 1.0), 0.45, (0.5 * PI - 1.1, 0.5 * PI + 1.1), Ink::Velocity)
            .dot((0.0, 1.0), Ink::Body, "", Side::Above);
        pushed(sketch, (0.0, 1.0), [[floor, -mu * floor], [wall, -mu * wall]])
    };

    /// Angular velocity against time. Pressed to the wall it falls along a straight line to zero and stays
    /// there. The other way round it falls less steeply and stays at a third of what it was; the velocity of
    /// the axis over R rises from zero to meet it there.
    spin: {
        let [pressed, away] = &rides;
        let end = 1.2 * pressed.event("floor sticks")?.t * time;
        let read = |ride: &Ride, i: usize, t: f64| Ok(ride.at((t / time).min(ride.end_time()))?.v[i].abs() / time);
        let (roll, rest) = (rate * p.radius / (3.0 * p.friction * p.gravity), rate / 3.0);
        let dots = |ride, i| Ok::<_, kit::Error>(Curve::sampled(times(0.0, end, 12), |t| read(ride, i, t), Ink::Velocity)?.dots());
        Panel::over_axes("$t$ / s", Axis::linear("angular velocity / (rad/s)").range(0.0, rate))
            .curve(Curve::new([(0.0, rate), (end / 1.2, 0.0), (end, 0.0)], Ink::Ink)
                .label_at("pressed", 0.6 * end, 0.2 * rate, Side::BelowLeft))
            .curve(Curve::new([(0.0, rate), (roll, rest), (end, rest)], Ink::Ink)
                .label_at("the other sense", 0.28 * end, 0.75 * rate, Side::AboveRight))
            .curve(Curve::new([(0.0, 0.0), (roll, rest)], Ink::Frame).dashed()
                .label_at("$v/R$", 0.25 * end, 0.09 * rate, Side::Left))
            .curve(dots(pressed, 2)?)
            .curve(dots(away, 2)?)
    };

    /// Forces over the weight against the coefficient of friction, from 0.01 to 100. That of the floor falls
    /// from one to zero. That of the wall rises to one half where the coefficient is one, and falls again. The
    /// friction of the wall rises from zero to one.
    carried: {
        let [floor, wall] = [0, 1].map(|i| move |mu: f64| Cylinder::alike(mu).pressed()[i]);
        let rub = move |mu: f64| mu * wall(mu);
        Panel::over_axes(Axis::log(r"$\mu$"), Axis::linear("force / $Mg$").range(0.0, 1.0))
            .curve(Curve::of(rough(), floor, Ink::Ink).label_at("$N_1$", 0.3, 0.95, Side::AboveRight))
            .curve(Curve::of(rough(), wall, Ink::Ink).dashed().label_at("$N_2$", 0.2, 0.22, Side::AboveLeft))
            .curve(Curve::of(rough(), rub, Ink::Force).label_at(r"$\mu N_2$", 4.0, 0.95, Side::AboveLeft))
            .curve(simulated(|ride, t| Ok(ride.forces(t)?[0].normal))?)
    };

    /// Time to the stop against the coefficient of friction, both logarithmic: it falls, has a flat minimum
    /// between two and three, and rises a little to one half. The dashed line of a floor alone lies above it
    /// where the coefficient is below one, and below it beyond.
    stop: {
        let floor = |mu: f64| 0.5 / mu;
        let stop = |mu| 1.0 / Cylinder::alike(mu).braking();
        let ticks = [0.1, 1.0, 10.0].map(|y| (y, y.to_string()));
        Panel::over_axes(Axis::log(r"$\mu$"), Axis::log(r"$t_s\,g/\Omega R$").range(0.02, 50.0).ticks(ticks))
            .curve(Curve::of(times(-2.0, 1.3, 100).map(|e| pow(10.0, e)), floor, Ink::Frame).dashed()
                .label_at("floor alone", 4.0, floor(4.0), Side::BelowLeft))
            .curve(Curve::of(rough(), stop, Ink::Ink))
            .curve(simulated(|ride, _| Ok(ride.event("floor sticks")?.t))?.label("simulated"))
            .ring(1.0 + SQRT_2, stop(1.0 + SQRT_2), Ink::Ink, r"$1+\sqrt{2}$", Side::Above)
    };

    /// The cylinder that turns clockwise at equal times, with a spoke: at first close together and turning
    /// fast, then, rolling, at equal distances.
    away: {
        let roll = rides[1].event("floor sticks")?.t;
        let until = (1.6 * roll).min(within(p, 30.0));
        let end = rides[1].at(until)?.q[0];
        let mut sketch = corner(end).window((-1.3, end + 1.3), (-0.3, 2.3)).width(560);
        for t in times(0.0, until, 8) {
            let [x, y, turned] = rides[1].at(t)?.q;
            let drawn = |sketch: Sketch| sketch.roller((x, y), 1.0, 0.5 * PI + turned, Ink::Body);
            sketch = if t < roll { sketch.ghost(drawn) } else { drawn(sketch) };
        }
        sketch
    };

    /// Spin near the stop, in steps. The contact solver's line falls to zero and stays; that of the law of
    /// signs goes on as a zigzag above and below zero.
    chatter: {
        let stop = w / Cylinder::alike(p.friction).braking();
        let h = stop / 97.4;
        let steps = by_sign(p.friction, w, false, 194.0 * h, 194);
        let steps = steps.iter().zip(1..).map(|([_, spin], i)| (f64::from(i) * h * time, spin / time));
        let near: Vec<_> = steps.filter(|(t, _)| (0.93..1.18).contains(&(t / (stop * time)))).collect();
        let line = [(0.93, 0.07), (1.0, 0.0), (1.18, 0.0)].map(|(t, part)| (t * stop * time, part * rate));
        Panel::over_axes("$t$ / s", Axis::linear("angular velocity / (rad/s)"))
            .curve(Curve::new(near, Ink::Wrong).dashed().label_at("wrong: by the sign", 1.1 * stop * time, 0.012 * rate, Side::Above))
            .curve(Curve::new(line, Ink::Velocity).label_at("held", 0.96 * stop * time, 0.04 * rate, Side::AboveRight))
    };
}

/// A time until which it goes no farther than this, slipping.
fn within(p: &Parameters, far: f64) -> f64 {
    (2.0 * far / p.friction).sqrt()
}

/// The motion that is shown, its unit of time, and until when.
fn shown(p: &Parameters) -> Result<(Ride, f64, f64)> {
    let [pressed, away] = senses(p)?;
    let (is_away, [_, time, ..]) = (p.sense == "away", units(p)?);
    let ride = if is_away { away } else { pressed };
    let change = ride.event("floor sticks")?.t;
    let end = within(p, if is_away { 20.0 } else { f64::INFINITY });
    Ok((ride, time, (1.25 * change).min(end) * time))
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let side = p.spin.signum();
    let columns = "t [s], x [m], v [m/s], turned [rad], spin [rad/s], N_floor/Mg, F_floor/Mg, N_wall/Mg, F_wall/Mg";
    let ((ride, time, end), radius) = (shown(p)?, p.radius);
    Trajectory::sampled(columns.split(", "), times(0.0, end, 250), |t| {
        let (MechanismState { q, v }, [floor, wall]) = (ride.at(t / time)?, ride.forces(t / time)?);
        let [x, v, turned, rate] = [q[0], v[0], q[2], v[2]].map(|odd| side * odd);
        let rubs = [floor.tangential, wall.tangential].map(|odd| side * odd);
        let motion = [t, radius * x, radius / time * v, turned, rate / time];
        let forces = [floor.normal, rubs[0], wall.normal, rubs[1]];
        Ok([&motion[..], &forces].concat())
    })
}

/// The cylinder with the forces on it; below, its angular velocity.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((ride, time, end), side) = (shown(p)?, p.spin.signum());
    let far = ride.at(end / time)?.q[0].max(0.6);
    let spin = |t: f64| Ok(side * ride.at(t / time)?.v[2] / time);
    let graph = Panel::over_axes("$t$ / s", r"$\omega$ / (rad/s)");
    let graph = graph.curve(Curve::sampled(times(0.0, end, 200), spin, Ink::Velocity)?);
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.45 * end, end], move |t| {
        let (MechanismState { q, v }, [floor, wall]) = (ride.at(t / time)?, ride.forces(t / time)?);
        let (modes, [x, y, turned], speed) = (ride.modes(t / time)?, q, v[2].abs() / time);
        let scene = corner(far).roller((x, y), 1.0, 0.25 * PI + turned, Ink::Body);
        let forces = [floor, wall].map(|force| [force.normal, force.tangential]);
        let scene = pushed(scene, (x, y), forces).mirrored_if(side < 0.0);
        let does = match modes {
            [Mode::Stick, Mode::Stick] => "It is at rest in the corner",
            [Mode::Stick, _] => "It rolls away from the wall",
            [_, Mode::Open] => "It slips on the floor, away from the wall",
            _ => "It slips on the floor and on the wall",
        };
        let alt = format!(
            "The cylinder after {t:.2} s with the forces on it. {does} and turns at {speed:.0} rad/s; below, that rate against time."
        );
        Ok((alt, scene))
    })
}
