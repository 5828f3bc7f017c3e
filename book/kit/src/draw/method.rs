//! How methods of integration look: one ink, dash and marker for each, on every page.

use super::curve::Curve;
use super::display::Dash;
use super::ink::Ink;

/// The shape of the points on a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// A filled disc.
    Disc,
    /// A ring.
    Ring,
    /// A square.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle.
    Triangle,
}

/// A method of integration, as it is drawn.
///
/// | methods | ink |
/// |---|---|
/// | RK4, Munthe-Kaas 4 | brown |
/// | DOP853 | wine |
/// | Strang, SRKN 6b, SRKN 14a, Kahan-Li 17b | olive |
/// | ABA(8,2), ABA(10,4), ABA(10,6,4) | teal |
/// | Gauss-Legendre 16: plain, projected, spin-free | violet |
/// | closed form, exact flow, `solve` | ink |
/// | naive methods | vermillion, dashed |
/// | others | grey, thin |
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The closed form.
    Exact,
    /// The exact flow, step by step.
    Flow,
    /// What `solve` chooses.
    Solve,
    /// Classical Runge-Kutta of order 4.
    Rk4,
    /// Runge-Kutta of order 4 on the group.
    MuntheKaas4,
    /// Dormand and Prince of order 8.
    Dop853,
    /// DOP853 with the spin taken out, or on other variables.
    Dop853Changed,
    /// Splitting of order 2.
    Strang,
    /// Blanes-Moan SRKN 6b, order 4.
    Srkn6b,
    /// Blanes-Moan SRKN 14a, order 6.
    Srkn14a,
    /// Kahan-Li 17b, order 8.
    KahanLi17b,
    /// McLachlan ABA(8,2).
    Aba82,
    /// ABA(10,4).
    Aba104,
    /// ABA(10,6,4).
    Aba1064,
    /// Gauss-Legendre of order 16.
    Gauss,
    /// Gauss-Legendre, brought back to the invariants.
    GaussProjected,
    /// Gauss-Legendre with the spin taken out.
    GaussSpinFree,
    /// Euler on angles, semi-implicit Euler.
    Naive,
    /// Somebody else's.
    Other,
}

/// A part of a method's name, lower case, and who is meant. The first that fits counts.
const NAMES: [(&str, Method); 20] = [
    ("solve", Method::Solve),
    ("closed form", Method::Exact),
    ("exact flow", Method::Flow),
    ("projected", Method::GaussProjected),
    ("gauss-legendre 16, spin-free", Method::GaussSpinFree),
    ("gauss", Method::Gauss),
    ("munthe-kaas 4", Method::MuntheKaas4),
    ("srkn 6b", Method::Srkn6b),
    ("srkn 14a", Method::Srkn14a),
    ("kahan-li 17b", Method::KahanLi17b),
    ("aba(8,2)", Method::Aba82),
    ("aba(10,4)", Method::Aba104),
    ("aba(10,6,4)", Method::Aba1064),
    ("strang", Method::Strang),
    ("dop853 on", Method::Dop853Changed),
    ("dop853,", Method::Dop853Changed),
    ("dop853", Method::Dop853),
    ("rk4", Method::Rk4),
    ("euler", Method::Naive),
    ("naive", Method::Naive),
];

impl Method {
    /// The method of this name, as tables and strips write it; [`Method::Other`] if it is
    /// not one of the library's.
    pub fn named(name: &str) -> Self {
        let name = name.to_lowercase();
        NAMES
            .iter()
            .find(|(part, _)| name.contains(part))
            .map_or(Self::Other, |(_, method)| *method)
    }

    /// Its ink.
    pub fn ink(self) -> Ink {
        match self {
            Self::Exact | Self::Flow | Self::Solve => Ink::Ink,
            Self::Rk4 | Self::MuntheKaas4 => Ink::RungeKutta,
            Self::Dop853 | Self::Dop853Changed => Ink::Adaptive,
            Self::Strang | Self::Srkn6b | Self::Srkn14a | Self::KahanLi17b => Ink::Splitting,
            Self::Aba82 | Self::Aba104 | Self::Aba1064 => Ink::WeakKicks,
            Self::Gauss | Self::GaussProjected | Self::GaussSpinFree => Ink::Gauss,
            Self::Naive => Ink::Wrong,
            Self::Other => Ink::Frame,
        }
    }

