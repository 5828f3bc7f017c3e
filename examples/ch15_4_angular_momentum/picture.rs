//! The cylinder on its shaft: L goes round Omega, and the torque of the bearings turns it.

use super::{Parameters, Shaft};
use core::f64::consts::TAU;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, Stack, View};
use kit::{MovingPicture, Result, Trajectory, times};
use rotation_dynamics::frame::{BodyVector, SpaceVector};

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const ALONG: BodyVector = BodyVector::new(0.0, 0.0, 1.0);

/// A shaft in two bearings, held by a frame behind it.
pub fn bearings(view: View) -> View {
    let [low, high] = [UP * -0.92, UP * 0.92];
    let back = SpaceVector::new(0.15, -0.85, 0.0);
    let frame = |view: View, from, to| view.solid(Solid::rod(from, to, 0.03), Ink::Frame);
    let ring = |view: View, at| view.solid(Solid::ring(at, UP, 0.07, 0.028), Ink::Frame);
    let view = frame(view, low + back, high + back);
    let view = frame(frame(view, low, low + back), high, high + back);
    ring(ring(view, low), high).solid(Solid::rod(UP * -1.0, UP * 1.0, 0.02), Ink::Frame)
}

/// The cylinder of these parameters, at most 1.2 long and wide in the view.
fn cylinder(view: View, p: &Parameters, axis: SpaceVector) -> View {
    let unit = 0.6 / (0.5 * p.height).max(p.radius);
    let end = axis * (0.5 * p.height * unit);
    view.solid(Solid::cylinder(-end, end, p.radius * unit), Ink::Body)
}

/// One moment, without the graph.
pub fn scene(p: &Parameters, shaft: &Shaft, t: f64, alt: &str) -> View {
    let (attitude, size) = (shaft.attitude(t), 0.95 / shaft.momentum().norm());
    let momentum = |t| shaft.attitude(t).to_space(shaft.momentum()) * size;
    let tip = momentum(t);
    let path = times(0.0, TAU / shaft.rate, 90).map(momentum);
    let torque = attitude.to_space(shaft.torque()) * (0.9 * size / shaft.rate.abs());
    let [from, to] = if shaft.rate < 0.0 { [1.35, 1.0] } else { [1.0, 1.35] };
    let view = View::new("scene", alt).around(UP * 0.1, 1.3).size(340, 340);
    let view = cylinder(bearings(view), p, attitude.to_space(ALONG))
        .ground(UP * -1.0, 0.85)
        .dashed(path, Ink::Momentum)
        .arrow(UP * from, UP * to, Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(SpaceVector::zero(), tip, Ink::Momentum, "", Side::Right)
        .text(tip * 0.7, "$L$", Ink::Momentum, Side::Below);
    match torque.norm() > 0.05 {
        true => view.arrow(tip, tip + torque, Ink::Force, r"$\tau$", Side::Below),
        false => view,
    }
}

/// A turn and a half, and a bit.
pub fn moving(p: &Parameters) -> Result<MovingPicture> {
    let (p, shaft) = (p.clone(), Shaft::of(p)?);
    let end = 1.6 * TAU / shaft.rate.abs();
    let momentum = |t| shaft.attitude(t).to_space(shaft.momentum()).to_array();
    let mut graph = Panel::new("graph", "")
        .x(Axis::linear("$t$ / s").range(0.0, end))
        .y(Axis::linear(r"$L$ / (kg m$^2$/s)"));
    for (i, label) in ["$L_X$", "$L_Y$", "$L_Z$"].into_iter().enumerate() {
        let curve = Curve::of(times(0.0, end, 160), |t| momentum(t)[i], Ink::Momentum);
        let curve = curve.label_end(label);
        graph = graph.curve(match i {
            0 => curve.dotted(),
            1 => curve.dashed(),
            _ => curve,
        });
    }
    let side = ["towards", "away from"][usize::from(shaft.i1 > shaft.i3)];
    let (way, near) = match shaft.rate < 0.0 {
        true => ("down", "lower"),
        false => ("up", "upper"),
    };
    let draw = move |t: f64| {
        let alt = format!(
            "A cylinder slants on an upright shaft in two bearings, {:.2} turns after the start. \
             Omega points {way} along the shaft; L leans {side} the {near} end of the cylinder, and \
             its tip is on a level circle. At the tip the torque points along the circle. Below, \
             the level components of L swing, the upright one stays.",
            t * shaft.rate.abs() / TAU
        );
        Stack::frame(&alt, scene(&p, &shaft, t, &alt), &graph, t)
    };
    MovingPicture::new(0.0..=end, [0.0, 0.17 * end, 0.36 * end], draw)
}

/// Angular momentum and torque on fixed axes.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let shaft = Shaft::of(p)?;
    let columns = [
        "t [s]",
        "L_X [kg m^2/s]",
        "L_Y [kg m^2/s]",
        "L_Z [kg m^2/s]",
        "tau_X [N m]",
        "tau_Y [N m]",
        "tau_Z [N m]",
    ];
    Trajectory::sampled(columns, times(0.0, 1.6 * TAU / shaft.rate.abs(), 200), |t| {
        let attitude = shaft.attitude(t);
        let [momentum, torque] =
            [shaft.momentum(), shaft.torque()].map(|v| attitude.to_space(v).to_array());
        Ok([&[t], &momentum[..], &torque[..]].concat())
    })
}
