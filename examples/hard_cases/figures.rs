//! The drawings: a method that breaks, and beside it the form that holds.

use super::naive::*;
use super::rotations::*;
use super::*;
use kit::draw::Marker;
use rotation_dynamics::math::sort_by_number;

/// Below it a logarithmic axis draws an error as this: no double has a smaller one of 1.
const FLOOR: f64 = 1e-17;

/// Powers of ten, so many in each decade.
fn decades(from: i32, to: i32, each: i32) -> impl Iterator<Item = f64> {
    let step = 1.0 / f64::from(each);
    (0..=(to - from) * each).map(move |n| pow(10.0, f64::from(from) + step * f64::from(n)))
}

/// Errors over one quantity, a curve for each method.
fn errors<const N: usize>(
    xs: impl IntoIterator<Item = f64>,
    errors: impl Fn(f64) -> Result<[f64; N]>,
) -> Result<[Vec<(f64, f64)>; N]> {
    let mut curves = [const { Vec::new() }; N];
    for x in xs {
        for (curve, error) in curves.iter_mut().zip(errors(x)?) {
            if error.is_finite() {
                curve.push((x, error.max(FLOOR)));
            }
        }
    }
    Ok(curves)
}

/// What breaks and what holds.
fn pair(
    panel: Panel,
    xs: impl IntoIterator<Item = f64>,
    both: impl Fn(f64) -> Result<[f64; 2]>,
    labels: [&str; 2],
) -> Result<Panel> {
    let [wrong, held] = errors(xs, both)?;
    let wrong = Curve::new(wrong, Ink::Wrong).dashed();
    let held = Curve::new(held, Ink::Ink).label(labels[1]);
    Ok(panel.curve(wrong.label(labels[0])).curve(held))
}

/// The errors of an attitude by a naive method, and of the closed form.
fn ends(motion: &Motion, naive: impl Fn(&Motion) -> Option<Attitude>) -> Result<[f64; 2]> {
    let closed = motion.in_closed_form()?;
    Ok([naive(motion), Some(closed)].map(|end| motion.off(end)))
}

/// The naive error of a case, and that of its last answer; one that is refused leaves a gap.
fn across(Answered(_, (_, naive), answers): Answered) -> Result<[f64; 2]> {
    let last = answers.last().and_then(|(answer, _)| answer.as_ref().ok());
    Ok([naive, last.copied().unwrap_or(f64::NAN)])
}

/// A top whose energy is so little above the least: the smaller turning point by the formula for
/// the roots of a cubic, and by the library. The truth by Newton's method in pairs of doubles.
fn turning_points(excess: f64) -> Result<[f64; 2]> {
    let [a, b, c] = NOTES_TOP;
    let top = ReducedTop::new(a, b, c)?;
    let (_, lowest) = top.minimum();
    let energy = lowest + excess * lowest.abs();
    let theta = HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0)?.theta_min();
    let naive = turning_point([a, b, c], energy);
    let (root_a, one) = (DoubleDouble::from(a).sqrt(), DoubleDouble::from(1.0));
    let mut u = DoubleDouble::from(theta).sin_cos().1;
    for _ in 0..60 {
        // (1 - u^2) (2 E + 2 c - 2 c u) - a (b - u)^2 and its slope.
        let (rest, lift) = (one - u.square(), DoubleDouble::from(energy) + c - u * c);
        let across = root_a * (DoubleDouble::from(b) - u);
        let value = rest * lift * 2.0 - across.square();
        let slope = u * lift * -4.0 - rest * (2.0 * c) + across * root_a * 2.0;
        u -= value / slope;
    }
    let off = |theta: f64| {
        let (sin, cos) = DoubleDouble::from(theta).sin_cos();
        ((cos - u) / sin).to_f64().abs()
    };
    Ok([off(naive), off(theta)])
}

