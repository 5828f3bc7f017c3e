//! The methods that step a motion, each with one setting.
//!
//! The setting is the *level*: one level up, the error is 40 times smaller (of DOP853 13 times). A method of
//! order p then takes 40^(1/p) times as many steps, an adaptive one is given a 40 times
//! smaller error of a step. So methods of any order are refined alike.

use super::constants::{LEVEL, ORDER_SIXTEEN};
use super::problem::{Acting, Problem};
use crate::accuracy::Variables;
use crate::integrators::Method as Named;
use crate::math::{exp, log};

/// A method, the variables it steps, and its model, measured on random motions of every kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Method {
    /// The name that is printed.
    pub name: &'static str,
    pub named: Named,
    pub variables: Variables,
    /// The angle (rad) that the fastest rotation makes in a step at level 0.
    angle: f64,
    /// The error of a turn at level 0, as a power of 40 (median),
    first: f64,
    /// and how that grows with the power of the torque over the kinetic energy.
    with_torque: f64,
    /// By how many levels the error falls with each.
    pub falls: f64,
    /// The coarsest level that is tried: beyond it Gauss-Legendre's sweeps do not converge, and the
    /// others are no longer in their order.
    pub coarsest: f64,
    /// The level beyond which there is nothing but round-off, whatever the scene.
    pub finest: f64,
    /// The smallest error that it reaches, in units of eps (1 + condition): the largest of 600 random
    /// motions.
    pub floor: f64,
    /// The error that rounding adds to the attitude in a step, in units of eps. Measured on runs of
    /// DOP853 of up to a million steps: 0.15; of Gauss-Legendre over 155 000 steps of a pulse: 0.11.
    pub rounded: f64,
}

/// Gauss-Legendre on attitude and momentum.
const GAUSS: Method = Method {
    name: Named::GaussLegendre16.name(),
    named: Named::GaussLegendre16,
    variables: Variables::Space,
    angle: 1.6,
    first: -8.5,
    with_torque: 0.0,
    falls: 1.0,
    coarsest: -2.0,
    finest: 12.0,
    floor: 24.0,
    rounded: 0.5,
};

/// The same on the axes of a body without torque, or under effects that see e3 only.
const BODY_GAUSS: Method = Method { variables: Variables::Body, floor: 8.0, rounded: 0.0, ..GAUSS };

/// The same without the spin.
const SPIN_FREE_GAUSS: Method = Method {
    name: "Gauss-Legendre 16, spin-free",
    variables: Variables::SpinFree,
    angle: 2.5,
    ..BODY_GAUSS
};

/// The splitting of order 6 with what resists the rotation in its kick.
const RESISTED: Method = Method {
    name: "SRKN 14a, resisted",
    named: Named::Srkn14,
    variables: Variables::Space,
    angle: 4.0,
    first: -3.7,
    with_torque: 0.85,
    coarsest: -0.5,
    ..BODY_GAUSS
};

/// DOP853 on attitude and momentum.
const ADAPTIVE: Method = Method {
    name: Named::Dop853.name(),
    named: Named::Dop853,
    variables: Variables::Space,
    angle: 4.0,
    first: -3.2,
    with_torque: 0.0,
    falls: 0.7,
    coarsest: -0.5,
    finest: 7.4,
    floor: 24.0,
    rounded: 0.5,
};

/// The same on the axes of a slender body.
const ON_BODY: Method = Method { variables: Variables::Body, ..ADAPTIVE };

