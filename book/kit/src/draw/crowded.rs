//! Whether a drawing can be read: every label whole, large enough, apart from the others and clear
//! of lines.
//!
//! A line counts if the eye follows it: at least 1 px wide, or 1.5 px if it is broken, at least half
//! opaque, and not behind a body. Thinner and fainter lines are guides; they may pass below a label,
//! whose halo parts them. What is filled may lie below a label as a whole.

use super::canvas::Point;
use super::display::{Anchor, Dash, Display, Place, Run, Shape, Text, UNITS};
use super::label::width;
use super::words::Rect;
use rotation_dynamics::math::hypot;

/// Of the 2 px of their halo, letters keep this much clear of lines, in px.
const CLEAR: f64 = 1.5;
/// The width of a halo: as much lies between labels, in px.
pub(super) const APART: f64 = 2.0;
/// The width of a space: labels that are closer on one line are read as one text, in px.
pub(super) const SPACE: f64 = 4.0;
/// The smallest size of letters on a phone, where a figure is as wide as [`PHONE`], in px.
const SMALLEST: f64 = 11.0;
const PHONE: f64 = 340.0;
/// Between a slanted letter, which leans to the right, and its prime, parts of its size.
const PRIME: f64 = 0.12;

/// How far the letters of a run reach above and below its baseline, parts of its size.
fn reach(run: &Run) -> (f64, f64) {
    let above = |c: char| match c {
        '\u{300}'..='\u{36f}' => 0.8,
        _ if c.is_whitespace() => 0.0,
        '−' | '-' | '=' | '+' | '×' | '≈' | '·' | '→' => 0.5,
        'a'
        | 'c'
        | 'e'
        | 'g'
        | 'm'..='s'
        | 'u'..='z'
        | 'α'
        | 'γ'
        | 'ε'
        | 'η'
        | 'κ'
        | 'μ'
        | 'ν'
        | 'π'
        | 'ρ'
        | 'σ'
        | 'τ'
        | 'φ'
        | 'χ'
        | 'ω'
        | ','
        | '.' => 0.53,
        _ => 0.73,
    };
    let below = |c: char| match c {
        'g' | 'j' | 'p' | 'q' | 'y' | 'Q' | '(' | ')' | '[' | ']' | '/' | ',' | ';' | 'β' | 'γ'
        | 'ζ' | 'η' | 'μ' | 'ξ' | 'ρ' | 'φ' | 'χ' | 'ψ' => 0.21,
        'f' if run.slanted => 0.21,
        _ => 0.0,
    };
    let most = |reach: &dyn Fn(char) -> f64| run.text.chars().map(reach).fold(0.0, f64::max);
    (most(&above), most(&below))
}

impl Text {
    fn says(&self) -> String {
        let all: String = self.runs.iter().map(|run| &*run.text).collect();
        all.replace('\u{200a}', "")
    }

    /// The boxes of its letters, in px: one for each run, without the space around it.
    pub(super) fn boxes(&self) -> Vec<Rect> {
        let size = |run: &Run, text: &str| width(text, run.slanted) * run.size;
        let whole: f64 = self.runs.iter().map(|run| size(run, &run.text)).sum();
        let (x, baseline) = (f64::from(self.at.0) / UNITS, f64::from(self.at.1) / UNITS);
        let mut left = match self.anchor {
            Anchor::Start => x,
            Anchor::Middle => x - 0.5 * whole,
            Anchor::End => x - whole,
        };
        let mut found = Vec::new();
        for run in &self.runs {
            let begin = left;
            left += size(run, &run.text);
            let letters = run.text.trim_start();
            let before = size(run, &run.text[..run.text.len() - letters.len()]);
            let ((above, below), base) = (reach(run), baseline + run.drop);
            if !letters.is_empty() {
                found.push(Rect {
                    left: begin + before,
                    right: begin + before + size(run, letters.trim_end()),
                    top: base - above * run.size,
                    bottom: base + below * run.size,
                });
            }
        }
        found
    }

    /// Whether a prime touches the slanted letter before it.
    fn prime_touches(&self) -> bool {
        let letters =
            self.runs.iter().flat_map(|run| run.text.chars().map(move |c| (c, run.slanted)));
        let (mut leaning, mut space) = (false, 0.0);
        for (c, slanted) in letters {
            match c {
                '′' if leaning && space < PRIME => return true,
                _ if c.is_whitespace() => space += width(c.encode_utf8(&mut [0; 4]), slanted),
                _ => (leaning, space) = (slanted, 0.0),
            }
        }
        false
    }
}

/// By how much two boxes are closer than they must be, in px.
fn too_close(a: &Rect, b: &Rect) -> f64 {
    let across = a.right.min(b.right) - a.left.max(b.left);
    let up = a.bottom.min(b.bottom) - a.top.max(b.top);
    let on_one_line = up > 0.5 * (a.bottom - a.top).min(b.bottom - b.top);
    (across + if on_one_line { SPACE } else { APART }).min(up + APART)
}

fn px(&(x, y): &Place) -> Point {
    (f64::from(x) / UNITS, f64::from(y) / UNITS)
}

