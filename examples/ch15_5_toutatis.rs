//! Section 15.5: the asteroid Toutatis, its tumbling against seventeen days of radar images,
//! and against one sixteen years later.

#[path = "ch15_5_toutatis/figures.rs"]
mod figures;
#[path = "ch15_5_toutatis/fit.rs"]
mod fit;
#[path = "ch15_5_toutatis/moved.rs"]
mod moved;
#[path = "ch15_5_toutatis/observed.rs"]
mod observed;
#[path = "ch15_5_toutatis/tide.rs"]
mod tide;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use rotation_dynamics::accuracy::{Problem, largest};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, KeplerOrbit, OrbitingBody};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, after, ode, size_or};
use rotation_dynamics::scene::Scene;

pub use fit::{Fit, Unknowns, best, jackknife, least_squares, unknowns};
pub use observed::{Observed, observed, seconds, since_epoch, turning};
pub use tide::{AU, Changed, EARTH, HALF, Path, by_kicks, number};

/// s.
pub const DAY: f64 = 86400.0;
/// When the published state holds, UTC.
pub const EPOCH: &str = "1992-11-09T17:49:47";

parameters! {
    /// The asteroid: its moments of inertia, and the flyby that is put in.
    pub struct Parameters {
        /// moment of inertia about x over that about the long axis
        moment_x: number(3.0836, "-", from_to(1.5, 8.0).because("in units of the least moment; a longer body would break").usually(2.5, 3.2)).open("moment about x, over the least", "less of a spindle", "a spindle");
        /// the same about y
        moment_y: number(3.235, "-", from_to(1.5, 8.0).because("in units of the least moment; a longer body would break").usually(3.2, 4.0)).open("moment about y, over the least", "a spindle", "less of a spindle");
        /// least distance from the Earth in the flyby
        closest: number(1.5558e9, "m", from_to(1e8, 1e11).because("nearer, the tide outdoes the spin; farther, the Earth is not felt").usually(5e8, 1e10));
        /// speed far from the Earth
        speed: number(11e3, "m/s", from_to(1e3, 1e5).because("slower, the Sun's pull counts in the flyby; nothing of the solar system is faster").usually(5e3, 2e4));
        /// longitude of the Earth at the closest, seen from the asteroid
        longitude: number(0.0, "rad", from_to(-PI, PI).because("other longitudes repeat these after whole turns"));
        /// error asked of the attitude after the flyby: from 1e-12 to 1e-3
        tolerance: number(1e-9, "rad", from_to(1e-12, 1e-3));
    }
}

/// A free motion: the moments of inertia (the long axis has 1) and the state at the time t, s after
/// the epoch.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub t: f64,
    pub moments: [f64; 3],
    pub attitude: Attitude,
    pub angular_velocity: BodyVector,
}

// ANCHOR: start
/// What is published of the epoch: Euler angles in degrees, rates in degrees a day, and two
/// moments of inertia over that about the long axis.
pub fn numbers(p: &Parameters) -> [f64; 8] {
    [145.498, 65.865, 241.524, 14.51, 33.529, -98.709, p.moment_x, p.moment_y]
}

impl Start {
    pub fn of([phi, theta, zeta, x, y, z, moment_x, moment_y]: [f64; 8]) -> Result<Self> {
        let (attitude, angular_velocity) = turning([phi, theta, zeta, x, y, z])?;
        Ok(Self { t: 0.0, moments: [moment_x, moment_y, 1.0], attitude, angular_velocity })
    }

    pub fn body(&self) -> rotation_dynamics::Result<RigidBody> {
        let [x, y, z] = self.moments;
        Ok(RigidBody::new(PrincipalMoments::new(x, y, z)?))
    }

    /// The motion without any torque, in closed form; its clock begins with the start.
    pub fn motion(&self) -> rotation_dynamics::Result<FreeBody> {
        FreeBody::new(self.body()?.moments(), self.attitude, self.angular_velocity)
    }
}

/// The period of the rotation about the long axis and that of its precession, s.
pub fn periods(motion: &FreeBody) -> [f64; 2] {
    let one = motion.rate_period();
    [one, one * TAU / motion.precession_per_period().abs()]
}
// ANCHOR_END: start

impl Start {
    /// The same motion, begun at another time.
    pub fn at(&self, t: f64) -> Result<Self> {
        let found = self.motion()?.kinematics(t - self.t);
        Ok(self.but(|start| {
            (start.t, start.attitude) = (t, found.attitude);
            start.angular_velocity = found.angular_velocity;
        }))
    }
    pub fn periods(&self) -> Result<[f64; 2]> {
        Ok(periods(&self.motion()?))
    }
}

