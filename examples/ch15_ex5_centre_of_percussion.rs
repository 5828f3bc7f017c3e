//! Exercise 15.5: where a bat must hit the ball so that the hands feel nothing.

#[path = "ch15_ex5_centre_of_percussion/figures.rs"]
mod figures;
#[path = "ch15_ex5_centre_of_percussion/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::integrators::{Dop853, Event, after, ode, size_or};

parameters! {
    /// Bat and ball; the notes leave all numbers open.
    pub struct Parameters {
        /// length of the bat
        length: number(0.85, "m", from_to(1e-4, 1e4).usually(0.75, 1.2)).drawn(0.80, 1.00, 0.05);
        /// mass of the bat
        mass: number(1.2, "kg", from_to(1e-6, 1e6).usually(0.5, 2.0)).drawn(0.9, 1.5, 0.1);
        /// distance of the hands from the end of the handle
        hands: number(0.0, "m", at_least(0.0).usually(0.0, 0.3)).open("place of the hands, from that end", "at the end", "up the bat");
        /// distance of the blow from the end of the handle
        hit: number(0.7, "m", at_least(0.0).usually(0.1, 0.85)).drawn(0.60, 0.75, 0.01).open("place of the blow, from the end of the handle", "near the hands", "at the tip");
        /// mass of the ball
        ball: number(0.16, "kg", from_to(1e-6, 1e6).usually(0.05, 0.5)).drawn(0.10, 0.25, 0.01);
        /// speed of the ball
        speed: number(30.0, "m/s", from_to(-1e5, 1e5).but_zero("at rest nothing is hit").usually(5.0, 40.0)).drawn(15.0, 40.0, 1.0);
        /// part of the speed with which they part again
        restitution: number(0.5, "-", from_to(0.1, 1.0).because("a ball that hardly jumps back hits again and again"));
        /// how long they touch, in the simulation with a soft ball
        contact: number(1e-3, "s", from_to(1e-6, 1.0).usually(1e-4, 1e-2));
        /// relative error of the simulations
        tolerance: number(1e-11, "-", from_to(1e-12, 1e-4));
    }
}

/// The first bending mode of a free rod: beta with cosh(beta) cos(beta) = 1.
pub const BETA: f64 = 4.730_040_744_862_704;

/// (cosh(beta) - cos(beta))/(sinh(beta) - sin(beta)).
fn sigma() -> f64 {
    let (grown, shrunk) = (exp(BETA), exp(-BETA));
    (0.5 * (grown + shrunk) - cos(BETA)) / (0.5 * (grown - shrunk) - sin(BETA))
}

/// Its shape from x = 0 to 1; the mean square is 1.
pub fn shape(x: f64) -> f64 {
    let (ratio, (s, c), grown, shrunk) = (sigma(), sincos(BETA * x), exp(BETA * x), exp(-BETA * x));
    0.5 * (grown * (1.0 - ratio) + shrunk * (1.0 + ratio)) + c - ratio * s
}

/// Where the mode has its second node, by bisection.
fn node() -> f64 {
    bisect([0.5, 1.0], 0.0, |x| shape(x) < 0.0)[1]
}

/// The same by integrating w'''' = beta^4 w from a free end, with the end values of curvature and shear.
pub fn shot(tolerance: f64) -> Result<(f64, [f64; 4])> {
    let fourth = BETA * BETA * BETA * BETA;
    let law = ode(move |_, &[w, a, b, c]: &[f64; 4]| [a, b, c, fourth * w]);
    let (law, start) = (law.scaled(size_or([1.0; 4])), [2.0, -2.0 * BETA * sigma(), 0.0, 0.0]);
    let node = Event::rising("node", |_, w: &[f64; 4]| w[0]);
    let run = Dop853::new(tolerance)?.solve(&law, 0.0, &start, 1.0, &[node])?;
    Ok((run.events().first().map_or(f64::NAN, |node| node.t), *run.end_state()))
}

