//! The drawings of the phone; all but the set-up, the ten flips and the throw are over turns and
//! hold for every rate.

use super::*;
use core::f64::consts::FRAC_PI_2;
use models::throws::{self, camera};
use rotation_dynamics::exact::free_body::FreeBody;

/// The phone about `centre`.
fn phone(view: View, p: &Parameters, attitude: &Attitude, centre: SpaceVector) -> View {
    throws::phone(view, [p.length, p.width, p.thickness], attitude, centre)
}

/// The rates over that of the turn, and the time in turns.
fn unit(p: &Parameters, tilt: f64, toward: f64) -> Result<Throw> {
    Ok(Throw::new(slab(p)?, TAU, tilt, toward))
}

/// Thrown with `axis` 0, 1 or 2 nearly along L: the angle of the axis from L over turns.
fn three(p: &Parameters, axis: usize) -> Result<(Throw, impl Fn([f64; 3]) -> f64)> {
    let mut rates = [0.0; 3];
    (rates[axis], rates[(axis + 1) % 3]) = (TAU * cos(0.05), TAU * sin(0.05));
    let throw = Throw { moments: slab(p)?, rates };
    Ok((throw, move |rates| acos(throw.along(axis, rates).clamp(-1.0, 1.0)).to_degrees()))
}

