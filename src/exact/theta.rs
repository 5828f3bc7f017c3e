//! The common part of all theta series of the closed forms: the periods by the nome that is small,
//! the zeros, and the sums of four terms in both forms, polynomials in sin^2 z and hyperbolic
//! waves.
//!
//! Derived in `book/src/how_heavy_top.md` and `book/src/how_free_body.md`.

use crate::exact::nome::{Angle, Depth, Nome};
use crate::math::{DoubleDouble as Dd, exp, expm1};

/// Periods and nome of a parameter m.
#[derive(Debug, Clone)]
pub(super) struct Periods {
    /// K, infinite for m = 1.
    pub(super) quarter: Dd,
    /// True if the series run in the nome q' of 1 - m: after Jacobi's imaginary
    /// transformation, in hyperbolic functions.
    pub(super) hyperbolic: bool,
    /// The nome of m, or if they do, of 1 - m.
    pub(super) nome: Nome,
}

impl Periods {
    /// For the parameter m and 1 - m, by the nome of m while that is at most `most`.
    pub(super) fn new(m: Dd, m1: Dd, most: f64) -> Self {
        let hyperbolic = m > most;
        let nome = if hyperbolic { Nome::new(m1, m) } else { Nome::new(m, m1) };
        Self { quarter: if hyperbolic { nome.conjugate() } else { nome.quarter }, hyperbolic, nome }
    }

    /// The argument u <= K/2 with sc^2(u|m) = `num`/`den`.
    pub(super) fn argument(&self, num: Dd, den: Dd) -> Dd {
        self.nome.argument(if self.hyperbolic {
            self.nome.depth(num, den).y()
        } else {
            self.nome.angle(num, den).z
        })
    }

    /// The argument u, 0 <= u <= K, with sc^2(u|m) = `num`/`den`, as its distance from the nearer
    /// of 0 and K; true if that is K.
    pub(super) fn nearer_end(&self, num: Dd, den: Dd) -> (bool, Dd) {
        let nome = &self.nome;
        let m1 = if self.hyperbolic { nome.m } else { nome.m1 };
        // Half-way, sc^2 = 1/sqrt(1-m); sc^2(K - u) = cs^2(u)/(1-m).
        if num.hi() * m1.hi().sqrt() <= den.hi() {
            (false, self.argument(num, den))
        } else {
            (true, self.argument(den, m1 * num))
        }
    }

    /// The zero i eta, 0 <= eta <= K', from sc^2(eta|m1) and sc^2(K' - eta|m1), each as a
    /// quotient.
    pub(super) fn zero(&self, eta: (Dd, Dd), rest: (Dd, Dd)) -> Zero {
        let (nearer, (num, den)) = nearer_zero(eta, rest);
        if self.hyperbolic {
            self.along(nearer, self.nome.angle(num, den))
        } else {
            self.across(nearer, self.nome.depth(num, den))
        }
    }

    /// Two of them.
    pub(super) fn zeros(&self, zeros: [[(Dd, Dd); 2]; 2]) -> [Zero; 2] {
        let [(first, of_first), (second, of_second)] =
            zeros.map(|[eta, rest]| nearer_zero(eta, rest));
        if self.hyperbolic {
            let angle = |(num, den)| self.nome.angle(num, den);
            [self.along(first, angle(of_first)), self.along(second, angle(of_second))]
        } else {
            let [one, other] = self.nome.depths([of_first, of_second]);
            [self.across(first, one), self.across(second, other)]
        }
    }

    /// From the angle of eta, or of K' - eta.
    fn along(&self, nearer: bool, angle: Angle) -> Zero {
        Zero::Along(if nearer { angle } else { angle.complement() })
    }

    /// From the depth of eta, or of K' - eta.
    fn across(&self, nearer: bool, depth: Depth) -> Zero {
        let nome = &self.nome;
        // No q -> 0 times e^y -> infinity.
        let other = if nome.q == 0.0 { Dd::ZERO } else { nome.q / depth.decay };
        Zero::Across(if nearer {
            Across { decay: depth.decay, fall: depth.fall, rest: other }
        } else {
            Across { decay: other, fall: 1.0 - other, rest: depth.decay }
        })
    }
}

