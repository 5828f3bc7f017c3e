//! Hard cases: where the arithmetic that everyone writes first breaks, and the form that holds.
//!
//! It is one table. A row is a case: its name, what goes wrong there, and a motion with a naive
//! method, which everyone writes first. The methods of its family solve it in several
//! representations of an attitude. A cell holds if its error is at most K eps times the condition
//! of the case, with one K for a method on all cases. Or it refuses, by a named error. Nothing
//! else is let through, and a test demands that every naive method is broken:
//!
//! ```text
//! "pitch of pi/2", "gimbal lock: yaw and roll are one turn": locked()?.against(by, YAW);
//! ```
//!
//! The tables are in `rotations`, `torques`, `findings` and `events`; `naive` has the methods that
//! break, `motions` those that hold, `models::truth` the series against which all are judged.

#[path = "hard_cases/events.rs"]
mod events;
#[path = "hard_cases/figures.rs"]
pub mod figures;
#[path = "hard_cases/findings.rs"]
pub mod findings;
#[path = "hard_cases/motions.rs"]
mod motions;
#[path = "hard_cases/naive.rs"]
mod naive;
#[path = "hard_cases/report.rs"]
pub mod report;
#[path = "hard_cases/rotations.rs"]
pub mod rotations;
#[path = "hard_cases/torques.rs"]
mod torques;

// What the modules share.
use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};
use kit::prelude::*;
use kit::{Prepared, short};
use motions::{By, CLOSED, FREE, How, SOLVE, TOP};
use motions::{MATRIX, Motion, NAMES, QUATERNION, in_each_form, turned};
use naive::Plain;
use rotation_dynamics::accuracy::{Problem, Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::{
    BoxedEffect, EffectList, GravityAtLever, Torque, ViscousFriction,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Method};
use rotation_dynamics::math::{DoubleDouble, EPS, expm1};
use rotation_dynamics::motion::Motion as Exact;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result as Solved};
use std::sync::Arc;

/// A row: the case, what goes wrong there, and what comes of it by the methods of its family.
pub struct Case(pub &'static str, pub &'static str, fn(&[By]) -> Result<Answered>);

/// The naive method, which everyone writes first, and its error.
pub type Naive = (&'static str, f64);

/// What comes of a case.
pub struct Answered {
    /// The change of the answer per relative change of what it is computed from.
    condition: f64,
    naive: Naive,
    /// Method by method, each in all forms.
    pub cells: Vec<Cell>,
}

/// What comes of a case by a method in a form: an error (rad, unless the family says otherwise) or
/// a refusal by name; and the bound that an error is held to.
pub struct Cell {
    pub method: &'static str,
    pub answer: Solved<f64>,
    pub bound: f64,
}

/// Cases that are hard for the same reason.
pub struct Family {
    /// Its word on the command line.
    pub key: &'static str,
    pub title: &'static str,
    pub methods: &'static [By],
    pub forms: &'static [&'static str],
    pub cases: &'static [Case],
}

/// A family as a table in the source: the name of a case, what goes wrong, and its answers, which
/// the methods of the family give or methods of its own.
macro_rules! family {
    ($name:ident, $key:literal: $title:literal, |$by:pat_param| $methods:expr, in $forms:expr;
     $( $case:literal, $wrong:literal: $answers:expr; )+) => {
        pub const $name: Family = Family {
            key: $key,
            title: $title,
            methods: &$methods,
            forms: &$forms,
            cases: &[ $( Case($case, $wrong, |$by| $answers) ),+ ],
        };
    };
}
use family;

/// The families, in the order of the page.
pub const FAMILIES: &[Family] = &[
    rotations::POLES,
    rotations::THRESHOLD,
    rotations::SEPARATRIX,
    rotations::FLIPS,
    rotations::SHAPES,
    rotations::TOPS,
    rotations::TURNS,
    rotations::SCALES,
    rotations::LONG,
    torques::TORQUES,
    findings::FINDINGS,
    events::EVENTS,
    events::IMPACTS,
    torques::STABILITY,
];

impl Cell {
    /// Lets through what holds and what refuses.
    ///
    /// # Errors
    /// [`kit::Error::Contradicted`] for an error that is not within its bound.
    pub fn judge(&self, case: &str) -> Result<()> {
        match self.answer {
            Err(_) => Ok(()),
            Ok(measured) if measured <= self.bound => Ok(()),
            Ok(value) => Err(kit::Error::Contradicted {
                key: format!("{case}, {}", self.method),
                value,
                oracle: "the truth".into(),
                oracle_value: 0.0,
                bound: self.bound,
            }),
        }
    }

    /// The error in units of its bound; 0 within a bound of 0. None if it is refused.
    pub fn part(&self) -> Option<f64> {
        let measured = *self.answer.as_ref().ok()?;
        Some(if measured == 0.0 { 0.0 } else { measured / self.bound })
    }
}

impl Answered {
    /// The naive error in units of the smallest bound to which a careful method is held (where all
    /// refuse, would be); infinite if there is no number at all.
    pub fn broken(&self) -> f64 {
        let all_refuse = self.cells.iter().all(|cell| cell.answer.is_err());
        let counted = self.cells.iter().filter(|cell| all_refuse || cell.answer.is_ok());
        let part = self.naive.1 / counted.map(|cell| cell.bound).fold(f64::NAN, f64::min);
        if part.is_nan() { f64::INFINITY } else { part }
    }
}

/// A family with its rows computed.
pub struct Computed {
    pub family: &'static Family,
    pub rows: Vec<(&'static Case, Answered)>,
}

impl Computed {
    fn new(family: &'static Family) -> Result<Self> {
        let mut rows = Vec::new();
        for case in family.cases {
            let answered = case.2(family.methods)?;
            answered.cells.iter().try_for_each(|cell| cell.judge(case.0))?;
            rows.push((case, answered));
        }
        Ok(Self { family, rows })
    }

    pub fn cells(&self) -> impl Iterator<Item = &Cell> {
        self.rows.iter().flat_map(|(_, answered)| &answered.cells)
    }

    /// How many rows, cells, cells that hold, and cells that refuse there are.
    pub fn count(&self) -> [usize; 4] {
        let [cells, holds] = [self.cells().count(), self.cells().filter_map(Cell::part).count()];
        [self.rows.len(), cells, holds, cells - holds]
    }
}

kit::parameters! {
    /// Which family is computed.
    pub struct Parameters {
        /// family of cases
        family: choice("all", "poles", "threshold", "separatrix", "flips", "shapes", "tops", "turns", "scales", "long", "torques", "findings", "events", "impacts", "stability");
        /// step of RK4 in the moving picture
        step: number(0.1, "s", from_to(0.02, 0.5).usually(0.02, 0.5)).open("step of RK4", "short", "long");
        /// error asked for in the accuracy strip; three of them if none is given
        tolerance: optional("rad", from_to(1e-14, 1.0));
    }
}

/// The families asked for, each computed once and kept.
pub fn computed(p: &Parameters) -> Result<Vec<Arc<Computed>>> {
    static KEPT: [Prepared<(), Computed>; FAMILIES.len()] =
        [const { Prepared::new() }; FAMILIES.len()];
    let mut all = Vec::new();
    for (family, kept) in FAMILIES.iter().zip(&KEPT) {
        if p.family == "all" || p.family == family.key {
            all.push(kept.get(&(), |()| Computed::new(family))?);
        }
    }
    Ok(all)
}

kit::example! {
    hard_cases: "Hard cases: a family at a time, the naive method that breaks beside those that hold";
    report::report, figures::figures, report::trajectory, figures::book
}
