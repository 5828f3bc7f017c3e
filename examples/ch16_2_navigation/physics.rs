//! An axle that keeps its direction while the ground turns and travels: the formulas of a star, the
//! drift of a level axle along a great circle, and the axle carried in space.

// ANCHOR: physics
use core::f64::consts::FRAC_PI_2;
use kit::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::{Ode, ode, size_or};

pub const EARTH: f64 = 7.292_115e-5; // angular velocity against the stars, rad/s
pub const RADIUS: f64 = 6.371e6; // mean radius, m

/// Azimuth and altitude of an axle fixed in space, which lay level towards the azimuth `start`
/// before the Earth turned by `turn`: the formulas of a star.
pub fn star(latitude: f64, start: f64, turn: f64) -> [f64; 2] {
    let ((s, c), (s0, c0)) = (sincos(latitude), sincos(start));
    let (sd, cd) = (c * c0, hypot(s * c0, s0)); // declination
    let (sh, ch) = sincos(atan2(-s0, -s * c0) + turn); // hour angle
    sky(BodyVector::new(-cd * sh, sd * c - cd * ch * s, s * sd + c * cd * ch))
}

/// The ground at a place when the Earth has turned by `turned`, in space: its axes are east,
/// north, up.
pub fn ground(place: BodyVector, turned: f64) -> rotation_dynamics::Result<Attitude> {
    let [x, y, z] = place.to_array();
    let (phi, theta) = (FRAC_PI_2 + atan2(y, x) + turned, atan2(hypot(x, y), z));
    Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 })
}

/// The direction at this azimuth and altitude on the ground.
pub fn towards([azimuth, altitude]: [f64; 2]) -> BodyVector {
    let ((s, c), (up, flat)) = (sincos(azimuth), sincos(altitude));
    BodyVector::new(s * flat, c * flat, up)
}

/// Azimuth and altitude of a direction on the ground.
pub fn sky(seen: BodyVector) -> [f64; 2] {
    let [east, north, up] = seen.to_array();
    [atan2(east, north), atan2(up, hypot(east, north))]
}

/// A unit vector on the axes of the Earth.
pub fn place(latitude: f64, longitude: f64) -> BodyVector {
    let ((s, c), (y, x)) = (sincos(latitude), sincos(longitude));
    BodyVector::new(c * x, c * y, s)
}

/// A circle from `from` about a unit vector `pole`, both on the axes of the Earth: by `angle` (rad)
/// in the time `time` (s), at a constant speed.
#[derive(Debug, Clone, Copy)]
pub struct Journey {
    pub from: BodyVector,
    pub pole: BodyVector,
    pub angle: f64,
    pub time: f64,
}

impl Journey {
    /// The great circle to another place.
    pub fn great_circle(from: BodyVector, to: BodyVector, speed: f64) -> Self {
        let across = from.cross(&to);
        let angle = atan2(across.norm(), from.dot(&to));
        Self { from, pole: across / across.norm(), angle, time: RADIUS * angle / speed }
    }

    /// The place when `turned` rad of the circle are behind us, and its derivative.
    pub fn at(&self, turned: f64) -> [BodyVector; 2] {
        let ((s, c), along) = (sincos(turned), self.pole.cross(&self.from));
        let centre = self.pole * self.pole.dot(&self.from);
        let out = self.from - centre;
        [centre + out * c + along * s, along * c - out * s]
    }

    /// Course there, from north to east.
    pub fn course(&self, turned: f64) -> f64 {
        let [[x, y, z], [u, v, w]] = self.at(turned).map(BodyVector::to_array);
        atan2(x * v - y * u, w * (x * x + y * y) - z * (x * u + y * v))
    }

    /// Drift of a level axle until `turned`: by the path, and by the turning of the Earth.
    pub fn drift(&self, turned: f64) -> [f64; 2] {
        let (up, bends) = (self.pole.cross(&self.from).z(), self.pole.dot(&self.from));
        let ((s, c), height, centre) = (sincos(turned), self.from.z(), self.pole.z() * bends);
        let sines = centre * turned + (height - centre) * s + up * (1.0 - c);
        let path = self.course(turned) - self.course(0.0) + bends * turned;
        [path, EARTH * self.time / self.angle * sines]
    }

    /// The vertical in space, and its rate, on an Earth that turns at the rate `earth`.
    fn vertical(&self, t: f64, earth: f64) -> [SpaceVector; 2] {
        let axis = SpaceVector::new(0.0, 0.0, earth);
        let turned = Attitude::from_rotation_vector(axis * t).unwrap_or(Attitude::IDENTITY);
        let rate = self.angle / self.time;
        let [up, moves] = self.at(rate * t).map(|v| turned.to_space(v));
        [up, moves * rate + axis.cross(&up)]
    }

    /// A level axle: what tilts it does not turn it about the vertical n, so e' = -(e.n') n.
    pub fn carried(self, earth: f64) -> impl Ode<3> {
        ode(move |t, &axle: &[f64; 3]| {
            let [up, moves] = self.vertical(t, earth);
            (up * -SpaceVector::from_array(axle).dot(&moves)).to_array()
        })
        .scaled(size_or([1.0; 3]))
    }

    /// A pilot who steers by the axle: `[place, direction of flight]` on the axes of the Earth. The
    /// track bends to the right at the rate Omega sin(latitude).
    pub fn steered(self) -> impl Ode<6> {
        let rate = self.angle / self.time;
        ode(move |_, state: &[f64; 6]| {
            let [[x, y, z], [u, v, w]] = [0, 3].map(|i| [state[i], state[i + 1], state[i + 2]]);
            let (up, ahead) = (BodyVector::new(x, y, z), BodyVector::new(u, v, w));
            let bends = ahead.cross(&up) * (EARTH * z) - up * rate;
            let ([a, b, c], [d, e, f]) = ((ahead * rate).to_array(), bends.to_array());
            [a, b, c, d, e, f]
        })
        .scaled(size_or([1.0; 6]))
    }
}
// ANCHOR_END: physics
