//! The moving pictures, for what a reader sets: a control begins at what is shown, each open one
//! changes the picture, and at the ends of its sliders all that it shows is in its frame.

use crate::snapshots::misplaced;
use kit::draw::{Display, Ink, Shape, Sketch};
use kit::{Figure, Moves, MovingPicture, Page, seen};
use pages::{ALL, MOVING, WHOLE};
use serde_json::Value;

/// What is declared of the parameters of a page.
fn flags(page: &dyn Page) -> Vec<Value> {
    let declared: Value = serde_json::from_str(&page.declared()).expect("it is JSON");
    declared["flags"].as_array().expect("a list").clone()
}

/// The settings of a page with one slider at one of its ends.
fn ends(page: &dyn Page) -> Vec<String> {
    let ends = |flag: &Value| Some([flag["from"].as_f64()?, flag["to"].as_f64()?]);
    let sliders = flags(page).into_iter().filter_map(|flag| {
        Some(ends(&flag)?.map(|end| format!("{}={end}", flag["name"].as_str().expect("a name"))))
    });
    sliders.flatten().collect()
}

/// The frame after this part of the span.
fn frame(picture: &MovingPicture, part: f64) -> Figure {
    let (from, to) = picture.span().into_inner();
    let frame = picture.frame((from + part * (to - from)).min(to));
    frame.unwrap_or_else(|error| panic!("after {part} of the span: {error}"))
}

/// Whether these settings are those of the picture that is shown, as far as they are set.
fn is_shown(page: &dyn Moves, settings: &str) -> bool {
    let drawn = |settings: &str| {
        let picture = page.opened(settings).ok()??;
        let frames = [0.0, 0.3, 0.6, 1.0].map(|part| frame(&picture, part).display);
        Some((picture.span(), frames))
    };
    drawn(settings) == drawn("")
}

/// The settings of the values on show: each that is not set otherwise alone, and all together.
fn on_show(page: &dyn Page) -> Vec<String> {
    let set = |flag: &Value| Some(format!("{}={}\n", flag["name"].as_str()?, flag["shown"].as_str()?));
    let flags = flags(page);
    let alone = flags.iter().filter(|flag| flag["kind"] == "optional").filter_map(set);
    alone.chain([flags.iter().filter_map(set).collect()]).collect()
}

#[test]
fn a_control_begins_at_what_is_shown() {
    for (page, moves) in ALL.iter().zip(MOVING) {
        if moves.opened("").expect("its own parameters").is_some() {
            for settings in on_show(*page) {
                assert!(is_shown(*moves, &settings), "{}: {settings:?} is not shown", page.stem());
            }
            // The damaged twin: a value beside the one on show.
            let others = ends(*page).into_iter().filter(|setting| !is_shown(*moves, setting));
            assert!(others.count() > 0, "{} shows no slider", page.stem());
        }
    }
}

