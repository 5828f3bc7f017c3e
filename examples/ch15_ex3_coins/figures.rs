//! The drawings of exercise 15.3; lengths in the radius of the fixed coin.

use super::*;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack};
use rotation_dynamics::report::{Figure, MovingPicture, Trajectory, times};

/// All figures of the page.
pub fn figures(_: &Parameters) -> Result<Vec<Figure>> {
    [setup, turns, inside]
        .into_iter()
        .map(|draw| draw())
        .collect()
}

/// The path of the point that touched at the start, while the line of centres turns to `orbit`.
fn path(r: f64, orbit: f64) -> impl Iterator<Item = (f64, f64)> {
    times(0.0, orbit.max(1e-6), 240).map(move |t| place(r, t, r, 0.0).into())
}

/// The coin when the line of centres has turned by `orbit`, with an arrow to the mark.
fn coin(sketch: Sketch, r: f64, orbit: f64) -> Sketch {
    let (middle, mark): ((f64, f64), (f64, f64)) = (
        place(r, orbit, 0.0, 0.0).into(),
        place(r, orbit, r, 0.0).into(),
    );
    sketch
        .disc(middle, r.abs(), Ink::Body, 0.15)
        .arrow_along([middle, place(r, orbit, 0.93 * r, 0.0).into()], Ink::Body)
        .dot(mark, Ink::Body, "", Side::Centre)
}

fn setup() -> Result<Figure> {
    let (r, orbit, o) = (0.6, 0.7, (0.0, 0.0));
    let alt = "A fixed coin of the radius R1 and a smaller one of the radius R2 that touches it from \
               outside. The line of centres has turned by an angle from the level; faint is where \
               the small coin was at the start.";
    let middle: (f64, f64) = place(r, orbit, 0.0, 0.0).into();
    let (s, c) = sincos(orbit);
    let sketch = Sketch::new("setup", alt)
        .window((-1.2, 2.6), (-1.1, 2.5))
        .ghost(|sketch| sketch.disc((1.0 + r, 0.0), r, Ink::Body, 0.15))
        .disc(o, 1.0, Ink::Frame, 0.15)
        .disc(middle, r, Ink::Body, 0.15)
        .curve(Curve::new([o, (1.0 + r, 0.0)], Ink::Frame).thin().dashed())
        .curve(Curve::new([o, middle], Ink::Ink).thin().dashed())
        .angle(o, 0.5, (0.0, orbit), r"$\theta$")
        .arrow_along([o, (-0.7, 0.7)], Ink::Ink)
        .text((-0.35, 0.35), "$R_1$", Ink::Ink, Side::BelowLeft)
        .arrow_along([middle, (middle.0, middle.1 + 0.57)], Ink::Ink)
        .text((middle.0, middle.1 + 0.3), "$R_2$", Ink::Ink, Side::Right)
        .turn(o, 2.35, (0.75, 1.15), Ink::Velocity);
    let (s2, c2) = sincos(0.95);
    sketch
        .text(
            (2.4 * c2, 2.4 * s2),
            r"$\Omega=\dot\theta$",
            Ink::Velocity,
            Side::Left,
        )
        .dot(o, Ink::Ink, "$O_1$", Side::BelowLeft)
        .dot(middle, Ink::Ink, "$O_2$", Side::BelowRight)
        .dot((c, s), Ink::Ink, "", Side::Right)
        .figure()
}

