//! Section 15.3, example 3: the falling plank.

use crate::answers::{answer, confirmed, refused, value};
use core::f64::consts::FRAC_PI_2;
use kit::{parse, times};
use pages::ch15_3_plank::*;
use models::plank::Plank as Exact;
use rotation_dynamics::math::{cos, sin, sincos};
use rotation_dynamics::planar::contact::{Mode, Sense, MechanismState, misdeclared};
use support::{Errors, assert_error, assert_largest};

const STARTS: [f64; 6] = [1e-12, 1e-6, 0.01, 0.3, 1.0, 1.5];

fn plank() -> Plank {
    Plank::smooth(&Parameters::default())
}

fn falling(start: f64) -> Exact {
    exact(&Parameters::default(), start).unwrap()
}

/// The equation that is missing in the notes: kinetic energy of the middle and of the rotation,
/// over m, for the length 1; against pieces that are seen a little before and after, while the
/// middle stays above one point.
#[test]
fn eq_15_3_ex3_1_energy() {
    let (mut errors, mut damaged) = (Errors::of("energy"), Errors::of("without the rotation"));
    let (rate, n, dt) = (1.3, 400, 1e-4);
    for angle in times(0.1, 1.5, 20) {
        let [later, earlier] = [dt, -dt].map(|t| sincos(angle + rate * t));
        let piece = |i: i32| {
            let s = (f64::from(i) + 0.5) / f64::from(n) - 0.5;
            let x = s * (later.0 - earlier.0) / (2.0 * dt);
            let y = (0.5 + s) * (later.1 - earlier.1) / (2.0 * dt);
            0.5 * (x * x + y * y) / f64::from(n)
        };
        // The pieces turn, too: what sums of n pieces lack of a whole.
        let pieces = (0..n).map(piece).sum::<f64>() + rate * rate / (24.0 * f64::from(n * n));
        let (middle, turning) = (0.125 * sin(angle) * sin(angle) * 1.69, 1.69 / 24.0);
        errors.push((middle + turning) / pieces - 1.0);
        damaged.push(middle / pieces - 1.0);
    }
    assert_largest!(errors, 21, @"5.63e-9");
    damaged.exceed(0.2, 21);
}

/// E42: with the missing equation, energy m g l/2 gives (2) at every angle.
#[test]
fn e42_the_missing_equation_gives_the_rate() {
    let p = Parameters::default();
    let (mut errors, mut damaged) = (Errors::of("energy over m g l/2"), Errors::of("foot held"));
    for angle in times(0.05, FRAC_PI_2, 30) {
        let (rate, s) = (rate_from_upright(&p, angle), sin(angle));
        let kinetic = |shape: f64| rate * rate * shape / (12.0 * p.gravity);
        errors.push(kinetic(1.0 + 3.0 * s * s) + cos(angle) - 1.0);
        damaged.push(kinetic(4.0) + cos(angle) - 1.0);
    }
    assert_largest!(errors, 31, @"4.44e-16");
    assert!(damaged.largest() > 0.1);
}

/// Along a simulation that knows Newton's laws and a floor that pushes.
#[test]
fn eq_15_3_ex3_2_rate() {
    let (p, run) = (Parameters::default(), plank().fall(1e-13, 1e-9, 0.0).unwrap());
    let (mut errors, mut damaged) = (Errors::of("rate"), Errors::of("without 3 sin^2"));
    for t in times(0.7 * run.end_time(), run.end_time(), 40) {
        let MechanismState { q: [x, _, angle], v: [_, _, rate] } = run.at(t).unwrap();
        errors.push(rate_from_upright(&p, angle) / rate - 1.0);
        damaged.push(2.0 * growth(&p) * sin(0.5 * angle) / rate - 1.0);
        // Nothing pushes sideways: the middle comes straight down.
        assert_eq!(x, 0.0);
    }
    assert_largest!(errors, 41, @"2.38e-14");
    assert!(damaged.largest() > 0.9);
    let askew = MechanismState { q: [0.1, 0.4, 0.7], v: [0.3, -0.2, 1.1] };
    assert!(misdeclared(&plank(), &askew) < 1e-9);
}

