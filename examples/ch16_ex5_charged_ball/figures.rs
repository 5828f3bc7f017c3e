//! The drawings of exercise 16.5; those over qE/mg are for a solid ball and mu = 0.1.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// Over the pull of the field, in weights of the ball.
fn pulls() -> Sweep {
    Sweep::over("$qE/mg$", 0.0, 0.8).at([0.05, 0.15, 0.25, 0.33, 0.4, 0.5, 0.6, 0.7])
}

/// A solid ball with mu = 0.1, R = g = 1.
fn unit(pull: f64) -> Ball {
    let (press, radius, resisting) = (1.0, 1.0, [0.0; 2]);
    Ball { pull, press, radius, shape: 0.4, mu: 0.1, spot: 0.0, resisting, length: 10.0 }
}

/// x'', R phi'' and the part that is lost, simulated.
fn simulated(pull: f64) -> Result<[f64; 3]> {
    let ball = unit(pull);
    let (t, [vx, _, rate]) = ball.rolled(1e3, 1e-10)?;
    let left = (vx * vx + 0.4 * rate * rate) / (2.0 * pull * ball.length);
    Ok([vx / t, -rate / t, 1.0 - left])
}

figures! { p: &Parameters;
    /// A ball of radius R with the charge q lies on a rough slab between a plate with a plus sign on the left
    /// and one with a minus sign on the right. Between the plates the electric field E points to the right, as
    /// does x. The way to the end of the slab is l.
    setup: {
        let plate = |x: f64| Curve::new([(x, 0.06), (x, 1.0)], Ink::Ink).width(4.0);
        let field = |sketch: Sketch, y: f64| sketch.arrow_along([(-0.42, y), (1.62, y)], Ink::Frame);
        let sketch = Sketch::within((-0.75, 1.95), (-0.42, 1.1))
            .wall((-0.6, 0.0), (1.8, 0.0))
            .curve(plate(-0.5))
            .curve(plate(1.7));
        [0.66, 0.84].into_iter().fold(sketch, field)
            .text((-0.56, 0.55), "$+$", Ink::Ink, Side::Left).text((1.76, 0.55), "$-$", Ink::Ink, Side::Right)
            .text((0.6, 0.86), "$E$", Ink::Frame, Side::Above)
            .disc((0.0, 0.24), 0.24, Ink::Body, 0.15)
            .string((0.0, 0.24), (0.0, 0.48), "$R$", Side::Left)
            .dot((0.0, 0.24), Ink::Body, "$q$, $m$", Side::BelowRight)
            .arrow((0.42, 0.24), (0.8, 0.24), Ink::Frame, "$x$", Side::Above)
            .dimension((0.0, -0.17), (1.5, -0.17), r"$\ell$", Side::Below)
    };

    /// The forces on the ball. At its middle the field pulls to the right with q E and gravity down with m g.
    /// At the contact the slab pushes up with N and, with the friction F, to the left. The ball turns
    /// clockwise.
    forces: Sketch::within((-0.62, 0.95), (-0.2, 0.95))
        .wall((-0.6, 0.0), (0.95, 0.0))
        .disc((0.0, 0.4), 0.4, Ink::Body, 0.15)
        .dot((0.0, 0.4), Ink::Body, "", Side::Above)
        .turn((0.0, 0.4), 0.3, (2.6, 1.0), Ink::Velocity).text((-0.13, 0.55), r"$\alpha$", Ink::Velocity, Side::Centre)
        .vector((0.0, 0.4), (1.0, 0.0), 150.0, Ink::Force, "$qE$")
        .vector((0.0, 0.4), (0.0, -0.92), 70.0, Ink::Force, "").text((0.02, 0.24), "$mg$", Ink::Force, Side::Right)
        .vector((-0.05, 0.0), (0.0, 1.0), 65.0, Ink::Force, "").text((-0.07, 0.24), "$N$", Ink::Force, Side::Left)
        .vector((0.0, 0.025), (-1.0, 0.0), 43.0, Ink::Force, "").text((-0.2, 0.03), "$F$", Ink::Force, Side::AboveLeft);

    /// Accelerations over g against q E over m g. Up to 0.35 the middle and the rim have the same acceleration,
    /// which rises as a straight line. Beyond, that of the middle rises more steeply and that of the rim stays.
    /// The simulated dots lie on the lines.
    split: pulls().panel(Axis::linear("acceleration$/g$").range(0.0, 0.72))
        .curve(pulls().exact(|x| unit(x).accelerations()[0]).label_at("$a$", 0.6, 0.5, Side::AboveLeft))
        .curve(pulls().exact(|x| unit(x).accelerations()[1]).label_at(r"$R\alpha$", 0.65, 0.25, Side::Above))
        .curve(pulls().simulated(|x| Ok(simulated(x)?[0]))?)
        .curve(pulls().simulated(|x| Ok(simulated(x)?[1]))?);

    /// The part of the work of the field that is lost, against q E over m g: nothing up to 0.35, then a steep
    /// rise to about 8 per cent near 0.65, and a slow fall. The simulated dots lie on the line.
    lost: pulls().exact_and_simulated(
        Axis::linear("lost of the work").range(0.0, 0.1), |x| unit(x.max(1e-9)).lost().max(0.0), |x| Ok(simulated(x)?[2]))?;

    /// Friction over q E against the turns that the ball has made, for a charge in the middle and for one half
    /// of the radius off it. The first is a level line at two sevenths; the second is a wave about it, highest
    /// after a quarter of a turn and below zero after three quarters.
    ripple: {
        let (k, two) = (p.shape, 4.0 * PI);
        let ball = Ball { mu: 1e3, spot: 0.5 * p.radius, length: two * p.radius, ..Ball::new(p)? };
        let run = ball.run(ball.ahead(), 1e3, 1e-10)?;
        let end = run.event("arrives")?.t;
        let dots = sampled(times(0.0, end, 16), |t| {
            let turns = ball.side() * run.at(t)?.q[0] / (2.0 * PI * p.radius);
            Ok((turns, -run.forces(t)?[0].tangential / ball.pull))
        })?;
        let needed = |spot: f64| move |x: f64| (k + spot * sin(2.0 * PI * x)) / (1.0 + k);
        let turns = || times(0.0, 2.0, 200);
        Panel::over_axes(Axis::linear("turns").range(0.0, 2.0), Axis::linear("$F/qE$").range(-0.2, 0.8))
            .level(0.0, Ink::Frame, "")
            .curve(Curve::of(turns(), needed(0.0), Ink::Ink).dashed().label_at("middle", 0.75, 0.286, Side::Above))
            .curve(Curve::of(turns(), needed(0.5), Ink::Ink).label_at("off it", 0.3, 0.62, Side::AboveRight))
            .curve(Curve::new(dots, Ink::Body).dots())
    };
}

