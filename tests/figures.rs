//! Figures as documents: well formed, the same bytes every time, legible, and
//! refused when they cannot be right.

use kit::draw::{Axis, Curve, Ink, PALETTE, Panel, Side, Sketch, Solid, Stack, Sweep, View};
use kit::{Error, Figure, MovingPicture, times};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{cos, exp, sin, sincos};

fn grid(n: i32, to: f64) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| to * f64::from(i) / f64::from(n))
}

fn series() -> Panel {
    Panel::new("series", "two angles against time: one swings, one drifts")
        .x(Axis::linear("$t'$"))
        .y(Axis::angle(r"$\theta$, $\phi$"))
        .curve(
            Curve::new(grid(400, 10.0).map(|t| (t, 1.0 + 0.5 * sin(3.0 * t))), Ink::Body)
                .label(r"$\theta$"),
        )
        .curve(Curve::new(grid(400, 10.0).map(|t| (t, 0.3 * t)), Ink::Momentum).label(r"$\phi$"))
        .curve(Curve::new(grid(40, 10.0).map(|t| (t, 0.3 * t)), Ink::Momentum).dots())
}

fn prices() -> Panel {
    let order = |p: f64| grid(6, 5.0).map(move |x| (100.0 * exp(x), 0.01 * exp(-p * x)));
    Panel::new("prices", "error against work: the higher the order the steeper the line")
        .x(Axis::log("torques"))
        .y(Axis::log("error / rad"))
        .curve(Curve::new(order(2.0), Ink::Velocity).with_dots().label_end("order 2"))
        .curve(Curve::new(order(4.0), Ink::Momentum).with_dots().label_end("order 4"))
        .level(1e-11, Ink::Frame, "round-off")
}

fn setup() -> Sketch {
    Sketch::new("setup", "a ladder leans between wall and floor, with its weight")
        .window((-0.3, 2.0), (-0.3, 2.9))
        .wall((0.0, 2.8), (0.0, 0.0))
        .wall((0.0, 0.0), (1.9, 0.0))
        .curve(Curve::new([(0.0, 2.6), (1.5, 0.0)], Ink::Body).width(4.0))
        .angle((0.0, 2.6), 0.7, (-1.571, -1.047), r"$\theta$")
        .arrow((0.75, 1.3), (0.75, 0.5), Ink::Force, "$mg$", Side::Left)
        .dimension((0.2, 2.7), (1.7, 0.1), r"$\ell$", Side::AboveRight)
        .turn((0.0, 0.0), 0.5, (0.2, 1.4), Ink::Velocity)
        .disc((1.6, 2.4), 0.2, Ink::Energy, 0.2)
        .ring((0.0, 2.6), Ink::Ink, "", Side::Above)
}

fn view() -> View {
    let trace = grid(600, 9.0).map(|t| {
        let ((s, c), (sp, cp)) =
            (sincos(1.2 + 0.5 * cos(5.0 * t)), sincos(0.7 * t - 0.35 * sin(5.0 * t)));
        SpaceVector::new(s * cp, s * sp, c)
    });
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    View::new("view", "the axis draws loops on the sphere, between two circles of latitude")
        .sphere()
        .latitude(0.7)
        .trace(trace, Ink::Body)
        .solid(Solid::turned(SpaceVector::zero(), up, &[(0.0, 0.0), (0.3, 0.2)]), Ink::Body)
        .arrow(SpaceVector::zero(), up, Ink::Momentum, "$L$", Side::Right)
        .triad()
}

fn all() -> Vec<Figure> {
    let stack = Stack::new("stack", "two angles against one time axis, in two rows")
        .panel(series())
        .panel(series());
    let figures =
        [series().figure(), prices().figure(), stack.figure(), setup().figure(), view().figure()];
    figures.into_iter().map(|f| f.expect("a sound figure is drawn")).collect()
}

/// The tags of a document, in order, without their attributes; `/` marks a closing one.
fn tags(svg: &str) -> Vec<String> {
    let mut found = Vec::new();
    for piece in svg.split('<').skip(1) {
        let (tag, _) = piece.split_once('>').expect("every tag ends");
        let name = tag.split_whitespace().next().expect("every tag has a name");
        if !tag.ends_with('/') {
            found.push(name.to_owned());
        }
    }
    found
}

