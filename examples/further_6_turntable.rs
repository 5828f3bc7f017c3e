//! A ball that rolls on a turntable, and one that rolls inside an upright cylinder.

#[path = "further_6_turntable/figures.rs"]
mod figures;
#[path = "further_6_turntable/rolling.rs"]
pub mod rolling;

use core::f64::consts::PI;
use kit::prelude::*;
use rolling::{Ball, Found, Moving, STILL, Surface, at};
use rotation_dynamics::integrators::{after, ode, size_or};

parameters! {
    /// A ball on a table of the laboratory, and a golf ball in its hole.
    pub struct Parameters {
        /// angular velocity of the table
        rate: number(10.0, "rad/s", any().usually(3.0, 15.0)).drawn(6.0, 14.0, 1.0).open("rate of the table", "slow", "fast");
        /// radius of the table
        table: number(0.3, "m", above(0.0).usually(0.16, 0.5));
        /// radius of the ball
        radius: number(0.02, "m", above(0.0).usually(0.005, 0.03));
        /// k = I/(m a^2) of both balls: 2/5 for a uniform one, 2/3 for a thin shell
        shape: number(0.4, "-", above_to(0.0, 2.0 / 3.0).because("that is all mass at the surface").usually(0.3, 0.66));
        /// coefficient of friction
        friction: number(0.2, "-", above(0.0).usually(0.05, 0.6)).drawn(0.15, 0.40, 0.05);
        /// where the ball starts: its distance from the axis, along x
        place: number(0.15, "m", any().usually(0.02, 0.25)).drawn(0.08, 0.20, 0.01);
        /// its velocity there, along y
        velocity: number(0.2, "m/s", any().usually(0.05, 0.4)).drawn(0.10, 0.30, 0.05).open("velocity at the start", "a small circle", "a large circle");
        /// tilt of the table
        tilt: number(0.01, "rad", between(-0.5 * PI, 0.5 * PI).because("a table on edge carries no ball").usually(0.002, 0.03)).drawn(0.005, 0.020, 0.005);
        /// rolling resistance: its moment over m a^2 and the angular velocity
        loss: number(0.05, "1/s", at_least(0.0).because("resistance takes energy").usually(0.01, 0.3));
        /// radius of the upright cylinder
        hole: number(0.054, "m", above(0.0).usually(0.05, 0.2));
        /// radius of the ball in it
        golf: number(0.02133, "m", above(0.0).usually(0.01, 0.04));
        /// angular velocity of its middle about the axis of the cylinder
        orbit: number(45.0, "rad/s", any().usually(30.0, 80.0)).drawn(40.0, 60.0, 5.0);
        /// its velocity downward at the start
        drop: number(0.3, "m/s", any().usually(0.0, 0.6)).drawn(0.1, 0.5, 0.1);
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        tolerance: step(1e-13, 1e-3);
    }
}

/// The rate of the circle over that of the table.
pub fn share(shape: f64) -> f64 {
    shape / (1.0 + shape)
}

/// The middle of the circle on which a ball rolls, or would roll if it did not slip.
pub fn centre(ball: &Ball, at: &Moving) -> SpaceVector {
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let rolled = at.spin - up * at.spin.z();
    (rolled * ball.radius + up.cross(&at.velocity) / ball.shape) / ball.rate
}

/// The exponents of a ball with rolling resistance, `x + i y = A exp(l1 t) + B exp(l2 t)`: that of
/// the middle of the circle, and that of the circle, as real and imaginary part, 1/s.
pub fn exponents(rate: f64, shape: f64, loss: f64) -> [[f64; 2]; 2] {
    let (sense, rate) = (rate.signum(), rate.abs());
    let (nu, damping) = (share(shape) * rate, loss / (1.0 + shape));
    let re = damping * damping - nu * nu;
    let im = damping * (4.0 * rate - 2.0 * nu);
    let root = (0.5 * (hypot(re, im) - re)).sqrt();
    let [x, y] = [0.5 * (0.5 * im / root - damping), 0.5 * (root + nu)];
    // The product of the two is -i damping rate.
    let scale = -damping * rate / (x * x + y * y);
    [[scale * y, sense * scale * x], [x, sense * y]]
}

