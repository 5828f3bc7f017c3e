//! The report and what goes into its sections.

use super::claim::Claim;
use super::computation::{ClosedForm, Computation};
use super::entries::Entry;
use super::lab::Lab;
use super::number::{rounded_up, short, supported_digits};
use super::table::{Table, check_cell};
use crate::error::{Error, Result, finite};
use core::fmt;

/// The heading of the section that lists the parameters.
pub(super) const PARAMETERS: &str = "parameters";

/// A limit in which the answer is known: what must come out, and what does.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    limit: String,
    because: String,
    must_give: f64,
    gives: f64,
    within: f64,
}

impl Limit {
    /// In the limit `limit` the result must be `must_give`, because `because`; it
    /// `gives` a value that may differ by `within`.
    ///
    /// # Errors
    /// [`Error::Contradicted`] if it differs by more, or anything is not finite.
    pub fn new(
        limit: impl Into<String>,
        because: impl Into<String>,
        must_give: f64,
        gives: f64,
        within: f64,
    ) -> Result<Self> {
        let entry = Self {
            limit: limit.into(),
            because: because.into(),
            must_give,
            gives,
            within,
        };
        check_cell(&entry.limit)?;
        check_cell(&entry.because)?;
        let agrees = (gives - must_give).abs() <= within;
        if agrees && within.is_finite() && gives.is_finite() {
            Ok(entry)
        } else {
            Err(Error::Contradicted {
                key: entry.limit,
                value: gives,
                oracle: entry.because,
                oracle_value: must_give,
                bound: within,
            })
        }
    }
}

/// A line of the card of effects.
#[derive(Debug, Clone, PartialEq)]
pub struct EffectEntry {
    /// The effect: `"air drag"`.
    pub effect: String,
    /// The dimensionless number that measures it, as a formula: `"rho C d l^2 / m"`.
    pub number: String,
    /// The value of that number.
    pub value: f64,
    /// The error made by leaving it out.
    pub error: f64,
    /// The unit of that error, `"-"` if it has none.
    pub unit: String,
    /// The same error from a simulation with the effect and one without it, where one was made.
    pub measured: Option<f64>,
    /// The error of that itself.
    pub within: f64,
    /// What a simulation costs without it and with it, in words, where it was counted:
    /// `"closed form, 812 torques"`.
    pub cost: Option<String>,
    /// Whether the scene includes it.
    pub included: bool,
    /// The accuracy that is asked for and needs it, in words, if it was weighed against one:
    /// `"1e-3 rad"`.
    pub needed_for: Option<String>,
}

/// An effect whose number is larger is not small: a prediction to first order in it need not
/// hold.
pub(super) const SMALL: f64 = 0.1;

/// Prediction and simulation of a small effect agree within this factor.
const WITHIN: f64 = 2.0;

impl EffectEntry {
    pub(super) fn check(&self) -> Result<()> {
        finite("the number of an effect", self.value)?;
        finite("the error of leaving out an effect", self.error)?;
        [&self.effect, &self.number, &self.unit]
            .into_iter()
            .chain(&self.cost)
            .chain(&self.needed_for)
            .try_for_each(|cell| check_cell(cell))?;
        self.measured
            .map_or(Ok(()), |measured| self.predicts(measured))
    }

    /// That what is measured of a small effect is what is predicted, within a factor 2.
    fn predicts(&self, measured: f64) -> Result<()> {
        finite("the measured error of leaving out an effect", measured)?;
        let larger = self.error.abs().max(measured.abs());
        let bound = larger * (1.0 - 1.0 / WITHIN);
        if self.value.abs() > SMALL || (measured - self.error).abs() <= bound + self.within {
            return Ok(());
        }
        Err(Error::Contradicted {
            key: format!("the predicted error of leaving out '{}'", self.effect),
            value: self.error,
            oracle: "simulation with it and without".into(),
            oracle_value: measured,
            bound,
        })
    }

    /// Whether it is in, and what needs it.
    fn here(&self) -> String {
        let here = if self.included { "in" } else { "left out" };
        match &self.needed_for {
            None => here.into(),
            Some(accuracy) => format!("{here}, needed for {accuracy}"),
        }
    }
}

/// A line of the accuracy strip: what was asked for, what came, and its price.
#[derive(Debug, Clone)]
pub struct Price {
    /// The method: `"DOP853"`.
    pub method: String,
    /// The global error asked for; `None` for a method without a dial.
    pub requested: Option<f64>,
    /// The error found against the exact solution.
    pub delivered: f64,
    /// The work, in words: `"1204 torques"`. Deterministic; never a time.
    pub work: String,
    /// How to compute it again, for those who measure its time.
    pub again: Option<Computation>,
}

