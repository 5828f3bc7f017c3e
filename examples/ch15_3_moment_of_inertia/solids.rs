//! Uniform solids, each against point masses that stand for it; a torus in slices.

use super::{Mass, Parameters, diagonal, uniform, whole};
use core::f64::consts::{FRAC_PI_2, TAU};
use kit::prelude::*;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::inertia::MassProperties;
use rotation_dynamics::math::EPS;

/// Values of a coordinate and their weights.
type Nodes = Vec<(f64, f64)>;

/// A coordinate that runs from 0 to 1: Gauss's rule with four points.
fn line() -> Nodes {
    let pair = |x: f64, w: f64| [(0.5 - 0.5 * x, 0.5 * w), (0.5 + 0.5 * x, 0.5 * w)];
    let outer = pair(0.861_136_311_594_052_6, 0.347_854_845_137_453_85);
    [outer, pair(0.339_981_043_584_856_26, 0.652_145_154_862_546_2)].concat()
}

/// One that runs once round: eight equal angles.
fn turn() -> Nodes {
    (0..8).map(|i| (TAU * f64::from(i) / 8.0, 0.125)).collect()
}

/// One that the solid does not need.
fn none() -> Nodes {
    vec![(0.0, 1.0)]
}

/// What a solid has at the coordinates (u, v, w): its volume element, up to a factor, and the place.
type Element = fn([f64; 3]) -> (f64, [f64; 3]);

