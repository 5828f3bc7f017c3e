//! How a mechanism responds in given modes: accelerations and contact forces, or
//! velocities after an impact and impulses.

use super::Modes;
use super::declare::{Contact, Mode, Press, Sense, dot};
use super::linear::{Equations, Root, SIZE, unit};

/// A number smaller than this part of its size counts as none: it is the round-off that equations
/// of sixteen unknowns may leave.
pub(super) const ZERO: f64 = 1e-12;

/// How far a rate may be from 0 where an event says that it is 0. Where a force has come
/// down to 0 through infinity (Painlevé) it is farther.
const DECIDED: f64 = 0.01;

/// The force of a contact, N (or its impulse, N s).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Force {
    /// Along the normal; the contact pushes where it is positive.
    pub normal: f64,
    /// Along the tangent.
    pub tangential: f64,
}

/// The sum of all contact forces, the measure of their round-off.
pub(super) fn total<const C: usize>(forces: &[Force; C]) -> f64 {
    let sizes = forces.iter().map(|f| f.normal.abs() + f.tangential.abs());
    sizes.sum()
}

/// `M rate = load + contacts`, with the normal and the slip rate of each contact that a
/// closed, sticking contact has: rates are accelerations, or velocities after an impact.
pub(super) struct Problem<'a, const N: usize, const C: usize> {
    pub mass: &'a [[f64; N]; N],
    pub load: [f64; N],
    pub contacts: &'a [Contact<N>; C],
    pub aim: [[f64; 2]; C],
    /// In an impact given forces have no impulse, and friction holds no better than it slips.
    pub impact: bool,
}

/// Rates and forces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Response<const N: usize, const C: usize> {
    pub rate: [f64; N],
    pub force: [Force; C],
}

