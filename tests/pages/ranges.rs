//! Every parameter of every page over its physically possible range: both signs, zero, six decades
//! up and down, and a hair on either side of each end of what is allowed. The page answers, which
//! confirms each number, or refuses and names the physics or the limit of its method.
//!
//! `PROPERTY_CASES=N` tries 2 N values of each parameter (15 tries them all; without it one of three of
//! those for N = 1 is tried), `PROPERTY_SEED=S` others, `PAGES=STEM` one page.

use crate::answers::asked;
use kit::{Error, Page};
use kit::interval::{Interval, above, from_to};
use oorandom::Rand64;
use pages::{ALL, WHOLE};
use rotation_dynamics::Error as Refusal;
use serde_json::Value;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Pages, by the beginning of their stem, of which refusals are known that do not say why: they are
/// printed and not judged. (Over nearly 1000 periods the races take steps too long for one method.)
const KNOWN: [&str; 1] = ["accuracy"];

/// An interval may end without a word so many times above or below the default: no page is tried
/// further.
const FAR: f64 = 999.0;

/// Values of each parameter, thinned.
const THIN: usize = 2;

/// A number among the parameters of a page.
struct Number {
    name: String,
    /// Whether its sign is that of a sense of motion: then each has an answer.
    signed: bool,
    /// The default, or the usual strength; 1 for what is not set.
    usual: f64,
    /// The ends of the allowed interval.
    ends: Vec<f64>,
}

/// The numbers among the parameters of a page, and what it can be told in words, a line each: all as
/// they are, and each other word.
fn numbers_and_words(page: &dyn Page) -> (Vec<Number>, Vec<String>) {
    let declared: Value = serde_json::from_str(&page.declared()).expect("it is JSON");
    let (mut numbers, mut words) = (Vec::new(), vec![String::new()]);
    for flag in declared["flags"].as_array().expect("a list") {
        let text = |key: &str| flag[key].as_str().unwrap_or_default();
        let name = text("name").to_owned();
        if flag["kind"] == "choice" {
            let others = flag["words"].as_array().into_iter().flatten().skip(1);
            words.extend(others.map(|word| format!("{name}={}\n", word.as_str().expect("a word"))));
            continue;
        }
        let usual = [text("default"), text("usual")].iter().find_map(|text| text.parse().ok());
        // What stands in brackets is the reason.
        let allowed = text("allowed").split('(').next().unwrap_or_default();
        numbers.push(Number {
            signed: ["rad/s", "m/s", "rad", "1/s", "deg/h"].contains(&text("unit")) && name != "tolerance",
            usual: usual.filter(|usual| *usual != 0.0).unwrap_or(1.0),
            ends: allowed.split(' ').filter_map(|word| word.parse().ok()).collect(),
            name,
        });
    }
    (numbers, words)
}

/// The values to try, the most telling first.
fn values(number: &Number, seed: u64) -> Vec<f64> {
    let (usual, mut dice) = (number.usual, Rand64::new(u128::from(seed)));
    let hairs = number.ends.iter().flat_map(|end| {
        let hair = if *end == 0.0 { 1e-12 * usual.abs() } else { 1e-12 * end.abs() };
        [*end, end - hair, end + hair]
    });
    let decades = (-6..=6).filter(|k| *k != 0).map(|k| usual * 10_f64.powi(k));
    let mut others: Vec<f64> = hairs.chain(decades).chain([0.0]).collect();
    others.extend((0..4).map(|_| {
        let sign = if dice.rand_u64().is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * usual * 10_f64.powf(4.0 * dice.rand_float() - 2.0)
    }));
    // Fisher and Yates.
    for last in (1..others.len()).rev() {
        others.swap(last, dice.rand_range(0..last as u64 + 1) as usize);
    }
    [-usual].into_iter().chain(others).collect()
}

