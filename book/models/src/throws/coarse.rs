//! How coarse a recording may be: by fits to a made-up throw that is sampled coarser and coarser.

use super::made::{FLIGHT, MOMENTS, RELEASES};
use kit::recording::made::{Made, Motion};
use kit::{Result, Table, short};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::fit::{Fit, Flight};
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::inertia::PrincipalMoments;

/// The ratio of the moments about the long and the short edge, which tells most of a phone.
const TOLD: [usize; 2] = [1, 0];

/// The throw about the short edge, without noise, as a sensor shows it that gives so many means a second:
/// each is that of the rates since the one before.
fn averaged(frequency: f64) -> Result<Fit> {
    let [i1, i2, i3] = MOMENTS;
    let body = PrincipalMoments::new(i1, i2, i3)?;
    let body = FreeBody::new(body, Attitude::IDENTITY, BodyVector::from(RELEASES[0]))?;
    // Gauss's rule of three points.
    let points = [
        (0.5 - 0.15_f64.sqrt(), 5.0 / 18.0),
        (0.5, 8.0 / 18.0),
        (0.5 + 0.15_f64.sqrt(), 5.0 / 18.0),
    ];
    let mean = |end: f64| {
        let at =
            |(part, weight): (f64, f64)| body.angular_velocity(end - part / frequency) * weight;
        points.map(at).iter().fold(BodyVector::zero(), |sum, rates| sum + *rates)
    };
    let times: Vec<f64> =
        (1..=(FLIGHT * frequency) as u32).map(|k| f64::from(k) / frequency).collect();
    let rates = times.iter().map(|t| DesignVector::from(mean(*t).to_array()));
    Ok(Flight::new(times.clone(), rates.collect())?.fit(&[])?)
}

/// By how much the ratio of [`TOLD`] is off then, relative.
fn off(frequency: f64) -> Result<f64> {
    let [i, j] = TOLD;
    let told = averaged(frequency)?.ratio(i, j).map_or(f64::NAN, |ratio| ratio.value);
    Ok(told * MOMENTS[j] / MOMENTS[i] - 1.0)
}

/// So many samples a second at which averaging shifts the ratio by this part.
///
/// # Errors
/// Those of the fit.
pub(super) fn too_coarse(part: f64) -> Result<f64> {
    // It goes with the square of the time, nearly.
    let mut frequency = 60.0;
    for _ in 0..6 {
        frequency *= (off(frequency)?.abs() / part).sqrt();
    }
    Ok(frequency)
}

/// The same by the square of the time alone, from a fine sampling.
///
/// # Errors
/// Those of the fit.
pub(super) fn too_coarse_by_squares(part: f64) -> Result<f64> {
    Ok(400.0 * (off(400.0)?.abs() / part).sqrt())
}

/// Half the interval of the ratio, relative, of a noisy recording of so many samples a second.
fn open(frequency: f64) -> Result<f64> {
    let motion =
        Motion::Throws { moments: MOMENTS, releases: vec![RELEASES[0]], flight: FLIGHT, drag: 0.0 };
    let made = Made { motion, frequency, ..Made::default() };
    let [begin, end] = made.motion.flights()[0];
    let samples = made.samples()?;
    let pairs = samples.times.iter().zip(&samples.rates).filter(|(t, _)| (begin..end).contains(*t));
    let (times, rates): (Vec<f64>, Vec<_>) =
        pairs.map(|(t, w)| (*t, DesignVector::from(*w))).unzip();
    let ratio = Flight::new(times, rates)?.fit(&[])?.ratio(TOLD[0], TOLD[1]);
    Ok(ratio.map_or(f64::NAN, |ratio| 0.5 * (ratio.to - ratio.from) / ratio.value))
}

/// The table `coarse`.
///
/// # Errors
/// Those of the fits.
pub(super) fn table() -> Result<Table> {
    let columns = [
        "samples a second",
        "in the flight",
        "off by averaging",
        "interval, by noise of 0.02 rad/s",
    ];
    Table::of("coarse", columns, [400.0, 200.0, 100.0, 50.0, 25.0], |frequency: f64| {
        Ok([
            frequency.to_string(),
            ((FLIGHT * frequency) as u32).to_string(),
            format!("{} %", short(100.0 * off(frequency)?.abs(), 2)),
            format!("± {} %", short(100.0 * open(frequency)?, 2)),
        ])
    })
}
