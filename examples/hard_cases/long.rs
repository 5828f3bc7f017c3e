//! A trillion periods.

use super::forms::Form;
use super::motions::{By, Motion};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::motion::Motion as _;

pub const FAMILY: Family = Family {
    key: "long",
    title: "A trillion periods",
    cure: "phases are counted in turns of thirty digits; a time is reduced before it is rounded",
    methods: &By::names(By::CLOSED),
    forms: &Form::NAMES,
    rows,
};

pub const PERIODS: f64 = 1e12;

/// A free body after many periods, and where it is if whole periods are dropped in doubles.
pub struct Late {
    pub motion: Motion,
    pub exact: FreeBody,
    pub modulo: Attitude,
}

impl Late {
    /// After so many periods and three tenths of one.
    pub fn after(periods: f64, moments: [f64; 3], rates: [f64; 3]) -> Result<Self> {
        let attitude = Attitude::from_euler(EulerAngles {
            phi: 0.3,
            theta: 0.8,
            zeta: 0.2,
        })?;
        let of = |end: f64| Motion::free(moments, attitude, rates, end);
        let exact = FreeBody::new(of(0.0).body()?, attitude, BodyVector::from_array(rates))?;
        let period = exact.rate_period();
        let motion = of(periods * period + 0.3 * period);
        let (count, rest) = ((motion.end / period).floor(), motion.end % period);
        let turn = Attitude::about_space_axis(
            exact.angular_momentum(),
            (count * exact.precession_per_period()) % core::f64::consts::TAU,
        )?;
        let modulo = turn * exact.attitude(rest);
        Ok(Self {
            motion,
            exact,
            modulo,
        })
    }
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for (words, moments, rates) in [
        (
            [
                "three moments",
                "a period rounded once is a trillion times wrong",
            ],
            [1.0, 2.0, 2.5],
            [0.8, 0.4, 0.3],
        ),
        (
            [
                "near the separatrix, 1 - k^2 = 2e-5",
                "the same, and the period is hard to have",
            ],
            [1.0, 2.0, 2.5],
            [0.0, 1.0, 2e-3],
        ),
        (
            ["two moments", "the same of two circular motions"],
            [1.0, 1.0, 1.7],
            [0.8, 0.4, 0.3],
        ),
    ] {
        let Late {
            motion,
            exact,
            modulo,
        } = Late::after(PERIODS, moments, rates)?;
        let naive = Naive {
            method: "t modulo the period, in doubles",
            error: motion.off(Some(modulo)),
        };
        // The inputs are what they are: what a period may do is all that is granted.
        let condition = exact.condition(exact.rate_period())?;
        rows.push(motion.row_of_condition(words, &By::CLOSED, naive, [condition; 2])?);
    }
    Ok(rows)
}
