//! The three turns, one after the other: as they are made, and one panel for each triad.

use super::*;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Solid, Stack, View};
use kit::{Figure, MovingPicture, Trajectory, times};

const ORIGIN: SpaceVector = SpaceVector::zero();
/// Where the pictures are seen from: azimuth and elevation of the eye, rad. From here the axes X,
/// x and x' of the page fan out.
const EYE: [f64; 2] = [-0.5, 0.5];
/// The middle of what they show, its height above the origin and its reach to every side.
const MIDDLE: f64 = 0.35;
const REACH: f64 = 1.15;
/// Lengths of the arrows of the fixed axes and of the body's.
const FIXED: f64 = 1.2;
const BODY: f64 = 1.05;

/// The angles when `t` of the three turns are made.
fn made(p: &Parameters, t: f64) -> [f64; 3] {
    let part = |k: f64| (t - k).clamp(0.0, 1.0);
    [part(0.0) * p.phi, part(1.0) * p.theta, part(2.0) * p.zeta]
}

/// What the pictures of all three turns show: centre and reach. Where an axis comes to point
/// far down they show more below.
fn shown(p: &Parameters) -> (SpaceVector, f64) {
    let [(sa, ca), (se, ce)] = EYE.map(sincos);
    let up = SpaceVector::new(-se * ca, -se * sa, ce);
    let tips = times(0.0, 3.0, 60).flat_map(|t| frames(made(p, t))[3]);
    let lowest = tips.map(|axis| BODY * axis.dot(&up)).fold(0.0, f64::min);
    // Room for a label below the tip.
    let missing = (MIDDLE * ce - REACH - (lowest - 0.12)).max(0.0);
    let middle = MIDDLE - 0.5 * missing / ce;
    (SpaceVector::new(0.0, 0.0, middle), REACH + 0.5 * missing)
}

/// Those of three arrows of this length that have names.
pub fn triad(view: View, axes: [SpaceVector; 3], length: f64, names: [&str; 3], ink: Ink) -> View {
    let sides = [Side::Below, Side::Right, Side::Above];
    let each = axes.into_iter().zip(names).zip(sides).filter(|((_, name), _)| !name.is_empty());
    each.fold(view, |view, ((axis, name), side)| view.arrow(ORIGIN, axis * length, ink, name, side))
}

/// The way of an axis while it is turned about another, as an arrow.
fn way(view: View, from: SpaceVector, about: SpaceVector, angle: f64, radius: f64) -> View {
    if angle.abs() < 0.02 {
        return view;
    }
    view.turn(times(0.0, angle, 24).map(|a| turned(from, about, a) * radius), Ink::Velocity)
}

/// A disc in the plane of x and y, with a mark that points along x.
fn body(view: View, [x, _, z]: [SpaceVector; 3]) -> View {
    let face = z * 0.026;
    view.solid(Solid::disc(ORIGIN, z, 0.42, 0.05), Ink::Body)
        .line([face, face + x * 0.42], Ink::Paper)
}

/// The body in the triad that these angles lead to, and the ways of the axes; `view` says what
/// is shown.
fn scene(view: View, angles: [f64; 3], names: [&str; 3]) -> View {
    let [phi, theta, zeta] = angles;
    let [fixed, first, second, last] = frames(angles);
    let view = view.camera(Camera::new(EYE[0], EYE[1])).size(250, 230);
    let view = triad(body(view, last), fixed, FIXED, ["$X$", "$Y$", "$Z$"], Ink::Frame);
    let label = |view: View, on: bool, at: SpaceVector, text: &str| {
        if on { view.text(at, text, Ink::Velocity, Side::Centre) } else { view }
    };
    let middle = |from, about, angle: f64, radius| turned(from, about, 0.5 * angle) * radius;
    let (on_phi, on_theta, on_zeta) = (phi.abs() > 0.1, theta.abs() > 0.1, zeta.abs() > 0.1);
    let view = way(view, fixed[0], fixed[2], phi, 0.8);
    let view = label(view, on_phi, middle(fixed[0], fixed[2], phi, 0.93), "$\\phi$");
    let view = way(view, first[2], first[0], theta, 0.8);
    let view = label(view, on_theta, middle(first[2], first[0], theta, 0.94), "$\\theta$");
    let view = way(view, second[1], second[2], zeta, 0.8);
    let view = label(view, on_zeta, middle(second[1], second[2], zeta, 0.93), "$\\zeta$");
    // Where x and y were, from which x' and y' are turned.
    let view = view.only_if(on_zeta, |view| {
        view.dashed([ORIGIN, second[0] * 0.95], Ink::Ink)
            .dashed([ORIGIN, second[1] * 0.95], Ink::Ink)
    });
    triad(view, last, BODY, names, Ink::Body)
}