/// The height of a ball in a cylinder that turns about the axis at the rate `orbit`, without spin
/// about the normal at the start, where it comes from above with the velocity `drop`.
#[derive(Debug, Clone, Copy)]
pub struct Bobbing {
    /// Angular frequency.
    pub rate: f64,
    /// The height about which it goes up and down.
    pub middle: f64,
    pub amplitude: f64,
    /// When it is lowest.
    pub lowest: f64,
    /// The most friction over the weight.
    pub friction: f64,
}

pub fn bobbing(p: &Parameters) -> Bobbing {
    let rate = p.orbit.abs() * share(p.shape).sqrt();
    let below = p.gravity / (p.shape * p.orbit * p.orbit);
    let amplitude = hypot(below, p.drop / rate);
    let lowest = (PI - atan2(p.drop, below * rate)) / rate;
    let friction = 1.0 + rate * rate * amplitude / p.gravity;
    Bobbing { rate, middle: -below, amplitude, lowest, friction }
}

/// The ball on the level table, rolling at the place and with the velocity of the parameters.
pub fn on_table(p: &Parameters) -> (Ball, Moving) {
    let &Parameters { table: edge, rate, radius, shape, friction: mu, gravity, .. } = p;
    let (surface, gravity) = (Surface::Table { edge }, SpaceVector::new(0.0, 0.0, -gravity));
    let ball = Ball { surface, rate, radius, shape, mu, gravity, loss: 0.0 };
    (ball, thrown(&ball, [p.place, 0.0], [0.0, p.velocity]))
}

/// The same, if it runs round a circle.
fn circling(p: &Parameters) -> Result<(Ball, Moving)> {
    let (ball, start) = on_table(p);
    let nu = (share(p.shape) * p.rate).abs();
    let slope = p.gravity * sin(p.tilt).abs().max(1e-3) / (p.shape * p.rate.abs());
    let (turn, passed) = (2.0 * PI / nu, 100.0 * (p.place / p.radius).abs());
    allowed! {
        "size of the table's rate": p.rate.abs(), above(0.0), "on a table at rest it rolls straight on";
        "size of the velocity": p.velocity.abs(), above(0.0), "it rolls on the spot, as the table passes below it";
        "place over the radius of the table": (p.place / p.table).abs(), from_to(0.0, 1.0), "it starts beside the table";
        "radians that the ball turns in a turn of its circle": turn * start.spin.norm(), from_to(0.0, 1e4), "more of them take too long to simulate";
        "radians that it turns in that time on the slope": turn * slope / p.radius, from_to(0.0, 1e4), "more of them take too long to simulate";
        "radians that it turns while the table turns by 100 of them": passed, from_to(0.0, 3e4), "more of them take too long to simulate";
        "loss over the rate on the circle": p.loss / nu, from_to(0.0, 50.0), "braked more strongly, it is carried by the table";
    }?;
    Ok((ball, start))
}

/// Rolling on a table, from here with this velocity, with the spin of the table about the normal.
pub fn thrown(ball: &Ball, [x, y]: [f64; 2], [vx, vy]: [f64; 2]) -> Moving {
    let place = SpaceVector::new(x, y, ball.radius);
    ball.rolling(place, SpaceVector::new(vx, vy, 0.0), ball.rate)
}

/// Put down there without velocity and without spin.
pub fn dead(ball: &Ball, place: [f64; 2]) -> Moving {
    Moving { spin: SpaceVector::zero(), ..thrown(ball, place, [0.0; 2]) }
}

/// The same table with its right side, along x, lowered by the tilt.
pub fn tilted(ball: Ball, p: &Parameters) -> Ball {
    let gravity = SpaceVector::new(sin(p.tilt), 0.0, -cos(p.tilt)) * p.gravity;
    Ball { gravity, ..ball }
}

