//! The cylinder on its shaft: L goes round Omega, and the torque of the bearings turns it.

use super::*;

pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// A shaft in two bearings, held by a frame behind it.
pub fn bearings(view: View) -> View {
    let (low, high, back) = (UP * -0.92, UP * 0.92, SpaceVector::new(0.15, -0.85, 0.0));
    let frame = [(low + back, high + back), (low, low + back), (high, high + back)];
    let rods = frame.map(|(from, to)| Solid::rod(from, to, 0.03)).into_iter();
    let rings = [low, high].map(|at| Solid::ring(at, UP, 0.07, 0.028));
    let view = rods.chain(rings).fold(view, |view, solid| view.solid(solid, Ink::Frame));
    view.solid(Solid::rod(UP * -1.0, UP * 1.0, 0.02), Ink::Frame)
}

/// L on fixed axes at a time.
fn momentum(shaft: &Shaft, t: f64) -> SpaceVector {
    shaft.attitude(t).to_space(shaft.momentum())
}

/// One moment, without the graph; the cylinder is at most 1.2 long and wide.
fn scene(p: &Parameters, shaft: &Shaft, t: f64) -> View {
    let (attitude, size) = (shaft.attitude(t), 0.95 / shaft.momentum().norm());
    let unit = 0.6 / (0.5 * p.height).max(p.radius);
    let end = attitude.to_space(BodyVector::new(0.0, 0.0, 1.0)) * (0.5 * p.height * unit);
    let tip = momentum(shaft, t) * size;
    let path = times(0.0, TAU / shaft.rate, 90).map(|t| momentum(shaft, t) * size);
    let torque = attitude.to_space(shaft.torque()) * (0.9 * size / shaft.rate.abs());
    let [from, to] = if shaft.rate < 0.0 { [1.35, 1.0] } else { [1.0, 1.35] };
    bearings(View::of(UP * 0.1, 1.3).size(340, 340))
        .solid(Solid::cylinder(-end, end, p.radius * unit), Ink::Body)
        .ground(UP * -1.0, 0.85)
        .dashed(path, Ink::Momentum)
        .arrow(UP * from, UP * to, Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(ORIGIN, tip, Ink::Momentum, "", Side::Right)
        .text(tip * 0.7, "$L$", Ink::Momentum, Side::Below)
        .only_if(torque.norm() > 0.05, |view| {
            view.arrow(tip, tip + torque, Ink::Force, r"$\tau$", Side::Below)
        })
}

/// A turn and a half, and a bit: s.
fn end(shaft: &Shaft) -> f64 {
    1.6 * TAU / shaft.rate.abs()
}

/// That motion.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, shaft) = (p.clone(), Shaft::of(p)?);
    let end = end(&shaft);
    let part = |axis: usize, label: &str| {
        let part = |t| momentum(&shaft, t)[axis];
        Curve::of(times(0.0, end, 160), part, Ink::Momentum).label_end(label)
    };
    let time = Axis::linear("$t$ / s").range(0.0, end);
    let graph = Panel::over_axes(time, r"$L$ / (kg m$^2$/s)")
        .curve(part(0, "$L_X$").dotted())
        .curve(part(1, "$L_Y$").dashed())
        .curve(part(2, "$L_Z$"));
    let side = ["towards", "away from"][usize::from(shaft.i1 > shaft.i3)];
    let (way, near) = match shaft.rate < 0.0 {
        true => ("down", "lower"),
        false => ("up", "upper"),
    };
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.17 * end, 0.36 * end], move |t| {
        let alt = format!(
            "A cylinder slants on an upright shaft in two bearings, {:.2} turns after the start. \
             Omega points {way} along the shaft; L leans {side} the {near} end of the cylinder, and \
             its tip is on a level circle. At the tip the torque points along the circle. Below, \
             the level components of L swing, the upright one stays.",
            t * shaft.rate.abs() / TAU
        );
        Ok((alt, scene(&p, &shaft, t)))
    })
}

/// Angular momentum and torque on fixed axes, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let shaft = Shaft::of(p)?;
    let columns = "t [s], L_X [kg m^2/s], L_Y [kg m^2/s], L_Z [kg m^2/s], tau_X [N m], tau_Y [N m], tau_Z [N m]";
    Trajectory::sampled(columns.split(", "), times(0.0, end(&shaft), 200), |t| {
        let torque = shaft.attitude(t).to_space(shaft.torque());
        Ok([&[t], &momentum(&shaft, t).to_array()[..], &torque.to_array()].concat())
    })
}
