//! The drawings: a method that breaks, and beside it the form that holds; and a book that must
//! not flip.

use super::findings::on_the_middle;
use super::naive::*;
use super::rotations::*;
use super::*;
use kit::draw::{Camera, Marker};

/// Below it a logarithmic axis draws an error as this: no double has a smaller one of 1.
const FLOOR: f64 = 1e-17;

/// Powers of ten, so many in each decade.
fn decades(from: i32, to: i32, each: i32) -> impl Iterator<Item = f64> {
    let step = 1.0 / f64::from(each);
    (0..=(to - from) * each).map(move |n| pow(10.0, f64::from(from) + step * f64::from(n)))
}

/// Over one quantity the errors of what breaks and of what holds, each with its label.
fn pair(
    [x, y]: [&str; 2],
    over: impl IntoIterator<Item = f64>,
    errors: impl Fn(f64) -> Result<[f64; 2]>,
    labels: [&str; 2],
) -> Result<Panel> {
    let errors = sampled(over, |x| Ok((x, errors(x)?)))?;
    let curve = |i: usize, ink| {
        let finite = errors.iter().filter(|(_, error)| error[i].is_finite());
        Curve::new(finite.map(|(x, error)| (*x, error[i].max(FLOOR))), ink).label(labels[i])
    };
    let y = match y {
        "relative error" => Axis::log(y).range(FLOOR, 10.0),
        _ => Axis::log(y),
    };
    let panel = Panel::over_axes(Axis::log(x), y);
    Ok(panel.curve(curve(0, Ink::Wrong).dashed()).curve(curve(1, Ink::Ink)))
}

/// The errors of a naive method, and of the closed form.
fn ends(motion: &Motion, naive: Plain) -> Result<[f64; 2]> {
    let truth = motion.truth()?;
    Ok([naive.1(motion, truth)?, truth.angle_to(&motion.in_closed_form()?)])
}

figures! { p: &Parameters;
    /// The relative error of 1 - cos x against x, both logarithmic. As it stands it grows as
    /// 1/x^2, to one below 1e-8; written as twice the square of a sine it stays at 1e-16.
    digits: pair(["$x$", "relative error"], decades(-9, 0, 12), |x| {
            let truth = DoubleDouble::from(0.5 * x).sin_cos().0.square() * 2.0;
            let sine = sin(0.5 * x);
            Ok([1.0 - cos(x), 2.0 * sine * sine].map(|y| ((truth - y) / truth).to_f64().abs()))
        }, ["wrong: $1-\\cos x$", r"$2\sin^2(x/2)$"])?;

    /// The error after 20 s against the distance from the pole at the start, both logarithmic.
    /// The one of RK4 on Euler angles jumps about, up to a thousandth of a radian, and is a rounding
    /// only next to the pole; that of the closed form is one everywhere.
    poles: pair([r"$\theta_0$ / rad", "error / rad"], decades(-10, -1, 4),
        |theta| ends(&at_pole(turned(0.3, theta, 0.0)?, [0.1, 0.0, 2.0]), ANGLES),
        ["wrong: Euler angles", "closed form"])?;

    /// The relative error of a tilt against the tilt, both logarithmic. By an arc cosine it grows
    /// to one at 1e-8 rad; by the arc tangent of two lengths it is a rounding everywhere.
    tilt: pair([r"$\theta$ / rad", "relative error"], decades(-9, 0, 12), |theta| {
            let tilted = turned(0.3, theta, 0.2)?;
            let tilts = [by_arc_cosine(tilted).unwrap_or(tilted), tilted].map(|a| a.euler_angles().theta);
            Ok(tilts.map(|tilt| (tilt / theta - 1.0).abs()))
        }, ["wrong: arc cosine", "arc tangent"])?;

    /// The error after one flip against 1 - k^2, both logarithmic. By subtraction it grows as one over
    /// 1 - k^2, to one at 1e-16; that of the closed form stays small.
    separatrix: pair(["$1-k^2$", "error / rad"], decades(-16, -2, 4), |complement| {
            // The direction of L on the body's axes.
            let motion = one_flip(complement)?;
            let closed = motion.free_body()?.angular_velocity(motion.end).to_array();
            Ok([momentum_off(&motion, rates_by_landau(&motion)), momentum_off(&motion, closed)])
        }, ["wrong: subtracted", "closed form"])?;

    /// The error of a quaternion against how far a rotation is from half a turn, both logarithmic.
    /// From the trace it grows as one over it, to 1e-8, and ends at 1e-8; from the largest component it is a rounding.
    turns: pair(["half a turn less this / rad", "error / rad"], decades(-9, 0, 8), |off| {
            let turned = half_turn(off)?;
            Ok([by_trace(turned), MATRIX(turned)?.angle_to(&turned)])
        }, ["wrong: by the trace", "largest component"])?;

    /// The error against the number of periods, 1 to 1e12, both logarithmic. The one of the time
    /// modulo a rounded period grows in proportion; the one of the closed form stays a rounding.
    late: pair(["periods", "error / rad"], decades(0, 12, 1),
        |periods| ends(&late([periods, 0.3], [1.0, 2.0, 2.5], [0.8, 0.4, 0.3])?, MODULO), ["wrong: $t$ mod $T$", "closed form"])?;

    /// The error of the end against the depth of a graze, both logarithmic. Looked at every 0.03 s
    /// it is from a third of a millimetre to centimetres; with the event located it is a rounding, growing as the graze
    /// gets shallow.
    events: pair(["excess speed / (m/s)", "error / m"], decades(-9, -1, 3), |excess| {
            let Answered { naive: (_, naive), cells, .. } = events::graze(excess)?;
            Ok([naive, *cells[1].answer.as_ref().unwrap_or(&f64::NAN)])
        }, ["wrong: every 0.03 s", "located"])?;

    /// For each family the errors over their bounds, logarithmic: of each case the worst method in its
    /// worst representation left of one, the naive method right of it.
    table: overview(p)?;
}

