//! Refusals say what is wrong, in few digits.

use kit::interval::{above, from_to};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Properties, check};
use rotation_dynamics::exact::jacobi::sn_cn_dn;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, ode, second_order, size_or};
use rotation_dynamics::math::{cos, exp};
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

/// Digits in a row, at most: those of a double.
const DIGITS: usize = 17;
/// Characters of a message, at most, beside four of its lists of seven numbers.
const LENGTH: usize = 400;
/// Of such a list, with brackets and commas: a double is at most 24 long.
const LIST: usize = 7 * 26;

/// Every refusal of the library, with these numbers in it.
fn all(x: f64, y: f64, z: f64) -> Vec<Error> {
    let (name, allowed, n) = ("speed", "it must be greater than 0", u64::MAX);
    let (list, text) = (vec![x, y, z, x, y, z, x], String::from("floor"));
    let list = || list.clone();
    let text = || text.clone();
    let limit = usize::MAX;
    let mut all = vec![
        Error::NotFinite { name, value: x },
        Error::out_of_range(name, x, allowed),
        Error::Lengths { name, found: limit, expected: limit },
        Error::AtIndex {
            name,
            index: limit,
            reason: Box::new(Error::out_of_range(name, x, allowed)),
        },
        Error::FunctionOutOfRange {
            what: text(),
            t: x,
            variables: name,
            state: list(),
            value: list(),
            allowed: allowed.into(),
        },
        Error::Contradiction {
            effect: text(),
            claim: name,
            t: x,
            probe: x < y,
            off: y,
            allowed: z,
        },
        Error::Sliding { effect: text(), t: x },
        Error::Undeclared { effect: text(), requested: x, every: y, limit: n },
        Error::Incompatible { effects: text(), reason: allowed.into() },
        Error::Cancelled { torques: n },
        Error::NoConvergence { t: x, h: y, change: z },
        Error::PhaseLost { t: x, latest: y },
        Error::OutsideRun { t: x, start: y, end: z },
        Error::NotRotation { deviation: x, determinant: y },
        Error::GimbalLock { sequence: name, angle: x, locked: name },
        Error::ImpactGainsEnergy { t: x, before: y, after: z },
        Error::NotReached { name, until: x },
        Error::ConditionUnknown { name },
    ];
    // Those with more than one message.
    all.extend(["torques", "steps", "changes of phase"].map(|what| Error::LimitReached {
        what,
        t: x,
        t_end: y,
        limit: n,
    }));
    all.extend([z, f64::INFINITY].map(|until| Error::BouncesUnresolved {
        contact: name,
        height: y,
        t: x,
        until,
    }));
    all.extend([None, Some(z)].map(|clock| Error::StepUnderflow {
        t: x,
        step: y,
        clock,
        state: list(),
    }));
    all.extend([y, 0.0].map(|excess| Error::NotABody { moments: [x, y, z], excess, slack: x }));
    all.extend([None, Some(z)].map(|rate| Error::CannotHold { name, t: x, value: y, rate }));
    all.extend([vec![], vec![text(), text()]].map(|motions| Error::ContactsUndetermined {
        t: x,
        state: list(),
        tried: limit,
        motions,
    }));
    all.extend([None, Some(z)].map(|condition| Error::NotDelivered {
        requested: x,
        best: y,
        condition,
    }));
    all
}

/// Every refusal that only pages raise, with these numbers in it.
fn of_pages(x: f64, y: f64, z: f64) -> Vec<kit::Error> {
    use kit::Error;
    let (name, allowed) = ("speed", "it must be greater than 0");
    let text = || String::from("floor");
    vec![
        Error::Parameter { name, value: x, allowed: from_to(-y.abs(), y.abs()) },
        Error::Parameter { name, value: x, allowed: above(z) },
        Error::Contradicted { key: text(), value: x, oracle: text(), oracle_value: y, bound: z },
        Error::Text { text: text(), allowed },
        Error::UnknownKey { key: text(), known: text() },
        Error::File { path: text(), reason: text() },
        Error::Recording { line: Some(7), column: Some(text()), reason: text() },
        Error::Unread { path: text(), reason: text() },
    ]
}

/// The names of all refusals, as library and kit write them.
fn names() -> Vec<&'static str> {
    let sources = [include_str!("../../src/error.rs"), include_str!("../../book/kit/src/error.rs")];
    let lines = sources.iter().flat_map(|source| {
        let (_, variants) = source.split_once("pub enum Error {\n").expect("the refusals");
        let (variants, _) = variants.split_once("\n}\n").expect("an end");
        variants.lines().filter_map(|line| line.strip_prefix("    "))
    });
    lines
        .filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()))
        .map(|line| line.split([' ', ',', '(']).next().expect("a name"))
        .filter(|name| *name != "Library")
        .collect()
}