fn turns() -> Result<Figure> {
    let alt = "Turns in a circuit against R1/R2. Outside: a straight line from 1 that rises by 1 for \
               each unit; inside: a straight line two below it, which starts at zero for equal \
               radii and counts turns backward. Dots: simulated.";
    let simulated = |sign: f64, ratios: [f64; 4]| {
        let turns = |x: f64| Ok(rolled(sign / x, TAU, 1e-9)?.end_time() / TAU);
        Curve::sampled(ratios, turns, Ink::Body)
    };
    Panel::new("turns", alt)
        .x(Axis::linear("$R_1/R_2$").range(0.0, 5.0))
        .y(Axis::linear("turns").range(0.0, 6.0))
        .curve(
            Curve::of(times(0.0, 5.0, 2), |x| 1.0 + x, Ink::Ink).label_at(
                "outside",
                3.4,
                4.4,
                Side::AboveLeft,
            ),
        )
        .curve(
            Curve::of(times(1.0, 5.0, 2), |x| x - 1.0, Ink::Ink)
                .dashed()
                .label_at("inside, backward", 2.6, 1.5, Side::BelowRight),
        )
        .curve(simulated(1.0, [0.5, 1.0, 5.0 / 3.0, 3.0])?.dots())
        .curve(simulated(-1.0, [1.5, 2.0, 3.0, 4.0])?.dots())
        .figure()
}

fn inside() -> Result<Figure> {
    let (r, o) = (-2.0 / 3.0, (0.0, 0.0));
    let alt = "A coin rolls inside a ring of one and a half times its radius. A point of its rim draws \
               three arches within the ring; while the coin goes round to the left, its arrow turns \
               to the right.";
    let ring = times(0.0, TAU, 120).map(|t| (sincos(t).1, sincos(t).0));
    let sketch = Sketch::new("inside", alt)
        .window((-1.35, 1.35), (-1.15, 1.15))
        .curve(Curve::new(ring, Ink::Frame).width(3.0))
        .curve(Curve::new(path(r, 2.0 * TAU), Ink::Body).thin().dashed());
    coin(sketch, r, 1.1)
        .turn(o, 1.12, (0.3, 0.8), Ink::Velocity)
        .text((1.12, 0.65), r"$\Omega$", Ink::Velocity, Side::Right)
        .figure()
}

/// A circuit, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (columns, r) = (
        [
            "t [s]",
            "theta_net [rad]",
            "x [m]",
            "y [m]",
            "rim x [m]",
            "rim y [m]",
        ],
        ratio(p)?,
    );
    Trajectory::sampled(columns, times(0.0, TAU, 360), |turn| {
        let ([x, y], [u, v]) = (place(r, turn, 0.0, 0.0), place(r, turn, r, 0.0));
        let net = angular_velocity(r) * turn;
        Ok([
            turn / p.rate,
            net,
            p.inner * x,
            p.inner * y,
            p.inner * u,
            p.inner * v,
        ])
    })
}

/// The coin on its way round, with the path of its mark; below, how far it has turned.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (r, rate) = (ratio(p)?, p.rate);
    let (net, reach) = (angular_velocity(r), 1.0 + 2.0 * r.max(0.0));
    let most = (net * TAU).max(0.0).max(TAU);
    let graph = Panel::new("graph", "")
        .x(Axis::linear("$t$ / s"))
        .y(Axis::linear("turns").range((net).min(0.0), most / TAU));
    let line = |slope: f64| Curve::new([(0.0, 0.0), (TAU / rate, slope)], Ink::Body);
    let graph = graph
        .curve(line(net).label("coin"))
        .curve(line(1.0).dashed().label("line of centres"));
    let draw = move |t: f64| {
        let turn = (rate * t).min(TAU);
        let alt = format!(
            "The line of centres has turned by {:.0} degrees and the coin by {:.0}; dashed, the path of \
             the point of its rim to which the arrow leads. Below, both in turns against time.",
            turn.to_degrees(),
            (net * turn).to_degrees()
        );
        let middle: (f64, f64) = place(r, turn, 0.0, 0.0).into();
        let sketch = Sketch::new("scene", "scene")
            .window((-1.25 * reach, 1.25 * reach), (-1.05 * reach, 1.05 * reach))
            .disc((0.0, 0.0), 1.0, Ink::Frame, 0.15);
        let sketch = coin(sketch, r, turn)
            .curve(Curve::new(path(r, turn), Ink::Body).thin().dashed())
            .curve(Curve::new([(0.0, 0.0), middle], Ink::Ink).thin().dashed());
        Stack::frame(&alt, sketch, &graph, t)
    };
    MovingPicture::new(0.0..=TAU / rate, [0.0, 0.3 * TAU / rate, TAU / rate], draw)
}
