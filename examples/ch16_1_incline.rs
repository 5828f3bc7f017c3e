//! Section 16.1: a cylinder that rolls up an incline and back, and what makes it turn.
//!
//! ```text
//! cargo run --example ch16_1_incline -- --friction 0.1 --check acceleration=-4.05
//! ```

#[path = "ch16_1_incline/bouncer.rs"]
pub mod bouncer;
#[path = "ch16_1_incline/figures.rs"]
mod figures;

pub use bouncer::Bouncer;
use core::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};
use kit::interval::at_least;
use kit::prelude::*;
use kit::short;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::math::log1p;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Mode, QuadraticDrag, Surface, entry,
    motion_within,
};

parameters! {
    /// The cylinder of the example; the notes leave all numbers open.
    pub struct Parameters {
        /// inclination of the slope
        angle: number(FRAC_PI_6, "rad", between(0.0, FRAC_PI_2).because("level nothing brings it back, upright nothing presses it").usually(0.05, 1.2)).open("inclination of the slope", "gentle", "steep");
        /// mass of the body
        mass: number(2.0, "kg", above(0.0).usually(0.1, 10.0));
        /// radius of the body
        radius: number(0.1, "m", above(0.0).usually(0.02, 0.5));
        /// k = I/(m R^2): 1/2 for a cylinder, 2/5 for a ball, 1 for a hoop
        shape: number(0.5, "-", above_to(0.0, 1.0).because("no mass is outside the body").usually(0.1, 1.0)).open("shape: I/(m R^2)", "mass at the middle", "a hoop");
        /// coefficient of friction between the body and the slope
        friction: number(0.5, "-", at_least(0.0).usually(0.0, 1.0)).open("coefficient of friction", "slides", "rolls");
        /// speed at the start, up the slope, rolling
        speed: number(2.0, "m/s", above(0.0).because("started downward it never turns").usually(0.5, 5.0));
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// arm of the normal force ahead of the body, for the claims about it
        rolling: effect(2e-4, "m", above_to(0.0, 1.0));
        /// drag coefficient of a cylinder of wood in air, for the claims about it
        air: effect(1.0, "-", above_to(0.0, 1e3).because("more is a parachute"));
        /// relative error asked for, at every event: from 1e-13 to 0.01
        tolerance: number(1e-12, "-", from_to(1e-13, 0.01));
    }
}

/// What ends a run.
#[derive(Debug, Clone, Copy)]
pub enum Goal {
    /// Its time only.
    Never,
    /// The highest place.
    Top,
    /// So far down the slope from where it began.
    Down(f64),
}

/// A round body on a slope, per unit mass: `[x, y, angle]`, up along the slope, at right angles
/// to it, and counterclockwise; the slope rises to the right, so phi = -angle.
#[derive(Debug, Clone, Copy)]
pub struct Roller {
    pub slope: f64,
    pub radius: f64,
    pub shape: f64,
    pub mu: f64,
    pub gravity: f64,
    /// The speed that errors count against.
    pub speed: f64,
    pub goal: Goal,
}

// ANCHOR: scene
impl Mechanism<3, 1> for Roller {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.shape * self.radius * self.radius;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        let [along, across] = [sin, cos].map(|part| self.gravity * part(self.slope));
        [-along, -across, 0.0]
    }

    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 1] {
        [Contact::rim("body", body, self.radius, Surface::FLOOR).friction(self.mu)]
    }
    // ANCHOR_END: scene

    fn end(&self, body: &MechanismState<3>) -> Option<(&'static str, f64)> {
        match self.goal {
            Goal::Never => None,
            Goal::Top => Some(("turns", body.v[0])),
            Goal::Down(length) => Some(("arrives", length + body.q[0])),
        }
    }

    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let (v, r) = (self.speed, self.radius);
        let length = v * v / (self.gravity * sin(self.slope));
        MechanismState { q: [length, r, length / r], v: [v, v, v / r] }
    }
}

// ANCHOR: resisted
/// The body with rolling resistance: one contact more, which rides on the other.
#[derive(Debug, Clone, Copy)]
pub struct Resisted {
    pub roller: Roller,
    /// The torque over normal force and radius.
    pub resistance: f64,
}

