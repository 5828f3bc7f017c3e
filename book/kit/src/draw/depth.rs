//! What hides what: faces and pieces of lines, ordered from behind to the front.
//!
//! Two items that overlap in the picture are compared by the plane of one of them
//! (Newell, Newell and Sancha, 1972); the order of all is a topological sort, and
//! where items hide each other in a circle the farther goes first. Bodies that pass
//! through one another are right up to the size of their faces.

use super::canvas::{Paint, Point};
use super::solid::{Camera, normal};
use core::cmp::{Ordering, Reverse};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::order_of;
use std::collections::BinaryHeap;

/// A convex face, or a piece of a line.
pub(super) struct Item {
    pub(crate) points: Vec<SpaceVector>,
    pub(crate) paint: Paint,
    /// A piece of a line that goes on where the item before it ends.
    pub(crate) goes_on: bool,
}

struct Seen {
    flat: Vec<Point>,
    depth: f64,
    /// Normal towards the eye, and distance from the origin.
    plane: Option<(SpaceVector, f64)>,
    x: Point,
    y: Point,
}

impl Seen {
    fn new(camera: &Camera, item: &Item) -> Self {
        let flat: Vec<Point> = item.points.iter().map(|&p| camera.project(p)).collect();
        let bounds = |of: fn(&Point) -> f64| {
            let values = flat.iter().map(of);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
        };
        let depth = item.points.iter().map(|&p| camera.depth(p)).sum::<f64>();
        let face = matches!(item.paint, Paint::Face(..));
        let plane = normal(&item.points).filter(|_| face);
        let plane = plane.map(|n| if camera.depth(n) < 0.0 { n * -1.0 } else { n });
        Self {
            x: bounds(|p| p.0),
            y: bounds(|p| p.1),
            depth: depth / item.points.len() as f64,
            plane: plane.map(|n| {
                (n, item.points.iter().map(|p| p.dot(&n)).sum::<f64>() / item.points.len() as f64)
            }),
            flat,
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.y.0 < other.y.1 - NEAR
            && other.y.0 < self.y.1 - NEAR
            && !separated(&self.flat, &other.flat)
            && !separated(&other.flat, &self.flat)
    }
}

/// Lengths below this are none.
const NEAR: f64 = 1e-7;

/// Whether a side of the convex outline `a` has all of `b` beyond it.
fn separated(a: &[Point], b: &[Point]) -> bool {
    (0..a.len()).any(|i| {
        let (p, q) = (a[i], a[(i + 1) % a.len()]);
        let (dx, dy) = (q.0 - p.0, q.1 - p.1);
        let side = |r: &Point| dx * (r.1 - p.1) - dy * (r.0 - p.0);
        let span = |points: &[Point]| {
            let sides = points.iter().map(side);
            sides.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s), h.max(s)))
        };
        let ((a0, a1), (b0, b1)) = (span(a), span(b));
        b0 > a1 - NEAR * NEAR.sqrt() && b1 > a1 || b1 < a0 + NEAR * NEAR.sqrt() && b0 < a0
    })
}

/// On which side of the plane these points lie: `Less` is behind it.
fn side((normal, offset): (SpaceVector, f64), points: &[SpaceVector]) -> Option<Ordering> {
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    for p in points {
        let above = p.dot(&normal) - offset;
        (low, high) = (low.min(above), high.max(above));
    }
    match (low < -NEAR, high > NEAR) {
        (true, false) => Some(Ordering::Less),
        (false, true) => Some(Ordering::Greater),
        (false, false) => Some(Ordering::Equal),
        (true, true) => None,
    }
}

/// Whether `a` is behind `b` (`Less`), where they overlap.
fn compared(a: (&Item, &Seen), b: (&Item, &Seen)) -> Ordering {
    let by_b = b.1.plane.and_then(|plane| side(plane, &a.0.points));
    let by_a = a.1.plane.and_then(|plane| side(plane, &b.0.points));
    match (by_b, by_a.map(Ordering::reverse)) {
        // What lies on a face is drawn on it.
        (Some(Ordering::Equal), None) => Ordering::Greater,
        (None, Some(Ordering::Equal)) => Ordering::Less,
        (Some(order), _) | (None, Some(order)) => order,
        (None, None) => a.1.depth.total_cmp(&b.1.depth),
    }
}

