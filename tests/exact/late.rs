//! The closed forms after up to 10^12 periods, against values of 25 digits
//! (tests/data/late.txt, written by late.py), and near the latest times at which they are known
//! (latest.txt, by latest.py).
//!
//! Inputs and times are taken as the doubles that they are, so a phase is owed to the last bit
//! however late it is read: no error here is granted to the length of time.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{EPS, hypot};
use support::{Errors, assert_largest, relative};

struct Case {
    kind: &'static str,
    name: String,
    periods: &'static str,
    inputs: Vec<f64>,
    t: f64,
    want: Vec<f64>,
}

fn cases(references: &'static str) -> impl Iterator<Item = Case> {
    references.lines().map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        let inputs = if words[0] == "pendulum" { 6 } else { 9 };
        let numbers = |words: &[&str]| words.iter().map(|x| x.parse().unwrap()).collect();
        let [periods, t] = [words[2 + inputs], words[3 + inputs]];
        Case {
            kind: words[0],
            name: words[1].replace('_', " "),
            periods,
            inputs: numbers(&words[2..2 + inputs]),
            t: t.parse().unwrap(),
            want: numbers(&words[4 + inputs..]),
        }
    })
}

impl Case {
    /// Attitude and rates on the body axes, or angle and rate, at the time `t`.
    fn got(&self, t: f64) -> Result<Vec<f64>> {
        let v = self.inputs.as_slice();
        let angles = |v: &[f64]| EulerAngles { phi: v[0], theta: v[1], zeta: v[2] };
        let rates = |v: &[f64]| BodyVector::new(v[0], v[1], v[2]);
        let now = match self.kind {
            "free" => {
                let moments = PrincipalMoments::new(v[0], v[1], v[2])?;
                let start = Attitude::from_euler(angles(&v[6..]))?;
                FreeBody::new(moments, start, rates(&v[3..]))?.try_kinematics(t)?
            }
            "top" => {
                let body = SymmetricTop::new(v[0], v[1], v[2].abs(), v[2].signum())?;
                HeavyTop::from_body(body, angles(&v[3..]), rates(&v[6..]))?.try_kinematics(t)?
            }
            _ => {
                let suspension =
                    Suspension { moment: v[0], mass: v[1], gravity: v[2], lever: v[3] };
                let state = Pendulum::new(suspension, v[4], v[5])?.at(t)?;
                return Ok(vec![state.theta, state.omega]);
            }
        };
        let mut got = now.attitude.quaternion().to_vec();
        got.extend(now.angular_velocity.to_array());
        Ok(got)
    }

    /// How far attitude (rad) and rates are off, the latter as a part of themselves; of a
    /// pendulum both are. The references are moved on as if every rate were off by `damage` of
    /// itself.
    fn off(&self, damage: f64) -> [f64; 2] {
        let got = self.got(self.t).expect("a time that is known");
        let late = damage * self.t;
        if let [theta, omega] = *self.want {
            let [moment, mass, gravity, lever, ..] = *self.inputs else {
                unreachable!("six inputs");
            };
            let torque = -mass * gravity * lever * rotation_dynamics::math::sin(theta);
            let moved = [theta + omega * late, omega + torque / moment * late];
            return [0, 1].map(|i| relative(got[i], moved[i], moved[i].abs()));
        }
        let (want, rates) = self.want.split_at(4);
        let [w, x, y, z] = [want[0], want[1], want[2], want[3]];
        let [p, q, r] = [rates[0], rates[1], rates[2]].map(|rate| 0.5 * rate * late);
        let moved = [
            w - x * p - y * q - z * r,
            x + w * p + y * r - z * q,
            y + w * q + z * p - x * r,
            z + w * r + x * q - y * p,
        ];
        let along: f64 = got.iter().zip(moved).map(|(a, b)| a * b).sum();
        let size = |v: &[f64]| v.iter().fold(0.0, |size, x| hypot(size, *x));
        let apart = [0, 1, 2, 3].map(|i| got[i] * along.signum() - moved[i]);
        let faster = [0, 1, 2].map(|i| got[4 + i] - rates[i]);
        [2.0 * size(&apart), relative(size(&faster), 0.0, size(rates))]
    }
}

/// The record, and in it what is measured: the error of each attitude in eps rad, or of each
/// angle in eps of itself, and the largest of the rates in eps of themselves.
#[test]
fn a_trillion_periods_cost_no_digit() {
    let mut rows = Vec::new();
    let (mut places, mut rates) =
        (Errors::in_units_of(EPS, "attitude"), Errors::in_units_of(EPS, "rates"));
    let mut damaged = Errors::in_units_of(EPS, "with rates that are off by 2^-80 of themselves");
    let cases: Vec<Case> = cases(include_str!("../data/late.txt")).collect();
    for motion in cases.chunks(5) {
        let name = format!("{}, {}", motion[0].kind, motion[0].name);
        let periods: Vec<&str> = motion.iter().map(|case| case.periods).collect();
        assert_eq!(periods, ["1", "1e3", "1e6", "1e9", "1e12"], "{name}");
        let off: Vec<[f64; 2]> = motion.iter().map(|case| case.off(0.0)).collect();
        let mut fastest: f64 = 0.0;
        for [place, rate] in &off {
            places.push_at(*place, &name);
            rates.push_at(*rate, &name);
            fastest = fastest.max(*rate);
        }
        let cells = off.iter().map(|off| off[0]).chain([fastest]);
        let cells: Vec<String> = cells.map(|x| format!("{:<4.1}", x / EPS)).collect();
        let row = format!("{name:<36}{}", cells.join("  "));
        println!("{}", row.trim_end());
        rows.push(row.trim_end().to_owned());
        // The last bits of a low word.
        let [place, rate] = motion[4].off(2.0_f64.powi(-80));
        damaged.push_at(place.max(rate), &name);
    }
    let record = include_str!("../../benches/record/late.txt").lines();
    let recorded: Vec<&str> = record.skip_while(|x| *x != "table late").skip(2).collect();
    assert_eq!(rows, recorded);
    assert_largest!(places, 5 * 29, @"8.65");
    assert_largest!(rates, 5 * 29, @"3.75");
    damaged.exceed(1e3, 29);
}

/// The last turns are owed as the first: a part of the way to where the phase is lost no digit is
/// missing, and what is beyond is refused.
#[test]
fn the_last_turns_cost_no_digit() {
    let (mut places, mut rates) =
        (Errors::in_units_of(EPS, "attitude"), Errors::in_units_of(EPS, "rates"));
    let mut damaged = Errors::in_units_of(EPS, "with rates that are off by 2^-88 of themselves");
    for case in cases(include_str!("../data/latest.txt")) {
        let latest = crate::latest(case.got(1e300).err());
        assert!(case.t > 0.05 * latest, "{}: {}", case.name, case.t / latest);
        assert!(case.got(1.001 * latest).is_err() && case.got(-1.001 * latest).is_err());
        assert!(case.got(latest).is_ok() && case.got(-latest).is_ok());
        let [place, rate] = case.off(0.0);
        places.push_at(place, &case.name);
        rates.push_at(rate, &case.name);
        let [place, rate] = case.off(2.0_f64.powi(-88));
        damaged.push_at(place.max(rate), &case.name);
    }
    assert_largest!(places, 29, @"4.27");
    assert_largest!(rates, 29, @"3.15");
    damaged.exceed(100.0, 29);
}
