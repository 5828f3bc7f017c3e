//! The problem to be solved, as given and with every input a little changed.

use super::exact_motion::ExactMotion;
use super::slender::Slender;
use crate::accuracy::{Stepper, Variables, larger};
use crate::body::{RigidBody, State};
use crate::effects::erased::{AnyEffect, AxisOnly};
use crate::effects::{
    Checked, Conserved, Effect, GravityAtLever, IntegrableCase, Properties, Resistance, each,
    one_by_one, piece,
};
use crate::error::{Error, Result};
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::integrators::gauss_legendre::SideBySide;
use crate::integrators::{BodyFixed, Integrator, Resisted, Work};
use crate::math::{EPS, Lane, hypot};
use crate::scene::Scene;

/// The effects that act, as far as they matter to how the problem is stepped. Each kind is compiled
/// once.
#[derive(Clone, Copy)]
pub(super) enum Acting<'e> {
    /// Nothing.
    Nothing,
    /// The weight of a body held at a point of its axis.
    Weight(GravityAtLever),
    /// Effects that see the body's axis only, and are smooth.
    OnAxis(&'e dyn AnyEffect),
    /// Any that are smooth, if only along the motion.
    Smooth(&'e dyn AnyEffect),
    /// Any.
    Anything(&'e dyn AnyEffect),
}

impl<'e> Acting<'e> {
    pub(super) fn of(effects: &'e dyn AnyEffect) -> Self {
        let properties = effects.properties();
        match effects.integrable_case() {
            IntegrableCase::Free => Self::Nothing,
            IntegrableCase::HeavyTop(gravity) => Self::Weight(gravity),
            IntegrableCase::None if properties.axis_only && properties.smooth => {
                Self::OnAxis(effects)
            }
            IntegrableCase::None if properties.smooth => Self::Smooth(effects),
            IntegrableCase::None => Self::Anything(effects),
        }
    }
}

/// A scene, its start and the end asked for.
#[derive(Clone, Copy)]
pub(super) struct Problem<'e> {
    pub body: RigidBody,
    pub acting: Acting<'e>,
    /// The factor of the torque: 1, but for a change of it.
    pub strength: f64,
    /// The scale of the torque.
    pub torque: f64,
    pub start: State,
    pub t_start: f64,
    pub t_end: f64,
    /// Where the torque jumps or has a kink on the way, or runs are cut, in the order of the motion.
    pub breaks: &'e [f64],
    /// No step may be longer.
    pub longest_step: f64,
    /// The [fastest rate](Self::fastest_damping) of what resists.
    pub damping: f64,
    pub checked: &'e Checked<'e>,
    pub known: IntegrableCase,
    /// The result of a trial run of a slender body.
    pub slender: Option<Slender>,
}

/// A scene as it is stepped on the axes of a slender body.
pub(super) type OnBodyAxes<'s> = BodyFixed<'s, ((), Strengthened<'s, false, true>)>;

/// An effect behind a pointer with its torque multiplied, between two times at which it may
/// jump.
pub(super) struct Strengthened<'e, const AXIS_ONLY: bool, const SLIPS: bool> {
    effects: &'e dyn AnyEffect,
    strength: f64,
    torque: f64,
    /// The time at which the piece begins: so steps much shorter than that are not rounded
    /// with it.
    origin: f64,
    /// The first time and the last that belong to this piece.
    piece: [f64; 2],
}

impl<const AXIS_ONLY: bool, const SLIPS: bool> Strengthened<'_, AXIS_ONLY, SLIPS> {
    /// The time that is this long after the beginning of the piece.
    #[inline(always)]
    fn time(&self, t: f64) -> f64 {
        (self.origin + t).max(self.piece[0]).min(self.piece[1])
    }
}

impl<const AXIS_ONLY: bool, const SLIPS: bool> Effect for Strengthened<'_, AXIS_ONLY, SLIPS> {
    const PROPERTIES: Properties = Properties {
        axis_only: AXIS_ONLY,
        on_rates: !AXIS_ONLY,
        on_time: !AXIS_ONLY,
        smooth: true,
        slips: SLIPS,
        weight: false,
        torque_free: false,
        conserved: Conserved::NONE,
    };

    fn name(&self) -> &'static str {
        "effects"
    }

    /// On this piece: at a jump, what it is on this side.
    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.effects.torque(self.time(t), body, state) * self.strength
    }

    /// Of effects that resist as well: what is left.
    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        if AXIS_ONLY {
            return one_by_one(self, body, axis);
        }
        each(axis, |axis| {
            let torque = self.effects.torque_on_axis(body, axis);
            torque.map(|m| m * self.strength)
        })
    }

    /// On this piece.
    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        let known = self.effects.resistance(self.time(t), body)?;
        Some(known.times(self.strength))
    }

    #[inline]
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.effects.slip(self.time(t), body, state) * self.strength
    }

    #[inline]
    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.torque * self.strength
    }
}

