//! Next to the motion that needs for ever: the middle axis, and the top that just gets up.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{jacobi, on_euler_angles, rates_by_landau};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{atan2, atanh, cos, log, tan, tanh};

pub const FAMILY: Family = Family {
    key: "separatrix",
    title: "At the separatrix",
    cure: "1 - k^2 is formed from the small rates themselves, never as a difference from 1",
    methods: &By::names(By::FREE),
    forms: &Form::NAMES,
    rows,
};

/// Moments for which a separatrix goes through round numbers: omega_1 = 2 omega_3.
const MOMENTS: [f64; 3] = [3.0, 4.0, 6.0];

fn start() -> Result<Attitude> {
    Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })
}

pub fn free(rates: [f64; 3], end: f64) -> Result<Motion> {
    Ok(Motion::free(MOMENTS, start()?, rates, end))
}

/// The angle between the angular momentum on the body's axes with these rates and the true one.
pub fn off(motion: &Motion, rates: [f64; 3]) -> Result<f64> {
    let momentum = |rates: [f64; 3]| {
        let [a, b, c]: [f64; 3] = core::array::from_fn(|i| MOMENTS[i] * rates[i]);
        BodyVector::new(a, b, c)
    };
    let (one, truth) = (momentum(rates), momentum(motion.true_rates()?));
    Ok(atan2(one.cross(&truth).norm(), one.dot(&truth)))
}

fn by_landau(motion: &Motion) -> Result<Naive> {
    Ok(Naive {
        method: "Jacobi's functions with 1 - k^2 by subtraction",
        error: off(motion, rates_by_landau(motion))?,
    })
}

/// From the middle axis, the third rate off: 1 - k^2 = 4.5 of its square.
pub fn one_flip(complement: f64) -> Result<Motion> {
    let off: f64 = (complement / 4.5_f64).sqrt();
    // The flip comes when the small rate, growing as exp(t/3), is of order one.
    let flip = 3.0 * log(2.0 / off);
    free([0.0, 1.0, off], flip + 6.0)
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for (words, complement) in [
        (
            [
                "1 - k^2 = 1e-8, one flip",
                "the flip is late by the logarithm of 1 - k^2",
            ],
            1e-8,
        ),
        (
            [
                "1 - k^2 = 1e-12, one flip",
                "of which a difference from 1 keeps four digits",
            ],
            1e-12,
        ),
        (["1 - k^2 = 1e-16, one flip", "and here none"], 1e-16),
    ] {
        let motion = one_flip(complement)?;
        rows.push(motion.row(words, &By::FREE, by_landau(&motion)?)?);
    }
    let motion = free([0.0, 1.0, 0.0], 20.0)?;
    let words = [
        "exactly about the middle axis",
        "any rounding is a kick, and grows as exp(t/3)",
    ];
    rows.push(motion.row(words, &By::FREE, by_landau(&motion)?)?);
    // On the separatrix itself: 3 (4 - 3) omega_1^2 = 6 (6 - 4) omega_3^2 to the last bit.
    let motion = free([0.5, 1.0, 0.25], 15.0)?;
    let words = [
        "1 - k^2 = 0, between the ends",
        "K is infinite, and sn, cn, dn are no longer periodic",
    ];
    rows.push(motion.row(words, &By::FREE, by_mean(&motion)?)?);
    let motion = free([-0.5, 1.0, 0.25], 15.0)?;
    let words = [
        "1 - k^2 = 0, its other half",
        "a rate that goes as cn, and changes sign, goes as sech here",
    ];
    rows.push(motion.row(words, &By::FREE, turned_back(&motion)?)?);

    // A top at the energy and the momentum of the upright one, on its way up and not yet there.
    let (moments, theta) = ([1.0, 0.25], 2.0);
    let spin = 2.0;
    let across = moments[1] * spin * tan(0.5 * theta);
    let lost = 2.0 * (1.0 - cos(theta));
    let along = -(lost - across * across).sqrt();
    let tilted = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta,
        zeta: 0.0,
    })?;
    let top = |end: f64| Motion::top(moments, 1.0, tilted, [along, across, spin], end);
    for (words, end) in [
        (
            [
                "homoclinic top, after 8 s",
                "it comes to the vertical in an infinite time",
            ],
            8.0,
        ),
        (
            [
                "homoclinic top, after 16 s",
                "and the rounding of its start decides on which side it falls",
            ],
            16.0,
        ),
    ] {
        let motion = top(end);
        let naive = Naive {
            method: "RK4 on Euler angles, 2000 steps",
            error: motion.off(on_euler_angles(&motion, 2000)),
        };
        rows.push(motion.row(words, &By::FREE, naive)?);
    }
    Ok(rows)
}

/// sn at k = 1 by the descent of the arithmetic-geometric mean, which has no bottom there, and
/// the hyperbolic tangent that it is.
fn by_mean(motion: &Motion) -> Result<Naive> {
    let [p, q, r] = motion.rates;
    let [i1, i2, i3] = MOMENTS;
    // The largest middle rate, and the phase at the start and at the end.
    let largest = ((i1 * p * p + i2 * q * q + i3 * r * r) / i2).sqrt();
    let phase = atanh(q / largest) + largest * motion.end / 3.0;
    let [sn, ..] = jacobi(phase, 1.0);
    Ok(Naive {
        method: "Jacobi's functions by the arithmetic-geometric mean",
        error: (sn - tanh(phase)).abs(),
    })
}

/// Where cn is negative the phase is counted back from half a period, 2K - u: of K = ln(4/k')
/// with k' = 0 nothing is left to count.
fn turned_back(motion: &Motion) -> Result<Naive> {
    let [p, q, r] = motion.rates;
    let [i1, i2, i3] = MOMENTS;
    let largest = ((i1 * p * p + i2 * q * q + i3 * r * r) / i2).sqrt();
    let complement = 1.0 - (i3 * (i3 - i2) * r * r) / (i1 * (i2 - i1) * p * p);
    let half = 2.0 * log(4.0 / complement.sqrt());
    let phase = half - atanh(-q / largest) + largest * motion.end / 3.0;
    let [_, middle, _] = motion.true_rates()?;
    Ok(Naive {
        method: "the phase counted back from half a period",
        error: (largest * tanh(half - phase) - middle).abs(),
    })
}
