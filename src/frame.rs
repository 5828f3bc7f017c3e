//! Space-fixed and body-fixed vectors as types.
//!
//! A vector knows the axes its components refer to: [`SpaceVector`] the fixed
//! axes X, Y, Z of the laboratory, [`BodyVector`] axes that turn with the body.
//! Adding one to the other does not compile; [`crate::attitude::Attitude`] is
//! the only way across. A [`DesignVector`] has a third set of axes, those in
//! which a body is described before its principal axes are known;
//! [`crate::body::DesignedBody`] leads from them to the others.

mod conversions;

pub(crate) use conversions::written;

use core::marker::PhantomData;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};
use nalgebra::Vector3;

mod sealed {
    pub trait Sealed {
        /// The name of a vector on these axes.
        const VECTOR: &'static str;
    }
}

/// A set of axes in which components are given.
pub trait Frame: sealed::Sealed + Copy + Clone + core::fmt::Debug + PartialEq + 'static {}

/// The fixed axes X, Y, Z of the laboratory; Z points up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Space;
/// Axes fixed in the body: its principal axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body;
/// Axes fixed in the body, with some origin: the axes of its drawing, on which its parts are given.
/// For a solid or a tensor that is diagonal they are principal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Design;

impl sealed::Sealed for Space {
    const VECTOR: &'static str = "SpaceVector";
}
impl sealed::Sealed for Body {
    const VECTOR: &'static str = "BodyVector";
}
impl sealed::Sealed for Design {
    const VECTOR: &'static str = "DesignVector";
}
impl Frame for Space {}
impl Frame for Body {}
impl Frame for Design {}

/// A vector with components on the axes of frame `F`.
///
/// It converts from and to arrays and nalgebra's columns, is indexed, summed and
/// printed; the unit is for the reader of the print to know, and so for its writer
/// to say.
///
/// ```
/// use rotation_dynamics::frame::SpaceVector;
/// let steps: [SpaceVector; 2] = [[1.0, 0.0, 0.5].into(), [0.25, 2.0, 0.0].into()];
/// let walk: SpaceVector = steps.iter().sum();
/// assert_eq!(walk[0], 1.25);
/// assert_eq!(format!("{walk:.2} m"), "(1.25, 2.00, 0.50) m");
/// assert_eq!(format!("{walk:?}"), "SpaceVector(1.25, 2.0, 0.5)");
/// assert_eq!(<[f64; 3]>::from(walk), [1.25, 2.0, 0.5]);
/// assert_eq!(nalgebra::Vector3::from(walk).y, walk.y());
/// ```
///
/// One frame for another does not compile:
///
/// ```compile_fail,E0308
/// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, inertia::PrincipalMoments};
/// # use rotation_dynamics::frame::DesignVector;
/// # let body = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5)?);
/// let spin = DesignVector::new(0.0, 0.0, 3.0);
/// let start = body.state(Attitude::IDENTITY, spin)?; // it wants a BodyVector
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Vector<F: Frame> {
    components: Vector3<f64>,
    frame: PhantomData<F>,
}

/// A vector given by its components on the fixed axes X, Y, Z.
pub type SpaceVector = Vector<Space>;
/// A vector given by its components on the body's principal axes.
pub type BodyVector = Vector<Body>;
/// A vector given by its components on the axes of the body's drawing.
pub type DesignVector = Vector<Design>;

impl<F: Frame> Vector<F> {
    /// The vector with these components.
    #[inline]
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { components: Vector3::new(x, y, z), frame: PhantomData }
    }

    /// The zero vector.
    #[inline]
    pub const fn zero() -> Self {
        Self::new(0.0, 0.0, 0.0)
    }

    /// The vector with these components, as an array.
    #[inline]
    pub const fn from_array([x, y, z]: [f64; 3]) -> Self {
        Self::new(x, y, z)
    }

    /// The components, as an array.
    #[inline]
    pub fn to_array(self) -> [f64; 3] {
        self.components.into()
    }

    /// The vector with these components, as a nalgebra column.
    #[inline]
    pub(crate) const fn from_column(components: Vector3<f64>) -> Self {
        Self { components, frame: PhantomData }
    }

    /// The components, as a nalgebra column without its frame.
    #[inline]
    pub const fn column(&self) -> &Vector3<f64> {
        &self.components
    }

    /// First component.
    #[inline]
    pub fn x(&self) -> f64 {
        self.components.x
    }

    /// Second component.
    #[inline]
    pub fn y(&self) -> f64 {
        self.components.y
    }

    /// Third component.
    #[inline]
    pub fn z(&self) -> f64 {
        self.components.z
    }

    /// Scalar product.
    #[inline]
    pub fn dot(&self, other: &Self) -> f64 {
        self.components.dot(&other.components)
    }

    /// Vector product, in this order.
    #[inline]
    pub fn cross(&self, other: &Self) -> Self {
        Self::from_column(self.components.cross(&other.components))
    }

    /// Length, without overflow or underflow on the way.
    #[inline]
    pub fn norm(&self) -> f64 {
        crate::math::hypot(
            crate::math::hypot(self.components.x, self.components.y),
            self.components.z,
        )
    }

    /// True if every component is finite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.components.iter().all(|c| c.is_finite())
    }
}

impl<F: Frame> Add for Vector<F> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::from_column(self.components + other.components)
    }
}

impl<F: Frame> AddAssign for Vector<F> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.components += other.components;
    }
}

impl<F: Frame> Sub for Vector<F> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::from_column(self.components - other.components)
    }
}

impl<F: Frame> SubAssign for Vector<F> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        self.components -= other.components;
    }
}

impl<F: Frame> Neg for Vector<F> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::from_column(-self.components)
    }
}

impl<F: Frame> Mul<f64> for Vector<F> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self::from_column(self.components * factor)
    }
}

impl<F: Frame> Mul<Vector<F>> for f64 {
    type Output = Vector<F>;
    #[inline]
    fn mul(self, vector: Vector<F>) -> Vector<F> {
        vector * self
    }
}

impl<F: Frame> Div<f64> for Vector<F> {
    type Output = Self;
    #[inline]
    fn div(self, divisor: f64) -> Self {
        Self::from_column(self.components / divisor)
    }
}
