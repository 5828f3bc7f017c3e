//! Bodies that pages need, as meshes. Points and lengths are in the units of the view,
//! axes are unit vectors.

use super::solid::{Solid, across, normal};
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

impl Solid {
    /// A disc about `centre` of this radius, so thick along `axis`.
    pub fn disc(centre: SpaceVector, axis: SpaceVector, radius: f64, thickness: f64) -> Self {
        let half = thickness / 2.0;
        Self::turned(centre, axis, &[(-half, radius), (half, radius)])
    }

    /// A cylinder with the line `from`, `to` in its middle.
    pub fn cylinder(from: SpaceVector, to: SpaceVector, radius: f64) -> Self {
        let (axis, length) = direction(from, to);
        Self::turned(from, axis, &[(0.0, radius), (length, radius)])
    }

    /// A thin round rod from one point to another: an axle, a stick, a stand's pillar.
    pub fn rod(from: SpaceVector, to: SpaceVector, radius: f64) -> Self {
        let (axis, length) = direction(from, to);
        Self::turned_with(10, from, axis, &[(0.0, radius), (length, radius)])
    }

    /// A cone from its base to its tip.
    pub fn cone(base: SpaceVector, tip: SpaceVector, radius: f64) -> Self {
        let (axis, length) = direction(base, tip);
        Self::turned(base, axis, &[(0.0, radius), (length, 0.0)])
    }

    /// The inner side of a cone from its base to its tip, without its base: a funnel whose near half
    /// is cut away.
    pub fn funnel(base: SpaceVector, tip: SpaceVector, radius: f64) -> Self {
        let mut faces = Self::cone(base, tip, radius).faces;
        // The last two are its ends.
        faces.truncate(faces.len().saturating_sub(2));
        faces.iter_mut().for_each(|face| face.reverse());
        Self { faces }
    }

    /// A ball.
    pub fn ball(centre: SpaceVector, radius: f64) -> Self {
        const RINGS: u32 = 9;
        let profile: Vec<(f64, f64)> = (0..=RINGS)
            .map(|i| {
                let (s, c) = sincos(PI * f64::from(i) / f64::from(RINGS));
                (-radius * c, radius * s)
            })
            .collect();
        Self::turned_with(18, centre, SpaceVector::new(0.0, 0.0, 1.0), &profile)
    }

    /// A box about `centre`; `edges` are its three edges as vectors at right angles.
    pub fn cuboid(centre: SpaceVector, edges: [SpaceVector; 3]) -> Self {
        let half = edges.map(|e| e * 0.5);
        let face = |k: usize, sign: f64| {
            let (out, u, v) = (half[k] * sign, half[(k + 1) % 3], half[(k + 2) % 3]);
            let middle = centre + out;
            let mut face = vec![middle + u + v, middle - u + v, middle - u - v, middle + u - v];
            // In a left-handed box, and on opposite sides, the corners run the other way.
            if normal(&face).is_some_and(|n| n.dot(&out) < 0.0) {
                face.reverse();
            }
            face
        };
        Self::new((0..3).flat_map(|k| [face(k, 1.0), face(k, -1.0)]))
    }

    /// The toy top of 16.2: its centre of mass is `lever` above its tip, a ball of this radius about
    /// that point or, with 0, the point. Its rim, 3/4 of the lever wide, is level with the centre of
    /// mass and first touches the floor: on a point at 0.93 rad. Its stem ends 0.7 levers above.
    pub fn top(centre: SpaceVector, axis: SpaceVector, lever: f64, ball: f64) -> Self {
        /// Over the lever: height from the centre of mass, and radius.
        const ABOVE: [(f64, f64); 8] = [
            (-0.15, 0.55),
            (-0.04, 0.73),
            (0.0, 0.75),
            (0.08, 0.74),
            (0.18, 0.3),
            (0.23, 0.075),
            (0.68, 0.055),
            (0.7, 0.0),
        ];
        let tip = (0..=7).map(|i| {
            let (s, c) = sincos(1.9 * f64::from(i) / 7.0);
            (-lever - ball * c, ball * s)
        });
        let above = ABOVE.map(|(height, radius)| (lever * height, lever * radius));
        // A tip that is a point is one point.
        let tip = tip.take(if ball > 0.0 { 8 } else { 1 });
        Self::turned(centre, axis, &tip.chain(above).collect::<Vec<_>>())
    }

    /// A bicycle wheel: rim, spokes, hub, and the axle, `axle` to each side of the centre.
    /// `turn` (radians) is how far the spokes have turned about `axis`.
    pub fn wheel(
        centre: SpaceVector,
        axis: SpaceVector,
        radius: f64,
        axle: f64,
        turn: f64,
    ) -> Self {
        const SPOKES: u32 = 8;
        let (u, v) = across(axis);
        let spokes = (0..SPOKES).map(|i| {
            let (s, c) = sincos(turn + 2.0 * PI * f64::from(i) / f64::from(SPOKES));
            let out = u * c + v * s;
            Self::beam(
                centre + out * (0.05 * radius),
                centre + out * (0.93 * radius),
                0.012 * radius,
            )
        });
        let hub = Self::turned_with(
            14,
            centre - axis * (0.11 * radius),
            axis,
            &[(0.0, 0.07 * radius), (0.22 * radius, 0.07 * radius)],
        );
        let axle = Self::rod(centre - axis * axle, centre + axis * axle, 0.025 * radius);
        let rim = Self::ring(centre, axis, 0.96 * radius, 0.045 * radius);
        spokes.fold(rim.with(hub).with(axle), Self::with)
    }

