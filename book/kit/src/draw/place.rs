//! Where labels go: beside their line, clear of lines, ticks and each other.

use super::canvas::{Frame, Paint, Point, head_at_end, units};
use super::crowded::{APART, SPACE};
use super::display::{Place, Stroke, UNITS};
use super::stations::stations;
use super::words::{Rect, Side, Words};
use crate::error::Result;
use rotation_dynamics::math::{hypot, sort_by_number};

/// The sides tried for a label, the most wanted first.
const SIDES: [Side; 8] = [
    Side::Above,
    Side::Right,
    Side::AboveRight,
    Side::AboveLeft,
    Side::Below,
    Side::BelowRight,
    Side::BelowLeft,
    Side::Left,
];

/// Distance of a label from its curve, in px.
pub(super) const GAP: f64 = 5.0;

/// The distances tried for a label, and what each costs.
const DISTANCES: [(f64, f64); 6] =
    [(GAP, 0.0), (9.0, 2.0), (14.0, 5.0), (22.0, 14.0), (34.0, 18.0), (50.0, 24.0)];

/// What is clear about a label: its halo and a little.
pub(super) const HALO: f64 = 3.0;

/// From this distance on a thin line leads from a label to what it names.
const LEADER: f64 = 20.0;

/// A label with its place: the point it belongs to, and the line that leads there.
pub(super) struct Placed {
    at: Point,
    words: Words,
    leader: Option<[Point; 2]>,
}

impl Placed {
    /// Draws it on a sheet (px).
    pub(super) fn paint(self, sheet: &Frame<'_>) -> Result<()> {
        if let Some(leader) = self.leader {
            let stroke = Stroke::new(self.words.ink, 0.8).faint(0.7);
            sheet.draw(&leader, &Paint::Line(stroke))?;
        }
        sheet.draw(&[self.at], &Paint::Text(self.words))
    }
}

/// What labels must keep clear of: curves as dense points, and boxes already taken.
pub(super) struct Obstacles {
    /// Points at most 3 px apart, each with the number of its curve.
    points: Vec<(usize, Point)>,
    taken: Vec<Rect>,
    room: Rect,
    /// What a label keeps between its box and lines, in px.
    pub(super) clear: f64,
}

impl Obstacles {
    /// The owner of lines that have no label: axes, ticks, outlines.
    pub(super) const NOBODY: usize = usize::MAX;

    /// Nothing yet, in a room (px) that labels must not leave.
    pub(super) fn new(room: Rect) -> Self {
        Self { points: Vec::new(), taken: Vec::new(), room, clear: HALO }
    }

    /// Adds a line of curve number `curve`, in px.
    pub(super) fn add_line(&mut self, curve: usize, line: &[Point]) {
        for pair in line.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let steps = (hypot(b.0 - a.0, b.1 - a.1) / 3.0) as usize + 1;
            for i in 0..=steps {
                let s = i as f64 / steps as f64;
                let p = (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1));
                self.points.push((curve, p));
            }
        }
    }

    /// Adds the head of an arrow along this line, so long, in px.
    pub(super) fn add_head(&mut self, line: &[Point], length: f64) {
        let mut places: Vec<Place> = line.iter().map(|p| (units(p.0), units(p.1))).collect();
        let head = head_at_end(&mut places, length, true).into_iter();
        let px = |(x, y)| (f64::from(x) / UNITS, f64::from(y) / UNITS);
        self.add_line(Self::NOBODY, &head.map(px).collect::<Vec<_>>());
    }

    /// Marks a box as taken.
    pub(super) fn take(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// The best place for the label `words(side, gap)` of curve number `curve` along `line`
    /// (px). The place is taken.
    pub(super) fn place(
        &mut self,
        curve: usize,
        line: &[Point],
        words: impl Fn(Side, f64) -> Words,
    ) -> Option<Placed> {
        let mut wanted = Vec::new();
        for (position, at) in stations(line) {
            for (rank, side) in SIDES.into_iter().enumerate() {
                // A slight preference for the end, and for the first sides.
                wanted.push((at, side, 2.0 * (1.0 - position) + 0.3 * rank as f64));
            }
        }
        self.best(Some(curve), wanted, 0.0, words)
    }

    /// The best place for a label of the point `at` (px), on this side if it is free there.
    /// The place is taken.
    pub(super) fn place_at(
        &mut self,
        at: Point,
        side: Side,
        closest: f64,
        words: impl Fn(Side, f64) -> Words,
    ) -> Option<Placed> {
        let mut wanted = vec![(at, side, 0.0)];
        let others = SIDES.into_iter().filter(|&s| s != side);
        wanted.extend(others.enumerate().map(|(rank, s)| (at, s, 15.0 + rank as f64)));
        self.best(None, wanted, closest - GAP, words)
    }

    fn best(
        &mut self,
        curve: Option<usize>,
        mut wanted: Vec<(Point, Side, f64)>,
        further: f64,
        words: impl Fn(Side, f64) -> Words,
    ) -> Option<Placed> {
        let mut best: Option<(f64, Placed, Rect)> = None;
        // The most wanted first: then the others need not be looked at for long.
        sort_by_number(&mut wanted, |wanted| wanted.2);
        for (at, side, taste) in wanted {
            for (gap, far) in DISTANCES {
                let least = best.as_ref().map_or(f64::INFINITY, |b| b.0);
                if taste + far >= least {
                    continue;
                }
                let words = words(side, gap + further);
                let rect = words.rect(at);
                let leader = (gap >= LEADER).then(|| leader(at, &rect));
                let cost = taste + far + self.cost(curve, &rect, leader, least - taste - far);
                if cost < least {
                    best = Some((cost, Placed { at, words, leader }, rect));
                }
            }
        }
        best.map(|(_, placed, rect)| {
            self.take(rect);
            placed
        })
    }

    /// What is wrong with a box; counted no further than `enough`.
    fn cost(
        &self,
        curve: Option<usize>,
        rect: &Rect,
        leader: Option<[Point; 2]>,
        enough: f64,
    ) -> f64 {
        let corners = [(rect.left, rect.top), (rect.right, rect.bottom)];
        let outside = !corners.iter().all(|&c| self.room.contains(c));
        let taken = |t: &&Rect| {
            let crossed = leader.is_some_and(|leader| {
                !t.contains(leader[1]) && distance_squared(leader, t.middle()) < 36.0
            });
            // As far apart as the check of all figures asks.
            let t = Rect { left: t.left - SPACE, right: t.right + SPACE, ..t.grown(APART) };
            crossed || t.overlaps(rect)
        };
        let taken = self.taken.iter().filter(taken).count();
        let mut cost = if outside { 1e4 } else { 0.0 } + 500.0 * taken as f64;
        if cost >= enough {
            return cost;
        }
        let tight = rect.grown(self.clear);
        let (mut own, mut other) = (f64::INFINITY, f64::INFINITY);
        for &(owner, p) in &self.points {
            let distance = rect.squared_distance(p);
            if distance < self.clear * self.clear * 2.0 && tight.contains(p) {
                cost += 10.0;
            }
            // A line that leads across others leads astray.
            if let Some([from, to]) = leader
                && distance_squared([from, to], p) < 4.0
                && distance_squared([to, to], p) > 64.0
            {
                cost += 8.0;
            }
            if cost >= enough {
                return cost;
            }
            let nearest = if Some(owner) == curve { &mut own } else { &mut other };
            if owner != Self::NOBODY {
                *nearest = nearest.min(distance);
            }
        }
        // Nearer to another curve it would be read as that curve's label.
        if curve.is_some() && leader.is_none() && other < 1.4 * own {
            cost += if other < own { 45.0 } else { 8.0 };
        }
        cost
    }
}

