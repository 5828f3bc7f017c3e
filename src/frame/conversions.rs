//! Vectors to and from what others use: arrays, nalgebra's columns, text, sums.

use super::{Frame, Vector};
use core::fmt;
use core::iter::Sum;
use core::ops::Index;
use nalgebra::Vector3;

impl<F: Frame> From<[f64; 3]> for Vector<F> {
    #[inline]
    fn from(components: [f64; 3]) -> Self {
        Self::from_array(components)
    }
}

impl<F: Frame> From<Vector<F>> for [f64; 3] {
    #[inline]
    fn from(vector: Vector<F>) -> Self {
        vector.to_array()
    }
}

impl<F: Frame> From<Vector3<f64>> for Vector<F> {
    #[inline]
    fn from(components: Vector3<f64>) -> Self {
        Self::from_column(components)
    }
}

impl<F: Frame> From<Vector<F>> for Vector3<f64> {
    #[inline]
    fn from(vector: Vector<F>) -> Self {
        *vector.column()
    }
}

/// The component with this index, 0, 1 or 2; any other panics, as for an array.
impl<F: Frame> Index<usize> for Vector<F> {
    type Output = f64;
    #[inline]
    fn index(&self, index: usize) -> &f64 {
        &self.column().data.0[0][index]
    }
}

impl<F: Frame> Sum for Vector<F> {
    fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
        vectors.fold(Self::zero(), |sum, vector| sum + vector)
    }
}

impl<'a, F: Frame> Sum<&'a Self> for Vector<F> {
    fn sum<I: Iterator<Item = &'a Self>>(vectors: I) -> Self {
        vectors.copied().sum()
    }
}

/// The three components, each written as the format says: `{:.3}`, `{:+8.2}`.
impl<F: Frame> fmt::Display for Vector<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self.to_array(), f, fmt::Display::fmt)
    }
}

/// The name of the type and the components: `SpaceVector(1.25, 2.0, 0.5)`.
impl<F: Frame> fmt::Debug for Vector<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(F::VECTOR)?;
        written(self.to_array(), f, fmt::Debug::fmt)
    }
}

/// The components with exponents: `{:e}`, `{:.3e}`.
impl<F: Frame> fmt::LowerExp for Vector<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self.to_array(), f, fmt::LowerExp::fmt)
    }
}

/// The numbers in brackets, each as it is written alone.
pub(crate) fn written<const N: usize>(
    numbers: [f64; N],
    f: &mut fmt::Formatter<'_>,
    write: impl Fn(&f64, &mut fmt::Formatter<'_>) -> fmt::Result,
) -> fmt::Result {
    for (i, number) in numbers.iter().enumerate() {
        f.write_str(if i == 0 { "(" } else { ", " })?;
        write(number, f)?;
    }
    f.write_str(")")
}
