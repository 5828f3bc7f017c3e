//! Exercise 15.9: a ball hits one of the two masses of a dumbbell.

#[path = "ch15_ex9_dumbbell/figures.rs"]
mod figures;
#[path = "ch15_ex9_dumbbell/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;

parameters! {
    /// The ball and the dumbbell of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the ball, and of the dumbbell
        mass: number(0.5, "kg", from_to(1e-6, 1e6).usually(0.1, 2.0)).drawn(0.2, 1.0, 0.1);
        /// length of the stick
        length: number(0.6, "m", from_to(1e-6, 1e6).usually(0.2, 1.5)).drawn(0.3, 1.0, 0.1);
        /// speed of the ball
        speed: number(3.0, "m/s", from_to(-1e6, 1e6).but_zero("at rest nothing is hit").usually(0.5, 6.0)).drawn(1.0, 6.0, 0.5).open("speed of the ball", "slow", "fast");
        /// coefficient of restitution; 1 is elastic
        restitution: number(1.0, "-", from_to(0.1, 1.0).because("a ball that hardly jumps back hits again and again").usually(0.7, 1.0)).open("coefficient of restitution", "lossy", "elastic");
        /// angle of its path from the right angle to the stick
        slant: number(0.0, "rad", from_to(0.0, FRAC_PI_2).because("counted away from the other mass, which else is met first"));
        /// radius of the ball
        ball: number(0.03, "m", above(0.0).usually(0.01, 0.1));
        /// radius of the two masses
        knob: number(0.03, "m", above(0.0).usually(0.01, 0.1));
        /// error of a step of the simulation: from 1e-15 to 1e-6
        tolerance: number(1e-13, "-", from_to(1e-15, 1e-6));
    }
}

/// The scene of these parameters.
pub fn scene(p: &Parameters) -> Result<Hit> {
    let reach = (p.ball + p.knob) / p.length;
    allowed! {
        "knob/length": p.knob / p.length, between(0.0, 0.5), "or the masses overlap";
        "(ball + knob)/length": reach, from_to(2e-3, 10.0), "a smaller ball passes a mass within a step of the simulation";
    }?;
    Ok(Hit { slant: p.slant, ..Hit::across(p.restitution, reach) })
}

/// The second hit for e = 1/2: how far the stick has turned. Ball and middle of the stick run
/// level, so the ball stays at the end of a tangent to the circle of the masses; the other mass
/// meets it along the second tangent.
pub fn second(reach: f64) -> f64 {
    PI - 2.0 * atan2(2.0 * reach, 1.0)
}

/// The sum of the radii, in l, above which the ball of an elastic hit meets the upper mass: the
/// least of those whose circle passes through it.
fn touching() -> f64 {
    // The upper mass is behind the ball, as point masses, by this much.
    let radius = |angle: f64| {
        let [ball, _, upper] = cycloids(Answer::new(1.0, 0.0), 0.0, angle);
        let behind = ball[0] - upper[0];
        (behind * behind + upper[1] * upper[1]) / (2.0 * behind)
    };
    least(radius, 1.0, 1.8)
}

/// The same by simulations, between one with a second hit and one without.
fn touching_simulated() -> Result<f64> {
    // A contact that only grazes can pass between two steps, so the distance decides.
    let clears = |reach: f64| -> Result<bool> {
        let blow = Blow::new(Hit::across(1.0, reach), 1e-9, 2.0)?;
        Ok(blow.nearest(0.7, 1.8) > reach + 1e-10)
    };
    Ok(try_bisect([1.0, 1.5], 1e-6, clears)?.iter().sum::<f64>() * 0.5)
}