    /// A ring about `centre`: the mean radius, and half its thickness.
    pub fn ring(centre: SpaceVector, axis: SpaceVector, radius: f64, half: f64) -> Self {
        const ROUND: [(f64, f64); 6] =
            [(-0.5, -0.866), (-1.0, 0.0), (-0.5, 0.866), (0.5, 0.866), (1.0, 0.0), (0.5, -0.866)];
        Self::hoop(32, centre, axis, &ROUND.map(|(h, r)| (half * h, radius + half * r)))
    }

    /// A ring of square section about `centre`, so large that only many sides make it round: a
    /// gimbal.
    pub fn gimbal(centre: SpaceVector, axis: SpaceVector, radius: f64, half: f64) -> Self {
        let section = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
        Self::hoop(60, centre, axis, &section.map(|(h, r)| (half * h, radius + half * r)))
    }

    /// A flywheel about `centre`: a heavy rim of this outer radius, a hub, and six spokes, one
    /// along the unit vector `spoke` at right angles to the axis.
    pub fn flywheel(
        centre: SpaceVector,
        axis: SpaceVector,
        spoke: SpaceVector,
        radius: f64,
    ) -> Self {
        // Parts of the radius: the inside of the rim, half its width, the hub.
        const INSIDE: f64 = 0.76;
        const HALF: f64 = 0.12;
        const HUB: f64 = 0.2;
        let aside = axis.cross(&spoke);
        let half = HALF * radius;
        let section = [(-half, INSIDE), (-half, 1.0), (half, 1.0), (half, INSIDE)];
        let rim = Self::hoop(32, centre, axis, &section.map(|(h, r)| (h, r * radius)));
        let hub = Self::turned_with(
            14,
            centre - axis * half,
            axis,
            &[(0.0, HUB * radius), (2.0 * half, HUB * radius)],
        );
        let spokes = (0..6).map(|i| {
            let (s, c) = sincos(PI * f64::from(i) / 3.0);
            let out = (spoke * c + aside * s) * radius;
            Self::beam(centre + out * (0.9 * HUB), centre + out * (1.02 * INSIDE), 0.055 * radius)
        });
        spokes.fold(rim.with(hub), Self::with)
    }

    /// What a closed section of `(height along the axis, radius)` sweeps out about `centre`; the
    /// section goes round outwards below and inwards above.
    fn hoop(sides: u32, centre: SpaceVector, axis: SpaceVector, section: &[(f64, f64)]) -> Self {
        let (u, v) = across(axis);
        let at = |i: u32, k: usize| {
            let (s, c) = sincos(2.0 * PI * f64::from(i % sides) / f64::from(sides));
            let (h, r) = section[k % section.len()];
            centre + (u * c + v * s) * r + axis * h
        };
        let face = |i: u32, k: usize| vec![at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)];
        let places = (0..sides).flat_map(|i| (0..section.len()).map(move |k| (i, k)));
        Self::new(places.map(|(i, k)| face(i, k)))
    }

    /// The body with each of its points carried elsewhere, to where `to` has it: stretched, turned.
    #[must_use]
    pub fn carried(mut self, to: impl Fn(SpaceVector) -> SpaceVector) -> Self {
        self.faces.iter_mut().flatten().for_each(|point| *point = to(*point));
        self
    }

    /// A stand on the ground: a foot plate and a pillar up to `pivot`, `height` above it.
    pub fn stand(pivot: SpaceVector, height: f64, foot: f64) -> Self {
        let up = SpaceVector::new(0.0, 0.0, 1.0);
        let ground = pivot - up * height;
        let plate = Self::turned(ground, up, &[(0.0, foot), (0.12 * foot, foot)]);
        let pillar = Self::turned_with(
            14,
            ground + up * (0.12 * foot),
            up,
            &[(0.0, 0.16 * foot), (height - 0.12 * foot, 0.05 * foot)],
        );
        plate.with(pillar)
    }

    /// An arrow with a shaft and a head, for a view of this reach, so many times as thick as usual.
    /// Its shaft is cut into short rings, so that what it passes through hides the right part of it.
    pub(super) fn arrow(from: SpaceVector, to: SpaceVector, reach: f64, thick: f64) -> Self {
        /// Radius of the shaft, radius and length of the head over the reach.
        const SIZE: [f64; 3] = [0.022, 0.06, 0.16];
        const RINGS: u32 = 5;
        let (axis, length) = direction(from, to);
        // A short arrow is a small one.
        let size = reach.min(length / (2.0 * SIZE[2]));
        let [shaft, head, long] = SIZE.map(|part| part * size);
        let ring = |i: u32| ((length - long) * f64::from(i) / f64::from(RINGS), thick * shaft);
        let head = [(length - long, thick * head), (length, 0.0)];
        let profile: Vec<_> = (0..=RINGS).map(ring).chain(head).collect();
        Self::turned_with(10, from, axis, &profile)
    }

    /// A square bar.
    fn beam(from: SpaceVector, to: SpaceVector, half: f64) -> Self {
        let (axis, length) = direction(from, to);
        Self::turned_with(4, from, axis, &[(0.0, half), (length, half)])
    }
}

