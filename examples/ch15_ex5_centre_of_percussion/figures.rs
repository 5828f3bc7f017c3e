//! The drawings of exercise 15.5; the bat has the length 1.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

figures! { p: &Parameters;
    /// A level bat of length l. The hands hold it at the left, at the distance p from the end of the handle.
    /// The ball comes from below at the distance d from that end and pushes the bat upward with the impulse J.
    setup: Sketch::within((-0.15, 1.15), (-0.45, 0.38))
        .bar((0.0, 0.0), (1.0, 0.0), 0.07, Ink::Body)
        .ring((0.12, 0.0), Ink::Ink, "", Side::Above)
        .text((0.12, 0.05), "hands", Ink::Ink, Side::Above)
        .dot((0.5, 0.0), Ink::Body, "", Side::Above)
        .text((0.5, 0.05), "$S$", Ink::Body, Side::Above)
        .disc((0.8, -0.09), 0.05, Ink::Ink, 0.7)
        .arrow_to((0.8, 0.0), (0.8, 0.25), Ink::Force, "$J$", Side::Right)
        .dimension((0.0, -0.22), (0.8, -0.22), "$d$", Side::Below)
        .dimension((0.0, -0.38), (1.0, -0.38), "$l$", Side::Below)
        .dimension((0.0, 0.24), (0.12, 0.24), "$p$", Side::Above);

    /// Impulse of the hands over that of the ball against the place of the blow: a straight line from minus one
    /// at the hands through minus a quarter at the middle and zero at two thirds of the length to one half at
    /// the tip. Dots: simulated impacts.
    hands: {
        let p = &p.but(|p| p.hands = 0.0);
        let simulated = |x: f64| Ok(rigid(&at(p, x), true)?.reaction);
        Panel::over_axes(Axis::linear("$d/l$").range(0.0, 1.0), Axis::linear("$J_h/J$").range(-1.0, 0.6))
            .level(0.0, Ink::Frame, "")
            .curve(Curve::of(times(0.0, 1.0, 2), |x| reaction(&at(p, x)), Ink::Ink))
            .curve(Curve::sampled([0.05, 0.25, 0.5, 2.0 / 3.0, 0.8, 0.95], simulated, Ink::Force)?.dots())
            .note(0.3, -0.55, Ink::Force, "the hands push back", Side::BelowRight)
            .note(0.76, 0.15, Ink::Force, "they push forward", Side::AboveLeft)
    };

    /// Velocity along a free bat just after the blow, for three places of it. Struck in the middle all points
    /// move alike; struck at two thirds the end of the handle is at rest; struck at the tip that end moves
    /// backward at twice J/m.
    free: {
        let line = |x: f64, ink| Curve::of(times(0.0, 1.0, 2), |s| 1.0 + 12.0 * (x - 0.5) * (s - 0.5), ink);
        Panel::over_axes(Axis::linear("place on the bat, over $l$").range(0.0, 1.0), Axis::linear("velocity over $J/m$").range(-2.0, 4.0))
            .level(0.0, Ink::Frame, "")
            .curve(line(0.5, Ink::Frame).dashed().label_at("$d=l/2$", 0.25, 1.0, Side::Above))
            .curve(line(2.0 / 3.0, Ink::Ink).label_at("$d=2l/3$", 0.9, 1.8, Side::Above))
            .curve(line(1.0, Ink::Body).dotted().label_at("$d=l$", 0.85, 3.1, Side::AboveLeft))
    };

    /// The shape of the slowest bending of a free rod: its ends move one way, its middle the other. It crosses
    /// zero at about a quarter of the length from each end; the right crossing lies farther out than the point
    /// at two thirds.
    bending: Panel::over_axes(Axis::linear("place on the bat, over $l$").range(0.0, 1.0), Axis::linear("bending").range(-2.0, 2.0))
        .level(0.0, Ink::Frame, "")
        .curve(Curve::of(times(0.0, 1.0, 160), shape, Ink::Body))
        .ring(node(), 0.0, Ink::Body, "node", Side::BelowRight)
        .dot(2.0 / 3.0, 0.0, Ink::Ink, "$2l/3$", Side::AboveLeft);
}

