//! What gimbals and bearings do: predicted beforehand, and measured with them in.

use super::*;
use kit::supported_digits;

/// How many half nods the dry tilt bearing needs, alone: by work and energy, turning point by
/// turning point, V(next) = V(last) - tau |next - last|, until the valley's slope is less than tau.
pub fn half_nods(y: &Gyroscope) -> u32 {
    let (g, start, dry) = (&y.gimbals, &y.start, y.bearings.tilt.dry());
    let momenta = [g.vertical_momentum(start), start.axial_momentum];
    let valley = |theta: f64| g.effective_potential(theta, momenta);
    let slope = |theta: f64| (valley(theta + 1e-6) - valley(theta - 1e-6)) / 2e-6;
    let (mut theta, mut count) = (start.theta, 0);
    while slope(theta).abs() > dry && count < 2000 {
        let down = -slope(theta).signum();
        let left = |way: f64| valley(theta) - dry * way - valley(theta + down * way);
        let mut outside = 0.01;
        while left(outside) > 0.0 {
            outside *= 1.5;
        }
        let [inside, _] = kit::bisect([1e-9, outside], 0.0, |way| left(way) > 0.0);
        theta += down * inside;
        count += 1;
    }
    count
}

/// What each effect does: the table of what is predicted and measured, and the card of effects.
pub fn ledger(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let (g, s, pull, f) = (&y.gimbals, sin(p.theta), y.pull(), y.fading()?);
    let (axial, spin, turn) = (y.start.axial_momentum, p.rpm * TAU / 60.0, TAU / f.precession);
    // P = I1 (1 + a), N = I1 sin^2 (1 + b).
    let (a, b) = (p.ring / I1, g.turning(p.theta) / (I1 * s * s) - 1.0);
    let (nod, bare) = (NutationCycle::of(g, &y.start)?, measured::nod_without_gimbals(&y)?);
    let size = |n: &NutationCycle| n.theta_max - n.theta_min;
    let longer = [((1.0 + a) * (1.0 + b)).sqrt() - 1.0, nod.period / bare.period - 1.0];
    let deeper = [b, size(&nod) / size(&bare) - 1.0];
    let halves = 0.5 * pull / p.tilt_dry;
    let stops = [halves, measured::half_nods(&y, p.tolerance)?.unwrap_or(f64::NAN)];
    // How far the axis sinks in a turn with one bearing alone.
    let sinks = |bearings: Bearings| -> Result<[f64; 2]> {
        let theory = Decay::of(g, &bearings, y.bottom()?, axial)?;
        Ok([theory.sag * turn, measured::sinking(&y, bearings, p.tolerance)? * turn])
    };
    let (smooth, all) = (Bearings::SMOOTH, y.bearings);
    let pivot = sinks(Bearings { azimuth: all.azimuth, ..smooth })?;
    let axle = sinks(Bearings { axle: all.axle, ..smooth })?;
    let air = sinks(Bearings { air: all.air, ..smooth })?;
    let drag = all.air.map_or(0.0, |air| -air.axial_torque(spin));
    // The axis goes towards the vertical on its side, up or down.
    let goes = if axle[0] > 0.0 { "axle bearings: it sinks" } else { "axle bearings: it rises" };
    let (by_pivot, by_axle) = (TAU * p.pivot_dry / pull, TAU * p.axle_dry / pull * cos(p.theta));
    let (in_turn, of_theta) = (drag * turn / axial, "rad a turn, in θ");
    let lines = [
        ("gimbals: the nod is longer", "A/I1 + N/(I1 sin(theta)^2) - 1", a + b, longer, "of a nod"),
        ("gimbals: the dip is deeper", "N/(I1 sin(theta)^2) - 1", b, deeper, "of the dip"),
        ("tilt bearing: half nods", "m g l sin(theta)/(2 tau)", halves, stops, "until it holds"),
        ("pivot: the axis sinks", "2 pi tau/(m g l sin(theta))", by_pivot, pivot, of_theta),
        (goes, "2 pi tau/(m g l tan(theta))", by_axle, axle, of_theta),
        ("air: it sinks", "torque x turn / L_z", in_turn, air, of_theta),
    ];
    let columns = ["effect", "number", "value", "predicted", "measured", "of what"];
    let lines = lines.into_iter().filter(|(.., seen, _)| !seen[1].is_nan());
    let table = Table::of("ledger", columns, lines, |(what, number, value, seen, of)| {
        let [value, told, seen] =
            [value, seen[0], seen[1]].map(|x| supported_digits(x, 5e-3 * x.abs()));
        Ok([what.into(), number.into(), value, told, seen, of.into()])
    })?;
    report.add(table)?;
    // Steel, 7850 kg/m^3, 200 GPa, Poisson's ratio 0.3: the moment of a disc grows by
    // (1 - nu)(7 + nu)/12 of the number. A ring of aluminium that bends at 300 Hz.
    let stretch = 7850.0 * spin * spin * RADIUS * RADIUS / 2e11;
    let swells = 0.7 * 7.3 / 12.0 * stretch;
    let bends = pow(f.frequency / (TAU * 300.0), 2.0);
    let (stuck, play, earth) = (PI * p.tilt_dry / pull, 1e-5, 7.292115e-5);
    effect_card! { report,
        "inertia of ring and fork": "N/(I1 sin(theta)^2) - 1" = b, costs b, "of the dip", measured deeper[1], within 1e-12, included;
        "dry friction of the tilt": "pi tau/(m g l sin(theta))" = stuck, costs f64::from(stuck > 0.0), "of the nods", included;
        "viscous friction of the tilt": "decay x nod" = f.decay * TAU / f.frequency,
            costs 1.0 - exp(-f.decay * turn), "of the nods, in a turn", included;
        "friction of the vertical pivot": "2 pi tau/(m g l sin(theta))" = by_pivot,
            costs pivot[0], "rad a turn, in θ", measured pivot[1], within 1e-9, included;
        "friction of the axle": "torque x turn / L_z" = p.axle_dry * turn / axial,
            costs axle[0], "rad a turn, in θ", measured axle[1], within 1e-9, included;
        "air on the rotor": "torque x turn / L_z" = in_turn, costs 0.5 * in_turn * TAU, "rad a turn, in φ", included;
        "play of the tilt bearing": "play/dip" = play / (y.bottom()? - p.theta), costs play, "rad";
        "a ring that bends": "(nods/own frequency)^2" = bends, costs 0.5 * bends, "of a nod";
        "stretch of the disc": "rho omega^2 R^2/E" = stretch, costs swells * TAU, "rad a turn, in φ";
        "rotation of the Earth": "Omega_E/(dphi/dt)" = earth / f.precession, costs earth * turn, "rad a turn, at most";
    }
}
