//! Section 15.5: the asteroid Toutatis, its tumbling against seventeen days of radar images,
//! and against one sixteen years later.

#[path = "ch15_5_toutatis/figures.rs"]
mod figures;
#[path = "ch15_5_toutatis/fit.rs"]
mod fit;
#[path = "ch15_5_toutatis/observed.rs"]
mod observed;
#[path = "ch15_5_toutatis/tide.rs"]
mod path;
#[path = "ch15_5_toutatis/picture.rs"]
mod picture;
#[path = "ch15_5_toutatis/tables.rs"]
mod tables;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::interval::between;
use kit::{Report, Result};
use rotation_dynamics::accuracy::{Problem, largest};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{Effect, KeplerOrbit, OrbitingBody};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, ode, size_or};
use rotation_dynamics::math::{acos, atan2, cos, hypot, sin};
use rotation_dynamics::scene::Scene;

pub use fit::{Fit, MIDDLE, Unknowns, jackknife, least_squares, unknowns};
pub use observed::{Observed, attitude, observed, rates, seconds};
pub use path::{AU, Changed, EARTH, HALF, Path, by_kicks, number, under_the_sun};
pub use tables::{Moved, phases};

/// s.
pub const DAY: f64 = 86400.0;
/// When the published state holds, UTC; when the Earth was closest in 2004 and in 1992.
pub const EPOCH: &str = "1992-11-09T17:49:47";
const FLYBY: &str = "2004-09-29T13:37:00";
const FIRST_FLYBY: &str = "1992-12-08T05:37:00";

