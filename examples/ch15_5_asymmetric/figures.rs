//! The drawings of the page, but for the tumbling book.

use super::*;
use naive::book;
use tumbling::{camera, on_sphere, sphere, tip};

/// The curve of the tip of L on the sphere of the body.
fn polhode(tumble: &Tumble) -> Result<Vec<[f64; 3]>> {
    sampled(times(0.0, 2.0 * tumble.between_flips()?, 90), |t| tip(tumble, t))
}

/// The page's naive run against time: the tip of L, brought back to the sphere, until it has
/// turned over.
fn naive_run() -> impl Iterator<Item = (f64, [f64; 3])> {
    let run = Naive::of_the_page(60.0);
    let moments = run.moments;
    run.take(258).zip(1_u32..).map(move |(rates, k)| {
        let carried = [0, 1, 2].map(|i| moments[i] * rates[i]);
        (f64::from(k) / 60.0, carried.map(|l| l / length(carried)))
    })
}

figures! { p: &Parameters, tumble = tumble(p)?, motion = tumble.free_body()?, flips = tumble.between_flips()?;
    /// A ball in the light with the body's axes 1 up, 2 towards the reader, 3 to the right. Closed
    /// curves surround the ends of axes 1 and 3. Two great circles that cross at the ends
    /// of axis 2 part them; near these ends the curves are hyperbolas.
    polhodes: {
        let ball = View::of(SpaceVector::zero(), 1.3).camera(camera()).solid_ball(Ink::Body);
        let mut view = sphere(ball, tumble.moments);
        for (about, aside) in [0, 2].into_iter().flat_map(|about| [0.2, 0.6, 1.1].map(|aside| (about, aside))) {
            let curve = polhode(&Tumble::new(tumble.moments, 1.0, aside, about))?;
            for sign in [1.0, -1.0] {
                let there = |tip: &[f64; 3]| on_sphere(tip.but(|tip| tip[about] *= sign));
                view = view.trace(curve.iter().map(there), Ink::Momentum);
            }
        }
        view
    };

    /// An ellipsoid with a fixed centre touches a level plane from below. L stands upright
    /// on the plane; the angular velocity slants from the centre to the point where they
    /// touch. A closed curve on the ellipsoid and a curve on the plane run through it.
    rolling: {
        let now = 0.3 * flips;
        let attitude = motion.kinematics(now).attitude;
        // Lengths in the height of the plane above the centre.
        let scale = 1.0 / tumble.height();
        let [a, b, c] = tumble.moments.map(|i| (tumble.momentum() * scale / i).sqrt());
        let profile: Vec<_> = times(0.0, PI, 24).map(|turn| (-cos(turn), sin(turn))).collect();
        let ball = Solid::turned(SpaceVector::zero(), SpaceVector::new(1.0, 0.0, 0.0), &profile);
        let solid = ball.carried(|at| attitude.to_space(BodyVector::new(a * at.x(), b * at.y(), c * at.z())));
        let polhode = sampled(times(0.0, 2.0 * flips, 120), |t| {
            Ok(attitude.to_space(BodyVector::from_array(tumble.rates(t)?) * (scale * 1.01)))
        })?;
        let contact = |t: f64| {
            let at = motion.try_kinematics(t)?;
            // A hair above the ellipsoid.
            Ok(at.attitude.to_space(at.angular_velocity) * (1.01 * scale))
        };
        let plane = sampled(times(now - 1.5 * flips, now + 1.5 * flips, 240), contact)?;
        let (centre, top) = (SpaceVector::zero(), SpaceVector::new(0.0, 0.0, 1.0));
        View::of(top * 0.2, 1.5)
            .camera(camera())
            .solid(solid, Ink::Body)
            .line(polhode, Ink::Ink)
            .circle(top, top, 0.9, Ink::Frame)
            .line(plane, Ink::Velocity)
            .arrow(centre, contact(now)?, Ink::Velocity, r"$\Omega$", Side::Right)
            .arrow(centre, top * 1.55, Ink::Momentum, "$L$", Side::Above)
    };

    /// The herpolhode from above: a curve that swings to and fro between an inner and an
    /// outer circle as it goes round, and does not close.
    herpolhode: {
        let curve = times(0.0, 7.0 * flips, 900).map(|t| {
            let at = motion.kinematics(t);
            let omega = at.attitude.to_space(at.angular_velocity);
            (omega.x(), omega.y())
        });
        let rims = [tumble.across(tumble.start), tumble.across(tumble.rates(0.5 * flips)?)];
        let most = 1.1 * rims[0].max(rims[1]);
        let axis = |label| Axis::linear(label).range(-most, most);
        let panel = Panel::over_axes(axis(r"$\Omega_X$ / rad/s"), axis(r"$\Omega_Y$ / rad/s"))
            .equal_aspect()
            .curve(Curve::new(curve, Ink::Velocity).width(1.2));
        let circle = |panel: Panel, radius: f64| {
            let points = times(0.0, TAU, 90).map(|turn| (radius * cos(turn), radius * sin(turn)));
            panel.curve(Curve::new(points, Ink::Frame).thin().dashed())
        };
        rims.into_iter().fold(panel, circle).dot(0.0, 0.0, Ink::Momentum, "$L$", Side::Right)
    };

    /// Component of L along the middle axis against time, for a start off by a tenth, a
    /// hundredth and a thousandth of a radian: near one, a quick fall to minus one, a rest,
    /// and back. The nearer the start, the longer the rests; each flip is as quick.
    flips: {
        let pace = small_motions(tumble.moments, p.rate)[1];
        let moved = |aside: f64| Tumble::new(tumble.moments, p.rate, aside, tumble.about);
        let unit = 1.0 / moved(0.1).between_flips()?;
        let end = 2.6 / unit;
        let mut panel = Panel::over_axes(
            Axis::linear(r"$\lambda t$").range(0.0, end * pace),
            Axis::linear("$L_2/L$").range(-1.0, 1.0).step(0.5),
        );
        let dashes: [fn(Curve) -> Curve; 3] = [|curve| curve, Curve::dashed, Curve::dotted];
        let lines = [(0.1, "0.1", 1.0, 0.25), (0.01, "0.01", 0.75, 0.0), (0.001, "0.001", 0.5, -0.25)];
        for ((aside, label, shade, height), dashes) in lines.into_iter().zip(dashes) {
            let tumble = moved(aside);
            let curve = sampled(times(0.0, end, 300), |t| Ok((pace * t, tip(&tumble, t)?[1])))?;
            let curve = dashes(Curve::new(curve, Ink::Momentum).faint(shade));
            let first = 0.5 * tumble.between_flips()?;
            let run = Dop853::new(1e-14)?.solve(&euler(tumble.moments), 0.0, &tumble.start, end, &[])?;
            let dots = sampled(times(0.0, end, 24), |t| {
                Ok((pace * t, tumble.carried(run.at(t)?)[1] / tumble.momentum()))
            })?;
            panel = panel.curve(curve.label_at(label, pace * first, height, Side::Right))
                .curve(Curve::new(dots, Ink::Momentum).dots());
        }
        panel
    };

    /// Time between flips, times the rate of growth, against the angle by which the start
    /// is off, from a billionth of a radian to one: a straight falling line on the
    /// logarithmic axis, for both directions, that bends at the right end.
    waiting: {
        let growth = small_motions(tumble.moments, p.rate)[1];
        let moved = |aside: f64, about: usize| Tumble::new(tumble.moments, p.rate, aside, about);
        let wait = |aside: f64, about: usize| Ok(growth * moved(aside, about).between_flips()?);
        let measured = |aside: f64, about: usize| Ok(growth * 2.0 * moved(aside, about).flip(1)?.0.t);
        let mut panel = Panel::over_axes(
            Axis::log("off by / rad").range(1e-9, 1.5),
            Axis::linear(r"time between flips, times $\lambda$").range(0.0, 50.0),
        );
        for (about, label, side) in
            [(0, "off towards axis 1", Side::BelowLeft), (2, "off towards axis 3", Side::AboveRight)]
        {
            let asides = times(-9.0, 0.17, 120).map(|x| pow(10.0, x));
            let line = Curve::sampled(asides, |x| wait(x, about), Ink::Ink)?;
            let dots = Curve::sampled([1e-8, 1e-6, 1e-4, 1e-2, 0.3], |x| measured(x, about), Ink::Body)?;
            panel = panel.curve(line.label_at(label, 1e-5, wait(1e-5, about)?, side)).curve(dots.dots());
        }
        panel
    };

    /// On the sphere of the body the true path is a small closed curve about axis 3. The
    /// path of the naive run winds outward from it to the separatrix.
    naive_sphere: {
        let view = View::of(SpaceVector::zero(), 1.3).camera(camera()).ball(Ink::Body);
        sphere(view, book().moments)
            .trace(naive_run().map(|(_, tip)| on_sphere(tip)), Ink::Wrong)
            .trace(polhode(&book())?.into_iter().map(on_sphere), Ink::Momentum)
            .text(on_sphere([-0.62, 0.62, 0.3]), "wrong: Euler", Ink::Wrong, Side::Centre)
            .text(on_sphere([0.0, 0.42, 0.9]), "true", Ink::Momentum, Side::Centre)
    };

    /// Component of L along the largest axis against time: the true one swings a little
    /// and stays positive. The naive one, sixty steps a second, swings ever wider and is below
    /// zero after four seconds.
    naive_angle: {
        let right = Curve::sampled(times(0.0, 5.0, 300), |t| Ok(tip(&book(), t)?[2]), Ink::Momentum)?;
        let wrong = Curve::new(naive_run().map(|(t, tip)| (t, tip[2])), Ink::Wrong).dashed();
        Panel::over_axes(Axis::linear("$t$ / s").range(0.0, 5.0), Axis::linear("$L_3/L$").range(-1.0, 1.0).step(0.5))
            .curve(wrong.label_at("wrong: Euler, 60 steps a second", 0.3, -0.55, Side::Right))
            .curve(right.label_at("true", 0.4, 0.62, Side::Below))
    };
}
