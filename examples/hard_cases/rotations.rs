//! The families of motions: a body that turns freely, or a top, and a method that breaks on it.

use super::naive::*;
use super::*;

/// Most of them begin here.
pub fn start() -> Solved<Attitude> {
    turned(0.3, 0.8, 0.2)
}

/// A body on which nothing acts, from there.
fn free(moments: [f64; 3], rates: [f64; 3], end: f64) -> Solved<Motion> {
    Ok(Motion::free(moments, start()?, rates, end))
}

/// About its axis (rad/s): a top of this kind sleeps from 4 rad/s on.
const SPIN: f64 = 2.0;

pub fn at_pole(attitude: Attitude, rates: [f64; 3]) -> Motion {
    Motion::top([1.0, 0.5], 1.0, attitude, rates, 20.0)
}

/// Exactly upright.
fn upright() -> Solved<Attitude> {
    Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), 0.7)
}

/// Nose on the vertical: the pitch is pi/2, and yaw and roll are about one line.
pub fn locked() -> Solved<Motion> {
    let (yaw, pitch, roll) = (0.3, FRAC_PI_2, 0.1);
    let locked = Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll })?;
    Ok(at_pole(locked, [0.4, 0.3, SPIN]))
}

family! { POLES, "poles": "Pole passages and gimbal lock", |by| TOP, in NAMES;
    "exactly up, kicked", "precession and spin are one turn: no rate of either is defined":
        at_pole(upright()?, [0.1, 0.0, SPIN]).against(by, ANGLES);
    "exactly down, kicked", "the same below; pi is no double":
        at_pole(Attitude::from_quaternion([0.0, 1.0, 0.0, 0.0])?, [0.1, 0.2, SPIN]).against(by, ANGLES);
    "1e-8 rad off the top", "the angles turn a hundred million times faster than the body":
        at_pole(turned(0.3, 1e-8, 0.0)?, [0.1, 0.0, SPIN]).against(by, ANGLES);
    "1e-8 rad off the bottom", "the same below":
        at_pole(Attitude::from_quaternion([0.5e-8, 1.0, 0.0, 0.0])?, [0.1, 0.2, SPIN]).against(by, ANGLES);
    // With this rate across the node L_Z = L_z, or L_Z = -L_z: the axis meets the pole.
    "through the top in flight, b = 1", "the axis meets the pole and the angles jump by pi":
        at_pole(turned(0.3, 1.0, 0.0)?, [-1.5, tan(0.5), SPIN]).against(by, ANGLES);
    "through the bottom in flight, b = -1", "the same below":
        at_pole(turned(0.3, 1.0, 0.0)?, [0.5, -1.0 / tan(0.5), SPIN]).against(by, ANGLES);
    "pitch of pi/2", "gimbal lock: yaw and roll are one turn": locked()?.against(by, YAW);
    // What turns the vertical axis alone changes nothing of it: the condition is the spin's.
    "exactly up below the critical spin", "any rounding is a kick, and grows as exp(0.87 t)":
        at_pole(upright()?, [0.0, 0.0, SPIN]).of_condition(by, 2.0 + 20.0 * SPIN, ANGLES);
}

/// I3 omega_3 = 2 sqrt(I1 m g l), and the last digit below.
const CRITICAL: f64 = 4.0;
const BELOW: f64 = CRITICAL * (1.0 - f64::EPSILON);

fn at_threshold(theta: f64, kick: f64, spin: f64) -> Solved<Motion> {
    Ok(at_pole(turned(0.3, theta, 0.2)?, [kick, 0.0, spin]).until(15.0))
}