/// The period of the rotation about the long axis by an elliptic integral, s. L^2 < 2 T B: the
/// long axis keeps to one side of L.
pub fn elliptic_period(start: &Start) -> Result<f64> {
    let ([x, y, c], rates) = (start.moments, start.angular_velocity.to_array());
    let (a, b) = (x.max(y), x.min(y));
    let momenta = [x * rates[0], y * rates[1], c * rates[2]];
    let squares = momenta.iter().map(|l| l * l).sum::<f64>();
    let energy: f64 = momenta.iter().zip(rates).map(|(l, w)| l * w).sum();
    let (above, below) = (energy * a - squares, squares - energy * c);
    let k2 = (a - b) * below / ((b - c) * above);
    between(0.0, 1.0)
        .because("beyond it tumbles about another axis")
        .check("k^2 of a tumbling about the long axis", k2)?;
    Ok(4.0 * legendre::k(Modulus::from_m(k2)?)? * (a * b * c / ((b - c) * above)).sqrt())
}

/// Euler's equations and the attitude: rates (rad a day), quaternion, the azimuth of the long
/// axis about L; time in days. A torque adds `more` to the slopes of the rates.
fn tumbling([a, b, c]: [f64; 3], more: impl Fn(f64, &[f64; 8]) -> [f64; 3]) -> impl Ode<8> {
    ode(move |t, state: &[f64; 8]| {
        let [p, q, r, w, x, y, z, _] = *state;
        let (across, whole) = (a * a * p * p + b * b * q * q, c * c * r * r);
        let azimuth = (across + whole).sqrt() * (a * p * p + b * q * q) / across;
        let [along_x, along_y, along_z] = more(t, state);
        [
            (b - c) * q * r / a + along_x,
            (c - a) * r * p / b + along_y,
            (a - b) * p * q / c + along_z,
            -0.5 * (x * p + y * q + z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            azimuth,
        ]
    })
    .scaled(size_or([1.0; 8]))
}

/// A motion simulated by them over this time, s, with this error of a step, and the work.
pub fn simulated(
    start: &Start,
    more: impl Fn(f64, &[f64; 8]) -> [f64; 3],
    time: f64,
    step: f64,
) -> rotation_dynamics::Result<([f64; 8], Work)> {
    let [p, q, r] = (start.angular_velocity * DAY).to_array();
    let [w, x, y, z] = start.attitude.quaternion();
    let from = [p, q, r, w, x, y, z, 0.0];
    Dop853::new(step)?.advance(&tumbling(start.moments, more), 0.0, &from, time / DAY)
}

/// A torque about the long axis that goes with the body, in 1/s^2: over its moment of inertia.
pub fn push(torque: f64) -> impl Fn(f64, &[f64; 8]) -> [f64; 3] {
    move |_, _| [0.0, 0.0, torque * (DAY * DAY)]
}

/// The attitude in such a motion.
fn turned([_, _, _, w, x, y, z, _]: [f64; 8]) -> rotation_dynamics::Result<Attitude> {
    Attitude::from_quaternion([w, x, y, z])
}

/// How a motion is computed: its attitude at a time, s after the epoch.
pub type Model = fn(&Start, f64) -> Result<Attitude>;

pub fn in_closed_form(start: &Start, t: f64) -> Result<Attitude> {
    Ok(start.motion()?.attitude(t - start.t))
}

pub fn by_simulation(start: &Start, t: f64) -> Result<Attitude> {
    Ok(turned(simulated(start, push(0.0), t - start.t, 1e-14)?.0)?)
}

/// The turn from one attitude to another, as a vector in space.
pub fn turn_between(from: &Attitude, to: &Attitude) -> SpaceVector {
    (*to * from.inverse()).rotation_vector()
}

/// The angle between two vectors, degrees.
pub fn angle_between(a: SpaceVector, b: SpaceVector) -> f64 {
    atan2(a.cross(&b).norm(), a.dot(&b)).to_degrees()
}

/// The rotation that lays L upright.
pub fn upright(momentum: SpaceVector) -> rotation_dynamics::Result<Attitude> {
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let axis = momentum.cross(&up);
    Attitude::about_space_axis(axis, atan2(axis.norm(), momentum.z()))
}

/// By how much the attitude is off, degrees, on each day of December.
pub fn misses(start: &Start, model: Model) -> Result<Vec<f64>> {
    let miss = |day: &Observed| Ok(day.attitude.angle_to(&model(start, day.t)?).to_degrees());
    observed()?.0.iter().map(miss).collect()
}

/// The root of the mean of the squares.
fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64).sqrt()
}

