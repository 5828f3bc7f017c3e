//! The methods that everyone writes first. Not for use: they are here to break.

use super::motions::Plain;
use super::rotations::{FLIPS_STEPS, POLE_STEPS, half_turn, momentum_off};
use super::*;
use rotation_dynamics::math::{atanh, sort_by_number, tanh};

/// Plain methods: a name, what each is called, and its error on a motion.
macro_rules! plain {
    ($( $(#[$doc:meta])* $name:ident: $method:literal, |$motion:ident| $error:expr; )+) => {
        $( $(#[$doc])* pub const $name: Plain = ($method, |$motion| Ok($error)); )+
    };
}

plain! {
    ANGLES: "RK4 on Euler angles, 20 000 steps", |m| m.off(on_euler_angles(m, POLE_STEPS));
    FEWER: "RK4 on Euler angles, 2000 steps", |m| m.off(on_euler_angles(m, 2000));
    YAW: "RK4 on yaw, pitch, roll, 20 000 steps", |m| m.off(on_yaw_pitch_roll(m, POLE_STEPS));
    FLIPS_BY_RK4: "RK4 on quaternion and rates, 100 steps a flip", |m| m.off(on_quaternion(m, FLIPS_STEPS));
    FROM_MOMENTUM: "RK4 on the quaternion, rates from L, 5000 steps", |m| m.off(by_momentum(m, 5000));
    FIRST_STEP: "RK4, steps of 0.01 |omega|/|omega'|", |m| m.off(by_first_step(m));
    AXIS: "axis by omega/|omega|", |m| m.off(by_axis(m));
    ONE_STEP: "one step of 1e-6 s at most, axis by omega/|omega|", |m| m.off(by_axis(m));
    JITTER: "a moment changed by 1e-9, so that nothing is 0/0", |m| m.off(jittered(m));
    GUARDED: "1e-30 added, so that nothing is divided by zero", |m| m.off(guarded(m));
    ASLEEP: "at rest below 1e-4 rad/s", |m| m.off(asleep(m, 1e-4));
    ARC_COSINE: "tilt by the arc cosine", |m| m.off(by_arc_cosine(m.truth()?));
    TRIANGLE: "triangle inequality to the last bit",
        |m| m.off((m.moments[2] <= m.moments[0] + m.moments[1]).then(|| m.truth()).transpose()?);
    TRACE: "quaternion from the trace of the matrix",
        |m| by_trace(m.attitude).map_or(f64::NAN, |naive| naive.angle_to(&m.attitude));
    ENERGY: "theta' = sqrt(2 (E - U)), stepped",
        |m| (tilt_by_energy(m, 10_000) - m.truth()?.euler_angles().theta).abs();
    LANDAU: "Jacobi's functions with 1 - k^2 by subtraction",
        |m| momentum_off(m, rates_by_landau(m))?;
    /// The same, as the sum of what the rates are off.
    LANDAU_RATES: "Jacobi's functions with 1 - k^2 by subtraction",
        |m| rates_off(m)?.iter().sum::<f64>().abs();
    /// Of a body whose L^2 is no double: Landau's k^2 is made of it.
    SQUARES: "k^2 from L^2 and 2 E", |m| rates_off(m)?.iter().map(|off| off.abs()).sum();
    MEAN: "Jacobi's functions by the arithmetic-geometric mean", |m| by_mean(m);
    BACK: "the phase counted back from half a period", |m| turned_back(m)?;
    COMPARED: "attitudes compared by their quaternions' difference", |m| between_quaternions(m)?;
}

fn rates_off(motion: &Motion) -> Solved<[f64; 3]> {
    let (naive, truth) = (rates_by_landau(motion), motion.true_rates()?);
    Ok([0, 1, 2].map(|i| naive[i] - truth[i]))
}

/// The largest middle rate on the separatrix, and by how much the phase grows until the end.
fn middle(motion: &Motion) -> [f64; 2] {
    let ([p, q, r], [i1, i2, i3]) = (motion.rates, motion.moments);
    let largest = ((i1 * p * p + i2 * q * q + i3 * r * r) / i2).sqrt();
    [largest, largest * motion.end / 3.0]
}

/// sn at k = 1 by the descent of the arithmetic-geometric mean, which has no bottom there, less
/// the hyperbolic tangent that it is.
fn by_mean(motion: &Motion) -> f64 {
    let [largest, grown] = middle(motion);
    let phase = atanh(motion.rates[1] / largest) + grown;
    (jacobi(phase, 1.0)[0] - tanh(phase)).abs()
}

/// Where cn is negative the phase is counted back from half a period, 2K - u: of K = ln(4/k')
/// with k' = 0 nothing is left to count.
fn turned_back(motion: &Motion) -> Solved<f64> {
    let ([p, q, r], [i1, i2, i3]) = (motion.rates, motion.moments);
    let [largest, grown] = middle(motion);
    let complement = 1.0 - (i3 * (i3 - i2) * r * r) / (i1 * (i2 - i1) * p * p);
    let half = 2.0 * log(4.0 / complement.sqrt());
    let phase = half - atanh(-q / largest) + grown;
    Ok((largest * tanh(half - phase) - motion.true_rates()?[1]).abs())
}

/// The distance of the quaternions at the end, of this start and of its antipode.
fn between_quaternions(motion: &Motion) -> Solved<f64> {
    let mut half = *motion;
    half.attitude = half_turn()?;
    let [[a, b, c, d], [e, f, g, h]] = [motion.truth()?, half.truth()?].map(|a| a.quaternion());
    Ok(2.0 * hypot(hypot(a - e, b - f), hypot(c - g, d - h)))
}

/// A step of the classical Runge-Kutta method.
fn rk4<const N: usize>(f: &impl Fn(&[f64; N]) -> [f64; N], y: &[f64; N], h: f64) -> [f64; N] {
    let add = |k: &[f64; N], part: f64| core::array::from_fn(|i| y[i] + part * h * k[i]);
    let a = f(y);
    let b = f(&add(&a, 0.5));
    let c = f(&add(&b, 0.5));
    let d = f(&add(&c, 1.0));
    core::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
}

/// The start, and what follows after each step.
fn path<const N: usize>(
    f: impl Fn(&[f64; N]) -> [f64; N],
    start: [f64; N],
    end: f64,
    count: u32,
) -> impl Iterator<Item = [f64; N]> {
    let h = end / f64::from(count);
    let next = move |y: &[f64; N]| Some(rk4(&f, y, h));
    core::iter::successors(Some(start), next).take(count as usize + 1)
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
    motion.gravity.map_or(0.0, |[weight, lever]| weight * lever)
}

/// Euler's equations, with the torque of a weight on the third axis.
fn rates_of(motion: &Motion, [p, q, r]: [f64; 3], [g1, g2]: [f64; 2]) -> [f64; 3] {
    let [i1, i2, i3] = motion.moments;
    let pull = pull(motion);
    [
        ((i2 - i3) * q * r + pull * g2) / i1,
        ((i3 - i1) * r * p - pull * g1) / i2,
        (i1 - i2) * p * q / i3,
    ]
}

/// RK4 on the Euler angles of the notes and the body's rates, with 1/sin(theta) in them.
pub fn on_euler_angles(motion: &Motion, count: u32) -> Option<Attitude> {
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

/// RK4 on yaw, pitch and roll, with 1/cos(pitch) in their rates.
pub fn on_yaw_pitch_roll(motion: &Motion, count: u32) -> Option<Attitude> {
    let YawPitchRoll { yaw, pitch, roll } = motion.attitude.yaw_pitch_roll();
    let [p, q, r] = motion.rates;
    let slope = |&[_, pitch, roll, p, q, r]: &[f64; 6]| {
        let ((s, c), (sr, cr)) = (sincos(pitch), sincos(roll));
        let turn = (q * sr + r * cr) / c;
        let [a, b, d] = rates_of(motion, [p, q, r], [-s, c * sr]);
        [turn, q * cr - r * sr, p + turn * s, a, b, d]
    };
    let path = path(slope, [yaw, pitch, roll, p, q, r], motion.end, count);
    let [yaw, pitch, roll, ..] = path.last()?;
    Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll }).ok()
}

/// The tilt by the arc cosine of the axis's height, the others by arc tangents of elements of
/// the matrix: the formulas of every textbook.
pub fn by_arc_cosine(attitude: Attitude) -> Option<Attitude> {
    let m = attitude.matrix();
    let (phi, zeta) = (atan2(m[0][2], -m[1][2]), atan2(m[2][0], m[2][1]));
    turned(phi, acos(m[2][2].clamp(-1.0, 1.0)), zeta).ok()
}

/// The scalar part of a quaternion from the trace of the matrix.
pub fn scalar_by_trace(attitude: Attitude) -> f64 {
    let m = attitude.matrix();
    0.5 * (1.0 + m[0][0] + m[1][1] + m[2][2]).max(0.0).sqrt()
}

/// A quaternion divided by that.
pub fn by_trace(attitude: Attitude) -> Option<Attitude> {
    let (m, w) = (attitude.matrix(), scalar_by_trace(attitude));
    let [x, y, z] = [(2, 1), (0, 2), (1, 0)].map(|(i, j)| (m[i][j] - m[j][i]) / (4.0 * w));
    Attitude::from_quaternion([w, x, y, z]).ok()
}

/// The same motion with the first moment larger by a billionth, "so that nothing is 0/0".
pub fn jittered(motion: &Motion) -> Option<Attitude> {
    let mut other = *motion;
    other.moments[0] *= 1.0 + 1e-9;
    other.truth().ok()
}

/// sn, cn and dn of the parameter m, with 1 - m formed by subtraction.
pub fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let mut a = [1.0; 32];
    let mut c = [0.0; 32];
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
/// of moments and energies as they stand there. In rising order of the moments.
pub fn rates_by_landau(motion: &Motion) -> [f64; 3] {
    let [i1, i2, i3] = motion.moments;
    let [p, q, r] = motion.rates;
    let twice = i1 * p * p + i2 * q * q + i3 * r * r;
    let square = i1 * i1 * p * p + i2 * i2 * q * q + i3 * i3 * r * r;
    let k2 = (i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1));
    let rate = ((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3)).sqrt();
    let largest = [
        ((twice * i3 - square) / (i1 * (i3 - i1))).max(0.0).sqrt(),
        ((twice * i3 - square) / (i2 * (i3 - i2))).max(0.0).sqrt(),
        ((square - twice * i1) / (i3 * (i3 - i1))).max(0.0).sqrt(),
    ];
    // At the turning point of the middle rate a quarter of a period has passed.
    let quarter = FRAC_PI_2 / mean(1.0, (1.0 - k2).max(0.0).sqrt());
    let [sn, cn, dn] = jacobi(rate * motion.end + quarter, k2);
    [largest[0] * cn, largest[1] * sn, largest[2] * dn]
}

/// The arithmetic-geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..60 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// RK4 on the quaternion and the body's rates, with nothing kept.
pub fn on_quaternion(motion: &Motion, count: u32) -> Option<Attitude> {
    let [w, x, y, z, ..] = path_on_quaternion(motion, count).last()?;
    Attitude::from_quaternion([w, x, y, z]).ok()
}

/// The same at the start and after each step: quaternion and rates.
pub fn path_on_quaternion(motion: &Motion, count: u32) -> impl Iterator<Item = [f64; 7]> {
    let motion = *motion;
    let [w, x, y, z] = motion.attitude.quaternion();
    let [p, q, r] = motion.rates;
    let slope = move |&[w, x, y, z, p, q, r]: &[f64; 7]| {
        let vertical = [2.0 * (x * z - w * y), 2.0 * (y * z + w * x)];
        let [a, b, c] = rates_of(&motion, [p, q, r], vertical);
        let [w, x, y, z] = turning([w, x, y, z], [p, q, r]);
        [w, x, y, z, a, b, c]
    };
    path(slope, [w, x, y, z, p, q, r], motion.end, count)
}

/// RK4 on the quaternion alone, the rates from L, which stays in space: the end.
pub fn by_momentum(motion: &Motion, count: u32) -> Option<Attitude> {
    Some(path_by_momentum(motion, count).ok()?.last()?.0)
}

/// RK4 on the quaternion alone, the rates from L, which stays in space: the attitude at the
/// start and after each step, with the rate about the middle axis.
pub fn path_by_momentum(motion: &Motion, count: u32) -> Solved<Vec<(Attitude, f64)>> {
    let [i1, i2, i3] = motion.moments;
    let momentum = motion.attitude.to_space(motion.momentum(motion.rates));
    let rates = |attitude: Attitude| {
        let [a, b, c] = attitude.to_body(momentum).to_array();
        [a / i1, b / i2, c / i3]
    };
    let read = |q: &[f64; 4]| Attitude::from_quaternion(*q);
    let slope = |q: &[f64; 4]| turning(*q, rates(read(q).unwrap_or(motion.attitude)));
    let path = path(slope, motion.attitude.quaternion(), motion.end, count);
    path.map(|q| read(&q).map(|attitude| (attitude, rates(attitude)[1]))).collect()
}

/// The tilt at the end by theta' = sqrt(2 (E - U)), the sign always that of the start: at a
/// turning point the root is zero, and the motion stays there.
pub fn tilt_by_energy(motion: &Motion, count: u32) -> f64 {
    let [i1, _, i3] = motion.moments;
    let [p, q, r] = motion.rates;
    let pull = pull(motion);
    let EulerAngles { theta, zeta, .. } = motion.attitude.euler_angles();
    let ((s, c), (sz, cz)) = (sincos(theta), sincos(zeta));
    let (along, across) = (p * cz - q * sz, p * sz + q * cz);
    let own = i3 * r;
    let vertical = i1 * across * s + own * c;
    let energy = 0.5 * i1 * (along * along + across * across) + pull * c;
    let sign = if along < 0.0 { -1.0 } else { 1.0 };
    let slope = |&[theta]: &[f64; 1]| {
        let (s, c) = sincos(theta);
        let turn = (vertical - own * c) / (i1 * s);
        let left = 2.0 * (energy - pull * c) / i1 - turn * turn;
        [sign * left.max(0.0).sqrt()]
    };
    let path = path(slope, [theta], motion.end, count);
    path.last().map_or(f64::NAN, |[theta]| theta)
}

/// The smaller turning point of a top (the notes' a, b, c and E~) by the trigonometric formula
/// for the roots of a cubic, from its coefficients.
pub fn turning_point([a, b, c]: [f64; 3], energy: f64) -> f64 {
    let p = -(2.0 * energy + 2.0 * c + a) / (2.0 * c);
    let q = (2.0 * a * b - 2.0 * c) / (2.0 * c);
    let r = (2.0 * energy + 2.0 * c - a * b * b) / (2.0 * c);
    let [linear, constant] = [q - p * p / 3.0, 2.0 * p * p * p / 27.0 - p * q / 3.0 + r];
    let size = (-linear / 3.0).sqrt();
    let angle = acos((-constant / (2.0 * size * size * size)).clamp(-1.0, 1.0)) / 3.0;
    let third = TAU / 3.0;
    let mut roots = [0.0, 1.0, 2.0].map(|k| 2.0 * size * cos(angle - k * third) - p / 3.0);
    sort_by_number(&mut roots, |root| *root);
    acos(roots[1])
}

/// A body that is left as it is if nothing turns faster than this (rad/s): it "sleeps".
pub fn asleep(motion: &Motion, below: f64) -> Option<Attitude> {
    let fastest = motion.rates.iter().fold(0.0, |m: f64, w| m.max(w.abs()));
    if fastest < below {
        return Some(motion.attitude);
    }
    motion.truth().ok()
}

/// 1e-30 kg m^2 added to each moment before it divides the momentum, "so that nothing is
/// divided by zero".
pub fn guarded(motion: &Motion) -> Option<Attitude> {
    let mut other = *motion;
    for i in 0..3 {
        other.moments[i] += 1e-30;
        other.rates[i] *= motion.moments[i] / other.moments[i];
    }
    other.truth().ok()
}

fn size([a, b, c]: [f64; 3]) -> f64 {
    (a * a + b * b + c * c).sqrt()
}

/// Axis by division by |omega|, as it is squared and summed; then the angle |omega| t.
pub fn by_axis(motion: &Motion) -> Option<Attitude> {
    let size = size(motion.rates);
    let (sin, cos) = sincos(0.5 * size * motion.end);
    let [x, y, z] = motion.rates.map(|rate| sin * rate / size);
    Some(motion.attitude * Attitude::from_quaternion([cos, x, y, z]).ok()?)
}

/// RK4 in steps of a hundredth of the time in which the rates change by their own size.
pub fn by_first_step(motion: &Motion) -> Option<Attitude> {
    let slope = rates_of(motion, motion.rates, [0.0; 2]);
    let step = 0.01 * size(motion.rates) / size(slope);
    // No step, no end.
    (step > 0.0).then(|| on_quaternion(motion, (motion.end / step).ceil() as u32))?
}
