//! How a panel is painted: margins, axes, contents, labels.

use super::backend::Scale;
use super::canvas::{Canvas, Frame, Paint, Point, drawn, units};
use super::clip::{clipped, clipped_polygon};
use super::curve::{AXIS, Curve, LabelPlace};
use super::display::{Display, Stroke, Text};
use super::ink::Ink;
use super::label::{Label, SIZE};
use super::panel::{Panel, Rule};
use super::place::{GAP, HALO, Obstacles};
use super::stations::spread;
use super::words::{Rect, Side, Words};
use crate::error::Result;
use plotters::chart::ChartBuilder;
use rotation_dynamics::math::sort_by_number;

/// Length of ticks, and distance of the axes from the data.
const TICK: f64 = 5.0;
const OFFSET: f64 = 6.0;
/// Half the width of a mark on a curve, and of a dot.
const MARK: f64 = 2.6;
const DOT: f64 = 3.5;
/// Height of a line of text.
const LINE: f64 = 17.0;

impl Panel {
    fn place(&self, (x, y): Point) -> Result<Point> {
        Ok((self.x.place(x)?, self.y.place(y)?))
    }

    fn places(&self, points: &[Point]) -> Result<Vec<Point>> {
        points.iter().map(|&p| self.place(p)).collect()
    }

    /// The extents of both axes, in places.
    pub(super) fn extents(&self) -> Result<(Point, Point)> {
        let curves = self.curves.iter().map(|curve| &curve.points);
        let outlines = curves.chain(self.areas.iter().map(|area| &area.0));
        let all = outlines.map(|points| self.places(points));
        let all: Vec<Vec<Point>> = all.collect::<Result<_>>()?;
        let (mut xs, mut ys): (Vec<f64>, Vec<f64>) = all.into_iter().flatten().unzip();
        for (rule, ..) in &self.rules {
            match rule {
                Rule::Across(y) => ys.push(self.y.place(*y)?),
                Rule::Up(x) => xs.push(self.x.place(*x)?),
            }
        }
        Ok((self.x.extent(xs)?, self.y.extent(ys)?))
    }

    /// Ticks about 28 px apart; where a small range makes them closer, every second of them.
    fn y_ticks(&self, y: Point, height: f64) -> rotation_dynamics::Result<Vec<(f64, String)>> {
        let unit = height / (y.1 - y.0);
        let close = |ticks: &[(f64, String)]| {
            ticks.windows(2).any(|pair| (pair[1].0 - pair[0].0).abs() * unit < LINE - 1.0)
        };
        let mut ticks = self.y.marks(y, (height / 28.0).clamp(3.0, 6.0) as usize)?;
        while ticks.len() > 2 && close(&ticks) {
            ticks = ticks.into_iter().step_by(2).collect();
        }
        Ok(ticks)
    }

    /// The room that the labels of the vertical axis need.
    pub(super) fn left_margin(&self, y: Point, height: f64) -> Result<f64> {
        let ticks = self.y_ticks(y, height)?;
        let widest =
            ticks.iter().map(|(_, label)| Label::new(label).width(SIZE)).fold(0.0, f64::max);
        Ok(widest + OFFSET + TICK + 7.0)
    }

    /// The room around the plot on each side, given the left one.
    fn margins(&self, left: f64, labelled_x: bool) -> Rect {
        let end_labels = self.curves.iter().filter_map(|c| match &c.label {
            Some((text, LabelPlace::End)) => Some(Label::new(text).width(SIZE)),
            _ => None,
        });
        let ticks = OFFSET + TICK + LINE + 3.0;
        Rect {
            left,
            right: end_labels.fold(12.0, |margin, width| f64::max(margin, width + 14.0)),
            top: if self.y.label.is_empty() { 10.0 } else { LINE + 10.0 },
            bottom: match (labelled_x, self.x.label.is_empty()) {
                (false, _) => OFFSET,
                (true, true) => ticks + 3.0,
                (true, false) => ticks + LINE,
            },
        }
    }

