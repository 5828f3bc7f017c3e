//! A gyroscope one can hold, in SI units: a 0.5 kg disc of 6 cm radius at 3000 turns a
//! minute, 10 cm from its pivot.

use super::Parameters;
use kit::{Report, Result, Table, claim, supported_digits};
use models::heavy_top::{Motion, Nod, Steady};
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{cos, sin};

use core::f64::consts::{PI, TAU};

/// A rotor on a pivot, and how it starts.
#[derive(Debug, Clone, Copy)]
pub struct Rotor {
    /// Moments of inertia across the axis about the pivot, and about the axis (kg m^2).
    pub i1: f64,
    pub i3: f64,
    pub mass: f64,    // kg
    pub gravity: f64, // m/s^2
    pub length: f64,  // from the pivot to the centre of mass, m
    pub theta: f64,   // tilt at the start, rad
    /// The start: angular velocity along the axis, rates of phi and theta (rad/s).
    pub spin: f64,
    pub precession: f64,
    pub nutation: f64,
}

pub const ROTOR: Rotor = Rotor {
    i1: 5.45e-3,
    i3: 9e-4,
    mass: 0.5,
    gravity: 9.80665,
    length: 0.1,
    theta: PI / 3.0,
    spin: 100.0 * PI, // 3000 turns a minute
    precession: 0.0,  // released at rest
    nutation: 0.0,
};

impl Rotor {
    /// Its motion in closed form.
    pub fn motion(&self) -> rotation_dynamics::Result<Motion> {
        let (mass, gravity) = (self.mass, self.gravity);
        let body = SymmetricTop::from_mass(self.i1, self.i3, mass, gravity, self.length)?;
        Motion::new("", HeavyTop::from_body(body, self.tilted(), self.rates())?)
    }

    /// Where it starts.
    pub const fn tilted(&self) -> EulerAngles {
        EulerAngles { phi: 0.0, theta: self.theta, zeta: 0.0 }
    }

    /// How it starts to turn: along the line of nodes, at right angles to it and the axis, and
    /// along the axis.
    pub fn rates(&self) -> BodyVector {
        BodyVector::new(self.nutation, self.precession * sin(self.theta), self.spin)
    }

    /// In slow steady precession at its tilt.
    pub fn steady(&self) -> rotation_dynamics::Result<Steady> {
        let body = RigidBody::new(PrincipalMoments::symmetric(self.i1, self.i3)?);
        let gravity = GravityAtLever::new(self.mass * self.gravity, self.length)?;
        Steady::new(body, gravity, self.theta, self.spin)
    }
}

/// The rotor with what the flags change; `None` if they change nothing.
pub fn asked_for(p: &Parameters) -> Option<Rotor> {
    let mut rotor = ROTOR;
    let fields = [
        (&mut rotor.i1, p.i1),
        (&mut rotor.i3, p.i3),
        (&mut rotor.mass, p.mass),
        (&mut rotor.length, p.length),
        (&mut rotor.theta, p.theta),
        (&mut rotor.spin, p.spin),
        (&mut rotor.precession, p.precession),
        (&mut rotor.nutation, p.nutation),
    ];
    let mut changed = super::driven::is_asked_for(p) || p.gravity != Some(ROTOR.gravity);
    for (field, given) in fields {
        changed |= given.is_some();
        *field = given.unwrap_or(*field);
    }
    rotor.gravity = p.gravity.unwrap_or(0.0);
    changed.then_some(rotor)
}

impl Rotor {
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

    /// The slow steady precession at tilt `theta` with the axial momentum `momentum`, rad/s:
    /// the root of I1 cos(theta) phi'^2 - L_z phi' + m g l = 0 that needs the weight.
    pub fn steady_rate(&self, theta: f64, momentum: f64) -> f64 {
        let weight = self.weight_moment();
        let discriminant = momentum * momentum - 4.0 * self.i1 * weight * cos(theta);
        2.0 * weight / (momentum + discriminant.sqrt())
    }

    /// The least spin with which the axis can precess steadily at its tilt, rad/s.
    pub fn least_spin(&self) -> f64 {
        2.0 * (self.i1 * self.weight_moment() * cos(self.theta)).sqrt() / self.i3
    }

