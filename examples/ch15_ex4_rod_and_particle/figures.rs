//! The drawings of exercise 15.4; but for what moves, of a rod with the length 1.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// The rod at these ends, with the particle on the first.
fn drawn(sketch: Sketch, [low, high]: [(f64, f64); 2]) -> Sketch {
    sketch.bar(low, high, 0.035, Ink::Body).disc(low, 0.045, Ink::Ink, 0.8)
}

figures! { _: &Parameters, a = ratio(1.0), rest = a.centre + a.velocity / a.angular_velocity;
    /// Seen from above: a rod of length l and mass M lies upright in the picture, free on a smooth table; its
    /// middle is marked. A particle of mass M comes from the left with the velocity v towards its lower end.
    setup: Sketch::within((-1.25, 0.75), (-0.72, 0.68))
        .bar((0.0, -0.5), (0.0, 0.5), 0.05, Ink::Body)
        .dot((0.0, 0.0), Ink::Body, "middle", Side::Left)
        .disc((-0.75, -0.5), 0.045, Ink::Ink, 0.8).text((-0.75, -0.45), "$M$", Ink::Ink, Side::Above)
        .arrow_to((-0.68, -0.5), (-0.3, -0.5), Ink::Ink, "$v$", Side::Below)
        .text((0.0, 0.5), "$M$", Ink::Body, Side::Above)
        .dimension((0.5, -0.5), (0.5, 0.5), "$l$", Side::Right);

    /// The rod just after the impact with arrows for the velocities along it: at the particle four fifths of v
    /// to the right, at the centre of mass one half, at the middle one fifth, nothing at a point a sixth of the
    /// length beyond the middle, and two fifths to the left at the far end. The tips of the arrows lie on a
    /// straight line.
    velocities: {
        let tip = |place: f64| (0.8 * a.after(place), place);
        Sketch::within((-0.95, 1.25), (-0.68, 0.62))
            .bar((0.0, -0.5), (0.0, 0.5), 0.04, Ink::Body)
            .disc((0.0, -0.5), 0.045, Ink::Ink, 0.8)
            .curve(Curve::new([tip(-0.5), tip(0.5)], Ink::Frame).thin().dashed())
            .dot((0.0, a.centre), Ink::Body, "$S$", Side::Left)
            .ring((0.0, rest), Ink::Ink, "at rest", Side::Right)
            .arrow_to((0.0, -0.5), tip(-0.5), Ink::Ink, "$4v/5$", Side::Right)
            .arrow_to((0.0, a.centre), tip(a.centre), Ink::Ink, "$v/2$", Side::Right)
            .arrow_to((0.0, 0.0), tip(0.0), Ink::Ink, "$v/5$", Side::Right)
            .arrow_to((0.0, 0.5), tip(0.5), Ink::Ink, "$-2v/5$", Side::Left)
    };

    /// Paths of four points of the rod from the impact on. The centre of mass runs straight. The particle makes
    /// low waves about it, the point that was at rest makes cusps on a line, the far end makes loops. A circle
    /// about the centre of mass through the point at rest touches that line.
    paths: {
        let radius = a.velocity / a.angular_velocity;
        let (last, end) = (0.6 * TAU / a.angular_velocity, 1.06 * TAU / a.angular_velocity);
        let path = |place: f64, ink: Ink| Curve::new(times(0.0, end, 240).map(|t| a.at(t, place)), ink);
        let ends = |t: f64| [-0.5, 0.5].map(|place| a.at(t, place));
        let sketch = Sketch::within((-0.55, 2.95), (-1.12, 0.8))
            .curve(Curve::new([(-0.5, rest), (2.9, rest)], Ink::Frame).thin())
            .disc(a.at(0.0, a.centre), radius, Ink::Frame, 0.1)
            .curve(path(a.centre, Ink::Frame).dashed())
            .curve(path(-0.5, Ink::Ink))
            .curve(path(rest, Ink::Frame).dotted())
            .curve(path(0.5, Ink::Body))
            .text((2.05, 0.38), "far end", Ink::Body, Side::Left)
            .text((1.62, 0.02), "particle", Ink::Ink, Side::Above)
            .text((2.25, a.centre), "$S$", Ink::Frame, Side::Above);
        drawn(sketch, ends(0.0))
            .ghost(|sketch| drawn(sketch, ends(last)))
            .ring((0.0, rest), Ink::Ink, "", Side::Right)
    };
}

