//! What a scene keeps, the integrators keep; and nothing else is claimed.
//!
//! `Scene::invariants` names the quantities, the tests below run over exactly
//! those. Splittings keep L_Z, L_z and the unit quaternion to round-off and the
//! energy without drift; the general methods keep all of them to their tolerance.

mod effects;
mod long_runs;
mod scenes;