// ANCHOR: fit
/// The free motion closest to these days: a start in their middle, two moments.
pub fn fitted(days: &[Observed], guess: Unknowns, model: Model) -> Result<Fit> {
    least_squares(guess, |at| {
        let (start, mut residuals) = (fit::start(at)?, Vec::new());
        for day in days {
            residuals.extend(turn_between(&model(&start, day.t)?, &day.attitude).to_array());
        }
        Ok(residuals)
    })
}
// ANCHOR_END: fit

/// The published state; it must tumble about the long axis.
pub fn published(p: &Parameters) -> Result<Start> {
    let start = Start::of(numbers(p))?;
    elliptic_period(&start)?;
    Ok(start)
}

/// The published state against December 1992.
fn free(p: &Parameters, report: &mut Report) -> Result<()> {
    let start = published(p)?;
    let [spin, precession] = start.periods()?.map(|t| t / DAY);
    let other = elliptic_period(&start)? / DAY;
    let ([.., azimuth], _) = simulated(&start, push(0.0), spin * DAY, 1e-14)?;
    let (missed, again) = (misses(&start, in_closed_form)?, misses(&start, by_simulation)?);
    let worst = |misses: &[f64]| largest(misses.iter().copied());
    let momentum = start.motion()?.angular_momentum();
    let latitude = atan2(momentum.z(), hypot(momentum.x(), momentum.y())).to_degrees();
    let by_angle = 90.0 - angle_between(momentum, SpaceVector::new(0.0, 0.0, 1.0));
    claims! { report,
        /// period of the rotation about the long axis
        spin_period: spin, "d", "an elliptic integral" => other, within 1e-12, in "The free motion":
            precession => "that is the other one";
        /// period of the precession of the long axis
        precession_period: precession, "d", "the precession simulated" => TAU * spin / azimuth, within 1e-10,
        in "The free motion":
            spin => "that is the other one";
        /// the first day is missed by
        miss_first: missed[0], "deg", "simulated" => again[0], within 1e-9;
        /// the worst day
        miss_worst: worst(&missed), "deg", "simulated" => worst(&again), within 1e-9;
        /// root mean square of December 1992
        miss_rms: root_mean_square(&missed), "deg", "simulated" => root_mean_square(&again), within 1e-9;
        /// latitude of L above the ecliptic
        latitude: latitude, "deg", "its angle from the pole" => by_angle, within 1e-12;
    }
}

/// Day by day: what is seen of the published state, and what is left after the fit.
fn days(start: &Start, fitted: &Start) -> Result<Table> {
    let columns = "day,since the epoch,attitude off,long axis off,angular velocity off,its length,off after the fit";
    let (motion, (december, last)) = (start.motion()?, observed()?);
    let after = misses(fitted, in_closed_form)?;
    let days = december.iter().chain([&last]).enumerate();
    Table::of("days", columns.split(','), days, |(i, day)| {
        let found = motion.kinematics(day.t);
        let space = |v: BodyVector| found.attitude.to_space(v);
        let (w, seen) = (found.angular_velocity, day.angular_velocity);
        Ok([
            day.date[..10].to_string(),
            format!("{:.2} d", day.t / DAY),
            format!("{:.1}", day.attitude.angle_to(&found.attitude).to_degrees()),
            format!("{:.1}", angle_between(found.attitude.axis(), day.attitude.axis())),
            format!("{:.1}", angle_between(space(w), space(seen))),
            format!("{:.3}", seen.norm() / w.norm()),
            after.get(i).map_or("-".into(), |miss| format!("{miss:.1}")),
        ])
    })
}

