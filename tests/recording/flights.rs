//! Flights are found in recordings of which they are known.

use core::f64::consts::TAU;
use kit::recording::made::{Format, Made, Motion, Samples};
use kit::recording::{Flight, Recording};
use support::Random;

fn recording(made: &Made) -> Recording {
    let text = made.text(Format::Phyphox).expect("a text");
    Recording::read("made.csv", text.as_bytes()).expect("a recording")
}

/// By how much found flights begin and end after the true ones (ms).
fn errors(made: &Made) -> Vec<[f64; 2]> {
    let recording = recording(made);
    let found = recording.flights().unwrap_or_else(|error| panic!("{error}: {made:?}"));
    let truth = made.motion.flights();
    assert_eq!(found.len(), truth.len(), "{made:?}");
    let ends = |n: usize| {
        let samples = found[n].samples.clone();
        [samples.start, samples.end - 1].map(|k| recording.times()[k])
    };
    (0..truth.len()).map(|n| [0, 1].map(|k| 1e3 * (ends(n)[k] - truth[n][k]))).collect()
}

/// Another phone, another throw, another sensor.
fn drawn(random: &mut Random, seed: u64, throws: usize, flight: f64) -> Made {
    let middle = random.between(1.5, 6.0);
    let moments = [1.0, middle, middle + random.between(0.3, 0.9)];
    let release = |random: &mut Random| {
        let mut release: [f64; 3] = random.vector().map(|x: f64| 2.0 * x);
        release[(3.0 * random.unit()) as usize] += random.between(6.0, 20.0);
        release
    };
    let releases = (0..throws).map(|_| release(random)).collect();
    Made {
        motion: Motion::Throws { moments, releases, flight, drag: random.between(0.0, 0.2) },
        turn: random.vector().map(|x: f64| 0.3 * x),
        frequency: [100.0, 200.0, 400.0][(3.0 * random.unit()) as usize],
        noise: random.size(0.003, 0.05),
        offset: random.vector().map(|x: f64| 0.03 * x),
        filter: random.between(0.0, 0.005),
        accelerometer: (seed % 2 == 1).then_some([0.03, 0.02, -0.01]),
        seed,
        ..Made::default()
    }
}

#[test]
fn the_ends_are_found_and_lie_inside() {
    let mut random = Random(5);
    let mut tried = [0; 2];
    let mut ranges = [[[f64::INFINITY, f64::NEG_INFINITY]; 2]; 2];
    for case in 0..100 {
        let flight = [0.2, 0.4, 0.7, 1.0, 1.5][case as usize / 2 % 5];
        let made = drawn(&mut random, case, 1, flight);
        let noisy = usize::from(made.noise > 0.02);
        for error in errors(&made) {
            for (range, error) in ranges[noisy].iter_mut().zip(error) {
                *range = [range[0].min(error), range[1].max(error)];
            }
            tried[noisy] += 1;
        }
    }
    // A hand lets go by and by, and what it does within the noise cannot be seen.
    let said = |n: usize| {
        format!("{} throws: begin {:.1?}, end {:.1?} ms", tried[n], ranges[n][0], ranges[n][1])
    };
    insta::assert_snapshot!(said(0), @"63 throws: begin [-4.4, 25.0], end [-18.0, -7.0] ms");
    insta::assert_snapshot!(said(1), @"37 throws: begin [-15.8, 24.3], end [-25.2, -11.0] ms");
}

#[test]
fn each_of_several_throws_is_found() {
    let mut random = Random(8);
    let mut tried = 0;
    for case in 0..10 {
        let made = drawn(&mut random, case, 2 + case as usize % 2, 0.5);
        let made = Made { noise: 0.01, ..made };
        for [begin, end] in errors(&made) {
            assert!((-10.0..30.0).contains(&begin) && (-25.0..3.0).contains(&end), "{begin} {end}");
            tried += 1;
        }
    }
    assert_eq!(tried, 25);
}