/// The square of the distance of a point from a segment.
pub(super) fn distance_squared([a, b]: [Point; 2], p: Point) -> f64 {
    let (dx, dy, px, py) = (b.0 - a.0, b.1 - a.1, p.0 - a.0, p.1 - a.1);
    let square = dx * dx + dy * dy;
    let s = if square > 0.0 { ((dx * px + dy * py) / square).clamp(0.0, 1.0) } else { 0.0 };
    let (ex, ey) = (px - s * dx, py - s * dy);
    ex * ex + ey * ey
}

/// The line that leads from a label to the point it names, without touching either.
fn leader(at: Point, rect: &Rect) -> [Point; 2] {
    let from = rect.nearest(at);
    let (dx, dy) = (at.0 - from.0, at.1 - from.1);
    let length = hypot(dx, dy).max(1.0);
    let step = |from: Point, by: f64| (from.0 + by * dx / length, from.1 + by * dy / length);
    [step(from, 1.0), step(at, -2.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four waves that cross each other, each with a label of its own: every label is
    /// found a place that touches no curve and no other label.
    #[test]
    fn labels_touch_neither_curves_nor_each_other() {
        use super::super::ink::Ink;
        let room = Rect { left: 0.0, right: 300.0, top: 0.0, bottom: 200.0 };
        let mut obstacles = Obstacles::new(room);
        let wave = |k: usize| -> Vec<Point> {
            let at = |i: u32| f64::from(i) * 3.0;
            let height =
                |x: f64| 100.0 + 60.0 * rotation_dynamics::math::sin(0.02 * x + 1.5 * k as f64);
            (0..=100).map(|i| (at(i), height(at(i)))).collect()
        };
        for k in 0..4 {
            obstacles.add_line(k, &wave(k));
        }
        let crossed = |rect: &Rect, obstacles: &Obstacles| {
            obstacles.points.iter().filter(|(_, p)| rect.contains(*p)).count()
        };
        let mut rects: Vec<Rect> = Vec::new();
        for k in 0..4 {
            let words = |side, gap| Words::new("wave number", Ink::Ink, side, gap);
            let placed = obstacles.place(k, &wave(k), words).expect("a line has places");
            let rect = placed.words.rect(placed.at);
            assert_eq!(crossed(&rect, &obstacles), 0, "label {k}");
            assert!(rects.iter().all(|r| !r.overlaps(&rect)), "label {k}");
            assert!(
                room.contains((rect.left, rect.top)) && room.contains((rect.right, rect.bottom))
            );
            rects.push(rect);
        }
        assert_eq!(rects.len(), 4);
        // The damaged twin: at the middle of its curve the label is crossed.
        let blind = Words::new("wave number", Ink::Ink, Side::Right, GAP).rect(wave(0)[50]);
        assert!(crossed(&blind, &obstacles) > 0);
    }
}
