//! Section 16.2 (1): a cylinder made to precess at a constant tilt, the torque that it takes,
//! and what the cylinder does when it is let go.
//!
//! ```text
//! cargo run --example ch16_2_precessing_cylinder -- --height 0.02 --check torque=0.05
//! ```

#[path = "ch16_2_precessing_cylinder/figures.rs"]
mod figures;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, Work, ode, second_order, size_or};

parameters! {
    /// The cylinder of section 15.4; the notes leave all numbers open.
    pub struct Parameters {
        /// mass
        mass: number(2.0, "kg", above(0.0).usually(0.1, 10.0));
        /// radius
        radius: number(0.05, "m", above(0.0).usually(0.01, 0.2));
        /// height along the axis
        height: number(0.3, "m", at_least(0.0).usually(0.0, 0.5)).open("height of the cylinder", "a disc", "a rod");
        /// tilt of the axis from the vertical
        tilt: number(0.5, "rad", between(0.0, FRAC_PI_2).because("upright and level it needs no torque").usually(0.05, 1.5)).open("tilt of the clamped axis", "nearly upright", "nearly level");
        /// angular velocity about the vertical
        rate: number(10.0, "rad/s", any().usually(1.0, 100.0));
        tolerance: step(1e-13, 1e-3);
    }
}

/// Moments across the axis and along it, the tilt held, the rate about the vertical.
#[derive(Debug, Clone, Copy)]
pub struct Cylinder {
    pub i1: f64,
    pub i3: f64,
    pub tilt: f64,
    pub rate: f64,
}

/// What is let go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LetGo {
    /// The clamp, while a motor keeps the rate.
    Motor,
    /// The clamp; the fork turns on by itself.
    Clamp,
    /// Everything.
    All,
}

impl Cylinder {
    pub fn new(p: &Parameters) -> Result<Self> {
        let square = p.radius * p.radius;
        let i1 = p.mass * (3.0 * square + p.height * p.height) / 12.0;
        let i3 = 0.5 * p.mass * square;
        let body = Self { i1, i3, tilt: p.tilt, rate: p.rate };
        allowed! {
            "|I1 - I3|/I1": ((i1 - i3) / i1).abs(), from_to(1e-3, 1.0), "like a ball it needs no torque";
            "tolerance": p.tolerance, from_to(0.0, 0.1 * body.slowness()), "so near to upright or level the swing goes over";
        }?;
        require(p.rate != 0.0, "rate", p.rate, "at rest the cylinder needs no torque and stays")?;
        Ok(body)
    }

    // ANCHOR: lagrange
    /// The moment about the vertical at a tilt.
    pub fn about_vertical(&self, tilt: f64) -> f64 {
        let (s, c) = sincos(tilt);
        self.i3 * c * c + self.i1 * s * s
    }

    /// L_Z, the derivative of the Lagrangian by phi'.
    pub fn vertical_momentum(&self) -> f64 {
        self.about_vertical(self.tilt) * self.rate
    }

    /// lambda, what the clamp adds to make the tilt stay.
    pub fn torque(&self) -> f64 {
        let (s, c) = sincos(self.tilt);
        -(self.i1 - self.i3) * self.rate * self.rate * s * c
    }

    /// Lagrange's equations once the constraint is gone: `[theta, phi, theta', phi']`.
    pub fn let_go(&self, what: LetGo) -> impl Ode<4> {
        let Self { i1, i3, tilt, rate } = *self;
        let spin = i3 * rate * cos(tilt);
        ode(move |_, &[theta, _, nod, turn]: &[f64; 4]| {
            let (s, c) = sincos(theta);
            let free = s * c * turn * turn - spin / i1 * turn * s;
            let forked = (i1 - i3) / i1 * s * c * turn * turn;
            let whole = i3 * c * c + i1 * s * s;
            match what {
                LetGo::Motor => [nod, turn, forked, 0.0],
                LetGo::Clamp => [nod, turn, forked, -2.0 * (i1 - i3) * s * c * nod * turn / whole],
                LetGo::All => [nod, turn, free, nod * (spin / (i1 * s) - 2.0 * turn * c / s)],
            }
        })
        .scaled(size_or([1.0; 4]))
    }
    // ANCHOR_END: lagrange

    /// The state at which it is let go.
    pub fn start(&self) -> [f64; 4] {
        [self.tilt, 0.0, 0.0, self.rate]
    }

    fn long(&self) -> bool {
        self.i1 > self.i3
    }

    /// The square of the sine of the angle from rest, upright or level: what an error of a step
    /// has to be small against, or the swing may go over.
    fn slowness(&self) -> f64 {
        let (s, c) = sincos(self.tilt);
        s.min(c) * s.min(c)
    }

