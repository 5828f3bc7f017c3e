//! Exercise 15.8: a particle circles on a string that is pulled in through a hole.

#[path = "ch15_ex8_string/figures.rs"]
mod figures;
#[path = "ch15_ex8_string/physics.rs"]
pub mod physics;

use kit::prelude::*;
use physics::*;
use rotation_dynamics::integrators::{Ode, after, newton, ode, place_and_velocity, size_or};
use rotation_dynamics::planar::contact::ContactEvent;

parameters! {
    /// The string of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// mass of the particle
        mass: number(0.2, "kg", above(0.0).usually(0.05, 1.0)).drawn(0.10, 0.50, 0.05);
        /// radius of the circle
        radius: number(0.8, "m", above(0.0).usually(0.3, 1.2)).drawn(0.6, 1.2, 0.1);
        /// speed on the circle
        speed: number(1.5, "m/s", any().but_zero("at rest on the circle it is pulled straight in").usually(0.5, 4.0)).drawn(1.0, 3.0, 0.1).open("speed on the circle", "slow", "fast");
        /// rate at which the string is pulled in
        pull: number(0.1, "m/s", above(0.0).because("the string is pulled in: let out, it does not pull").usually(0.03, 0.2)).drawn(0.05, 0.15, 0.01).open("rate of the pull", "winds in slowly", "winds in quickly");
        /// time for which it is pulled
        time: number(3.0, "s", above(0.0).usually(0.5, 6.0)).drawn(1.0, 4.0, 0.5);
        /// radius of the hole
        hole: number(0.05, "m", above(0.0).usually(0.01, 0.1));
        tolerance: step(1e-14, 1e-6);
    }
}

/// The answer, when the pull ends and the radius of the hole, in units of r0 and r0/u.
pub fn scene(p: &Parameters) -> Result<(Answer, f64, f64)> {
    let (pull, hole) = (p.pull / p.speed.abs(), p.hole / p.radius);
    let end = p.time * p.speed.abs() / p.radius;
    allowed! {
        "hole/radius": hole, from_to(0.005, 0.95), "at the edge of a smaller hole the turns are too many";
        "pull/|speed|": pull, from_to(1e-3, 1e2), "slower, the turns to the hole are too many; faster, too few";
        "pull time/radius, what is pulled in,": pull * end, above(1e-6), "less is lost in rounding";
        "radius - pull time, what is left of the string,": p.radius - p.pull * p.time, above(p.hole), "the radius of the hole";
    }?;
    Ok((Answer { pull }, end, hole))
}

/// Newton's law for a string that winds on a post of this radius: it pulls towards the point
/// where it leaves the post, at right angles to the velocity.
pub fn on_post(post: f64) -> impl Ode<6> {
    newton(move |_, [place, velocity]| {
        let free = string_on_post(post, place);
        free * (velocity.dot(&velocity) / free.dot(&free))
    })
    .scaled(size_or([1.0; 6]))
}

/// From the particle to the point where its string leaves the post, which it winds up forward.
pub fn string_on_post(post: f64, place: SpaceVector) -> SpaceVector {
    let far = place.dot(&place);
    let (along, side) = (post * post / far, post * (far - post * post).sqrt() / far);
    let left = SpaceVector::new(-place.y(), place.x(), 0.0);
    place * (along - 1.0) - left * side
}

