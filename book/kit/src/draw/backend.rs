//! What plotters draws on: its marks, and ours between its axes, become a display list.
//!
//! A pixel of plotters is a hundredth of a px of ours ([`UNITS`]), so that its whole numbers are
//! our places. The text of its ticks is TeX of ours, and is measured by our table of widths, so that
//! the list is the same on every machine.

use super::canvas::{Paint, Point, units};
use super::curve::AXIS;
use super::display::{Display, Place, Stroke, UNITS};
use super::ink::Ink;
use super::label::{Label, SIZE};
use super::words::{Side, Words};
use core::cell::RefCell;
use core::convert::Infallible;
use core::ops::Range;
use plotters::coord::CoordTranslate;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::Rect;
use plotters::element::{CoordMapper, Drawable, PointCollection};
use plotters_backend::text_anchor::HPos;
use plotters_backend::{BackendColor, BackendStyle, BackendTextStyle, DrawingBackend};

type Drawn<T = ()> = Result<T, plotters_backend::DrawingErrorKind<Infallible>>;

/// A sheet of paper. Plotters itself draws axes, ticks and their texts on it, all in ink.
#[derive(Clone, Copy)]
pub(super) struct Sheet<'a>(pub(super) &'a RefCell<Display>);

impl DrawingBackend for Sheet<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        let (width, height) = self.0.borrow().size;
        (width * UNITS as u32, height * UNITS as u32)
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    /// A list has no pixels, and nothing here asks for one.
    fn draw_pixel(&mut self, _: Place, _: BackendColor) -> Drawn {
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: Place, to: Place, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = Place>>(
        &mut self,
        path: I,
        _: &S,
    ) -> Drawn {
        let line = Paint::Line(Stroke::new(Ink::Ink, AXIS));
        self.0.borrow_mut().mark(path.into_iter().collect(), &line);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: Place) -> Drawn {
        // Plotters keeps a text twice the length of a tick off its axis.
        let (side, gap) = match style.anchor().h_pos {
            HPos::Right => (Side::Left, -1.0),
            _ => (Side::Below, -1.0),
        };
        let words = Words::new(text, Ink::Ink, side, gap).bare();
        // The last text moves in rather than over the edge; widths are estimates.
        let half = match side {
            Side::Below => units(0.55 * words.label.width(SIZE) + 1.0),
            _ => 0,
        };
        let inside = at.0.min(self.get_size().0 as i32 - half);
        self.0.borrow_mut().mark(vec![(inside, at.1)], &Paint::Text(words));
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(&self, text: &str, _: &S) -> Drawn<(u32, u32)> {
        let size = [Label::new(text).width(SIZE), SIZE].map(|px| units(px) as u32);
        Ok((size[0], size[1]))
    }
}

/// A coordinate: its range, the pixels between its start and the axis across, and the ticks.
#[derive(Clone)]
pub(super) struct Scale {
    range: RangedCoordf64,
    room: i32,
    ticks: Vec<(f64, String)>,
}

impl Scale {
    pub(super) fn new((from, to): Point, room: i32, ticks: Vec<(f64, String)>) -> Self {
        let range = (from..to).into();
        Self { range, room, ticks }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (first, last): Place) -> i32 {
        let room = self.room * (last - first).signum();
        self.range.map(value, (first + room, last))
    }

    fn key_points<H: KeyPointHint>(&self, _: H) -> Vec<f64> {
        self.ticks.iter().map(|tick| tick.0).collect()
    }

    fn range(&self) -> Range<f64> {
        self.range.range()
    }

    /// It reaches to a tick that is all but within the range.
    fn axis_pixel_range(&self, limit: Place) -> Range<i32> {
        let Range { start, end } = self.range();
        let ticks = self.ticks.iter().map(|tick| tick.0);
        let places = ticks.chain([start, end]).map(|value| self.map(&value, limit));
        places.clone().min().unwrap_or(limit.0)..places.max().unwrap_or(limit.1)
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, value: &f64) -> String {
        let tick = self.ticks.iter().find(|tick| tick.0 == *value);
        tick.map(|tick| tick.1.clone()).unwrap_or_default()
    }
}

/// A mark of ours as an element of plotters.
pub(super) struct Mark<'a>(pub(super) &'a [Point], pub(super) &'a Paint);

/// Its places as they are: plotters' own elements move what is outside to the edge.
pub(super) struct Anywhere;

impl CoordMapper for Anywhere {
    type Output = Place;

    fn map<C: CoordTranslate>(coordinates: &C, point: &C::From, _: &Rect) -> Place {
        coordinates.translate(point)
    }
}

impl<'a> PointCollection<'a, Point, Anywhere> for &'a Mark<'_> {
    type Point = &'a Point;
    type IntoIter = &'a [Point];

    fn point_iter(self) -> &'a [Point] {
        self.0
    }
}

impl Drawable<Sheet<'_>, Anywhere> for Mark<'_> {
    fn draw<I: Iterator<Item = Place>>(
        &self,
        places: I,
        sheet: &mut Sheet<'_>,
        _: (u32, u32),
    ) -> Drawn {
        sheet.0.borrow_mut().mark(places.collect(), self.1);
        Ok(())
    }
}
