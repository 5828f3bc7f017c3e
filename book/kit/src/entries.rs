//! The lines of a report, one builder each: `report.add(claim(…).within(…).against(…))?`.

use super::card::{EffectEntry, SMALL};
use super::claim::Claim;
use super::lab::Lab;
use super::sections::{Limit, Price, Report};
use super::table::Table;
use crate::error::Result;
use rotation_dynamics::accuracy::{Measured, NeglectedEffects, PredictedError};
use rotation_dynamics::effects::Effect;
use rotation_dynamics::integrators::Work;

/// Something that a report can hold; added by [`Report::add`], which checks it.
pub trait Entry {
    /// Puts it into `report`.
    ///
    /// # Errors
    /// What is wrong with it: a contradicted number, a text that does not fit, a key
    /// that is taken.
    fn enter(self, report: &mut Report) -> Result<()>;
}

impl Entry for Claim {
    fn enter(self, report: &mut Report) -> Result<()> {
        report.add_claim(self)
    }
}

impl Entry for Limit {
    fn enter(self, report: &mut Report) -> Result<()> {
        report.add_limit(self)
    }
}

/// A line of the card of effects: an effect that is left out, unless
/// [`included`](EffectLine::included). It needs [`number`](EffectLine::number) and
/// [`costs`](EffectLine::costs).
pub fn effect(effect: impl Into<String>) -> EffectLine {
    let entry = EffectEntry {
        effect: effect.into(),
        number: String::new(),
        value: f64::NAN,
        error: f64::NAN,
        unit: "-".into(),
        beside: None,
        measured: None,
        within: 0.0,
        cost: None,
        included: false,
        beyond: false,
    };
    EffectLine { entry, asked: None }
}

/// An effect to be added; without its number and the error it is refused.
#[derive(Debug, Clone)]
#[must_use = "it is added by Report::add"]
pub struct EffectLine {
    entry: EffectEntry,
    /// The accuracy (rad) at which it was weighed.
    asked: Option<f64>,
}

impl EffectLine {
    /// The dimensionless number that measures it, as a formula, and its value.
    pub fn number(mut self, formula: impl Into<String>, value: f64) -> Self {
        (self.entry.number, self.entry.value) = (formula.into(), value);
        self
    }
    /// The error of leaving it out, with its unit or what it is an error of.
    pub fn costs(mut self, error: f64, unit: impl Into<String>) -> Self {
        (self.entry.error, self.entry.unit) = (error, unit.into());
        self
    }
    /// The error is large or small beside the value of the claim with this key; without it, beside
    /// the first claim in its unit, a part (`"of the period"`) beside the whole, an angle beside a
    /// radian.
    pub fn beside(mut self, key: impl Into<String>) -> Self {
        self.entry.beside = Some(key.into());
        self
    }
    /// The same error, with its sign, from a simulation with the effect and one without it;
    /// `None` where none could tell. For a small effect, whose number is 0.1 or less, the
    /// report refuses a prediction that is off by more than a factor 2.
    pub fn measured(mut self, error: impl Into<Option<f64>>) -> Self {
        self.entry.measured = error.into();
        self
    }
    /// The error of what is measured itself: of a part of a negative number its size.
    pub fn within(mut self, bound: f64) -> Self {
        self.entry.within = bound.abs();
        self
    }
    /// What a simulation costs without it and with it: `"closed form, 812 torques"`.
    pub fn at_cost(mut self, cost: impl Into<String>) -> Self {
        self.entry.cost = Some(cost.into());
        self
    }
    /// Without it a closed form answers; with it a simulation did this work, if one was made.
    pub fn at_work(mut self, work: impl Into<Option<Work>>) -> Self {
        let told = |work: Work| format!("closed form, {} derivatives", work.derivatives);
        self.entry.cost = work.into().map(told);
        self
    }
    /// The scene includes it.
    pub fn included(mut self) -> Self {
        self.entry.included = true;
        self
    }
}

