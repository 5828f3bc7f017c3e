//! Why L leaves Omega, and by how much; the examples are drawn in `setups`.

use super::picture::bearings;
use super::setups;
use super::swarm::{self, Swarm, angle, step};
use super::{Parameters, Shaft, euler, shape};
use core::f64::consts::FRAC_PI_2;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Solid, View};
use kit::{Figure, Result, times};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::sincos;

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![
        dumbbell()?,
        components(p)?,
        angles()?,
        setups::wheel()?,
        setups::coin()?,
        setups::earth()?,
        setups::runner()?,
        setups::plate()?,
    ])
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// Two balls on a stick that slants on the shaft.
fn dumbbell() -> Result<Figure> {
    let end = euler(0.0, 0.8, 0.0).to_space(BodyVector::new(0.0, 0.0, 0.68));
    let momentum = UP.cross(&end);
    let l = end.cross(&momentum) * 2.4;
    let alt = "A stick with a ball at each end slants on an upright shaft. The upper ball, on the \
               left, moves towards the reader, the lower one away. Both have their angular \
               momentum along the same line, which is square to the stick and leans to the right \
               of the shaft, along which Omega points.";
    let view = View::new("dumbbell", alt).around(UP * 0.17, 1.25).size(340, 320);
    bearings(view)
        .solid(Solid::rod(-end, end, 0.022), Ink::Body)
        .solid(Solid::ball(end, 0.12), Ink::Body)
        .solid(Solid::ball(-end, 0.12), Ink::Body)
        .arrow(end, end + momentum, Ink::Ink, "$p$", Side::Below)
        .arrow(-end, -end - momentum, Ink::Ink, "$-p$", Side::Above)
        .arrow(UP, UP * 1.35, Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(SpaceVector::zero(), l, Ink::Momentum, "$L$", Side::Right)
        .text(end * 0.5, "$r$", Ink::Body, Side::AboveRight)
        .figure()
}

/// Omega along the principal axes, and each part times its moment: in the plane of both.
fn components(p: &Parameters) -> Result<Figure> {
    let shaft = Shaft::of(p)?;
    let (s, c) = sincos(p.tilt);
    let ([y, z], o) = ([(c, s), (-s, c)], (0.0, 0.0));
    let along = |(x, y): (f64, f64), by: f64| (x * by, y * by);
    let (omega, l) = (shaft.angular_velocity(), shaft.momentum());
    let (wide, long) = (1.0 / p.rate, 1.25 / l.norm());
    let [oy, oz] = [along(y, omega.y() * wide), along(z, omega.z() * wide)];
    let [ly, lz] = [along(y, l.y() * long), along(z, l.z() * long)];
    let tip = (ly.0 + lz.0, ly.1 + lz.1);
    let side = |from, to, ink| Curve::new([from, to], ink).thin().dashed();
    let alt = "The plane of the cylinder and the shaft. Omega points up. Its part along the \
               cylinder, up to the left, is long, its part square to it short. Times their \
               moments the long part becomes short and the short one long: L points up to the right.";
    let end = along(z, 0.95);
    Sketch::new("components", alt)
        .window((-0.95, 1.4), (-0.75, 1.2))
        .bar((-0.75 * end.0, -0.75 * end.1), (0.75 * end.0, 0.75 * end.1), 0.24, Ink::Body)
        .curve(side(o, along(z, 1.15), Ink::Body))
        .text(along(z, 1.15), "$z$", Ink::Body, Side::Left)
        .curve(side(o, along(y, 1.45), Ink::Body))
        .text(along(y, 1.45), "$y$", Ink::Body, Side::Right)
        .curve(side(oy, (0.0, 1.0), Ink::Velocity))
        .curve(side(oz, (0.0, 1.0), Ink::Velocity))
        .curve(side(ly, tip, Ink::Momentum))
        .curve(side(lz, tip, Ink::Momentum))
        .arrow_to(o, oz, Ink::Velocity, r"$\Omega_z$", Side::Left)
        .arrow_to(o, ly, Ink::Momentum, r"$I_1\Omega_y$", Side::Below)
        .arrow_to(o, oy, Ink::Velocity, r"$\Omega_y$", Side::Below)
        .arrow_to(o, lz, Ink::Momentum, r"$I_3\Omega_z$", Side::Left)
        .arrow_to(o, (0.0, 1.0), Ink::Velocity, r"$\Omega$", Side::Above)
        .arrow_to(o, tip, Ink::Momentum, "$L$", Side::Right)
        .figure()
}

/// The angle between Omega and L for cylinders of several shapes.
fn angles() -> Result<Figure> {
    let alt = "Angle from Omega to L against the angle from the shaft to the cylinder. For a \
               height of root three radii it is zero throughout. A disc leans by up to 0.34 rad; \
               the longer the cylinder, the more its curve approaches the straight line from a \
               right angle to zero, but each curve begins and ends at zero.";
    let mut panel = Panel::new("angles", alt)
        .x(Axis::angle(r"tilt $\theta$ / rad").range(0.0, FRAC_PI_2))
        .y(Axis::angle(r"from $\Omega$ to $L$ / rad").range(0.0, FRAC_PI_2));
    let shapes = [
        (0.0, "disc", 0.62, Side::Above),
        (3.0_f64.sqrt(), r"$\sqrt 3$", 0.9, Side::Above),
        (3.0, "3", 0.6, Side::Below),
        (6.0, "$H/R=6$", 0.75, Side::AboveRight),
        (20.0, "20", 0.45, Side::AboveRight),
    ];
    for (ratio, label, at, side) in shapes {
        let of = |tilt| shape(ratio, tilt).angle();
        let curve = Curve::of(times(0.0, FRAC_PI_2, 200), of, Ink::Ink);
        let summed = times(0.15, 1.5, 5).map(|tilt| (tilt, by_grains(ratio, tilt)));
        panel = panel
            .curve(curve.label_at(label, at, of(at), side))
            .curve(Curve::new(summed, Ink::Momentum).dots());
    }
    panel.figure()
}

/// That angle for a cylinder of radius 1 and this height, summed over its grains.
fn by_grains(height: f64, tilt: f64) -> f64 {
    let place = move |t, grain| euler(t, tilt, 0.0).to_space(grain);
    let grains = swarm::cylinder(1.0, 1.0, height);
    let body = Swarm { grains, place, step: step(1.0) };
    angle(body.angular_momentum(SpaceVector::zero()), UP)
}
