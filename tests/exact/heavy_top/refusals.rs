//! What is refused, and that nothing else fails.

use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::frame::BodyVector;

#[test]
fn an_energy_below_the_minimum_is_no_motion() {
    let top = ReducedTop::new(2.0, 1.2, 0.2).expect("a top");
    let refuse = |energy| HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0);
    let error = refuse(0.40).expect_err("below");
    assert_eq!(error.to_string(), "E~ = 0.4 is not allowed: no motion is below U_min = 0.404262");
    // One part in 1e14 below is seen, and shown.
    let minimum = top.minimum().1;
    let error = refuse(minimum * (1.0 - 1e-13)).expect_err("below");
    assert!(error.to_string().contains(&minimum.to_string()), "{error}");
    assert!(refuse(minimum).is_ok());
}

#[test]
fn bad_input_is_named() {
    let top = ReducedTop::new(1.0, 0.5, 0.2).expect("a top");
    let start = |theta, rate| HeavyTop::from_angles(top, theta, rate, 0.0, 0.0).err();
    let parameters = |a, b, c| ReducedTop::new(a, b, c).err();
    let body = |i1, i3, weight, lever| SymmetricTop::new(i1, i3, weight, lever).err();
    let nan = f64::NAN;
    let errors = [
        (parameters(nan, 0.5, 0.2), "a = NaN"),
        (parameters(-1.0, 0.5, 0.2), "a = -1"),
        (parameters(2.5, 0.5, 0.2), "I3 > 2 I1"),
        (parameters(1.0, f64::INFINITY, 0.2), "b = inf"),
        (parameters(1.0, 0.5, nan), "c = NaN"),
        (start(0.0, 0.1), "b = 1"),
        (start(-0.1, 0.1), "theta = -0.1"),
        (start(3.2, 0.1), "theta = 3.2"),
        (start(nan, 0.1), "theta = NaN"),
        (start(1.0, nan), "theta_rate0 = NaN"),
        (HeavyTop::from_energy(top, nan, Start::ThetaMin, 0.0, 0.0).err(), "energy = NaN"),
        (HeavyTop::from_energy(top, 1.0, Start::ThetaMin, nan, 0.0).err(), "phi0 = NaN"),
        (body(0.0, 1.0, 1.0, 1.0), "I1 = 0"),
        (body(1.0, -1.0, 1.0, 1.0), "I3 = -1"),
        (body(f64::INFINITY, 1.0, 1.0, 1.0), "I1 = inf"),
        (body(1.0, 2.1, 1.0, 0.0), "I3/I1 = 2.1"),
        (body(1.0, 2.0, 1.0, 0.1), "I3/I1 = 2"),
        (body(1.0, 1.0, -1.0, 0.1), "m g = -1"),
        (body(1.0, 1.0, 1.0, nan), "l = NaN"),
    ];
    for (error, part) in &errors {
        let text = error.as_ref().map(Error::to_string).unwrap_or_default();
        assert!(text.contains(part), "{part:?} is not in {text:?}");
    }
    assert_eq!(errors.len(), 19);
    assert!(SymmetricTop::new(1.0, 2.0, 1.0, 0.0).is_ok());
}

/// A generator of its own, so that the cases are the same everywhere.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Of either sign, from 10^-`decades` to 10^`decades`; sometimes 0 or 1.
    fn wild(&mut self, decades: f64) -> f64 {
        let sign = if self.unit() < 0.5 { -1.0 } else { 1.0 };
        let exponent = decades * (2.0 * self.unit() - 1.0);
        match self.unit() {
            u if u < 0.1 => 0.0,
            u if u < 0.2 => sign,
            _ => sign * rotation_dynamics::math::pow(10.0, exponent),
        }
    }
}

fn is_sound(motion: &HeavyTop) -> bool {
    [0.0, 1e-9, 0.7, -31.0, 1e6].into_iter().all(|t| {
        let angles = motion.angles(t);
        let Kinematics { attitude, angular_velocity: omega } = motion.kinematics(t);
        if let Err(error) = motion.try_kinematics(t) {
            // So fast that its phase is lost by then.
            let numbers = [angles.theta, angles.phi, omega.x(), motion.cos_theta(t)];
            return matches!(error, Error::PhaseLost { .. }) && numbers.iter().all(|x| x.is_nan());
        }
        let norm: f64 = attitude.quaternion().iter().map(|c| c * c).sum();
        (0.0..=core::f64::consts::PI).contains(&angles.theta)
            && angles.phi.is_finite()
            && angles.zeta.is_finite()
            && (norm - 1.0).abs() < 1e-14
            && omega.is_finite()
            && motion.theta_rate(t).is_finite()
            && motion.cos_theta(t).abs() <= 1.0
    })
}

