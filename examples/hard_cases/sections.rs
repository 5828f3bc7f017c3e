//! The sections that every page has: what is claimed of the table, limits, and a picture of it.

use super::naive::{guarded, on_quaternion, on_yaw_pitch_roll};
use super::rotations::{FLIPS_STEPS, POLE_STEPS, TRILLION, flips, late, locked, scaled};
use super::*;

/// All of them, before the families' tables.
pub fn add(report: &mut Report, p: &Parameters, computed: &[Arc<Computed>]) -> Result<()> {
    digits(report)?;
    broken(report)?;
    counts(report, computed)?;
    limits(report)?;
    let asked = p.tolerance.map_or(vec![1e-9, 1e-6, 1e-12], |one| vec![one]);
    // These cases are about arithmetic: what is in is rounding.
    effect_card! { report, asked asked[0];
        "rounding of the numbers": "2^-53" = EPS, costs 0.5 * EPS, "rad per radian turned", included;
    }?;
    report.strip(&flip()?, &asked)?;
    let columns = ["finding", "what was found", "the test that sees it"];
    let told = |[finding, found, _, test]: &[&'static str; 4]| Ok([*finding, *found, *test]);
    let table = Table::of("findings_elsewhere", columns, findings::ELSEWHERE, told)?;
    report.add(table)?;
    summary(report, computed)
}

/// The example of the opening: the same function, and two ways to write it.
fn digits(report: &mut Report) -> Result<()> {
    let x: f64 = 1e-6;
    let half = sin(0.5 * x);
    claims! { report,
        /// condition of 1 - cos x at 1e-6 rad
        function_condition: x * sin(x) / (2.0 * half * half), "-",
            "x cot(x/2)" => x / tan(0.5 * x), within 1e-12;
        /// condition of its last step, the subtraction
        subtraction_condition: cos(x) / (2.0 * half * half), "-",
            "its series, 2/x^2 - 5/6" => 2.0 / (x * x) - 5.0 / 6.0, within 0.01;
        /// 1 - cos x as it stands, at 1e-8 rad
        cancelled: 1.0 - cos(1e-8), "-", "the double nearest to 1 - 5e-17 is 1" => 0.0, within 0.0;
        /// the smallest tilt but 0 that an arc cosine can give
        least_tilt: acos(1.0 - EPS), "rad", "theta^2/2 = 2^-53" => (2.0 * EPS).sqrt(), within 1e-23;
    }
}

/// How far naive methods are off, against the series in pairs of doubles and, once more,
/// against the closed form.
fn broken(report: &mut Report) -> Result<()> {
    // About the middle axis of moments 1, 2, 2.5 a kick grows as exp(t sqrt(1/5)).
    let rate = 0.2_f64.sqrt();
    let (locked, molecule) = (locked()?, scaled(1e-46, 1e12)?);
    let flips = flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
    let (late, _, modulo) = late(TRILLION, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?;
    let off = |motion: Motion, reached: Option<Attitude>| -> Result<[f64; 2]> {
        let exact = motion.in_closed_form()?;
        let again = reached.map_or(f64::NAN, |reached| exact.angle_to(&reached));
        Ok([motion.off(reached), again])
    };
    let a = off(locked, on_yaw_pitch_roll(&locked, POLE_STEPS))?;
    let b = off(flips, on_quaternion(&flips, FLIPS_STEPS))?;
    let [c, d] = [off(late, Some(modulo))?, off(molecule, guarded(&molecule))?];
    claims! { report,
        /// a rounding about the middle axis has grown to one
        grown: log(2.0 / EPS) / rate, "s", "first flip by RK4" => pictures::first_flip()?, within 5.0;
        /// yaw, pitch and roll from a pitch of pi/2, off after 20 s
        locked: a[0], "rad", "the closed form" => a[1], within 1e-10;
        /// RK4 on quaternion and rates, off after ten thousand flips
        flipped: b[0], "rad", "the closed form" => b[1], within 1e-10;
        /// time modulo the period in doubles, off after 1e12 periods
        late: c[0], "rad", "the closed form" => c[1], within 1e-10;
        /// 1e-30 kg m^2 added to the moments of a molecule, off after 30 rad
        guarded: d[0], "rad", "the closed form" => d[1], within 1e-10;
    }
}

/// Nothing is left out: every case has every method in every representation.
fn counts(report: &mut Report, computed: &[Arc<Computed>]) -> Result<()> {
    let total =
        |of: fn(&Computed) -> usize| computed.iter().map(|one| of(one)).sum::<usize>() as f64;
    let (cells, holds) = (total(|one| one.count().cells), total(|one| one.count().holds));
    let refused = total(|one| one.count().refusals);
    claims! { report,
        /// cases
        cases: total(|one| one.rows.len()), "-",
            "naive methods, one for each" => total(|one| one.rows.len()), within 0.0;
        /// cells
        cells: cells, "-", "cases times methods times representations" => total(Computed::due), within 0.0;
        /// cells that hold
        holds: holds, "-", "cells less refusals" => cells - refused, within 0.0;
        /// cells that are refused
        refused: refused, "-", "cells less those that hold" => cells - holds, within 0.0;
    }?;
    for one in computed {
        let (family, count) = (one.family, one.count());
        let mut add = |what: &str, meaning: &str, value: usize, route, gives: usize| {
            let (key, meaning) = (family.key, format!("{}: {meaning}", family.title));
            let value = claim(format!("{key}_{what}"), meaning, value as f64, "-");
            report.add(value.agrees_with(route, gives as f64, 0.0))
        };
        let (cells, due) = (count.cells, one.due());
        let product = "cases times methods times representations";
        add("cells", "cells of the table", cells, product, due)?;
        let (means, rest) = ("cells that hold their bound", cells - count.refusals);
        add("holds", means, count.holds, "cells less refusals", rest)?;
    }
    Ok(())
}

fn limits(report: &mut Report) -> Result<()> {
    let half = Attitude::about_space_axis(SpaceVector::new(1.0, -2.0, 3.0), PI)?;
    limits! { report,
        /// gravity has no lever on an axis that is exactly vertical
        "exactly upright below the critical spin, after 1e6 s: tilt in rad":
            HeavyTop::new(SymmetricTop::new(1.0, 0.5, 1.0, 1.0)?, Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 2.0))?
                .angles(1e6).theta => 0.0, within 0.0;
        /// half a turn and half a turn are a turn
        "rotation by pi about a skew axis, twice: off the start, in rad":
            (half * half).angle_to(&Attitude::IDENTITY) => 0.0, within 4.0 * EPS;
    }
}

/// One flip next to the separatrix: 1 - k^2 = 1e-8.
fn flip() -> Result<Problem<()>> {
    let (moments, rates) = ([3.0, 4.0, 6.0], [0.0, 1.0, 4.7e-5]);
    let motion = Motion::free(moments, Attitude::IDENTITY, rates, 38.0);
    let scene = Scene::new(RigidBody::new(motion.body()?));
    let start = scene.body().state(motion.attitude, motion.rates())?;
    let exact = motion.free_body()?;
    let end = exact.state(motion.end);
    Ok(Problem::new(scene, start, motion.end, end).in_closed_form(move |t| exact.attitude(t)))
}

/// A line for each family.
fn summary(report: &mut Report, computed: &[Arc<Computed>]) -> Result<()> {
    let columns = "family, what it is, cases, cells, hold, refused, error/bound, naive";
    let line = |one: &Arc<Computed>| {
        let (family, count) = (one.family, one.count());
        let numbers = [count.rows, count.cells, count.holds, count.refusals];
        let [cases, cells, hold, refused] = numbers.map(|n| n.to_string());
        let [worst, naive] = [count.worst, count.least_broken].map(|part| short(part, 2));
        let [key, title] = [family.key, family.title].map(str::to_owned);
        Ok([key, title, cases, cells, hold, refused, worst, naive])
    };
    report.add(Table::of("families", columns.split(", "), computed, line)?)
}

/// All cells as numbers: family, case, method, representation, error, bound; those that hold.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "family, case, method, representation, error, bound";
    let mut rows = Trajectory::new(columns.split(", "))?;
    for (f, one) in super::computed(p)?.iter().enumerate() {
        for (r, row) in one.rows.iter().enumerate() {
            for (c, cell) in row.cells.iter().enumerate() {
                if let Ok(measured) = cell.verdict {
                    let (method, form) = (c / one.family.forms.len(), c % one.family.forms.len());
                    let [f, r, method, form] = [f, r, method, form].map(|n| (n + 1) as f64);
                    rows.push(vec![f, r, method, form, measured, cell.bound])?;
                }
            }
        }
    }
    Ok(rows)
}