    fn dash(self) -> Dash {
        match self {
            Self::MuntheKaas4
            | Self::Dop853Changed
            | Self::Aba104
            | Self::KahanLi17b
            | Self::GaussProjected
            | Self::Solve
            | Self::Naive => Dash::Dashed,
            Self::Flow | Self::Strang | Self::Aba1064 => Dash::Dotted,
            _ => Dash::Solid,
        }
    }

    fn marker(self) -> Marker {
        match self {
            Self::Rk4 | Self::Srkn6b | Self::Aba82 | Self::GaussSpinFree => Marker::Square,
            Self::MuntheKaas4 | Self::Strang | Self::Dop853Changed | Self::GaussProjected => {
                Marker::Ring
            }
            Self::Dop853 | Self::KahanLi17b | Self::Aba1064 => Marker::Diamond,
            Self::Srkn14a | Self::Aba104 | Self::Naive => Marker::Triangle,
            _ => Marker::Disc,
        }
    }

    /// Its name beside a line.
    pub fn label(self) -> &'static str {
        match self {
            Self::Exact => "closed form",
            Self::Flow => "exact flow",
            Self::Solve => "solve",
            Self::Rk4 => "RK4",
            Self::MuntheKaas4 => "MK4",
            Self::Dop853 => "DOP853",
            Self::Dop853Changed => "DOP853, spin-free",
            Self::Strang => "Strang",
            Self::Srkn6b => "SRKN 6b",
            Self::Srkn14a => "SRKN 14a",
            Self::KahanLi17b => "Kahan-Li 17b",
            Self::Aba82 => "ABA(8,2)",
            Self::Aba104 => "ABA(10,4)",
            Self::Aba1064 => "ABA(10,6,4)",
            Self::Gauss => "Gauss 16",
            Self::GaussProjected => "Gauss, projected",
            Self::GaussSpinFree => "Gauss, spin-free",
            Self::Naive => "naive",
            Self::Other => "other",
        }
    }

    /// A curve of this method's: its ink, dash and markers; unlabelled.
    ///
    /// ```
    /// use kit::draw::{Ink, Method};
    /// let runs = [(10.0, 1e-3), (20.0, 6e-5)];
    /// let method = Method::named("Blanes-Moan SRKN 6b splitting");
    /// assert_eq!((method, method.ink()), (Method::Srkn6b, Ink::Splitting));
    /// let curve = method.curve(runs).with_dots().label_end(method.label());
    /// ```
    pub fn curve(self, points: impl IntoIterator<Item = (f64, f64)>) -> Curve {
        let mut curve = Curve::new(points, self.ink());
        (curve.dash, curve.marker) = (self.dash(), self.marker());
        if self == Self::Other { curve.thin() } else { curve }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn names_of_tables_are_known() {
        for (name, method) in [
            ("RK4", Method::Rk4),
            ("solve: RK4", Method::Solve),
            ("Strang splitting", Method::Strang),
            ("Blanes-Moan SRKN 14a splitting", Method::Srkn14a),
            ("Blanes et al. ABA(10,4)", Method::Aba104),
            ("McLachlan ABA(8,2)", Method::Aba82),
            ("Gauss-Legendre 16", Method::Gauss),
            ("Gauss-Legendre 16, spin-free", Method::GaussSpinFree),
            ("Gauss-Legendre 16, projected", Method::GaussProjected),
            ("DOP853, spin-free", Method::Dop853Changed),
            ("semi-implicit Euler", Method::Naive),
            ("closed form, batch", Method::Exact),
            ("rapier", Method::Other),
        ] {
            assert_eq!(Method::named(name), method, "{name}");
        }
    }

    #[test]
    fn no_two_methods_look_the_same() {
        let looks: BTreeSet<String> = NAMES
            .iter()
            .map(|(_, m)| (m, format!("{:?} {:?} {:?}", m.ink(), m.dash(), m.marker())))
            .map(|(_, look)| look)
            .collect();
        // Two names are second names: of the naive methods and of the changed DOP853.
        assert_eq!(looks.len(), NAMES.len() - 2, "{looks:?}");
        let labels: BTreeSet<&str> = NAMES.iter().map(|(_, m)| m.label()).collect();
        assert_eq!(labels.len(), looks.len());
    }
}