/// A line of the card of effects from what [`NeglectedEffects`] finds.
pub trait CardLine {
    /// The line of the card for an effect that the scene leaves out: what the page calls it,
    /// the number that measures it, as a formula and its value, the effect, and what the
    /// predicted angle is: `"rad a turn, of the axis"`. Beside the prediction stands what two
    /// simulations measure, what they cost, and whether the tolerance, at which the card from now
    /// on says in or out, calls for the effect.
    ///
    /// ```
    /// use rotation_dynamics::attitude::{Attitude, EulerAngles};
    /// use rotation_dynamics::body::RigidBody;
    /// use rotation_dynamics::effects::{DiscDrag, Effect, GravityAtLever};
    /// use rotation_dynamics::frame::BodyVector;
    /// use rotation_dynamics::inertia::PrincipalMoments;
    /// use kit::{CardLine, Report};
    /// use rotation_dynamics::scene::Scene;
    /// # fn main() -> kit::Result<()> {
    /// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
    /// let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
    /// let start = body.state(tilted, BodyVector::new(0.0, 0.0, 314.0))?;
    /// let scene = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?);
    /// let air = DiscDrag::new(0.06, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, 314.0)?;
    ///
    /// let left_out = scene.neglected_effects(&start, 0.2, 1e-3)?.of_axis();
    /// let mut report = Report::new("A rotor", "a disc on an axle")?;
    /// let number = air.number(&body, &start);
    /// report.add(left_out.line("air", "torque / |L| omega", number, &air, "rad in 0.2 s")?)?;
    /// let text = report.text()?;
    /// assert!(text.contains("rad in 0.2 s") && text.contains("left out"), "{text}");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`NeglectedEffects::predict`] and [`NeglectedEffects::measure`].
    fn line<C: Effect + Clone>(
        &self,
        name: impl Into<String>,
        formula: impl Into<String>,
        number: f64,
        candidate: &C,
        of: &str,
    ) -> Result<EffectLine>;
}

impl<E: Effect + Clone> CardLine for NeglectedEffects<'_, E> {
    fn line<C: Effect + Clone>(
        &self,
        name: impl Into<String>,
        formula: impl Into<String>,
        number: f64,
        candidate: &C,
        of: &str,
    ) -> Result<EffectLine> {
        let weighed = self.predict(candidate, number)?;
        let measured = self.measure(candidate)?;
        let line = effect(name).number(formula, number);
        Ok(line.weighed(&weighed, &measured, of, self.tolerance()))
    }
}

impl EffectLine {
    /// With what [`NeglectedEffects`] has found.
    fn weighed(
        self,
        weighed: &PredictedError,
        measured: &Measured,
        of: &str,
        tolerance: f64,
    ) -> Self {
        let torques = |work: Work| match work.torques() {
            0 => "closed form".into(),
            torques => format!("{torques} torques"),
        };
        let [without, with] = measured.work.map(torques);
        let order =
            if weighed.linear && weighed.number.abs() <= SMALL { "" } else { ", to first order" };
        let mut line = self
            .costs(weighed.predicted, format!("{of}{order}"))
            .at_cost(format!("{without}, {with}"));
        line.entry.beyond = !weighed.linear;
        line.asked = Some(tolerance);
        // Of an effect that is not small the first order need not hold.
        let within = if weighed.linear { measured.within } else { f64::INFINITY };
        line.measured(measured.error).within(within)
    }
}

impl Entry for EffectLine {
    fn enter(self, report: &mut Report) -> Result<()> {
        if let Some(asked) = self.asked {
            report.ask(asked)?;
        }
        report.add_effect(self.entry)
    }
}

impl Entry for Table {
    fn enter(self, report: &mut Report) -> Result<()> {
        report.add_table(self)
    }
}

impl Entry for Price {
    fn enter(self, report: &mut Report) -> Result<()> {
        report.add_price(self);
        Ok(())
    }
}

/// The methods that a reader may try.
impl Entry for Lab {
    fn enter(self, report: &mut Report) -> Result<()> {
        report.set_lab(self);
        Ok(())
    }
}

/// Several of a kind.
impl<E: Entry> Entry for Vec<E> {
    fn enter(self, report: &mut Report) -> Result<()> {
        self.into_iter().try_for_each(|entry| entry.enter(report))
    }
}
