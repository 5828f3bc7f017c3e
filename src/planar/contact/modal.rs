//! A mechanism as a scene in phases: the phase is the mode of each contact.

use super::declare::{Contact, MechanismState, Mode, Press, Sense};
use super::resolve::{Entered, Trigger, enter, put_on};
use super::response::{Problem, Response, total};
use super::{Force, Mechanism, Modes};
use crate::error::Result;
use crate::math::EPS;
use crate::planar::{Condition, Entry, Next, Phased};
use core::fmt;

/// Round-off of a normal force that is 0, in parts of all contact forces.
const FORCE_NOISE: f64 = 4.0 * EPS;
/// Round-off of gaps and slips, in parts of their sizes.
const NOISE: f64 = EPS;
/// Round-off of forces over a whole piece, in parts of all contact forces.
const FORCE_DRIFT: f64 = 1e-12;

/// A [`Mechanism`] as a [`Phased`] scene.
#[derive(Clone, Copy)]
pub struct Modal<M, const N: usize, const C: usize>(pub M);

impl<M, const N: usize, const C: usize> fmt::Debug for Modal<M, N, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Modal<{N}, {C}>")
    }
}

/// The modes in which `mechanism` starts from `state`, and the state put onto its contacts.
///
/// # Errors
/// [`crate::Error::CannotHold`] for a contact whose gap is negative or closing at the start,
/// [`crate::Error::FunctionOutOfRange`] for a mass matrix or a force that has no motion,
/// [`crate::Error::ContactsUndetermined`],
/// [`crate::Error::OutOfRange`] and [`crate::Error::NotFinite`] for coefficients,
/// [`crate::Error::AtIndex`] for a coordinate or a velocity that is not finite.
pub fn entry<M: Mechanism<N, C>, const N: usize, const C: usize>(
    mechanism: &M,
    state: MechanismState<N>,
) -> Result<(Modes<C>, MechanismState<N>)> {
    let mechanism: &dyn Mechanism<N, C> = mechanism;
    let Entered { modes, state, .. } = enter(&Modal(mechanism), 0.0, None, state)?;
    Ok((modes, state))
}

impl<M: Mechanism<N, C>, const N: usize, const C: usize> Modal<M, N, C> {
    /// Accelerations and forces in these modes; `None` if they contradict each other.
    pub(super) fn respond(
        &self,
        modes: &Modes<C>,
        state: &MechanismState<N>,
    ) -> Option<Response<N, C>> {
        let contacts = self.0.contacts(state);
        self.newton(state, &self.0.mass(&state.q), &contacts).respond(modes)
    }

    /// Newton's laws with the contacts.
    pub(super) fn newton<'a>(
        &self,
        state: &MechanismState<N>,
        mass: &'a [[f64; N]; N],
        contacts: &'a [Contact<N>; C],
    ) -> Problem<'a, N, C> {
        Problem {
            mass,
            load: self.0.force(state),
            contacts,
            aim: contacts.map(|c| [-c.normal.bias, -c.tangent.bias]),
            impact: false,
        }
    }

    /// The forces of the contacts; NaN where the modes have none.
    pub(super) fn forces(&self, modes: &Modes<C>, state: &MechanismState<N>) -> [Force; C] {
        let none = Force { normal: f64::NAN, tangential: f64::NAN };
        self.respond(modes, state).map_or([none; C], |response| response.force)
    }

    fn contact(&self, i: usize, state: &MechanismState<N>) -> Contact<N> {
        self.0.contacts(state)[i]
    }

    /// Whether a contact that acts is off its surface, or moves where it must not, by more than
    /// this part of its size.
    fn has_drifted(&self, modes: &Modes<C>, state: &MechanismState<N>, within: f64) -> bool {
        let contacts = self.0.contacts(state);
        (0..C).filter(|&i| modes[i] != Mode::Open).any(|i| {
            let Contact { gap, normal, tangent, press, .. } = &contacts[i];
            let is_off = || {
                gap.abs() > within * self.gap_size(i, state)
                    || normal.speed(&state.v).abs() > within * self.normal_size(i, state)
            };
            let slips = || tangent.speed(&state.v).abs() > within * self.slip_size(i, state);
            let touches = matches!(press, Press::OneSided | Press::TwoSided);
            (touches && is_off()) || (modes[i] == Mode::Stick && slips())
        })
    }

    /// The measure of the gap of contact `i`.
    pub(super) fn gap_size(&self, i: usize, state: &MechanismState<N>) -> f64 {
        let row = self.0.contacts(state)[i].normal;
        row.size(&self.0.scale(state).q)
    }

    /// The measure of its normal speed.
    pub(super) fn normal_size(&self, i: usize, state: &MechanismState<N>) -> f64 {
        let row = self.0.contacts(state)[i].normal;
        row.size(&self.0.scale(state).v) + row.surface.abs()
    }

    /// The measure of its slip speed.
    pub(super) fn slip_size(&self, i: usize, state: &MechanismState<N>) -> f64 {
        let row = self.0.contacts(state)[i].tangent;
        row.size(&self.0.scale(state).v) + row.surface.abs()
    }
}