/// The end of the pull, the flight when the string is held again, and the edge of the hole.
fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, end, hole) = scene(p)?;
    // The particle may circle clockwise: then velocities across the string and angles are negative.
    let (sense, u) = (p.speed.signum(), p.speed.abs());
    let (m, r0, t0) = (p.mass, p.radius, p.radius / u);
    let (force, joule, far) = (m * u * u / r0, m * u * u, (1.0 - hole) / a.pull);
    // Errors grow with the angle.
    let bound = 1e3 * p.tolerance * (0.1 * a.angle(end)).max(1.0);
    let edge_bound = 1e3 * p.tolerance * (0.003 * a.angle(far)).max(1.0);
    let run = Pulled::new(a.pull, hole, p.tolerance, end)?;
    let ContactEvent { before, after: jerked, .. } = run.motion.event("hand touches")?;
    let (last, r, v) = (run.at(end)?, a.radius(end), a.across(end));
    let speed = hypot(a.pull, v);
    // The string is held again: the particle flies off, until it is taut.
    let slack = 2.0 * r * a.pull / (speed * speed);
    let held = Pulled::held(last, p.tolerance, 2.0 * slack)?;
    let ContactEvent { before: flown, after: caught, t: taut, .. } =
        held.motion.event("knot touches")?;
    let chord = 2.0 * atan2(a.pull, v);
    let [from, to] = [last.q, flown.q].map(|[x, y, _]| atan2(y, x).rem_euclid(TAU));
    // On to the edge of the hole.
    let edge = Pulled::new(a.pull, hole, p.tolerance, 2.0 * far)?;
    let turning = ode(|t, _: &[f64; 1]| [a.across(t)]).scaled(size_or([1.0; 1]));
    let naive = after(end, &turning, &[0.0], 1e-13)?[0];
    let keeping = -log(r) / a.pull;
    claims! { report,
        /// length of string that is left on the table
        left: r0 * r, "m", "string simulated" => r0 * radius(&last), within bound * r0;
        /// force of the string at the end of the pull
        force: force * a.force(end), "N", "string simulated" => force * run.tension(end)?, within 10.0 * bound * force * a.force(end),
        in "The force":
            force / r => "does the speed stay?", force => "that is at the beginning",
            force / (r * r) => "the speed has grown, and enters as its square";
        /// the same at the beginning
        force_first: force, "N", "string simulated" => force * run.tension(0.0)?, within bound * force, in "The force";
        /// velocity towards the hole
        inward: p.pull, "m/s", "string simulated" => -u * outward(&last), within bound * u * v, in "The velocities";
        /// velocity at right angles to the string
        across: sense * u * v, "m/s", "string simulated" => sense * u * across(&last), within bound * u * v, in "The velocities":
            sense * u => "the force is not at right angles to the path",
            sense * u * r => "what stays is the angular momentum";
        /// speed
        speed: u * speed, "m/s", "string simulated" => u * hypot(last.v[0], last.v[1]), within bound * u * v, judged 1e-4, in "The velocities":
            u * v => "the particle also moves inward";
        /// angular velocity
        angular_velocity: sense * u / r0 * a.angular_velocity(end), "rad/s", "string simulated" => sense * u / r0 * across(&last) / radius(&last),
        within 10.0 * bound * u / r0 * v * v, in "The velocities":
            sense * u / r0 / r => "that is for a speed that stays", sense * u / r0 => "that is at the beginning";
        /// angle since the beginning of the pull
        angle: sense * a.angle(end), "rad", "string simulated" => sense * run.angle(end)?, within bound * (1.0 + a.angle(end)) * v,
        in "The velocities":
            sense * keeping => "that is for a speed that stays",
            sense * end * a.angular_velocity(end) => "it has turned slower before";
        /// work of the hand after the jerk
        work: joule * a.work(end), "J", "energy gained, simulated" => joule * (energy(&last) - energy(jerked)),
        within bound * joule * (1.0 + v * v), in "The work":
            force * r0 * a.pull * end => "the force grows",
            joule * a.force(end) * a.pull * end => "the force was smaller before";
        /// impulse of the jerk
        impulse: m * p.pull, "N s", "string simulated" => m * u * (outward(before) - outward(jerked)), within bound * m * u;
        /// energy lost in it
        lost: 0.5 * m * p.pull * p.pull, "J", "string simulated" => joule * (a.pull * a.pull - (energy(jerked) - energy(before))),
        within 2.0 * bound * joule;
        /// time for which the string is slack when it is held
        slack: t0 * slack, "s", "string simulated" => t0 * taut, within bound * t0 * v;
        /// angle of that flight
        flight: sense * chord, "rad", "string simulated" => sense * (to - from).rem_euclid(TAU), within bound * v;
        /// energy lost when it is taut again
        caught: 0.5 * m * p.pull * p.pull, "J", "string simulated" => joule * (energy(flown) - energy(caught)), within 2.0 * bound * joule * v * v;
        /// when the particle is at the edge of the hole
        edge_time: t0 * far, "s", "string simulated" => t0 * edge.end(), within edge_bound * t0 * far;
        /// turns by then
        edge_turns: sense * a.angle(far) / TAU, "-", "string simulated" => sense * edge.angle(edge.end())? / TAU, within edge_bound * a.angle(far) / hole;
        /// force there
        edge_force: force * a.force(far), "N", "string simulated" => force * edge.tension(edge.end())?, within 100.0 * edge_bound * force * a.force(far) / hole;
        /// wrong: angle of a solver that keeps the speed
        naive_angle: sense * keeping, "rad", "that solver" => sense * naive, within 1e-11 * (1.0 + keeping);
    }
}