/// A hit that returns half of the relative velocity, for two thirds of a turn.
pub fn halved(reach: f64, step: f64) -> Result<Blow> {
    Blow::new(Hit::across(0.5, reach), step, 4.2)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (scene, a) = (scene(p)?, Answer::new(p.restitution, p.slant));
    let (m, l, v0, (s, c), bound) = (p.mass, p.length, p.speed, sincos(p.slant), 1e-12);
    let after = Blow::new(scene, p.tolerance, 0.02)?.after;
    let [centre, ball] = [[0, 1], [3, 4]].map(|[x, y]| after.v[x] * c + after.v[y] * s);
    let [_, struck, other] = velocities(&after).map(|v| v0.abs() * hypot(v[0], v[1]));
    // The turning adds to the velocity of the struck mass across the stick and takes it
    // from the other.
    let of = |sign: f64| v0.abs() * hypot(a.centre * s, a.centre * c * (1.0 + sign));
    let elastic = p.restitution == 1.0 && p.slant == 0.0 && scene.reach < 1.2;
    let turn = TAU / a.angular_velocity.max(0.1);
    let followed = || Blow::new(scene, p.tolerance, turn);
    let half = || halved(scene.reach, p.tolerance);
    claims! { report,
        /// velocity of the ball after the hit, along that before
        v_ball: v0 * a.ball, "m/s", "contacts simulated" => v0 * ball, within bound * v0, in "The velocities":
            0.5 * v0 * (1.0 - p.restitution) => "the dumbbell is not a particle of its mass",
            -v0 * a.ball => "which way?",
            v0 * (1.0 - (1.0 + p.restitution) / (2.0 + 0.5 * c * c)) => "the moment of inertia of two masses at l/2 each";
        /// velocity of the centre of mass of the dumbbell
        v_cm: v0 * a.centre, "m/s", "contacts simulated" => v0 * centre, within bound * v0, in "The velocities":
            0.5 * v0 * (1.0 + p.restitution) => "the dumbbell also turns",
            v0.signum() * of(1.0) => "that is the struck mass";
        /// angular velocity of the dumbbell
        omega: v0 / l * a.angular_velocity, "rad/s", "contacts simulated" => v0 / l * after.v[2], within bound * v0 / l, in "The velocities":
            0.5 * v0 / l * a.angular_velocity => "the arm is half of the stick",
            2.0 * v0 / l * c => "the ball keeps a part of its momentum";
        /// speed of the struck mass
        v_hit: of(1.0), "m/s", "contacts simulated" => struck, within bound * v0, in "The velocities":
            v0.abs() * a.centre => "that is the centre of mass";
        /// speed of the other mass just after the hit
        v_other: of(-1.0), "m/s", "contacts simulated" => other, within bound * v0, in "The velocities":
            v0.abs() * a.centre => "the turning takes it backward";
        /// impulse of the hit
        impulse: m * v0 * a.centre, "N s", "contacts simulated" => m * v0 * (1.0 - ball), within bound * m * v0, in "The velocities":
            m * v0 => "the ball does not stop",
            (1.0 + p.restitution) * m * v0 => "the ball does not come back as from a wall";
        /// way of the centre of mass in a turn
        way: PI * l, "m", "contacts simulated" => l * followed()?.at(turn)?.q[0], within 1e2 * p.tolerance * l, if elastic, in "What follows":
            TAU * l => "the circle of the masses has the radius l/2";
        /// least distance from the ball to the other mass, from middle to middle
        nearest: l * least(|x| to_upper(cycloids(a, scene.reach, x)), 1.0, 3.0), "m", "contacts simulated" =>
            l * followed()?.nearest(1.0 / a.angular_velocity, 3.0 / a.angular_velocity), within 1e2 * p.tolerance * l, if elastic;
        /// for e = 1/2: angle at the second hit
        again: second(scene.reach), "rad", "contacts simulated" => half()?.again()? * half()?.after.v[2], within 1e3 * p.tolerance, if elastic;
        /// sum of the radii, over l, that makes a second hit
        touching: touching(), "-", "simulations with and without" => touching_simulated()?, within 1e-6, if elastic;
    }
}

/// Other readings, other balls, and what two free particles do.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let [elastic, plastic] = [1.0, 0.0].map(|part| Answer::new(part, 0.0));
    let along = Answer::new(1.0, FRAC_PI_2);
    let struck = |a: Answer| a.centre + 0.5 * a.angular_velocity;
    let speeds = [elastic.ball, elastic.centre, 0.5 * elastic.angular_velocity];
    let energy = speeds.map(|speed| 0.5 * speed * speed).iter().sum();
    limits! { report,
        /// a particle of half its mass: 2 m/(m + m/2); the other mass feels nothing
        "elastic: struck mass, over v0": struck(elastic) => 4.0 / 3.0, within 1e-15;
        /// nothing is lost: m v0^2 (1/18 + 2/9 + 2/9)
        "elastic: energy, over m v0^2": energy => 0.5, within 1e-15;
        /// ball and struck mass go on together
        "plastic: struck mass - ball": struck(plastic) - plastic.ball => 0.0, within 1e-15;
        /// equal masses exchange their velocities
        "along the stick: ball, over v0": along.ball => 0.0, within 1e-15;
        /// the hit has no arm
        "along the stick: Omega l/v0": along.angular_velocity => 0.0, within 1e-15;
    }
}