impl Mechanism<3, 2> for Resisted {
    fn mass(&self, q: &[f64; 3]) -> [[f64; 3]; 3] {
        self.roller.mass(q)
    }
    fn force(&self, body: &MechanismState<3>) -> [f64; 3] {
        self.roller.force(body)
    }
    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 2] {
        let [rim] = self.roller.contacts(body);
        let rolling = Contact::rolling("rolling", 0, self.roller.radius, self.resistance);
        [rim, rolling]
    }
    // ANCHOR_END: resisted
    /// A hair before the highest place, where the resistance turns round as well: which comes first
    /// is round-off.
    fn end(&self, body: &MechanismState<3>) -> Option<(&'static str, f64)> {
        let (name, left) = self.roller.end(body)?;
        Some((name, left - 1e-9 * self.roller.speed))
    }
    fn scale(&self, body: &MechanismState<3>) -> MechanismState<3> {
        self.roller.scale(body)
    }
}

/// A motion of the body.
pub type Roll = ContactMotion<Roller, 3, 1>;

impl Roller {
    /// The body of these parameters.
    pub fn new(p: &Parameters) -> Self {
        Self {
            slope: p.angle,
            radius: p.radius,
            shape: p.shape,
            mu: p.friction,
            gravity: p.gravity,
            speed: p.speed,
            goal: Goal::Never,
        }
    }

    /// Rolling up the slope at this speed.
    pub fn rolling(&self, speed: f64) -> MechanismState<3> {
        MechanismState { q: [0.0, self.radius, 0.0], v: [speed, 0.0, -speed / self.radius] }
    }

    /// The motion from there, at most until `end`.
    pub fn run(self, goal: Goal, speed: f64, end: f64, tolerance: f64) -> Result<Roll> {
        let body = Self { goal, ..self };
        Ok(motion_within(body, tolerance, body.rolling(speed), end)?)
    }

    // ANCHOR: law
    /// The coefficient of friction that rolling needs: `k/(1 + k) tan(theta)`.
    pub fn needed(&self) -> f64 {
        self.shape / (1.0 + self.shape) * tan(self.slope)
    }

    /// Friction over the normal force, up the slope: what rolling needs, or all there is.
    pub fn grip(&self) -> f64 {
        self.needed().min(self.mu)
    }

    /// x'', up the slope, of a body that rolls at the start.
    pub fn acceleration(&self) -> f64 {
        if self.grip() < self.needed() {
            return -self.gravity * (sin(self.slope) - self.grip() * cos(self.slope));
        }
        -self.gravity * sin(self.slope) / (1.0 + self.shape)
    }

    /// R phi''.
    pub fn spinning_up(&self) -> f64 {
        -self.grip() * self.gravity * cos(self.slope) / self.shape
    }
    // ANCHOR_END: law

    /// R phi' over the first speed, and the energy over the first, back at the start.
    pub fn back(&self) -> [f64; 2] {
        let spin = 1.0 - 2.0 * self.spinning_up() / self.acceleration();
        [spin, (1.0 + self.shape * spin * spin) / (1.0 + self.shape)]
    }

    /// The coefficient of friction with which it comes back without any spin.
    pub fn worst(&self) -> f64 {
        self.needed() * (1.0 + self.shape) / (2.0 + self.shape)
    }

    /// The same, simulated.
    pub fn run_back(self, tolerance: f64) -> Result<[f64; 2]> {
        let end = -2.0 * self.speed / self.acceleration();
        let [vx, _, rate] = self.run(Goal::Never, self.speed, end, tolerance)?.at(end)?.v;
        let (speed, spin) = (vx / self.speed, -rate * self.radius / self.speed);
        Ok([spin, (speed * speed + self.shape * spin * spin) / (1.0 + self.shape)])
    }

    /// Time down a length of the slope, from rest; closed form and located.
    pub fn race(self, length: f64, tolerance: f64) -> Result<[f64; 2]> {
        let time = (-2.0 * length / self.acceleration()).sqrt();
        let speed = length / time;
        let run = Self { speed, ..self }.run(Goal::Down(length), 0.0, 2.0 * time, tolerance)?;
        Ok([time, run.event("arrives")?.t])
    }
}

/// The least coefficient of friction with which the solver lets the body stick: by bisection.
fn holds_from(body: Roller) -> Result<f64> {
    let slips = |mu| -> Result<bool> {
        let there = Roller { mu, ..body };
        Ok(entry(&there, there.rolling(body.speed))?.0 != [Mode::Stick])
    };
    Ok(try_bisect([0.0, 2.0 * body.needed()], 0.0, slips)?[1])
}

