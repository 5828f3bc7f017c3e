//! What a flight tells in numbers.

use super::{AXES, Lengths, Thrown, size, triple};
use kit::{Found, Result};
use rotation_dynamics::inertia::solids;

/// The pairs of moments whose ratios are told.
const PAIRS: [(&str, usize, usize); 3] = [("I_x/I_z", 0, 2), ("I_y/I_z", 1, 2), ("I_x/I_y", 0, 1)];

/// A fit that describes a flight leaves the noise; with so many times as much it does not.
const UNEXPLAINED: f64 = 4.0;

impl Thrown {
    /// All numbers; compared with a uniform box if one is given.
    pub(super) fn found(&self, compared: Option<Lengths>) -> Result<Vec<Found>> {
        let (fit, count) = (&self.fit, self.times.len());
        let mean = self.rates.iter().map(size).sum::<f64>() / count as f64;
        let per_second = (count - 1) as f64 / self.duration();
        let turn = core::f64::consts::TAU / mean;
        let mut found = vec![
            Found::number("from", "first sample, as the file counts time", "s", self.times[0], 6),
            Found::number("to", "last sample", "s", self.times[count - 1], 6),
            Found::number("samples", "how many are fitted", "-", count as f64, 6),
            Found::number("turns", "turns a second, in the mean", "1/s", turn.recip(), 3),
            Found::number("sampling", "samples a turn", "-", per_second * turn, 3),
        ];
        for (name, i, j) in PAIRS {
            let meaning =
                format!("ratio of the moments about the axes {} and {}", AXES[i], AXES[j]);
            found.push(match fit.ratio(i, j) {
                Some(ratio) => Found::estimate(name, meaning, "-", triple(ratio)),
                None => Found::open(
                    name,
                    meaning,
                    "this flight does not tell it, as a spin about one axis does not",
                ),
            });
        }
        if let Some(lengths) = compared {
            let [a, b, c] = lengths;
            let solid = solids::cuboid(1.0, a, b, c)?.about_centre_of_mass();
            let moment = |i: usize| solid.matrix()[i][i];
            let size = format!("a uniform box of {a} by {b} by {c} m");
            for (key, i, j) in [("box I_x/I_z", 0, 2), ("box I_y/I_z", 1, 2)] {
                found.push(Found::number(key, size.clone(), "-", moment(i) / moment(j), 4));
            }
        }
        self.motion(&mut found);
        found.push(Found::number(
            "misfit",
            "root of the mean square of the residuals",
            "rad/s",
            fit.misfit(),
            2,
        ));
        let noise = self.noise();
        if fit.misfit() > UNEXPLAINED * noise {
            let meaning = "misfit over noise: this is no free flight, or more acts than is fitted; \
                try another piece, with from and to";
            let told = Found::number("not explained", meaning, "-", fit.misfit() / noise, 2);
            found.insert(0, told);
        }
        if let Some(kept) = fit.kept() {
            let keys = [["energy: change", "energy: scatter"], ["|L|: change", "|L|: scatter"]];
            for (([change_key, scatter_key], what), course) in
                keys.into_iter().zip(["energy", "size of L"]).zip(kept)
            {
                let [change, scatter] = [course.change, course.scatter].map(|part| 100.0 * part);
                let words = format!("{what} by the samples, from the first to the last");
                found.push(Found::number(change_key, words, "%", change, 2));
                let words = format!("{what} by the samples, scatter about that");
                found.push(Found::number(scatter_key, words, "%", scatter, 2));
            }
        }
        Ok(found)
    }

    /// Which axis is the middle one, on which side of the separatrix it turns, and its flips.
    fn motion(&self, found: &mut Vec<Found>) {
        let (fit, axis) = (&self.fit, self.fit.middle_axis());
        let meaning = "axis of the middle moment";
        let Some((axis, side)) = axis.zip(fit.separatrix()) else {
            let why = match fit.moments() {
                Some(_) => "two moments may be equal",
                None => "the moments are not determined",
            };
            found.push(Found::open("middle axis", meaning, why));
            return;
        };
        found.push(Found::word("middle axis", meaning, AXES[axis]));
        let about = if side.value < 1.0 { "largest" } else { "least" };
        let words = match side.holds(1.0) {
            true => "1 on the separatrix, which is within the interval".into(),
            false => format!("1 on the separatrix; L circles the axis of the {about} moment"),
        };
        found.push(Found::estimate("2 E I_mid/L^2", words, "-", triple(side)));
        let half = 0.5 * fit.motion().rate_period();
        let meaning = "between two zeros of the rate about the middle axis, closed form: from flip to flip \
            where it turns about that axis";
        if half.is_finite() {
            found.push(Found::number("half a period", meaning, "s", half, 4));
        }
        let meaning = "the same, counted among the samples";
        found.push(match fit.counted_period() {
            Some(period) => Found::number("counted", meaning, "s", 0.5 * period, 4),
            None => Found::open("counted", meaning, "fewer than two in this flight"),
        });
    }
}