    /// Whether with this spin some L_Z holds the axis at its tilt: equation (4) has the
    /// largest torque against the weight at one b, found by cutting an interval in three.
    fn can_be_held(&self, spin: f64) -> Result<bool> {
        let (a, momentum) = (self.i3 / self.i1, self.i3 * spin);
        let c = self.weight_moment() * self.i3 / (momentum * momentum);
        let falls = |b: f64| {
            Ok::<_, rotation_dynamics::Error>(ReducedTop::new(a, b, c)?.torque(self.theta))
        };
        let (mut low, mut high) = (cos(self.theta), 10.0);
        for _ in 0..100 {
            let third = (high - low) / 3.0;
            if falls(low + third)? < falls(high - third)? {
                high -= third;
            } else {
                low += third;
            }
        }
        Ok(falls(low)? <= 0.0)
    }

    /// The spin at which that begins, rad/s.
    fn least_spin_by_bisection(&self) -> Result<f64> {
        let falls = |spin| Ok::<_, kit::Error>(!self.can_be_held(spin)?);
        Ok(kit::try_bisect([1.0, 1e4], 0.0, falls)?[1])
    }
}

/// Adds the rotor's own claims and the table of leading orders.
pub fn add(report: &mut Report) -> Result<()> {
    const GROUP: &str = "The half-kilogram rotor";
    let (rotor, motion) = (ROTOR, ROTOR.motion()?);
    let (weight, momentum) = (rotor.weight_moment(), rotor.axial_momentum());
    let (s, ratio, exact) = (sin(rotor.theta), rotor.ratio(), &motion.exact);
    let nod = Nod::by_quadrature(&motion.top, motion.energy);
    let period = nod.period * motion.unit;
    let mut table = Table::new("rotor", ["quantity", "unit", "exact", "fast rotor", "formula"])?;
    let mut add = |key: &str, meaning: &str, formula: &str, unit: &str, values: [f64; 3]| {
        let [value, other, leading] = values;
        let digits = |x| supported_digits(x, 1e-5 * value);
        let row =
            [meaning.to_string(), unit.into(), digits(value), digits(leading), formula.into()];
        table.push(row)?;
        let claim = claim(key, meaning, value, unit).within(1e-12).answer(GROUP);
        Ok::<_, kit::Error>(claim.against("quadrature over one nod", other))
    };
    let rate = add(
        "rotor_rate",
        "mean rate of precession",
        "m g l/L_z",
        "rad/s",
        [
            exact.precession_per_period() / exact.nutation_period(),
            nod.precession / period,
            weight / momentum,
        ],
    )?;
    let time = add(
        "rotor_period",
        "time of one nod",
        "2 pi I1/L_z",
        "s",
        [exact.nutation_period(), period, TAU * rotor.i1 / momentum],
    )?;
    let dip = add(
        "rotor_dip",
        "depth of the dip",
        "2 (m g l I1/L_z^2) sin(theta)",
        "rad",
        [exact.theta_max() - exact.theta_min(), nod.theta_max - nod.theta_min, 2.0 * ratio * s],
    )?;
    report.add(rate.slip(
        weight * s / momentum,
        "the torque has a factor sin(theta), and so has the momentum it turns",
    ))?;
    report.add(time.slip(TAU * rotor.i3 / momentum, "that is a turn of the spin"))?;
    report.add(dip.slip(ratio * s, "that is the middle of the nod, half of the dip"))?;
    let least = rotor.least_spin();
    report.add(
        claim(
            "rotor_least_spin",
            "least spin for a steady precession at 60 degrees",
            least,
            "rad/s",
        )
        .within(1e-6)
        .against(
            "bisection: some L_Z holds the axis there or none",
            rotor.least_spin_by_bisection()?,
        )
        .slip(0.5 * least, "the discriminant of a quadratic has a factor 4")
        .answer(GROUP),
    )?;
    report.add(table)?;
    report.add(variations()?)
}

/// What the motions of the page's last section do.
fn variations() -> Result<Table> {
    let columns = ["flag", "least tilt", "greatest tilt", "one nod", "rate of precession"];
    let mut table = Table::new("variations", columns)?;
    for (flag, rotor) in [
        ("none", ROTOR),
        ("--spin 628.3", Rotor { spin: 628.3, ..ROTOR }),
        ("--precession 1.8", Rotor { precession: 1.8, ..ROTOR }),
        ("--spin 60", Rotor { spin: 60.0, ..ROTOR }),
    ] {
        let exact = rotor.motion()?.exact;
        let (period, digits) = (exact.nutation_period(), |x| supported_digits(x, 5e-6));
        table.push([
            flag.into(),
            format!("{} rad", digits(exact.theta_min())),
            format!("{} rad", digits(exact.theta_max())),
            format!("{} s", digits(period)),
            format!("{} rad/s", digits(exact.precession_per_period() / period)),
        ])?;
    }
    Ok(table)
}