/// A torque switched on and off.
fn jumps(panel: Panel) -> Result<Panel> {
    let over = decades(1, 4, 8).map(f64::round);
    let [on, rk4, gauss] = errors(over, |n| Ok(torques::across_jumps(n as u64)?))?;
    let on = Curve::new(on, Ink::Wrong).dashed();
    Ok(panel
        .curve(on.label("wrong: RK4 straight on"))
        .curve(Curve::new(rk4, Ink::RungeKutta).label("RK4 anew"))
        .curve(Curve::new(gauss, Ink::Gauss).label("Gauss–Legendre anew")))
}

/// Two moments this far from equal: the body called symmetric below 1e-6, the first moment
/// changed by 1e-9, and the closed form.
fn nearly_symmetric(panel: Panel) -> Result<Panel> {
    let [called, jittered, closed] = errors(decades(-15, -3, 6), |apart| {
        let motion = shaped([1.0, 1.0 + apart, 1.7])?;
        let equal = shaped([1.0, 1.0, 1.7])?;
        let called = if apart < 1e-6 { equal } else { motion };
        let [jittered, closed] = ends(&motion, jittered)?;
        Ok([motion.off(called.in_closed_form().ok()), jittered, closed])
    })?;
    let called = Curve::new(called, Ink::Wrong).dashed();
    let jittered = Curve::new(jittered, Ink::Wrong).dotted();
    Ok(panel
        .curve(called.label_at("wrong: called equal", 2e-13, 1e-13, Side::Right))
        .curve(jittered.label("wrong: made unequal"))
        .curve(Curve::new(closed, Ink::Ink).label("closed form")))
}

/// How much a change of the start by so much moves the end, over that change: a body that
/// turns about its middle axis for 100 s.
fn condition_by_difference(panel: Panel) -> Result<Panel> {
    let end = |off: f64| findings::off_the_middle(off)?.in_closed_form();
    let still = end(0.0)?;
    let moved = |off: f64| Ok(end(off)?.angle_to(&still) / off);
    Ok(panel.upright(1e-12, Ink::Wrong, "once felt here").curve(Curve::sampled(
        decades(-26, -2, 3),
        moved,
        Ink::Ink,
    )?))
}

/// What a step of length z over the rate multiplies a spin by, that is braked: RK4 and exact.
fn factor(panel: Panel) -> Panel {
    let over = || times(0.0, 3.2, 80);
    let rk4 = Curve::of(over(), stability::factor, Ink::Wrong);
    panel
        .level(1.0, Ink::Frame, "")
        .curve(Curve::of(over(), |z| exp(-z), Ink::Ink).label("exact"))
        .curve(rk4.dashed().label("RK4"))
}

fn errors_over(x: &str) -> Panel {
    Panel::over_axes(Axis::log(x), Axis::log("error / rad"))
}

fn parts_over(x: &str) -> Panel {
    Panel::over_axes(Axis::log(x), Axis::log("relative error").range(FLOOR, 10.0))
}

