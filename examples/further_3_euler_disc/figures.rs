//! The drawings of Euler's disc; lengths in radii.

use super::*;
use kit::draw::Camera;

/// The centre of a disc that lies so, and its lowest point on the table.
fn points(tilt: f64, disc: &Disc) -> [SpaceVector; 2] {
    let centre = SpaceVector::new(0.0, 0.0, sin(tilt));
    [centre, centre + disc.arm]
}

/// A level circle about the vertical through the origin.
fn circle(radius: f64, from: f64, to: f64) -> impl Iterator<Item = SpaceVector> {
    times(from, to, 60).map(move |a| SpaceVector::new(radius * cos(a), radius * sin(a), 0.0))
}

/// The disc on its table.
fn view(tilt: f64, disc: &Disc) -> View {
    let [centre, contact] = points(tilt, disc);
    // As near as a disc that stands so high allows.
    let high = sin(tilt);
    View::of(SpaceVector::new(0.0, 0.0, 0.6 * high), (high + 0.3).max(0.85))
        .size(340, 230)
        .camera(Camera::new(-0.6, 0.38))
        .ground(SpaceVector::zero(), 1.22)
        .dashed(circle(cos(tilt), 0.0, TAU), Ink::Frame)
        .solid(Solid::disc(centre + disc.axis * 0.015, disc.axis, 1.0, 0.03), Ink::Body)
        .spot(contact, Ink::Velocity)
}

/// Inclinations of the steady motions.
fn inclinations() -> Sweep {
    Sweep::over(r"$\alpha$ / rad", 0.0, FRAC_PI_2).at([0.06, 0.15, 0.3, 0.5, 0.8, 1.1, 1.4])
}

/// In the last hundredths of a second: this of the disc, over ms.
fn at_last(by: &Settled, of: impl Fn(&Disc) -> f64) -> Result<Vec<(f64, f64)>> {
    let span = times(by.end - 0.02 / by.time, by.run.end_time(), 300);
    sampled(span, |t| Ok((1e3 * (t - by.end) * by.time, of(&by.at(t)?))))
}

/// Time before the simulated end when the inclination is this.
fn reached(by: &Settled, tilt: f64) -> Result<f64> {
    let steeper = |t| Ok::<_, kit::Error>(by.at(t)?.tilt > tilt);
    let [early, _] = try_bisect([0.0, by.run.end_time()], 0.0, steeper)?;
    Ok(by.end - early)
}

