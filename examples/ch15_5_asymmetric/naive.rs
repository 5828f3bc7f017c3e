//! Euler's equations stepped along the tangent: energy grows, and the book flips that never
//! would.

use super::*;
use core::iter::successors;
use rotation_dynamics::integrators::Rk4;
use rotation_dynamics::integrators::foils::SemiImplicitEuler;
use rotation_dynamics::math::DoubleDouble;

/// How far the book's L is off its middle axis, towards the largest: 0.57 rad from that.
pub const NAIVE_TILT: f64 = 1.0;

impl Naive {
    /// The page's run: the book, so many steps a second.
    pub fn of_the_page(steps: f64) -> Self {
        let Tumble { moments, start, .. } = book();
        Self { moments, rates: start, step: 1.0 / steps }
    }
}

/// The book, on a polhode about its largest axis.
pub fn book() -> Tumble {
    let p = Parameters::default();
    let moments = box_moments(p.mass, [p.length, p.width, p.thickness]);
    Tumble::new(moments, p.rate, NAIVE_TILT, 2)
}

/// L^2 - 2 E I2: positive about the largest axis, negative about the least.
fn side(moments: [f64; 3], rates: [f64; 3]) -> f64 {
    let term = |i: usize| moments[i] * (moments[i] - moments[1]) * rates[i] * rates[i];
    term(0) + term(2)
}

/// Twice the energy of the book.
fn energy(rates: [f64; 3]) -> f64 {
    let moments = book().moments;
    (0..3).map(|i| moments[i] * rates[i] * rates[i]).sum()
}

/// How many steps of a run are on one side.
fn kept<S>(run: impl Iterator<Item = S>, inside: impl Fn(&S) -> bool) -> f64 {
    run.take_while(inside).take(100_000).count() as f64
}

/// When the run at so many steps a second leaves the polhodes about the largest axis: when `side`
/// changes its sign. It is the product of `u` and `v`, which each step only multiplies, by 1 + x
/// and 1 - x; as a difference of squares it soon has no digit left.
fn crossing(steps: f64) -> f64 {
    let Naive { moments, rates, .. } = Naive::of_the_page(steps);
    let ([i1, i2, i3], [p, q, r]) = (moments, rates);
    let [_, growth, _] = small_motions(moments, 1.0);
    let (first, third) = ((i1 * (i2 - i1)).sqrt(), (i3 * (i3 - i2)).sqrt());
    let slope = (i3 - i1) / (4.0 * i2 * first * third);
    let start = [third * r - first * p, third * r + first * p, q];
    let next = |&[u, v, q]: &[f64; 3]| {
        let x = growth * q / steps;
        Some([u * (1.0 + x), v * (1.0 - x), q + slope * (v * v - u * u) / steps])
    };
    kept(successors(Some(start), next), |[u, v, _]| u * v > 0.0) / steps
}

/// The same in double-double, with the rates about the first two axes and `side` itself, which
/// each step multiplies by 1 - x^2; the third rate is what they leave.
fn crossing_by_side(steps: f64) -> f64 {
    let Naive { moments, rates, .. } = Naive::of_the_page(steps);
    let ([i1, i2, i3], [p, q, r]) =
        (moments.map(DoubleDouble::from), rates.map(DoubleDouble::from));
    let (first, third) = (i1 * (i2 - i1), i3 * (i3 - i2));
    let shrinks = (i2 - i1) * (i3 - i2) / (i1 * i3 * steps * steps);
    let start = [p, q, third * r.square() - first * p.square()];
    let next = |&[p, q, side]: &[DoubleDouble; 3]| {
        let r = ((side + first * p.square()) / third).sqrt();
        let [to_p, to_q] = [(i2 - i3) / i1 * q * r, (i3 - i1) / i2 * r * p];
        Some([p + to_p / steps, q + to_q / steps, side * (1.0 - shrinks * q.square())])
    };
    kept(successors(Some(start), next), |[.., side]| *side > 0.0) / steps
}

