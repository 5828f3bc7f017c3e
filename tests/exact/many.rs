//! Many motions at one time have the bits of one by one.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBodies, FreeBody, Kind};
use rotation_dynamics::exact::heavy_top::{HeavyTop, HeavyTops, ReducedTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::{Error, Result};

/// As many bodies of every kind, in turn: tumbling about either axis, beside the separatrix
/// and on it, symmetric about each axis, steady.
fn bodies(number: u32) -> Vec<FreeBody> {
    let kinds = [
        ([1.0, 2.0, 8.0 / 3.0], [0.8, 0.4, 0.3375]),
        ([8.0 / 3.0, 1.0, 2.0], [0.9, -0.7, -0.1]),
        ([1.0, 2.0, 2.5], [1e-9, 1.3, 2e-9]),
        ([3.0, 2.0, 1.0], [-0.02, 1.3, 0.03]),
        ([1.0, 2.5, 3.0], [0.75, -0.5, 0.75]),
        ([1.0, 1.0, 1.9], [1.0, 0.5, -0.2]),
        ([1.9, 1.0, 1.0], [1.0, 0.5, -0.2]),
        ([1.0, 1.9, 1.0], [-1.0, 0.5, -0.2]),
        ([1.0, 2.0, 2.5], [0.0, -1.5, 0.0]),
    ];
    let body = |k: u32| {
        let ([i1, i2, i3], rates) = kinds[k as usize % kinds.len()];
        let start = Attitude::from_rotation_vector(SpaceVector::new(0.3, -1.1, f64::from(k)))?;
        let moments = PrincipalMoments::new(i1, i2, i3)?;
        // A power of two leaves the separatrix where it is.
        let faster = f64::from(1 << (k % 4));
        FreeBody::new(moments, start, BodyVector::from_array(rates.map(|w| w * faster)))
    };
    (0..number).map(|k| body(k).expect("a motion")).collect()
}

/// As many tops: in waves and loops, next to the homoclinic motion and on it, with gravity
/// upwards, asleep.
fn tops(number: u32) -> Vec<HeavyTop> {
    let top = |k: u32| {
        let part = 1.0 + 1e-3 * f64::from(k);
        let reduced = |a, b, c, theta, rate| {
            HeavyTop::from_angles(ReducedTop::new(a, b, c)?, theta, rate, 0.3, 0.4)
        };
        match k % 7 {
            0 => reduced(2.0, 1.2, 0.2, 0.5, 0.1 * part),
            1 => reduced(2.0, 1.0001, 1.3, 0.02 * part, 0.0),
            2 => reduced(2.0, 0.999, 1.3, 0.03, -0.4 * part),
            3 => reduced(2.0, -1.0001, -1.3, 3.12, 0.01 * part),
            4 => reduced(0.7, 0.9, -0.4 * part, 1.1, 0.2),
            5 => homoclinic(part),
            _ => {
                let body = SymmetricTop::new(1.0, 0.4, 2.0, 1.0)?;
                HeavyTop::new(body, Attitude::IDENTITY, BodyVector::new(0.0, 0.0, part))
            }
        }
    };
    (0..number).map(|k| top(k).expect("a motion")).collect()
}

/// b = 1 and E~ = 0 with c > a/4.
fn homoclinic(part: f64) -> Result<HeavyTop> {
    use rotation_dynamics::exact::heavy_top::Start;
    let top = ReducedTop::new(2.0, 1.0, 1.25 * part)?;
    HeavyTop::from_energy(top, 0.0, Start::ThetaMax, 0.0, 0.0)
}

/// Early and late; from the fifth on the homoclinic tops are beyond what is done in lanes.
const TIMES: [f64; 8] = [0.0, 0.37, -12.5, 77.7, 901.0, -1e6, 3e9, 1e13];

fn bits(states: &[Kinematics]) -> Vec<[u64; 7]> {
    let of = |state: &Kinematics| {
        let [w, x, y, z] = state.attitude.quaternion();
        let [p, q, r] = state.angular_velocity.to_array();
        [w, x, y, z, p, q, r].map(f64::to_bits)
    };
    states.iter().map(of).collect()
}

#[test]
fn free_bodies_have_the_scalar_bits() -> Result<()> {
    let mut compared = 0;
    // Blocks that are full and that are not, and none.
    for number in [0, 1, 8, 9, 71, 72, 73, 500] {
        let bodies = bodies(number);
        let together = FreeBodies::new(&bodies);
        assert_eq!(together.bodies().len(), bodies.len());
        let mut states = vec![Kinematics::REST; bodies.len()];
        for t in TIMES {
            together.kinematics(t, &mut states)?;
            let one_by_one: Vec<_> = bodies.iter().map(|body| body.kinematics(t)).collect();
            assert_eq!(bits(&states), bits(&one_by_one), "{number} bodies at {t}");
            compared += states.len();
        }
    }
    assert_eq!(compared, 8 * 734);
    let separatrix = |body: &FreeBody| body.kind() == Kind::Separatrix;
    assert!(bodies(9).iter().any(separatrix));
    Ok(())
}

#[test]
fn tops_have_the_scalar_bits() -> Result<()> {
    let (mut compared, mut late) = (0, 0);
    for number in [0, 1, 7, 8, 9, 56, 57, 500] {
        let tops = tops(number);
        let together = HeavyTops::new(&tops);
        assert_eq!(together.tops().len(), tops.len());
        let mut states = vec![Kinematics::REST; tops.len()];
        for t in TIMES {
            together.kinematics(t, &mut states)?;
            let one_by_one: Vec<_> = tops.iter().map(|top| top.kinematics(t)).collect();
            assert_eq!(bits(&states), bits(&one_by_one), "{number} tops at {t}");
            compared += states.len();
        }
        late += tops.iter().filter(|top| top.parameter() > 0.8).count();
    }
    assert_eq!((compared, late), (8 * 638, LATE));
    Ok(())
}

/// How many of these tops have the hyperbolic series.
const LATE: usize = 363;

#[test]
fn a_wrong_number_of_states_or_a_time_that_is_none_is_refused_untouched() {
    let (bodies, tops) = (bodies(11), tops(11));
    let (bodies, tops) = (FreeBodies::new(&bodies), HeavyTops::new(&tops));
    let mut refused = 0;
    let mut refuse = |length: usize, t: f64, told: &dyn Fn(Error) -> bool| {
        let mut states = vec![Kinematics::REST; length];
        for error in
            [bodies.kinematics(t, &mut states).err(), tops.kinematics(t, &mut states).err()]
        {
            assert!(error.is_some_and(told), "{length} states at {t}");
            assert!(states.iter().all(|state| *state == Kinematics::REST));
            refused += 1;
        }
    };
    for found in [0, 10, 12] {
        let lengths = Error::Lengths { name: "states", found, expected: 11 };
        refuse(found, 1.0, &|error| error == lengths);
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refuse(
            11,
            bad,
            &|error| matches!(error, Error::NotFinite { name: "t", value } if value.to_bits() == bad.to_bits()),
        );
    }
    for late in [1e17, -1e300] {
        refuse(11, late, &|error| matches!(error, Error::PhaseLost { t, .. } if t == late));
    }
    assert_eq!(refused, 16);
}

/// Teeth: one body of many that is another shows, and it alone.
#[test]
fn damaged_a_body_that_is_another_shows() -> Result<()> {
    let bodies = bodies(100);
    let mut damaged = bodies.clone();
    damaged[41] = bodies[42].clone();
    let mut states = [vec![Kinematics::REST; 100], vec![Kinematics::REST; 100]];
    FreeBodies::new(&bodies).kinematics(5.0, &mut states[0])?;
    FreeBodies::new(&damaged).kinematics(5.0, &mut states[1])?;
    let differ = |k: &usize| bits(&states[0][*k..=*k]) != bits(&states[1][*k..=*k]);
    assert_eq!((0..100).filter(differ).collect::<Vec<_>>(), [41]);
    Ok(())
}