/// The notes' figure, panel by panel.
pub fn panels(p: &Parameters) -> Result<[Figure; 4]> {
    let [phi, theta, zeta] = p.angles();
    let (centre, reach) = shown(p);
    let panel = |name, alt, angles, names| {
        let view = View::new(name, alt).around(centre, reach);
        scene(view, angles, names).figure()
    };
    Ok([
        panel(
            "frames_a",
            "A disc lies level in the fixed axes X, Y, Z; its mark points along X",
            [0.0; 3],
            [""; 3],
        )?,
        panel(
            "frames_b",
            "The disc has turned about Z by phi: its axis x is off X by that angle and Y' off Y; Z is where it was",
            [phi, 0.0, 0.0],
            ["$x$", "$Y'$", ""],
        )?,
        panel(
            "frames_c",
            "The disc has tilted about x by theta: z leans off Z by that angle, away from Y', and y has risen above Y'",
            [phi, theta, 0.0],
            ["$x$", "$y$", "$z$"],
        )?,
        panel(
            "frames_d",
            "The disc has turned about its own axis z by zeta: x' and y' are off x and y, which are dashed, by that angle",
            [phi, theta, zeta],
            ["$x'$", "$y'$", "$z$"],
        )?,
    ])
}

/// The three turns against the part that is made, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns =
        ["turns [-]", "phi [rad]", "theta [rad]", "zeta [rad]", "w [-]", "x [-]", "y [-]", "z [-]"];
    Trajectory::sampled(columns, times(0.0, 3.0, 300), |t| {
        let [a, b, c] = made(p, t);
        let [w, x, y, z] = attitude([a, b, c])?.quaternion();
        Ok([t, a, b, c, w, x, y, z])
    })
}

/// The turns as they are made, above the three angles.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let p = p.clone();
    let angle = |i: usize| times(0.0, 3.0, 60).map(|t| (t, made(&p, t)[i])).collect::<Vec<_>>();
    let names = ["$\\phi$", "$\\theta$", "$\\zeta$"];
    let (centre, reach) = shown(&p);
    // At least as high as for the angles of the page, so that larger ones look larger.
    let angles = [p.angles(), Parameters::default().angles()].concat();
    let turns = Axis::linear("turns made").step(1.0);
    let axes = Panel::over_axes(turns, Axis::linear("angle / rad").over(angles));
    let graph = (0..3).fold(axes, |panel, i| {
        let curve = Curve::new(angle(i), Ink::Velocity);
        panel.curve(
            [curve.clone(), curve.clone().dashed(), curve.dotted()][i].clone().label_end(names[i]),
        )
    });
    MovingPicture::new(0.0..=3.0, [0.6, 1.6, 3.0], move |t| {
        let angles = made(&p, t);
        let names = match t {
            t if t <= 1.0 => ["$x$", "$Y'$", ""],
            t if t <= 2.0 => ["$x$", "$y$", "$z$"],
            _ => ["$x'$", "$y'$", "$z$"],
        };
        let [phi, theta, zeta] = angles;
        let alt = format!(
            "A disc with its axes in the fixed axes X, Y, Z, turned so far by {phi:.2} rad about Z, {theta:.2} rad \
             about x and {zeta:.2} rad about z; below, the three angles, each growing while its turn is made."
        );
        let scene = scene(View::of(centre, reach), angles, names);
        Stack::frame(&alt, scene, &graph, t)
    })
    .map(|picture| picture.timed("turns made"))
}