/// The closed form, the quadrature and the simulation of a release at rest.
#[test]
fn released_at_rest_by_three_routes() {
    let p = Parameters::default();
    let [mut sums, mut runs, mut rates, mut damaged] =
        ["quadrature", "simulation", "rates along it", "the rate from upright"].map(Errors::of);
    for start in STARTS {
        let (fall, run) = (falling(start), plank().fall(1e-13, start, 0.0).unwrap());
        let time = fall.landing_time();
        sums.push_at(time_by_quadrature(&p, start) / time - 1.0, start);
        runs.push_at(run.end_time() / time - 1.0, start);
        for t in times(0.1 * time, time, 9) {
            let (s, there) = (fall.at(t).unwrap(), run.at(t.min(run.end_time())).unwrap());
            rates.push_at(rate_released(&p, s.theta, start) / s.omega - 1.0, (start, t));
            runs.push_at((there.q[2] - s.theta) / s.theta, (start, t));
        }
        let early = fall.at(0.2 * time).unwrap();
        damaged.push(rate_from_upright(&p, early.theta) / early.omega - 1.0);
    }
    assert_largest!(sums, 6, @"2.24e-14");
    assert_largest!(runs, 6 * 11, @"5.31e-15");
    assert_largest!(rates, 6 * 10, @"4.42e-14");
    damaged.exceed(1e-6, 6);
}

/// E15: upright at rest is an equilibrium; nearer to it the time grows without limit.
#[test]
fn e15_upright_it_never_falls() {
    // A simulation that starts at exactly zero stays there.
    let run = plank().fall(1e-12, 0.0, 0.0).unwrap();
    assert!(run.end_time() > 800.0 && run.at(run.end_time()).unwrap().q[2] == 0.0);
    let p = Parameters::default();
    assert!(exact(&p, 0.0).is_err());
    // Each factor of ten costs the same time, ln(10)/lambda.
    let mut errors = Errors::of("time of a factor ten");
    let time = |n: i32| falling(10.0_f64.powi(-n)).landing_time() * growth(&p);
    for n in [10, 20, 60, 150] {
        errors.push(time(n + 1) - time(n) - 10.0_f64.ln());
    }
    errors.attain(1.1e-14..=1.6e-14, 4);
    // Printed: (2) for a plank that starts at rest; it moves already where it is released.
    assert!(rate_from_upright(&p, 0.01) > 0.07 && rate_released(&p, 0.01, 0.01) == 0.0);
    assert_error!(value(&EXAMPLE, "t_floor") - 0.883_792_345_570_951, 1.1e-16);
}

#[test]
fn small_angles_grow_twice_as_fast_as_with_the_foot_held() {
    let p = Parameters::default();
    assert_error!(value(&EXAMPLE, "growth") / value(&EXAMPLE, "growth_held"), 2.0, 0.0 eps);
    // At the floor the two are equally fast, because the middle then moves straight down in both.
    let mut errors = Errors::of("rates at the floor");
    for start in STARTS {
        let held = hinged_fall(&p, start, FRAC_PI_2).unwrap().state[1];
        errors.push(falling(start).landing().omega / held - 1.0);
    }
    assert_largest!(errors, 6, @"6.66e-16");
}

/// The force of the floor is m (g + y''), and it never vanishes, whatever the start.
#[test]
fn the_floor_pushes_all_the_way() {
    let (mut errors, mut least) = (Errors::of("m (g + y'') over m g"), f64::INFINITY);
    for start in STARTS {
        let fall = falling(start);
        let (time, h) = (fall.landing_time(), 1e-3 / 7.67);
        let y = |t: f64| fall.at(t).unwrap().y_cm;
        for t in times(time - 0.4_f64.min(0.8 * time), time - 3.0 * h, 60) {
            let second = 16.0 * (y(t + h) + y(t - h)) - y(t + 2.0 * h) - y(t - 2.0 * h) - 30.0 * y(t);
            let force = fall.at(t).unwrap().floor_force;
            errors.push(1.0 + second / (12.0 * h * h) / 9.80665 - force);
            least = least.min(force);
        }
    }
    assert_largest!(errors, 6 * 61, @"1.65e-8");
    assert_error!(least - least_force()[1], 5.4e-5);
    assert!(least >= least_force()[1]);
}

