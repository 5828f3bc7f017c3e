//! Every kind of registers gives the bits of one number at a time.

use super::*;
use crate::math::{STEEPEST, sincos_turns, sinh_cosh_of};

/// Every operation of a lane, and every operation of its pairs.
struct Probe;

impl Sampler<6> for Probe {
    fn sample<L: Phased>(&self, t: L, _: usize) -> [L; 6] {
        let (sin, cos) = sincos_turns(t);
        let pair = L::Pair::new(t, sin) * L::Pair::both(&[0.3, -1.7]);
        let (first, second) = (pair.swapped() - pair).parts();
        [
            sin,
            -cos.abs(),
            (t * t + 0.1).sqrt() / (t - 0.3),
            t.leading() * first,
            second,
            sinh_cosh_of((t * 20.0).within(STEEPEST)).0,
        ]
    }
}

type Bits = [u64; 6];

fn bits(sample: [f64; 6]) -> Bits {
    sample.map(f64::to_bits)
}

fn probed<'a, S: Sampler<6>>(
    sampler: &'a S,
    times: &'a [f64],
    found: &'a mut Vec<Bits>,
) -> impl Work + 'a {
    EachTime::<_, _, 6> { sampler, times, put: |sample| found.push(bits(sample)) }
}

fn in_lanes<L: Phased>(sampler: &impl Sampler<6>, times: &[f64]) -> Vec<Bits> {
    let mut found = Vec::new();
    probed(sampler, times, &mut found).run::<L>();
    found
}

/// In every width that this processor has.
fn in_each_width(sampler: &impl Sampler<6>, times: &[f64]) -> Vec<Vec<Bits>> {
    let common = [
        in_lanes::<f64>(sampler, times),
        in_lanes::<Both<f64>>(sampler, times),
        in_lanes::<Two>(sampler, times),
        in_lanes::<CommonEight>(sampler, times),
    ];
    common.into_iter().chain(in_wider_registers(sampler, times)).collect()
}

#[cfg(target_arch = "x86_64")]
fn in_wider_registers(sampler: &impl Sampler<6>, times: &[f64]) -> Vec<Vec<Bits>> {
    let mut found = Vec::new();
    if std::is_x86_feature_detected!("avx2") {
        let mut wide = Vec::new();
        // SAFETY: just detected.
        unsafe { x86::avx2(probed(sampler, times, &mut wide)) };
        found.push(wide);
    }
    if std::is_x86_feature_detected!("avx512f") {
        let mut wide = Vec::new();
        // SAFETY: just detected.
        unsafe { x86::avx512(probed(sampler, times, &mut wide)) };
        found.push(wide);
    }
    found
}

#[cfg(not(target_arch = "x86_64"))]
fn in_wider_registers(_: &impl Sampler<6>, _: &[f64]) -> Vec<Vec<Bits>> {
    Vec::new()
}

/// For any length of the list.
#[test]
fn every_width_gives_the_scalar_bits() {
    let mut compared = 0;
    for length in 0..300 {
        let times: Vec<f64> = (0..length).map(|k| f64::from(k) * 0.37 - 20.0).collect();
        let expected: Vec<Bits> = times.iter().map(|t| bits(Probe.sample(*t, 0))).collect();
        for found in in_each_width(&Probe, &times) {
            assert_eq!(found, expected);
            compared += found.len();
        }
    }
    assert!(compared >= 4 * 44_850, "only {compared} samples compared");
}

/// The damaged twin: had a product been fused with the sum after it, these times would tell.
#[test]
fn a_fused_product_would_be_seen() {
    let fused = |t: f64| libm::sqrt(libm::fma(t, t, 0.1)) / (t - 0.3);
    let times = (0..300).map(|k| f64::from(k) * 0.37 - 20.0);
    let differ = times.filter(|t| fused(*t).to_bits() != bits(Probe.sample(*t, 0))[2]);
    assert_eq!(differ.count(), 25);
}

/// A number kept within bounds, six bounds.
struct Kept;

impl Sampler<6> for Kept {
    fn sample<L: Phased>(&self, t: L, _: usize) -> [L; 6] {
        [0.5, 1.0, 2.0, 3.0, 1e300, STEEPEST].map(|bound| t.within(bound))
    }
}

/// A value that is no number is none within any bound either, in whatever lane.
#[test]
fn no_number_stays_none_within_bounds() {
    let mut compared = 0;
    for place in 0..8 {
        let mut times = [-2.5, 0.0, -0.0, 0.7, f64::INFINITY, f64::NEG_INFINITY, 1e9, -0.5];
        times[place] = f64::NAN;
        for found in in_each_width(&Kept, &times) {
            for (t, kept) in times.iter().zip(found) {
                let expected = Kept.sample(*t, 0);
                for (kept, expected) in kept.map(f64::from_bits).into_iter().zip(expected) {
                    let same = kept.to_bits() == expected.to_bits();
                    assert!(same || (kept.is_nan() && t.is_nan()), "{t}: {kept}");
                    assert_eq!(kept.is_nan(), t.is_nan(), "{t}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 4 * 8 * 8 * 6, "only {compared} compared");
}

/// The lanes are added as the trait says: halves, then halves of that.
#[test]
fn sums_are_taken_in_one_order() {
    let values: [f64; 8] = core::array::from_fn(|k| 1.0 / (k as f64 + 3.0));
    let [a, b, c, d, e, f, g, h] = values;
    let expected = ((a + e) + (c + g)) + ((b + f) + (d + h));
    assert_eq!(CommonEight::load(&values).sum(), expected);
    assert_eq!(<Both<Both<Both<f64>>>>::load(&values).sum(), expected);
    let one_by_one: f64 = values.iter().sum();
    assert_ne!(one_by_one, expected);
}
