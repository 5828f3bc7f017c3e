//! The drawings: a method that breaks, and beside it the form that holds.

use super::forms::Form;
use super::long::Late;
use super::motions::{By, Motion};
use super::naive::{
    by_arc_cosine, on_euler_angles, on_quaternion, path_by_momentum, rates_by_landau,
    tilt_by_energy,
};
use super::{Parameters, flips, poles, separatrix, table::Cell, tops, torques};
use core::f64::consts::FRAC_PI_3;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::math::DoubleDouble;
use rotation_dynamics::report::draw::{Camera, Marker};
use rotation_dynamics::report::prelude::*;

/// Below it a logarithmic axis draws an error as this: no double has a smaller one of 1.
const FLOOR: f64 = 1e-17;

/// Powers of ten, so many in each decade.
fn decades(from: i32, to: i32, each: i32) -> impl Iterator<Item = f64> {
    let step = 1.0 / f64::from(each);
    (0..=(to - from) * each).map(move |n| pow(10.0, f64::from(from) + step * f64::from(n)))
}

/// What breaks and what holds, over one quantity; a pair of errors at each place.
fn pair(
    panel: Panel,
    xs: impl IntoIterator<Item = f64>,
    errors: impl Fn(f64) -> Result<[f64; 2]>,
    labels: [&str; 2],
) -> Result<Panel> {
    let (mut wrong, mut held) = (Vec::new(), Vec::new());
    for x in xs {
        let [naive, ours] = errors(x)?;
        if naive.is_finite() {
            wrong.push((x, naive.max(FLOOR)));
        }
        held.push((x, ours.max(FLOOR)));
    }
    let wrong = Curve::new(wrong, Ink::Wrong).dashed().label(labels[0]);
    let held = Curve::new(held, Ink::Ink).label(labels[1]);
    Ok(panel.curve(wrong).curve(held))
}

fn closed(motion: &Motion) -> Result<Attitude> {
    motion.reached(By::ClosedForm, Form::Quaternion, 0.0)
}

/// 1 - cos x as it stands and as 2 sin^2(x/2): relative errors.
fn one_less_cosine(x: f64) -> [f64; 2] {
    let half = DoubleDouble::from(0.5 * x).sin_cos().0;
    let truth = half.square() * 2.0;
    let sine = sin(0.5 * x);
    [1.0 - cos(x), 2.0 * sine * sine].map(|y| ((truth - y) / truth).to_f64().abs())
}

/// A small tilt by the arc cosine, and by the arc tangent of the library: relative errors.
fn small_tilt(theta: f64) -> Result<[f64; 2]> {
    let (phi, zeta) = (0.3, 0.2);
    let tilted = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let tilts = [by_arc_cosine(tilted).unwrap_or(tilted), tilted].map(|a| a.euler_angles().theta);
    Ok(tilts.map(|tilt| (tilt / theta - 1.0).abs()))
}

/// So far from the pole at the start: RK4 on Euler angles, and the closed form.
fn beside_the_pole(theta: f64) -> Result<[f64; 2]> {
    let motion = poles::top(poles::tilted(theta)?, [0.1, 0.0, 2.0]);
    let naive = motion.off(on_euler_angles(&motion, poles::STEPS));
    Ok([naive, motion.off(Some(closed(&motion)?))])
}

/// After so many periods of two flips.
fn after_flips(periods: f64) -> Result<[f64; 2]> {
    let whole = flips::flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
    let end = whole.end * periods / flips::PERIODS;
    let motion = Motion { end, ..whole };
    let naive = on_quaternion(&motion, (200.0 * periods) as u32);
    Ok([motion.off(naive), motion.off(Some(closed(&motion)?))])
}

