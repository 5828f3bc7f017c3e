//! The heavy symmetric top in closed form, in every regime.

use crate::{Held, drawn, holds, or_refused, within};
use proptest::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::hypot;
use rotation_dynamics::motion::Motion;
use support::EPS;

const K: f64 = 64.0;

/// A top, its start, and a span in radians of its fastest rate.
#[derive(Debug, Clone, Copy)]
struct Drawn {
    moments: [f64; 2],
    torque: f64,
    attitude: Attitude,
    rates: BodyVector,
    radians: f64,
}

fn inputs() -> impl Strategy<Value = Drawn> {
    let shape = prop_oneof![4 => 0.05..1.99, 1 => drawn::decades(-9.0..0.0), 1 => Just(1.0), 1 => drawn::decades(-9.0..-1.0).prop_map(|x| 2.0 - x)];
    // Torque over I1 omega^2: from nearly free to hardly turning.
    let strength = (drawn::decades(-8.0..6.0), any::<bool>());
    let parts = (shape, drawn::decades(-40.0..38.0), strength, drawn::attitude());
    (parts, drawn::direction(), drawn::decades(-3.0..4.0), drawn::radians()).prop_map(
        |((shape, i1, (strength, below), attitude), direction, rate, radians)| {
            let size = i1 * rate * rate * strength;
            Drawn {
                moments: [i1, shape * i1],
                torque: if below { -size } else { size },
                attitude,
                rates: BodyVector::from_array(direction.map(|x| x * rate)),
                radians,
            }
        },
    )
}

impl Drawn {
    fn top(&self) -> rotation_dynamics::Result<HeavyTop> {
        let [i1, i3] = self.moments;
        HeavyTop::new(
            SymmetricTop::new(i1, i3, self.torque.abs(), self.torque.signum())?,
            self.attitude,
            self.rates,
        )
    }

    fn time(&self) -> f64 {
        let swing = (self.torque.abs() / self.moments[0]).sqrt();
        self.radians / hypot(self.rates.norm(), swing)
    }

    /// Energy, L_Z and L_z.
    fn kept(&self, now: &Kinematics) -> [f64; 3] {
        let [i1, i3] = self.moments;
        let [a, b, c] = now.angular_velocity.to_array();
        let up = now.attitude.vertical();
        let l = BodyVector::new(i1 * a, i1 * b, i3 * c);
        let energy = 0.5 * (i1 * (a * a + b * b) + i3 * c * c) + self.torque * up.z();
        [energy, l.dot(&up), l.z()]
    }

    /// The sizes against which these count.
    fn sizes(&self, now: &Kinematics) -> [f64; 3] {
        let [i1, i3] = self.moments;
        let [a, b, c] = now.angular_velocity.to_array();
        let energy = i1 * (a * a + b * b) + i3 * c * c + self.torque.abs();
        let l = hypot(hypot(i1 * a, i1 * b), i3 * c);
        let most = (energy * i1.max(i3)).sqrt().max(l);
        [energy, most, most]
    }
}

#[test]
fn energy_and_momenta_stay() {
    holds("heavy top: what it keeps", 3000, 0.02, inputs(), |drawn| {
        let top = or_refused!(drawn.top());
        let now = or_refused!(top.try_kinematics(drawn.time()));
        prop_assert!(now.is_finite());
        let start = Kinematics::new(drawn.attitude, drawn.rates);
        let (from, to, sizes) = (drawn.kept(&start), drawn.kept(&now), drawn.sizes(&now));
        for ((from, to), size) in from.into_iter().zip(to).zip(sizes) {
            within!((from - to).abs(), K * EPS * size, "kept");
        }
        Ok(Held::Yes)
    });
}

/// Gravity has one direction: turns about the vertical, and reflections in time, are free.
#[test]
fn a_turn_about_the_vertical_turns_the_motion() {
    let inputs = (inputs(), -3.2..3.2);
    holds("heavy top: the start turned", 2000, 0.02, inputs, |(drawn, angle)| {
        let turn = Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), angle).unwrap();
        let top = or_refused!(drawn.top());
        let turned = or_refused!(Drawn { attitude: turn * drawn.attitude, ..drawn }.top());
        let t = drawn.time();
        let condition = or_refused!(top.condition(t));
        let off = turned.attitude(t).angle_to(&(turn * top.attitude(t)));
        within!(off, K * EPS * (1.0 + condition), "attitude");
        Ok(Held::Yes)
    });
}

#[test]
fn there_and_back() {
    holds("heavy top: there and back", 1500, 0.03, inputs(), |drawn| {
        let (top, t) = (or_refused!(drawn.top()), drawn.time());
        let there = or_refused!(top.try_kinematics(t));
        let back = Drawn { attitude: there.attitude, rates: there.angular_velocity, ..drawn };
        let back = or_refused!(back.top());
        let condition = or_refused!(top.condition(t)) + or_refused!(back.condition(-t));
        if condition < 1e9 {
            let off = back.attitude(-t).angle_to(&drawn.attitude);
            within!(off, K * EPS * (1.0 + condition), "attitude");
        }
        Ok(Held::Yes)
    });
}
