//! The ways to state a motion: by energy, by angles and rates, by a body.

use super::hyperbolic::Late;
use super::motion::{Motion, Rates};
use super::reduced::too_far_apart;
use super::roots::{Conserved, Origin, Roots, State};
use super::sample::Sampler;
use super::{Course, Form, Given, HeavyTop, ReducedTop, Start, SymmetricTop, Turns};
use crate::attitude::{Attitude, EulerAngles};
use crate::body::Kinematics;
use crate::error::{Error, Result, finite, plain};
use crate::frame::BodyVector;
use crate::math::{self, DoubleDouble as Dd};

/// The problem in u = cos(theta), before the sign of gravity is taken out.
struct Problem {
    /// B = L_z/I1, A - B, A + B.
    spin: Dd,
    difference: Dd,
    sum: Dd,
    omega3: Dd,
    free_spin: Dd,
    /// 2 m g l/I1, with its sign.
    gravity: Dd,
    start: Beginning,
    phi0: f64,
    zeta0: f64,
    moments: [f64; 2],
    reduced: Option<ReducedTop>,
    body: Option<SymmetricTop>,
    given: Given,
}

enum Beginning {
    /// At rest in theta, with this value of alpha - beta.
    Turning { excess: Dd, start: Start },
    /// At an angle, with nodal rates x = theta' and y = phi' sin(theta).
    Angle { theta: f64, half_sin: Dd, half_cos: Dd, nodal: [Dd; 2] },
}

impl HeavyTop {
    /// The motion of energy `energy` = E~ that is at rest in theta at the turning point
    /// `start` when t' = 0.
    ///
    /// An E~ below U_min by no more than rounding is taken as U_min: steady precession.
    /// With b = 1 the axis passes the pole if E~ > 0; started at `ThetaMin` it then is
    /// at the pole, arriving with the given phi0 and zeta0 (for c < 0: leaving).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if E~ is below U_min; `NotFinite`; phi0 or zeta0 beyond 1e15 rad.
    pub fn from_energy(
        top: ReducedTop,
        energy: f64,
        start: Start,
        phi0: f64,
        zeta0: f64,
    ) -> Result<Self> {
        finite("energy", energy)?;
        if !top.is_well_above_minimum(energy) {
            let (_, minimum, size) = top.minimum_dd();
            if energy < (minimum - ReducedTop::energy_slack(size)).to_f64() {
                return Err(below(energy, minimum.to_f64()));
            }
        }
        let excess = Dd::from(energy).scaled(2.0);
        let given = Given::Energy { top, energy, start };
        let start = Beginning::Turning { excess, start };
        Self::reduced_problem(top, start, phi0, zeta0, given)
    }

    /// The motion with these initial angles (rad) and this theta' (per t').
    ///
    /// A start at exactly theta = 0 needs b = 1; theta' then is the rate at which the
    /// axis leaves the pole, along the node line of `phi0` and `zeta0`.
    ///
    /// # Errors
    /// An input that is not finite; theta0 outside [0, pi], or 0 while b is not 1; phi0 or
    /// zeta0 beyond 1e15 rad.
    pub fn from_angles(
        top: ReducedTop,
        theta0: f64,
        theta_rate0: f64,
        phi0: f64,
        zeta0: f64,
    ) -> Result<Self> {
        finite("theta_rate0", theta_rate0)?;
        let (half_sin, half_cos) = half_angle(theta0)?;
        let root_a = Dd::from(top.a()).sqrt();
        let nodal_y = if theta0 == 0.0 {
            if top.b() != 1.0 {
                return Err(Error::out_of_range(
                    "theta0",
                    theta0,
                    "an axis starts at theta = 0 only if b = 1",
                ));
            }
            Dd::ZERO
        } else {
            // (b - cos)/sin in half angles.
            let below = Dd::sum(top.b(), 1.0) * half_sin / half_cos;
            let above = Dd::sum(top.b(), -1.0) * half_cos / half_sin;
            root_a * (below + above).scaled(0.5)
        };
        let start = Beginning::Angle {
            theta: theta0,
            half_sin,
            half_cos,
            nodal: [Dd::from(theta_rate0), nodal_y],
        };
        let given = Given::Angles { top, theta0, theta_rate0 };
        Self::reduced_problem(top, start, phi0, zeta0, given)
    }

    fn reduced_problem(
        top: ReducedTop,
        start: Beginning,
        phi0: f64,
        zeta0: f64,
        given: Given,
    ) -> Result<Self> {
        let root_a = Dd::from(top.a()).sqrt();
        Self::solve(Problem {
            spin: root_a,
            difference: root_a * Dd::sum(top.b(), -1.0),
            sum: root_a * Dd::sum(top.b(), 1.0),
            omega3: root_a.recip(),
            free_spin: Dd::sum(1.0, -top.a()) / root_a,
            gravity: Dd::from(2.0 * top.c()),
            start,
            phi0: known_turn("phi0", phi0)?,
            zeta0: known_turn("zeta0", zeta0)?,
            moments: [1.0, top.a()],
            reduced: Some(top),
            body: None,
            given,
        })
    }

