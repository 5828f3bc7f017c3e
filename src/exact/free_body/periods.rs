//! The time since a turning point of a tumbling body, by the nome that is small.

use crate::exact::nome::Nome;
use crate::exact::theta::Periods;
use crate::math::DoubleDouble as Dd;

impl Periods {
    /// F of the amplitude with sin : cos = `sin` : `cos`, in (-2K, 2K].
    pub(crate) fn first_kind(&self, sin: Dd, cos: Dd) -> Dd {
        let (beyond, distance) = self.nearer_end(sin.square(), cos.square());
        let f = if beyond { self.quarter - distance } else { distance };
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
    pub(crate) fn beside_the_saddle(m1: Dd, ln_unit: Dd, sin: Dd, cos: Dd) -> (Self, Dd) {
        let nome = Nome::new(Dd::ZERO, Dd::ONE);
        let quarter = if m1 == 0.0 {
            Dd::from(f64::INFINITY)
        } else {
            (Dd::from(16.0) / m1).ln().scaled(0.5) - ln_unit
        };
        let periods = Self { quarter, nome, hyperbolic: true };
        let (s, c) = (sin.square(), cos.square());
        let f = if m1 == 0.0 {
            (s.scaled(4.0) / c).ln().scaled(0.5) - ln_unit
        } else {
            quarter - periods.argument(c, m1 * s)
        };
        let tau = periods.unfolded(f, sin, cos);
        (periods, tau)
    }
}
