//! The drawings of exercise 16.1; those over the friction or the pulley are for m1 = 3/2 m2.

use super::*;

/// The drawing of a machine, in m, with its pulley of this radius at the origin and the masses
/// so far below it, the heavier one on this side (-1 is left).
fn drawn(sketch: Sketch, radius: f64, [left, right]: [f64; 2], turn: f64, side: f64) -> Sketch {
    let (heavy, light) = ((1.25 * 0.15, 0.24), (0.15, 0.18));
    let (first, second) = if side > 0.0 { (light, heavy) } else { (heavy, light) };
    sketch
        .wall((0.25, 0.32), (-0.25, 0.32))
        .pulley((0.0, 0.0), radius, turn, (0.0, 0.32))
        .rope([(-radius, -left), (-radius, 0.0)])
        .rope(times(0.0, PI, 40).map(|t| (radius * cos(t), radius * sin(t))))
        .rope([(radius, 0.0), (radius, -right)])
        .block((-radius, -left - 0.5 * first.1), first, 0.0, Ink::Body)
        .block((radius, -right - 0.5 * second.1), second, 0.0, Ink::Body)
}

/// m1 = 3, m2 = 2 with g = 1, a pulley and a grip.
fn unit(usual: Machine, pulley: f64, grip: f64) -> Machine {
    Machine { pulley, grip, gravity: 1.0, ..usual }
}

figures! { _: &Parameters, usual = machine(&Parameters::default())?;
    /// Two masses hang on a rope over a pulley that is held from above. The pulley has the moment of inertia I
    /// and the radius R. On the left hangs m1, on the right m2; both hang the height h below the axle.
    setup: {
        drawn(Sketch::within((-0.7, 0.75), (-0.95, 0.45)), 0.2, [0.6, 0.6], 0.6, -1.0)
            .text((-0.31, -0.72), "$m_1$", Ink::Body, Side::Left).text((0.29, -0.69), "$m_2$", Ink::Body, Side::Right)
            .text((0.21, 0.1), "$I$, $R$", Ink::Frame, Side::Right)
            .dimension((0.55, -0.6), (0.55, 0.0), "$h$", Side::Right)
            .gravity((-0.6, 0.25), 0.25)
    };

    /// The three bodies apart. On m1 its weight pulls downward and T1 upward, on m2 its weight and T2, and on
    /// the rim of the pulley T1 on the left and T2 on the right, both downward; T1 is the longer arrow, and the
    /// pulley turns to the left.
    forces: {
        let sketch = Sketch::within((-0.75, 0.75), (-1.15, 0.4))
            .pulley((0.0, 0.0), 0.2, 0.6, (0.0, 0.32))
            .wall((0.25, 0.32), (-0.25, 0.32))
            .block((-0.4, -0.75), (0.2, 0.24), 0.0, Ink::Body)
            .block((0.4, -0.75), (0.16, 0.18), 0.0, Ink::Body);
        let forces = [
            ((-0.2, 0.0), -0.26, "$T_1$", Side::Left), ((0.2, 0.0), -0.23, "$T_2$", Side::Right),
            ((-0.4, -0.63), 0.26, "$T_1$", Side::Left), ((0.4, -0.66), 0.23, "$T_2$", Side::Right),
            ((-0.4, -0.75), -0.31, "$m_1g$", Side::Left), ((0.4, -0.75), -0.2, "$m_2g$", Side::Right),
        ];
        forces.into_iter().fold(sketch, |sketch, (from, length, label, side)| {
            sketch.arrow_to(from, (from.0, from.1 + length), Ink::Force, label, side)
        })
            .turn((0.0, 0.0), 0.27, (1.0, 2.1), Ink::Velocity).text((-0.15, 0.25), r"$\alpha$", Ink::Velocity, Side::Left)
            .arrow_along([(-0.62, -0.65), (-0.62, -0.85)], Ink::Ink).text((-0.62, -0.75), "$a$", Ink::Ink, Side::Left)
            .arrow_along([(0.6, -0.85), (0.6, -0.65)], Ink::Ink).text((0.6, -0.75), "$a$", Ink::Ink, Side::Right)
    };

    /// Both tensions over m2 g against I/R^2 over the sum of the masses. Without a pulley they are equal, 1.2.
    /// With a heavier one they part: the upper rises towards 1.5, the weight of m1, the lower falls towards
    /// one, the weight of m2. Dots: from Newton's law for each body.
    tensions: {
        let heavy = Sweep::over(r"$I/(m_1+m_2)R^2$", 0.0, 4.0).at([0.2, 0.6, 1.2, 2.0, 3.2]);
        let of = |x: f64| unit(usual, 5.0 * x, FIRM);
        let exact = |k: usize| heavy.exact(move |x| 0.5 * of(x).closed_form().1[2 + k]);
        let dots = |k: usize| heavy.simulated(move |x| Ok(0.5 * of(x).forces(Grip::Holds, 0.0)[2 + k]));
        heavy.panel(Axis::linear("$T/m_2g$").range(0.9, 1.6))
            .curve(exact(0).label_at("$T_1$", 2.0, 1.4, Side::Above))
            .curve(exact(1).label_at("$T_2$", 2.0, 1.07, Side::Below))
            .curve(dots(0)?)
            .curve(dots(1)?)
            .level(1.5, Ink::Frame, "$m_1g$").level(1.0, Ink::Frame, "$m_2g$")
    };

    /// Accelerations over g against the coefficient of friction, for I/R^2 equal to 2/5 of the sum of the
    /// masses. Above a small threshold that of the masses and that of the rim are the same and do not change.
    /// Below it the rope slips: the masses are faster the smoother the pulley, and the rim is slower. Dots:
    /// simulated.
    slip: {
        let rub = Sweep::over(r"$\mu$", 0.0, 0.08).at([0.005, 0.015, 0.025, 0.035, 0.05, 0.07]);
        let at = |mu: f64| unit(usual, 2.0, exp(mu * PI));
        let run = |k: usize| move |mu: f64| {
            let run = Machine { grip: capstan(mu)?, ..at(mu) }.run(0.0, 1e-9, 10.0)?;
            Ok(run.transition("arrives").map(|event| event.before[k] / event.t)?)
        };
        rub.panel(Axis::linear("acceleration$/g$").range(0.0, 0.22))
            .curve(rub.exact(|mu| at(mu).closed_form().1[0]).label_at("masses", 0.012, 0.19, Side::Right))
            .curve(rub.exact(|mu| at(mu).closed_form().1[1]).dashed().label_at("rim", 0.02, 0.07, Side::BelowRight))
            .curve(rub.simulated(run(1))?)
            .curve(rub.simulated(run(3))?)
    };
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let run = machine(p)?.run(0.0, p.tolerance, 1e3)?;
    let columns = "t [s], way [m], speed [m/s], way of the rim [m], speed of the rim [m/s]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 300), |t| {
        let [way, speed, rim, rim_speed] = run.at(t)?.1;
        Ok([t, way, speed, rim, rim_speed])
    })
}

