//! Effects that say the same of themselves as others but for one thing, and how they are told.

use core::fmt::Debug;
use rotation_dynamics::Result;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{Feature, IntegrableCase, Part, Properties, Resistance};
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

// Their numbers.
pub const TORQUE_FREE: usize = 0;
pub const AXIS_ONLY: usize = 1;
pub const NOT_ON_RATES: usize = 2;
pub const NOT_ON_TIME: usize = 3;
pub const KEEPS_ENERGY: usize = 4;
pub const KEEPS_AXIAL: usize = 8;
pub const OTHER_POTENTIAL: usize = 9;
pub const OTHER_POWER: usize = 10;
pub const SMALL_SCALE: usize = 11;
pub const LARGE_SCALE: usize = 12;
pub const NO_BREAKS: usize = 13;
pub const CLOSED_FORM: usize = 14;
pub const NO_SLIP: usize = 15;

/// The properties of the twin that tells this lie.
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

/// An effect that says the same of itself but for the claim of this number in [`LIES`]. It says
/// nothing of what resists, and asks nothing of the start.
pub struct Twin<'e>(pub &'e (dyn AnyEffect + Sync), pub usize);

impl AnyEffect for Twin<'_> {
    fn properties(&self) -> Properties {
        damaged(self.0.properties(), self.1)
    }

    fn names(&self) -> Vec<&'static str> {
        self.0.names()
    }

    fn parts(&self) -> Vec<Part<'_>> {
        vec![Part { effect: self, law: None }]
    }

    fn about_axis(&self) -> Vec<&'static str> {
        if self.properties().conserved.axial_momentum { Vec::new() } else { self.names() }
    }

    fn holds_from(&self, _: f64, _: &RigidBody, _: &State, _: &[&'static str]) -> Result<()> {
        Ok(())
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn torque_on_axis(&self, body: &RigidBody, axis: [f64; 3]) -> [f64; 3] {
        self.0.torque_on_axis(body, axis)
    }

    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_size(t, body, state)
    }

    fn resistance(&self, _t: f64, _body: &RigidBody) -> Option<Resistance> {
        let Properties { axis_only, smooth, .. } = self.properties();
        (axis_only && smooth).then_some(Resistance::NONE)
    }

    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.slip(t, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let sign = if self.1 == OTHER_POTENTIAL { -1.0 } else { 1.0 };
        sign * self.0.potential_energy(t, body, state)
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let part = match self.1 {
            KEEPS_ENERGY => 0.0,
            OTHER_POWER => -1.0,
            _ => 1.0,
        };
        part * self.0.power(t, body, state)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let factor = match self.1 {
            SMALL_SCALE => 1e-5,
            LARGE_SCALE => 1e8,
            _ => 1.0,
        };
        factor * self.0.torque_scale(t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        if self.1 == NO_BREAKS { Vec::new() } else { self.0.break_points() }
    }

    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }

    fn integrable_case(&self) -> IntegrableCase {
        if self.1 == CLOSED_FORM { IntegrableCase::Free } else { self.0.integrable_case() }
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
