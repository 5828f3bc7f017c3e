//! Scenes made to break `solve`, and what becomes of them.

pub mod hostile;
pub mod kinked;
pub mod laws;
pub mod resisted;
pub mod truth;

use super::Dice;
use rotation_dynamics::accuracy::Solved;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::{Error, Result};
use std::collections::BTreeMap;

/// A scene, what `solve` makes of it, and its true end.
pub struct Case {
    pub kind: &'static str,
    pub text: String,
    pub solve: Box<dyn Fn(f64) -> Result<Solved>>,
    pub exact: Attitude,
}

/// Every scene is asked for two of these, which differ from scene to scene.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// What became of the requests of a kind.
#[derive(Default)]
pub struct Tally {
    /// Errors of what was granted, as parts of the request.
    pub ratios: Vec<f64>,
    /// Refusals, by their reason.
    pub refused: BTreeMap<&'static str, usize>,
}

impl Tally {
    fn quantile(&self, part: f64) -> f64 {
        let last = self.ratios.len().saturating_sub(1);
        let at = (part * last as f64).round() as usize;
        self.ratios.get(at).copied().unwrap_or(0.0)
    }
}

/// The reason of a refusal, if it is one that `solve` may give.
fn reason(error: &Error) -> Option<&'static str> {
    Some(match error {
        Error::NotDelivered { condition: Some(_), .. } => "beyond the condition",
        Error::NotDelivered { condition: None, .. } => "not delivered",
        Error::LimitReached { what: "torques", .. } => "over the budget",
        Error::Contradiction { .. } => "contradiction",
        Error::Sliding { .. } => "sliding",
        _ => return None,
    })
}

/// What became of each kind, and what exceeds its request or is refused for no good reason.
pub type Attacked = (BTreeMap<&'static str, Tally>, Vec<String>);

/// Scenes first to last, of so many kinds.
pub fn attacked(
    scenes: std::ops::Range<u64>,
    kinds: u64,
    case: impl Fn(u64) -> Result<Case>,
) -> Result<Attacked> {
    let mut tallies: BTreeMap<&str, Tally> = BTreeMap::new();
    let mut failures = Vec::new();
    for n in scenes {
        let Case { kind, text, solve, exact } = case(n)?;
        let tally = tallies.entry(kind).or_default();
        let first = (n / kinds) as usize;
        for tolerance in [first, first + 3].map(|k| TOLERANCES[k % TOLERANCES.len()]) {
            match solve(tolerance) {
                Ok(solved) => {
                    let ratio = exact.angle_to(&solved.state.attitude) / tolerance;
                    tally.ratios.push(ratio);
                    if ratio.is_nan() || ratio > 1.0 {
                        failures.push(format!(
                            "{kind} {n}, {tolerance:e}: {ratio:e} times, {solved:?} {text}"
                        ));
                    }
                }
                Err(error) => match reason(&error) {
                    Some(reason) => *tally.refused.entry(reason).or_default() += 1,
                    None => failures.push(format!("{kind} {n}, {tolerance:e}: {error} {text}")),
                },
            }
        }
    }
    for tally in tallies.values_mut() {
        tally.ratios.sort_by(f64::total_cmp);
    }
    Ok((tallies, failures))
}

fn table(tallies: &BTreeMap<&str, Tally>) -> String {
    let mut lines =
        vec!["kind                  granted  median   0.99     largest  refused".to_owned()];
    for (kind, tally) in tallies {
        let [median, most, largest] = [0.5, 0.99, 1.0].map(|part| tally.quantile(part));
        let refused: Vec<String> =
            (tally.refused.iter()).map(|(reason, count)| format!("{count} {reason}")).collect();
        lines.push(format!(
            "{kind:<22}{:>7}  {median:.1e}  {most:.1e}  {largest:.1e}  {}",
            tally.ratios.len(),
            refused.join(", ")
        ));
    }
    lines.join("\n")
}

/// Prints what came of an attack.
pub fn told((tallies, failures): &Attacked) {
    println!("{}", table(tallies));
    println!("{} above the request\n{}", failures.len(), failures.join("\n"));
}

/// How many were granted, and refused; none may be above its request.
pub fn held(attacked: &Attacked) -> [usize; 2] {
    told(attacked);
    let (tallies, failures) = attacked;
    assert!(failures.is_empty());
    let sum = |count: fn(&Tally) -> usize| tallies.values().map(count).sum();
    let refused = |tally: &Tally| tally.refused.values().sum();
    [sum(|tally| tally.ratios.len()), sum(refused)]
}

/// The largest error of what was granted, as a part of its request.
pub fn largest((tallies, _): &Attacked) -> f64 {
    let all = tallies.values().flat_map(|tally| &tally.ratios);
    all.copied().fold(0.0, f64::max)
}
