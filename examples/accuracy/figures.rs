//! The figures of the page.

use super::Parameters;
use super::measured::{self, Line, Measured, evaluations};
use super::methods::FLOW;
use super::tables::price;
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Measure, WorkPrecision, front};
use rotation_dynamics::math::{EPS, pow};
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side};

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let measured = measured::all(p)?;
    let mut figures = Vec::new();
    for one in &measured {
        figures.push(work(one)?);
    }
    if let Some(top) = measured.get(1) {
        for (measure, name, axis) in MEASURES {
            figures.push(in_measure(top, measure, name, axis)?);
        }
        figures.push(best(top)?);
        figures.push(best(&measured[0])?);
    }
    figures.push(digit(&measured)?);
    figures.extend(super::long::figures()?);
    figures.push(super::dial::figure()?);
    Ok(figures)
}

/// Which methods are drawn: those that the text of the page speaks of.
fn shown(problem: &str, key: &str) -> bool {
    match problem {
        "fast" => !["angles", "srkn6", "kl17", "aba82", "aba1064"].contains(&key),
        "pole" => !["mk4", "srkn6", "kl17", "aba82", "aba104", "aba1064"].contains(&key),
        _ => !["aba82", "aba104", "aba1064"].contains(&key),
    }
}

/// A family of methods has a colour, and a line says its own name.
fn styled(curve: Curve, key: &str) -> Curve {
    match key {
        "euler" | "semi" => curve.dashed(),
        "angles" | "mk4" | "kl17" | "aba104" => curve.dashed(),
        FLOW => curve.dotted(),
        _ => curve,
    }
}

fn ink(key: &str) -> Ink {
    match key {
        "euler" | "semi" => Ink::Wrong,
        "rk4" | "mk4" => Ink::Energy,
        "strang" | "aba82" | "aba1064" => Ink::Force,
        "srkn6" | "aba104" => Ink::Momentum,
        "srkn14" | "kl17" | FLOW => Ink::Body,
        "gauss" => Ink::Ink,
        _ => Ink::Velocity,
    }
}

fn label(line: &Line) -> &'static str {
    match line.method.key {
        "euler" | "semi" => "foils",
        "mk4" => "MK4",
        "angles" => "on angles",
        "gauss" => "Gauss 16",
        "srkn6" => "order 4",
        "srkn14" => "order 6",
        "kl17" => "order 8",
        "aba104" => "weak kicks",
        _ => line.method.name,
    }
}

/// The runs from coarse to fine: a line that turns back has found shorter steps cheaper.
fn drawn(line: &Line, measure: Measure) -> Vec<(f64, f64)> {
    let runs = line.sweep.runs().iter();
    runs.map(|run| (evaluations(&run.work) as f64, run.errors.get(measure)))
        .map(|(work, error)| (work, error.max(1e-16)))
        .filter(|(_, error)| *error <= 1.0)
        .collect()
}

/// Error of the attitude against evaluations.
fn work(measured: &Measured) -> Result<Figure> {
    let name = format!("work_{}", measured.problem.key);
    let alt = format!(
        "{}: error of the attitude against evaluations, on logarithmic axes; the higher the order, the \
         steeper the line, down to a floor of round-off",
        measured.problem.name
    );
    let mut panel = Panel::new(&name, &alt)
        .size(340, 340)
        .x(Axis::log("evaluations").range(30.0, 3e5))
        .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0));
    // What round-off alone may do; shown where it is inside the picture.
    let floor = EPS * measured.path_condition.1;
    panel = panel.level(floor, Ink::Frame, "");
    for line in &measured.lines {
        let points = drawn(line, Measure::Attitude);
        if points.len() < 3 || !shown(measured.problem.key, line.method.key) {
            continue;
        }
        let key = line.method.key;
        let (x, y) = points[points.len() - 1];
        let (x0, y0) = points[points.len() / 4];
        let curve = Curve::new(points, ink(key));
        panel = panel.curve(match key {
            // The two foils run side by side and share a name.
            "euler" => styled(curve, key),
            FLOW => styled(curve.label_at(label(line), x0, y0, Side::Above), key),
            "semi" => styled(curve.label_at(label(line), x, y, Side::Below), key),
            _ => styled(curve.label(label(line)), key),
        });
    }
    panel.figure()
}

const MEASURES: [(Measure, &str, &str); 3] = [
    (Measure::Attitude, "attitude", "error of the attitude / rad"),
    (Measure::Rates, "rates", "error of the rates"),
    (Measure::Invariants, "invariants", "error of what is kept"),
];