/// A body with this `k` that does not slip; with 0, a block without friction.
pub fn gripping(p: &Parameters, shape: f64) -> Roller {
    let (shape, mu) = if shape == 0.0 { (1.0, 0.0) } else { (shape, tan(p.angle)) };
    Roller { shape, mu, ..Roller::new(p) }
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, m, g, v) = (Roller::new(p), p.mass, p.gravity, p.speed);
    let told =
        at_least(1e-10).because("contacts do not tell a smaller part of the weight from none");
    told.check("coefficient of friction that rolling needs", body.needed())?;
    let ((s, c), k, a) = (sincos(p.angle), p.shape, body.acceleration());
    let (top, bound) = (-v / a, 8.0 * p.tolerance);
    let up = body.run(Goal::Top, v, 2.0 * top, p.tolerance)?;
    let turns = up.event("turns")?;
    let whole = body.run(Goal::Never, v, 2.0 * top, p.tolerance)?;
    let ([rising], [falling]) = (whole.forces(0.3 * top)?, whole.forces(1.7 * top)?);
    let (rubbing, pressing, needed) = (m * g * c * body.grip(), m * g * c, body.needed());
    let ([spin, kept], [ran_spin, ran_kept]) = (body.back(), body.run_back(p.tolerance)?);
    let worst = Roller { mu: body.worst(), ..body };
    let [worst_spin, worst_kept] = worst.run_back(p.tolerance)?;
    let race = |shape| gripping(p, shape).race(1.0, p.tolerance);
    let ([ball, ball_ran], [cylinder, cylinder_ran]) = (race(0.4)?, race(0.5)?);
    let [hoop, hoop_ran] = race(1.0)?;
    let dropped = Bouncer::new(p);
    let (limit, found) = (dropped.rests(), dropped.run(p.tolerance)?);
    let fast = g * s * 2.0 * limit / 1.4;
    claims! { report,
        /// acceleration, up the slope
        acceleration: a, "m/s^2", "located event" => -v / turns.t, within -bound * a, in "Up and back":
            -g * s => "that slides without friction; the energy of the rotation counts too",
            -g * c / (1.0 + k) => "the height is x times the sine",
            g * s / (1.0 + k) => "x is counted up the slope";
        /// distance to the highest place
        distance: -0.5 * v * v / a, "m", "located event" => turns.before.q[0], within -bound * v * v / a, in "Up and back":
            0.5 * v * v / (g * s) => "that slides without friction";
        /// time to the highest place
        t_top: top, "s", "located event" => turns.t, within bound * top, in "Up and back";
        /// friction, up the slope, on the way up
        friction_up: rubbing, "N", "contact solver" => m * rising.tangential, within bound * m * g, in "The forces":
            -rubbing => "which way does it change the spin?",
            m * g * c * p.friction => "that is the most there can be",
            m * g * s => "then it would not slow down";
        /// friction, up the slope, on the way down
        friction_down: rubbing, "N", "contact solver" => m * falling.tangential, within bound * m * g, in "The forces":
            -rubbing => "which way does it change the spin?";
        /// normal force
        normal: pressing, "N", "contact solver" => m * rising.normal, within bound * m * g, in "The forces":
            m * g => "that is the weight";
        /// least coefficient of friction for rolling
        mu_min: needed, "-", "bisection of the modes" => holds_from(body)?, within 1e-9 * needed + 1e-11, in "The forces":
            tan(p.angle) => "that is for a body that does not turn";
        /// R phi' over the first speed, back at the start
        spin_back: spin, "-", "simulated" => ran_spin, within bound * (1.0 + spin.abs());
        /// energy over the first, back at the start
        energy_back: kept, "-", "simulated" => ran_kept, within 2.0 * bound * (1.0 + spin * spin);
        /// coefficient of friction with which most energy is lost
        mu_worst: worst.mu, "-", "no spin is left: simulated" => worst.mu * (1.0 + worst_spin), within bound * worst.mu;
        /// the part of the energy lost then
        lost_worst: k / (1.0 + k), "-", "simulated" => 1.0 - worst_kept, within bound;
        /// a ball, from rest: time down 1 m
        race_ball: ball, "s", "located event" => ball_ran, within bound * ball;
        /// a cylinder
        race_cylinder: cylinder, "s", "located event" => cylinder_ran, within bound * cylinder, in "The race":
            ball => "that is the ball";
        /// a hoop
        race_hoop: hoop, "s", "located event" => hoop_ran, within bound * hoop;
        /// a ball, dropped, that returns 0.6 of its speed: the end of its bounces
        drop_rests: limit, "s", "located event" => found.event("body rests")?.t, within 1e-9 * limit;
        /// its speed down the slope at twice that time
        drop_speed: fast, "m/s", "contact solver" => -found.at(2.0 * limit)?.v[0], within bound * fast;
    }
}

