//! The motions by which throughput is measured: of either closed form one whose series is
//! trigonometric and one whose series is hyperbolic, each from a case with 25 digits.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBodies, FreeBody};
use rotation_dynamics::exact::heavy_top::{HeavyTop, HeavyTops};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use std::path::Path;

#[path = "../../tests/reference/case.rs"]
#[allow(dead_code, reason = "the test reads more of a case")]
mod case;
#[path = "../../tests/reference/free_body.rs"]
#[allow(dead_code, reason = "the test damages it")]
mod free_body;
#[path = "../../tests/reference/top.rs"]
#[allow(dead_code, reason = "the test knows more tops")]
mod top;

use case::{Case, Trouble};

/// The kinds of closed forms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    FreeBody,
    HeavyTop,
}

/// A motion, set up as it is at hand.
pub enum Closed {
    FreeBody(FreeBody),
    HeavyTop(HeavyTop),
}

/// A motion of a reference case.
pub struct Motion {
    pub name: &'static str,
    pub kind: Kind,
    case: Case,
    /// The largest error over eps (|value| + condition) in the case's samples, and what the
    /// suite holds every case to.
    pub factor: f64,
    pub claimed: f64,
}

/// Motions of one kind side by side.
pub enum Many {
    FreeBodies(Vec<FreeBody>),
    HeavyTops(Vec<HeavyTop>),
}

const CASES: [(&str, &str, Kind); 4] = [
    ("free-asym", "free body, m = 0.53", Kind::FreeBody),
    ("free-racket", "free body, 1 - m = 2e-6", Kind::FreeBody),
    ("nd-fig3b", "heavy top, m = 0.063", Kind::HeavyTop),
    ("nd-sleep-tip", "heavy top, 1 - m = 2e-6", Kind::HeavyTop),
];

/// All of them, each held to its 25 digits.
///
/// # Errors
/// A case that is missing, is refused, or is off by more than is claimed.
pub fn motions() -> core::result::Result<Vec<Motion>, String> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/reference.json");
    let mut cases = case::read(&file);
    CASES
        .map(|(id, name, kind)| {
            let found = cases.iter().position(|case| case.id == id);
            let case = cases.swap_remove(found.ok_or_else(|| format!("no case {id}"))?);
            Motion::new(name, kind, case)
        })
        .into_iter()
        .collect()
}

impl Motion {
    fn new(name: &'static str, kind: Kind, case: Case) -> core::result::Result<Self, String> {
        let (outcome, claimed) = match kind {
            Kind::FreeBody => (free_body::closed_form(&case), free_body::BOUND),
            Kind::HeavyTop => (top::dimensionless(&case), top::BOUND),
        };
        let outcome = outcome.map_err(|trouble| format!("{name}: {trouble:?}"))?;
        let factor = outcome.factor;
        if outcome.compared == 0 || !(0.0..=claimed).contains(&factor) {
            return Err(format!("{name}: K = {factor}, and {claimed} is claimed"));
        }
        Ok(Self { name, kind, case, factor, claimed })
    }

    /// Sets the motion up, with an input larger by the part `by`.
    ///
    /// # Errors
    /// As the constructors.
    pub fn set_up(&self, by: f64) -> Result<Closed> {
        let told = |trouble| match trouble {
            Trouble::Refused(error) => error,
            Trouble::Lacks(what) => panic!("{}: {what}", self.name),
        };
        let case = &self.case;
        match self.kind {
            Kind::HeavyTop => {
                top::from_parameters(case, 1.0 + by).map(Closed::HeavyTop).map_err(told)
            }
            Kind::FreeBody => {
                let [i1, i2, i3] = case.input_vector("I").map_err(told)?;
                let omega = case.input_vector("omega0").map_err(told)?;
                let [phi, theta, zeta] = case.input_vector("euler0").map_err(told)?;
                let moments = PrincipalMoments::new(i1, i2, i3)?;
                let start = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
                let omega = BodyVector::from_array(omega.map(|w| w * (1.0 + by)));
                FreeBody::new(moments, start, omega).map(Closed::FreeBody)
            }
        }
    }