/// The same method in the library's foil: the rates after so many steps.
fn after_of_the_foil(steps: f64, count: u64) -> Result<[f64; 3]> {
    let (tumble, scene) = (book(), Scene::new(book().body()?));
    let start = tumble.free_body()?.state(0.0);
    let (end, _) =
        SemiImplicitEuler::new(count)?.advance(&scene, 0.0, &start, count as f64 / steps)?;
    Ok(scene.body().angular_velocity(&end).to_array())
}

/// The step in which the foil crosses, near this time.
fn crossing_of_the_foil(steps: f64, near: f64) -> Result<f64> {
    let crossed =
        |count| Ok::<_, kit::Error>(side(book().moments, after_of_the_foil(steps, count)?) <= 0.0);
    // Its products are rounded in another order: a few steps to either side.
    let first = (near * steps) as u64 - 5;
    for count in first..first + 10 {
        if crossed(count + 1)? && !crossed(count)? {
            return Ok((count + 1) as f64 / steps);
        }
    }
    Ok(f64::NAN)
}

/// How fast the energy of the naive run grows, as a part of it, over the step (1/s^2): each
/// step adds the square of its slope. Averaged over the true motion.
fn gain() -> Result<f64> {
    let (tumble, count) = (book(), 200_u32);
    let law = euler(tumble.moments);
    // A periodic function: equal weights.
    let each = sampled(times(0.0, tumble.between_flips()?, count).skip(1), |t| {
        Ok(energy(law.derivative(0.0, &tumble.rates(t)?)))
    })?;
    Ok(each.iter().sum::<f64>() / f64::from(count) / energy(tumble.start))
}

/// The same, measured over half a period of the rates with short steps.
fn gain_measured() -> Result<f64> {
    let (whole, count) = (book().between_flips()?, 100_000);
    let mut run = Naive::of_the_page(count as f64 / whole);
    let step = run.step;
    let end = run.nth(count - 1).unwrap_or([f64::NAN; 3]);
    Ok((energy(end) / energy(book().start) - 1.0) / (whole * step))
}

/// The part of its energy that RK4 loses on the same motion in half a minute.
fn lost_by_rk4(steps: u64) -> Result<f64> {
    let (tumble, method) = (book(), Rk4::new(steps * 30)?);
    let (end, _) = method.advance(&euler(tumble.moments), 0.0, &tumble.start, 30.0)?;
    Ok(1.0 - energy(end) / energy(tumble.start))
}

/// What the page says of the naive solver.
pub fn claims(_: &Parameters, report: &mut Report) -> Result<()> {
    let [coarse, fine] = [60.0, 240.0].map(crossing);
    // When doubles that form the difference see its sign change: rounding decides.
    let ours = |rates: &[f64; 3]| side(book().moments, *rates) > 0.0;
    let rounded = (kept(Naive::of_the_page(240.0), ours) + 1.0) / 240.0;
    let (gain, lost) = (gain()?, lost_by_rk4(60)?);
    let grown = |rates| energy(rates) / energy(book().start);
    let naive = Naive::of_the_page(60.0).nth(119).unwrap_or([f64::NAN; 3]);
    let foil = after_of_the_foil(60.0, 120)?;
    claims! { report,
        /// RK4: part of the energy lost in half a minute, sixty steps a second
        rk4_loss: lost, "-", "32 times that of half the step" => 32.0 * lost_by_rk4(120)?, within 0.05 * lost;
        /// naive: growth of the energy over the step
        naive_gain: gain, "1/s^2", "measured with short steps" => gain_measured()?, within 1e-3 * gain;
        /// naive: energy after two seconds over the true, sixty steps a second
        naive_energy: grown(naive), "-", "library's foil" => grown(foil), within 1e-9;
        /// naive: leaves its polhodes, sixty steps a second
        naive_crosses: coarse, "s", "library's foil" => crossing_of_the_foil(60.0, coarse)?, within 1.5 / 60.0;
        /// the same, 240 steps a second
        naive_crosses_later: fine, "s", "double-double, other variables" => crossing_by_side(240.0), within 1.0 / 240.0;
        /// the same where doubles form the difference from two squares, and rounding decides
        naive_rounded: rounded, "s", "library's foil" => crossing_of_the_foil(240.0, rounded)?, within 4.0 / 240.0;
    }
}