/// Inputs that are changed: three of the attitude, three of the momentum, the strength
/// of the torque and three moments of inertia.
const INPUTS: usize = 10;

/// Signs with which the inputs are changed, run by run: the twelve rows of a design in which every
/// two columns are orthogonal. So the mean square of the changes that the rows make is the sum of
/// squares over the inputs, each changed alone. The mean over some of the rows is an estimate of
/// it.
///
/// R. L. Plackett, J. P. Burman, Biometrika 33, 305 (1946); for the estimate M. F.
/// Hutchinson, Commun. Stat. Simul. Comput. 19, 433 (1990).
pub(super) fn signs(row: usize) -> [f64; INPUTS] {
    const FIRST: [f64; 11] = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0];
    core::array::from_fn(|column| match row % ALL_ROWS {
        11 => -1.0,
        row => FIRST[(column + 11 - row) % 11],
    })
}

/// All rows: the sum of squares itself.
pub(super) const ALL_ROWS: usize = 12;

/// How the condition is measured.
pub(super) struct Probe {
    /// Relative changes that are tried, one after the other, until the end moves by
    /// little: a change that grows beyond that is no measure of a slope.
    pub changes: &'static [f64],
    /// An end moved by more than this (rad) has left the linear regime.
    pub linear: f64,
    /// Within it, the slope is measured again with a change as small as this.
    pub again: Option<f64>,
}

impl Probe {
    /// For closed forms, whose rounding is all that blurs a small change.
    pub(super) const EXACT: Self =
        Self { changes: &[1e-9, 1e-12, 8.0 * EPS], linear: 1e-4, again: None };
    /// The same near a separatrix.
    pub(super) const STEEP: Self = Self { again: Some(16.0 * EPS), ..Self::EXACT };
    /// For stepping.
    pub(super) const STEPPED: Self =
        Self { changes: &[1e-6, 1e-9, 1e-12, 64.0 * EPS], linear: 3e-3, again: None };

    fn smallest(&self) -> f64 {
        self.changes.last().copied().unwrap_or(0.0)
    }
}

/// The distances of two states: the angle between the attitudes (rad), and the differences of
/// momentum and of rates, each as a part of its scale.
pub(super) type Distances = [f64; 3];

impl<'e> Problem<'e> {
    /// A run between two times without a jump; its work is added to `work`.
    pub(super) fn carried(
        &self,
        stepper: &Stepper,
        variables: Variables,
        [from, to]: [f64; 2],
        start: &State,
        work: &mut Work,
    ) -> Result<State> {
        let span = [0.0, to - from];
        match (self.acting, stepper, variables) {
            (Acting::Nothing, _, Variables::Body) => {
                stepper.advance_free(&self.body, span, start, work)
            }
            (Acting::Nothing, Stepper::Dop853(m), _) => {
                let scene = self.scene::<false, false>(&(), [from, to]);
                m.advance_counting(&scene, 0.0, start, to - from, work)
            }
            (Acting::Weight(gravity), Stepper::Dop853(m), Variables::Space) => {
                let scene = self.scene::<false, false>(&gravity, [from, to]);
                m.advance_counting(&scene, 0.0, start, to - from, work)
            }
            (Acting::Weight(gravity), ..) => {
                let weight = gravity.weight() * self.strength;
                let gravity = GravityAtLever::new(weight, gravity.lever())?;
                let scene = Scene::new(self.body).with(gravity);
                stepper.advance_axis(&scene, variables, span, start, work)
            }
            (
                Acting::OnAxis(effects) | Acting::Smooth(effects) | Acting::Anything(effects),
                Stepper::Dop853(m),
                Variables::Space,
            ) => {
                if effects.properties().slips {
                    let scene = self.scene::<false, true>(effects, [from, to]);
                    m.advance_counting(&scene, 0.0, start, to - from, work)
                } else {
                    let scene = self.scene::<false, false>(effects, [from, to]);
                    m.advance_counting(&scene, 0.0, start, to - from, work)
                }
            }
            (
                Acting::Smooth(effects) | Acting::Anything(effects),
                Stepper::Splitting(m),
                Variables::Space,
            ) => {
                let scene = self.scene::<false, false>(effects, [from, to]);
                let resisted = Resisted::new(&scene, 0.0)?;
                m.advance_counting(&resisted, 0.0, start, to - from, work)
            }
            (Acting::Smooth(effects), Stepper::GaussLegendre(m), Variables::Space) => {
                let scene = self.scene::<false, true>(effects, [from, to]);
                let scene: &Scene<dyn AnyEffect> = &scene;
                let scene = SideBySide::new(scene, effects.properties().slips);
                m.advance_counting(&scene, 0.0, start, to - from, work)
            }
            (Acting::OnAxis(effects), ..) => {
                let piece = self.strengthened::<true, false>(effects, [from, to]);
                let scene = Scene::new(self.body).with(AxisOnly(&piece));
                stepper.advance_axis(&scene, variables, span, start, work)
            }
            _ => Err(Error::sees_more("effects".to_owned())),
        }
    }