/// Before the impact, in units of l/v.
const APPROACH: f64 = 0.6;

/// The motion until one turn after the impact, and its span in s.
fn whole(p: &Parameters) -> Result<(Strike, Blow, [f64; 2])> {
    let (s, end) = (scene(p), turn(p));
    let blow = Blow::new(s, p.tolerance, APPROACH, end)?;
    Ok((s, blow, [-APPROACH * s.unit(), end * s.unit()]))
}

/// It, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (s, blow, [from, to]) = whole(p)?;
    let columns = "t [s], x_S [m], y_S [m], angle [rad], L_S [kg m^2/s], P_x [kg m/s], T [J]";
    Trajectory::sampled(columns.split(", "), times(from, to, 500), |t| {
        let state = blow.at(t)?;
        let ([x, y], [push, _]) = (s.centre(&state), s.momentum(&state));
        let momentum = s.angular_momentum(&state, [x, y]);
        Ok([t, x, y, state.q[2], momentum, push, s.energy(&state)])
    })
}

/// The blow, with what is kept and what is not.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((s, blow, [from, to]), l, a) = (whole(p)?, p.length, Answer::new(p));
    let part = |of: &dyn Fn(&MechanismState<5>) -> f64, ink: Ink| {
        let instants = times(from, -1e-9, 20).chain(times(0.0, to, 100));
        Curve::sampled(instants, |t| Ok(of(&blow.at(t)?) / of(&blow.before)), ink)
    };
    let spin = part(&|state| s.angular_momentum(state, s.centre(state)), Ink::Momentum)?;
    let time = Axis::linear("$t$ / s").range(from, to);
    let graph = Panel::over_axes(time, Axis::linear("over the start").range(0.0, 1.2))
        .curve(spin.label_end("$L_S$, $P_x$"))
        .curve(part(&|state| s.momentum(state)[0], Ink::Ink)?.dashed())
        .curve(part(&|state| s.energy(state), Ink::Energy)?.label_end("$T$"));
    let (reach, right, sense) = ((a.velocity * to).abs().max(l), p.speed > 0.0, p.speed.signum());
    let stills = [0.7 * from, 0.12 * to, 0.55 * to];
    MovingPicture::above(graph, from..=to, stills, move |t| {
        let (state, hit, apart) = (blow.at(t)?, t >= 0.0, t.abs());
        let way = if right { "right" } else { "left" };
        let drifts = format!("Rod and particle drift to the {way} and turn,");
        let (does, when) = match hit {
            true => (drifts.as_str(), "after"),
            false => ("The particle comes towards the rod,", "before"),
        };
        let alt = format!(
            "{does} {apart:.2} s {when} the impact. Below, momentum and angular momentum about the centre of \
             mass are one level line; the energy drops at the impact."
        );
        let ([x, y], (sin, cos)) = (s.centre(&state), sincos(state.q[2]));
        let place = |at: f64| (state.q[0] - at * l * sin, state.q[1] + at * l * cos);
        let ahead = times(0.0, to, 2).map(|t| (a.velocity * t, a.centre));
        let (near, far) = (0.75 * l, reach + 0.85 * l);
        let across = if right { (-near, far) } else { (-far, near) };
        let trail = times(0.0, t.max(0.0), 120).map(|t| a.at(t, 0.5 * l));
        let turns = [0.3, 1.4].map(|on| state.q[2] - FRAC_PI_2 + sense * on);
        let scene = Sketch::within(across, (-1.1 * l, 0.75 * l))
            .high(149)
            .curve(Curve::new(ahead, Ink::Body).thin().dashed())
            .only_if(hit, |scene| {
                let scene = scene.curve(Curve::new(trail, Ink::Body));
                scene.turn((x, y), 0.3 * l, turns.into(), Ink::Velocity)
            })
            .bar(place(-0.5), place(0.5), 0.04 * l, Ink::Body)
            .disc((state.q[3], state.q[4]), 0.05 * l, Ink::Ink, 0.8)
            .dot((x, y), Ink::Body, "$S$", Side::Above);
        Ok((alt, scene))
    })
}
