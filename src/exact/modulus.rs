//! The modulus and the characteristic of elliptic integrals, each kept with its
//! complement, so that nothing is lost where one of the pair is near 1.
//!
//! Not for: parameters m below 0 or above 1; map them first (DLMF 19.7, 22.17).

use crate::error::{Error, Result, finite};
use crate::math::DoubleDouble as Dd;

/// The modulus of an elliptic function or integral: m = k^2 and m1 = 1 - m, to 106 bits each.
///
/// Which of the pair is given matters: near the separatrix of a motion m rounds
/// to 1 and only m1 tells the states apart.
///
/// ```
/// use rotation_dynamics::exact::{Modulus, legendre};
/// // m = 1 - 1e-40 cannot be written as a double; its complement can.
/// let k = legendre::k(Modulus::from_m1(1e-40)?)?;
/// assert_eq!(k, 47.437996221000804);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulus {
    m: Dd,
    m1: Dd,
    k1: Dd,
}

impl Modulus {
    /// From the parameter m = k^2, 0 <= m <= 1.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` outside [0, 1].
    pub fn from_m(m: f64) -> Result<Self> {
        let allowed = "it must lie in 0..=1; outside, map it (DLMF 19.7, 22.17): for m < 0 with \
                       n = m/(m - 1), q = 1/sqrt(1 - m): K(m) = q K(n), sn(u, m) = q sd(u/q, n); \
                       for m > 1 with k = sqrt(m): sn(u, m) = sn(k u, 1/m)/k";
        let m = Dd::from(unit_interval("m", m, allowed)?);
        Ok(Self::from_pair(m, Dd::ONE - m))
    }

    /// From the complementary parameter m1 = 1 - m = k'^2, 0 <= m1 <= 1.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` outside [0, 1].
    pub fn from_m1(m1: f64) -> Result<Self> {
        let allowed = "it must lie in 0..=1; outside, map m = 1 - m1 as `from_m` says";
        let m1 = Dd::from(unit_interval("m1", m1, allowed)?);
        Ok(Self::from_pair(Dd::ONE - m1, m1))
    }

    /// From the modulus k, 0 <= k <= 1.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` outside [0, 1].
    pub fn from_k(k: f64) -> Result<Self> {
        let allowed = "it must lie in 0..=1; below, take -k; above, map m = k^2 as `from_m` says";
        let k = unit_interval("k", k, allowed)?;
        // (1 - k)(1 + k): both factors are exact pairs.
        let m1 = Dd::sum(1.0, -k) * Dd::sum(1.0, k);
        Ok(Self::from_pair(Dd::product(k, k), m1))
    }

    fn from_pair(m: Dd, m1: Dd) -> Self {
        // Scaled, because the square of the root of 1e-308 has no room for its low part.
        const UP: f64 = 1.329_227_995_784_916e36; // 2^120
        let k1 = if m1.hi() < 1e-200 {
            m1.scaled(UP).scaled(UP).sqrt().scaled(1.0 / UP)
        } else {
            m1.sqrt()
        };
        Self { m, m1, k1 }
    }

    /// The parameter m = k^2, rounded.
    pub fn m(&self) -> f64 {
        self.m.to_f64()
    }

    /// The complementary parameter m1 = 1 - m, rounded.
    pub fn m1(&self) -> f64 {
        self.m1.to_f64()
    }

    /// The modulus k, rounded.
    pub fn k(&self) -> f64 {
        self.m.sqrt().to_f64()
    }

    /// The modulus with m and m1 exchanged.
    #[must_use]
    pub fn complement(&self) -> Self {
        Self::from_pair(self.m1, self.m)
    }

    pub(crate) fn m_extended(&self) -> Dd {
        self.m
    }

    pub(crate) fn m1_extended(&self) -> Dd {
        self.m1
    }

    pub(crate) fn k1_extended(&self) -> Dd {
        self.k1
    }
}

/// The characteristic n of an integral of the third kind with 1 - n, to 106 bits each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    n: Dd,
    n1: Dd,
}

impl Characteristic {
    /// From n, |n| <= 1e300.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` beyond 1e300.
    pub fn from_n(n: f64) -> Result<Self> {
        let n = not_huge("n", n)?;
        Ok(Self { n: Dd::from(n), n1: Dd::sum(1.0, -n) })
    }

    /// From the complement n1 = 1 - n, |n1| <= 1e300.
    ///
    /// # Errors
    /// `NotFinite`; `OutOfRange` beyond 1e300.
    pub fn from_n1(n1: f64) -> Result<Self> {
        let n1 = not_huge("n1", n1)?;
        Ok(Self { n: Dd::sum(1.0, -n1), n1: Dd::from(n1) })
    }

    /// The characteristic n, rounded.
    pub fn n(&self) -> f64 {
        self.n.to_f64()
    }

    /// The complement 1 - n, rounded.
    pub fn n1(&self) -> f64 {
        self.n1.to_f64()
    }

    pub(crate) fn n_extended(&self) -> Dd {
        self.n
    }

    pub(crate) fn n1_extended(&self) -> Dd {
        self.n1
    }
}

fn unit_interval(name: &'static str, value: f64, allowed: &'static str) -> Result<f64> {
    finite(name, value)?;
    if (0.0..=1.0).contains(&value) {
        Ok(value)
    } else {
        Err(Error::out_of_range(name, value, allowed))
    }
}

fn not_huge(name: &'static str, value: f64) -> Result<f64> {
    finite(name, value)?;
    if value.abs() <= 1e300 {
        Ok(value)
    } else {
        Err(Error::out_of_range(name, value, "its size must not exceed 1e300"))
    }
}
