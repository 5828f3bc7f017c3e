//! The camera, and solids of flat faces.

use super::canvas::Point;
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

/// Where one looks from: the direction of the eye, in radians. Parallel light, no perspective.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    pub(super) right: SpaceVector,
    pub(super) up: SpaceVector,
    pub(super) eye: SpaceVector,
}

impl Camera {
    /// The eye stands `azimuth` from the X axis towards Y, and `elevation` above the
    /// X-Y plane.
    pub fn new(azimuth: f64, elevation: f64) -> Self {
        let ((sa, ca), (se, ce)) = (sincos(azimuth), sincos(elevation));
        Self {
            right: SpaceVector::new(-sa, ca, 0.0),
            up: SpaceVector::new(-se * ca, -se * sa, ce),
            eye: SpaceVector::new(ce * ca, ce * sa, se),
        }
    }

    pub(super) fn project(&self, v: SpaceVector) -> Point {
        (v.dot(&self.right), v.dot(&self.up))
    }

    pub(super) fn depth(&self, v: SpaceVector) -> f64 {
        v.dot(&self.eye)
    }
}

impl Default for Camera {
    /// The book's camera: X towards the reader and to the left, Y to the right, seen from a
    /// little above. Set another only where it hides what matters, and then for the page.
    fn default() -> Self {
        Self::new(0.6, 0.38)
    }
}

/// A solid of flat, convex faces; bodies are in the file beside.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    pub(super) faces: Vec<Vec<SpaceVector>>,
}

impl Solid {
    /// This solid and another as one.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        self.faces.extend(other.faces);
        self
    }

    /// The solid with these faces, each a plane polygon, counterclockwise seen from outside.
    pub fn new(faces: impl IntoIterator<Item = Vec<SpaceVector>>) -> Self {
        Self { faces: faces.into_iter().collect() }
    }

    /// What a profile of `(height along the axis, radius)` sweeps out about the line
    /// through `base` along the unit vector `axis`: cylinders, cones, discs, tops. The
    /// profile goes from below to above; the ends are closed.
    ///
    pub fn turned(base: SpaceVector, axis: SpaceVector, profile: &[(f64, f64)]) -> Self {
        Self::turned_with(36, base, axis, profile)
    }

    /// As [`Self::turned`], with so many sides.
    pub(super) fn turned_with(
        sides: usize,
        base: SpaceVector,
        axis: SpaceVector,
        profile: &[(f64, f64)],
    ) -> Self {
        let (u, v) = across(axis);
        let rim = |&(h, r): &(f64, f64)| -> Vec<SpaceVector> {
            (0..sides)
                .map(|i| {
                    let (s, c) = sincos(2.0 * PI * i as f64 / sides as f64);
                    base + axis * h + u * (r * c) + v * (r * s)
                })
                .collect()
        };
        let mut faces = Vec::new();
        for pair in profile.windows(2) {
            let (low, high) = (rim(&pair[0]), rim(&pair[1]));
            for i in 0..sides {
                let j = (i + 1) % sides;
                faces.push(vec![low[i], low[j], high[j], high[i]]);
            }
        }
        if let (Some(first), Some(last)) = (profile.first(), profile.last()) {
            faces.push(rim(first).into_iter().rev().collect());
            faces.push(rim(last));
        }
        Self { faces }
    }
}

/// Two unit vectors at right angles to the unit vector `axis` and to each other.
pub(super) fn across(axis: SpaceVector) -> (SpaceVector, SpaceVector) {
    let other = if axis.z().abs() < 0.9 {
        SpaceVector::new(0.0, 0.0, 1.0)
    } else {
        SpaceVector::new(1.0, 0.0, 0.0)
    };
    let u = other.cross(&axis);
    let u = u / u.norm();
    (u, axis.cross(&u))
}

/// The outward unit normal of a face (Newell); `None` if it has no area.
pub(super) fn normal(face: &[SpaceVector]) -> Option<SpaceVector> {
    let mut sum = SpaceVector::zero();
    for (i, a) in face.iter().enumerate() {
        sum += a.cross(&face[(i + 1) % face.len()]);
    }
    let norm = sum.norm();
    (norm > 0.0).then(|| sum / norm)
}

/// A profile with a point between each two, such that it is smooth (Dyn, Levin and Gregory, 1987);
/// it begins and ends on the axis, and goes on at the other side.
pub fn smooth(profile: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let last = profile.len().saturating_sub(1);
    let at = |i: usize| match i {
        0 => (profile[1].0, -profile[1].1),
        i if i > last + 1 => (profile[last - 1].0, -profile[last - 1].1),
        i => profile[i - 1],
    };
    let middle = |[a, b, c, d]: [f64; 4]| (9.0 * (b + c) - (a + d)) / 16.0;
    let between = |i: usize| {
        let near = [0, 1, 2, 3].map(|k| at(i + k));
        (middle(near.map(|p| p.0)), middle(near.map(|p| p.1)))
    };
    let pairs = (0..last).flat_map(|i| [profile[i], between(i)]);
    pairs.chain(profile.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between the points of a half circle that is made of few, those that are added lie close to it.
    #[test]
    fn a_smooth_profile_is_round_and_closed_over_its_ends() {
        let circle = |k: u32| {
            let (s, c) = sincos(PI * f64::from(k) / 8.0);
            (-c, s)
        };
        let few: Vec<_> = (0..=8).map(circle).collect();
        let profile = smooth(&few);
        assert_eq!(profile.len(), 17);
        for (h, r) in profile {
            assert!((rotation_dynamics::math::hypot(h, r) - 1.0).abs() < 1e-3, "{h} {r}");
        }
        // The damaged twin: the middles of straight sides lie farther off.
        let (a, b) = (few[3], few[4]);
        assert!(rotation_dynamics::math::hypot(a.0 + b.0, a.1 + b.1) / 2.0 < 1.0 - 1e-2);
        assert!(smooth(&[]).is_empty());
    }
}
