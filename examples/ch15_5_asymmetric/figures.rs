//! The drawings of the page, but for the tumbling book.

use super::naive::book;
use super::tumbling::{camera, on_sphere, separatrices, sphere, tip};
use super::*;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, View};
use kit::{Figure, sampled};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::pow;

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let tumble = tumble(p)?;
    Ok(vec![
        polhodes(tumble.moments)?,
        rolling(tumble)?,
        herpolhode(tumble)?,
        flips(p, tumble)?,
        waiting(p, tumble)?,
        naive_sphere()?,
        naive_angle()?,
    ])
}

/// Paths of the tip of L on the sphere of the body, for many energies.
fn polhodes(moments: [f64; 3]) -> Result<Figure> {
    let alt = "A ball in the light with the body's axes 1 up, 2 towards the reader, 3 to the right. Closed \
               curves surround the ends of axes 1 and 3. Two great circles that cross at the ends \
               of axis 2 part them; near these ends the curves are hyperbolas.";
    let mut view = sphere(
        View::new("polhodes", alt)
            .camera(camera())
            .around(SpaceVector::zero(), 1.3)
            .solid_ball(Ink::Body),
        separatrices(moments),
    );
    for about in [0, 2] {
        for aside in [0.2, 0.6, 1.1] {
            let tumble = Tumble::new(moments, 1.0, aside, about);
            let whole = 2.0 * tumble.between_flips()?;
            for sign in [1.0, -1.0] {
                let curve = sampled(times(0.0, whole, 90), |t| {
                    let mut tip = tip(&tumble, t)?;
                    tip[about] *= sign;
                    Ok(on_sphere(tip))
                })?;
                view = view.trace(curve, Ink::Momentum);
            }
        }
    }
    view.figure()
}