/// Error of the simulations with a soft ball, of which four digits are shown.
pub const SOFT: f64 = 1e-7;

/// Angular velocity of the bat after the blow, held by the hands.
fn turn(p: &Parameters) -> f64 {
    let [arm, hit] = arms(p);
    impulse(p, true) * hit / (p.mass * inertia(p, arm))
}

/// Another place for the blow, as a part of the length.
pub fn at(p: &Parameters, part: f64) -> Parameters {
    p.but(|p| p.hit = part * p.length)
}

/// The impact of rigid bodies, hands as a hinge or none.
pub fn rigid(p: &Parameters, held: bool) -> Result<Blow> {
    Blow::new(Strike::rigid(p, held), p.tolerance)
}

/// The place of the blow that is not felt, from the hands: two blows simulated, and the straight
/// line through the two reactions.
fn unfelt(p: &Parameters) -> Result<f64> {
    let (near, far) = (0.55, 0.95);
    let [a, b] = [near, far].map(|part| rigid(&at(p, part), true));
    let (a, b) = (a?.reaction, b?.reaction);
    Ok((near - a * (far - near) / (b - a)) * p.length - p.hands)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let turn = turn(p);
    allowed! {
        "hands/length": p.hands / p.length, from_to(0.0, 0.45), "held at its middle a bat has no such place";
        "hit/length": p.hit / p.length, from_to(p.hands / p.length, 1.0), "between the hands and the tip";
        "ball/mass": p.ball / p.mass, from_to(1e-3, 1e3), "what one gets is lost beside the other";
        "|speed| contact/length": p.speed.abs() * p.contact / p.length, above(1e-10), "a slower ball is lost in rounding beside the bat";
        "Omega t_c, the angle in the time of contact,": turn.abs() * p.contact, from_to(0.0, 1.0), "or it is no blow";
    }?;
    let ([arm, hit], l, bound) = (arms(p), p.length, 100.0 * p.tolerance);
    let (held, free, sense) = (rigid(p, true)?, rigid(p, false)?, p.speed.signum());
    let (push, loose) = (impulse(p, true), impulse(p, false));
    let (reaction, centre, away) = (reaction(p), centre(p), loose / p.mass * free_hands(p));
    claims! { report,
        /// distance from the hands at which a blow is not felt
        centre: centre, "m", "two impacts simulated" => unfelt(p)?, within bound * l, in "The place":
            arm => "that is the centre of mass; the bat turns about the hands",
            centre - arm => "that is from the centre of mass", l - p.hands => "that is the tip",
            0.75 * l => "compare the velocity of the centre of mass with the angular velocity";
        /// impulse of the hands over that of the ball
        reaction: reaction, "-", "impact simulated" => held.reaction, within bound, in "The hands":
            -reaction => "that is the impulse on the hands",
            hit / centre => "the momentum of the bat comes from the ball as well",
            free_hands(p) => "that is how a free bat would move there";
        /// impulse of the ball on the bat
        impulse: push, "N s", "impact simulated" => sense * held.impulse, within bound * push;
        /// impulse of the hands on the bat, along that of the ball
        hands: reaction * push, "N s", "impact simulated" => sense * held.hands, within bound * push;
        /// angular velocity of the bat after
        turn: turn, "rad/s", "impact simulated" => sense * held.turn, within bound * turn.abs().max(p.speed.abs() / l);
        /// velocity of the place of the hands if nobody holds the bat
        away: away, "m/s", "impact simulated, bat free" => sense * free.away, within bound * p.speed, in "The hands":
            loose / p.mass => "that is the centre of mass; the bat turns as well";
        /// second node of the bending, from the end of the handle
        node: node() * l, "m", "shooting from a free end" => shot(1e-13)?.0 * l, within 1e-10 * l;
    }
}

