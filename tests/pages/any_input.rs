//! Whatever a reader types, on the command line of a page or into its answer box: a result or
//! a clear error. `PROPERTY_CASES=N` tries N times as much, `PROPERTY_SEED=S` other things; without
//! the first a quarter is tried.

use crate::answers::{asked, thinned};
use kit::{Answer, claim, Report};
use pages::ALL;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

fn runner(cases: u32) -> TestRunner {
    let mut seed = [0; 32];
    let asked = asked("PROPERTY_SEED").unwrap_or(1) as u32;
    seed[..4].copy_from_slice(&asked.to_le_bytes());
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 100, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
}

/// What may stand after a flag: numbers that are allowed, or hardly, or not at all.
fn value() -> impl Strategy<Value = String> {
    let odd = [
        "", "0", "-0", "1", "-1", "1e308", "-1e308", "1e309", "5e-324", "nan", "NaN", "inf",
        "-inf", "1e", "1,5", "0x10", "2/3", "pi", "--", "1e-300", "3.141592653589793", "½", "١",
        "1_000", "+", ".", "1.5.2", "e", "rest", "🦀", "99999999999999999999999999999999999999999",
    ];
    prop_oneof![
        3 => prop::sample::select(odd.to_vec()).prop_map(str::to_owned),
        1 => any::<f64>().prop_map(|x| x.to_string()),
        1 => "[-+.eE0-9a-z/ ]{0,12}".prop_map(|text| text.replace(' ', "")),
    ]
}

#[test]
fn command_lines() {
    let page = 0..ALL.len();
    let flag = (any::<prop::sample::Index>(), 0..8_usize, value());
    let inputs = (page, prop::collection::vec(flag, 1..4));
    let ran = core::cell::Cell::new(0);
    let cases = thinned(400, 4) as u32;
    let said = runner(cases).run(&inputs, |(page, flags)| {
        let page = ALL[page];
        let known = page.flags();
        let words: Vec<String> = flags
            .iter()
            .map(|(index, kind, value)| match kind {
                0 => format!("--{value}"),
                1 => format!("--check={}={value}", known[index.index(known.len())]),
                2 => value.clone(),
                3 => format!("--with={value}"),
                _ => format!("--{}={value}", known[index.index(known.len())]),
            })
            .collect();
        let told = page.answer(&words.join(" "));
        let line = format!("{} {}", page.stem(), words.join(" "));
        // This page quotes a refusal with a NaN in it.
        let quotes = page.stem() == "library";
        let nan = told.stdout.contains("NaN") && !quotes;
        match told.code {
            0 | 1 => prop_assert!(!told.stdout.is_empty() && !nan, "{line}"),
            2 => prop_assert!(told.stdout.is_empty() && told.stderr.len() > 10, "{line}"),
            code => prop_assert!(false, "{line}: {code}"),
        }
        ran.set(ran.get() + 1);
        Ok(())
    });
    said.unwrap_or_else(|error| panic!("{error}"));
    println!("command lines: {} cases", ran.get());
    assert!(ran.get() >= cases);
}

#[test]
fn answers() {
    let mut report = Report::new("A rod", "a rod about its end").expect("a report");
    let third = claim("moment", "moment of inertia", 1.0 / 3.0, "kg m^2");
    let third = third.agrees_with("again", 1.0 / 3.0, 1e-12).slip(0.5, "not that").answer("The rod");
    report.add(third).expect("a claim");
    let claim = report.claim("moment").expect("it was added");
    let grammar = "[-+0-9.,eEx*/^() pisqrtkgmNs²³⁻·×π√−]{0,24}";
    let texts = prop_oneof![3 => grammar, 1 => any::<String>(), 1 => value()];
    let (read, refused) = (core::cell::Cell::new(0), core::cell::Cell::new(0));
    let cases = thinned(20_000, 4) as u32;
    let said = runner(cases).run(&texts, |text| {
        match Answer::read(&text) {
            Ok(answer) => {
                prop_assert!(answer.value.is_finite(), "{text:?} is read as {}", answer.value);
                prop_assert!(!claim.verdict(answer).words().is_empty());
                read.set(read.get() + 1);
            }
            Err(why) => {
                prop_assert!(why.len() > 5);
                refused.set(refused.get() + 1);
            }
        }
        Ok(())
    });
    said.unwrap_or_else(|error| panic!("{error}"));
    println!("answers: {} read, {} refused", read.get(), refused.get());
    assert!(read.get() > cases / 40 && refused.get() > cases / 40, "{} {}", read.get(), refused.get());
}
