#![doc = include_str!("README.md")]
//!
//! # Which way to take
//!
//! | you have | take | you get |
//! |---|---|---|
//! | a free body, a heavy symmetric top, a pendulum | a closed form: [`FreeBody`], [`HeavyTop`], [`Pendulum`] | any time at the same price, to round-off times the condition; batches in vector registers |
//! | a body under effects, and an error in mind | [`Scene::solve`](scene::Scene::solve), [`solve_at`](scene::Scene::solve_at), [`solve_along`](scene::Scene::solve_along) | the attitude within the tolerance, or the reason why not; no step to choose |
//! | the same, and events to find | `solve_along`, then [`crossings`](accuracy::SolvedMotion::crossings) | their times, with an estimate of the error |
//! | a fixed price per step, or a loop that feeds back | a stepper: [`GaussLegendre`], [`Splitting`], [`Rk4`] on the scene ([`Integrator`]) | steps of your choice; the error is yours to measure ([`accuracy`]) |
//! | equations of your own | [`ode`](integrators::ode) or [`second_order`](integrators::second_order), by [`Dop853`] | dense output, located events |
//! | rates that a gyroscope recorded in free flight | [`Flight::fit`](fit::Flight::fit) | ratios of moments of inertia with intervals, and which corrections the rates need |
//! | contacts and impacts in a plane | [`planar`] | phases, impacts and rest, each located |
//!
//! If it is not clear which: `solve`. It takes the closed form where the scene has one.
//! A torque that jumps with the state, such as a relay, is for
//! [`Torque::sampled`](effects::Torque::sampled) or [`Switched`](effects::Switched).
//!
//! [`FreeBody`]: exact::free_body::FreeBody
//! [`HeavyTop`]: exact::heavy_top::HeavyTop
//! [`Pendulum`]: exact::pendulum::Pendulum
//! [`GaussLegendre`]: integrators::GaussLegendre
//! [`Splitting`]: integrators::Splitting
//! [`Rk4`]: integrators::Rk4
//! [`Integrator`]: integrators::Integrator
//! [`Dop853`]: integrators::Dop853
//!
//! # Coming from elsewhere
//!
//! An [`Attitude`](attitude::Attitude) turns components on the body's axes into components on the
//! fixed axes. Angles are in radians, axes are right-handed.
//!
//! ## From scipy's `Rotation`
//!
//! scipy has the scalar last. Capital letters there are turns about carried axes, as here; small
//! letters are turns about fixed axes, here the same turns in the opposite order.
//!
//! | scipy | here |
//! |---|---|
//! | `from_quat(q)`, `as_quat()` | [`from_xyzw`](attitude::Attitude::from_xyzw), [`xyzw`](attitude::Attitude::xyzw) |
//! | `from_matrix(m)`, `as_matrix()` | [`from_matrix`](attitude::Attitude::from_matrix), which refuses what is no rotation, or [`nearest`](attitude::Attitude::nearest); [`matrix`](attitude::Attitude::matrix) |
//! | `from_rotvec(v)`, `as_rotvec()` | [`from_rotation_vector`](attitude::Attitude::from_rotation_vector), [`rotation_vector`](attitude::Attitude::rotation_vector) |
//! | `from_mrp(p)`, `as_mrp()` | [`from_modified_rodrigues`](attitude::Attitude::from_modified_rodrigues), [`modified_rodrigues`](attitude::Attitude::modified_rodrigues) |
//! | `from_euler("ZYX", a)`, `as_euler("ZYX")` | [`from_sequence`](attitude::Attitude::from_sequence), [`angles`](attitude::Attitude::angles) with `Sequence::Zyx` |
//! | `r.apply(v)`, `r.inv().apply(v)` | [`to_space`](attitude::Attitude::to_space), [`to_body`](attitude::Attitude::to_body) |
//! | `p * q`, `r.inv()`, `r.magnitude()` | `p * q`, [`inverse`](attitude::Attitude::inverse), [`angle_to`](attitude::Attitude::angle_to) the identity |
//! | `Slerp`, `r.mean()`, `align_vectors(a, b)` | [`Arcs`](attitude::Arcs) or [`toward`](attitude::Attitude::toward), [`mean`](attitude::Attitude::mean), [`from_directions`](attitude::Attitude::from_directions) |
//!
//! ```
//! use rotation_dynamics::attitude::{Attitude, Sequence};
//! use rotation_dynamics::frame::BodyVector;
//! # fn main() -> rotation_dynamics::Result<()> {
//! // Rotation.from_euler("xyz", [0.1, 0.2, 0.3]): fixed axes, so the turns in the opposite order.
//! let [a, b, c] = [0.1, 0.2, 0.3];
//! let r = Attitude::from_sequence(Sequence::Zyx, [c, b, a])?;
//! // What scipy 1.17 prints for r.as_quat() and r.apply([1, 2, 3]).
//! let quaternion = [0.034270798550482096, 0.10602051106179562, 0.1435721750273919, 0.9833474432563558];
//! let applied = [1.0411536583867151, 2.0916086087501053, 2.922528440824898];
//! let turned = r.to_space(BodyVector::new(1.0, 2.0, 3.0));
//! let here = r.xyzw().into_iter().chain(turned.to_array());
//! for (here, scipy) in here.zip(quaternion.into_iter().chain(applied)) {
//!     assert!((here - scipy).abs() < 1e-15);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! ## From a game engine's state
//!
//! Engines hold `f32`, the scalar last, angular velocity on the fixed axes, and often Y up. Here
//! the effects of gravity pull along -Z. Rename the axes of space and body alike, in cyclic order:
//!
//! ```
//! use rotation_dynamics::attitude::Attitude;
//! use rotation_dynamics::body::RigidBody;
//! use rotation_dynamics::frame::SpaceVector;
//! use rotation_dynamics::inertia::PrincipalMoments;
//! use rotation_dynamics::scene::Scene;
//! # fn main() -> rotation_dynamics::Result<()> {
//! // Right-handed with Y up (Bevy, Godot, three.js): their z, x, y are our x, y, z.
//! let ours = |[x, y, z]: [f32; 3]| [z, x, y].map(f64::from);
//! let rotation = [0.0_f32, 0.38268343, 0.0, 0.92387953]; // x, y, z, w: 45 degrees about the vertical
//! let angular_velocity = [0.1_f32, 2.0, 0.0]; // rad/s, on the fixed axes
//! let inertia = [0.2_f32, 0.5, 0.4]; // kg m^2, on the body's axes
//!
//! let [x, y, z] = ours([rotation[0], rotation[1], rotation[2]]);
//! let attitude = Attitude::from_xyzw([x, y, z, rotation[3].into()])?;
//! assert!((attitude.yaw_pitch_roll().yaw.to_degrees() - 45.0).abs() < 1e-5);
//! let [i1, i2, i3] = ours(inertia);
//! let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3)?);
//! let start = body.state(attitude, attitude.to_body(SpaceVector::from(ours(angular_velocity))))?;
//! let end = Scene::new(body).solve(&start, 0.5, 1e-7)?.state;
//! let theirs = |attitude: Attitude| {
//!     let [x, y, z, w] = attitude.xyzw();
//!     [y, z, x, w].map(|c| c as f32)
//! };
//! println!("after half a second: {:?}", theirs(end.attitude));
//! for (back, given) in theirs(attitude).into_iter().zip(rotation) {
//!     assert!((back - given).abs() < 1e-7);
//! }
//!
//! // Left-handed with Y up (Unity): y and z change places, and what turns changes its sign. A
//! // quarter turn about Y there takes forward (z, our y) to the right (x).
//! let ours = |[x, y, z]: [f32; 3]| [-x, -z, -y].map(f64::from);
//! let [x, y, z] = ours([0.0, 0.70710677, 0.0]);
//! let quarter = Attitude::from_xyzw([x, y, z, 0.70710677])?;
//! assert!((quarter.matrix()[0][1] - 1.0).abs() < 1e-6);
//! # Ok(())
//! # }
//! ```
//!
//! A body that is drawn on other axes than its principal ones is a
//! [`DesignedBody`](body::DesignedBody), which finds the axes from its tensor.
//!
//! ## From Euler angles in degrees
//!
//! ```
//! use rotation_dynamics::attitude::{Attitude, Sequence, YawPitchRoll};
//! # fn main() -> rotation_dynamics::Result<()> {
//! let [yaw, pitch, roll] = [30.0_f64, -10.0, 5.0].map(f64::to_radians);
//! let attitude = Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll })?;
//! let degrees = attitude.angles(Sequence::Zyx).map(f64::to_degrees);
//! for (back, given) in degrees.into_iter().zip([30.0, -10.0, 5.0]) {
//!     assert!((back - given).abs() < 1e-13);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! Other orders are a [`Sequence`](attitude::Sequence); the angles of textbooks, z-x'-z'', are
//! [`EulerAngles`](attitude::EulerAngles). Where a pole is a rounding away,
//! [`angles_locked`](attitude::Attitude::angles_locked) takes it for the pole.
//!
//! ## From nalgebra, and through it
//!
//! Vectors are `From` and `Into` [`nalgebra`]'s `Vector3`. An attitude is `Into` its
//! `UnitQuaternion` and `Rotation3`, and `TryFrom` them, because unchecked ones can hold anything.
//! The features `convert-mint`, `convert-glam*` and `convert-bytemuck` of `nalgebra` 0.35 lead on to
//! other crates.
//!
//! ```
//! use rotation_dynamics::attitude::Attitude;
//! use rotation_dynamics::frame::{BodyVector, SpaceVector};
//! use rotation_dynamics::nalgebra::{Rotation3, UnitQuaternion, Vector3};
//! # fn main() -> rotation_dynamics::Result<()> {
//! let theirs = UnitQuaternion::from_euler_angles(0.1, 0.2, 0.3);
//! let ours = Attitude::try_from(theirs)?;
//! let turned: Vector3<f64> = ours.to_space(BodyVector::from(Vector3::new(1.0, 2.0, 3.0))).into();
//! assert!((turned - theirs * Vector3::new(1.0, 2.0, 3.0)).norm() < 1e-15);
//! assert!((Rotation3::from(ours).matrix() - theirs.to_rotation_matrix().matrix()).norm() < 1e-15);
//! assert_eq!(UnitQuaternion::from(ours), theirs);
//! assert_eq!(SpaceVector::from(turned).to_array(), <[f64; 3]>::from(turned));
//! # Ok(())
//! # }
//! ```
//!
//! # The modules
//!
//! Bottom to top; each depends only on those above it in this list.
//!
//! | module | what it holds |
//! |---|---|
//! | [`math`] | the only door to elementary functions (`libm`), and double-double arithmetic |
//! | [`error`] | one error type; every variant carries the offending numbers |
//! | [`frame`] | vectors on space-fixed, body-fixed and design axes as types |
//! | [`attitude`] | unit quaternion, Euler angles z-x'-z'' and the other conventions, rotation vector |
//! | [`inertia`] | tensor, principal moments and axes, parallel axes, solids |
//! | [`body`] | a rigid body and its state, on principal axes or on those of its drawing |
//! | `documents` | values to and from documents (feature `serde`) |
//! | [`motion`] | what every motion can be asked, closed form or solved |
//! | [`effects`] | what acts on a body, one file per effect |
//! | [`scene`] | body, effects and initial state together |
//! | [`exact`] | elliptic functions and closed-form solutions |
//! | [`integrators`] | one method per file, coefficients as data |
//! | [`accuracy`] | errors against the exact motion, and what they cost |
//! | [`planar`] | one-axis scenes with contacts and located events |
//!
//! Where these docs name a file, as in "measured in `tests/…`" or "`benches/record/…`", it is in the
//! repository: the tests, the records and the book are not in the package. "The notes" are two
//! chapters of lecture notes on rigid bodies, which the book goes with.
//!
//! # Notation
//!
//! | symbol | identifier | unit | frame |
//! |---|---|---|---|
//! | R | `attitude` ([`attitude::Attitude`]) | | body to space |
//! | phi, theta, zeta | [`attitude::EulerAngles`] | rad | z-x'-z'': precession, tilt, spin |
//! | omega | `angular_velocity` ([`frame::BodyVector`]) | rad/s | body |
//! | L | `angular_momentum` ([`frame::SpaceVector`]) in a [`body::State`] | kg m^2/s | space |
//! | L on the body's axes | [`body::RigidBody::angular_momentum`] | kg m^2/s | body |
//! | I1, I2, I3 | [`inertia::PrincipalMoments`] | kg m^2 | body |
//! | I | [`inertia::InertiaTensor`] | kg m^2 | the axes of a drawing |
//! | torque | [`effects::Effect::torque`] | N m | space |
//! | T, U, E | `kinetic_energy`, `potential_energy`, `energy` | J | |
//! | m g, l | `weight`, `lever` ([`effects::GravityAtLever`]) | N, m | along -Z, along e3 |
//! | t | `t`, `t_start`, `t_end` | s | |

