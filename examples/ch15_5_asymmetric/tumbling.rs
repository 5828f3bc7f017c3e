//! The book as it tumbles, beside the tip of L on the momentum sphere of the body.

use super::*;
use kit::draw::Camera;

/// Azimuth and elevation of the eye: the middle axis of the sphere points to the reader.
const EYE: (f64, f64) = (0.4, 0.34);
const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

pub fn camera() -> Camera {
    Camera::new(EYE.0, EYE.1)
}

/// Where a direction of the body stands on the drawn sphere: 1 up, 2 to the reader, 3 right.
pub fn on_sphere([one, two, three]: [f64; 3]) -> SpaceVector {
    SpaceVector::new(two, three, one)
}

/// The direction of L on the body's axes at the time t.
pub fn tip(tumble: &Tumble, t: f64) -> Result<[f64; 3]> {
    let size = tumble.momentum();
    Ok(tumble.carried(tumble.rates(t)?).map(|l| l / size))
}

/// The three axes on the sphere of the body, and in ink the two great circles of the separatrix.
pub fn sphere(view: View, [i1, i2, i3]: [f64; 3]) -> View {
    let lean = atan2((i2 / i1 - 1.0).sqrt(), (1.0 - i2 / i3).sqrt());
    let circle = |lean: f64| {
        times(0.0, TAU, 90).map(move |turn| {
            let (s, c) = sincos(turn);
            on_sphere([s * cos(lean), c, s * sin(lean)])
        })
    };
    let view = view.trace(circle(lean), Ink::Ink).trace(circle(-lean), Ink::Ink);
    let axes = [(0, "$1$", Side::Above), (1, "$2$", Side::BelowLeft), (2, "$3$", Side::Right)];
    axes.into_iter().fold(view, |view, (axis, label, side)| {
        let out = on_sphere(unit(axis).to_array());
        view.arrow(out, out * 1.3, Ink::Body, label, side)
    })
}

/// The book about `centre`, as large as the sphere: pages between its covers, the spine on the
/// side -2, and a title on the front cover.
fn book(view: View, p: &Parameters, attitude: &Attitude, centre: SpaceVector) -> View {
    let size = 1.5 / p.length;
    // A thinner one could not be told from a sheet.
    let lengths = [p.length, p.width, p.thickness.max(0.06 * p.length)];
    let edges = [0, 1, 2].map(|i| attitude.to_space(unit(i)) * (lengths[i] * size));
    // The title is a hair above the cover.
    let [a, b, c] = edges.map(|edge| edge * 0.5);
    let title = |x: f64| [-0.6, 0.6].map(|y| centre + a * x + b * y + c * 1.02);
    let (book, pages) = ((centre, edges), [-0.7, 0.7]);
    view.solid(Solid::cuboid(centre, edges), Ink::Body)
        .patch_on(book, (0, 1.01), [[-0.9, 1.0], pages], Ink::Frame, 95)
        .patch_on(book, (0, -1.01), [[-0.9, 1.0], pages], Ink::Frame, 95)
        .patch_on(book, (1, 1.01), [pages, [-1.0, 1.0]], Ink::Frame, 95)
        .line(title(0.6), Ink::Paper)
        .line(title(0.4), Ink::Paper)
}

/// From the start through two flips.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (tumble, p) = (tumble(p)?, p.clone());
    let (motion, flips) = (tumble.free_body()?, tumble.between_flips()?);
    let end = 2.5 * flips;
    let along = sampled(times(0.0, end, 250), |t| Ok((t, tip(&tumble, t)?[1])))?;
    let graph = Panel::over_axes("$t$ / s", Axis::linear("$L_2/L$").range(-1.0, 1.0).step(1.0))
        .curve(Curve::new(along, Ink::Momentum));
    let polhode = sampled(times(0.0, 2.0 * flips, 160), |t| Ok(on_sphere(tip(&tumble, t)?)))?;
    let aside = SpaceVector::new(sin(EYE.0), -cos(EYE.0), 0.0) * 2.35;
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.5 * flips, flips], move |t| {
        let (now, attitude) = (tip(&tumble, t)?, motion.attitude(t));
        let axis = attitude.to_space(unit(1));
        let alt = format!(
            "{t:.2} s after the throw: a book turns about the vertical L, its middle axis 2 {:.0} \
             degrees from it; beside it L as an arrow in the sphere of the body, its tip on a \
             path that runs close to the separatrix and passes close by both ends of axis 2; below, \
             the component of L along axis 2.",
            acos(now[1].clamp(-1.0, 1.0)).to_degrees()
        );
        let view = View::of(aside * 0.5, 1.42).camera(camera()).size(340, 200).ball(Ink::Body);
        let view = sphere(view, tumble.moments)
            .trace(polhode.iter().copied(), Ink::Momentum)
            .arrow(SpaceVector::zero(), on_sphere(now), Ink::Momentum, "", Side::Right)
            .spot(on_sphere(now), Ink::Momentum);
        let view = book(view, &p, &attitude, aside)
            .vector(aside, aside + UP * 1.2, Ink::Momentum, "$L$", Side::Above)
            .arrow(aside, aside + axis * 0.95, Ink::Body, "", Side::Right)
            // Beside L, also where the axis lies along it.
            .text(aside * 0.95 + axis * 0.9, "$2$", Ink::Body, Side::Right);
        Ok((alt, view))
    })
}
