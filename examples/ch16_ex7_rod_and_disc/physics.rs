//! A pendulum of a rod and a disc: what counts in it, its swings in closed form, and its equations
//! of motion with one angle and with two.

// ANCHOR: physics
use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::integrators::{Ode, ode, second_order, size_or};

/// Moments of inertia of the pendulum, about the pivot but for the disc's own, and its torque.
#[derive(Debug, Clone, Copy)]
pub struct Moments {
    pub carried: f64, // rod, and disc as if all of it were at its centre, kg m^2
    pub own: f64,     // the disc about its own axle, kg m^2
    pub gravity: f64, // torque of gravity over sin(theta), N m
    pub share: f64,   // the disc's own moment over what is carried
}

impl Moments {
    /// With the centre of the disc at the end of the rod.
    pub fn new(p: &Parameters) -> Result<Self> {
        let (l, m, big) = (p.length, p.rod, p.disc);
        let (carried, own) = ((m / 3.0 + big) * l * l, 0.5 * big * p.radius * p.radius);
        let share = above(0.0).check("(M R^2/2)/(m l^2/3 + M l^2)", own / carried)?;
        let gravity = (0.5 * m + big) * p.gravity * l;
        Ok(Self { carried, own, gravity, share })
    }

    /// Whether the disc is felt, and yet so small that no grease stops the swinging within a swing.
    pub fn is_felt(&self) -> bool {
        (1e-8..=1.0).contains(&self.share)
    }

    /// Angular frequency of small swings, the disc free, rad/s.
    pub fn rate(&self) -> f64 {
        (self.gravity / self.carried).sqrt()
    }
}

/// The pendulum in closed form, with this moment of inertia about the pivot.
pub fn pendulum(p: &Parameters, moment: f64, release: f64) -> Result<Pendulum> {
    let (mass, gravity) = (p.rod + p.disc, p.gravity);
    let lever = (0.5 * p.rod + p.disc) * p.length / mass;
    Ok(Pendulum::new(Suspension { moment, mass, gravity, lever }, release, 0.0)?)
}

// ANCHOR: motion
/// Rod and disc, each with its angle: `[theta, theta', phi, phi']`.
/// In the unit of time the free pendulum has the angular frequency 1;
/// `share` is J/A, `drag` is c/(J W), 0 if the disc is free.
pub fn two_angles(share: f64, drag: f64) -> impl Ode<4> {
    coupled(share, drag, sin)
}

/// The same with another law for the pull of gravity: for small swings it is the angle itself.
pub fn coupled(share: f64, drag: f64, pull: fn(f64) -> f64) -> impl Ode<4> {
    ode(move |_, [theta, rate, _, spin]: &[f64; 4]| {
        let torque = drag * (rate - spin); // on the disc, over J
        [*rate, -pull(*theta) - share * torque, *spin, torque]
    })
    .scaled(size_or([1.0; 4]))
}

/// Rod and disc as one body, in the same units.
pub fn one_angle(share: f64) -> impl Ode<2> {
    second_order(move |_, theta, _| -sin(theta) / (1.0 + share))
}
// ANCHOR_END: motion

/// Angular frequency and rate of decay of small swings, in units of W, for the friction
/// `drag` = c/(J W), and which part of the disc's own moment goes along with the rod.
#[derive(Debug, Clone, Copy)]
pub struct Between {
    pub frequency: f64,
    pub decay: f64,
    pub part: f64,
}

impl Between {
    /// From the root x of x = drag^2 (1 + x)^2 (share - x) between 0 and `share`.
    pub fn new(share: f64, drag: f64) -> Self {
        let lacks = |x: f64| drag * drag * (1.0 + x) * (1.0 + x) * (share - x) - x;
        let [x, _] = bisect([0.0, share], 0.0, |x| lacks(x) > 0.0);
        let decay = 0.5 * x / (drag * (1.0 + x) * (1.0 + x));
        Self { frequency: (1.0 / (1.0 + x) - decay * decay).sqrt(), decay, part: x / share }
    }
}

/// The friction, as c/(J W), of the fastest decay.
pub fn worst(share: f64) -> f64 {
    (1.0 + 0.5 * share) / ((1.0 + share) * (1.0 + share).sqrt())
}
// ANCHOR_END: physics

/// The disc hinged at its rim: the pull of gravity on each angle, what couples them, M l R, and
/// the moment of inertia of the disc about the hinge.
fn hinged(p: &Parameters, m: &Moments) -> [f64; 4] {
    let lever = p.disc * p.radius;
    [m.gravity, lever * p.gravity, lever * p.length, 3.0 * m.own]
}

/// The disc hung by its rim and free there, for small angles: both angular frequencies, the
/// slower first, and the angle of the disc over that of the rod in each.
pub fn by_the_rim(p: &Parameters, m: &Moments) -> [[f64; 2]; 2] {
    let [k1, k2, cross, own] = hinged(p, m);
    let a = m.carried * own - cross * cross;
    let b = 0.5 * (k1 * own + k2 * m.carried);
    let fast = (b + (b * b - a * k1 * k2).sqrt()) / a;
    [k1 * k2 / (a * fast), fast].map(|square| [square.sqrt(), (k1 / square - m.carried) / cross])
}

/// Its motion: Lagrange's equations of two angles from the vertical.
pub fn double(p: &Parameters, m: &Moments) -> impl Ode<4> {
    let ([k1, k2, cross, second], first) = (hinged(p, m), m.carried);
    ode(move |_, [rod, rate, disc, spin]: &[f64; 4]| {
        let (s, c) = sincos(rod - disc);
        let f = -cross * s * spin * spin - k1 * sin(*rod);
        let g = cross * s * rate * rate - k2 * sin(*disc);
        let (mix, det) = (cross * c, first * second - cross * cross * c * c);
        let [faster, spins] = [(second * f - mix * g) / det, (first * g - mix * f) / det];
        [*rate, faster, *spin, spins]
    })
    .scaled(size_or([1.0; 4]))
}