#[test]
fn documents_are_well_formed_and_the_same_every_time() {
    let (first, second) = (all(), all());
    assert_eq!(first.len(), 5);
    assert_eq!(first, second);
    for figure in &first {
        let svg = figure.svg();
        let mut open: Vec<String> = Vec::new();
        for tag in tags(&svg) {
            match tag.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop().as_deref(), Some(name), "{}", figure.name),
                None => open.push(tag),
            }
        }
        assert!(open.is_empty(), "{}: {open:?} left open", figure.name);
        // Said once: a description that repeats the label is read twice.
        assert_eq!(svg.matches(&figure.alt).count(), 1, "{}", figure.name);
        assert!(svg.contains(&format!("aria-label=\"{}\"", figure.alt)));
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", figure.name);
        // Measured: 5 to 26 kB; a page holds a dozen.
        assert!(svg.len() < 40_000, "{} has {} bytes", figure.name, svg.len());
    }
}

#[test]
fn every_colour_follows_the_theme() {
    for figure in all() {
        let svg = figure.svg();
        let bare = svg.match_indices('#').filter(|&(at, _)| {
            let hex = &svg[at + 1..at + 7];
            let from_palette = PALETTE
                .iter()
                .any(|c| [c.line, c.text].map(|c| format!("{c:06X}")).contains(&hex.to_string()));
            let in_variable = svg[..at].ends_with(',');
            // The faces of solids have a mixed colour for readers without color-mix.
            let fallback = svg[..at].ends_with("fill:") || svg[..at].ends_with("stroke:");
            // Lit and shaded, they are mixed from the palette's.
            let body = ["-lit,", "-shade,"].iter().any(|end| svg[..at].ends_with(end));
            let explained =
                body || (in_variable && from_palette) || (fallback && figure.name == "view");
            !explained
        });
        assert_eq!(bare.count(), 0, "{}", figure.name);
    }
}

#[test]
fn text_is_never_below_eleven_px() {
    let mut sizes = 0;
    for figure in all() {
        let svg = figure.svg();
        for (at, key) in svg.match_indices("font-size=\"") {
            let value = &svg[at + key.len()..];
            let size: f64 = value[..value.find('"').expect("closed")].parse().expect("a number");
            assert!((11.0..=16.0).contains(&size), "{}: {size}", figure.name);
            sizes += 1;
        }
    }
    assert!(sizes > 10, "only {sizes} sizes seen");
}

#[test]
fn exponents_are_raised_and_minus_signs_are_minus_signs() {
    let svg = prices().figure().expect("drawn").svg();
    assert!(svg.contains(">10<tspan dy=\"-5.0\" font-size=\"11.1\">\u{2212}4</tspan>"), "{svg}");
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let panel = |points: [(f64, f64); 2]| {
        Panel::new("panel", "a line from here to there, for the test")
            .curve(Curve::new(points, Ink::Ink))
    };
    assert!(panel([(0.0, 0.0), (1.0, 1.0)]).figure().is_ok());
    for (figure, fits) in [
        (panel([(0.0, 0.0), (1.0, f64::NAN)]).figure(), "NaN is not a finite number"),
        (panel([(0.0, 0.0), (f64::INFINITY, 1.0)]).figure(), "inf is not a finite number"),
        (panel([(0.0, 0.0), (1.0, 0.0)]).figure(), "give the axis a range"),
        (panel([(0.0, 0.0), (1.0, 1.0)]).y(Axis::log("y")).figure(), "it must be greater than 0"),
        (
            panel([(0.0, 0.0), (1.0, 1.0)]).x(Axis::linear("x").range(2.0, 1.0)).figure(),
            "give the axis a range",
        ),
        (
            Panel::new("empty", "nothing at all is to be seen here").figure(),
            "give the axis a range",
        ),
        (Panel::new("Bad name", "a line from here to there").figure(), "give the axis a range"),
        (
            Panel::new("alt", "short")
                .curve(Curve::new([(0.0, 0.0), (1.0, 1.0)], Ink::Ink))
                .figure(),
            "says in a sentence",
        ),
        (setup().window((0.0, 0.0), (0.0, 1.0)).figure(), "greater than 0 and at most 3"),
        (setup().dot((1e9, 0.0), Ink::Ink, "", Side::Above).figure(), "far outside"),
        (
            view().dot(SpaceVector::new(f64::NAN, 0.0, 0.0), Ink::Ink, "", Side::Above).figure(),
            "finite",
        ),
        (view().around(SpaceVector::zero(), 0.0).figure(), "reach"),
        (Stack::new("stack", "no panel at all is in this stack").figure(), "at least one panel"),
    ] {
        match figure {
            Err(error) => assert!(error.to_string().contains(fits), "{error}"),
            Ok(figure) => panic!("{} was drawn", figure.name),
        }
    }
    let named = panel([(0.0, 0.0), (1.0, 1.0)]).figure().expect("drawn");
    assert_eq!(named.name, "panel");
    assert!(matches!(
        Panel::new("Bad name", "a line from here to there, for the test")
            .curve(Curve::new([(0.0, 0.0), (1.0, 1.0)], Ink::Ink))
            .figure(),
        Err(Error::Text { .. })
    ));
}

