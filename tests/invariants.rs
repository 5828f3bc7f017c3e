//! What a scene keeps, the integrators keep; and nothing else is claimed.
//!
//! `Scene::invariants` names the quantities, the tests below run over exactly
//! those. Splittings keep L_Z, L_z and the unit quaternion to round-off and the
//! energy without drift; the general methods keep all of them to their tolerance.

#[path = "invariants/effects.rs"]
mod effects;
#[path = "invariants/long_runs.rs"]
mod long_runs;
#[path = "invariants/scenes.rs"]
mod scenes;
#[path = "convergence/top.rs"]
mod top;
