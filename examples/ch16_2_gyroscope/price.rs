//! What accuracy costs here.

use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Variables;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::exp2;
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel};
use rotation_dynamics::report::heavy_top::Motion;

/// The methods that are drawn, and their lines.
const DRAWN: [(Method, &str, Ink); 5] = [
    (Method::Rk4, "RK4", Ink::Velocity),
    (Method::Strang, "order 2", Ink::Energy),
    (Method::Srkn6, "order 4", Ink::Momentum),
    (Method::Srkn14, "order 6", Ink::Body),
    (Method::Dop853, "DOP853", Ink::Ink),
];

/// Coarser and finer by factors of 2^(1/2) in the steps, of 4 in the tolerance.
fn settings(method: Method) -> Vec<f64> {
    let by = |factor: f64, half: i32| (0..=half).map(move |k| exp2(factor * f64::from(k)));
    match method {
        Method::Dop853 => by(-2.0, 23).map(|x| (0.1 * x).max(1e-15)).collect(),
        Method::Srkn14 => by(0.5, 24).map(|x| (8.0 * x).floor()).collect(),
        Method::Srkn6 => by(0.5, 26).map(|x| (8.0 * x).floor()).collect(),
        _ => by(0.5, 28).map(|x| (8.0 * x).floor()).collect(),
    }
}

/// Error of the attitude against torques, for every method.
pub fn figure(motion: &Motion) -> Result<Figure> {
    let problem = motion.problem()?;
    let mut panel = Panel::new(
        "work",
        "Error of the attitude against torques evaluated, on logarithmic axes: the splittings of order 4 and 6 \
         and DOP853 reach 1e-13, RK4 and the splitting of order 2 need far more work",
    )
    .size(340, 300)
    .x(Axis::log("torques evaluated"))
    .y(Axis::log("error of the attitude / rad").range(1e-15, 1.0));
    for (method, name, ink) in DRAWN {
        let sweep = problem.sweep(method, Variables::Space, settings(method));
        let points = (sweep.runs().iter())
            .map(|run| (run.work.torques() as f64, run.errors.attitude))
            .filter(|(_, error)| *error < 0.5 && *error > 1e-15);
        panel = panel.curve(Curve::new(points, ink).label(name));
    }
    panel.figure()
}