#![warn(missing_docs)]
// But for vector registers, in `math::lane` and where it is called.
#![deny(unsafe_code)]

pub mod accuracy;
pub mod attitude;
pub mod body;
#[cfg(feature = "serde")]
pub mod documents;
pub mod effects;
pub mod error;
pub mod exact;
pub mod fit;
pub mod frame;
pub mod inertia;
pub mod integrators;
pub mod math;
pub mod motion;
pub mod planar;
pub mod scene;
mod written;

pub use error::{Error, Result};
/// Vectors and attitudes convert from and to its types.
pub use nalgebra;

/// What a program sends to its threads or shares between them. (A `SolvedMotion` stays in the thread
/// that solved it: it borrows effects of any type.)
const _: fn() = || {
    fn threads<T: Send + Sync>() {}
    threads::<(Error, attitude::Attitude, attitude::Arcs, frame::SpaceVector)>();
    threads::<(body::RigidBody, body::DesignedBody, body::State, inertia::InertiaTensor)>();
    threads::<(exact::free_body::FreeBody, exact::heavy_top::HeavyTop, exact::pendulum::Pendulum)>(
    );
    threads::<(effects::Torque<'_>, effects::Switched<'_>, effects::EffectList)>();
    threads::<scene::Scene<(((), effects::GravityAtLever), effects::Torque<'_>)>>();
    threads::<(accuracy::Limits<'_>, accuracy::Solved, accuracy::Crossing)>();
    threads::<(integrators::Dop853, integrators::GaussLegendre, integrators::Splitting)>();
};