/// Makes 6000 motions from numbers of +-`decades`; returns how many were made, how many
/// refused for their range. Whatever is made must answer with numbers.
fn tally(decades: f64) -> (usize, usize) {
    let mut random = Random(7);
    let (mut made, mut refused) = (0, 0);
    for i in 0..6000 {
        let a = (random.unit() * 2.0).max(1e-9);
        let (b, c) = (random.wild(decades), random.wild(decades));
        let theta = match random.unit() {
            u if u < 0.2 => 0.0,
            u if u < 0.3 => core::f64::consts::PI,
            u if u < 0.5 => random.wild(1.5 * decades).abs().min(3.0),
            _ => random.unit() * core::f64::consts::PI,
        };
        let (rate, spin) = (random.wild(decades), random.wild(decades));
        let top = ReducedTop::new(a, b, c).expect("a top");
        let motion = match i % 3 {
            0 => HeavyTop::from_angles(top, theta, rate, 0.1, 0.2),
            1 => {
                let start = [Start::ThetaMin, Start::ThetaMax][i / 3 % 2];
                let energy = top.minimum().1 + rate.abs();
                HeavyTop::from_energy(top, energy, start, 0.1, 0.2)
            }
            _ => SymmetricTop::new(1.0, a * 0.99, c.abs(), b).and_then(|body| {
                let attitude = EulerAngles { phi: 0.1, theta, zeta: 0.2 };
                let omega = BodyVector::new(rate, random.wild(decades), spin);
                HeavyTop::from_body(body, attitude, omega)
            }),
        };
        match motion {
            Ok(motion) => {
                made += 1;
                assert!(is_sound(&motion), "case {i}: {motion:?}");
            }
            Err(Error::OutOfRange { name: "theta0", .. }) => {}
            Err(Error::OutOfRange { name: "fastest rate", .. }) => refused += 1,
            Err(error) => panic!("case {i}: {error}"),
        }
    }
    (made, refused)
}

#[test]
fn no_motion_answers_with_nonsense() {
    let (made, refused) = tally(6.0);
    assert!(made > 5000 && refused == 0, "{made} {refused}");
}

/// Far beyond any top: either numbers or a refusal.
#[test]
fn two_hundred_decades_give_numbers_or_a_refusal() {
    let (made, refused) = tally(100.0);
    assert!(made > 4800 && refused > 0, "{made} {refused}");
}

/// Rates whose squares doubles do not hold were lost in silence: a body that turns was at rest.
#[test]
fn rates_that_would_be_lost_are_refused() {
    let mut refused = 0;
    for rate in [5e-324, 1e-310, 1e-200, 1e-160] {
        for weight in [0.0, 1e-300, 1.0] {
            let top = SymmetricTop::new(4.5, 3.02, weight, weight).expect("a top");
            let rates = BodyVector::new(rate, rate, 0.0);
            let made = HeavyTop::new(top, Attitude::IDENTITY, rates);
            assert!(
                matches!(made, Err(Error::OutOfRange { name: "fastest rate", .. })),
                "{rate} {weight}"
            );
            refused += 1;
        }
    }
    assert_eq!(refused, 12);
    // One a hundred decades below one is kept.
    let top = SymmetricTop::new(4.5, 3.02, 0.0, 0.0).expect("a top");
    let slow = HeavyTop::new(top, Attitude::IDENTITY, BodyVector::new(1e-100, 1e-100, 0.0));
    let momentum = slow.expect("slow").angular_momentum(0.0).to_array();
    assert!((momentum[0] / 4.5e-100 - 1.0).abs() < 4e-16, "{momentum:?}");
}

/// What the refusal says of the rates that are allowed is so: how far apart they are is no reason.
#[test]
fn rates_far_apart_whose_squares_are_doubles_are_taken() {
    let start = EulerAngles { phi: 0.1, theta: 1.0, zeta: 0.2 };
    let made = |fall: f64, rates: [f64; 3]| {
        let top = SymmetricTop::new(1.0, 0.6, fall, fall).expect("a top");
        HeavyTop::from_body(top, start, BodyVector::from_array(rates))
    };
    let mut taken = 0;
    for slow in [3e-146, 1e-100, 1e-20, 1e-3] {
        for fast in [1e3, 1e20, 3e102, 1e147] {
            for (fall, rates) in [
                (0.0, [slow, 0.0, fast]),
                (0.0, [fast, 0.0, slow]),
                (slow, [fast, 0.0, slow]),
                (fast, [slow, slow, 0.0]),
            ] {
                let motion = made(fall, rates).expect("a motion");
                let off = motion.angular_velocity(0.0) - BodyVector::from_array(rates);
                assert!(off.norm() <= 1e-14 * fast.max(fall), "{fall} {rates:?}");
                taken += 1;
            }
        }
    }
    assert_eq!(taken, 64);
    let refused = made(0.0, [1e150, 0.0, 1.0]).expect_err("its square is beyond 1e299");
    let text = refused.to_string();
    assert!(text.contains("must stay within doubles, from 1e-308 to 1e299"), "{text}");
}

/// U_min and the energy of a refusal are written short however large they are.
#[test]
fn a_refused_energy_is_written_short() {
    let mut said = Vec::new();
    for (b, c, energy) in
        [(1.2, 0.2, 0.1), (1e30, 0.2, -0.08), (1.2, 1e30, -1e40), (1e-30, 0.2, -5.0)]
    {
        let top = ReducedTop::new(2.0, b, c).expect("a top");
        let refused = HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0);
        said.push(refused.expect_err("no motion").to_string());
    }
    let expected = [
        "E~ = 0.1 is not allowed: no motion is below U_min = 0.404262",
        "E~ = -0.08 is not allowed: no motion is below U_min = 1.0000000000000001e60",
        "E~ = -1e40 is not allowed: no motion is below U_min = -1.999999999999997e30",
        "E~ = -5 is not allowed: no motion is below U_min = -0.209903",
    ];
    assert_eq!(said, expected);
    // The twin with six places.
    assert!(format!("{:.6}", 1e60).len() > 60);
}

/// Squares of its rates are the last that doubles hold, and what is multiplied by gravity is
/// small again: it would start 0.07 rad from where it is put.
#[test]
fn rates_whose_powers_come_back_are_refused() {
    let top = ReducedTop::formal(8.6e98, -5.5e103, 7.9e-87).expect("a top");
    let made = HeavyTop::from_angles(top, 1.1, 1.3e80, 0.1, 0.2);
    assert!(matches!(made, Err(Error::OutOfRange { name: "fastest rate", .. })), "{made:?}");
}