/// The ball in the cylinder, which turns at the rate `turning`.
pub fn in_hole(p: &Parameters, turning: f64) -> Result<(Ball, Moving)> {
    let (distance, bobbing) = (p.hole - p.golf, bobbing(p));
    let spin = p.orbit.abs() * (bobbing.amplitude - bobbing.middle) / p.golf;
    let turned = 2.0 * PI / bobbing.rate * spin;
    allowed! {
        "(radius of the cylinder - that of the ball)/(that of the ball)": distance / p.golf, from_to(1e-3, 1e3), "below 0 it does not fit in; far above, the wall is a plane";
        "size of the orbit": p.orbit.abs(), above(0.0), "a ball that does not go round is not pressed to the wall, and falls";
        "radians that the ball turns as it goes down and up": turned, from_to(0.0, 3e4), "more of them take too long to simulate";
    }?;
    let surface = Surface::Wall { distance };
    let ball = Ball { surface, rate: turning, radius: p.golf, ..on_table(p).0 };
    let velocity = SpaceVector::new(0.0, distance * p.orbit, -p.drop);
    Ok((ball, ball.rolling(SpaceVector::new(distance, 0.0, 0.0), velocity, 0.0)))
}

/// The distance from the axis, or the speed along the table.
pub fn level(v: SpaceVector) -> f64 {
    hypot(v.x(), v.y())
}

/// Turning point `n` of the circle, where the velocity along x is zero again.
fn turning(ball: Ball, start: &Moving, n: u32, step: f64) -> Found {
    ball.zero(start, n, 1e9, step, |y| y[3])
}

/// The real part of exponent `n`, simulated: a ball that starts so that the other is not there.
fn measured(ball: Ball, [re, im]: [f64; 2], step: f64) -> Result<f64> {
    let start = thrown(&ball, [0.1, 0.0], [0.1 * re, 0.1 * im]);
    // The slower an exponent, the fewer of its digits are above the error of a step.
    let time = (2.0 / hypot(re, im)).min(100.0 / (share(ball.shape) * ball.rate).abs());
    Ok(log(level(ball.later(&start, time, step)?.place) / 0.1) / time)
}

fn circle(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((ball, start), g, k, v, step) =
        (circling(p)?, p.gravity, p.shape, p.velocity, p.tolerance);
    let (turns, bound) = (share(k) * p.rate, 1e3 * p.tolerance);
    let nu = turns.abs();
    let (half, whole) = (turning(ball, &start, 1, step)?.0, turning(ball, &start, 2, step)?.0);
    let (radius, held) = (v.abs() / nu, ball.forces(&start).1);
    let size = p.place.abs() + radius;
    // Which way the friction bends its path.
    let sense = (-v * held.x()).signum();
    // Carried by the table, and let go.
    let out = if p.place == 0.0 { p.radius } else { p.place.abs() };
    let lying = thrown(&ball, [out, 0.0], [0.0, p.rate * out]);
    let carried = out * p.friction * g / ball.forces(&lying).1.norm();
    // Put down without spin: it slips at first.
    let wide = ball.without_edge();
    let until = 2.0 * (p.rate * p.place).abs() / (p.friction * g);
    // If it turns often before it rolls, that is not followed.
    let few = until * p.rate.abs() * (1.0 + p.place.abs() / p.radius) < 1e5;
    let slid = when(few, || wide.run(&dead(&wide, [p.place, 0.0]), until, step))?;
    let caught = slid.and_then(|run| Some(Moving::of(&run.transition("rolls").ok()?.after)));
    let [far, quick] = caught.map_or([f64::NAN; 2], |at| [at.place, at.velocity].map(level));
    claims! { report,
        /// angular velocity on the circle
        nu: turns, "rad/s", "located event" => sense * 2.0 * PI / whole.t, within bound * nu, in "On the table":
            p.rate => "that is the table, and the ball rolls on it",
            k * p.rate => "friction has to move the ball as well as to turn it",
            p.rate / (1.0 + k) => "which part of the change is it, k or 1?";
        /// time of a turn of the circle
        period: 2.0 * PI / nu, "s", "located event" => whole.t, within bound * whole.t, in "On the table":
            2.0 * PI / p.rate => "that is a turn of the table";
        /// radius of the circle
        circle: radius, "m", "located event" => 0.5 * (p.place - half.state[0]).abs(), within bound * size, in "On the table":
            p.place => "the axis of the table is not the middle of the circle";
        /// place of its middle, along x
        centre: p.place - v / turns, "m", "located event" => 0.5 * (p.place + half.state[0]), within bound * size, in "On the table":
            p.place + v / turns => "to which side does it turn?";
        /// coefficient of friction that it needs
        mu_min: nu * v.abs() / g, "-", "contact forces" => held.norm() / g, within bound * nu * v.abs() / g, in "Where it slips";
        /// carried by the table and let go: it rolls if it is nearer to the axis than
        carried: p.friction * g / (turns * p.rate), "m", "contact forces" => carried, within bound * carried, in "Where it slips":
            p.friction * g / (p.rate * p.rate) => "that is a coin, which goes with the table";
        /// put down at rest: radius of the circle on which it rolls in the end
        dead: far, "m", "velocity over nu" => quick / nu, within 1e-7 * far + 2.0 * STILL / nu, if caught.is_some();
    }
}