/// The ellipsoid of energy below its plane, with the two curves.
fn rolling(tumble: Tumble) -> Result<Figure> {
    let alt = "An ellipsoid with a fixed centre touches a level plane from below. L stands upright \
               on the plane; the angular velocity slants from the centre to the point where they \
               touch. A closed curve on the ellipsoid and a curve on the plane run through it.";
    let (motion, flips) = (tumble.free_body()?, tumble.between_flips()?);
    let now = 0.3 * flips;
    let at_now = motion.kinematics(now);
    // Lengths in the height of the plane above the centre.
    let scale = 1.0 / tumble.height();
    let axes = tumble.moments.map(|i| (tumble.momentum() * scale / i).sqrt());
    let profile: Vec<_> = times(0.0, PI, 24).map(|turn| (-cos(turn), sin(turn))).collect();
    let ball = Solid::turned(SpaceVector::zero(), SpaceVector::new(1.0, 0.0, 0.0), &profile);
    let solid = ball.carried(|at| {
        let [x, y, z] = at.to_array();
        at_now.attitude.to_space(BodyVector::new(axes[0] * x, axes[1] * y, axes[2] * z))
    });
    let polhode = sampled(times(0.0, 2.0 * flips, 120), |t| {
        let rates = BodyVector::from_array(tumble.rates(t)?) * (scale * 1.01);
        Ok(at_now.attitude.to_space(rates))
    })?;
    let contact = |t: f64| {
        let at = motion.try_kinematics(t)?;
        // A hair above the ellipsoid.
        Ok(at.attitude.to_space(at.angular_velocity) * (1.01 * scale))
    };
    let plane = sampled(times(now - 1.5 * flips, now + 1.5 * flips, 240), contact)?;
    let top = SpaceVector::new(0.0, 0.0, 1.0);
    View::new("rolling", alt)
        .camera(camera())
        .around(top * 0.2, 1.5)
        .solid(solid, Ink::Body)
        .line(polhode, Ink::Ink)
        .circle(top, top, 0.9, Ink::Frame)
        .line(plane, Ink::Velocity)
        .arrow(SpaceVector::zero(), contact(now)?, Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(SpaceVector::zero(), top * 1.55, Ink::Momentum, "$L$", Side::Above)
        .figure()
}

/// The curve on the plane, from above.
fn herpolhode(tumble: Tumble) -> Result<Figure> {
    let alt = "The herpolhode from above: a curve that swings to and fro between an inner and an \
               outer circle as it goes round, and does not close.";
    let (motion, flips) = (tumble.free_body()?, tumble.between_flips()?);
    let curve = sampled(times(0.0, 7.0 * flips, 900), |t| {
        let at = motion.kinematics(t);
        let [x, y, _] = at.attitude.to_space(at.angular_velocity).to_array();
        Ok((x, y))
    })?;
    let rims = [tumble.across(tumble.start), tumble.across(tumble.rates(0.5 * flips)?)];
    let most = rims[0].max(rims[1]);
    let axis = |label| Axis::linear(label).range(-1.1 * most, 1.1 * most);
    let panel = Panel::new("herpolhode", alt)
        .x(axis(r"$\Omega_X$ / rad/s"))
        .y(axis(r"$\Omega_Y$ / rad/s"))
        .equal_aspect()
        .curve(Curve::new(curve, Ink::Velocity).width(1.2));
    let circle =
        |radius: f64| times(0.0, TAU, 90).map(move |turn| (radius * cos(turn), radius * sin(turn)));
    let panel = rims
        .into_iter()
        .fold(panel, |panel, rim| panel.curve(Curve::new(circle(rim), Ink::Frame).thin().dashed()));
    panel.dot(0.0, 0.0, Ink::Momentum, "$L$", Side::Right).figure()
}

/// L along the middle axis against time, for three starts.
fn flips(p: &Parameters, tumble: Tumble) -> Result<Figure> {
    let alt = "Component of L along the middle axis against time, for a start off by a tenth, a \
               hundredth and a thousandth of a radian: near one, a quick fall to minus one, a rest, \
               and back. The nearer the start, the longer the rests; each flip is as quick.";
    let end = 2.6;
    let starts = [(0.1, "0.1"), (0.01, "0.01"), (0.001, "0.001")];
    let moved = |aside: f64| Tumble::new(tumble.moments, p.rate, aside, tumble.about);
    let unit = 1.0 / moved(0.1).between_flips()?;
    let mut panel = Panel::new("flips", alt)
        .x(Axis::linear(r"$\lambda t$")
            .range(0.0, end / unit * small_motions(tumble.moments, p.rate)[1]))
        .y(Axis::linear("$L_2/L$").range(-1.0, 1.0).step(0.5));
    let pace = small_motions(tumble.moments, p.rate)[1];
    for (k, (aside, label)) in starts.into_iter().enumerate() {
        let tumble = moved(aside);
        let curve = sampled(times(0.0, end / unit, 300), |t| Ok((pace * t, tip(&tumble, t)?[1])))?;
        let curve = Curve::new(curve, Ink::Momentum).faint([1.0, 0.75, 0.5][k]);
        let curve = [curve.clone(), curve.clone().dashed(), curve.dotted()][k].clone();
        let first = 0.5 * tumble.between_flips()?;
        panel =
            panel.curve(curve.label_at(label, pace * first, [0.25, 0.0, -0.25][k], Side::Right));
        let method = Dop853::new(1e-14)?;
        let run = method.solve(&euler(tumble.moments), 0.0, &tumble.start, end / unit, &[])?;
        let dots = sampled(times(0.0, end / unit, 24), |t| {
            Ok((pace * t, tumble.carried(run.at(t)?)[1] / tumble.momentum()))
        })?;
        panel = panel.curve(Curve::new(dots, Ink::Momentum).dots());
    }
    panel.figure()
}

/// Time between flips against the start, on a logarithmic axis.
fn waiting(p: &Parameters, tumble: Tumble) -> Result<Figure> {
    let alt = "Time between flips, times the rate of growth, against the angle by which the start \
               is off, from a billionth of a radian to one: a straight falling line on the \
               logarithmic axis, for both directions, that bends at the right end.";
    let growth = small_motions(tumble.moments, p.rate)[1];
    let wait = |aside: f64, about: usize| {
        Ok(growth * Tumble::new(tumble.moments, p.rate, aside, about).between_flips()?)
    };
    let asides = || times(-9.0, 0.17, 120).map(|x| pow(10.0, x));
    let lines =
        [(0, "off towards axis 1", Side::BelowLeft), (2, "off towards axis 3", Side::AboveRight)];
    let mut panel = Panel::new("waiting", alt)
        .x(Axis::log("off by / rad").range(1e-9, 1.5))
        .y(Axis::linear(r"time between flips, times $\lambda$").range(0.0, 50.0));
    for (about, label, side) in lines {
        let at = wait(1e-5, about)?;
        panel = panel.curve(
            Curve::sampled(asides(), |x| wait(x, about), Ink::Ink)?.label_at(label, 1e-5, at, side),
        );
        let measured = |x: f64| {
            let tumble = Tumble::new(tumble.moments, p.rate, x, about);
            Ok(growth * 2.0 * tumble.flip(1)?.t)
        };
        panel =
            panel.curve(Curve::sampled([1e-8, 1e-6, 1e-4, 1e-2, 0.3], measured, Ink::Body)?.dots());
    }
    panel.figure()
}

/// The tip of L of the naive run against time, brought back to the sphere, until it has
/// turned over.
fn naive_run() -> impl Iterator<Item = (f64, [f64; 3])> {
    let run = Naive::of_the_page(60.0);
    let moments = run.moments;
    run.take(258).zip(1_u32..).map(move |(rates, k)| {
        let carried = [0, 1, 2].map(|i| moments[i] * rates[i]);
        (f64::from(k) / 60.0, carried.map(|l| l / length(carried)))
    })
}

fn naive_sphere() -> Result<Figure> {
    let alt = "On the sphere of the body the true path is a small closed curve about axis 3. The \
               path of the naive run winds outward from it to the separatrix.";
    let true_book = book();
    let curve = sampled(times(0.0, 2.0 * true_book.between_flips()?, 90), |t| {
        Ok(on_sphere(tip(&true_book, t)?))
    })?;
    let moments = true_book.moments;
    let wrong = naive_run().map(|(_, tip)| on_sphere(tip));
    let view = View::new("naive_sphere", alt).camera(camera()).around(SpaceVector::zero(), 1.3);
    sphere(view.ball(Ink::Body), separatrices(moments))
        .trace(wrong, Ink::Wrong)
        .trace(curve, Ink::Momentum)
        .text(on_sphere([-0.62, 0.62, 0.3]), "wrong: Euler", Ink::Wrong, Side::Centre)
        .text(on_sphere([0.0, 0.42, 0.9]), "true", Ink::Momentum, Side::Centre)
        .figure()
}

fn naive_angle() -> Result<Figure> {
    let alt = "Component of L along the largest axis against time: the true one swings a little \
               and stays positive. The naive one, sixty steps a second, swings ever wider and is below \
               zero after four seconds.";
    let (true_book, end) = (book(), 5.0);
    let right =
        Curve::sampled(times(0.0, end, 300), |t| Ok(tip(&true_book, t)?[2]), Ink::Momentum)?;
    let wrong = naive_run().map(|(t, tip)| (t, tip[2]));
    Panel::new("naive_angle", alt)
        .x(Axis::linear("$t$ / s").range(0.0, end))
        .y(Axis::linear("$L_3/L$").range(-1.0, 1.0).step(0.5))
        .curve(Curve::new(wrong, Ink::Wrong).dashed().label_at(
            "wrong: Euler, 60 steps a second",
            0.3,
            -0.55,
            Side::Right,
        ))
        .curve(right.label_at("true", 0.4, 0.62, Side::Below))
        .figure()
}