    /// The angle between L and the axis while the cylinder is held.
    pub fn lean(&self) -> f64 {
        atan2(self.i1 * sin(self.tilt), self.i3 * cos(self.tilt))
    }

    /// The tilt at the far end of the swing, and the time of a whole one.
    pub fn swung(&self, what: LetGo) -> Result<[f64; 2]> {
        let (s, c) = sincos(self.tilt);
        let far = if self.long() { PI - self.tilt } else { -self.tilt };
        Ok(match what {
            LetGo::Motor => {
                let modulus = Modulus::from_k(if self.long() { c } else { s })?;
                // That of small swings about the tilt of rest.
                let rate = self.rate.abs() * ((self.i1 - self.i3).abs() / self.i1).sqrt();
                [far, 4.0 * legendre::k(modulus)? / rate]
            }
            LetGo::Clamp => [far, self.coasting()],
            LetGo::All => {
                let momentum = hypot(self.i1 * s, self.i3 * c) * self.rate.abs();
                [(2.0 * self.lean() - self.tilt).abs(), TAU * self.i1 / momentum]
            }
        })
    }

    /// The time of a swing with L_Z kept: an integral over a period, by equal steps.
    fn coasting(&self) -> f64 {
        let (s, c) = sincos(self.tilt);
        let edge = if self.long() { c } else { s };
        let here = self.about_vertical(self.tilt);
        let slope = |psi: f64| {
            let off = edge * sin(psi);
            let square = off * off;
            let cosine = if self.long() { square } else { 1.0 - square };
            (self.i1 * here * (self.i1 - (self.i1 - self.i3) * cosine) / (1.0 - square)).sqrt()
        };
        // The nearest singularity is as far off the real line as the small one of sine and cosine.
        let n = 64.0 + (40.0 / s.min(c)).ceil();
        let sum: f64 = (0..n as u32).map(|k| slope(TAU * f64::from(k) / n)).sum();
        let scale = (self.i1 - self.i3).abs().sqrt() * self.vertical_momentum().abs();
        TAU / n * sum / scale
    }

    /// Turning point number `n` of the simulated swing.
    fn turning(&self, what: LetGo, n: u32, step: f64) -> Result<(LocatedEvent<4>, Work)> {
        let until = 10.0 * self.swung(what)?[1];
        Ok(Dop853::new(step)?.zero(&self.let_go(what), self.start(), n, until, |y| y[2])?)
    }

    /// Where it is while it is held: the fork has turned by `turn`.
    pub fn held(&self, turn: f64) -> Result<Attitude> {
        Ok(Attitude::from_euler(EulerAngles { phi: turn, theta: self.tilt, zeta: 0.0 })?)
    }

    /// Its motion if everything is let go when it has turned by 0, by the library.
    pub fn freed(&self) -> Result<FreeBody> {
        let (s, c) = sincos(self.tilt);
        let omega = BodyVector::new(0.0, self.rate * s, self.rate * c);
        let moments = PrincipalMoments::symmetric(self.i1, self.i3)?;
        Ok(FreeBody::new(moments, self.held(0.0)?, omega)?)
    }
}

// ANCHOR: grains
/// Grains at equal parts of the mass: three rings, eight around, two high, as far out as makes
/// the sums of squares those of the cylinder.
pub fn grains(p: &Parameters) -> impl Iterator<Item = BodyVector> {
    let (radius, up) = (p.radius, p.height / 12.0_f64.sqrt());
    (0..48).map(move |n| {
        let (ring, around, side) = (n % 3, n / 3 % 8, n / 24);
        let out = radius * ((f64::from(ring) + 0.5) / 3.0).sqrt();
        let (s, c) = sincos(TAU * f64::from(around) / 8.0);
        BodyVector::new(out * c, out * s, if side == 0 { up } else { -up })
    })
}

/// L_Z, and the torque along x of the forces that keep the grains on their circles.
pub fn by_grains(p: &Parameters) -> Result<[f64; 2]> {
    held(p, grains(p), 0.0)
}