fn tilt_and_loss(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((ball, start), g, k, v, step) =
        (circling(p)?, p.gravity, p.shape, p.velocity, p.tolerance);
    let (nu, bound) = (share(k) * p.rate.abs(), 1e3 * p.tolerance);
    let (sloping, drift) = (tilted(ball, p), g * sin(p.tilt) / (k * p.rate));
    let moved = sloping.later(&start, 2.0 * PI / nu, step)?.place - start.place;
    let lossy = Ball { loss: p.loss, ..ball.without_edge() };
    let [shrinks, grows] = exponents(p.rate, k, p.loss);
    // The acceleration of a circle about the axis that grows is grows^2 times its radius.
    let slips = p.friction * g / (grows[0] * grows[0] + grows[1] * grows[1]);
    // A slow spiral starts nearer to where it slips. A much slower one, and one on a table so wide
    // that the ball turns too often on its way, is not followed.
    let part = 1.0 - 1e-3 * (100.0 * grows[0] / nu).min(1.0);
    let end = 10.0 * (1.0 - part) / grows[0];
    let followed = grows[0] > 1e-6 * nu && p.rate.abs() * slips / p.radius * end < 1e5;
    let near = thrown(&lossy, [part * slips, 0.0], grows.map(|x| part * slips * x));
    let let_go = when(followed, || lossy.zero(&near, 1, end, step, |y| lossy.grip(y)))?;
    let let_go = let_go.map_or(f64::NAN, |(event, _)| level(Moving::of(&event.state).place));
    // Wrong: Lagrange's equation after rolling was put into the kinetic energy.
    let (wrong, rate) = (nu / k.sqrt(), p.rate);
    let naive = ode(move |_, &[x, y, vx, vy]: &[f64; 4]| {
        [vx, vy, share(k) * rate * (rate * x - 2.0 * vy), share(k) * rate * (rate * y + 2.0 * vx)]
    })
    .scaled(size_or([1.0; 4]));
    let away = |t: f64| -> Result<f64> {
        let [x, y, ..] = after(t / wrong, &naive, &[1.0, 0.0, 0.0, 0.1 * rate], 1e-14)?;
        Ok(log(hypot(x, y)))
    };
    claims! { report,
        /// tilted: velocity of the drift, across the slope
        drift: drift, "m/s", "simulated" => moved.y() * nu / (2.0 * PI), within bound * (drift.abs() + v.abs()), in "The tilted table":
            drift * k / (1.0 + k) => "in the drift nothing accelerates";
        /// tilted: drift down the slope
        downhill: 0.0, "m/s", "simulated" => moved.x() * nu / (2.0 * PI), within bound * (drift.abs() + v.abs());
        /// rolling resistance: the circle grows at the rate
        grows: grows[0], "1/s", "simulated" => measured(lossy, grows, step)?, within 10.0 * bound * nu;
        /// its middle comes to the axis at the rate
        shrinks: -shrinks[0], "1/s", "simulated" => -measured(lossy, shrinks, step)?, within 10.0 * bound * nu;
        /// the growing circle slips when its radius is
        spiral_slip: slips, "m", "located event" => let_go, within 1e-6 * slips, if followed;
        /// wrong: rate at which it leaves the axis
        naive: wrong, "1/s", "simulated" => wrong * 0.125 * (away(24.0)? - away(16.0)?), within 1e-9 * wrong;
    }
}

