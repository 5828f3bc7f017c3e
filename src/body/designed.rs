//! A body on the axes of its drawing.
//!
//! Closed forms, integrators and effects work on the principal axes of a body, where its
//! tensor is diagonal. A body that is made of parts has its principal axes askew to those
//! on which its parts are given; here they are found, kept, and undone on output.

use super::{RigidBody, State};
use crate::attitude::Attitude;
use crate::error::Result;
use crate::frame::{BodyVector, DesignVector, SpaceVector};
use crate::inertia::{InertiaTensor, PrincipalMoments};

/// A rigid body that is described on axes of the user's choice, the axes of its drawing.
///
/// A start is given on the axes of the drawing, and a state is read on them: both are a
/// [`DesignState`]. Scenes, closed forms and integrators take [`DesignedBody::rigid_body`] and the
/// [`DesignState::principal`] state of the start; their results come back by
/// [`DesignedBody::from_principal`]. Vectors and states on the two sets of axes are different
/// types.
///
/// The principal axes are chosen among six permutations and their signs: the choice nearest to the
/// axes of the drawing, right-handed. A diagonal tensor that is given keeps its axes, their order
/// and its moments to the bit. Of any other, moments that agree within
/// [`InertiaTensor::known_within`] differ by rounding alone; they are made equal, and of all axes
/// in their plane those nearest to the drawing's are taken.
///
/// An angle of two cuboids, thrown so that it turns about its long leg:
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::DesignedBody;
/// use rotation_dynamics::exact::free_body::FreeBody;
/// use rotation_dynamics::frame::DesignVector;
/// use rotation_dynamics::inertia::{MassProperties, solids};
/// # fn main() -> rotation_dynamics::Result<()> {
/// // Legs of 0.3 m along x and 0.2 m along y, 20 mm thick; the corner is the origin.
/// let long = solids::cuboid(0.6, 0.30, 0.02, 0.02)?.displaced([0.15, 0.01, 0.01].into())?;
/// let short = solids::cuboid(0.36, 0.02, 0.18, 0.02)?.displaced([0.01, 0.11, 0.01].into())?;
/// let angle = MassProperties::of_parts(&[long, short])?;
/// let body = DesignedBody::new(&angle.about_centre_of_mass())?;
///
/// // Its axes lie along the fixed axes, and it turns about x, almost twice a second.
/// let start = body.state(Attitude::IDENTITY, DesignVector::new(12.0, 0.0, 0.0))?;
/// assert_eq!(format!("{:.3}", start.attitude()), "(1.000, 0.000, 0.000, 0.000)");
/// // The principal axes are turned by 24 degrees about the edge of the corner.
/// let principal = start.principal();
/// assert_eq!(format!("{:.3}", principal.attitude), "(0.978, 0.000, 0.000, -0.208)");
///
/// // A leg is not a principal axis: half a second later it turns about another line.
/// let rigid = body.rigid_body();
/// let rates = rigid.angular_velocity(&principal);
/// let motion = FreeBody::new(rigid.moments(), principal.attitude, rates)?;
/// let later = rigid.state(motion.attitude(0.5), motion.angular_velocity(0.5))?;
/// let later = body.from_principal(later);
/// let rates = later.angular_velocity();
/// assert_eq!(format!("{rates:.3} rad/s"), "(11.057, -4.591, 4.078) rad/s");
/// let long_leg = later.to_space(DesignVector::new(1.0, 0.0, 0.0));
/// assert_eq!(format!("{long_leg:.3}"), "(-0.330, 0.918, -0.221)");
/// let yaw = later.attitude().yaw_pitch_roll().yaw;
/// assert_eq!(format!("{yaw:.3} rad"), "1.916 rad");
/// # Ok(())
/// # }
/// ```
///
/// Source: notes 15.3, 15.4.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignedBody {
    tensor: InertiaTensor,
    moments: PrincipalMoments,
    /// Principal axes -> axes of the drawing.
    principal: Attitude,
}

