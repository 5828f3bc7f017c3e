//! From the coordinates of a figure to places on its sheet.
//!
//! Plotters maps them, but where it would bring a browser's interface along
//! (wasm32): there stands the same arithmetic in a few lines, and a test holds the two
//! equal to the bit.

use super::canvas::Point;
use super::display::Place;

/// Maps `x` and `y`, each from first to second, to these places.
#[cfg(not(target_arch = "wasm32"))]
pub(super) struct Map(
    plotters::prelude::Cartesian2d<
        plotters::coord::types::RangedCoordf64,
        plotters::coord::types::RangedCoordf64,
    >,
);

#[cfg(not(target_arch = "wasm32"))]
impl Map {
    pub(super) fn new(x: Point, y: Point, across: Place, up: Place) -> Self {
        let sheet = (across.0..across.1, up.0..up.1);
        Self(plotters::prelude::Cartesian2d::new(
            x.0..x.1,
            y.0..y.1,
            sheet,
        ))
    }

    /// The place of a point.
    pub(super) fn place(&self, point: Point) -> Place {
        use plotters::coord::CoordTranslate;
        self.0.translate(&point)
    }
}

#[cfg(target_arch = "wasm32")]
pub(super) use own::Map;

#[cfg(any(target_arch = "wasm32", test))]
mod own {
    use super::{Place, Point};

    /// Plotters' arithmetic.
    pub(crate) struct Map {
        x: (Point, Place),
        y: (Point, Place),
    }

    impl Map {
        pub(crate) fn new(x: Point, y: Point, across: Place, up: Place) -> Self {
            Self {
                x: (x, across),
                y: (y, up),
            }
        }

        pub(crate) fn place(&self, (x, y): Point) -> Place {
            (along(x, self.x), along(y, self.y))
        }
    }

    /// Towards the first end, but for a thousandth of a unit.
    fn along(value: f64, ((from, to), (first, last)): (Point, Place)) -> i32 {
        if from == to {
            return (last - first) / 2;
        }
        let (part, length) = ((value - from) / (to - from), last - first);
        if length == 0 {
            return last;
        }
        let units = f64::from(length) * part;
        if length > 0 {
            first + libm::floor(units + 1e-3) as i32
        } else {
            first + libm::ceil(units - 1e-3) as i32
        }
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    /// Ranges and sheets as figures have them, points inside and far outside.
    #[test]
    fn our_arithmetic_is_that_of_plotters() {
        let ranges = [
            (0.0, 1.0),
            (-0.3, 7.1),
            (1e-3, 2e-3),
            (-15.0, 0.0),
            (0.0, 340.0),
        ];
        let sheets = [
            ((4012, 32800), (21405, 1000)),
            ((0, 34000), (25000, 0)),
            ((7, 7), (9, 5)),
        ];
        let mut seen = 0;
        let mut off_by_rounding = 0;
        for x in ranges {
            for y in ranges {
                for (across, up) in sheets {
                    let theirs = Map::new(x, y, across, up);
                    let ours = own::Map::new(x, y, across, up);
                    for i in -400..=1400 {
                        let part = f64::from(i) / 1000.0 + 1e-7 * f64::from(i * i % 97);
                        let (u, v) = (x.0 + part * (x.1 - x.0), y.0 + 7.0 * part * (y.1 - y.0));
                        assert_eq!(theirs.place((u, v)), ours.place((u, v)), "{u} {v}");
                        seen += 1;
                        let naive = f64::from(across.0) + part * f64::from(across.1 - across.0);
                        off_by_rounding +=
                            usize::from(libm::round(naive) as i32 != ours.place((u, v)).0);
                    }
                }
            }
        }
        assert_eq!(seen, 5 * 5 * 3 * 1801);
        // The damaged twin: rounding to the nearest gives other places.
        assert!(off_by_rounding > seen / 10, "{off_by_rounding}");
    }
}