/// The order in which the items are painted.
pub(super) fn from_behind(camera: &Camera, items: &[Item]) -> Vec<usize> {
    let seen: Vec<Seen> = items.iter().map(|item| Seen::new(camera, item)).collect();
    let mut ahead: Vec<Vec<usize>> = vec![Vec::new(); items.len()];
    let mut waits = vec![0_usize; items.len()];
    let across = order_of(&seen.iter().map(|seen| seen.x.0).collect::<Vec<_>>());
    for (k, &i) in across.iter().enumerate() {
        for &j in &across[k + 1..] {
            if seen[j].x.0 > seen[i].x.1 - NEAR {
                break;
            }
            let lines = seen[i].plane.is_none() && seen[j].plane.is_none();
            if lines || !seen[i].overlaps(&seen[j]) {
                continue;
            }
            match compared((&items[i], &seen[i]), (&items[j], &seen[j])) {
                Ordering::Less => {
                    ahead[i].push(j);
                    waits[j] += 1;
                }
                Ordering::Greater => {
                    ahead[j].push(i);
                    waits[i] += 1;
                }
                Ordering::Equal => {}
            }
        }
    }
    let by_depth = order_of(&seen.iter().map(|seen| seen.depth).collect::<Vec<_>>());
    let mut rank = vec![0; items.len()];
    for (place, &i) in by_depth.iter().enumerate() {
        rank[i] = place;
    }
    let ready = by_depth.iter().enumerate().filter(|&(_, &i)| waits[i] == 0);
    let mut ready: BinaryHeap<Reverse<usize>> = ready.map(|(place, _)| Reverse(place)).collect();
    let (mut done, mut order) = (vec![false; items.len()], Vec::new());
    let mut farthest = 0;
    while order.len() < items.len() {
        // A line is rather drawn on than left for something else.
        let on = order.last().map(|&i: &usize| i + 1);
        let on = on.filter(|&i| i < items.len() && items[i].goes_on && !done[i] && waits[i] == 0);
        let next = on.unwrap_or_else(|| {
            while let Some(Reverse(place)) = ready.pop() {
                if !done[by_depth[place]] {
                    return by_depth[place];
                }
            }
            // All that is left waits for each other.
            while done[by_depth[farthest]] {
                farthest += 1;
            }
            by_depth[farthest]
        });
        done[next] = true;
        order.push(next);
        for &i in &ahead[next] {
            waits[i] = waits[i].saturating_sub(1);
            if waits[i] == 0 && !done[i] {
                ready.push(Reverse(rank[i]));
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::super::ink::Ink;
    use super::*;

    fn face(corners: [[f64; 3]; 4]) -> Item {
        Item {
            points: corners.map(|[x, y, z]| SpaceVector::new(x, y, z)).into(),
            paint: Paint::Face(Ink::Body, 50),
            goes_on: false,
        }
    }

    /// A long plate that leans away and a small one in front of its far end: the middle of
    /// the small one is farther than that of the long one, and yet it hides it.
    #[test]
    fn the_plane_decides_where_the_depth_of_the_middle_is_wrong() {
        let camera = Camera::new(0.0, 0.0);
        let long = |y: f64, z: f64| [-6.0 * y, y, z];
        let items = [
            face([[-4.5, 0.9, -0.1], [-4.5, 1.1, -0.1], [-4.5, 1.1, 0.1], [-4.5, 0.9, 0.1]]),
            face([long(0.0, -1.0), long(1.0, -1.0), long(1.0, 1.0), long(0.0, 1.0)]),
        ];
        assert_eq!(from_behind(&camera, &items), [1, 0]);
        // The damaged twin: the middles say the opposite.
        let middle = |item: &Item| item.points.iter().map(|&p| camera.depth(p)).sum::<f64>();
        assert!(middle(&items[0]) < middle(&items[1]));
    }

    #[test]
    fn what_hides_each_other_in_a_circle_is_still_painted_once() {
        let camera = Camera::new(0.0, 1.57);
        let beam = |turn: f64| {
            let (s, c) = rotation_dynamics::math::sincos(turn);
            let at = |along: f64, across: f64| {
                let z = 0.3 * along;
                [c * along - s * (across + 0.5), s * along + c * (across + 0.5), z]
            };
            face([at(-1.0, -0.1), at(1.0, -0.1), at(1.0, 0.1), at(-1.0, 0.1)])
        };
        let third = 2.0 * core::f64::consts::PI / 3.0;
        let items = [beam(0.0), beam(third), beam(2.0 * third)];
        let mut order = from_behind(&camera, &items);
        order.sort_unstable();
        assert_eq!(order, [0, 1, 2]);
    }
}