/// What an example says: title, description, and the sections in their fixed order.
#[derive(Debug, Clone)]
pub struct Report {
    title: String,
    description: String,
    parameters: Option<Table>,
    claims: Vec<Claim>,
    limits: Vec<Limit>,
    effects: Vec<EffectEntry>,
    accuracy: Vec<Price>,
    closed_form: Option<ClosedForm>,
    lab: Option<Lab>,
    tables: Vec<Table>,
}

impl Report {
    /// An empty report; `description` is one line that says what the scene is.
    ///
    /// # Errors
    /// [`Error::Text`] if either is empty or longer than a line.
    pub fn new(title: impl Into<String>, description: impl Into<String>) -> Result<Self> {
        let (title, description) = (title.into(), description.into());
        check_cell(&title)?;
        check_cell(&description)?;
        Ok(Self {
            title,
            description,
            parameters: None,
            claims: Vec::new(),
            limits: Vec::new(),
            effects: Vec::new(),
            accuracy: Vec::new(),
            closed_form: None,
            lab: None,
            tables: Vec::new(),
        })
    }

    /// Adds a line or a table: a claim, a limit, an effect, a price.
    ///
    /// # Errors
    /// Those of the entry; see [`Entry`].
    pub fn add(&mut self, entry: impl Entry) -> Result<()> {
        entry.enter(self)
    }

    /// Adds a claim.
    ///
    /// # Errors
    /// [`Error::Text`] if its key is taken, [`Error::OutOfRange`] if its tolerance is
    /// not between 0 and 1, [`Error::NotFinite`] if a slip is NaN or infinite.
    pub fn add_claim(&mut self, claim: Claim) -> Result<()> {
        let tolerance = claim.tolerance();
        if !(0.0 < tolerance && tolerance < 1.0) {
            return Err(Error::OutOfRange {
                name: "the relative tolerance of a check",
                value: tolerance,
                allowed: "it must lie between 0 and 1",
            });
        }
        for slip in claim.slips() {
            finite("a slip", slip.value)?;
            check_cell(&slip.hint)?;
        }
        if self.claim(claim.key()).is_some() {
            return Err(Error::Text {
                text: claim.key().into(),
                allowed: "a key may be used only once in a report",
            });
        }
        self.claims.push(claim);
        Ok(())
    }

    /// Adds a limit.
    pub fn add_limit(&mut self, limit: Limit) {
        self.limits.push(limit);
    }

    /// Adds a line to the card of effects.
    pub fn add_effect(&mut self, effect: EffectEntry) {
        self.effects.push(effect);
    }

    /// Adds a line to the accuracy strip.
    pub fn add_price(&mut self, price: Price) {
        self.accuracy.push(price);
    }

    /// Sets the closed form whose samples are the unit of the strip's times.
    pub fn set_closed_form(&mut self, closed_form: ClosedForm) {
        self.closed_form = Some(closed_form);
    }

    /// Adds a table of its own.
    ///
    /// # Errors
    /// [`Error::Text`] if its name is taken.
    pub fn add_table(&mut self, table: Table) -> Result<()> {
        if self.tables.iter().any(|t| t.heading() == table.heading()) {
            return Err(Error::Text {
                text: table.heading().into(),
                allowed: "the name of a table may be used only once in a report",
            });
        }
        self.tables.push(table);
        Ok(())
    }

    pub(super) fn set_parameters(&mut self, table: Table) {
        self.parameters = Some(table);
    }