/// Two or three controls are open, all of them seen, and both ends of their sliders are allowed.
#[test]
fn the_open_controls_change_the_picture() {
    let (mut count, mut wrong) = (0, Vec::new());
    for (page, moves) in ALL.iter().zip(MOVING) {
        let told: Value = serde_json::from_str(&seen(*page, *moves).expect("it moves")).expect("JSON");
        let seen = told["seen"].as_array().expect("a list");
        if moves.opened("").expect("its own parameters").is_none() {
            continue;
        }
        count += 1;
        let open = flags(*page).into_iter().filter(|flag| flag["title"].is_string());
        let open: Vec<Value> = open.collect();
        let mut fault = |what: String| wrong.push(format!("{}: {what}; seen: {seen:?}", page.stem()));
        if !(1..=3).contains(&open.len()) {
            fault(format!("{} open controls", open.len()));
        }
        for flag in open {
            let name = flag["name"].as_str().expect("a name");
            if !seen.contains(&flag["name"]) {
                fault(format!("{name} changes nothing"));
            }
            let range = ["from", "to"].map(|end| flag[end].as_f64());
            if flag["words"].as_array().is_some_and(Vec::is_empty) && range.contains(&None) {
                fault(format!("{name} has no slider"));
            }
            for end in range.into_iter().flatten() {
                if let Err(error) = moves.opened(&format!("{name}={end}")) {
                    fault(format!("at an end of its slider {error}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(!WHOLE || count > 40, "{count} pictures");
}

/// By how many px what is drawn leaves the frame.
fn beyond(display: &Display) -> f64 {
    let (width, height) = (f64::from(display.size.0), f64::from(display.size.1));
    let outside = |&(x, y): &(i32, i32)| {
        let (x, y) = (f64::from(x) / 100.0, f64::from(y) / 100.0);
        [-x, x - width, -y, y - height].into_iter().fold(0.0, f64::max)
    };
    let worst = |places: &[(i32, i32)]| places.iter().map(outside).fold(0.0, f64::max);
    let shapes = display.shapes.iter().map(|shape| match shape {
        Shape::Line(places, ..) | Shape::Area(places, ..) | Shape::Face(places, ..) => worst(places),
        Shape::Dot(place, ..) => outside(place),
    });
    shapes.fold(0.0, f64::max)
}

/// What is wrong with the frames of a picture: texts on one another, something that leaves the
/// frame or is no number, another size than the locked stills have.
fn faults(picture: &MovingPicture, size: (u32, u32)) -> Vec<String> {
    let mut found = Vec::new();
    for part in [0.0, 0.3, 0.6, 1.0] {
        let figure = frame(picture, part);
        let (svg, display) = (figure.svg(), figure.display);
        found.extend(misplaced(&svg));
        let out = beyond(&display);
        if out > 2.0 {
            found.push(format!("{out:.0} px of it leave the frame after {part} of the span"));
        }
        if svg.contains("NaN") || display.size != size {
            found.push(format!("{:?} px, with a number in each place", display.size));
        }
    }
    found
}

/// Pages where that is not so yet at some end of a slider; one that is mended comes off.
const NOT_YET: [&str; 1] = ["further_5_wheel_on_rope"];

#[test]
fn at_the_ends_of_its_sliders_a_picture_is_whole() {
    let (mut seen, mut wrong) = (0, Vec::new());
    for (page, moves) in ALL.iter().zip(MOVING) {
        let Some(usual) = moves.opened("").expect("its own parameters") else {
            continue;
        };
        let size = frame(&usual, 0.0).display.size;
        let mut found = Vec::new();
        for setting in ends(*page) {
            // What no motion belongs to is refused.
            if let Ok(Some(picture)) = moves.opened(&setting) {
                let faults = faults(&picture, size).into_iter();
                found.extend(faults.map(|fault| format!("{} {setting}: {fault}", page.stem())));
                seen += 1;
            }
        }
        let excused = NOT_YET.contains(&page.stem());
        if excused == found.is_empty() {
            wrong.push(format!("{}: {}", page.stem(), found.join("\n")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(!WHOLE || seen > 500, "{seen} settings");
}

/// The damaged twin: an arrow that grows out of its frame, and a frame of another size.
#[test]
fn what_leaves_its_frame_is_seen() {
    let grows = |end: f64| {
        let picture = MovingPicture::new(0.0..=end, [0.0], |t| {
            let arrow = [(0.0, 0.0), (t, 0.0)];
            Sketch::new("arrow", "an arrow grows to the right").window((-1.0, 1.0), (-1.0, 1.0))
                .arrow_along(arrow, Ink::Ink).figure()
        });
        picture.expect("a span")
    };
    assert_eq!(faults(&grows(0.9), (340, 340)), Vec::<String>::new());
    assert_eq!(faults(&grows(1.1), (340, 340)), ["17 px of it leave the frame after 1 of the span"]);
    assert_eq!(faults(&grows(0.9), (340, 300)).len(), 4);
}
