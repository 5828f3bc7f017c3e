//! The methods that everyone writes first. Not for use: they are here to break.

use super::*;
use models::naive::{quarter_period, runge_kutta as path};
use rotation_dynamics::math::{atanh, tanh};

/// A plain method that everyone writes first, and its error on a motion whose true end is known.
pub type Plain = (&'static str, fn(&Motion, Attitude) -> Solved<f64>);

/// Plain methods, one an entry: its constant, its name, and its error on a motion.
macro_rules! plain {
    ($( $(#[$doc:meta])* $name:ident: $method:literal, |$m:pat_param, $truth:pat_param| $error:expr; )+) => {
        $( $(#[$doc])* pub const $name: Plain = ($method, |$m, $truth| Ok($error)); )+
    };
}

/// How far from the truth an end is (rad); NaN for none.
fn off(truth: Attitude, end: Option<Attitude>) -> f64 {
    end.map_or(f64::NAN, |end| truth.angle_to(&end))
}

plain! {
    ANGLES: "RK4 on Euler angles, 20 000 steps", |m, truth| off(truth, on_euler_angles(m, 20_000));
    FEWER: "RK4 on Euler angles, 2000 steps", |m, truth| off(truth, on_euler_angles(m, 2000));
    /// With 1/cos(pitch) in their rates.
    YAW: "RK4 on yaw, pitch, roll, 20 000 steps", |m, truth| {
        let YawPitchRoll { yaw, pitch, roll } = m.attitude.yaw_pitch_roll();
        let [p, q, r] = m.rates;
        let slope = |&[_, pitch, roll, p, q, r]: &[f64; 6]| {
            let ((s, c), (sr, cr)) = (sincos(pitch), sincos(roll));
            let turn = (q * sr + r * cr) / c;
            let [a, b, d] = rates_of(m, [p, q, r], [-s, c * sr]);
            [turn, q * cr - r * sr, p + turn * s, a, b, d]
        };
        let end = path(slope, [yaw, pitch, roll, p, q, r], m.end, 20_000).last();
        off(truth, end.and_then(|[yaw, pitch, roll, ..]|
            Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll }).ok()))
    };
    FLIPS_BY_RK4: "RK4 on quaternion and rates, 100 steps a flip", |m, truth| off(truth, on_quaternion(m, 1_000_050));
    FROM_MOMENTUM: "RK4 on the quaternion, rates from L, 5000 steps",
        |m, truth| off(truth, path_by_momentum(m, 5000).ok().and_then(|path| Some(path.last()?.0)));
    /// In steps of a hundredth of the time in which the rates change by their own size; none, and there is no end.
    FIRST_STEP: "RK4, steps of 0.01 |omega|/|omega'|", |m, truth| {
        let step = 0.01 * size(m.rates) / size(rates_of(m, m.rates, [0.0; 2]));
        off(truth, (step > 0.0).then(|| on_quaternion(m, (m.end / step).ceil() as u32)).flatten())
    };
    /// Their size as it is squared and summed; then the angle |omega| t.
    AXIS: "axis by omega/|omega|", |m, truth| {
        let size = size(m.rates);
        let (sin, cos) = sincos(0.5 * size * m.end);
        let [x, y, z] = m.rates.map(|rate| sin * rate / size);
        off(truth, Attitude::from_quaternion([cos, x, y, z]).ok().map(|turn| m.attitude * turn))
    };
    ONE_STEP: "one step of 1e-6 s at most, axis by omega/|omega|", |m, truth| AXIS.1(m, truth)?;
    JITTER: "a moment changed by 1e-9, so that nothing is 0/0", |m, truth| {
        let mut other = *m;
        other.moments[0] *= 1.0 + 1e-9;
        off(truth, other.truth().ok())
    };
    /// 1e-30 kg m^2 to each moment before it divides the momentum.
    GUARDED: "1e-30 added, so that nothing is divided by zero", |m, truth| {
        let mut other = *m;
        for i in 0..3 {
            other.moments[i] += 1e-30;
            other.rates[i] *= m.moments[i] / other.moments[i];
        }
        off(truth, other.truth().ok())
    };
    ASLEEP: "at rest below 1e-4 rad/s",
        |m, truth| off(truth, Some(if m.rates.iter().all(|w| w.abs() < 1e-4) { m.attitude } else { truth }));
    ARC_COSINE: "tilt by the arc cosine", |_, truth| off(truth, by_arc_cosine(truth));
    TRIANGLE: "triangle inequality to the last bit",
        |m, truth| off(truth, (m.moments[2] <= m.moments[0] + m.moments[1]).then_some(truth));
    TRACE: "quaternion from the trace of the matrix", |m, _| by_trace(m.attitude);
    /// The tilt, with the sign of the start at all times: at a turning point the root is zero, and the motion stays.
    ENERGY: "theta' = sqrt(2 (E - U)), stepped", |m, truth| {
        let ([i1, _, i3], [p, q, r], pull) = (m.moments, m.rates, pull(m));
        let EulerAngles { theta, zeta, .. } = m.attitude.euler_angles();
        let ((s, c), (sz, cz)) = (sincos(theta), sincos(zeta));
        let (along, across, own) = (p * cz - q * sz, p * sz + q * cz, i3 * r);
        let vertical = i1 * across * s + own * c;
        let energy = 0.5 * i1 * (along * along + across * across) + pull * c;
        let sign = if along < 0.0 { -1.0 } else { 1.0 };
        let slope = |&[theta]: &[f64; 1]| {
            let (s, c) = sincos(theta);
            let turn = (vertical - own * c) / (i1 * s);
            [sign * (2.0 * (energy - pull * c) / i1 - turn * turn).max(0.0).sqrt()]
        };
        let end = path(slope, [theta], m.end, 10_000).last().map_or(f64::NAN, |[theta]| theta);
        (end - truth.euler_angles().theta).abs()
    };
    LANDAU: "Jacobi's functions with 1 - k^2 by subtraction", |m, _| momentum_off(m, rates_by_landau(m));
    /// The same, as the sum of the errors of the rates.
    LANDAU_RATES: "Jacobi's functions with 1 - k^2 by subtraction", |m, _| rates_off(m).iter().sum::<f64>().abs();
    /// For a body whose L^2 is no double: Landau's k^2 is made of it.
    SQUARES: "k^2 from L^2 and 2 E", |m, _| rates_off(m).iter().map(|off| off.abs()).sum();
    /// sn at k = 1 by the descent of the arithmetic-geometric mean, which has no bottom there, less
    /// the hyperbolic tangent that it is.
    MEAN: "Jacobi's functions by the arithmetic-geometric mean", |m, _| {
        let [largest, grown] = middle(m);
        let phase = atanh(m.rates[1] / largest) + grown;
        (jacobi(phase, 1.0)[0] - tanh(phase)).abs()
    };
    /// Where cn is negative the phase is counted back from half a period, 2K - u: of K = ln(4/k')
    /// with k' = 0 nothing is left to count.
    BACK: "the phase counted back from half a period", |m, _| {
        let ([p, q, r], [i1, i2, i3], [largest, grown]) = (m.rates, m.moments, middle(m));
        let complement = 1.0 - (i3 * (i3 - i2) * r * r) / (i1 * (i2 - i1) * p * p);
        let half = 2.0 * log(4.0 / complement.sqrt());
        let phase = half - atanh(-q / largest) + grown;
        (largest * tanh(half - phase) - m.true_rates()[1]).abs()
    };
    /// The distance of the quaternions at the end, of this start and of its antipode.
    COMPARED: "attitudes compared by their quaternions' difference", |m, truth| {
        let half = Motion { attitude: rotations::half_turn(0.0)?, ..*m };
        let [[a, b, c, d], [e, f, g, h]] = [truth, half.truth()?].map(|a| a.quaternion());
        2.0 * hypot(hypot(a - e, b - f), hypot(c - g, d - h))
    };
    /// The closed form, with whole periods dropped.
    MODULO: "t modulo the period, in doubles", |m, truth| {
        let exact = m.free_body()?;
        let period = exact.rate_period();
        let (count, rest) = ((m.end / period).floor(), m.end % period);
        let phase = (count * exact.precession_per_period()) % TAU;
        let turn = Attitude::about_space_axis(exact.angular_momentum(), phase)?;
        truth.angle_to(&(turn * exact.attitude(rest)))
    };
    /// Nobody asks whether it can be right.
    BELIEVED: "one run of DOP853 at 1e-15, believed", |m, truth| off(truth, m.reached(How::Dop853, QUATERNION, 0.0).ok());
    COARSE: "RK4 on quaternion and rates, 100 steps", |m, truth| off(truth, on_quaternion(m, 100));
}

fn rates_off(motion: &Motion) -> [f64; 3] {
    let (naive, truth) = (rates_by_landau(motion), motion.true_rates());
    [0, 1, 2].map(|i| naive[i] - truth[i])
}

/// The angle between the angular momentum on the body's axes with these rates and the true one.
pub fn momentum_off(motion: &Motion, rates: [f64; 3]) -> f64 {
    let [one, truth] = [rates, motion.true_rates()].map(|rates| motion.momentum(rates));
    atan2(one.cross(&truth).norm(), one.dot(&truth))
}

/// The largest middle rate on the separatrix, and by how much the phase grows until the end.
fn middle(motion: &Motion) -> [f64; 2] {
    let ([p, q, r], [i1, i2, i3]) = (motion.rates, motion.moments);
    let largest = ((i1 * p * p + i2 * q * q + i3 * r * r) / i2).sqrt();
    [largest, largest * motion.end / 3.0]
}

fn size([a, b, c]: [f64; 3]) -> f64 {
    (a * a + b * b + c * c).sqrt()
}

/// The rate of a quaternion.
fn turning([w, x, y, z]: [f64; 4], [p, q, r]: [f64; 3]) -> [f64; 4] {
    [
        0.5 * (-x * p - y * q - z * r),
        0.5 * (w * p + y * r - z * q),
        0.5 * (w * q + z * p - x * r),
        0.5 * (w * r + x * q - y * p),
    ]
}

fn pull(motion: &Motion) -> f64 {
    motion.gravity[0] * motion.gravity[1]
}

/// Euler's equations, with the torque of a weight on the third axis.
fn rates_of(motion: &Motion, [p, q, r]: [f64; 3], [g1, g2]: [f64; 2]) -> [f64; 3] {
    let ([i1, i2, i3], pull) = (motion.moments, pull(motion));
    [
        ((i2 - i3) * q * r + pull * g2) / i1,
        ((i3 - i1) * r * p - pull * g1) / i2,
        (i1 - i2) * p * q / i3,
    ]
}

/// RK4 on the Euler angles of the notes and the body's rates, with 1/sin(theta) in them.
fn on_euler_angles(motion: &Motion, count: u32) -> Option<Attitude> {
    let EulerAngles { phi, theta, zeta } = motion.attitude.euler_angles();
    let [p, q, r] = motion.rates;
    let slope = |&[_, theta, zeta, p, q, r]: &[f64; 6]| {
        let ((s, c), (sz, cz)) = (sincos(theta), sincos(zeta));
        let turn = (p * sz + q * cz) / s;
        let [a, b, d] = rates_of(motion, [p, q, r], [s * sz, s * cz]);
        [turn, p * cz - q * sz, r - turn * c, a, b, d]
    };
    let path = path(slope, [phi, theta, zeta, p, q, r], motion.end, count);
    let [phi, theta, zeta, ..] = path.last()?;
    turned(phi, theta, zeta).ok()
}

/// RK4 on the quaternion and the body's rates, with nothing kept.
fn on_quaternion(motion: &Motion, count: u32) -> Option<Attitude> {
    let ([w, x, y, z], [p, q, r]) = (motion.attitude.quaternion(), motion.rates);
    let slope = |&[w, x, y, z, p, q, r]: &[f64; 7]| {
        let vertical = [2.0 * (x * z - w * y), 2.0 * (y * z + w * x)];
        let [a, b, c] = rates_of(motion, [p, q, r], vertical);
        let [w, x, y, z] = turning([w, x, y, z], [p, q, r]);
        [w, x, y, z, a, b, c]
    };
    let [w, x, y, z, ..] = path(slope, [w, x, y, z, p, q, r], motion.end, count).last()?;
    Attitude::from_quaternion([w, x, y, z]).ok()
}

/// RK4 on the quaternion alone, the rates from L, which stays in space: the attitude at the
/// start and after each step, with the rate about the middle axis.
pub fn path_by_momentum(motion: &Motion, count: u32) -> Solved<Vec<(Attitude, f64)>> {
    let momentum = motion.attitude.to_space(motion.momentum(motion.rates));
    let rates = |attitude: Attitude| {
        let momentum = attitude.to_body(momentum).to_array();
        [0, 1, 2].map(|i| momentum[i] / motion.moments[i])
    };
    let read = |q: &[f64; 4]| Attitude::from_quaternion(*q);
    let slope = |q: &[f64; 4]| turning(*q, rates(read(q).unwrap_or(motion.attitude)));
    let path = path(slope, motion.attitude.quaternion(), motion.end, count);
    path.map(|q| read(&q).map(|attitude| (attitude, rates(attitude)[1]))).collect()
}

/// The tilt by the arc cosine of the axis's height, the others by arc tangents of elements of
/// the matrix: the formulas of every textbook.
pub fn by_arc_cosine(attitude: Attitude) -> Option<Attitude> {
    let m = attitude.matrix();
    let (phi, zeta) = (atan2(m[0][2], -m[1][2]), atan2(m[2][0], m[2][1]));
    turned(phi, acos(m[2][2].clamp(-1.0, 1.0)), zeta).ok()
}

/// The error of a quaternion divided by its scalar part, which is from the trace of the matrix.
pub fn by_trace(attitude: Attitude) -> f64 {
    let m = attitude.matrix();
    let w = 0.5 * (1.0 + m[0][0] + m[1][1] + m[2][2]).max(0.0).sqrt();
    let [x, y, z] = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| (m[i][j] - m[j][i]) / (4.0 * w));
    let naive = Attitude::from_quaternion([w, x, y, z]);
    naive.map_or(f64::NAN, |naive| naive.angle_to(&attitude))
}

/// sn, cn and dn of the parameter m, with 1 - m formed by subtraction.
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut c) = ([1.0; 32], [0.0; 32]);
    let (mut b, mut n) = ((1.0 - m).max(0.0).sqrt(), 0);
    c[0] = m.sqrt();
    while n < 30 && c[n].abs() > 1e-16 {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = (a[n] * b).sqrt();
        n += 1;
    }
    let mut phi = a[n] * u * f64::from(1_u32 << n);
    for k in (1..=n).rev() {
        phi = 0.5 * (phi + asin((c[k] / a[k] * sin(phi)).clamp(-1.0, 1.0)));
    }
    let (sn, cn) = sincos(phi);
    [sn, cn, (1.0 - m * sn * sn).max(0.0).sqrt()]
}

/// Landau's formulas for the rates of a body that starts on the middle axis, all differences
/// of moments and energies as printed there. In rising order of the moments.
pub fn rates_by_landau(motion: &Motion) -> [f64; 3] {
    let ([p, q, r], [i1, i2, i3]) = (motion.rates, motion.moments);
    let twice = i1 * p * p + i2 * q * q + i3 * r * r;
    let square = i1 * i1 * p * p + i2 * i2 * q * q + i3 * i3 * r * r;
    let k2 = (i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1));
    let rate = ((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3)).sqrt();
    let largest = [
        (twice * i3 - square) / (i1 * (i3 - i1)),
        (twice * i3 - square) / (i2 * (i3 - i2)),
        (square - twice * i1) / (i3 * (i3 - i1)),
    ];
    // At the turning point of the middle rate a quarter of a period has passed.
    let functions = jacobi(rate * motion.end + quarter_period((1.0 - k2).max(0.0)), k2);
    [(0, 1), (1, 0), (2, 2)].map(|(i, f)| largest[i].max(0.0).sqrt() * functions[f])
}
