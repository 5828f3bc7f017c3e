//! Exercise 16.7: a pendulum of a rod and a disc that is fixed to it, or free on its axle.

#[path = "ch16_ex7_rod_and_disc/figures.rs"]
mod figures;
#[path = "ch16_ex7_rod_and_disc/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use kit::{Asked, Recorded, Recordings};
use physics::*;
use rotation_dynamics::Error;
use rotation_dynamics::exact::pendulum::Pendulum;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{MassProperties, solids};
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, Solution, Work};
use rotation_dynamics::integrators::{after, second_order, small_frequency};

parameters! {
    /// The pendulum of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// length of the rod
        length: number(1.0, "m", above(0.0).usually(0.3, 2.0)).drawn(0.6, 1.6, 0.1);
        /// mass of the rod
        rod: number(0.6, "kg", above(0.0).usually(0.1, 2.0)).drawn(0.3, 1.2, 0.1);
        /// mass of the disc
        disc: number(1.1, "kg", above(0.0).usually(0.1, 3.0)).drawn(0.5, 2.0, 0.1);
        /// radius of the disc
        radius: number(0.2, "m", above(0.0).usually(0.05, 0.9)).drawn(0.10, 0.30, 0.02).open("radius of the disc", "small", "wide");
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// angle of the wide swing, released at rest
        release: number(1.0, "rad", between(-PI, PI).because("pi is upright").usually(0.1, 3.0)).drawn(0.6, 1.4, 0.1).open("angle at the release", "a small swing", "nearly upright");
        /// torque in a greased axle over how fast the disc turns in it
        friction: number(0.07, "N m s", at_least(0.0).usually(0.005, 1.0));
        tolerance: step(1e-13, 1e-3);
    }
}

/// [`Between`], simulated: period in 1/W and decay in W, between two zeros of a small swing
/// that come late enough for disc and rod to have found their rhythm. They find it at the rate
/// `drag` or faster, while the swing itself decays at the rate `share * drag / 2` at most.
pub fn measured(share: f64, drag: f64) -> Result<[f64; 2]> {
    let (scene, method) = (coupled(share, drag, |angle| angle), Dop853::new(1e-15)?);
    let mut start = [1.0, 0.0, 0.0, 0.0];
    for _ in 0..(6.0 / (1.0 - 0.5 * share)).ceil() as u32 {
        let late = after(6.0 / drag + 1.0, &scene, &start, 1e-15)?;
        // Small swings do not depend on their size: it is 1 again.
        let size = hypot(late[0], late[1]);
        start = [late[0] / size, late[1] / size, 0.0, late[3] / size];
    }
    let zero = |n| method.zero(&scene, start, n, 40.0, |y| y[0]);
    let ((first, _), (third, _)) = (zero(1)?, zero(3)?);
    let period = third.t - first.t;
    Ok([period, log(first.state[1] / third.state[1]) / period])
}

/// [`worst`], simulated: where a little more friction and a little less damp alike.
pub fn measured_worst(share: f64) -> Result<f64> {
    let more = |drag: f64| -> Result<bool> {
        Ok(measured(share, 1.002 * drag)?[1] > measured(share, drag / 1.002)?[1])
    };
    Ok(try_bisect([0.2, 2.0], 1e-7, more)?[0])
}

/// Rod and, where it has an angle of its own, disc: at rest, turned by this angle.
fn at_rest<const N: usize>(angle: f64) -> [f64; N] {
    core::array::from_fn(|i| if i.is_multiple_of(2) { angle } else { 0.0 })
}

/// The motion with two angles, from rest at `angle`, in units of 1/W.
pub fn swung(share: f64, drag: f64, angle: f64, end: f64, step: f64) -> Result<Solution<4>> {
    Ok(Dop853::new(step)?.solve(&two_angles(share, drag), 0.0, &at_rest(angle), end, &[])?)
}

/// How long the return of a wide swing is awaited, in units of 1/W, the disc being free: what goes
/// over the top never returns.
const LONG: f64 = 1e3;

