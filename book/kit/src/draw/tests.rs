//! What no locked figure of the book shows.

use super::canvas::Paint;
use super::display::{Dash, Shape, Stroke};
use super::label::{Label, SIZE};
use super::{Axis, Curve, Ink, Panel, Side, Sketch, Solid, View};
use crate::Result;
use core::f64::consts::PI;
use rotation_dynamics::frame::SpaceVector;

fn sheet() -> Sketch {
    Sketch::new("sheet", "what is drawn on a sheet for a test").window((-1.0, 4.0), (-1.0, 4.0))
}

/// A plane rises by its length times the sine, to either side, and its hatched ground is
/// below it.
#[test]
fn a_plane_rises_to_its_top() -> Result<()> {
    for (angle, top) in
        [(PI / 6.0, (1.0 + 3.0_f64.sqrt(), 1.0)), (5.0 * PI / 6.0, (1.0 - 3.0_f64.sqrt(), 1.0))]
    {
        let foot = (1.0, 0.0);
        let (from, to) = if top.0 > 1.0 { (foot, top) } else { (top, foot) };
        let by_hand =
            sheet().curve(Curve::new([foot, (top.0, 0.0), top], Ink::Frame).thin()).wall(from, to);
        let plane = sheet().incline(foot, 2.0, angle);
        assert_eq!(plane.figure()?.svg(), by_hand.figure()?.svg());
        let lower = sheet().incline(foot, 1.9, angle);
        assert_ne!(lower.figure()?.svg(), by_hand.figure()?.svg());
    }
    Ok(())
}

/// Multiples of five, ten and more half turns are labelled as what they are.
#[test]
fn many_turns_have_their_labels() {
    let labels = |high: f64| -> Vec<String> {
        let ticks = Axis::angle("x").marks((0.0, high), 5);
        let ticks = ticks.expect("the ticks are the axis's own");
        assert!(ticks.iter().all(|(place, _)| *place <= high));
        ticks.into_iter().map(|(_, label)| label).collect()
    };
    assert_eq!(labels(40.1 * PI), ["$0$", "$10\\pi$", "$20\\pi$", "$30\\pi$", "$40\\pi$"]);
    assert_eq!(labels(15.1 * PI), ["$0$", "$5\\pi$", "$10\\pi$", "$15\\pi$"]);
    assert_eq!(labels(2.1 * PI), ["$0$", "$\\pi/2$", "$\\pi$", "$3\\pi/2$", "$2\\pi$"]);
}

/// The alternative text is a sentence: twenty letters, spaces around it not counted.
#[test]
fn a_figure_says_what_is_to_be_seen() {
    let figure = |alt: &str| Sketch::new("sheet", alt).window((0.0, 1.0), (0.0, 1.0)).figure();
    assert!(figure("a sheet of 20 lettrs").is_ok());
    assert!(figure("a sheet of 19 lettr").is_err());
    assert!(figure(" a sheet of 19 lettr ").is_err());
}

#[test]
fn a_thin_space_in_a_formula_is_no_comma() {
    assert_eq!(Label::new(r"$a\,b$"), Label::new("$a\u{2009}b$"));
    assert_ne!(Label::new(r"$a\,b$"), Label::new("$a,b$"));
}

/// A window grows about its middle to the height asked for, and no farther than what is to be
/// clear about a box asks.
#[test]
fn a_window_grows_as_asked() {
    let (across, all) = ((-1.0, 1.0), (0.0, 2.0));
    let shown = |sketch: Sketch| (sketch.x, sketch.y);
    let sheet = || Sketch::within(across, all).width(200);
    assert_eq!(shown(sheet().high(200)), (across, all));
    assert_eq!(shown(sheet().high(100)), ((-2.0, 2.0), all));
    assert_eq!(shown(sheet().high(300)), (across, (-0.5, 2.5)));
    let clear = |x, margins| shown(sheet().clear(x, (1.0, 1.0), margins));
    assert_eq!(clear((0.0, 0.5), [100.0, 50.0, 100.0, 100.0]), (across, all));
    // Too little on the right, then on both sides.
    assert_eq!(clear((0.5, 0.5), [0.0, 100.0, 0.0, 0.0]), ((-1.0, 2.0), (-0.5, 2.5)));
    assert_eq!(clear((-1.0, 1.0), [50.0, 50.0, 0.0, 0.0]), ((-2.0, 2.0), (-1.0, 3.0)));
}

/// With equal units the plot is as high as its data ask, and margins are added to that.
#[test]
fn equal_units_make_the_height() {
    let panel = Panel::new("sheet", "a panel with equal units on both axes")
        .y(Axis::linear("y"))
        .equal_aspect();
    let height = |up: f64| panel.fitted_size(40.0, (0.0, 2.0), (0.0, up)).1;
    // Of 340 px 40 and 12 are margins; 288 px are two units.
    let [half, one] = [height(1.0), height(1.5)].map(f64::from);
    assert_eq!(one - half, 72.0);
    let margins = half - 144.0;
    assert!((27.0..=27.0 + 3.0 * SIZE).contains(&margins), "{margins}");
    // Flat and tall ones have their limits.
    assert_eq!([height(0.01), height(9.0)], [120, 340]);
}

