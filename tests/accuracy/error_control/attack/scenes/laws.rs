//! What engineers have in hand: tables, sampled controllers, laws that saturate, have a dead band, or
//! switch. The truth is of steps of their own: extrapolated midpoints on the body's axes, cut at tables
//! and samples, and at switches by halving the step.

use super::{Case, Dice};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{
    BoxedEffect, EffectList, GravityAtLever, GravityGradient, PrescribedTorque, Profile, Switched,
    Torque, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::sin;
use rotation_dynamics::scene::Scene;
use std::sync::Arc;

/// As many kinds.
pub const KINDS: u64 = 6;

/// Of time, body and state.
type Function<T> = Arc<dyn Fn(f64, &RigidBody, &State) -> T + Send + Sync>;

/// A torque on the body's axes, and how it goes on in pieces.
#[derive(Clone)]
pub struct Control {
    pub rule: Rule,
    pub law: Function<BodyVector>,
    /// Whether the law is said to be smooth.
    pub is_declared: bool,
}

#[derive(Clone)]
pub enum Rule {
    Table(BodyVector, Profile, Vec<f64>),
    Sampled(f64),
    Saturated(f64),
    DeadBand(f64),
    /// Below zero of the signal the law, else this torque.
    Switched(Function<f64>, BodyVector),
}

/// A control as an effect.
fn effect<const SMOOTH: bool>(
    control: &Control,
    law: Torque<'static, SMOOTH>,
) -> Result<BoxedEffect> {
    Ok(match control.rule.clone() {
        Rule::Table(torque, profile, _) => Box::new(PrescribedTorque::on_body(torque, profile)?),
        Rule::Sampled(dt) => Box::new(law.sampled(dt)?),
        Rule::Saturated(limit) => Box::new(law.saturated(limit)?),
        Rule::DeadBand(band) => Box::new(law.dead_band(band)?),
        Rule::Switched(signal, torque) if SMOOTH => {
            let above = Torque::on_body("above", move |_, _, _| torque).smooth();
            let below = control.law.clone();
            let below = Torque::on_body("law", move |t, b, s| below(t, b, s)).smooth();
            Box::new(Switched::new("switch", move |t, b, s| signal(t, b, s), below, above))
        }
        Rule::Switched(signal, torque) => {
            let above = Torque::on_body("above", move |_, _, _| torque);
            let below = control.law.clone();
            let below = Torque::on_body("law", move |t, b, s| below(t, b, s));
            Box::new(Switched::new("switch", move |t, b, s| signal(t, b, s), below, above))
        }
    })
}

impl Control {
    pub fn effect(&self) -> Result<BoxedEffect> {
        let law = self.law.clone();
        let law = Torque::on_body("law", move |t, b, s| law(t, b, s));
        if self.is_declared { effect(self, law.smooth()) } else { effect(self, law) }
    }

    /// What is held from here on: a sample, or sides.
    fn held(&self, t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        let law = || (self.law)(t, body, state).to_array();
        match &self.rule {
            Rule::Table(..) => [0.0; 3],
            Rule::Sampled(_) => law(),
            Rule::Saturated(limit) | Rule::DeadBand(limit) => law().map(|u| {
                if u > *limit {
                    1.0
                } else if u < -limit {
                    -1.0
                } else {
                    0.0
                }
            }),
            Rule::Switched(signal, _) => {
                [if signal(t, body, state) < 0.0 { -1.0 } else { 1.0 }, 0.0, 0.0]
            }
        }
    }

    fn torque(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> BodyVector {
        let law = || (self.law)(t, body, state);
        let each = |of: fn(f64, f64) -> f64| {
            let u = law().to_array();
            BodyVector::from_array([0, 1, 2].map(|n| of(held[n], u[n])))
        };
        match &self.rule {
            Rule::Table(torque, profile, _) => *torque * profile.at(t),
            Rule::Sampled(_) => BodyVector::from_array(held),
            Rule::Saturated(limit) => {
                let free = each(|side, u| if side == 0.0 { u } else { 0.0 });
                free + BodyVector::from_array(held) * *limit
            }
            Rule::DeadBand(band) => {
                let free = each(|side, u| if side == 0.0 { 0.0 } else { u });
                free - BodyVector::from_array(held) * *band
            }
            Rule::Switched(_, above) if held[0] > 0.0 => *above,
            Rule::Switched(..) => law(),
        }
    }

    /// What is held, with what is no longer so.
    fn now(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        match self.rule {
            Rule::Table(..) | Rule::Sampled(_) => held,
            _ => self.held(t, body, state),
        }
    }
}

/// What becomes of a motion.
#[derive(Clone, Copy, PartialEq)]
enum End {
    At(Attitude),
    /// It comes to a surface on which it slides.
    Slides,
    /// It switches more often than is worth waiting for, or steps are too long for it.
    Unknown,
}

/// The end of a motion, by more and more steps until it does not change by more than the first number
/// here (rad).
fn truth(
    body: &RigidBody,
    others: &EffectList,
    controls: &[Control],
    start: &State,
    t_end: f64,
) -> End {
    const SAME: f64 = 1e-13;
    let by = |steps| end(body, others, controls, start, t_end, steps);
    let mut steps = (16.0 * t_end).ceil() as usize;
    let (mut before, mut apart) = (by(steps), f64::INFINITY);
    while steps < MOST_STEPS {
        steps *= 2;
        let now = by(steps);
        if let (End::At(was), End::At(is)) = (before, now) {
            let nearer = is.angle_to(&was);
            // Where they come no nearer they differ by rounding.
            if nearer < SAME || nearer < 1e-10 && nearer > 0.1 * apart {
                return now;
            }
            apart = nearer;
        } else if before == now && now == End::Slides {
            return now;
        }
        before = now;
    }
    End::Unknown
}

const MOST_STEPS: usize = 20_000;

const MOST_SWITCHES: usize = 500;

/// So many switches in a row, after less than this part of the span each, are those of a motion that
/// slides.
const SLIDES: (usize, f64) = (8, 1e-7);

/// The end of a motion by so many steps at least.
fn end(
    body: &RigidBody,
    others: &EffectList,
    controls: &[Control],
    start: &State,
    t_end: f64,
    steps: usize,
) -> End {
    let mut cuts: Vec<f64> = (0..=steps).map(|n| t_end * n as f64 / steps as f64).collect();
    for control in controls {
        match &control.rule {
            Rule::Table(_, _, times) => cuts.extend(times),
            Rule::Sampled(dt) => {
                cuts.extend((1..).map(|k| f64::from(k) * dt).take_while(|t| *t < t_end));
            }
            _ => {}
        }
    }
    cuts.retain(|t| (0.0..t_end).contains(t));
    cuts.push(t_end);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-13 * t_end);
    let l = body.angular_momentum(start).to_array();
    let [w, x, y, z] = start.attitude.quaternion();
    let mut now = [w, x, y, z, l[0], l[1], l[2]];
    let mut held: Vec<_> = controls.iter().map(|c| c.held(0.0, body, &state(&now))).collect();
    let (mut switches, mut at_once) = (0, 0);
    for cut in cuts.windows(2) {
        for (control, held) in controls.iter().zip(&mut held) {
            let is_sample = match control.rule {
                Rule::Sampled(dt) => {
                    (cut[0] / dt - (cut[0] / dt).round()).abs() * dt < 1e-12 * t_end
                }
                _ => false,
            };
            if is_sample {
                *held = control.held(cut[0], body, &state(&now));
            }
        }
        let inside = 1e-14 * t_end;
        let mut t = cut[0];
        while t < cut[1] {
            let slope = |at: f64, y: &[f64; 7]| {
                let at = at.max(cut[0] + inside).min(cut[1] - inside);
                slope(body, others, controls, &held, at, y)
            };
            let sides = |at: f64, y: &[f64; 7]| -> Vec<[f64; 3]> {
                let at = at.max(cut[0] + inside).min(cut[1] - inside);
                let all = controls.iter().zip(&held);
                all.map(|(c, held)| c.now(*held, at, body, &state(y))).collect()
            };
            let h = cut[1] - t;
            let to = |part: f64| extrapolated(&slope, t, &now, h * part);
            let look = |k: u32| f64::from(k) / 4.0;
            let changed = (1..=4).find(|k| sides(t + h * look(*k), &to(look(*k))) != held);
            let Some(k) = changed else {
                now = to(1.0);
                break;
            };
            let (mut low, mut high) = (look(k - 1), look(k));
            for _ in 0..55 {
                let middle = 0.5 * (low + high);
                let is_beyond = sides(t + h * middle, &to(middle)) != held;
                *(if is_beyond { &mut high } else { &mut low }) = middle;
            }
            if !to(high).iter().all(|y| y.is_finite()) {
                return End::Unknown;
            }
            switches += 1;
            at_once = if h * high < SLIDES.1 * t_end { at_once + 1 } else { 0 };
            if at_once > SLIDES.0 {
                return End::Slides;
            }
            if switches > MOST_SWITCHES {
                return End::Unknown;
            }
            let (next, beyond) = (to(high), sides(t + h * high, &to(high)));
            (t, now, held) = (t + h * high, next, beyond);
        }
    }
    if now.iter().all(|y| y.is_finite()) { End::At(state(&now).attitude) } else { End::Unknown }
}

fn state([w, x, y, z, a, b, c]: &[f64; 7]) -> State {
    // Steps that are too long for the motion blow up: shorter ones follow.
    let attitude = Attitude::from_quaternion([*w, *x, *y, *z]).unwrap_or(Attitude::IDENTITY);
    State { attitude, angular_momentum: attitude.to_space(BodyVector::new(*a, *b, *c)) }
}

/// Euler's equations.
fn slope(
    body: &RigidBody,
    others: &EffectList,
    controls: &[Control],
    held: &[[f64; 3]],
    t: f64,
    y: &[f64; 7],
) -> [f64; 7] {
    let state = state(y);
    let mut torque = state.attitude.to_body(others.torque(t, body, &state));
    for (control, held) in controls.iter().zip(held) {
        torque += control.torque(*held, t, body, &state);
    }
    let [w, x, yy, z, a, b, c] = *y;
    let [i1, i2, i3] = body.moments().to_array();
    let [p, q, r] = [a / i1, b / i2, c / i3];
    let [m1, m2, m3] = torque.to_array();
    [
        0.5 * (-x * p - yy * q - z * r),
        0.5 * (w * p + yy * r - z * q),
        0.5 * (w * q + z * p - x * r),
        0.5 * (w * r + x * q - yy * p),
        m1 + b * r - c * q,
        m2 + c * p - a * r,
        m3 + a * q - b * p,
    ]
}

/// A step by the midpoint rule in 2, 4, ..., 14 parts, extrapolated to none (W. B. Gragg, SIAM J.
/// Numer. Anal. 2, 384, 1965): order 14.
fn extrapolated(
    slope: &impl Fn(f64, &[f64; 7]) -> [f64; 7],
    t: f64,
    start: &[f64; 7],
    h: f64,
) -> [f64; 7] {
    let add = |y: &[f64; 7], by: f64, slope: &[f64; 7]| -> [f64; 7] {
        core::array::from_fn(|i| y[i] + by * slope[i])
    };
    let mut table: Vec<[f64; 7]> = Vec::new();
    for j in 1..=7_usize {
        let parts = 2 * j;
        let dt = h / parts as f64;
        // What is added to the start: its rounding is small.
        let mut before = [0.0; 7];
        let mut now: [f64; 7] = slope(t, start).map(|k| dt * k);
        for n in 1..parts {
            let y = add(start, 1.0, &now);
            let next = add(&before, 2.0 * dt, &slope(t + n as f64 * dt, &y));
            (before, now) = (now, next);
        }
        let mut row = vec![now];
        for k in 1..j {
            let ratio = (j as f64 / (j - k) as f64).powi(2) - 1.0;
            let finer = row[k - 1];
            let coarser = table[k - 1];
            row.push(core::array::from_fn(|i| finer[i] + (finer[i] - coarser[i]) / ratio));
        }
        table = row;
    }
    add(start, 1.0, &table[6])
}

/// The n-th scene; the kinds come in turn, and every third has a second control of another kind.
pub fn case(n: u64) -> Result<Case> {
    stronger(n, 1.0)
}

/// The same with controls so many times as strong as those whose end is known: another motion.
pub fn stronger(n: u64, times: f64) -> Result<Case> {
    let mut dice = Dice(n + 5_000_000);
    dice.part();
    loop {
        if let Some(case) = thrown(n, times, &mut dice)? {
            return Ok(case);
        }
    }
}

/// A scene, if its end is known; of one that slides the end is none's.
fn thrown(n: u64, times: f64, dice: &mut Dice) -> Result<Option<Case>> {
    let body = RigidBody::new(dice.moments()?);
    let rates = dice.vector() * dice.scale(0.1, 2.0);
    let start = body.state(Attitude::from_euler(dice.attitude())?, rates)?;
    let t_end = dice.scale(2.0, 20.0);
    let kind = n % KINDS;
    let mut controls = vec![control(kind, &body, dice, t_end)?];
    if n % 3 == 2 {
        let other = (dice.part() * KINDS as f64) as u64;
        controls.push(control(other, &body, dice, t_end)?);
    }
    let background = Background::thrown(dice);
    let others = background.list(&[])?;
    let (kind, exact) = match truth(&body, &others, &controls, &start, t_end) {
        End::Unknown => return Ok(None),
        End::Slides => ("it slides", Attitude::IDENTITY),
        End::At(end) => (NAMES[kind as usize], end),
    };
    for control in &mut controls {
        let law = control.law.clone();
        control.law = Arc::new(move |t, b, s| law(t, b, s) * times);
        if let Rule::Table(torque, ..) | Rule::Switched(_, torque) = &mut control.rule {
            *torque = *torque * times;
        }
    }
    let text = format!("{:?} {rates:?} {t_end} {background:?}", body.moments());
    Ok(Some(Case {
        kind,
        text,
        exact,
        solve: Box::new(move |tolerance| {
            let scene = Scene::new(body).with_list(background.list(&controls)?);
            scene.solve(&start, t_end, tolerance)
        }),
    }))
}

const NAMES: [&str; KINDS as usize] =
    ["a table", "sampled", "saturated", "dead band", "at an angle", "at a rate"];

/// What acts besides.
#[derive(Debug, Clone, Copy)]
pub struct Background {
    gravity: f64,
    orbit: f64,
    friction: f64,
}

impl Background {
    fn thrown(dice: &mut Dice) -> Self {
        let mut some = |low: f64, high: f64| {
            let is_there = dice.part() < 0.5;
            let size = dice.scale(low, high);
            if is_there { size } else { 0.0 }
        };
        Self { gravity: some(0.01, 1.0), orbit: some(0.01, 1.0), friction: some(0.001, 0.3) }
    }

    fn list(&self, controls: &[Control]) -> Result<EffectList> {
        let mut all: Vec<BoxedEffect> = Vec::new();
        if self.gravity > 0.0 {
            all.push(Box::new(GravityAtLever::new(self.gravity, 1.0)?));
        }
        if self.orbit > 0.0 {
            let [normal, towards] =
                [SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0)];
            all.push(Box::new(GravityGradient::on_orbit(self.orbit, normal, towards)?));
        }
        if self.friction > 0.0 {
            all.push(Box::new(ViscousFriction::isotropic(self.friction)?));
        }
        for control in controls {
            all.push(control.effect()?);
        }
        EffectList::new(all)
    }
}

