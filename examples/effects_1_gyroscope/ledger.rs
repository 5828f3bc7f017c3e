//! What gimbals and bearings do: predicted beforehand, and measured with them in.

use super::*;

/// How many half nods dry friction of the tilt bearing needs, alone.
pub fn half_nods(y: &Gyroscope) -> Result<f64> {
    let (f, size) = (y.fading()?, y.bottom()? - y.start.theta);
    Ok((size / f.shortening - 0.5).ceil().max(0.0))
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
    let (weight, axial) = (g.weight_moment(), y.start.axial_momentum);
    let (nod, bare) = (Nod::of(g, &y.start)?, measured::nod_without_gimbals(y)?);
    let sizes = |n: &Nod| n.theta_max - n.theta_min;
    let rate = |n: &Nod| n.precession / n.period;
    // P = I1 (1 + a), N = I1 sin^2 (1 + b).
    let a = p.ring / I1;
    let b = g.turning(p.theta) / (I1 * s * s) - 1.0;
    let steady = y.fading()?;
    let turn = TAU / steady.precession;
    let (walk, fixed) = (weight * cos(p.theta) / (axial * axial), p.fork + p.ring_along);
    let only = |bearings: Bearings| -> Result<[f64; 2]> {
        let theory = Fading::of(g, &bearings, y.bottom()?, axial)?;
        Ok([theory.sag * turn, measured::sinking(y, bearings, p.tolerance)? * turn])
    };
    let b0 = Bearings::SMOOTH;
    let [pivot, pivot_seen] = only(Bearings { azimuth: y.bearings.azimuth, ..b0 })?;
    let [axle, axle_seen] = only(Bearings { axle: y.bearings.axle, ..b0 })?;
    let [air, air_seen] = only(Bearings { air: y.bearings.air, ..b0 })?;
    let drag = y.bearings.air.map_or(0.0, |air| -air.axial_torque(axial / I3));
    Ok(vec![
        Line {
            what: "gimbals: the nod is longer",
            number: "A/I1 + (N/I1 sin^2 - 1)",
            value: a + b,
            predicted: ((1.0 + a) * (1.0 + b)).sqrt() - 1.0,
            measured: nod.period / bare.period - 1.0,
            of: "of a nod",
        },
        Line {
            what: "gimbals: the dip is deeper",
            number: "N/I1 sin^2 - 1",
            value: b,
            predicted: b,
            measured: sizes(&nod) / sizes(&bare) - 1.0,
            of: "of the dip",
        },
        Line {
            what: "gimbals: the precession",
            number: "m g l (C + J)/L_z^2",
            value: weight * fixed / (axial * axial),
            predicted: walk * (p.ring - p.ring_along - 0.5 * fixed / (s * s)),
            measured: rate(&nod) / rate(&bare) - 1.0,
            of: "of its rate",
        },
        Line {
            what: "pivot: the axis sinks",
            number: "2 pi tau/m g l sin",
            value: TAU * p.pivot_dry / y.pull(),
            predicted: pivot,
            measured: pivot_seen,
            of: "rad a turn",
        },
        Line {
            what: "axle bearings: it rises",
            number: "2 pi tau/m g l tan",
            value: TAU * p.axle_dry / y.pull() * cos(p.theta),
            predicted: axle,
            measured: axle_seen,
            of: "rad a turn",
        },
        Line {
            what: "air: it sinks",
            number: "torque x turn/L_z",
            value: drag * turn / axial,
            predicted: air,
            measured: air_seen,
            of: "rad a turn",
        },
    ])
}

/// The table of predictions, and the card of effects.
pub fn ledger(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let columns = ["effect", "number", "value", "predicted", "measured", "of what"];
    let mut table = Table::new("ledger", columns)?;
    for line in lines(p, &y)? {
        let cell = |x: f64| format!("{x:.2e}");
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
    card(p, &y, report)
}

fn card(p: &Parameters, y: &Gyroscope, report: &mut Report) -> Result<()> {
    let (f, spin) = (y.fading()?, p.rpm * TAU / 60.0);
    let (turn, pull) = (TAU / f.precession, y.pull());
    let (earth, axial): (f64, f64) = (7.292115e-5, y.start.axial_momentum);
    let drag = y.bearings.air.map_or(0.0, |air| -air.axial_torque(spin));
    let halves = PI * y.bearings.tilt.dry() / pull;
    let b = y.gimbals.turning(p.theta) / (I1 * pow(sin(p.theta), 2.0)) - 1.0;
    // Steel, 7850 kg/m^3 and 200 GPa; a ring of aluminium that bends at 300 Hz.
    let stretch = 7850.0 * spin * spin * RADIUS * RADIUS / 2e11;
    let bends = pow(f.frequency / (TAU * 300.0), 2.0);
    let play = 1e-5;
    effect_card! { report,
        "inertia of ring and fork": "N/I1 sin^2 - 1" = b, costs b, "of the dip", included;
        "dry friction of the tilt": "pi tau/m g l sin" = halves, costs 1.0, "of the nods", included;
        "viscous friction of the tilt": "decay x nod" = f.decay * TAU / f.frequency,
            costs 1.0 - exp(-f.decay * turn), "of the nods, in a turn", included;
        "friction of the vertical pivot": "2 pi tau/m g l sin" = TAU * p.pivot_dry / pull,
            costs p.pivot_dry * turn / (axial * sin(p.theta)), "rad a turn", included;
        "friction of the axle": "torque x turn/L_z" = p.axle_dry * turn / axial,
            costs p.axle_dry * turn / (axial * tan(p.theta)), "rad a turn", included;
        "air on the rotor": "torque x turn/L_z" = drag * turn / axial,
            costs 0.5 * drag * turn * TAU / axial, "rad a turn, in φ", included;
        "play of the tilt bearing": "play/dip" = play / (y.bottom()? - p.theta), costs play, "rad";
        "a ring that bends": "(nods/own frequency)^2" = bends, costs 0.5 * bends, "of a nod";
        "stretch of the disc": "rho omega^2 R^2/E" = stretch, costs stretch * TAU, "rad a turn, in φ";
        "rotation of the Earth": "Omega_E/(dphi/dt)" = earth / f.precession,
            costs earth * turn, "rad a turn, at most";
    }
}
