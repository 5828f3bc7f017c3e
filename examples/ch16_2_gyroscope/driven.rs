//! The rotor with what `--with` puts in. No closed form knows it, so it is stepped.

use super::Parameters;
use super::rotor::{ROTOR, asked_for};
use kit::{Report, Result};
use models::heavy_top::{Added, Stepped};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::inertia::PrincipalMoments;

/// Whether something is put in that no closed form knows.
pub fn is_asked_for(p: &Parameters) -> bool {
    [p.friction, p.air, p.bearing].iter().any(Option::is_some)
}

/// The rotor with what is put in, for a second.
pub fn rotor(p: &Parameters) -> Result<Stepped> {
    let rotor = asked_for(p).unwrap_or(ROTOR);
    // It refuses what no gyroscope can be.
    rotor.motion()?;
    let body = RigidBody::new(PrincipalMoments::symmetric(rotor.i1, rotor.i3)?);
    let start = body.state(Attitude::from_euler(rotor.tilted())?, rotor.rates())?;
    let gravity = |g| GravityAtLever::new(rotor.mass * g, rotor.length);
    // A disc of the rotor's mass and moment.
    let radius = (2.0 * rotor.i3 / rotor.mass).sqrt();
    let added = Added { nodes: p.friction, dry: p.bearing, ..Added::default() }
        .in_air(p.air, radius, rotor.spin)?;
    Stepped::new(body, p.gravity.map(gravity).transpose()?, added, start, 1.0)
}

/// Where it ends, and what each effect has done.
pub fn report(p: &Parameters) -> Result<Report> {
    let names = ["bearing of the line of nodes", "air on the rotor", "bearings of the axle"];
    rotor(p)?.report(["The gyroscope", "a rotor"], p.tolerance, names)
}
