//! Hard cases: where the arithmetic that everyone writes first breaks, and the form that holds.

#[path = "hard_cases/contacts.rs"]
mod contacts;
#[path = "hard_cases/events.rs"]
mod events;
#[path = "hard_cases/figures.rs"]
mod figures;
#[path = "hard_cases/findings.rs"]
pub mod findings;
#[path = "hard_cases/impacts.rs"]
mod impacts;
#[path = "hard_cases/ladder.rs"]
mod ladder;
#[path = "hard_cases/motions.rs"]
mod motions;
#[path = "hard_cases/naive.rs"]
mod naive;
#[path = "hard_cases/pictures.rs"]
mod pictures;
#[path = "hard_cases/rotations.rs"]
pub mod rotations;
#[path = "hard_cases/sections.rs"]
mod sections;
#[path = "hard_cases/stability.rs"]
mod stability;
#[path = "hard_cases/stepped.rs"]
mod stepped;
#[path = "hard_cases/table.rs"]
pub mod table;
#[path = "hard_cases/torques.rs"]
mod torques;
#[path = "hard_cases/truth.rs"]
mod truth;

// What the modules share.
use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};
use kit::draw::Camera;
use kit::prelude::*;
use kit::{Prepared, short};
use motions::{By, FORMS, MATRIX, Motion, NAMES, QUATERNION, in_each_form, turned};
use rotation_dynamics::accuracy::{Limits, Problem, Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Torque, ViscousFriction};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Method};
use rotation_dynamics::math::{DoubleDouble, EPS, expm1};
use rotation_dynamics::motion::Motion as _;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result as Solved};
use std::sync::Arc;
use table::{Answered, Case, Computed, Family, Naive, family};

kit::parameters! {
    /// Which family is computed.
    pub struct Parameters {
        /// family of cases
        family: choice("all", "poles", "threshold", "separatrix", "flips", "shapes", "tops", "turns", "scales", "long", "torques", "findings", "events", "impacts", "stability");
        /// error asked for in the accuracy strip; three of them if none is given
        tolerance: optional("rad", from_to(1e-14, 1.0));
    }
}

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
    torques::FAMILY,
    findings::FAMILY,
    events::FAMILY,
    impacts::FAMILY,
    stability::FAMILY,
];

/// The families asked for, each computed once and kept.
pub fn computed(p: &Parameters) -> Result<Vec<Arc<Computed>>> {
    static KEPT: [Prepared<(), Computed>; FAMILIES.len()] =
        [const { Prepared::new() }; FAMILIES.len()];
    FAMILIES
        .iter()
        .zip(&KEPT)
        .filter(|(family, _)| p.family == "all" || p.family == family.key)
        .map(|(family, kept)| kept.get(&(), |()| Computed::new(family)))
        .collect()
}

fn report(p: &Parameters) -> Result<Report> {
    let computed = computed(p)?;
    let mut report = Report::new(
        "Hard cases",
        "cases times methods times attitude representations: an error within its bound, or a refusal by name",
    )?;
    sections::add(&mut report, p, &computed)?;
    for family in computed.iter() {
        report.add(family.tables()?)?;
    }
    Ok(report)
}

fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    Ok([figures::figures(p)?, pictures::stills(p)?].concat())
}

kit::example! {
    hard_cases: "Hard cases: a family at a time, the naive method that breaks beside those that hold";
    report, figures, sections::trajectory, pictures::moving_picture
}
