//! The figures of the page.

use super::*;
use kit::Result;
use kit::draw::Method as Look;
use lines::FLOW;
use motions::Motion;
use tables::price;

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let measured = super::prepared(p)?;
    let mut figures = measured.iter().map(work).collect::<Result<Vec<_>>>()?;
    figures.extend(self::figures(p)?);
    figures.extend(error_control::figures(p)?);
    Ok(figures)
}

/// Which methods are not drawn: those that the text of the page does not speak of.
fn hidden(motion: &str) -> &'static [&'static str] {
    match motion {
        "flips" => &["euler", "semi", "mk4"],
        "fast" => &["angles", "srkn6", "kl17", "aba82", "aba1064"],
        "pole" => &["mk4", "srkn6", "kl17", "aba82", "aba104", "aba1064"],
        "lopsided" => &["aba82", "aba104", "aba1064", "mk4", "srkn6"],
        _ => &["aba82", "aba104", "aba1064", "srkn6"],
    }
}

/// Error of the attitude against evaluations.
fn work(measured: &Measured) -> Result<Figure> {
    let Motion { key, name, .. } = measured.motion;
    // What round-off alone may do.
    let floor = EPS * measured.path_condition.1;
    let first = match measured.first(1e-9) {
        Some((work, name)) => {
            format!("{name} is the first to reach 1e-9, with {work:.0} evaluations")
        }
        None => "no method reaches 1e-9".into(),
    };
    let alt = format!(
        "{name}: error of the attitude against evaluations, both logarithmic. {first}; the level \
         line of rounding lies at {}",
        rounded_up(floor)
    );
    let mut panel = Panel::new(&format!("work_{key}"), &alt)
        .size(340, 340)
        .x(Axis::log("evaluations").range(30.0, 3e5))
        .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0))
        .level(floor, Ink::Frame, "");
    for line in measured.lines.iter().filter(|line| !hidden(key).contains(&line.key)) {
        // From coarse to fine: a line that turns back has found shorter steps cheaper.
        let runs = line.sweep.runs().iter();
        let points = runs.map(|run| (run.work.torques() as f64, run.errors.attitude.max(1e-16)));
        let points: Vec<_> = points.filter(|(_, error)| *error <= 1.0).collect();
        let Some(&(x, y)) = points.last() else {
            continue;
        };
        let (x0, y0) = points[points.len() / 4];
        let look = Look::named(line.name);
        // Several splittings share an ink: a mark at some of their runs tells them apart.
        if look.ink() == Ink::Splitting {
            panel = panel.curve(look.curve(points.iter().copied().step_by(4)).dots());
        }
        let curve = look.curve(points);
        panel = panel.curve(match line.key {
            // The two naive methods run side by side and share a name.
            "euler" => curve,
            "semi" => curve.label_at(look.label(), x, y, Side::Below),
            FLOW => curve.label_at(look.label(), x0, y0, Side::Above),
            "angles" => curve.label("on angles"),
            _ => curve.label(look.label()),
        });
    }
    panel.figure()
}

/// What is written at the first dot of an order.
const LABELS: [(u32, &str); 5] = [
    (2, "Strang, ABA(8,2)"),
    (4, "RK4 and four others"),
    (6, "SRKN 14a"),
    (8, "DOP853, Kahan-Li"),
    (16, "Gauss 16"),
];

figures! { p: &Parameters;
    /// Factor in work for one more digit against the order of the method: the curve ten to the
    /// power of one over the order falls steeply up to order four and is flat from order eight;
    /// most measured factors lie near it, those of Gauss-Legendre below it
    digit: digit(&super::prepared(p)?);
}

/// The price of one more digit against the order.
fn digit(all: &[Measured]) -> Panel {
    let by_order = (10..=170).map(|k| 0.1 * f64::from(k)).map(|p| (p, pow(10.0, 1.0 / p)));
    let law = Curve::new(by_order.filter(|(_, y)| *y <= 4.0), Ink::Ink);
    let ticks = LABELS.map(|(order, _)| (f64::from(order), order.to_string()));
    let mut panel = Panel::over_axes(
        Axis::log("order $p$").range(1.6, 48.0).ticks(ticks),
        Axis::linear("work for one more digit, factor").range(1.0, 4.0),
    )
    .size(340, 300)
    .curve(law.label_at("$10^{1/p}$", 2.7, 2.35, Side::AboveRight));
    let mut labels = LABELS.to_vec();
    for line in all.iter().flat_map(|measured| &measured.lines) {
        let Some(price) = price(line) else { continue };
        let order = line.method.order();
        let label = labels.iter().position(|(of, _)| *of == order);
        let label = label.map_or("", |at| labels.remove(at).1);
        let side = if order == 16 { Side::Above } else { Side::AboveRight };
        let ink = Look::named(line.name).ink();
        panel = panel.dot(f64::from(order), price.factor, ink, label, side);
    }
    panel
}
