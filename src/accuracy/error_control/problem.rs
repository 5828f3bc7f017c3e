//! The problem to be solved, and how a method steps it.

use super::constants::{SLENDER, TUMBLING};
use super::exact_motion::ExactMotion;
use crate::accuracy::{Stepper, Variables};
use crate::body::{RigidBody, State};
use crate::effects::erased::{AnyEffect, AxisOnly};
use crate::effects::{
    Checked, Conserved, Effect, GravityAtLever, IntegrableCase, Properties, Resistance, each,
    one_by_one, piece,
};
use crate::error::{Error, Result};
use crate::frame::SpaceVector;
use crate::integrators::gauss_legendre::SideBySide;
use crate::integrators::{BodyFixed, Integrator, Resisted, Work};
use crate::math::{Lane, order_of_three};
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
}

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
            (acting, Stepper::Dop853(m), Variables::Body) => {
                let effects: &dyn AnyEffect = match &acting {
                    Acting::Nothing => &(),
                    Acting::Weight(gravity) => gravity,
                    Acting::OnAxis(all) | Acting::Smooth(all) | Acting::Anything(all) => *all,
                };
                let scene = self.scene::<false, true>(effects, [from, to]);
                let fixed = BodyFixed::new(&scene, self.torque, effects.properties().slips);
                let start = fixed.components(start);
                fixed.state(&m.advance_counting(&fixed, 0.0, &start, to - from, work)?)
            }
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

    /// A bound on the rates (rad/s) that the body reaches, by its energy.
    pub(super) fn bound_on_rate(&self) -> f64 {
        self.rate_about(0)
    }

    /// The fastest rate (rad/s) to be expected: that bound, or of a slender body what the energy allows
    /// about its other axes.
    pub(super) fn fastest(&self) -> f64 {
        if self.is_slender() {
            return self.rate_about(1).max(self.body.angular_velocity(&self.start).norm());
        }
        self.bound_on_rate()
    }

    /// The rate (rad/s) that the energy allows about an axis, by the order of their moments.
    fn rate_about(&self, axis: usize) -> f64 {
        let moments = self.body.moments().to_array();
        let energy = self.body.kinetic_energy(&self.start);
        ((2.0 * energy + 4.0 * self.torque) / moments[order_of_three(moments)[axis]]).sqrt()
    }

    /// True if one moment is far below the others, and the body does not turn mostly about that axis.
    /// Then L on the fixed axes blurs the rate about it ([`BodyFixed`]), and DOP853 would follow that.
    pub(super) fn is_slender(&self) -> bool {
        let moments = self.body.moments().to_array();
        let [least, _, most] = order_of_three(moments).map(|axis| moments[axis]);
        let rate = self.body.angular_velocity(&self.start).norm();
        most > SLENDER * least && !self.is_spin_free() && self.bound_on_rate() > TUMBLING * rate
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

    /// The time at which the interval of this number begins.
    pub(super) fn time_at(&self, interval: usize, intervals: usize) -> f64 {
        if interval == intervals {
            self.t_end
        } else {
            self.t_start + interval as f64 / intervals as f64 * self.span()
        }
    }
}
