//! The drawings of section 16.2 (2).

use super::*;
use kit::draw::Camera;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// The direction of the axis at these angles.
fn axis(angles: &EulerAngles) -> SpaceVector {
    let ((s, c), (y, x)) = (sincos(angles.theta), sincos(angles.phi));
    SpaceVector::new(s * y, -s * x, c)
}

/// Where L points.
fn pole(top: &Top) -> SpaceVector {
    SpaceVector::new(0.0, -sin(top.lean), cos(top.lean))
}

/// The motions with Z along L, inside the cone of the axis, and outside.
fn three(p: &Parameters) -> [(Top, &'static str); 3] {
    let top = Top::new(p);
    [(0.0, "along $L$"), (0.5, "inside"), (1.7, "outside")]
        .map(|(part, name)| (top.but(|top| top.lean = part * p.cone), name))
}

/// A panel of the three over time in nods, exact and stepped.
fn over_time(p: &Parameters, y: Axis, which: usize, labels: [(f64, Side); 3]) -> Result<Panel> {
    let mut panel = Panel::over_axes(Axis::linear("$t$ / nods").range(0.0, 2.0), y);
    for ((top, name), (at, side)) in three(p).into_iter().zip(labels) {
        let run = top.stepped(2.0 * top.nod(), 1e-13)?;
        let of = |t: f64| Ok(run.at((t * top.nod()).min(run.end_time()))?[which]);
        let curve = Curve::sampled(times(0.0, 2.0, 240), of, Ink::Body)?;
        let turn = |angle: f64, near: f64| angle + TAU * ((near - angle) / TAU).round();
        let exact = |t: f64| {
            let angles = top.angles(t * top.nod())?;
            // Angles are known up to whole turns.
            Ok(if which == 0 { angles.theta } else { turn(angles.phi, of(t)?) })
        };
        let dots = Curve::sampled(times(0.0, 2.0, 16), exact, Ink::Ink)?.dots();
        panel = panel.curve(curve.label_at(name, at, of(at)?, side)).curve(dots);
    }
    Ok(panel)
}

figures! { p: &Parameters;
    /// The vertical Z, the angular momentum L leaning to the left of it by beta, and the axis z of
    /// the cylinder, which circles L on a dashed cone of the half-angle gamma. Its tilt from Z
    /// changes as it goes round.
    setup: {
        let top = Top { lean: 0.75, cone: 0.4, ..Top::new(p) };
        let angles = top.angles(0.05 * top.nod())?;
        let (z, l) = (axis(&angles), pole(&top));
        let circle = sampled(times(0.0, top.nod(), 80), |t| Ok(axis(&top.angles(t)?)))?;
        let between = |a: SpaceVector, b: SpaceVector, size: f64| {
            times(0.0, 1.0, 24).map(move |k| {
                let v = a * (1.0 - k) + b * k;
                v * (size / v.norm())
            })
        };
        let middle = |a: SpaceVector, b: SpaceVector| (a + b) * (1.0 / (a + b).norm());
        View::of(UP * 0.35 - SpaceVector::new(0.0, 0.3, 0.0), 0.95)
            .camera(Camera::new(-0.7, 0.3))
            .solid(Solid::cylinder(z * -0.3, z * 0.3, 0.12), Ink::Body)
            .dashed(circle, Ink::Body)
            .arrow(SpaceVector::zero(), UP * 1.15, Ink::Frame, "$Z$", Side::Right)
            .arrow(SpaceVector::zero(), l * 1.2, Ink::Momentum, "$L$", Side::Left)
            .arrow(z * 0.3, z, Ink::Body, "$z$", Side::Left)
            .line(between(UP, l, 0.62), Ink::Frame)
            .text(middle(UP, l) * 0.62, r"$\beta$", Ink::Frame, Side::Above)
            .line(between(l, z, 0.85), Ink::Frame)
            .text(middle(l, z) * 0.85, r"$\gamma$", Ink::Frame, Side::Below)
            .line(between(UP, z, 0.97), Ink::Body)
            .text(middle(UP, z) * 0.97, r"$\theta$", Ink::Body, Side::AboveLeft)
    };

    /// Tilt against time for three directions of Z: constant if Z is along L; nodding by a little
    /// if Z is inside the cone of the axis, and by the whole width of the cone if it is outside.
    tilt: over_time(p, Axis::linear(r"$\theta$ / rad").range(0.0, 1.0), 0,
        [(1.5, Side::Above), (0.5, Side::Below), (1.0, Side::Above)])?;

    /// Azimuth of the line of nodes against time for the same three: growing evenly if Z is along
    /// L, unevenly if Z is inside the cone, and swinging to and fro about zero if it is outside.
    azimuth: over_time(p, Axis::linear(r"$\phi$ / rad").range(-2.0, 14.0), 1,
        [(0.4, Side::AboveLeft), (1.25, Side::BelowRight), (1.2, Side::Above)])?;

    /// Effective potential over the energy of the nodding, against the tilt, for Z inside the cone
    /// of the axis and outside. Each is a valley; the level of the energy meets its walls at the
    /// two tilts between which the axis nods. The valley of the second comes down to zero.
    potential: {
        let x = Axis::linear(r"$\theta$ / rad").range(0.0, 1.2);
        let mut panel = Panel::over_axes(x, Axis::linear(r"$V/E'$").range(0.0, 1.6)).level(1.0, Ink::Frame, "$E'$");
        for ((top, name), side) in three(p).into_iter().skip(1).zip([Side::Left, Side::Right]) {
            let (from, to) = ((top.lean - top.cone).abs(), top.lean + top.cone);
            let v = |theta: f64| top.potential(theta) / top.energy();
            let inside = times(0.02, 1.2, 400).filter(|&theta| v(theta) < 1.6);
            let curve = Curve::new(inside.map(|theta| (theta, v(theta))), Ink::Energy);
            let at = if side == Side::Left { from } else { 0.55 * from + 0.45 * to };
            panel = panel.curve(curve.label_at(name, at, v(at), Side::BelowRight));
            panel = panel.dot(from, 1.0, Ink::Body, "", Side::Left).dot(to, 1.0, Ink::Body, "", Side::Right);
        }
        panel
    };
}

/// The wide wobble, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let top = wide(p)?;
    let columns =
        "t [s], theta [rad], phi [rad], zeta [rad], theta' [rad/s], phi' [rad/s], zeta' [rad/s]";
    let run = top.stepped(2.0 * top.nod(), p.tolerance)?;
    Trajectory::of(&run, columns.split(", "), 200, |t, y: [f64; 6]| [&[t], &y[..]].concat())
}