    /// The size of the figure; with equal units the height follows from the width.
    pub(super) fn fitted_size(&self, left: f64, x: Point, y: Point) -> (u32, u32) {
        let (width, height) = self.size;
        if !self.equal {
            return (width, height);
        }
        let margins = self.margins(left, true);
        let across = f64::from(width) - margins.left - margins.right;
        let up = across * (y.1 - y.0) / (x.1 - x.0) + margins.top + margins.bottom;
        // Tall and narrow data are fitted into a square instead.
        (width, libm::ceil(up).clamp(120.0, f64::from(width)) as u32)
    }

    /// Draws it into `outer` (px), with a left margin and extents that may be shared.
    pub(super) fn paint(
        &self,
        canvas: &Canvas,
        outer: Rect,
        left: f64,
        x: Point,
        y: Point,
        labelled_x: bool,
    ) -> Result<()> {
        let margins = self.margins(left, labelled_x);
        let mut plot = Rect {
            left: outer.left + margins.left,
            right: outer.right - margins.right,
            top: outer.top + margins.top,
            bottom: outer.bottom - margins.bottom,
        };
        if self.equal {
            plot = equal_units(plot, x, y);
        }
        let (floor, wall) = (plot.bottom + OFFSET, plot.left - OFFSET);
        let most = ((plot.right - plot.left) / 48.0) as usize;
        let room = units(OFFSET) - 1;
        let x_scale = Scale::new(x, room, self.x.marks(x, most)?);
        let y_scale = Scale::new(y, room, self.y_ticks(y, plot.bottom - plot.top)?);
        let (area, whole) = (canvas.area(), canvas.rect());
        // Plotters counts the last pixel of an area as a part of it, and draws an axis on the first
        // pixel beyond.
        let right = units(whole.right - plot.right) - 1;
        let below = units(whole.bottom - floor);
        let mut builder = ChartBuilder::on(&area);
        builder.margin_top(units(plot.top)).margin_right(right);
        builder.y_label_area_size(units(wall) + 1);
        match labelled_x {
            true => builder.x_label_area_size(below),
            false => builder.margin_bottom(below),
        };
        let mut chart = drawn(builder.build_cartesian_2d(x_scale, y_scale));
        let frame = Frame(chart.plotting_area().clone());
        for (outline, ink) in &self.areas {
            let cut = clipped_polygon(&self.places(outline)?, x, y);
            frame.draw(&cut, &Paint::Fill(*ink, 0.18))?;
        }
        let mut mesh = chart.configure_mesh();
        mesh.disable_mesh().set_all_tick_mark_size(units(TICK));
        drawn(mesh.draw());

        let sheet = canvas.sheet();
        if labelled_x {
            let text = Words::new(&self.x.label, Ink::Ink, Side::BelowLeft, 0.0);
            let at = (plot.right, floor + TICK + LINE + 3.0);
            sheet.draw(&[at], &Paint::Text(text))?;
        }
        let text = Words::new(&self.y.label, Ink::Ink, Side::AboveRight, 0.0).bare();
        let at = (wall - TICK, plot.top - 8.0);
        let mut obstacles = Obstacles::new(Rect {
            left: plot.left,
            right: outer.right - 2.0,
            top: outer.top + 2.0,
            bottom: plot.bottom + 3.0,
        });
        if self.now.is_some() {
            // The dot of the present runs along the curves.
            obstacles.clear = 0.5 * HALO + DOT;
        }
        obstacles.add_line(Obstacles::NOBODY, &[(wall, plot.top), (wall, plot.bottom)]);
        obstacles.take(text.rect(at));
        sheet.draw(&[at], &Paint::Text(text))?;
        self.paint_contents(canvas, &frame, (x, y), plot, &mut obstacles)
    }

