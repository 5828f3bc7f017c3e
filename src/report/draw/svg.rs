//! A plotters backend that writes our SVG.
//!
//! Plotters' own backend has whole pixels and literal colours, and neither dashes
//! nor slanted or raised text. This one counts in hundredths of a pixel, turns the
//! palette's colours into CSS variables, and thins curves to what can be seen.

use super::ink::{Ink, PALETTE};
use super::label::{Label, escaped};
use core::convert::Infallible;
use core::fmt::Write;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    text_anchor::HPos,
};

/// Units of a backend coordinate in a pixel.
pub(super) const UNITS: f64 = 100.0;

/// How a line is broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Not at all.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stroke {
    pub ink: Ink,
    pub width: f64,
    pub dash: Dash,
    pub opacity: f64,
}

impl Stroke {
    pub(super) const fn new(ink: Ink, width: f64) -> Self {
        Self {
            ink,
            width,
            dash: Dash::Solid,
            opacity: 1.0,
        }
    }
}

/// Where a text lies relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// The backend; the document is complete after `present`.
pub(super) struct Svg<'a> {
    out: &'a mut String,
    size: (u32, u32),
    closed: bool,
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl<'a> Svg<'a> {
    /// Opens a document of `size` pixels with alternative text `alt`.
    pub(super) fn open(out: &'a mut String, size: (u32, u32), alt: &str) -> Self {
        let (w, h) = size;
        let alt = escaped(alt);
        // Writing to a string cannot fail, here and below.
        let _ = write!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" viewBox=\"0 0 {w} {h}\" \
             width=\"{w}\" height=\"{h}\" role=\"img\" aria-label=\"{alt}\" fill=\"none\" \
             stroke-linejoin=\"round\" font-size=\"{size}\" font-family=\"{SANS}\">\n\
             <desc>{alt}</desc>\n\
             <style>.fig .v{{font-style:italic;font-family:var(--fig-math,{SERIF})}}\
             .fig .h{{paint-order:stroke;stroke-width:4px;stroke:{paper}}}</style>\n\
             <rect width=\"{w}\" height=\"{h}\" style=\"fill:{paper}\"/>\n",
            size = super::label::SIZE,
            paper = Ink::Paper.line(),
        );
        Self {
            out,
            size,
            closed: false,
        }
    }

    pub(super) fn line(&mut self, points: &[BackendCoord], stroke: Stroke, closed: bool) {
        if points.len() < 2 {
            return;
        }
        let data = path_data(&thinned(points), closed);
        let dash = match stroke.dash {
            Dash::Solid => "",
            Dash::Dashed => " stroke-dasharray=\"6 4\"",
            Dash::Dotted => " stroke-dasharray=\"0.1 4\" stroke-linecap=\"round\"",
        };
        let _ = writeln!(
            self.out,
            "<path d=\"{data}\" stroke-width=\"{}\"{dash}{} style=\"stroke:{}\"/>",
            stroke.width,
            opacity(stroke.opacity),
            stroke.ink.line(),
        );
    }

    pub(super) fn fill(&mut self, points: &[BackendCoord], ink: Ink, alpha: f64) {
        if points.len() < 3 {
            return;
        }
        let data = path_data(&thinned(points), true);
        let _ = writeln!(
            self.out,
            "<path d=\"{data}\"{} style=\"fill:{}\"/>",
            opacity(alpha),
            ink.line()
        );
    }

    /// A face of a solid, `percent` of `ink` on paper. The rim has the same colour, so
    /// that neighbours leave no seam.
    pub(super) fn face(&mut self, points: &[BackendCoord], ink: Ink, percent: u32) {
        let data = path_data(&thinned(points), true);
        let plain = ink.mixed(percent);
        let mix = format!(
            "color-mix(in srgb,{} {percent}%,{})",
            ink.line(),
            Ink::Paper.line()
        );
        let _ = writeln!(
            self.out,
            "<path d=\"{data}\" stroke-width=\"0.6\" \
             style=\"fill:{plain};stroke:{plain};fill:{mix};stroke:{mix}\"/>"
        );
    }

    /// A disc, or with `ring` a circle filled with paper.
    pub(super) fn dot(&mut self, at: BackendCoord, radius: f64, ink: Ink, ring: bool) {
        let (x, y) = (hundredths(at.0), hundredths(at.1));
        let paint = if ring {
            format!(
                "fill:{};stroke:{};stroke-width:1.5px",
                Ink::Paper.line(),
                ink.line()
            )
        } else {
            format!("fill:{}", ink.line())
        };
        let _ = writeln!(
            self.out,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" style=\"{paint}\"/>"
        );
    }

    /// Text with its baseline at `at`, with a halo of paper around it.
    pub(super) fn text(
        &mut self,
        at: BackendCoord,
        label: &Label,
        size: f64,
        anchor: Anchor,
        ink: Ink,
    ) {
        let (x, y) = (hundredths(at.0), hundredths(at.1));
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let font = if size == super::label::SIZE {
            String::new()
        } else {
            format!(" font-size=\"{size}\"")
        };
        let _ = writeln!(
            self.out,
            "<text x=\"{x}\" y=\"{y}\"{anchor}{font} class=\"h\" style=\"fill:{}\">{}</text>",
            ink.text(),
            label.svg(size)
        );
    }
}

