//! A motion and its linear response to an effect, as one system of 14 components.

use crate::body::RigidBody;
use crate::effects::Effect;
use crate::effects::erased::AnyEffect;
use crate::error::Result;
use crate::integrators::Ode;
use crate::integrators::scene::state;
use crate::math::hypot;
use crate::scene::Scene;

/// The change of y along the response that tells the slope of its rates, as a part of y.
const CHANGE: f64 = 1e-5;

/// The angle (rad) by which the response turns the body.
pub(super) fn turned(y: &[f64; 14]) -> f64 {
    let (q, d) = (&y[..4], &y[7..11]);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // What dq has along q is of no effect; across it, its length is half the angle.
    let along = dot(q, d) / dot(q, q);
    let across: [f64; 4] = core::array::from_fn(|i| d[i] - along * q[i]);
    2.0 * (dot(&across, &across) / dot(q, q)).sqrt()
}

/// The angle (rad) by which the response turns the body's axis e3.
pub(super) fn leaned(y: &[f64; 14]) -> f64 {
    let [w, x, v, z, _, _, _, a, b, c, d, ..] = *y;
    // What q^-1 dq has along e1 and e2: half of the turns about them.
    let (about_1, about_2) = (w * b - x * a - v * d + z * c, w * c + x * d - v * a - z * b);
    2.0 * hypot(about_1, about_2) / (w * w + x * x + v * v + z * z)
}

/// A scene behind pointers: code written for it is compiled once for all scenes.
#[derive(Clone, Copy)]
pub(super) struct AnyScene<'s> {
    pub(super) body: &'s RigidBody,
    pub(super) effects: &'s dyn AnyEffect,
    motion: &'s dyn Ode<7>,
}

impl<'s, E: Effect> From<&'s Scene<E>> for AnyScene<'s> {
    fn from(scene: &'s Scene<E>) -> Self {
        Self { body: scene.body(), effects: scene.effects(), motion: scene }
    }
}

/// The motion of a scene and its linear response to an effect, side by side.
pub(super) struct Variation<'s> {
    pub(super) scene: AnyScene<'s>,
    pub(super) effect: &'s dyn AnyEffect,
    /// A response (rad) of no interest, where the effect does not say how large it is.
    pub(super) least: f64,
    /// A rate (rad/s) that is slow: a radian in the whole span.
    pub(super) slowest: f64,
    /// The time (s) of the start, at which an effect says how large it is.
    pub(super) t_start: f64,
    /// The first time and the last between two jumps.
    pub(super) piece: [f64; 2],
}

impl Variation<'_> {
    /// The contribution of the effect alone to the rates of q and L.
    fn added(&self, t: f64, y: &[f64; 7]) -> Result<[f64; 7]> {
        let at = state(y)?;
        let [a, b, c] = self.effect.torque(t, self.scene.body, &at).to_array();
        let mut added = [0.0, 0.0, 0.0, 0.0, a, b, c];
        if self.effect.properties().slips {
            let [w, x, v, z, ..] = *y;
            let [p, q, r] = (self.effect.slip(t, self.scene.body, &at) * 0.5).to_array();
            // (0, slip) q / 2: the slip is on the fixed axes.
            added[0] = -(p * x + q * v + r * z);
            added[1] = p * w + q * z - r * v;
            added[2] = q * w + r * x - p * z;
            added[3] = r * w + p * v - q * x;
        }
        Ok(added)
    }

    /// The scale of y; for L no less than what turns the body slowly.
    fn sizes(&self, y: &[f64; 7]) -> [f64; 7] {
        let [i1, i2, i3] = self.scene.body.moments().to_array();
        let [q, .., l] = self.scene.motion.scale(y);
        let l = l.max(self.slowest * i1.max(i2).max(i3));
        [q, q, q, q, l, l, l]
    }
}

fn halves(y: &[f64; 14]) -> ([f64; 7], [f64; 7]) {
    (core::array::from_fn(|i| y[i]), core::array::from_fn(|i| y[7 + i]))
}

impl Ode<14> for Variation<'_> {
    fn derivative(&self, t: f64, y: &[f64; 14]) -> [f64; 14] {
        let t = t.max(self.piece[0]).min(self.piece[1]);
        let (y, d) = halves(y);
        let rates = self.scene.motion.derivative(t, &y);
        // A state that is no state: the step is refused, and shortened.
        let mut response = self.added(t, &y).unwrap_or([f64::NAN; 7]);
        let scale = self.sizes(&y);
        let part = |i: usize| (d[i] / scale[i]).abs();
        let size = (0..7).map(part).fold(0.0, f64::max);
        if size > 0.0 {
            let by = CHANGE / size;
            let moved = |by: f64| {
                self.scene.motion.derivative(t, &core::array::from_fn(|i| y[i] + by * d[i]))
            };
            let (ahead, behind) = (moved(by), moved(-by));
            for i in 0..7 {
                response[i] += (ahead[i] - behind[i]) / (2.0 * by);
            }
        }
        core::array::from_fn(|i| if i < 7 { rates[i] } else { response[i - 7] })
    }

    /// For the motion as ever. For the response its own size, and at the start, where it is 0, a
    /// small part of the effect while the body turns by a radian.
    fn scale(&self, y: &[f64; 14]) -> [f64; 14] {
        let (y, d) = halves(y);
        let scale = self.sizes(&y);
        let Ok(at) = state(&y) else {
            return [f64::NAN; 14];
        };
        let rate = self.scene.body.angular_velocity(&at).norm();
        let torque = self.effect.torque_scale(self.t_start, self.scene.body, &at);
        let slip = if self.effect.properties().slips {
            self.effect.slip(self.piece[0], self.scene.body, &at).norm()
        } else {
            0.0
        };
        let within = |size: f64| size / rate.max(self.slowest);
        let floor = (within(slip).max(within(torque) / scale[4])).max(self.least);
        let part = |i: usize| (d[i] / scale[i]).abs();
        let size = (0..7).map(part).fold(floor, f64::max);
        core::array::from_fn(|i| if i < 7 { scale[i] } else { scale[i - 7] * size })
    }
}