figures! { p: &Parameters;
    /// A phone as it leaves the hand, its screen up. Its axes: 1 along the long edge, away from the hand, 2 along the short
    /// edge, to the right, 3 out of its back, downward. It turns about 2, the far end going up; the axis of rotation is a small
    /// angle off, towards axis 1.
    setup: {
        let attitude = unit(p, 0.1, 0.0)?.start()?.attitude;
        let out = |x: f64, y: f64, z: f64| attitude.to_space(BodyVector::new(x, y, z)) * p.length;
        let origin = SpaceVector::zero();
        let arc = times(-0.5, 0.9, 30).map(|a| out(0.78 * cos(a), 0.0, -0.78 * sin(a)));
        let view = View::of(out(0.05, 0.05, 0.1), 0.85 * p.length).camera(camera());
        phone(view, p, &attitude, origin)
            .arrow(out(0.5, 0.0, 0.0), out(0.85, 0.0, 0.0), Ink::Body, "1", Side::Right)
            .arrow(out(0.0, 0.25, 0.0), out(0.0, 0.72, 0.0), Ink::Body, "2", Side::Below)
            .arrow(out(0.0, 0.0, 0.03), out(0.0, 0.0, 0.5), Ink::Body, "3", Side::Below)
            .arrow(origin, out(0.16, 0.68, 0.0), Ink::Velocity, r"$\omega$", Side::Right)
            .turn(arc, Ink::Velocity)
    };

    /// Turns until the phone is half over, against the angle of the axis of rotation from the short edge, which spans nine
    /// decades: nearly straight lines that fall, for the two directions close together, from five turns to half a turn. A level
    /// line: the flight.
    waiting: {
        let angles = |n| times(-9.0, -0.3, n).map(|e| pow(10.0, e));
        let exact = |toward| {
            let wait = |x| unit(p, x, toward).and_then(|throw| Ok(throw.until_flip()?)).unwrap_or(f64::NAN);
            Curve::of(angles(90), wait, Ink::Ink)
        };
        let simulated = |toward| Curve::sampled(angles(9), |x| Ok(unit(p, x, toward)?.flip(1, 1e-13)?.t), Ink::Body);
        let (x, y) = (Axis::log("angle off the short edge / rad").range(1e-9, 0.6), Axis::linear("turns until half over"));
        Panel::over_axes(x, y.range(0.0, 5.0))
            .curve(exact(0.0))
            .curve(exact(FRAC_PI_2).dashed())
            .curve(simulated(0.0)?.dots().label_at("simulated", 1e-6, 3.2, Side::Right))
            .curve(simulated(FRAC_PI_2)?.dots())
            .level(p.turns.abs() * flight(p), Ink::Frame, "the flight")
    };

    /// Angle of the axis of the throw from L over four turns, for throws 0.05 rad off. About the short edge it rises to 175
    /// degrees within a turn and a half, falls back, and rises again. About the long edge and about the normal it stays below a
    /// few degrees and sways.
    three: {
        let panel = Panel::over_axes(Axis::linear("turns").range(0.0, 4.0), Axis::linear("axis from $L$ / degrees").range(0.0, 180.0).step(45.0));
        let labels = [("long edge, normal", 1.7, 13.0, Side::Above), ("short edge", 1.7, 165.0, Side::Below), ("", 2.2, 4.0, Side::Above)];
        (0..3).zip(labels).try_fold(panel, |panel, (axis, (label, x, y, side))| {
            let (throw, angle) = three(p, axis)?;
            let free = throw.free()?;
            let line = Curve::of(times(0.0, 4.0, 240), |t| angle(free.angular_velocity(t).to_array()), Ink::Ink);
            let run = Dop853::new(1e-13)?.solve(&euler(throw.moments), 0.0, &throw.rates, 4.0, &[])?;
            let dots = Curve::sampled(times(0.1, 3.9, 19), |t| Ok(angle(run.at(t)?)), Ink::Body)?.dots();
            Ok::<_, kit::Error>(panel.curve(line.label_at(label, x, y, side)).curve(dots))
        })?
    };

    /// A plane of how far the axis of rotation is off towards the long edge and towards the normal, filled with the throws of a
    /// hand in a round cloud. A strip leads through its middle from lower left to upper right; in it are rings, the throws that
    /// are not half over after one turn, outside it dots.
    strip: {
        let moments = slab(p)?;
        let [into_1, into_3] = exchange(moments);
        let lean = (into_1 / into_3).sqrt();
        let wide = 3.0 * p.spread;
        let axis = |label: &str| Axis::linear(label).range(-wide, wide);
        let mut panel = Panel::over_axes(axis("towards the long edge / rad"), axis("towards the normal / rad")).equal_aspect();
        for throw in hand(300, moments, TAU, p.spread) {
            let [x, _, y] = throw.rates.map(|rate| rate / TAU);
            panel = match throw.until_flip()? < 1.0 {
                _ if x.abs().max(y.abs()) >= wide => panel,
                true => panel.dot(x, y, Ink::Body, "", Side::Above),
                false => panel.ring(x, y, Ink::Ink, "", Side::Above),
            };
        }
        let half = 4.0 * into_1.sqrt() * exp(-growth(moments) * TAU);
        [-half, 0.0, half].into_iter().fold(panel, |panel, off| {
            let low = (-wide).max((-wide - off) / lean);
            let high = wide.min((wide - off) / lean);
            let edge = Curve::new([(low * lean + off, low), (high * lean + off, high)], Ink::Ink);
            panel.curve(if off == 0.0 { edge.dashed() } else { edge })
        })
    };

    /// Part of a hand's throws that are half over, against the turns since the release, for three spreads. Each curve begins at
    /// zero, rises steeply between half a turn and a turn and a half and comes close to one; the wider the spread, the earlier.
    /// Dots: counted among six hundred throws.
    hand: {
        let moments = slab(p)?;
        let turns = Sweep::over("turns", 0.2, 2.0).at([0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8]);
        let panel = turns.panel(Axis::linear("part that is half over").range(0.0, 1.0));
        let spreads = [(0.0125, "0.0125", 1.12, 0.42), (0.05, "0.05", 0.84, 0.42), (0.2, "0.2", 0.56, 0.42)];
        spreads.into_iter().try_fold(panel, |panel, (spread, label, x, y)| {
            let exact = turns.exact(|x| 1.0 - steady(moments, x, spread).unwrap_or(f64::NAN)).label_at(label, x, y, Side::Left);
            let counted = |x| part(hand(600, moments, TAU, spread), |throw| Ok(throw.until_flip()? < x));
            Ok::<_, kit::Error>(panel.curve(exact).curve(turns.simulated(counted)?))
        })?
    };

    /// Part of L along the short edge, against the time: from one it falls to minus one, comes back, and so on, five times in
    /// equal intervals. Rings at the zeros are the times of the closed form; dots, the simulation, lie on the line.
    ten: flips_in_a_row(&thrown(p)?, 0)?;

    /// The same, going on: flips six to ten, in the same intervals.
    ten_on: flips_in_a_row(&thrown(p)?, 5)?;
}

