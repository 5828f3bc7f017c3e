//! A gyroscope one can hold, in SI units: a 0.5 kg disc of 6 cm radius at 3000 turns a
//! minute, 10 cm from its pivot.

use super::*;
use kit::supported_digits;
use models::heavy_top::{Added, Stepped};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::SymmetricTop;
use rotation_dynamics::inertia::PrincipalMoments;

/// A rotor on a pivot, and how it starts. SI units.
#[derive(Clone, Copy)]
pub struct Rotor {
    /// Moment of inertia across the axis, about the pivot.
    pub i1: f64,
    pub i3: f64,
    pub mass: f64,
    pub gravity: f64,
    /// From the pivot to the centre of mass.
    pub length: f64,
    pub theta: f64,
    pub spin: f64,
    pub precession: f64,
    pub nutation: f64,
}

/// Whether something is put in that no closed form knows.
pub fn is_driven(p: &Parameters) -> bool {
    [p.friction, p.air, p.bearing].iter().any(Option::is_some)
}

/// The rotor with what the flags change; `None` if they change nothing.
pub fn asked_for(p: &Parameters) -> Option<Rotor> {
    let set = [p.i1, p.i3, p.mass, p.length, p.theta, p.spin, p.precession, p.nutation];
    let weighs = p.gravity == Parameters::default().gravity;
    let unchanged = weighs && !is_driven(p) && set.iter().all(Option::is_none);
    (!unchanged).then(|| Rotor::new(p))
}

/// The rotor with what is put in, stepped for a second.
pub fn driven(p: &Parameters) -> Result<Stepped> {
    let rotor = Rotor::new(p);
    rotor.motion()?; // It refuses what no gyroscope can be.
    let (body, (tilted, rates)) = (rotor.body()?, rotor.start());
    let start = body.state(Attitude::from_euler(tilted)?, rates)?;
    let gravity =
        p.gravity.map(|g| GravityAtLever::new(rotor.mass * g, rotor.length)).transpose()?;
    // A disc of the rotor's mass and moment.
    let radius = (2.0 * rotor.i3 / rotor.mass).sqrt();
    let added = Added { nodes: p.friction, dry: p.bearing, ..Added::default() };
    Stepped::new(body, gravity, added.in_air(p.air, radius, rotor.spin)?, start, 1.0)
}

impl Rotor {
    /// That of the page, released at rest, with what is set.
    pub fn new(p: &Parameters) -> Self {
        Self {
            i1: p.i1.unwrap_or(5.45e-3),
            i3: p.i3.unwrap_or(9e-4),
            mass: p.mass.unwrap_or(0.5),
            gravity: p.gravity.unwrap_or(0.0),
            length: p.length.unwrap_or(0.1),
            theta: p.theta.unwrap_or(PI / 3.0),
            spin: p.spin.unwrap_or(100.0 * PI), // 3000 turns a minute
            precession: p.precession.unwrap_or(0.0),
            nutation: p.nutation.unwrap_or(0.0),
        }
    }

    /// Where it starts, and how it starts to turn: along the line of nodes, at right angles to
    /// it and the axis, and along the axis.
    fn start(&self) -> (EulerAngles, BodyVector) {
        let sideways = self.precession * sin(self.theta);
        let tilted = EulerAngles { phi: 0.0, theta: self.theta, zeta: 0.0 };
        (tilted, BodyVector::new(self.nutation, sideways, self.spin))
    }

    fn body(&self) -> Result<RigidBody> {
        Ok(RigidBody::new(PrincipalMoments::symmetric(self.i1, self.i3)?))
    }

    /// Its motion in closed form.
    pub fn motion(&self) -> Result<Motion> {
        let Self { i1, i3, mass, gravity, length, .. } = *self;
        let (tilted, rates) = self.start();
        let top = SymmetricTop::from_mass(i1, i3, mass, gravity, length)?;
        Ok(Motion::new("", HeavyTop::from_body(top, tilted, rates)?)?)
    }

    /// In slow steady precession at its tilt.
    pub fn steady(&self) -> Result<Steady> {
        let gravity = GravityAtLever::new(self.mass * self.gravity, self.length)?;
        Ok(Steady::new(self.body()?, gravity, self.theta, self.spin)?)
    }

    /// m g l, N m.
    pub fn weight_moment(&self) -> f64 {
        self.mass * self.gravity * self.length
    }

    /// L_z, kg m^2/s.
    pub fn axial_momentum(&self) -> f64 {
        self.i3 * self.spin
    }

    /// c/a = m g l I1/L_z^2: the weight against the spin.
    pub fn ratio(&self) -> f64 {
        let momentum = self.axial_momentum();
        self.weight_moment() * self.i1 / (momentum * momentum)
    }

