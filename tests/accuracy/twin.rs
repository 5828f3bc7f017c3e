//! Effects that say the same of themselves as others but for one thing, and how they are told.

use core::fmt::Debug;
use rotation_dynamics::Result;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Feature, IntegrableCase, Properties};
use rotation_dynamics::frame::SpaceVector;

/// What a twin says that may be false. One claim is left out: that a torque is an analytic
/// function where it has no jump cannot be seen by looking at it.
pub const LIES: [&str; 16] = [
    "that there is no torque",
    "sees the axis only",
    "does not depend on the rates",
    "does not depend on the time",
    "keeps the energy",
    "no torque about X",
    "no torque about Y",
    "no torque about Z",
    "no torque about the body's axis",
    "the potential with the other sign",
    "the power with the other sign",
    "a scale a hundred thousand times too small",
    "a scale a hundred million times too large",
    "no break points",
    "a closed form: the free body's",
    "that the axes follow L alone",
];

// Those that tests of one effect name.
pub const TORQUE_FREE: usize = 0;
pub const AXIS_ONLY: usize = 1;
pub const NOT_ON_RATES: usize = 2;
pub const NOT_ON_TIME: usize = 3;
pub const KEEPS_ENERGY: usize = 4;
pub const KEEPS_AXIAL: usize = 8;
pub const OTHER_POTENTIAL: usize = 9;
pub const OTHER_POWER: usize = 10;
pub const NO_SLIP: usize = 15;

/// The nature of the twin that tells this lie.
pub const fn damaged(mut properties: Properties, lie: usize) -> Properties {
    match lie {
        TORQUE_FREE => properties.torque_free = true,
        AXIS_ONLY => properties.axis_only = true,
        NOT_ON_RATES => properties.on_rates = false,
        NOT_ON_TIME => properties.on_time = false,
        KEEPS_ENERGY => properties.conserved.energy = true,
        5..=7 => properties.conserved.momentum[lie - 5] = true,
        KEEPS_AXIAL => properties.conserved.axial_momentum = true,
        NO_SLIP => properties.slips = false,
        _ => {}
    }
    properties
}

/// An effect that says the same of itself but for one thing.
pub struct Twin<'e, E, const LIE: usize>(pub &'e E);

impl<E: Effect, const LIE: usize> Effect for Twin<'_, E, LIE> {
    const PROPERTIES: Properties = damaged(E::PROPERTIES, LIE);

    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.slip(t, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let sign = if LIE == OTHER_POTENTIAL { -1.0 } else { 1.0 };
        sign * self.0.potential_energy(t, body, state)
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        match LIE {
            KEEPS_ENERGY => 0.0,
            OTHER_POWER => -self.0.power(t, body, state),
            _ => self.0.power(t, body, state),
        }
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let factor = match LIE {
            11 => 1e-5,
            12 => 1e8,
            _ => 1.0,
        };
        factor * self.0.torque_scale(t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        if LIE == 13 { Vec::new() } else { self.0.break_points() }
    }

    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }

    fn integrable_case(&self) -> IntegrableCase {
        if LIE == 14 { IntegrableCase::Free } else { self.0.integrable_case() }
    }
}

/// Every one of these is refused, in words that contain those beside it.
pub fn refused<T: Debug, const N: usize>(damaged: [(Result<T>, &str); N]) {
    const { assert!(N > 0) };
    for (checked, words) in damaged {
        let told = checked.expect_err(words).to_string();
        assert!(told.contains(words), "{told}");
    }
}
