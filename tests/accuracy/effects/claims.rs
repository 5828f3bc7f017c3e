//! Every claim of every effect is true, and its damaged twin is refused.

use super::{body, tilted};
use crate::twin::*;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, EffectList, Feature, Gravity, GravityAtLever,
    GravityGradient, KeplerOrbit, OrbitingBody, PrescribedTorque, Profile, Properties, Resistance,
    Torque, ViscousFriction, check,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::Lane;

/// Effects, refusals of false claims and true claims so far.
#[derive(Default)]
struct Tally {
    checked: usize,
    refused: usize,
    allowed: usize,
}

const SPAN: [f64; 2] = [0.0, 10.0];

impl Tally {
    /// The effect itself passes, and every twin whose claim is false is refused.
    fn judge(&mut self, effect: &(dyn AnyEffect + Sync), body: &RigidBody, state: &State) {
        check(effect, body, SPAN, state).expect("true claims");
        let properties = effect.properties();
        self.checked += 1;
        for (lie, said) in LIES.into_iter().enumerate() {
            let verdict = check(&Twin(effect, lie), body, SPAN, state);
            let breaks = !effect.break_points().is_empty();
            let true_all_the_same = match lie {
                // Of an effect that keeps no energy it is true where there is no potential.
                OTHER_POTENTIAL => effect.potential_energy(SPAN[0], body, state) == 0.0,
                OTHER_POWER => properties.conserved.energy,
                SMALL_SCALE | CLOSED_FORM => false,
                // It may be that none of the places lie where it is that large.
                LARGE_SCALE => breaks || effect.narrowest() != Some(Feature::WIDE),
                NO_BREAKS => !breaks,
                _ => damaged(properties, lie) == properties,
            };
            let name = effect.names()[0];
            assert_eq!(verdict.is_ok(), true_all_the_same, "{name}, {said}: {verdict:?}");
            if let Err(error) = verdict {
                let told = error.to_string();
                assert!(told.contains(&format!("\"{name}\" says")), "{told}");
                self.refused += 1;
            } else {
                self.allowed += 1;
            }
        }
    }
}

#[test]
fn every_claim_is_true_and_its_twin_is_refused() {
    let mut tally = Tally::default();
    let weight = 9.8;
    let lever = GravityAtLever::new(weight, 0.3).expect("gravity");
    let centre = BodyVector::new(0.2, -0.1, 0.3);
    let gravity = Gravity::new(weight, centre).expect("gravity");
    let viscous = ViscousFriction::new(0.02, 0.05).expect("friction");
    let steps = Profile::steps(&[(1.0, 1.0), (3.0, -0.5), (7.5, 0.0)]).expect("steps");
    let lines = Profile::lines(&[(2.0, 1.0), (4.0, -0.5), (8.0, 0.4)]).expect("lines");
    let pulse = Profile::pulse(5.0, 1.5).expect("a pulse");
    let torque = [0.3, -0.2, 0.5];
    let on_space = |profile: &Profile| {
        let torque = SpaceVector::from_array(torque);
        PrescribedTorque::on_space(torque, profile.clone()).expect("a torque")
    };
    let on_body = |profile: &Profile| {
        let torque = BodyVector::from_array(torque);
        PrescribedTorque::on_body(torque, profile.clone()).expect("a torque")
    };
    for moments in [[1.0, 1.5, 0.8], [1.0, 1.0, 0.6]] {
        for rates in [[0.3, 0.1, 2.0], [-0.7, 1.1, -0.4]] {
            let body = body(moments[0], moments[1], moments[2]);
            let start = tilted(&body, rates);
            tally.judge(&lever, &body, &start);
            tally.judge(&gravity, &body, &start);
            tally.judge(&viscous, &body, &start);
            for spin in [10.0, 1e3] {
                let drag = DiscDrag::new(0.1, 1.2, 1.5e-5, spin).expect("drag");
                tally.judge(&drag, &body, &start);
            }
            for profile in [&steps, &lines, &pulse] {
                tally.judge(&on_space(profile), &body, &start);
                tally.judge(&on_body(profile), &body, &start);
            }
            if !body.moments().is_symmetric() {
                for e in [0.4, 1.3] {
                    let orbit = KeplerOrbit::about(1.0, 2.0, e)
                        .and_then(|orbit| orbit.oriented(0.3, 0.8, 1.9))
                        .and_then(|orbit| orbit.turning(-0.02, 0.03))
                        .expect("an orbit");
                    let planet = OrbitingBody::new(0.7, orbit).expect("a body");
                    tally.judge(&planet, &body, &start);
                    if let Ok(mean) = planet.averaged() {
                        tally.judge(&mean, &body, &start);
                    }
                }
            }
            if body.moments().is_symmetric() {
                let bearing = CoulombBearing::new(0.3, &body, &start, 0.0).expect("a bearing");
                tally.judge(&bearing, &body, &start);
            }
        }
    }
    assert_eq!(tally.checked, 4 * 11 + 2 * 3 + 2);
    // False claims: 7 of gravity at a lever, 9 of gravity anywhere, 12 of friction and of
    // drag, 12 of steps and of lines, 11 of a pulse, each on both axes; 12 of the bearing and
    // of an orbiting body, on an ellipse, on a hyperbola and averaged.
    let of_all = 7 + 9 + 3 * 12 + 4 * 12 + 2 * 11;
    assert_eq!(tally.refused, 4 * of_all + 2 * 12 + 2 * 3 * 12);
    assert_eq!(tally.refused + tally.allowed, 52 * LIES.len());
}