/// Whether a point lies within an outline.
fn within(outline: &[Place], (x, y): Point) -> bool {
    let mut inside = false;
    let ends = outline.iter().zip(outline.iter().cycle().skip(1));
    for ((ax, ay), (bx, by)) in ends.map(|(a, b)| (px(a), px(b))) {
        if (ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax {
            inside = !inside;
        }
    }
    inside
}

/// What of a shape a label must be clear of: its outline, and half its width in px.
fn seen(shape: &Shape) -> Option<(Vec<Place>, f64)> {
    match shape {
        Shape::Line(points, closed, stroke)
            if stroke.opacity >= 0.5
                && stroke.width >= if stroke.dash == Dash::Solid { 1.0 } else { 1.5 } =>
        {
            let back = points.first().filter(|_| *closed);
            Some((points.iter().chain(back).copied().collect(), 0.5 * stroke.width))
        }
        // The head of an arrow, or the mark of a value.
        Shape::Area(points, _, opacity) if *opacity >= 0.5 && points.len() <= 4 => {
            let span = |of: fn(&Place) -> i32| {
                let values = points.iter().map(of);
                values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
            };
            let small = 14 * UNITS as i32;
            let mark = span(|p| p.0) < small && span(|p| p.1) < small;
            mark.then(|| (points.iter().chain(points.first()).copied().collect(), 0.0))
        }
        Shape::Dot(at, radius, ..) => Some((vec![*at, *at], *radius)),
        _ => None,
    }
}

impl Display {
    /// What is hard to read, a sentence for each: nothing for a good figure.
    pub fn crowded(&self) -> Vec<String> {
        self.faults(0.0, true)
    }

    /// Labels that leave the drawing or lie on one another: none in any frame of a moving picture.
    pub fn collided(&self) -> Vec<String> {
        self.faults(SPACE, false)
    }

    /// What is wrong with labels: those that are closer than they may be by more than this (px), and,
    /// if they are asked for, those that lines cross.
    fn faults(&self, more: f64, lines: bool) -> Vec<String> {
        let labels: Vec<(&Text, Vec<Rect>)> = self.texts.iter().map(|t| (t, t.boxes())).collect();
        let mut found = Vec::new();
        for (i, (text, boxes)) in labels.iter().enumerate() {
            let says = text.says();
            let alone = self.alone(text, boxes).into_iter();
            found.extend(alone.map(|fault| format!("“{says}” {fault}")));
            for (other, others) in &labels[..i] {
                let pairs = boxes.iter().flat_map(|a| others.iter().map(move |b| too_close(a, b)));
                let worst = pairs.fold(0.0, f64::max);
                if worst > more {
                    let other = other.says();
                    found.push(format!("“{says}” is too close to “{other}” by {worst:.1} px"));
                }
            }
            for (ink, length) in self.crossing(boxes).into_iter().filter(|_| lines) {
                found.push(format!("“{says}” is crossed by {length:.1} px of a line in {ink}"));
            }
        }
        found
    }

    /// What is wrong with a label by itself.
    fn alone(&self, text: &Text, boxes: &[Rect]) -> Vec<String> {
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let beyond = |b: &Rect| (-b.left).max(b.right - width).max(-b.top).max(b.bottom - height);
        let beyond = boxes.iter().map(beyond).fold(0.0, f64::max);
        let scale = (PHONE / width).min(1.0);
        let smallest = text.runs.iter().map(|run| run.size * scale).fold(SMALLEST, f64::min);
        let mut found = Vec::new();
        if beyond > 1.0 {
            found.push(format!("leaves the figure by {beyond:.1} px"));
        }
        if smallest < SMALLEST {
            found.push(format!("has {smallest:.1} px on a phone"));
        }
        if text.prime_touches() {
            found.push("has a prime that touches its letter".into());
        }
        found
    }

    /// The lines that come too close to these boxes: their inks, and how much of them, in px.
    fn crossing(&self, boxes: &[Rect]) -> Vec<(&'static str, f64)> {
        let mut found: Vec<(&'static str, f64)> = Vec::new();
        for (i, shape) in self.shapes.iter().enumerate() {
            let Some((points, half)) = seen(shape) else { continue };
            let boxes: Vec<Rect> = boxes.iter().map(|b| b.grown(half + CLEAR)).collect();
            let inside: f64 =
                points.windows(2).map(|pair| self.within_boxes(i, pair, &boxes)).sum();
            if inside > 1.0 {
                let ink = shape.ink().colour().name;
                match found.iter_mut().find(|(name, _)| *name == ink) {
                    Some((_, length)) => *length += inside,
                    None => found.push((ink, inside)),
                }
            }
        }
        found
    }

    /// How much of a straight piece of shape number `i` lies in the boxes and is seen there, in px.
    fn within_boxes(&self, i: usize, pair: &[Place], boxes: &[Rect]) -> f64 {
        let (a, b) = (px(&pair[0]), px(&pair[1]));
        let near = |r: &Rect| {
            a.0.min(b.0) < r.right
                && a.0.max(b.0) > r.left
                && a.1.min(b.1) < r.bottom
                && a.1.max(b.1) > r.top
        };
        if !boxes.iter().any(near) {
            return 0.0;
        }
        let length = hypot(b.0 - a.0, b.1 - a.1);
        // A dot has no length, and all of it counts.
        let steps = (2.0 * length) as usize + 1;
        let part = if length == 0.0 { 2.0 } else { length } / steps as f64;
        let hidden = |p: Point| {
            self.shapes[i + 1..].iter().any(|shape| match shape {
                Shape::Face(outline, ..) => within(outline, p),
                Shape::Area(outline, _, opacity) if *opacity > 0.9 => within(outline, p),
                _ => false,
            })
        };
        let counts = (0..steps).filter(|&k| {
            let s = (k as f64 + 0.5) / steps as f64;
            let p = (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1));
            boxes.iter().any(|r| r.contains(p)) && !hidden(p)
        });
        part * counts.count() as f64
    }
}

#[cfg(test)]
mod tests {
    use super::super::display::Stroke;
    use super::super::ink::Ink;
    use super::super::label::{Label, SIZE};
    use super::*;

    fn label(text: &str, (x, y): Place) -> Text {
        let runs = Label::new(text).runs(SIZE);
        Text { at: (100 * x, 100 * y), anchor: Anchor::Start, ink: Ink::Ink, halo: true, runs }
    }

    fn line(y: i32, change: impl Fn(Stroke) -> Stroke) -> Shape {
        Shape::Line(
            vec![(0, 100 * y), (20000, 100 * y)],
            false,
            change(Stroke::new(Ink::Body, 1.8)),
        )
    }

    fn found(shapes: Vec<Shape>, texts: Vec<Text>) -> Vec<String> {
        Display { size: (200, 100), shapes, texts }.crowded()
    }

    #[test]
    fn labels_are_apart() {
        let beside = |at| found(vec![], vec![label("air", (20, 50)), label("creaking", at)]);
        // The first ends at 35.55.
        assert_eq!(beside((42, 50)), Vec::<String>::new());
        assert_eq!(beside((39, 50)), ["“creaking” is too close to “air” by 0.6 px"]);
        assert_eq!(beside((20, 63)), Vec::<String>::new());
        assert_eq!(beside((20, 60)).len(), 1);
        let on = |at| {
            let texts = vec![label("air", (20, 50)), label("creaking", at)];
            Display { size: (200, 100), shapes: vec![], texts }.collided().len()
        };
        assert_eq!([on((34, 50)), on((39, 50)), on((183, 30))], [1, 0, 1]);
    }

    #[test]
    fn labels_are_whole_and_large_enough() {
        let at = |at| found(vec![], vec![label("air", at)]);
        assert_eq!(at((183, 50)), Vec::<String>::new());
        assert_eq!(at((187, 50)), ["“air” leaves the figure by 2.6 px"]);
        assert_eq!(at((20, 8)), ["“air” leaves the figure by 2.2 px"]);
        let wide =
            Display { size: (400, 100), shapes: vec![], texts: vec![label("$x_1$", (20, 50))] };
        assert_eq!(wide.crowded(), ["“x1” has 9.4 px on a phone"]);
    }

    #[test]
    fn lines_that_the_eye_follows_keep_clear_of_labels() {
        let near = |shapes| found(shapes, vec![label("air", (20, 50))]).len();
        assert_eq!([near(vec![line(45, |s| s)]), near(vec![line(52, |s| s)])], [1, 1]);
        assert_eq!([near(vec![line(36, |s| s)]), near(vec![line(53, |s| s)])], [0, 0]);
        // Guides may pass below, and what a body hides is not seen.
        let guides: [fn(Stroke) -> Stroke; 3] = [
            |s| Stroke { width: 0.8, ..s },
            |s| Stroke { width: 1.4, dash: Dash::Dashed, ..s },
            |s| s.faint(0.3),
        ];
        for guide in guides {
            assert_eq!(near(vec![line(45, guide)]), 0);
        }
        let body = Shape::Area(vec![(0, 0), (20000, 0), (20000, 9000), (0, 9000)], Ink::Body, 1.0);
        assert_eq!(near(vec![line(45, |s| s), body.clone()]), 0);
        assert_eq!(near(vec![body, line(45, |s| s)]), 1);
        // The head of an arrow, and a dot.
        let head = Shape::Area(vec![(2500, 4500), (3300, 4200), (3300, 4800)], Ink::Force, 1.0);
        assert_eq!(near(vec![head]), 1);
        assert_eq!(near(vec![Shape::Dot((1700, 4500), 2.6, Ink::Body, false)]), 1);
        assert_eq!(near(vec![Shape::Dot((1500, 4500), 2.6, Ink::Body, false)]), 0);
    }

    #[test]
    fn primes_are_clear_of_their_letters() {
        let mut prime = label("$x'$", (20, 50));
        assert_eq!(found(vec![], vec![prime.clone()]), Vec::<String>::new());
        prime.runs[1].text = "\u{200a}′".into();
        assert_eq!(found(vec![], vec![prime]), ["“x′” has a prime that touches its letter"]);
    }
}
