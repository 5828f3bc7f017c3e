//! The table: cases times methods times attitude representations.
//!
//! A cell is an error within its bound, or a refusal by name; nothing else can be made. The
//! bound is K eps times the case's own condition number, with one K for a method on all cases.

use kit::{Report, Result, Table, rounded_up, short};
use rotation_dynamics::Error;
use rotation_dynamics::math::EPS;

/// What came of a case by a method in a representation.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// An error (rad, unless the family says otherwise), and what it is held to.
    Holds { measured: f64, bound: f64 },
    /// It is refused, for a reason with a name.
    Refuses(Error),
}

/// One verdict, and where it stands.
#[derive(Debug, Clone)]
pub struct Cell {
    pub method: &'static str,
    pub form: &'static str,
    pub verdict: Verdict,
    /// What it is held to, or would be.
    pub bound: f64,
}

/// The method that everyone writes first, and how far off it is on this case.
#[derive(Debug, Clone, Copy)]
pub struct Naive {
    pub method: &'static str,
    pub error: f64,
}

/// A case: all methods, all representations.
#[derive(Debug, Clone)]
pub struct Row {
    pub case: &'static str,
    /// What goes wrong there.
    pub wrong: &'static str,
    /// By how much the answer changes per relative change of what it is computed from.
    pub condition: f64,
    pub naive: Naive,
    pub cells: Vec<Cell>,
}

/// Cases that are hard for the same reason.
pub struct Family {
    /// Its word on the command line.
    pub key: &'static str,
    pub title: &'static str,
    /// The form of the arithmetic that cures it.
    pub cure: &'static str,
    pub methods: &'static [&'static str],
    pub forms: &'static [&'static str],
    pub rows: fn() -> Result<Vec<Row>>,
}

/// A family with its rows computed.
pub struct Computed {
    pub family: &'static Family,
    pub rows: Vec<Row>,
}

/// What the whole of some rows comes to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Count {
    pub rows: usize,
    pub cells: usize,
    pub holds: usize,
    pub refusals: usize,
    /// The largest error in units of its bound.
    pub worst: f64,
    /// The smallest error of a naive method in units of the smallest bound of its row.
    pub least_broken: f64,
}

impl Cell {
    /// The verdict on an answer: held to K eps times the condition, or refused.
    ///
    /// # Errors
    /// [`kit::Error::Contradicted`] if it does not hold.
    pub fn of(
        (case, method, form): (&str, &'static str, &'static str),
        answer: rotation_dynamics::Result<f64>,
        bound: f64,
    ) -> Result<Self> {
        let verdict = match answer {
            Ok(measured) if measured <= bound => Verdict::Holds { measured, bound },
            Ok(measured) => {
                return Err(kit::Error::Contradicted {
                    key: format!("{case}, {method}, {form}"),
                    value: measured,
                    oracle: "the truth".into(),
                    oracle_value: 0.0,
                    bound,
                });
            }
            Err(error) => Verdict::Refuses(error),
        };
        Ok(Self {
            method,
            form,
            verdict,
            bound,
        })
    }

    /// The error in units of its bound; 0 within a bound of 0. None if it is refused.
    pub fn part(&self) -> Option<f64> {
        match self.verdict {
            Verdict::Holds { measured: 0.0, .. } => Some(0.0),
            Verdict::Holds { measured, bound } => Some(measured / bound),
            Verdict::Refuses(_) => None,
        }
    }

    fn printed(&self) -> String {
        match &self.verdict {
            Verdict::Holds { .. } => short(self.part().unwrap_or_default(), 2),
            Verdict::Refuses(error) => name_of(error),
        }
    }
}

/// The name of an error: `GimbalLock`.
pub fn name_of(error: &Error) -> String {
    let told = format!("{error:?}");
    told.split([' ', '{', '('])
        .next()
        .unwrap_or_default()
        .to_owned()
}

/// K eps times the condition.
pub fn bound(k: f64, condition: f64) -> f64 {
    k * EPS * condition
}

