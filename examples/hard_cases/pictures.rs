//! What moves: for each family the true motion and, dashed, what a naive method makes of it.

use super::forms::Form;
use super::long::Late;
use super::motions::{By, Motion};
use super::naive::{
    by_arc_cosine, by_trace, guarded, on_yaw_pitch_roll, path_by_momentum, path_on_quaternion,
    rates_by_landau, tilt_by_energy,
};
use super::{
    FAMILIES, Parameters, findings, flips, poles, scales, separatrix, stepped, threshold, tops,
};
use core::f64::consts::{FRAC_PI_3, PI, TAU};
use kit::draw::Camera;
use kit::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::math::EPS;

/// The picture of the family asked for; of all of them the book that must not flip.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    match p.family {
        "poles" => gimbals(),
        "threshold" => tip(),
        "separatrix" => separatrix_passed(),
        "flips" => late_flips(),
        "shapes" => all_but_symmetric(),
        "tops" => let_go(),
        "turns" => half_turn(),
        "scales" => molecule(),
        "long" => trillions(),
        "torques" => stepped::bell(),
        "findings" => stepped::risen(),
        "events" => stepped::bounces(),
        "impacts" => stepped::pushed(),
        "stability" => stepped::braked(),
        _ => book(),
    }
}

/// Two stills of each family's picture, for the pages: `poles_1`, `poles_2`, ...
pub fn stills(p: &Parameters) -> Result<Vec<Figure>> {
    let mut all = Vec::new();
    for family in FAMILIES.iter().filter(|_| p.family == "all") {
        let of = Parameters {
            family: family.key,
            ..p.clone()
        };
        for (still, n) in moving_picture(&of)?.stills()?.into_iter().zip(1..) {
            let name = format!("{}_{n}", family.key);
            all.push(Figure { name, ..still });
        }
    }
    Ok(all)
}

pub const ZERO: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);

/// A brick of these edges where it is, and dashed the outline of where it is said to be, with
/// an arrow along one of its axes in each.
fn brick(edges: [f64; 3], axis: BodyVector, truth: Attitude, naive: Option<Attitude>) -> View {
    let [a, b, c] = edges;
    let solid = [(a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c)]
        .map(|(x, y, z)| truth.to_space(BodyVector::new(x, y, z)));
    let view = View::of(ZERO, 1.1)
        .camera(Camera::new(0.5, 0.35))
        .solid(Solid::cuboid(ZERO, solid), Ink::Body)
        .arrow(ZERO, truth.to_space(axis), Ink::Body, "exact", Side::Right);
    let Some(naive) = naive else { return view };
    let corners = [
        (-0.5, -0.5),
        (0.5, -0.5),
        (0.5, 0.5),
        (-0.5, 0.5),
        (-0.5, -0.5),
    ];
    let outline = corners.map(|(x, y)| naive.to_space(BodyVector::new(x * a, y * b, 0.55 * c)));
    view.dashed(outline, Ink::Wrong).arrow(
        ZERO,
        naive.to_space(axis),
        Ink::Wrong,
        "wrong",
        Side::Left,
    )
}

/// A graph of what is exact and what is wrong over one time.
pub fn graph(
    [x, y]: [Axis; 2],
    xs: impl Iterator<Item = f64> + Clone,
    exact: impl Fn(f64) -> Result<f64>,
    naive: impl Fn(f64) -> Result<f64>,
) -> Result<Panel> {
    let mut wrong = sampled(xs.clone(), |t| Ok((t, naive(t)?)))?;
    wrong.retain(|(_, y)| y.is_finite());
    Ok(Panel::over_axes(x, y)
        .curve(Curve::sampled(xs, exact, Ink::Ink)?)
        .curve(Curve::new(wrong, Ink::Wrong).dashed()))
}

pub fn seconds() -> Axis {
    Axis::linear("$t$ / s")
}

pub fn until(motion: &Motion, end: f64) -> Motion {
    Motion { end, ..*motion }
}

fn closed(motion: &Motion) -> rotation_dynamics::Result<Attitude> {
    motion.reached(By::ClosedForm, Form::Quaternion, 0.0)
}

