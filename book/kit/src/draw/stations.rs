//! Where along a line a label is tried, and labels in a column.

use super::canvas::Point;
use rotation_dynamics::math::{hypot, sort_by_number};

/// Points along a line at which a label is tried, with their position from 0 to 1.
pub(super) fn stations(line: &[Point]) -> Vec<(f64, Point)> {
    const COUNT: usize = 25;
    let lengths: Vec<f64> =
        line.windows(2).map(|w| hypot(w[1].0 - w[0].0, w[1].1 - w[0].1)).collect();
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
        let s = if length > 0.0 { (position * total - behind) / length } else { 0.0 };
        found.push((position, (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1))));
    }
    if found.is_empty() {
        found.extend(line.first().map(|&p| (1.0, p)));
    }
    found
}

/// Moves labels of height `height`, centred at these `y`, apart, within `top..bottom`.
pub(super) fn spread(centres: &mut [(usize, f64)], height: f64, top: f64, bottom: f64) {
    sort_by_number(centres, |centre| centre.1);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_spread_and_stay_inside() {
        let mut centres = [(0, 50.0), (1, 52.0), (2, 99.0)];
        spread(&mut centres, 15.0, 0.0, 100.0);
        assert_eq!(centres.map(|c| c.1), [50.0, 65.0, 92.5]);
    }
}