/// A hit 1 mm off the middle, smooth masses of some size, a table that rubs with 0.1: what can be
/// put into the scene is, by another mass, moment or start of the same simulation.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, l, v0) = (Answer::new(p.restitution, p.slant), p.length, p.speed);
    let (size, square) = (1.6 * p.knob * p.knob / (l * l), cos(p.slant) * cos(p.slant));
    let aside = 1e-3 / (p.ball + p.knob);
    let contact = 1e-4 * v0.abs() / l * a.angular_velocity;
    let weak = 0.1 * 9.80665 * l / (v0 * v0);
    let rub = weak / (a.centre * a.centre);
    let (plain, struck) = (scene(p)?, |hit: Hit| Blow::new(hit, 1e-13, 0.02));
    let free = struck(plain)?;
    let [x, y, turn, ..] = free.after.v;
    let heavy = struck(Hit { moment: 0.25 * (1.0 + size), ..plain })?;
    let staff = struck(Hit { mass: 1.01, moment: 0.25 + 0.01 / 12.0, ..plain })?;
    let cost = |other: &Blow| {
        let [without, with] = [&free, other].map(|blow| blow.motion.work().derivatives);
        format!("{without} derivatives, {with} derivatives")
    };
    // Along the stick nothing turns; a ball that is far aside misses; what rubs much stops it.
    let turned = (square > 1e-6).then(|| 1.0 - heavy.after.v[2] / turn);
    let astray = when(aside < 0.5, || struck(Hit { aside: 1e-3 / l, ..plain }))?;
    let its_cost = astray.as_ref().map_or("-".into(), cost);
    let off = |blow: &Blow| (atan2(blow.after.v[1], blow.after.v[0]) - p.slant).abs();
    let held = rub * held_back([x, y, turn]);
    let braked = when(held < 0.4, || rubbed([x, y, turn], weak))?;
    effect_card! { report,
        "size of the masses": "8 a^2/(5 l^2)" = size, costs size * 2.0 / (2.0 + square), "of Omega, to first order",
            measured turned, within 1e-9, at_cost cost(&heavy);
        "it hits 1 mm off the middle": "d/(a + b)" = aside, costs aside, "rad of the direction, to first order",
            measured astray.as_ref().map(off), within 1e-9, at_cost its_cost;
        "the contact lasts 0.1 ms": "Omega t_c" = contact, costs 0.5 * contact, "rad of the angle";
        "mass of the stick, 1 %": "m_s/m" = 0.01, costs 0.01 * (1.0 + 2.0 / 3.0 * square) / (2.0 + square), "of V, to first order",
            measured 1.0 - hypot(staff.after.v[0], staff.after.v[1]) / a.centre, within 1e-9, at_cost cost(&staff);
        "friction of the table": "mu_k g l/V^2" = rub, costs held.min(1.0), "of V in the way l, to first order",
            measured braked.map(|(part, _)| part), within 1e-8, at_work braked.map(|(_, work)| work);
    }
}

/// The accuracy strip: the time of the second hit, for e = 1/2.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (reach, a) = (scene(p)?.reach.min(1.0), Answer::new(0.5, 0.0));
    let time = second(reach) / a.angular_velocity;
    let asked = [p.tolerance, 1e-6, 1e-9, 1e-12];
    report.in_closed_form(move |_| second(reach));
    let error = move |blow: &Blow| Ok(blow.again()? - time);
    report.stepped(asked, move |step| halved(reach, step), |blow| blow.motion.work(), error)
}

example! {
    ch15_ex9_dumbbell: "Exercise 15.9: a ball hits one of the two masses of a dumbbell";
    "A dumbbell hit", "A ball hits one of the two masses of a dumbbell.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