/// A blow at each end and in the middle, and hands that hold elsewhere.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let p = p.but(|p| (p.length, p.mass, p.speed, p.restitution) = (1.0, 1.0, 1.0, 1.0));
    let unit = |hands, hit| p.but(|p| (p.hands, p.hit) = (hands, hit));
    let [light, heavy] =
        [1e-9, 1e9].map(|ball| impulse(&unit(0.0, 1.0).but(|p| p.ball = ball), true));
    limits! { report,
        /// a blow on the hands: they carry all of it
        "d = 0: J_h/J": reaction(&unit(0.0, 0.0)) => -1.0, within 1e-15;
        /// on the centre of mass: a quarter
        "d = l/2: J_h/J": reaction(&unit(0.0, 0.5)) => -0.25, within 1e-15;
        /// at the tip
        "d = l: J_h/J": reaction(&unit(0.0, 1.0)) => 0.5, within 1e-15;
        /// a free bat that is struck at the tip turns about that point
        "hands at l/3: centre over l, from the end": 1.0 / 3.0 + centre(&unit(1.0 / 3.0, 1.0)) => 1.0, within 1e-15;
        /// hands near the middle: no place on the bat
        "hands at 0.4 l: centre over l, from the end": 0.4 + centre(&unit(0.4, 1.0)) => 0.5 + 1.0 / 1.2, within 1e-15;
        /// a light ball is turned back by a bat that hardly notices
        "m_b to 0, at the tip: J/(m_b v)": light / 1e-9 => 2.0, within 1e-8;
        /// a heavy one finds a third of the mass at the tip
        "m_b to infinity, at the tip: J/(m v)": heavy => 2.0 / 3.0, within 1e-8;
    }
}

/// Soft balls: the same blow, spread over a longer time, as long as it is one.
fn soft(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns =
        "contact / s | J_h/J | largest force, ball / kN | hands / kN | turned meanwhile / rad";
    let rate = turn(p).abs();
    let contacts = [0.0001, 0.001, 0.01].into_iter().filter(|contact| rate * contact <= 1.0);
    report.add(Table::of("soft", columns.split(" | "), contacts, |contact| {
        let blow = Blow::new(Strike::soft(&p.but(|p| p.contact = contact)), SOFT)?;
        let [ball, hands] = blow.largest_forces()?.map(|force| format!("{:.2}", 1e-3 * force));
        let turned = blow.motion.at(blow.touch + contact)?.q[2];
        let [reaction, turned] = [blow.reaction, turned].map(|number| format!("{number:.4}"));
        Ok([contact.to_string(), reaction, ball, hands, turned])
    })?)
}

/// What the turning of the bat changes in a blow of Hertz's law, to second order: means over the
/// force, in units of the time of contact, of the square of the angle, of the place of a ball
/// that this angle deflects, and of angle times depth. The angle is over the last rate.
fn turning() -> Result<[f64; 3]> {
    let deepest = 1.0 / 2.943_275_f64;
    let stiffness = 1.25 / pow(deepest, 2.5);
    // Depth, angle and place with their rates, then the three means; the impulse is 1.
    let law = ode(move |_, &[d, dd, a, da, x, dx, ..]: &[f64; 9]| {
        let force = 0.5 * stiffness * d.max(0.0) * d.max(0.0).sqrt();
        let [square, place, depth] = [a * a, x, a * d].map(|mean| force * mean);
        let (slower, aside) = (-2.0 * force, force * a);
        [dd, slower, da, force, dx, aside, square, place, depth]
    })
    .scaled(size_or([1.0; 9]));
    let mut start = [0.0; 9];
    start[1] = 1.0;
    let [.., square, place, depth] = after(1.0, &law, &start, 1e-11)?;
    Ok([square, place, depth])
}

/// Where a blow on a bat whose density grows as 1 + e (2 x/l - 1) is not felt, from the hands:
/// moment of inertia over mass and distance, of a thousand pieces.
fn in_pieces(p: &Parameters, e: f64) -> f64 {
    let sum = |power: i32| -> f64 {
        let parts = (0..1000).map(|k| (f64::from(k) + 0.5) / 1e3);
        parts.map(|x| (1.0 + e * (2.0 * x - 1.0)) * (x * p.length - p.hands).powi(power)).sum()
    };
    sum(2) / sum(1)
}

