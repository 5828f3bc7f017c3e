//! Many free bodies at one time.

use super::asymmetric::Form;
use super::hyperbolic::Late;
use super::sample::{Sampler, placed};
use super::symmetric::Symmetric;
use super::{FreeBody, Motion};
use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::error::{Result, known};
use crate::exact::batch::Blocks;
use crate::exact::check_length;
use crate::frame::BodyVector;
use crate::math::lane::Row;

/// Bodies that are asked for their states at one time after the other: side by side in vector
/// registers, each kind of motion with its own.
///
/// For 512 tumbling bodies one by one, a state takes 2.7 times as long as together with AVX-512 and
/// 2.1 times as long as with AVX2. Beside their middle axes it is 2.9 and 2.3 times (`benches`,
/// binary `batch`). Bodies that a cache does not hold, some 400 bytes each, take the time in which
/// memory brings them.
///
/// ```
/// # use rotation_dynamics::{attitude::Attitude, body::Kinematics};
/// # use rotation_dynamics::exact::free_body::{FreeBodies, FreeBody};
/// # use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments};
/// let bodies = (0..1000)
///     .map(|k| {
///         let moments = PrincipalMoments::new(1.0, 2.0, 2.5 + 1e-4 * f64::from(k))?;
///         FreeBody::new(moments, Attitude::IDENTITY, BodyVector::new(0.8, 0.4, 0.3))
///     })
///     .collect::<Result<Vec<_>, _>>()?;
/// let together = FreeBodies::new(&bodies);
/// let mut states = vec![Kinematics::REST; bodies.len()];
/// together.kinematics(12.0, &mut states)?;
/// assert_eq!(states[999], bodies[999].kinematics(12.0));
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct FreeBodies<'a> {
    bodies: &'a [FreeBody],
    symmetric: Blocks<Symmetric<Row>>,
    tumbling: Blocks<Sampler<Row>>,
    late: Blocks<Late<Row>>,
    /// The place of each body's axes on the axes on which its rates are found.
    places: Vec<[usize; 3]>,
    /// The greatest |t| at which the phases of all are known.
    latest: f64,
}

impl<'a> FreeBodies<'a> {
    /// Copies what samples need of the motions, side by side.
    pub fn new(bodies: &'a [FreeBody]) -> Self {
        let (mut symmetric, mut tumbling, mut late) = (Vec::new(), Vec::new(), Vec::new());
        let mut places = Vec::with_capacity(bodies.len());
        for (number, body) in bodies.iter().enumerate() {
            places.push(match &body.motion {
                Motion::Steady(motion) | Motion::Symmetric(motion) => {
                    symmetric.push((number, *motion));
                    motion.place
                }
                Motion::Asymmetric(motion) => match &motion.form {
                    Form::Trigonometric(sampler) => {
                        tumbling.push((number, *sampler));
                        sampler.rates.place
                    }
                    Form::Hyperbolic(motion) => {
                        late.push((number, *motion));
                        motion.rates.place
                    }
                },
            });
        }
        Self {
            bodies,
            symmetric: Blocks::new(&symmetric),
            tumbling: Blocks::new(&tumbling),
            late: Blocks::new(&late),
            places,
            latest: bodies.iter().fold(f64::MAX, |t, body| t.min(body.latest())),
        }
    }

    /// The bodies.
    pub const fn bodies(&self) -> &'a [FreeBody] {
        self.bodies
    }

    /// Attitude and body rates of each body at time `t` (s), in their order: the bits of
    /// [`FreeBody::kinematics`]. Nothing is allocated.
    ///
    /// # Errors
    /// `Lengths` if there are not as many states as bodies; for a time as
    /// [`FreeBody::try_kinematics`] of the body that is known for the shortest time. No state is
    /// touched then.
    pub fn kinematics(&self, t: f64, states: &mut [Kinematics]) -> Result<()> {
        check_length("states", states.len(), self.bodies.len())?;
        known(t, self.latest)?;
        let near = |number: usize, [w, x, y, z, p, q, r]: [f64; 7]| {
            let rates = placed(self.places[number], [p, q, r]);
            Kinematics::new(Attitude::from_unit([w, x, y, z]), BodyVector::from_array(rates))
        };
        let far = |number: usize| self.bodies[number].kinematics(t);
        self.symmetric.fill(t, states, near, far);
        self.tumbling.fill(t, states, near, far);
        self.late.fill(t, states, near, far);
        Ok(())
    }
}
