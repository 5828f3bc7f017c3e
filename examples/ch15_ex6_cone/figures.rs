//! The drawings of exercise 15.6; lengths over h. What moves is the cone of the parameters, the
//! figures show that of the page.

use super::cone::{UP, drawn, placed, sweep};
use super::*;

use kit::draw::Camera;

/// The half angle of the page.
const ALPHA: f64 = 0.4;

/// How long the line of contact of a cone is, over that of the page.
fn size(a: f64) -> f64 {
    cos(ALPHA) / cos(a)
}

/// A cone of this half angle on its table, with the circle of its rim.
fn on_table(a: f64, attitude: &Attitude) -> View {
    let view = View::of(UP * (0.22 * size(a)), 1.3 * size(a))
        .camera(Camera::new(0.6, 0.42))
        .size(340, 260)
        .ground(SpaceVector::zero(), 1.32 * size(a))
        .dashed(sweep(0.0, TAU, 1.0 / cos(a)), Ink::Frame);
    drawn(view, a, SpaceVector::zero(), attitude)
}

figures! { _: &Parameters;
    /// A cone lies on a table. Its vertex O stays in place; the line along which it touches the table points
    /// along rho and turns about the vertical Z at the rate Omega. Its axis rises from the table by the half
    /// angle alpha; its height is h.
    setup: {
        let (rho, o, attitude) = (level(1.75), SpaceVector::zero(), placed(ALPHA, 1.75, 0.9)?);
        let axis = attitude.axis();
        let rise = times(0.0, ALPHA, 12).map(|b| (rho * cos(b) + UP * sin(b)) * 1.42);
        on_table(ALPHA, &attitude)
            .dashed([o, axis * 1.5], Ink::Body).text(axis * 1.5, "axis", Ink::Body, Side::Above)
            .line(rise, Ink::Ink).text((rho * cos(0.2) + UP * sin(0.2)) * 1.44, r"$\alpha$", Ink::Ink, Side::Right)
            .text(axis * 0.45 + UP * 0.22, "$h$", Ink::Ink, Side::Above)
            .arrow(o, rho * 1.6, Ink::Frame, r"$\hat\rho$", Side::Below)
            .arrow(o, UP * 0.95, Ink::Frame, r"$Z$", Side::Right)
            .turn(sweep(0.2, 2.6, 0.3).map(|p| p + UP * 0.7), Ink::Velocity)
            .text(UP * 0.7 - level(2.17) * 0.3, r"$\Omega$", Ink::Velocity, Side::Left)
            .dot(o, Ink::Ink, "$O$", Side::Below)
    };

    /// The side of the cone, laid out flat: a sector of a circle, less than half of it. Faint sectors of the
    /// same size follow it round the circle; two and a half fill it.
    sector: {
        let (angle, on) = (TAU * sin(ALPHA), |r: f64, t: f64| (r * cos(t), r * sin(t)));
        let outline = |from: f64, to: f64| [(0.0, 0.0)].into_iter().chain(times(from, to, 60).map(move |t| on(1.0, t)));
        let rest = |s: Sketch| s.body(outline(angle, 2.0 * angle), Ink::Body, 0.3).body(outline(2.0 * angle, TAU), Ink::Body, 0.1);
        Sketch::within((-1.35, 1.45), (-1.2, 1.2))
            .guide(times(0.0, TAU, 120).map(|t| on(1.0, t)))
            .ghost(rest)
            .body(outline(0.0, angle), Ink::Body, 0.25)
            .angle((0.0, 0.0), 0.25, (0.0, angle), "")
            .text(on(0.3, 0.5 * angle), r"$2\pi\,\sin\,\alpha$", Ink::Ink, Side::AboveRight)
            .text((0.5, 0.0), r"$h/\cos\,\alpha$", Ink::Ink, Side::Below)
            .text(on(1.0, 0.9), r"$2\pi h\,\tan\,\alpha$", Ink::Body, Side::AboveRight)
            .dot((0.0, 0.0), Ink::Ink, "$O$", Side::Left)
    };

    /// The cone in the upright plane through its axis, lying on the table. From the vertex O omega points along
    /// the table, away from the cone; the angular momentum points up and away. The weight acts below the middle
    /// of the cone, the force of the table farther out.
    vectors: {
        let (slant, w) = (1.0 / cos(ALPHA), 0.3 * 25.0 / 9.80665);
        let (o, top) = ((0.0, 0.0), (slant * cos(2.0 * ALPHA), slant * sin(2.0 * ALPHA)));
        let (cm, d) = ((0.75 * cos(ALPHA), 0.75 * sin(ALPHA)), centre_of_pressure(ALPHA, w));
        let [lx, lz] = angular_momentum(ALPHA).map(|l| 2.0 * l);
        Sketch::within((-1.0, 1.5), (-0.62, 1.1))
            .wall((-0.95, 0.0), (1.45, 0.0))
            .body([o, (slant, 0.0), top], Ink::Body, 0.2)
            .curve(Curve::new([o, (cos(ALPHA), sin(ALPHA))], Ink::Body).thin().dashed())
            .angle(o, 0.45, (0.0, ALPHA), r"$\alpha$")
            .arrow_to(o, (-0.7, 0.0), Ink::Velocity, r"$\omega$", Side::Above)
            .arrow_to(o, (lx, lz), Ink::Momentum, "$L$", Side::Above)
            .arrow_to(cm, (cm.0, cm.1 - 0.55), Ink::Force, "$Mg$", Side::Left)
            .arrow_to((d, 0.0), (d, 0.62), Ink::Force, "$N$", Side::Right)
            .dimension((0.0, -0.48), (d, -0.48), "$d$", Side::Below)
            .curve(Curve::new([(d, 0.0), (d, -0.48)], Ink::Frame).thin().dotted())
            .dot(cm, Ink::Ink, "", Side::Above)
            .dot(o, Ink::Ink, "$O$", Side::BelowLeft)
    };

    /// The square of the rate at which a cone tips or slips, as h Omega^2 over g, against its half angle.
    /// Tipping falls steeply from slender cones to a wide bottom near 0.4 rad and rises to more than 6. For a
    /// coefficient of friction of 0.3 slipping runs below it everywhere; for 1 the two run close together from
    /// 0.25 to 1.2 rad.
    regimes: {
        let tip = Curve::of(times(0.05, 1.5, 200), tips, Ink::Ink);
        let slip = |mu: f64, a: f64, side| {
            let at = move |a: f64| mu / needed(a, 1.0);
            let curve = Curve::of(times(0.0, 1.5, 150), at, Ink::Force).dashed();
            curve.label_at(&format!(r"slips, $\mu={mu}$"), a, at(a), side)
        };
        Panel::over_axes(Axis::linear(r"$\alpha$ / rad").range(0.0, 1.5), Axis::linear(r"$h\Omega^2/g$").range(0.0, 7.0))
            .curve(tip.label_at("tips", 0.1, tips(0.1), Side::Right))
            .curve(slip(0.3, 1.2, Side::BelowRight))
            .curve(slip(1.0, 0.85, Side::AboveLeft))
    };
}

