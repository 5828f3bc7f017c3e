//! The models that pages are about, written with the public items of library and kit alone.
//!
//! | module | pages | what it holds |
//! |---|---|---|
//! | [`by_closures`] | `hard_cases`, and tests of contacts | small motions in a plane, written as closures |
//! | [`gimbals`] | `effects_1_gyroscope` | a rotor in a ring and a fork that have inertia, and friction in their bearings |
//! | [`heavy_top`] | `ch16_2_gyroscope`, `ch16_2_top_and_wheel`, `effects` | a heavy symmetric top: its numbers by three routes, its figures |
//! | [`ladder`] | `ch16_ex6_ladder` | the sliding ladder, in closed form |
//! | [`naive`] | `hard_cases`, and the reference of the tests | what everyone writes first, and where it breaks |
//! | [`plank`] | `ch15_3_plank` | a plank that falls over on a smooth floor, in closed form |
//! | [`swings`] | `ch16_ex7_rod_and_disc` | a phone's recording of a swing: the pendulum that fits it |
//! | [`throws`] | `further_1_phone` | a phone's recording of a throw: the free body that fits it, its table, its figures |
//! | [`tops`] | `effects_2_top` | tops on a rounded tip that slides, creeps and rolls, from throw to fall |
//! | [`truth`] | `hard_cases`, and attacks of the tests | a body that turns, to some thirty digits |
//! | [`wedge`] | `ch16_1_incline` | a cylinder on the slope of a wedge, drawn |

pub mod by_closures;
pub mod gimbals;
pub mod heavy_top;
pub mod ladder;
pub mod naive;
pub mod plank;
pub mod swings;
pub mod throws;
pub mod tops;
pub mod truth;
pub mod wedge;
