//! Bodies, states and angles as text, with their units. A format such as `{:.3}` or `{:+e}`
//! holds for every number.

use crate::attitude::{EulerAngles, YawPitchRoll};
use crate::body::{DesignState, Kinematics, RigidBody, State};
use crate::frame::written;
use crate::inertia::{InertiaTensor, MassProperties, PrincipalMoments};
use crate::motion::Kept;
use core::fmt::{Display, Formatter, Result};

/// Angles (rad) with their names.
fn angles(named: [(&str, f64); 3], f: &mut Formatter<'_>) -> Result {
    for (i, (name, angle)) in named.into_iter().enumerate() {
        write!(f, "{}{name} = ", if i == 0 { "" } else { ", " })?;
        angle.fmt(f)?;
    }
    f.write_str(" rad")
}

/// `phi = 0.3, theta = 0.7, zeta = -0.4 rad`
impl Display for EulerAngles {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self { phi, theta, zeta } = *self;
        angles([("phi", phi), ("theta", theta), ("zeta", zeta)], f)
    }
}

/// `yaw = 0.3, pitch = 0.7, roll = -0.4 rad`
impl Display for YawPitchRoll {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self { yaw, pitch, roll } = *self;
        angles([("yaw", yaw), ("pitch", pitch), ("roll", roll)], f)
    }
}

/// `(1, 2, 2.5) kg m^2`
impl Display for PrincipalMoments {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        written(self.to_array(), f, Display::fmt)?;
        f.write_str(" kg m^2")
    }
}

/// The three rows: `((1, 0, 0), (0, 2, 0), (0, 0, 2.5)) kg m^2`
impl Display for InertiaTensor {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (i, row) in self.matrix().into_iter().enumerate() {
            f.write_str(if i == 0 { "(" } else { ", " })?;
            written(row, f, Display::fmt)?;
        }
        f.write_str(") kg m^2")
    }
}

/// `3 kg at (0, 0, 1) m, tensor ((1, 0, 0), (0, 1, 0), (0, 0, 0)) kg m^2`
impl Display for MassProperties {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        self.mass().fmt(f)?;
        f.write_str(" kg at ")?;
        self.centre_of_mass().fmt(f)?;
        f.write_str(" m, tensor ")?;
        self.about_centre_of_mass().fmt(f)
    }
}

/// `moments (1, 2, 2.5) kg m^2`
impl Display for RigidBody {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("moments ")?;
        self.moments().fmt(f)
    }
}

/// `attitude (1, 0, 0, 0), angular momentum (0, 0, 5) kg m^2/s`
impl Display for State {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("attitude ")?;
        self.attitude.fmt(f)?;
        f.write_str(", angular momentum ")?;
        self.angular_momentum.fmt(f)?;
        f.write_str(" kg m^2/s")
    }
}

/// `attitude of the drawing (1, 0, 0, 0), angular momentum (0, 0, 5) kg m^2/s`
impl Display for DesignState {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("attitude of the drawing ")?;
        self.attitude().fmt(f)?;
        f.write_str(", angular momentum ")?;
        self.principal().angular_momentum.fmt(f)?;
        f.write_str(" kg m^2/s")
    }
}

/// `attitude (1, 0, 0, 0), angular velocity (0, 0, 2) rad/s`
impl Display for Kinematics {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str("attitude ")?;
        self.attitude.fmt(f)?;
        f.write_str(", angular velocity ")?;
        self.angular_velocity.fmt(f)?;
        f.write_str(" rad/s")
    }
}

/// `energy = 2.5 J`
impl Display for Kept {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{} = ", self.name)?;
        self.value.fmt(f)?;
        match self.unit {
            "" => Ok(()),
            unit => write!(f, " {unit}"),
        }
    }
}
