//! A display list written down as SVG: colours are CSS variables of the palette, the
//! bytes follow from the list alone.

use super::display::{Anchor, Dash, Display, Place, Run, Shape, Stroke, Text};
use super::ink::Ink;
use super::label::SIZE;
use crate::Figure;
use core::fmt::Write;
use std::collections::BTreeSet;

/// Faces of words and figures, unless the page's CSS names another.
const SANS: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans',sans-serif";
/// Faces of variables, unless the page's CSS sets `--fig-math`.
const SERIF: &str = "'STIX Two Text','Times New Roman','Liberation Serif',serif";

impl Figure {
    /// The whole SVG document; deterministic to the byte. A frame that a page paints needs none.
    pub fn svg(&self) -> String {
        document(&self.display, &self.alt)
    }
}

/// The document of `display`, with alternative text `alt`.
fn document(display: &Display, alt: &str) -> String {
    let (w, h) = display.size;
    let (paper, alt) = (Ink::Paper.line(), escaped(alt));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" viewBox=\"0 0 {w} {h}\" \
         width=\"{w}\" height=\"{h}\" role=\"img\" aria-label=\"{alt}\" fill=\"none\" \
         stroke-linejoin=\"round\" font-size=\"{SIZE}\" font-family=\"{SANS}\">\n\
         <style>.fig .v{{font-style:italic;font-family:var(--fig-math,{SERIF})}}\
         .fig .h{{fill:{paper};stroke:{paper};stroke-width:4px}}{}</style>\n\
         <rect width=\"{w}\" height=\"{h}\" style=\"fill:{paper}\"/>\n",
        faces(display),
    );
    for item in &display.shapes {
        shape(&mut out, item);
    }
    // All halos first: one that came later would eat its neighbour's letters.
    if display.texts.iter().any(|t| t.halo) {
        out.push_str("<g class=\"h\" aria-hidden=\"true\">\n");
        for item in display.texts.iter().filter(|t| t.halo) {
            text(&mut out, item, "");
        }
        out.push_str("</g>\n");
    }
    for item in &display.texts {
        text(&mut out, item, &format!(" style=\"fill:{}\"", item.ink.text()));
    }
    out.push_str("</svg>\n");
    out
}

/// `text` with the characters that XML reserves replaced.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The rules of the faces that occur. A page holds many figures in one style sheet: the
/// name says all of the colour, so that the same name is the same rule.
fn faces(display: &Display) -> String {
    let used: BTreeSet<(usize, u32)> = display
        .shapes
        .iter()
        .filter_map(|shape| match shape {
            Shape::Face(_, ink, light) => Some((*ink as usize, *light)),
            _ => None,
        })
        .collect();
    used.iter().fold(String::new(), |mut rules, &(ink, light)| {
        let colour = super::ink::PALETTE[ink];
        let (plain, mix) = (colour.ink.lit(light), colour.ink.lit_css(light));
        // Writing to a string cannot fail, here and below.
        let _ = write!(
            rules,
            ".fig .{}-{light}{{fill:{plain};stroke:{plain};fill:{mix};stroke:{mix}}}",
            colour.name
        );
        rules
    })
}

fn shape(out: &mut String, shape: &Shape) {
    let _ = match shape {
        Shape::Line(points, closed, stroke) => line(out, points, *closed, *stroke),
        Shape::Area(points, ink, alpha) => writeln!(
            out,
            "<path d=\"{}\"{} style=\"fill:{}\"/>",
            path_data(points, true),
            opacity(*alpha),
            ink.line()
        ),
        Shape::Face(points, ink, light) => writeln!(
            out,
            "<path d=\"{}\" stroke-width=\"1\" class=\"{}-{light}\"/>",
            path_data(points, true),
            ink.colour().name
        ),
        Shape::Dot(at, radius, ink, ring) => {
            let paint = if *ring {
                format!("fill:{};stroke:{};stroke-width:1.5px", Ink::Paper.line(), ink.line())
            } else {
                format!("fill:{}", ink.line())
            };
            writeln!(
                out,
                "<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\" style=\"{paint}\"/>",
                hundredths(at.0),
                hundredths(at.1)
            )
        }
    };
}