/// The free motion that comes closest.
fn fits(p: &Parameters, report: &mut Report) -> Result<()> {
    // From elsewhere, by Euler's equations instead of the closed form.
    let elsewhere = unknowns()?.map(|at| 1.02 * at + 0.02);
    let (fit, other) = (best()?, fitted(&observed()?.0, elsewhere, by_simulation)?);
    let [start, other_start] = [&fit, &other].map(|fit| fit::start(&fit.at));
    let (start, other_start) = (start?, other_start?);
    let [spin, precession] = start.periods()?.map(|t| t / DAY);
    let [other_spin, other_precession] = other_start.periods()?.map(|t| t / DAY);
    let [sd_spin, sd_precession] = fit.deviations_of_periods()?.map(|t| t / DAY);
    let [other_sd_spin, other_sd_precession] = other.deviations_of_periods()?.map(|t| t / DAY);
    report.add(days(&published(p)?, &start)?)?;
    report.add(fit.table()?)?;
    let root = root_mean_square(&misses(&start, in_closed_form)?);
    let degrees = fit.scatter.to_degrees();
    claims! { report,
        /// moment about x over that about the long axis, fitted
        fit_x: fit.at[6], "-", "another start, simulated" => other.at[6], within 1e-6;
        /// its standard deviation
        fit_x_sd: fit.deviation(6), "-", "another start, simulated" => other.deviation(6), within 1e-6;
        /// moment about y
        fit_y: fit.at[7], "-", "another start, simulated" => other.at[7], within 1e-6;
        /// its standard deviation
        fit_y_sd: fit.deviation(7), "-", "another start, simulated" => other.deviation(7), within 1e-6;
        /// scatter of one component of an attitude
        fit_scatter: degrees, "deg", "another start, simulated" => other.scatter.to_degrees(), within 1e-6;
        /// root mean square of the misses
        fit_rms: root, "deg", "of the components" => degrees * (43.0_f64 / 17.0).sqrt(), within 1e-9;
        /// period of the rotation about the long axis
        fit_spin: spin, "d", "another start, simulated" => other_spin, within 1e-6;
        /// its standard deviation
        fit_spin_sd: sd_spin, "d", "another start, simulated" => other_sd_spin, within 1e-6;
        /// period of the precession
        fit_precession: precession, "d", "another start, simulated" => other_precession, within 1e-6;
        /// its standard deviation
        fit_precession_sd: sd_precession, "d", "another start, simulated" => other_sd_precession, within 1e-6;
    }
}

/// The mean angle between two attitudes drawn at random, degrees.
pub fn at_random() -> f64 {
    (FRAC_PI_2 + 2.0 / PI).to_degrees()
}

/// The same by an integral: the angle is spread as (1 - cos a)/pi.
fn random_by_integral() -> Result<f64> {
    let spread = ode(|a: f64, _: &[f64; 1]| [a * (1.0 - cos(a)) / PI]).scaled(size_or([1.0; 1]));
    Ok(after(PI, &spread, &[0.0], 1e-14)?[0])
}

/// How many turns the error of a period adds up to in this time.
fn turns_lost(time: f64, period: f64, error: f64) -> f64 {
    time * error / (period * period)
}

/// 2008: what is left of the forecast, and what would have been needed.
fn later(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, (_, last)) = (published(p)?, observed()?);
    let (motion, body) = (start.motion()?, start.body()?);
    let momentum = motion.angular_momentum();
    let stepped = Scene::new(body).solve_by_stepping(&motion.state(0.0), last.t, 1e-7)?;
    let (there, there_stepped) = (motion.attitude(last.t), stepped.state.attitude);
    let off = |found: &Attitude| off_about(found, &last.attitude, momentum);
    let [miss, azimuth, spin] = off(&there)?;
    let [other_miss, other_azimuth, other_spin] = off(&there_stepped)?;
    let axis = |found: &Attitude| angle_between(found.axis(), last.attitude.axis());
    let seen = body.state(last.attitude, last.angular_velocity)?.angular_momentum;
    let dot = (seen.dot(&momentum) / (seen.norm() * momentum.norm())).clamp(-1.0, 1.0);
    let periods = start.periods()?;
    let [a, b] = periods.map(|period| turns_lost(last.t, period, 0.03 * DAY));
    let share = |period: f64| last.t / period - last.t / (period + 0.03 * DAY);
    // Both are first orders: what they leave is the square.
    let bound = |period: f64, lost: f64| f64::max(0.05, 1.2 * lost * 0.03 * DAY / period);
    let needed = periods[0] * periods[0] * spin.abs() / (360.0 * last.t * DAY);
    let rounded = f64::max(1e-6, 1.2 * needed * needed * DAY / periods[0]);
    let heavier = start.but(|start| start.moments[1] *= 1.01);
    let more = |period: f64, other: f64| 360.0 * (last.t / other - last.t / period);
    let percent = more(periods[0], heavier.periods()?[0]);
    let other_percent = more(elliptic_period(&start)?, elliptic_period(&heavier)?);
    let stretched = last.t / (last.t / periods[0] - spin.abs() / 360.0) / DAY - periods[0] / DAY;
    claims! { report,
        /// miss of 2008
        miss_2008: miss, "deg", "stepped through" => other_miss, within 1e-5;
        /// of the long axis alone
        axis_2008: axis(&there), "deg", "stepped through" => axis(&there_stepped), within 1e-5;
        /// of L
        momentum_2008: angle_between(seen, momentum), "deg", "by its cosine" => acos(dot).to_degrees(), within 1e-9;
        /// of the azimuth of the long axis about L
        azimuth_2008: azimuth, "deg", "stepped through" => other_azimuth, within 1e-5;
        /// of the angle about the long axis
        spin_2008: spin, "deg", "stepped through" => other_spin, within 1e-5;
        /// mean angle between two random attitudes
        random: at_random(), "deg", "an integral" => random_by_integral()?.to_degrees(), within 1e-9, in "2008":
            90.0 => "that is the mean for an axis, not for a whole attitude", 180.0 => "that is the largest";
        /// turns about the long axis since the epoch
        turns: last.t / periods[0], "-", "days over days" => last.t / DAY / (periods[0] / DAY), within 1e-9;
        /// turns about the long axis that 0.03 d are worth by 2008
        lost_spin: a, "-", "the turns counted" => share(periods[0]), within bound(periods[0], a), in "2008":
            last.t / periods[0] => "that is the number of turns", b => "that is of the precession";
        /// turns of the precession that 0.03 d are worth
        lost_precession: b, "-", "the turns counted" => share(periods[1]), within bound(periods[1], b), in "2008";
        /// what one percent of the moment about y is worth in the angle about the long axis
        percent: percent, "deg", "elliptic integrals" => other_percent, within 1e-6 * percent.abs();
        /// change of the first period that would take the spin miss away
        needed: needed, "d", "the turns counted" => stretched, within rounded;
    }
}