/// Bodies of known shape, on slopes without friction and too steep to roll on.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let over = |body: Roller| -> Result<f64> {
        let (v, sine) = (body.speed, body.gravity * sin(body.slope));
        let up = body.run(Goal::Top, v, 10.0 * v / sine, 1e-12)?;
        Ok(v / (up.event("turns")?.t * sine))
    };
    let (plain, steep) = (gripping(p, p.shape), FRAC_PI_2 - 1e-3);
    // On a slope where contacts tell so small a part of the weight from none.
    let angle = p.angle.clamp(1e-2, 1.56);
    let sloping = gripping(&Parameters { angle, ..p.clone() }, p.shape);
    let near = |part| Roller { mu: part * sloping.needed(), ..sloping };
    let ice = Roller { mu: 0.0, ..plain };
    limits! { report,
        /// all mass on the axis: it slides like a block
        "k = 1e-9: -x''/(g sin theta)": over(gripping(p, 1e-9))? => 1.0, within 2e-9;
        /// a hoop has as much energy in its turning as in its going
        "k = 1: -x''/(g sin theta)": over(gripping(p, 1.0))? => 0.5, within 1e-11;
        /// no friction: it slides, and keeps its spin
        "mu = 0: -x''/(g sin theta)": over(ice)? => 1.0, within 1e-11;
        /// nothing has changed the spin
        "mu = 0: spin on return over the first": ice.run_back(1e-12)?[0] => 1.0, within 1e-11;
        /// just below the threshold it still goes as if it rolled
        "mu = 0.9999999 mu_min: -(1 + k) x''/(g sin theta)":
            (1.0 + p.shape) * over(near(0.999_999_9))? => 1.0, within 1e-6;
        /// all but upright, nothing presses and nothing rubs
        "theta = pi/2 - 0.001, mu = 0.5: -x''/g":
            over(Roller { slope: steep, mu: 0.5, shape: 0.5, ..plain })? => 1.0 - 5e-4, within 1e-6;
    }
}

/// How far up the slope a body comes that starts rolling.
fn way<const C: usize>(
    body: impl Mechanism<3, C>,
    start: MechanismState<3>,
    end: f64,
) -> Result<f64> {
    Ok(motion_within(body, 1e-10, start, end)?.event("turns")?.before.q[0])
}

/// Drag over the mass, for a cylinder of wood (700 kg/m^3, C = 1) in air: `rho C (2 R l)/(2 m)`
/// with its length l.
fn drag(p: &Parameters) -> f64 {
    1.204 / (700.0 * PI * p.radius)
}

/// What `--with rolling` and `--with air` add: it does not come as far. With the arm b to
/// `1/(1 + b/(R tan))` of the way up, in air to `log(1 + d)/d`, d the drag over the pull of the slope.
fn resisted(p: &Parameters, report: &mut Report) -> Result<()> {
    let body = Roller::new(p);
    let (roller, start) = (Roller { goal: Goal::Top, ..body }, body.rolling(p.speed));
    let end = -4.0 * p.speed / body.acceleration();
    let far = -0.5 * p.speed * p.speed / body.acceleration();
    let grips = |least: f64, why| at_least(least).because(why).check("friction", p.friction);
    if p.rolling.is_some() || p.air.is_some() {
        // What slides is slowed down otherwise.
        grips(body.needed(), "less does not let it roll")?;
    }
    if let Some(arm) = p.rolling {
        let resistance = arm / p.radius;
        // Beyond k tan(theta) it is the friction that keeps it turning.
        let needed = (resistance - p.shape * tan(p.angle)) / (1.0 + p.shape);
        grips(needed, "less does not keep it turning against the resistance")?;
        let far = far / (1.0 + resistance / tan(p.angle));
        claims! { report,
            /// with rolling resistance: distance to the highest place
            rolled_way: far, "m", "located event" => way(Resisted { roller, resistance }, start, end)?, within 1e-8 * far;
        }?;
    }
    let Some(coefficient) = p.air else {
        return Ok(());
    };
    let air = QuadraticDrag::new(coefficient * drag(p))?;
    let number = air.number(p.speed, p.gravity * sin(p.angle));
    grips(body.needed() * (1.0 + number), "less lets it slip in the drag")?;
    let far = far * log1p(number) / number;
    claims! { report,
        /// in air: distance to the highest place
        blown_way: far, "m", "located event" => way(roller.with(air), start, end)?, within 1e-8 * far;
    }
}

