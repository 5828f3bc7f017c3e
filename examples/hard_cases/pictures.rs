//! What moves: for each family the true motion and, dashed, what a naive method makes of it.

use super::findings::on_the_middle;
use super::naive::*;
use super::rotations::*;
use super::*;
use kit::draw::Scene as Drawn;

/// The picture of the family asked for; of all of them the book that must not flip.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let family = FAMILIES.iter().find(|family| family.key == p.family);
    family.map_or_else(book, |family| (family.picture)())
}

/// Two stills of each family's picture, for the pages: `poles_1`, `poles_2`, ...
pub fn stills(p: &Parameters) -> Result<Vec<Figure>> {
    let mut all = Vec::new();
    for family in FAMILIES.iter().filter(|_| p.family == "all") {
        for (still, n) in (family.picture)()?.stills()?.into_iter().zip(1..) {
            let name = format!("{}_{n}", family.key);
            all.push(Figure { name, ..still });
        }
    }
    Ok(all)
}

/// The graph of a quantity, exact and wrong, of what `both` are at these times.
pub fn graph<T>(
    [x, y]: [Axis; 2],
    over: impl Iterator<Item = f64>,
    both: impl Fn(f64) -> Result<T>,
    quantity: impl Fn(&T) -> [f64; 2],
) -> Result<Panel> {
    let (mut exact, mut wrong) = (Vec::new(), Vec::new());
    for t in over {
        let [truth, naive] = quantity(&both(t)?);
        exact.push((t, truth));
        if naive.is_finite() {
            wrong.push((t, naive));
        }
    }
    Ok(Panel::over_axes(x, y)
        .curve(Curve::new(exact, Ink::Ink))
        .curve(Curve::new(wrong, Ink::Wrong).dashed()))
}

/// What `both` are, exact and wrong, from 0 to an end: a scene with its words over the graph of a
/// quantity, which is drawn from so many times.
pub fn picture<T, S: Into<Drawn>>(
    axes: [Axis; 2],
    (end, count): (f64, u32),
    stills: [f64; 2],
    both: impl Fn(f64) -> Result<T> + Send + Sync + 'static,
    quantity: impl Fn(&T) -> [f64; 2],
    scene: impl Fn(f64, T) -> (String, S) + Send + Sync + 'static,
) -> Result<MovingPicture> {
    let graph = graph(axes, times(0.0, end, count), &both, quantity)?;
    MovingPicture::above(graph, 0.0..=end, stills, move |t| Ok(scene(t, both(t)?)))
}

/// Two linear axes, the second of this range, with a tick at each step.
pub fn axes(x: &str, y: &str, [from, to, step]: [f64; 3]) -> [Axis; 2] {
    let y = Axis::linear(y).range(from, to);
    [Axis::linear(x), y.step(step)]
}

pub const TIME: &str = "$t$ / s";
const MIDDLE_RATE: &str = r"$\Omega_2$ / (rad/s)";

pub const ZERO: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);
pub const THIRD: BodyVector = BodyVector::new(0.0, 0.0, 1.0);
const ALONG: BodyVector = BodyVector::new(0.0, 0.0, 0.95);

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
    let (l, r) = (-0.5, 0.5);
    let corners = [(l, l), (r, l), (r, r), (l, r), (l, l)];
    let outline = corners.map(|(x, y)| naive.to_space(BodyVector::new(x * a, y * b, 0.55 * c)));
    let said = naive.to_space(axis);
    view.dashed(outline, Ink::Wrong).arrow(ZERO, said, Ink::Wrong, "wrong", Side::Left)
}

const BOOK: [f64; 3] = [0.9, 1.2, 0.16];
const NAIL: BodyVector = BodyVector::new(0.0, 0.95, 0.0);

/// A book that turns exactly about its middle axis for so long (s), in steps of RK4: it must do so
/// for ever.
const THROWN: f64 = 240.0;
const STEPS: u32 = 2400;

/// When the book that RK4 turns lies across its axis for the first time (s).
pub fn first_flip() -> Result<f64> {
    let path = path_by_momentum(&on_the_middle(THROWN)?, STEPS)?;
    let turned = path.iter().position(|(_, middle)| *middle < 0.0);
    let steps = turned.map_or(f64::NAN, |n| n as f64);
    Ok(THROWN / f64::from(STEPS) * steps)
}