    fn paint_contents(
        &self,
        canvas: &Canvas,
        frame: &Frame<'_>,
        (x, y): (Point, Point),
        plot: Rect,
        obstacles: &mut Obstacles,
    ) -> Result<()> {
        let mut curves: Vec<Curve> = Vec::new();
        for (rule, ink, label) in &self.rules {
            let line = match rule {
                Rule::Across(at) => {
                    let at = self.y.place(*at)?;
                    [(x.0, at), (x.1, at)]
                }
                Rule::Up(at) => {
                    let at = self.x.place(*at)?;
                    [(at, y.0), (at, y.1)]
                }
            };
            let mut curve = Curve::new(line, *ink).thin();
            if !label.is_empty() {
                curve = curve.label(label);
            }
            curves.push(curve);
        }
        for curve in &self.curves {
            let mut curve = curve.clone();
            curve.points = self.places(&curve.points)?;
            curves.push(curve);
        }
        let lines: Vec<Vec<Vec<Point>>> = curves.iter().map(|c| clipped(&c.points, x, y)).collect();
        let kept = self.labels.as_ref().and_then(|labels| labels.get());
        let kept = kept.filter(|(placed, _)| *placed == plot);
        let now = self.now.map(|now| self.x.place(now)).transpose()?;
        for (i, (curve, parts)) in curves.iter().zip(&lines).enumerate() {
            match now {
                Some(now) if curve.runs_on() && i >= self.rules.len() => {
                    let before = clipped(&curve.points, (x.0, now), y);
                    let after = clipped(&curve.points, (now, x.1), y);
                    curve.clone().faint(0.3 * curve.opacity).paint(frame, &after, (now, x.1), y)?;
                    curve.paint(frame, &before, (x.0, now), y)?;
                }
                _ => curve.paint(frame, parts, x, y)?,
            }
            for part in parts.iter().filter(|_| kept.is_none()) {
                let px: Vec<Point> = part.iter().map(|&p| frame.px(p)).collect();
                obstacles.add_line(i, &px);
                for (x, y) in px.into_iter().filter(|_| curve.dots) {
                    obstacles.add_line(i, &[(x - MARK, y), (x + MARK, y)]);
                    obstacles.add_line(i, &[(x, y - MARK), (x, y + MARK)]);
                }
            }
        }
        for note in self.notes.iter().filter(|note| note.dot.is_some()) {
            obstacles.take(Rect::about(frame.px(self.place(note.at)?), DOT));
        }
        let placed;
        let labels = match kept {
            Some((_, labels)) => labels,
            None => {
                let apart = Canvas::new(canvas.display.borrow().size);
                self.paint_labels(&apart.sheet(), frame, &curves, &lines, plot, obstacles)?;
                placed = apart.display.into_inner();
                if let Some(kept) = &self.labels {
                    // Another frame may have been first.
                    let _ = kept.set((plot, placed.clone()));
                }
                &placed
            }
        };
        if let Some(now) = now {
            self.paint_now(&canvas.sheet(), frame, &curves[self.rules.len()..], (now, y), labels)?;
        }
        for note in &self.notes {
            if let Some(ring) = note.dot {
                frame.draw(&[self.place(note.at)?], &Paint::Dot(note.ink, DOT, ring))?;
            }
        }
        canvas.again(labels);
        Ok(())
    }

    /// The thin line at the present, parted by the labels that it passes, and a dot on each curve
    /// that runs through it.
    fn paint_now(
        &self,
        sheet: &Frame<'_>,
        frame: &Frame<'_>,
        curves: &[Curve],
        (now, y): (f64, Point),
        labels: &Display,
    ) -> Result<()> {
        let line = Paint::Line(Stroke::new(Ink::Frame, AXIS));
        let ((x, foot), (_, head)) = (frame.px((now, y.0)), frame.px((now, y.1)));
        let boxes = labels.texts.iter().flat_map(Text::boxes).map(|letters| letters.grown(HALO));
        let mut passed: Vec<Rect> =
            boxes.filter(|letters| (letters.left..=letters.right).contains(&x)).collect();
        sort_by_number(&mut passed, |letters| letters.top);
        let mut from = head;
        for letters in passed {
            if letters.top > from {
                sheet.draw(&[(x, from), (x, letters.top)], &line)?;
            }
            from = from.max(letters.bottom);
        }
        if from < foot {
            sheet.draw(&[(x, from), (x, foot)], &line)?;
        }
        for curve in curves.iter().filter(|c| c.line && c.runs_on()) {
            let at = clipped(&curve.points, (now, now), y);
            if let Some(&at) = at.first().and_then(|part| part.first()) {
                frame.draw(&[at], &Paint::Dot(curve.ink, DOT, false))?;
            }
        }
        Ok(())
    }