/// A solid of the table.
pub struct Row {
    pub name: &'static str,
    formulas: [&'static str; 3], // of its moments
    solid: MassProperties,       // the library's
    over: [fn() -> Nodes; 3],    // how its coordinates run
    element: Element,
}

/// A place given by the distance from the third axis, the angle about it, and the height.
fn round(radius: f64, angle: f64, height: f64) -> [f64; 3] {
    let (s, c) = sincos(angle);
    [radius * c, radius * s, height]
}

/// A place on the unit sphere, by its height from 0 to 1 and the angle about the third axis.
fn direction(height: f64, angle: f64) -> [f64; 3] {
    let z = 2.0 * height - 1.0;
    round(((1.0 - z) * (1.0 + z)).sqrt(), angle, z)
}

/// Radius, inner radius, and length or height; semi-axes or edges; radius of the tube.
const R: f64 = 0.5;
const INNER: f64 = 0.3;
const L: f64 = 1.2;
const A: f64 = 0.4;
const B: f64 = 0.7;
const C: f64 = 0.9;
const TUBE: f64 = 0.2;

/// The moments of a body that is the same across its third axis in any direction.
const fn axial(across: &'static str, along: &'static str) -> [&'static str; 3] {
    [across, across, along]
}

fn row(
    name: &'static str,
    formulas: [&'static str; 3],
    solid: MassProperties,
    over: [fn() -> Nodes; 3],
    element: Element,
) -> Row {
    Row { name, formulas, solid, over, element }
}

#[rustfmt::skip]
fn rows() -> Result<[Row; 12]> {
    Ok([
        row("rod", axial("M l^2/12", "0"), uniform::rod(1.0, L)?, [line, none, none], |[u, ..]| (1.0, [0.0, 0.0, L * u])),
        row("hoop", axial("M r^2/2", "M r^2"), uniform::hoop(1.0, R)?, [none, turn, none],
            |[_, v, _]| (1.0, round(R, v, 0.0))),
        row("disc", axial("M r^2/4", "M r^2/2"), uniform::disc(1.0, R)?, [line, turn, none],
            |[u, v, _]| (u, round(R * u, v, 0.0))),
        row("plate", ["M b^2/12", "M a^2/12", "M (a^2 + b^2)/12"], uniform::plate(1.0, A, B)?, [line, line, none],
            |[u, v, _]| (1.0, [A * u, B * v, 0.0])),
        row("cuboid", ["M (b^2 + c^2)/12", "M (a^2 + c^2)/12", "M (a^2 + b^2)/12"], uniform::cuboid(1.0, A, B, C)?,
            [line, line, line], |[u, v, w]| (1.0, [A * u, B * v, C * w])),
        row("cylinder", axial("M (r^2/4 + l^2/12)", "M r^2/2"), uniform::cylinder(1.0, R, L)?, [line, turn, line],
            |[u, v, w]| (u, round(R * u, v, L * w))),
        row("tube, inner radius b", axial("M ((r^2 + b^2)/4 + l^2/12)", "M (r^2 + b^2)/2"),
            uniform::hollow_cylinder(1.0, INNER, R, L)?, [line, turn, line],
            |[u, v, w]| (INNER + (R - INNER) * u, round(INNER + (R - INNER) * u, v, L * w))),
        row("cone", axial("M (12 r^2 + 3 h^2)/80", "M (3 r^2/10)"), uniform::cone(1.0, R, L)?, [line, turn, line],
            |[u, v, w]| (u * w * w, round(R * u * w, v, L * w))),
        row("sphere", axial("M (2 r^2/5)", "M (2 r^2/5)"), uniform::sphere(1.0, R)?, [line, turn, line],
            |[u, v, w]| (u * u, direction(w, v).map(|x| R * u * x))),
        row("spherical shell", axial("M (2 r^2/3)", "M (2 r^2/3)"), uniform::spherical_shell(1.0, R)?,
            [none, turn, line], |[_, v, w]| (1.0, direction(w, v).map(|x| R * x))),
        row("ellipsoid", ["M (b^2 + c^2)/5", "M (a^2 + c^2)/5", "M (a^2 + b^2)/5"], uniform::ellipsoid(1.0, A, B, C)?,
            [line, turn, line], |[u, v, w]| {
                let [x, y, z] = direction(w, v).map(|x| u * x);
                (u * u, [A * x, B * y, C * z])
            }),
        row("torus, tube of radius b", axial("M (r^2/2 + 5 b^2/8)", "M (r^2 + 3 b^2/4)"), uniform::torus(1.0, R, TUBE)?,
            [line, turn, turn], |[u, v, w]| {
                let radius = R + TUBE * u * cos(w);
                (u * radius, round(radius, v, TUBE * u * sin(w)))
            }),
    ])
}

/// Point masses that have the moments of a solid of mass 1.
fn points(row: &Row) -> Vec<Mass> {
    let [us, vs, ws] = row.over.map(|nodes| nodes());
    let mut points = Vec::new();
    for (u, a) in &us {
        for (v, b) in &vs {
            for (w, c) in &ws {
                let (volume, place) = (row.element)([*u, *v, *w]);
                points.push((a * b * c * volume, place.into()));
            }
        }
    }
    let mass = whole(&points);
    points.into_iter().map(|(m, place)| (m / mass, place)).collect()
}

/// Each solid, how many points stand for it, and by how much their moments differ from the solid's,
/// over its first; those of the solid are off by the part `damage`.
pub fn compared(damage: f64) -> Result<Vec<(Row, usize, f64)>> {
    let of = |row: Row| {
        let (points, solid) = (points(&row), &row.solid);
        let sums = MassProperties::of_points(&points)?.about_centre_of_mass().matrix();
        let moments = solid.about_centre_of_mass().matrix();
        let pairs = sums.as_flattened().iter().zip(moments.as_flattened());
        let off = largest(pairs.map(|(sum, moment)| sum - moment * (1.0 + damage)));
        let off = off / diagonal(solid)[0];
        Ok((row, points.len(), off))
    };
    rows()?.into_iter().map(of).collect()
}

/// The solids of the library, their moments, and how far the points are off.
pub fn table(_: &Parameters, report: &mut Report) -> Result<()> {
    let columns = ["solid", "I_1", "I_2", "I_3", "points", "off by / eps"];
    report.add(Table::of("solids", columns, compared(0.0)?, |(row, count, off)| {
        let [one, two, three] = row.formulas;
        let (count, off) = (count.to_string(), format!("{:.1}", off / EPS));
        Ok([row.name.into(), one.into(), two.into(), three.into(), count, off])
    })?)
}

/// How a torus with the tube TUBE/R is cut, its radius 1: at the part u of the way through, half
/// the width of the slice and its weight.
type Slice = fn(f64) -> (f64, f64);

/// In slices of equal thickness across its axis.
fn equal_thickness(u: f64) -> (f64, f64) {
    let height = 2.0 * u - 1.0;
    let half = TUBE / R * ((1.0 - height) * (1.0 + height)).sqrt();
    (half, half)
}

/// At equal steps of the angle in the tube's section.
fn equal_angles(u: f64) -> (f64, f64) {
    let c = cos(FRAC_PI_2 * (2.0 * u - 1.0));
    // A slice is the thinner the nearer to top and bottom.
    (TUBE / R * c, TUBE / R * c * c)
}

/// I_3/(M R^2) from `n` slices, the mean of 1 + h^2 with half the width h: a washer from 1 - h to
/// 1 + h has the mean square radius ((1 - h)^2 + (1 + h)^2)/2.
fn sliced(n: u32, slice: Slice) -> f64 {
    let (mut weights, mut sum) = (0.0, 0.0);
    for i in 0..n {
        let (half, weight) = slice((f64::from(i) + 0.5) / f64::from(n));
        weights += weight;
        sum += weight * half * half;
    }
    1.0 + sum / weights
}

/// Doubles the slices until they agree with half as many, unless that would take more than a
/// second; the value, and all slices cut.
fn agreed(slice: Slice, tolerance: f64) -> rotation_dynamics::Result<(f64, u32)> {
    let (mut all, mut last, mut best) = (4, sliced(4, slice), f64::INFINITY);
    for n in (3..=22).map(|doublings| 1 << doublings) {
        let next = sliced(n, slice);
        all += n;
        best = (next / last - 1.0).abs();
        if best <= tolerance {
            return Ok((next, all));
        }
        last = next;
    }
    Err(Error::NotDelivered { requested: tolerance, best, condition: None })
}

/// What accuracy costs: a torus cut in two ways.
pub fn strip(p: &Parameters, report: &mut Report) -> Result<()> {
    let exact = 1.0 + 0.75 * (TUBE / R) * (TUBE / R);
    claims! { report,
        /// I_3/(M R^2) of a torus whose tube is two fifths of R
        torus: exact, "-", "slices at equal angles" => agreed(equal_angles, p.tolerance)?.0, within 2.0 * p.tolerance;
    }?;
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-12];
    let angles = |tolerance| agreed(equal_angles, tolerance);
    let thickness = |tolerance| agreed(equal_thickness, tolerance);
    let slices = |(_, count): &(f64, u32)| format!("{count} slices");
    let error = move |&(value, _): &(f64, u32)| Ok((value / exact - 1.0).abs());
    report.controlled("solve: slices at equal angles", asked, angles, slices, error)?;
    report.controlled("solve: slices of equal thickness", asked, thickness, slices, error)?;
    report.in_closed_form(|part| 1.0 + 0.75 * part * part);
    Ok(())
}