/// The machine with a pulley that spins at first; below, the speeds of rope and rim.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (m, h) = (machine(p)?, p.height);
    let run = m.run(p.spin * p.radius, p.tolerance, 1e3)?;
    let (end, scale) = (run.end_time(), 0.9 / h);
    let speed = |k: usize| Curve::sampled(times(0.0, end, 300), |t| Ok(run.at(t)?.1[k]), Ink::Body);
    let caught = run.transition("catches").is_ok() && m.closed_form().0 == Grip::Holds;
    // Where the lines are apart.
    let (apart, rope_side, rim_side) = match caught {
        true => (0.27 * end, Side::BelowRight, Side::AboveRight),
        false => (0.9 * end, Side::AboveLeft, Side::BelowRight),
    };
    let [_, rope, _, rim] = run.at(apart)?.1;
    let graph = Panel::over_axes("$t$ / s", "speed / (m/s)")
        .curve(speed(1)?.label_at("rope", apart, rope, rope_side))
        .curve(speed(3)?.dashed().label_at("rim", apart, rim, rim_side));
    // So that a force also fits above a mass that has come up to the axle.
    let fitting = sampled(times(0.0, end, 300), |t| {
        let (grip, [way, ..]) = run.at(t)?;
        let [.., left, right] = m.forces(grip, way);
        let room = |hang: f64, tension: f64| (0.41 + 0.5 * scale * hang) / tension;
        Ok(room(h + way, left).min(room(h - way, right)))
    })?;
    let force = fitting.into_iter().fold(0.45 / (p.m1.max(p.m2) * m.gravity), f64::min);
    let (side, goes_on) = if p.m1 > p.m2 { (-1.0, "rise as") } else { (1.0, "fall as") };
    let told = format!(": they approach each other and then {goes_on} one line");
    let told = if caught { told } else { String::new() };
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.2 * end, 0.9 * end], move |t| {
        let (grip, [way, _, rim, _]) = run.at(t)?;
        let does = if grip == Grip::Holds { "holds" } else { "slips" };
        let gone = if side * way > 0.0 { "up" } else { "down" };
        let alt = format!(
            "After {t:.2} s the heavier mass has gone {gone} by {:.2} m and the rope {does} on the pulley. \
             Below, the speeds of rope and rim against time{told}.",
            way.abs()
        );
        let (radius, [left, right]) = (0.16, [h + way, h - way].map(|y| 0.5 * scale * y));
        let sketch = Sketch::within((-1.0, 1.0), (-1.35, 0.4));
        let [.., t1, t2] = m.forces(grip, way);
        let (first, second) = ((-1.6 * radius, -left), (1.6 * radius, -right));
        let tip = |(x, low): (f64, f64), tension: f64| (x, low + force * tension);
        let scene = drawn(sketch, radius, [left, right], 0.6 + 0.5 * scale * rim / radius, side)
            .arrow(first, tip(first, t1), Ink::Force, "$T_1$", Side::Left)
            .arrow(second, tip(second, t2), Ink::Force, "$T_2$", Side::Right);
        Ok((alt, scene))
    })
}