/// The same of these grains, with what they weigh held as well.
fn held(
    p: &Parameters,
    grains: impl Iterator<Item = BodyVector>,
    gravity: f64,
) -> Result<[f64; 2]> {
    let held = Attitude::from_euler(EulerAngles { phi: 0.0, theta: p.tilt, zeta: 0.0 })?;
    let (omega, share) = (SpaceVector::new(0.0, 0.0, p.rate), p.mass / 48.0);
    let up = SpaceVector::new(0.0, 0.0, gravity);
    Ok(grains.fold([0.0; 2], |[momentum, torque], grain| {
        let r = held.to_space(grain);
        let v = omega.cross(&r);
        let force = (omega.cross(&v) + up) * share;
        // At phi = 0 the direction x of the triad is X.
        [momentum + r.cross(&(v * share)).z(), torque + r.cross(&force).x()]
    }))
}
// ANCHOR_END: grains

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, [momentum, torque]) = (Cylinder::new(p)?, by_grains(p)?);
    let ((s, c), w, unit) = (sincos(p.tilt), p.rate, p.rate * p.rate * body.i1.max(body.i3));
    let (lz, lambda) = (body.vertical_momentum(), body.torque());
    let [motor, clamp, all] = [LetGo::Motor, LetGo::Clamp, LetGo::All];
    let ran = |what, n| Ok::<_, kit::Error>(body.turning(what, n, p.tolerance)?.0);
    let ([far, motor_time], [_, clamp_time]) = (body.swung(motor)?, body.swung(clamp)?);
    let [all_far, all_time] = body.swung(all)?;
    let error = 100.0 * p.tolerance.max(1e-14);
    let bound = error / body.slowness();
    let free_bound = error / (body.lean() - p.tilt).abs();
    let free = body.freed()?;
    let l = free.angular_momentum();
    // L of one that is turned the other way points down.
    let lean = if w > 0.0 { body.lean() } else { PI - body.lean() };
    // Where the grains need no torque.
    let balance = 3.0_f64.sqrt() * p.radius;
    let low = |height| Ok::<_, kit::Error>(by_grains(&p.but(|p| p.height = height))?[1] >= 0.0);
    let [below, above] = try_bisect([0.0, 4.0 * p.radius], 0.0, low)?;
    claims! { report,
        /// moment of inertia across the axis
        i1: body.i1, "kg m^2", "grains" => grains(p).map(|r| p.mass / 48.0 * (r.x() * r.x() + r.z() * r.z())).sum(),
        within 1e-14 * body.i1.max(body.i3);
        /// moment of inertia about the axis
        i3: body.i3, "kg m^2", "grains" => grains(p).map(|r| p.mass / 48.0 * (r.x() * r.x() + r.y() * r.y())).sum(),
        within 1e-14 * body.i3;
        /// angular momentum about the vertical
        vertical_momentum: lz, "kg m^2/s", "sum over grains" => momentum, within 1e-14 * unit / w, in "Held":
            body.i1 * w => "only a part of the turning is across the axis",
            body.i3 * w * c => "that is the component along the axis",
            hypot(body.i1 * s, body.i3 * c) * w => "that is the length of L";
        /// torque of the clamp, lambda
        torque: lambda, "N m", "forces on grains" => torque, within 1e-14 * unit, in "Held":
            -lambda => "which way does the cylinder want to go?",
            lambda / w => "is that a torque? look at the units",
            (body.i3 - body.i1) * w * w * s => "only a part of L is across the vertical";
        /// angle between L and the axis
        lean: lean, "rad", "library's free body" => acos(free.attitude(0.0).axis().dot(&l) / l.norm()),
        within 1e-7, in "Held":
            p.tilt => "that is the angle of the angular velocity";
        /// height at which no torque is needed
        balanced: balance, "m", "bisection over grains" => 0.5 * (below + above), within 1e-12 * balance, in "Held":
            2.0 * p.radius => "compare the moments";
        /// the clamp let go, a motor keeps the rate: far tilt
        motor_far: far, "rad", "located event" => ran(motor, 1)?.state[0], within bound;
        /// the same: time of a whole swing
        motor_time: motor_time, "s", "located event" => ran(motor, 2)?.t, within bound * motor_time;
        /// the clamp let go, nothing keeps the rate: time of a whole swing
        clamp_time: clamp_time, "s", "located event" => ran(clamp, 2)?.t, within bound * clamp_time;
        /// everything let go: far tilt
        free_far: all_far, "rad", "located event" => ran(all, 1)?.state[0], within free_bound, in "Let go":
            far => "with the fork; a free cylinder circles its L",
            body.lean() => "that is the angle from L";
        /// the same: time of a whole nod
        free_time: all_time, "s", "located event" => ran(all, 2)?.t, within free_bound * all_time, in "Let go":
            TAU / w => "the axis circles L at L/I1";
    }
}

/// M R^2 and the rate are 1.
fn of_radius_one() -> Parameters {
    Parameters { mass: 1.0, radius: 1.0, rate: 1.0, ..Parameters::default() }
}