/// The most digits in a row.
fn digits(message: &str) -> usize {
    let runs = message.split(|c: char| !c.is_ascii_digit());
    runs.map(str::len).max().unwrap_or(0)
}

/// Whatever its numbers are, a message can be read.
#[test]
fn messages_are_short() {
    let numbers = [
        1e300,
        -1e300,
        1e-300,
        -1e-300,
        -1.234_567_890_123_456_7e300,
        1.234_567_890_123_456_7e-300,
        f64::MAX,
        5e-324,
        0.1 + 0.2,
        -1e15 / 3.0,
        0.0,
        f64::INFINITY,
        f64::NAN,
    ];
    let mut cases = 0;
    for (i, x) in numbers.iter().enumerate() {
        for (j, y) in numbers.iter().enumerate() {
            let z = numbers[(i + 5 * j) % numbers.len()];
            let library = all(*x, *y, z).into_iter().map(kit::Error::from);
            for error in library.chain(of_pages(*x, *y, z)) {
                let message = error.to_string();
                // Counts of the machine's own size have twenty.
                let counts = message.replace(&u64::MAX.to_string(), "n");
                assert!(digits(&counts) <= DIGITS, "{message}");
                assert!(message.len() <= LENGTH + 2 * LIST, "{}: {message}", message.len());
                cases += 1;
            }
        }
    }
    let library = all(1.0, 2.0, 3.0);
    let pages = of_pages(1.0, 2.0, 3.0);
    let swept = library.iter().map(|error| format!("{error:?}"));
    let told: Vec<String> = (swept.chain(pages.iter().map(|error| format!("{error:?}")))).collect();
    assert_eq!(cases, told.len() * numbers.len() * numbers.len());
    // None is left out.
    let names = names();
    for name in &names {
        let is_told = told.iter().any(|t| t.split([' ', '{']).next() == Some(name));
        assert!(is_told, "{name}");
    }
    // At most 25 of the library, and seven of pages.
    assert_eq!(names.len(), 25 + 7);
    // Eight have two messages or cases, one of them three.
    assert_eq!(told.len(), names.len() + 9);
    // The damaged twin: the same number as it is printed without care.
    assert!(digits(&format!("{}", 1e300)) > 300);
}

/// A run in steps that the clock cannot tell apart is refused for that.
#[test]
fn a_coarse_clock_is_named() -> Result<()> {
    let decay = |tau: f64| ode(move |_, [y]: &[f64; 1]| [-y / tau]).scaled(size_or([1.0; 1]));
    let method = Dop853::new(1e-12)?;
    let mut cases = 0;
    for (t, tau) in [(1e6, 1e-10), (-1e6, 1e-10), (3e9, 1e-7), (1.0, 1e-16), (1e-3, 1e-19)] {
        for span in [10.0, 1e3, -1e3] {
            let error = method.advance(&decay(tau), t, &[1.0], t + span * tau);
            let Err(Error::StepUnderflow { clock: Some(_), .. }) = error else {
                panic!("{t} {tau}: {error:?}")
            };
            // As it says, the count from 0 helps.
            let (end, _) = method.advance(&decay(tau), 0.0, &[1.0], 10.0 * tau)?;
            assert!((end[0] / exp(-10.0) - 1.0).abs() < 1e-6, "{end:?}");
            cases += 1;
        }
    }
    assert_eq!(cases, 15);
    let error = method.advance(&decay(1e-10), 1e6, &[1.0], 1e6 + 1e-9).expect_err("coarse");
    let message = error.to_string();
    assert!(message.starts_with("at t = 1000000 the clock is too coarse: "), "{message}");
    assert!(message.contains("1.2e-10") && message.contains("count the time from 0"), "{message}");
    // The damaged twin: a pole is a pole, and no matter of the clock.
    let pole = ode(|_, [y]: &[f64; 1]| [y * y]).scaled(size_or([1.0; 1]));
    for t in [0.0, 1e3, -1e3] {
        let error = method.advance(&pole, t, &[1.0], t + 2.0);
        let Err(Error::StepUnderflow { clock: None, .. }) = error else { panic!("{t}: {error:?}") };
    }
    Ok(())
}

