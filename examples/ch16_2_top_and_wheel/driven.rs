//! The body with what `--with` puts in. No closed form knows it, so it is stepped.

use super::{Parameters, TOP, WHEEL};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{DiscDrag, GravityAtLever};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::report::Report;
use rotation_dynamics::report::heavy_top::{Added, Stepped};

/// Whether something is put in that no closed form knows.
pub fn is_asked_for(p: &Parameters) -> bool {
    [p.friction, p.air, p.brake].iter().any(Option::is_some)
}

/// The body asked for with what is put in, for a second.
pub fn body(p: &Parameters) -> Result<Stepped> {
    let (body, radius) = match p.body {
        "wheel" => (p.applied_to(WHEEL), 0.35),
        _ => (p.applied_to(TOP), 0.0283),
    };
    let rigid = RigidBody::new(PrincipalMoments::symmetric(body.moment(), body.i3)?);
    let start = rigid.state(Attitude::from_euler(body.tilted())?, body.rates())?;
    let gravity = |g| GravityAtLever::new(body.mass * g, body.length);
    // What is thinner is as viscous, so that nu goes with 1/density.
    let air = |density| {
        let viscosity = DiscDrag::AIR_VISCOSITY * (DiscDrag::AIR_DENSITY / density);
        DiscDrag::new(radius, density, viscosity, body.spin)
    };
    let added = Added {
        nodes: p.friction,
        air: p.air.map(air).transpose()?,
        dry: p.brake,
    };
    Stepped::new(
        rigid,
        p.gravity.map(gravity).transpose()?,
        added,
        start,
        1.0,
    )
}

/// Where it ends, and what each effect has done.
pub fn report(p: &Parameters) -> Result<Report> {
    let mut report = Report::new(
        "The top and the bicycle wheel",
        "a body with what --with puts in, for a second: stepped; nods, turning points and the strip, \
         which need the closed form, are left out",
    )?;
    let (body, names) = (
        body(p)?,
        [
            "bearing of the line of nodes",
            "air",
            "dry friction against the spin",
        ],
    );
    report.add(body.claims(p.tolerance)?)?;
    report.add(body.ledger(p.tolerance, names)?)?;
    Ok(report)
}