fn after_periods(periods: f64) -> Result<[f64; 2]> {
    let late = Late::after(periods, [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?;
    let reached = [late.modulo, closed(&late.motion)?];
    Ok(reached.map(|end| late.motion.off(Some(end))))
}

/// The middle rate through one flip, 1 - k^2 = 1e-16: by Landau's formulas, and exact.
fn flip(panel: Panel) -> Result<Panel> {
    let motion = separatrix::one_flip(1e-16)?;
    let rates = BodyVector::from_array(motion.rates);
    let exact = FreeBody::new(motion.body()?, motion.attitude, rates)?;
    let end = motion.end;
    let naive = |t: f64| rates_by_landau(&Motion { end: t, ..motion })[1];
    let truth = |t: f64| exact.angular_velocity(t).y();
    Ok(panel
        .curve(Curve::of(times(0.0, end, 300), truth, Ink::Ink).label("exact"))
        .curve(
            Curve::of(times(0.0, end, 300), naive, Ink::Wrong)
                .dashed()
                .label("wrong: $1-k^2$ subtracted"),
        ))
}

/// A torque switched on and off.
fn jumps(panel: Panel) -> Result<Panel> {
    let mut curves = [const { Vec::new() }; 3];
    for n in decades(1, 4, 8).map(f64::round) {
        for (curve, error) in curves.iter_mut().zip(torques::across_jumps(n as u64)?) {
            curve.push((n, error.max(FLOOR)));
        }
    }
    let [on, rk4, gauss] = curves;
    Ok(panel
        .curve(
            Curve::new(on, Ink::Wrong)
                .dashed()
                .label("wrong: RK4 straight on"),
        )
        .curve(Curve::new(rk4, Ink::RungeKutta).label("RK4 anew"))
        .curve(Curve::new(gauss, Ink::Gauss).label("Gauss–Legendre anew")))
}

/// The tilt of a top let go at rest: by the square root of the energy, and exact.
fn cusps(panel: Panel) -> Result<Panel> {
    let at = |end: f64| tops::released([1.5, 0.25], FRAC_PI_3, end);
    let truth = |t: f64| Ok(closed(&at(t)?)?.euler_angles().theta);
    let naive = |t: f64| Ok(tilt_by_energy(&at(t)?, 200));
    Ok(panel
        .note(
            20.0,
            FRAC_PI_3,
            Ink::Wrong,
            "wrong: by the energy",
            Side::Below,
        )
        .curve(Curve::sampled(times(0.0, 40.0, 240), truth, Ink::Ink)?.label("exact"))
        .curve(Curve::sampled(times(0.0, 40.0, 40), naive, Ink::Wrong)?.dashed()))
}

fn errors_over(x: &str) -> Panel {
    Panel::over_axes(Axis::log(x), Axis::log("error / rad"))
}

figures! { p: &Parameters;
    /// The relative error of 1 - cos x against x, both logarithmic. As it stands it grows as
    /// 1/x^2, to one below 1e-8; written as twice the square of a sine it stays at 1e-16.
    digits: pair(Panel::over_axes(Axis::log("$x$"), Axis::log("relative error").range(FLOOR, 10.0)),
        decades(-9, 0, 12), |x| Ok(one_less_cosine(x)),
        ["wrong: $1-\\cos x$", r"$2\sin^2(x/2)$"])?;

    /// The error after 20 s against the distance from the pole at the start, both logarithmic.
    /// The one of RK4 on Euler angles jumps about and rises towards the pole; that of the closed
    /// form is a rounding everywhere.
    poles: pair(errors_over(r"$\theta_0$ / rad"), decades(-10, -1, 4), beside_the_pole,
        ["wrong: Euler angles", "closed form"])?;

    /// The relative error of a tilt against the tilt, both logarithmic. By an arc cosine it grows
    /// to one at 1e-8 rad; by the arc tangent of two lengths it is a rounding everywhere.
    tilt: pair(Panel::over_axes(Axis::log(r"$\theta$ / rad"), Axis::log("relative error").range(FLOOR, 10.0)),
        decades(-9, 0, 12), small_tilt, ["wrong: arc cosine", "arc tangent"])?;

    /// The middle rate through a flip with 1 - k^2 = 1e-16 against time. The exact one stays at 1,
    /// falls to -1 near the end, and stays there. The one of the naive formula does not.
    flip: flip(Panel::over_axes("$t$ / s", Axis::linear(r"$\Omega_2$ / (rad/s)").range(-1.2, 1.2)))?;

    /// The error against the number of periods of two flips, both logarithmic. That of RK4 grows
    /// until it is of order one; that of the closed form stays a rounding.
    flips: pair(errors_over("periods"), decades(0, 3, 2).map(|n| n + 0.25), after_flips,
        ["wrong: RK4", "closed form"])?;

    /// The tilt of a top let go at rest against time. It nods; the one that is stepped by the
    /// square root of the energy stays where it is.
    cusps: cusps(Panel::over_axes("$t$ / s", Axis::linear(r"$\theta$ / rad").range(0.95, 1.4)))?;

    /// The error against the number of periods, 1 to 1e12, both logarithmic. The one of the time
    /// modulo a rounded period grows in proportion; the one of the closed form stays a rounding.
    late: pair(errors_over("periods"), decades(0, 12, 1), after_periods,
        ["wrong: $t$ mod $T$", "closed form"])?;

    /// The error against the number of steps through a torque that is switched on and off, both
    /// logarithmic. RK4 is ragged and falls about as one over the number, also where it is started
    /// anew at each jump; Gauss-Legendre, started anew, is at round-off.
    jumps: jumps(errors_over("steps"))?;

    /// For each family the errors over their bounds, logarithmic: all methods in all
    /// representations left of one, the naive method of each case right of it.
    table: overview(p)?;
}

/// A line for each family: what holds left of one, what breaks right of it.
fn overview(p: &Parameters) -> Result<Panel> {
    let computed = super::computed(p)?;
    let (mut held, mut naive, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (i, one) in computed.iter().enumerate() {
        let y = (computed.len() - i) as f64;
        names.push((y, one.family.key));
        for row in &one.rows {
            let parts = row.cells.iter().filter_map(Cell::part);
            held.extend(parts.map(|part| (part.max(1e-8), y)));
            naive.push((row.broken().clamp(1e-8, 1e16), y));
        }
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

/// A book that turns exactly about its middle axis: it must do so for ever.
fn thrown() -> Result<Motion> {
    let (phi, theta, zeta) = (1.0, 0.5, 2.0);
    let start = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    Ok(Motion::free([1.0, 2.0, 2.5], start, [0.0, 1.0, 0.0], 240.0))
}
const STEPS: u32 = 2400;

/// When the book that RK4 turns lies across its axis for the first time (s).
pub fn first_flip() -> Result<f64> {
    let motion = thrown()?;
    let path = path_by_momentum(&motion, STEPS)?;
    let turned = path.iter().position(|(_, middle)| *middle < 0.0);
    let steps = turned.map_or(f64::NAN, |n| n as f64);
    Ok(motion.end / f64::from(STEPS) * steps)
}

/// The book by RK4 (dashed outline) beside the true one.
pub fn moving_picture(_: &Parameters) -> Result<MovingPicture> {
    let motion = thrown()?;
    let exact = FreeBody::new(
        motion.body()?,
        motion.attitude,
        BodyVector::from_array(motion.rates),
    )?;
    let path = path_by_momentum(&motion, STEPS)?;
    let h = motion.end / f64::from(STEPS);
    let middle = |t: f64| exact.angular_velocity(t).y();
    let naive = path
        .iter()
        .enumerate()
        .map(|(n, (_, middle))| (h * n as f64, *middle));
    let graph = Panel::over_axes(
        "$t$ / s",
        Axis::linear(r"$\Omega_2$ / (rad/s)")
            .range(-1.1, 1.6)
            .step(1.0),
    )
    .curve(Curve::of(times(0.0, motion.end, 600), middle, Ink::Ink).label("exact"))
    .curve(Curve::new(naive, Ink::Wrong).dashed().label("wrong: RK4"));
    MovingPicture::above(graph, 0.0..=motion.end, [40.0, 85.0, 120.0], move |t| {
        let (naive, _) = path[((t / h).round() as usize).min(path.len() - 1)];
        let truth = exact.attitude(t);
        let alt = format!(
            "A book after {t:.0} s of turning about its middle axis, and dashed the one that RK4 gives, {:.1} rad off; \
             below, the rates about the middle axis against time.",
            truth.angle_to(&naive)
        );
        let sides = [
            (-0.45, -0.6),
            (0.45, -0.6),
            (0.45, 0.6),
            (-0.45, 0.6),
            (-0.45, -0.6),
        ];
        let outline = sides.map(|(x, y)| naive.to_space(BodyVector::new(x, y, 0.09)));
        let edges = [(0.9, 0.0, 0.0), (0.0, 1.2, 0.0), (0.0, 0.0, 0.16)]
            .map(|(x, y, z)| truth.to_space(BodyVector::new(x, y, z)));
        let zero = SpaceVector::zero();
        let nail = |a: Attitude| a.to_space(BodyVector::new(0.0, 0.95, 0.0));
        let scene = View::of(zero, 1.1)
            .camera(Camera::new(0.5, 0.35))
            .solid(Solid::cuboid(zero, edges), Ink::Body)
            .arrow(zero, nail(truth), Ink::Body, "exact", Side::Right)
            .dashed(outline, Ink::Wrong)
            .arrow(zero, nail(naive), Ink::Wrong, "wrong", Side::Left);
        Ok((alt, scene))
    })
}
