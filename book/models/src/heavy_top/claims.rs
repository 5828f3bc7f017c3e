//! What can be said of a motion in numbers, each by the closed form and by a second route.

use super::Motion;
use super::routes::{Newton, Nod, greatest_tilt};
use kit::Result;
use kit::{Claim, claim};
use rotation_dynamics::Error;
use rotation_dynamics::exact::heavy_top::Regime;
use rotation_dynamics::integrators::{Dop853, Event, Integrator, Ode};
use rotation_dynamics::math::{EPS, atan2, cos, hypot, sin};

const ROOT: &str = "bisection of E~ - U_eff";
const SUM: &str = "quadrature over one nod";
const RUN: &str = "DOP853 on (4), (5), (6)";
const HIGHEST: &str = "DOP853 on dL/dt = torque, where it is highest";

impl Motion {
    /// What its regime allows to say. `equations` are the notes' (4) to (6), the second
    /// route to the state at the end.
    ///
    /// # Errors
    /// Those of the second routes.
    pub fn claims(&self, equations: &impl Ode<4>) -> Result<Vec<Claim>> {
        match self.exact.regime() {
            _ if !self.clear_of_poles() => self.tilt(),
            Regime::Steady => self.steady(equations),
            _ => {
                let mut claims = self.nod();
                claims.extend(self.azimuth(equations)?);
                Ok(claims)
            }
        }
    }

    fn claim(&self, what: &str, meaning: &str, value: f64, unit: &str) -> Claim {
        let meaning =
            if self.name.is_empty() { meaning.into() } else { format!("{}: {meaning}", self.name) };
        claim(self.key(what), meaning, value, unit)
    }

    /// The same, offered in the answer box.
    fn answer(&self, what: &str, meaning: &str, value: f64, unit: &str) -> Claim {
        let claim = self.claim(what, meaning, value, unit);
        if self.group.is_empty() { claim } else { claim.answer(self.group) }
    }

    /// Turning points, period and advances, against bisection and quadrature.
    fn nod(&self) -> Vec<Claim> {
        let exact = &self.exact;
        let nod = Nod::by_quadrature(&self.top, self.energy);
        // With a spin below 0 the time t' runs backwards.
        let (unit, sense) = (self.unit.abs(), self.unit.signum());
        let (period, precession) = (nod.period * unit, sense * nod.precession);
        let time = if self.in_seconds() { "s" } else { "-" };
        let near = 100.0 * EPS * (nod.theta_max - nod.theta_min).recip();
        let refined = 4.0 * nod.refinement + near * nod.leverage + 20.0 * EPS * nod.condition;
        let bound = |value: f64, within: f64| within + 200.0 * EPS * value.abs().max(1.0);
        let (least, most) = (exact.theta_min(), exact.theta_max());
        let (time_of_nod, walk, spin) =
            (exact.nutation_period(), exact.precession_per_period(), exact.spin_per_period());
        let mut claims = vec![
            (self.answer("theta_min", "least tilt", least, "rad"))
                .within(bound(least, near))
                .against(ROOT, nod.theta_min),
            (self.answer("theta_max", "greatest tilt", most, "rad"))
                .within(bound(most, near))
                .against(ROOT, nod.theta_max),
            (self.answer("period", "time of one nod", time_of_nod, time))
                .within(bound(time_of_nod, refined * unit))
                .against(SUM, period),
            (self.answer("precession", "advance of phi in one nod", walk, "rad"))
                .within(bound(walk, refined))
                .against(SUM, precession),
            (self.claim("spin", "advance of zeta in one nod", spin, "rad"))
                .within(bound(spin, refined))
                .against(SUM, sense * nod.spin),
        ];
        if self.in_seconds() {
            let rate = walk / time_of_nod;
            let meaning = "mean rate of precession";
            claims.push(
                (self.answer("precession_rate", meaning, rate, "rad/s"))
                    .within(bound(rate, refined / period))
                    .against(SUM, precession / period),
            );
        }
        claims
    }

    /// The state at the end by the notes' equations, and how far a run with a tolerance
    /// 100 times coarser ends from it; `None` after millions of turns, which no run in
    /// steps can confirm.
    fn carried(&self, equations: &impl Ode<4>) -> Result<Option<([f64; 4], f64)>> {
        let (start, end) = (self.start(), self.end_reduced());
        let run = |tolerance| Dop853::new(tolerance)?.advance(equations, 0.0, &start, end);
        let (fine, coarse) = match (run(1e-14), run(1e-12)) {
            (Err(Error::LimitReached { .. }), _) => return Ok(None),
            (fine, coarse) => (fine?.0, coarse?.0),
        };
        let apart = (0..4).map(|i| (fine[i] - coarse[i]).abs());
        Ok(Some((fine, apart.fold(0.0, f64::max))))
    }