/// Five methods on the heavy top in one measure, all on the same axes.
fn in_measure(top: &Measured, measure: Measure, name: &str, axis: &str) -> Result<Figure> {
    let alt = format!(
        "The heavy top, {axis} against evaluations for four methods, on the same logarithmic axes as its \
         neighbours"
    );
    let mut panel = Panel::new(&format!("top_{name}"), &alt)
        .size(340, 300)
        .x(Axis::log("evaluations").range(30.0, 3e5))
        .y(Axis::log(axis).range(1e-16, 1.0));
    for key in ["semi", "rk4", "srkn6", "srkn14", "gauss"] {
        let Some(line) = top.line(key) else { continue };
        let name = if key == "semi" { "foil" } else { label(line) };
        let curve = Curve::new(drawn(line, measure), ink(key)).label(name);
        panel = panel.curve(styled(curve, key));
    }
    panel.figure()
}

/// Every method as a faint line, and the runs that nothing beats as dots on a full one.
fn best(measured: &Measured) -> Result<Figure> {
    let lines: Vec<&Line> = measured.contestants().collect();
    let curves: Vec<WorkPrecision> = lines.iter().map(|l| l.attitude.clone()).collect();
    let front = front(&curves);
    let name = format!("front_{}", measured.problem.key);
    let alt = format!(
        "{}: error against evaluations, every method as a faint line; along the lower left edge dots mark the runs \
         that none beats, each stretch named after its method",
        measured.problem.name
    );
    let mut panel = Panel::new(&name, &alt)
        .size(340, 300)
        .x(Axis::log("evaluations").range(30.0, 3e5))
        .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0));
    for line in &lines {
        let all = Curve::new(drawn(line, Measure::Attitude), ink(line.method.key));
        panel = panel.curve(styled(all.thin().faint(0.5), line.method.key));
    }
    let shown: Vec<(usize, (f64, f64))> = (front.iter())
        .map(|(method, p)| (*method, (p.work, p.error)))
        .filter(|(_, (_, error))| (1e-15..=1.0).contains(error))
        .collect();
    let stretches: Vec<&[(usize, (f64, f64))]> = shown.chunk_by(|a, b| a.0 == b.0).collect();
    for stretch in &stretches {
        let line = lines[stretch[0].0];
        let points = stretch.iter().map(|(_, p)| *p);
        let curve = Curve::new(points, ink(line.method.key)).with_dots();
        // A method is named once, on its longest stretch.
        let rivals = stretches.iter().filter(|s| s[0].0 == stretch[0].0);
        let longest = rivals.max_by_key(|s| s.len()).is_some_and(|s| s == stretch);
        panel = panel.curve(if longest && stretch.len() > 2 {
            curve.label(label(line))
        } else {
            curve
        });
    }
    panel.figure()
}

/// The price of one more digit against the order.
fn digit(all: &[Measured]) -> Result<Figure> {
    let by_order = (10..=170)
        .map(|k| 0.1 * f64::from(k))
        .map(|p| (p, pow(10.0, 1.0 / p)));
    let mut panel = Panel::new(
        "digit",
        "Factor in work for one more digit against the order of the method: the curve ten to the power of \
         one over the order falls steeply up to order four and is flat from order eight; the measured \
         factors lie on it, those of Gauss-Legendre below it",
    )
    .size(340, 300)
    .x(Axis::log("order $p$").range(1.6, 48.0).ticks([2, 4, 6, 8, 16].map(|p| (f64::from(p), p.to_string()))))
    .y(Axis::linear("work for one more digit, factor").range(1.0, 4.0))
    .curve(Curve::new(by_order.filter(|(_, y)| *y <= 4.0), Ink::Ink).label_at("$10^{1/p}$", 2.7, 2.35, Side::AboveRight));
    let mut labels: Vec<(u32, &str)> = vec![
        (2, "Strang, ABA(8,2)"),
        (4, "RK4 and five others"),
        (6, "SRKN 14a"),
        (8, "DOP853, Kahan-Li"),
        (16, "Gauss 16"),
    ];
    for measured in all {
        for line in &measured.lines {
            if let Some(price) = price(line) {
                let order = line.method.order;
                let label = labels.iter().position(|(p, _)| *p == order);
                let label = label.map_or("", |i| labels.remove(i).1);
                let side = if order == 16 {
                    Side::Above
                } else {
                    Side::AboveRight
                };
                panel = panel.dot(
                    f64::from(order),
                    price.factor,
                    ink(line.method.key),
                    label,
                    side,
                );
            }
        }
    }
    panel.figure()
}
