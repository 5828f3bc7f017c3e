//! The table: cases times methods times representations, and the engine that walks it.
//!
//! A cell is an error within its bound, or a refusal by name; nothing else can be made. The
//! bound is K eps times the case's own condition number, with one K for a method on all cases.

use super::*;
use kit::rounded_up;

/// Cases that are hard for the same reason.
pub struct Family {
    /// Its word on the command line.
    pub key: &'static str,
    pub title: &'static str,
    pub methods: &'static [By],
    pub forms: &'static [&'static str],
    pub cases: &'static [Case],
    /// The true motion and, dashed, what a naive method makes of it.
    pub picture: fn() -> Result<MovingPicture>,
}

/// A case, what goes wrong there, and what these methods make of it.
pub struct Case(pub &'static str, pub &'static str, pub fn(&[By]) -> Result<Answered>);

/// A family as a table in the source, two lines a case: its name, what goes wrong, and what is
/// asked, of which `by` the family's methods answers come.
macro_rules! family {
    ($name:ident, $key:literal: $title:literal, by $methods:expr, in $forms:expr, seen in $picture:path;
     $( $case:literal, $wrong:literal: $asked:expr; )+) => {
        pub const $name: Family = Family {
            key: $key,
            title: $title,
            methods: &$methods,
            forms: &$forms,
            picture: $picture,
            cases: &[ $( Case($case, $wrong, |methods| $asked?.by(methods)) ),+ ],
        };
    };
}
pub(super) use family;

