//! Two bodies on a line that collide, one of them up to 1e12 times the other.

use super::table::{Cell, Family, Naive, Row, bound};
use kit::Result;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, motion};

pub const FAMILY: Family = Family {
    key: "impacts",
    title: "Impacts of a trillion to one",
    cure: "the impulse is what is solved for; nobody's energy is a difference of the others'",
    methods: &["contact solver"],
    forms: &["speed of the one that hits", "speed of the one that is hit"],
    rows,
};

/// Of the one that hits (m/s): at 1 m/s the energies of a heavy mass are whole numbers, and
/// their difference is exact by luck.
pub const SPEED: f64 = 1.7;

/// A mass that hits another of 1 kg, which is at rest 1 m on.
struct Pair {
    mass: f64,
    restitution: f64,
}

impl Mechanism<2, 1> for Pair {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[self.mass, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [0.0; 2]
    }
    fn contacts(&self, pair: &MechanismState<2>) -> [Contact<2>; 1] {
        let [x, y] = pair.q;
        [Contact::new("they meet", y - x, [-1.0, 1.0], 0.0).restitution(self.restitution)]
    }
}

/// The speed of the one that is hit, from what the energy lacks.
pub fn by_energy(m: f64, e: f64) -> f64 {
    let first = SPEED * (m - e) / (m + 1.0);
    let lost = 0.5 * (1.0 - e * e) * m / (1.0 + m) * SPEED * SPEED;
    let left = 0.5 * m * SPEED * SPEED - lost - 0.5 * m * first * first;
    (2.0 * left.max(0.0)).sqrt()
}

/// The speed of the one that an elastic body of this mass hits: by the energy, and by the
/// solver; off by these parts of it.
pub fn errors(mass: f64) -> Result<[f64; 2]> {
    let restitution = 1.0;
    let row = hit(["", ""], Pair { mass, restitution })?;
    let solved = row.cells[1].part().unwrap_or(f64::NAN) * row.least_bound();
    Ok([row.naive.error, solved])
}

fn hit([case, wrong]: [&'static str; 2], pair: Pair) -> Result<Row> {
    let (m, e) = (pair.mass, pair.restitution);
    let truth = [(m - e) / (m + 1.0), m * (1.0 + e) / (m + 1.0)].map(|part| part * SPEED);
    let start = MechanismState {
        q: [0.0, 1.0],
        v: [SPEED, 0.0],
    };
    let after = motion(&pair, &Dop853::new(1e-15)?, start, 2.0).map(|found| {
        let meets = found.events().first();
        meets.map_or([f64::NAN; 2], |event| event.after.v)
    });
    let naive = Naive {
        method: "the second speed from what is left of the energy",
        error: (by_energy(m, e) / truth[1] - 1.0).abs(),
    };
    // Each speed is relative to itself: a product and a sum of what is given.
    let condition = 4.0;
    let mut cells = Vec::new();
    for (i, form) in FAMILY.forms.iter().enumerate() {
        let answer = after.clone().map(|v| (v[i] / truth[i] - 1.0).abs());
        let name = (case, FAMILY.methods[0], *form);
        cells.push(Cell::of(name, answer, bound(8.0, condition))?);
    }
    Ok(Row {
        case,
        wrong,
        condition,
        naive,
        cells,
    })
}

fn rows() -> Result<Vec<Row>> {
    let light = "what the heavy one gets is lost in the energy of the light one";
    let heavy = "what the light one gets is lost in the energy of the heavy one";
    let mut rows = Vec::new();
    for (case, wrong, mass, restitution) in [
        ("1e-12 hits 1, elastic", light, 1e-12, 1.0),
        ("1e-8 hits 1, elastic", light, 1e-8, 1.0),
        ("1e-6 hits 1, half elastic", light, 1e-6, 0.5),
        ("1e6 hits 1, half elastic", heavy, 1e6, 0.5),
        ("1e8 hits 1, elastic", heavy, 1e8, 1.0),
        ("1e12 hits 1, elastic", heavy, 1e12, 1.0),
        ("1e12 hits 1, plastic", heavy, 1e12, 0.0),
    ] {
        rows.push(hit([case, wrong], Pair { mass, restitution })?);
    }
    Ok(rows)
}