/// Whether a refusal says nothing of the physics or the method.
fn unexplained(error: &Error, number: &Number) -> bool {
    match error {
        // No length, mass or strength is negative; every other end has its reason.
        Error::Parameter { name, value, allowed } => {
            let own = name.replace('_', "-") == number.name;
            let below = *value <= 0.0 && !allowed.contains(-1e-300);
            let times = (value / number.usual).abs();
            let far = own && (times > FAR || (times > 0.0 && times < 1.0 / FAR));
            let limit = number.name == "tolerance" || far || (below && !(own && number.signed));
            allowed.reason().is_none() && !limit
        }
        // Flags that exclude each other are named.
        Error::Text { text, .. } if text.ends_with("together") => false,
        Error::Contradicted { .. } | Error::UnknownKey { .. } | Error::Text { .. } => true,
        Error::Library(error) => unexplained_of_library(error),
        error => senseless(&error.to_string()),
    }
}

fn unexplained_of_library(error: &Refusal) -> bool {
    match error {
        Refusal::AtIndex { reason, .. } => unexplained_of_library(reason),
        // What doubles reach is said beside what was asked for, unless there is no such thing.
        Refusal::NotDelivered { best, condition: None, .. } => !best.is_finite(),
        Refusal::LimitReached { what, .. } => *what != "torques",
        Refusal::Contradiction { .. }
        | Refusal::NotFinite { .. }
        | Refusal::FunctionOutOfRange { .. }
        | Refusal::StepUnderflow { clock: None, .. }
        | Refusal::NoConvergence { .. }
        | Refusal::OutsideRun { .. }
        | Refusal::NotReached { .. }
        | Refusal::CannotHold { .. }
        | Refusal::Lengths { .. } => true,
        error => senseless(&error.to_string()),
    }
}

fn senseless(text: &str) -> bool {
    text.contains("NaN") || text.contains("not finite") || text.contains("not a finite")
}

/// What became of a page.
#[derive(Default)]
struct Swept {
    stem: &'static str,
    answered: usize,
    refused: usize,
    faults: Vec<String>,
    seconds: f64,
}

fn sweep(page: &dyn Page, count: usize) -> Swept {
    let (mut swept, begun) = (Swept { stem: page.stem(), ..Swept::default() }, Instant::now());
    let (numbers, words) = numbers_and_words(page);
    // At its tightest end a tolerance costs as much as all else.
    let thinned = count == THIN;
    let part = if asked("PROPERTY_CASES").is_some() || !WHOLE { 1 } else { 3 };
    let numbers = numbers.into_iter().filter(|number| !thinned || number.name != "tolerance");
    for (place, number) in numbers.enumerate() {
        let seed = asked("PROPERTY_SEED").unwrap_or(1) * 1000 + place as u64;
        for (turn, value) in values(&number, seed).into_iter().take(count).enumerate() {
            if !(turn + place).is_multiple_of(part) {
                continue;
            }
            let since = Instant::now();
            let settings = format!("{}{}={value:?}", words[turn % words.len()], number.name);
            match page.lab(&settings) {
                Ok(_) => swept.answered += 1,
                Err(error) => {
                    swept.refused += 1;
                    let fault = || format!("{} {settings:?}: {error}", page.stem());
                    swept.faults.extend(unexplained(&error, &number).then(fault));
                }
            }
            let took = since.elapsed().as_secs_f64();
            if took > 2.0 {
                println!("{} {settings:?} took {took:.1} s", page.stem());
            }
        }
    }
    swept.seconds = begun.elapsed().as_secs_f64();
    swept
}

/// The pages of which one report takes as long as all of another.
const LONG: [&str; 6] =
    ["accuracy", "accuracy_races", "ch15_5_toutatis", "further_3_euler_disc", "hard_cases", "library"];