/// By how much the attitude, the azimuth about L of the long axis and the angle about it are off,
/// degrees.
fn off_about(found: &Attitude, seen: &Attitude, momentum: SpaceVector) -> Result<[f64; 3]> {
    let up = upright(momentum)?;
    let [of_found, of_seen] = [(up * *found).euler_angles(), (up * *seen).euler_angles()];
    let degrees = |angle: f64| (angle - TAU * (angle / TAU).round()).to_degrees();
    let azimuth = degrees(of_seen.phi - of_found.phi);
    let spin = degrees(of_seen.zeta - of_found.zeta);
    Ok([seen.angle_to(found).to_degrees(), azimuth, spin])
}

/// The flyby of the parameters.
pub fn flyby(p: &Parameters) -> Path {
    Path::flyby(p, p.closest, "2004-09-29T13:37:00")
}

/// That of December 1992, with the Earth farther away.
pub fn first_flyby(p: &Parameters) -> Path {
    Path::flyby(p, 0.0242 * AU, "1992-12-08T05:37:00")
}

// ANCHOR: tide
/// The tide along a path: the library's torque of a body on an orbit by Kepler. The clock of the
/// scene begins at `begin`.
pub fn tide(path: Path, begin: f64) -> rotation_dynamics::Result<OrbitingBody> {
    let [node, inclination, argument] = path.angles;
    let orbit = KeplerOrbit::about(path.attracts, path.closest, path.eccentricity)?
        .oriented(node, inclination, argument)?
        .passing_at(path.when - begin)?;
    OrbitingBody::new(path.attracts, orbit)
}
// ANCHOR_END: tide

/// The flyby of 2004 put in.
fn tides(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, path) = (published(p)?, flyby(p));
    let changed = Changed::by(&start, path, p.tolerance)?;
    let other = Changed::simulated(&start, path, path.span(), 1e-14)?;
    let size = changed.momentum();
    let number = number(&start, &path)?;
    let speed = start.angular_velocity.norm();
    let (n, [x, y, _]) = ((EARTH / p.closest).sqrt() / p.closest, start.moments);
    let by_hand = 3.0 * (n / speed) * (n / speed) * (1.0 - 1.0 / x.max(y));
    let slope = ((path.eccentricity - 1.0) * (path.eccentricity + 1.0)).sqrt();
    let bend = 2.0 * atan2(1.0, slope).to_degrees();
    let far = 1e6 * p.closest / p.speed;
    let (early, late) = (path.place(path.when - far)?, path.place(path.when + far)?);
    let (rate, bound) = (speed.to_degrees() * DAY, 10.0 * p.tolerance);
    claims! { report,
        /// number of the tide at the closest
        tide_number: number, "-", "3 (n/Omega)^2 (1 - I_z/I_max)" => by_hand, within 1e-12 * number, in "The tide":
            number / 3.0 => "a factor 3", number.sqrt() => "it is a square";
        /// eccentricity of the path
        eccentricity: path.eccentricity, "-", "1/sin of half the bend" => 1.0 / sin(0.5 * bend.to_radians()), within 1e-9;
        /// how far the flyby bends the path
        bend: bend, "deg", "the path far away" => 180.0 - angle_between(early, late), within 2e-3;
        /// change of L over L
        tide_momentum: size, "-", "Euler's equations" => other.momentum(), within bound;
        /// change of L over L, times the angular velocity
        tide_rate: size * rate, "deg/d", "Euler's equations" => other.momentum() * rate, within bound * rate;
        /// attitude moved, twenty days after the closest
        tide_attitude: changed.attitude(), "deg", "Euler's equations" => other.attitude(), within 60.0 * bound;
    }
}

