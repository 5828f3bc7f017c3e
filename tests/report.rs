//! Claims, limits and reports: what may be printed, and what may not.

use kit::{
    Answer, Claim, EffectLine, Entry, Error, Limit, Price, Report, Table, Verdict, effect, limit,
    parse,
};
use serde_json::Value;

fn claim(value: f64, oracle: f64, bound: f64) -> Claim {
    kit::claim("rate", "rate of turning", value, "rad/s").agrees_with("oracle", oracle, bound)
}

fn added(entry: impl Entry) -> Result<(), Error> {
    Report::new("A title", "What the scene is.")?.add(entry)
}

/// A claim is added only if its oracle agrees; the comparison is a positive condition,
/// so a NaN anywhere fails it.
#[test]
fn a_contradicted_number_cannot_be_claimed() {
    assert!(added(claim(1.0, 1.0 + 1e-9, 1e-9 * (1.0 + 1e-6))).is_ok());
    let mut refused = 0;
    for (value, oracle, bound) in [
        (1.0, 1.0 + 1.1e-9, 1e-9),
        (f64::NAN, 1.0, 1e-9),
        (1.0, f64::NAN, 1e-9),
        (1.0, 1.0, f64::NAN),
        (1.0, 1.0, f64::INFINITY),
        (f64::INFINITY, f64::INFINITY, 1e-9),
        (f64::INFINITY, 1.0, f64::INFINITY),
    ] {
        assert!(
            matches!(added(claim(value, oracle, bound)), Err(Error::Contradicted { .. })),
            "{value} {oracle} {bound}"
        );
        refused += 1;
    }
    assert_eq!(refused, 7);
    let told = added(claim(1.0, 2.0, 0.5)).expect_err("contradicted").to_string();
    assert_eq!(told, "rate = 1.0 is contradicted: oracle gives 2.0, and they may differ by 0.5");
    assert!(added(slow(1e-16)).is_ok());
    assert!(added(slow(1e-14)).is_err());
    assert!(added(slow(f64::NAN)).is_err());
}

fn slow(gives: f64) -> Limit {
    limit("slow", 0.0, gives).because("nothing moves").within(1e-15)
}

#[test]
fn text_that_would_break_a_table_is_refused() {
    let named = |key: &str, meaning: &str, unit: &str| {
        added(kit::claim(key, meaning, 1.0, unit).agrees_with("oracle", 1.0, 0.0))
    };
    assert!(named("rate_2", "rate of turning", "rad/s").is_ok());
    for (key, meaning, unit) in [
        ("Rate", "rate of turning", "rad/s"),
        ("", "rate of turning", "rad/s"),
        ("rate", "rate  of turning", "rad/s"),
        ("rate", "rate\nof turning", "rad/s"),
        ("rate", " rate", "rad/s"),
        ("rate", "", "rad/s"),
        ("rate", "rate of turning", ""),
    ] {
        assert!(
            matches!(named(key, meaning, unit), Err(Error::Text { .. })),
            "{key} {meaning} {unit}"
        );
    }
    let table = || Table::new("masses", ["m", "t"]).expect("a sound table");
    assert!(table().row(["1", "2"]).is_ok());
    assert!(table().row(["1"]).is_err());
    assert!(table().row(["1", ""]).is_err());
    assert!(Table::new("Masses", ["m"]).is_err());
    assert!(Table::new("masses", Vec::<String>::new()).is_err());
}

fn sound() -> Report {
    let mut report = Report::new("A title", "What the scene is.").expect("sound");
    report.add(claim(1.25, 1.25, 1e-3).slip(2.0, "that is twice").answer("rates")).expect("sound");
    report.add(slow(1e-16)).expect("sound");
    let drag = effect("air drag").number("rho C A l / m", 0.0123);
    report.add(drag.costs(4.56e-7, "rad")).expect("sound");
    let price = report.add(Price {
        method: "RK4".into(),
        requested: None,
        delivered: 3.2e-9,
        work: "400 torques".into(),
        again: None,
    });
    price.expect("sound");
    let table = Table::new("masses", ["m", "t"]).and_then(|t| t.row(["1", "-2"])).expect("sound");
    report.add(table).expect("sound");
    report
}

