//! The sections that every page has: what is claimed of the table, limits, and a picture of it.

use super::Parameters;
use super::forms::Form;
use super::long::{self, Late};
use super::motions::{By, Motion};
use super::table::{Computed, Verdict};
use super::{findings, flips, naive, pictures, poles, scales};
use kit::prelude::*;
use kit::short;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;
use std::sync::Arc;

/// All of them, before the families' tables.
pub fn add(report: &mut Report, p: &Parameters, computed: &[Arc<Computed>]) -> Result<()> {
    digits(report)?;
    broken(report)?;
    counts(report, computed)?;
    limits(report)?;
    let asked = p.tolerance.map_or(vec![1e-9, 1e-6, 1e-12], |one| vec![one]);
    effects(report, asked[0])?;
    report.strip(&flip()?, &asked)?;
    findings::elsewhere(report)?;
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
    claims! { report,
        /// a rounding about the middle axis has grown to one
        grown: log(2.0 / EPS) / rate, "s", "first flip by RK4" => pictures::first_flip()?, within 5.0;
    }?;
    let locked = poles::locked()?;
    let flips = flips::flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
    let late = Late::after(long::PERIODS, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?;
    let molecule = scales::scaled(1e-46, 1e12)?;
    for (key, meaning, motion, reached) in [
        (
            "locked",
            "yaw, pitch and roll from a pitch of pi/2, off after 20 s",
            &locked,
            naive::on_yaw_pitch_roll(&locked, poles::STEPS),
        ),
        (
            "flipped",
            "RK4 on quaternion and rates, off after ten thousand flips",
            &flips,
            naive::on_quaternion(&flips, 1_000_050),
        ),
        (
            "late",
            "time modulo the period in doubles, off after 1e12 periods",
            &late.motion,
            Some(late.modulo),
        ),
        (
            "guarded",
            "1e-30 kg m^2 added to the moments of a molecule, off after 30 rad",
            &molecule,
            naive::guarded(&molecule),
        ),
    ] {
        let exact = motion.reached(By::ClosedForm, Form::Quaternion, 0.0)?;
        let again = reached.map_or(f64::NAN, |reached| exact.angle_to(&reached));
        report.add(claim(key, meaning, motion.off(reached), "rad").agrees_with(
            "the closed form",
            again,
            1e-10,
        ))?;
    }
    Ok(())
}

/// Nothing is left out: every case has every method in every representation.
fn counts(report: &mut Report, computed: &[Arc<Computed>]) -> Result<()> {
    let total =
        |of: fn(&Computed) -> usize| computed.iter().map(|one| of(one)).sum::<usize>() as f64;
    let cells = total(|one| one.count().cells);
    claims! { report,
        /// cases
        cases: total(|one| one.count().rows), "-",
            "naive methods, one for each" => total(|one| one.rows.len()), within 0.0;
        /// cells
        cells: cells, "-", "cases times methods times representations" =>
            total(|one| one.rows.len() * one.family.methods.len() * one.family.forms.len()), within 0.0;
        /// cells that hold
        holds: total(|one| one.count().holds), "-", "cells less refusals" =>
            cells - total(|one| one.count().refusals), within 0.0;
        /// cells that are refused
        refused: total(|one| one.count().refusals), "-", "cells less those that hold" =>
            cells - total(|one| one.count().holds), within 0.0;
    }?;
    for one in computed {
        let (family, count) = (one.family, one.count());
        let due = count.rows * family.methods.len() * family.forms.len();
        report.add(
            claim(
                format!("{}_cells", family.key),
                format!("{}: cells of the table", family.title),
                count.cells as f64,
                "-",
            )
            .agrees_with("cases times methods times representations", due as f64, 0.0),
        )?;
        report.add(
            claim(
                format!("{}_holds", family.key),
                format!("{}: cells that hold their bound", family.title),
                count.holds as f64,
                "-",
            )
            .agrees_with(
                "cells less refusals",
                (count.cells - count.refusals) as f64,
                0.0,
            ),
        )?;
    }
    Ok(())
}

fn limits(report: &mut Report) -> Result<()> {
    limits! { report,
        /// gravity has no lever on an axis that is exactly vertical
        "exactly upright below the critical spin, after 1e6 s: tilt in rad":
            HeavyTop::new(SymmetricTop::new(1.0, 0.5, 1.0, 1.0)?, Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 2.0))?
                .angles(1e6).theta => 0.0, within 0.0;
        /// half a turn and half a turn are a turn
        "rotation by pi about a skew axis, twice: off the start, in rad":
            twice()? => 0.0, within 4.0 * EPS;
    }
}

fn twice() -> Result<f64> {
    let half = Attitude::about_space_axis(SpaceVector::new(1.0, -2.0, 3.0), core::f64::consts::PI)?;
    Ok((half * half).angle_to(&Attitude::IDENTITY))
}

/// These cases are about arithmetic: what is in is rounding.
fn effects(report: &mut Report, asked: f64) -> Result<()> {
    effect_card! { report, asked asked;
        "rounding of the numbers": "2^-53" = EPS, costs 0.5 * EPS, "rad per radian turned", included;
    }
}

/// One flip next to the separatrix: 1 - k^2 = 1e-8.
fn flip() -> Result<Problem<()>> {
    let motion = Motion::free(
        [3.0, 4.0, 6.0],
        Attitude::IDENTITY,
        [0.0, 1.0, 4.7e-5],
        38.0,
    );
    let rates = BodyVector::from_array(motion.rates);
    let scene = Scene::new(RigidBody::new(motion.body()?));
    let start = scene.body().state(motion.attitude, rates)?;
    let exact = FreeBody::new(motion.body()?, motion.attitude, rates)?;
    let end = exact.state(motion.end);
    Ok(Problem::new(scene, start, motion.end, end).in_closed_form(move |t| exact.attitude(t)))
}

/// A line for each family.
fn summary(report: &mut Report, computed: &[Arc<Computed>]) -> Result<()> {
    let columns = [
        "family",
        "what it is",
        "cases",
        "cells",
        "hold",
        "refused",
        "error/bound",
        "naive",
    ];
    let mut table = Table::new("families", columns)?;
    for one in computed {
        let count = one.count();
        table.push([
            one.family.key.to_owned(),
            one.family.title.to_owned(),
            count.rows.to_string(),
            count.cells.to_string(),
            count.holds.to_string(),
            count.refusals.to_string(),
            short(count.worst, 2),
            short(count.least_broken, 2),
        ])?;
    }
    report.add(table)
}

/// All cells as numbers: family, case, method, representation, error, bound; those that hold.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = [
        "family",
        "case",
        "method",
        "representation",
        "error",
        "bound",
    ];
    let mut rows = Trajectory::new(columns)?;
    for (f, one) in super::computed(p)?.iter().enumerate() {
        for (r, row) in one.rows.iter().enumerate() {
            for (c, cell) in row.cells.iter().enumerate() {
                let Verdict::Holds { measured, bound } = cell.verdict else {
                    continue;
                };
                let (method, form) = (c / one.family.forms.len(), c % one.family.forms.len());
                let place = [f, r, method, form].map(|n| (n + 1) as f64);
                rows.push([place.as_slice(), &[measured, bound]].concat())?;
            }
        }
    }
    Ok(rows)
}