figures! { p: &Parameters, losses = [Settled::by("rolling", p)?, Settled::by("air", p)?], air = &losses[1], time = air.time;
    /// A disc of radius R stands askew on its edge on a table, at the inclination alpha to it. Its centre is above the middle
    /// of a dashed circle on the table; on this circle the contact runs round with the rate Omega.
    setup: {
        let tilt = 0.5;
        let disc = Disc::new(&placed(tilt, [1.0, 0.0, 0.0], 0.0)?);
        let [centre, contact] = points(tilt, &disc);
        let (out, up) = (disc.towards, disc.arm * -1.0);
        let arc = times(0.0, tilt, 20).map(|a| contact - out * (0.75 * cos(a)) + SpaceVector::new(0.0, 0.0, 0.75 * sin(a)));
        let top = SpaceVector::new(0.0, 0.0, 1.02);
        // In profile: the angle is in the plane of the paper.
        view(tilt, &disc)
            .camera(Camera::new(0.2, 0.25))
            .dashed([SpaceVector::zero(), top], Ink::Frame)
            .text(top, "$Z$", Ink::Frame, Side::Right)
            .dashed([contact, contact - out * 0.95], Ink::Ink)
            .line(arc, Ink::Ink)
            .text(contact - out * 0.78 + SpaceVector::new(0.0, 0.0, 0.1), r"$\alpha$", Ink::Ink, Side::Left)
            .arrow(centre, centre + disc.axis * 0.6, Ink::Body, r"$\hat e_3$", Side::Left)
            .line([centre, centre + up].map(|at| at + disc.axis * 0.035), Ink::Ink)
            .text(centre + up * 0.55, "$R$", Ink::Ink, Side::Above)
            .turn(circle(1.1, -1.35, -0.55), Ink::Velocity)
            .text(circle(1.17, -0.95, -0.95).next().unwrap_or(contact), r"$\Omega$", Ink::Velocity, Side::Below)
    };

    /// Rates against the inclination. That of the contact falls steeply from very large values to two upright. The angular
    /// speed of the disc rises from zero to two. The rate at which the face turns rises from zero even more slowly at first.
    rates: {
        let motion = |tilt| Steady { tilt, circle: 0.0 };
        let rate = |tilt| Ok(TAU / turn(motion(tilt), 1e-10)?.0);
        let omega = |tilt| Ok(turn(motion(tilt), 1e-10)?.1.angular_velocity.norm());
        inclinations().panel(Axis::linear(r"rate / $(g/R)^{1/2}$").range(0.0, 8.0))
            .curve(inclinations().beyond(0.0627).exact(|a| motion(a).rate()).label_at(r"$\Omega$ of the contact", 0.35, 3.9, Side::AboveRight))
            .curve(inclinations().beyond(0.01).exact(|a| motion(a).rate() * sin(a)).dashed().label_at(r"$\omega$ of the disc", 0.62, 1.75, Side::AboveLeft))
            .curve(inclinations().beyond(0.01).exact(|a| motion(a).face()).dotted().label_at("its face", 1.05, 0.85, Side::BelowRight))
            .curve(inclinations().beyond(0.1).simulated(rate)?)
            .curve(inclinations().simulated(omega)?)
    };

    /// Inclination against time for both losses. By rolling friction it falls a little faster all the time, by air it stays
    /// long and then drops almost straight down.
    settles: {
        let mut panel = Panel::over_axes("$t$ / s", Axis::linear(r"$\alpha$ / rad").range(0.0, p.start));
        for by in &losses {
            let end = by.law.left(p.start);
            let law = |part: f64| by.law.tilt((end * (1.0 - part)).max(0.0));
            let line = times(0.0, 1.0, 200).map(|u| 1.0 - (1.0 - u) * (1.0 - u) * (1.0 - u));
            let points = line.map(|part| (part * end * time, law(part)));
            let dots = sampled(times(0.0, 0.98 * by.end, 10), |t| Ok((t * time, by.at(t)?.tilt)))?;
            panel = panel.curve(Curve::new(points, Ink::Ink).label_at(by.name, 0.75 * end * time, law(0.75), Side::AboveRight))
                .curve(Curve::new(dots, Ink::Body).dots());
        }
        panel
    };

    /// Tone against the time left, both logarithmic: two straight lines that fall, that of rolling friction twice as steep as
    /// that of air. Towards short times each ends at a ring.
    tone: {
        let ticks = [(1e-4, "100 µs"), (1e-2, "10 ms"), (1.0, "1 s"), (100.0, "100 s")];
        let hertz = [10.0, 30.0, 100.0, 300.0].map(|f| (f, format!("{f}")));
        let mut panel = Panel::over_axes(Axis::log("time left").range(1e-4, 150.0).ticks(ticks.map(|(t, s)| (t, s.to_string()))), Axis::log("tone / Hz").range(10.0, 500.0).ticks(hertz));
        for by in &losses {
            let heard = |tilt: f64| Settling::passing(tilt).rate() / (TAU * time);
            let tilts = times(log(p.start), log(by.law_ends), 60).map(exp);
            let points: Vec<_> = tilts.map(|tilt| (by.law.left(tilt) * time, heard(tilt))).collect();
            let dots = sampled(times(log(0.9 * p.start), log(2.5 * by.law_ends), 8).map(exp), |tilt| {
                let left = reached(by, tilt)?;
                Ok((left * time, by.at(by.end - left)?.rate / (TAU * time)))
            })?;
            let (from, to) = (points[30], points[60]);
            let side = if by.name == "air" { Side::BelowRight } else { Side::AboveLeft };
            panel = panel.curve(Curve::new(points, Ink::Ink).label_at(by.name, from.0, from.1, side))
                .curve(Curve::new(dots, Ink::Body).dots())
                .ring(to.0, to.1, Ink::Ink, "", Side::Above);
        }
        panel
    };

    /// The simulated rate, braked by air, to the power minus one over an assumed exponent, against time. For 1/6 it is a
    /// straight line; for a smaller exponent it sags below it, for a larger one it bulges above.
    bend: {
        let mut panel = Panel::over_axes("$t$ / s", Axis::linear(r"$(\Omega/\Omega_0)^{-1/\beta}$").range(0.0, 1.0));
        let from = air.at(0.0)?.rate;
        for (name, n, at, side) in [(r"$\beta = 0.12$", 0.12, 0.5, Side::BelowLeft), (r"$\beta = 1/6$", 1.0 / 6.0, 0.3, Side::AboveRight), (r"$\beta = 0.3$", 0.3, 0.75, Side::AboveRight)] {
            let z = |t: f64| Ok::<_, kit::Error>((t * time, pow(air.at(t)?.rate / from, -1.0 / n)));
            let curve = Curve::new(sampled(times(0.0, air.passed[2], 120), z)?, Ink::Velocity);
            let (x, y) = z(at * air.end)?;
            let curve = if n == 1.0 / 6.0 { curve } else { curve.dashed() };
            panel = panel.curve(curve.label_at(name, x, y, side));
        }
        panel
    };

    /// The last hundredths of a second with the air as the loss. The tone by the law rises without end; that of the disc
    /// follows it, stays behind, and breaks off to zero.
    last: {
        let sounds = at_last(air, |disc| disc.rate / (TAU * time))?;
        let law = times(0.0, 1.0, 200).map(|u| 0.02 / time * (1.0 - u) * (1.0 - u) + 1e-4 * air.law.left(air.law_ends));
        let law = law.map(|left| (-1e3 * left * time, 2.0 / air.law.tilt(left).sqrt() / (TAU * time)));
        let law: Vec<_> = law.filter(|(_, f)| *f < 150.0).collect();
        Panel::over_axes("$t - t_0$ / ms", Axis::linear("tone / Hz").range(0.0, 150.0))
            .curve(Curve::new(law, Ink::Wrong).dashed().label_at("wrong: the law", -1.0, 125.0, Side::Left))
            .curve(Curve::new(sounds, Ink::Velocity).label_at("the disc", -6.0, 62.0, Side::BelowLeft))
    };

    /// The force of the table over the weight in the same time: it is one, falls, and ends at one fifth, never at zero.
    force: {
        let force = at_last(air, |disc| disc.force(air.loss).z())?;
        Panel::over_axes("$t - t_0$ / ms", Axis::linear("$N/mg$").range(0.0, 1.2))
            .level(0.2, Ink::Frame, "1/5")
            .curve(Curve::new(force, Ink::Force))
    };
}

