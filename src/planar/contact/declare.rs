//! The declarations of a scene about its contacts.

/// Coordinates and velocities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MechanismState<const N: usize> {
    /// The coordinates.
    pub q: [f64; N],
    /// Their velocities.
    pub v: [f64; N],
}

impl<const N: usize> MechanismState<N> {
    /// At rest.
    pub const fn rest(q: [f64; N]) -> Self {
        Self { q, v: [0.0; N] }
    }

    /// Coordinates, then velocities: `S` = 2 N numbers.
    pub fn to_array<const S: usize>(&self) -> [f64; S] {
        const { assert!(S == 2 * N, "a state has two numbers for each coordinate") };
        core::array::from_fn(|k| if k < N { self.q[k] } else { self.v[k - N] })
    }

    /// The state of these coordinates and, after them, velocities.
    pub fn from_array<const S: usize>(numbers: &[f64; S]) -> Self {
        const { assert!(S == 2 * N, "a state has two numbers for each coordinate") };
        Self {
            q: core::array::from_fn(|j| numbers[j]),
            v: core::array::from_fn(|j| numbers[N + j]),
        }
    }
}

/// The direction of a slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// The slip speed is positive.
    Forward,
    /// The slip speed is negative.
    Backward,
}

impl Sense {
    /// +1 or -1.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// The mode of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// It does not act.
    Open,
    /// It pushes, without friction.
    Smooth,
    /// It pushes, and friction keeps the surfaces from slipping.
    Stick,
    /// It pushes, and friction opposes the slip.
    Slip(Sense),
}

/// Coefficients of dry friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// Of surfaces that slip.
    pub kinetic: f64,
    /// Up to which surfaces hold that do not slip; at least `kinetic`.
    pub holding: f64,
}

/// A speed as a function of the velocities: `along . v - surface`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<const N: usize> {
    /// Its derivative by each velocity: a row of the Jacobian J.
    pub along: [f64; N],
    /// Its rate at constant velocities, `J' v` less the acceleration of the surface.
    pub bias: f64,
    /// The speed of the surface itself.
    pub surface: f64,
}

impl<const N: usize> Row<N> {
    /// A row for a surface at rest.
    pub const fn new(along: [f64; N], bias: f64) -> Self {
        Self { along, bias, surface: 0.0 }
    }

    /// `along . v - surface`.
    pub fn speed(&self, v: &[f64; N]) -> f64 {
        dot(&self.along, v) - self.surface
    }

    /// The sum of `|along| sizes`.
    pub(super) fn size(&self, sizes: &[f64; N]) -> f64 {
        dot(&self.along.map(f64::abs), sizes)
    }
}

pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The cause of the push of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Press {
    /// The gap must not become negative.
    OneSided,
    /// The gap must stay 0; the force may pull.
    TwoSided,
    /// A given force.
    Given(f64),
    /// The normal force of the contact at this place.
    By(usize),
}

/// A contact at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact<const N: usize> {
    pub(super) name: &'static str,
    pub(super) gap: f64,
    pub(super) normal: Row<N>,
    pub(super) tangent: Row<N>,
    pub(super) friction: Friction,
    pub(super) restitution: f64,
    pub(super) press: Press,
}

impl<const N: usize> Contact<N> {
    /// A smooth contact that can push and not pull: its `gap`, the gradient of the gap by
    /// the coordinates, and the rate of the gap's speed at constant velocities.
    ///
    /// Also a string, whose gap is what it lacks to be taut and whose force is its tension.
    /// An impact is plastic unless [`restitution`](Self::restitution) is said.
    pub const fn new(name: &'static str, gap: f64, gradient: [f64; N], bias: f64) -> Self {
        Self {
            name,
            gap,
            normal: Row::new(gradient, bias),
            tangent: Row::new([0.0; N], 0.0),
            friction: Friction { kinetic: 0.0, holding: 0.0 },
            restitution: 0.0,
            press: Press::OneSided,
        }
    }

    /// A contact that also pulls: the gap stays 0.
    pub const fn joint(name: &'static str, gap: f64, gradient: [f64; N], bias: f64) -> Self {
        Self { press: Press::TwoSided, ..Self::new(name, gap, gradient, bias) }
    }

    /// Surfaces pressed together with a given `force` >= 0, whatever moves: a brake, a pair of discs.
    pub const fn pressed(name: &'static str, force: f64) -> Self {
        Self { press: Press::Given(force), ..Self::new(name, 0.0, [0.0; N], 0.0) }
    }

    /// A resistance that rides on another contact: pressed with the normal force of the contact
    /// at the place `by` in the list, and open where that is open. Its `tangent` is the rate that
    /// it resists; see [`rolling`](Contact::rolling).
    pub const fn pressed_by(name: &'static str, by: usize) -> Self {
        Self { press: Press::By(by), ..Self::new(name, 0.0, [0.0; N], 0.0) }
    }

    /// The same contact, whose slip speed is `along . v`, with its rate at constant velocities.
    pub const fn tangent(self, along: [f64; N], bias: f64) -> Self {
        Self { tangent: Row::new(along, bias), ..self }
    }

    /// The same contact with the friction `mu`, slipping or not.
    pub const fn friction(self, mu: f64) -> Self {
        self.frictions(mu, mu)
    }

    /// The same contact with one coefficient for slipping and a larger one for holding.
    pub const fn frictions(self, kinetic: f64, holding: f64) -> Self {
        Self { friction: Friction { kinetic, holding }, ..self }
    }

