//! The sections that every page has: what is claimed of the table, limits, and a picture of it.

use super::Parameters;
use super::motions::Motion;
use super::table::{Computed, Verdict};
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::math::EPS;
use rotation_dynamics::report::draw::Marker;
use rotation_dynamics::report::prelude::*;
use rotation_dynamics::report::short;
use rotation_dynamics::scene::Scene;

/// All of them, before the families' tables.
pub fn add(report: &mut Report, p: &Parameters, computed: &[Computed]) -> Result<()> {
    counts(report, computed)?;
    limits(report)?;
    effects(report)?;
    let asked = p.tolerance.map_or(vec![1e-9, 1e-6, 1e-12], |one| vec![one]);
    report.strip(&flip()?, &asked)?;
    summary(report, computed)
}

/// Nothing is left out: every case has every method in every representation.
fn counts(report: &mut Report, computed: &[Computed]) -> Result<()> {
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
fn effects(report: &mut Report) -> Result<()> {
    effect_card! { report,
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
fn summary(report: &mut Report, computed: &[Computed]) -> Result<()> {
    let columns = [
        "family",
        "what it is",
        "cases",
        "cells",
        "hold",
        "refused",
        "largest error over its bound",
        "naive methods: least error over the bound",
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

/// The naive methods above the line, all others below it, a column for each case.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let computed = super::computed(p)?;
    let rows: Vec<_> = computed.iter().flat_map(|one| &one.rows).collect();
    let x = |i: usize| (i + 1) as f64;
    let (mut held, mut naive) = (Vec::new(), Vec::new());
    for (i, row) in rows.iter().enumerate() {
        let parts = row.cells.iter().filter_map(super::table::Cell::part);
        held.extend(parts.map(|part| (x(i), part.max(1e-8))));
        naive.push((x(i), row.broken().clamp(1e-8, 1e16)));
    }
    let alt = "Error over its bound, logarithmic, for each case of the table: the cells of all methods \
               and representations lie below one, the naive method of the case above it";
    let figure = Panel::new("table", alt)
        .size(720, 300)
        .x(Axis::linear("case").range(0.0, x(rows.len())))
        .y(Axis::log("error over its bound").range(1e-8, 1e16))
        .level(1.0, Ink::Ink, "bound")
        .curve(Curve::new(held, Ink::Ink).faint(0.5).dots())
        .curve(Curve::new(naive, Ink::Wrong).marker(Marker::Square).dots())
        .figure()?;
    Ok(vec![figure])
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