    /// phi at the end, against the notes' equations.
    fn azimuth(&self, equations: &impl Ode<4>) -> Result<Option<Claim>> {
        let Some((state, apart)) = self.carried(equations)? else {
            return Ok(None);
        };
        let value = self.exact.angles(self.end).phi;
        let (what, meaning) = if self.in_seconds() {
            ("phi_1s", "phi after 1 s")
        } else {
            ("phi_20", "phi at t' = 20")
        };
        // (5) loses the digits that b and cos(theta) share; a rounding of b is never seen.
        let closest = sin(self.exact.theta_min()).min(sin(self.exact.theta_max()));
        let rounded = EPS * self.rate_per_tilt(closest) * self.end_reduced().abs();
        let bound = 4.0 * apart + 1e-13 * value.abs().max(1.0) + rounded;
        let claim = self.claim(what, meaning, value, "rad").within(bound);
        Ok(Some(claim.against(RUN, state[2])))
    }

    /// By how much more phi' an error of the tilt or of b makes in (5), at the sine `s`.
    fn rate_per_tilt(&self, s: f64) -> f64 {
        self.top.a().sqrt() * (1.0 + self.top.b().abs()) / (s * s)
    }

    /// Constant tilt: where, the two constant rates, and the energy.
    fn steady(&self, equations: &impl Ode<4>) -> Result<Vec<Claim>> {
        let (a, b, c) = (self.top.a(), self.top.b(), self.top.c());
        let (exact, unit) = (&self.exact, self.unit);
        // "Steady" may nod a little, up to 1e-7 rad; its means are steady to second order.
        let nods = exact.theta_max() - exact.theta_min();
        let theta = exact.theta_min() + 0.5 * nods;
        let (s, u) = (sin(theta), cos(theta));
        let second = nods * nods * (1.0 + a) * (1.0 + b * b) / (s * s * s * s);
        let period = exact.nutation_period();
        let mean = |advance: f64, rate: f64| {
            let moves = nods > 0.0 && period.is_finite();
            unit * if moves { advance / period } else { rate }
        };
        // cos(theta) p^2 - sqrt(a) p + c = 0 has a slow and a fast root; phi' is one of them.
        let rate = mean(exact.precession_per_period(), exact.phi_rate(0.0));
        let root = (a - 4.0 * c * u).max(0.0).sqrt();
        let (slow, fast) = (2.0 * c / (a.sqrt() + root), (a.sqrt() + root) / (2.0 * u));
        let is_fast = (rate - fast).abs() < (rate - slow).abs();
        let nearer = if is_fast { fast } else { slow };
        let sharp = 64.0 * EPS * (1.0 + b.abs()) / (s * s) * nearer.abs().max(1.0) + second;
        // The kinetic energy of the precession, and the height lost.
        let half = sin(0.5 * theta);
        let energy = 0.5 * nearer * nearer * s * s - 2.0 * c * half * half;
        let spin = mean(exact.spin_per_period(), exact.zeta_rate(0.0));
        let mut claims = vec![
            (self.answer("precession", "dphi/dt'", rate, "-"))
                .within(sharp)
                .against("root of the quadratic for p", nearer),
            (self.answer("energy", "E~, the minimum of U_eff", self.energy, "-"))
                .within(sharp)
                .against("(p sin(theta))^2/2 and height", energy),
        ];
        if let Some((state, apart)) = self.carried(equations)? {
            let bound = 4.0 * apart + 1e-13 + nods;
            let tilt = self.answer("theta", "the constant tilt", theta, "rad");
            claims.insert(0, tilt.within(bound).against(RUN, state[0]));
            let (blurred, end) = (nods * self.rate_per_tilt(s), self.end_reduced());
            let turns = self.answer("spin", "dzeta/dt'", spin, "-");
            claims.push(turns.within(bound + blurred).against(RUN, state[3] / end));
        }
        Ok(claims)
    }