/// An effect that says it resists the rotation twice as strongly as its torque does.
struct Overstated<E>(E);

impl<E: Effect> Effect for Overstated<E> {
    const PROPERTIES: Properties = E::PROPERTIES;

    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        self.0.torques_on_axis(body, axis)
    }

    fn resistance(&self, t: f64, body: &RigidBody) -> Option<Resistance> {
        Some(self.0.resistance(t, body)?.times(2.0))
    }

    fn break_points(&self) -> Vec<f64> {
        self.0.break_points()
    }

    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }
}

#[test]
fn a_resistance_that_is_overstated_is_refused() {
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.3, 0.1, 2.0]);
    let viscous = ViscousFriction::new(0.02, 0.05).expect("friction");
    let drag = DiscDrag::new(0.1, 1.2, 1.5e-5, 1e3).expect("drag");
    let bearing = CoulombBearing::new(0.3, &body, &start, 0.0).expect("a bearing");
    let told = [
        check(&Overstated(viscous), &body, SPAN, &start),
        check(&Overstated(drag), &body, SPAN, &start),
        check(&Overstated(bearing), &body, SPAN, &start),
    ]
    .map(|verdict| verdict.expect_err("overstated").to_string());
    for told in told {
        assert!(told.contains("says what of its torque resists the rotation"), "{told}");
    }
}

/// Gravity and a wire that bears all of it but a small part: what is left is judged against
/// the rounding of the two, not its own. Its twin has a jump that is longer than that.
#[test]
fn effects_that_nearly_cancel_are_judged_by_their_own_sizes() {
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.3, 0.1, 2.0]);
    let weight = 9.8;
    let (mut held, mut refused) = (0, 0);
    for left in [0.0, 1e-15, 1e-13, 1e-9] {
        for jump in [0.0, 1e-7] {
            let lever = GravityAtLever::new(weight, 0.3).expect("gravity");
            let wire = Torque::on_space("wire", move |_t, _body: &RigidBody, state: &State| {
                let axis = state.attitude.axis();
                let aside = if axis.x() > 0.1 { jump } else { 0.0 };
                SpaceVector::new(axis.y(), -axis.x(), 0.0) * (weight * 0.3 * (1.0 - left))
                    + SpaceVector::new(0.0, 0.0, aside)
            });
            let verdict = check(&(lever, wire.smooth()), &body, SPAN, &start);
            held += usize::from(jump == 0.0 && verdict.is_ok());
            refused += usize::from(jump > 0.0 && verdict.is_err());
        }
    }
    assert_eq!((held, refused), (4, 4));
}

/// A body at rest, a start without spin, a torque of size zero: nothing is claimed falsely.
#[test]
fn nothing_is_claimed_of_nothing() {
    let body = body(1.0, 1.0, 0.6);
    let mut ran = 0;
    for rates in [[0.0; 3], [0.3, 0.0, 0.0]] {
        let start = tilted(&body, rates);
        let centre = BodyVector::zero();
        check(&Gravity::new(1.0, centre).expect("gravity"), &body, SPAN, &start).expect("gravity");
        let viscous = ViscousFriction::isotropic(0.0).expect("friction");
        check(&viscous, &body, SPAN, &start).expect("friction");
        let viscous = ViscousFriction::isotropic(0.1).expect("friction");
        check(&viscous, &body, SPAN, &start).expect("friction");
        for tau in [0.0, 0.1] {
            let bearing = CoulombBearing::new(tau, &body, &start, 0.0).expect("a bearing");
            check(&bearing, &body, SPAN, &start).expect("a bearing");
        }
        let drag = DiscDrag::new(0.1, 1.2, 1.5e-5, 0.0).expect("drag");
        check(&drag, &body, SPAN, &start).expect("drag");
        let none = Profile::steps(&[(20.0, 1.0)]).expect("steps");
        let later = PrescribedTorque::on_space(SpaceVector::new(1.0, 0.0, 0.0), none);
        check(&later.expect("a torque"), &body, SPAN, &start).expect("a torque");
        ran += 7;
    }
    assert_eq!(ran, 14);
}