/// From 0 on no motion is too fast or too slow.
#[test]
fn any_time_will_do_from_zero() -> Result<()> {
    let mut errors = Errors::of("e^-1 after a time tau");
    for tau in [1e-300, 1e-200, 1e-100, 1e-20, 1.0, 1e20, 1e100, 1e200, 1e300] {
        let decay = ode(move |_, [y]: &[f64; 1]| [-y / tau]).scaled(size_or([1.0; 1]));
        let (end, _) = Dop853::new(1e-12)?.advance(&decay, 0.0, &[1.0], tau)?;
        errors.push_at(end[0] / exp(-1.0) - 1.0, tau);
    }
    assert_largest!(errors, 9, @"9.33e-15");
    // A spring.
    let spring = second_order(|_, x, _| -x);
    let (end, _) = Dop853::new(1e-12)?.advance(&spring, 0.0, &[1.0, 0.0], 1e-200)?;
    assert!((end[0] - cos(1e-200)).abs() < 1e-15);
    Ok(())
}

/// What is outside the parameters of elliptic functions says how to come in, and comes in by that.
#[test]
fn parameters_outside_say_how_to_map_them() -> Result<()> {
    for m in [-1.0, 4.0, 1.0 + 2e-16, -1e300] {
        let error = Modulus::from_m(m).expect_err("outside").to_string();
        for said in ["m < 0", "n = m/(m - 1)", "q K(n)", "q sd(u/q, n)", "sn(k u, 1/m)/k"] {
            assert!(error.contains(said), "{error}");
        }
        for error in [Modulus::from_m1(1.0 - m).err(), Modulus::from_k(-2.0).err()] {
            assert!(error.is_none_or(|e| e.to_string().contains("map m = ")));
        }
    }
    // By what is said: sn solves s'' = -(1 + m) s + 2 m s^3 from 0 at the rate 1, for any m.
    let mut errors = Errors::of("sn by the map, against its equation");
    let mut quarters = Errors::of("K by the map: where the rate of sn is 0");
    for m in [-0.1, -1.0, -7.5, 1.3, 4.0] {
        for u in [0.1, 0.35, 0.6] {
            let (mapped, rate) = if m < 0.0 {
                let (n, q) = (Modulus::from_m(m / (m - 1.0))?, 1.0 / (1.0_f64 - m).sqrt());
                let (s, _, d) = sn_cn_dn(u / q, n)?;
                (q * s / d, q)
            } else {
                let k = m.sqrt();
                (sn_cn_dn(k * u, Modulus::from_m(1.0 / m)?)?.0 / k, f64::NAN)
            };
            let elliptic = second_order(move |_, s, _| -(1.0 + m) * s + 2.0 * m * s * s * s);
            let method = Dop853::new(1e-15)?;
            let (end, _) = method.advance(&elliptic, 0.0, &[0.0, 1.0], u)?;
            errors.push_at(mapped - end[0], (m, u));
            if rate.is_finite() {
                let quarter = rate * legendre::k(Modulus::from_m(m / (m - 1.0))?)?;
                let (end, _) = method.advance(&elliptic, 0.0, &[0.0, 1.0], quarter)?;
                quarters.push_at(end[1], m);
            }
        }
    }
    assert_largest!(errors, 15, @"9.44e-16");
    assert_largest!(quarters, 9, @"2.19e-15");
    Ok(())
}

/// An effect that says that it does not depend on how the body turns; it does, but only where the
/// body is turned by more than this (rad).
struct Turned(f64);

impl Effect for Turned {
    const PROPERTIES: Properties = Properties { on_rates: false, ..Properties::ANYTHING };
    fn name(&self) -> &'static str {
        "spring"
    }
    fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        let far = state.attitude.angle_to(&Attitude::IDENTITY) >= self.0;
        state.angular_momentum * if far { -1.0 } else { 0.0 }
    }
}

#[test]
fn refusals_say_where_and_hint_at_a_way_out() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    let contradicted = |from| check(&Turned(from), &body, [0.0, 1.0], &start);
    let typed = |z: f64| [[0.866, -0.5, 0.0], [0.5, 0.866, 0.0], [0.0, 0.0, z]];
    let slides = Error::Sliding { effect: "relay".into(), t: 1.0 };
    let said = |refused: Result<()>| refused.expect_err("refused").to_string();
    let cases = [
        (said(contradicted(0.0)), "how the body turns, and at t = 0 its torque"),
        (said(contradicted(0.1)), "at another attitude and momentum, its torque is off"),
        (
            said(Attitude::from_matrix(typed(1.0)).map(|_| ())),
            "`Attitude::nearest` finds the rotation nearest to it",
        ),
        (
            said(Attitude::from_matrix(typed(-1.0)).map(|_| ())),
            "it must be +1, of right-handed axes",
        ),
        (slides.to_string(), "hysteresis, sample it at a rate (`Torque::sampled`)"),
    ];
    let mut ran = 0;
    for (said, words) in cases {
        assert!(said.contains(words), "{said} should contain {words}");
        ran += 1;
    }
    assert_eq!(ran, 5);
    Ok(())
}