    /// The same contact, whose surface moves along the tangent with this constant speed.
    pub const fn moving(mut self, speed: f64) -> Self {
        self.tangent.surface = speed;
        self
    }

    /// The same contact, whose surface moves along the normal with this speed and acceleration.
    pub const fn rising(mut self, speed: f64, acceleration: f64) -> Self {
        self.normal.surface = speed;
        self.normal.bias -= acceleration;
        self
    }

    /// The same contact, which returns this part of the normal velocity, from 0 to 1.
    pub const fn restitution(self, restitution: f64) -> Self {
        Self { restitution, ..self }
    }
}

/// A straight surface: the points p with `normal . p = offset`. The body is on the side of
/// the normal, a unit vector; the tangent is the normal turned clockwise by a right angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// The unit vector across it, towards the body.
    pub normal: [f64; 2],
    /// Its distance from the origin, along the normal (m).
    pub offset: f64,
}

impl Surface {
    /// y = 0, the body above; slip to the right is positive.
    pub const FLOOR: Self = Self { normal: [0.0, 1.0], offset: 0.0 };
    /// x = 0, the body to the right; slip downward is positive.
    pub const WALL: Self = Self { normal: [1.0, 0.0], offset: 0.0 };

    const fn tangent(self) -> [f64; 2] {
        [self.normal[1], -self.normal[0]]
    }
}

/// Contacts of one rigid body with the coordinates `[x, y, angle]`: the place of its centre of
/// mass, and its rotation counterclockwise.
impl Contact<3> {
    /// A corner of the body, at `arm` from the centre in space axes, on a surface.
    pub fn corner(
        name: &'static str,
        body: &MechanismState<3>,
        arm: [f64; 2],
        surface: Surface,
    ) -> Self {
        let ([x, y, _], [.., omega]) = (body.q, body.v);
        let row = |[nx, ny]: [f64; 2]| {
            let inward = -omega * omega * (arm[0] * nx + arm[1] * ny);
            ([nx, ny, arm[0] * ny - arm[1] * nx], inward)
        };
        let [nx, ny] = surface.normal;
        let gap = (x + arm[0]) * nx + (y + arm[1]) * ny - surface.offset;
        let (gradient, bias) = row(surface.normal);
        let (along, slip_bias) = row(surface.tangent());
        Self::new(name, gap, gradient, bias).tangent(along, slip_bias)
    }

    /// Rolling resistance of a round body at the contact `by`, on a surface at rest: a torque of
    /// at most
    ///
    /// ```text
    /// |M| <= C_rr N R,
    /// ```
    ///
    /// equal to it and against the rotation while the body turns. At rest it takes any value up to
    /// that, so that a body at rest stays where a smaller torque would move it. A body that comes
    /// to rest stops, at an event ("stops"; "starts" and "reverses" are the others).
    ///
    /// `radius` R (m); `coefficient` C_rr (not negative; 0.002 for steel on a rail, 0.01 for a tyre
    /// on a road). It is judged by the number C_rr itself. On the level a body with I = k m R^2
    /// that rolls loses C_rr g/(1 + k) of speed a second, and on an incline of less than C_rr it
    /// does not begin to roll. Range of validity: a resistance that does not depend on the speed,
    /// and speeds at which the surfaces creep back in time.
    ///
    /// A mechanism without it has one contact less: there is nothing to be called.
    ///
    /// Accuracy: time and place of the stop to 3 eps at a tolerance of 1e-12
    /// (`tests/planar/resistance.rs`).
    ///
    /// ```
    /// use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, Surface, motion_within};
    ///
    /// /// A wheel of radius 0.3 m: m = 1, I = m R^2, C_rr = 0.01.
    /// struct Wheel;
    /// impl Mechanism<3, 2> for Wheel {
    ///     fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
    ///         [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.09]]
    ///     }
    ///     fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
    ///         [0.0, -9.81, 0.0]
    ///     }
    ///     fn contacts(&self, wheel: &MechanismState<3>) -> [Contact<3>; 2] {
    ///         let rim = Contact::rim("rim", wheel, 0.3, Surface::FLOOR).friction(0.5);
    ///         [rim, Contact::rolling("wheel", 0, 0.3, 0.01)]
    ///     }
    /// }
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let start = MechanismState { q: [0.0, 0.3, 0.0], v: [1.0, 0.0, -1.0 / 0.3] };
    /// let motion = motion_within(&Wheel, 1e-12, start, 60.0)?;
    /// let stops = motion.event("wheel stops")?;
    /// assert!((stops.t - 2.0 / (0.01 * 9.81)).abs() < 1e-11);
    /// assert!(motion.at(60.0)?.v[0].abs() < 1e-15);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Source: K. L. Johnson, *Contact Mechanics* (1985), 9; as a set-valued torque F.
    /// Pfeiffer, C. Glocker, cited with [this module](super).
    pub const fn rolling(name: &'static str, by: usize, radius: f64, coefficient: f64) -> Self {
        Self::pressed_by(name, by).tangent([0.0, 0.0, radius], 0.0).friction(coefficient)
    }

    /// The rim of a disc or ball of this radius about the centre, on a surface.
    pub fn rim(
        name: &'static str,
        body: &MechanismState<3>,
        radius: f64,
        surface: Surface,
    ) -> Self {
        let ([nx, ny], [tx, ty]) = (surface.normal, surface.tangent());
        let gap = body.q[0] * nx + body.q[1] * ny - surface.offset - radius;
        Self::new(name, gap, [nx, ny, 0.0], 0.0).tangent([tx, ty, radius], 0.0)
    }
}