#[test]
fn a_report_has_its_sections_in_order_and_reads_back() {
    let text = sound().text().expect("sound");
    assert_eq!(
        text,
        "A title\nWhat the scene is.\n\n\
         claims\nkey   value  unit   bound  checked against  differs by\n\
         rate  1.250  rad/s  1e-3   oracle           <1e-15\n\n\
         limits\nlimit  must give  gives  within  because\n\
         slow   0          0      1e-15   nothing moves\n\n\
         effects\neffect    number         value  error if left out  here      at 1e-2\n\
         air drag  rho C A l / m  0.012  4.6e-7 rad         left out  out\n\n\
         accuracy\nmethod  requested  delivered  work         relative time\n\
         RK4     -          4e-9       400 torques  -\n\n\
         table masses\nm   t\n1  -2\n\n\
         checks\nkey   within  meaning          group\nrate  1e-3    rate of turning  rates\n\n\
         slips\nkey   value  hint\nrate  2.000  that is twice\n"
    );
    let parsed = parse(&text).expect("it follows its grammar");
    let tables = sound().sections().expect("sound");
    assert_eq!(parsed.tables, tables);
}

#[test]
fn a_report_refuses_what_it_cannot_print() {
    let mut report = sound();
    let again = claim(1.0, 1.0, 0.0);
    assert!(report.add(again).is_err(), "the key is taken");
    let other = |key: &str| kit::claim(key, "another", 1.0, "-").agrees_with("oracle", 1.0, 0.0);
    assert!(report.add(other("a").judged_within(0.0)).is_err());
    assert!(report.add(other("a").judged_within(f64::NAN)).is_err());
    assert!(report.add(other("a").slip(f64::NAN, "no number")).is_err());
    assert!(report.add(other("a").slip(1.0, "two  spaces")).is_err());
    assert!(report.add(other("a")).is_ok());
    assert!(report.add(Table::new("masses", ["m"]).expect("sound")).is_err(), "the name is taken");
    let price = report.add(Price {
        method: "RK4".into(),
        requested: Some(1e-9),
        delivered: f64::NAN,
        work: "400 torques".into(),
        again: None,
    });
    price.expect("a line");
    assert!(matches!(
        report.text(),
        Err(Error::Library(rotation_dynamics::Error::NotFinite { .. }))
    ));
}

/// The order of the rules: right, listed slip, nearly, usual slip, wrong.
#[test]
fn answers_are_judged_by_the_stated_rules() {
    let judged = claim(0.25, 0.25, 1e-6).judged_within(1e-4).slip(0.2501, "nearly a slip");
    for (answer, verdict) in [
        (0.25, Verdict::Right),
        (0.250_004, Verdict::Right),
        (0.250_024, Verdict::RightTo(4, 5)),
        (0.2501, Verdict::Slip("nearly a slip".into())),
        (0.250_3, Verdict::RightTo(3, 5)),
        (0.2512, Verdict::RightTo(2, 5)),
        (0.26, Verdict::Wrong),
        (4.0, Verdict::Slip("that is one over the value".into())),
        (f64::MAX, Verdict::Wrong),
    ] {
        assert_eq!(judged.verdict(answer), verdict, "{answer}");
    }
    // A value of zero has no digits and no factors: its tolerance is absolute.
    let zero = claim(0.0, 0.0, 1e-12);
    assert_eq!(zero.verdict(5e-4), Verdict::Right);
    assert_eq!(zero.verdict(0.1), Verdict::Wrong);
}

/// The one-line builders give the same report, and what they lack is refused.
#[test]
fn a_line_without_its_parts_is_refused() {
    use kit::claim;
    let rate = || claim("rate", "rate of turning", 1.25, "rad/s");
    let mut report = sound();
    let mut refused = 0;
    for outcome in [
        report.add(rate().within(1e-3).against("oracle", 1.25)), // the key is taken
        report.add(claim("new", "no bound", 1.0, "-").against("oracle", 1.0)),
        report.add(claim("new", "no oracle", 1.0, "-").within(1.0)),
        report.add(limit("slow", 0.0, 0.0).because("no bound")),
        report.add(limit("slow", 0.0, 0.0).within(1e-15)), // no reason
        report.add(effect("wind").number("no error", 1.0)),
        report.add(effect("wind").costs(1.0, "-")), // no number
    ] {
        assert!(outcome.is_err());
        refused += 1;
    }
    assert_eq!(refused, 7);
}

