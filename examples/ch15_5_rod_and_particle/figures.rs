//! The set-up, what depends on the masses, and the motion.

use super::*;

/// A rod of length 1, upright.
fn rod() -> Sketch {
    let sketch = Sketch::within((-1.25, 0.75), (-0.72, 0.68));
    sketch.bar((0.0, -0.5), (0.0, 0.5), 0.05, Ink::Body)
}

figures! { _: &Parameters, o = (0.0, 0.0);
    /// Seen from above: a rod of length l lies upright in the picture, hinged at its middle O. A particle comes
    /// from the left with the velocity v towards its lower end. A curved arrow shows the rod turning
    /// counterclockwise.
    setup: rod()
        .pivot(o, 0.0)
        .text(o, "$O$", Ink::Ink, Side::Left)
        .disc((-0.75, -0.5), 0.045, Ink::Ink, 0.8)
        .text((-0.75, -0.45), "$M$", Ink::Ink, Side::Above)
        .arrow_to((-0.68, -0.5), (-0.3, -0.5), Ink::Ink, "$v$", Side::Below)
        .text((0.0, 0.5), "$M$", Ink::Body, Side::Above)
        .dimension((0.5, -0.5), (0.5, 0.5), "$l$", Side::Right)
        .turn(o, 0.3, (-1.35, -0.5), Ink::Velocity)
        .text((0.22, -0.2), r"$\Omega$", Ink::Velocity, Side::BelowRight);

    /// The rod during the impact. At its lower end the particle gives it an impulse to the right; at its middle
    /// the hinge gives it an impulse of the same size to the left. The particle receives an impulse to the left.
    impulses: rod()
        .arrow_to(o, (-0.4, 0.0), Ink::Force, "hinge $J_h$", Side::Above)
        .arrow_to((0.03, -0.5), (0.43, -0.5), Ink::Force, "$J$", Side::Right)
        .disc((-0.5, -0.5), 0.045, Ink::Ink, 0.8)
        .arrow_to((-0.55, -0.5), (-0.95, -0.5), Ink::Force, "$-J$", Side::Above)
        .ring(o, Ink::Ink, "", Side::Right);

    /// Against the mass of the particle over that of the rod, on a logarithmic axis from 0.01 to 100: the speed
    /// of the end over v rises from near zero to one, and the part of the energy that is lost falls from one to
    /// zero. At equal masses the speed is three quarters and the loss one quarter.
    masses: {
        let end = |m: f64| 0.5 * ratio(m).angular_velocity;
        let lost = |m: f64| 1.0 - ratio(m).energies[1] / ratio(m).energies[0];
        let all = times(-2.0, 2.0, 160).map(|x| pow(10.0, x));
        Panel::over_axes(Axis::log("$m/M$"), Axis::linear("").range(0.0, 1.0))
            .curve(Curve::of(all.clone(), end, Ink::Ink).label_at(r"$\Omega l/2v$", 12.0, 0.97, Side::Below))
            .curve(Curve::of(all, lost, Ink::Ink).dashed().label_at("lost", 0.06, 0.85, Side::Right))
            .dot(1.0, end(1.0), Ink::Ink, "3/4", Side::AboveLeft)
            .dot(1.0, lost(1.0), Ink::Ink, "1/4", Side::BelowLeft)
    };
}

/// The motion from before the impact, and its span in s.
fn whole(p: &Parameters) -> Result<(Strike, Blow, [f64; 2])> {
    let (s, approach) = (scene(p, true), 0.8);
    let blow = Blow::new(s, p.tolerance, approach, END)?;
    Ok((s, blow, [-approach * s.unit(), END * s.unit()]))
}

/// Angle, momenta and energy, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (s, blow, [from, to]) = whole(p)?;
    let columns =
        "t [s], angle [rad], omega [rad/s], L [kg m^2/s], P_x [kg m/s], P_y [kg m/s], T [J]";
    Trajectory::sampled(columns.split(", "), times(from, to, 500), |t| {
        let state = blow.at(t)?;
        let ([px, py], l) = (s.momentum(&state), s.angular_momentum(&state, [0.0, 0.0]));
        Ok([t, state.q[2], state.v[2], l, px, py, s.energy(&state)])
    })
}

/// The blow, with what is kept and what is not.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((s, blow, [from, to]), l, o) = (whole(p)?, p.length, (0.0, 0.0));
    // The jump stands at the impact: values before it, then after it.
    let instants = || times(from, -1e-9, 20).chain(times(0.0, to, 200));
    let whole = s.angular_momentum(&blow.before, [0.0, 0.0]);
    let [start, _] = s.momentum(&blow.before);
    let momentum = |t: f64| Ok(s.angular_momentum(&blow.at(t)?, [0.0, 0.0]) / whole);
    let push = |t: f64| Ok(s.momentum(&blow.at(t)?)[0] / start);
    let time = Axis::linear("$t$ / s").range(from, to);
    let graph = Panel::over_axes(time, Axis::linear("over the start").range(-1.0, 1.2))
        .curve(Curve::sampled(instants(), momentum, Ink::Momentum)?.label_end("$L$"))
        .curve(Curve::sampled(instants(), push, Ink::Ink)?.dashed().label_end("$P_x$"));
    let stills = [0.6 * from, 0.05 * to, 0.36 * to];
    MovingPicture::above(graph, from..=to, stills, move |t| {
        let (state, hit, sense) = (blow.at(t)?, t >= 0.0, start.signum());
        let (does, when) = match hit {
            true => ("Rod and particle turn together about the hinge", "after the impact"),
            false => ("The particle comes towards the rod at rest", "before it"),
        };
        let alt = format!(
            "{does}, {:.2} s {when}: below, the angular momentum about the hinge is a level line; the \
             momentum along v jumps down at the impact and then swings.",
            t.abs()
        );
        let (sin, cos) = sincos(state.q[2]);
        let up = |by: f64| (-by * l * sin, by * l * cos);
        let (particle, [px, py]) = ((state.q[3], state.q[4]), s.momentum(&state));
        let (long, turned) = (0.45 * l / start.abs(), state.q[2] - FRAC_PI_2);
        let end = (particle.0 + long * px, particle.1 + long * py);
        let across = if start < 0.0 { (-0.75 * l, l) } else { (-l, 0.75 * l) };
        let turns = (turned + sense * 0.25, turned + sense * 1.2);
        let scene = Sketch::within(across, (-0.72 * l, 0.72 * l))
            .bar(up(-0.5), up(0.5), 0.05 * l, Ink::Body)
            .pivot(o, 0.0)
            .disc(particle, 0.045 * l, Ink::Ink, 0.8)
            .arrow_to(particle, end, Ink::Ink, "$P$", Side::Right)
            .only_if(hit, |scene| scene.turn(o, 0.25 * l, turns, Ink::Velocity));
        Ok((alt, scene))
    })
}