/// The ball that is put down sliding, and how long it is followed.
fn slide(p: &Parameters) -> Result<(Roll, f64)> {
    let ball = Ball::new(p)?;
    let shot = if p.shot == 0.0 { 0.3 } else { p.shot };
    let [a, _] = ball.accelerations();
    let end = 2.0 * shot.abs() / a.abs();
    let far = Ball { length: p.length + 10.0 * shot.abs() * end, ..ball };
    Ok((far.run(far.start(0.0, shot), end, p.tolerance)?, end))
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (run, end) = slide(p)?;
    let columns = "t [s], x [m], turned [rad], vx [m/s], R omega [m/s], friction [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, end, 300), |t| {
        let (MechanismState { q, v }, [force]) = (run.at(t)?, run.forces(t)?);
        let (turned, rim) = (0.0 - q[2], 0.0 - p.radius * v[2]);
        Ok([t, q[0], turned, v[0], rim, -p.mass * force.tangential])
    })
}

/// That ball with the two forces along the slab; below, the velocities of middle and rim.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((run, end), r, ball) = (slide(p)?, p.radius, Ball::new(p)?);
    let speed = |k: usize, unit: f64, ink| {
        Curve::sampled(times(0.0, end, 300), |t| Ok(unit * run.at(t)?.v[k]), ink)
    };
    let rim = speed(2, -r, Ink::Velocity)?.dashed();
    let graph = Panel::over_axes("$t$ / s", "velocity / (m/s)")
        .level(0.0, Ink::Frame, "")
        .curve(speed(0, 1.0, Ink::Body)?.label_end("$v$"))
        .curve(rim.label_at(r"$R\omega$", 0.0, -0.02, Side::AboveRight));
    let ways = sampled(times(0.0, end, 100), |t| Ok(run.at(t)?.q[0]))?;
    let (left, right) =
        ways.iter().fold((0.0_f64, 0.0_f64), |ends, x| (ends.0.min(*x), ends.1.max(*x)));
    // So that the longer of the two forces fits.
    let (pull, field) = (ball.pull.abs(), p.field.signum());
    let most = ball.holding().abs().max(ball.mu * ball.press) / pull;
    let pixels = 60.0 * (1.2 / most).min(1.0);
    let catch = ball.caught(p.shot)[0].clamp(0.0, end);
    let stills = [0.4 * if catch > 0.0 { catch } else { 0.1 * end }, 0.2 * end, 0.85 * end];
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let MechanismState { q: [x, _, turn], v: [vx, _, rate] } = run.at(t)?;
        let rub = run.forces(t)?[0].tangential / pull;
        let slips = (vx + r * rate).abs() > 1e-6 * (vx.abs() + r * rate.abs());
        let does = ["rolls", "slides"][usize::from(slips)];
        let way = ["against the field", "with the field"][usize::from(vx * field > 0.0)];
        let along = ["against", "along"][usize::from(rub * field > 0.0)];
        let alt = format!(
            "After {t:.3} s the ball {does} {way}, and the friction at its contact points {along} the field. \
             Below, the velocities of its middle and of its rim against time."
        );
        let scene = Sketch::within((left - 3.0 * r, right + 4.5 * r), (-0.9 * r, 2.6 * r))
            .high(102)
            .clear((left, right), (0.0, 2.0 * r), [80.0, 90.0, 24.0, 12.0])
            .wall((left - 3.0 * r, 0.0), (right + 4.5 * r, 0.0))
            .roller((x, r), r, FRAC_PI_2 + turn, Ink::Body)
            .vector((x, r), (ball.side(), 0.0), pixels, Ink::Force, "$qE$")
            .vector((x, 0.09 * r), (rub, 0.0), pixels, Ink::Force, "")
            .text((x + 0.3 * r * rub.signum(), -0.16 * r), "$F$", Ink::Force, Side::Below);
        Ok((alt, scene))
    })
}