impl Method {
    /// Those that are tried for this error, the first that converges to it delivers.
    pub(super) fn candidates(problem: &Problem, tolerance: f64) -> &'static [Self] {
        let symmetric = problem.body.moments().is_symmetric();
        // Where it is strong the steps would follow what resists, and not the rotation.
        let is_thick = RESISTED.angle * problem.damping > problem.fastest();
        let resisted = !is_thick && problem.is_resisted();
        match problem.acting {
            _ if problem.has_laws() => &[ADAPTIVE],
            _ if problem.is_slender() => &[ON_BODY],
            Acting::Weight(_) | Acting::OnAxis(_) if symmetric => &[SPIN_FREE_GAUSS, ADAPTIVE],
            Acting::Nothing | Acting::Weight(_) | Acting::OnAxis(_) => &[BODY_GAUSS, ADAPTIVE],
            _ if resisted => &[RESISTED, ADAPTIVE],
            Acting::Smooth(_) if tolerance < ORDER_SIXTEEN => &[GAUSS, ADAPTIVE],
            Acting::Smooth(_) => &[ADAPTIVE, GAUSS],
            Acting::Anything(_) => &[ADAPTIVE],
        }
    }

    /// The order p.
    const fn order(self) -> f64 {
        self.named.order() as f64
    }

    /// The level at which this error (rad) is expected at the end. Errors of a turn add up, and
    /// errors of the energy, which DOP853 does not keep, do so once more.
    pub(super) fn level_for(self, problem: &Problem, error: f64) -> f64 {
        let energy = problem.body.kinetic_energy(&problem.start);
        let weight = if energy > 0.0 { problem.torque / energy } else { 1e3 };
        let torque = log(weight.clamp(1e-6, 1e3)) / LEVEL;
        let turns = self.turned(problem, problem.span()) / core::f64::consts::TAU;
        let turns = turns.max(1.0);
        let grown = if self.is_adaptive() { turns * turns } else { turns };
        let levels = self.first + self.with_torque * torque - log(error / grown) / LEVEL;
        (levels / self.falls).clamp(self.coarsest, self.finest - 1.0)
    }

    /// True if it chooses its steps itself, and so answers a small change of the start
    /// with a small jump.
    pub(super) const fn is_adaptive(self) -> bool {
        matches!(self.named, Named::Dop853)
    }

    /// By what factor the steps grow when the level is raised by so much.
    pub(super) fn more_steps(self, levels: f64) -> f64 {
        exp(levels * LEVEL / self.order())
    }

    /// A bound on the rates (rad/s) that this method has to follow.
    fn rate(self, problem: &Problem) -> f64 {
        let moments = problem.body.moments();
        // Without the spin the axis turns with L/I1; falling sets free up to 2 m g l.
        let of_axis = || {
            let turning = problem.start.angular_momentum.norm() / moments.i1();
            turning + 2.0 * (problem.torque / moments.i1()).sqrt()
        };
        match self.named {
            _ if self.variables == Variables::SpinFree => of_axis(),
            Named::GaussLegendre16 | Named::Dop853 => problem.fastest(),
            _ => {
                let rate = if moments.is_symmetric() { of_axis() } else { problem.fastest() };
                // Nor are steps in their order that take most of the momentum at once.
                rate.max(self.angle * problem.damping)
            }
        }
    }

    /// The angle (rad) turned until `t_end`, on which the number of steps rests; 1 at
    /// least, so that a finer level takes more steps of whatever seems at rest.
    pub(super) fn turned(self, problem: &Problem, t_end: f64) -> f64 {
        (self.rate(problem) * t_end.abs()).max(1.0)
    }

    /// The steps of this level until `t_end` (not for adaptive methods).
    pub(super) fn steps(self, problem: &Problem, t_end: f64, level: f64) -> f64 {
        self.turned(problem, t_end) / self.angle * self.more_steps(level)
    }

    /// The level at which this many steps are taken (not for adaptive methods).
    pub(super) fn level_of(self, problem: &Problem, t_end: f64, steps: f64) -> f64 {
        let base = self.turned(problem, t_end) / self.angle;
        log(steps / base) * self.order() / LEVEL
    }

    /// Torques that a step takes: of Gauss-Legendre in a dozen sweeps.
    pub(super) const fn torques(self) -> f64 {
        match self.named {
            Named::GaussLegendre16 => 8.0 * 12.0,
            Named::Dop853 => 12.0,
            _ => 14.0,
        }
    }
}
