//! Pictures of a motion: its angles against time, and its path on the sphere.

use super::Equations;
use super::motions::Motion;
use rotation_dynamics::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::sincos;
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Camera, Curve, Ink, Panel, Side, Stack, View};

use core::f64::consts::PI;

/// The chapter's camera: the notes' start (phi = 0) lies to the left, in front.
pub fn camera() -> Camera {
    Camera::new(-0.45, 0.7)
}

/// The unit vector at tilt theta and precession phi.
pub fn direction(theta: f64, phi: f64) -> SpaceVector {
    let ((s, u), (sp, cp)) = (sincos(theta), sincos(phi));
    SpaceVector::new(s * sp, -s * cp, u)
}

/// theta, phi and zeta against time: closed form, with the notes' equations as dots.
pub fn angles(motion: &Motion) -> Result<Figure> {
    let (name, end) = (figure_name(motion, "angles"), motion.end);
    let run = Dop853::new(1e-10)?.solve(
        &Equations::of(&motion.top),
        0.0,
        &motion.start(),
        end / motion.unit,
        &[],
    )?;
    let mut rows: [(Vec<_>, Vec<_>); 3] = Default::default();
    for k in 0..=400 {
        let t = end * f64::from(k) / 400.0;
        let exact = motion.exact.angles(t);
        for (row, value) in rows.iter_mut().zip([exact.theta, exact.phi, exact.zeta]) {
            row.0.push((t, value));
        }
        if k % 16 == 8 {
            let [theta, _, phi, zeta] = run.at(t / motion.unit)?;
            for (row, value) in rows.iter_mut().zip([theta, phi, zeta]) {
                row.1.push((t, value));
            }
        }
    }
    let [theta, phi, zeta] = rows;
    let row = |(line, dots): (Vec<_>, Vec<_>), label: &str, axis: Axis| {
        Panel::new("row", "row")
            .x(Axis::linear(if motion.in_seconds() {
                "$t$ / s"
            } else {
                "$t'$"
            }))
            .y(axis)
            .curve(Curve::new(line, Ink::Ink).label_end(label))
            .curve(Curve::new(dots, Ink::Body).dots())
    };
    let (least, most) = (motion.exact.theta_min(), motion.exact.theta_max());
    let margin = if most - least < 1e-6 {
        0.4
    } else {
        0.08 * (most - least)
    };
    let tilt = Axis::angle("").range(least - margin, most + margin);
    Stack::new(
        &name,
        &format!(
            "{}: theta, phi and zeta against time, in closed form and as dots by the notes' equations",
            scene(motion)
        ),
    )
    .row_height(100)
    .panel(row(theta, "$\\theta$", tilt))
    .panel(row(phi, "$\\phi$", Axis::angle("")))
    .panel(row(zeta, "$\\zeta$", Axis::angle("")))
    .figure()
}

/// The regime, and the two numbers that tell the motions of the notes apart.
fn scene(motion: &Motion) -> String {
    format!(
        "{}, b = {:.3}, E~ = {:.3}",
        motion.regime(),
        motion.top.b(),
        motion.energy
    )
}

fn figure_name(motion: &Motion, what: &str) -> String {
    if motion.name.is_empty() {
        format!("motion_{what}")
    } else {
        format!("{}_{what}", motion.name)
    }
}

/// The path of the axis on the sphere, for half a turn around the vertical.
pub fn trace(motion: &Motion) -> Result<Figure> {
    let period = motion.exact.nutation_period();
    let advance = motion.exact.precession_per_period().abs();
    let nods = (PI / advance.max(1e-3)).clamp(3.0, 12.0);
    let end = if period.is_finite() && advance > 0.0 {
        nods * period
    } else {
        motion.end
    };
    let points = 2000_u32;
    let path = (0..=points).map(|k| motion.exact.axis(end * f64::from(k) / f64::from(points)));
    let start = motion.exact.axis(0.0);
    let heading: Vec<SpaceVector> = (0..=12)
        .map(|k| motion.exact.axis(end * (0.5 + 0.002 * f64::from(k))))
        .collect();
    View::new(
        &figure_name(motion, "trace"),
        &format!(
            "{}: the path of the end of the axis on a sphere",
            scene(motion)
        ),
    )
    .camera(camera())
    .sphere()
    .latitude(motion.exact.theta_min())
    .latitude(motion.exact.theta_max())
    .trace(path, Ink::Body)
    .turn(heading, Ink::Body)
    .arrow(SpaceVector::zero(), start, Ink::Body, "", Side::Left)
    .dot(start, Ink::Body, "start", Side::Left)
    .triad()
    .figure()
}
