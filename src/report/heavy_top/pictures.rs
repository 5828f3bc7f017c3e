//! Figures of a motion: its angles against time, and its path on the sphere.

use super::Motion;
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::integrators::{Dop853, Ode};
use crate::math::sincos;
use crate::report::draw::{Axis, Camera, Curve, Ink, Panel, Side, Stack, View};
use crate::report::{Figure, times};
use core::f64::consts::PI;

/// The unit vector at tilt theta and precession phi (rad).
pub fn direction(theta: f64, phi: f64) -> SpaceVector {
    let ((s, u), (sp, cp)) = (sincos(theta), sincos(phi));
    SpaceVector::new(s * sp, -s * cp, u)
}

impl Motion {
    /// theta, phi and zeta against time: closed form, with a run of the notes'
    /// `equations` as dots.
    ///
    /// # Errors
    /// Those of the run and of the drawing.
    pub fn angles(&self, equations: &impl Ode<4>) -> Result<Figure> {
        let (start, end) = (self.start(), self.end);
        let run = Dop853::new(1e-10)?.solve(equations, 0.0, &start, self.end_reduced(), &[])?;
        let mut rows: [(Vec<_>, Vec<_>); 3] = Default::default();
        for (k, t) in times(0.0, end, 400).enumerate() {
            let exact = self.exact.angles(t);
            for (row, value) in rows.iter_mut().zip([exact.theta, exact.phi, exact.zeta]) {
                row.0.push((t, value));
            }
            if k % 16 == 8 {
                let [theta, _, phi, zeta] = run.at(t / self.unit)?;
                for (row, value) in rows.iter_mut().zip([theta, phi, zeta]) {
                    row.1.push((t, value));
                }
            }
        }
        let time = if self.in_seconds() { "$t$ / s" } else { "$t'$" };
        let row = |(line, dots): (Vec<_>, Vec<_>), label: &str, axis: Axis| {
            Panel::new("row", "row")
                .x(Axis::linear(time))
                .y(axis)
                .curve(Curve::new(line, Ink::Ink).label_end(label))
                .curve(Curve::new(dots, Ink::Body).dots())
        };
        let [theta, phi, zeta] = rows;
        let (least, most) = (self.exact.theta_min(), self.exact.theta_max());
        let margin = if most - least < 1e-6 {
            0.4
        } else {
            0.08 * (most - least)
        };
        let tilt = Axis::angle("").range(least - margin, most + margin);
        let alt = format!(
            "{}: theta, phi and zeta against time, in closed form and as dots by the notes' equations",
            self.scene()
        );
        Stack::new(&self.figure_name("angles"), &alt)
            .row_height(100)
            .panel(row(theta, "$\\theta$", tilt))
            .panel(row(phi, "$\\phi$", Axis::angle("")))
            .panel(row(zeta, "$\\zeta$", Axis::angle("")))
            .figure()
    }

    /// The regime, and the two numbers that tell the motions of the notes apart.
    fn scene(&self) -> String {
        let (b, energy) = (self.top.b(), self.energy);
        format!("{}, b = {b:.3}, E~ = {energy:.3}", self.regime())
    }

    fn figure_name(&self, what: &str) -> String {
        if self.name.is_empty() {
            format!("motion_{what}")
        } else {
            self.key(what)
        }
    }

    /// The path of the axis on the sphere, for half a turn around the vertical.
    ///
    /// # Errors
    /// Those of the drawing.
    pub fn trace(&self) -> Result<Figure> {
        let period = self.exact.nutation_period();
        let advance = self.exact.precession_per_period().abs();
        let nods = (PI / advance.max(1e-3)).clamp(3.0, 12.0);
        let end = if period.is_finite() && advance > 0.0 {
            nods * period
        } else {
            self.end
        };
        let path = times(0.0, end, 2000).map(|t| self.exact.axis(t));
        let start = self.exact.axis(0.0);
        let heading = times(0.5, 0.524, 12).map(|part| self.exact.axis(end * part));
        let alt = format!(
            "{}: the path of the end of the axis on a sphere",
            self.scene()
        );
        View::new(&self.figure_name("trace"), &alt)
            .camera(Camera::new(-0.45, 0.7))
            .sphere()
            .latitude(self.exact.theta_min())
            .latitude(self.exact.theta_max())
            .trace(path, Ink::Body)
            .turn(heading, Ink::Body)
            .arrow(SpaceVector::zero(), start, Ink::Body, "", Side::Left)
            .dot(start, Ink::Body, "start", Side::Left)
            .triad()
            .figure()
    }
}