    fn paint_labels(
        &self,
        sheet: &Frame<'_>,
        frame: &Frame<'_>,
        curves: &[Curve],
        lines: &[Vec<Vec<Point>>],
        plot: Rect,
        obstacles: &mut Obstacles,
    ) -> Result<()> {
        let at_points = curves.iter().filter_map(|curve| match &curve.label {
            Some((text, LabelPlace::At(at, side))) => Some((*at, text, curve.ink, *side, GAP)),
            _ => None,
        });
        let notes = self.notes.iter();
        let notes = notes.map(|note| (note.at, &note.text, note.ink, note.side, GAP + 2.0));
        for (at, text, ink, side, gap) in at_points.chain(notes).filter(|n| !n.1.is_empty()) {
            let at = frame.px(self.place(at)?);
            let words = |side, gap| Words::new(text, ink, side, gap);
            if let Some(placed) = obstacles.place_at(at, side, gap, words) {
                placed.paint(sheet)?;
            }
        }
        // Of each curve with a label at its end: the label and where the curve ends.
        let at_ends = curves.iter().zip(lines).filter_map(|(curve, parts)| match &curve.label {
            Some((text, LabelPlace::End)) => {
                let end = frame.px(*parts.last()?.last()?);
                Some((Words::new(text, curve.ink, Side::Right, GAP + 2.0), end))
            }
            _ => None,
        });
        let at_ends: Vec<(Words, Point)> = at_ends.collect();
        let mut heights: Vec<(usize, f64)> =
            at_ends.iter().map(|(_, end)| end.1).enumerate().collect();
        // The tail of an index is below the line.
        spread(&mut heights, LINE + 1.0, plot.top - 8.0, plot.bottom + 8.0);
        for (i, height) in heights {
            let (words, end) = &at_ends[i];
            let at = (end.0, height);
            obstacles.take(words.rect(at));
            sheet.draw(&[at], &Paint::Text(words.clone()))?;
        }
        let found = curves.iter().enumerate().filter_map(|(i, curve)| match &curve.label {
            Some((text, LabelPlace::Found)) => Some((i, curve.ink, text)),
            _ => None,
        });
        let mut found: Vec<(usize, Ink, &String)> = found.collect();
        // The longest is the hardest to place: it chooses first.
        sort_by_number(&mut found, |label| -(label.2.len() as f64));
        for (i, ink, text) in found {
            let Some(longest) = lines[i].iter().max_by_key(|part| part.len()) else {
                continue;
            };
            let px: Vec<Point> = longest.iter().map(|&p| frame.px(p)).collect();
            let words = |side, gap| Words::new(text, ink, side, gap);
            if let Some(placed) = obstacles.place(i, &px, words) {
                placed.paint(sheet)?;
            }
        }
        Ok(())
    }
}

/// `plot` made smaller so that a unit is as long across as up.
fn equal_units(plot: Rect, x: Point, y: Point) -> Rect {
    let (width, height) = (plot.right - plot.left, plot.bottom - plot.top);
    let unit = (width / (x.1 - x.0)).min(height / (y.1 - y.0));
    let spare = (width - unit * (x.1 - x.0)) / 2.0;
    Rect {
        left: plot.left + spare,
        right: plot.right - spare,
        top: plot.bottom - unit * (y.1 - y.0),
        bottom: plot.bottom,
    }
}
