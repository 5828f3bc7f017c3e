//! A contact that lets go and another that sticks in one instant, or a few roundings apart.

use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, motion};
use support::{EPS, Errors, assert_largest};

/// A block that slides to a stop, and one that is lifted off its shelf by a force that grows
/// with the time, which is the third coordinate; it carries that one at `lifts`.
struct Tie {
    lifts: f64,
}

const BRAKE: f64 = 5.0;
const GROWS: f64 = 10.0;

impl Mechanism<3, 2> for Tie {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }
    fn force(&self, both: &MechanismState<3>) -> [f64; 3] {
        [0.0, GROWS * (both.q[2] - self.lifts), 0.0]
    }
    fn contacts(&self, both: &MechanismState<3>) -> [Contact<3>; 2] {
        [
            Contact::pressed("block", BRAKE).tangent([1.0, 0.0, 0.0], 0.0).friction(1.0),
            Contact::new("shelf", both.q[1], [0.0, 1.0, 0.0], 0.0),
        ]
    }
}

/// Both are found, whichever is a rounding earlier. Where the stop was met and the force of the
/// shelf was a rounding above zero the shelf was kept, failed at once, and the run was refused.
#[test]
fn a_stop_and_a_release_in_one_instant() {
    let mut errors = Errors::in_units_of(EPS, "times and places");
    let mut damaged = Errors::in_units_of(EPS, "a shelf that lets go a millionth later");
    let method = Dop853::new(1e-15).unwrap();
    for stops in [0.2, 0.6, 1.0, 1.7, 3.0] {
        for roundings in -4..=4 {
            let lifts = stops * (1.0 + 2.0 * EPS * f64::from(roundings));
            let start = MechanismState { q: [0.0; 3], v: [BRAKE * stops, 0.0, 1.0] };
            let (tie, end) = (Tie { lifts }, stops + 1.0);
            let found = motion(&tie, &method, start, end).unwrap();
            let (sticks, lets_go) =
                (found.event("block sticks").unwrap().t, found.event("shelf lets go").unwrap().t);
            assert_eq!(found.events().len(), 2, "{stops} {roundings}");
            let [x, y, _] = found.at(end).unwrap().q;
            errors.add(sticks, stops, stops);
            errors.add(lets_go, lifts, stops);
            let place = 0.5 * BRAKE * stops * stops;
            errors.add(x, place, place);
            let since = end - lifts;
            let height = |since: f64| GROWS * since * since * since / 6.0;
            // What the times do to it, beside its own size.
            let size = height(since) * (1.0 + 3.0 * end / since);
            errors.add(y, height(since), size);
            damaged.add(y, height(since - 1e-6 * end), size);
        }
    }
    assert_largest!(errors, 5 * 9 * 4, @"8.33");
    damaged.exceed(1e6, 5 * 9);
}