    /// As many motions, the inputs of each a little larger.
    ///
    /// # Errors
    /// As the constructors.
    pub fn many(&self, number: u32) -> Result<Many> {
        let (mut bodies, mut tops) = (Vec::new(), Vec::new());
        for k in 0..number {
            match self.set_up(1e-6 * f64::from(k))? {
                Closed::FreeBody(body) => bodies.push(body),
                Closed::HeavyTop(top) => tops.push(top),
            }
        }
        Ok(match self.kind {
            Kind::FreeBody => Many::FreeBodies(bodies),
            Kind::HeavyTop => Many::HeavyTops(tops),
        })
    }
}

impl Closed {
    /// Attitude and body rates at a time.
    #[inline]
    pub fn kinematics(&self, t: f64) -> Kinematics {
        match self {
            Self::FreeBody(body) => body.kinematics(t),
            Self::HeavyTop(top) => top.kinematics(t),
        }
    }

    /// The same at many times.
    ///
    /// # Errors
    /// As that of the closed form.
    pub fn kinematics_at(&self, times: &[f64], states: &mut [Kinematics]) -> Result<()> {
        match self {
            Self::FreeBody(body) => body.kinematics_at(times, states),
            Self::HeavyTop(top) => top.kinematics_at(times, states),
        }
    }

    /// The period of the rates or of the nodding.
    pub fn period(&self) -> f64 {
        match self {
            Self::FreeBody(body) => body.rate_period(),
            Self::HeavyTop(top) => top.nutation_period(),
        }
    }
}

/// Motions in vector registers.
pub enum Together<'a> {
    FreeBodies(FreeBodies<'a>),
    HeavyTops(HeavyTops<'a>),
}

impl Many {
    /// The state of each at a time, one after the other.
    pub fn one_by_one(&self, t: f64, states: &mut [Kinematics]) {
        match self {
            Self::FreeBodies(bodies) => {
                for (body, state) in bodies.iter().zip(states) {
                    *state = body.kinematics(t);
                }
            }
            Self::HeavyTops(tops) => {
                for (top, state) in tops.iter().zip(states) {
                    *state = top.kinematics(t);
                }
            }
        }
    }

    /// The same motions side by side.
    pub fn together(&self) -> Together<'_> {
        match self {
            Self::FreeBodies(bodies) => Together::FreeBodies(FreeBodies::new(bodies)),
            Self::HeavyTops(tops) => Together::HeavyTops(HeavyTops::new(tops)),
        }
    }
}

impl Together<'_> {
    /// The state of each at a time.
    ///
    /// # Errors
    /// As that of the closed form.
    pub fn kinematics(&self, t: f64, states: &mut [Kinematics]) -> Result<()> {
        match self {
            Self::FreeBodies(bodies) => bodies.kinematics(t, states),
            Self::HeavyTops(tops) => tops.kinematics(t, states),
        }
    }
}

/// As many times in a thousand periods.
pub fn times(motion: &Closed, number: u32) -> Vec<f64> {
    let step = 1000.0 * motion.period() / f64::from(number);
    (0..number).map(|k| f64::from(k) * step).collect()
}

/// The batch has the bits of the states one by one.
///
/// # Errors
/// Those of the batch, and if it has not.
pub fn same_bits(
    name: &str,
    one_by_one: &[Kinematics],
    batch: &[Kinematics],
) -> core::result::Result<(), String> {
    let bits = |state: &Kinematics| {
        let rates = state.angular_velocity.to_array().map(f64::to_bits);
        (state.attitude.quaternion().map(f64::to_bits), rates)
    };
    if one_by_one.iter().map(bits).eq(batch.iter().map(bits)) {
        Ok(())
    } else {
        Err(format!("{name}: not the bits of one by one"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_motions_are_as_good_as_claimed_and_a_damaged_one_is_seen() {
        let motions = motions().expect("four motions");
        assert_eq!(motions.len(), 4);
        let mut states = [Kinematics::REST; 20];
        for motion in &motions {
            let many = motion.many(20).expect("motions");
            many.one_by_one(3.0, &mut states);
            let mut together = states;
            many.together().kinematics(3.0, &mut together).expect("20");
            assert_eq!(same_bits(motion.name, &states, &together), Ok(()));
            together[17] = many_changed(&states[17]);
            assert!(same_bits(motion.name, &states, &together).is_err());
        }
    }

    /// A state with a rate that is off by an ulp.
    fn many_changed(state: &Kinematics) -> Kinematics {
        let [p, q, r] = state.angular_velocity.to_array();
        Kinematics::new(state.attitude, BodyVector::new(p, q, r.next_up()))
    }
}