family! { THRESHOLD, "threshold": "The sleeping top at its threshold", |by| TOP, in NAMES;
    "1e-6 rad off, at the threshold", "two roots of the cubic meet":
        at_threshold(1e-6, 0.0, CRITICAL)?.against(by, ARC_COSINE);
    "1e-6 rad off, an eps above", "their gap is lost to cancellation":
        at_threshold(1e-6, 0.0, CRITICAL * (1.0 + f64::EPSILON))?.against(by, ARC_COSINE);
    "1e-6 rad off, an eps below", "and its sign decides whether the top sleeps":
        at_threshold(1e-6, 0.0, BELOW)?.against(by, ARC_COSINE);
    "upright, kicked at the threshold", "the kick is all there is":
        at_threshold(0.0, 1e-6, CRITICAL)?.against(by, ANGLES);
    "upright, kicked an eps below", "the same": at_threshold(0.0, 1e-6, BELOW)?.against(by, ANGLES);
    // Exactly upright: the condition is the spin's.
    "exactly upright, at the threshold", "a kick by rounding would grow with t":
        at_threshold(0.0, 0.0, CRITICAL)?.of_condition(by, 2.0 + 15.0 * CRITICAL, ANGLES);
    "exactly upright, an eps below", "and here exponentially":
        at_threshold(0.0, 0.0, BELOW)?.of_condition(by, 2.0 + 15.0 * BELOW, ANGLES);
}

/// A separatrix of these goes through round numbers: omega_1 = 2 omega_3.
const ROUND: [f64; 3] = [3.0, 4.0, 6.0];

/// From the middle axis, the third rate off: 1 - k^2 = 4.5 of its square. The flip comes when the
/// small rate, growing as exp(t/3), is of order one.
pub fn one_flip(complement: f64) -> Solved<Motion> {
    let off: f64 = (complement / 4.5_f64).sqrt();
    free(ROUND, [0.0, 1.0, off], 3.0 * log(2.0 / off) + 6.0)
}

/// A top at the energy and the momentum of the upright one, on its way up and not yet there.
fn homoclinic(end: f64) -> Solved<Motion> {
    let (theta, spin) = (2.0, 2.0);
    let across = 0.25 * spin * tan(0.5 * theta);
    let lost = 2.0 * (1.0 - cos(theta));
    let rates = [-(lost - across * across).sqrt(), across, spin];
    Ok(Motion::top([1.0, 0.25], 1.0, turned(0.3, theta, 0.0)?, rates, end))
}

family! { SEPARATRIX, "separatrix": "At the separatrix", |by| FREE, in NAMES;
    "1 - k^2 = 1e-8, one flip", "the flip is late by the logarithm of 1 - k^2": one_flip(1e-8)?.against(by, LANDAU);
    "1 - k^2 = 1e-12, one flip", "of which a difference from 1 keeps four digits": one_flip(1e-12)?.against(by, LANDAU);
    "1 - k^2 = 1e-16, one flip", "and here none": one_flip(1e-16)?.against(by, LANDAU);
    "exactly about the middle axis", "any rounding is a kick, and grows as exp(t/3)":
        free(ROUND, [0.0, 1.0, 0.0], 20.0)?.against(by, LANDAU);
    // On the separatrix itself: 3 (4 - 3) omega_1^2 = 6 (6 - 4) omega_3^2 to the last bit.
    "1 - k^2 = 0, between the ends", "K is infinite, and sn, cn, dn are no longer periodic":
        free(ROUND, [0.5, 1.0, 0.25], 15.0)?.against(by, MEAN);
    "1 - k^2 = 0, its other half", "a rate that goes as cn, and changes sign, goes as sech here":
        free(ROUND, [-0.5, 1.0, 0.25], 15.0)?.against(by, BACK);
    "homoclinic top, after 8 s", "it comes to the vertical in an infinite time": homoclinic(8.0)?.against(by, FEWER);
    "homoclinic top, after 16 s", "and the rounding of its start decides on which side it falls":
        homoclinic(16.0)?.against(by, FEWER);
}

/// A free body after so many periods of its rates, and a part of one.
pub fn late([count, part]: [f64; 2], moments: [f64; 3], rates: [f64; 3]) -> Solved<Motion> {
    let motion = free(moments, rates, 0.0)?;
    let period = motion.free_body()?.rate_period();
    Ok(motion.until(count * period + part * period))
}

/// Ten thousand flips about the intermediate axis, two a period, and a quarter of a period more.
pub const FLIPPED: [f64; 2] = [5000.25, 0.0];

