//! What acts on a gyroscope on a desk beside its weight.

use super::*;
use core::f64::consts::{FRAC_PI_3, PI};
use rotation_dynamics::Result;
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Properties, Torque};

/// Angular velocity of the Earth against the stars, rad/s, and its mean radius, m.
pub const EARTH: f64 = 7.292_115e-5;
pub const EARTH_RADIUS: f64 = 6.371e6;
const GRAVITY: f64 = 9.80665;
/// Density of steel, kg/m^3.
const STEEL: f64 = 7850.0;

/// A rotor or a top, and what its surroundings are made of.
#[derive(Debug, Clone, Copy)]
pub struct Spinner {
    /// Moments across and along the axis about the fixed point, kg m^2.
    pub moments: [f64; 2],
    pub mass: f64,
    /// From the fixed point to the centre of mass, and of the disc, m.
    pub lever: f64,
    pub radius: f64,
    pub tilt: f64,
    pub spin: f64,
    /// Dry friction about the axis, N m.
    pub bearing: f64,
    /// Friction of the vertical pivot, N m; 0 if it has none.
    pub pivot: f64,
    /// Of what it is made, kg/m^3.
    pub density: f64,
}

/// The half-kilogram gyroscope of the page on section 16.2 (3): a ball bearing with
/// mu = 0.0015 at 2 mm.
pub fn gyroscope(p: &Parameters) -> Spinner {
    Spinner {
        moments: [5.45e-3, 9e-4],
        mass: 0.5,
        lever: 0.1,
        radius: 0.06,
        tilt: FRAC_PI_3,
        spin: p.spin,
        bearing: 0.0015 * 0.5 * GRAVITY * 2e-3,
        pivot: p.pivot,
        density: STEEL,
    }
}

/// The wooden top of the page on other gyroscopes, on a tip that neither slides nor rolls;
/// the tip drills with mu = 0.2 on a contact of 19 micrometres (Hertz, a tip of 1 mm).
pub fn toy_top() -> Spinner {
    let (mass, lever, across) = (0.1, 0.04, 4e-5);
    Spinner {
        moments: [across + mass * lever * lever, 4e-5],
        mass,
        lever,
        radius: 0.0283,
        tilt: 0.4,
        spin: 150.0,
        bearing: 3.0 * PI / 16.0 * 0.2 * mass * GRAVITY * 1.95e-5,
        pivot: 0.0,
        density: 700.0,
    }
}

impl Spinner {
    /// The scene with its weight alone, released with its axis at rest.
    pub fn scene(&self) -> Result<(Scene<Weight>, State)> {
        let [across, along] = self.moments;
        let body = RigidBody::new(PrincipalMoments::symmetric(across, along)?);
        let weight = GravityAtLever::new(self.mass * GRAVITY, self.lever)?;
        let (phi, theta, zeta) = (0.0, self.tilt, 0.0);
        let tilted = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
        let start = body.state(tilted, BodyVector::new(0.0, 0.0, self.spin))?;
        Ok((Scene::new(body).with(weight), start))
    }

    /// Still air, on both faces of its disc.
    pub fn air(&self) -> Result<DiscDrag> {
        let (density, viscosity) = (DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY);
        DiscDrag::new(self.radius, density, viscosity, self.spin)
    }

    /// The bearing of the axle, or the tip that drills.
    pub fn dry(&self) -> Result<CoulombBearing> {
        let (scene, start) = self.scene()?;
        CoulombBearing::new(self.bearing, scene.body(), &start, 0.0)
    }

    /// m g l, N m.
    pub fn weight(&self) -> f64 {
        self.mass * GRAVITY * self.lever
    }

    /// I3 omega, kg m^2/s.
    pub fn momentum(&self) -> f64 {
        self.moments[1] * self.spin
    }

    /// What the air that it displaces carries of the weight.
    pub fn lifted(&self) -> f64 {
        DiscDrag::AIR_DENSITY / self.density
    }

    /// The weight less that of the air that it displaces: what this changes.
    pub fn buoyancy(&self) -> impl Effect + Clone + use<> {
        let lift = self.weight() * self.lifted();
        let torque = move |_t, _body: &RigidBody, state: &State| {
            let axis = state.attitude.axis();
            SpaceVector::new(axis.y(), -axis.x(), 0.0) * lift
        };
        Torque::on_space("buoyancy", torque).smooth()
    }

    /// Friction that a vertical pivot has against precession: the frame hands it to the rotor,
    /// but for the part along the axle, about which it cannot turn it. With an axle that is
    /// upright it has no direction, so it does not call itself smooth.
    pub fn pivot(&self) -> impl Effect + Clone + use<> {
        let drag = self.pivot;
        let torque = move |_t, _body: &RigidBody, state: &State| {
            let axis = state.attitude.axis();
            let across = UP - axis * axis.z();
            across * (-drag / across.dot(&across))
        };
        Torque::on_space("pivot", torque)
    }
}

pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
pub const ASIDE: SpaceVector = SpaceVector::new(1.0, 0.0, 0.0);

/// The field of the Earth, which is stronger below than above.
pub fn gradient() -> Result<GravityGradient<true>> {
    GravityGradient::fixed((GRAVITY / EARTH_RADIUS).sqrt(), UP)
}

// ANCHOR: turning
/// A room that turns: on its axes L goes round the other way, and so does the body.
#[derive(Debug, Clone, Copy)]
pub struct Turning {
    pub rate: SpaceVector,
}

impl Effect for Turning {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        slips: true, // it turns the body without a torque
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "a room that turns"
    }

    fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        state.angular_momentum.cross(&self.rate)
    }

    fn slip(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        -self.rate
    }
}
// ANCHOR_END: turning

/// The room at 52 degrees north: X is east, Y north.
pub fn on_the_earth() -> Turning {
    let (s, c) = sincos(52.0_f64.to_radians());
    Turning { rate: SpaceVector::new(0.0, EARTH * c, EARTH * s) }
}