/// Five flips, after so many others.
fn flips_in_a_row(throw: &Throw, before: u32) -> Result<Panel> {
    let (first, between, free) = (throw.until_flip()?, throw.between_flips()?, throw.free()?);
    let at = |n: f64| first + n * between;
    let (from, to) = (at(f64::from(before) - 0.5).max(0.0), at(f64::from(before) + 4.5));
    let run = Dop853::new(1e-13)?.solve(&euler(throw.moments), 0.0, &throw.rates, to, &[])?;
    let exact = |t| throw.along(1, free.angular_velocity(t).to_array());
    let line = Curve::of(times(from, to, 300), exact, Ink::Momentum);
    let simulated = |t: f64| Ok(throw.along(1, run.at(t)?));
    let dots = Curve::sampled(times(from, to, 50), simulated, Ink::Momentum)?.dots();
    let part = Axis::linear("$L_2/L$").range(-1.0, 1.0).step(1.0);
    let panel = Panel::over_axes(Axis::linear("$t$ / s").range(from, to), part).size(340, 170);
    Ok((before..before + 5).fold(panel.curve(line).curve(dots), |panel, n| {
        panel.ring(at(f64::from(n)), 0.0, Ink::Ink, &format!("{}", n + 1), Side::Right)
    }))
}

/// The free motion through ten flips, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let throw = thrown(p)?;
    let free = throw.free()?;
    let end = throw.until_flip()? + 9.5 * throw.between_flips()?;
    let columns =
        "t [s], omega_1 [rad/s], omega_2 [rad/s], omega_3 [rad/s], L_2/L [-], screen up [-]";
    Trajectory::sampled(columns.split(", "), times(0.0, end, 1000), |t| {
        let at = free.kinematics(t);
        let rates @ [p, q, r] = at.angular_velocity.to_array();
        Ok([t, p, q, r, throw.along(1, rates), screen(&at.attitude).z()])
    })
}

/// The throw from the hand to the hand, and how much of L is along axis 2.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, throw, end) = (p.clone(), thrown(p)?, flight(p));
    let free = throw.free()?;
    let along = move |t: f64, free: &FreeBody| throw.along(1, free.angular_velocity(t).to_array());
    let graph = Panel::over_axes("$t$ / s", Axis::linear("$L_2/L$").range(-1.0, 1.0).step(1.0))
        .curve(Curve::of(times(0.0, end, 300), |t| along(t, &free), Ink::Momentum));
    let stills = [0.0, throw.until_flip()?.min(end), end];
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let attitude = free.attitude(t);
        // The height is drawn reduced, so that the phone is large.
        let reduced = 0.1_f64.min(0.38 * p.length / p.height);
        let centre = SpaceVector::new(0.0, 0.0, reduced * (0.5 * p.gravity * t * (end - t)));
        let axis = attitude.to_space(BodyVector::new(0.0, 1.0, 0.0)) * (0.8 * p.length);
        let momentum = free.angular_momentum();
        let momentum = momentum * (0.95 * p.length / momentum.norm());
        let looks = if screen(&attitude).z() > 0.0 { "up" } else { "down" };
        let part = 100.0 * along(t, &free);
        let alt = format!(
            "The phone {t:.2} s after it has left the hand, in the air; its screen looks {looks}, \
             and {part:.0} per cent of L are along axis 2. Below, that part against time."
        );
        let view = View::of(SpaceVector::new(0.0, 0.0, 0.5 * reduced * p.height), 0.76 * p.length)
            .camera(camera())
            .size(340, 220);
        let scene = phone(view, &p, &attitude, centre)
            .vector(centre, centre + momentum, Ink::Momentum, "$L$", Side::Below)
            .arrow(centre, centre + axis, Ink::Body, "2", Side::Left);
        Ok((alt, scene))
    })
}
