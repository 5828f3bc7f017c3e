//! A motion with its exact solution, and what can be said about it in numbers.

use super::Equations;
use super::routes::{Nod, Vectors, greatest_tilt};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Regime, Start};
use rotation_dynamics::integrators::{Dop853, Integrator};
use rotation_dynamics::math::{EPS, cos, sin};
use rotation_dynamics::report::{Claim, Oracle, Report, Trajectory};
use rotation_dynamics::{Error, Result};

/// One motion of one gyroscope.
pub struct Motion {
    /// Prefix of its keys and figures; empty for a motion asked for by flags.
    pub name: &'static str,
    pub exact: HeavyTop,
    pub top: ReducedTop,
    pub energy: f64,
    /// Length of the unit of time t' in the motion's own unit: 1, or in seconds; below
    /// 0 with L_z.
    pub unit: f64,
    /// How far it is followed, in its own unit of time.
    pub end: f64,
}

impl Motion {
    fn new(name: &'static str, exact: HeavyTop) -> Result<Self> {
        let (Some(top), Some(energy), Some(unit)) =
            (exact.reduced(), exact.energy_reduced(), exact.time_unit())
        else {
            return Err(Error::OutOfRange {
                name: "L_z",
                value: exact.momenta().1,
                allowed: "the axis must spin: the notes' unit of time is sqrt(I1 I3)/L_z",
            });
        };
        let end = if exact.body().is_some() { 1.0 } else { 20.0 };
        Ok(Self {
            name,
            exact,
            top,
            energy,
            unit,
            end,
        })
    }

    /// The motion of this energy that starts at a turning point.
    pub fn with_energy(
        name: &'static str,
        top: ReducedTop,
        energy: f64,
        start: Start,
    ) -> Result<Self> {
        Self::new(name, HeavyTop::from_energy(top, energy, start, 0.0, 0.0)?)
    }

