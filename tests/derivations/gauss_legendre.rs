//! The page `how_gauss_legendre`: the spin taken out, the phase of a step, what a sweep leaves,
//! what keeps quadratic invariants, and the attitude of a free body by quadrature.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::LaneByLane;
use rotation_dynamics::integrators::gauss_legendre::coefficients::{
    CONTINUATION, NODES, STAGES, STAGES_REST, WEIGHTS, WEIGHTS_REST,
};
use rotation_dynamics::integrators::{GaussLegendre, Integrator, ode, size_or};
use rotation_dynamics::math::double_double::two_sum;
use rotation_dynamics::math::{DoubleDouble as Dd, EPS, atan2, sincos};
use support::{Errors, assert_error, assert_largest, derivative};

#[test]
fn the_rest_turns_with_the_momentum_alone() {
    // S = R exp(-Omega_S t e3) of heavy tops: S' = (0, L/I1) S/2.
    let errors = |damage: f64| {
        let mut errors = Errors::of("S' less (0, L/I1) S/2");
        for (i3, spin) in [(0.4, 3.0), (0.4, 30.0), (1.7, -6.0)] {
            let body = SymmetricTop::new(1.0, i3, 2.0, 1.0).expect("a top");
            let start = EulerAngles { phi: 0.1, theta: 0.8, zeta: 0.2 };
            let omega = BodyVector::new(0.3, -0.2, spin);
            let motion = HeavyTop::from_body(body, start, omega).expect("a motion");
            let rate = damage * spin * (1.0 - i3);
            let without = |t: f64| -> [f64; 4] {
                let [w, x, y, z] = motion.attitude(t).quaternion();
                let (s, c) = sincos(-0.5 * rate * t);
                [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
            };
            for k in 1..20 {
                let t = 0.13 * f64::from(k);
                let [w, x, y, z] = without(t);
                let [p, q, r] = (motion.angular_momentum(t) * 0.5).to_array();
                let want = [
                    -(p * x + q * y + r * z),
                    p * w + q * z - r * y,
                    q * w + r * x - p * z,
                    r * w + p * y - q * x,
                ];
                let mut off = 0.0;
                for (i, want) in want.into_iter().enumerate() {
                    let slope = derivative(|t| without(t)[i], t, 1e-3);
                    off += (slope - want).abs();
                }
                errors.push_at(off, (i3, spin, k));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 3 * 19, @"4.76e-10");
    errors(1.001).exceed(1e-4, 3 * 19);
}

/// The phase that a step of Gauss's method with eight stages adds for an angle: twice the
/// argument of Pade's numerator.
fn phase(angle: f64) -> Dd {
    let (mut re, mut im) = (Dd::ZERO, Dd::ZERO);
    let mut coefficient = Dd::ONE;
    let mut power = Dd::ONE;
    for k in 0..=8 {
        let sign = if k % 4 < 2 { 1.0 } else { -1.0 };
        let term = coefficient * power * sign;
        if k % 2 == 0 {
            re += term;
        } else {
            im += term;
        }
        let k = f64::from(k);
        coefficient = coefficient * (8.0 - k) / ((16.0 - k) * (k + 1.0));
        power = power * angle;
    }
    im.atan2(re) * 2.0
}

#[test]
fn phase_of_a_step_is_pades() {
    let turning = LaneByLane(ode(|_, &[x, y]: &[f64; 2]| [-y, x]).scaled(size_or([1.0; 2])));
    let mut errors = Errors::of("phase of a step");
    let mut leading = Errors::of("first term of what it lacks, relative");
    let mut damaged = Errors::of("the same with another constant");
    // (8!)^2/(16! 17!).
    let constant = (1..=8).fold(1.0, |product, k| product * f64::from(k) / f64::from(8 + k))
        / (1..=17).fold(1.0, |product, k| product * f64::from(k));
    for angle in [0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0] {
        let method = GaussLegendre::new(1).expect("a step");
        let end: [f64; 2] =
            method.advance(&turning, 0.0, &[1.0, 0.0], angle).expect("it converges").0;
        let found = atan2(end[1], end[0]);
        let turns = ((phase(angle).to_f64() - found) / core::f64::consts::TAU).round();
        errors.push_at(phase(angle).to_f64() - found - turns * core::f64::consts::TAU, angle);
    }
    for angle in [0.5, 0.7, 1.0_f64] {
        // angle^17 is below 2^-53; by pairs it is seen.
        let lacks = (Dd::from(angle) - phase(angle)).to_f64();
        let first = |constant: f64| constant * angle.powi(17);
        leading.push_at(lacks / first(constant) - 1.0, angle);
        damaged.push_at(lacks / first(1.1 * constant) - 1.0, angle);
    }
    assert_largest!(errors, 7, @"4.44e-15");
    assert_largest!(leading, 3, @"0.0148");
    damaged.exceed(0.05, 3);
}

#[test]
fn a_sweep_integrates_once_more() {
    // A^k 1 = c^k/k! up to k = 8: what sweep k leaves of a linear problem.
    let errors = |damage: f64| {
        let mut errors = Errors::of("powers of the stages");
        let mut powers = [1.0; 8];
        let (mut want, mut size) = ([1.0; 8], 1.0);
        for k in 1..=8 {
            size /= f64::from(k);
            powers =
                core::array::from_fn(|i| (0..8).map(|j| STAGES[j][i] * powers[j] * damage).sum());
            want = core::array::from_fn(|i| want[i] * NODES[i] / f64::from(k));
            for i in 0..8 {
                errors.push_at((powers[i] - want[i]) / size, (k, i));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 64, @"1.67e-16");
    assert!(errors(1.0 + 1e-6).largest() > 1e-7);
}

#[test]
fn what_is_quadratic_is_kept() {
    // y' C y after a step less before it: 2 h sum b_i Y_i C f_i - h^2 sum M_ij f_i C f_j, for any
    // slopes f, of which the first sum vanishes for an invariant and M for the method.
    let f = |i: usize| [0.3 + 0.1 * i as f64, 1.0 / (1.0 + i as f64), 0.2 * i as f64];
    let c = |a: [f64; 3], b: [f64; 3]| 1.5 * a[0] * b[0] - a[1] * b[1] + 0.7 * a[2] * b[2];
    let (start, h) = ([0.4, -0.3, 0.9], 0.7);
    let errors = |damage: f64| {
        let plus = |weight: &dyn Fn(usize) -> f64| -> [f64; 3] {
            core::array::from_fn(|n| {
                start[n] + h * (0..8).map(|j| weight(j) * f(j)[n]).sum::<f64>()
            })
        };
        let end = plus(&|j| WEIGHTS[j]);
        let mut change = c(end, end) - c(start, start);
        for i in 0..8 {
            let stage = plus(&|j| STAGES[j][i]);
            change -= damage * 2.0 * h * WEIGHTS[i] * c(stage, f(i));
        }
        let mut errors = Errors::of("the change of a quadratic form");
        errors.push(change);
        errors
    };
    assert_largest!(errors(1.0), 1, @"3.61e-16");
    errors(1.01).exceed(1e-3, 1);
}

/// The shortest rotation from one direction to another.
fn shortest(from: [f64; 3], to: [f64; 3]) -> Attitude {
    let ([a, b, c], [d, e, f]) = (from, to);
    Attitude::from_quaternion([
        1.0 + a * d + b * e + c * f,
        b * f - c * e,
        c * d - a * f,
        a * e - b * d,
    ])
    .expect("not opposite")
}

#[test]
fn attitude_of_a_free_body_is_a_quadrature() {
    let errors = |damage: f64| {
        let mut errors = Errors::of("attitude over a step, in rad");
        for moments in [[1.0, 2.0, 2.5], [1.0, 1.0, 1.4], [1.0, 1.3, 0.5]] {
            let [i1, i2, i3] = moments;
            let moments = PrincipalMoments::new(i1, i2, i3).expect("a body");
            let rates = BodyVector::new(0.8, 0.4, 0.6);
            let motion = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion");
            let direction = |t: f64| -> ([f64; 3], [f64; 3]) {
                let omega = motion.angular_velocity(t);
                let own = motion.body_momentum(omega);
                ((own / own.norm()).to_array(), omega.to_array())
            };
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            for h in [0.3, 0.7, 1.1] {
                let (u, _) = direction(0.5 * h);
                let mut angle = 0.0;
                for (node, weight) in NODES.iter().zip(WEIGHTS) {
                    let (n, omega) = direction(node * h);
                    let both = core::array::from_fn(|i| n[i] + damage * u[i]);
                    angle += h * weight * dot(omega, both) / (1.0 + damage * dot(n, u));
                }
                let (from, to) = (direction(0.0).0, direction(h).0);
                let about = Attitude::about_space_axis(SpaceVector::from_array(u), angle);
                let turn = shortest(from, u).inverse() * about.expect("finite") * shortest(to, u);
                errors.push_at(turn.angle_to(&motion.attitude(h)), (i2, h));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 9, @"5.46e-16");
    errors(1.1).exceed(1e-7, 9);
}

/// What the energy of a tumbling body has drifted by after so many steps of half a second, with
/// sweeps that end when what is missing is `precision` or less, or nothing is gained any more; and
/// the sweeps a step.
fn drift(steps: u32, precision: f64) -> (f64, f64) {
    let inverse = [1.0, 1.0 / 1.3, 1.0 / 1.7];
    let slope = |l: [f64; 3]| -> [f64; 3] {
        let w: [f64; 3] = core::array::from_fn(|i| inverse[i] * l[i]);
        [l[1] * w[2] - l[2] * w[1], l[2] * w[0] - l[0] * w[2], l[0] * w[1] - l[1] * w[0]]
    };
    let energy = |l: [f64; 3]| -> Dd {
        (0..3).fold(Dd::ZERO, |sum, i| sum + Dd::product(l[i], l[i]) * inverse[i])
    };
    let (mut y, mut carry) = ([0.5, 0.2 * 1.3, 1.7], [0.0; 3]);
    let (before, h) = (energy(y), 0.5);
    let combined = |columns: &[[f64; 8]; 8], f: &[[f64; 3]; 8], i: usize, n: usize| -> f64 {
        (0..8).map(|j| columns[j][i] * f[j][n]).sum()
    };
    let mut f = [slope(y); 8];
    let mut sweeps = 0;
    for step in 0..steps {
        if step > 0 {
            f = core::array::from_fn(|i| {
                core::array::from_fn(|n| combined(&CONTINUATION, &f, i, n))
            });
        }
        let rest: [[f64; 3]; 8] = core::array::from_fn(|i| {
            core::array::from_fn(|n| carry[n] + h * combined(&STAGES_REST, &f, i, n))
        });
        let mut last = f64::INFINITY;
        loop {
            sweeps += 1;
            let new: [[f64; 3]; 8] = core::array::from_fn(|i| {
                slope(core::array::from_fn(|n| {
                    y[n] + (h * combined(&STAGES, &f, i, n) + rest[i][n])
                }))
            });
            let change =
                (0..24).map(|k| (new[k % 8][k / 8] - f[k % 8][k / 8]).abs() * h).sum::<f64>();
            f = new;
            let missing = if last.is_finite() { (change / last).min(1.0) * change } else { change };
            if missing <= precision || (change >= last && change <= 1e-12) {
                break;
            }
            last = change;
        }
        for n in 0..3 {
            let sum = |weights: &[f64; 8]| -> f64 {
                (1..8).map(|j| weights[j] * (f[j][n] - f[0][n])).sum()
            };
            let mean = sum(&WEIGHTS_REST) + sum(&WEIGHTS);
            let (more, lost) = two_sum(h * (f[0][n] + mean), carry[n]);
            let (sum, left) = two_sum(y[n], more);
            (y[n], carry[n]) = (sum, left + lost);
        }
    }
    let off = (energy(y) / before - 1.0).to_f64();
    (off.abs(), f64::from(sweeps) / f64::from(steps))
}

#[test]
fn sweeps_that_end_early_leave_a_drift() {
    // Half an eps by what is missing, as the library ends them, and until nothing is gained.
    let (early, fewer) = drift(100_000, 0.5 * EPS);
    let (late, more) = drift(100_000, -1.0);
    assert_error!(early, 9.7e-15);
    assert_error!(late, 2.1e-15);
    assert_error!(more / fewer, 1.38);
    // In proportion to the steps.
    let (half, _) = drift(50_000, 0.5 * EPS);
    assert_error!(half / early, 0.5);
}