fn cylinder(p: &Parameters, report: &mut Report) -> Result<()> {
    let (bobbing, (golf, start)) = (bobbing(p), in_hole(p, 0.0)?);
    let (k, g, bound) = (p.shape, p.gravity, 1e4 * p.tolerance);
    let extreme = |n| golf.zero(&start, n, 1e9, p.tolerance, |y| y[5]);
    // Thrown upward, it is highest first.
    let first = if p.drop < 0.0 { 2 } else { 1 };
    let (low, after_it) = (extreme(first)?.0, extreme(first + 2)?.0);
    let (push, most) = golf.forces(&Moving::of(&low.state));
    let depth = bobbing.amplitude - bobbing.middle;
    let bob = 2.0 * PI / (after_it.t - low.t);
    let pressed = p.orbit * p.orbit * (p.hole - p.golf);
    let wall = bobbing.friction * g / pressed;
    claims! { report,
        /// in the cylinder: angular frequency of going up and down
        bob: bobbing.rate, "rad/s", "located event" => bob, within bound * bobbing.rate, in "In the cylinder":
            p.orbit.abs() => "not once a turn",
            p.orbit.abs() * share(k) => "it is the square of the ratio";
        /// turns about the axis for one time up and down
        turns: p.orbit.abs() / bobbing.rate, "-", "located event" => p.orbit.abs() / bob, within bound * p.orbit.abs() / bobbing.rate, in "In the cylinder";
        /// depth of the lowest place
        depth: depth, "m", "located event" => -low.state[2], within bound * (depth + 1e-3), in "In the cylinder":
            bobbing.amplitude => "count from the start, not from the middle";
        /// when it is there
        lowest: bobbing.lowest, "s", "located event" => low.t, within bound * low.t;
        /// coefficient of friction that this needs
        wall_mu: wall, "-", "contact forces" => most.norm() / push, within bound * wall, in "In the cylinder":
            g / pressed => "at its lowest place it accelerates upward";
    }
}