/// The blow of the page by a soft ball, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (run, sense) = (Blow::new(Strike::soft(p), SOFT)?, p.speed.signum());
    let columns = "t [s], angle [rad], y ball [m], force of the ball [N], of the hands [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.motion.end_time(), 400), |t| {
        let ([ball, hands], MechanismState { q, .. }) = (run.forces(t)?, run.motion.at(t)?);
        Ok([t, sense * q[2], sense * q[4], sense * ball, sense * hands])
    })
}

/// Bat, ball and forces; below, the forces against time in ms.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (run, p) = (Blow::new(Strike::soft(p), SOFT)?, p.clone());
    let (end, length, arm) = (run.motion.end_time(), p.length, arms(&p)[0]);
    let ([most, _], sense) = (run.largest_forces()?, p.speed.signum());
    // Named at this part of the contact, at this part of the largest force.
    let curve = |k: usize, name: &str, part: f64, high: f64, side: Side| {
        let of = |t| Ok((1e3 * t, sense * 1e-3 * run.forces(t)?[k]));
        let (all, t) = (times(0.0, end, 240), 1e3 * (run.touch + part * p.contact));
        let curve = Curve::new(sampled(all, of)?, Ink::Force);
        Ok::<_, kit::Error>(curve.label_at(name, t, sense * high * 1e-3 * most, side))
    };
    let graph = Panel::over_axes("$t$ / ms", "force / kN")
        .level(0.0, Ink::Frame, "")
        .curve(curve(0, "ball", 0.3, 0.7, Side::Left)?)
        .curve(curve(1, "hands", 0.9, 0.12, Side::AboveRight)?.dashed());
    let stills = [0.3, 1.0, 1.95].map(|part| 1e3 * part * p.contact);
    MovingPicture::above(graph, 0.0..=1e3 * end, stills, move |ms| {
        let t = (1e-3 * ms).min(end);
        let (MechanismState { q, .. }, [ball, hands]) = (run.motion.at(t)?, run.forces(t)?);
        let [turned, pushes, holds] =
            [q[2].to_degrees(), 1e-3 * ball, 1e-3 * hands].map(|odd| sense * odd);
        let alt = format!(
            "{ms:.2} ms: the bat has turned by {turned:.1} degrees, the ball pushes it with {pushes:.1} kN and \
             the hands with {holds:.1} kN. Below, both forces against time."
        );
        let (s, c) = sincos(q[2]);
        let on = |x: f64| {
            let (along, up) = (q[0] + (x - arm) * c, sense * (q[1] + (x - arm) * s));
            (along / length, up / length)
        };
        // The hands are where they are; the bat lies farther back the farther in they hold it.
        let back = p.hands / length;
        let high = if sense < 0.0 { (-0.5, 0.35) } else { (-0.35, 0.5) };
        let ball_at = (q[3] / length, sense * (q[4] / length - 0.075));
        let scene = Sketch::within((-0.12 - back, 1.15 - back), high)
            .bar(on(-p.hands), on(length - p.hands), 0.07, Ink::Body)
            .disc(ball_at, 0.04, Ink::Ink, 0.7)
            .ring(on(0.0), Ink::Ink, "", Side::Below);
        let pushes = [(on(p.hit - p.hands), ball, "ball"), (on(0.0), hands, "hands")];
        let scene = pushes.into_iter().fold(scene, |scene, ((x, y), size, label)| {
            let tip = (x, y + sense * 0.4 * size / most);
            let arrow = |s: Sketch| s.arrow_to((x, y), tip, Ink::Force, label, Side::Right);
            scene.only_if((size / most).abs() > 0.02, arrow)
        });
        Ok((alt, scene))
    })
}
