//! A block on an incline: it holds, slides to rest, stays.

use super::G;
use rotation_dynamics::Error;
use rotation_dynamics::math::{atan, cos, sin};
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Mode, Sense, motion_within,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// A point mass on an incline: x down the slope, y off it.
pub struct Block {
    pub slope: f64,
    pub kinetic: f64,
    pub holding: f64,
}

impl Block {
    fn new(slope: f64, mu: f64) -> Self {
        Self { slope, kinetic: mu, holding: mu }
    }
}

impl Mechanism<2, 1> for Block {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[2.0, 0.0], [0.0, 2.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [2.0 * G * sin(self.slope), -2.0 * G * cos(self.slope)]
    }
    fn contacts(&self, block: &MechanismState<2>) -> [Contact<2>; 1] {
        let slope = Contact::new("slope", block.q[1], [0.0, 1.0], 0.0);
        [slope.tangent([1.0, 0.0], 0.0).frictions(self.kinetic, self.holding)]
    }
}

fn slide(block: &Block, speed: f64, t_end: f64) -> ContactMotion<&Block, 2, 1> {
    let start = MechanismState { q: [0.0, 0.0], v: [speed, 0.0] };
    motion_within(block, 1e-12, start, t_end).unwrap()
}

/// What a block on a slope does whose friction is off by the part `damage`.
struct Released {
    /// How far one moves that holds, m and m/s.
    moved: Errors,
    /// Speed and way of one that slides, in parts of g.
    slid: Errors,
    friction: Errors,
}

fn released(damage: f64) -> Released {
    let mut found = Released {
        moved: Errors::of("moved though it holds"),
        slid: Errors::in_units_of(EPS, "speed and way"),
        friction: Errors::in_units_of(EPS, "friction"),
    };
    for mu in [0.1, 0.3, 0.7, 1.5] {
        for off in [0.9, 1.0 - 1e-9, 1.0, 1.0 + 1e-9, 1.1] {
            let slope = off * atan(mu);
            let block = Block::new(slope, mu * (1.0 + damage));
            let motion = slide(&block, 0.0, 1.0);
            let [force] = motion.forces(0.5).unwrap();
            let end = motion.at(1.0).unwrap();
            assert!(motion.events().is_empty());
            let held = motion.modes(0.5).unwrap() == [Mode::Stick];
            assert!(held || motion.modes(0.5).unwrap() == [Mode::Slip(Sense::Forward)]);
            let weight = 2.0 * G;
            if off <= 1.0 {
                found.moved.push(end.q[0]);
                found.moved.push(end.v[0]);
                let want = -weight * sin(slope);
                found.friction.add(force.tangential, want, want.abs());
            } else {
                let a = G * (sin(slope) - mu * cos(slope));
                found.slid.add(end.v[0], a, G);
                found.slid.add(end.q[0], 0.5 * a, G);
                let want = -mu * weight * cos(slope);
                found.friction.add(force.tangential, want, want.abs());
            }
        }
    }
    found
}

/// Released at rest it stays if mu >= tan(slope), and else slides with g (sin - mu cos).
#[test]
fn a_block_holds_up_to_the_tangent() {
    let found = released(0.0);
    assert_largest!(found.moved, 24, @"0");
    assert_largest!(found.slid, 16, @"0.891");
    assert_largest!(found.friction, 20, @"1.49");
    // The damaged twins: it slips too easily, or holds too well.
    let smoother = released(-1e-8);
    assert!(smoother.moved.largest() > 1e-9);
    assert!(smoother.slid.largest() > 1e6 && smoother.friction.largest() > 1e6);
    let rougher = released(1e-8);
    assert_eq!(rougher.moved.largest(), 0.0);
    assert!(rougher.slid.largest() > 1e6 && rougher.friction.largest() > 1e6);
}

/// Stop and way of a pushed block whose friction is off by the part `damage`.
fn stops(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "stop and way");
    for (slope, mu, speed) in
        [(0.0, 0.3, 2.0), (0.0, 0.3, -2.0), (0.2, 0.3, 2.0), (0.2, 0.3, -2.0), (-0.2, 1.0, 1e-3)]
    {
        let block = Block::new(slope, mu * (1.0 + damage));
        let brake = G * (mu * cos(slope) - f64::copysign(sin(slope), speed * slope));
        let stop = speed.abs() / brake;
        let motion = slide(&block, speed, 10.0 * stop);
        assert_eq!(motion.events().len(), 1, "{:?}", motion.events());
        let stops = motion.event("slope sticks").unwrap();
        errors.add(stops.t, stop, stop);
        let end = motion.at(10.0 * stop).unwrap();
        let way = 0.5 * speed * stop;
        errors.add(end.q[0], way, way.abs());
        assert_eq!(end.v[0], 0.0);
    }
    errors
}

/// Pushed, it slides to rest on time, and stays: one event, no chatter.
#[test]
fn a_block_slides_to_rest_and_stays() {
    assert_largest!(stops(0.0), 10, @"6.89");
    stops(1e-12).exceed(1e3, 10);
}

/// Too steep to hold it, it goes up, turns and comes back without a rest.
#[test]
fn a_block_reverses_on_a_steep_slope() {
    let block = Block::new(0.5, 0.3);
    let motion = slide(&block, -2.0, 2.0);
    let up = 2.0 / (G * (sin(0.5) + 0.3 * cos(0.5)));
    let turns = motion.event("slope reverses").unwrap();
    assert_error!(turns.t, up, 0.0 eps);
    let down = G * (sin(0.5) - 0.3 * cos(0.5)) * (2.0 - up);
    let end = motion.at(2.0).unwrap();
    assert_error!(end.v[0], down, 2.2 eps);
    assert_eq!(motion.events().len(), 1);
    // The damaged twin: friction that does not turn round with the slip.
    let kept = G * (sin(0.5) + 0.3 * cos(0.5)) * (2.0 - up);
    assert!((kept / end.v[0] - 1.0).abs() > 1.0);
}

#[test]
fn wrong_starts_are_refused() {
    let block = Block::new(0.2, 0.3);
    let refused =
        |block: &Block, q, v| motion_within(block, 1e-9, MechanismState { q, v }, 1.0).unwrap_err();
    for (q, v) in [([0.0, -1e-6], [0.0, 0.0]), ([0.0, 0.0], [0.0, -1e-6])] {
        let error = refused(&block, q, v);
        assert!(matches!(error, Error::CannotHold { name: "slope", rate: Some(_), .. }), "{error}");
    }
    for (q, v, name) in
        [([0.0, f64::NAN], [0.0, 0.0], "coordinates"), ([0.0, 0.0], [0.0, f64::NAN], "velocities")]
    {
        let message = refused(&block, q, v).to_string();
        assert_eq!(message, format!("{name}[1]: value = NaN is not a finite number"));
    }
    let message = refused(&block, [0.0, -0.5], [0.0, 0.0]).to_string();
    assert!(
        message.starts_with("\"slope\" cannot hold at t = 0: its gap is -0.5 and opens at 0"),
        "{message}"
    );
    for (kinetic, holding) in [(-0.1, 0.0), (0.3, 0.2), (f64::NAN, 1.0)] {
        let block = Block { slope: 0.0, kinetic, holding };
        let error = refused(&block, [0.0; 2], [0.0; 2]);
        assert!(matches!(error, Error::OutOfRange { .. } | Error::NotFinite { .. }), "{error}");
    }
}