/// A control of this kind, about as strong as turns the body in a second or some.
fn control(kind: u64, body: &RigidBody, dice: &mut Dice, t_end: f64) -> Result<Control> {
    let [i1, i2, i3] = body.moments().to_array();
    let inertia = i1.max(i2).max(i3);
    let rate = dice.scale(0.3, 2.0);
    let stiff = inertia * rate * rate;
    let damped = dice.between(0.2, 1.2) * inertia * rate;
    // Every fifth law does not say that it is smooth.
    let is_declared = dice.part() < 0.8;
    let goal = dice.between(-1.0, 1.0);
    let law: Function<BodyVector> = Arc::new(move |t, body: &RigidBody, state: &State| {
        let [w, x, y, z] = state.attitude.quaternion();
        let off = BodyVector::new(2.0 * w * x, 2.0 * w * y, 2.0 * w * z - goal * sin(0.7 * t));
        off * -stiff - body.angular_velocity(state) * damped
    });
    let limit = stiff * dice.scale(0.05, 1.0);
    let rule = match kind {
        0 => {
            let count = 3 + (dice.part() * 12.0) as usize;
            let mut times: Vec<f64> = (0..count).map(|_| t_end * dice.between(-0.1, 1.1)).collect();
            times.sort_by(f64::total_cmp);
            let rows: Vec<_> = times.iter().map(|t| (*t, dice.between(-1.0, 1.0))).collect();
            let profile = match (dice.part() * 3.0) as u32 {
                0 => Profile::steps(&rows)?,
                1 => Profile::lines(&rows)?,
                _ => Profile::cubic(&rows)?,
            };
            Rule::Table(dice.vector() * limit, profile, times)
        }
        1 => Rule::Sampled(dice.scale(0.02, 0.5) / rate),
        2 => Rule::Saturated(limit),
        3 => Rule::DeadBand(limit),
        4 => {
            let at = dice.between(-0.8, 0.8);
            let above = dice.vector() * limit;
            Rule::Switched(Arc::new(move |_, _, s: &State| s.attitude.axis().z() - at), above)
        }
        _ => {
            let axis = (dice.part() * 3.0) as usize;
            let at = dice.between(-1.0, 1.0);
            let above = dice.vector() * limit;
            let signal = move |_: f64, body: &RigidBody, state: &State| {
                body.angular_velocity(state).to_array()[axis] - at
            };
            Rule::Switched(Arc::new(signal), above)
        }
    };
    let steady = dice.vector() * limit;
    let law = match kind {
        4 | 5 if dice.part() < 0.5 => Arc::new(move |_: f64, _: &RigidBody, _: &State| steady),
        _ => law,
    };
    Ok(Control { rule, law, is_declared })
}
