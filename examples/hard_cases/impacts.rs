//! Two bodies on a line that collide, one of them up to 1e12 times the other.

use super::table::{Cell, Family, Naive, Row, bound};
use rotation_dynamics::Result;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{Contact, Mechanism, State, motion};

pub const FAMILY: Family = Family {
    key: "impacts",
    title: "Impacts of a trillion to one",
    cure: "the impulse is what is solved for; nobody's energy is a difference of the others'",
    methods: &["contact solver"],
    forms: &["speed of the one that hits", "speed of the one that is hit"],
    rows,
};

/// A mass that hits another of 1 kg, which is at rest 1 m on.
struct Pair {
    mass: f64,
    restitution: f64,
}

impl Mechanism<2, 4, 1> for Pair {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[self.mass, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: &State<2>) -> [f64; 2] {
        [0.0; 2]
    }
    fn contacts(&self, pair: &State<2>) -> [Contact<2>; 1] {
        let [x, y] = pair.q;
        [Contact::new("they meet", y - x, [-1.0, 1.0], 0.0).restitution(self.restitution)]
    }
}

fn hit([case, wrong]: [&'static str; 2], pair: Pair) -> Result<Row> {
    let (m, e) = (pair.mass, pair.restitution);
    let truth = [(m - e) / (m + 1.0), m * (1.0 + e) / (m + 1.0)];
    let start = State {
        q: [0.0, 1.0],
        v: [1.0, 0.0],
    };
    let after = motion(&pair, &Dop853::new(1e-15)?, start, 2.0).and_then(|found| {
        let meets = found.events().first();
        Ok(meets.map_or([f64::NAN; 2], |event| event.after.v))
    });
    // The one that is hit has what the energy lacks: by its square root.
    let lost = 0.5 * (1.0 - e * e) * m / (1.0 + m);
    let left = 0.5 * m - lost - 0.5 * m * truth[0] * truth[0];
    let naive = Naive {
        method: "the second speed from what is left of the energy",
        error: ((2.0 * left.max(0.0)).sqrt() / truth[1] - 1.0).abs(),
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
        ("1e-4 hits 1, half elastic", light, 1e-4, 0.5),
        ("1e4 hits 1, half elastic", heavy, 1e4, 0.5),
        ("1e8 hits 1, elastic", heavy, 1e8, 1.0),
        ("1e12 hits 1, elastic", heavy, 1e12, 1.0),
        ("1e12 hits 1, plastic", heavy, 1e12, 0.0),
    ] {
        rows.push(hit([case, wrong], Pair { mass, restitution })?);
    }
    Ok(rows)
}