/// The card of effects: up to the highest place, with the effect in and without.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, v, arm) = (Roller::new(p), p.speed, 2e-4);
    let sliding = body.grip() < body.needed();
    let (roller, start) = (Roller { goal: Goal::Top, ..body }, body.rolling(v));
    let (end, air) = (-4.0 * v / body.acceleration(), QuadraticDrag::new(drag(p))?);
    let still = way(roller, start, end)?;
    let shorter = |way: f64| (1.0 - way / still).max(0.0);
    // What slides is not slowed down by what its turning meets.
    let all_but_held = arm > 10.0 * p.radius * tan(p.angle);
    let rolled = match sliding {
        true => Some(0.0),
        false if all_but_held => None,
        false => {
            let resisted = Resisted { roller, resistance: arm / p.radius };
            Some(shorter(way(resisted, start, end)?))
        }
    };
    let rolling = arm / (p.radius * tan(p.angle));
    let held = if sliding { 0.0 } else { rolling / (1.0 + rolling) };
    let number = air.number(v, p.gravity * sin(p.angle));
    // Slowed down much, it slips.
    let grips = !sliding && body.needed() * (1.0 + number) <= body.mu;
    let slowed = when(grips, || Ok::<_, kit::Error>(shorter(way(roller.with(air), start, end)?)))?;
    let blown = (1.0 - log1p(number) / number).max(0.0);
    let thick = Roller { mu: body.mu * 0.99, ..body }.acceleration() / body.acceleration() - 1.0;
    let slips = match p.friction > 0.0 {
        true => effect("slipping").number("mu_min/mu", body.needed() / p.friction),
        false => effect("slipping").number("mu/mu_min", 0.0),
    };
    report.add(slips.costs(thick, "of x'' for 1 % less mu").included())?;
    effect_card! { report,
        "rolling resistance, arm 0.2 mm": "b/(R tan theta)" = rolling, costs held, "of the distance",
            measured rolled, within 1e-8;
        "drag of the air, a cylinder of wood": "rho C R l v^2/(m g sin theta)" = number, costs blown, "of the distance",
            measured slowed, within 1e-8;
    }
}

/// Bodies that roll, in the order in which they arrive.
fn race(p: &Parameters, report: &mut Report) -> Result<()> {
    let bodies = [
        ("block without friction", 0.0),
        ("ball", 0.4),
        ("cylinder", 0.5),
        ("thin spherical shell", 2.0 / 3.0),
        ("hoop", 1.0),
    ];
    let columns = "body, k, -x''/(g sin theta), mu_min/tan theta, t / s";
    report.add(Table::of("race", columns.split(", "), bodies, |(name, k)| {
        let [_, time] = gripping(p, k).race(1.0, p.tolerance)?;
        let numbers = [k, 1.0 / (1.0 + k), k / (1.0 + k), time].map(|x| short(x, 4));
        Ok(core::iter::once(name.to_string()).chain(numbers))
    })?)
}

/// The accuracy strip: up and back.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, v) = (Roller::new(p), p.speed);
    let end = -2.0 * v / body.acceleration();
    report.in_closed_form(move |part| {
        let t = part * end;
        (v + 0.5 * body.acceleration() * t) * t
    });
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-13];
    let run = move |tolerance| body.run(Goal::Never, v, end, tolerance);
    report.controlled("contact by DOP853", asked, run, Roll::work, move |run| {
        let MechanismState { q, v: [back, ..] } = run.at(end)?;
        Ok(largest([q[0] / (v * end), back / v + 1.0]))
    })
}

example! {
    ch16_1_incline: "Section 16.1: a cylinder that rolls up an incline and back";
    "Rolling on an incline", "A round body rolls up a slope, stops, and rolls back.",
    [claims, resisted, limits, effects, accuracy, race];
    figures::figures, figures::trajectory, figures::moving_picture
}
