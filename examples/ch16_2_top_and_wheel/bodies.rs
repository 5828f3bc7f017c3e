//! From a body to its motion, and the limits in which the answer is known.

use super::{Body, WHEEL};
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties};
use rotation_dynamics::math::sin;
use rotation_dynamics::report::heavy_top::Motion;
use rotation_dynamics::report::{Claim, Limit, Oracle, Report};
use rotation_dynamics::{Error, Result};

use core::f64::consts::TAU;

impl Body {
    /// This body with some values replaced: mass, length, I1, I3, gravity, tilt, spin,
    /// precession, nutation.
    pub fn with(mut self, given: &[Option<f64>; 9]) -> Self {
        let fields = [
            &mut self.mass,
            &mut self.length,
            &mut self.i1,
            &mut self.i3,
            &mut self.gravity,
            &mut self.theta,
            &mut self.spin,
            &mut self.precession,
            &mut self.nutation,
        ];
        for (field, value) in fields.into_iter().zip(given) {
            *field = value.unwrap_or(*field);
        }
        self
    }

    /// The body as the closed form wants it.
    pub fn symmetric(&self) -> Result<SymmetricTop> {
        if self.mass <= 0.0 {
            return Err(Error::OutOfRange {
                name: "mass",
                value: self.mass,
                allowed: "it must be greater than 0",
            });
        }
        SymmetricTop::from_mass(self.moment(), self.i3, self.mass, self.gravity, self.length)
    }

    /// Its motion.
    pub fn motion(&self, name: &'static str) -> Result<Motion> {
        let start = EulerAngles {
            phi: 0.0,
            theta: self.theta,
            zeta: 0.0,
        };
        let omega = BodyVector::new(self.nutation, self.precession * sin(self.theta), self.spin);
        Motion::new(name, HeavyTop::from_body(self.symmetric()?, start, omega)?)
    }

    /// The slow steady precession when the axis is horizontal, rad/s.
    fn horizontal_rate(&self) -> f64 {
        self.weight_moment() / (self.i3 * self.spin)
    }

    /// I1' as a claim, against the tensor of the displaced body.
    pub fn add_moment(&self, name: &str, report: &mut Report) -> Result<()> {
        let tensor = InertiaTensor::diagonal([self.i1, self.i1, self.i3])?;
        let centre = BodyVector::new(0.0, 0.0, self.length);
        let about_tip = MassProperties::new(self.mass, centre, tensor)?.about(BodyVector::zero())?;
        let across = about_tip.moment_about(BodyVector::new(1.0, 0.0, 0.0))?;
        let claim = Claim::new(
            format!("{name}_moment"),
            format!("{name}: I1', across the axis about the fixed point"),
            self.moment(),
            "kg m^2",
            1e-15 * self.moment(),
            Oracle::new("tensor of the displaced body", across),
        )?;
        report.add_claim(claim.slip(self.i1, "that is about the centre of mass, which moves"))
    }
}

/// Limits in which the answer is known without solving anything.
pub fn add_limits(report: &mut Report) -> Result<()> {
    let mut add = |limit: &str, because: &str, must: f64, gives: f64, within: f64| -> Result<()> {
        report.add_limit(Limit::new(limit, because, must, gives, within)?);
        Ok(())
    };
    let rate = |body: Body| -> Result<f64> {
        let motion = body.motion("")?;
        Ok(motion.exact.precession_per_period() / motion.exact.nutation_period())
    };
    let level = Body {
        precession: WHEEL.horizontal_rate(),
        ..WHEEL
    };
    let heavier = Body {
        i1: 10.0 * WHEEL.i1,
        ..level
    };
    let steady = |body: Body| -> Result<f64> { Ok(body.motion("")?.exact.phi_rate(0.3)) };
    add(
        "wheel level, started at m g l/L_z: its rate in rad/s",
        "at 90 degrees the quadratic loses its first term",
        WHEEL.horizontal_rate(),
        steady(level)?,
        1e-12,
    )?;
    add(
        "the same with ten times the I1: its rate in rad/s",
        "I1 does not enter at 90 degrees",
        WHEEL.horizontal_rate(),
        steady(heavier)?,
        1e-12,
    )?;
    let fast = Body { spin: 1e4, ..WHEEL };
    add(
        "wheel released level at 10000 rad/s: rate over m g l/L_z",
        "the mean torque turns L, and L is the spin",
        1.0,
        rate(fast)? / fast.horizontal_rate(),
        1e-6,
    )?;
    // Hardly any spin: it swings like a pendulum about the lowest point.
    let hanging = Body {
        length: -WHEEL.length,
        theta: 0.01,
        spin: 1e-6,
        ..WHEEL
    };
    let swing = hanging.motion("")?.exact.nutation_period();
    let small = 0.5 * TAU * (hanging.moment() / -hanging.weight_moment()).sqrt();
    add(
        "hanging wheel without spin: time from side to side in s",
        "a pendulum of small swings",
        small,
        swing,
        1e-4,
    )
}
