//! Figures of a motion: its angles against time, and its path on the sphere.

use super::Motion;
use kit::Result;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Stack, View};
use kit::{Figure, times};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Dop853, Ode};
use rotation_dynamics::math::sincos;

/// The unit vector at tilt theta and precession phi (rad).
pub fn direction(theta: f64, phi: f64) -> SpaceVector {
    let ((s, u), (sp, cp)) = (sincos(theta), sincos(phi));
    SpaceVector::new(s * sp, -s * cp, u)
}

/// The ranges of theta, phi and zeta over what is shown of these motions, with a margin
/// around theta: the axes of figures that stand side by side.
pub fn extents(motions: &[Motion]) -> [(f64, f64); 3] {
    let mut ranges = [(f64::INFINITY, f64::NEG_INFINITY); 3];
    for motion in motions {
        for (range, own) in ranges.iter_mut().zip(motion.extents()) {
            *range = (range.0.min(own.0), range.1.max(own.1));
        }
    }
    ranges
}

impl Motion {
    /// How far it is shown, in its own unit of time: to its end, or 12 nods.
    pub fn shown(&self) -> f64 {
        self.end.min(12.0 * self.exact.nutation_period())
    }

    /// The ranges of theta, phi and zeta (rad) over what is shown.
    pub fn extents(&self) -> [(f64, f64); 3] {
        let mut ranges = [(f64::INFINITY, f64::NEG_INFINITY); 3];
        for t in times(0.0, self.shown(), 400) {
            let angles = self.exact.angles(t);
            for (range, x) in ranges.iter_mut().zip([angles.theta, angles.phi, angles.zeta]) {
                *range = (range.0.min(x), range.1.max(x));
            }
        }
        for (range, least) in ranges.iter_mut().zip([1e-6, 1e-12, 1e-12]) {
            let length = range.1 - range.0;
            let margin = if length < least { 0.4 } else { 0.0 };
            *range = (range.0 - margin, range.1 + margin);
        }
        let [tilt, ..] = &mut ranges;
        let margin = 0.08 * (tilt.1 - tilt.0);
        *tilt = (tilt.0 - margin, tilt.1 + margin);
        ranges
    }

    /// theta, phi and zeta against time: closed form, with a run of the notes'
    /// `equations` as dots.
    ///
    /// # Errors
    /// Those of the run and of the drawing.
    pub fn angles(&self, equations: &impl Ode<4>) -> Result<Figure> {
        self.angles_over(self.extents(), equations)
    }

    /// The same over these ranges of theta, phi and zeta; see [`extents`].
    ///
    /// # Errors
    /// As [`Motion::angles`].
    pub fn angles_over(&self, ranges: [(f64, f64); 3], equations: &impl Ode<4>) -> Result<Figure> {
        let (start, end) = (self.start(), self.shown());
        let run = Dop853::new(1e-10)?.solve(equations, 0.0, &start, end / self.unit, &[])?;
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
        let (least, most) = (self.exact.theta_min(), self.exact.theta_max());
        let last = self.exact.angles(end);
        let alt = format!(
            "{}: theta between {least:.2} and {most:.2} rad, phi up to {:.2} rad and zeta up to {:.2} rad \
             against time, in closed form, and on the lines dots by the notes' equations",
            self.scene(),
            last.phi,
            last.zeta,
        );
        let labels = ["$\\theta$", "$\\phi$", "$\\zeta$"];
        let mut stack = Stack::new(&self.figure_name("angles"), &alt).row_height(100);
        for (((line, dots), label), (low, high)) in rows.into_iter().zip(labels).zip(ranges) {
            let panel = Panel::new("row", "row")
                .x(Axis::linear(time))
                .y(Axis::linear("").range(low, high))
                .curve(Curve::new(line, Ink::Ink).label_end(label))
                .curve(Curve::new(dots, Ink::Body).dots());
            stack = stack.panel(panel);
        }
        stack.figure()
    }

    /// The regime, and the two numbers that tell the motions of the notes apart.
    fn scene(&self) -> String {
        let (b, energy) = (self.top.b(), self.energy);
        format!("{}, b = {b:.3}, E~ = {energy:.3}", self.regime())
    }

    fn figure_name(&self, what: &str) -> String {
        if self.name.is_empty() { format!("motion_{what}") } else { self.key(what) }
    }

    /// The path of the end of the axis on the sphere, over the time that its angles show.
    ///
    /// # Errors
    /// Those of the drawing.
    pub fn trace(&self, camera: Camera) -> Result<Figure> {
        let end = self.shown();
        let path = times(0.0, end, 2000).map(|t| self.exact.axis(t));
        let start = self.exact.axis(0.0);
        let heading = times(0.45, 0.46, 12).map(|part| self.exact.axis(end * part));
        let alt = format!(
            "{}: the path of the end of the axis on a sphere, between two circles {:.2} and {:.2} rad from the pole",
            self.scene(),
            self.exact.theta_min(),
            self.exact.theta_max(),
        );
        View::new(&self.figure_name("trace"), &alt)
            .camera(camera)
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