impl Row {
    /// The smallest bound of the row: what a careful method is held to, or what was asked for
    /// and refused; of a row of which nothing holds, what it would be held to.
    pub fn least_bound(&self) -> f64 {
        let bounds = self.cells.iter().filter_map(|cell| match cell.verdict {
            Verdict::Holds { bound, .. } => Some(bound),
            Verdict::Refuses(Error::NotDelivered {
                requested,
                condition: Some(_),
                ..
            }) => Some(requested),
            Verdict::Refuses(_) => None,
        });
        let held = bounds.fold(f64::INFINITY, f64::min);
        if held.is_finite() {
            return held;
        }
        let due = self.cells.iter().map(|cell| cell.bound);
        due.fold(f64::INFINITY, f64::min)
    }

    /// The naive error in units of that bound; infinite if there is no number at all.
    pub fn broken(&self) -> f64 {
        let part = self.naive.error / self.least_bound();
        if part.is_nan() { f64::INFINITY } else { part }
    }
}

impl Computed {
    pub fn new(family: &'static Family) -> Result<Self> {
        let rows = (family.rows)()?;
        Ok(Self { family, rows })
    }

    pub fn count(&self) -> Count {
        let cells = || self.rows.iter().flat_map(|row| &row.cells);
        let parts = || cells().filter_map(Cell::part);
        let broken = self.rows.iter().map(Row::broken);
        Count {
            rows: self.rows.len(),
            cells: cells().count(),
            holds: parts().count(),
            refusals: cells().count() - parts().count(),
            worst: parts().fold(0.0, f64::max),
            least_broken: broken.fold(f64::INFINITY, f64::min),
        }
    }

    /// The family's three tables: what goes wrong and the naive method, the cells, and what the
    /// refusals say.
    pub fn add(&self, report: &mut Report) -> Result<()> {
        let key = self.family.key;
        let columns = [
            "case",
            "what goes wrong",
            "condition",
            "naive method",
            "its error",
            "over the bound",
        ];
        let mut table = Table::new(&format!("{key}_naive"), columns)?;
        for row in &self.rows {
            let [error, broken] = [row.naive.error, row.broken()].map(|x| match x {
                x if x.is_nan() || x.is_infinite() => "no number".to_owned(),
                x => short(x, 2),
            });
            table.push([
                row.case.to_owned(),
                row.wrong.to_owned(),
                match row.condition {
                    known if known.is_finite() => short(known, 2),
                    _ => "-".to_owned(),
                },
                row.naive.method.to_owned(),
                error,
                broken,
            ])?;
        }
        report.add(table)?;

        let columns = ["case", "method", "bound"].iter().chain(self.family.forms);
        let mut table = Table::new(key, columns.copied())?;
        for row in &self.rows {
            for method in self.family.methods {
                let cells = || row.cells.iter().filter(|cell| cell.method == *method);
                let held = cells().find_map(|cell| match cell.verdict {
                    Verdict::Holds { bound, .. } => Some(rounded_up(bound)),
                    Verdict::Refuses(_) => None,
                });
                let mut line = vec![
                    row.case.to_owned(),
                    (*method).to_owned(),
                    held.unwrap_or("-".into()),
                ];
                line.extend(cells().map(Cell::printed));
                table.push(line)?;
            }
        }
        report.add(table)?;
        self.add_refusals(report)
    }

    /// What each kind of refusal says, once.
    fn add_refusals(&self, report: &mut Report) -> Result<()> {
        let mut told: Vec<[String; 2]> = Vec::new();
        for cell in self.rows.iter().flat_map(|row| &row.cells) {
            if let Verdict::Refuses(error) = &cell.verdict {
                let name = name_of(error);
                if told.iter().all(|[known, _]| *known != name) {
                    told.push([name, error.to_string()]);
                }
            }
        }
        if told.is_empty() {
            return Ok(());
        }
        let mut table = Table::new(
            &format!("{}_refusals", self.family.key),
            ["refusal", "says"],
        )?;
        for line in told {
            table.push(line)?;
        }
        report.add(table)
    }
}
