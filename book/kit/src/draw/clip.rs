//! How lines and areas are cut at the edge of a panel.

use super::canvas::Point;

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
    for (step, room) in [(-dx, a.0 - x.0), (dx, x.1 - a.0), (-dy, a.1 - y.0), (dy, y.1 - a.1)] {
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
    let edges: [fn(Point, Point, Point) -> f64; 4] =
        [|p, x, _| p.0 - x.0, |p, x, _| x.1 - p.0, |p, _, y| p.1 - y.0, |p, _, y| y.1 - p.1];
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
}
