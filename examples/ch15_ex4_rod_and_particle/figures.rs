//! The set-up, the velocities just after the impact, the paths, and the motion.

use super::{Answer, Blow, Parameters, ratio, scene, turn};
use core::f64::consts::{FRAC_PI_2, TAU};
use rotation_dynamics::Result;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack};
use rotation_dynamics::report::{Figure, MovingPicture, Trajectory, sampled, times};

/// All figures of the page.
pub fn figures(_: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![setup()?, velocities()?, paths()?])
}

fn setup() -> Result<Figure> {
    let alt = "Seen from above: a rod of length l and mass M lies upright in the picture, free on a \
               smooth table; its middle is marked. A particle of mass M comes from the left with \
               the velocity v towards its lower end.";
    Sketch::new("setup", alt)
        .window((-1.25, 0.75), (-0.72, 0.68))
        .bar((0.0, -0.5), (0.0, 0.5), 0.05, Ink::Body)
        .dot((0.0, 0.0), Ink::Body, "middle", Side::Left)
        .disc((-0.75, -0.5), 0.045, Ink::Ink, 0.8)
        .text((-0.75, -0.45), "$M$", Ink::Ink, Side::Above)
        .arrow_along([(-0.68, -0.5), (-0.3, -0.5)], Ink::Ink)
        .text((-0.3, -0.5), "$v$", Ink::Ink, Side::Below)
        .text((0.0, 0.5), "$M$", Ink::Body, Side::Above)
        .dimension((0.5, -0.5), (0.5, 0.5), "$l$", Side::Right)
        .figure()
}

/// Along the rod, just after the impact; equal masses.
fn velocities() -> Result<Figure> {
    let a = ratio(1.0);
    let alt = "The rod just after the impact with arrows for the velocities along it: at the particle \
               four fifths of v to the right, at the centre of mass one half, at the middle one \
               fifth, nothing at a point a sixth of the length beyond the middle, and two fifths \
               to the left at the far end. The tips of the arrows lie on a straight line.";
    let tip = |place: f64| (0.8 * a.after(place), place);
    let rest = a.centre + a.velocity / a.angular_velocity;
    let ends = Curve::new([tip(-0.5), tip(0.5)], Ink::Frame);
    let arrow = |sketch: Sketch, (place, label, side): (f64, &str, Side)| {
        sketch
            .arrow_along([(0.0, place), tip(place)], Ink::Ink)
            .text(tip(place), label, Ink::Ink, side)
    };
    let sketch = Sketch::new("velocities", alt)
        .window((-0.95, 1.25), (-0.68, 0.62))
        .bar((0.0, -0.5), (0.0, 0.5), 0.04, Ink::Body)
        .disc((0.0, -0.5), 0.045, Ink::Ink, 0.8)
        .curve(ends.thin().dashed())
        .dot((0.0, a.centre), Ink::Body, "$S$", Side::Left)
        .ring((0.0, rest), Ink::Ink, "at rest", Side::Right);
    let all = [
        (-0.5, "$4v/5$", Side::Right),
        (a.centre, "$v/2$", Side::Right),
        (0.0, "$v/5$", Side::Right),
        (0.5, "$-2v/5$", Side::Left),
    ];
    all.into_iter().fold(sketch, arrow).figure()
}

/// A turn of the points of a rod of length 1, with the disc that would roll so.
fn paths() -> Result<Figure> {
    let a = ratio(1.0);
    let radius = a.velocity / a.angular_velocity;
    let (rest, end) = (a.centre + radius, 1.06 * TAU / a.angular_velocity);
    let path = |place: f64, ink: Ink| Curve::new(times(0.0, end, 240).map(|t| a.at(t, place)), ink);
    let alt = "Paths of four points of the rod from the impact on. The centre of mass runs straight. \
               The particle makes low waves about it, the point that was at rest makes cusps on a \
               line, the far end makes loops. A circle about the centre of mass through the point \
               at rest touches that line.";
    let at = |t: f64| {
        move |sketch: Sketch| {
            let (low, high) = (a.at(t, -0.5), a.at(t, 0.5));
            sketch
                .bar(low, high, 0.035, Ink::Body)
                .disc(low, 0.045, Ink::Ink, 0.8)
        }
    };
    let last = 0.6 * TAU / a.angular_velocity;
    let sketch = Sketch::new("paths", alt)
        .window((-0.55, 2.95), (-1.12, 0.8))
        .curve(Curve::new([(-0.5, rest), (2.9, rest)], Ink::Frame).thin())
        .disc(a.at(0.0, a.centre), radius, Ink::Frame, 0.1)
        .curve(path(a.centre, Ink::Frame).dashed())
        .curve(path(-0.5, Ink::Ink))
        .curve(path(rest, Ink::Frame).dotted())
        .curve(path(0.5, Ink::Body))
        .text((2.05, 0.38), "far end", Ink::Body, Side::Left)
        .text((1.62, 0.02), "particle", Ink::Ink, Side::Above)
        .text((2.25, a.centre), "$S$", Ink::Frame, Side::Above);
    let drawn = at(0.0)(sketch).ghost(at(last));
    drawn.ring((0.0, rest), Ink::Ink, "", Side::Right).figure()
}

