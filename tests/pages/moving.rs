//! The moving pictures, for what a reader sets: each is moved by a slider, or is one of a list, and
//! at the ends of its sliders all that it shows is in its frame.

use kit::draw::{Display, Ink, Shape, Sketch};
use kit::{Figure, Moves, MovingPicture, Page};
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

/// Those with one word of a list.
fn choices(page: &dyn Page) -> Vec<String> {
    let words = |flag: &Value| flag["words"].as_array().cloned().unwrap_or_default();
    let set = |flag: &Value, word: &Value| Some(format!("{}={}", flag["name"].as_str()?, word.as_str()?));
    let lists = flags(page).into_iter();
    lists.flat_map(|flag| words(&flag).into_iter().filter_map(move |word| set(&flag, &word))).collect()
}

/// The frame after this part of the span.
fn frame(picture: &MovingPicture, part: f64) -> Figure {
    let (from, to) = picture.span().into_inner();
    let frame = picture.frame((from + part * (to - from)).min(to));
    frame.unwrap_or_else(|error| panic!("after {part} of the span: {error}"))
}

/// Whether one of these settings changes the picture half of the way.
fn moved(page: &dyn Moves, settings: &[String]) -> bool {
    let drawn = |setting: &str| {
        let picture = page.opened(setting).ok()??;
        Some(frame(&picture, 0.5).display)
    };
    let before = drawn("").expect("it moves");
    settings.iter().filter_map(|setting| drawn(setting)).any(|display| display != before)
}

#[test]
fn a_control_moves_every_picture() {
    let mut seen = 0;
    for (page, moves) in ALL.iter().zip(MOVING) {
        if moves.opened("").expect("its own parameters").is_some() {
            let (sliders, lists) = (ends(*page), choices(*page));
            let controls = if sliders.is_empty() { &lists } else { &sliders };
            assert!(moved(*moves, controls), "no control moves the picture of {}", page.stem());
            // The damaged twin: what is declared already moves nothing.
            assert!(!moved(*moves, &["\n".into()]), "{}", page.stem());
            seen += 1;
        }
    }
    assert!(!WHOLE || seen > 40, "{seen} pictures");
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
        found.extend(display.collided());
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

/// The stills are not the only moments that are seen.
#[test]
fn labels_can_be_read_while_a_picture_moves() {
    const MOMENTS: u32 = 12;
    let (mut seen, mut wrong) = (0, Vec::new());
    for (page, moves) in ALL.iter().zip(MOVING) {
        let Some(usual) = moves.opened("").expect("its own parameters") else {
            continue;
        };
        for moment in 0..=MOMENTS {
            let found = frame(&usual, f64::from(moment) / f64::from(MOMENTS)).display.crowded();
            let at = |fault| format!("{} after {moment}/{MOMENTS}: {fault}", page.stem());
            wrong.extend(found.into_iter().map(at));
            seen += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(!WHOLE || seen > 500, "{seen} frames");
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