#[test]
fn every_parameter_over_its_range() {
    let widened = asked("PROPERTY_CASES");
    let count = THIN * widened.unwrap_or(1) as usize;
    let pages: Vec<_> = ALL.iter().filter(|page| count > THIN || !WHOLE || !LONG.contains(&page.stem())).collect();
    let (next, all) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(2, usize::from).min(4) {
            scope.spawn(|| {
                while let Some(page) = pages.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let swept = sweep(**page, count);
                    all.lock().expect("no thread panics").push(swept);
                }
            });
        }
    });
    let mut all = all.into_inner().expect("no thread panics");
    all.sort_by_key(|swept| swept.stem);
    let mut judged = Vec::new();
    for swept in &all {
        let Swept { stem, answered, refused, faults, seconds } = swept;
        println!("{stem}: {answered} answered, {refused} refused, {} without a reason; {seconds:.1} s", faults.len());
        faults.iter().for_each(|fault| println!("  {fault}"));
        if !KNOWN.iter().any(|known| stem.starts_with(known)) {
            judged.extend(faults.iter().map(String::as_str));
        }
    }
    let (answered, refused) = all.iter().fold((0, 0), |(a, r), s| (a + s.answered, r + s.refused));
    println!("{answered} answered, {refused} refused");
    assert!(judged.is_empty(), "{} refusals without a reason:\n{}", judged.len(), judged.join("\n"));
    let least = if widened.is_some() { [250, 450] } else { [60, 140] };
    assert!(!WHOLE || (answered > least[0] && refused > least[1]), "{answered} {refused}");
}

/// A page, some of its flags, and a number that its figures exceed.
type Mirrored = (&'static str, &'static [(&'static str, f64)], usize);

/// Motions that are mirrored, or far from those of the locked figures.
const MIRRORED: [Mirrored; 6] = [
    ("further_1_phone", &[("turns", -3.0), ("tilt", -0.05)], 5),
    ("further_2_gyrocompass", &[("spin", -1500.0), ("latitude", -0.9), ("speed", -10.0), ("release", -0.5)], 5),
    ("further_3_euler_disc", &[("inclination", 1.2), ("start", 0.05), ("radius", 0.012), ("left", 0.2)], 6),
    ("further_4_yo_yo_despin", &[("spin", -10.0), ("aim", 1.0)], 3),
    ("further_5_wheel_on_rope", &[("spin", -20.0), ("push", 1.0)], 5),
    ("further_6_turntable", &[("rate", -10.0), ("velocity", -0.2), ("place", -0.1), ("orbit", -45.0)], 5),
];

#[test]
fn figures_are_drawn_of_the_mirrored_motion() {
    let mut drawn = 0;
    for (stem, flags, fewer) in MIRRORED {
        let Some(page) = ALL.iter().find(|page| page.stem() == stem) else { continue };
        assert!(page.figures_with(flags).unwrap().len() > fewer, "{stem}");
        drawn += 1;
    }
    assert!(drawn == MIRRORED.len() || !WHOLE, "{drawn} pages");
}

/// The twins: a mirrored rate refused, an end without a reason, a contradiction, a NaN.
#[test]
fn a_refusal_without_a_reason_is_seen() {
    let number = |name: &str, signed| Number { name: name.into(), signed, usual: 1.5, ends: Vec::new() };
    let seen = |allowed: Interval, value: f64, signed| {
        let refused = allowed.check("rate", value).expect_err("it is not allowed");
        unexplained(&refused, &number("rate", signed))
    };
    assert!(seen(above(0.0), -1.5, true) && seen(from_to(0.0, 3.0), 4.0, true) && seen(above(0.0), 0.0, true));
    assert!(!seen(above(0.0), -1.5, false) && !seen(from_to(0.0, 1e4), 2e4, true));
    assert!(!seen(from_to(0.0, 3.0).because("it slips"), 4.0, true));
    let (key, oracle) = ("rate".into(), "simulated".into());
    let contradicted = Error::Contradicted { key, value: 1.0, oracle, oracle_value: 2.0, bound: 1e-3 };
    let nan = Refusal::out_of_range("rate", f64::NAN, "a number");
    for fault in [contradicted, nan.into(), Refusal::NotReached { name: "stop", until: 1.0 }.into()] {
        assert!(unexplained(&fault, &number("rate", true)), "{fault}");
    }
}
