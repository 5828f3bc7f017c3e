//! Where labels go, and how curves are cut at the edge of a panel.

use super::canvas::{Point, Rect, Side, Text};
use crate::math::hypot;

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

/// What labels must keep clear of: curves as dense points, and boxes already taken.
pub(super) struct Obstacles {
    /// Points at most 3 px apart, each with the number of its curve.
    points: Vec<(usize, Point)>,
    taken: Vec<Rect>,
    room: Rect,
}

impl Obstacles {
    /// Nothing yet, in a room (px) that labels must not leave.
    pub(super) fn new(room: Rect) -> Self {
        Self {
            points: Vec::new(),
            taken: Vec::new(),
            room,
        }
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

    /// Marks a box as taken.
    pub(super) fn take(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// The best place for the label `text(side, gap)` of curve number `curve` along `line`
    /// (px): its point and the text. The place is taken.
    pub(super) fn place(
        &mut self,
        curve: usize,
        line: &[Point],
        text: impl Fn(Side, f64) -> Text,
    ) -> Option<(Point, Text)> {
        let mut best: Option<(f64, Point, Text, Rect)> = None;
        for (position, at) in stations(line) {
            for (rank, &side) in SIDES.iter().enumerate() {
                for (far, gap) in [GAP, 2.0 * GAP, 3.0 * GAP].into_iter().enumerate() {
                    let text = text(side, gap);
                    let rect = text.rect(at);
                    // A slight preference for the end, for the first sides, for being near.
                    let taste = 2.0 * (1.0 - position) + 0.3 * rank as f64 + 4.0 * far as f64;
                    let cost = taste + self.cost(curve, &rect);
                    if best.as_ref().is_none_or(|b| cost < b.0) {
                        best = Some((cost, at, text, rect));
                    }
                }
            }
        }
        best.map(|(_, at, text, rect)| {
            self.take(rect);
            (at, text)
        })
    }

    fn cost(&self, curve: usize, rect: &Rect) -> f64 {
        let corners = [(rect.left, rect.top), (rect.right, rect.bottom)];
        let outside = !corners.iter().all(|&c| self.room.contains(c));
        let taken = self
            .taken
            .iter()
            .filter(|t| t.grown(2.0).overlaps(rect))
            .count();
        let tight = rect.grown(1.0);
        let mut cost = if outside { 1e4 } else { 0.0 } + 500.0 * taken as f64;
        let (mut own, mut other) = (f64::INFINITY, f64::INFINITY);
        for &(owner, p) in &self.points {
            if tight.contains(p) {
                cost += 10.0;
            }
            let nearest = if owner == curve { &mut own } else { &mut other };
            *nearest = nearest.min(rect.distance(p));
        }
        // Much nearer to another curve it would be read as that curve's label.
        if other < 0.7 * own {
            cost += 12.0;
        }
        cost
    }
}

/// Points along a line at which a label is tried, with their position from 0 to 1.
fn stations(line: &[Point]) -> Vec<(f64, Point)> {
    const COUNT: usize = 25;
    let lengths: Vec<f64> = line
        .windows(2)
        .map(|w| hypot(w[1].0 - w[0].0, w[1].1 - w[0].1))
        .collect();
    let total: f64 = lengths.iter().sum();
    let mut found = Vec::new();
    let (mut behind, mut segment) = (0.0, 0);
    for i in 0..=COUNT {
        let position = i as f64 / COUNT as f64;
        while segment + 1 < lengths.len() && behind + lengths[segment] < position * total {
            behind += lengths[segment];
            segment += 1;
        }
        let (Some(&a), Some(&length)) = (line.get(segment), lengths.get(segment)) else {
            break;
        };
        let b = line[segment + 1];
        let s = if length > 0.0 {
            (position * total - behind) / length
        } else {
            0.0
        };
        found.push((position, (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1))));
    }
    if found.is_empty() {
        found.extend(line.first().map(|&p| (1.0, p)));
    }
    found
}

/// Moves labels of height `height`, centred at these `y`, apart, within `top..bottom`.
pub(super) fn spread(centres: &mut [(usize, f64)], height: f64, top: f64, bottom: f64) {
    centres.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut least = top + height / 2.0;
    for (_, y) in centres.iter_mut() {
        *y = y.max(least);
        least = *y + height;
    }
    let mut most = bottom - height / 2.0;
    for (_, y) in centres.iter_mut().rev() {
        *y = y.min(most);
        most = *y - height;
    }
}

/// The parts of a line that lie within `x` and `y` (Liang and Barsky, 1984).
pub(super) fn clipped(line: &[Point], x: Point, y: Point) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in line.windows(2) {
        let Some((a, b)) = clipped_segment(pair[0], pair[1], x, y) else {
            continue;
        };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&a) => part.push(b),
            _ => parts.push(vec![a, b]),
        }
    }
    parts
}

