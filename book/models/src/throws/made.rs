//! A recording that is made up, what it says, and what the page claims of that.

use super::{Thrown, coarse};
use kit::recording::made::{Format, Made, Motion};
use kit::{Asked, Figure, Prepared, Recorded, Report, Result, claims};
use std::sync::Arc;

/// The moments of the phone that is made up, on the axes x, y, z.
pub(super) const MOMENTS: [f64; 3] = [4.1, 1.0, 4.9];

/// Its rates at the release of two throws (rad/s): about the short edge, about the long one.
pub(super) const RELEASES: [[f64; 3]; 2] = [[16.0, 3.5, 0.6], [0.5, 21.0, 0.8]];

/// How long each is in the air (s).
pub(super) const FLIGHT: f64 = 0.8;

/// Two throws, as phyphox exports them; nothing if they cannot be made.
pub fn made() -> String {
    let (releases, drag) = (RELEASES.to_vec(), 0.0);
    let motion = Motion::Throws { moments: MOMENTS, releases, flight: FLIGHT, drag };
    // A battery that is not in the middle turns the axes.
    let (turn, accelerometer) = ([0.0, 0.0, 0.06], Some([0.02, 0.05, 0.0]));
    let made = Made { motion, turn, accelerometer, ..Made::default() };
    made.text(Format::Phyphox).unwrap_or_default()
}

/// What the made-up recording says.
struct Told {
    recorded: Recorded,
    /// I_x/I_z and I_y/I_z, each with the half of its interval.
    ratios: [[f64; 2]; 2],
    /// How coarse is too coarse, by two routes (1/s).
    coarse: [f64; 2],
}

/// The same for all parameters of a page.
fn told() -> Result<Arc<Told>> {
    static TOLD: Prepared<(), Told> = Prepared::new();
    TOLD.get(&(), |()| {
        let thrown = Thrown::read("made-up.csv", made().as_bytes(), &Asked::default())?;
        let ratio =
            |i| thrown.fit.ratio(i, 2).map_or([f64::NAN; 2], |r| [r.value, 0.5 * (r.to - r.from)]);
        Ok(Told {
            ratios: [ratio(0), ratio(1)],
            coarse: [coarse::too_coarse(0.01)?, coarse::too_coarse_by_squares(0.01)?],
            recorded: thrown.recorded(None)?,
        })
    })
}

/// The figures of the made-up recording.
///
/// # Errors
/// Those of the fit and of the drawings.
pub fn figures() -> Result<Vec<Figure>> {
    told()?.recorded.all_figures()
}

/// What it says, against what it was made with; how coarse a recording may be. A section of a report, the
/// same for all parameters.
///
/// # Errors
/// Those of the fit, and a number that is contradicted.
pub fn report<P>(_: &P, report: &mut Report) -> Result<()> {
    let told = told()?;
    let ([xz, yz], [fine, squares], [x, y, z]) = (told.ratios, told.coarse, MOMENTS);
    claims! { report,
        /// made-up recording: moment about the short edge over that about the normal
        recorded_xz: xz[0], "-", "what it was made with" => x / z, within xz[1];
        /// made-up recording: moment about the long edge over that about the normal
        recorded_yz: yz[0], "-", "what it was made with" => y / z, within yz[1];
        /// what the recording was made with, about the short edge
        made_xz: x / z, "-", "its inverse" => 1.0 / (z / x), within 1e-15;
        /// what it was made with, about the long edge
        made_yz: y / z, "-", "its inverse" => 1.0 / (z / y), within 1e-15;
        /// samples a second below which averaging shifts I_y/I_x by more than one per cent
        coarse: fine, "1/s", "square of the time, from 400 a second" => squares, within 0.02 * fine;
    }?;
    for name in ["table throws", "table found", "table corrections"] {
        let table = told.recorded.report.section(name)?;
        table.map_or(Ok(()), |table| report.add(table))?;
    }
    report.add(coarse::table()?)
}