    /// The first line.
    pub fn title(&self) -> &str {
        &self.title
    }
    /// The claims, in order.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }
    /// The claim with this key.
    pub fn claim(&self, key: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.key() == key)
    }

    /// The card of effects, line by line.
    pub fn effects(&self) -> &[EffectEntry] {
        &self.effects
    }

    /// The accuracy strip, line by line.
    pub fn prices(&self) -> &[Price] {
        &self.accuracy
    }

    /// The methods that a reader may try, if the scene is a problem with a known answer.
    pub fn lab(&self) -> Option<&Lab> {
        self.lab.as_ref()
    }

    /// Sets the methods that a reader may try.
    pub fn set_lab(&mut self, lab: Lab) {
        self.lab = Some(lab);
    }

    /// The unit of the strip's times, if the scene has a closed form.
    pub fn closed_form(&self) -> Option<&ClosedForm> {
        self.closed_form.as_ref()
    }

    /// The sections that are not empty, in the order in which they are printed.
    ///
    /// # Errors
    /// [`Error::Text`] if an entry holds text that does not fit in a table,
    /// [`Error::NotFinite`] if it holds a NaN or an infinity.
    pub fn sections(&self) -> Result<Vec<Table>> {
        let mut all: Vec<Table> = self.parameters.iter().cloned().collect();
        let columns = [
            "key",
            "value",
            "unit",
            "bound",
            "checked against",
            "differs by",
        ];
        let mut table = Table::headed("claims", columns)?;
        for claim in &self.claims {
            table.push(claim.cells())?;
        }
        all.push(table);

        let mut table = Table::headed(
            "limits",
            ["limit", "must give", "gives", "within", "because"],
        )?;
        for l in &self.limits {
            table.push([
                l.limit.clone(),
                supported_digits(l.must_give, l.within),
                supported_digits(l.gives, l.within),
                rounded_up(l.within),
                l.because.clone(),
            ])?;
        }
        all.push(table);

        // Two columns stand only where a line has something to say in them.
        let measured = self.effects.iter().any(|e| e.measured.is_some());
        let counted = self.effects.iter().any(|e| e.cost.is_some());
        let mut columns = vec!["effect", "number", "value", "error if left out"];
        columns.extend(measured.then_some("measured"));
        columns.extend(counted.then_some("cost: without, with"));
        columns.push("here");
        let mut table = Table::headed("effects", columns)?;
        for e in &self.effects {
            e.check()?;
            let unit = if e.unit == "-" {
                String::new()
            } else {
                format!(" {}", e.unit)
            };
            let mut row = vec![
                e.effect.clone(),
                e.number.clone(),
                short(e.value, 2),
                format!("{}{unit}", short(e.error, 2)),
            ];
            let dash = || "-".to_string();
            row.extend(measured.then(|| e.measured.map_or_else(dash, |m| short(m, 2))));
            row.extend(counted.then(|| e.cost.clone().unwrap_or_else(dash)));
            row.push(e.here());
            table.push(row)?;
        }
        all.push(table);

        let columns = ["method", "requested", "delivered", "work", "relative time"];
        let mut table = Table::headed("accuracy", columns)?;
        for p in &self.accuracy {
            finite("the requested error", p.requested.unwrap_or_default())?;
            finite("the delivered error", p.delivered)?;
            table.push([
                p.method.clone(),
                p.requested.map_or("-".into(), rounded_up),
                rounded_up(p.delivered),
                p.work.clone(),
                "-".into(),
            ])?;
        }
        all.push(table);

        all.extend(self.tables.iter().cloned());

        let mut checks = Table::headed("checks", ["key", "within", "meaning", "group"])?;
        let mut slips = Table::headed("slips", ["key", "value", "hint"])?;
        for c in &self.claims {
            checks.push([
                c.key().into(),
                rounded_up(c.tolerance()),
                c.meaning().into(),
                c.group().unwrap_or("-").into(),
            ])?;
            for slip in c.slips() {
                slips.push([
                    c.key().into(),
                    supported_digits(slip.value, c.bound()),
                    slip.hint.clone(),
                ])?;
            }
        }
        all.push(checks);
        all.push(slips);
        all.retain(|table| !table.is_empty());
        Ok(all)
    }

    /// The text, in the grammar of [`crate::report`].
    ///
    /// # Errors
    /// As [`Report::sections`].
    pub fn text(&self) -> Result<String> {
        use fmt::Write;
        let mut text = format!("{}\n{}\n", self.title, self.description);
        for section in self.sections()? {
            // Writing to a string cannot fail.
            let _ = write!(text, "\n{section}");
        }
        Ok(text)
    }

    /// The claims as JSON: key, meaning, value, unit, bound, oracle; numbers read back to
    /// the same bits.
    pub fn json(&self, stem: &str) -> String {
        super::json::claims(stem, self)
    }

    /// What an example prints: the text without its last two sections, which are
    /// for the page's answer box and would give its hints away.
    ///
    /// # Errors
    /// As [`Report::sections`].
    pub fn output(&self) -> Result<String> {
        let text = self.text()?;
        Ok(for_reading(&text).to_owned())
    }
}

/// A report's text up to the sections of the answer box, `checks` and `slips`.
pub fn for_reading(text: &str) -> &str {
    text.split_once("\n\nchecks\n")
        .map_or(text, |(before, _)| &text[..before.len() + 1])
}