/// Which of the two quotients belongs to the zero's nearer end, true if to eta, and that one.
fn nearer_zero(eta: (Dd, Dd), rest: (Dd, Dd)) -> (bool, (Dd, Dd)) {
    let nearer = eta.0 * rest.1 <= rest.0 * eta.1;
    (nearer, if nearer { eta } else { rest })
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
pub(super) struct Across<L = f64> {
    /// e^{-2y}.
    pub(super) decay: Dd<L>,
    /// 1 - e^{-2y}.
    pub(super) fall: Dd<L>,
    /// q e^{2y}.
    pub(super) rest: Dd<L>,
}

/// Waves of w >= 0 times 2 e^{-w}, so that nothing overflows, and the n-th times the n-th power of
/// e^{2w} and a nome, n = 0 to 3.
#[derive(Debug, Clone, Copy)]
pub(super) struct Waves {
    /// cosh and sinh (2n+1) w.
    pub(super) odd_cosh: [f64; 4],
    pub(super) odd_sinh: [f64; 4],
    /// e^{-w} cosh 2n w.
    pub(super) even_cosh: [f64; 4],
}

impl Waves {
    /// For the nome e^{-`width`}.
    #[inline(always)]
    pub(super) fn new(w: f64, width: f64) -> Self {
        let minus = -expm1(-2.0 * w);
        let decay = 1.0 - minus;
        let growth = exp(2.0 * w - width);
        let [mut odd_cosh, mut odd_sinh, mut even_cosh] = [[0.0; 4]; 3];
        let (mut weight, mut power, mut differences) = (1.0, decay, minus);
        let mut full = 1.0;
        for n in 0..4 {
            odd_cosh[n] = weight * (1.0 + power);
            odd_sinh[n] = weight * differences;
            even_cosh[n] = weight * (1.0 + full);
            weight *= growth;
            // 1 - E^{2n+3} = (1 - E^{2n+1}) + E^{2n+1} (1 - E)(1 + E), E = e^{-2w}.
            differences += power * minus * (1.0 + decay);
            power *= decay * decay;
            full *= decay * decay;
        }
        Self { odd_cosh, odd_sinh, even_cosh }
    }
}

/// A sum of waves with these coefficients.
#[inline]
pub(super) fn dot(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    a[0] * b[0] + (a[1] * b[1] + (a[2] * b[2] + a[3] * b[3]))
}

/// Horner's rule for a cubic.
#[inline]
pub(super) fn horner(p: &[f64; 4], x: f64) -> f64 {
    p[0] + x * (p[1] + x * (p[2] + x * p[3]))
}

/// Multiples of z as polynomials in sin^2 z, n = 0 to 3.
pub(super) type Multiples = [[f64; 4]; 4];

/// sin (2n+1)z/sin z.
pub(super) const ODD_SINES: Multiples = [
    [1.0, 0.0, 0.0, 0.0],
    [3.0, -4.0, 0.0, 0.0],
    [5.0, -20.0, 16.0, 0.0],
    [7.0, -56.0, 112.0, -64.0],
];

/// cos (2n+1)z/cos z.
pub(super) const ODD_COSINES: Multiples = [
    [1.0, 0.0, 0.0, 0.0],
    [1.0, -4.0, 0.0, 0.0],
    [1.0, -12.0, 16.0, 0.0],
    [1.0, -24.0, 80.0, -64.0],
];

/// sin 2nz/(sin z cos z).
pub(super) const EVEN_SINES: Multiples =
    [[0.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [4.0, -8.0, 0.0, 0.0], [6.0, -32.0, 32.0, 0.0]];

/// cos 2nz.
pub(super) const EVEN_COSINES: Multiples =
    [[1.0, 0.0, 0.0, 0.0], [1.0, -2.0, 0.0, 0.0], [1.0, -8.0, 8.0, 0.0], [1.0, -18.0, 48.0, -32.0]];

/// The sum of these multiples with these coefficients, as one polynomial: the n-th multiple has
/// powers up to the n-th.
#[inline]
pub(super) fn collected(multiples: &Multiples, c: [f64; 4]) -> [f64; 4] {
    core::array::from_fn(|j| (j..4).fold(0.0, |sum, n| sum + multiples[n][j] * c[n]))
}

/// (-1)^n.
pub(super) fn alternating(n: usize) -> f64 {
    if n.is_multiple_of(2) { 1.0 } else { -1.0 }
}