/// The wide wobble: the axis circles L evenly, and nods as seen from Z.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let top = wide(p)?;
    let (nod, l) = (top.nod(), pole(&top));
    let end = 1.5 * nod;
    let tilt = sampled(times(0.0, end, 160), |t| Ok((t, top.angles(t)?.theta)))?;
    let graph =
        Panel::over_axes("$t$ / s", r"$\theta$ / rad").curve(Curve::new(tilt, Ink::Body)).low();
    let path = sampled(times(0.0, end, 400), |t| Ok((t, axis(&top.angles(t)?))))?;
    let circle = sampled(times(0.0, nod, 90), |t| Ok(axis(&top.angles(t)?)))?;
    let (half, radius) = (0.5 * p.height, p.radius);
    let unit = 0.34 / half.max(radius);
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.3 * nod, 0.5 * nod], move |t| {
        let angles = top.angles(t)?;
        let (z, attitude) = (axis(&angles), Attitude::from_euler(angles)?);
        let face = z * (half * unit).max(0.02);
        let rim = face * 1.01 + attitude.to_space(BodyVector::new(radius * unit, 0.0, 0.0));
        let tilt = angles.theta;
        let between = |k: f64| axis(&EulerAngles { theta: k * tilt, ..angles });
        let (meridian, middle) = (times(0.0, 1.0, 24).map(between), between(0.5));
        let alt = format!(
            "A free cylinder {t:.2} s after the start. L stays, to the left of the vertical Z; the \
             axis z, on a dashed circle about L, is {:.0} degrees from Z. Below, this tilt against \
             time.",
            tilt.to_degrees()
        );
        let scene = View::of(UP * 0.34 - SpaceVector::new(0.0, 0.3, 0.0), 0.86)
            .camera(Camera::new(-0.7, 0.38))
            .size(340, 270)
            .solid(Solid::cylinder(-face, face, radius * unit), Ink::Body)
            .line([face * 1.01, rim], Ink::Ink)
            .dashed(circle.clone(), Ink::Body)
            .followed(&path, [t, 0.8 * nod], z, Ink::Body)
            .line(meridian, Ink::Body)
            .arrow(SpaceVector::zero(), UP * 1.15, Ink::Frame, "$Z$", Side::Right)
            .vector(SpaceVector::zero(), l * 1.2, Ink::Momentum, "$L$", Side::Above)
            .arrow(face, z, Ink::Body, "$z$", Side::Left)
            .text(middle, r"$\theta$", Ink::Body, Side::Above)
            .corner(&format!("{t:.2} s"));
        Ok((alt, scene))
    })
}