fn book() -> Result<MovingPicture> {
    let motion = on_the_middle(THROWN)?;
    let exact = motion.free_body()?;
    let path = path_by_momentum(&motion, STEPS)?;
    let h = THROWN / f64::from(STEPS);
    let middle = |t: f64| exact.angular_velocity(t).y();
    let naive = path.iter().enumerate();
    let naive = naive.map(|(n, (_, middle))| (h * n as f64, *middle));
    let [t, rates] = axes(TIME, MIDDLE_RATE, [-1.1, 1.6, 1.0]);
    let graph = Panel::over_axes(t, rates)
        .curve(Curve::of(times(0.0, THROWN, 600), middle, Ink::Ink).label("exact"))
        .curve(Curve::new(naive, Ink::Wrong).dashed().label("wrong: RK4"));
    MovingPicture::above(graph, 0.0..=THROWN, [40.0, 85.0, 120.0], move |t| {
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
pub fn gimbals() -> Result<MovingPicture> {
    let motion = locked()?;
    picture(
        axes(TIME, "off by / rad", [0.0, 1.5, 0.5]),
        (motion.end, 200),
        [0.0, 3.0],
        move |t| {
            let (now, steps) = (motion.until(t), (100.0 * t) as u32 + 1);
            Ok((now.in_closed_form()?, on_yaw_pitch_roll(&now, steps)))
        },
        |(truth, naive)| [0.0, naive.map_or(f64::NAN, |naive| naive.angle_to(truth))],
        |t, (truth, naive)| {
            let alt = format!(
                "A brick that began with its nose on the vertical, after {t:.0} s, and dashed where yaw, pitch and roll have it; \
                 below, how far that is off, against time."
            );
            let nose = BodyVector::new(1.05, 0.0, 0.0);
            (alt, brick([1.3, 0.8, 0.16], nose, truth, naive))
        },
    )
}

/// The tip of a top that all but sleeps, from above, a hundred million times as large.
pub fn tip() -> Result<MovingPicture> {
    const SIZE: f64 = 1e8;
    let motion = at_threshold(1e-8, 0.0, 4.4)?;
    // The azimuth and the tilt, and the tilt by the arc cosine.
    let both = move |t: f64| {
        let truth = motion.until(t).in_closed_form()?;
        let (angles, read) = (truth.euler_angles(), by_arc_cosine(truth));
        let wrong = read.map_or(f64::NAN, |a| a.euler_angles().theta);
        Ok::<_, kit::Error>((angles.phi, angles.theta, wrong))
    };
    let at = |phi: f64, theta: f64| (SIZE * theta * sin(phi), -SIZE * theta * cos(phi));
    let span = 13.7;
    let sampled_to = move |end: f64| sampled(times(0.0, end, 120), move |t| Ok((t, both(t)?)));
    let (exact, wrong): (Vec<_>, Vec<_>) = sampled_to(span)?
        .into_iter()
        .map(|(t, (_, tilt, wrong))| ((t, SIZE * tilt), (t, SIZE * wrong)))
        .unzip();
    let wrong = wrong.into_iter().filter(|(_, tilt)| tilt.is_finite());
    let [x, y] = axes(TIME, r"$10^8\,\theta$ / rad", [0.0, 4.0, 1.0]);
    let graph = Panel::over_axes(x, y)
        .curve(Curve::new(exact, Ink::Ink))
        .curve(Curve::new(wrong, Ink::Wrong).dots());
    MovingPicture::above(graph, 0.0..=span, [1.6, 3.4], move |t| {
        let (phi, theta, wrong) = both(t)?;
        let path = sampled_to(t.max(0.01))?.into_iter().map(|(_, (phi, theta, _))| at(phi, theta));
        let mut scene = Sketch::within((-3.75, 3.75), (-3.0, 3.0));
        for n in 1..=4 {
            let level = (2.0 * f64::from(n) * EPS).sqrt();
            let circle = times(0.0, TAU, 48).map(|phi| at(phi, level));
            scene = scene.curve(Curve::new(circle, Ink::Wrong).thin().faint(0.5));
        }
        let alt = format!(
            "From above the path of a top's tip in the first {t:.1} s, some hundred-millionths of a radian wide, with circles on \
             which an arc cosine can have it; below, the tilt against time, a wave, and by the arc cosine dots on a few levels."
        );
        let scene = scene
            .curve(Curve::new(path, Ink::Body).thin())
            .dot(at(phi, theta), Ink::Body, "exact", Side::Left)
            .ring(at(phi, wrong), Ink::Wrong, "wrong", Side::Right);
        Ok((alt, scene))
    })
}

/// The angular momentum on the axes of a body that flips, 1 - k^2 = 1e-16.
pub fn separatrix_passed() -> Result<MovingPicture> {
    let motion = one_flip(1e-16)?;
    let exact = motion.free_body()?;
    let along = move |rates: [f64; 3]| {
        let [x, y, z] = motion.momentum(rates).to_array();
        let l = SpaceVector::new(x, y, z);
        l / l.norm()
    };
    let path: Vec<_> =
        times(0.0, motion.end, 160).map(|t| along(exact.angular_velocity(t).to_array())).collect();
    picture(
        axes(TIME, MIDDLE_RATE, [-1.1, 1.1, 1.0]),
        (motion.end, 200),
        [30.0, 59.0],
        move |t| {
            let exact = exact.angular_velocity(t).to_array();
            Ok([exact, rates_by_landau(&motion.until(t))])
        },
        |both| both.map(|rates| rates[1]),
        move |t, both| {
            let alt = format!(
                "The sphere of the body's axes after {t:.0} s with the angular momentum, exact, and dashed with one minus the modulus \
                 squared found by subtraction, a quarter of a turn off; below, the middle rates against time."
            );
            let [truth, naive] = both.map(along);
            let scene = View::of(ZERO, 1.2)
                .camera(Camera::new(0.7, 0.4))
                .sphere()
                .trace(path.iter().copied(), Ink::Momentum)
                .arrow(ZERO, truth, Ink::Momentum, "exact", Side::Right)
                .arrow(ZERO, naive, Ink::Wrong, "wrong", Side::Left);
            (alt, scene)
        },
    )
}

/// Three periods of two flips after a thousand, by RK4 with a hundred steps a flip.
pub fn late_flips() -> Result<MovingPicture> {
    let whole = flips([1.0, 2.0, 2.5], [0.0, 1.0, 1e-3])?;
    let period = whole.end / FLIPS_PERIODS;
    let motion = whole.until(1003.0 * period);
    let path: Vec<_> = path_on_quaternion(&motion, 200_600).skip(200_000).collect();
    let exact = motion.free_body()?;
    picture(
        axes("$t-1000\\,T$ / s", MIDDLE_RATE, [-1.1, 1.1, 1.0]),
        (3.0 * period, 300),
        [0.95 * period, 1.5 * period],
        move |t| {
            let late = 1000.0 * period + t;
            let [w, x, y, z, _, rate, _] = path[((t / period * 200.0).round() as usize).min(600)];
            let naive = Attitude::from_quaternion([w, x, y, z])?;
            let rates = [exact.angular_velocity(late).y(), rate];
            Ok((exact.attitude(late), naive, rates))
        },
        |(_, _, rates)| *rates,
        |t, (truth, naive, _)| {
            let alt = format!(
                "A book {t:.0} s after its two thousandth flip, and dashed the one that RK4 gives, {:.1} rad off; \
                 below, the rates about the middle axis, which part.",
                truth.angle_to(&naive)
            );
            (alt, brick(BOOK, NAIL, truth, Some(naive)))
        },
    )
}

/// A body whose moments differ by a billionth, after a billion seconds, and one for which they
/// were called equal.
pub fn all_but_symmetric() -> Result<MovingPicture> {
    const LATE: f64 = 1e9;
    let late = r"$t-10^9\,\mathrm{s}$ / s";
    let of = |apart: f64| shaped([1.0, 1.0 + apart, 1.7])?.free_body();
    let bodies = [of(1e-9)?, of(0.0)?];
    picture(
        axes(late, r"$\Omega_1$ / (rad/s)", [-1.0, 1.0, 0.5]),
        (30.0, 200),
        [0.0, 10.0],
        move |t| Ok(bodies.each_ref().map(|body| body.kinematics(LATE + t))),
        |both| both.map(|now| now.angular_velocity.x()),
        |t, both| {
            let [truth, naive] = both.map(|now| now.attitude);
            let alt = format!(
                "A brick a billion seconds and {t:.0} more after its start, and dashed the one whose two like moments were called \
                 equal, {:.1} rad off; below, one of the rates of both against time.",
                truth.angle_to(&naive)
            );
            (alt, brick([1.1, 1.1, 0.4], ALONG, truth, Some(naive)))
        },
    )
}

/// A top that is let go at rest.
pub fn let_go() -> Result<MovingPicture> {
    let at = |end: f64| released([1.5, 0.25], FRAC_PI_3, end);
    let axis_at = move |t: f64| Ok(at(t)?.in_closed_form()?.to_space(THIRD));
    let span = 22.8;
    let tilts = graph(
        axes(TIME, r"$\theta$ / rad", [0.9, 1.5, 0.2]),
        times(0.0, span, 200),
        |t| {
            let now = at(t)?;
            let truth = now.in_closed_form()?.euler_angles().theta;
            Ok([truth, tilt_by_energy(&now, 200)])
        },
        |tilts| *tilts,
    )?;
    MovingPicture::above(tilts, 0.0..=span, [8.5, 22.0], move |t| {
        let alt = format!(
            "The axis of a top {t:.0} s after it was let go, with its path, which has cusps, and one that never left; \
             below, the tilt against time."
        );
        let path = sampled(times(0.0, t.max(0.1), 100), axis_at)?;
        let scene = View::of(SpaceVector::new(0.0, 0.0, 0.2), 1.15)
            .camera(Camera::new(0.9, 0.45))
            .sphere()
            .trace(path, Ink::Body)
            .arrow(ZERO, axis_at(t)?, Ink::Body, "exact", Side::Right)
            .arrow(ZERO, axis_at(0.0)?, Ink::Wrong, "wrong", Side::Left);
        Ok((alt, scene))
    })
}

/// Towards half a turn, a power of ten in each unit of time: from its matrix by the trace.
pub fn half_turn() -> Result<MovingPicture> {
    let axis = SpaceVector::new(1.0, -2.0, 3.0);
    picture(
        [Axis::linear("$n$: half a turn less $10^{-n}$ rad"), Axis::log("scalar part")],
        (9.0, 360),
        [7.6, 8.5],
        move |n| Ok((n, Attitude::about_space_axis(axis, PI - pow(10.0, -n))?)),
        |(n, truth)| {
            let w = scalar_by_trace(*truth);
            [sin(0.5 * pow(10.0, -n)), if w > 0.0 { w } else { f64::NAN }]
        },
        |n, (_, truth)| {
            let alt = format!(
                "A brick turned by half a turn but for the power of ten with the exponent minus {n:.1}, and dashed where the trace of \
                 its matrix has it, if anywhere; below, the scalar part of the quaternion, exact and by the trace."
            );
            let nose = BodyVector::new(1.05, 0.0, 0.0);
            (alt, brick([1.3, 0.9, 0.5], nose, truth, by_trace(truth)))
        },
    )
}

/// A molecule, and the one to whose moments 1e-30 kg m^2 was added.
pub fn molecule() -> Result<MovingPicture> {
    let motion = scaled(1e-46, 1e12)?;
    picture(
        axes("$t$ / ps", "turned by / rad", [0.0, 3.3, 1.0]),
        (30.0, 240),
        [3.0, 8.0],
        move |t| {
            let now = motion.until(1e-12 * t);
            Ok((now.in_closed_form()?, guarded(&now)))
        },
        |(truth, naive)| {
            let off = |a: Attitude| a.angle_to(&motion.attitude);
            [off(*truth), naive.map_or(f64::NAN, off)]
        },
        |t, (truth, naive)| {
            let alt = format!(
                "A brick in place of a molecule after {t:.0} picoseconds, and dashed the one with guarded moments, which has not \
                 moved; below, the angle from the start of both."
            );
            (alt, brick([1.2, 0.9, 0.3], ALONG, truth, naive))
        },
    )
}

/// After a hundred trillion periods, in steps that a double of that time still has.
pub fn trillions() -> Result<MovingPicture> {
    const PERIODS: f64 = 1e14;
    let late = |t: f64| late(PERIODS + t, [1.0, 1.0, 1.7], [0.8, 0.4, 0.3]);
    let ends = move |t: f64| {
        let (motion, _, modulo) = late(t)?;
        Ok::<_, kit::Error>((motion.end, [motion.in_closed_form()?, modulo]))
    };
    // A double of this time is a multiple of a sixteenth of a second: drawn where it is.
    let (first, exact, _) = late(0.0)?;
    let heights = sampled(times(0.0, 1.5, 96), |t| {
        let (end, both) = ends(t)?;
        let t = (end - first.end) / exact.rate_period();
        Ok(both.map(|a| (t, a.to_space(BodyVector::new(1.0, 0.0, 0.0)).z())))
    })?;
    let curve = |i: usize, ink| Curve::new(heights.iter().map(|both| both[i]), ink);
    let [x, y] = axes("$t/T-10^{14}$", "height of an edge", [-1.05, 1.05, 1.0]);
    let graph =
        Panel::over_axes(x, y).curve(curve(0, Ink::Ink)).curve(curve(1, Ink::Wrong).dashed());
    MovingPicture::above(graph, 0.0..=1.5, [0.25, 1.0], move |t| {
        let (_, [truth, naive]) = ends(t)?;
        let alt = format!(
            "A brick a hundred trillion periods and {t:.2} after its start, and dashed the one whose time was taken modulo a \
             rounded period, {:.1} rad off; below, the height of an edge of both.",
            truth.angle_to(&naive)
        );
        let edge = BodyVector::new(0.95, 0.0, 0.0);
        Ok((alt, brick([1.3, 0.8, 0.3], edge, truth, Some(naive))))
    })
}
