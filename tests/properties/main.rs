//! What must hold for every legal input, tried on random ones.
//!
//! proptest draws the inputs: bodies from needles to discs, rates from 1e-200 to 1e8 rad/s,
//! spans of up to a million radians, attitudes at and beside the poles. Each property has its share of
//! inputs, of which `cargo test` runs half, and the gate all; with `PROPERTY_CASES=N` every property
//! runs N times its share, and with `PROPERTY_SEED=S` others:
//!
//! ```text
//! PROPERTY_CASES=100 cargo test --release --package checks --test properties -- --nocapture
//! ```
//!
//! What has been run is written down in `benches/record/properties.txt`.

mod attitudes;
mod drawn;
mod free_body;
mod given;
mod heavy_top;
mod scenes;

use core::cell::Cell;
use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};

/// A number from the environment.
fn asked(name: &str) -> Option<u32> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name}={text} is no number")))
}

/// Asserts that `property` holds of half of `share` inputs, or of `PROPERTY_CASES` times as many. It says how often
/// it was asked in vain: where a clear error was the answer. That may be at most the part
/// `refused` of all.
#[track_caller]
pub fn holds<S: Strategy>(
    name: &str,
    share: u32,
    refused: f64,
    inputs: S,
    property: impl Fn(S::Value) -> Result<Held, TestCaseError>,
) {
    let cases = asked("PROPERTY_CASES").map_or(share.div_ceil(2), |times| share * times);
    let mut seed = [0; 32];
    seed[..4].copy_from_slice(&asked("PROPERTY_SEED").unwrap_or(1).to_le_bytes());
    let config =
        Config { cases, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let (ran, vain) = (Cell::new(0_u32), Cell::new(0_u32));
    let outcome = TestRunner::new_with_rng(config, rng).run(&inputs, |input| {
        ran.set(ran.get() + 1);
        if property(input)? == Held::Refused {
            vain.set(vain.get() + 1);
        }
        Ok(())
    });
    match outcome {
        Ok(()) => {}
        Err(TestError::Fail(reason, input)) => panic!("{name}: {reason}\n{input:?}"),
        Err(TestError::Abort(reason)) => panic!("{name}: {reason}"),
    }
    assert_eq!(ran.get(), cases, "{name}");
    let (ran, vain) = (f64::from(ran.get()), f64::from(vain.get()));
    println!("{name}: {ran} cases, {vain} of them refused");
    assert!(vain <= refused * ran, "{name}: {vain} of {ran} refused");
}

/// What came of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Held {
    /// The property holds.
    Yes,
    /// The input was refused with a reason.
    Refused,
}

/// Fails the case unless `error` is a number, at most `bound`.
#[macro_export]
macro_rules! within {
    ($error:expr, $bound:expr, $what:expr) => {{
        let (error, bound): (f64, f64) = ($error, $bound);
        proptest::prop_assert!(error <= bound, "{}: {error:e}, not within {bound:e}", $what);
    }};
}

/// The value, or the end of this case: it was refused. A refusal has a text to read.
#[macro_export]
macro_rules! or_refused {
    ($outcome:expr) => {
        match $outcome {
            Ok(value) => value,
            Err(error) => {
                let text = error.to_string();
                if std::env::var_os("PROPERTY_REFUSALS").is_some() {
                    println!("refused: {text}");
                }
                proptest::prop_assert!(text.len() > 10 && !text.contains("Error"), "{text}");
                return Ok($crate::Held::Refused);
            }
        }
    };
}

/// A property that is false is found to be so: the twin of all others.
#[test]
#[should_panic(expected = "not within")]
fn a_false_property_is_noticed() {
    holds("damaged", 100, 0.0, drawn::attitude(), |attitude| {
        let there = attitude.euler_angles();
        let angles = rotation_dynamics::attitude::EulerAngles { phi: there.zeta, ..there };
        let back = rotation_dynamics::attitude::Attitude::from_euler(angles).unwrap();
        within!(back.angle_to(&attitude), 1e-12, "zeta for phi");
        Ok(Held::Yes)
    });
}

/// An input that is always refused is noticed as well.
#[test]
#[should_panic(expected = "refused")]
fn a_property_that_is_asked_in_vain_is_noticed() {
    holds("damaged", 100, 0.5, drawn::attitude(), |_| Ok(Held::Refused));
}