figures! { p: &Parameters;
    /// The relative error of 1 - cos x against x, both logarithmic. As it stands it grows as
    /// 1/x^2, to one below 1e-8; written as twice the square of a sine it stays at 1e-16.
    digits: pair(parts_over("$x$"), decades(-9, 0, 12), |x| {
            let truth = DoubleDouble::from(0.5 * x).sin_cos().0.square() * 2.0;
            let sine = sin(0.5 * x);
            Ok([1.0 - cos(x), 2.0 * sine * sine].map(|y| ((truth - y) / truth).to_f64().abs()))
        }, ["wrong: $1-\\cos x$", r"$2\sin^2(x/2)$"])?;

    /// The error after 20 s against the distance from the pole at the start, both logarithmic.
    /// The one of RK4 on Euler angles jumps about, up to a thousandth of a radian, and is a rounding
    /// only next to the pole; that of the closed form is one everywhere.
    poles: pair(errors_over(r"$\theta_0$ / rad"), decades(-10, -1, 4),
        |theta| ends(&at_pole(turned(0.3, theta, 0.0)?, [0.1, 0.0, 2.0]), |m| on_euler_angles(m, POLE_STEPS)),
        ["wrong: Euler angles", "closed form"])?;

    /// The relative error of a tilt against the tilt, both logarithmic. By an arc cosine it grows
    /// to one at 1e-8 rad; by the arc tangent of two lengths it is a rounding everywhere.
    tilt: pair(parts_over(r"$\theta$ / rad"), decades(-9, 0, 12), |theta| {
            let tilted = turned(0.3, theta, 0.2)?;
            let tilts = [by_arc_cosine(tilted).unwrap_or(tilted), tilted].map(|a| a.euler_angles().theta);
            Ok(tilts.map(|tilt| (tilt / theta - 1.0).abs()))
        }, ["wrong: arc cosine", "arc tangent"])?;

    /// The error after one flip against 1 - k^2, both logarithmic. By subtraction it grows as one over
    /// 1 - k^2, to one at 1e-16; that of the closed form stays small.
    separatrix: pair(errors_over("$1-k^2$"), decades(-16, -2, 4), |complement| {
            // The direction of L on the body's axes.
            let motion = one_flip(complement)?;
            let closed = motion.free_body()?.angular_velocity(motion.end).to_array();
            Ok([momentum_off(&motion, rates_by_landau(&motion))?, momentum_off(&motion, closed)?])
        }, ["wrong: subtracted", "closed form"])?;

    /// The error against the number of periods of two flips, both logarithmic. That of RK4 grows
    /// until it is of order one; that of the closed form stays a rounding.
    flips: pair(errors_over("periods"), decades(0, 3, 2).map(|n| n + 0.25), |periods| {
            let whole = flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
            let motion = whole.until(whole.end * periods / FLIPS_PERIODS);
            ends(&motion, |m| on_quaternion(m, (200.0 * periods) as u32))
        }, ["wrong: RK4", "closed form"])?;

    /// The error of a turning point against how far the energy is above the least, both logarithmic.
    /// By the formula for the roots of a cubic it grows to 1e-8; by the library it stays small.
    tops: pair(errors_over("energy over its least, less one"), decades(-15, -1, 4), turning_points,
        ["wrong: a cubic", "as a distance"])?;

    /// The error against the number of periods, 1 to 1e12, both logarithmic. The one of the time
    /// modulo a rounded period grows in proportion; the one of the closed form stays a rounding.
    late: pair(errors_over("periods"), decades(0, 12, 1), |periods| {
            let (motion, _, modulo) = late(periods, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?;
            ends(&motion, |_| Some(modulo))
        }, ["wrong: $t$ mod $T$", "closed form"])?;

    /// The error against the number of steps through a torque that is switched on and off, both
    /// logarithmic. RK4 is ragged and falls about as one over the number, also where it is started
    /// anew at each jump; Gauss-Legendre, started anew, is at round-off.
    jumps: jumps(errors_over("steps"))?;

    /// The error after 30 s against how far two moments are from equal, both logarithmic. Called
    /// equal below 1e-6 it grows in proportion up to 1e-5; with a moment changed by 1e-9 it is
    /// level at 1e-8; that of the closed form is a rounding everywhere.
    shapes: nearly_symmetric(errors_over("$I_2/I_1-1$"))?;

    /// The error after 5 s against the needle's moment along it, both logarithmic. With the rates
    /// from the angular momentum it rises steeply to one and ends where there is no number; that of
    /// the closed form is a rounding.
    needle: pair(errors_over("$I_3/I_1$"), decades(-9, 0, 4),
        |thin| ends(&shaped([1.0, 1.0, thin])?.until(5.0), |m| by_momentum(m, 5000)),
        ["wrong: from $L$", "closed form"])?;

    /// The error of a quaternion against how far a rotation is from half a turn, both logarithmic.
    /// From the trace it grows as one over it, to 1e-8, and ends at 1e-8; from the largest component it is a rounding.
    turns: pair(errors_over("half a turn less this / rad"), decades(-9, 0, 8), |off| {
            let turned = Attitude::about_space_axis(SpaceVector::new(1.0, -2.0, 3.0), PI - off)?;
            let naive = by_trace(turned).map_or(f64::NAN, |a| a.angle_to(&turned));
            Ok([naive, MATRIX(turned)?.angle_to(&turned)])
        }, ["wrong: by the trace", "largest component"])?;

    /// The error after 30 rad against the size of the moments, both logarithmic. With 1e-30 added it
    /// falls in proportion above 1e-29, and is of order one below; without, it is a rounding.
    scales: pair(errors_over("moment / (kg m²)"), decades(-46, 0, 2), |moment| {
            // Where the guard is less than a rounding, nothing is wrong and nothing drawn.
            let [naive, closed] = ends(&scaled(moment, 1.0)?, guarded)?;
            Ok([if naive > EPS { naive } else { f64::NAN }, closed])
        }, ["wrong: guarded", "closed form"])?;

    /// How much the end moves over how much the start was moved, against the latter, both
    /// logarithmic. For changes below 1e-20 it is level at 1e19; for larger ones it falls in
    /// proportion. A mark stands at 1e-12, where it is 1e12.
    findings: condition_by_difference(Panel::over_axes(Axis::log("change of the start"), Axis::log("magnified")))?;

    /// The error of the end against the depth of a graze, both logarithmic. Looked at every 0.03 s
    /// it is from a third of a millimetre to centimetres; with the event located it is a rounding, growing as the graze
    /// gets shallow.
    events: pair(Panel::over_axes(Axis::log("excess speed / (m/s)"), Axis::log("error / m")),
        decades(-9, -1, 3), |excess| across(events::graze(excess)?), ["wrong: every 0.03 s", "located"])?;

    /// The relative error of the speed after an impact against the ratio of the masses, both
    /// logarithmic. From the energy it is smallest for equal masses and reaches one on either side;
    /// by the impulse it is a rounding.
    impacts: pair(Panel::over_axes(Axis::log("mass that hits / mass that is hit"), Axis::log("relative error")),
        decades(-16, 15, 2).map(|m| 2.0 * m), |mass| across(impacts::hit(mass, 1.0)?), ["wrong: from the energy", "impulse"])?;

    /// What a step multiplies a braked spin by, against rate times step. The exact factor falls to
    /// zero; that of RK4 follows it to about one, turns, and crosses one at 2.785.
    stability: factor(Panel::over_axes(r"$\lambda h$", "factor of a step"));

    /// For each family the errors over their bounds, logarithmic: all methods in all
    /// representations left of one, the naive method of each case right of it.
    table: overview(p)?;
}

/// The nearest of eight places in a decade: what falls on one another is drawn once.
fn apart(x: f64) -> f64 {
    const EACH: f64 = 8.0;
    let decade = log(10.0);
    exp((EACH * log(x) / decade).round() * decade / EACH)
}

/// A line for each family: what holds left of one, what breaks right of it.
fn overview(p: &Parameters) -> Result<Panel> {
    let computed = computed(p)?;
    let (mut held, mut naive, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (i, one) in computed.iter().enumerate() {
        let y = (computed.len() - i) as f64;
        names.push((y, one.family.key));
        for row in &one.rows {
            let parts = row.cells.iter().filter_map(table::Cell::part);
            held.extend(parts.map(|part| (apart(part.max(1e-8)), y)));
            naive.push((apart(row.broken().clamp(1e-8, 1e16)), y));
        }
    }
    for points in [&mut held, &mut naive] {
        sort_by_number(points, |point| point.0);
        sort_by_number(points, |point| -point.1);
        points.dedup();
    }
    let lines = computed.len() as f64;
    Ok(Panel::over_axes(
        Axis::log("error over its bound").range(1e-8, 1e16),
        Axis::linear("").range(0.3, lines + 0.7).ticks(names),
    )
    .size(340, 60 + 26 * computed.len() as u32)
    .upright(1.0, Ink::Ink, "bound")
    .curve(Curve::new(held, Ink::Ink).faint(0.5).dots())
    .curve(Curve::new(naive, Ink::Wrong).marker(Marker::Square).dots()))
}
