//! The numbers of the page: what is claimed of the table, limits, and the tables themselves.

use super::naive::{FLIPS_BY_RK4, GUARDED, MODULO, YAW};
use super::rotations::{FLIPPED, TRILLION, half_turn, late, locked, scaled};
use super::*;
use kit::rounded_up;

pub fn report(p: &Parameters) -> Result<Report> {
    let all = computed(p)?;
    let mut report = Report::new(
        "Hard cases",
        "cases times methods times attitude representations: an error within its bound, or a refusal by name",
    )?;
    claims(&mut report, &all)?;
    let half = half_turn(0.0)?;
    limits! { report,
        /// gravity has no lever on an axis that is exactly vertical
        "exactly upright below the critical spin, after 1e6 s: tilt in rad":
            HeavyTop::new(SymmetricTop::new(1.0, 0.5, 1.0, 1.0)?, Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 2.0))?
                .angles(1e6).theta => 0.0, within 0.0;
        /// half a turn and half a turn are a turn
        "rotation by pi about a skew axis, twice: off the start, in rad":
            (half * half).angle_to(&Attitude::IDENTITY) => 0.0, within 4.0 * EPS;
    }?;
    let asked = p.tolerance.map_or(vec![1e-9, 1e-6, 1e-12], |one| vec![one]);
    // These cases are about arithmetic: what is in is rounding.
    effect_card! { report, asked asked[0];
        "rounding of the numbers": "2^-53" = EPS, costs 0.5 * EPS, "rad per radian turned", included;
    }?;
    report.strip(&flip()?, &asked)?;
    let columns = ["found", "the test that sees it"];
    report.add(Table::of("findings_elsewhere", columns, findings::ELSEWHERE, Ok)?)?;
    report.add(summary(&all)?)?;
    all.iter().try_for_each(|one| report.add(tables(one)?))?;
    Ok(report)
}