fn clipped_segment(a: Point, b: Point, x: Point, y: Point) -> Option<(Point, Point)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (step, room) in [
        (-dx, a.0 - x.0),
        (dx, x.1 - a.0),
        (-dy, a.1 - y.0),
        (dy, y.1 - a.1),
    ] {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    // The end points themselves are kept bit for bit, so that parts join.
    let at = |s: f64| match s {
        0.0 => a,
        1.0 => b,
        s => (a.0 + s * dx, a.1 + s * dy),
    };
    (enter <= leave).then(|| (at(enter), at(leave)))
}

/// A polygon cut to within `x` and `y` (Sutherland and Hodgman, 1974).
pub(super) fn clipped_polygon(polygon: &[Point], x: Point, y: Point) -> Vec<Point> {
    let mut polygon = polygon.to_vec();
    let edges: [fn(Point, Point, Point) -> f64; 4] = [
        |p, x, _| p.0 - x.0,
        |p, x, _| x.1 - p.0,
        |p, _, y| p.1 - y.0,
        |p, _, y| y.1 - p.1,
    ];
    for inside in edges {
        let mut next = Vec::with_capacity(polygon.len() + 4);
        for (i, &b) in polygon.iter().enumerate() {
            let a = polygon[(i + polygon.len() - 1) % polygon.len()];
            let (da, db) = (inside(a, x, y), inside(b, x, y));
            if (da < 0.0) != (db < 0.0) {
                let s = da / (da - db);
                next.push((a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1)));
            }
            if db >= 0.0 {
                next.push(b);
            }
        }
        polygon = next;
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_cut_at_the_edge_and_joins_inside() {
        let line = [(-1.0, 0.5), (0.5, 0.5), (0.5, 2.0), (0.75, 0.5)];
        let parts = clipped(&line, (0.0, 1.0), (0.0, 1.0));
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0], [(0.0, 0.5), (0.5, 0.5), (0.5, 1.0)]);
        assert_eq!(parts[1][1], (0.75, 0.5));
        assert!(clipped(&[(2.0, 2.0), (3.0, 3.0)], (0.0, 1.0), (0.0, 1.0)).is_empty());
    }

    #[test]
    fn a_polygon_is_cut_at_the_edge() {
        let square = [(-1.0, -1.0), (0.5, -1.0), (0.5, 0.5), (-1.0, 0.5)];
        let cut = clipped_polygon(&square, (0.0, 1.0), (0.0, 1.0));
        let area: f64 = (0..cut.len())
            .map(|i| {
                let (a, b) = (cut[i], cut[(i + 1) % cut.len()]);
                (a.0 * b.1 - b.0 * a.1) / 2.0
            })
            .sum();
        assert_eq!(area, 0.25);
    }

    #[test]
    fn labels_are_spread_and_stay_inside() {
        let mut centres = [(0, 50.0), (1, 52.0), (2, 99.0)];
        spread(&mut centres, 15.0, 0.0, 100.0);
        assert_eq!(centres.map(|c| c.1), [50.0, 65.0, 92.5]);
    }

    /// Four waves that cross each other, each with a label of its own: every label is
    /// found a place that touches no curve and no other label.
    #[test]
    fn labels_touch_neither_curves_nor_each_other() {
        use super::super::ink::Ink;
        let room = Rect {
            left: 0.0,
            right: 300.0,
            top: 0.0,
            bottom: 200.0,
        };
        let mut obstacles = Obstacles::new(room);
        let wave = |k: usize| -> Vec<Point> {
            let at = |i: u32| f64::from(i) * 3.0;
            let height = |x: f64| 100.0 + 60.0 * crate::math::sin(0.02 * x + 1.5 * k as f64);
            (0..=100).map(|i| (at(i), height(at(i)))).collect()
        };
        for k in 0..4 {
            obstacles.add_line(k, &wave(k));
        }
        let crossed = |rect: &Rect, obstacles: &Obstacles| {
            obstacles
                .points
                .iter()
                .filter(|(_, p)| rect.contains(*p))
                .count()
        };
        let mut rects: Vec<Rect> = Vec::new();
        for k in 0..4 {
            let text = |side, gap| Text::new("wave number", Ink::Ink, side, gap);
            let (at, text) = obstacles
                .place(k, &wave(k), text)
                .expect("a line has places");
            let rect = text.rect(at);
            assert_eq!(crossed(&rect, &obstacles), 0, "label {k}");
            assert!(rects.iter().all(|r| !r.overlaps(&rect)), "label {k}");
            assert!(
                room.contains((rect.left, rect.top)) && room.contains((rect.right, rect.bottom))
            );
            rects.push(rect);
        }
        assert_eq!(rects.len(), 4);
        // The damaged twin: at the middle of its curve the label is crossed.
        let blind = Text::new("wave number", Ink::Ink, Side::Right, GAP).rect(wave(0)[50]);
        assert!(crossed(&blind, &obstacles) > 0);
    }
}