/// The open head of a dashed arrow is drawn in full.
#[test]
fn heads_are_not_dashed() -> Result<()> {
    let dashed = Stroke { dash: Dash::Dashed, ..Stroke::new(Ink::Ink, 1.0) };
    let figure = super::canvas::figure("sheet", "an arrow that is dashed", (100, 100), |canvas| {
        canvas.sheet().draw(&[(10.0, 10.0), (90.0, 90.0)], &Paint::Arrow(dashed, 9.0, true))
    })?;
    let dashes: Vec<Dash> = figure
        .display
        .shapes
        .iter()
        .filter_map(|shape| match shape {
            Shape::Line(_, _, stroke) => Some(stroke.dash),
            _ => None,
        })
        .collect();
    assert_eq!(dashes, [Dash::Dashed, Dash::Solid]);
    Ok(())
}

/// A trail gets wider and stronger towards its new end; one of a single point is none.
#[test]
fn a_trail_fades_towards_its_old_end() -> Result<()> {
    let strokes = |count: u32| -> Result<Vec<(f64, f64)>> {
        let points = (0..count).map(|i| SpaceVector::new(0.0, 0.02 * f64::from(i), 0.0));
        let figure =
            View::new("trail", "where something has gone").trail(points, Ink::Body).figure()?;
        let line = |shape: Shape| match shape {
            Shape::Line(_, _, stroke) => Some((stroke.opacity, stroke.width)),
            _ => None,
        };
        Ok(figure.display.shapes.into_iter().filter_map(line).collect())
    };
    let found = strokes(33)?;
    assert_eq!(found.len(), 16);
    assert!(found.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 < w[1].1), "{found:?}");
    assert_eq!(found[15].0, 1.0);
    assert_eq!([strokes(2)?.len(), strokes(1)?.len()], [1, 0]);
    Ok(())
}

/// What was at the path's places before the span is not followed.
#[test]
fn a_trail_begins_at_its_time() -> Result<()> {
    let path: Vec<_> =
        (0..50).map(|i| (f64::from(i), SpaceVector::new(0.0, 0.02 * f64::from(i), 0.0))).collect();
    let now = SpaceVector::new(0.0, 0.61, 0.0);
    let view = View::new("trail", "where something has gone");
    let followed = view.clone().followed(&path, [30.5, 10.0], now, Ink::Body).figure()?;
    let by_hand = path[21..=30].iter().map(|(_, place)| *place).chain([now]);
    assert_eq!(followed, view.trail(by_hand, Ink::Body).figure()?);
    Ok(())
}

/// A globe hides what is behind it, and a ghost lies behind every body.
#[test]
fn what_is_behind_is_painted_first() -> Result<()> {
    let place = |view: View, wanted: Ink| -> Result<usize> {
        let shapes = view.figure()?.display.shapes;
        let found = shapes.iter().position(|shape| match shape {
            Shape::Face(_, ink, _) | Shape::Area(_, ink, _) => *ink == wanted,
            _ => false,
        });
        Ok(found.expect("it is drawn"))
    };
    // The camera looks along -x.
    let with_ball = |x: f64| {
        let ball = Solid::ball(SpaceVector::new(x, 0.0, 0.0), 0.1);
        let view = View::new("globe", "a ball beside the Earth")
            .globe(0.3)
            .around(SpaceVector::zero(), 2.0);
        view.camera(super::Camera::new(0.0, 0.1)).solid(ball, Ink::Body)
    };
    assert!(place(with_ball(-1.2), Ink::Body)? < place(with_ball(-1.2), Ink::Paper)?);
    assert!(place(with_ball(1.2), Ink::Body)? > place(with_ball(1.2), Ink::Paper)?);
    let ball = |x: f64| Solid::ball(SpaceVector::new(x, 0.0, 0.0), 0.3);
    let view = View::new("ghost", "a ball and where it was").solid(ball(0.0), Ink::Body);
    let view = view.ghost(ball(0.5), Ink::Energy).corner("1 s");
    assert!(place(view.clone(), Ink::Energy)? < place(view, Ink::Body)?);
    Ok(())
}

/// A vector is a body of its own colour, with no light so strong that the colour is lost.
#[test]
fn a_vector_keeps_its_colour() -> Result<()> {
    let origin = SpaceVector::zero();
    let tip = SpaceVector::new(0.0, 0.6, 0.6);
    let view = View::new("vector", "an angular momentum that leans");
    let shapes =
        view.vector(origin, tip, Ink::Momentum, "$L$", Side::Right).figure()?.display.shapes;
    let lights = shapes.iter().filter_map(|shape| match shape {
        Shape::Face(_, Ink::Momentum, light) => Some(*light),
        _ => None,
    });
    let (least, most) = lights.fold((100, 0), |(a, b), light| (light.min(a), light.max(b)));
    assert!(least >= 12 && most <= 60 && most > least + 10, "{least} {most}");
    Ok(())
}