/// The unit vector from one point to another, and their distance.
fn direction(from: SpaceVector, to: SpaceVector) -> (SpaceVector, f64) {
    let along = to - from;
    let length = along.norm();
    if length > 0.0 { (along / length, length) } else { (SpaceVector::new(0.0, 0.0, 1.0), 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume inside the faces, by the divergence theorem: it is positive and right
    /// only if all faces are there and turn their outside out.
    fn volume(solid: &Solid) -> f64 {
        let faces = solid.faces.iter().filter(|face| normal(face).is_some());
        faces
            .map(|face| {
                let fan = (1..face.len() - 1).map(|i| face[0].dot(&face[i].cross(&face[i + 1])));
                fan.sum::<f64>() / 6.0
            })
            .sum()
    }

    #[test]
    fn bodies_are_closed_and_turn_their_outside_out() {
        let at = |x: f64, y: f64, z: f64| SpaceVector::new(x, y, z);
        let axis = at(0.6, 0.0, 0.8);
        // A prism of n sides has the share sin(2 pi / n) / (2 pi / n) of the cylinder.
        let share = |n: f64| rotation_dynamics::math::sin(2.0 * PI / n) / (2.0 * PI / n);
        let edges = [at(2.0, 0.0, 0.0), at(0.0, 3.0, 0.0), at(0.0, 0.0, 0.5)];
        let mirrored = [edges[1], edges[0], edges[2]];
        let cases = [
            (Solid::disc(at(1.0, 2.0, 3.0), axis, 2.0, 0.5), 2.0 * PI * share(36.0), 1e-13),
            (Solid::cone(at(1.0, 0.0, 0.0), at(1.0, 3.0, 0.0), 1.0), PI * share(36.0), 1e-13),
            (Solid::rod(at(0.0, 0.0, 0.0), axis * 2.0, 0.1), 0.02 * PI * share(10.0), 1e-13),
            (Solid::cuboid(at(5.0, 5.0, 5.0), edges), 3.0, 1e-13),
            (Solid::cuboid(at(5.0, 5.0, 5.0), mirrored), 3.0, 1e-13),
            (Solid::ball(at(1.0, 1.0, 1.0), 1.0), 4.0 / 3.0 * PI, 0.1),
            (Solid::ring(at(1.0, 1.0, 1.0), axis, 2.0, 0.1), 4.0 * PI * PI * 0.01, 0.2),
            (
                Solid::arrow(at(1.0, 1.0, 1.0), at(1.0, 1.0, 3.0), 1.0, 1.0),
                PI * (0.022 * 0.022 * 1.84 + 0.06 * 0.06 * 0.16 / 3.0) * share(10.0),
                1e-12,
            ),
        ];
        let count = cases.len();
        for (i, (solid, expected, within)) in cases.into_iter().enumerate() {
            let found = volume(&solid);
            assert!((found / expected - 1.0).abs() < within, "{i}: {found} {expected}");
        }
        assert_eq!(count, 8);
        // The damaged twin: a body without one of its faces is not closed.
        let mut open = Solid::cuboid(at(5.0, 5.0, 5.0), edges);
        open.faces.pop();
        assert!((volume(&open) / 3.0 - 1.0).abs() > 0.1);
    }

    /// The rim of the top reaches the floor first, at the tilt that its doc says, and on a ball of an
    /// eighth of the lever a little later. The damaged twins lean a little further.
    #[test]
    fn a_top_stands_on_its_tip_until_its_rim_touches() {
        let depth = |tilt: f64, ball: f64| {
            let (s, c) = sincos(tilt);
            let (axis, centre) =
                (SpaceVector::new(s, 0.0, c), SpaceVector::new(0.0, 0.0, ball + c));
            let top = Solid::top(centre, axis, 1.0, ball);
            top.faces.iter().flatten().map(SpaceVector::z).fold(f64::INFINITY, f64::min)
        };
        for (tilt, ball) in [(0.0, 0.0), (0.4, 0.0), (0.92, 0.0), (0.3, 0.125), (1.02, 0.125)] {
            assert!(depth(tilt, ball) > -1e-12, "{tilt} {ball}: {}", depth(tilt, ball));
        }
        assert!(depth(0.935, 0.0) < -1e-3 && depth(1.04, 0.125) < -1e-3);
    }
}