kit::figures! { heights: &[f64; 2], top = heights[0].max(heights[1]);
    /// Two lines, the one
    /// above the other.
    lines: Panel::over_axes("$x$", Axis::linear("$y$").range(0.0, top))
        .curve(Curve::of(grid(4, 1.0), |x| heights[0] * x, Ink::Ink))
        .curve(Curve::of(grid(4, 1.0), |x| heights[1] * x, Ink::Body));

    weight(format!("A weight on a string of the length {top} m.")):
        Sketch::within((-1.0, 1.0), (-1.2, 0.2))
            .wall((0.5, 0.0), (-0.5, 0.0))
            .guide([(0.0, 0.0), (0.0, -1.1)])
            .string((0.0, 0.0), (0.3, -0.8), "$l$", Side::Right)
            .weight((0.3, -0.8), 0.08, "$M$")
            .gravity((-0.6, -0.3), 0.3);
}

#[test]
fn figures_are_named_and_say_what_is_to_be_seen() {
    let drawn = figures(&[1.0, 2.0]).expect("drawn");
    let said: Vec<_> = drawn.iter().map(|f| (f.name.as_str(), f.alt.as_str())).collect();
    let expected = [
        ("lines", "Two lines, the one above the other."),
        ("weight", "A weight on a string of the length 2 m."),
    ];
    assert_eq!(said, expected);
    // What the builders stand for, by hand: the same bytes.
    let by_hand = Sketch::new(expected[1].0, expected[1].1)
        .window((-1.0, 1.0), (-1.2, 0.2))
        .wall((0.5, 0.0), (-0.5, 0.0))
        .curve(Curve::new([(0.0, 0.0), (0.0, -1.1)], Ink::Frame).thin().dashed())
        .curve(Curve::new([(0.0, 0.0), (0.3, -0.8)], Ink::Ink))
        .text((0.15, -0.4), "$l$", Ink::Ink, Side::Right)
        .disc((0.3, -0.8), 0.08, Ink::Body, 1.0)
        .text((0.38, -0.8), "$M$", Ink::Body, Side::Right)
        .arrow((-0.6, -0.3), (-0.6, -0.6), Ink::Frame, "$g$", Side::Left);
    assert_eq!(by_hand.figure().expect("drawn").svg(), drawn[1].svg());
    // The damaged twin: a panel that nobody named is refused.
    assert!(Panel::over_axes("$x$", "$y$").figure().is_err());
}

#[test]
fn a_sweep_draws_its_lines_and_dots_over_one_axis() {
    let sweep = Sweep::over("$x$", 0.0, 2.0).at([0.5, 1.0, 1.5]);
    let whole = Curve::of(times(0.0, 2.0, 260), sin, Ink::Ink);
    assert_eq!(sweep.exact(sin), whole);
    // Beyond the middle half of the points, and the dots that are there.
    let beyond = sweep.beyond(1.0);
    assert_eq!(beyond.exact(sin), Curve::of(times(1.0, 2.0, 130), sin, Ink::Ink));
    let dots = Curve::new([1.0, 1.5].map(|x| (x, cos(x))), Ink::Body).dots();
    assert_eq!(beyond.simulated(|x| Ok(cos(x))).expect("dots"), dots);
    let both = sweep.exact_and_simulated("$y$", sin, |x| Ok(sin(x))).expect("a panel");
    let by_hand = Panel::over_axes(Axis::linear("$x$").range(0.0, 2.0), "$y$");
    let simulated = sweep.simulated(|x| Ok(sin(x))).expect("dots").label("simulated");
    assert_eq!(both, by_hand.curve(whole).curve(simulated));
    assert!(
        sweep
            .simulated(|t| Err(rotation_dynamics::Error::NotFinite { name: "t", value: t }.into()))
            .is_err()
    );
}

#[test]
fn a_picture_above_its_graph_is_the_usual_frame() {
    let graph =
        Panel::over_axes("$t$ / s", "$x$ / m").curve(Curve::of(grid(60, 6.0), cos, Ink::Body));
    let ball =
        |t: f64| Sketch::within((-1.3, 1.3), (-0.2, 0.6)).disc((cos(t), 0.2), 0.2, Ink::Body, 0.3);
    let alt = "a ball swings to and fro; below it its place against time";
    let by_hand = Stack::frame(alt, ball(2.0), &graph, 2.0).expect("a frame");
    let picture = MovingPicture::above(graph, 0.0..=6.0, [2.0], move |t| Ok((alt.into(), ball(t))));
    let picture = picture.expect("a picture");
    assert_eq!(picture.stills().expect("stills")[0].svg(), by_hand.svg());
    assert!(picture.frame(6.1).is_err());
}