/// When a wide swing returns, in units of 1/W and before `until`, with which state, and the work.
fn returns<const N: usize>(
    scene: &impl Ode<N>,
    angle: f64,
    until: f64,
    step: f64,
) -> Result<(LocatedEvent<N>, Work)> {
    Ok(Dop853::new(step)?.zero(scene, at_rest(angle), 2, until, |y| y[1])?)
}

/// Angular frequency of small swings, in W.
fn small_rate<const N: usize>(scene: &impl Ode<N>) -> Result<f64> {
    Ok(small_frequency(scene, at_rest, 1e6, |y| y[1])?)
}

/// Rod and disc put together by the library, the disc's centre so far from the pivot: the
/// moment of inertia about the pivot, of the whole and of the rod with a ball at the centre.
fn assembled(p: &Parameters, far: f64) -> Result<[f64; 2]> {
    // The axle is along e1 for the rod and along e3 for the disc as the library makes them.
    let down = |far: f64| DesignVector::new(0.0, 0.0, -far);
    let rod = solids::rod(p.rod, p.length)?.displaced(down(0.5 * p.length))?;
    let ball = MassProperties::of_points(&[(p.disc, down(far))])?;
    let both = MassProperties::of_parts(&[rod, ball])?;
    let own = solids::disc(p.disc, p.radius)?.about_centre_of_mass().matrix()[2][2];
    let carried = both.about(DesignVector::zero())?.matrix()[0][0];
    Ok([carried + own, carried])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (release, size) = (p.release, p.release.abs());
    let small = "it must be off the vertical by 1e-6 rad: smaller swings are small swings";
    require(size >= 1e-6, "release", release, small)?;
    let upright = "it must be off pi by 1e-9 rad: released upright it stays there";
    require(size <= PI - 1e-9, "release", release, upright)?;
    let m = Moments::new(p)?;
    let (unit, share, fixed, step) = (1.0 / m.rate(), m.share, m.carried + m.own, p.tolerance);
    let period = |moment, release| Ok::<_, kit::Error>(pendulum(p, moment, release)?.period());
    let (t_fixed, t_free) = (period(fixed, 0.0)?, period(m.carried, 0.0)?);
    let (w_fixed, w_free) = (period(fixed, p.release)?, period(m.carried, p.release)?);
    let (loose, welded) = (two_angles(share, 0.0), one_angle(share));
    let (slow, stiff) = (small_rate(&loose)?, small_rate(&welded)?);
    let long = LONG * (1.0 + share).sqrt();
    // A step counts the more near the upright position, and in a tiny swing.
    let top = cos(0.5 * p.release);
    let bound = (30.0 + 10.0 / (top * top) + 1.0 / p.release.abs()) * step;
    let told = bound < 0.1; // else no step can confirm it
    let [all, carried] = assembled(p, p.length)?;
    // The most that the joint has to pass on to the disc, from how the disc starts to turn.
    let hardest = p.release.abs().min(FRAC_PI_2);
    let (most, hard) = (sin(hardest), pendulum(p, fixed, hardest)?);
    let grip = m.own * m.gravity * most / fixed;
    let spin = |t: f64| Ok::<_, Error>(m.own * hard.at(t * w_fixed)?.omega.abs() / (t * w_fixed));
    let starts = (4.0 * spin(1e-4)? - spin(2e-4)?) / 3.0;
    // A greased axle.
    let drag = p.friction * unit / m.own;
    let (between, damped) = (Between::new(share, drag), worst(share));
    let ours = 2.0 * PI * unit / between.frequency;
    let worst_friction = damped * m.own / unit;
    let told_greased = m.is_felt() && (1e-2..=1e2).contains(&drag);
    let [swing, decay] = if told_greased { measured(share, drag)? } else { [0.0; 2] };
    let part = |decay: f64, period: f64| 1.0 - exp(-decay * period);
    let lost = part(between.decay, 2.0 * PI / between.frequency);
    let most_lost = 0.25 * share / (1.0 + share).sqrt();
    // The disc hung by its rim.
    let far = p.length + p.radius;
    let pull = (0.5 * p.rod * p.length + p.disc * far) * p.gravity;
    let period = |moment: f64| 2.0 * PI * (moment / pull).sqrt();
    let sum = p.rod * p.length * p.length / 3.0 + p.disc * far * far + m.own;
    let (rim, by_rim) = (period(sum), period(assembled(p, far)?[0]));
    let [[slower, ratio], _] = by_the_rim(p, &m);
    let (rim_free, shape) = (2.0 * PI / slower, |size: f64| [size, 0.0, size * ratio, 0.0]);
    let rim_slow = || small_frequency(&double(p, &m), shape, 4.0 * rim_free, |y| y[1]);
    let rod_only = 2.0 * PI * (2.0 * p.length / (3.0 * p.gravity)).sqrt();
    claims! { report,
        /// moment of inertia, the disc fixed
        inertia_fixed: fixed, "kg m^2", "put together of solids" => all, within 1e-13 * fixed,
        in "Moments of inertia about the pivot":
            m.carried => "the disc turns with the rod", m.carried + 0.5 * m.own => "that is a disc about its diameter",
            fixed - 0.25 * p.rod * p.length * p.length => "the rod turns about its end";
        /// moment of inertia, the disc free
        inertia_free: m.carried, "kg m^2", "put together of solids" => carried, within 1e-13 * fixed,
        in "Moments of inertia about the pivot":
            fixed => "nothing turns the disc", p.rod * p.length * p.length / 3.0 => "the disc still has to be carried along";
        /// period of small swings, the disc fixed
        period_fixed: t_fixed, "s", "simulated" => 2.0 * PI * unit / stiff, within 1e-9 * t_fixed, in "Periods of small swings":
            2.0 * PI * (p.length / p.gravity).sqrt() => "that is for all mass at the end",
            rod_only => "that is the rod alone", 0.5 * t_fixed => "a period is there and back",
            t_free => "that is the other case";
        /// period of small swings, the disc free
        period_free: t_free, "s", "two angles, simulated" => 2.0 * PI * unit / slow, within 1e-9 * t_free,
        in "Periods of small swings":
            t_fixed => "that is the other case";
        /// period from the release, the disc fixed
        wide_fixed: w_fixed, "s", "located event" => unit * returns(&welded, p.release, long, step)?.0.t,
        within bound * w_fixed, if told, in "The wide swing":
            t_fixed => "a wide swing takes longer",
            t_fixed * (1.0 + p.release * p.release / 16.0) => "that is the first term of a series";
        /// period from the release, the disc free
        wide_free: w_free, "s", "two angles, located event" => unit * returns(&loose, p.release, LONG, step)?.0.t,
        within bound * w_free, if told, in "The wide swing":
            t_free => "a wide swing takes longer",
            t_free * (1.0 + p.release * p.release / 16.0) => "that is the first term of a series";
        /// swings until the free one is half a swing ahead
        ahead: 0.5 * (1.0 + (m.carried / fixed).sqrt()) * fixed / m.own, "-", "the simulated periods" => 0.5 * slow / (slow - stiff),
        within ((1e-6 + 1e-12 / share) / share).max(1e-12), if share >= 1e-8;
        /// torque that the fixed joint must hold
        grip: grip, "N m", "how fast the disc's turning grows" => starts, within 1e-6 * grip, in "The joint":
            m.gravity * sin(p.release) => "that turns the whole pendulum",
            m.own * m.gravity * most / m.carried => "the disc is fixed here";
        /// greased axle: period of small swings
        greased: ours, "s", "two angles, simulated" => unit * swing, within 1e-12 * ours, if told_greased;
        /// part of the amplitude lost in a swing
        lost: lost, "-", "two angles, simulated" => part(decay, swing), within 1e-12, if told_greased;
        /// part of the disc's own moment that goes along
        part: between.part, "-", "from the simulated swing" => ((decay * decay + 4.0 * PI * PI / (swing * swing)).recip() - 1.0) / share,
        within 1e-11 / share, if told_greased;
        /// friction of the fastest decay
        worst: worst_friction, "N m s", "simulated, bisected" => measured_worst(share)? * m.own / unit,
        within 1e-4 * worst_friction, if m.is_felt();
        /// part of the amplitude that is lost there
        most_lost: part(most_lost, 2.0 * PI / Between::new(share, damped).frequency), "-",
        "two angles, simulated" => { let [period, decay] = measured(share, damped)?; part(decay, period) }, within 1e-12, if m.is_felt();
        /// hung by the rim, fixed: period of small swings
        rim_fixed: rim, "s", "put together of solids" => by_rim, within 1e-13 * rim;
        /// hung by the rim, free: period of the slow small swing
        rim_free: rim_free, "s", "double pendulum, simulated" => 2.0 * PI / rim_slow()?, within 1e-6 * rim_free,
        if (1e-6..1e4).contains(&(p.radius / p.length));
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let unit = p.but(|p| (p.length, p.gravity) = (1.0, 1.0));
    let with = |rod, disc, radius| unit.but(|p| (p.rod, p.disc, p.radius) = (rod, disc, radius));
    let swing = |q: &Parameters, release: f64, hold: f64| -> Result<f64> {
        let m = Moments::new(q)?;
        Ok(pendulum(q, m.carried + hold * m.own, release)?.period() / (2.0 * PI))
    };
    let (light, point, wheel) = (with(1.0, 1e-6, 0.2), with(1.0, 1.0, 1e-3), with(1e-9, 1.0, 1e-3));
    let high = 2.0 * PI * swing(&point, PI - 1e-4, 0.0)? / swing(&point, 0.0, 0.0)?;
    let [loose, tight] = [1e-4, 1e4].map(|drag| Between::new(0.02, drag));
    limits! { report,
        /// the rod alone, 2 pi sqrt(2 l/(3 g))
        "M = 0: T/(2 pi sqrt(l/g))": swing(&light, 0.0, 1.0)? => (2.0_f64 / 3.0).sqrt(), within 1e-6;
        /// a small disc has nothing to turn
        "R = 0: T_fixed/T_free": swing(&point, 0.0, 1.0)? / swing(&point, 0.0, 0.0)? => 1.0, within 1e-6;
        /// a weight on a string
        "R = 0, m = 0: T/(2 pi sqrt(l/g))": swing(&wheel, 0.0, 1.0)? => 1.0, within 1e-6;
        /// nearly upright: the period grows as a logarithm
        "theta0 = pi - x: W T - 4 log(8/x)": high - 4.0 * log(8e4) => 0.0, within 1e-6;
        /// a slippery axle lets the disc be
        "c = x: part that goes along": loose.part => 0.0, within 1e-7;
        /// a tough one takes it along
        "c = 1/x: part that goes along": tight.part => 1.0, within 1e-7;
        /// and neither takes energy
        "both: kappa/W": loose.decay.max(tight.decay) => 0.0, within 1e-6;
    }
}

/// An aluminium disc on a steel pin of 5 mm in a ball bearing; a rod 2 cm wide.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = Moments::new(p)?;
    let (fixed, w2, air) = (m.carried + m.own, m.gravity / m.carried, 1.204 / 2700.0);
    let size = sin(0.5 * p.release) * sin(0.5 * p.release);
    let longer = pendulum(p, fixed, p.release)?.period() / pendulum(p, fixed, 0.0)?.period() - 1.0;
    let pin = 0.002 * 0.005 * (p.rod + p.disc) * p.gravity / m.gravity;
    let off = 0.001 * p.disc * p.length; // M l e
    let askew = off * off * w2 / (m.carried * (m.own * w2 - 0.001 * p.disc * p.gravity));
    let (bearing, wide) = (1e-4 / (m.own * w2.sqrt()), 4e-4 / (p.length * p.length));
    // Small swings from 1 rad over 1: a turn of the phase, and two half swings that rub. A tiny disc
    // goes along at once, and a large one is not left out.
    let greased = coupled(m.share, bearing, |angle| angle);
    let turned = || after(2.0 * PI, &greased, &at_rest(1.0), 1e-13);
    let rubbed = when(bearing < 1e4 && m.share * bearing < 0.1, turned)?.map(|end| 1.0 - end[0]);
    let half = |from: f64| -> Result<f64> {
        let law = second_order(|_, angle, _| -angle + pin * from.signum());
        Ok(Dop853::new(1e-13)?.zero(&law, [from, 0.0], 1, 9.0, |y| y[1])?.0.state[0])
    };
    let stopped = when(pin < 0.25, || half(half(1.0)?))?;
    let (welded, long) = (one_angle(m.share), LONG * (1.0 + m.share).sqrt());
    let wide_period =
        |release: f64| -> Result<f64> { Ok(returns(&welded, release, long, 1e-13)?.0.t) };
    effect_card! { report,
        "size of the swing": "sin^2(theta0/2)" = size, costs longer, "of T",
            measured wide_period(p.release)? / wide_period(1e-3 * p.release)? - 1.0, within 1e-9, included;
        "buoyancy in air": "rho_a/rho" = air, costs 0.5 * air, "of T";
        "friction at the pivot": "mu r (m + M) g/D" = pin, costs 4.0 * pin, "rad of amplitude a swing",
            measured stopped.map(|left| 1.0 - left), within 1e-9;
        "the free disc's bearing": "c/(J W)" = bearing, costs PI * m.share * bearing, "of the amplitude a swing",
            measured rubbed, within 1e-9;
        "disc 1 mm off its axle, free": "e/R" = 0.001 / p.radius, costs 0.5 * askew.abs(), "of T";
        "width of the rod": "w^2/l^2" = wide, costs p.rod * wide * p.length * p.length / (24.0 * fixed), "of T";
    }
}

