//! Rigid-body rotation, executable.
//!
//! The modules, bottom to top; each depends only on those above it in this list.
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
//! The pages of the book are made by another crate, `kit` (`book/kit`), which uses this one.
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
//!
//! # Three programs
//!
//! (The book's page "The library alone" says more of each: `examples/library.rs`.)
//!
//! A satellite for a day under the gradient of gravity, to 1e-8 rad all the way:
//!
//! ```
//! use rotation_dynamics::accuracy::Limits;
//! use rotation_dynamics::attitude::Attitude;
//! use rotation_dynamics::body::RigidBody;
//! use rotation_dynamics::effects::GravityGradient;
//! use rotation_dynamics::frame::{BodyVector, SpaceVector};
//! use rotation_dynamics::inertia::PrincipalMoments;
//! use rotation_dynamics::scene::Scene;
//! # fn main() -> rotation_dynamics::Result<()> {
//! let n0 = 1.1e-3; // one orbit in 95 minutes
//! let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
//! let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
//! let scene = Scene::new(body).with(GravityGradient::on_orbit(n0, normal, down)?);
//! // Its long axis hangs a little askew: it will swing about the vertical.
//! let askew = Attitude::about_space_axis(normal, 0.1)?;
//! let start = body.state(askew, BodyVector::new(0.0, 0.0, n0))?;
//! let hours: Vec<f64> = (1..=24).map(|hour| 3600.0 * f64::from(hour)).collect();
//! let day = scene.solve_at(&start, &hours, 1e-8, &Limits::default())?;
//! for (t, state) in hours.iter().zip(&day) {
//!     let upright = Attitude::about_space_axis(normal, n0 * t)?;
//!     // It swings by no more than it began with.
//!     assert!(state.attitude.angle_to(&upright) < 0.1 + 1e-8);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! A heavy top at one time, in closed form:
//!
//! ```
//! use rotation_dynamics::attitude::{Attitude, EulerAngles};
//! use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
//! use rotation_dynamics::frame::BodyVector;
//! # fn main() -> rotation_dynamics::Result<()> {
//! let top = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?;
//! let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
//! let motion = HeavyTop::new(top, tilted, BodyVector::new(0.0, 0.0, 314.0))?;
//! let angles = motion.angles(60.0);
//! assert!(motion.theta_min() <= angles.theta && angles.theta <= motion.theta_max());
//! # Ok(())
//! # }
//! ```
//!
//! An effect of one's own beside one of the library's, to 1e-9 rad or a reason why not:
//!
//! ```
//! use rotation_dynamics::attitude::{Attitude, EulerAngles};
//! use rotation_dynamics::body::RigidBody;
//! use rotation_dynamics::effects::{GravityAtLever, Torque};
//! use rotation_dynamics::frame::BodyVector;
//! use rotation_dynamics::inertia::PrincipalMoments;
//! use rotation_dynamics::scene::Scene;
//! # fn main() -> rotation_dynamics::Result<()> {
//! let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
//! let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
//! let start = body.state(tilted, BodyVector::new(0.0, 0.0, 100.0))?;
//! // A motor that drives the rotor, from its own axis.
//! let motor = Torque::on_body("motor", |_t, _body, _state| BodyVector::new(0.0, 0.0, 0.18))
//!     .smooth();
//! let scene = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?).with(motor);
//! let solved = scene.solve(&start, 1.0, 1e-9)?;
//! let spin = body.angular_velocity(&solved.state).z();
//! // I3 omega_3 grows by the torque times the time.
//! assert!((spin - (100.0 + 0.18 / 9.0e-4)).abs() < 1e-9 * spin);
//! assert!(scene.solve(&start, 1.0, 1e-15).is_err());
//! # Ok(())
//! # }
//! ```

pub mod accuracy;
pub mod attitude;
pub mod body;
#[cfg(feature = "serde")]
pub mod documents;
pub mod effects;
pub mod error;
pub mod exact;
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