fn free(motion: &Motion) -> rotation_dynamics::Result<FreeBody> {
    let rates = BodyVector::from_array(motion.rates);
    FreeBody::new(motion.body()?, motion.attitude, rates)
}

const BOOK: [f64; 3] = [0.9, 1.2, 0.16];
const NAIL: BodyVector = BodyVector::new(0.0, 0.95, 0.0);

/// A book that turns exactly about its middle axis: it must do so for ever.
fn thrown() -> Result<Motion> {
    let start = findings::turned(1.0, 0.5, 2.0)?;
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

fn book() -> Result<MovingPicture> {
    let motion = thrown()?;
    let exact = free(&motion)?;
    let path = path_by_momentum(&motion, STEPS)?;
    let h = motion.end / f64::from(STEPS);
    let middle = |t: f64| exact.angular_velocity(t).y();
    let naive = path
        .iter()
        .enumerate()
        .map(|(n, (_, middle))| (h * n as f64, *middle));
    let rates = Axis::linear(r"$\Omega_2$ / (rad/s)")
        .range(-1.1, 1.6)
        .step(1.0);
    let graph = Panel::over_axes(seconds(), rates)
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
        Ok((alt, brick(BOOK, NAIL, truth, Some(naive))))
    })
}

/// Nose on the vertical, by yaw, pitch and roll: the first step divides by the cosine of pi/2.
fn gimbals() -> Result<MovingPicture> {
    let motion = poles::locked()?;
    let truth = move |t: f64| closed(&until(&motion, t));
    let naive = move |t: f64| on_yaw_pitch_roll(&until(&motion, t), (100.0 * t) as u32 + 1);
    let nose = BodyVector::new(1.05, 0.0, 0.0);
    let off =
        |t: f64| Ok(naive(t).map_or(f64::NAN, |a| truth(t).map_or(f64::NAN, |b| a.angle_to(&b))));
    let graph = graph(
        [
            seconds(),
            Axis::linear("off by / rad").range(0.0, 1.5).step(0.5),
        ],
        times(0.0, motion.end, 200),
        |_| Ok(0.0),
        off,
    )?;
    MovingPicture::above(graph, 0.0..=motion.end, [0.0, 3.0], move |t| {
        let alt = format!(
            "A brick that began with its nose on the vertical, after {t:.0} s, and dashed where yaw, pitch and roll have it; \
             below, how far that is off, against time."
        );
        Ok((alt, brick([1.3, 0.8, 0.16], nose, truth(t)?, naive(t))))
    })
}

/// The tip of a top that all but sleeps, from above, a hundred million times as large.
fn tip() -> Result<MovingPicture> {
    const SIZE: f64 = 1e8;
    let motion = threshold::top(1e-8, [0.0, 0.0, 4.4])?;
    let angles =
        move |t: f64| Ok::<_, rotation_dynamics::Error>(closed(&until(&motion, t))?.euler_angles());
    let read = move |t: f64| {
        Ok::<_, rotation_dynamics::Error>(
            by_arc_cosine(closed(&until(&motion, t))?).map(|a| a.euler_angles().theta),
        )
    };
    let at = |phi: f64, theta: f64| (SIZE * theta * sin(phi), -SIZE * theta * cos(phi));
    let span = 13.7;
    let mut wrong = sampled(times(0.0, span, 120), |t| {
        Ok((t, SIZE * read(t)?.unwrap_or(f64::NAN)))
    })?;
    wrong.retain(|(_, tilt)| tilt.is_finite());
    let tilt = Axis::linear(r"$10^8\,\theta$ / rad")
        .range(0.0, 4.0)
        .step(1.0);
    let exact = |t: f64| Ok(SIZE * angles(t)?.theta);
    let graph = Panel::over_axes(seconds(), tilt)
        .curve(Curve::sampled(times(0.0, span, 120), exact, Ink::Ink)?)
        .curve(Curve::new(wrong, Ink::Wrong).dots());
    MovingPicture::above(graph, 0.0..=span, [1.6, 3.4], move |t| {
        let now = angles(t)?;
        let wrong = read(t)?.unwrap_or(f64::NAN);
        let path = sampled(times(0.0, t.max(0.01), 120), |t| {
            Ok(at(angles(t)?.phi, angles(t)?.theta))
        })?;
        let circle =
            |n: i32| times(0.0, TAU, 48).map(move |phi| at(phi, (2.0 * f64::from(n) * EPS).sqrt()));
        let mut scene = Sketch::within((-3.75, 3.75), (-3.0, 3.0));
        for n in 1..=4 {
            scene = scene.curve(Curve::new(circle(n), Ink::Wrong).thin().faint(0.5));
        }
        let alt = format!(
            "From above the path of a top's tip in the first {t:.1} s, some hundred-millionths of a radian wide, with circles on \
             which an arc cosine can have it; below, the tilt against time, a wave, and by the arc cosine dots on a few levels."
        );
        let (x, y) = at(now.phi, wrong);
        let scene = scene
            .curve(Curve::new(path, Ink::Body).thin())
            .dot(at(now.phi, now.theta), Ink::Body, "exact", Side::Left)
            .ring((x, y), Ink::Wrong, "wrong", Side::Right);
        Ok((alt, scene))
    })
}