fn claims(report: &mut Report, all: &[Arc<Computed>]) -> Result<()> {
    // The example of the opening: the same function, and two ways to write it.
    let x: f64 = 1e-6;
    let half = sin(0.5 * x);
    // About the middle axis of moments 1, 2, 2.5 a kick grows as exp(t sqrt(1/5)).
    let rate = 0.2_f64.sqrt();
    // The error of a naive method against the series, and once more against the closed form.
    let errors = |motion: Motion, (_, off): Plain| -> Result<[f64; 2]> {
        Ok([off(&motion, motion.truth()?)?, off(&motion, motion.in_closed_form()?)?])
    };
    let a = errors(locked()?, YAW)?;
    let b = errors(late(FLIPPED, [1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?, FLIPS_BY_RK4)?;
    let c = errors(late(TRILLION, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?, MODULO)?;
    let d = errors(scaled(1e-46, 1e12)?, GUARDED)?;
    let total = |n: usize| all.iter().map(|one| one.count()[n]).sum::<usize>() as f64;
    let [cases, cells, holds, refused] = [0, 1, 2, 3].map(total);
    let due =
        |one: &Arc<Computed>| one.rows.len() * one.family.methods.len() * one.family.forms.len();
    let due = all.iter().map(due).sum::<usize>() as f64;
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
        /// a rounding about the middle axis has grown to one
        grown: log(2.0 / EPS) / rate, "s", "first flip by RK4" => figures::first_flip(0.1)?, within 5.0;
        /// yaw, pitch and roll from a pitch of pi/2, off after 20 s
        locked: a[0], "rad", "the closed form" => a[1], within 1e-10;
        /// RK4 on quaternion and rates, off after ten thousand flips
        flipped: b[0], "rad", "the closed form" => b[1], within 1e-10;
        /// time modulo the period in doubles, off after 1e12 periods
        late: c[0], "rad", "the closed form" => c[1], within 1e-10;
        /// 1e-30 kg m^2 added to the moments of a molecule, off after 30 rad
        guarded: d[0], "rad", "the closed form" => d[1], within 1e-10;
        /// cases
        cases: cases, "-", "naive methods, one for each" => cases, within 0.0;
        /// cells
        cells: cells, "-", "cases times methods times representations" => due, within 0.0;
        /// cells that hold
        holds: holds, "-", "cells less refusals" => cells - refused, within 0.0;
        /// cells that are refused
        refused: refused, "-", "cells less those that hold" => cells - holds, within 0.0;
    }
}

/// One flip next to the separatrix: 1 - k^2 = 1e-8.
fn flip() -> Result<Problem<()>> {
    let (moments, rates) = ([3.0, 4.0, 6.0], [0.0, 1.0, 4.7e-5]);
    let motion = Motion::free(moments, Attitude::IDENTITY, rates, 38.0);
    let (exact, body) = (motion.free_body()?, RigidBody::new(motion.body()?));
    let (scene, end) = (Scene::new(body), exact.state(motion.end));
    let start = body.state(motion.attitude, BodyVector::from_array(rates))?;
    Ok(Problem::new(scene, start, motion.end, end).in_closed_form(move |t| exact.attitude(t)))
}

/// A line for each family.
fn summary(all: &[Arc<Computed>]) -> Result<Table> {
    let columns = "family, what it is, cases, cells, hold, refused, error/bound, naive";
    Table::of("families", columns.split(", "), all, |one: &Arc<Computed>| {
        let worst = short(one.cells().filter_map(Cell::part).fold(0.0, f64::max), 2);
        let broken = one.rows.iter().map(|(_, answered)| answered.broken());
        let broken = short(broken.fold(f64::INFINITY, f64::min), 2);
        let (key, title) = (one.family.key.to_owned(), one.family.title.to_owned());
        let [cases, cells, hold, refused] = one.count().map(|n| n.to_string());
        Ok([key, title, cases, cells, hold, refused, worst, broken])
    })
}

/// The name of an error: `GimbalLock`.
pub fn name_of(error: &Error) -> String {
    let told = format!("{error:?}");
    let name = told.split([' ', '{', '(']).next();
    name.unwrap_or_default().to_owned()
}

/// A family's three tables: what goes wrong and the naive method, the cells, and what each kind of
/// refusal says, once.
fn tables(one: &Computed) -> Result<Vec<Table>> {
    let Family { key, forms, .. } = one.family;
    let columns = "case, what goes wrong, condition, naive method, its error, over the bound";
    let number = |x: f64, none: &str| if x.is_finite() { short(x, 2) } else { none.to_owned() };
    let naive = |(Case(case, wrong, _), answered): &(&Case, Answered)| {
        let (method, error) = answered.naive;
        let condition = number(answered.condition, "-");
        let [error, broken] = [error, answered.broken()].map(|x| number(x, "no number"));
        Ok([(*case).to_owned(), (*wrong).to_owned(), condition, method.to_owned(), error, broken])
    };
    let naive = Table::of(&format!("{key}_naive"), columns.split(", "), &one.rows, naive)?;
    let columns = ["case", "method", "bound"].iter().chain(*forms);
    let mut table = Table::new(key, columns.copied())?;
    let mut refusals = Table::new(&format!("{key}_refusals"), ["refusal", "says"])?;
    let printed = |cell: &Cell| match &cell.answer {
        Ok(_) => short(cell.part().unwrap_or_default(), 2),
        Err(error) => name_of(error),
    };
    for (case, answered) in &one.rows {
        for cells in answered.cells.chunks(forms.len()) {
            let held = cells.iter().find(|cell| cell.answer.is_ok());
            let bound = held.map_or("-".to_owned(), |cell| rounded_up(cell.bound));
            let line = [case.0.to_owned(), cells[0].method.to_owned(), bound];
            table.push(line.into_iter().chain(cells.iter().map(printed)))?;
        }
        for error in answered.cells.iter().filter_map(|cell| cell.answer.as_ref().err()) {
            if refusals.rows().iter().all(|told| told[0] != name_of(error)) {
                refusals.push([name_of(error), error.to_string()])?;
            }
        }
    }
    let all = [naive, table, refusals];
    Ok(all.into_iter().filter(|table| !table.is_empty()).collect())
}

/// All cells as numbers: family, case, method, representation, error, bound; those that hold.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "family, case, method, representation, error, bound";
    let mut rows = Trajectory::new(columns.split(", "))?;
    for (f, one) in computed(p)?.iter().enumerate() {
        let forms = one.family.forms.len();
        for (r, (_, answered)) in one.rows.iter().enumerate() {
            for (c, cell) in answered.cells.iter().enumerate() {
                let Ok(measured) = cell.answer else { continue };
                let [f, r, method, form] = [f, r, c / forms, c % forms].map(|n| (n + 1) as f64);
                rows.push([f, r, method, form, measured, cell.bound])?;
            }
        }
    }
    Ok(rows)
}