    /// Whether with this spin some L_Z holds the axis at its tilt: of all b one gives the
    /// largest torque against the weight in equation (4).
    fn can_be_held(&self, spin: f64) -> Result<bool> {
        let momentum = self.i3 * spin;
        let c = self.weight_moment() * self.i3 / (momentum * momentum);
        let a = self.i3 / self.i1;
        let torque = |b| ReducedTop::new(a, b, c).map(|top| top.torque(self.theta));
        let falls = |b| Ok::<_, kit::Error>(torque(b + 0.01)? < torque(b - 0.01)?);
        let [b, _] = try_bisect([cos(self.theta), 10.0], 0.0, falls)?;
        Ok(torque(b)? <= 0.0)
    }
}

/// Adds the rotor's own claims, the table of leading orders, and what the motions of the page's
/// last section do.
pub fn claims(report: &mut Report) -> Result<()> {
    const SUM: &str = "quadrature over one nod";
    let rotor = Rotor::new(&Parameters::default());
    let motion = rotor.motion()?;
    let (weight, momentum, ratio) = (rotor.weight_moment(), rotor.axial_momentum(), rotor.ratio());
    let (s, exact) = (sin(rotor.theta), &motion.exact);
    let rate = exact.precession_per_period() / exact.nutation_period();
    let (time, dip) = (exact.nutation_period(), exact.theta_max() - exact.theta_min());
    let nod = Nod::by_quadrature(&motion.top, motion.energy);
    let period = nod.period * motion.unit;
    // L_z^2 must be 4 I1 m g l cos(theta).
    let least = 2.0 * (rotor.i1 * weight * cos(rotor.theta)).sqrt() / rotor.i3;
    let falls = |spin| Ok::<_, kit::Error>(!rotor.can_be_held(spin)?);
    let [_, held_from] = try_bisect([1.0, 1e4], 0.0, falls)?;
    claims! { report,
        /// mean rate of precession
        rotor_rate: rate, "rad/s", SUM => nod.precession / period, within 1e-12, in "The half-kilogram rotor":
            weight * s / momentum => "the torque has a factor sin(theta), and so has the momentum it turns";
        /// time of one nod
        rotor_period: time, "s", SUM => period, within 1e-12, in "The half-kilogram rotor":
            TAU * rotor.i3 / momentum => "that is a turn of the spin";
        /// depth of the dip
        rotor_dip: dip, "rad", SUM => nod.theta_max - nod.theta_min, within 1e-12, in "The half-kilogram rotor":
            ratio * s => "that is the middle of the nod, half of the dip";
        /// least spin for a steady precession at 60 degrees
        rotor_least_spin: least, "rad/s", "bisection: some L_Z holds the axis there or none" => held_from, within 1e-6,
        in "The half-kilogram rotor":
            0.5 * least => "the discriminant of a quadratic has a factor 4";
    }?;
    let columns = ["quantity", "unit", "exact", "fast rotor", "formula"];
    let rows = [
        ("mean rate of precession", "rad/s", rate, weight / momentum, "m g l/L_z"),
        ("time of one nod", "s", time, TAU * rotor.i1 / momentum, "2 pi I1/L_z"),
        ("depth of the dip", "rad", dip, 2.0 * ratio * s, "2 (m g l I1/L_z^2) sin(theta)"),
    ];
    report.add(Table::of(
        "rotor",
        columns,
        rows,
        |(quantity, unit, value, leading, formula)| {
            let [value, leading] = [value, leading].map(|x| supported_digits(x, 1e-5 * value));
            Ok([quantity, unit, &value, &leading, formula].map(String::from))
        },
    )?)?;
    let columns = ["flag", "least tilt", "greatest tilt", "one nod", "rate of precession"];
    let changes = [
        ("none", rotor),
        ("--spin 628.3", Rotor { spin: 628.3, ..rotor }),
        ("--precession 1.8", Rotor { precession: 1.8, ..rotor }),
        ("--spin 60", Rotor { spin: 60.0, ..rotor }),
    ];
    report.add(Table::of("variations", columns, changes, |(flag, rotor)| {
        let exact = rotor.motion()?.exact;
        let (period, walk) = (exact.nutation_period(), exact.precession_per_period());
        let nod = [(exact.theta_min(), "rad"), (exact.theta_max(), "rad"), (period, "s")];
        let told = |(x, unit)| format!("{} {unit}", supported_digits(x, 5e-6));
        let cells = nod.into_iter().chain([(walk / period, "rad/s")]).map(told);
        Ok(core::iter::once(flag.to_owned()).chain(cells))
    })?)
}