/// The settling by the chosen loss, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let by = Settled::by(p.loss, p)?;
    let (columns, time) = ("t [s], inclination [rad], tone [Hz], omega [rad/s], N/mg", by.time);
    Trajectory::sampled(columns.split(", "), times(0.0, by.run.end_time(), 500), |t| {
        let disc = by.at(t)?;
        let omega = disc.angular_velocity.norm() / time;
        Ok([t * time, disc.tilt, disc.rate / (TAU * time), omega, disc.force(by.loss).z()])
    })
}

/// The steady motion for three turns of the contact, with a mark on the face; below, the turns of
/// both.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (motion, time) = (steady(p)?, (p.radius / p.gravity).sqrt());
    let end = 3.0 * TAU / motion.rate();
    let run =
        Dop853::new(p.tolerance)?.solve(&rolling(Loss::None), 0.0, &motion.placed()?, end, &[])?;
    let turns = |rate: f64| [(0.0, 0.0), (end * time, rate * end / TAU)];
    let graph = Panel::over_axes("$t$ / s", "turns")
        .curve(Curve::new(turns(motion.rate()), Ink::Velocity).label("contact"))
        .curve(Curve::new(turns(motion.face()), Ink::Ink).label("face"));
    let span = end * time;
    MovingPicture::above(graph, 0.0..=span, [0.0, span / 2.0, span], move |t| {
        let y = run.at((t / time).min(end))?;
        let (disc, attitude) = (Disc::new(&y), attitude(&y)?);
        let ([centre, _], high) = (points(disc.tilt, &disc), sin(disc.tilt));
        let on_face = |x: f64| centre + attitude.to_space(BodyVector::new(x, 0.0, 0.035));
        // From farther off where it stands higher than the drawings' disc; the mark in ink, as one in
        // the colour of the body would be lost on a lit face.
        let scene = view(disc.tilt, &disc)
            .around(SpaceVector::new(0.0, 0.0, 0.6 * high), (0.4 + 1.15 * high).max(0.85))
            .arrow(on_face(0.0), on_face(0.9), Ink::Ink, "", Side::Above);
        let [contact, face] = [motion.rate(), motion.face()].map(|rate| rate * t / (time * TAU));
        let alt = format!(
            "The disc after {t:.2} s, askew on its edge. Its contact has run round {contact:.2} times, \
             and the mark on its face has turned by {face:.2} of a turn; below, both against time."
        );
        Ok((alt, scene))
    })
}
