//! Attitudes and all that they are written as.

use crate::{Held, drawn, holds, within};
use proptest::prelude::*;
use rotation_dynamics::attitude::{Attitude, Sequence};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use support::EPS;

#[test]
fn every_way_of_writing_leads_back() {
    let inputs = (drawn::attitude(), 0..12_usize);
    holds("attitudes written and read", 20_000, 0.0, inputs, |(attitude, n)| {
        let sequence = Sequence::ALL[n];
        let back = [
            Attitude::from_euler(attitude.euler_angles()).unwrap(),
            Attitude::from_sequence(sequence, attitude.angles(sequence)).unwrap(),
            Attitude::from_matrix(attitude.matrix()).unwrap(),
            Attitude::from_rotation_vector(attitude.rotation_vector()).unwrap(),
            Attitude::from_yaw_pitch_roll(attitude.yaw_pitch_roll()).unwrap(),
            Attitude::from_xyzw(attitude.xyzw()).unwrap(),
        ];
        for (n, back) in back.iter().enumerate() {
            within!(back.angle_to(&attitude), 12.0 * EPS, format!("way {n}"));
        }
        Ok(Held::Yes)
    });
}

#[test]
fn attitudes_are_a_group_that_keeps_lengths() {
    let inputs = [drawn::attitude(), drawn::attitude(), drawn::attitude()];
    holds("the group", 20_000, 0.0, inputs, |[a, b, c]| {
        let norm = (a * b).quaternion().iter().map(|x| x * x).sum::<f64>();
        within!((norm - 1.0).abs(), 8.0 * EPS, "length");
        within!(((a * b) * c).angle_to(&(a * (b * c))), 12.0 * EPS, "in any order");
        within!((a * a.inverse()).angle_to(&Attitude::IDENTITY), 8.0 * EPS, "inverse");
        within!(a.then(&b).angle_to(&(b * a)), 8.0 * EPS, "then");
        Ok(Held::Yes)
    });
}

#[test]
fn vectors_turn_there_and_back() {
    let size = drawn::decades(-150.0..150.0);
    let inputs = (drawn::attitude(), drawn::attitude(), drawn::direction(), size);
    holds("vectors turned", 20_000, 0.0, inputs, |(a, b, direction, size)| {
        let v = BodyVector::from_array(direction.map(|x| x * size));
        let turned = a.to_space(v);
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt() * size;
        // A quaternion that is unit to 4 eps is taken as it is, and stretches by four times that.
        within!((turned.norm() / length - 1.0).abs(), 24.0 * EPS, "length");
        within!((a.to_body(turned) - v).norm(), 40.0 * EPS * length, "back");
        let two = a.to_space(BodyVector::from_array(b.to_space(v).to_array()));
        within!(((a * b).to_space(v) - two).norm(), 48.0 * EPS * length, "two turns");
        Ok(Held::Yes)
    });
}

/// An attitude from any four doubles, any three: a rotation, or a reason.
#[test]
fn any_bits_are_an_attitude_or_are_refused() {
    let bits = prop::array::uniform9(any::<u64>());
    holds("attitudes of any bits", 20_000, 1.0, bits, |bits| {
        let x = bits.map(f64::from_bits);
        let made = [
            Attitude::from_quaternion([x[0], x[1], x[2], x[3]]),
            Attitude::from_rotation_vector(SpaceVector::new(x[0], x[1], x[2])),
            Attitude::about_body_axis(BodyVector::new(x[0], x[1], x[2]), x[3]),
            Attitude::from_sequence(Sequence::ALL[(bits[3] % 12) as usize], [x[0], x[1], x[2]]),
            Attitude::from_matrix([[x[0], x[1], x[2]], [x[3], x[4], x[5]], [x[6], x[7], x[8]]]),
        ];
        let mut held = Held::Refused;
        for made in made {
            match made {
                Ok(attitude) => {
                    let norm = attitude.quaternion().iter().map(|x| x * x).sum::<f64>();
                    within!((norm - 1.0).abs(), 8.0 * EPS, "length");
                    held = Held::Yes;
                }
                Err(error) => prop_assert!(error.to_string().len() > 10),
            }
        }
        Ok(held)
    });
}