    /// The motion of a body with this attitude and angular velocity (on the body axes,
    /// rad/s) at t = 0 s.
    ///
    /// # Errors
    /// An input that is not finite; theta outside [0, pi]; phi or zeta beyond 1e15 rad.
    pub fn from_body(
        body: SymmetricTop,
        attitude: EulerAngles,
        omega_body: BodyVector,
    ) -> Result<Self> {
        let EulerAngles { phi, theta, zeta } = attitude;
        known_turn("phi", phi)?;
        known_turn("zeta", zeta)?;
        let (half_sin, half_cos) = half_angle(theta)?;
        let half = HalfAngle { theta, sin: half_sin, cos: half_cos };
        Self::of_body(body, &half, [phi, zeta], omega_body)
    }

    /// The motion of a body with this attitude and angular velocity (on the body axes,
    /// rad/s) at t = 0 s; as [`FreeBody::new`](crate::exact::free_body::FreeBody::new)
    /// takes them.
    ///
    /// An attitude next to a pole keeps its distance from it, which theta as a double has
    /// next to 0 and not next to pi: a body with its axis exactly down is exactly down.
    ///
    /// # Errors
    /// A rate that is not finite; [`Error::OutOfRange`] of the fastest.
    pub fn new(body: SymmetricTop, attitude: Attitude, omega_body: BodyVector) -> Result<Self> {
        let EulerAngles { phi, theta, zeta } = attitude.euler_angles();
        let [w, x, y, z] = attitude.quaternion();
        let length = |a: f64, b: f64| {
            // Scaled, because the square of a tiny component is no double.
            let up = if a.abs().max(b.abs()) < 1e-100 { UP } else { 1.0 };
            let square = Dd::product(a * up, a * up) + Dd::product(b * up, b * up);
            square.sqrt().scaled(1.0 / up)
        };
        let (sin, cos) = (length(x, y), length(w, z));
        let norm = (sin.square() + cos.square()).sqrt();
        let half = HalfAngle { theta, sin: sin / norm, cos: cos / norm };
        Self::of_body(body, &half, [phi, zeta], omega_body)
    }

    fn of_body(
        body: SymmetricTop,
        half: &HalfAngle,
        [phi, zeta]: [f64; 2],
        omega_body: BodyVector,
    ) -> Result<Self> {
        let HalfAngle { theta, sin: half_sin, cos: half_cos } = *half;
        for value in omega_body.to_array() {
            finite("omega_body", value)?;
        }
        let i1 = Dd::from(body.i1());
        let omega3 = omega_body.z();
        let spin = Dd::product(body.i3(), omega3) / i1;
        let (sin, cos) = Dd::from(zeta).sin_cos();
        let (x, y) = (omega_body.x(), omega_body.y());
        let nodal = [cos * x - sin * y, sin * x + cos * y];
        // A - B = -B (1 - cos) + omega_y sin, A + B = B (1 + cos) + omega_y sin.
        let across = nodal[1] * (half_sin * half_cos).scaled(2.0);
        let upright = half_sin == 0.0;
        let moving = x != 0.0 || y != 0.0;
        let (start, phi0, zeta0);
        if (upright || half_cos == 0.0) && moving {
            // The node line is where the axis leaves the pole: towards growing theta from
            // theta = 0, towards falling theta from pi.
            let out = if upright { 1.0 } else { -1.0 };
            let node = Dd::from(-out * y).atan2(Dd::from(out * x));
            let speed = (Dd::product(x, x) + Dd::product(y, y)).sqrt();
            if speed.hi() == 0.0 {
                // It moves, by less than the squares of doubles hold.
                let fastest = x.abs().max(y.abs());
                return Err(too_far_apart(fastest));
            }
            start = Beginning::Angle { theta, half_sin, half_cos, nodal: [speed * out, Dd::ZERO] };
            // phi + zeta has a meaning at theta = 0, phi - zeta at pi.
            phi0 = (Dd::sum(phi, out * zeta) - node * out).to_f64();
            zeta0 = node.to_f64();
        } else {
            start = Beginning::Angle { theta, half_sin, half_cos, nodal };
            (phi0, zeta0) = (phi, zeta);
        }
        Self::solve(Problem {
            spin,
            difference: across - (spin * half_sin.square()).scaled(2.0),
            sum: across + (spin * half_cos.square()).scaled(2.0),
            omega3: Dd::from(omega3),
            free_spin: Dd::sum(body.i1(), -body.i3()) * omega3 / i1,
            gravity: body.moment().scaled(2.0) / i1,
            start,
            phi0,
            zeta0,
            moments: [body.i1(), body.i3()],
            reduced: None,
            body: Some(body),
            given: Given::Body { body, omega_body },
        })
    }

