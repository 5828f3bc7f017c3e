//! The plank on two rollers (exercise 16.8): stick, slip, limit cycle, lift-off.

use super::G;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{atan, sincos};
use rotation_dynamics::planar::contact::{Contact, Mechanism, Mode, Motion, State, motion};
use serde_json::Value;
use support::{EPS, Errors, assert_error};

/// A thin plank of 2 kg and 3 m on rollers a distance `a` apart, whose tops move with `speed`
/// toward each other (or apart, if it is negative).
struct Plank {
    a: f64,
    g: f64,
    kinetic: f64,
    holding: f64,
    speed: f64,
}

impl Mechanism<3, 6, 2> for Plank {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.5]]
    }
    fn force(&self, _: &State<3>) -> [f64; 3] {
        [0.0, -2.0 * self.g, 0.0]
    }
    fn contacts(&self, plank: &State<3>) -> [Contact<3>; 2] {
        let ([x, y, tilt], [vx, vy, omega]) = (plank.q, plank.v);
        let (s, c) = sincos(tilt);
        let roller = |name, at: f64, speed: f64| {
            let gap = y * c - (x - at) * s;
            let lever = -(x - at) * c - y * s;
            let bias = -2.0 * omega * (c * vx + s * vy) - gap * omega * omega;
            Contact::new(name, gap, [-s, c, lever], bias)
                .tangent([c, s, 0.0], omega * (c * vy - s * vx))
                .frictions(self.kinetic, self.holding)
                .moving(speed)
        };
        [
            roller("left", -0.5 * self.a, self.speed),
            roller("right", 0.5 * self.a, -self.speed),
        ]
    }
}

fn laid(plank: &Plank, x: f64, v: f64, t_end: f64) -> Motion<&Plank, 3, 6, 2> {
    let start = State {
        q: [x, 0.0, 0.0],
        v: [v, 0.0, 0.0],
    };
    motion(plank, &Dop853::new(1e-14).unwrap(), start, t_end).unwrap()
}

/// The reference cases, in the order of the file.
fn cases() -> Vec<Value> {
    let text = include_str!("../data/reference.json");
    let all: Value = serde_json::from_str(text).unwrap();
    let all = all["cases"].as_array().unwrap().clone();
    all.into_iter()
        .filter(|c| c["kind"] == "roller_plank")
        .collect()
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

/// The errors of a case in units of eps (|value| + sensitivity), if the plank has `change`
/// times the friction of the case.
fn deviation(case: &Value, change: f64) -> Errors {
    let of = |name: &str| number(&case["inputs"][name]);
    let sense = if case["inputs"]["sense"] == "in" {
        1.0
    } else {
        -1.0
    };
    let plank = Plank {
        a: of("a"),
        g: of("g"),
        kinetic: of("mu_k") * change,
        holding: of("mu_s") * change,
        speed: sense * of("V"),
    };
    let samples = case["samples"].as_array().unwrap();
    let events = case["derived"]["events"].as_array().unwrap();
    let last = samples.iter().chain(events).map(|s| number(&s["t"]));
    let motion = laid(&plank, of("x0"), of("v0"), last.fold(0.0, f64::max) + 1e-3);
    let mut errors = Errors::of(case["id"].to_string());
    for sample in samples {
        let t = number(&sample["t"]);
        let state = motion.at(t).unwrap();
        let modes = motion.modes(t).unwrap().map(|m| m == Mode::Stick);
        let stuck = match sample["stuck"].as_str().unwrap() {
            "no" => [false, false],
            "stickL" => [true, false],
            other => [false, other == "stickR"],
        };
        assert_eq!(modes, stuck, "{} at {t}", case["id"]);
        for (name, got) in [("x", state.q[0]), ("v", state.v[0])] {
            let want = number(&sample[name]);
            let unit = EPS * (want.abs() + number(&sample["sens_norm"][name]));
            errors.push_at((got - want) / unit, (name, t));
        }
    }
    assert_eq!(motion.events().len(), events.len(), "{:?}", motion.events());
    for (event, want) in motion.events().iter().zip(events) {
        let name = match want["event"].as_str().unwrap() {
            "catchR" => "right sticks",
            "break" => "right slips",
            other => {
                assert_eq!(other, "tip");
                "left lets go"
            }
        };
        assert_eq!(event.name, name);
        // Times have no sensitivity of their own in the file: that of x over the speed.
        let unit = EPS * (number(&want["t"]) + 30.0 / event.before.v[0].abs());
        errors.push_at((event.t - number(&want["t"])) / unit, name);
    }
    errors
}

#[test]
fn planks_agree_with_the_reference() {
    let cases = cases();
    assert_eq!(cases.len(), 3);
    let measured = [(36.0..=37.0, 6), (6.0..=6.1, 10), (3.8..=3.9, 8)];
    for (case, (range, count)) in cases.iter().zip(measured) {
        deviation(case, 1.0).attain(range, count);
        assert!(deviation(case, 1.0 + 1e-9).largest() > 1e4);
    }
}

/// Errors of period and amplitude of the limit cycle, if the holding friction is off by the
/// part `damage`.
fn limit_cycle(damage: f64) -> Errors {
    let (a, mu, mu_s, v) = (1.2, 0.2, 0.35, 0.25);
    let plank = Plank {
        a,
        g: G,
        kinetic: mu,
        holding: mu_s * (1.0 + damage),
        speed: v,
    };
    let motion = laid(&plank, 0.3, 0.0, 30.0);
    let named = |name| motion.events().iter().filter(move |e| e.name == name);
    let catches: Vec<_> = named("right sticks").map(|e| e.t).collect();
    let lambda = (2.0 * mu * G / a).sqrt();
    let x_s = 0.5 * a * (mu_s - mu) / (mu_s + mu);
    let period = 4.0 * x_s / v + 4.0 / lambda * atan(v / (lambda * x_s));
    assert_error!(period, 4.17036398431852, 9.6 eps);
    let mut errors = Errors::of("limit cycle");
    // The first catch is not yet in the cycle.
    for pair in catches[1..].windows(2) {
        errors.add(pair[1] - pair[0], period, period);
    }
    for breaks in named("right slips") {
        errors.add(breaks.before.q[0].abs(), x_s, x_s);
    }
    errors
}

/// Holding better than it slips, the plank ends in a limit cycle of stick and slip.
#[test]
fn stick_and_slip_have_a_period() {
    limit_cycle(0.0).attain(6.2e-14..=6.3e-14, 13);
    limit_cycle(1e-9).exceed(1e-11, 13);
}

/// Pushed outward past the roller, the plank lifts off the other and tips.
#[test]
fn a_plank_lifts_off() {
    let pushed = |a| {
        let plank = Plank {
            a,
            g: G,
            kinetic: 0.3,
            holding: 0.3,
            speed: -5.0,
        };
        let motion = laid(&plank, 0.49, 0.0, 0.5);
        let lifts = motion.event("left lets go").unwrap().before.q[0];
        let [_, right] = motion.forces(0.5).unwrap();
        (
            lifts,
            motion.at(0.5).unwrap(),
            right,
            motion.drift().unwrap(),
        )
    };
    let (lifts, end, right, (gap, _)) = pushed(1.0);
    assert_error!(lifts, 0.5, 4.0 eps);
    assert!(end.q[2] < 0.0 && end.q[0] > 0.5, "{end:?}");
    assert!(right.normal > 0.0);
    assert_error!(gap, 7.5e-17);
    // The damaged twin: rollers that stand elsewhere.
    assert!((pushed(1.0 + 1e-12).0 / 0.5 - 1.0).abs() > 1e3 * EPS);
}
