//! The drawings of exercise 15.3; lengths in the radius of the fixed coin.

use super::*;

/// The path of the point that touched at the start, while the line of centres turns to `orbit`.
fn path(r: f64, orbit: f64) -> impl Iterator<Item = (f64, f64)> {
    let orbit = if orbit.abs() < 1e-6 { 1e-6 } else { orbit };
    times(0.0, orbit, 240).map(move |t| place(r, t, r, 0.0).into())
}

/// The coin when the line of centres has turned by `orbit`, with an arrow to the mark.
fn coin(sketch: Sketch, r: f64, orbit: f64) -> Sketch {
    let at = |distance| <(f64, f64)>::from(place(r, orbit, distance, 0.0));
    sketch
        .disc(at(0.0), r.abs(), Ink::Body, 0.15)
        .arrow_along([at(0.0), at(0.93 * r)], Ink::Body)
        .dot(at(r), Ink::Body, "", Side::Centre)
}

figures! { _: &Parameters;
    /// A fixed coin of the radius R1 and a smaller one of the radius R2 that touches it from outside. The line
    /// of centres has turned by an angle from the level; faint is where the small coin was at the start.
    setup: {
        let (r, orbit, o) = (0.6, 0.7, (0.0, 0.0));
        let middle: (f64, f64) = place(r, orbit, 0.0, 0.0).into();
        Sketch::within((-1.2, 2.6), (-1.1, 2.5))
            .ghost(|sketch| sketch.disc((1.0 + r, 0.0), r, Ink::Body, 0.15))
            .disc(o, 1.0, Ink::Frame, 0.15)
            .disc(middle, r, Ink::Body, 0.15)
            .guide([o, (1.0 + r, 0.0)])
            .curve(Curve::new([o, middle], Ink::Ink).thin().dashed())
            .angle(o, 0.5, (0.0, orbit), r"$\theta$")
            .arrow_along([o, (-0.7, 0.7)], Ink::Ink).text((-0.35, 0.35), "$R_1$", Ink::Ink, Side::BelowLeft)
            .arrow_along([middle, (middle.0, middle.1 + 0.57)], Ink::Ink)
            .text((middle.0, middle.1 + 0.3), "$R_2$", Ink::Ink, Side::Right)
            .turn(o, 2.35, (0.75, 1.15), Ink::Velocity)
            .text((2.4 * cos(0.95), 2.4 * sin(0.95)), r"$\Omega=\dot\theta$", Ink::Velocity, Side::Left)
            .dot(o, Ink::Ink, "$O_1$", Side::BelowLeft)
            .dot(middle, Ink::Ink, "$O_2$", Side::BelowRight)
            .dot((cos(orbit), sin(orbit)), Ink::Ink, "", Side::Right)
    };

    /// Turns in a circuit against R1/R2. Outside: a straight line from 1 that rises by 1 for each unit; inside:
    /// a straight line two below it, which starts at zero for equal radii and counts turns backward. Dots:
    /// simulated.
    turns: {
        let ratio = Sweep::over("$R_1/R_2$", 0.0, 5.0);
        let turns = |sign: f64| move |x: f64| Ok(rolled(sign / x, TAU, 1e-9)?.end_time() / TAU);
        let (out, within) = (ratio.clone().at([0.5, 1.0, 5.0 / 3.0, 3.0]), ratio.at([1.5, 2.0, 3.0, 4.0]).beyond(1.0));
        out.panel(Axis::linear("turns").range(0.0, 6.0))
            .curve(out.exact(|x| 1.0 + x).label_at("outside", 3.4, 4.4, Side::AboveLeft))
            .curve(within.exact(|x| x - 1.0).dashed().label_at("inside, backward", 2.6, 1.5, Side::BelowRight))
            .curve(out.simulated(turns(1.0))?)
            .curve(within.simulated(turns(-1.0))?)
    };

    /// A coin rolls inside a ring of one and a half times its radius. A point of its rim draws three arches
    /// within the ring; while the coin goes round to the left, its arrow turns to the right.
    inside: {
        let (r, o) = (-2.0 / 3.0, (0.0, 0.0));
        let ring = times(0.0, TAU, 120).map(|t| (cos(t), sin(t)));
        let sketch = Sketch::within((-1.35, 1.35), (-1.15, 1.15))
            .curve(Curve::new(ring, Ink::Frame).width(3.0))
            .curve(Curve::new(path(r, 2.0 * TAU), Ink::Body).thin().dashed());
        coin(sketch, r, 1.1)
            .turn(o, 1.12, (0.3, 0.8), Ink::Velocity).text((1.12, 0.65), r"$\Omega$", Ink::Velocity, Side::Right)
    };
}

/// A circuit, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "t [s], theta_net [rad], x [m], y [m], rim x [m], rim y [m]";
    let (r, a) = (ratio(p)?, p.inner);
    Trajectory::sampled(columns.split(", "), times(0.0, TAU, 360), |turn| {
        let (t, turn) = (turn / p.rate.abs(), p.rate.signum() * turn);
        let ([x, y], [u, v]) = (place(r, turn, 0.0, 0.0), place(r, turn, r, 0.0));
        Ok([t, angular_velocity(r) * turn, a * x, a * y, a * u, a * v])
    })
}

/// The coin on its way round, with the path of its mark; below, how far it has turned.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (r, rate, sense) = (ratio(p)?, p.rate, p.rate.signum());
    let (net, end, reach) = (angular_velocity(r), TAU / rate.abs(), 1.0 + 2.0 * r.max(0.0));
    let line = |turns: f64| Curve::new([(0.0, 0.0), (end, sense * turns)], Ink::Body);
    let (low, high) = (net.min(0.0), net.max(1.0));
    let (low, high) = if rate < 0.0 { (-high, -low) } else { (low, high) };
    let graph = Panel::over_axes("$t$ / s", Axis::linear("turns").range(low, high))
        .curve(line(net).label("coin"))
        .curve(line(1.0).dashed().label("line of centres"));
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.3 * end, end], move |t| {
        let turn = (rate * t).clamp(-TAU, TAU);
        let [line, turned] = [turn, net * turn].map(f64::to_degrees);
        let alt = format!(
            "The line of centres has turned by {line:.0} degrees and the coin by {turned:.0}; dashed, the path of \
             the point of its rim to which the arrow leads. Below, both in turns against time."
        );
        let (o, middle) = ((0.0, 0.0), place(r, turn, 0.0, 0.0).into());
        let window = |share: f64| (-share * reach, share * reach);
        let sketch = Sketch::within(window(1.25), window(1.05)).disc(o, 1.0, Ink::Frame, 0.15);
        let sketch = coin(sketch, r, turn)
            .curve(Curve::new(path(r, turn), Ink::Body).thin().dashed())
            .curve(Curve::new([o, middle], Ink::Ink).thin().dashed());
        Ok((alt, sketch))
    })
}