impl<M: Mechanism<N, C>, const N: usize, const S: usize, const C: usize> Phased<S>
    for Modal<M, N, C>
{
    type Phase = Modes<C>;

    fn derivative(&self, modes: Modes<C>, state: &[f64; S]) -> [f64; S] {
        let state = MechanismState::from_array(state);
        let rate = self.respond(&modes, &state).map_or([f64::NAN; N], |response| response.rate);
        MechanismState { q: state.v, v: rate }.to_array()
    }

    fn conditions(&self, modes: Modes<C>) -> Vec<Condition<'_, Modes<C>, S>> {
        let state = MechanismState::from_array::<S>;
        let nowhere = MechanismState::rest([0.0; N]);
        let mut conditions = Vec::new();
        if let Some((name, _)) = self.0.end(&nowhere) {
            let margin = move |y: &[f64; S]| self.0.end(&state(y)).map_or(f64::NAN, |(_, m)| m);
            conditions.push(Condition::gap(name, margin, Next::End));
        }
        // Name and kind of a contact are the same in every state.
        for (i, contact) in self.0.contacts(&nowhere).into_iter().enumerate() {
            let decide = |trigger| {
                let before = Some((modes, trigger));
                Next::decide(move |t, y: &[f64; S]| {
                    enter(self, t, before, state(y)).map(Entry::from)
                })
            };
            let one_sided = contact.press == Press::OneSided;
            if one_sided && modes[i] == Mode::Open {
                let gap = move |y: &[f64; S]| self.contact(i, &state(y)).gap;
                let size = move |y: &[f64; S]| NOISE * self.gap_size(i, &state(y));
                let next = decide(Trigger::Gap(i));
                conditions.push(Condition::gap(contact.name, gap, next).flickering(size));
            }
            let all = move |y: &[f64; S]| FORCE_DRIFT * total(&self.forces(&modes, &state(y)));
            if one_sided && modes[i] != Mode::Open {
                let push = move |y: &[f64; S]| {
                    let forces = self.forces(&modes, &state(y));
                    let normal = forces[i].normal;
                    // A contact that neither pushes nor pulls does not flicker.
                    let none = normal.abs() <= FORCE_NOISE * total(&forces);
                    if none { 0.0 } else { normal }
                };
                let next = decide(Trigger::Force(i));
                conditions.push(Condition::contact(contact.name, push, next).decided(all));
            }
            if modes[i] == Mode::Stick {
                for sense in [Sense::Forward, Sense::Backward] {
                    // Friction against the slip that begins: T = -sign mu N.
                    let left = move |y: &[f64; S]| {
                        let Force { normal, tangential } = self.forces(&modes, &state(y))[i];
                        let holding = self.contact(i, &state(y)).friction.holding;
                        holding * normal + sense.sign() * tangential
                    };
                    let next = decide(Trigger::Cone(i, sense));
                    conditions.push(Condition::gap(contact.name, left, next).decided(all));
                }
            }
            if let Mode::Slip(sense) = modes[i] {
                let slip = move |y: &[f64; S]| {
                    sense.sign() * self.contact(i, &state(y)).tangent.speed(&state(y).v)
                };
                let size = move |y: &[f64; S]| NOISE * self.slip_size(i, &state(y));
                let next = decide(Trigger::Slip(i));
                conditions.push(Condition::gap(contact.name, slip, next).flickering(size));
            }
        }
        conditions
    }

    fn scale(&self, state: &[f64; S]) -> [f64; S] {
        self.0.scale(&MechanismState::from_array(state)).to_array()
    }

    fn phase_limit(&self) -> usize {
        self.0.phase_limit()
    }

    fn drift(&self, modes: Modes<C>, state: &[f64; S], within: f64) -> Option<[f64; S]> {
        let mut back = MechanismState::from_array(state);
        self.has_drifted(&modes, &back, within).then(|| {
            put_on(self, &modes, &mut back);
            let back: [f64; S] = back.to_array();
            core::array::from_fn(|k| state[k] - back[k])
        })
    }
}