kit::parameters! {
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

/// A free motion: the moments of inertia (the long axis has 1) and a state.
#[derive(Debug, Clone, Copy)]
pub struct Start {
    pub moments: [f64; 3],
    pub attitude: Attitude,
    pub angular_velocity: BodyVector,
}

// ANCHOR: start
/// The published state of the epoch: Euler angles in degrees, rates in degrees a day.
pub fn published(p: &Parameters) -> Result<Start> {
    Ok(Start {
        moments: [p.moment_x, p.moment_y, 1.0],
        attitude: attitude([145.498, 65.865, 241.524])?,
        angular_velocity: rates([14.51, 33.529, -98.709]),
    })
}

impl Start {
    pub fn body(&self) -> rotation_dynamics::Result<RigidBody> {
        let [x, y, z] = self.moments;
        Ok(RigidBody::new(PrincipalMoments::new(x, y, z)?))
    }

    /// The motion without any torque, in closed form at any time.
    pub fn motion(&self) -> rotation_dynamics::Result<FreeBody> {
        FreeBody::new(self.body()?.moments(), self.attitude, self.angular_velocity)
    }

    /// The period of the rotation about the long axis and that of its precession, s.
    pub fn periods(&self) -> Result<[f64; 2]> {
        let (motion, one) = (self.motion()?, self.motion()?.rate_period());
        Ok([one, one * TAU / motion.precession_per_period().abs()])
    }
}
// ANCHOR_END: start

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
/// axis about L; time in days.
pub fn tumbling([a, b, c]: [f64; 3]) -> impl Ode<8> {
    ode(move |_, &[p, q, r, w, x, y, z, _]: &[f64; 8]| {
        let (across, whole) = (a * a * p * p + b * b * q * q, c * c * r * r);
        let azimuth = (across + whole).sqrt() * (a * p * p + b * q * q) / across;
        [
            (b - c) * q * r / a,
            (c - a) * r * p / b,
            (a - b) * p * q / c,
            -0.5 * (x * p + y * q + z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            azimuth,
        ]
    })
    .scaled(size_or([1.0; 8]))
}

/// A free motion simulated by them over this time, s.
pub fn simulated(start: &Start, time: f64) -> rotation_dynamics::Result<[f64; 8]> {
    Ok(driven(start, 0.0, time)?.0)
}

/// The same with a torque about the long axis that goes with the body, in 1/s^2: over its moment
/// of inertia; and the work.
pub fn driven(
    start: &Start,
    torque: f64,
    time: f64,
) -> rotation_dynamics::Result<([f64; 8], Work)> {
    let [p, q, r] = (start.angular_velocity * DAY).to_array();
    let [w, x, y, z] = start.attitude.quaternion();
    let (free, from) = (tumbling(start.moments), [p, q, r, w, x, y, z, 0.0]);
    let law = ode(|t, state: &[f64; 8]| {
        let mut slope = free.derivative(t, state);
        slope[2] += torque * (DAY * DAY);
        slope
    })
    .scaled(size_or([1.0; 8]));
    Dop853::new(1e-14)?.advance(&law, 0.0, &from, time / DAY)
}

/// The attitudes at some times by the closed form.
pub fn in_closed_form(start: &Start, times: &[f64]) -> rotation_dynamics::Result<Vec<Attitude>> {
    let motion = start.motion()?;
    Ok(times.iter().map(|t| motion.attitude(*t)).collect())
}

/// The same by simulation.
pub fn by_simulation(start: &Start, times: &[f64]) -> rotation_dynamics::Result<Vec<Attitude>> {
    let each = times.iter().map(|t| {
        let [_, _, _, w, x, y, z, _] = simulated(start, *t)?;
        Attitude::from_quaternion([w, x, y, z])
    });
    each.collect()
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

/// By how much the attitude is off, degrees, on each of these days.
pub fn misses(days: &[Observed], found: &[Attitude]) -> Vec<f64> {
    let pairs = days.iter().zip(found);
    pairs.map(|(day, found)| day.attitude.angle_to(found).to_degrees()).collect()
}

/// The root of the mean of the squares.
pub fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64).sqrt()
}

/// How a model carries a start through some times, s from the start: the attitudes.
pub type Model = fn(&Start, &[f64]) -> rotation_dynamics::Result<Vec<Attitude>>;

// ANCHOR: fit
/// The free motion closest to these days: a start in their middle, two moments.
pub fn fitted(days: &[Observed], from: &Start, guess: Unknowns, model: Model) -> Result<Fit> {
    let reference = from.motion()?.attitude(MIDDLE);
    let times: Vec<f64> = days.iter().map(|day| day.t - MIDDLE).collect();
    least_squares(guess, |at| {
        let computed = model(&fit::start(at, &reference)?, &times)?;
        let pairs = computed.iter().zip(days);
        Ok(pairs.flat_map(|(found, day)| turn_between(found, &day.attitude).to_array()).collect())
    })
}
// ANCHOR_END: fit

/// Everything that the report, the tables and the figures share.
#[derive(Debug, Clone)]
pub struct Study {
    pub start: Start,
    /// The state with the published moments, whatever the parameters are: the fit begins there.
    pub printed: Start,
    pub december: Vec<Observed>,
    pub last: Observed,
    pub misses: Vec<f64>,
    pub fit: Fit,
    pub fitted: Start,
    pub fitted_misses: Vec<f64>,
}

impl Study {
    pub fn new(p: &Parameters) -> Result<Self> {
        let (start, printed) = (published(p)?, published(&Parameters::default())?);
        let mut december = observed()?;
        elliptic_period(&start)?;
        let last = december
            .pop()
            .ok_or(kit::Error::Text { text: "toutatis.csv".into(), allowed: "a row a day" })?;
        let times: Vec<f64> = december.iter().map(|day| day.t).collect();
        let found = misses(&december, &in_closed_form(&start, &times)?);
        let fit = fitted(&december, &printed, unknowns(&printed)?, in_closed_form)?;
        let best = fit::start(&fit.at, &printed.motion()?.attitude(MIDDLE))?;
        let shifted: Vec<f64> = times.iter().map(|t| t - MIDDLE).collect();
        let fitted_misses = misses(&december, &in_closed_form(&best, &shifted)?);
        Ok(Self { start, printed, december, last, misses: found, fit, fitted: best, fitted_misses })
    }

    /// The standard deviation of a period of the fit, s.
    pub fn deviation_of_period(&self, which: usize) -> Result<f64> {
        let reference = self.printed.motion()?.attitude(MIDDLE);
        self.fit.deviation_of(|at| Ok(fit::start(at, &reference)?.periods()?[which]))
    }

    /// How many turns the error of a period adds up to by 2008.
    pub fn turns_lost(&self, period: f64, error: f64) -> f64 {
        self.last.t * error / (period * period)
    }
}

/// Every number of the page.
fn report(p: &Parameters) -> Result<Report> {
    let about = "The free motion of an asteroid against its published attitudes; then with tides.";
    let (mut report, study) = (Report::new("A tumbling asteroid", about)?, Study::new(p)?);
    free(&study, &mut report)?;
    fits(&study, &mut report)?;
    later(&study, &mut report)?;
    let moved = Moved::new(p, &study)?;
    tides(p, &study, &moved, &mut report)?;
    tables::add(p, &study, &moved, &mut report)?;
    limits(p, &mut report)?;
    effects(p, &study, &moved, &mut report)?;
    accuracy(p, &study, &mut report)?;
    Ok(report)
}

/// The published state against December 1992.
fn free(study: &Study, report: &mut Report) -> Result<()> {
    let (start, motion) = (study.start, study.start.motion()?);
    let [spin, precession] = start.periods()?.map(|t| t / DAY);
    let other = elliptic_period(&start)? / DAY;
    let azimuth = simulated(&start, spin * DAY)?[7];
    let times: Vec<f64> = study.december.iter().map(|day| day.t).collect();
    let again = misses(&study.december, &by_simulation(&start, &times)?);
    let root = root_mean_square(&study.misses);
    let worst = largest(study.misses.iter().copied());
    let scattered = TAU * spin / azimuth;
    let momentum = motion.angular_momentum();
    let latitude = atan2(momentum.z(), hypot(momentum.x(), momentum.y())).to_degrees();
    let by_angle = 90.0 - angle_between(momentum, SpaceVector::new(0.0, 0.0, 1.0));
    kit::claims! { report,
        /// period of the rotation about the long axis
        spin_period: spin, "d", "an elliptic integral" => other, within 1e-12, in "The free motion":
            precession => "that is the other one";
        /// period of the precession of the long axis
        precession_period: precession, "d", "the precession simulated" => scattered, within 1e-10, in "The free motion":
            spin => "that is the other one";
        /// the first day is missed by
        miss_first: study.misses[0], "deg", "simulated" => again[0], within 1e-9;
        /// the worst day
        miss_worst: worst, "deg", "simulated" => largest(again.iter().copied()), within 1e-9;
        /// root mean square of December 1992
        miss_rms: root, "deg", "simulated" => root_mean_square(&again), within 1e-9;
        /// latitude of L above the ecliptic
        latitude: latitude, "deg", "its angle from the pole" => by_angle, within 1e-12;
    }
}

/// The free motion that comes closest.
fn fits(study: &Study, report: &mut Report) -> Result<()> {
    let (fit, reference) = (&study.fit, study.printed.motion()?.attitude(MIDDLE));
    // From elsewhere, by Euler's equations instead of the closed form.
    let mut guess = unknowns(&study.printed)?;
    guess.iter_mut().for_each(|at| *at = 1.02 * *at + 0.02);
    let other = fitted(&study.december, &study.printed, guess, by_simulation)?;
    let [spin, precession] = study.fitted.periods()?.map(|t| t / DAY);
    let [other_spin, other_precession] =
        fit::start(&other.at, &reference)?.periods()?.map(|t| t / DAY);
    let [sd_spin, sd_precession] =
        [study.deviation_of_period(0)? / DAY, study.deviation_of_period(1)? / DAY];
    let elsewhere =
        |which| other.deviation_of(|at| Ok(fit::start(at, &reference)?.periods()?[which] / DAY));
    let root = root_mean_square(&study.fitted_misses);
    let degrees = fit.scatter.to_degrees();
    kit::claims! { report,
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
        fit_spin_sd: sd_spin, "d", "another start, simulated" => elsewhere(0)?, within 1e-6;
        /// period of the precession
        fit_precession: precession, "d", "another start, simulated" => other_precession, within 1e-6;
        /// its standard deviation
        fit_precession_sd: sd_precession, "d", "another start, simulated" => elsewhere(1)?, within 1e-6;
    }
}

/// The mean angle between two attitudes drawn at random, degrees.
pub fn at_random() -> f64 {
    (FRAC_PI_2 + 2.0 / PI).to_degrees()
}

/// 2008: what is left of the forecast, and what would have been needed.
fn later(study: &Study, report: &mut Report) -> Result<()> {
    let (last, motion) = (study.last, study.start.motion()?);
    let (there, momentum) = (motion.attitude(last.t), motion.angular_momentum());
    let solved =
        Scene::new(study.start.body()?).solve_by_stepping(&motion.state(0.0), last.t, 1e-7)?.state;
    let z = BodyVector::new(0.0, 0.0, 1.0);
    let axis = |attitude: &Attitude| attitude.to_space(z);
    let of = |found: &Attitude| {
        let off = angle_between(axis(found), axis(&last.attitude));
        [last.attitude.angle_to(found).to_degrees(), off]
    };
    let ([miss, off], [again, off_again]) = (of(&there), of(&solved.attitude));
    let seen = study.start.body()?.state(last.attitude, last.angular_velocity)?.angular_momentum;
    let moved = angle_between(seen, momentum);
    let dot = (seen.dot(&momentum) / (seen.norm() * momentum.norm())).clamp(-1.0, 1.0);
    let [azimuth, spin] = off_about(&there, &last.attitude, momentum)?;
    let [azimuth_again, spin_again] = off_about(&solved.attitude, &last.attitude, momentum)?;
    let periods = study.start.periods()?;
    let [a, b] = periods.map(|period| study.turns_lost(period, 0.03 * DAY));
    let share = |period: f64| last.t / period - last.t / (period + 0.03 * DAY);
    // Both are first orders: what they leave is the square.
    let bound = |period: f64, lost: f64| f64::max(0.05, 1.2 * lost * 0.03 * DAY / period);
    let needed = periods[0] * periods[0] * spin.abs() / (360.0 * last.t * DAY);
    let rounded = f64::max(1e-6, 1.2 * needed * needed * DAY / periods[0]);
    let heavier = Start {
        moments: [study.start.moments[0], 1.01 * study.start.moments[1], 1.0],
        ..study.start
    };
    let more = |period: f64, other: f64| 360.0 * (last.t / other - last.t / period);
    let percent = more(periods[0], heavier.periods()?[0]);
    let percent_again = more(elliptic_period(&study.start)?, elliptic_period(&heavier)?);
    let stretched = last.t / (last.t / periods[0] - spin.abs() / 360.0) / DAY - periods[0] / DAY;
    kit::claims! { report,
        /// miss of 2008
        miss_2008: miss, "deg", "stepped through" => again, within 1e-5;
        /// of the long axis alone
        axis_2008: off, "deg", "stepped through" => off_again, within 1e-5;
        /// of L
        momentum_2008: moved, "deg", "by its cosine" => acos(dot).to_degrees(), within 1e-9;
        /// of the azimuth of the long axis about L
        azimuth_2008: azimuth, "deg", "stepped through" => azimuth_again, within 1e-5;
        /// of the angle about the long axis
        spin_2008: spin, "deg", "stepped through" => spin_again, within 1e-5;
        /// mean angle between two random attitudes
        random: at_random(), "deg", "an integral" => random_by_integral()?.to_degrees(), within 1e-9, in "2008":
            90.0 => "that is the mean for an axis, not for a whole attitude",
            180.0 => "that is the largest";
        /// turns about the long axis since the epoch
        turns: last.t / periods[0], "-", "days over days" => last.t / DAY / (periods[0] / DAY), within 1e-9;
        /// turns about the long axis that 0.03 d are worth by 2008
        lost_spin: a, "-", "the turns counted" => share(periods[0]), within bound(periods[0], a), in "2008":
            last.t / periods[0] => "that is the number of turns",
            b => "that is of the precession";
        /// turns of the precession that 0.03 d are worth
        lost_precession: b, "-", "the turns counted" => share(periods[1]), within bound(periods[1], b), in "2008";
        /// what one percent of the moment about y is worth in the angle about the long axis
        percent: percent, "deg", "elliptic integrals" => percent_again, within 1e-6 * percent.abs();
        /// change of the first period that would take the spin miss away
        needed: needed, "d", "the turns counted" => stretched, within rounded;
    }
}

/// By how much the azimuth about L of the long axis and the angle about it are off, degrees.
pub fn off_about(found: &Attitude, seen: &Attitude, momentum: SpaceVector) -> Result<[f64; 2]> {
    let up = upright(momentum)?;
    let [found, seen] = [(up * *found).euler_angles(), (up * *seen).euler_angles()];
    let degrees = |angle: f64| (angle - TAU * (angle / TAU).round()).to_degrees();
    Ok([degrees(seen.phi - found.phi), degrees(seen.zeta - found.zeta)])
}

/// The same by an integral: the angle is spread as (1 - cos a)/pi.
fn random_by_integral() -> Result<f64> {
    let spread = ode(|a: f64, _: &[f64; 1]| [a * (1.0 - cos(a)) / PI]).scaled(size_or([1.0; 1]));
    Ok(Dop853::new(1e-14)?.advance(&spread, 0.0, &[0.0], PI)?.0[0])
}

/// The flyby of the parameters.
pub fn flyby(p: &Parameters) -> Path {
    passage(p, p.closest, FLYBY)
}

/// That of December 1992, with the Earth farther away.
pub fn first_flyby(p: &Parameters) -> Path {
    passage(p, 0.0242 * AU, FIRST_FLYBY)
}

fn passage(p: &Parameters, closest: f64, date: &str) -> Path {
    Path::flyby(closest, p.speed, p.longitude, seconds(date) - seconds(EPOCH))
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

/// [`tumbling`] with a tide.
pub fn pulled([a, b, c]: [f64; 3], tide: OrbitingBody) -> impl Ode<8> {
    let free = tumbling([a, b, c]);
    ode(move |t, state: &[f64; 8]| {
        let mut slope = free.derivative(t, state);
        let [w, x, y, z] = [state[3], state[4], state[5], state[6]];
        let (v, strength) = tide.pull(t * DAY);
        // The direction on the body's axes: v + 2 (v x u) w + 2 (v x u) x u.
        let u = SpaceVector::new(x, y, z);
        let across = v.cross(&u) * 2.0;
        let [l, m, n] = (v + across * w + across.cross(&u)).to_array();
        let pull = 3.0 * strength * (DAY * DAY);
        slope[0] += pull * (c - b) * m * n / a;
        slope[1] += pull * (a - c) * n * l / b;
        slope[2] += pull * (b - a) * l * m / c;
        slope
    })
    .scaled(size_or([1.0; 8]))
}

/// Attitude and angular momentum at a time after a tide that begins to act at `begin`, by
/// Euler's equations, and the work: another method, in other variables.
pub fn simulated_under(
    start: &Start,
    path: Path,
    [begin, end]: [f64; 2],
    step: f64,
) -> Result<(Attitude, SpaceVector, Work)> {
    let at = start.motion()?.kinematics(begin);
    let ([a, b, c], [p, q, r]) = (start.moments, (at.angular_velocity * DAY).to_array());
    let [w, x, y, z] = at.attitude.quaternion();
    let law = pulled(start.moments, tide(path, begin)?);
    let from = [p, q, r, w, x, y, z, 0.0];
    let (end, work) = Dop853::new(step)?.advance(&law, 0.0, &from, (end - begin) / DAY)?;
    let attitude = Attitude::from_quaternion([end[3], end[4], end[5], end[6]])?;
    let momentum = BodyVector::new(a * end[0], b * end[1], c * end[2]) / DAY;
    Ok((attitude, attitude.to_space(momentum), work))
}

/// The flyby of 2004 put in; and the Sun.
fn tides(p: &Parameters, study: &Study, moved: &Moved, report: &mut Report) -> Result<()> {
    let (start, path) = (study.start, flyby(p));
    let changed = Changed::by(&start, path, p.tolerance)?;
    let span = [path.when - path::HALF, path.when + path::HALF];
    let (attitude, momentum, _) = simulated_under(&start, path, span, 1e-14)?;
    let free = changed.free.angular_momentum;
    let (size, other) = (changed.momentum(), (momentum - free).norm() / free.norm());
    let off = |attitude: &Attitude| attitude.angle_to(&changed.free.attitude).to_degrees();
    let apart = off(&changed.after.attitude);
    let number = number(&start, &path)?;
    let speed = start.angular_velocity.norm();
    let (n, [x, y, _]) = ((EARTH / p.closest).sqrt() / p.closest, start.moments);
    let by_hand = 3.0 * (n / speed) * (n / speed) * (1.0 - 1.0 / x.max(y));
    let slope = ((path.eccentricity - 1.0) * (path.eccentricity + 1.0)).sqrt();
    let bend = 2.0 * atan2(1.0, slope).to_degrees();
    let far = 1e6 * p.closest / p.speed;
    let (early, late) = (path.place(path.when - far)?, path.place(path.when + far)?);
    let (rate, end) = (speed.to_degrees() * DAY, study.last.t);
    let sunlit = under_the_sun(&start, end)?;
    let by_sun = sunlit.angle_to(&start.motion()?.attitude(end)).to_degrees();
    let bound = 10.0 * p.tolerance;
    kit::claims! { report,
        /// number of the tide at the closest
        tide_number: number, "-", "3 (n/Omega)^2 (1 - I_z/I_max)" => by_hand, within 1e-12 * number, in "The tide":
            number / 3.0 => "a factor 3",
            number.sqrt() => "it is a square";
        /// eccentricity of the path
        eccentricity: path.eccentricity, "-", "1/sin of half the bend" => 1.0 / sin(0.5 * bend.to_radians()), within 1e-9;
        /// how far the flyby bends the path
        bend: bend, "deg", "the path far away" => 180.0 - angle_between(early, late), within 2e-3;
        /// change of L over L
        tide_momentum: size, "-", "Euler's equations" => other, within bound;
        /// change of L over L, times the angular velocity
        tide_rate: size * rate, "deg/d", "Euler's equations" => other * rate, within bound * rate;
        /// attitude moved, twenty days after the closest
        tide_attitude: apart, "deg", "Euler's equations" => off(&attitude), within 60.0 * bound;
        /// attitude of 2008 moved by the tide of the Sun
        sun_2008: moved.sun[0], "deg", "Gauss-Legendre 16" => by_sun, within 1e-4;
    }
}

/// A body without differences, one almost without, the Earth far away.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let start = published(p)?;
    let thin = Start { moments: [3.2, 3.2 + 1e-9, 1.0], ..start };
    let [_, _, w] = start.angular_velocity.to_array();
    let symmetric = TAU / ((1.0 - 1.0 / 3.2) * w.abs());
    let momentum = thin.motion()?.angular_momentum().norm();
    let path = Path::flyby(p.closest, p.speed, p.longitude, 0.0);
    let far = |closest: f64| number(&start, &Path { closest, ..path });
    let round = Path { eccentricity: 1e-12, ..Path::orbit() };
    let third = TAU * (round.closest * round.closest * round.closest / round.attracts).sqrt() / 3.0;
    let moved = angle_between(round.place(round.when)?, round.place(round.when + third)?);
    let straight = Path::flyby(1e9, 1e7, 0.0, 0.0).place(1000.0)?;
    kit::limits! { report,
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

/// The card of effects: what each is worth in the attitude of 2008.
fn effects(p: &Parameters, study: &Study, moved: &Moved, report: &mut Report) -> Result<()> {
    let (start, end) = (study.start, study.last.t);
    // Light pushes a crooked body: a hundredth of its pressure on the cross-section of a ball with
    // a radius of 1.2 km, which is also the arm, and 1.9e13 kg.
    let pressure =
        4.56e-6 * (AU * AU) / (2.5321 * AU * (2.5321 * AU) * ((1.0_f64 - 0.6288) * 1.6288).sqrt());
    let push = 0.01 * pressure * PI * 1.2e3 / (0.4 * 1.9e13);
    // Tumbling bends it: rigidity times quality 5e12 Pa, 2500 kg/m^3, shape factor 0.03 (Harris).
    let w = start.angular_velocity.norm();
    let damping = 5e12 / (2500.0 * 0.03 * 1.2e3 * 1.2e3 * w * w * w);
    let friction = end / damping;
    // As if all of it turned the body about its long axis.
    let ([_, _, _, a, x, y, z, _], by_light) = driven(&start, push, end)?;
    let lit = Attitude::from_quaternion([a, x, y, z])?;
    // Each tide by kicks along the free motion; the Earth in the worst of its phases.
    let earth = |path: Path| -> Result<f64> {
        let each = phases(path)
            .map(|path| by_kicks(&start, path, [path.when - HALF, path.when + HALF], end));
        Ok(largest(each.collect::<Result<Vec<_>>>()?).to_degrees())
    };
    let (own, first) = (earth(flyby(p))?, earth(first_flyby(p))?);
    let sun = by_kicks(&start, Path::orbit(), [0.0, end], end)?.to_degrees();
    // What goes round too far comes back from the other side.
    let told = |predicted: f64, [moved, ..]: [f64; 3]| (predicted < 60.0).then_some(moved);
    let [by_sun, by_first, by_own] = moved.work;
    kit::effect_card! { report,
        "tide of the Earth, 2004": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &flyby(p))?, costs own, "deg in 2008, at most, to first order",
            measured told(own, moved.own), within 1e-5, at_work by_own, included;
        "tide of the Earth, 1992": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &first_flyby(p))?, costs first, "deg in 2008, at most, to first order",
            measured told(first, moved.first), within 1e-5, at_work by_first;
        "tide of the Sun": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &Path::orbit())?, costs sun, "deg in 2008, to first order",
            measured told(sun, moved.sun), within 1e-5, at_work by_sun;
        "push of light on a crooked body": "torque x t/(I Omega)" = push * end / w, costs (0.5 * push * end * end).to_degrees(), "deg in 2008, about",
            measured lit.angle_to(&start.motion()?.attitude(end)).to_degrees(), at_work by_light;
        "friction inside": "t over the time of damping" = friction, costs (friction * w * end).to_degrees(), "deg in 2008, about";
    }
}

/// The free motion of December, and what it costs by stepping.
fn accuracy(p: &Parameters, study: &Study, report: &mut Report) -> Result<()> {
    let (motion, end) = (study.start.motion()?, study.december[16].t);
    let scene = Scene::new(study.start.body()?);
    let problem = Problem::new(scene, motion.state(0.0), end, motion.state(end));
    report.strip(
        &problem.in_closed_form(move |t| motion.attitude(t)),
        &[p.tolerance, 1e-3, 1e-6, 1e-12],
    )
}

kit::example! {
    ch15_5_toutatis: "Section 15.5: the asteroid Toutatis, its free tumbling and the tides, against radar images";
    report, figures::figures, picture::trajectory, picture::moving_picture
}