    /// The motion that starts at this tilt, at rest in theta.
    pub fn at_rest_in_theta(name: &'static str, top: ReducedTop, theta: f64) -> Result<Self> {
        Self::new(name, HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)?)
    }

    /// The motion of the notes' dimensionless gyroscope that the flags ask for.
    pub fn reduced(a: f64, b: f64, c: f64, energy: f64, start: &str) -> Result<Self> {
        let start = if start == "theta_max" {
            Start::ThetaMax
        } else {
            Start::ThetaMin
        };
        Self::with_energy("", ReducedTop::new(a, b, c)?, energy, start)
    }

    /// A motion of a body, in SI units.
    pub fn of_body(name: &'static str, exact: HeavyTop) -> Result<Self> {
        Self::new(name, exact)
    }

    pub fn in_seconds(&self) -> bool {
        self.exact.body().is_some()
    }

    /// The regime in a word, and the numbers that fix the motion.
    pub fn description(&self) -> String {
        format!(
            "a symmetric rotor about a fixed point: {}; a = {:.6}, b = {:.6}, c = {:.6}, E~ = {:.6}",
            self.regime(),
            self.top.a(),
            self.top.b(),
            self.top.c(),
            self.energy
        )
    }

    pub fn regime(&self) -> &'static str {
        match self.exact.regime() {
            Regime::Steady => "steady precession",
            Regime::Waves => "precession with waves",
            Regime::Cusps => "precession with cusps",
            Regime::Loops => "precession with loops",
            Regime::Sleeping => "sleeping upright",
            Regime::Homoclinic => "leaving the vertical and returning to it in infinite time",
            Regime::Planar => "a swing in a plane",
            _ => "through the vertical",
        }
    }

    /// The state of equations (4) to (6) at the start.
    pub fn start(&self) -> [f64; 4] {
        let angles = self.exact.angles(0.0);
        let nutation = self.exact.theta_rate(0.0) * self.unit;
        [angles.theta, nutation, angles.phi, angles.zeta]
    }

    /// L and the axis at the start, for I1 = 1 and L_z = sqrt(a): the closed form's own,
    /// since tilt and rates would lose digits next to a pole.
    fn start_in_vectors(&self) -> [f64; 6] {
        let axis = self.exact.axis(0.0).to_array();
        let momentum = self.exact.angular_momentum(0.0).to_array();
        let unit = self.top.a().sqrt() / self.exact.momenta().1;
        core::array::from_fn(|k| match k {
            0..3 => momentum[k] * unit,
            _ => axis[k - 3],
        })
    }

    fn key(&self, what: &str) -> String {
        if self.name.is_empty() {
            what.into()
        } else {
            format!("{}_{what}", self.name)
        }
    }

    fn time_unit(&self) -> &'static str {
        if self.in_seconds() { "s" } else { "-" }
    }

    /// Whether phi and zeta are of use: far enough from both poles for equations (5)
    /// and (6), which divide by sin^2(theta).
    pub fn clear_of_poles(&self) -> bool {
        let regular = matches!(
            self.exact.regime(),
            Regime::Steady | Regime::Waves | Regime::Cusps | Regime::Loops
        );
        regular && sin(self.exact.theta_min()).min(sin(self.exact.theta_max())) > 0.02
    }

    /// What a number is, with the motion it belongs to.
    fn named(&self, meaning: &str) -> String {
        if self.name.is_empty() {
            meaning.into()
        } else {
            format!("{}: {meaning}", self.name)
        }
    }

    /// Adds what the regime allows to say.
    pub fn add_claims(&self, report: &mut Report) -> Result<()> {
        if !self.clear_of_poles() {
            return self.add_tilt(report);
        }
        if self.exact.regime() == Regime::Steady {
            return self.add_steady(report);
        }
        self.add_nod(report)?;
        self.add_end(report)
    }

    /// Turning points, period and advances, against bisection and quadrature.
    fn add_nod(&self, report: &mut Report) -> Result<()> {
        let exact = &self.exact;
        let nod = Nod::by_quadrature(&self.top, self.energy)?;
        // With a spin below 0 the time t' runs backwards.
        let (unit, sense) = (self.unit.abs(), self.unit.signum());
        let (precession, spin) = (sense * nod.precession, sense * nod.spin);
        let time = self.time_unit();
        let mut add = |what: &str,
                       meaning: &str,
                       value: f64,
                       unit: &str,
                       other: f64,
                       rule: &str,
                       within: f64| {
            let bound = within + 200.0 * EPS * value.abs().max(1.0);
            report.add_claim(Claim::new(
                self.key(what),
                self.named(meaning),
                value,
                unit,
                bound,
                Oracle::new(rule, other),
            )?)
        };
        let near = 100.0 * EPS * (nod.theta_max - nod.theta_min).recip();
        let (root, sum) = ("bisection of E~ - U_eff", "quadrature over one nod");
        let refined = 4.0 * nod.refinement + near * nod.leverage + 20.0 * EPS * nod.condition;
        add(
            "theta_min",
            "least tilt",
            exact.theta_min(),
            "rad",
            nod.theta_min,
            root,
            near,
        )?;
        add(
            "theta_max",
            "greatest tilt",
            exact.theta_max(),
            "rad",
            nod.theta_max,
            root,
            near,
        )?;
        let period = nod.period * unit;
        add(
            "period",
            "time of one nod",
            exact.nutation_period(),
            time,
            period,
            sum,
            refined * unit,
        )?;
        add(
            "precession",
            "advance of phi in one nod",
            exact.precession_per_period(),
            "rad",
            precession,
            sum,
            refined,
        )?;
        add(
            "spin",
            "advance of zeta in one nod",
            exact.spin_per_period(),
            "rad",
            spin,
            sum,
            refined,
        )?;
        if self.in_seconds() {
            let (value, other) = (
                exact.precession_per_period() / exact.nutation_period(),
                precession / period,
            );
            add(
                "precession_rate",
                "mean rate of precession",
                value,
                "rad/s",
                other,
                sum,
                refined / period,
            )?;
        }
        Ok(())
    }

    /// The azimuth at the end of the run, against the notes' equations.
    fn add_end(&self, report: &mut Report) -> Result<()> {
        let end = self.end / self.unit;
        let (state, apart) = Equations::of(&self.top).carried(&self.start(), end)?;
        let value = self.exact.angles(self.end).phi;
        let (what, meaning) = if self.in_seconds() {
            ("phi_1s", "phi after 1 s")
        } else {
            ("phi_20", "phi at t' = 20")
        };
        let bound = 4.0 * apart + 1e-13 * value.abs().max(1.0);
        let oracle = Oracle::new("DOP853 on (4), (5), (6)", state[2]);
        report.add_claim(Claim::new(
            self.key(what),
            self.named(meaning),
            value,
            "rad",
            bound,
            oracle,
        )?)
    }

    /// Constant tilt: where, and the two constant rates.
    fn add_steady(&self, report: &mut Report) -> Result<()> {
        let (a, b, c) = (self.top.a(), self.top.b(), self.top.c());
        let end = self.end / self.unit;
        let (state, apart) = Equations::of(&self.top).carried(&self.start(), end)?;
        let theta = self.exact.theta_min();
        let bound = 4.0 * apart + 1e-13;
        let run = "DOP853 on (4), (5), (6)";
        report.add_claim(Claim::new(
            self.key("theta"),
            self.named("the constant tilt"),
            theta,
            "rad",
            bound,
            Oracle::new(run, state[0]),
        )?)?;
        // cos(theta) p^2 - sqrt(a) p + c = 0 has a slow and a fast root; phi' is one of them.
        let rate = self.exact.phi_rate(0.0) * self.unit;
        let root = (a - 4.0 * c * cos(theta)).max(0.0).sqrt();
        let fast = (a.sqrt() + root) / (2.0 * cos(theta));
        let slow = 2.0 * c / (a.sqrt() + root);
        let nearer = if (rate - fast).abs() < (rate - slow).abs() {
            fast
        } else {
            slow
        };
        let quadratic = "root of the quadratic for p";
        let sharp =
            64.0 * EPS * (1.0 + b.abs()) / (sin(theta) * sin(theta)) * nearer.abs().max(1.0);
        report.add_claim(Claim::new(
            self.key("precession"),
            self.named("dphi/dt'"),
            rate,
            "-",
            sharp,
            Oracle::new(quadratic, nearer),
        )?)?;
        // The kinetic energy of the precession, and the height lost.
        let (s, half) = (sin(theta), sin(0.5 * theta));
        let energy = 0.5 * nearer * nearer * s * s - 2.0 * c * half * half;
        report.add_claim(Claim::new(
            self.key("energy"),
            self.named("E~, the minimum of U_eff"),
            self.energy,
            "-",
            sharp,
            Oracle::new("(p sin(theta))^2/2 and height", energy),
        )?)?;
        let spin = self.exact.zeta_rate(0.0) * self.unit;
        report.add_claim(Claim::new(
            self.key("spin"),
            self.named("dzeta/dt'"),
            spin,
            "-",
            bound,
            Oracle::new(run, state[3] / end),
        )?)
    }

    /// The tilt at the end, against a run in vectors, which knows no poles.
    fn add_tilt(&self, report: &mut Report) -> Result<()> {
        let top = &self.top;
        let (greatest, bisected) = (self.exact.theta_max(), greatest_tilt(top, self.energy));
        // Rounding of E~, b and c over the torque, neighbouring numbers, and, of a body,
        // the rounding of b: dtheta = db/sin(theta) where E~ is at the minimum.
        let (s, u) = (sin(greatest), cos(greatest));
        let barrier = top.a() * top.b() * (top.b() - u) / (s * s);
        let terms = self.energy.abs() + 2.0 * top.c().abs() + barrier.abs();
        let of_b = if self.in_seconds() { 8.0 / s } else { 0.0 };
        let bound = EPS * (64.0 * terms / top.torque(greatest).abs() + 32.0 * greatest + of_b);
        // A top that sleeps has no turning point to speak of.
        if bound < 1e-6 {
            report.add_claim(Claim::new(
                self.key("theta_max"),
                self.named("greatest tilt"),
                greatest,
                "rad",
                bound,
                Oracle::new("bisection of E~ - U_eff", bisected),
            )?)?;
        }
        let end = self.end / self.unit;
        let vectors = Vectors {
            i1: 1.0,
            weight_moment: self.top.c(),
        };
        let start = self.start_in_vectors();
        let run = |tolerance| Dop853::new(tolerance)?.advance(&vectors, 0.0, &start, end);
        let (fine, coarse) = match (run(1e-14), run(1e-12)) {
            // Millions of turns: no run in steps can confirm their end.
            (Err(Error::TooManySteps { .. }), _) => return Ok(()),
            (fine, coarse) => (fine?.0, coarse?.0),
        };
        let value = self.exact.cos_theta(self.end);
        // Each passage near the separatrix divides an error of the energy by 1 - m, the
        // distance from it.
        let passages = 1.0 + self.end / self.exact.nutation_period();
        let apart = self.exact.complementary_parameter();
        let lost = if passages.is_finite() && apart > 0.0 {
            1e-13 * passages / apart
        } else {
            0.0
        };
        let bound = 4.0 * (fine[5] - coarse[5]).abs() + 1e-10 + lost;
        if bound > 1e-3 {
            return Ok(());
        }
        report.add_claim(Claim::new(
            self.key("height_end"),
            self.named("cos(theta) at the end"),
            value,
            "-",
            bound,
            Oracle::new("DOP853 on dL/dt = torque", fine[5]),
        )?)
    }
}

/// The motions in closed form: 200 samples over the run of each.
pub fn trajectory(motions: &[Motion]) -> Result<Trajectory> {
    let time = if motions.iter().any(Motion::in_seconds) {
        "t [s]"
    } else {
        "t'"
    };
    let mut table = Trajectory::new([
        "motion",
        time,
        "theta [rad]",
        "phi [rad]",
        "zeta [rad]",
        "axis X",
        "axis Y",
        "axis Z",
    ])?;
    for (number, motion) in (1_u32..).zip(motions) {
        for k in 0..=200 {
            let t = motion.end * f64::from(k) / 200.0;
            let angles = motion.exact.angles(t);
            let [x, y, z] = motion.exact.axis(t).to_array();
            table.push([
                f64::from(number),
                t,
                angles.theta,
                angles.phi,
                angles.zeta,
                x,
                y,
                z,
            ])?;
        }
    }
    Ok(table)
}
