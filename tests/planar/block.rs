//! A block on an incline: it holds, slides to rest, stays.

use super::{G, relative};
use rotation_dynamics::Error;
use rotation_dynamics::math::{EPS, atan, cos, sin};
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, Mode, Motion, Sense, State, motion_within,
};

/// A point mass on an incline: x down the slope, y off it.
pub struct Block {
    pub slope: f64,
    pub kinetic: f64,
    pub holding: f64,
}

impl Block {
    fn new(slope: f64, mu: f64) -> Self {
        Self {
            slope,
            kinetic: mu,
            holding: mu,
        }
    }
}

impl Mechanism<2, 4, 1> for Block {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[2.0, 0.0], [0.0, 2.0]]
    }
    fn force(&self, _: &State<2>) -> [f64; 2] {
        [2.0 * G * sin(self.slope), -2.0 * G * cos(self.slope)]
    }
    fn contacts(&self, block: &State<2>) -> [Contact<2>; 1] {
        let slope = Contact::new("slope", block.q[1], [0.0, 1.0], 0.0);
        [slope
            .tangent([1.0, 0.0], 0.0)
            .frictions(self.kinetic, self.holding)]
    }
}

fn slide(block: &Block, speed: f64, t_end: f64) -> Motion<&Block, 2, 4, 1> {
    let start = State {
        q: [0.0, 0.0],
        v: [speed, 0.0],
    };
    motion_within(block, 1e-12, start, t_end).unwrap()
}

/// Released at rest it stays if mu >= tan(slope), and else slides with g (sin - mu cos).
#[test]
fn a_block_holds_up_to_the_tangent() {
    let (mut held, mut slid, mut worst) = (0, 0, 0.0);
    for mu in [0.1, 0.3, 0.7, 1.5] {
        for off in [0.9, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.1] {
            let slope = off * atan(mu);
            let block = Block::new(slope, mu);
            let motion = slide(&block, 0.0, 1.0);
            let [force] = motion.forces(0.5).unwrap();
            let end = motion.at(1.0).unwrap();
            assert!(motion.events().is_empty());
            if off <= 1.0 {
                assert_eq!(motion.modes(0.5).unwrap(), [Mode::Stick]);
                worst = f64::max(worst, end.q[0].abs()).max(end.v[0].abs());
                assert!(relative(force.tangential, -2.0 * G * sin(slope)) <= 2.0 * EPS);
                held += 1;
            } else {
                assert_eq!(motion.modes(0.5).unwrap(), [Mode::Slip(Sense::Forward)]);
                let a = G * (sin(slope) - mu * cos(slope));
                assert!((end.v[0] - a).abs() <= 4.0 * EPS * G, "{}", end.v[0] - a);
                assert!((end.q[0] - 0.5 * a).abs() <= 4.0 * EPS * G);
                assert!(relative(force.tangential, -mu * 2.0 * G * cos(slope)) <= 4.0 * EPS);
                slid += 1;
            }
        }
    }
    assert_eq!((held, slid), (12, 8));
    assert!(worst <= 0.0, "{worst:e}");
}

/// Pushed, it slides to rest on time, and stays: one event, no chatter.
#[test]
fn a_block_slides_to_rest_and_stays() {
    let (mut ran, mut worst) = (0, 0.0);
    for (slope, mu, speed) in [
        (0.0, 0.3, 2.0),
        (0.0, 0.3, -2.0),
        (0.2, 0.3, 2.0),
        (0.2, 0.3, -2.0),
        (-0.2, 1.0, 1e-3),
    ] {
        let block = Block::new(slope, mu);
        let brake = G * (mu * cos(slope) - f64::copysign(sin(slope), speed * slope));
        let stop = speed.abs() / brake;
        let motion = slide(&block, speed, 10.0 * stop);
        assert_eq!(motion.events().len(), 1, "{:?}", motion.events());
        let stops = motion.event("slope sticks").unwrap();
        worst = f64::max(worst, relative(stops.t, stop));
        let end = motion.at(10.0 * stop).unwrap();
        worst = worst.max(relative(end.q[0], 0.5 * speed * stop));
        assert_eq!(end.v[0], 0.0);
        ran += 1;
    }
    assert_eq!(ran, 5);
    assert!(worst <= 6.9 * EPS, "{} eps", worst / EPS);
}

/// Too steep to hold it, it goes up, turns and comes back without a rest.
#[test]
fn a_block_reverses_on_a_steep_slope() {
    let block = Block::new(0.5, 0.3);
    let motion = slide(&block, -2.0, 2.0);
    let up = 2.0 / (G * (sin(0.5) + 0.3 * cos(0.5)));
    let turns = motion.event("slope reverses").unwrap();
    assert!(
        relative(turns.t, up) <= 4.0 * EPS,
        "{}",
        relative(turns.t, up) / EPS
    );
    let down = G * (sin(0.5) - 0.3 * cos(0.5)) * (2.0 - up);
    let end = motion.at(2.0).unwrap();
    assert!(
        relative(end.v[0], down) <= 8.0 * EPS,
        "{}",
        relative(end.v[0], down) / EPS
    );
    assert_eq!(motion.events().len(), 1);
}

#[test]
fn wrong_starts_are_refused() {
    let block = Block::new(0.2, 0.3);
    let refused =
        |block: &Block, q, v| motion_within(block, 1e-9, State { q, v }, 1.0).unwrap_err();
    for (q, v) in [
        ([0.0, -1e-6], [0.0, 0.0]),
        ([0.0, 0.0], [0.0, -1e-6]),
        ([0.0, f64::NAN], [0.0, 0.0]),
        ([0.0, 0.0], [0.0, f64::NAN]),
    ] {
        let error = refused(&block, q, v);
        assert!(
            matches!(
                error,
                Error::CannotHold {
                    contact: "slope",
                    ..
                }
            ),
            "{error}"
        );
    }
    let message = refused(&block, [0.0, -0.5], [0.0, 0.0]).to_string();
    assert!(
        message.starts_with("\"slope\" cannot hold at t = 0: its gap is -0.5 and opens at 0"),
        "{message}"
    );
    for (kinetic, holding) in [(-0.1, 0.0), (0.3, 0.2), (f64::NAN, 1.0)] {
        let block = Block {
            slope: 0.0,
            kinetic,
            holding,
        };
        let error = refused(&block, [0.0; 2], [0.0; 2]);
        assert!(
            matches!(error, Error::OutOfRange { .. } | Error::NotFinite { .. }),
            "{error}"
        );
    }
}