/// Balls of other kinds, and those that do nothing.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (ball, _) = on_table(p);
    let slow = thrown(&ball, [0.01 * p.radius, 0.0], [0.0, 1e-3 * p.rate * p.radius]);
    let rate = |shape| -> Result<f64> {
        Ok(2.0 * PI / (turning(Ball { shape, ..ball }, &slow, 2, 1e-12)?.0.t * p.rate.abs()))
    };
    let still = thrown(&ball, [p.place, 0.0], [0.0; 2]);
    let rests = ball.later(&still, 100.0 / p.rate.abs(), 1e-12)?.place - still.place;
    let size = if p.place == 0.0 { p.radius } else { p.place.abs() };
    let [middle, circle] = exponents(1.0, p.shape, 1e-9 * (1.0 + p.shape));
    let (golf, start) = in_hole(p, 0.0)?;
    let hanging = golf.rolling(start.place, SpaceVector::zero(), 0.0);
    let falls = golf.later(&hanging, 0.1, 1e-12)?.velocity.z();
    limits! { report,
        /// a thin shell, k = 2/3
        "k = 2/3: nu/Omega": rate(2.0 / 3.0)? => 0.4, within 1e-11;
        /// nearly all mass in the middle: friction cannot push it, it goes straight on
        "k = 0.01: nu/(k Omega)": rate(0.01)? / 0.01 => 1.0, within 0.01;
        /// too hard to turn: it goes around as the table does
        "k = 1e9: nu/Omega": rate(1e9)? => 1.0, within 1e-8;
        /// v = 0: it rolls on the spot, as the table passes below it
        "v = 0: way/place": level(rests) / size => 0.0, within 1e-12;
        /// small rolling resistance c: the middle comes in with c/k
        "c = 1e-9 (1 + k): shrinks k/c": -1e9 * middle[0] * share(p.shape) => 1.0, within 1e-7;
        /// and the circle grows with c/(k (1 + k))
        "c = 1e-9 (1 + k): grows k (1 + k)/c": 1e9 * circle[0] * p.shape => 1.0, within 1e-7;
        /// no turning about the axis: it falls as on an upright slope
        "W = 0: (1 + k) z''/g": -falls * 10.0 * (1.0 + p.shape) / p.gravity => 1.0, within 1e-11;
    }
}

fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (nu, k, v) = (share(p.shape) * p.rate.abs(), p.shape, p.velocity.abs());
    let (turn, lossy) = (2.0 * PI / nu, p.loss / (1.0 + k));
    let air = 3.0 * 1.204 * 0.47 * v / (8.0 * 7850.0 * p.radius);
    let (slant, earth) = (1e-3 * p.gravity / (k * p.rate.abs()), 7.292e-5 / nu);
    let ((ball, start), step) = (on_table(p), p.tolerance.min(1e-9));
    let sloping = tilted(ball, &p.but(|p| p.tilt = 1e-3));
    let drifted = level(sloping.later(&start, turn, step)?.place - start.place);
    let rolling = Ball { loss: p.loss, ..ball.without_edge() };
    let grows = exponents(p.rate, k, p.loss)[1];
    let (noise, slips) = (1e4 * step, nu * v / (p.friction * p.gravity));
    effect_card! { report,
        "slipping": "nu v/(mu g)" = slips, costs f64::from(slips > 1.0), "of the circle", included;
        "table not level, by 1 mrad": "g epsilon/(k Omega v)" = slant / v, costs turn * slant, "m of drift a turn",
            measured drifted, within noise * (p.place.abs() + v / nu);
        "rolling resistance": "c/((1 + k) nu)" = lossy / nu, costs turn * grows[0], "of the radius a turn",
            measured turn * measured(rolling, grows, step)?, within noise;
        "air drag, steel ball": "gamma/nu" = air / nu, costs turn * air / (1.0 + k), "of the radius a turn";
        "turning of the Earth, at a pole": "Omega_E/nu" = earth, costs earth / (1.0 + k), "of nu";
        "pivoting friction": "M_n/(m g a), without effect" = 0.0, costs 0.0, "of the circle";
    }
}

/// The accuracy strip: a turn of the circle.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((ball, start), nu) = (on_table(p), share(p.shape) * p.rate);
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15];
    let turn = move |step| turning(ball, &start, 2, step);
    report.dial_of_return(asked, turn, 2.0 * PI / nu.abs(), p.place)?;
    let (c, r) = (p.place - p.velocity / nu, p.velocity / nu);
    report.set_closed_form(ClosedForm::new(move |part| {
        let (s, k) = sincos(2.0 * PI * part * nu.signum());
        Ok::<_, rotation_dynamics::Error>([c + r * k, r * s])
    }));
    Ok(())
}

example! {
    further_6_turntable: "A ball that rolls on a turntable, and one inside an upright cylinder";
    "A ball on a turntable", "A ball rolls without slipping on a table that turns, and another inside a cylinder.",
    [circle, tilt_and_loss, cylinder, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