/// The method that everyone writes first, and how far off it is on a case.
pub type Naive = (&'static str, f64);

/// What came of a case: by how much the answer changes per relative change of what it is computed
/// from, the naive method, and for each method in each form, in the family's order, an error or
/// a refusal, and the bound that an error is held to.
pub struct Answered(pub f64, pub Naive, pub Vec<(Solved<f64>, f64)>);

impl Answered {
    /// As it is: the case brings methods of its own.
    pub fn by(self, _: &[By]) -> Result<Self> {
        Ok(self)
    }
}

/// What came of a case by a method in a representation.
pub struct Cell {
    pub method: &'static str,
    pub form: &'static str,
    /// An error (rad, unless the family says otherwise) that is held, or why it is refused.
    pub verdict: Solved<f64>,
    /// What it is held to, or would be.
    pub bound: f64,
}

impl Cell {
    /// The verdict on an answer: held to its bound, or refused.
    ///
    /// # Errors
    /// [`kit::Error::Contradicted`] if it does not hold.
    pub fn of(
        (case, method, form): (&str, &'static str, &'static str),
        verdict: Solved<f64>,
        bound: f64,
    ) -> Result<Self> {
        let held = |measured: f64| measured <= bound;
        match verdict {
            Ok(value) if !held(value) => Err(kit::Error::Contradicted {
                key: format!("{case}, {method}, {form}"),
                value,
                oracle: "the truth".into(),
                oracle_value: 0.0,
                bound,
            }),
            _ => Ok(Self { method, form, verdict, bound }),
        }
    }

    /// The error in units of its bound; 0 within a bound of 0. None if it is refused.
    pub fn part(&self) -> Option<f64> {
        let measured = *self.verdict.as_ref().ok()?;
        let part = measured / self.bound;
        Some(if measured == 0.0 { 0.0 } else { part })
    }

    fn printed(&self) -> String {
        let refused = self.verdict.as_ref().err().map(name_of);
        refused.unwrap_or_else(|| short(self.part().unwrap_or_default(), 2))
    }
}

/// The name of an error: `GimbalLock`.
pub fn name_of(error: &Error) -> String {
    let told = format!("{error:?}");
    let name = told.split([' ', '{', '(']).next();
    name.unwrap_or_default().to_owned()
}

/// A case with all its cells.
pub struct Row {
    pub case: &'static str,
    wrong: &'static str,
    condition: f64,
    naive: Naive,
    pub cells: Vec<Cell>,
}

impl Row {
    fn new(family: &Family, &Case(case, wrong, asked): &Case) -> Result<Self> {
        let Answered(condition, naive, answers) = asked(family.methods)?;
        let of = |by: &By| {
            let method = by.name();
            family.forms.iter().map(move |form| (method, *form))
        };
        let names = family.methods.iter().flat_map(of);
        let mut cells = Vec::new();
        for ((method, form), (answer, bound)) in names.zip(answers) {
            cells.push(Cell::of((case, method, form), answer, bound)?);
        }
        Ok(Self { case, wrong, condition, naive, cells })
    }

    /// The smallest bound of the row: what a careful method is held to, or what was asked for
    /// and refused; of a row of which nothing holds, what it would be held to.
    fn least_bound(&self) -> f64 {
        let bounds = self.cells.iter().filter_map(|cell| match cell.verdict {
            Ok(_) => Some(cell.bound),
            Err(Error::NotDelivered { requested, condition, .. }) => condition.and(Some(requested)),
            Err(_) => None,
        });
        let due = self.cells.iter().map(|cell| cell.bound);
        let held = bounds.reduce(f64::min);
        held.unwrap_or_else(|| due.fold(f64::INFINITY, f64::min))
    }

    /// The naive error in units of that bound; infinite if there is no number at all.
    pub fn broken(&self) -> f64 {
        let part = self.naive.1 / self.least_bound();
        if part.is_nan() { f64::INFINITY } else { part }
    }
}

/// A family with its rows computed.
pub struct Computed {
    pub family: &'static Family,
    pub rows: Vec<Row>,
}

/// What the whole of some rows comes to.
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

impl Computed {
    pub fn new(family: &'static Family) -> Result<Self> {
        let rows = family.cases.iter().map(|case| Row::new(family, case));
        let rows = rows.collect::<Result<_>>()?;
        Ok(Self { family, rows })
    }

    /// How many cells there are to be: cases times methods times representations.
    pub fn due(&self) -> usize {
        self.rows.len() * self.family.methods.len() * self.family.forms.len()
    }

    pub fn cells(&self) -> impl Iterator<Item = &Cell> {
        self.rows.iter().flat_map(|row| &row.cells)
    }

    pub fn count(&self) -> Count {
        let parts = || self.cells().filter_map(Cell::part);
        let broken = self.rows.iter().map(Row::broken);
        let (cells, holds) = (self.cells().count(), parts().count());
        Count {
            rows: self.rows.len(),
            cells,
            holds,
            refusals: cells - holds,
            worst: parts().fold(0.0, f64::max),
            least_broken: broken.fold(f64::INFINITY, f64::min),
        }
    }

    /// The family's three tables: what goes wrong and the naive method, the cells, and what the
    /// refusals say.
    pub fn tables(&self) -> Result<Vec<Table>> {
        let Family { key, forms, .. } = self.family;
        let columns = "case, what goes wrong, condition, naive method, its error, over the bound";
        let number = |x: f64, none: &str| match x.is_finite() {
            true => short(x, 2),
            false => none.to_owned(),
        };
        let line = |row: &Row| {
            let [case, wrong, method] = [row.case, row.wrong, row.naive.0].map(str::to_owned);
            let [error, broken] = [row.naive.1, row.broken()].map(|x| number(x, "no number"));
            let condition = number(row.condition, "-");
            Ok([case, wrong, condition, method, error, broken])
        };
        let name = format!("{key}_naive");
        let naive = Table::of(&name, columns.split(", "), &self.rows, line)?;

        let columns = ["case", "method", "bound"].iter().chain(*forms);
        let mut table = Table::new(key, columns.copied())?;
        for row in &self.rows {
            for cells in row.cells.chunks(forms.len()) {
                let held = cells.iter().find(|cell| cell.verdict.is_ok());
                let bound = held.map_or("-".into(), |cell| rounded_up(cell.bound));
                let line = [row.case.to_owned(), cells[0].method.to_owned(), bound];
                table.push(line.into_iter().chain(cells.iter().map(Cell::printed)))?;
            }
        }

        // What each kind of refusal says, once.
        let mut told: Vec<[String; 2]> = Vec::new();
        for error in self.cells().filter_map(|cell| cell.verdict.as_ref().err()) {
            let name = name_of(error);
            if told.iter().all(|[known, _]| *known != name) {
                told.push([name, error.to_string()]);
            }
        }
        let refusals = Table::of(&format!("{key}_refusals"), ["refusal", "says"], told, Ok)?;
        let all = [naive, table, refusals];
        Ok(all.into_iter().filter(|table| !table.is_empty()).collect())
    }
}
