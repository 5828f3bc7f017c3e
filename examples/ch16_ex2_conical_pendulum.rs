//! Exercise 16.2: the conical pendulum, a bob on a string that is turned about the vertical.

#[path = "ch16_ex2_conical_pendulum/figures.rs"]
mod figures;
#[path = "ch16_ex2_conical_pendulum/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use physics::*;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::integrators::{
    Dop853, LocatedEvent, Solution, Work, after, place_and_velocity, small_frequency,
};

parameters! {
    /// The pendulum of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the bob
        mass: number(0.4, "kg", above(0.0).usually(0.1, 2.0)).drawn(0.2, 1.0, 0.1);
        /// length of the string
        length: number(0.8, "m", above(0.0).usually(0.2, 2.0)).drawn(0.5, 1.5, 0.1);
        /// angular velocity about the vertical
        rate: number(5.0, "rad/s", any().usually(1.0, 12.0)).drawn(5.0, 9.0, 0.5).open("rate of the turning plane", "hangs straight", "flies out");
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// angle of the wide swing, from rest in the turning plane; of a rod if a string goes slack
        release: number(0.5, "rad", between(-PI, PI).because("pi is upright").usually(0.1, 1.5)).open("angle of the release", "nearly hanging", "nearly level");
        tolerance: step(1e-13, 1e-3);
    }
}

/// q = g/(l w^2), the one number that decides: infinite in a plane that does not turn.
fn ratio(p: &Parameters) -> Result<f64> {
    let q = p.gravity / (p.length * p.rate * p.rate);
    // What is left of a difference that is smaller has less than half of its digits.
    let far = |off: f64| off.abs() >= 1e-8;
    let differs = "it must differ from 1 by 1e-8: at this threshold nothing drives the bob \
                   back or away, and small oscillations take for ever";
    require(far(1.0 - q), "g/(l w^2)", q, differs)?;
    let turns = "from there the bob creeps up to the vertical and takes for ever: \
                 2 g/(l w^2) - cos(release) must differ from 1 by 1e-8";
    require(far(opposite(q, p.release) - 1.0), "release", p.release, turns)?;
    let stays = "at rest there the bob stays, at the vertical as on the cone: \
                 it must be off by 1e-8 rad";
    require(far(p.release) && far(cone(q) - p.release.abs()), "release", p.release, stays)?;
    Ok(q)
}

/// The cosine of the angle where a swing from rest at `angle` turns back, if it is one.
fn opposite(q: f64, angle: f64) -> f64 {
    2.0 * q - cos(angle)
}

/// Turning point number `n` of the swing from rest at `angle`, undamped, and the work.
fn turning(q: f64, angle: f64, n: u32, step: f64) -> Result<(LocatedEvent<2>, Work)> {
    Ok(Dop853::new(step)?.zero(&in_plane(q, 0.0), [angle, 0.0], n, 1e4 / driven(q), |y| y[1])?)
}

/// Where the pendulum comes to rest if it is damped, rad.
pub fn settled(q: f64, step: f64) -> Result<f64> {
    Ok(swung(q, driven(q), 0.1, 80.0 / driven(q), step)?.end_state()[0].abs())
}

/// [`driven`], simulated.
pub fn measured_driven(q: f64) -> Result<f64> {
    // The period is even in how far cos(theta), below the threshold theta, is off rest.
    let off = |size| if q < 1.0 { cone(q + size * (1.0 - q)) } else { size * driven(q) };
    Ok(small_frequency(&in_plane(q, 0.0), |size| [off(size), 0.0], 1e2 / driven(q), |y| y[1])?)
}

/// [`free`], simulated.
pub fn measured_free(q: f64) -> Result<f64> {
    let knocked = |size| in_space([cone(q), size * sin(cone(q))], 1.0, 0.0);
    let rest = knocked(0.0)[2];
    Ok(small_frequency(&on_string(q, 0.0), knocked, 10.0, |y| y[2] - rest)?)
}

