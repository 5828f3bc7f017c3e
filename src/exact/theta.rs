//! What the theta series of both closed forms start from: the periods by the nome that is
//! small, and the zeros of the series.
//!
//! Derived in `book/src/how_heavy_top.md` and `book/src/how_free_body.md`.

use crate::exact::nome::{Angle, Nome};
use crate::math::DoubleDouble as Dd;

/// Periods and nome of a parameter m.
#[derive(Debug, Clone)]
pub(super) struct Periods {
    /// K, infinite for m = 1.
    pub quarter: Dd,
    /// True if the series run in the nome q' of 1 - m: after Jacobi's imaginary
    /// transformation, in hyperbolic functions.
    pub hyperbolic: bool,
    /// That of m, or if they do that of 1 - m.
    pub nome: Nome,
}

impl Periods {
    /// For the parameter m and 1 - m, by the nome of m while that is at most `most`.
    pub fn new(m: Dd, m1: Dd, most: f64) -> Self {
        let hyperbolic = m > most;
        let nome = if hyperbolic {
            Nome::new(m1, m)
        } else {
            Nome::new(m, m1)
        };
        Self {
            quarter: if hyperbolic {
                nome.conjugate()
            } else {
                nome.quarter
            },
            hyperbolic,
            nome,
        }
    }

    /// The argument u <= K/2 with sc^2(u|m) = `num`/`den`.
    pub fn argument(&self, num: Dd, den: Dd) -> Dd {
        self.nome.argument(if self.hyperbolic {
            self.nome.depth(num, den).y
        } else {
            self.nome.angle(num, den).z
        })
    }

    /// The zero i eta, 0 <= eta <= K', from sc^2(eta|m1) and sc^2(K' - eta|m1), each as a
    /// quotient.
    pub fn zero(&self, eta: (Dd, Dd), rest: (Dd, Dd)) -> Zero {
        let nome = &self.nome;
        let nearer = eta.0 * rest.1 <= rest.0 * eta.1;
        let (num, den) = if nearer { eta } else { rest };
        if self.hyperbolic {
            let angle = nome.angle(num, den);
            return Zero::Along(if nearer { angle } else { angle.complement() });
        }
        let depth = nome.depth(num, den);
        // No q -> 0 times e^y -> infinity.
        let other = if nome.q == 0.0 {
            Dd::ZERO
        } else {
            nome.q / depth.decay
        };
        Zero::Across(if nearer {
            Across {
                decay: depth.decay,
                fall: depth.fall,
                rest: other,
            }
        } else {
            Across {
                decay: other,
                fall: 1.0 - other,
                rest: depth.decay,
            }
        })
    }
}

/// A zero off the real axis, in the terms of the series that converges.
#[derive(Debug, Clone, Copy)]
pub(super) enum Zero {
    /// In q.
    Across(Across),
    /// In q', by y' = pi eta/2K'.
    Along(Angle),
}

/// A zero by y = pi eta/2K.
#[derive(Debug, Clone, Copy)]
pub(super) struct Across {
    /// e^{-2y}.
    pub decay: Dd,
    /// 1 - e^{-2y}.
    pub fall: Dd,
    /// q e^{2y}.
    pub rest: Dd,
}

/// (-1)^n.
pub(super) fn alternating(n: usize) -> f64 {
    if n.is_multiple_of(2) { 1.0 } else { -1.0 }
}