/// What it costs to hold the disc by friction, which is not how to simulate a joint.
fn held(p: &Parameters, report: &mut Report) -> Result<()> {
    let m = Moments::new(p)?;
    if !m.is_felt() {
        return Ok(());
    }
    let columns = "friction over c^*; period; derivatives; RK4, 100 steps";
    report.add(Table::of("held", columns.split("; "), 0..5, |power| {
        let drag = 10.0_f64.powi(power) * worst(m.share);
        let (back, work) = returns(&two_angles(m.share, drag), p.release, LONG, 1e-10)?;
        // Its steps must be shorter than 2.785 over the fastest rate.
        let stable = (1.0 + m.share) * drag * 0.02 * PI < 2.785;
        let name = ["grows without bound", "stable"][usize::from(stable)];
        let (drag, period) = (format!("1e{power}"), format!("{:.6} s", back.t / m.rate()));
        Ok([drag, period, work.derivatives.to_string(), name.into()])
    })?)
}

/// The accuracy strip: the wide swing with two angles, for a period.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, release) = (Moments::new(p)?, p.release);
    let exact = pendulum(p, m.carried, release)?;
    let period = exact.period() * m.rate();
    report.set_closed_form(ClosedForm::new(move |part| exact.at(part * exact.period())));
    let swing = move |step| match returns(&two_angles(m.share, 0.0), release, LONG, step) {
        // Released high up, a coarse run goes over the top.
        Err(kit::Error::Library(Error::NotReached { .. })) => {
            Err(Error::NotDelivered { requested: step, best: PI, condition: None }.into())
        }
        swing => swing,
    };
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-15];
    report.dial_of_return(asked, swing, period, release)
}

/// A reader's own swing: the recording of a phone's gyroscope, fitted by the exact pendulum.
const RECORDINGS: Recordings<Parameters> =
    Recordings { throws: false, made: models::swings::made, recorded };

fn recorded(p: &Parameters, name: &str, bytes: &[u8], asked: &Asked) -> Result<Recorded> {
    let m = Moments::new(p)?;
    let length = |moment: f64| moment * p.gravity / m.gravity;
    let own = [("disc fixed", length(m.carried + m.own)), ("disc free", length(m.carried))];
    models::swings::recorded(name, bytes, asked, p.gravity, &own)
}

example! {
    ch16_ex7_rod_and_disc: "Exercise 16.7: a pendulum of a rod and a disc";
    "A pendulum of rod and disc", "A rod hangs on a pivot; the disc at its end is fixed to it, or free on its axle.",
    [claims, limits, effects, held, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture; RECORDINGS
}
