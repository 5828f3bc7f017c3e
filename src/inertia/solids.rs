//! Uniform solids: mass and moments from dimensions (notes 15.3).
//!
//! Every solid has its centre of mass at the origin and its symmetry axis along
//! e3. Masses in kg, lengths in m; every one must be positive and finite. The
//! moments are closed forms of at most five roundings, within 8.2 eps of sums over
//! slices (`tests/bodies/inertia`; most of that is the sums').

use super::{InertiaTensor, MassProperties};
use crate::error::{Error, Result, positive};
use crate::frame::DesignVector;

/// A solid of this mass with moments `mass * factor` about its centre.
fn solid(mass: f64, factors: [f64; 3]) -> Result<MassProperties> {
    positive("mass", mass)?;
    let tensor = InertiaTensor::diagonal(factors.map(|f| mass * f))?;
    MassProperties::new(mass, DesignVector::zero(), tensor)
}

/// A thin rod along e3: (1, 1, 0) m l^2/12.
pub fn rod(mass: f64, length: f64) -> Result<MassProperties> {
    let l = positive("length", length)?;
    let across = l * l / 12.0;
    solid(mass, [across, across, 0.0])
}

/// A thin ring (hoop) about e3: (1/2, 1/2, 1) m r^2.
pub fn hoop(mass: f64, radius: f64) -> Result<MassProperties> {
    let r = positive("radius", radius)?;
    let across = r * r / 2.0;
    solid(mass, [across, across, 2.0 * across])
}

/// A thin disc about e3: (1/4, 1/4, 1/2) m r^2.
pub fn disc(mass: f64, radius: f64) -> Result<MassProperties> {
    let r = positive("radius", radius)?;
    let across = r * r / 4.0;
    solid(mass, [across, across, 2.0 * across])
}

/// A solid cylinder of this radius and length along e3:
/// I1 = I2 = m (r^2/4 + l^2/12), I3 = m r^2/2.
pub fn cylinder(mass: f64, radius: f64, length: f64) -> Result<MassProperties> {
    hollow_cylinder_of(mass, 0.0, positive("radius", radius)?, length)
}

/// A cylinder with a coaxial bore: I1 = I2 = m ((r^2 + R^2)/4 + l^2/12),
/// I3 = m (r^2 + R^2)/2. With r close to R a thin tube.
///
/// Errors: also if the inner radius is not below the outer.
pub fn hollow_cylinder(
    mass: f64,
    inner_radius: f64,
    outer_radius: f64,
    length: f64,
) -> Result<MassProperties> {
    positive("inner radius", inner_radius)?;
    positive("outer radius", outer_radius)?;
    if inner_radius >= outer_radius {
        return Err(Error::out_of_range(
            "inner radius",
            inner_radius,
            "it must be less than the outer radius",
        ));
    }
    hollow_cylinder_of(mass, inner_radius, outer_radius, length)
}

fn hollow_cylinder_of(mass: f64, inner: f64, outer: f64, length: f64) -> Result<MassProperties> {
    let l = positive("length", length)?;
    let round = (inner * inner + outer * outer) / 4.0;
    let across = round + l * l / 12.0;
    solid(mass, [across, across, 2.0 * round])
}

/// A solid sphere: 2/5 m r^2.
pub fn sphere(mass: f64, radius: f64) -> Result<MassProperties> {
    let r = positive("radius", radius)?;
    solid(mass, [0.4 * r * r; 3])
}

/// A thin spherical shell: 2/3 m r^2.
pub fn spherical_shell(mass: f64, radius: f64) -> Result<MassProperties> {
    let r = positive("radius", radius)?;
    solid(mass, [2.0 * r * r / 3.0; 3])
}

/// A solid ellipsoid with semi-axes a, b, c along e1, e2, e3: I1 = m (b^2 + c^2)/5 and so on.
pub fn ellipsoid(mass: f64, a: f64, b: f64, c: f64) -> Result<MassProperties> {
    let [a, b, c] =
        [positive("semi-axis a", a)?, positive("semi-axis b", b)?, positive("semi-axis c", c)?]
            .map(|axis| 0.2 * axis * axis);
    solid(mass, [b + c, a + c, a + b])
}

/// A solid torus about e3, from the axis to the middle of the tube R, radius of the tube r:
/// I1 = I2 = m (R^2/2 + 5 r^2/8), I3 = m (R^2 + 3 r^2/4).
///
/// Errors: also if the tube is thicker than it is far from the axis.
pub fn torus(mass: f64, radius: f64, tube: f64) -> Result<MassProperties> {
    let ring = positive("radius", radius)?;
    let r = positive("radius of the tube", tube)?;
    if r > ring {
        return Err(Error::out_of_range(
            "radius of the tube",
            r,
            "it must not exceed the radius of the ring",
        ));
    }
    let across = ring * ring / 2.0 + 5.0 * r * r / 8.0;
    solid(mass, [across, across, ring * ring + 3.0 * r * r / 4.0])
}

/// A box with edges a, b, c along e1, e2, e3: I1 = m (b^2 + c^2)/12 and so on.
pub fn cuboid(mass: f64, a: f64, b: f64, c: f64) -> Result<MassProperties> {
    let [a, b, c] = [positive("edge a", a)?, positive("edge b", b)?, positive("edge c", c)?]
        .map(|edge| edge * edge / 12.0);
    solid(mass, [b + c, a + c, a + b])
}

/// A thin rectangular plate with edges a, b along e1, e2:
/// (b^2, a^2, a^2 + b^2) m/12.
pub fn plate(mass: f64, a: f64, b: f64) -> Result<MassProperties> {
    let [a, b] = [positive("edge a", a)?, positive("edge b", b)?].map(|edge| edge * edge / 12.0);
    solid(mass, [b, a, a + b])
}

/// A solid right circular cone about e3, base radius r, height h: I1 = I2 = 3/80 m (4 r^2 + h^2),
/// I3 = 3/10 m r^2. They are about its centre of mass, which lies 3h/4 from the vertex and h/4 from
/// the base.
pub fn cone(mass: f64, radius: f64, height: f64) -> Result<MassProperties> {
    let r = positive("radius", radius)?;
    let h = positive("height", height)?;
    let across = 3.0 * (4.0 * r * r + h * h) / 80.0;
    solid(mass, [across, across, 3.0 * r * r / 10.0])
}