    /// Near a pole: the greatest tilt, and the tilt at the end against a run in vectors,
    /// which knows no poles.
    fn tilt(&self) -> Result<Vec<Claim>> {
        let (top, mut claims) = (&self.top, Vec::new());
        let greatest = self.exact.theta_max();
        // Rounding of E~, b and c over the torque, neighbouring numbers, and, of a body,
        // the rounding of b: dtheta = db/sin(theta) where E~ is at the minimum.
        let (s, u) = (sin(greatest), cos(greatest));
        let barrier = top.a() * top.b() * (top.b() - u) / (s * s);
        let terms = self.energy.abs() + 2.0 * top.c().abs() + barrier.abs();
        let of_b = if self.in_seconds() { 8.0 / s } else { 0.0 };
        let bound = EPS * (64.0 * terms / top.torque(greatest).abs() + 32.0 * greatest + of_b);
        // A top that sleeps has no turning point to speak of.
        if bound < 1e-6 {
            claims.push(
                (self.answer("theta_max", "greatest tilt", greatest, "rad"))
                    .within(bound)
                    .against(ROOT, greatest_tilt(top, self.energy)),
            );
        }
        claims.extend(self.nod_in_vectors()?);
        let (newton, start) = (self.newton(), self.start_in_vectors());
        let end = self.end_reduced();
        let run = |tolerance| Dop853::new(tolerance)?.advance(&newton, 0.0, &start, end);
        let (fine, coarse) = match (run(1e-14), run(1e-12)) {
            // Millions of turns: no run in steps can confirm their end.
            (Err(Error::LimitReached { .. }), _) => return Ok(claims),
            (fine, coarse) => (fine?.0, coarse?.0),
        };
        // Each passage near the separatrix divides an error of the energy by 1 - m, the
        // distance from it.
        let passages = 1.0 + self.end / self.exact.nutation_period();
        let apart = self.exact.complementary_parameter();
        let lost = if passages.is_finite() && apart > 0.0 { 1e-13 * passages / apart } else { 0.0 };
        let bound = 4.0 * (fine[5] - coarse[5]).abs() + 1e-10 + lost;
        if bound <= 1e-3 {
            let height = self.exact.cos_theta(self.end);
            claims.push(
                (self.claim("height_end", "cos(theta) at the end", height, "-"))
                    .within(bound)
                    .against("DOP853 on dL/dt = torque", fine[5]),
            );
        }
        Ok(claims)
    }

    /// Near a pole: least tilt and time of one nod, against the places where a run in vectors
    /// is highest. Nothing where no run comes round twice: a top that sleeps, or one that takes
    /// for ever to the vertical.
    fn nod_in_vectors(&self) -> Result<Vec<Claim>> {
        let (least, period) = (self.exact.theta_min(), self.exact.nutation_period());
        let (newton, start) = (self.newton(), self.start_in_vectors());
        let end = 2.5 * period / self.unit.abs();
        let far = 50.0 * self.end_reduced().abs();
        if !(0.0..=far).contains(&end) || self.exact.complementary_parameter() < 1e-6 {
            return Ok(Vec::new());
        }
        let highest = |tolerance| -> rotation_dynamics::Result<Option<[f64; 2]>> {
            // The rate of the height, times I1.
            let rate = |_: f64, &[lx, ly, _, ex, ey, _]: &[f64; 6]| lx * ey - ly * ex;
            let turns = Event::falling("highest", rate);
            let run = Dop853::new(tolerance)?.solve(&newton, 0.0, &start, end, &[turns])?;
            Ok(match run.events() {
                [first, second, ..] => {
                    let [.., ex, ey, ez] = first.state;
                    Some([atan2(hypot(ex, ey), ez), second.t - first.t])
                }
                _ => None,
            })
        };
        let (fine, coarse) = match (highest(1e-14), highest(1e-12)) {
            (Err(Error::LimitReached { .. }), _) => return Ok(Vec::new()),
            (fine, coarse) => (fine?, coarse?),
        };
        let (Some(fine), Some(coarse)) = (fine, coarse) else {
            return Ok(Vec::new());
        };
        let bound = |i: usize| 100.0 * (fine[i] - coarse[i]).abs() + 1e-11 * fine[i].max(1.0);
        let time = if self.in_seconds() { "s" } else { "-" };
        let claims = vec![
            (self.answer("theta_min", "least tilt", least, "rad"))
                .within(bound(0))
                .against(HIGHEST, fine[0]),
            (self.answer("period", "time of one nod", period, time))
                .within(bound(1) * self.unit.abs())
                .against(HIGHEST, fine[1] * self.unit.abs()),
        ];
        // What the run itself hardly knows confirms nothing.
        let known = bound(0) < 1e-6 && bound(1) < 1e-6 * fine[1];
        Ok(if known { claims } else { Vec::new() })
    }

    /// The same top for a run in vectors, in t' and with I1 = 1 and L_z = sqrt(a).
    fn newton(&self) -> Newton {
        Newton { i1: 1.0, weight_moment: self.top.c() }
    }

    /// L and the axis at the start, in the same units: the closed form's own, since tilt
    /// and rates would lose digits next to a pole.
    fn start_in_vectors(&self) -> [f64; 6] {
        let axis = self.exact.axis(0.0).to_array();
        let momentum = self.exact.angular_momentum(0.0).to_array();
        let unit = self.top.a().sqrt() / self.exact.momenta().1;
        core::array::from_fn(|k| match k {
            0..3 => momentum[k] * unit,
            _ => axis[k - 3],
        })
    }
}
