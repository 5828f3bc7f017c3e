//! A thin uniform disc that rolls on a table without slipping: its equations of motion in
//! vectors, which know nothing of angles. Lengths in radii R, times in sqrt(R/g), masses in that
//! of the disc.

use super::*;
use rotation_dynamics::integrators::{Event, Ode, Solution, ode, size_or};

/// What takes energy from the disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Loss {
    /// Nothing.
    None,
    /// This part of the weight, on the way of the contact over the table.
    Rolling(f64),
    /// The air under it, by Moffatt's estimate; its viscosity in m g/(R^2 sqrt(g/R)).
    Air(f64),
    /// Both at once.
    Both(f64, f64),
}

impl Loss {
    /// What brakes the contact on its way, which at this inclination runs along the rim with
    /// this speed: the power over that speed.
    pub fn drag(self, tilt: f64, speed: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Rolling(part) => part * f64::signum(speed),
            Self::Air(viscosity) => 0.25 * PI * viscosity * speed / tilt,
            Self::Both(part, viscosity) => {
                Self::Rolling(part).drag(tilt, speed) + Self::Air(viscosity).drag(tilt, speed)
            }
        }
    }
}

/// The disc at one time: what its equations need.
pub struct Disc {
    /// Its axis, and its angular velocity.
    pub axis: SpaceVector,
    pub angular_velocity: SpaceVector,
    /// From its centre to its lowest point, and how fast that changes.
    pub arm: SpaceVector,
    pub arm_rate: SpaceVector,
    /// Horizontal direction from the centre towards the contact.
    pub towards: SpaceVector,
    /// Inclination, and how fast the line of steepest descent turns about the vertical.
    pub tilt: f64,
    pub rate: f64,
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

// ANCHOR: disc
impl Disc {
    /// From `[w, x, y, z, omega_x, omega_y, omega_z, x, y]`: quaternion, angular velocity, place.
    pub fn new(&[w, x, y, z, wx, wy, wz, ..]: &[f64; 9]) -> Self {
        let scale = 1.0 / (w * w + x * x + y * y + z * z);
        let axis = SpaceVector::new(
            2.0 * (x * z + w * y),
            2.0 * (y * z - w * x),
            (w * w + z * z) - (x * x + y * y),
        ) * scale;
        let angular_velocity = SpaceVector::new(wx, wy, wz);
        let (s, c) = (hypot(axis.x(), axis.y()), axis.z());
        let towards = SpaceVector::new(axis.x() / s, axis.y() / s, 0.0);
        let turning = angular_velocity.cross(&axis);
        let (s_rate, c_rate) = (turning.dot(&towards), turning.z());
        let across = (turning - UP * c_rate - towards * s_rate) * (1.0 / s);
        Self {
            axis,
            angular_velocity,
            arm: towards * c - UP * s,
            arm_rate: across * c + towards * c_rate - UP * s_rate,
            towards,
            tilt: atan2(s, c),
            rate: towards.cross(&across).z(),
        }
    }

    /// Velocity of the centre: the lowest point is at rest.
    pub fn velocity(&self) -> SpaceVector {
        self.arm.cross(&self.angular_velocity)
    }

    /// The moment of the loss, about the horizontal towards the contact.
    fn braking(&self, loss: Loss) -> SpaceVector {
        let slope = -self.arm.z();
        let speed = -self.towards.dot(&self.angular_velocity) / slope;
        self.towards * (loss.drag(self.tilt, speed) / slope)
    }

    /// Angular acceleration: of I omega' = r x F - omega x I omega + moment, where F is the
    /// acceleration of the centre and the weight, and that acceleration follows from omega'.
    pub fn acceleration(&self, loss: Loss) -> SpaceVector {
        let (omega, spin) = (self.angular_velocity, self.angular_velocity.dot(&self.axis));
        let pull = self.arm.cross(&(UP - omega.cross(&self.arm_rate)));
        let all = pull - omega.cross(&self.axis) * (0.25 * spin) + self.braking(loss);
        // About its axis and the line to the contact the inertia is 3/2 and 1/4, else 5/4.
        let (own, along) = (all.dot(&self.axis), all.dot(&self.arm));
        all * 0.8 + self.axis * (own * (2.0 / 3.0 - 0.8)) + self.arm * (along * (4.0 - 0.8))
    }

    /// The force of the table over the weight.
    pub fn force(&self, loss: Loss) -> SpaceVector {
        let turning = self.arm.cross(&self.acceleration(loss));
        UP + turning + self.arm_rate.cross(&self.angular_velocity)
    }
}

/// The equations of motion.
pub fn rolling(loss: Loss) -> impl Ode<9> {
    ode(move |_, y: &[f64; 9]| {
        let disc = Disc::new(y);
        let ([w, x, z, u], [a, b, c]) =
            ([y[0], y[1], y[2], y[3]], disc.angular_velocity.to_array());
        let q = [
            -(a * x + b * z + c * u),
            a * w + b * u - c * z,
            b * w + c * x - a * u,
            c * w + a * z - b * x,
        ];
        let ([p, r, s], v) = (disc.acceleration(loss).to_array(), disc.velocity());
        [0.5 * q[0], 0.5 * q[1], 0.5 * q[2], 0.5 * q[3], p, r, s, v.x(), v.y()]
    })
    .scaled(size_or([1.0; 9]))
}
// ANCHOR_END: disc

impl Disc {
    /// Energy in m g R.
    pub fn energy(&self) -> f64 {
        let (v, omega) = (self.velocity(), self.angular_velocity);
        let own = omega.dot(&self.axis);
        sin(self.tilt) + 0.5 * v.dot(&v) + 0.125 * (omega.dot(&omega) + own * own)
    }
}

/// How the disc lies in this state.
pub fn attitude(&[w, x, y, z, ..]: &[f64; 9]) -> rotation_dynamics::Result<Attitude> {
    Attitude::from_quaternion([w, x, y, z])
}

/// The state at this inclination and these rates of precession, inclination and spin, with the
/// centre at this distance from the vertical through the origin.
pub fn placed(tilt: f64, [rate, falling, spin]: [f64; 3], centre: f64) -> Result<[f64; 9]> {
    let attitude = Attitude::from_euler(EulerAngles { phi: 0.0, theta: tilt, zeta: 0.0 })?;
    let turning = attitude.to_space(BodyVector::new(falling, rate * sin(tilt), spin));
    let ([w, x, y, z], [a, b, c]) = (attitude.quaternion(), turning.to_array());
    Ok([w, x, y, z, a, b, c, 0.0, centre])
}

/// The motion from `start` until the inclination is `least`, with the times at which it passes
/// these marks; or until the table would have to pull.
pub fn settling(
    loss: Loss,
    start: [f64; 9],
    marks: &[f64],
    least: f64,
    end: f64,
    step: f64,
) -> rotation_dynamics::Result<Solution<9>> {
    let passes = |name, mark| Event::falling(name, move |_, y: &[f64; 9]| Disc::new(y).tilt - mark);
    let lifts = Event::falling("lifts off", move |_, y: &[f64; 9]| Disc::new(y).force(loss).z());
    let mut events = vec![passes("film", least).terminal(), lifts.terminal()];
    events.extend(marks.iter().map(|mark| passes("mark", *mark)));
    Dop853::new(step)?.solve(&rolling(loss), 0.0, &start, end, &events)
}
