//! Which method: what each does on the first stretch of the motion.

use super::method::{LEVEL, Method};
use super::stepping::{SWEEPS, Stepping, is_final, stops};
use super::verdict::APART;
use crate::error::{Error, Result};
use crate::math::{EPS, exp, log, sort_by_number};

/// All runs of the span together cost about so many times the one that delivers.
const RUNS: f64 = 2.5;

/// The error aimed at, as a part of the tolerance: what the last run is predicted to deliver.
pub(super) const AIM: f64 = 0.02;

/// The methods of a motion, the cheapest first, and what is wanted of them.
pub(super) struct Candidates {
    pub all: Vec<Candidate>,
    /// Those whose trial could not have paid.
    pub untried: Vec<Method>,
    /// The part of the span that the stretch is.
    pub part: f64,
    /// The error (rad) on the stretch that is predicted to deliver.
    pub wanted: f64,
    /// The smallest floor, in units of eps (1 + condition).
    pub lowest: f64,
}

/// A method, and what it did on the first stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Candidate {
    pub method: Method,
    /// At this level it made this error (rad) at this cost.
    pub level: f64,
    pub error: f64,
    pub cost: f64,
}

impl Candidate {
    /// The level at which it makes this error on the stretch.
    pub fn level(&self, error: f64) -> f64 {
        self.level + log(self.error / error) / LEVEL
    }

    /// The error that it makes on the stretch at this level.
    pub fn error(&self, level: f64) -> f64 {
        self.error * exp(LEVEL * (self.level - level))
    }

    /// What that costs.
    pub fn cost(&self, error: f64) -> f64 {
        self.cost * self.method.dearer(self.level(error) - self.level)
    }
}

impl Stepping<'_> {
    /// The candidates: each runs twice on the first stretch of the motion, and the
    /// distance of its two ends is its error constant; but for those whose trial would cost
    /// more than they can save.
    ///
    /// # Errors
    /// Why the last of them failed, if all did.
    pub(super) fn candidates(&mut self) -> Result<Candidates> {
        let methods = Method::candidates(self.problem);
        let (part, whole) = (self.part, self.problem.span());
        // Errors grow with the time at least.
        let wanted = AIM * self.tolerance * part;
        let lowest = (methods.iter())
            .map(|method| method.floor(self.problem))
            .fold(f64::INFINITY, f64::min);
        let mut found = Candidates {
            all: Vec::new(),
            untried: Vec::new(),
            part,
            wanted,
            lowest,
        };
        let mut why = None;
        for method in methods {
            let best = (found.all.iter()).min_by(|a, b| a.cost(wanted).total_cmp(&b.cost(wanted)));
            if let Some(best) = best {
                let [least, trial] = method.prospect(self.problem, part * whole, wanted, best);
                if (best.cost(wanted) - least) * RUNS < trial * part {
                    found.untried.push(method);
                    continue;
                }
            }
            match self.tried(method, part) {
                Ok(candidate) => found.all.push(candidate),
                Err(error) if is_final(&error) => return Err(error),
                Err(error) => why = Some(error),
            }
        }
        match why {
            Some(error) if found.all.is_empty() => Err(error),
            _ => {
                sort_by_number(&mut found.all, |candidate| candidate.cost(wanted));
                Ok(found)
            }
        }
    }

    /// What the method does on the stretch.
    pub(super) fn tried(&mut self, method: Method, part: f64) -> Result<Candidate> {
        let precision = (SWEEPS * self.tolerance * part).min(1e-6);
        let t = self.problem.t_start;
        let times = [t, t + part * self.problem.span()];
        // Where the error of order 16 shows.
        let mut level = if method.sweeps() {
            method.coarsest()
        } else {
            0.0
        };
        let mut why = Error::NotDelivered {
            requested: self.tolerance,
            reached: f64::INFINITY,
        };
        while level + 1.0 <= method.finest() {
            let two = self
                .run(method, &times, level, &[], precision)
                .and_then(|coarse| {
                    let fine = self.next(method, &times, &coarse, 1.0, precision)?;
                    Ok((coarse, fine))
                });
            match two {
                Ok((coarse, fine)) => {
                    let error = self.distance(&coarse, &fine)[0];
                    // Not so for a NaN.
                    if error < APART {
                        return Ok(Candidate {
                            method,
                            level: coarse.level,
                            error: error.max(EPS) / method.grown(part),
                            cost: method.cost(self.problem, &coarse.work),
                        });
                    }
                }
                Err(error) if stops(&error) => return Err(error),
                Err(error) => why = error,
            }
            level += 2.0;
        }
        Err(why)
    }
}