/// A slow pull, a fast one, a short one.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let half = |pull: f64| Pulled::new(pull, 0.1, 1e-13, 0.5 / pull);
    let (slow, fast, short) = (half(0.01)?, half(100.0)?, Answer { pull: 1e-6 });
    let [slowly, quickly] = [slow.at(50.0)?, fast.at(0.005)?];
    limits! { report,
        /// what is kept by a slow change of an oscillator: energy over frequency
        "slow pull, u/100, to half the radius: K r^2 over the start": 0.5 * energy(&slowly) => 1.0, within 1e-4;
        /// twice the speed, on the circle that is then its path
        "slow pull: F r/(2 K)": 0.25 * slow.tension(50.0)? / energy(&slowly) => 1.0, within 1e-4;
        /// the particle goes straight in
        "fast pull, 100 u: angle times pull over u": 100.0 * fast.angle(0.005)? => 1.0, within 1e-9;
        /// but the angular momentum is not less for that
        "fast pull: speed across the string, over u": across(&quickly) => 2.0, within 1e-9;
        /// at the start: work is force times way
        "short pull: work over force times way": short.work(1e-3) / 1e-9 => 1.0, within 2e-9;
    }
}

/// A nylon line of 1 mm (3 GPa, 1150 kg/m^3) over an edge with mu = 0.2, and an air table.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, end, _) = scene(p)?;
    let (r, area) = (a.radius(end), 0.5e-6 * FRAC_PI_2);
    let force = p.mass * p.speed * p.speed / p.radius * a.force(end);
    let edge = exp(0.2 * FRAC_PI_2) - 1.0;
    // Friction turns against the path, the part of it across the string takes angular momentum.
    let (rub, pull) = (0.001 * 9.80665 * (p.radius / (p.speed * p.speed)), a.pull);
    let slant = |r: f64| (1.0 + pull * pull * r * r).sqrt();
    let rubbed = rub * end * (1.0 + r) / (slant(1.0) + slant(r));
    // The angular momentum simulated with it; the force goes with its square.
    let slowed = ode(|t, &[l]: &[f64; 1]| {
        let (r, v) = (a.radius(t), l / a.radius(t));
        [-rub * r * v / hypot(pull, v)]
    })
    .scaled(size_or([1.0; 1]));
    let kept = after(end, &slowed, &[1.0], 1e-13)?[0];
    let stretch = force / (3e9 * area);
    // It adds half of its mass at the end, and brings the angular momentum of what goes down.
    let string = 1150.0 * area * p.radius * r / p.mass;
    let carried = 0.5 + 2.0 / 3.0 * (1.0 / r - 1.0);
    let earth = 7.292e-5 * p.radius / p.speed.abs() * (1.0 - r * r);
    effect_card! { report,
        "friction at the edge of the hole": "exp(mu pi/2) - 1" = edge, costs edge, "of the force of the hand";
        "friction of an air table": "mu_k g (r0 + r) t/(2 u r0)" = rubbed, costs 2.0 * rubbed, "of F",
            measured 1.0 - kept * kept, within 1e-10;
        "stretch of the string": "F/(E A)" = stretch, costs 2.0 * stretch, "of the angular velocity";
        "mass of the string": "m_s/m" = string, costs carried * string, "of F at the hole";
        "turning of the Earth, at a pole": "Omega_E (r0^2 - r^2)/(r0 u)" = earth, costs earth, "of the angular velocity";
    }
}

/// The accuracy strip: the place when the pull ends.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, end, hole) = scene(p)?;
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
    let ((s, c), r) = (sincos(a.angle(end)), a.radius(end));
    let state = move |t| [a.radius(t), a.angle(t), a.force(t)];
    report.in_closed_form(move |part| state(part * end));
    let run = move |step| Pulled::new(a.pull, hole, step, end);
    let error = move |run: &Pulled| {
        let [x, y, _] = run.at(end)?.q;
        Ok(hypot(x - r * c, y - r * s) / r)
    };
    report.stepped(asked, run, |run| run.motion.work(), error)
}

example! {
    ch15_ex8_string: "Exercise 15.8: a particle circles on a string that is pulled in through a hole";
    "A string pulled in", "A particle on a smooth table circles on a string that is pulled in at a constant rate.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