#[test]
fn what_is_no_flight_is_none() {
    let refusal = |made: Made| recording(&made).flights().unwrap_err().to_string();
    let rest = Made { motion: Motion::Rest(5.0), ..Made::default() };
    insta::assert_snapshot!(refusal(rest), @r#"no free flight was found, 0.15 s to 3 s in which the phone turns freely and faster than 3 rad/s; the fastest rate is 0.09136 rad/s, at 0.69203 s. A piece is set by hand with --from and --to, on the page with the fields "from" and "to""#);
    let swing = Motion::Swing {
        length: 0.5,
        gravity: 9.81,
        amplitude: 0.5,
        linear: 0.05,
        quadratic: 0.0,
        duration: 10.0,
    };
    insta::assert_snapshot!(refusal(Made { motion: swing, ..Made::default() }), @r#"no free flight was found, 0.15 s to 3 s in which the phone turns freely and faster than 3 rad/s; the fastest rate is 2.194 rad/s, at 0.32211 s. A piece is set by hand with --from and --to, on the page with the fields "from" and "to""#);
}

/// A recording of these, with some of its samples changed.
fn changed(made: &Made, change: impl Fn(&mut Samples)) -> Recording {
    let mut samples = made.samples().expect("samples");
    change(&mut samples);
    let text = samples.text(Format::Phyphox);
    Recording::read("made.csv", text.as_bytes()).expect("a recording")
}

#[test]
fn a_flight_is_one_beyond_gaps_stamps_and_fast_flips() {
    let mut random = Random(12);
    let mut tried = 0;
    for case in 0..40 {
        // Nearly about the middle axis, so that it flips, with little noise.
        let release = [random.between(-1.0, 1.0), random.between(12.0, 25.0), 0.3];
        let releases = vec![release];
        let motion = Motion::Throws { moments: [1.0, 4.1, 4.8], releases, flight: 0.8, drag: 0.0 };
        let frequency = [100.0, 200.0, 400.0][case % 3];
        let made = Made { motion, frequency, noise: 0.003, seed: case as u64, ..Made::default() };
        let gap = random.between(1.4, 1.8);
        let late: Vec<bool> = (0..1500).map(|_| random.unit() < 0.05).collect();
        let recording = changed(&made, |samples| match case % 4 {
            0 => {
                let keep = |t: &f64| *t < gap || *t > gap + 0.05;
                let times = samples.times.clone();
                samples.times.retain(keep);
                let mut kept = times.iter().map(keep);
                samples.rates.retain(|_| kept.next() == Some(true));
            }
            1 | 2 => (1..samples.times.len()).filter(|k| late[*k]).for_each(|k| {
                samples.times[k] = samples.times[k - 1];
            }),
            _ => {}
        });
        let found = recording.flights().expect("a flight");
        let ends = |flight: &Flight| {
            [flight.samples.start, flight.samples.end - 1].map(|k| recording.times()[k])
        };
        let found: Vec<[f64; 2]> = found.iter().map(ends).collect();
        let [[begin, end]] = found[..] else { panic!("{case}: {found:?}") };
        assert!((1.19..1.24).contains(&begin) && (1.96..2.0).contains(&end), "{case}: {found:?}");
        tried += 1;
    }
    assert_eq!(tried, 40);
}

#[test]
fn a_knock_parts_a_flight() {
    // The twin: the same tensor before and after it, but another |L|.
    let releases = vec![[0.1, 0.2, 15.0]];
    let motion = Motion::Throws { moments: [1.0, 4.1, 4.8], releases, flight: 0.8, drag: 0.0 };
    let made = Made { motion, ..Made::default() };
    let knocked = |kept: f64| {
        let recording = changed(&made, |samples| {
            let all = samples.times.iter().zip(samples.rates.iter_mut());
            all.filter(|(t, _)| **t > 1.6).for_each(|(_, w)| *w = w.map(|w| kept * w));
        });
        recording.flights().expect("flights").len()
    };
    assert_eq!([1.0, 0.7].map(knocked), [1, 2]);
}

#[test]
fn a_sensor_at_its_limit_is_told_instead_of_a_flight() {
    let release = vec![[1.0, 14.0, 2.0]];
    let motion =
        Motion::Throws { moments: [1.0, 4.1, 4.8], releases: release, flight: 0.8, drag: 0.0 };
    let made = Made { motion, ..Made::default() };
    let limited = |degrees: f64| {
        let limit = f64::to_radians(degrees);
        let clip = |w: &mut f64| *w = w.clamp(-limit, limit);
        changed(&made, |samples| samples.rates.iter_mut().flatten().for_each(clip)).flights()
    };
    assert_eq!(limited(2000.0).expect("a flight").len(), 1);
    let error = limited(500.0).unwrap_err().to_string();
    insta::assert_snapshot!(error, @"no free flight was found: from 1.5125 s to 1.6879 s (pieces like this: 4) the rate about x stays at 8.727 rad/s, the end of the sensor's range: throw more slowly");
}

#[test]
fn too_few_samples_a_second_are_told() {
    let slow = Made { frequency: 10.0, ..Made::default() };
    let error = recording(&slow).flights().unwrap_err().to_string();
    insta::assert_snapshot!(error, @r#"no free flight was found, 0.15 s to 3 s in which the phone turns freely and faster than 3 rad/s; the fastest rate is 9.379 rad/s, at 1.9466 s. A fit needs 13 samples: 9.89 a second are too few for a flight of less than 1.3 s. A piece is set by hand with --from and --to, on the page with the fields "from" and "to""#);
}

/// A phone that turns on a table, less and less; with an accelerometer or none.
fn on_a_table(seconds: f64, loss: f64, felt: bool) -> Recording {
    let mut random = Random(1);
    let mut text = String::from("t (s),wx (rad/s),wy (rad/s),wz (rad/s)");
    text.push_str(if felt { ",ax (m/s^2),ay (m/s^2),az (m/s^2)" } else { "" });
    for k in 0..(200.0 * seconds) as u32 {
        let t = 0.005 * f64::from(k);
        let w = if t < 1.0 { 0.0 } else { 9.0 * rotation_dynamics::math::exp(-loss * (t - 1.0)) };
        let mut noise = || 0.02 * random.between(-1.0, 1.0);
        text.push_str(&format!("\n{t:.3},{:.4},{:.4},{:.4}", noise(), noise(), w + noise()));
        if felt {
            let [radial, along] = [-w * w * 0.02, 9.81];
            text.push_str(&format!(
                ",{:.4},{:.4},{:.4}",
                radial + noise(),
                noise(),
                along + noise()
            ));
        }
    }
    Recording::read("", text.as_bytes()).expect("a recording")
}

#[test]
fn accelerations_tell_a_table_from_the_air() {
    // The rates alone do not.
    assert_eq!(on_a_table(3.0, 0.1, false).flights().expect("a flight").len(), 1);
    // But no throw is so long.
    assert!(on_a_table(5.0, 0.1, false).flights().is_err());
    let error = on_a_table(3.0, 0.1, true).flights().unwrap_err().to_string();
    assert!(error.contains("no free flight was found"), "{error}");
    // A torque is told by the rates.
    assert!(on_a_table(3.0, 2.0, false).flights().is_err());
}

#[test]
fn the_swing_is_that_of_a_pendulum() {
    // Small, and without damping: the period of the simple pendulum, by counted zeros of the rate.
    let motion = Motion::Swing {
        length: 1.0,
        gravity: 9.81,
        amplitude: 0.01,
        linear: 0.0,
        quadratic: 0.0,
        duration: 20.06,
    };
    let made = Made { motion, noise: 0.0, step: 0.0, jitter: 0.0, ..Made::default() };
    let samples = made.samples().expect("samples");
    let mut zeros = Vec::new();
    for k in 1..samples.times.len() {
        let [a, b] = [k - 1, k].map(|k| samples.rates[k][2]);
        if a < 0.0 && b >= 0.0 {
            zeros.push(
                samples.times[k - 1] - a / (b - a) * (samples.times[k] - samples.times[k - 1]),
            );
        }
    }
    let period = (zeros[zeros.len() - 1] - zeros[0]) / (zeros.len() - 1) as f64;
    // 1 + amplitude^2/16.
    let expected = TAU / 9.81_f64.sqrt() * (1.0 + 0.01 * 0.01 / 16.0);
    assert_eq!(zeros.len(), 10);
    assert!((period / expected - 1.0).abs() < 1e-6, "{period} {expected}");
}

#[test]
fn a_throw_keeps_energy_and_momentum_in_flight_alone() {
    let made = Made { noise: 0.0, step: 0.0, ..Made::default() };
    let samples = made.samples().expect("samples");
    let [begin, end] = made.motion.flights()[0];
    let Motion::Throws { moments, .. } = &made.motion else { panic!("a throw") };
    let kept = |w: &[f64; 3]| {
        [0, 1].map(|n| {
            (0..3)
                .map(|k| w[k] * w[k] * moments[k] * if n == 0 { 1.0 } else { moments[k] })
                .sum::<f64>()
        })
    };
    let all = samples.times.iter().zip(&samples.rates);
    let inside: Vec<[f64; 2]> =
        all.clone().filter(|(t, _)| (begin..end).contains(*t)).map(|(_, w)| kept(w)).collect();
    assert!(inside.len() > 150);
    assert!(inside.iter().all(|k| (0..2).all(|n| (k[n] / inside[0][n] - 1.0).abs() < 1e-12)));
    let after = all.filter(|(t, _)| **t > end + 0.05).map(|(_, w)| kept(w));
    assert!(after.clone().count() > 100);
    assert!(after.into_iter().all(|k| (k[0] / inside[0][0] - 1.0).abs() > 0.1));
}