/// A rough floor: the foot slips where the force needed reaches mu N; backwards if mu is below
/// 15 sqrt(40)/256, forwards if it is above.
#[test]
fn which_way_a_rough_foot_slips() {
    let p = Parameters { angle: 1e-3, ..Parameters::default() };
    let limit = 15.0 * 40.0_f64.sqrt() / 256.0;
    let mut errors = Errors::of("force needed over mu N, less one");
    for mu in [0.05, 0.2, 0.36, limit - 1e-4, limit + 1e-4, 0.5, 1.0] {
        let run = rubbing(&p, mu).unwrap();
        let slip = run.event("foot slips").unwrap();
        let ((s, c), from) = (sincos(slip.before.q[2]), cos(1e-3));
        // The rod turns about its foot: both forces by Newton's law for its middle.
        let (across, up) = (3.0 * s * (3.0 * c - 2.0 * from), 1.0 + 9.0 * c * c - 6.0 * c * from);
        errors.push_at(across.abs() / (mu * up) - 1.0, mu);
        let sense = run.modes(slip.t * (1.0 + 1e-7)).unwrap()[0];
        let backwards = if mu < limit { Sense::Forward } else { Sense::Backward };
        assert_eq!(sense, Mode::Slip(backwards), "mu = {mu}");
        // What slips backwards turns round or holds before the plank lies down.
        let ends = ["foot reverses", "foot sticks"];
        let turns = run.events().iter().any(|at| ends.contains(&at.name.as_str()));
        assert_eq!(turns, mu < limit, "mu = {mu}");
    }
    assert_largest!(errors, 7, @"3.81e-11");
}

/// Let go at rest, the plank needs the part 3/4 s c/(1 - 3/4 s^2) of the push to turn about its
/// foot: with less friction the foot slips at once, and the table says so.
#[test]
fn a_foot_that_slips_at_once_is_told() {
    let mut told = [0; 3];
    for angle in [0.02, 0.5, 1.5] {
        let parsed = parse(&answer(&EXAMPLE, &format!("--angle {angle}")).stdout).unwrap();
        let (s, c) = sincos(angle);
        let needed = 0.75 * s * c / (1.0 - 0.75 * s * s);
        for row in parsed.table("table rough").unwrap().rows() {
            let (mu, at, way) = (row[0].parse::<f64>().unwrap(), row[1].as_str(), row[2].as_str());
            assert_eq!(at == "at once", mu < needed, "{angle} rad, mu = {mu}");
            assert_eq!(at == "-", way == "never", "{angle} rad, mu = {mu}");
            assert!(at != "at once" || way == "backwards", "{angle} rad, mu = {mu}");
            told[["at once", "-"].iter().position(|word| *word == at).unwrap_or(2)] += 1;
        }
    }
    assert_eq!(told.iter().sum::<i32>(), 24);
    assert!(told.iter().all(|rows| *rows > 0), "{told:?}");
}

/// The air takes what its push along the exact fall does, to first order.
#[test]
fn the_air_takes_what_its_work_is() {
    let (fall, drag) = (falling(0.01), 1e-3);
    let (time, steps) = (fall.landing_time(), 400);
    let mut work = 0.0;
    for t in times(0.5 * time / 400.0, time - 0.5 * time / 400.0, steps - 1) {
        let state = fall.at(t).unwrap();
        for s in times(-39.0 / 80.0, 39.0 / 80.0, 39) {
            let speed = state.omega * (s + 0.5 * sin(state.theta) * sin(state.theta));
            work += drag * speed.abs() * speed * speed / 40.0 * time / f64::from(steps);
        }
    }
    let windy = Plank { drag, ..plank() }.fall(1e-9, 0.01, 0.0).unwrap();
    let lost = 1.0 - windy.event("arrives").unwrap().before.v[2] / fall.landing().omega;
    // The energy of the fall, over m, goes with the square of the rate.
    let predicted = 0.5 * work / (0.5 * 9.80665 * cos(0.01));
    assert_error!(lost / predicted - 1.0, 2.9e-4);
}

#[test]
fn other_planks_are_confirmed() {
    let planks = ["", "--length 100 --mass 1e-3", "--length 1e-4 --gravity 1.62", "--tolerance 1e-4"];
    let starts = ["--angle 1e-30", "--angle 1.4 --look 1.5 --from 1.2", "--angle 1e-8 --look 0.01 --from 1e-5"];
    let runs = planks.iter().flat_map(|plank| starts.iter().map(move |start| format!("{plank} {start}")));
    confirmed(&EXAMPLE, runs, 12);
}

#[test]
fn what_is_no_plank_is_refused() {
    refused(&EXAMPLE, [
        ("--angle 0", "angle = 0 is not allowed"),
        ("--angle 1.6", "angle = 1.6 is not allowed"),
        ("--length=-1", "length = -1 is not allowed"),
        ("--mass nan", "not a finite number"),
        ("--tolerance 1e-16", "tolerance = 1e-16 is not allowed"),
    ]);
}