/// The greater of |w| and sqrt(g/l), rad/s: one over the unit of time.
fn unit_rate(p: &Parameters) -> f64 {
    p.rate.abs().max((p.gravity / p.length).sqrt())
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (q, m, g, l) = (ratio(p)?, p.mass, p.gravity, p.length);
    let (theta, w0, bound) = (cone(q), (g / l).sqrt(), 100.0 * p.tolerance);
    let (w, turned) = (unit_rate(p), squares(q)[0].sqrt().copysign(p.rate));
    let (s, c) = sincos(theta);
    let last = opposite(q, p.release);
    // Below the threshold the square of the frequency is w0^2 - w^2: here of a plane with q = 2.
    let slower = w0 * (0.5 + measured_driven(2.0)? * measured_driven(2.0)?).sqrt();
    let (start, unit) = (in_space([theta, 0.0], turned, 0.0), m * (l * w * w));
    let end = after(2.0 * PI, &on_string(q, 0.0), &start, p.tolerance)?;
    let [r, v] = place_and_velocity(&end);
    let (pull, out) = (unit * tension(q, [r, v]), hypot(r.x(), r.y()));
    let newton = if q < 1.0 { unit } else { m * g };
    let turns = |angle, n| Ok::<_, kit::Error>(turning(q, angle, n, p.tolerance)?.0);
    let wide = turns(p.release, 1)?;
    // If no angle has that cosine, the wide swing goes through the vertical.
    let far = if last < 1.0 { cone(last).copysign(p.release) } else { -p.release };
    // An error of a step is one of the energy: it counts the more, the weaker the pull is where a
    // swing begins and where it turns back.
    let creeps = |from: f64, to: f64| {
        let begins = from / force(q, from);
        let turns = from.abs().max(to.abs()) / force(q, to);
        10.0 * p.tolerance * (begins * begins + turns * turns)
    };
    let late = creeps(p.release, far);
    let late_touch = creeps(1e-9, cone(opposite(q, 1e-9)));
    let further = 10.0 * p.tolerance * p.release.abs().max(far.abs()) / force(q, far).abs();
    let told = late < 1e-2; // else no step can confirm it
    let (small, time, free) = (w * driven(q), period(q, p.release)? / w, w * free(q));
    let touched = 0.5 * period(q, 1e-9)? / w;
    claims! { report,
        /// angle from the vertical
        theta: theta, "rad", "where it settles" => settled(q, p.tolerance)?, within bound, in "The angle":
            FRAC_PI_2 - theta => "measure from the vertical", cone(1.5 * q) => "that is a uniform rod without a bob",
            cone(q / (4.0 * PI * PI)) => "not turns but radians a second",
            (2.0 - 2.0 * q).max(0.0).sqrt() => "the angle is not small";
        /// rate where it rises
        omega_threshold: w0, "rad/s", "swings in a slower plane" => slower, within 1e-9 * w0, in "The angle":
            g / l => "that is its square";
        /// reaction: tension of the string
        tension: newton, "N", "a turn in space" => pull, within bound * newton, in "The reaction":
            m * g => "that is its vertical part only", unit * s => "that is its horizontal part only",
            m * g * c => "along the string the bob is accelerated";
        /// its part towards the axis
        horizontal: unit * s, "N", "a turn in space" => pull * out, within bound * newton, in "The reaction":
            newton => "that is the whole of it";
        /// the plane kept turning
        driven: small, "rad/s", "simulated" => w * measured_driven(q)?, within 1e-9 * small,
        in "Angular frequency of small oscillations":
            w * c => "look at the second derivative again", w0 => "that is for a plane at rest";
        /// where it turns back
        far: far, "rad", "located event" => wide.state[0], within bound + further, if told, in "The wide swing":
            (2.0 * theta).copysign(p.release) - p.release => "in the angle, the cone is not halfway between the two";
        /// period
        period: time, "s", "located event" => 2.0 * wide.t / w, within 10.0 * bound * time + late / w, if told, in "The wide swing":
            2.0 * PI / small => "that is for small oscillations";
        /// the bob left to itself
        free: free, "rad/s", "simulated" => w * measured_free(q)?, within (1e-9 + 1e-12 / (1.0 - q)) * free, if q < 1.0,
        in "Angular frequency of small oscillations":
            small => "further in, the bob now turns faster";
        /// far turning point, from 1e-9 rad
        touched: touched, "s", "located event" => turns(1e-9, 1)?.t / w,
        within 10.0 * bound * touched + late_touch / w, if q < 1.0 && late_touch < 1e-2;
    }
}

fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let (near, still) = (1.0 - 1e-8, legendre::k(Modulus::from_k(sin(0.25))?)?);
    limits! { report,
        /// cos(theta) = 1 - theta^2/2 for a small angle
        "q = 1 - x: theta/sqrt(2 x)": cone(near) / 2e-8_f64.sqrt() => 1.0, within 1e-8;
        /// at the threshold nothing drives the bob back or away
        "q = 1 - x: Omega/(omega theta)": driven(near) / cone(near) => 1.0, within 1e-8;
        /// a small ellipse about the vertical: in and out twice a turn
        "q = 1 - x: Omega_free/omega": free(near) => 2.0, within 2e-8;
        /// turned fast, or long: the string is nearly horizontal
        "q = x: (pi/2 - theta)/x": (FRAC_PI_2 - cone(1e-5)) / 1e-5 => 1.0, within 1e-9;
        /// plane at rest: 4 K(sin 0.25), a pendulum from 0.5 rad
        "q = 1/x: omega tau/sqrt(x)": period(1e8, 0.5)? => 4.0 * still, within 1e-6;
    }
}

/// The angle by which drag lowers the cone in a turn, rad, to first order: it takes
/// drag s^3 of L_Z = s^2 a radian, and on a cone dL/L = (1 + 3 c^2)/(2 s c) dtheta.
pub fn sinking(q: f64, drag: f64) -> f64 {
    let (s, c) = sincos(cone(q));
    4.0 * PI * drag * s * s * c / (1.0 + 3.0 * c * c)
}

/// The card of effects, for a steel ball on a nylon string of 1 mm (3 GPa, 1150 kg/m^3).
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (q, m, l, w) = (ratio(p)?, p.mass, p.length, unit_rate(p));
    let (r, area) = (cbrt(3.0 * m / (4.0 * PI * 7850.0)), 0.25e-6 * PI);
    let drag = 1.204 * 0.47 * PI * r * r * l / (2.0 * m);
    // Hanging straight down, it does so with these effects as well.
    let slope = if q < 1.0 { q / sin(cone(q)) } else { 0.0 };
    let stretch = m * (l * w * w).max(p.gravity) / (3e9 * area);
    let (string, size, earth) = (1150.0 * area * l / m, 0.4 * r * r / (l * l), 1.4584e-4 / w);
    // From the steady turning, with the air: how much lower after a turn.
    let start = in_space([cone(q), 0.0], squares(q)[0].sqrt(), 0.0);
    let [x, y, z, ..] = after(2.0 * PI, &on_string(q, drag), &start, 1e-12)?;
    let sunk = cone(q) - atan2(hypot(x, y), -z);
    effect_card! { report,
        "air drag, bob left to itself": "rho C S l/(2 M)" = drag, costs sinking(q, drag), "rad a turn", measured sunk, within 1e-9;
        "stretch of the string": "T/(E A_s)" = stretch, costs slope * stretch, "rad of theta";
        "mass of the string": "m/M" = string, costs slope * string / 6.0, "rad of theta";
        "size of the bob": "2 r^2/(5 l^2)" = size, costs 0.5 * size, "of Omega";
        "turning of the Earth, at a pole": "2 Omega_E/omega" = earth, costs slope * earth, "rad of theta";
    }
}

/// The accuracy strip: the wide swing, for a period.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (q, release) = (ratio(p)?, p.release);
    report.in_closed_form(move |_| period(q, release));
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-15];
    let swing = move |step| turning(q, release, 2, step);
    report.dial_of_return(asked, swing, period(q, release)?, release)
}

example! {
    ch16_ex2_conical_pendulum: "Exercise 16.2: a bob on a string that is turned about the vertical";
    "The conical pendulum", "A bob on a string, in a vertical plane that turns at a constant rate.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
