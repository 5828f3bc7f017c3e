//! The body with what `--with` puts in. No closed form knows it, so it is stepped.

use super::{Parameters, TOP, WHEEL};
use kit::interval::between;
use kit::{Report, Result};
use models::heavy_top::{Added, Stepped};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::inertia::PrincipalMoments;

/// Whether something is put in that no closed form knows.
pub fn is_asked_for(p: &Parameters) -> bool {
    [p.friction, p.air, p.brake].iter().any(Option::is_some)
}

/// How long it is followed, s.
const SPAN: f64 = 1.0;

/// The body asked for with what is put in, for a second.
pub fn body(p: &Parameters) -> Result<Stepped> {
    let (body, radius) = match p.body {
        "wheel" => (p.applied_to(WHEEL), 0.35),
        _ => (p.applied_to(TOP), 0.0283),
    };
    let rigid = RigidBody::new(PrincipalMoments::symmetric(body.moment(), body.i3)?);
    let start = rigid.state(Attitude::from_euler(body.tilted())?, body.rates())?;
    if let Some(brake) = p.brake {
        let most = body.i3 * body.spin.abs() / SPAN;
        let turns = between(0.0, most).because("more stops the spin in the time that is looked at");
        turns.check("brake", brake)?;
    }
    let gravity = |g| GravityAtLever::new(body.mass * g, body.length);
    let added = Added { nodes: p.friction, dry: p.brake, ..Added::default() }
        .in_air(p.air, radius, body.spin)?;
    Stepped::new(rigid, p.gravity.map(gravity).transpose()?, added, start, SPAN)
}

/// Where it ends, and what each effect has done.
pub fn report(p: &Parameters) -> Result<Report> {
    let names = ["bearing of the line of nodes", "air", "dry friction against the spin"];
    body(p)?.report(["The top and the bicycle wheel", "a body"], p.tolerance, names)
}
