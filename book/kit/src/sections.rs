//! The report and what goes into its sections.

use super::card::{self, ASKED, EffectEntry};
use super::claim::Claim;
use super::computation::{ClosedForm, Computation};
use super::entries::Entry;
use super::lab::Lab;
use super::number::{rounded_up, supported_digits};
use super::strip::Lines;
use super::table::{Table, check_cell};
use crate::error::{Error, Result, finite};
use core::fmt;

/// The heading of the section that lists the parameters.
pub(super) const PARAMETERS: &str = "parameters";

const CLAIMS: &str = "claims";
const LIMITS: &str = "limits";
pub(super) const EFFECTS: &str = "effects";
const ACCURACY: &str = "accuracy";

/// A limit in which the answer is known: what must come out, and what does. It needs
/// [`within`](Limit::within) and [`because`](Limit::because), and is checked as [`Report::add`] adds
/// it.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "it is added by Report::add"]
pub struct Limit {
    limit: String,
    because: String,
    must_give: f64,
    gives: f64,
    within: f64,
}

/// In the limit `limit` the result must be `must_give`, and it `gives` this.
pub fn limit(limit: impl Into<String>, must_give: f64, gives: f64) -> Limit {
    Limit { limit: limit.into(), because: String::new(), must_give, gives, within: f64::NAN }
}

impl Limit {
    /// By how much the two may differ: of a part of a negative number its size.
    pub fn within(mut self, bound: f64) -> Self {
        self.within = bound.abs();
        self
    }

    /// Why this must come out, in a few words.
    pub fn because(mut self, reason: impl Into<String>) -> Self {
        self.because = reason.into();
        self
    }

    fn check(&self) -> Result<()> {
        check_cell(&self.limit)?;
        check_cell(&self.because)?;
        let agrees = (self.gives - self.must_give).abs() <= self.within;
        if agrees && self.within.is_finite() && self.gives.is_finite() {
            return Ok(());
        }
        Err(Error::Contradicted {
            key: self.limit.clone(),
            value: self.gives,
            oracle: self.because.clone(),
            oracle_value: self.must_give,
            bound: self.within,
        })
    }
}

/// A line of the accuracy strip: what was asked for, what came, and its price.
#[derive(Debug, Clone)]
pub struct Price {
    /// The method: `"DOP853"`.
    pub method: String,
    /// The global error asked for; `None` for a method without one.
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
    asked: f64,
    accuracy: Vec<Lines>,
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
            asked: ASKED,
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

    /// Adds a claim whose key is not taken.
    pub(super) fn add_claim(&mut self, claim: Claim) -> Result<()> {
        claim.check()?;
        if self.claim(&claim.key).is_some() {
            return Err(Error::Text {
                text: claim.key,
                allowed: "a key may be used only once in a report",
            });
        }
        self.claims.push(claim);
        Ok(())
    }

    pub(super) fn add_limit(&mut self, limit: Limit) -> Result<()> {
        limit.check()?;
        self.limits.push(limit);
        Ok(())
    }

    /// Adds a line to the card of effects.
    pub(super) fn add_effect(&mut self, effect: EffectEntry) -> Result<()> {
        effect.check()?;
        self.effects.push(effect);
        Ok(())
    }

    /// Asks for this accuracy: an effect is in or out on the card by whether the error of leaving
    /// it out is noticed at it. A part of what each line is an error of, of a radian for angles;
    /// one in a hundred if nothing is asked.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](rotation_dynamics::Error::OutOfRange) if it is not above 0 and finite.
    pub fn ask(&mut self, accuracy: f64) -> Result<()> {
        if !(accuracy > 0.0 && accuracy.is_finite()) {
            return Err(rotation_dynamics::Error::out_of_range(
                "the accuracy asked for",
                accuracy,
                "it must be above 0 and finite",
            )
            .into());
        }
        self.asked = accuracy;
        Ok(())
    }

    /// Adds a line to the accuracy strip.
    pub(super) fn add_price(&mut self, price: Price) {
        self.add_lines(move || Ok(vec![price.clone()]));
    }

    /// Adds lines to the accuracy strip that are computed when they are read.
    pub(super) fn add_lines(
        &mut self,
        compute: impl Fn() -> Result<Vec<Price>> + Send + Sync + 'static,
    ) {
        self.accuracy.push(Lines::new(compute));
    }

    /// Sets the closed form whose samples are the unit of the strip's times.
    pub fn set_closed_form(&mut self, closed_form: ClosedForm) {
        self.closed_form = Some(closed_form);
    }

    /// [`set_closed_form`](Self::set_closed_form) of one that gives a state at every part of the motion.
    pub fn in_closed_form<T>(&mut self, state: impl Fn(f64) -> T + Send + Sync + 'static) {
        self.set_closed_form(ClosedForm::new(move |part| Ok(state(part))));
    }