impl<const N: usize, const C: usize> Problem<'_, N, C> {
    /// The response if the contacts are in these modes; `None` if they contradict each other.
    pub(super) fn respond(&self, modes: &Modes<C>) -> Option<Response<N, C>> {
        // Unknowns: the rates, then both forces of each contact. The equations of the
        // contacts come first, those of Newton after them.
        let mut equations = Equations::new(N + 2 * C);
        let (rows, right) = (&mut equations.rows, &mut equations.right);
        for (i, (contact, mode)) in self.contacts.iter().zip(modes).enumerate() {
            let (normal, tangential) = (N + 2 * i, N + 2 * i + 1);
            let (row, slip) = (2 * i, 2 * i + 1);
            match (contact.press, *mode) {
                (Press::Given(force), _) => {
                    rows[row][normal] = 1.0;
                    right[row] = if self.impact { 0.0 } else { force };
                }
                (Press::By(by), _) => {
                    rows[row][normal] = 1.0;
                    if by < C && by != i {
                        rows[row][N + 2 * by] = -1.0;
                    }
                }
                (_, Mode::Open) => rows[row][normal] = 1.0,
                _ => {
                    rows[row][..N].copy_from_slice(&contact.normal.along);
                    right[row] = self.aim[i][0];
                }
            }
            match *mode {
                Mode::Stick => {
                    rows[slip][..N].copy_from_slice(&contact.tangent.along);
                    right[slip] = self.aim[i][1];
                }
                Mode::Slip(sense) => {
                    rows[slip][tangential] = 1.0;
                    rows[slip][normal] = sense.sign() * contact.friction.kinetic;
                }
                Mode::Open | Mode::Smooth => rows[slip][tangential] = 1.0,
            }
            for j in 0..N {
                rows[2 * C + j][normal] = -contact.normal.along[j];
                rows[2 * C + j][tangential] = -contact.tangent.along[j];
            }
        }
        for j in 0..N {
            rows[2 * C + j][..N].copy_from_slice(&self.mass[j]);
            right[2 * C + j] = self.load[j];
        }
        let root = equations.solve(&self.units())?;
        let x = match &root.freedom {
            Some(freedom) => self.most_relaxed(modes, &root, freedom),
            None => root.x,
        };
        Some(Response {
            rate: core::array::from_fn(|j| x[j]),
            force: core::array::from_fn(|i| Force {
                normal: x[N + 2 * i],
                tangential: x[N + 2 * i + 1],
            }),
        })
    }

    /// Units of the unknowns: the units of the forces go with the mass that is nearest to ordinary,
    /// so that masses may be given in any unit.
    fn units(&self) -> [f64; SIZE] {
        let masses = (0..N).map(|j| unit(self.mass[j][j]));
        let far = |unit: f64| unit.max(1.0 / unit);
        let nearest = masses.min_by(|a, b| far(*a).total_cmp(&far(*b)));
        let mut units = [1.0; SIZE];
        units[N..N + 2 * C].fill(nearest.unwrap_or(1.0));
        units
    }

    /// Of forces that are not determined, those in the middle of what the contacts allow.
    fn most_relaxed(&self, modes: &Modes<C>, root: &Root, freedom: &[f64; SIZE]) -> [f64; SIZE] {
        let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
        for i in 0..C {
            let of = |x: &[f64; SIZE]| self.margins(i, modes[i], x[N + 2 * i], x[N + 2 * i + 1]);
            for (margin, slope) in of(&root.x).into_iter().zip(of(freedom)) {
                if slope > 0.0 {
                    from = from.max(-margin / slope);
                } else if slope < 0.0 {
                    to = to.min(-margin / slope);
                }
            }
        }
        let step = match (from.is_finite(), to.is_finite()) {
            (true, true) => 0.5 * (from + to),
            (true, false) => from.max(0.0),
            (false, true) => to.min(0.0),
            (false, false) => 0.0,
        };
        core::array::from_fn(|j| root.x[j] + step * freedom[j])
    }

    /// The numbers that must not be negative in a contact: its normal force, and the room to either
    /// side of the friction cone.
    fn margins(&self, i: usize, mode: Mode, normal: f64, tangential: f64) -> [f64; 3] {
        let contact = &self.contacts[i];
        let held = self.holding(i) * normal;
        match (contact.press, mode) {
            (_, Mode::Open) => [0.0; 3],
            (Press::OneSided, Mode::Stick) => [normal, held - tangential, held + tangential],
            (Press::OneSided, _) => [normal, 0.0, 0.0],
            (_, Mode::Stick) => [0.0, held - tangential, held + tangential],
            _ => [0.0; 3],
        }
    }

    fn holding(&self, i: usize) -> f64 {
        let friction = self.contacts[i].friction;
        if self.impact { friction.kinetic } else { friction.holding }
    }

    /// The size of the forces, the measure of round-off in them.
    fn force_size(&self, i: usize, response: &Response<N, C>) -> f64 {
        let row = &self.contacts[i].normal.along;
        let square = dot(row, row);
        let load: f64 = (0..N).map(|j| (row[j] * self.load[j]).abs()).sum();
        let load = if square > 0.0 { load / square } else { 0.0 };
        load + total(&response.force)
    }

    /// The size of a rate, as large as all forces together could make it.
    fn rate_size(&self, response: &Response<N, C>, j: usize) -> f64 {
        let rows = self
            .contacts
            .iter()
            .map(|contact| contact.normal.along[j].abs() + contact.tangent.along[j].abs());
        let forces = self.load[j].abs() + rows.sum::<f64>() * total(&response.force);
        response.rate[j].abs().max(forces / self.mass[j][j])
    }

    /// Whether the response agrees with what the modes claim, where each contact's rate counts
    /// as none up to this part of its size.
    fn agrees(
        &self,
        modes: &Modes<C>,
        choices: &[Choices; C],
        within: &[f64; C],
        response: &Response<N, C>,
    ) -> bool {
        (0..C).all(|i| {
            let contact = &self.contacts[i];
            let Force { normal, tangential } = response.force[i];
            let forces = -ZERO * self.force_size(i, response);
            let holds = self.margins(i, modes[i], normal, tangential);
            let excess = |along: &[f64; N], aim: f64| {
                let size: f64 = (0..N).map(|j| along[j].abs() * self.rate_size(response, j)).sum();
                (dot(along, &response.rate) - aim, within[i] * (size + aim.abs()))
            };
            let moves = match modes[i] {
                Mode::Open if choices[i].shut => {
                    let (rate, none) = excess(&contact.normal.along, self.aim[i][0]);
                    rate >= -none
                }
                Mode::Slip(sense) if choices[i].slip_begins => {
                    let (rate, none) = excess(&contact.tangent.along, self.aim[i][1]);
                    sense.sign() * rate >= -none
                }
                _ => true,
            };
            let rides = match contact.press {
                Press::By(by) => (modes[i] == Mode::Open) == (modes[by] == Mode::Open),
                _ => true,
            };
            rides && moves && holds.into_iter().all(|margin| margin >= forces)
        })
    }

    /// The modes whose response agrees with them, and that response: all sets are tried, in order.
    /// Where two agree and move differently, the error has both. Where none does, the decision of
    /// an event may be off by [`DECIDED`].
    pub(super) fn search(
        &self,
        choices: &[Choices; C],
    ) -> Result<(Modes<C>, Response<N, C>), Unsolved<C>> {
        match self.search_within(choices, &[ZERO; C]) {
            Err(Unsolved { motions, .. })
                if motions.is_empty() && choices.iter().any(|c| c.decided) =>
            {
                let within = |c: &Choices| if c.decided { DECIDED } else { ZERO };
                self.search_within(choices, &choices.each_ref().map(within))
            }
            found => found,
        }
    }

    fn search_within(
        &self,
        choices: &[Choices; C],
        within: &[f64; C],
    ) -> Result<(Modes<C>, Response<N, C>), Unsolved<C>> {
        let mut found: Option<(Modes<C>, Response<N, C>)> = None;
        let mut tried = 0;
        let mut at = [0; C];
        loop {
            let modes: Modes<C> = core::array::from_fn(|i| choices[i].modes[at[i]]);
            tried += 1;
            if let Some(response) = self.respond(&modes)
                && self.agrees(&modes, choices, within, &response)
            {
                match &found {
                    None => found = Some((modes, response)),
                    Some((first, other)) if self.differ(other, &response) => {
                        if !self.held_by_rest(first, &modes) {
                            let motions = vec![*first, modes];
                            return Err(Unsolved { tried, motions });
                        }
                    }
                    Some(_) => {}
                }
            }
            // The next set: the last contact counts fastest.
            let Some(next) = (0..C).rev().find(|&i| at[i] + 1 < choices[i].count) else {
                let motions = Vec::new();
                return found.ok_or(Unsolved { tried, motions });
            };
            at[next] += 1;
            at[next + 1..].fill(0);
        }
    }

    fn differ(&self, a: &Response<N, C>, b: &Response<N, C>) -> bool {
        let size = (0..N).map(|j| self.rate_size(a, j).max(self.rate_size(b, j)));
        let apart = (0..N).map(|j| (a.rate[j] - b.rate[j]).abs());
        // Other modes, other pivots: the round-off of both.
        !size.zip(apart).all(|(size, apart)| apart <= 1e3 * ZERO * size)
    }

    /// Surfaces at rest hold with the larger friction though they could also slip with the
    /// smaller: rest goes on.
    fn held_by_rest(&self, first: &Modes<C>, other: &Modes<C>) -> bool {
        (0..C).any(|i| {
            let friction = self.contacts[i].friction;
            let rests = first[i] == Mode::Stick && matches!(other[i], Mode::Slip(_));
            !self.impact && friction.holding > friction.kinetic && rests
        })
    }
}

