//! The set-up, what depends on the masses, and the motion.

use super::{Answer, Blow, END, Parameters, ratio, scene};
use core::f64::consts::FRAC_PI_2;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack};
use kit::{Figure, MovingPicture, Result, Trajectory, sampled, times};
use rotation_dynamics::math::{pow, sincos};

/// All figures of the page.
pub fn figures(_: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![setup()?, impulses()?, masses()?])
}

fn setup() -> Result<Figure> {
    let alt = "Seen from above: a rod of length l lies upright in the picture, hinged at its middle \
               O. A particle comes from the left with the velocity v towards its lower end. A \
               curved arrow shows the rod turning counterclockwise.";
    Sketch::new("setup", alt)
        .window((-1.25, 0.75), (-0.72, 0.68))
        .bar((0.0, -0.5), (0.0, 0.5), 0.05, Ink::Body)
        .pivot((0.0, 0.0), 0.0)
        .text((0.0, 0.0), "$O$", Ink::Ink, Side::Left)
        .disc((-0.75, -0.5), 0.045, Ink::Ink, 0.8)
        .text((-0.75, -0.45), "$M$", Ink::Ink, Side::Above)
        .arrow_to((-0.68, -0.5), (-0.3, -0.5), Ink::Ink, "$v$", Side::Below)
        .text((0.0, 0.5), "$M$", Ink::Body, Side::Above)
        .dimension((0.5, -0.5), (0.5, 0.5), "$l$", Side::Right)
        .turn((0.0, 0.0), 0.3, (-1.35, -0.5), Ink::Velocity)
        .text((0.22, -0.2), r"$\Omega$", Ink::Velocity, Side::BelowRight)
        .figure()
}

/// What pushes on what during the impact.
fn impulses() -> Result<Figure> {
    let alt = "The rod during the impact. At its lower end the particle gives it an impulse to the \
               right; at its middle the hinge gives it an impulse of the same size to the left. \
               The particle receives an impulse to the left.";
    Sketch::new("impulses", alt)
        .window((-1.25, 0.75), (-0.72, 0.68))
        .bar((0.0, -0.5), (0.0, 0.5), 0.05, Ink::Body)
        .arrow_to((0.0, 0.0), (-0.4, 0.0), Ink::Force, "hinge $J_h$", Side::Above)
        .arrow_to((0.03, -0.5), (0.43, -0.5), Ink::Force, "$J$", Side::Right)
        .disc((-0.5, -0.5), 0.045, Ink::Ink, 0.8)
        .arrow_to((-0.55, -0.5), (-0.95, -0.5), Ink::Force, "$-J$", Side::Above)
        .ring((0.0, 0.0), Ink::Ink, "", Side::Right)
        .figure()
}

/// Speed of the end and loss of energy against the ratio of the masses.
fn masses() -> Result<Figure> {
    let alt = "Against the mass of the particle over that of the rod, on a logarithmic axis from \
               0.01 to 100: the speed of the end over v rises from near zero to one, and the part \
               of the energy that is lost falls from one to zero. At equal masses the speed is three quarters and the \
               loss one quarter.";
    let over = |f: fn(&Answer, f64) -> f64| {
        let points = times(-2.0, 2.0, 160).map(move |x| {
            let m = pow(10.0, x);
            (m, f(&ratio(m), m))
        });
        Curve::new(points, Ink::Ink)
    };
    let equal = ratio(1.0);
    Panel::new("masses", alt)
        .x(Axis::log("$m/M$"))
        .y(Axis::linear("").range(0.0, 1.0))
        .curve(over(|a, _| 0.5 * a.angular_velocity).label_at(
            r"$\Omega l/2v$",
            12.0,
            0.97,
            Side::Below,
        ))
        .curve(over(|a, _| 1.0 - a.energies[1] / a.energies[0]).dashed().label_at(
            "lost",
            0.06,
            0.85,
            Side::Right,
        ))
        .dot(1.0, 0.5 * equal.angular_velocity, Ink::Ink, "3/4", Side::AboveLeft)
        .dot(1.0, 1.0 - equal.energies[1] / equal.energies[0], Ink::Ink, "1/4", Side::BelowLeft)
        .figure()
}