kit::parameters! {
    /// One of each kind.
    pub struct Kinds {
        /// how far
        far_off: number(2.0, "m", between(0.0, 3.0));
        /// a share
        part: optional("-", above_to(0.0, 1.0));
        /// which one
        which: choice("first", "second");
    }
}

#[test]
fn parameters_are_declared_once_and_checked() {
    use kit::ParameterSet;
    let default = Kinds::default();
    assert_eq!((default.far_off, default.part, default.which), (2.0, None, "first"));
    assert!(default.check().is_ok());
    let names: Vec<String> = Kinds::FLAGS.iter().map(|flag| flag.name()).collect();
    assert_eq!(names, ["far-off", "part", "which"]);
    let rows = |p: &Kinds| p.table().expect("sound").rows().len();
    assert_eq!(rows(&default), 2, "what is not set is not listed");
    let mut refused = 0;
    for (far_off, part, message) in [
        (0.0, None, "far_off = 0 is not allowed: it must lie between 0 and 3"),
        (3.0, None, "far_off = 3 is not allowed: it must lie between 0 and 3"),
        (2.0, Some(1.5), "part = 1.5 is not allowed: it must be greater than 0 and at most 1"),
        (f64::NAN, Some(1.0), "far_off = NaN is not allowed: it must lie between 0 and 3"),
    ] {
        let kinds = Kinds { far_off, part, ..Kinds::default() };
        assert_eq!(kinds.check().expect_err("refused").to_string(), message);
        refused += 1;
    }
    assert_eq!(refused, 4);
    let sound = Kinds { part: Some(1.0), ..Kinds::default() };
    assert!(sound.check().is_ok() && rows(&sound) == 3);
}

/// Whoever gives the digits that are asked for, correctly rounded, is right, and whoever is one off
/// in the last of them is not.
#[test]
fn the_digits_that_are_asked_for_decide() {
    use rotation_dynamics::math::{pow, sin};
    let (mut right, mut wrong, mut forgiven) = (0, 0, 0);
    for i in 0..2000 {
        let x = f64::from(i);
        let value = pow(10.0, 12.0 * sin(1.7 * x)) * if i % 2 == 0 { 1.0 } else { -1.0 };
        for (relative, digits) in [(0.02, 3), (1e-3, 4), (1e-6, 7)] {
            let judged = claim(value, value, 0.0).judged_within(relative);
            let text = format!("{value:.*e}", digits - 1);
            let (mantissa, exponent) = text.split_once('e').expect("an exponent");
            let plain: i64 = mantissa.replace('.', "").parse().expect("digits");
            let last = exponent.parse::<i32>().expect("whole") + 1 - digits as i32;
            let verdict = |digits: i64| {
                let answer = Answer::read(&format!("{digits}e{last}")).expect("a number");
                let near = (answer.value - value).abs() <= relative * value.abs();
                (judged.verdict(answer) == Verdict::Right, near)
            };
            right += usize::from(verdict(plain).0);
            for off in [plain - 1, plain + 1] {
                let (told_right, near) = verdict(off);
                wrong += usize::from(!told_right);
                forgiven += usize::from(near);
            }
        }
    }
    assert_eq!((right, wrong), (6000, 12_000));
    // The twin takes the relative error alone, and lets 11 536 pass.
    assert!(forgiven > 11_500, "{forgiven}");
}