impl DesignedBody {
    /// The body with this tensor of inertia, about its centre of mass or a fixed point.
    ///
    /// From parts: [`crate::inertia::MassProperties`], `about_centre_of_mass` or `about` a point. A
    /// lever on the principal axes, such as the lever of a weight, is
    /// [`DesignedBody::to_principal`] of the vector on the drawing.
    ///
    /// Errors: [`Error::NotABody`](crate::Error::NotABody) for a rod or a point mass, whose
    /// smallest moment is zero or not above [`InertiaTensor::known_within`].
    /// Tensors of no body are refused by [`InertiaTensor::new`].
    /// Accuracy: moments of a tensor that is given within 15.9 eps of the largest (2.7 where
    /// none are made equal), and R diag(I) R^T within 12.1 eps of the tensor; measured in
    /// `tests/bodies/inertia`.
    pub fn new(tensor: &InertiaTensor) -> Result<Self> {
        let (moments, principal) = principal_frame(tensor)?;
        Ok(Self {
            tensor: *tensor,
            moments: PrincipalMoments::known_within(moments, tensor.known_within())?,
            principal,
        })
    }

    /// The tensor, on the axes of the drawing.
    pub const fn tensor(&self) -> InertiaTensor {
        self.tensor
    }

    /// The body on its principal axes: for scenes, closed forms and integrators.
    pub const fn rigid_body(&self) -> RigidBody {
        RigidBody::new(self.moments)
    }

    /// The principal axes as unit vectors on the axes of the drawing, in the order of the
    /// moments of [`DesignedBody::rigid_body`]; right-handed.
    pub fn principal_axes(&self) -> [DesignVector; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| self.to_design(e.into()))
    }

    /// The same vector on the axes of the drawing.
    ///
    /// Accuracy: 6.0 eps of its length, as [`Attitude::to_space`].
    pub fn to_design(&self, v: BodyVector) -> DesignVector {
        // The drawing takes the place of space.
        self.principal.to_space(v).to_array().into()
    }

    /// The same vector on the principal axes.
    ///
    /// Accuracy: 6.0 eps of its length, as [`Attitude::to_space`].
    pub fn to_principal(&self, v: DesignVector) -> BodyVector {
        self.principal.to_body(v.to_array().into())
    }

    /// The state with this attitude of the axes of the drawing (drawing -> space) and this
    /// angular velocity on them (rad/s): L = R I omega with the tensor as it was given.
    ///
    /// Errors: as [`RigidBody::state`].
    pub fn state(&self, attitude: Attitude, angular_velocity: DesignVector) -> Result<DesignState> {
        let rates = self.to_principal(angular_velocity);
        let state = self.rigid_body().state(attitude * self.principal, rates)?;
        Ok(self.from_principal(state))
    }

    /// A state of the principal axes, to be read on the axes of the drawing.
    pub const fn from_principal(&self, state: State) -> DesignState {
        DesignState { body: *self, principal: state }
    }
}

/// The state of a [`DesignedBody`], read on the axes of its drawing.
///
/// Nothing but a [`State`] is a start of a scene, so the principal axes are asked for by name:
///
/// ```compile_fail,E0308
/// # use rotation_dynamics::{attitude::Attitude, body::DesignedBody, frame::DesignVector};
/// # use rotation_dynamics::{inertia::InertiaTensor, scene::Scene};
/// # let body = DesignedBody::new(&InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
/// let start = body.state(Attitude::IDENTITY, DesignVector::new(0.0, 0.0, 3.0))?;
/// Scene::new(body.rigid_body()).solve(&start, 1.0, 1e-9)?; // it wants &start.principal()
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesignState {
    body: DesignedBody,
    principal: State,
}

impl DesignState {
    /// The state of the principal axes, for scenes, closed forms and integrators.
    pub const fn principal(&self) -> State {
        self.principal
    }

    /// The attitude of the axes of the drawing, drawing -> space.
    pub fn attitude(&self) -> Attitude {
        self.principal.attitude * self.body.principal.inverse()
    }

