//! The wobble of the Earth: a nearly round body turns freely, Chapter 15, Section 5.

#[path = "ch15_5_earth/equinoxes.rs"]
pub mod equinoxes;
#[path = "ch15_5_earth/figures.rs"]
mod figures;
#[path = "ch15_5_earth/yielding.rs"]
pub mod yielding;

use core::f64::consts::{PI, TAU};
use equinoxes::{ARCSEC, MOON, OBLIQUITY, SUN, YEAR};
use kit::prelude::*;
use kit::supported_digits;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, ode};
use rotation_dynamics::math::round_even;
use rotation_dynamics::scene::Scene;

parameters! {
    /// The Earth of the notes, as a rigid body with two equal moments.
    pub struct Parameters {
        /// moment of inertia about an axis in the equator, over M R^2
        a: number(0.329_591, "-", between(0.01, 0.5).because("a planet with a dense core has little, a hollow one 2/3").usually(0.32, 0.3304));
        /// moment of inertia about the figure axis, over M R^2
        c: number(0.330_675, "-", between(0.01, 0.5).because("a planet with a dense core has little, a hollow one 2/3").usually(0.33, 0.34)).open("moment about the figure axis, over M R^2", "nearly a ball", "flatter");
        /// distance of the pole of rotation from the figure axis, on the ground
        wander: number(10.0, "m", above_to(0.0, 1e6).usually(1.0, 20.0)).open("distance of the pole from the figure axis", "near", "far");
        /// radius of the Earth
        radius: number(6.371e6, "m", between(1e6, 1e8).because("smaller or larger it is no planet like the Earth").usually(6e6, 7e6));
        /// one turn relative to the equinox, a sidereal day
        day: number(86_164.090_5, "s", between(1e4, 1e6).because("faster, a planet breaks up; slower, others pull it about").usually(8e4, 9e4));
        /// Love number k_2 of the yielding mantle
        love: number(0.30, "-", from_to(0.0, 0.9).because("0 is rigid, a fluid has about 0.94").usually(0.0, 0.6));
        /// error asked of the attitude after one free period
        tolerance: number(1e-6, "rad", from_to(1e-9, 1.0));
    }
}

/// (C - A)/A, the number that decides.
fn flattening(p: &Parameters) -> Result<f64> {
    let least =
        from_to(1e-4, 1.0).because("rounder, the wobble takes years; flatter, it is no planet");
    least.check("(C - A)/A", (p.c - p.a) / p.a)
}

/// The angle between the figure axis and the angular velocity, rad.
pub fn alpha(p: &Parameters) -> f64 {
    atan2(p.wander, p.radius)
}

/// The rate of the daily turn along the figure axis, rad/s.
fn spin(p: &Parameters) -> f64 {
    TAU / p.day
}

// ANCHOR: motion
/// The free motion, with the angular momentum along Z.
pub fn motion(p: &Parameters) -> rotation_dynamics::Result<FreeBody> {
    let moments = PrincipalMoments::symmetric(p.a, p.c)?;
    let sideways = tan(alpha(p));
    let angular_velocity = BodyVector::new(sideways, 0.0, 1.0) * spin(p);
    // The figure axis is off the angular momentum by theta.
    let theta = atan2(p.a * sideways, p.c);
    let y = SpaceVector::new(0.0, 1.0, 0.0);
    FreeBody::new(moments, Attitude::about_space_axis(y, -theta)?, angular_velocity)
}

/// Euler's equations of a body with two equal moments; time in 1/Omega_z, rates in Omega_z.
pub fn circuit(flattening: f64, alpha: f64, step: f64) -> Result<f64> {
    let law = |_, [x, y, z]: &[f64; 3]| [-flattening * y * z, flattening * z * x, 0.0];
    let euler = ode(law).scaled(|_| [alpha, alpha, 1.0]);
    let start = [tan(alpha), 0.0, 1.0];
    let (back, _) = Dop853::new(step)?.zero(&euler, start, 2, 1e6, |y| y[1])?;
    Ok(back.t / TAU)
}
// ANCHOR_END: motion

/// How often the direction that `towards` gives turns about L from 0 to `end` (s).
pub fn turns(motion: &FreeBody, end: f64, towards: BodyVector) -> f64 {
    let azimuth = |t| {
        let v = motion.attitude(t).to_space(towards);
        atan2(v.y(), v.x())
    };
    let (mut total, mut last) = (0.0, azimuth(0.0));
    let daily = end * motion.angular_velocity(0.0).norm();
    // More than six places in a turn, even of a body that wobbles twice as fast as it turns.
    for t in times(0.0, end, 64 + (2.0 * daily) as u32).skip(1) {
        let now = azimuth(t);
        let step = (now - last) / TAU;
        total += step - round_even(step);
        last = now;
    }
    total
}