/// The modes that come into question for one contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Choices {
    modes: [Mode; 4],
    count: usize,
    /// The gap is shut: only its rate tells whether it opens.
    shut: bool,
    /// An event says what it does, and its rate there may be off by [`DECIDED`].
    decided: bool,
    /// The slip speed is 0: only its rate tells whether it slips, and which way.
    slip_begins: bool,
}

impl Choices {
    /// This mode and no other, whatever its rates.
    pub(super) const fn only(mode: Mode) -> Self {
        Self { modes: [mode; 4], count: 1, shut: false, decided: false, slip_begins: false }
    }

    /// These modes of a shut contact, in this order; where the slip begins its sense is to be found.
    pub(super) fn of(modes: &[Mode], slip_begins: bool) -> Self {
        let mut choices = Self {
            modes: [Mode::Open; 4],
            count: modes.len(),
            shut: true,
            decided: false,
            slip_begins,
        };
        choices.modes[..modes.len()].copy_from_slice(modes);
        choices
    }

    /// Everything that a shut contact with this friction can do.
    pub(super) fn shut(friction: bool, may_open: bool) -> Self {
        let all = if friction {
            [Mode::Stick, Mode::Slip(Sense::Forward), Mode::Slip(Sense::Backward), Mode::Open]
        } else {
            [Mode::Smooth, Mode::Open, Mode::Open, Mode::Open]
        };
        let closed = if friction { 3 } else { 1 };
        Self::of(&all[..closed + usize::from(may_open)], friction)
    }

    /// The same where an event has decided: the rest of the rates there is the error of the run,
    /// which was put back onto its contacts since.
    pub(super) fn decided(self) -> Self {
        Self { decided: true, ..self }
    }

    /// The same without the modes that `keep` refuses.
    pub(super) fn retain(self, keep: impl Fn(Mode) -> bool) -> Self {
        let mut kept = Self { count: 0, ..self };
        for mode in self.modes[..self.count].iter().filter(|m| keep(**m)) {
            kept.modes[kept.count] = *mode;
            kept.count += 1;
        }
        kept
    }
}

/// No set of modes agrees with its response, or several do.
#[derive(Debug)]
pub(super) struct Unsolved<const C: usize> {
    pub tried: usize,
    /// None, or two.
    pub motions: Vec<Modes<C>>,
}