    fn solve(problem: Problem) -> Result<Self> {
        let Problem { spin, difference, sum, gravity, .. } = problem;
        let flipped = gravity < 0.0;
        let flip = if flipped { -1.0 } else { 1.0 };
        let strength = gravity.abs();

        // alpha - beta in u, and alpha - beta and alpha + beta in v.
        let (excess, less, total, origin, theta0);
        match problem.start {
            Beginning::Turning { excess: given, start } => {
                let upper = (start == Start::ThetaMin) != flipped;
                origin = if upper { Origin::Upper } else { Origin::Lower };
                theta0 = None;
                excess = given;
                // Exchanged by the flip.
                let other = excess + gravity.scaled(2.0);
                (less, total) = if flipped { (other, excess) } else { (excess, other) };
            }
            Beginning::Angle { theta, half_sin, half_cos, nodal } => {
                let below = half_sin.square().scaled(2.0);
                let above = half_cos.square().scaled(2.0);
                let sin = (half_sin * half_cos).scaled(2.0);
                let cos = half_cos.square() - half_sin.square();
                let transverse = nodal[0].square() + nodal[1].square();
                // F'(v) = -2 v omega_t^2 - beta sin^2 + 2 B omega_y sin, odd in the flip
                // but for the middle term.
                let slope = ((spin * nodal[1] * sin - cos * transverse).scaled(2.0)) * flip
                    - strength * sin.square();
                let state = State {
                    to_one: if flipped { above } else { below },
                    from_minus_one: if flipped { below } else { above },
                    rate: -(sin * nodal[0]) * flip,
                    slope,
                };
                excess = transverse - gravity * below;
                // Each from the pole it refers to: near that one a sum would cancel.
                less = transverse - state.to_one * strength;
                total = transverse + state.from_minus_one * strength;
                origin = Origin::State(state);
                let vertical = half_sin == 0.0 || half_cos == 0.0;
                let at_rest = nodal == [Dd::ZERO; 2];
                theta0 = Some((theta, at_rest, vertical));
            }
        }
        let conserved = if flipped {
            Conserved {
                spin: -spin,
                difference: sum,
                sum: difference,
                excess: less,
                total,
                gravity: strength,
            }
        } else {
            Conserved { spin, difference, sum, excess: less, total, gravity: strength }
        };
        let at_upper_pole = if flipped { core::f64::consts::PI } else { 0.0 };
        let at_lower_pole = core::f64::consts::PI - at_upper_pole;
        let fixed = match theta0 {
            // Exactly upright or hanging without a transverse rate: it stays so for ever.
            Some((theta, at_rest, vertical))
                if at_rest && (vertical || (gravity == 0.0 && spin == 0.0)) =>
            {
                Some(theta)
            }
            _ => None,
        };
        // Squares of the rates are formed, in pairs of doubles.
        let far_apart = || too_far_apart((strength + spin.square() + excess.abs()).to_f64().sqrt());
        let course = if let Some(theta) = fixed {
            Course::Fixed { theta }
        } else {
            if conserved.largest_square() > MOST {
                return Err(far_apart());
            }
            let roots = Roots::new(&conserved, &origin);
            let homoclinic = roots.x2 == 0.0 && roots.outer == 0.0;
            let at_pole = roots.x1 <= 0.0 || roots.y2 <= 0.0;
            if at_pole && matches!(origin, Origin::State(_)) {
                // It moves, by less than the squares of doubles hold.
                return Err(far_apart());
            }
            if roots.x1 <= 0.0 || (homoclinic && matches!(origin, Origin::Upper)) {
                Course::Fixed { theta: at_upper_pole }
            } else if roots.y2 <= 0.0 {
                Course::Fixed { theta: at_lower_pole }
            } else {
                Self::moving(&problem, flip, Motion::new(&conserved, &origin, roots))
            }
        };
        let latest = match &course {
            Course::Fixed { .. } => math::latest(problem.omega3.to_f64()),
            // Beyond 1e290 a product of pairs leaves the range of doubles.
            Course::Moving { form, .. } => form.latest().min(1e290),
        };
        let motion = Self {
            phi0: problem.phi0,
            zeta0: problem.zeta0,
            flip,
            spin,
            difference,
            sum,
            omega3: problem.omega3,
            free_spin: problem.free_spin,
            excess,
            moments: problem.moments,
            reduced: problem.reduced,
            body: problem.body,
            given: problem.given,
            course,
            latest,
        };
        let start = motion.kinematics(0.0);
        if motion.is_representable(start) && motion.starts_as_given(&start, strength) {
            Ok(motion)
        } else {
            Err(far_apart())
        }
    }

