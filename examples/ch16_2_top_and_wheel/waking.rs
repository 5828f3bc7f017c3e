//! The picture that moves: a sleeping top that wakes while its spin is braked.

use super::figures::{O, UP};
use super::*;
use models::heavy_top::Pose;
use rotation_dynamics::effects::CoulombBearing;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::scene::Scene;

/// From what to what part of the critical spin the top is braked, and how long that
/// takes in units of sqrt(I1'/m g l).
const FROM: f64 = 1.05;
const TO: f64 = 0.85;
const UNITS: f64 = 50.0;

/// From the tip of a top of height 1 to its centre of mass.
const CENTRE: f64 = 1.0 / 1.7;
/// From the rope to the hub of the wheel; its radius is to scale.
const LEVER: f64 = 0.33;

/// The top that is asked for, or the page's, as its spin goes through the critical one.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    p.motions()?;
    if p.is_driven() {
        let body = p.driven()?;
        let wheel = p.body == "wheel";
        return if wheel { body.moving(LEVER, hanging) } else { body.moving(CENTRE, leaning) };
    }
    let mut bodies = p.bodies().into_iter();
    let asked = bodies.find(|(name, body)| *name == "top" && body.weight_moment() > 0.0);
    let body = asked.map_or(TOP, |(_, body)| body);
    let unit = (body.moment() / body.weight_moment()).sqrt();
    let (end, critical) = (UNITS * unit, body.critical_spin());
    let slope = (FROM - TO) / end;

    // Set upright with a touch.
    let rigid = body.rigid()?;
    let touched = BodyVector::new(0.004 / unit, 0.0, FROM * critical);
    let start = rigid.state(Attitude::IDENTITY, touched)?;
    let brake = CoulombBearing::new(body.i3 * critical * (FROM - TO) / end, &rigid, &start, 0.0)?;
    let scene = Scene::new(rigid).with(body.weight()?).with(brake);
    let run = Dop853::new(1e-10)?.solve(&scene, 0.0, &components(&start), end, &[])?;

    let tilt = |axis: SpaceVector| acos(axis.z().clamp(-1.0, 1.0));
    let path = sampled(times(0.0, end, 700), |t| Ok((t, state(&run.at(t)?)?.attitude.axis())))?;
    let tilts = path.iter().map(|(t, axis)| (*t, tilt(*axis)));
    // The brake's torque is constant.
    let graph = Panel::over_axes("$t$ / s", r"tilt $\theta$ / rad")
        .upright(end * (FROM - 1.0) / (FROM - TO), Ink::Frame, "critical spin")
        .curve(Curve::new(tilts, Ink::Body))
        .low();
    let stills = [0.2, 0.71, 0.81].map(|part| part * end);
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let now = state(&run.at(t)?)?;
        let axis = now.attitude.axis();
        // Angular velocity along the axis over the critical one.
        let ratio = now.angular_momentum.dot(&axis) / (body.i3 * critical);
        let torque = UP.cross(&axis) * 0.95;
        let pulls = torque.norm() >= 0.05;
        let told = match pulls {
            true => ", the torque of the weight and the change that this makes",
            false => ", whose torque is too small to be drawn",
        };
        let alt = format!(
            "A top on its tip at t = {t:.2} s, at {ratio:.2} of the critical spin: its axis leans at {:.2} rad; \
             arrows show its angular momentum, its weight{told}; a fading ribbon shows where the upper end of \
             the axis has been; below, the tilt against time, with a line where the spin is critical",
            tilt(axis),
        );
        // A mark on the shoulder, turned from the side that faces X.
        let (s, c) = sincos(critical * t * (FROM - 0.5 * slope * t));
        let x = SpaceVector::new(1.0, 0.0, 0.0);
        let side = x - axis * x.dot(&axis);
        let side = side / side.norm().max(1e-9);
        let spoke = side * c + axis.cross(&side) * s;
        let centre = axis * CENTRE;
        let momentum = now.angular_momentum / (body.i3 * critical) * 1.25;
        let view = View::of(UP * 0.58, 0.84).size(340, 270).table(O, 0.9);
        // At the tip the arrow of L is thicker than the body, and is left out.
        let view = top(view.dashed([O, UP * 1.45], Ink::Frame), axis, spoke)
            .vector(momentum * 0.2, momentum, Ink::Momentum, "$L$", Side::Left)
            .arrow_from_within(centre, centre - UP * 0.4, Ink::Force, "$mg$", Side::Left)
            .only_if(pulls, |view| {
                let later = momentum + torque * 0.6;
                view.arrow(O, torque, Ink::Force, "torque", Side::Below).vector(
                    momentum,
                    later,
                    Ink::Momentum,
                    r"$\mathrm{d}L$",
                    Side::Right,
                )
            })
            .followed(&path, [t, 0.3 * end], axis, Ink::Body)
            .corner(&format!("spin / critical $=$ {ratio:.2}"));
        Ok((alt, view))
    })
}

/// A top that leans.
fn leaning(pose: &Pose) -> View {
    let view = View::of(UP * 0.45, 1.1).size(340, 280).table(O, 1.0);
    top(view, pose.axis(), pose.spoke(0.0))
}

/// With the top, a mark on its shoulder along the spoke.
fn top(view: View, axis: SpaceVector, spoke: SpaceVector) -> View {
    let mark = [(1.19, 0.3), (1.09, 0.72)].map(|(h, r)| (axis * h + spoke * r) * CENTRE);
    view.solid(Solid::top(axis * CENTRE, axis, CENTRE, 0.0), Ink::Body).line(mark, Ink::Paper)
}

/// The wheel hung by one end of its axle.
fn hanging(pose: &Pose) -> View {
    let (axis, hub, radius) = (pose.axis(), pose.axis() * LEVER, LEVER * 0.33 / WHEEL.length);
    let spokes = (0..8).map(|i| {
        let out = pose.spoke(TAU * f64::from(i) / 8.0);
        Solid::rod(hub, hub + out * radius, 0.01)
    });
    let rim = Solid::ring(hub, axis, radius, 0.03);
    let wheel = spokes.fold(rim.with(Solid::rod(O, axis, 0.02)), Solid::with);
    View::of(UP * 0.2, 1.25).size(340, 320).line([O, UP], Ink::Ink).solid(wheel, Ink::Body)
}
