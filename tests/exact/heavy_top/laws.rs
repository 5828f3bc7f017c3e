//! What every motion keeps, and how its queries belong together.

use super::motions::all;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::EPS;
use support::{Errors, assert_largest};

const TIMES: [f64; 9] = [0.0, 0.013, 0.4, 1.0, -3.7, 17.0, 260.1, -1e4, 1e7];

/// Adds the changes of L_Z, L_z and the energy over the times, relative to the momenta and
/// energies at play; `damage` multiplies the transverse rates.
fn drift(motion: &HeavyTop, damage: f64, drifts: &mut Errors) {
    let (vertical, axial) = motion.momenta();
    let energy = motion.energy();
    let (i1, i3, moment) = match (motion.body(), motion.reduced()) {
        (Some(body), _) => (body.i1(), body.i3(), body.weight() * body.lever()),
        (None, Some(top)) => (1.0, top.a(), top.c()),
        (None, None) => unreachable!("a motion has a body or parameters"),
    };
    for t in TIMES {
        let Kinematics { attitude, angular_velocity: omega } = motion.kinematics(t);
        let (x, y) = (omega.x() * damage, omega.y() * damage);
        let momentum = BodyVector::new(i1 * x, i1 * y, i3 * omega.z());
        let size = momentum.norm() + i1 * (moment.abs() / i1).sqrt();
        let kinetic = 0.5 * (i1 * (x * x + y * y) + i3 * omega.z() * omega.z());
        let potential = moment * attitude.axis().z();
        drifts.add(attitude.to_space(momentum).z(), vertical, size);
        drifts.add(momentum.z(), axial, size);
        drifts.add(kinetic + potential, energy, kinetic + 2.0 * moment.abs());
    }
}

/// The motion's drifts by themselves.
fn drifts(motion: &HeavyTop, damage: f64) -> Errors {
    let mut drifts = Errors::in_units_of(EPS, "L_Z, L_z and energy");
    drift(motion, damage, &mut drifts);
    drifts
}

#[test]
fn momenta_and_energy_are_kept() {
    let mut drifts = Errors::in_units_of(EPS, "L_Z, L_z and energy");
    for motion in all() {
        drift(&motion, 1.0, &mut drifts);
    }
    // Over times up to 1e7.
    assert_largest!(drifts, 26 * 9 * 3, @"4.84");
}

#[test]
fn a_damaged_rate_breaks_the_laws() {
    let seen = all().iter().filter(|m| drifts(m, 1.0 + 1e-13).largest() > 4.9).count();
    // All but those without a transverse rate (sleeping, at rest).
    assert_eq!(seen, 24);
}

/// 2 conj(q) dq/dt by a central difference of order 8.
fn rate_by_difference(motion: &HeavyTop, t: f64, h: f64) -> [f64; 3] {
    let here = motion.attitude(t).inverse();
    // Vector part of conj(q(t)) q(t + kh) - conj(q(t)) q(t - kh): the signs of the
    // quaternions are free.
    let relative = |k: f64| {
        let [w, x, y, z] = (here * motion.attitude(t + k * h)).quaternion();
        [x, y, z].map(|v| v.copysign(v * w))
    };
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut rate = [0.0; 3];
    for (i, weight) in weights.into_iter().enumerate() {
        let k = (i + 1) as f64;
        let (ahead, behind) = (relative(k), relative(-k));
        for j in 0..3 {
            rate[j] += 2.0 * weight / h * (ahead[j] - behind[j]);
        }
    }
    rate
}

#[test]
fn the_attitude_turns_at_the_angular_velocity() {
    let mut errors = Errors::of("rate of the attitude");
    let mut compared = 0;
    for (i, motion) in all().iter().enumerate() {
        for t in [0.0, 0.4, -3.7, 17.0] {
            let omega = motion.angular_velocity(t);
            let speed = omega.norm().max(1.0);
            let h = 0.02 / speed;
            let rate = BodyVector::from_array(rate_by_difference(motion, t, h));
            errors.push_at((rate - omega).norm() / speed, (i, t));
            // The other frame is another vector.
            let space: Attitude = motion.attitude(t);
            let turned = space.to_space(rate).to_array();
            let apart = (BodyVector::from_array(turned) - omega).norm() / speed;
            if apart > 1e-3 {
                compared += 1;
            }
        }
    }
    // Rounding over h.
    assert_largest!(errors, 4 * 26, @"6.94e-13");
    assert!(compared > 60, "{compared}");
}

#[test]
fn the_angles_change_at_their_rates() {
    let mut errors = Errors::of("rates of the angles");
    for (i, motion) in all().iter().enumerate().filter(|(_, m)| !m.passes_pole()) {
        for t in [0.0, 0.4, -3.7, 17.0] {
            let omega = motion.angular_velocity(t).norm().max(1.0);
            let h = 0.006 / omega;
            let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
            let (mut phi, mut theta, mut zeta) = (0.0, 0.0, 0.0);
            for (k, weight) in weights.into_iter().enumerate() {
                let step = (k + 1) as f64 * h;
                let (ahead, behind) = (motion.angles(t + step), motion.angles(t - step));
                phi += weight / h * (ahead.phi - behind.phi);
                theta += weight / h * (ahead.theta - behind.theta);
                zeta += weight / h * (ahead.zeta - behind.zeta);
            }
            let sin = rotation_dynamics::math::sin(motion.angles(t).theta);
            for error in
                [phi - motion.phi_rate(t), theta - motion.theta_rate(t), zeta - motion.zeta_rate(t)]
            {
                errors.push_at(error * sin * sin / omega, (i, t));
            }
        }
    }
    assert_largest!(errors, 168, @"1.96e-12");
}

/// Attitude, angles, axis and cos(theta) are one and the same.
#[test]
fn the_queries_agree() {
    let mut turns = Errors::in_units_of(EPS, "attitude of the angles");
    let mut cosines = Errors::in_units_of(EPS, "cos theta");
    for (i, motion) in all().iter().enumerate() {
        for t in TIMES {
            let attitude = motion.attitude(t);
            let angles = motion.angles(t);
            let apart = Attitude::from_euler(angles).expect("finite").angle_to(&attitude);
            // Angles of many turns are rounded in their last place.
            let size = 8.0 + 2.0 * (angles.phi.abs() + angles.zeta.abs());
            turns.push_at(apart / size, (i, t));
            cosines.push_at(motion.cos_theta(t) - attitude.axis().z(), (i, t));
            assert!((0.0..=core::f64::consts::PI).contains(&angles.theta));
            let (lowest, highest) = (motion.theta_min(), motion.theta_max());
            assert!(angles.theta >= lowest * (1.0 - 4.0 * EPS) - 1e-300);
            assert!(angles.theta <= highest * (1.0 + 4.0 * EPS));
        }
    }
    assert_largest!(turns, 9 * 26, @"0.544");
    // The quaternion is squared.
    assert_largest!(cosines, 9 * 26, @"5");
}