    /// Angular velocity on the axes of the drawing (rad/s).
    ///
    /// Accuracy: of what went into [`DesignedBody::state`], 8.0 eps times the largest over
    /// the smallest moment, measured in `tests/bodies/inertia`.
    pub fn angular_velocity(&self) -> DesignVector {
        let rigid = self.body.rigid_body();
        self.body.to_design(rigid.angular_velocity(&self.principal))
    }

    /// Angular momentum on the axes of the drawing (kg m^2/s).
    ///
    /// Accuracy: of I omega, 15.5 eps of the largest moment times |omega|.
    pub fn angular_momentum(&self) -> DesignVector {
        let rigid = self.body.rigid_body();
        self.body.to_design(rigid.angular_momentum(&self.principal))
    }

    /// Components on the fixed axes of a vector on the axes of the drawing: where a point
    /// of it is, seen from the reference point.
    pub fn to_space(&self, v: DesignVector) -> SpaceVector {
        self.principal.attitude.to_space(self.body.to_principal(v))
    }

    /// Components on the axes of the drawing of a vector on the fixed axes.
    pub fn from_space(&self, v: SpaceVector) -> DesignVector {
        self.body.to_design(self.principal.attitude.to_body(v))
    }
}

/// The moments, and the rotation principal axes -> axes of the tensor.
fn principal_frame(tensor: &InertiaTensor) -> Result<([f64; 3], Attitude)> {
    let found = tensor.principal_axes();
    let [low, middle, high] = found.moments();
    // Of a rod and a point mass the moments that rounding hides are 0 already.
    let slack = if low > 0.0 { tensor.known_within() } else { 0.0 };
    let axes = found.axes().map(DesignVector::to_array);
    if high - low <= slack {
        Ok(([middle; 3], Attitude::IDENTITY))
    } else if middle - low <= slack {
        symmetric_about(axes[2], high, 0.5 * low + 0.5 * middle)
    } else if high - middle <= slack {
        symmetric_about(axes[0], low, 0.5 * middle + 0.5 * high)
    } else {
        nearest(axes, found.moments())
    }
}

/// The shortest turn that brings the axis of the drawing nearest to `axis` onto it.
fn symmetric_about(axis: [f64; 3], along: f64, across: f64) -> Result<([f64; 3], Attitude)> {
    let mut k = 0;
    for i in 1..3 {
        if axis[i].abs() > axis[k].abs() {
            k = i;
        }
    }
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let axis = axis.map(|c| c * 1.0_f64.copysign(axis[k]));
    let mut quaternion = [1.0 + axis[k], 0.0, 0.0, 0.0];
    quaternion[1 + i] = -axis[j];
    quaternion[1 + j] = axis[i];
    let mut moments = [across; 3];
    moments[k] = along;
    Ok((moments, Attitude::from_quaternion(quaternion)?))
}

/// The right-handed order and signs of the axes with the largest trace: the smallest turn.
fn nearest(axes: [[f64; 3]; 3], moments: [f64; 3]) -> Result<([f64; 3], Attitude)> {
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];
    let mut best = (f64::NEG_INFINITY, [0, 1, 2], [1.0; 3]);
    for (n, order) in orders.into_iter().enumerate() {
        let parity = if n < 3 { 1.0 } else { -1.0 };
        for signs in 0..4 {
            let [a, b] = [1, 2].map(|bit| if signs & bit == 0 { 1.0 } else { -1.0 });
            let signs = [a, b, parity * a * b];
            let trace = (0..3).map(|s| signs[s] * axes[order[s]][s]).sum();
            if trace > best.0 {
                best = (trace, order, signs);
            }
        }
    }
    let (_, order, signs) = best;
    let matrix = [0, 1, 2].map(|row| [0, 1, 2].map(|s| signs[s] * axes[order[s]][row]));
    Ok((order.map(|i| moments[i]), Attitude::from_matrix(matrix)?))
}