/// Faces of words and figures, unless the page's CSS names another.
const SANS: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans',sans-serif";
/// Faces of variables, unless the page's CSS sets `--fig-math`.
const SERIF: &str = "'STIX Two Text','Times New Roman','Liberation Serif',serif";

fn opacity(alpha: f64) -> String {
    if alpha == 1.0 {
        String::new()
    } else {
        format!(" opacity=\"{alpha}\"")
    }
}

/// A backend coordinate in px, without superfluous zeros.
fn hundredths(units: i32) -> String {
    let text = format!(
        "{}{}.{:02}",
        if units < 0 { "-" } else { "" },
        units.unsigned_abs() / 100,
        units.unsigned_abs() % 100
    );
    text.trim_end_matches('0').trim_end_matches('.').into()
}

fn path_data(points: &[BackendCoord], closed: bool) -> String {
    let mut data = String::new();
    for (i, &(x, y)) in points.iter().enumerate() {
        let separator = match i {
            0 => "M",
            1 => "L",
            _ => " ",
        };
        let _ = write!(data, "{separator}{},{}", hundredths(x), hundredths(y));
    }
    if closed {
        data.push('Z');
    }
    data
}

/// Drops points that lie within 0.04 px of the line through those kept
/// (Douglas and Peucker, 1973).
fn thinned(points: &[BackendCoord]) -> Vec<BackendCoord> {
    const NEAR: f64 = 4.0;
    let Some(last) = points.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[last] = true;
    let mut spans = vec![(0, last)];
    while let Some((a, b)) = spans.pop() {
        let farthest = (a + 1..b)
            .map(|i| (i, distance(points[i], points[a], points[b])))
            .fold(
                (a, NEAR),
                |best, next| if next.1 > best.1 { next } else { best },
            );
        if farthest.0 != a {
            keep[farthest.0] = true;
            spans.push((a, farthest.0));
            spans.push((farthest.0, b));
        }
    }
    let kept = points.iter().zip(keep);
    kept.filter_map(|(p, keep)| keep.then_some(*p)).collect()
}

/// The distance of `p` from the segment `ab`.
fn distance(p: BackendCoord, a: BackendCoord, b: BackendCoord) -> f64 {
    let vector = |from: BackendCoord, to: BackendCoord| {
        (
            f64::from(to.0) - f64::from(from.0),
            f64::from(to.1) - f64::from(from.1),
        )
    };
    let ((dx, dy), (px, py)) = (vector(a, b), vector(a, p));
    let length = dx * dx + dy * dy;
    let along = if length == 0.0 {
        0.0
    } else {
        ((px * dx + py * dy) / length).clamp(0.0, 1.0)
    };
    crate::math::hypot(px - along * dx, py - along * dy)
}

/// The ink whose line has this colour; anything else is ink.
fn ink_of(color: BackendColor) -> Ink {
    let (r, g, b) = color.rgb;
    let rgb = u32::from(r) << 16 | u32::from(g) << 8 | u32::from(b);
    PALETTE
        .iter()
        .find(|c| c.line == rgb)
        .map_or(Ink::Ink, |c| c.ink)
}

fn stroke_of<S: BackendStyle>(style: &S) -> Stroke {
    Stroke {
        opacity: style.color().alpha,
        ..Stroke::new(ink_of(style.color()), f64::from(style.stroke_width()))
    }
}

/// What plotters' own elements and series call; colours outside the palette
/// become ink.
impl DrawingBackend for Svg<'_> {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        (self.size.0 * 100, self.size.1 * 100)
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        if !self.closed {
            self.out.push_str("</svg>\n");
            self.closed = true;
        }
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        self.dot(point, 0.5, ink_of(color), false);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let points: Vec<BackendCoord> = path.into_iter().collect();
        self.line(&points, stroke_of(style), false);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        self.line(&[from, to], stroke_of(style), false);
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        self.dot(
            center,
            f64::from(radius) / UNITS,
            ink_of(style.color()),
            !fill,
        );
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let points: Vec<BackendCoord> = path.into_iter().collect();
        self.fill(&points, ink_of(style.color()), style.color().alpha);
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        pos: BackendCoord,
    ) -> Drawn {
        let anchor = match style.anchor().h_pos {
            HPos::Left => Anchor::Start,
            HPos::Center => Anchor::Middle,
            HPos::Right => Anchor::End,
        };
        self.text(
            pos,
            &Label::new(text),
            super::label::SIZE,
            anchor,
            ink_of(style.color()),
        );
        Ok(())
    }
}