    /// Adds a table of its own, whose name is not taken.
    pub(super) fn add_table(&mut self, table: Table) -> Result<()> {
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
    /// The line below it.
    pub fn description(&self) -> &str {
        &self.description
    }
    /// The claims, in order.
    pub fn claims(&self) -> &[Claim] {
        &self.claims
    }
    /// The claim with this key.
    pub fn claim(&self, key: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.key == key)
    }

    /// The card of effects, line by line.
    pub fn effects(&self) -> &[EffectEntry] {
        &self.effects
    }

    /// The accuracy at which the card says in or out.
    pub fn asked(&self) -> f64 {
        self.asked
    }

    /// The accuracy strip, line by line; computed when it is first read.
    ///
    /// # Errors
    /// What a run of the strip refuses; see [`Report::strip`] and [`Report::controlled`].
    pub fn prices(&self) -> Result<Vec<&Price>> {
        let lines: Vec<&[Price]> = self.accuracy.iter().map(Lines::get).collect::<Result<_>>()?;
        Ok(lines.into_iter().flatten().collect())
    }

    /// The methods that a reader may try, if the scene is a problem with a known answer.
    pub fn lab(&self) -> Option<&Lab> {
        self.lab.as_ref()
    }

    /// Sets the methods that a reader may try.
    pub(crate) fn set_lab(&mut self, lab: Lab) {
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
    /// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) if it holds a NaN or an
    /// infinity; those of [`Report::prices`].
    pub fn sections(&self) -> Result<Vec<Table>> {
        let mut all: Vec<Table> = self.parameters.iter().cloned().collect();
        all.push(self.claims_table()?);
        all.push(self.limits_table()?);
        all.push(card::table(&self.effects, &self.claims, self.asked)?);
        all.push(self.strip_table()?);
        all.extend(self.tables.iter().cloned());
        all.extend(self.answer_box()?);
        all.retain(|table| !table.is_empty());
        Ok(all)
    }

    /// The section with this heading, if the report has it; of the others nothing is computed.
    ///
    /// # Errors
    /// As [`Report::sections`].
    pub fn section(&self, heading: &str) -> Result<Option<Table>> {
        let table = match heading {
            PARAMETERS => self.parameters.clone(),
            CLAIMS => Some(self.claims_table()?),
            LIMITS => Some(self.limits_table()?),
            EFFECTS => Some(card::table(&self.effects, &self.claims, self.asked)?),
            ACCURACY => Some(self.strip_table()?),
            _ => {
                let answers = self.answer_box()?;
                let others = self.tables.iter().cloned().chain(answers);
                others.into_iter().find(|table| table.heading() == heading)
            }
        };
        Ok(table.filter(|table| !table.is_empty()))
    }

    fn claims_table(&self) -> Result<Table> {
        let columns = ["key", "value", "unit", "bound", "checked against", "differs by"];
        let mut table = Table::headed(CLAIMS, columns)?;
        for claim in &self.claims {
            table.push(claim.cells())?;
        }
        Ok(table)
    }

    fn limits_table(&self) -> Result<Table> {
        let columns = ["limit", "must give", "gives", "within", "because"];
        let mut table = Table::headed(LIMITS, columns)?;
        for l in &self.limits {
            table.push([
                l.limit.clone(),
                supported_digits(l.must_give, l.within),
                supported_digits(l.gives, l.within),
                rounded_up(l.within),
                l.because.clone(),
            ])?;
        }
        Ok(table)
    }

    fn strip_table(&self) -> Result<Table> {
        let columns = ["method", "requested", "delivered", "work", "relative time"];
        let mut table = Table::headed(ACCURACY, columns)?;
        for p in self.prices()? {
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
        Ok(table)
    }

    /// How answers are judged, and the slips that are known.
    fn answer_box(&self) -> Result<[Table; 2]> {
        let mut checks = Table::headed("checks", ["key", "within", "meaning", "group"])?;
        let mut slips = Table::headed("slips", ["key", "value", "hint"])?;
        for c in &self.claims {
            checks.push([
                c.key.clone(),
                rounded_up(c.judged_within),
                c.meaning.clone(),
                c.group.clone().unwrap_or("-".into()),
            ])?;
            for slip in &c.slips {
                slips.push([
                    c.key.clone(),
                    supported_digits(slip.value, c.bound),
                    slip.hint.clone(),
                ])?;
            }
        }
        Ok([checks, slips])
    }

    /// The text, in the grammar of [the crate](crate).
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
    text.split_once("\n\nchecks\n").map_or(text, |(before, _)| &text[..before.len() + 1])
}
