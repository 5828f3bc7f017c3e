//! The drawings: a method that breaks, and beside it the form that holds.

use super::forms::Form;
use super::long::Late;
use super::motions::{By, Motion};
use super::naive::{
    by_arc_cosine, on_euler_angles, on_quaternion, path_of_yaw_pitch_roll, rates_by_landau,
    tilt_by_energy,
};
use super::{Parameters, flips, poles, separatrix, table::Cell, tops, torques};
use core::f64::consts::{FRAC_PI_3, PI};
use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
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

/// The tilt of a top let go at rest: by the square root of the energy, and exact.
fn cusps(panel: Panel) -> Result<Panel> {
    let at = |end: f64| tops::released([1.5, 0.25], FRAC_PI_3, end);
    let truth = |t: f64| Ok(closed(&at(t)?)?.euler_angles().theta);
    let naive = |t: f64| Ok(tilt_by_energy(&at(t)?, 200));
    Ok(panel
        .curve(Curve::sampled(times(0.0, 40.0, 240), truth, Ink::Ink)?.label("exact"))
        .curve(
            Curve::sampled(times(0.0, 40.0, 40), naive, Ink::Wrong)?
                .dashed()
                .label("wrong: by the energy"),
        ))
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
    poles: pair(errors_over(r"$\theta_0$ / rad"), decades(-10, -1, 1), beside_the_pole,
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
    cusps: cusps(Panel::over_axes("$t$ / s", Axis::linear(r"$\theta$ / rad")))?;

    /// The error against the number of periods, 1 to 1e12, both logarithmic. The one of the time
    /// modulo a rounded period grows in proportion; the one of the closed form stays a rounding.
    late: pair(errors_over("periods"), decades(0, 12, 1), after_periods,
        ["wrong: $t$ mod $T$", "closed form"])?;

    /// The error of RK4 against the number of steps through a torque that is switched on and off,
    /// both logarithmic: ragged and about as one over the number where steps cross the jumps, as
    /// its fourth power to round-off where it is started anew at each.
    jumps: pair(errors_over("steps"), decades(1, 4, 6).map(f64::round), |n| torques::across_jumps(n as u64),
        ["wrong: straight on", "anew at each jump"])?;

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
    .size(480, 60 + 26 * computed.len() as u32)
    .upright(1.0, Ink::Ink, "bound")
    .curve(Curve::new(held, Ink::Ink).faint(0.5).dots())
    .curve(Curve::new(naive, Ink::Wrong).marker(Marker::Square).dots()))
}

/// A plate that turns once in 2 pi seconds about its axis 2, for two turns.
const LOOPS: f64 = 4.0 * PI;
const LOOP_STEPS: u32 = 240;

/// It starts level with a roll of 0.02 rad, so that its nose passes the zenith by as much.
fn looping() -> Result<Motion> {
    let level = Attitude::from_yaw_pitch_roll(YawPitchRoll {
        yaw: 0.3,
        pitch: 0.0,
        roll: 0.02,
    })?;
    Ok(Motion::free([1.0, 2.0, 1.5], level, [0.0, 1.0, 0.0], LOOPS))
}

/// Where it is.
fn looped(motion: &Motion, t: f64) -> Result<Attitude> {
    Ok(motion.attitude * Attitude::about_body_axis(BodyVector::new(0.0, 1.0, 0.0), t)?)
}

/// The plate by yaw, pitch and roll (dashed) beside the true one.
pub fn moving_picture(_: &Parameters) -> Result<MovingPicture> {
    let motion = looping()?;
    let path = path_of_yaw_pitch_roll(&motion, LOOP_STEPS);
    let h = LOOPS / f64::from(LOOP_STEPS);
    let mut off = Vec::new();
    for (n, naive) in path.iter().enumerate() {
        let t = h * n as f64;
        let naive = naive.unwrap_or(Attitude::IDENTITY);
        off.push((t, looped(&motion, t)?.angle_to(&naive)));
    }
    let ticks = [(0.0, "0"), (0.5 * PI, "π/2"), (PI, "π")];
    let graph = Panel::over_axes(
        "$t$ / s",
        Axis::linear("off by / rad").range(0.0, PI).ticks(ticks),
    )
    .curve(
        Curve::new(off.clone(), Ink::Wrong)
            .dashed()
            .label("wrong: yaw, pitch, roll"),
    );
    MovingPicture::above(graph, 0.0..=LOOPS, [1.2, 2.0, LOOPS], move |t| {
        let n = ((t / h).round() as usize).min(path.len() - 1);
        let truth = looped(&motion, t)?;
        let naive = path[n].unwrap_or(Attitude::IDENTITY);
        let alt = format!(
            "A plate that loops, after {t:.1} s, and beside it dashed the one that yaw, pitch and \
             roll give, {:.2} rad off; below, by how much it is off against time.",
            off[n].1
        );
        let corner = |a: Attitude, x: f64, y: f64| a.to_space(BodyVector::new(x, y, 0.0));
        let outline = [(0.8, 0.0), (-0.6, 0.45), (-0.6, -0.45), (0.8, 0.0)];
        let edges = [
            BodyVector::new(1.4, 0.0, 0.0),
            BodyVector::new(0.0, 0.7, 0.0),
            BodyVector::new(0.0, 0.0, 0.06),
        ];
        let zero = SpaceVector::zero();
        let scene = View::of(zero, 1.05)
            .camera(Camera::new(0.5, 0.35))
            .dashed(
                [
                    SpaceVector::new(0.0, 0.0, -1.0),
                    SpaceVector::new(0.0, 0.0, 1.0),
                ],
                Ink::Frame,
            )
            .solid(
                Solid::cuboid(zero, edges.map(|edge| truth.to_space(edge))),
                Ink::Body,
            )
            .arrow(
                zero,
                corner(truth, 1.0, 0.0),
                Ink::Body,
                "nose",
                Side::Right,
            )
            .dashed(outline.map(|(x, y)| corner(naive, x, y)), Ink::Wrong)
            .arrow(
                zero,
                corner(naive, 1.0, 0.0),
                Ink::Wrong,
                "wrong",
                Side::Left,
            );
        Ok((alt, scene))
    })
}
