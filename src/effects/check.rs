//! The claims of an effect, held against its torque.

mod kinks;
#[cfg(test)]
mod tests;

pub(crate) use kinks::NEAR;

use super::erased::AnyEffect;
use super::gravity::GRAVITY;
use super::{Feature, Holding, IntegrableCase, Properties};
use crate::attitude::Attitude;
use crate::body::{RigidBody, State};
use crate::error::{Error, FINITE, Result, finite, not_negative, positive};
use crate::frame::SpaceVector;
use crate::math::{EPS, sort_by_number};

/// Places at which an effect is looked at, and times beside those near its break points.
const PLACES: usize = 48;

/// Torques that should be equal may differ by this part of the largest: rounding.
const ROUNDING: f64 = 64.0 * EPS;

/// The angle (rad) over which a potential is differentiated: the remainder of the difference is of
/// its square, and the rounding error is eps U divided by it.
const STEP: f64 = 1e-6;

/// A power may be off by this part of torque times rate: the remainder of the difference,
/// for features down to a thousandth of a radian.
const POWER: f64 = 1e-5;

/// A feature that nothing names is seen if it comes no more often than this in the span.
pub(crate) const UNNAMED: f64 = 4096.0;

/// The scale of the torque may be so many times too small, and so many too large.
const SCALE_BELOW: f64 = 1e3;
const SCALE_ABOVE: f64 = 1e6;

/// Looks along a line on which a jump is searched.
const GRID: usize = 128;

/// A difference that has come down to this part of the allowed remainder belongs to no jump.
const SETTLED: f64 = 1.0 / 16.0;

/// A step of the torque from one look to the next that is so many times its neighbour's may
/// be a jump.
const ALONE: f64 = 8.0;

/// A break point holds for so many units in its last place to either side: an effect that forms the
/// same time in another way may jump beside it.
const FEW: f64 = 4.0;

const SMOOTH: &str = "that it is smooth between its break points";
const SMOOTH_BESIDE: &str = "that it is smooth between its break points (of which one is beside this \
                             time: form both in the same way, k dt with floor(t/dt))";

/// Nearer to a break point than this part of the latest time a jump is the one that was meant.
const BESIDE: f64 = 1e-9;

/// A pulse comes in so many looks, and is as high as this part of the longest torque.
const SHORT: [usize; 6] = [1, 2, 4, 8, 16, 32];
const PULSE: f64 = 0.1;

/// Holds all claims of `effect` against its torque: its variables and the quantities it leaves
/// alone, its form on lanes, its potential and power, its scale, its break points, its closed form.
///
/// The torque is asked for at 48 attitudes and momenta, of the size that `state` has, or that the
/// torque builds up in the body's own time. The times fill `span` (s) and lie on both sides of
/// every break point. A claim that is false only elsewhere is not found;
/// [`Scene::solve`](crate::scene::Scene::solve) looks again along the motion.
///
/// # Errors
/// [`Error::Contradiction`] with the name of the effect, the claim, and by how much the
/// torque differs from it, also if the torque of one time and state is not always the same;
/// [`Error::Incompatible`] for two gravities; [`Error::FunctionOutOfRange`] for a torque that is
/// not finite, or whose power is not; a scale, a break point or a width that is not finite, or negative.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::effects::{Effect, Properties, check};
/// use rotation_dynamics::frame::{BodyVector, SpaceVector};
/// use rotation_dynamics::inertia::PrincipalMoments;
///
/// /// It brakes, and claims to keep the energy.
/// struct Liar;
/// impl Effect for Liar {
///     const PROPERTIES: Properties = Properties {
///         conserved: rotation_dynamics::effects::Conserved { energy: true, ..Properties::ANYTHING.conserved },
///         ..Properties::ANYTHING
///     };
///     fn name(&self) -> &'static str {
///         "liar"
///     }
///     fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
///         state.angular_momentum * -0.1
///     }
/// }
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
/// let error = check(&Liar, &body, [0.0, 1.0], &start).unwrap_err();
/// assert!(error.to_string().contains("\"liar\" says that it keeps the energy"));
/// # Ok(())
/// # }
/// ```
pub fn check(
    effect: &dyn AnyEffect,
    body: &RigidBody,
    span: [f64; 2],
    state: &State,
) -> Result<()> {
    Checked::new(effect, body, span, state).map(|_| ())
}