/// Made to roll ever faster, evenly, from rest to the tipping in this time, s.
const END: f64 = 6.0;

/// The rate, how far the line of contact has turned, and where the table bears it, over h, at `t`.
fn sped_up(p: &Parameters, t: f64) -> [f64; 3] {
    let last = p.rate.signum() * (tips(p.half_angle) * p.gravity / p.height).sqrt();
    let rate = last * t / END;
    let borne = centre_of_pressure(p.half_angle, p.height * rate * rate / p.gravity);
    [rate, 0.5 * last * t * t / END, borne]
}

/// Made to roll ever faster, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = ["t [s]", "Omega [rad/s]", "phi [rad]", "d [m]"];
    Trajectory::sampled(columns, times(0.0, END, 300), |t| {
        let [rate, turn, borne] = sped_up(p, t);
        Ok([t, rate, turn, p.height * borne])
    })
}

/// The same with the force of the table. As it tips, the arrows are as long beside the line of
/// contact as those of the cone of the page.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, a, page) = (p.clone(), p.half_angle, Parameters::default());
    let outward = |t: f64| sped_up(&p, t)[2] * cos(a);
    let share = Axis::linear(r"$d\,\cos\,\alpha/h$").range(outward(0.0).min(0.5), 1.05);
    let bearing = Curve::of(times(0.0, END, 120), outward, Ink::Force);
    let graph = Panel::over_axes("$t$ / s", share).level(1.0, Ink::Frame, "rim").curve(bearing);
    let [l, l_page] = [a, ALPHA].map(|a| hypot(angular_momentum(a)[0], angular_momentum(a)[1]));
    let swift = size(a) * (sped_up(&page, END)[0] / sped_up(&p, END)[0].abs());
    let strong = swift * (l_page / l);
    MovingPicture::above(graph, 0.0..=END, [2.3, 4.2, END], move |t| {
        let ([rate, turn, d], [along, up]) = (sped_up(&p, t), angular_momentum(a));
        let (rho, o) = (level(turn + 2.35), SpaceVector::zero());
        let way = ["upward", "downward"][usize::from(up * rate < 0.0)];
        let (omega, l) = match rate < 0.0 {
            true => ("under the cone", "outward"),
            false => ("away from the cone", "away"),
        };
        let alt = format!(
            "The cone after {t:.1} s, at {rate:.1} rad/s. Omega lies along the line of contact and points {omega}, \
             L {way} and {l}. The table bears the cone at {d:.2} of its height from the vertex. \
             Below, that distance over the length of the line of contact against time."
        );
        let momentum = (rho * along + UP * up) * (0.3 * rate * strong);
        let force = rho * d + UP * (0.75 * size(a));
        let view = on_table(a, &rolled(a, turn + 2.35)?)
            .arrow(o, rho * (-0.17 * rate * swift), Ink::Velocity, r"$\omega$", Side::Left)
            .arrow(o, momentum, Ink::Momentum, "$L$", Side::Above)
            .dashed([o, rho / cos(a)], Ink::Ink)
            .arrow(rho * d, force, Ink::Force, "$N$", Side::Right)
            .dot(o, Ink::Ink, "", Side::Below);
        Ok((alt, view))
    })
}
