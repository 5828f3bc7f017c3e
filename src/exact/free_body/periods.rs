//! The quarter periods of a tumbling body, the place of the zero of its theta functions,
//! and the time since a turning point, all by the nome that is small.

use crate::exact::nome::Nome;
use crate::math::DoubleDouble as Dd;

/// K, and the nome it comes from.
pub(super) struct Periods {
    /// K, infinite for m = 1.
    pub quarter: Dd,
    /// The nome of m, or for m > 1/2 that of 1 - m.
    pub nome: Nome,
    pub complementary: bool,
}

#[derive(Clone, Copy)]
/// The zero i eta, 0 <= eta <= K'.
pub(super) struct Zero {
    /// pi eta/2K' where the nome is that of 1 - m.
    pub angle: Dd,
    /// e^{-pi eta/K}, 1 less that, and q e^{pi eta/K} where the nome is that of m.
    pub decay: Dd,
    pub fall: Dd,
    pub rest: Dd,
}

impl Periods {
    pub fn new(m: Dd, m1: Dd) -> Self {
        let complementary = m > 0.5;
        let nome = if complementary {
            Nome::new(m1, m)
        } else {
            Nome::new(m, m1)
        };
        Self {
            quarter: if complementary {
                nome.conjugate()
            } else {
                nome.quarter
            },
            nome,
            complementary,
        }
    }

    /// F of the amplitude with sin : cos = `sin` : `cos`, in (-2K, 2K].
    pub fn first_kind(&self, sin: Dd, cos: Dd) -> Dd {
        let (s, c) = (sin.square(), cos.square());
        let m1 = if self.complementary {
            self.nome.m
        } else {
            self.nome.m1
        };
        // Half-way, sc^2 = 1/sqrt(1-m); sc^2(K - u) = cs^2(u)/(1-m).
        let f = if s.hi() * m1.hi().sqrt() <= c.hi() {
            self.argument(s, c)
        } else {
            self.quarter - self.argument(c, m1 * s)
        };
        self.unfolded(f, sin, cos)
    }

    /// F in (-2K, 2K] from the one in [0, K] for |`sin`| : |`cos`|.
    fn unfolded(&self, f: Dd, sin: Dd, cos: Dd) -> Dd {
        let f = if sin < 0.0 { -f } else { f };
        if cos >= 0.0 {
            f
        } else if sin >= 0.0 {
            self.quarter.scaled(2.0) - f
        } else {
            -self.quarter.scaled(2.0) - f
        }
    }

    /// The periods for 1 - m = `m1` s^2, and F of the amplitude with sin : cos = `sin` :
    /// `cos` s, with an s = exp(`ln_unit`) so small that its square need not be a double:
    /// K = ln(4/sqrt(1 - m)) and sc u = sinh u there.
    pub fn beside_the_saddle(m1: Dd, ln_unit: Dd, sin: Dd, cos: Dd) -> (Self, Dd) {
        let nome = Nome::new(Dd::ZERO, Dd::ONE);
        let quarter = if m1 == 0.0 {
            Dd::from(f64::INFINITY)
        } else {
            (Dd::from(16.0) / m1).ln().scaled(0.5) - ln_unit
        };
        let periods = Self {
            quarter,
            nome,
            complementary: true,
        };
        let (s, c) = (sin.square(), cos.square());
        let f = if m1 == 0.0 {
            (s.scaled(4.0) / c).ln().scaled(0.5) - ln_unit
        } else {
            quarter - periods.argument(c, m1 * s)
        };
        let tau = periods.unfolded(f, sin, cos);
        (periods, tau)
    }

    /// The argument u <= K/2 with sc^2(u|m) = `num`/`den`.
    fn argument(&self, num: Dd, den: Dd) -> Dd {
        self.nome.argument(if self.complementary {
            self.nome.depth(num, den).y
        } else {
            self.nome.angle(num, den).z
        })
    }

    /// The zero from sc^2(eta|m1) and sc^2(K' - eta|m1), each as a quotient.
    pub fn zero(&self, eta: (Dd, Dd), rest: (Dd, Dd)) -> Zero {
        let nearer = eta.0 * rest.1 <= rest.0 * eta.1;
        let (num, den) = if nearer { eta } else { rest };
        let (nil, one) = (Dd::ZERO, Dd::ONE);
        if self.complementary {
            let z = self.nome.angle(num, den).z;
            let angle = if nearer { z } else { Dd::FRAC_PI_2 - z };
            return Zero {
                angle,
                decay: nil,
                fall: one,
                rest: nil,
            };
        }
        let depth = self.nome.depth(num, den);
        let other = if self.nome.q == 0.0 {
            nil
        } else {
            self.nome.q / depth.decay
        };
        let (decay, fall, rest) = if nearer {
            (depth.decay, depth.fall, other)
        } else {
            (other, 1.0 - other, depth.decay)
        };
        Zero {
            angle: nil,
            decay,
            fall,
            rest,
        }
    }
}
