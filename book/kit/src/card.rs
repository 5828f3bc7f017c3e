//! The card of effects: what a scene has in and leaves out, and what it calls for.

use super::claim::Claim;
use super::number::short;
use super::sections::EFFECTS;
use super::table::{Table, check_cell};
use crate::error::{Error, Result, finite};
use rotation_dynamics::accuracy::MARGIN;

/// The accuracy at which a card says in or out, where its page asks for none.
pub(super) const ASKED: f64 = 1e-2;

/// An effect whose number is larger is not small: a prediction to first order in it need not
/// hold.
pub(super) const SMALL: f64 = 0.1;

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
    /// What that is an error of, or its unit and where: `"of the period"`, `"rad a turn"`,
    /// `"m/s at the end"`; `"-"` if nothing is to be said.
    pub unit: String,
    /// The key of the claim whose size that error is compared with, if it is not the first in
    /// its unit.
    pub beside: Option<String>,
    /// The same error from a simulation with the effect and one without it, where one was made.
    pub measured: Option<f64>,
    /// The error of that itself.
    pub within: f64,
    /// What a simulation costs without it and with it, in words, where it was counted:
    /// `"closed form, 812 torques"`.
    pub cost: Option<String>,
    /// Whether the scene includes it.
    pub included: bool,
    /// Whether its prediction is too large to be believed: such an effect is called for at any
    /// accuracy.
    pub beyond: bool,
}

impl EffectEntry {
    pub(super) fn check(&self) -> Result<()> {
        finite("the number of an effect", self.value)?;
        finite("the error of leaving out an effect", self.error)?;
        [&self.effect, &self.number, &self.unit]
            .into_iter()
            .chain(&self.cost)
            .try_for_each(|cell| check_cell(cell))?;
        self.measured.map_or(Ok(()), |measured| self.predicts(measured))
    }

    /// That what is measured of a small effect is what is predicted, within a factor 2.
    fn predicts(&self, measured: f64) -> Result<()> {
        finite("the measured error of leaving out an effect", measured)?;
        let larger = self.error.abs().max(measured.abs());
        let bound = larger * (1.0 - 1.0 / MARGIN);
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

    /// Whether the accuracy `asked` for calls for it, with the tolerance where that is neither a
    /// part of what the line names nor an angle in radians: `"out"`, `"in, 0.063 rad/s"`.
    fn verdict(&self, asked: f64, claims: &[Claim]) -> Result<String> {
        let (tolerance, unit) = self.tolerance(asked, claims)?;
        let noticed = self.beyond || MARGIN * self.error.abs() > tolerance;
        let word = if noticed { "in" } else { "out" };
        Ok(match unit {
            None => word.into(),
            Some("-") => format!("{word}, {}", short(tolerance, 2)),
            Some(unit) => format!("{word}, {} {unit}", short(tolerance, 2)),
        })
    }

    /// The accuracy `asked` for, in the unit of the error, and that unit where it is to be told.
    fn tolerance<'a>(&self, asked: f64, claims: &'a [Claim]) -> Result<(f64, Option<&'a str>)> {
        let begins = |unit: &str| {
            let rest = self.unit.strip_prefix(unit);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', ',', ':']))
        };
        let of = |claim: &'a Claim| (asked * claim.value.abs(), Some(claim.unit.as_str()));
        if let Some(key) = &self.beside {
            let claim = claims.iter().find(|claim| claim.key == *key);
            return claim.map(of).ok_or_else(|| Error::UnknownKey {
                key: key.clone(),
                known: claims.iter().map(|claim| claim.key.as_str()).collect::<Vec<_>>().join(", "),
            });
        }
        if self.unit == "-" || begins("of") || begins("rad") {
            return Ok((asked, None));
        }
        if begins("deg") {
            return Ok((asked.to_degrees(), Some("deg")));
        }
        // "kg m^2/s" begins with "kg" as well: the longest unit counts, of those the first.
        let mut found: Option<&Claim> = None;
        for claim in claims.iter().filter(|claim| begins(&claim.unit)) {
            if found.is_none_or(|best| claim.unit.len() > best.unit.len()) {
                found = Some(claim);
            }
        }
        found.map(of).ok_or_else(|| Error::Text {
            text: format!("{}: {}", self.effect, self.unit),
            allowed: "an error on the card is a part of something, an angle, or in the unit of a \
                      claim, beside whose value it is large or small",
        })
    }
}

/// The card as a table; in or out at the accuracy `asked` for.
pub(super) fn table(effects: &[EffectEntry], claims: &[Claim], asked: f64) -> Result<Table> {
    // Two columns stand only where a line has something to say in them.
    let measured = effects.iter().any(|e| e.measured.is_some());
    let counted = effects.iter().any(|e| e.cost.is_some());
    let mut columns = ["effect", "number", "value", "error if left out"].map(String::from).to_vec();
    columns.extend(measured.then(|| "measured".into()));
    columns.extend(counted.then(|| "cost: without, with".into()));
    columns.extend(["here".into(), format!("at {asked:e}")]);
    let mut table = Table::headed(EFFECTS, columns)?;
    for e in effects {
        e.check()?;
        let error = short(e.error, 2);
        let mut row = vec![
            e.effect.clone(),
            e.number.clone(),
            short(e.value, 2),
            match e.unit.as_str() {
                "-" => error,
                unit => format!("{error} {unit}"),
            },
        ];
        let dash = || "-".to_string();
        row.extend(measured.then(|| e.measured.map_or_else(dash, |m| short(m, 2))));
        row.extend(counted.then(|| e.cost.clone().unwrap_or_else(dash)));
        row.push(if e.included { "in" } else { "left out" }.into());
        row.push(e.verdict(asked, claims)?);
        table.push(row)?;
    }
    Ok(table)
}