/// The angular momentum on the axes of a body that flips, 1 - k^2 = 1e-16.
fn separatrix_passed() -> Result<MovingPicture> {
    let motion = separatrix::one_flip(1e-16)?;
    let exact = free(&motion)?;
    let naive = move |t: f64| rates_by_landau(&until(&motion, t));
    let along = move |rates: [f64; 3]| {
        let [x, y, z]: [f64; 3] = core::array::from_fn(|i| motion.moments[i] * rates[i]);
        let l = SpaceVector::new(x, y, z);
        l / l.norm()
    };
    let truth = move |t: f64| exact.angular_velocity(t).to_array();
    let graph = graph(
        [
            seconds(),
            Axis::linear(r"$\Omega_2$ / (rad/s)")
                .range(-1.1, 1.1)
                .step(1.0),
        ],
        times(0.0, motion.end, 200),
        |t| Ok(truth(t)[1]),
        |t| Ok(naive(t)[1]),
    )?;
    MovingPicture::above(graph, 0.0..=motion.end, [30.0, 59.0], move |t| {
        let alt = format!(
            "The sphere of the body's axes after {t:.0} s with the angular momentum, exact, and dashed with one minus the modulus \
             squared found by subtraction, a quarter of a turn off; below, the middle rates against time."
        );
        let path = times(0.0, motion.end, 160).map(|t| along(truth(t)));
        let scene = View::of(ZERO, 1.2)
            .camera(Camera::new(0.7, 0.4))
            .sphere()
            .trace(path, Ink::Momentum)
            .arrow(ZERO, along(truth(t)), Ink::Momentum, "exact", Side::Right)
            .arrow(ZERO, along(naive(t)), Ink::Wrong, "wrong", Side::Left);
        Ok((alt, scene))
    })
}

/// Three periods of two flips after a thousand, by RK4 with a hundred steps a flip.
fn late_flips() -> Result<MovingPicture> {
    let whole = flips::flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
    let period = whole.end / flips::PERIODS;
    let motion = until(&whole, 1003.0 * period);
    let path: Vec<_> = path_on_quaternion(&motion, 200_600).skip(200_000).collect();
    let exact = free(&motion)?;
    let from = 1000.0 * period;
    let naive = move |t: f64| path[((t / period * 200.0).round() as usize).min(600)];
    let graph = graph(
        [
            Axis::linear("$t-1000\\,T$ / s"),
            Axis::linear(r"$\Omega_2$ / (rad/s)")
                .range(-1.1, 1.1)
                .step(1.0),
        ],
        times(0.0, 3.0 * period, 300),
        |t| Ok(exact.angular_velocity(from + t).y()),
        |t| Ok(naive(t)[5]),
    )?;
    let stills = [0.95 * period, 1.5 * period];
    MovingPicture::above(graph, 0.0..=3.0 * period, stills, move |t| {
        let [w, x, y, z, ..] = naive(t);
        let naive = Attitude::from_quaternion([w, x, y, z])?;
        let truth = exact.attitude(from + t);
        let alt = format!(
            "A book {t:.0} s after its two thousandth flip, and dashed the one that RK4 gives, {:.1} rad off; \
             below, the rates about the middle axis, which part.",
            truth.angle_to(&naive)
        );
        Ok((alt, brick(BOOK, NAIL, truth, Some(naive))))
    })
}