/// The shared cases of the command line and of the page's answer box.
#[test]
fn the_cases_of_the_answer_box_are_judged_alike() {
    let text = include_str!("data/answers.json");
    let cases: Value = serde_json::from_str(text).expect("JSON");
    let number = |check: &Value, name: &str| check[name].as_f64().expect("a number");
    let said = |text: &str, claim: Option<&Claim>| match (Answer::read(text), claim) {
        (Err(error), _) => error.to_owned(),
        (Ok(answer), Some(claim)) => claim.verdict(answer).words(),
        (Ok(answer), None) => format!("read as {answer:?}"),
    };
    let mut judged = 0;
    for case in cases["judged"].as_array().expect("cases") {
        let [key, text, words] = [0, 1, 2].map(|n| case[n].as_str().expect("text"));
        let check = &cases["checks"][key];
        let value = number(check, "value");
        let unit = check["unit"].as_str().expect("text");
        let mut claim = kit::claim(key, key, value, unit)
            .agrees_with("itself", value, number(check, "bound"))
            .judged_within(number(check, "within"));
        for slip in check["slips"].as_array().expect("slips") {
            claim = claim.slip(number(slip, "value"), slip["hint"].as_str().expect("text"));
        }
        assert_eq!(said(text, Some(&claim)), words, "{key} = '{text}'");
        judged += 1;
    }
    for case in cases["refused"].as_array().expect("cases") {
        let [text, words] = [0, 1].map(|n| case[n].as_str().expect("text"));
        assert_eq!(said(text, None), words, "'{text}'");
        judged += 1;
    }
    assert_eq!(judged, 134);
}

/// A line of the card: its number, what is predicted, what is measured.
fn measured(number: f64, predicted: f64, measured: impl Into<Option<f64>>) -> EffectLine {
    let line = effect("air drag").number("rho C A l / m", number);
    line.costs(predicted, "rad").measured(measured)
}

#[test]
fn the_card_becomes_a_ledger_where_something_is_measured() {
    let mut report = Report::new("A title", "What the scene is.").expect("sound");
    report
        .add(vec![
            measured(0.01, 2.0e-3, 2.1e-3).at_cost("closed form, 812 torques"),
            effect("weight").number("m g l / L w", 0.03).costs(6.3, "rad").included(),
        ])
        .expect("sound");
    let text = report.text().expect("sound");
    let expected = "effects\n\
        effect    number         value  error if left out  measured  cost: without, with       here      at 1e-2\n\
        air drag  rho C A l / m  0.010  0.0020 rad         0.0021    closed form, 812 torques  left out  out\n\
        weight    m g l / L w    0.030  6.3 rad            -         -                         in        in\n";
    assert!(text.ends_with(expected), "{text}");
    assert_eq!(
        parse(&text).expect("it follows its grammar").tables,
        report.sections().expect("sound")
    );
}

/// What the card says of an effect whose error of this size and unit is asked for, beside some
/// claims.
fn neglected_effects(
    asked: f64,
    error: f64,
    unit: &str,
    beside: Option<&str>,
) -> Result<String, String> {
    let mut report = Report::new("A title", "What the scene is.").expect("sound");
    for (key, value, unit) in [
        ("mass", 3.0, "kg"),
        ("spin", -5.0, "kg m^2/s"),
        ("rate", 2.5, "rad/s"),
        ("other", 70.0, "rad/s"),
        ("turns", 4.0, "-"),
    ] {
        let told = kit::claim(key, "a size", value, unit);
        report.add(told.within(1e-9).against("by hand", value)).expect("sound");
    }
    let line = effect("wind").number("n", 0.5).costs(error, unit);
    let line = beside.map_or(line.clone(), |key| line.beside(key));
    let added = report.ask(asked).and_then(|()| report.add(line));
    let sections = added.and_then(|()| report.sections()).map_err(|e| e.to_string())?;
    let card = sections.iter().find(|table| table.heading() == "effects").expect("it has a line");
    assert_eq!(card.columns().last().map(String::as_str), Some(format!("at {asked:e}").as_str()));
    Ok(card.rows()[0].last().cloned().expect("a cell"))
}