/// An effect whose power is so many times what it says.
struct Powered<E>(E, f64);

impl<E: Effect> Effect for Powered<E> {
    const PROPERTIES: Properties = E::PROPERTIES;

    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.potential_energy(t, body, state)
    }

    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.power(t, body, state) * self.1
    }

    fn narrowest(&self) -> Option<Feature> {
        self.0.narrowest()
    }
}

/// Seconds since the year 2000, or since 1970: a time is known to a ten-millionth of a second
/// only. What is true is believed there, in long spans and in short ones, and of a power a
/// small part that is false is still found.
#[test]
fn late_claims_are_judged_as_early_ones() {
    let body = body(20.0, 90.0, 100.0);
    let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
    let gradient = GravityGradient::on_orbit(1.1e-3, normal, towards).expect("an orbit");
    let planet = KeplerOrbit::about(4e14, 7e6, 0.1)
        .and_then(|orbit| orbit.oriented(0.3, 0.8, 1.9)?.turning(-2e-7, 3e-7))
        .and_then(|orbit| OrbitingBody::new(4e14, orbit))
        .expect("a body");
    let silent = || Torque::on_space("silent", |_, _: &RigidBody, _: &State| SpaceVector::zero());
    let (mut believed, mut refused) = (0, 0);
    for from in [0.0, 3e8, 8.4e8, 1e9, 1.76e9, -1.76e9] {
        for length in [1e-3, 0.01, 1.0, 17_000.0] {
            // Measured: refused from 1.5e-5 at the time 0 and 3.8e-4 at 1.76e9 on the first
            // three, and from 0.17 on the fast one.
            for (rates, lie) in [
                ([1e-9, 0.0, 0.0], 1e-3),
                ([0.0, 1e-5, 2e-6], 1e-3),
                ([0.0, 0.0, 1.1e-3], 1e-3),
                ([0.1, 0.2, 6.0], 0.3),
            ] {
                let start = tilted(&body, rates);
                let span = [from, from + length];
                for truth in [
                    check(&gradient, &body, span, &start),
                    check(&planet, &body, span, &start),
                    check(&(gradient, silent()), &body, span, &start),
                    check(&(planet, silent()), &body, span, &start),
                ] {
                    truth.expect("the truth");
                    believed += 1;
                }
                for false_power in [
                    check(&Powered(gradient, 1.0 + lie), &body, span, &start),
                    check(&Powered(planet, 1.0 - lie), &body, span, &start),
                ] {
                    let told = false_power.expect_err("a lie").to_string();
                    assert!(told.contains("at what power it changes the energy"), "{told}");
                    refused += 1;
                }
            }
        }
    }
    assert_eq!((believed, refused), (384, 192));
}

/// A scale is a claim of the effect that states it, and of no other beside it.
#[test]
fn a_scale_that_is_not_stated_claims_nothing() {
    let body = body(20.0, 90.0, 100.0);
    let start = tilted(&body, [0.01, 0.02, 0.03]);
    let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
    let gradient = GravityGradient::on_orbit(1.1e-3, normal, towards).expect("an orbit");
    // Strong late, strong early, and strong at the time 0, which is no part of the span.
    let shapes: [fn(f64) -> f64; 3] =
        [|t| t * t, |t| 1.0 / (t * t), |t| if t < 0.5 { 1e9 } else { 1.0 }];
    let span = [1.0, 1e4];
    let mut ran = 0;
    for length in [1e-9, 1e-3, 0.2, 100.0] {
        for shape in shapes {
            let closure = Torque::on_body("closure", move |t, _: &RigidBody, _: &State| {
                BodyVector::new(length * shape(t), 0.0, 0.0)
            });
            for truth in [
                check(&closure, &body, span, &start),
                check(&(gradient, closure.clone()), &body, span, &start),
                check(&((gradient, Some(closure)), ()), &body, span, &start),
            ] {
                truth.expect("the truth");
                ran += 1;
            }
        }
    }
    assert_eq!(ran, 36);
    // The damaged twins: beside a closure that is strong for an hour, a gradient that states a
    // scale a hundred thousand times too small.
    let thruster = Torque::on_body("thruster", |t, _: &RigidBody, _: &State| {
        let on = (2000.0..5600.0).contains(&t);
        BodyVector::new(if on { 100.0 } else { 0.0 }, 0.0, 0.0)
    });
    let gradient: &'static GravityGradient = Box::leak(Box::new(gradient));
    let small = || Box::new(Twin(gradient, SMALL_SCALE));
    let beside = EffectList::new(vec![small(), Box::new(thruster)]).expect("no weight");
    let told = [check(&*small(), &body, span, &start), check(&beside, &body, span, &start)]
        .map(|verdict| verdict.expect_err("a lie").to_string());
    for told in told {
        assert!(told.contains("a thousand times longer than torque_scale"), "{told}");
    }
}