/// A line for each family: the worst cell of each case left of one, its naive method right of it.
fn overview(p: &Parameters) -> Result<Panel> {
    let all = computed(p)?;
    let (mut held, mut naive, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (one, line) in all.iter().zip((1..=all.len()).rev()) {
        let y = line as f64;
        names.push((y, one.family.key));
        for (_, answered) in &one.rows {
            let worst = answered.cells.iter().filter_map(Cell::part).reduce(f64::max);
            held.extend(worst.map(|part| (part.max(1e-8), y)));
            naive.push((answered.broken().clamp(1e-8, 1e16), y));
        }
    }
    let lines = Axis::linear("").range(0.3, all.len() as f64 + 0.7);
    let errors = Axis::log("error over its bound").range(1e-8, 1e16);
    Ok(Panel::over_axes(errors, lines.ticks(names))
        .size(340, 60 + 26 * all.len() as u32)
        .upright(1.0, Ink::Ink, "bound")
        .curve(Curve::new(held, Ink::Ink).faint(0.5).dots())
        .curve(Curve::new(naive, Ink::Wrong).marker(Marker::Square).dots()))
}

/// A book turns exactly about its middle axis for so long (s): it must do so for ever.
const THROWN: f64 = 240.0;

/// The step of RK4 that is nearest to this (s), and after each the attitude and the middle rate.
fn by_rk4(step: f64) -> Result<(f64, Vec<(Attitude, f64)>)> {
    let steps = (THROWN / step).round();
    let path = path_by_momentum(&on_the_middle(THROWN)?, steps as u32)?;
    Ok((THROWN / steps, path))
}

/// When the book that RK4 turns lies across its axis for the first time (s).
pub fn first_flip(step: f64) -> Result<f64> {
    let (h, path) = by_rk4(step)?;
    let flipped = path.iter().position(|(_, middle)| *middle < 0.0);
    Ok(flipped.map_or(f64::NAN, |n| n as f64 * h))
}

/// The book, and dashed the outline of the one that RK4 turns.
pub fn book(p: &Parameters) -> Result<MovingPicture> {
    let (exact, (h, path)) = (on_the_middle(THROWN)?.free_body()?, by_rk4(p.step)?);
    let middle = |t: f64| exact.angular_velocity(t).y();
    let naive = path.iter().enumerate();
    let naive = naive.map(|(n, (_, middle))| (h * n as f64, *middle));
    let rates = Axis::linear(r"$\Omega_2$ / (rad/s)").range(-1.1, 1.6);
    let graph = Panel::over_axes(Axis::linear("$t$ / s"), rates.step(1.0))
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
        let centre = SpaceVector::zero();
        let nails = [truth, naive].map(|at| at.to_space(BodyVector::new(0.0, 0.95, 0.0)));
        let edges = [[0.9, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.16]];
        let edges = edges.map(|edge| truth.to_space(BodyVector::from_array(edge)));
        let corner = |k: usize| {
            let x = [-0.45, 0.45, 0.45, -0.45][k % 4];
            let y = [-0.6, -0.6, 0.6, 0.6][k % 4];
            naive.to_space(BodyVector::new(x, y, 0.088))
        };
        let scene = View::of(centre, 1.1)
            .camera(Camera::new(0.5, 0.35))
            .solid(Solid::cuboid(centre, edges), Ink::Body)
            .arrow(centre, nails[0], Ink::Body, "exact", Side::Right)
            .dashed((0..5).map(corner), Ink::Wrong)
            .arrow(centre, nails[1], Ink::Wrong, "wrong", Side::Left);
        Ok((alt, scene))
    })
}