/// The card of effects, for a wooden rod (12 GPa, 650 kg/m^3) of this length and mass.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([arm, hit], l, contact) = (arms(p), p.length, p.contact);
    let soft = Blow::new(Strike::soft(p), SOFT)?;
    let area = p.mass / (650.0 * l);
    // Bending stiffness over the mass of a unit of length: E/rho times area/(4 pi).
    let stiffness = 12e9 / 650.0 * area / (4.0 * PI);
    let frequency = BETA * BETA / (2.0 * PI * l * l) * stiffness.sqrt();
    // The velocity at the handle by a push that lasts half a sine, over J/m.
    let x = 2.0 * frequency * contact;
    let resonant = (x - 1.0).abs() < 1e-6;
    let response = if resonant { PI / 4.0 } else { cos(0.5 * PI * x) / (1.0 - x * x) };
    let bends = (shape(p.hands / l) * shape(p.hit / l)).abs();
    // Samples of the force do not tell what goes to and fro many times meanwhile.
    let swings = when(x < 20.0, || soft.left_swinging(2.0 * PI * frequency))?;
    // Mean of the place along the bat and of its square, from the hands, over l and l^2.
    let (heavier, part) = (0.5, p.hands / l);
    let mean = 0.5 + heavier / 6.0 - part;
    let square = 1.0 / 3.0 + heavier / 6.0 - part * (2.0 * mean + part);
    let shifted = square / mean * l - centre(p);
    // The elastic ball: angle and way of the ball along the bat in the time of contact, squared.
    let elastic = p.but(|p| p.restitution = 1.0);
    let (push, moment) = (impulse(&elastic, true) * contact, p.mass * inertia(p, arm));
    let angle = push * hit / moment * (push * hit / moment);
    let way = push * push / (moment * p.ball);
    // It is read when the bat has turned by all of this angle, and so its half square is lost.
    let [turned, along, deep] = turning()?;
    let turns = angle * (turned + 0.5 * deep - 0.5) + way * (along + 0.5 * deep);
    let slack = 10.0 * SOFT * (1.0 + p.mass / p.ball) + (angle + way) * (angle + way);
    let weight = p.mass * 9.80665 * contact / impulse(p, true).abs();
    effect_card! { report,
        "bending of the bat": "2 f_1 t_c" = x, costs bends * response.abs(), "of J/m, velocity of a free handle",
            measured swings.map(|left| bends * left), within 1e-6, at_work soft.motion.work();
        "half as heavy again at the tip, lighter at the handle": "e" = heavier, costs shifted, "m of the place",
            measured in_pieces(p, heavier) - centre(p), within 1e-5 * l;
        "the contact lasts": "Omega t_c" = soft.turn * contact, costs (1.0 + reaction(p)) * turns, "of J_h/J",
            measured soft.reaction - reaction(p), within slack, at_work soft.motion.work();
        "weight during the contact": "m g t_c/J" = weight, costs weight * reaction(&at(p, 0.5)).abs(), "of J_h/J, at most";
    }
}

/// The accuracy strip: the impact of rigid bodies.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (p, exact) = (p.clone(), reaction(p));
    let asked = [p.tolerance, 1e-4, 1e-6, 1e-8, 1e-12];
    let (error, line) = (move |blow: &Blow| Ok((blow.reaction - exact).abs()), p.clone());
    report.in_closed_form(move |part| reaction(&at(&line, part)));
    let run = move |tolerance| Blow::new(Strike::rigid(&p, true), tolerance);
    report.controlled("contacts by DOP853", asked, run, |blow| blow.motion.work(), error)
}

example! {
    ch15_ex5_centre_of_percussion: "Exercise 15.5: where a bat must hit the ball so that the hands feel nothing";
    "Centre of percussion", "A uniform bat, held near one end, hits a ball.",
    [claims, limits, effects, soft, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
