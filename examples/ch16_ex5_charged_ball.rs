//! Exercise 16.5: a charged ball that an electric field drives over a rough slab.

#[path = "ch16_ex5_charged_ball/figures.rs"]
mod figures;
#[path = "ch16_ex5_charged_ball/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::driven_in_air;
use kit::prelude::*;
use physics::*;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::integrators::{after, second_order};
use rotation_dynamics::planar::contact::{Mode, entry};

parameters! {
    /// The ball of the exercise: 1 cm of wood, charged nearly as highly as the air allows in this field.
    pub struct Parameters {
        /// charge of the ball
        charge: number(1e-8, "C", any().usually(1e-9, 3e-8));
        /// electric field along the slab
        field: number(5e5, "V/m", any().usually(5e4, 1e6)).drawn(2e5, 6e5, 5e4);
        /// mass of the ball
        mass: number(0.002, "kg", above(0.0).usually(0.001, 0.01));
        /// radius of the ball
        radius: number(0.01, "m", above(0.0).usually(0.005, 0.03));
        /// k = I/(m R^2): 2/5 for a solid ball, 2/3 for a thin shell
        shape: number(0.4, "-", above_to(0.0, 1.0).because("no mass is outside the ball").usually(0.3, 0.7));
        /// coefficient of friction between ball and slab
        friction: number(0.3, "-", at_least(0.0).usually(0.02, 0.6)).drawn(0.20, 0.50, 0.05).open("coefficient of friction", "slides", "rolls");
        /// length of the slab, from the place where the ball starts from rest
        length: number(0.2, "m", above(0.0).usually(0.05, 0.5)).drawn(0.10, 0.40, 0.05);
        /// velocity of a ball that is put down sliding, without spin
        shot: number(-0.3, "m/s", any().usually(-1.0, 1.0)).open("velocity at the start", "against the field", "with the field");
        /// how far off its middle a charged spot is, over R
        spot: number(0.5, "-", from_to(0.0, 1.0).because("inside the ball").usually(0.0, 1.0));
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// drag coefficient of the ball in air, for the claims about it
        air: effect(0.47, "-", above_to(0.0, 1e3).because("more is a parachute"));
        /// relative error asked for, at every event: from 1e-13 to 0.001
        tolerance: number(1e-12, "-", from_to(1e-13, 0.001));
    }
}

impl Ball {
    /// The ball of these parameters, its charge in the middle.
    pub fn new(p: &Parameters) -> Result<Self> {
        let pull = p.charge * p.field / p.mass;
        let weights = pull / p.gravity;
        let told = "its size must be from 1e-9, below which nothing drives the ball, to 1e9";
        require((1e-9..=1e9).contains(&weights.abs()), "q E/(m g)", weights, told)?;
        allowed! {
            "coefficient of friction that rolling needs": p.shape / (1.0 + p.shape) * weights.abs(),
                above(1e-11), "contacts do not tell a smaller part of the weight from none";
            "length/radius": p.length / p.radius, between(0.0, 1e6), "after so many turns the angle has lost its digits";
        }?;
        let Parameters { radius, shape, length, gravity: press, friction: mu, .. } = *p;
        Ok(Self { pull, press, radius, shape, mu, spot: 0.0, resisting: [0.0; 2], length })
    }
}