/// An effect that has been looked at, and can be looked at again along its motion.
pub(crate) struct Checked<'e> {
    /// With what its laws hold at the start.
    effect: Holding<'e>,
    properties: Properties,
    body: RigidBody,
    start: State,
    /// The longest torque that was seen (N m).
    largest: f64,
    /// The largest size that its rounding was a part of (N m).
    size: f64,
    span: [f64; 2],
    /// The break points that the effect names, rising.
    breaks: Vec<f64>,
    /// The torque at the start, before any other was asked for (N m).
    first: SpaceVector,
}

impl<'e> Checked<'e> {
    pub(crate) fn new(
        effect: &'e dyn AnyEffect,
        body: &RigidBody,
        span: [f64; 2],
        state: &State,
    ) -> Result<Self> {
        let names = effect.names();
        if names.iter().filter(|name| **name == GRAVITY).count() > 1 {
            return Err(Error::two_gravities(names.join(", ")));
        }
        effect.holds_from(span[0], body, state, &effect.about_axis())?;
        let mut checked = Self::unlooked(effect, body, span, state);
        checked.effect.hold(span[0], body, state)?;
        checked.first = checked.function(span[0], state)?;
        checked.declared()?;
        if checked.properties.torque_free && names.is_empty() {
            return Ok(checked);
        }
        let places = checked.places(state)?;
        for (t, state) in &places {
            let torque = checked.finite_torque(*t, state)?;
            checked.largest = checked.largest.max(torque.norm());
            let size = checked.effect.torque_size(*t, body, state);
            checked.size = checked.size.max(size);
        }
        checked.scale(&places)?;
        checked.at(span[0], state)?;
        // The first place is the start itself.
        for (t, state) in &places[1..] {
            checked.at(*t, state).map_err(Error::probed)?;
        }
        checked.smooth().map_err(Error::probed)?;
        Ok(checked)
    }

    /// An effect that has been looked at before.
    pub(crate) fn unlooked(
        effect: &'e dyn AnyEffect,
        body: &RigidBody,
        span: [f64; 2],
        state: &State,
    ) -> Self {
        let mut breaks = effect.break_points();
        sort_by_number(&mut breaks, |t| *t);
        Self {
            effect: Holding::new(effect),
            properties: effect.properties(),
            body: *body,
            start: *state,
            largest: 0.0,
            size: 0.0,
            span,
            breaks,
            first: SpaceVector::zero(),
        }
    }

