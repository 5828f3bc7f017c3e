//! Rows of contacts against differences of their gaps: what is declared wrongly is seen.

use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, misdeclared};
use support::{Errors, assert_largest};

/// A bead over a bowl y = x^2, whose rows are off by these parts.
#[derive(Default)]
struct Bead {
    gradient: f64,
    bias: f64,
    slip: f64,
    /// How fast the bowl rises, m/s.
    rises: f64,
}

impl Mechanism<2, 1> for Bead {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[1.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [0.0; 2]
    }
    fn contacts(&self, bead: &MechanismState<2>) -> [Contact<2>; 1] {
        let ([x, y], [vx, vy]) = (bead.q, bead.v);
        let along = [-2.0 * x * (1.0 + self.gradient), 1.0];
        let bias = -2.0 * vx * vx * (1.0 + self.bias);
        let slip_bias = 2.0 * vx * vy * (1.0 + self.slip);
        let bowl = Contact::new("bowl", y - x * x, along, bias);
        [bowl.tangent([1.0, 2.0 * x], slip_bias).rising(self.rises, 0.0)]
    }
}

fn error(bead: &Bead, faster: f64) -> f64 {
    let state = MechanismState { q: [0.7, 1.9], v: [0.4 * faster, -1.3 * faster] };
    misdeclared(bead, &state)
}

/// Sound rows are round-off of the differences, at any speed; each that is off shows.
#[test]
fn each_row_is_looked_at() {
    let mut sound = Errors::of("sound rows");
    let mut rising = Errors::of("sound rows of a bowl that rises");
    let mut damaged = Errors::of("rows off by a hundredth");
    let mut unseen = Errors::of("normal rows of a bowl that rises");
    for faster in [1e-6, 1.0, 1e6] {
        let with = |gradient, bias, slip, rises| Bead { gradient, bias, slip, rises };
        sound.push(error(&Bead::default(), faster));
        rising.push(error(&with(0.0, 0.0, 0.0, 2.0), faster));
        for bead in [
            with(1e-2, 0.0, 0.0, 0.0),
            with(0.0, 1e-2, 0.0, 0.0),
            with(0.0, 0.0, 1e-2, 0.0),
            // The slip is looked at though the bowl rises.
            with(0.0, 0.0, 1e-2, 2.0),
        ] {
            damaged.push(error(&bead, faster));
        }
        unseen.push(error(&with(1e-2, 1e-2, 0.0, 2.0), faster));
    }
    assert_largest!(sound, 3, @"1.18e-13");
    assert_largest!(rising, 3, @"1.18e-13");
    damaged.exceed(1e-4, 12);
    assert_largest!(unseen, 3, @"1.18e-13");
}