/// A body whose moments differ by a billionth, after a billion seconds, and one for which they
/// were called equal.
fn all_but_symmetric() -> Result<MovingPicture> {
    const LATE: f64 = 1e9;
    let of = |moments| {
        free(&Motion::free(
            moments,
            findings::turned(0.3, 0.8, 0.2)?,
            [0.8, 0.4, 0.9],
            0.0,
        ))
    };
    let (exact, naive) = (of([1.0, 1.0 + 1e-9, 1.7])?, of([1.0, 1.0, 1.7])?);
    let graph = graph(
        [
            Axis::linear(r"$t-10^9\,\mathrm{s}$ / s"),
            Axis::linear(r"$\Omega_1$ / (rad/s)")
                .range(-1.0, 1.0)
                .step(0.5),
        ],
        times(0.0, 30.0, 200),
        |t| Ok(exact.angular_velocity(LATE + t).x()),
        |t| Ok(naive.angular_velocity(LATE + t).x()),
    )?;
    MovingPicture::above(graph, 0.0..=30.0, [0.0, 10.0], move |t| {
        let [truth, naive] = [&exact, &naive].map(|body| body.attitude(LATE + t));
        let alt = format!(
            "A brick a billion seconds and {t:.0} more after its start, and dashed the one whose two like moments were called \
             equal, {:.1} rad off; below, one of the rates of both against time.",
            truth.angle_to(&naive)
        );
        let axis = BodyVector::new(0.0, 0.0, 0.95);
        Ok((alt, brick([1.1, 1.1, 0.4], axis, truth, Some(naive))))
    })
}

/// A top that is let go at rest.
fn let_go() -> Result<MovingPicture> {
    let at = |end: f64| tops::released([1.5, 0.25], FRAC_PI_3, end);
    let axis = |a: Attitude| a.to_space(BodyVector::new(0.0, 0.0, 1.0));
    let truth = move |t: f64| closed(&at(t)?);
    let span = 22.8;
    let graph = graph(
        [
            seconds(),
            Axis::linear(r"$\theta$ / rad").range(0.9, 1.5).step(0.2),
        ],
        times(0.0, span, 200),
        |t| Ok(truth(t)?.euler_angles().theta),
        |t| Ok(tilt_by_energy(&at(t)?, 200)),
    )?;
    MovingPicture::above(graph, 0.0..=span, [8.5, 22.0], move |t| {
        let alt = format!(
            "The axis of a top {t:.0} s after it was let go, with its path, which has cusps, and one that never left; \
             below, the tilt against time."
        );
        let path = sampled(times(0.0, t.max(0.1), 100), |t| Ok(axis(truth(t)?)))?;
        let scene = View::of(SpaceVector::new(0.0, 0.0, 0.2), 1.15)
            .camera(Camera::new(0.9, 0.45))
            .sphere()
            .trace(path, Ink::Body)
            .arrow(ZERO, axis(truth(t)?), Ink::Body, "exact", Side::Right)
            .arrow(ZERO, axis(truth(0.0)?), Ink::Wrong, "wrong", Side::Left);
        Ok((alt, scene))
    })
}

