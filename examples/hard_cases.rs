//! Hard cases: where the arithmetic that everyone writes first breaks, and the form that holds.

#[path = "hard_cases/contacts.rs"]
mod contacts;
#[path = "hard_cases/events.rs"]
mod events;
#[path = "hard_cases/figures.rs"]
mod figures;
#[path = "hard_cases/findings.rs"]
pub mod findings;
#[path = "hard_cases/flips.rs"]
mod flips;
#[path = "hard_cases/forms.rs"]
pub mod forms;
#[path = "hard_cases/impacts.rs"]
mod impacts;
#[path = "hard_cases/ladder.rs"]
mod ladder;
#[path = "hard_cases/long.rs"]
mod long;
#[path = "hard_cases/motions.rs"]
pub mod motions;
#[path = "hard_cases/naive.rs"]
mod naive;
#[path = "hard_cases/pictures.rs"]
mod pictures;
#[path = "hard_cases/poles.rs"]
mod poles;
#[path = "hard_cases/scales.rs"]
mod scales;
#[path = "hard_cases/sections.rs"]
mod sections;
#[path = "hard_cases/separatrix.rs"]
mod separatrix;
#[path = "hard_cases/shapes.rs"]
mod shapes;
#[path = "hard_cases/stability.rs"]
mod stability;
#[path = "hard_cases/stepped.rs"]
mod stepped;
#[path = "hard_cases/table.rs"]
pub mod table;
#[path = "hard_cases/threshold.rs"]
mod threshold;
#[path = "hard_cases/tops.rs"]
mod tops;
#[path = "hard_cases/torques.rs"]
mod torques;
#[path = "hard_cases/truth.rs"]
pub mod truth;
#[path = "hard_cases/turns.rs"]
pub mod turns;

use kit::{Figure, Prepared, Report, Result};
use std::sync::Arc;
use table::{Computed, Family};

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
    poles::FAMILY,
    threshold::FAMILY,
    separatrix::FAMILY,
    flips::FAMILY,
    shapes::FAMILY,
    tops::FAMILY,
    turns::FAMILY,
    scales::FAMILY,
    long::FAMILY,
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
        family.add(&mut report)?;
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