family! { FLIPS, "flips": "Ten thousand flips", |by| CLOSED, in NAMES;
    "a thousandth off the middle axis", "a small error of the energy makes each flip late":
        late(FLIPPED, [1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?.against(by, FLIPS_BY_RK4);
    "the same, the axes in another order", "an odd order of the axes is no rotation":
        late(FLIPPED, [2.0, 1.0, 2.5], [1.0, 0.0, 1e-3])?.against(by, FLIPS_BY_RK4);
    "a ten-thousandth off, the other way", "the closer, the later":
        late(FLIPPED, [1.0, 2.0, 2.5], [1e-4, -1.0, 0.0])?.against(by, FLIPS_BY_RK4);
}

fn shaped(moments: [f64; 3]) -> Solved<Motion> {
    free(moments, [0.8, 0.4, 0.9], 30.0)
}

family! { SHAPES, "shapes": "Nearly symmetric bodies, needle, disc and sphere", |by| FREE, in NAMES;
    "I2/I1 - 1 = 0", "formulas for three moments are 0/0": shaped([1.0, 1.0, 1.7])?.against(by, JITTER);
    "I2/I1 - 1 = 1e-15", "all that tells them apart is four last bits":
        shaped([1.0, 1.0 + 1e-15, 1.7])?.against(by, JITTER);
    "I2/I1 - 1 = 1e-10", "neither symmetric nor far from it": shaped([1.0, 1.0 + 1e-10, 1.7])?.against(by, JITTER);
    "all but a sphere", "every difference of moments is a billionth":
        shaped([1.0, 1.0 + 1e-9, 1.0 - 1e-9])?.against(by, JITTER);
    "sphere", "nothing tells one axis from another": shaped([2.0, 2.0, 2.0])?.against(by, JITTER);
    // The larger moment is the sum of the others, or a rounding more.
    "disc, I3 = I1 + I2 and a rounding", "0.7 + 0.1 is less than 0.8 in doubles":
        shaped([0.7, 0.1, 0.8])?.against(by, TRIANGLE);
    "disc, I3 = I1 + I2 exactly", "one of the differences of moments is the third moment":
        shaped([1.0, 2.0, 3.0])?.against(by, JITTER);
    // The spin about the thin axis of a needle is not in L.
    "needle, I3/I1 = 1e-9", "a rounding of L across the needle is a spin about it":
        shaped([1.0, 1.0, 1e-9])?.until(5.0).against(by, FROM_MOMENTUM);
    "needle of three moments", "I1 - I2 is half of I3":
        shaped([1.0, 1.0 + 5e-10, 1e-9])?.until(5.0).against(by, FROM_MOMENTUM);
}

const NOTES_TOP: [f64; 3] = [1.5, 1.2, 0.2];

/// The body of the notes' parameters a and c: I1 = 1, I3 = a, m g l = c, omega_3 = 1/sqrt(a).
fn top([a, c]: [f64; 2], theta: f64, [along, across]: [f64; 2], end: f64) -> Solved<Motion> {
    let (tilted, rates) = (turned(0.3, theta, 0.0)?, [along, across, 1.0 / a.sqrt()]);
    Ok(Motion::top([1.0, a], c, tilted, rates, end))
}

/// The same with the notes' b, which gives the rate across the node.
fn of_b([a, b, c]: [f64; 3], theta: f64, along: f64) -> Solved<Motion> {
    let across = a.sqrt() * (b - cos(theta)) / sin(theta);
    top([a, c], theta, [along, across], 40.0)
}

/// From its smaller turning point, with an energy that is told from the least.
fn turning(by: &[By], [a, b, c]: [f64; 3], energy: impl Fn(f64) -> f64) -> Result<Answered> {
    let reduced = ReducedTop::new(a, b, c)?;
    let energy = energy(reduced.minimum().1);
    let theta = HeavyTop::from_energy(reduced, energy, Start::ThetaMin, 0.0, 0.0)?.theta_min();
    let error = (models::naive::turning_point([a, b, c], energy) - theta).abs();
    let naive = ("turning point by the trigonometric formula of the cubic", error);
    let motion = of_b([a, b, c], theta, 0.0)?;
    motion.answered(by, naive, motion.conditions()?, motion.truth()?)
}

family! { TOPS, "tops": "Steady, cusped, fast and slow tops", |by| TOP, in NAMES;
    "E~ within 5e-13 of U_min", "the turning points are a millionth apart, a double root but for that":
        { let [a, b, c] = NOTES_TOP; of_b([a, b, c], ReducedTop::new(a, b, c)?.minimum().0, 1e-6)?.against(by, ENERGY) };
    "exactly on a cusp, b = 1/2", "it starts at rest, where the root is zero":
        top([1.5, 0.25], FRAC_PI_3, [0.0; 2], 40.0)?.against(by, ENERGY);
    "very fast, c = 1e-8", "it nods by 1e-8 rad": top([1.5, 1e-8], 1.0, [0.0; 2], 60.0)?.against(by, ENERGY);
    "very slow, c = 1e6", "it falls like a pendulum and passes the bottom close by":
        top([1.5, 1e6], 1.0, [0.0; 2], 0.03)?.against(by, ENERGY);
    "E~ two roundings above U_min", "all but a double root: half of the digits are lost":
        turning(by, NOTES_TOP, |lowest| lowest + 2.0 * f64::EPSILON * lowest.abs());
    "near the pole: b = 0.999, E~ = 0.05", "the root is all but 1, and what it lacks of 1 is asked for":
        turning(by, [1.9, 0.999, 0.45], |_| 0.05);
}

/// By this much less than half a turn (rad), about a skew axis.
pub fn half_turn(less: f64) -> Solved<Attitude> {
    Attitude::about_space_axis(SpaceVector::new(1.0, -2.0, 3.0), PI - less)
}

fn turning_at(attitude: Attitude, rates: [f64; 3], end: f64) -> Motion {
    Motion::free([1.0, 1.3, 1.7], attitude, rates, end)
}

/// About one axis alone, for ever as good as any.
fn alone(by: &[By], rate: f64) -> Result<Answered> {
    let end = 1.0 / f64::max(rate, 1e-300);
    turning_at(half_turn(0.0)?, [0.0, 0.0, rate], end).of_condition(by, 3.0, AXIS)
}

/// An azimuth of 1e32 rad without its whole turns: 1e32 is a whole number, and this its
/// remainder by 2 pi to 80 digits, rounded.
pub const AZIMUTH: [f64; 2] = [1e32, 0.625_167_975_329_289_9];

fn many_turns(by: &[By]) -> Result<Answered> {
    let after = |phi: f64| Solved::Ok(turning_at(turned(phi, 0.8, 0.2)?, [0.3, 0.2, 1.0], 10.0));
    let [azimuth, rest] = AZIMUTH;
    let [motion, same] = [after(azimuth)?, after(rest)?];
    let by_turns = after(azimuth - TAU * (azimuth / TAU).floor())?.attitude;
    let error = by_turns.angle_to(&same.attitude);
    let naive = ("whole turns of 2 pi subtracted in doubles", error);
    motion.answered(by, naive, motion.conditions()?, same.truth()?)
}

family! { TURNS, "turns": "Half turns, and rates of every size", |by| FREE, in NAMES;
    "started after half a turn", "the scalar part is zero, and is divided by":
        turning_at(half_turn(0.0)?, [0.3, 0.2, 1.0], 10.0).against(by, TRACE);
    "started from the antipodal quaternion", "q and -q are one attitude": turning_at(
        Attitude::from_quaternion(half_turn(0.0)?.quaternion().map(|c| -c))?, [0.3, 0.2, 1.0], 10.0).against(by, COMPARED);
    "an azimuth of 1e32 rad", "of its turns doubles know sixteen digits, and thirty-one count": many_turns(by);
    "at rest", "the axis of no rotation is 0/0": turning_at(half_turn(0.0)?, [0.0; 3], 10.0).against(by, AXIS);
    "rates of 1e-199 rad/s for 1e200 s", "their squares are zero in doubles":
        turning_at(half_turn(0.0)?, [3e-200, 2e-200, 1e-199], 1e200).against(by, AXIS);
    "rates of 1e8 rad/s for 1e-7 s", "a step of any fixed size is too long":
        turning_at(half_turn(0.0)?, [3e7, 2e7, 1e8], 1e-7).against(by, ONE_STEP);
    "rates of 1e150 rad/s for 1e-149 s", "the square of an angular acceleration is infinite":
        turning_at(half_turn(0.0)?, [3e149, 2e149, 1e150], 1e-149).against(by, FIRST_STEP);
    // A rate that is all but nothing, and below the rates of any motion.
    "1e-200 rad/s beside 1 rad/s", "its square is no double, and 1 - k^2 is made of it":
        Motion::free([1.0, 1.5, 2.0], half_turn(0.0)?, [1e-200, 1.0, 0.0], 30.0).against(by, LANDAU_RATES);
    "1e200 rad/s for 1e-200 s", "its square is infinite, and so is its energy": alone(by, 1e200);
    "1e-300 rad/s for 1e300 s", "its square is zero, and its momentum's": alone(by, 1e-300);
    "the least double, 5e-324 rad/s", "nothing smaller to round to": alone(by, 5e-324);
}

/// Moments 1, 1.3, 1.7 and rates 0.3, 0.2, 1 in these units, for 30 units of time.
pub fn scaled(moment: f64, rate: f64) -> Solved<Motion> {
    free([1.0, 1.3, 1.7].map(|i| i * moment), [0.3, 0.2, 1.0].map(|w| w * rate), 30.0 / rate)
}

/// A top of moments 1 and 0.5 in these units, its centre of mass so far from its tip (m), and a
/// weight that pulls with 1 of what they make: for 10 units of time.
fn scaled_top(moment: f64, rate: f64, lever: f64) -> Solved<Motion> {
    let (pull, rates) = (moment * rate * rate, [0.3, 0.2, 2.0].map(|w| w * rate));
    let top = Motion::top([moment, 0.5 * moment], pull, start()?, rates, 10.0 / rate);
    Ok(Motion { gravity: [pull / lever, lever], ..top })
}

family! { SCALES, "scales": "From a molecule to the Earth", |by| FREE, in NAMES;
    "top: 1e-40 kg m^2, 1e6 rad/s, 1e-14 m", "a torque of 1e-28 N m looks like none":
        scaled_top(1e-40, 1e6, 1e-14)?.against(by, GUARDED);
    "top: 1e38 kg m^2, 4e-5 rad/s, 1e6 m", "its rates look like rest, its torque is 1e29 N m":
        scaled_top(1e38, 4e-5, 1e6)?.against(by, ASLEEP);
    "1e-170 kg m^2, 1 rad/s", "the square of its momentum is zero": scaled(1e-170, 1.0)?.against(by, SQUARES);
    "1e160 kg m^2, 1 rad/s", "the square of its momentum is infinite": scaled(1e160, 1.0)?.against(by, SQUARES);
    "molecule: 1e-46 kg m^2, 1e12 rad/s", "its moments are less than any number that looks like zero":
        scaled(1e-46, 1e12)?.against(by, GUARDED);
    "dust: 1e-40 kg m^2, 1e6 rad/s", "the same": scaled(1e-40, 1e6)?.against(by, GUARDED);
    "asteroid: 1e20 kg m^2, 1e-6 rad/s", "its rates look like rest": scaled(1e20, 1e-6)?.against(by, ASLEEP);
    "Earth: 1e38 kg m^2, 7.3e-5 rad/s", "the same, and its energy is 5e29 J": scaled(1e38, 7.3e-5)?.against(by, ASLEEP);
}

/// Periods, and three tenths of one.
pub const TRILLION: [f64; 2] = [1e12, 0.3];

/// The inputs are exact: the bound grants a change over one period alone.
fn trillion(by: &[By], moments: [f64; 3], rates: [f64; 3]) -> Result<Answered> {
    let motion = late(TRILLION, moments, rates)?;
    let exact = motion.free_body()?;
    motion.of_condition(by, exact.condition(exact.rate_period())?, MODULO)
}

family! { LONG, "long": "A trillion periods", |by| CLOSED, in NAMES;
    "three moments", "a period rounded once is a trillion times wrong": trillion(by, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3]);
    "near the separatrix, 1 - k^2 = 2e-5", "the same, and the period is hard to have":
        trillion(by, [1.0, 2.0, 2.5], [0.0, 1.0, 2e-3]);
    "two moments", "the same of two circular motions": trillion(by, [1.0, 1.0, 1.7], [0.8, 0.4, 0.3]);
}