fn line(out: &mut String, points: &[Place], closed: bool, stroke: Stroke) -> core::fmt::Result {
    let dash = stroke.dash.pattern().map_or(String::new(), |[on, off]| {
        let ends = if stroke.dash == Dash::Dotted { " stroke-linecap=\"round\"" } else { "" };
        format!(" stroke-dasharray=\"{on} {off}\"{ends}")
    });
    writeln!(
        out,
        "<path d=\"{}\" stroke-width=\"{}\"{dash}{} style=\"stroke:{}\"/>",
        path_data(points, closed),
        stroke.width,
        opacity(stroke.opacity),
        stroke.ink.line(),
    )
}

fn text(out: &mut String, text: &Text, style: &str) {
    let anchor = match text.anchor {
        Anchor::Start => "",
        Anchor::Middle => " text-anchor=\"middle\"",
        Anchor::End => " text-anchor=\"end\"",
    };
    let _ = writeln!(
        out,
        "<text x=\"{}\" y=\"{}\"{anchor}{style}>{}</text>",
        hundredths(text.at.0),
        hundredths(text.at.1),
        spans(&text.runs)
    );
}

/// The content of a `<text>` element.
fn spans(runs: &[Run]) -> String {
    let mut out = String::new();
    let mut drop = 0.0;
    for run in runs {
        let mut attributes = String::new();
        if run.drop != drop {
            let _ = write!(attributes, " dy=\"{:.1}\"", run.drop - drop);
            drop = run.drop;
        }
        if run.size != SIZE {
            let _ = write!(attributes, " font-size=\"{:.1}\"", run.size);
        }
        if run.slanted {
            attributes.push_str(" class=\"v\"");
        }
        let text = escaped(&run.text);
        let _ = if attributes.is_empty() {
            write!(out, "{text}")
        } else {
            write!(out, "<tspan{attributes}>{text}</tspan>")
        };
    }
    out
}

fn opacity(alpha: f64) -> String {
    if alpha == 1.0 {
        return String::new();
    }
    let text = format!("{alpha:.3}");
    format!(" opacity=\"{}\"", text.trim_end_matches('0'))
}

/// A coordinate in px, without superfluous zeros.
fn hundredths(units: i32) -> String {
    let text = format!(
        "{}{}.{:02}",
        if units < 0 { "-" } else { "" },
        units.unsigned_abs() / 100,
        units.unsigned_abs() % 100
    );
    text.trim_end_matches('0').trim_end_matches('.').into()
}

fn path_data(points: &[Place], closed: bool) -> String {
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

#[cfg(test)]
mod tests {
    use super::super::label::Label;
    use super::*;

    #[test]
    fn only_variables_are_slanted_and_the_baseline_returns() {
        assert_eq!(
            spans(&Label::new(r"$x_1=2$ m").runs(SIZE)),
            "<tspan font-size=\"15.1\" class=\"v\">x</tspan><tspan dy=\"3.4\" font-size=\"11.1\">1</tspan>\
             <tspan dy=\"-3.4\">\u{2009}=\u{2009}2 m</tspan>"
        );
        assert!(spans(&Label::new(r"$\sin(x)$").runs(SIZE)).starts_with("sin(<tspan"));
    }

    #[test]
    fn halos_lie_below_all_letters_and_are_not_read() {
        let label = |at, halo| Text {
            at,
            anchor: Anchor::Start,
            ink: Ink::Body,
            halo,
            runs: Label::new("$t'$").runs(SIZE),
        };
        let display = Display {
            size: (50, 40),
            shapes: vec![],
            texts: vec![label((1000, 2000), true), label((2000, 2000), false)],
        };
        let svg = document(&display, "two labels");
        let (below, above) = svg.split_once("</g>").expect("a group of halos");
        assert!(below.contains("<g class=\"h\" aria-hidden=\"true\">"));
        assert_eq!(below.matches("<text").count(), 1);
        assert_eq!(above.matches("<text").count(), 2);
    }

    #[test]
    fn coordinates_are_short() {
        assert_eq!([0, 5, -5, 1200, -1250].map(hundredths), ["0", "0.05", "-0.05", "12", "-12.5"]);
        assert_eq!(opacity(0.07), " opacity=\"0.07\"");
    }
}
