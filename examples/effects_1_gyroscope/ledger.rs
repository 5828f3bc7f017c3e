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

/// A line of the ledger: what, its number, the prediction, what was measured, of what.
struct Line {
    what: &'static str,
    number: &'static str,
    value: f64,
    predicted: f64,
    measured: f64,
    of: &'static str,
}

fn lines(p: &Parameters, y: &Gyroscope) -> Result<Vec<Line>> {
    let (g, s) = (&y.gimbals, sin(p.theta));
    let axial = y.start.axial_momentum;
    let (nod, bare) = (NutationCycle::of(g, &y.start)?, measured::nod_without_gimbals(y)?);
    let sizes = |n: &NutationCycle| n.theta_max - n.theta_min;
    // P = I1 (1 + a), N = I1 sin^2 (1 + b).
    let a = p.ring / I1;
    let b = g.turning(p.theta) / (I1 * s * s) - 1.0;
    let steady = y.fading()?;
    let turn = TAU / steady.precession;
    let only = |bearings: Bearings| -> Result<[f64; 2]> {
        let theory = Decay::of(g, &bearings, y.bottom()?, axial)?;
        Ok([theory.sag * turn, measured::sinking(y, bearings, p.tolerance)? * turn])
    };
    let b0 = Bearings::SMOOTH;
    let [pivot, pivot_seen] = only(b0.but(|b0| b0.azimuth = y.bearings.azimuth))?;
    let [axle, axle_seen] = only(b0.but(|b0| b0.axle = y.bearings.axle))?;
    let [air, air_seen] = only(b0.but(|b0| b0.air = y.bearings.air))?;
    let drag = y.bearings.air.map_or(0.0, |air| -air.axial_torque(axial / I3));
    Ok(vec![
        Line {
            what: "gimbals: the nod is longer",
            number: "A/I1 + N/(I1 sin(theta)^2) - 1",
            value: a + b,
            predicted: ((1.0 + a) * (1.0 + b)).sqrt() - 1.0,
            measured: nod.period / bare.period - 1.0,
            of: "of a nod",
        },
        Line {
            what: "gimbals: the dip is deeper",
            number: "N/(I1 sin(theta)^2) - 1",
            value: b,
            predicted: b,
            measured: sizes(&nod) / sizes(&bare) - 1.0,
            of: "of the dip",
        },
        Line {
            what: "tilt bearing: half nods",
            number: "m g l sin(theta)/(2 tau)",
            value: 0.5 * y.pull() / p.tilt_dry,
            predicted: 0.5 * y.pull() / p.tilt_dry,
            measured: measured::half_nods(y, p.tolerance)?.unwrap_or(f64::NAN),
            of: "until it holds",
        },
        Line {
            what: "pivot: the axis sinks",
            number: "2 pi tau/(m g l sin(theta))",
            value: TAU * p.pivot_dry / y.pull(),
            predicted: pivot,
            measured: pivot_seen,
            of: "rad a turn, in θ",
        },
        Line {
            // The axis goes towards the vertical on its side, up or down.
            what: if axle > 0.0 { "axle bearings: it sinks" } else { "axle bearings: it rises" },
            number: "2 pi tau/(m g l tan(theta))",
            value: TAU * p.axle_dry / y.pull() * cos(p.theta),
            predicted: axle,
            measured: axle_seen,
            of: "rad a turn, in θ",
        },
        Line {
            what: "air: it sinks",
            number: "torque x turn / L_z",
            value: drag * turn / axial,
            predicted: air,
            measured: air_seen,
            of: "rad a turn, in θ",
        },
    ])
}

/// The table of predictions, and the card of effects.
pub fn ledger(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let columns = ["effect", "number", "value", "predicted", "measured", "of what"];
    let mut table = Table::new("ledger", columns)?;
    let lines = lines(p, &y)?;
    for line in &lines {
        if line.measured.is_nan() {
            continue;
        }
        let cell = |x: f64| supported_digits(x, 5e-3 * x.abs());
        table.push([
            line.what.into(),
            line.number.into(),
            cell(line.value),
            cell(line.predicted),
            cell(line.measured),
            line.of.into(),
        ])?;
    }
    report.add(table)?;
    card(p, &y, &lines, report)
}

fn card(p: &Parameters, y: &Gyroscope, lines: &[Line], report: &mut Report) -> Result<()> {
    let (f, spin) = (y.fading()?, p.rpm * TAU / 60.0);
    let (turn, pull) = (TAU / f.precession, y.pull());
    let (earth, axial): (f64, f64) = (7.292115e-5, y.start.axial_momentum);
    let drag = y.bearings.air.map_or(0.0, |air| -air.axial_torque(spin));
    let halves = PI * y.bearings.tilt.dry() / pull;
    let b = y.gimbals.turning(p.theta) / (I1 * pow(sin(p.theta), 2.0)) - 1.0;
    // Steel, 7850 kg/m^3, 200 GPa, Poisson's ratio 0.3: the moment of a disc grows by
    // (1 - nu)(7 + nu)/12 of the number. A ring of aluminium that bends at 300 Hz.
    let stretch = 7850.0 * spin * spin * RADIUS * RADIUS / 2e11;
    let swells = 0.7 * 7.3 / 12.0 * stretch;
    let bends = pow(f.frequency / (TAU * 300.0), 2.0);
    let play = 1e-5;
    let [_, dip, _, pivot, axle, _] = lines else { unreachable!("the ledger has six lines") };
    let seen = |line: &Line| Some(line.measured).filter(|measured| measured.is_finite());
    effect_card! { report,
        "inertia of ring and fork": "N/(I1 sin(theta)^2) - 1" = b, costs b, "of the dip", measured seen(dip), within 1e-12, included;
        "dry friction of the tilt": "pi tau/(m g l sin(theta))" = halves, costs f64::from(halves > 0.0), "of the nods", included;
        "viscous friction of the tilt": "decay x nod" = f.decay * TAU / f.frequency,
            costs 1.0 - exp(-f.decay * turn), "of the nods, in a turn", included;
        "friction of the vertical pivot": "2 pi tau/(m g l sin(theta))" = TAU * p.pivot_dry / pull,
            costs pivot.predicted, "rad a turn, in θ", measured seen(pivot), within 1e-9, included;
        "friction of the axle": "torque x turn / L_z" = p.axle_dry * turn / axial,
            costs axle.predicted, "rad a turn, in θ", measured seen(axle), within 1e-9, included;
        "air on the rotor": "torque x turn / L_z" = drag * turn / axial,
            costs 0.5 * drag * turn * TAU / axial, "rad a turn, in φ", included;
        "play of the tilt bearing": "play/dip" = play / (y.bottom()? - p.theta), costs play, "rad";
        "a ring that bends": "(nods/own frequency)^2" = bends, costs 0.5 * bends, "of a nod";
        "stretch of the disc": "rho omega^2 R^2/E" = stretch, costs swells * TAU, "rad a turn, in φ";
        "rotation of the Earth": "Omega_E/(dphi/dt)" = earth / f.precession,
            costs earth * turn, "rad a turn, at most";
    }
}