    /// The scene as the integrators see it, between two times without a jump; its time
    /// begins at the first of them.
    pub(super) fn scene<'s, const AXIS_ONLY: bool, const SLIPS: bool>(
        &self,
        effects: &'s dyn AnyEffect,
        span: [f64; 2],
    ) -> Scene<((), Strengthened<'s, AXIS_ONLY, SLIPS>)> {
        Scene::new(self.body).with(self.strengthened(effects, span))
    }

    /// Effects between two times without a jump. The code that steps lanes side by side sees them
    /// behind a pointer, so that it is compiled once for these and for all others.
    fn strengthened<'s, const AXIS_ONLY: bool, const SLIPS: bool>(
        &self,
        effects: &'s dyn AnyEffect,
        [from, to]: [f64; 2],
    ) -> Strengthened<'s, AXIS_ONLY, SLIPS> {
        Strengthened {
            effects,
            strength: self.strength,
            torque: self.torque,
            origin: from,
            piece: piece([from, to]),
        }
    }

    /// The state that `run` leads to between two times without a jump, by the scene on the body's
    /// axes and the components of the start; and its own components.
    pub(super) fn on_body_axes(
        &self,
        [from, to]: [f64; 2],
        (start, on_body): (&State, Option<[f64; 7]>),
        run: impl FnOnce(&OnBodyAxes, [f64; 7]) -> Result<[f64; 7]>,
    ) -> Result<(State, [f64; 7])> {
        let effects: &dyn AnyEffect = match &self.acting {
            Acting::Nothing => &(),
            Acting::Weight(gravity) => gravity,
            Acting::OnAxis(effects) | Acting::Smooth(effects) | Acting::Anything(effects) => {
                *effects
            }
        };
        let scene = self.scene::<false, true>(effects, [from, to]);
        let fixed = BodyFixed::new(&scene, self.torque, effects.properties().slips);
        let end = run(&fixed, on_body.unwrap_or_else(|| fixed.components(start)))?;
        Ok((fixed.state(&end)?, end))
    }

    /// The times that cut the motion from `t` to `t_end` where the torque jumps, with
    /// both ends.
    pub(super) fn pieces(&self, [t, t_end]: [f64; 2]) -> Vec<f64> {
        let backwards = self.t_end < self.t_start;
        let is_before = |a: f64, b: f64| if backwards { a > b } else { a < b };
        let passed = self.breaks.partition_point(|at| !is_before(t, *at));
        let ahead = &self.breaks[passed..];
        let inside = &ahead[..ahead.partition_point(|at| is_before(*at, t_end))];
        [&[t], inside, &[t_end]].concat()
    }

    /// True if something resists the rotation whose effect at a fixed attitude is known on
    /// every piece, and nothing acts beside it but what sees the axis only.
    pub(super) fn is_resisted(&self) -> bool {
        // Without symmetry l_3 passes through 0, where the other laws have a kink.
        let symmetric = self.body.moments().is_symmetric();
        self.resists(|resistance| symmetric || resistance.is_linear())
    }

    /// True if the torque is smooth all along the motion, whatever it does elsewhere. A resistance
    /// has its kink where l_3 = 0, and never brings l_3 of a symmetric body there.
    pub(super) fn stays_smooth(&self) -> bool {
        let symmetric = self.body.moments().is_symmetric();
        self.resists(|resistance| resistance.is_linear() || symmetric && !resistance.is_dry())
    }

    /// True if what resists is known on every piece, and of this kind.
    fn resists(&self, kind: impl Fn(&Resistance) -> bool) -> bool {
        let (Acting::Smooth(effects) | Acting::Anything(effects)) = self.acting else {
            return false;
        };
        let known = |piece: &[f64]| {
            let scene = self.scene::<false, false>(effects, [piece[0], piece[1]]);
            Resisted::new(&scene, 0.0).is_ok_and(|resisted| kind(resisted.resistance()))
        };
        let pieces = self.pieces([self.t_start, self.t_end]);
        !effects.properties().slips && pieces.windows(2).all(known)
    }

    /// The fastest rate (1/s) at which what resists takes momentum in proportion to it.
    pub(super) fn fastest_damping(&self) -> f64 {
        let (Acting::Smooth(effects) | Acting::Anything(effects)) = self.acting else {
            return 0.0;
        };
        let on_piece = |piece: &[f64]| {
            let scene = self.scene::<false, false>(effects, [piece[0], piece[1]]);
            Resisted::new(&scene, 0.0).map_or(0.0, |r| r.resistance().fastest())
        };
        let pieces = self.pieces([self.t_start, self.t_end]);
        pieces.windows(2).map(on_piece).fold(0.0, f64::max)
    }

    /// True if effects go on in pieces.
    pub(super) fn has_laws(&self) -> bool {
        self.checked.holding().has_laws()
    }

    /// True if a symmetric body is stepped without its spin: the torque depends on the axis only.
    pub(super) fn is_spin_free(&self) -> bool {
        let on_axis = matches!(self.acting, Acting::Weight(_) | Acting::OnAxis(_));
        on_axis && self.body.moments().is_symmetric()
    }

    /// The time from start to end (s).
    pub(super) fn span(&self) -> f64 {
        self.t_end - self.t_start
    }

    /// The closed form of this motion, if it has one.
    pub(super) fn exact_motion(&self) -> Option<ExactMotion> {
        ExactMotion::of(self.known, self.strength, &self.body, &self.start)
    }

    /// A bound on the rates (rad/s) that the body reaches: by its energy, or of a slender body as
    /// a trial run shows it.
    pub(super) fn fastest(&self) -> f64 {
        if let Some(slender) = self.slender {
            return slender.rate;
        }
        let [i1, i2, i3] = self.body.moments().to_array();
        let energy = self.body.kinetic_energy(&self.start);
        ((2.0 * energy + 4.0 * self.torque) / i1.min(i2).min(i3)).sqrt()
    }

    /// The size against which a change of the momentum counts: its length, or the momentum that the
    /// torques build up in the body's own time.
    pub(super) fn momentum_scale(&self, state: &State) -> f64 {
        let [i1, i2, i3] = self.body.moments().to_array();
        let built_up = (i1.max(i2).max(i3) * self.torque).sqrt();
        state.angular_momentum.norm().max(built_up)
    }

    /// How far two states of this motion are apart: the angle between their attitudes
    /// (rad), and the differences of momentum and rates as parts of their scales.
    pub(super) fn apart(&self, a: &State, b: &State) -> Distances {
        let ratio = |difference: f64, scale: f64| {
            if difference == 0.0 { 0.0 } else { difference / scale }
        };
        let momentum = (a.angular_momentum - b.angular_momentum).norm();
        let (rates, others) = (self.body.angular_velocity(a), self.body.angular_velocity(b));
        let [i1, i2, i3] = self.body.moments().to_array();
        let built_up = (self.torque / i1.max(i2).max(i3)).sqrt();
        [
            a.attitude.angle_to(&b.attitude),
            ratio(momentum, self.momentum_scale(a)),
            ratio((rates - others).norm(), rates.norm().max(built_up)),
        ]
    }

    /// The row of the design whose push turns the body fastest. In a single change of all inputs,
    /// the effects of the three pushes, large for a small moment of inertia, must not cancel.
    pub(super) fn most_sensitive_row(&self) -> Result<usize> {
        let mut most = (0, 0.0);
        for row in 0..ALL_ROWS {
            let [_, _, _, x, y, z, ..] = signs(row);
            let pushed = State::new(self.start.attitude, SpaceVector::new(x, y, z))?;
            let rate = self.body.angular_velocity(&pushed).norm();
            if rate > most.1 {
                most = (row, rate);
            }
        }
        Ok(most.0)
    }

    /// Every input changed by `by`, up or down.
    pub(super) fn changed(&self, row: usize, by: f64) -> Result<Self> {
        self.changed_by(signs(row), by)
    }

    fn changed_by(
        &self,
        [a, b, c, x, y, z, strength, moments @ ..]: [f64; INPUTS],
        by: f64,
    ) -> Result<Self> {
        let old = self.body.moments();
        let scaled = |[s1, s2, s3]: [f64; 3], by: f64| {
            // A symmetric body stays one.
            let s2 = if old.is_symmetric() { s1 } else { s2 };
            let [i1, i2, i3] = old.to_array();
            PrincipalMoments::new(i1 * (1.0 + s1 * by), i2 * (1.0 + s2 * by), i3 * (1.0 + s3 * by))
        };
        // A flat body has no neighbours on one side, a thin one hardly any but larger and
        // smaller ones. Those of a slender body count as exact: a change by eps of moments that
        // are nearly equal turns it about the thin axis by I_max/I_min times as much.
        let new = match self.slender {
            Some(_) => old,
            None => scaled(moments, by)
                .or_else(|_| scaled(moments, -by))
                .or_else(|_| scaled([moments[0]; 3], by))?,
        };
        Ok(Self {
            body: RigidBody::new(new),
            strength: self.strength * (1.0 + strength * by),
            start: self.moved(&self.start, [a, b, c, x, y, z], by)?,
            ..*self
        })
    }

    /// A state turned about the body's axes by `by` (rad), and its momentum pushed by as much of
    /// its scale. A slender body turns along, and its rates are pushed.
    pub(super) fn moved(
        &self,
        state: &State,
        [a, b, c, x, y, z]: [f64; 6],
        by: f64,
    ) -> Result<State> {
        let attitude = (state.attitude).turned_in_body(BodyVector::new(a, b, c) * by)?;
        if let Some(slender) = self.slender {
            let [i1, i2, i3] = self.body.moments().to_array();
            let push = BodyVector::new(x * i1, y * i2, z * i3) * (by * slender.rate);
            let momentum = self.body.angular_momentum(state) + push;
            return State::new(attitude, attitude.to_space(momentum));
        }
        State::new(
            attitude,
            state.angular_momentum
                + SpaceVector::new(x, y, z) * (by * self.momentum_scale(&self.start)),
        )
    }

    /// The motion in intervals of equal time by `interval` (from a time and state to a time), with
    /// the state moved before each of them, as rounding does on the way.
    ///
    /// Moved by 0 it is the motion itself.
    pub(super) fn in_intervals(
        &self,
        row: usize,
        by: f64,
        intervals: usize,
        mut interval: impl FnMut(&Self, f64, &State, f64) -> Result<State>,
    ) -> Result<State> {
        let problem = self.changed(row, by)?;
        let mut state = problem.start;
        for k in 0..intervals {
            if k > 0 {
                state = problem.moved_before(&state, [k, intervals], row, by)?;
            }
            let [from, to] = [k, k + 1].map(|k| self.time_at(k, intervals));
            state = interval(&problem, from, &state, to)?;
        }
        Ok(state)
    }

    /// A state moved before an interval, by its number and the number of all.
    pub(super) fn moved_before(
        &self,
        state: &State,
        [interval, intervals]: [usize; 2],
        row: usize,
        by: f64,
    ) -> Result<State> {
        // So much less that on a regular motion all of them together count as much as
        // the change of the start.
        let on_the_way = 2.0 * by / (intervals as f64).sqrt();
        // Other signs every time, so that nothing is undone by the next.
        let [a, b, c, x, y, z, ..] = signs((row + 5 * interval) % ALL_ROWS);
        self.moved(state, [a, b, c, x, y, z], on_the_way)
    }

    /// The time at which the interval of this number begins.
    pub(super) fn time_at(&self, interval: usize, intervals: usize) -> f64 {
        if interval == intervals {
            self.t_end
        } else {
            self.t_start + interval as f64 / intervals as f64 * self.span()
        }
    }

    /// The condition of the motion: the change per relative change of the inputs, as the root of
    /// the sum of squares over all of them and the time. It is taken at the place looked at where
    /// the motion changes most. `motions` tells where the motion is at those places, and where it
    /// is with all inputs changed by so much, up or down by the signs of some rows.
    ///
    /// Infinite if the smallest change that doubles hold is one too many.
    pub(super) fn condition(
        &self,
        probe: &Probe,
        mut motions: impl FnMut(f64) -> Result<(Vec<State>, Vec<Vec<State>>)>,
    ) -> Result<Distances> {
        let mut slopes_of = |by: f64| {
            let (places, changed) = motions(by)?;
            let changed: Vec<_> = changed.iter().map(Vec::as_slice).collect();
            Ok(self.slopes(by, &places, &changed))
        };
        // The change before this one, its slopes, and how far it went.
        let mut coarser: Option<(f64, Distances, f64)> = None;
        // Slopes that wait for a finer change to bear them out.
        let mut waiting: Option<Distances> = None;
        for &by in probe.changes {
            let (slopes, farthest) = slopes_of(by)?;
            let smallest = by <= probe.smallest();
            if farthest <= probe.linear {
                let unsure = waiting.is_none();
                let slopes = waiting
                    .map_or(slopes, |waiting| [0, 1, 2].map(|i| larger(slopes[i], waiting[i])));
                if let Some((before, _, went)) = coarser
                    && unsure
                    && went > FAR
                {
                    if !smallest {
                        waiting = Some(slopes);
                        continue;
                    }
                    if slopes[0] * before < GATHERED * probe.linear {
                        return Ok([f64::INFINITY; 3]);
                    }
                }
                let Some(again) = probe.again.filter(|again| *again < by) else {
                    return Ok(slopes);
                };
                // Near a separatrix a change may carry the motion past its own steepness.
                let (finer, _) = slopes_of(again)?;
                return Ok(if finer[0] > BLURRED * slopes[0] { finer } else { slopes });
            }
            if smallest {
                // A slope, if it is the same as that of a larger change.
                let same = coarser.is_some_and(|(_, slope, _)| slopes[0] <= STRAIGHT * slope[0]);
                let known = same && farthest <= LOST;
                return Ok(if known { slopes } else { [f64::INFINITY; 3] });
            }
            waiting = None;
            coarser = Some((by, slopes, farthest));
        }
        Ok([f64::INFINITY; 3])
    }

    /// By how much the places move per change of the inputs, and how far (rad) the attitude
    /// moved farthest.
    pub(super) fn slopes(
        &self,
        by: f64,
        places: &[State],
        changed: &[&[State]],
    ) -> (Distances, f64) {
        let mut slopes = [0.0; 3];
        let mut farthest: f64 = 0.0;
        for (n, place) in places.iter().enumerate() {
            let mut sum = [0.0; 3];
            for neighbour in changed {
                let apart = self.apart(place, &neighbour[n]);
                farthest = larger(farthest, apart[0]);
                for (sum, apart) in sum.iter_mut().zip(apart) {
                    *sum += (apart / by) * (apart / by);
                }
            }
            let late =
                self.body.angular_velocity(place).norm() * self.t_end.abs().max(self.t_start.abs());
            let rows = changed.len() as f64;
            for (slope, sum) in slopes.iter_mut().zip(sum) {
                *slope = larger(*slope, hypot((sum / rows).sqrt(), late));
            }
        }
        (slopes, farthest)
    }
}