/// Needles, discs, and tilts near rest.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let of = |i1: f64, i3: f64, tilt: f64| Cylinder { i1, i3, tilt, rate: 1.0 };
    let ran = |body: Cylinder, what| Ok::<_, kit::Error>(body.turning(what, 2, 1e-14)?.0.t / TAU);
    let needle = of(1.0, 1e-9, FRAC_PI_2 - 1e-4);
    let disc = Parameters { height: 0.0, ..of_radius_one() };
    limits! { report,
        /// sin(2 theta) is greatest there, and the needle has only I1
        "needle at 45 degrees: lambda/(I1 phi'^2)": of(1.0, 0.0, 0.25 * PI).torque() => -0.5, within 1e-15;
        /// I3 = 2 I1: as large, and the other way
        "disc: lambda/(I1 phi'^2 sin cos)": by_grains(&disc)?[1] / (0.25 * sin(disc.tilt) * cos(disc.tilt)) => 1.0, within 1e-14;
        /// L is along Z
        "level: lambda/(I1 phi'^2)": of(1.0, 0.1, FRAC_PI_2).torque() => 0.0, within 1e-15;
        /// one swing in one turn
        "needle near level, motor: turns in a swing": ran(needle, LetGo::Motor)? => 1.0, within 1e-8;
        /// small swings do not change the rate
        "the same, fork left to itself": ran(needle, LetGo::Clamp)? => 1.0, within 1e-8;
        /// the needle circles its L, to which it is square, as fast
        "needle near level, all let go": ran(needle, LetGo::All)? => 1.0, within 1e-8;
        /// I3 = 2 I1: the axis of a nearly upright disc circles L twice a turn
        "disc near upright, all let go": ran(of(0.5, 1.0, 1e-3), LetGo::All)? => 0.5, within 1e-6;
    }
}

/// The torque of a clamp that yields, over that of one that does not: from the middle of the
/// first swing of a cylinder that is handed to a spring, with which `yields` is the angle (rad,
/// towards where the cylinder wants to go) of the rigid clamp's torque. And the work.
pub fn yielding(tilt: f64, yields: f64) -> Result<(f64, Work)> {
    // Angle in that unit, time in that of the spring.
    let pull = move |x: f64| sin(2.0 * (tilt + yields * x)) / sin(2.0 * tilt);
    let law = second_order(move |_, x, _| pull(x) - x);
    let (far, work) = Dop853::new(1e-14)?.zero(&law, [0.0, 0.0], 1, 1e3, |y| y[1])?;
    Ok((0.5 * far.state[0], work))
}

/// The card of effects: the grains with the effect in, and a clamp that is a spring.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, (s, c)) = (Cylinder::new(p)?, sincos(p.tilt));
    let torque = body.torque().abs();
    let (gravity, aside, turning) = (9.80665, 1e-4, 7.292115e-5);
    let off = p.mass * gravity * aside * s / torque;
    let earth = 2.0 * turning / p.rate.abs();
    let yields = torque / 1e3;
    // Towards level if it is long; the torque changes by this part on the way.
    let way = if body.long() { yields } else { -yields };
    let part = way * (c - s) * (c + s) / (s * c);
    let weak = (1e-12..0.1).contains(&yields) && part < 0.5;
    let gives = when(weak, || yielding(p.tilt, way))?;
    let told = |(_, work): (f64, Work)| format!("closed form, {} derivatives", work.derivatives);
    let cost = gives.map_or("-".into(), told);
    let first = if weak { part / (1.0 - part) } else { part };
    let [_, alone] = by_grains(p)?;
    let moved = grains(p).map(|grain| grain + BodyVector::new(0.0, 0.0, aside));
    let [_, hung] = held(p, moved, gravity)?;
    let [_, faster] = by_grains(&Parameters { rate: p.rate.abs() + turning, ..p.clone() })?;
    // What stands off the hinge weighs, and is flung out.
    let stands = off + p.mass * aside * aside / (body.i1 - body.i3).abs();
    let rounding = 1e-13 * p.rate * p.rate * body.i1.max(body.i3) / torque;
    effect_card! { report,
        "centre of mass 0.1 mm off the hinge": "M g e sin theta/lambda" = off, costs stands, "of lambda",
            measured (hung / alone - 1.0).abs(), within rounding;
        "a clamp that yields 1 mrad to a newton metre": "lambda/c" = yields, costs first.abs(), "of lambda, to first order",
            measured gives.map(|(over, _)| (over - 1.0).abs()), within 4.0 * yields * yields, at_cost cost;
        "turning of the Earth, at a pole": "2 Omega_E/phi'" = earth, costs earth, "of lambda, to first order",
            measured faster / alone - 1.0, within rounding;
    }
}

/// The accuracy strip: a swing of the cylinder in a fork that is left to itself.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, what) = (Cylinder::new(p)?, LetGo::Clamp);
    let time = body.swung(what)?[1];
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-15]
        .into_iter()
        .filter(move |asked| *asked <= 0.1 * body.slowness());
    report.in_closed_form(move |_| body.coasting());
    report.dial_of_return(asked, move |step| body.turning(what, 2, step), time, p.tilt)
}

example! {
    ch16_2_precessing_cylinder: "Section 16.2 (1): a cylinder made to precess, and let go";
    "A cylinder made to precess", "A cylinder is turned about the vertical at a constant tilt; then it is let go.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