/// Towards half a turn, a power of ten in each unit of time: from its matrix by the trace.
fn half_turn() -> Result<MovingPicture> {
    let axis = SpaceVector::new(1.0, -2.0, 3.0);
    let truth = move |n: f64| Attitude::about_space_axis(axis, PI - pow(10.0, -n));
    let scalar = |n: f64| Ok(sin(0.5 * pow(10.0, -n)));
    let traced = |n: f64| {
        let m = truth(n)?.matrix();
        let w = 0.5 * (1.0 + m[0][0] + m[1][1] + m[2][2]).max(0.0).sqrt();
        Ok(if w > 0.0 { w } else { f64::NAN })
    };
    let graph = graph(
        [
            Axis::linear("$n$: half a turn less $10^{-n}$ rad"),
            Axis::log("scalar part"),
        ],
        times(0.0, 9.0, 360),
        scalar,
        traced,
    )?;
    MovingPicture::above(graph, 0.0..=9.0, [7.6, 8.5], move |n| {
        let naive = by_trace(truth(n)?);
        let alt = format!(
            "A brick turned by half a turn but for the power of ten with the exponent minus {n:.1}, and dashed where the trace of \
             its matrix has it, if anywhere; below, the scalar part of the quaternion, exact and by the trace."
        );
        let nose = BodyVector::new(1.05, 0.0, 0.0);
        Ok((alt, brick([1.3, 0.9, 0.5], nose, truth(n)?, naive)))
    })
}

/// A molecule, and the one to whose moments 1e-30 kg m^2 was added.
fn molecule() -> Result<MovingPicture> {
    let motion = scales::scaled(1e-46, 1e12)?;
    let at = move |t: f64| until(&motion, 1e-12 * t);
    let off = move |a: Attitude| a.angle_to(&motion.attitude);
    let graph = graph(
        [
            Axis::linear("$t$ / ps"),
            Axis::linear("turned by / rad").range(0.0, 3.3).step(1.0),
        ],
        times(0.0, 30.0, 240),
        |t| Ok(off(closed(&at(t))?)),
        |t| Ok(guarded(&at(t)).map_or(f64::NAN, off)),
    )?;
    MovingPicture::above(graph, 0.0..=30.0, [3.0, 8.0], move |t| {
        let alt = format!(
            "A brick in place of a molecule after {t:.0} picoseconds, and dashed the one with guarded moments, which has not \
             moved; below, the angle from the start of both."
        );
        let nose = BodyVector::new(0.0, 0.0, 0.95);
        Ok((
            alt,
            brick([1.2, 0.9, 0.3], nose, closed(&at(t))?, guarded(&at(t))),
        ))
    })
}

/// After a hundred trillion periods, in steps that a double of that time still has.
fn trillions() -> Result<MovingPicture> {
    const PERIODS: f64 = 1e14;
    let late = |t: f64| Late::after(PERIODS + t, [1.0, 1.0, 1.7], [0.8, 0.4, 0.3]);
    let ends = move |t: f64| {
        let late = late(t)?;
        Ok::<_, rotation_dynamics::Error>([closed(&late.motion)?, late.modulo])
    };
    let height = |a: Attitude| a.to_space(BodyVector::new(1.0, 0.0, 0.0)).z();
    // A double of this time is a multiple of a sixteenth of a second: drawn where it is.
    let (first, period) = (late(0.0)?.motion.end, late(0.0)?.exact.rate_period());
    let (mut exact, mut wrong) = (Vec::new(), Vec::new());
    for t in times(0.0, 1.5, 96) {
        let (x, [truth, naive]) = ((late(t)?.motion.end - first) / period, ends(t)?.map(height));
        exact.push((x, truth));
        wrong.push((x, naive));
    }
    let height = Axis::linear("height of an edge")
        .range(-1.05, 1.05)
        .step(1.0);
    let graph = Panel::over_axes(Axis::linear("$t/T-10^{14}$"), height)
        .curve(Curve::new(exact, Ink::Ink))
        .curve(Curve::new(wrong, Ink::Wrong).dashed());
    MovingPicture::above(graph, 0.0..=1.5, [0.25, 1.0], move |t| {
        let [truth, naive] = ends(t)?;
        let alt = format!(
            "A brick a hundred trillion periods and {t:.2} after its start, and dashed the one whose time was taken modulo a \
             rounded period, {:.1} rad off; below, the height of an edge of both.",
            truth.angle_to(&naive)
        );
        let edge = BodyVector::new(0.95, 0.0, 0.0);
        Ok((alt, brick([1.3, 0.8, 0.3], edge, truth, Some(naive))))
    })
}