/// A finer change whose slope is more than this times the coarser's has seen something
/// else; less may be rounding.
const BLURRED: f64 = 2.0;

/// Slopes of two changes are one slope if they differ by no more than this.
const STRAIGHT: f64 = 10.0;

/// An end that moves by more than this (rad) has gone far. If it hardly moves by a smaller change,
/// that may be a slope. Or the end is where all motions wait for a while, as a top does that has
/// all but stopped on the vertical: they gather there, and part again. A finer change tells.
const FAR: f64 = 0.5;

/// Where none is left: a slope by which the next larger change would have moved the end by
/// less than this part of what is linear, where in truth it went far, is none.
const GATHERED: f64 = 1e-2;

/// An attitude that moves by more than this (rad) when the inputs change as little as
/// doubles can: nothing is known of it.
const LOST: f64 = 0.05;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_two_columns_of_the_design_are_orthogonal() {
        let mut pairs = 0;
        for i in 0..INPUTS {
            for j in 0..=i {
                let product: f64 = (0..ALL_ROWS).map(|row| signs(row)[i] * signs(row)[j]).sum();
                assert_eq!(product, if i == j { 12.0 } else { 0.0 }, "{i}, {j}");
                pairs += 1;
            }
        }
        assert_eq!(pairs, 55);
    }
}