    /// True if the motion has at t = 0 the rates that it was made from: it has lost them where
    /// their powers leave the range of doubles. `gravity` is the square of its rate.
    fn starts_as_given(&self, start: &Kinematics, gravity: Dd) -> bool {
        const LOST: f64 = 1e-8;
        let Given::Body { omega_body, .. } = &self.given else {
            return true;
        };
        let swing = gravity.to_f64().sqrt();
        let fastest = omega_body.to_array().map(f64::abs).into_iter().fold(swing, f64::max);
        let off = (start.angular_velocity - *omega_body).to_array();
        off.into_iter().all(|off| off.abs() <= LOST * fastest)
    }

    /// True if the set-up stayed within the range of double-double arithmetic, with this at
    /// t = 0.
    fn is_representable(&self, start: Kinematics) -> bool {
        let Course::Moving { motion, turns, .. } = &self.course else {
            return self.omega3.is_finite();
        };
        let period = motion.half_period.hi();
        let start = self.with_momentum(start);
        let regular = start.attitude.quaternion().iter().all(|c| c.is_finite())
            && start.angular_momentum.is_finite()
            && motion.rate.is_finite()
            && [motion.roots.x1, motion.roots.x2, motion.roots.y1, motion.roots.y2]
                .iter()
                .all(|c| c.is_finite());
        let phases = turns
            .iter()
            .all(|turn| [turn.rate, turn.lag, turn.start].iter().all(|c| c.is_finite()));
        let periodic = period > 0.0 && (period.is_finite() || motion.m1 == 0.0);
        // Nearer to the separatrix, squares of the series leave the range.
        let apart = motion.m1 == 0.0 || motion.m1 > 1e-200;
        regular && phases && periodic && apart
    }

    fn moving(problem: &Problem, flip: f64, motion: Box<Motion>) -> Course {
        // alpha turns with (phi + zeta)/2, beta with (phi - zeta)/2; the free spin goes
        // to zeta. In v the two are exchanged for a flipped top.
        let turns = [1.0, -1.0].map(|sense| {
            let first = (sense > 0.0) == (flip > 0.0);
            let channel = &motion.channels[usize::from(!first)];
            let start = Dd::sum(problem.phi0, problem.zeta0 * sense).scaled(0.5);
            let phase = start - channel.initial - Dd::PI * channel.initial_half_turns;
            let rate = channel.rate + problem.free_spin.scaled(0.5) * sense;
            Turns { rate: rate.turns(), lag: channel.step.turns(), start: phase.turns() }
        });
        let spin = problem.omega3.to_f64();
        let form = match &motion.rates {
            Rates::Trigonometric(wave) => {
                Form::Trigonometric(Box::new(Sampler::new(&motion, wave, &turns, flip, spin)))
            }
            Rates::Hyperbolic(ripple) => {
                Form::Hyperbolic(Box::new(Late::new(&motion, ripple, &turns, flip, spin)))
            }
        };
        Course::Moving { motion, turns, form }
    }
}

/// An angle theta in [0, pi], and sine and cosine of theta/2 to more digits.
struct HalfAngle {
    theta: f64,
    sin: Dd,
    cos: Dd,
}

pub(super) const UP: f64 = 2.037_035_976_334_486e90; // 2^300

/// The largest square of a rate whose products with the others are looked into. Not far above, some
/// are infinite and others are not, and the result may look like a motion.
const MOST: f64 = 1e299;

/// An angle of no more turns than leave its last bit a meaning: at 1e15 rad that is 1/8 rad.
fn known_turn(name: &'static str, angle: f64) -> Result<f64> {
    if finite(name, angle)?.abs() <= 1e15 {
        Ok(angle)
    } else {
        Err(Error::out_of_range(name, angle, "its size must not exceed 1e15 rad"))
    }
}

/// Sine and cosine of theta/2 for theta in [0, pi].
fn half_angle(theta: f64) -> Result<(Dd, Dd)> {
    finite("theta", theta)?;
    if !(0.0..=core::f64::consts::PI).contains(&theta) {
        return Err(Error::out_of_range("theta", theta, "theta lies in [0, pi]"));
    }
    Ok(Dd::from(theta * 0.5).sin_cos())
}

/// The refusal of an energy; the minimum with six places, or all of them if six do not show the
/// difference.
fn below(energy: f64, minimum: f64) -> Error {
    let short = format!("{minimum:.6}");
    let off = short.parse::<f64>().map_or(f64::NAN, |m| (m - minimum).abs());
    let said = match off < 0.1 * (minimum - energy) && short.len() < 16 {
        true => short,
        false => plain(minimum),
    };
    Error::out_of_range("E~", energy, format!("no motion is below U_min = {said}"))
}