/// Before the impact, in units of l/v.
const APPROACH: f64 = 0.6;

/// The motion for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (s, blow) = (
        scene(p),
        Blow::new(scene(p), p.tolerance, APPROACH, turn(p))?,
    );
    let columns = [
        "t [s]",
        "x_S [m]",
        "y_S [m]",
        "angle [rad]",
        "L_S [kg m^2/s]",
        "P_x [kg m/s]",
        "T [J]",
    ];
    let end = turn(p) * s.unit();
    Trajectory::sampled(columns, times(-APPROACH * s.unit(), end, 500), |t| {
        let state = blow.at(t)?;
        let ([x, y], [push, _]) = (s.centre(&state), s.momentum(&state));
        let momentum = s.angular_momentum(&state, [x, y]);
        Ok([t, x, y, state.q[2], momentum, push, s.energy(&state)])
    })
}

/// The blow, with what is kept and what is not.
pub fn moving(p: &Parameters) -> Result<MovingPicture> {
    let (s, l, a) = (scene(p), p.length, Answer::new(p));
    let blow = Blow::new(s, p.tolerance, APPROACH, turn(p))?;
    let (from, to) = (-APPROACH * s.unit(), turn(p) * s.unit());
    let start = blow.before;
    let (about, push, energy) = (
        s.angular_momentum(&start, s.centre(&start)),
        s.momentum(&start)[0],
        s.energy(&start),
    );
    let instants = || times(from, -1e-9, 20).chain(times(0.0, to, 100));
    let of = |f: &dyn Fn(f64) -> Result<f64>| sampled(instants(), |t| Ok((t, f(t)?)));
    let angular = of(&|t| {
        let state = blow.at(t)?;
        Ok(s.angular_momentum(&state, s.centre(&state)) / about)
    })?;
    let linear = of(&|t| Ok(s.momentum(&blow.at(t)?)[0] / push))?;
    let kinetic = of(&|t| Ok(s.energy(&blow.at(t)?) / energy))?;
    let graph = Panel::new("graph", "")
        .x(Axis::linear("$t$ / s").range(from, to))
        .y(Axis::linear("over the start").range(0.0, 1.2))
        .curve(Curve::new(angular, Ink::Momentum).label_end("$L_S$, $P_x$"))
        .curve(Curve::new(linear, Ink::Ink).dashed())
        .curve(Curve::new(kinetic, Ink::Energy).label_end("$T$"));
    let reach = (a.velocity * to).max(l);
    let draw = move |t: f64| {
        let state = blow.at(t)?;
        let centre = s.centre(&state);
        let hit = t >= 0.0;
        let alt = format!(
            "{} {:.2} s {} the impact. Below, momentum and angular momentum about the centre of \
             mass are one level line; the energy drops at the impact.",
            if hit {
                "Rod and particle drift to the right and turn,"
            } else {
                "The particle comes towards the rod,"
            },
            t.abs(),
            if hit { "after" } else { "before" },
        );
        let place = |place: f64| {
            (
                state.q[0] - place * l * rotation_dynamics::math::sin(state.q[2]),
                state.q[1] + place * l * rotation_dynamics::math::cos(state.q[2]),
            )
        };
        let mut scene = Sketch::new("scene", &alt)
            .window((-0.75 * l, reach + 0.85 * l), (-1.1 * l, 0.75 * l))
            .high(149)
            .curve(
                Curve::new(
                    times(0.0, to, 2).map(|t| (a.velocity * t, a.centre)),
                    Ink::Body,
                )
                .thin()
                .dashed(),
            );
        if hit {
            let trail = times(0.0, t, 120).map(|t| a.at(t, 0.5 * l));
            scene = scene.curve(Curve::new(trail, Ink::Body));
            let turned = state.q[2] - FRAC_PI_2;
            scene = scene.turn(
                (centre[0], centre[1]),
                0.3 * l,
                (turned + 0.3, turned + 1.4),
                Ink::Velocity,
            );
        }
        let scene = scene
            .bar(place(-0.5), place(0.5), 0.04 * l, Ink::Body)
            .disc((state.q[3], state.q[4]), 0.05 * l, Ink::Ink, 0.8)
            .dot((centre[0], centre[1]), Ink::Body, "$S$", Side::Above);
        Stack::frame(&alt, scene, &graph, t)
    };
    MovingPicture::new(from..=to, [0.7 * from, 0.12 * to, 0.55 * to], draw)
}