    /// The effect, with what its laws hold at the start.
    pub(crate) const fn holding(&self) -> &Holding<'e> {
        &self.effect
    }

    /// The length of the torque at the start (N m).
    pub(crate) fn at_start(&self) -> f64 {
        (self.effect).torque(self.span[0], &self.body, &self.start).norm()
    }

    /// Where the effect is looked at: the state itself, and others that fill what there
    /// is of attitudes, momenta and times.
    fn places(&self, state: &State) -> Result<Vec<(f64, State)>> {
        let [from, to] = self.span;
        let mut times: Vec<f64> =
            (0..PLACES).map(|n| from + (to - from) * part(n, 0.414_213_562_373_095_1)).collect();
        times[0] = from;
        times.extend(self.breaks.iter().flat_map(|t| sides(*t)));
        let torque = self.effect.torque(from, &self.body, state).norm();
        let built_up = (largest_moment(&self.body) * torque).sqrt();
        let size = state.angular_momentum.norm().max(built_up);
        let mut places = vec![(from, *state)];
        for (n, &t) in times.iter().enumerate() {
            let [w, x, y, z, a, b, c] = [
                0.618_033_988_749_894_9,
                0.732_050_807_568_877_2,
                0.236_067_977_499_789_7,
                0.645_751_311_064_590_6,
                0.316_624_790_355_399_8,
                0.605_551_275_463_989_3,
                0.123_105_625_617_660_5,
            ]
            .map(|irrational| 2.0 * part(n + 1, irrational) - 1.0);
            let attitude = Attitude::from_quaternion([w, x, y, z])?;
            let momentum = SpaceVector::new(a, b, c) * size;
            places.push((t, State::new(attitude, momentum)?));
        }
        Ok(places)
    }

    fn finite_torque(&self, t: f64, state: &State) -> Result<SpaceVector> {
        let torque = self.effect.torque(t, &self.body, state);
        if torque.to_array().iter().all(|m| m.is_finite()) {
            return Ok(torque);
        }
        Err(self.refused(t, state, torque, FINITE))
    }

    fn refused(
        &self,
        t: f64,
        state: &State,
        torque: SpaceVector,
        allowed: impl Into<std::borrow::Cow<'static, str>>,
    ) -> Error {
        let state = [&state.attitude.quaternion()[..], &state.angular_momentum.to_array()];
        Error::of_function(
            format!("torque of \"{}\"", self.name()),
            t,
            ("quaternion and momentum", state.concat()),
            &torque.to_array(),
            allowed,
        )
    }

    /// The torque, if it is the same again after it was asked for elsewhere: a function of time and
    /// state remembers nothing.
    fn function(&self, t: f64, state: &State) -> Result<SpaceVector> {
        let torque = self.finite_torque(t, state)?;
        let [from, to] = self.span;
        let elsewhere = State {
            attitude: state.attitude * Attitude::about_coordinate(0, 1.2),
            angular_momentum: state.angular_momentum * -0.6,
        };
        let mirrored = (from + (to - t)).max(from.min(to)).min(from.max(to));
        for t in [mirrored, t] {
            self.effect.torque(t, &self.body, &elsewhere);
        }
        self.again(t, state, torque)?;
        Ok(torque)
    }

    /// The torque is this one, as it was before.
    fn again(&self, t: f64, state: &State, before: SpaceVector) -> Result<()> {
        let torque = self.effect.torque(t, &self.body, state);
        let claim = "that its torque is a function of time and state, which remembers nothing \
                     (for a law that is called at a rate and held in between there is Torque::sampled)";
        match torque == before {
            true => Ok(()),
            false => Err(self.contradicted(claim, t, (torque - before).norm(), 0.0)),
        }
    }

    /// The torque at the start is what it was before all runs; at these places it is the same against
    /// the order of the motion as along it.
    pub(crate) fn remembers_nothing(&self, places: &[(f64, State)]) -> Result<()> {
        self.again(self.span[0], &self.start, self.first)?;
        let torque = |(t, state): &(f64, State)| self.effect.torque(*t, &self.body, state);
        let before: Vec<_> = places.iter().map(torque).collect();
        let mut back = places.iter().zip(before).rev();
        back.try_for_each(|((t, state), before)| self.again(*t, state, before))
    }

    fn name(&self) -> String {
        self.effect.names().join(" and ")
    }

    /// The error that this claim is off by so much more than is allowed.
    fn held(&self, claim: &'static str, t: f64, off: f64, allowed: f64) -> Result<()> {
        // Below the least normal number products have lost their digits.
        if off <= allowed.max(f64::MIN_POSITIVE) {
            return Ok(());
        }
        Err(self.contradicted(claim, t, off, allowed))
    }

    fn contradicted(&self, claim: &'static str, t: f64, off: f64, allowed: f64) -> Error {
        Error::Contradiction { effect: self.name(), claim, t, probe: false, off, allowed }
    }

    /// The scale of the torque against its length, both at the same time and in the same state.
    /// So what states no scale, whose length then is its scale, counts on both sides, and nothing
    /// is claimed of it.
    fn scale(&self, places: &[(f64, State)]) -> Result<()> {
        let (effect, body) = (&self.effect, &self.body);
        let below = "that its torque is not a thousand times longer than torque_scale";
        for (t, state) in places {
            let length = effect.torque(*t, body, state).norm();
            let scale = effect.torque_scale(*t, body, state);
            self.held(below, *t, length, SCALE_BELOW * scale)?;
        }
        let t = self.span[0];
        let scale = effect.torque_scale(t, body, &self.start);
        let named = !self.breaks.is_empty()
            || (self.effect.narrowest()).is_some_and(|width| width != Feature::WIDE);
        if named {
            // It may be short, and none of the places lie in it.
            return Ok(());
        }
        let above = "that its torque comes within a millionth of torque_scale";
        self.held(above, t, scale, SCALE_ABOVE * self.size)
    }

    /// The causes that change L on the body's axes, beside their turning by I^-1 L: the torque, and
    /// L x slip.
    fn acting(&self, t: f64, state: &State) -> SpaceVector {
        let torque = self.effect.torque(t, &self.body, state);
        if !self.properties.slips {
            return torque;
        }
        let slip = self.effect.slip(t, &self.body, state);
        torque + state.angular_momentum.cross(&slip)
    }

    /// A torque that is called smooth has no jump: not in time between its break points,
    /// not while the body is turned about its axes or slows down and turns back.
    fn smooth(&self) -> Result<()> {
        let start = &self.start;
        if !self.properties.smooth {
            return self.smooth_beside();
        }
        let [from, to] = self.span;
        if self.properties.on_time {
            let (first, last) = (from.min(to), from.max(to));
            let inside = |t: &f64| first < *t && *t < last;
            let breaks = self.breaks.iter().copied().filter(inside);
            let ends: Vec<f64> = [first].into_iter().chain(breaks).chain([last]).collect();
            for ends in ends.windows(2) {
                let ends = piece([ends[0], ends[1]]);
                self.no_jump(ends, |t| self.acting(t, start), |t| (self.smooth_claim(t), t))?;
            }
        }
        // What sees the axis only has been held to that: a turn about it changes nothing.
        let axes = if self.properties.axis_only { 2 } else { 3 };
        let at_start = |_| (SMOOTH, from);
        for axis in 0..axes {
            let turned = |angle| {
                let attitude = start.attitude * Attitude::about_coordinate(axis, angle);
                self.acting(from, &State { attitude, ..*start })
            };
            self.no_jump([0.0, core::f64::consts::TAU], turned, at_start)?;
        }
        if self.properties.on_rates {
            let slowed = |part| {
                let angular_momentum = start.angular_momentum * part;
                let state = State { angular_momentum, ..*start };
                self.acting(from, &state)
            };
            self.no_jump([1.0, -1.1], slowed, at_start)?;
        }
        Ok(())
    }

    /// An effect beside a known resistance has none either.
    fn smooth_beside(&self) -> Result<()> {
        let (effect, body, start) = (&self.effect, &self.body, &self.start);
        if effect.resistance(self.span[0], body).is_none() {
            return Ok(());
        }
        for axis in 0..2 {
            let turned = |angle| {
                let turned = start.attitude * Attitude::about_coordinate(axis, angle);
                SpaceVector::from_array(effect.torque_on_axis(body, turned.axis().to_array()))
            };
            self.no_jump([0.0, core::f64::consts::TAU], turned, |_| (SMOOTH, self.span[0]))?;
        }
        Ok(())
    }

    /// Between two neighbours that differ most, the torque is halved down: a difference that is
    /// left over an interval that doubles hardly resolve is a jump. `told`: the claim that it
    /// contradicts, and the time.
    fn no_jump(
        &self,
        [from, to]: [f64; 2],
        torque: impl Fn(f64) -> SpaceVector,
        told: impl Fn(f64) -> (&'static str, f64),
    ) -> Result<()> {
        let at = |n: usize| match n {
            // Beyond it by a rounding there may be a jump.
            GRID => to,
            n => from + (to - from) * (n as f64 / GRID as f64),
        };
        let (mut a, mut b) = (from, from);
        let (mut low, mut high) = (torque(from), torque(from));
        let (mut before, mut first) = (low, -1.0);
        for n in 1..=GRID {
            let after = torque(at(n));
            let step = (after - before).norm();
            if step.total_cmp(&first).is_ge() {
                ((a, b), (low, high), first) = ((at(n - 1), at(n)), (before, after), step);
            }
            before = after;
        }
        let mut size = self.size;
        if self.properties.slips {
            let rate = self.body.angular_velocity(&self.start).norm();
            size = size.max(self.start.angular_momentum.norm() * rate);
        }
        // A smooth torque comes 2^40 times nearer; rounding leaves a little, and so does that of a
        // late time, which is no nearer to another than its last digit.
        let last_digits = 4.0 * EPS * from.abs().max(to.abs()) / (at(1) - at(0)).abs();
        let allowed = (last_digits.max(1e-3) * first).max(ROUNDING * size);
        let mut left = first;
        for _ in 0..40 {
            if left < SETTLED * allowed {
                break;
            }
            let middle = 0.5 * (a + b);
            let m = torque(middle);
            let (below, above) = ((m - low).norm(), (high - m).norm());
            (a, b, low, high, left) = if below > above {
                (a, middle, low, m, below)
            } else {
                (middle, b, m, high, above)
            };
        }
        let (claim, t) = told(a);
        self.held(claim, t, left, allowed)
    }

    /// The claim that a jump at this time contradicts.
    fn smooth_claim(&self, t: f64) -> &'static str {
        let [from, to] = self.span;
        let near = BESIDE * from.abs().max(to.abs());
        let after = self.breaks.partition_point(|point| *point <= t);
        let neighbours = &self.breaks[after.saturating_sub(1)..];
        if neighbours.iter().take(2).any(|point| (point - t).abs() < near) {
            SMOOTH_BESIDE
        } else {
            SMOOTH
        }
    }

    /// The torque on the body as it starts at so many times, of equal distances, and the end.
    pub(crate) fn looked(&self, looks: usize) -> Vec<SpaceVector> {
        let at = |n| self.torque_at_start(self.look(n, looks));
        (0..=looks).map(at).collect()
    }

    fn look(&self, n: usize, looks: usize) -> f64 {
        let [from, to] = self.span;
        if n == looks {
            return to;
        }
        from + (to - from) * (n as f64 / looks as f64)
    }

    fn torque_at_start(&self, t: f64) -> SpaceVector {
        self.effect.torque(t, &self.body, &self.start)
    }

    /// The times at which the torque that was [looked at](Self::looked) jumps, each the
    /// first, in the order of the motion, with what it jumps to.
    pub(crate) fn jumps(&self, seen: &[SpaceVector]) -> Vec<f64> {
        let looks = seen.len() - 1;
        let step = |n: usize| (seen[n + 1] - seen[n]).norm();
        let size = seen.iter().map(SpaceVector::norm).fold(0.0, f64::max);
        // Beside its neighbours: the looks of what is smooth differ by much the same.
        let alone = |n: &usize| {
            let before = n.checked_sub(1).map_or(0.0, step);
            let after = if n + 1 < looks { step(n + 1) } else { 0.0 };
            step(*n) > (ALONE * before.min(after)).max(ROUNDING * size)
        };
        (0..looks).filter(alone).filter_map(|n| self.jump(n, seen)).collect()
    }

    /// Halves the time between two looks, towards the larger difference, until nothing is
    /// between: if most of the difference is left, it is a jump.
    fn jump(&self, n: usize, seen: &[SpaceVector]) -> Option<f64> {
        let looks = seen.len() - 1;
        let (mut a, mut b) = (self.look(n, looks), self.look(n + 1, looks));
        let (mut low, mut high) = (seen[n], seen[n + 1]);
        let first = (high - low).norm();
        loop {
            let middle = 0.5 * (a + b);
            if middle == a || middle == b {
                break;
            }
            let m = self.torque_at_start(middle);
            if (m - low).norm() > (high - m).norm() {
                (b, high) = (middle, m);
            } else {
                (a, low) = (middle, m);
            }
        }
        ((high - low).norm() > 0.5 * first).then_some(b)
    }

    /// How many looks a step may pass over, of the torque that was [looked at](Self::looked).
    /// `None` if nothing comes and goes in less than 64.
    ///
    /// Let a change come and be gone again in s looks each at the least. Where such changes are few,
    /// a step passes 2 s. Where the torque goes to and fro all along, no run takes long steps in
    /// quiet and meets a pulse in one of them: 8 s, about as many s as a step has stages.
    pub(crate) fn looks_in_step(&self, seen: &[SpaceVector]) -> Option<usize> {
        let largest = seen.iter().map(SpaceVector::norm).fold(self.largest, f64::max);
        let far = |a: SpaceVector, b: SpaceVector| (a - b).norm() > PULSE * largest;
        let changes = |s: usize| {
            (s..seen.len().saturating_sub(s))
                .filter(move |&n| far(seen[n], seen[n - s]) && far(seen[n], seen[n + s]))
        };
        let s = SHORT.into_iter().find(|&s| changes(s).next().is_some())?;
        let all_along = 2 * changes(4 * s).count() >= seen.len();
        Some(if all_along { 8 * s } else { 2 * s })
    }

    /// Every claim, here and now.
    pub(crate) fn at(&self, t: f64, state: &State) -> Result<()> {
        let (effect, body, properties) = (&self.effect, &self.body, self.properties);
        let torque = self.function(t, state)?;
        let slack = ROUNDING * self.size.max(torque.norm());
        let off = |other: SpaceVector| (other - torque).norm();
        if properties.torque_free {
            self.held("that there is no torque", t, torque.norm(), 0.0)?;
        }
        let pushed = State {
            angular_momentum: state.angular_momentum * -0.6
                + SpaceVector::new(0.3, -0.2, 0.1) * state.angular_momentum.norm(),
            ..*state
        };
        let [from, to] = self.span;
        let later = t + 0.381_966 * (to - from);
        self.slip(t, state, later, &pushed)?;
        let rates = "that it does not depend on how the body turns";
        let time = "that it does not depend on the time";
        if !properties.on_rates {
            self.held(rates, t, off(effect.torque(t, body, &pushed)), slack)?;
        }
        if !properties.on_time {
            self.held(time, t, off(effect.torque(later, body, state)), slack)?;
        }
        let axis = state.attitude.axis();
        if properties.axis_only {
            let attitude = state.attitude * Attitude::about_coordinate(2, 1.2);
            let spun = State { attitude, ..pushed };
            let sees = "that it sees the body's axis only";
            self.held(sees, t, off(effect.torque(later, body, &spun)), slack)?;
            self.held(sees, t, torque.dot(&axis).abs(), slack)?;
            let on_lanes = effect.torque_on_axis(body, axis.to_array());
            let lanes = "that its torque on lanes is its torque";
            self.held(lanes, t, off(SpaceVector::from_array(on_lanes)), slack)?;
        }
        let about = [
            "that it has no torque about X",
            "that it has no torque about Y",
            "that it has no torque about Z",
        ];
        for ((kept, m), claim) in
            properties.conserved.momentum.into_iter().zip(torque.to_array()).zip(about)
        {
            if kept {
                self.held(claim, t, m.abs(), slack)?;
            }
        }
        if properties.conserved.axial_momentum {
            let claim = "that it has no torque about the body's axis";
            self.held(claim, t, torque.dot(&axis).abs(), slack)?;
        }
        self.resistance(t, state, torque, slack)?;
        self.known(t, state, torque, slack)?;
        self.power(t, state, torque)
    }

    /// The beginning of the piece between two break points that `t` belongs to, as a run from
    /// the one end of the span to the other meets it; none at a break point.
    fn begun(&self, t: f64) -> Option<f64> {
        let [from, to] = self.span;
        let after = self.breaks.partition_point(|point| *point <= t);
        let before = after.checked_sub(1).map(|n| self.breaks[n]);
        let after = self.breaks.get(after).copied();
        let is_at = |point: f64| {
            let [before, after] = sides(point);
            before < t && t < after
        };
        if [before, after].into_iter().flatten().any(is_at) {
            return None;
        }
        let [before_from, after_from] = sides(from);
        Some(if from <= to {
            before.map_or(after_from, |point| sides(point)[1].max(after_from))
        } else {
            after.map_or(before_from, |point| sides(point)[0].min(before_from))
        })
    }

    /// The resistance on the piece, with the effects that see the axis only, is all of the torque.
    fn resistance(&self, t: f64, state: &State, torque: SpaceVector, slack: f64) -> Result<()> {
        let (effect, body) = (&self.effect, &self.body);
        let begun = if self.properties.on_time { self.begun(t) } else { Some(t) };
        let resistance = begun.and_then(|begun| effect.resistance(begun, body));
        let Some(resists) = resistance.and_then(|r| r.torque(body.angular_momentum(state))) else {
            return Ok(());
        };
        let on_axis = effect.torque_on_axis(body, state.attitude.axis().to_array());
        let claimed = SpaceVector::from_array(on_axis) + state.attitude.to_space(resists);
        let claim = "what of its torque resists the rotation";
        self.held(claim, t, (torque - claimed).norm(), slack)
    }

    /// An effect that turns the body beyond I^-1 L says so, and does what it claims.
    fn slip(&self, t: f64, state: &State, later: f64, pushed: &State) -> Result<()> {
        let (effect, body, properties) = (&self.effect, &self.body, self.properties);
        let slip = effect.slip(t, body, state);
        if !properties.slips {
            let claim = "that nothing but its torque acts (slips: false)";
            return self.held(claim, t, slip.norm(), 0.0);
        }
        let claim = "that it slips and that only a torque on the axis acts, or none";
        let both = properties.axis_only || properties.torque_free;
        self.held(claim, t, f64::from(u8::from(both)), 0.0)?;
        let slack = ROUNDING * slip.norm();
        let off = |other: SpaceVector| (other - slip).norm();
        if !properties.on_rates {
            let claim = "that its slip does not depend on how the body turns";
            self.held(claim, t, off(effect.slip(t, body, pushed)), slack)?;
        }
        if !properties.on_time {
            let claim = "that its slip does not depend on the time";
            self.held(claim, t, off(effect.slip(later, body, state)), slack)?;
        }
        if properties.conserved.axial_momentum && body.moments().is_symmetric() {
            let claim = "that its slip leaves L_z alone";
            let rate = state.angular_momentum.cross(&slip);
            let slack = slack * state.angular_momentum.norm();
            self.held(claim, t, rate.dot(&state.attitude.axis()).abs(), slack)?;
        }
        Ok(())
    }

    /// The closed form's torque is the effect's.
    fn known(&self, t: f64, state: &State, torque: SpaceVector, slack: f64) -> Result<()> {
        let claimed = match self.effect.integrable_case() {
            IntegrableCase::None => return Ok(()),
            IntegrableCase::Free => SpaceVector::zero(),
            IntegrableCase::HeavyTop(gravity) => AnyEffect::torque(&gravity, t, &self.body, state),
        };
        let claim = "that its motion has a closed form";
        self.held(claim, t, (torque - claimed).norm(), slack)
    }

    /// Torque . omega, with (L x slip) . omega, changes the kinetic energy: with the change
    /// of the potential as the body turns by omega, and as time goes on, it must give the power.
    ///
    /// The turn and the time are differentiated apart. Late, a time is known to its last digit
    /// only, and the step in time must be long against that.
    fn power(&self, t: f64, state: &State, torque: SpaceVector) -> Result<()> {
        let (effect, body) = (&self.effect, &self.body);
        let omega = state.attitude.to_space(body.angular_velocity(state));
        let rate = omega.norm();
        // At rest, or as good as that: no turn by a step is long enough.
        if STEP / rate == f64::INFINITY {
            return Ok(());
        }
        if !(torque.norm() * rate).is_finite() {
            let allowed = format!(
                "on a body that may turn at {rate:.3e} rad/s its power must be finite, at most \
                 1.8e308 W"
            );
            return Err(self.refused(t, state, torque, allowed));
        }
        let acting = self.acting(t, state);
        let size = self.size.max(torque.norm()).max(acting.norm());
        let potential = |t: f64, attitude: Attitude| {
            effect.potential_energy(t, body, &State { attitude, ..*state })
        };
        // What rounding leaves is a part of the terms of a potential, which are as large as torques.
        let difference = |[before, after]: [f64; 2], step: f64| {
            let terms = before.abs().max(after.abs()).max(size);
            ((after - before) / (2.0 * step), 4.0 * EPS * terms / step)
        };
        let turn = Attitude::from_rotation_vector(omega * (STEP / rate))?;
        let turned = [turn.inverse(), turn].map(|turn| potential(t, turn * state.attitude));
        let (turning, turning_rounding) = difference(turned, STEP / rate);

        // The body may be nearly at rest while the effect goes on: an attracting body, round
        // a satellite that does not turn.
        let named = (effect.narrowest()).map_or(0.0, |width| 1.0 / width.time);
        let span = (self.span[1] - self.span[0]).abs();
        let seen = UNNAMED / span;
        let seen = if seen.is_finite() { seen } else { 0.0 };
        let (own, pace) = if named > 0.0 { (named, named) } else { (rate, rate.max(seen)) };
        let step = step_in_time(t, (STEP / pace).max(ROUNDING * t.abs()));
        let moved = [t - step, t + step].map(|t| potential(t, state.attitude));
        let (moving, moving_rounding) = difference(moved, step);
        // The effect rounds what it makes of the time, as a phase.
        let late = 4.0 * EPS * t.abs() / step * moving.abs();

        let found = acting.dot(&omega) + turning + moving;
        let power =
            if self.properties.conserved.energy { 0.0 } else { effect.power(t, body, state) };
        let off = (found - power).abs();
        // The phases of torque and power are rounded too, by less than goes on in a step.
        let (part, fastest) = if self.properties.on_time {
            (POWER.max(step * own), rate.max(own))
        } else {
            (POWER, rate)
        };
        let allowed = part * size * fastest + turning_rounding + moving_rounding + late;
        let claim = if self.properties.conserved.energy {
            "that it keeps the energy"
        } else {
            "at what power it changes the energy"
        };
        self.held(claim, t, off, allowed)
    }

    /// Numbers that an effect declares must be numbers.
    fn declared(&self) -> Result<()> {
        let scale = (self.effect).torque_scale(self.span[0], &self.body, &self.start);
        not_negative("torque_scale", scale)?;
        for t in &self.breaks {
            finite("break point", *t)?;
        }
        let Some(width) = self.effect.narrowest() else {
            return Ok(());
        };
        for (name, value) in [("narrowest time", width.time), ("narrowest angle", width.angle)] {
            if value != f64::INFINITY {
                positive(name, value)?;
            }
        }
        Ok(())
    }
}