/// Before the impact, in units of l/v.
const APPROACH: f64 = 0.8;

/// Momenta and energy over the particle's at the start, which stay 1 if they are kept.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (scene, blow) = (scene(p, true), Blow::new(scene(p, true), p.tolerance, APPROACH, END)?);
    let columns = [
        "t [s]",
        "angle [rad]",
        "omega [rad/s]",
        "L [kg m^2/s]",
        "P_x [kg m/s]",
        "P_y [kg m/s]",
        "T [J]",
    ];
    Trajectory::sampled(columns, times(-APPROACH * scene.unit(), END * scene.unit(), 500), |t| {
        let state = blow.at(t)?;
        let ([px, py], l) = (scene.momentum(&state), scene.angular_momentum(&state, [0.0, 0.0]));
        Ok([t, state.q[2], state.v[2], l, px, py, scene.energy(&state)])
    })
}

/// The blow, with what is kept and what is not.
pub fn moving(p: &Parameters) -> Result<MovingPicture> {
    let (s, l) = (scene(p, true), p.length);
    let blow = Blow::new(s, p.tolerance, APPROACH, END)?;
    let (from, to) = (-APPROACH * s.unit(), END * s.unit());
    let whole = s.angular_momentum(&blow.before, [0.0, 0.0]);
    let start = s.momentum(&blow.before)[0];
    // The jump stands at the impact: values before it, then after it.
    let instants = || times(from, -1e-9, 20).chain(times(0.0, to, 200));
    let of = |f: &dyn Fn(f64) -> Result<f64>| sampled(instants(), |t| Ok((t, f(t)?)));
    let momentum = of(&|t| Ok(s.angular_momentum(&blow.at(t)?, [0.0, 0.0]) / whole))?;
    let push = of(&|t| Ok(s.momentum(&blow.at(t)?)[0] / start))?;
    let graph = Panel::new("graph", "")
        .x(Axis::linear("$t$ / s").range(from, to))
        .y(Axis::linear("over the start").range(-1.0, 1.2))
        .curve(Curve::new(momentum, Ink::Momentum).label_end("$L$"))
        .curve(Curve::new(push, Ink::Ink).dashed().label_end("$P_x$"));
    let draw = move |t: f64| {
        let state = blow.at(t)?;
        let (sn, cs) = sincos(state.q[2]);
        let up = |by: f64| (-by * l * sn, by * l * cs);
        let particle = (state.q[3], state.q[4]);
        let [px, py] = s.momentum(&state);
        let hit = t >= 0.0;
        let alt = format!(
            "{}, {:.2} s {}: below, the angular momentum about the hinge is a level line; the \
             momentum along v jumps down at the impact and then swings.",
            if hit {
                "Rod and particle turn together about the hinge"
            } else {
                "The particle comes towards the rod at rest"
            },
            t.abs(),
            if hit { "after the impact" } else { "before it" },
        );
        let pushed = (0.45 * l * px / start.abs(), 0.45 * l * py / start.abs());
        let end = (particle.0 + pushed.0, particle.1 + pushed.1);
        let across = if start < 0.0 { (-0.75 * l, l) } else { (-l, 0.75 * l) };
        let mut scene = Sketch::new("scene", &alt)
            .window(across, (-0.72 * l, 0.72 * l))
            .bar(up(-0.5), up(0.5), 0.05 * l, Ink::Body)
            .pivot((0.0, 0.0), 0.0)
            .disc(particle, 0.045 * l, Ink::Ink, 0.8)
            .arrow_to(particle, end, Ink::Ink, "$P$", Side::Right);
        if hit {
            let (turned, sense) = (state.q[2] - FRAC_PI_2, start.signum());
            scene = scene.turn(
                (0.0, 0.0),
                0.25 * l,
                (turned + sense * 0.25, turned + sense * 1.2),
                Ink::Velocity,
            );
        }
        Stack::frame(&alt, scene, &graph, t)
    };
    MovingPicture::new(from..=to, [0.6 * from, 0.05 * to, 0.36 * to], draw)
}