/// The figure axis, and a line from the centre to the equator (the notes' OP).
pub const FIGURE_AXIS: BodyVector = BodyVector::new(0.0, 0.0, 1.0);
const ON_THE_EQUATOR: BodyVector = BodyVector::new(1.0, 0.0, 0.0);

/// The day of the clock, s.
const DAY: f64 = 86_400.0;

fn wobble(p: &Parameters, report: &mut Report) -> Result<()> {
    let (f, motion) = (flattening(p)?, motion(p)?);
    let (free, precession) = (1.0 / f, hypot(1.0 + f, tan(alpha(p))));
    let stepped = circuit(f, alpha(p), 1e-14)?;
    let [axis, line] = [FIGURE_AXIS, ON_THE_EQUATOR].map(|v| turns(&motion, free * p.day, v));
    let (end, l) = (0.4 * free * p.day, motion.angular_momentum());
    let omega = motion.attitude(end).to_space(motion.angular_velocity(end));
    let figure = motion.attitude(end).to_space(FIGURE_AXIS);
    let between = |u: &SpaceVector, v: &SpaceVector| atan2(u.cross(v).norm(), u.dot(v));
    let apart = atan2(f * tan(alpha(p)), 1.0 + f + tan(alpha(p)) * tan(alpha(p)));
    claims! { report,
        /// angle between the figure axis and the angular velocity
        alpha: alpha(p) / ARCSEC, "arcsec",
        "along the motion" => between(&figure, &omega) / ARCSEC, within 1e-9 * alpha(p) / ARCSEC, in "The angles":
            alpha(p).to_degrees() => "a second of arc is a 3600th of a degree";
        /// angle between the angular momentum and the angular velocity
        apart: 1e3 * apart / ARCSEC, "mas",
        "along the motion" => 1e3 * between(&l, &omega) / ARCSEC, within 2e-12 / ARCSEC, in "The angles":
            1e3 * alpha(p) / ARCSEC => "that is from the figure axis";
        /// spin over the daily turn, Omega_S/Omega_z
        ratio: -f, "-", "Euler's equations, stepped" => -1.0 / stepped, within 1e-11 * f, in "The rates":
            f => "for a flat body spin and precession have opposite signs",
            (p.a - p.c) / p.c => "divide by the moment across the axis";
        /// precession over the daily turn, Omega_P/Omega_z
        precession: precession, "-", "turns counted along the motion" => axis / free, within 1e-9, in "The rates":
            1.0 - f => "Omega_S is negative; Omega_z is the sum of the two";
        /// a circuit of the pole of rotation round the figure axis, in turns of the Earth
        free_period: free, "-", "located event" => stepped, within 1e-10 * free, in "The periods":
            free + 1.0 => "that is how often the figure axis goes round";
        /// the same in solar days
        free_period_solar: free * p.day / DAY, "d",
        "located event" => stepped * p.day / DAY, within 1e-10 * free, in "The periods":
            free => "these are sidereal days";
        /// turns of the line OP in a free period
        line_turns: free * (precession - f), "-", "turns counted along the motion" => line, within 1e-9 * free;
        /// turns of the figure axis about L in a free period
        axis_turns: free * precession, "-", "turns counted along the motion" => axis, within 1e-9 * free;
        /// one turn of the figure axis about L
        axis_period: p.day / precession, "s",
        "turns counted along the motion" => free * p.day / axis, within 1e-9 * p.day, in "The periods":
            free * p.day => "that is the circuit in the body",
            p.day => "the figure axis goes round a little faster than the body";
        /// by how much of a turn OP lags behind in one turn of the figure axis
        lag: f / precession, "-", "turns counted along the motion" => 1.0 - line / axis, within 1e-9, in "The rates":
            f => "that is for one turn of OP";
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let thin = motion(&p.but(|p| (p.a, p.c, p.wander) = (0.2, 0.4, 1e3)))?;
    let round = flattening(&p.but(|p| (p.a, p.c) = (0.4 / 1.001, 0.4)))?;
    let love = |k: f64| yielding::period(&p.but(|p| p.love = k));
    let k_s = yielding::fluid_love_number(p);
    limits! { report,
        /// a flat disc wobbles twice as fast as it turns
        "C = 2 A: Omega_P/Omega_z": turns(&thin, 100.0 * p.day, FIGURE_AXIS) / 100.0 => 2.0, within 1e-7;
        /// nearly a sphere: the axis stays with the body for a thousand days
        "C = 1.001 A: free period": circuit(round, 1e-6, 1e-14)? => 1000.0, within 1e-8;
        /// a mantle that does not yield
        "k_2 = 0: period/rigid": love(0.0)? * flattening(p)? => 1.0, within 1e-14;
        /// a body that yields like a fluid has no figure of its own: nothing calls the pole back
        "k_2 = k_s: rigid/period": 1.0 / (love(k_s * (1.0 - 1e-9))? * flattening(p)?) => 0.0, within 2e-9;
    }
}

/// The runs that the page asks the reader to predict, each number beside its second route.
fn tries(_: &Parameters, report: &mut Report) -> Result<()> {
    let columns = ["run", "free period", "Omega_P/Omega_z", "if it yields"];
    let ours = Parameters::default();
    let runs = [
        ("as it is", ours.clone()),
        ("a flat disc", ours.but(|p| (p.a, p.c) = (0.2, 0.4))),
        ("nearly fluid", ours.but(|p| p.love = 0.9)),
        ("poles far apart", ours.but(|p| p.wander = 1e5)),
    ];
    report.add(Table::of("tries", columns, runs, |(name, p)| {
        let (f, tilt) = (flattening(&p)?, tan(alpha(&p)));
        let routes = [
            (1.0 / f, circuit(f, alpha(&p), 1e-14)?, 1e-4),
            (hypot(1.0 + f, tilt), f * turns(&motion(&p)?, p.day / f, FIGURE_AXIS), 1e-6),
            (yielding::period(&p)?, yielding::simulated(&p, 1e-12)?, 1e-2),
        ];
        let cells =
            routes.map(|(x, other, least)| supported_digits(x, (x - other).abs().max(least)));
        Ok([[name.to_string()].as_slice(), &cells].concat())
    })?)
}

/// The card of effects. What the literature gives is named on the page.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (f, rigid) = (flattening(p)?, p.day / flattening(p)? / DAY);
    let kappa = p.love / yielding::fluid_love_number(p);
    let mean = TAU / (YEAR * DAY);
    let lunisolar = (SUN.rate(f) + MOON.rate(f)).abs();
    let yielded = (yielding::period(p)? - 1.0 / f) * p.day / DAY;
    // Two different moments: both off the mean by half of 0.0067 (C - A),
    // as the gravity of the Earth has it (4 J22 = 7.26e-6 beside J2 = 1.083e-3).
    let apart = |part: f64| -> Result<f64> {
        let side = part * (p.c - p.a);
        let moments = PrincipalMoments::new(p.a - side, p.a + side, p.c)?;
        let rates = BodyVector::new(1e-4, 0.0, 1.0);
        Ok(FreeBody::new(moments, Attitude::IDENTITY, rates)?.rate_period())
    };
    // None of what is no body.
    let unequal = apart(0.00335).ok().zip(apart(0.0).ok());
    effect_card! { report,
        "yielding of the mantle": "k_2/k_s" = kappa, costs yielded, "d of the period", included;
        "fluid core": "1 - A_m/A" = 0.11, costs -0.11 * rigid, "d of the period";
        "tide of the pole in the oceans": "k_ocean/k_s" = 0.05, costs 30.0, "d of the period";
        "two different moments in the equator":
            "(B - A)/(C - A)" = 0.0067, costs 0.5 * 0.00335 * 0.00335 * rigid, "d of the period",
            measured unequal.map(|(with, without)| (with / without - 1.0) * rigid), within 1e-9 * rigid;
        "torque of Sun and Moon": "psi'/(f Omega)" = lunisolar / (f * spin(p)),
            costs lunisolar * sin(OBLIQUITY) * (DAY / ARCSEC), "arcsec of the axis in a day";
        "yearly winds, snow and water": "rate of the year/|Omega_S|" = mean / (f * spin(p)),
            costs 0.1, "arcsec of the pole";
    }
}

/// The attitude after one free period, by closed form and by stepping.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let motion = motion(p)?;
    let body = RigidBody::new(PrincipalMoments::symmetric(p.a, p.c)?);
    let start = body.state(motion.attitude(0.0), motion.angular_velocity(0.0))?;
    let end = p.day / flattening(p)?;
    let problem = Problem::new(Scene::new(body), start, end, motion.state(end));
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-9])
}

/// The pole of rotation on the ground (m), Greenwich first, for `--csv`.
fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (motion, end) = (motion(p)?, p.day / flattening(p)?);
    let row = |t: f64| {
        let w = motion.angular_velocity(t);
        Ok([t / DAY, p.radius * w.x() / w.z(), p.radius * w.y() / w.z()])
    };
    let columns = ["t [d]", "x [m]", "y [m]"];
    Trajectory::sampled(columns, times(0.0, end, 400), row)
}

example! {
    ch15_5_earth: "Section 15.5: the free wobble of the Earth, how it yields, and the precession of the equinoxes";
    "The wobble of the Earth", "The Earth turns freely about an axis that is not quite its own.",
    [wobble, yielding::claims, equinoxes::claims, limits, effects, tries, accuracy];
    figures::figures, trajectory, figures::moving_picture
}