/// The flyby with the Earth in six directions, at the one moment of the parameters.
fn flybys(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns =
        "longitude,change of L,turn of L,change of 2 pi/T_1,change of 2 pi/T_2,moves 2008 by";
    let (start, end) = (published(p)?, observed()?.1.t);
    let (before, free) = (start.periods()?, start.motion()?.attitude(end));
    let paths = moved::phases(flyby(p)).take(6);
    report.add(Table::of("flybys", columns.split(','), paths, |path| {
        let changed = Changed::simulated(&start, path, path.span(), 1e-11)?;
        let after = periods(&tide::onward(&start.body()?, &changed.after)?);
        let rate = |i: usize| format!("{:.4} deg/d", (360.0 / after[i] - 360.0 / before[i]) * DAY);
        let turn = angle_between(changed.after.angular_momentum, changed.free.angular_momentum);
        let moved = changed.in_2008(&start, end)?.angle_to(&free).to_degrees();
        Ok([
            format!("{:.0} deg", path.angles[2].to_degrees()),
            format!("{:.2e}", changed.momentum()),
            format!("{turn:.3} deg"),
            rate(0),
            rate(1),
            format!("{moved:.1} deg"),
        ])
    })?)
}

/// A body without differences, one almost without, the Earth far away.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, path) = (published(p)?, flyby(p));
    let thin = start.but(|start| start.moments = [3.2, 3.2 + 1e-9, 1.0]);
    let symmetric = TAU / ((1.0 - 1.0 / 3.2) * start.angular_velocity.z().abs());
    let momentum = thin.motion()?.angular_momentum().norm();
    let far = |closest: f64| number(&start, &Path { closest, ..path });
    let round = Path::orbit().but(|path| path.eccentricity = 1e-12);
    let third = TAU * (round.closest * round.closest * round.closest / round.attracts).sqrt() / 3.0;
    let moved = angle_between(round.place(round.when)?, round.place(round.when + third)?);
    let fast = p.but(|p| (p.speed, p.longitude) = (1e7, 0.0));
    let straight = Path::flyby(&fast, 1e9, EPOCH).place(1000.0)?;
    limits! { report,
        /// a symmetric body: L runs round the axis at (1 - I_z/I_x) Omega_z
        "I_x = I_y: period of the rotation": thin.periods()?[0] / symmetric => 1.0, within 1e-8;
        /// and the axis precesses at L/I_x
        "I_x = I_y: period of the precession": thin.periods()?[1] * momentum / (TAU * 3.2) => 1.0, within 1e-8;
        /// the tide falls with the third power of the distance
        "twice as far: the tide": far(2.0 * p.closest)? / far(p.closest)? => 0.125, within 1e-12;
        /// a circle: equal angles in equal times
        "a circular orbit: a third, in degrees": moved => 120.0, within 1e-6;
        /// fast: the path is a straight line
        "a fast flyby: speed times time over the way": straight.y() / 1e10 => 1.0, within 1e-6;
    }
}

/// The free motion of December, and what it costs by stepping.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, (december, _)) = (published(p)?, observed()?);
    let (scene, motion, end) = (Scene::new(start.body()?), start.motion()?, december[16].t);
    let problem = Problem::new(scene, motion.state(0.0), end, motion.state(end));
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-6, 1e-12])
}

example! {
    ch15_5_toutatis: "Section 15.5: the asteroid Toutatis, its free tumbling and the tides, against radar images";
    "A tumbling asteroid", "The free motion of an asteroid against its published attitudes; then with tides.",
    [free, fits, later, tides, moved::add, flybys, limits, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
