//! The asteroid as it tumbles, with L upright, and as it was seen.

use super::figures::december;
use super::*;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, Stack, View, smooth};
use kit::{MovingPicture, Trajectory, sampled, times};

/// Half of the lengths of the body along x, y and the long axis, over the last: 4.6 km in all.
const HALF_AXES: [f64; 3] = [0.52, 0.42, 1.0];

/// Its outline: two lobes, the height along the long axis and the share of the width.
const LOBES: [(f64, f64); 11] = [
    (-1.0, 0.0),
    (-0.92, 0.42),
    (-0.72, 0.8),
    (-0.42, 1.0),
    (-0.1, 0.93),
    (0.18, 0.68),
    (0.34, 0.55),
    (0.55, 0.66),
    (0.78, 0.62),
    (0.94, 0.36),
    (1.0, 0.0),
];

/// The body in this attitude, so many times as large.
fn body(attitude: &Attitude, size: f64) -> Solid {
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    Solid::turned(SpaceVector::zero(), up, &smooth(&LOBES)).carried(|at| {
        let [x, y, z] = HALF_AXES;
        attitude.to_space(BodyVector::new(x * at.x(), y * at.y(), z * at.z())) * size
    })
}

/// Its attitude and angular velocity through December 1992, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = [
        "t [s]",
        "phi [rad]",
        "theta [rad]",
        "zeta [rad]",
        "wx [rad/s]",
        "wy [rad/s]",
        "wz [rad/s]",
    ];
    let motion = published(p)?.motion()?;
    Trajectory::sampled(columns, times(0.0, 40.0 * DAY, 800), |t| {
        let found = motion.kinematics(t);
        let (angles, [x, y, z]) =
            (found.attitude.euler_angles(), found.angular_velocity.to_array());
        Ok([t, angles.phi, angles.theta, angles.zeta, x, y, z])
    })
}

/// The tumbling of December 1992 with L, the angular velocity, and the nearest image; below it
/// two components of the angular velocity, measured and computed.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (motion, mut days) = (published(p)?.motion()?, observed()?);
    days.pop();
    let up = upright(motion.angular_momentum())?;
    let z = BodyVector::new(0.0, 0.0, 1.0);
    let lean = move |attitude: &Attitude| {
        acos((up * *attitude).to_space(z).z().clamp(-1.0, 1.0)).to_degrees()
    };
    let [from, to] = [days[0].t, days[16].t];
    let per_day = (1.0 * DAY).to_degrees();
    let rate = |i: usize| {
        let line = sampled(times(from, to, 300), |t| {
            Ok((december(t), motion.angular_velocity(t)[i] * per_day))
        });
        let seen: Vec<_> =
            days.iter().map(|day| (december(day.t), day.angular_velocity[i] * per_day)).collect();
        line.map(|line| (line, seen))
    };
    let ((x, seen_x), (y, seen_y)) = (rate(0)?, rate(1)?);
    let graph = Panel::new("graph", "")
        .x(Axis::linear("day of December 1992").step(4.0))
        .y(Axis::linear("deg/d").step(50.0))
        .curve(Curve::new(x, Ink::Velocity).label_end(r"$\Omega_x$"))
        .curve(Curve::new(y, Ink::Ink).dashed().label_end(r"$\Omega_y$"))
        .curve(Curve::new(seen_x, Ink::Velocity).dots())
        .curve(Curve::new(seen_y, Ink::Ink).dots());
    let span = december(from)..=december(to);
    let stills: Vec<f64> = [4, 8, 15].map(|i| december(days[i].t)).into();
    MovingPicture::new(span, stills, move |day| {
        let t = (day - december(0.0)) * DAY;
        let found = motion.kinematics(t);
        let shown = up * found.attitude;
        let off = |other: &Observed| (other.t - t).abs();
        let nearest = days.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let image = nearest.filter(|other| off(other) < 0.25 * DAY);
        let speed = shown.to_space(found.angular_velocity) * (0.6 * DAY);
        let origin = SpaceVector::zero();
        let alt = format!(
            "The asteroid on day {day:.1} of December 1992, its long axis {:.0} degrees from L, which points up; the angular \
             velocity leans beside it{}; below, two components of the angular velocity against time, measured values as dots.",
            lean(&found.attitude),
            [
                "",
                ", and a grey silhouette behind it shows the attitude seen by radar"
            ][usize::from(image.is_some())]
        );
        let view = View::new("scene", &alt)
            .around(SpaceVector::new(0.0, 0.0, 0.1), 1.3)
            .solid(body(&shown, 1.0), Ink::Body)
            .arrow(
                origin,
                SpaceVector::new(0.0, 0.0, 1.3),
                Ink::Momentum,
                "$L$",
                Side::Right,
            )
            .arrow(origin, speed, Ink::Velocity, r"$\Omega$", Side::Left);
        let view = image
            .into_iter()
            .fold(view, |view, other| view.ghost(body(&(up * other.attitude), 1.06), Ink::Ink));
        Stack::frame(&alt, view, &graph, day)
    })
    .map(|picture| picture.timed("day of December 1992"))
}
