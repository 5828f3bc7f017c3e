//! Uniform solids, each against point masses that stand for it; a torus in slices.

use super::{Parameters, diagonal, uniform};
use core::f64::consts::{FRAC_PI_2, TAU};
use kit::{ClosedForm, Computation, Price, Report, Result, Table, claim};
use rotation_dynamics::Error;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::MassProperties;
use rotation_dynamics::math::{EPS, sincos, sort_by_number};

/// How a coordinate runs through a solid: from 0 to 1, once round, or not at all.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Over {
    Line,
    Turn,
    Nothing,
}
use Over::{Line, Nothing, Turn};

impl Over {
    /// Nodes and weights: Gauss's rule with four points; eight equal angles.
    fn rule(self) -> Vec<(f64, f64)> {
        const GAUSS: [(f64, f64); 2] = [
            (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
            (0.339_981_043_584_856_26, 0.652_145_154_862_546_2),
        ];
        match self {
            Line => GAUSS
                .iter()
                .flat_map(|(x, w)| [(0.5 - 0.5 * x, 0.5 * w), (0.5 + 0.5 * x, 0.5 * w)])
                .collect(),
            Turn => (0..8).map(|i| (TAU * f64::from(i) / 8.0, 0.125)).collect(),
            Nothing => vec![(0.0, 1.0)],
        }
    }
}

/// What a solid has at the coordinates (u, v, w): its volume element, up to a factor, and the place.
type Element = fn([f64; 3]) -> (f64, [f64; 3]);

/// A solid of the table: its name, its moments as formulas, the library's, its coordinates.
struct Row {
    name: &'static str,
    formulas: [&'static str; 3],
    solid: rotation_dynamics::Result<MassProperties>,
    over: [Over; 3],
    element: Element,
}

/// A place given by the distance from the third axis, the angle about it, and the height.
fn round(radius: f64, angle: f64, height: f64) -> [f64; 3] {
    let (s, c) = sincos(angle);
    [radius * c, radius * s, height]
}

/// A place on the unit sphere.
fn direction(height: f64, angle: f64) -> [f64; 3] {
    round(((1.0 - height) * (1.0 + height)).sqrt(), angle, height)
}

/// Point masses that have the moments of a solid of mass 1.
fn points(row: &Row) -> Vec<(f64, DesignVector)> {
    let [us, vs, ws] = row.over.map(Over::rule);
    let mut points = Vec::new();
    for (u, a) in &us {
        for (v, b) in &vs {
            for (w, c) in &ws {
                let (volume, place) = (row.element)([*u, *v, *w]);
                points.push((a * b * c * volume, place.into()));
            }
        }
    }
    let mass: f64 = points.iter().map(|(m, _)| m).sum();
    points.into_iter().map(|(m, place)| (m / mass, place)).collect()
}

/// Radius, inner radius and length; semi-axes or edges; radius of the tube.
const R: f64 = 0.5;
const INNER: f64 = 0.3;
const L: f64 = 1.2;
const AXES: [f64; 3] = [0.4, 0.7, 0.9];
const TUBE: f64 = 0.2;

#[rustfmt::skip]
fn rows() -> [Row; 12] {
    let [a, b, c] = AXES;
    let row = |name, formulas, solid, over, element| Row { name, formulas, solid, over, element };
    let rod = "M l^2/12";
    let same = |formula| [formula, formula, formula];
    [
        row("rod", [rod, rod, "0"], uniform::rod(1.0, L), [Line, Nothing, Nothing],
            |[u, ..]| (1.0, [0.0, 0.0, L * u])),
        row("hoop", ["M r^2/2", "M r^2/2", "M r^2"], uniform::hoop(1.0, R), [Nothing, Turn, Nothing],
            |[_, v, _]| (1.0, round(R, v, 0.0))),
        row("disc", ["M r^2/4", "M r^2/4", "M r^2/2"], uniform::disc(1.0, R), [Line, Turn, Nothing],
            |[u, v, _]| (u, round(R * u, v, 0.0))),
        row("plate", ["M b^2/12", "M a^2/12", "M (a^2 + b^2)/12"], uniform::plate(1.0, a, b), [Line, Line, Nothing],
            |[u, v, _]| (1.0, [AXES[0] * u, AXES[1] * v, 0.0])),
        row("cuboid", ["M (b^2 + c^2)/12", "M (a^2 + c^2)/12", "M (a^2 + b^2)/12"], uniform::cuboid(1.0, a, b, c),
            [Line, Line, Line], |[u, v, w]| (1.0, [AXES[0] * u, AXES[1] * v, AXES[2] * w])),
        row("cylinder", ["M (r^2/4 + l^2/12)", "M (r^2/4 + l^2/12)", "M r^2/2"], uniform::cylinder(1.0, R, L),
            [Line, Turn, Line], |[u, v, w]| (u, round(R * u, v, L * w))),
        row("tube, inner radius b", ["M ((r^2 + b^2)/4 + l^2/12)", "M ((r^2 + b^2)/4 + l^2/12)", "M (r^2 + b^2)/2"],
            uniform::hollow_cylinder(1.0, INNER, R, L), [Line, Turn, Line],
            |[u, v, w]| {
                let radius = INNER + (R - INNER) * u;
                (radius, round(radius, v, L * w))
            }),
        row("cone", ["M (12 r^2 + 3 h^2)/80", "M (12 r^2 + 3 h^2)/80", "M (3 r^2/10)"], uniform::cone(1.0, R, L),
            [Line, Turn, Line], |[u, v, w]| (u * w * w, round(R * u * w, v, L * w))),
        row("sphere", same("M (2 r^2/5)"), uniform::sphere(1.0, R), [Line, Turn, Line],
            |[u, v, w]| (u * u, direction(2.0 * w - 1.0, v).map(|x| R * u * x))),
        row("spherical shell", same("M (2 r^2/3)"), uniform::spherical_shell(1.0, R), [Nothing, Turn, Line],
            |[_, v, w]| (1.0, direction(2.0 * w - 1.0, v).map(|x| R * x))),
        row("ellipsoid", ["M (b^2 + c^2)/5", "M (a^2 + c^2)/5", "M (a^2 + b^2)/5"], uniform::ellipsoid(1.0, a, b, c),
            [Line, Turn, Line], |[u, v, w]| {
                let [x, y, z] = direction(2.0 * w - 1.0, v).map(|x| u * x);
                (u * u, [AXES[0] * x, AXES[1] * y, AXES[2] * z])
            }),
        row("torus, tube of radius b", ["M (r^2/2 + 5 b^2/8)", "M (r^2/2 + 5 b^2/8)", "M (r^2 + 3 b^2/4)"],
            uniform::torus(1.0, R, TUBE), [Line, Turn, Turn], |[u, v, w]| {
                let (s, c) = sincos(w);
                let radius = R + TUBE * u * c;
                (u * radius, round(radius, v, TUBE * u * s))
            }),
    ]
}

/// By how much the moments of the points differ from the solid's, over its largest, and their
/// number; the solid's moments damaged by a relative amount.
fn difference(row: &Row, damage: f64) -> Result<(f64, usize)> {
    let points = points(row);
    let sums = MassProperties::of_points(&points)?.about_centre_of_mass().matrix();
    let solid = row.solid.clone()?.about_centre_of_mass().matrix();
    let mut off = 0.0_f64;
    for i in 0..3 {
        for j in 0..3 {
            let error = (sums[i][j] - solid[i][j] * (1.0 + damage)).abs();
            off = if error > off || error.is_nan() { error } else { off };
        }
    }
    Ok((off / diagonal(row.solid.as_ref().map_err(Clone::clone)?)[0], points.len()))
}

/// For the tests: each solid's name and how far its points are off.
pub fn points_of(damage: f64) -> Result<Vec<(&'static str, f64)>> {
    rows().iter().map(|row| Ok((row.name, difference(row, damage)?.0))).collect()
}

/// The solids of the library, their moments, and how far the points are off.
pub fn table(_: &Parameters) -> Result<Table> {
    let mut table = Table::new("solids", ["solid", "I_1", "I_2", "I_3", "points", "off by / eps"])?;
    for row in rows() {
        let (off, count) = difference(&row, 0.0)?;
        let [one, two, three] = row.formulas.map(String::from);
        table.push([
            row.name.into(),
            one,
            two,
            three,
            count.to_string(),
            format!("{:.1}", off / EPS),
        ])?;
    }
    Ok(table)
}

/// I_3/(M R^2) of a torus with the tube s R, from `n` slices of equal thickness across its axis.
fn equal_slices(s: f64, n: u32) -> f64 {
    sliced(n, |u| {
        let height = 2.0 * u - 1.0;
        let half = s * ((1.0 - height) * (1.0 + height)).sqrt();
        (half, half)
    })
}

/// The same from slices at equal steps of the angle in the tube's section.
fn equal_angles(s: f64, n: u32) -> f64 {
    sliced(n, |u| {
        let (_, c) = sincos(FRAC_PI_2 * (2.0 * u - 1.0));
        // A slice is the thinner the nearer to top and bottom.
        (s * c, s * c * c)
    })
}

/// The mean of 1 + h^2, half the width h and weight of each of `n` slices by `slice`: a washer
/// from 1 - h to 1 + h has the mean square radius ((1 - h)^2 + (1 + h)^2)/2.
fn sliced(n: u32, slice: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut weights, mut sum) = (0.0, 0.0);
    for i in 0..n {
        let (half, weight) = slice((f64::from(i) + 0.5) / f64::from(n));
        weights += weight;
        sum += weight * half * half;
    }
    1.0 + sum / weights
}

/// A way of cutting: the thickness of the tube, and the number of slices.
type Rule = fn(f64, u32) -> f64;

/// More slices would take a second.
const MOST: u32 = 1 << 22;

/// Doubles the slices until they agree with half as many; the value, and all slices cut.
fn agreed(rule: Rule, tolerance: f64) -> rotation_dynamics::Result<(f64, u32)> {
    let (mut n, mut all) = (4, 4);
    let mut last = rule(TUBE / R, n);
    loop {
        n *= 2;
        all += n;
        let next = rule(TUBE / R, n);
        let reached = (next / last - 1.0).abs();
        if reached <= tolerance {
            return Ok((next, all));
        }
        if n >= MOST {
            return Err(Error::NotDelivered {
                requested: tolerance,
                best: reached,
                condition: None,
            });
        }
        last = next;
    }
}

/// What accuracy costs: a torus cut in two ways.
pub fn strip(p: &Parameters, report: &mut Report) -> Result<()> {
    let exact = 1.0 + 0.75 * (TUBE / R) * (TUBE / R);
    let (cut, _) = agreed(equal_angles, p.tolerance)?;
    report.add(
        claim("torus", "I_3/(M R^2) of a torus whose tube is two fifths of R", exact, "-")
            .against("slices at equal angles", cut)
            .within(2.0 * p.tolerance),
    )?;
    let rules: [(&str, Rule); 2] = [
        ("solve: slices at equal angles", equal_angles),
        ("solve: slices of equal thickness", equal_slices),
    ];
    let mut asked = vec![1e-3, 1e-5, 1e-7, p.tolerance, 1e-12];
    sort_by_number(&mut asked, |tolerance| -tolerance);
    asked.dedup();
    for (method, rule) in rules {
        for &requested in &asked {
            let (delivered, work, again) = match agreed(rule, requested) {
                Ok((value, slices)) => {
                    let again = Computation::new(
                        move || Ok(agreed(rule, requested)?),
                        move |(value, _)| Ok((value / exact - 1.0).abs()),
                    );
                    ((value / exact - 1.0).abs(), format!("{slices} slices"), Some(again))
                }
                Err(Error::NotDelivered { best, .. }) => (best, "refused".into(), None),
                Err(other) => return Err(other.into()),
            };
            let (method, requested) = (method.into(), Some(requested));
            report.add(Price { method, requested, delivered, work, again })?;
        }
    }
    report.set_closed_form(ClosedForm::new(|part| Ok(1.0 + 0.75 * part * part)));
    Ok(())
}