/// The last time that is surely before a break point, and the first that is after it.
fn sides(point: f64) -> [f64; 2] {
    let few = FEW * f64::EPSILON * point.abs();
    [(point - few).next_down(), (point + few).next_up()]
}

/// The first time and the last that surely are between these two, at which the torque may jump; their
/// middle if they are too near.
pub(crate) fn piece([from, to]: [f64; 2]) -> [f64; 2] {
    let (first, last) = (sides(from.min(to))[1], sides(from.max(to))[0]);
    if first <= last { [first, last] } else { [0.5 * from + 0.5 * to; 2] }
}

/// True if two times are one break point.
pub(crate) fn is_same(one: f64, other: f64) -> bool {
    (one - other).abs() <= FEW * f64::EPSILON * one.abs()
}

/// About this step (s), such that `t` with it and without it are doubles.
fn step_in_time(t: f64, step: f64) -> f64 {
    (t.abs() + step) - t.abs()
}

fn largest_moment(body: &RigidBody) -> f64 {
    let [i1, i2, i3] = body.moments().to_array();
    i1.max(i2).max(i3)
}

/// The n-th of a sequence that fills 0 to 1 evenly.
fn part(n: usize, irrational: f64) -> f64 {
    let x = n as f64 * irrational;
    x - x.floor()
}