/// A part beside the whole, an angle beside a radian, the rest beside the claim in its unit: in if
/// twice the error is larger than the part asked for. A hair decides.
#[test]
fn an_effect_is_in_or_out_at_the_accuracy_asked_for() {
    let hair = 1.0 + 1e-12;
    let mut ran = 0;
    for (asked, error, unit, beside, told) in [
        (0.01, 0.005, "-", None, "out"),
        (0.01, 0.005 * hair, "-", None, "in"),
        (0.01, -0.005 * hair, "of the period", None, "in"),
        (0.02, -0.005 * hair, "of the period", None, "out"),
        (1e-3, 5e-4, "rad a turn", None, "out"),
        (1e-3, 5e-4 * hair, "rad, at most", None, "in"),
        (0.01, 0.28, "deg", None, "out, 0.57 deg"),
        (0.01, 0.29, "deg in a day", None, "in, 0.57 deg"),
        (0.01, 0.0125, "rad/s", None, "out, 0.025 rad/s"),
        (0.01, 0.0125 * hair, "rad/s: it slips", None, "in, 0.025 rad/s"),
        (0.01, 0.0125 * hair, "rad/s", Some("other"), "out, 0.70 rad/s"),
        // Not beside the mass.
        (0.1, 0.25, "kg m^2/s later", None, "out, 0.50 kg m^2/s"),
        (0.1, 0.25 * hair, "kg m^2/s later", None, "in, 0.50 kg m^2/s"),
        (0.1, 0.1, "turns", Some("mass"), "out, 0.30 kg"),
        (0.1, 0.1, "turns", Some("turns"), "out, 0.40"),
    ] {
        assert_eq!(
            neglected_effects(asked, error, unit, beside).as_deref(),
            Ok(told),
            "{error} {unit}"
        );
        ran += 1;
    }
    assert_eq!(ran, 15);
    for (asked, unit, beside, words) in [
        (0.01, "m", None, "wind: m"),
        (0.01, "offered", None, "wind: offered"),
        (0.01, "rad/s^2", None, "wind: rad/s^2"),
        (0.01, "m", Some("length"), "length"),
        (0.0, "-", None, "the accuracy asked for = 0"),
        (-1.0, "-", None, "the accuracy asked for = -1"),
        (f64::NAN, "-", None, "the accuracy asked for"),
        (f64::INFINITY, "-", None, "the accuracy asked for"),
    ] {
        let told = neglected_effects(asked, 0.5, unit, beside).expect_err("it is refused");
        assert!(told.contains(words), "{told}");
    }
}

/// Half and twice the prediction are within the factor 2, a little more is not; of a large
/// effect anything may come.
#[test]
fn a_prediction_that_no_simulation_bears_out_is_refused() {
    let add = |line| Report::new("A title", "What the scene is.").expect("sound").add(line);
    let mut ran = 0;
    for (number, predicted, found, sound) in [
        (0.01, 2e-3, 1e-3, true),
        (0.01, 2e-3, 4e-3, true),
        (0.01, -2e-3, -1.5e-3, true),
        (0.0, 0.0, 0.0, true),
        (0.01, 2e-3, 0.999e-3, false),
        (0.01, 2e-3, 4.001e-3, false),
        (0.01, 2e-3, -2e-3, false),
        (0.01, 2e-3, 0.0, false),
        (-0.01, 0.0, 1e-9, false),
        (0.1, 2e-3, 8e-3, false),
        // Not small.
        (0.11, 2e-3, 8e-3, true),
        (0.11, 2e-3, f64::NAN, false),
        (0.01, 2e-3, f64::INFINITY, false),
    ] {
        let added = add(measured(number, predicted, found));
        assert_eq!(added.is_ok(), sound, "{number} {predicted} {found}: {added:?}");
        ran += 1;
    }
    assert_eq!(ran, 13);
    assert!(add(measured(0.01, 2e-3, None)).is_ok(), "nothing is measured");
    // What the simulation cannot tell apart is not held against the prediction.
    assert!(add(measured(0.01, 0.0, 1e-9).within(2e-9)).is_ok());
    assert!(add(measured(0.01, 2e-3, 5e-3).within(f64::NAN)).is_err());
    let told = add(measured(0.01, 2e-3, 5e-3)).expect_err("refused").to_string();
    for part in ["leaving out 'air drag'", "0.002", "simulation with it and without gives 0.005"] {
        assert!(told.contains(part), "{part} in {told}");
    }
}