/// The least coefficient of friction with which the solver lets the ball stick: by bisection.
fn holds_from(ball: Ball) -> Result<f64> {
    let slips = |mu| -> Result<bool> {
        Ok(entry(&Ball { mu, ..ball }, ball.start(0.0, 0.0))?.0 != [Mode::Stick])
    };
    Ok(try_bisect([0.0, 2.0 * ball.pull.abs() / ball.press], 0.0, slips)?[1])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (ball, m, g) = (Ball::new(p)?, p.mass, p.gravity);
    let (r, k, d) = (p.radius, p.shape, p.length);
    let ([a, rim], side, bound) = (ball.accelerations(), ball.side(), 16.0 * p.tolerance);
    let (pull, driven, field) = (ball.pull, ball.pull.abs(), p.field.abs());
    let (time, fast) = ((2.0 * d / a.abs()).sqrt(), (2.0 * d * a.abs()).sqrt());
    let speed = side * fast;
    let run = ball.run(ball.start(0.0, 0.0), 2.0 * time, p.tolerance)?;
    let arrives = run.event("arrives")?;
    let [ran, _, turning] = arrives.before.v;
    let (spin, moving) = (rim * time / r, ran * ran + k * r * r * turning * turning);
    let (needed, least) = (ball.holding().abs() / g, holds_from(ball)?);
    // A ball that is put down sliding.
    let ([catch, then], shot) = (ball.caught(p.shot), p.shot.abs());
    let far = Ball { length: d + 10.0 * shot * catch.abs(), ..ball };
    let slid = || far.run(far.start(0.0, p.shot), 2.0 * catch, p.tolerance);
    let slides = shot > 0.0 && catch > 0.0 && catch.is_finite();
    let catches = slides && p.friction > needed * (1.0 + 1e-9);
    // A charged spot: below the middle it needs most friction.
    let spotted = Ball { spot: p.spot * r, ..ball };
    let rough = Ball { mu: 1e3 + 2.0 * driven / g, ..spotted };
    let lowest = rough.run(rough.start(-FRAC_PI_2, 0.0), 1e-3 * time, p.tolerance)?.forces(0.0)?[0];
    let most = (k + p.spot) / (1.0 + k) * pull;
    let further = d - spotted.spot * (1.0 - cos(d / r));
    let rolls = side * (2.0 * driven * further / (1.0 + k)).sqrt();
    // Its last digits are those of the angle through which it turns.
    let rolled = p.tolerance.max(1e-13 * d / r);
    let turned = || spotted.run(spotted.ahead(), 1e2 * time, rolled);
    let naive = pull - side * p.friction * g;
    let dragged = after(1.0, &second_order(move |_, _, _| naive), &[0.0, 0.0], 1e-12)?[1];
    claims! { report,
        /// acceleration
        a: a, "m/s^2", "located event" => side * ran * ran / (2.0 * d), within bound * driven, in "The motion":
            pull => "that slides without friction", naive => "friction is not at its limit",
            pull / 1.5 => "that is a cylinder", pull / (1.0 + 2.0 / 3.0) => "that is a thin shell";
        /// friction, against the field
        friction: m * ball.friction(), "N", "contact solver" => -m * run.forces(0.5 * time)?[0].tangential, within bound * m * driven,
        in "The friction":
            -m * ball.friction() => "which way must it turn the ball?",
            side * m * g * p.friction => "that is the most there can be",
            m * k * pull => "friction itself makes the acceleration smaller", m * pull => "then the ball would not start";
        /// least coefficient of friction for rolling
        mu_min: needed, "-", "bisection of the modes" => least, within 1e-9 * needed + 1e-11, in "The friction":
            driven / g => "that is for a body that does not turn",
            k * driven / g => "friction itself makes the acceleration smaller";
        /// strongest field in which it rolls
        field_max: 1e-6 * field * p.friction / needed, "MV/m", "bisection of the modes" => 1e-6 * field * p.friction / least,
        within 1e-6 * field * p.friction / needed * (1e-11 / needed).max(1e-8), in "The friction":
            1e-6 * field * p.friction * g / driven => "friction need not balance the whole pull";
        /// time to the end of the slab
        time: time, "s", "located event" => arrives.t, within bound * time, in "The motion":
            (2.0 * d / driven).sqrt() => "that slides without friction";
        /// velocity there
        speed: speed, "m/s", "located event" => ran, within bound * fast, in "The motion":
            side * (2.0 * d * driven).sqrt() => "the turning takes its part of the work";
        /// angular velocity there
        omega: spin, "rad/s", "located event" => -turning, within bound * fast / r, in "The motion":
            spin / (2.0 * PI) => "not turns but radians a second";
        /// part of the work of the field that is in the turning
        turning: k * (rim * time) * (rim * time) / (2.0 * driven * d), "-", "located event" => (moving - ran * ran) / (2.0 * driven * d),
        within 2.0 * bound;
        /// part that is lost to rubbing
        lost: ball.lost(), "-", "located event" => 1.0 - moving / (2.0 * driven * d), within 2.0 * bound;
        /// a ball put down sliding: when it begins to roll
        catch: catch, "s", "located event" => slid()?.event("ball sticks")?.t, within bound * catch, if catches;
        /// velocity then
        catch_velocity: then, "m/s", "located event" => slid()?.event("ball sticks")?.before.v[0], within bound * (shot + driven * catch), if catches;
        /// charged spot: the most friction that rolling needs
        spot_friction: m * most, "N", "contact solver" => -m * lowest.tangential, within bound * m * driven;
        /// charged spot: least coefficient
        spot_mu: most.abs() / g, "-", "contact solver" => lowest.tangential.abs() / lowest.normal, within bound * driven / g;
        /// charged spot, ahead at the start: velocity at the end of the slab
        spot_speed: rolls, "m/s", "located event" => turned()?.event("arrives")?.before.v[0], within 320.0 * rolled * fast, if most.abs() < p.friction * g && p.spot < 0.999 && d < TURNING * r;
        /// wrong: acceleration with the friction at its limit
        naive_a: naive, "m/s^2", "simulated" => dragged, within 1e-11 * (driven + p.friction * g);
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (k, gravity) = (p.shape, p.gravity);
    let plain = Ball { mu: 1e3, pull: gravity, ..Ball::new(p)? };
    let goes = |ball: Ball| -> Result<f64> {
        let (_, [v, ..]) = ball.rolled(10.0 * (ball.length / ball.pull).sqrt(), 1e-12)?;
        Ok(0.5 * v.powi(2) / (ball.length * ball.pull))
    };
    let shaped = |shape| goes(Ball { shape, ..plain });
    let rubbed = |mu| goes(Ball { mu, ..plain });
    let held = plain.holding() / p.gravity;
    let top = Ball { spot: p.radius, ..plain }.run(plain.start(FRAC_PI_2, 0.0), 1e-6, 1e-12)?;
    let top = top.forces(0.0)?[0].tangential;
    limits! { report,
        /// all mass in the middle: it goes like a particle
        "k = 1e-9: m x''/(q E)": shaped(1e-9)? => 1.0, within 2e-9;
        /// a thin shell, I = 2/3 m R^2
        "k = 2/3: m x''/(q E)": shaped(2.0 / 3.0)? => 0.6, within 1e-11;
        /// no friction: nothing turns it
        "mu = 0: m x''/(q E)": rubbed(0.0)? => 1.0, within 1e-11;
        /// just below the threshold it still goes as if it rolled
        "mu = 0.9999999 mu_min: (1 + k) m x''/(q E)": (1.0 + k) * rubbed(0.999_999_9 * held)? => 1.0, within 1e-6;
        /// a pull at the top of the ball: friction helps, by 1 - k
        "charge at the top: -(1 + k) F/(q E)": (1.0 + k) * top / plain.pull => 1.0 - k, within 1e-9;
    }
}

/// How many radii far the ball with a charged spot is followed.
const TURNING: f64 = 300.0;

/// Permittivity of the vacuum, F/m.
const EPSILON_0: f64 = 8.854_187_8e-12;

/// What `--with air` adds: it takes longer, and ends slower.
fn blown(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(drag) = p.air else { return Ok(()) };
    let ball = Ball::new(p)?;
    let [a, _] = ball.accelerations();
    // What rolls has the inertia of its turning as well.
    let rolls = p.friction * p.gravity > ball.holding().abs();
    let inertia = p.mass * if rolls { ball.pull / a } else { 1.0 };
    driven_in_air(report, [drag, PI * p.radius * p.radius], [a.abs(), inertia, p.length])
}

fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (ball, square) = (Ball::new(p)?, p.radius * p.radius);
    // Force of the image over the weight, arm of the normal force, drag over m v^2 for C = 0.47.
    let image = p.charge * p.charge / (16.0 * PI * EPSILON_0 * square) / (p.mass * p.gravity);
    let (arm, drag) = (2e-5, 0.5 * 1.204 * 0.47 * PI * square / p.mass);
    let (a, pull) = (ball.accelerations()[0].abs(), ball.pull.abs());
    let (time, speed) = ((2.0 * p.length / a).sqrt(), (2.0 * p.length * a).sqrt());
    let own = p.charge.abs() / (4.0 * PI * EPSILON_0 * p.radius * p.radius);
    let spark = (own + 3.0 * p.field.abs()) / 3e6;
    let grip = p.friction * p.gravity / ball.holding().abs();
    // A ball that slips is faster than one that rolls.
    let slipping = if grip < 1.0 { 1.0 - pull / ((1.0 + p.shape) * a) } else { 0.0 };
    // The part of the work that a ball which rolls has lost at the end, by the contact solver.
    let arrives = |resisting| Ball { resisting, ..ball }.rolled(4.0 * time, 1e-10);
    let lost = |resisting: [f64; 2]| -> Result<f64> {
        let part = arrives(resisting)?.1[0] / arrives([0.0; 2])?.1[0];
        Ok(1.0 - part * part)
    };
    let (rolling, blown) = (arm * p.gravity / (p.radius * pull), drag * speed * speed / pull);
    let rolled = when(grip >= 1.01 && rolling <= 0.5, || lost([arm, 0.0]))?;
    let dragged = when(grip >= 1.01 && blown <= 0.5, || lost([0.0, drag]))?;
    let (magnetic, leaking) = (speed * 5e-5 / p.field.abs(), 1e-14 * time / EPSILON_0);
    effect_card! { report,
        "slipping": "mu/mu_min" = grip, costs slipping, "of x''", included;
        "breakdown of the air at the ball": "(E_q + 3 E)/E_air" = spark, costs f64::from(spark >= 1.0), "of x'', nothing below 1";
        "image charge, if the slab conducts": "q^2/(16 pi epsilon_0 R^2 m g)" = image, costs image / (1.0 + image), "of mu_min";
        "rolling resistance, arm 0.02 mm": "b m g/(R q E)" = rolling, costs rolling, "of x''", measured rolled, within 1e-7;
        "air drag, at the end": "rho C S v^2/(2 q E)" = blown, costs 0.5 * blown, "of the work", measured dragged, within 1e-7;
        "charge lost to the air": "sigma t/epsilon_0" = leaking, costs leaking / 3.0, "of the way";
        "magnetic field of the Earth": "v B/E" = magnetic, costs magnetic, "of x''";
    }
}

/// The accuracy strip: the ball with a charged spot, which does not accelerate evenly.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let far = p.length.min(TURNING * p.radius);
    let ball = Ball { mu: 1e3, length: far, spot: p.spot * p.radius, ..Ball::new(p)? };
    let further = ball.length - ball.spot * (1.0 - cos(ball.length / p.radius));
    let pull = ball.pull.abs();
    let speed = ball.side() * (2.0 * pull * further / (1.0 + p.shape)).sqrt();
    let end = 1e2 * (ball.length / pull).sqrt();
    let run = move |tolerance| ball.run(ball.ahead(), end, tolerance);
    let error = move |run: &Roll| Ok(largest([run.event("arrives")?.before.v[0] / speed - 1.0]));
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    report.controlled("contact by DOP853", asked, run, Roll::work, error)?;
    report.in_closed_form(move |part| part.sqrt() * speed);
    Ok(())
}

example! {
    ch16_ex5_charged_ball: "Exercise 16.5: a charged ball that an electric field drives over a slab";
    "The charged ball in a field", "A ball with a charge rolls over a rough slab, driven by an electric field along it.",
    [claims, blown, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
