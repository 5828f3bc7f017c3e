//! Which parameters a moving picture shows: found by drawing it, so that nobody keeps a list. The
//! others have no control below it.

use super::draw::{Display, Shape, Turn};
use super::json::quoted;
use super::number::exactly;
use super::parameters::Settings;
use super::{Flag, Moves, MovingPicture, Page};
use crate::error::Result;

/// How far a place must move to be seen, in hundredths of a px: what a tolerance changes is less.
const SEEN: i32 = 100;

/// The parts of its span at which a picture is compared.
const PARTS: [f64; 6] = [0.0, 0.15, 0.35, 0.55, 0.8, 1.0];

/// `{"turns": …, "seen": [names]}`: whether a hand can turn the moving picture of a page, and which of
/// its parameters change it, at one of the ends of their usual range or as another word of their list.
///
/// # Errors
/// Those of the picture with nothing set.
pub fn seen(page: &dyn Page, moves: &dyn Moves) -> Result<String> {
    let Some(picture) = moves.opened("")? else {
        return Ok("{\"turns\": false, \"seen\": []}".into());
    };
    let (_, turns) = picture.seen(*picture.span().start(), Turn::default())?;
    let run = page.with_defaults();
    let defaults = run.parameters();
    let changes = |flag: &&Flag| {
        // An error that is asked for is none of the scene's, though a sample more may be drawn. What is
        // refused shows nothing.
        if flag.name() == "tolerance" {
            return false;
        }
        let opened = |value: &String| moves.opened(&format!("{}={value}", flag.name())).ok()?;
        tried(flag, defaults).iter().filter_map(opened).any(|other| !alike(&picture, &other))
    };
    let names = defaults.flags().iter().filter(changes).map(|flag| quoted(&flag.name()));
    Ok(format!("{{\"turns\": {turns}, \"seen\": [{}]}}", names.collect::<Vec<_>>().join(", ")))
}

/// What a parameter is set to, to see whether it changes anything; nothing for one that the picture
/// has no value of.
fn tried(flag: &Flag, defaults: &dyn Settings) -> Vec<String> {
    if !flag.words().is_empty() {
        return flag.words().iter().map(|word| (*word).to_owned()).collect();
    }
    let range = flag.allowed().and_then(|allowed| allowed.usual());
    let Some(shown) = flag.on_show(defaults) else {
        return flag.usual().map(exactly).into_iter().collect();
    };
    let left_out = flag.usual().map(|_| String::new());
    let ends = range.unwrap_or_else(|| match shown.parse().unwrap_or(0.0) {
        0.0 => [-0.1, 0.1],
        value => [0.5 * value, 1.5 * value],
    });
    left_out.into_iter().chain(ends.map(exactly)).collect()
}

/// Whether nobody can tell two pictures apart.
fn alike(one: &MovingPicture, other: &MovingPicture) -> bool {
    let frame = |picture: &MovingPicture, part: f64| {
        let (from, to) = picture.span().into_inner();
        picture.frame((from + part * (to - from)).min(to)).map(|figure| figure.display)
    };
    PARTS.into_iter().all(|part| match (frame(one, part), frame(other, part)) {
        (Ok(one), Ok(other)) => same(&one, &other),
        // A frame that is refused shows nothing.
        _ => true,
    })
}

fn same(one: &Display, other: &Display) -> bool {
    let near = |a: (i32, i32), b: (i32, i32)| (a.0 - b.0).abs().max((a.1 - b.1).abs()) < SEEN;
    let shapes = one.shapes.iter().zip(&other.shapes);
    let texts = one.texts.iter().zip(&other.texts);
    one.size == other.size
        && one.shapes.len() == other.shapes.len()
        && one.texts.len() == other.texts.len()
        && shapes.into_iter().all(|(one, other)| {
            let pairs = outline(one).into_iter().zip(outline(other));
            core::mem::discriminant(one) == core::mem::discriminant(other)
                && pairs.into_iter().all(|(a, b)| near(a, b))
        })
        && texts.into_iter().all(|(one, other)| near(one.at, other.at) && one.runs == other.runs)
}

/// The ends of a shape and the corners of the box around it: a line that is hardly another may be
/// thinned to another number of places.
fn outline(shape: &Shape) -> [(i32, i32); 4] {
    let places = match shape {
        Shape::Line(places, ..) | Shape::Area(places, ..) | Shape::Face(places, ..) => &**places,
        Shape::Dot(place, ..) => core::slice::from_ref(place),
    };
    let [first, last] = [places.first(), places.last()].map(|p| p.copied().unwrap_or_default());
    let corner = |(a, b): (i32, i32), &(x, y): &(i32, i32), pick: fn(i32, i32) -> i32| {
        (pick(a, x), pick(b, y))
    };
    let least = places.iter().fold(first, |all, place| corner(all, place, i32::min));
    let most = places.iter().fold(first, |all, place| corner(all, place, i32::max));
    [first, last, least, most]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::{Ink, Side, Sketch};
    use crate::{Example, Report, Trajectory};

    crate::parameters! {
        /// A clock.
        pub struct Parameters {
            /// length of the hand
            length: number(0.9, "m", above(0.0).usually(0.5, 1.0));
            /// its mass
            mass: number(1.0, "kg", above(0.0).usually(0.1, 10.0));
            /// an angle that is not set
            lead: optional("rad", any()).shown(0.25);
            /// one that the picture has no value of
            other: optional("rad", any());
            /// error of the gear
            tolerance: number(1e-9, "-", from_to(1e-15, 1e-3));
            /// which hand
            hand: choice("hour", "minute");
            /// what slows it
            air: effect(0.1, "-", above(0.0));
            /// what drives it
            spring: effect(1.0, "-", above(0.0)).present();
        }
    }

    const CLOCK: Example<Parameters> = Example {
        stem: "clock",
        about: "A clock",
        report: |_| Report::new("A clock", "a hand that turns"),
        figures: |_| Ok(Vec::new()),
        trajectory: |_| Trajectory::new(["t [s]"]),
        moving_picture: Some(|p: &Parameters| {
            let (l, lead) = (p.length, p.lead.unwrap_or(0.25));
            let driven = if p.hand == "hour" { 1.0 } else { 2.0 } + p.spring.unwrap_or(0.0);
            let rate = driven + p.tolerance - 0.5 * p.air.unwrap_or(0.0);
            MovingPicture::new(0.0..=6.0, [0.0], move |t| {
                let tip = (l * (rate * t + lead).sin(), l * (rate * t + lead).cos());
                Sketch::new("clock", "the hand of a clock turns")
                    .window((-1.0, 1.0), (-1.0, 1.0))
                    .arrow((0.0, 0.0), tip, Ink::Body, "", Side::Right)
                    .figure()
            })
        }),
        recordings: None,
    };

    #[test]
    fn what_changes_nothing_is_found() {
        let told = seen(CLOCK.page(), &CLOCK).expect("it moves");
        // Neither the mass, nor what has no value on show, nor a tolerance that moves less than a px.
        assert_eq!(
            told,
            r#"{"turns": false, "seen": ["length", "lead", "hand", "air", "spring"]}"#
        );
        let still = Example { moving_picture: None, ..CLOCK };
        let told = seen(still.page(), &still).expect("nothing moves");
        assert_eq!(told, r#"{"turns": false, "seen": []}"#);
    }
}
