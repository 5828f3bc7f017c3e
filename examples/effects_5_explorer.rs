//! Flips with and without a loss inside: Explorer 1, and the body that ends about its largest
//! axis.

#[path = "effects_5_explorer/figures.rs"]
mod figures;
#[path = "effects_5_explorer/opening.rs"]
mod opening;

pub use opening::Opening;

use core::f64::consts::{FRAC_PI_2, TAU};
use kit::prelude::*;
use kit::supported_digits;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::exact::free_body::FreeFlow;
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{PrincipalMoments, solids};
use rotation_dynamics::integrators::{
    Dop853, Event, Integrator, LocatedEvent, Ode, Scheme, Separable, Solution, Splitting, Work,
    after, ode, size_or,
};

parameters! {
    /// Explorer 1 as a uniform cylinder; and a body with three different moments, in units in
    /// which its angular momentum and its middle moment are 1.
    pub struct Parameters {
        /// mass of the satellite
        mass: number(13.97, "kg", above(0.0).usually(5.0, 50.0));
        /// its length
        length: number(2.03, "m", above(0.0).usually(0.1, 5.0)).open("length of the satellite", "a disc", "a rod");
        /// its diameter
        diameter: number(0.159, "m", above(0.0).usually(0.1, 2.0));
        /// its spin at the start
        spin: number(78.5, "rad/s", any().usually(1.0, 100.0));
        /// nutation angle, from L to the axis, at the start
        nutation: number(0.02, "rad", between(0.0, FRAC_PI_2).because("along the axis it stays; at a right angle there is no axis left").usually(0.005, 1.0)).open("angle from L to the axis at the start", "along L", "far off");
        /// time in which the tangent of that angle grows (or falls) by the factor e
        growth: number(1500.0, "s", from_to(1.0, 1e10).because("the law is that of a weak loss; without one nothing grows").usually(500.0, 5000.0));
        /// least moment of the other body over its middle one
        least: number(0.45, "-", between(0.0, 1.0).because("it is the least of three moments").usually(0.2, 0.9));
        /// its largest moment over the middle one
        largest: number(1.42, "-", between(1.0, 2.0).because("it is the largest of three, and less than the sum of the others").usually(1.1, 1.9));
        /// its loss: a times the length of L
        loss: number(0.01, "-", from_to(2e-3, 0.05).because("a weaker loss takes too long to simulate, a stronger one is not weak").usually(0.003, 0.05));
        /// angle of L from the middle axis at the start, towards the least one
        aside: number(0.5, "rad", from_to(0.05, 1.4).because("along an axis it stays").usually(0.1, 1.2));
        /// error asked of the satellite's attitude
        tolerance: number(1e-9, "rad", from_to(1e-11, 0.1));
    }
}

// ANCHOR: lossy
/// A body that loses energy inside at constant L: the direction of L on its axes.
#[derive(Debug, Clone, Copy)]
pub struct Lossy {
    /// 1/I, from the least moment to the largest.
    pub inverse: [f64; 3],
    /// a |L|.
    pub loss: f64,
    /// The motion without a loss.
    pub free: FreeFlow,
}

impl Lossy {
    /// n' = n x w + a|L| n x (n x w), with w = n/I; written out such that |n| is kept, too,
    /// where rounding has changed it.
    pub fn equations(self) -> impl Ode<3> {
        ode(move |_, n: &[f64; 3]| {
            let w = [0, 1, 2].map(|i| n[i] * self.inverse[i]);
            let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let (along, square) = (dot(n, &w), dot(n, n));
            [0, 1, 2].map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                n[j] * w[k] - n[k] * w[j] + self.loss * (n[i] * along - w[i] * square)
            })
        })
        .scaled(size_or([1.0; 3]))
    }
}

/// The free motion and the loss in turn, both exact.
impl Separable for Lossy {
    type State = [f64; 3];
    type Point = [f64; 3];

    fn flow(&self, n: &mut [f64; 3], dt: f64) {
        let turn = self.free.turn(BodyVector::from_array(*n), dt);
        *n = turn.to_body(SpaceVector::from_array(*n)).to_array();
    }

    /// The loss alone lets each component decay at its own rate, a|L|/I, at constant length.
    fn kick(&self, n: &mut [f64; 3], dt: f64) {
        *n = unit([0, 1, 2].map(|i| n[i] * exp(-self.loss * dt * self.inverse[i])));
    }
    // ANCHOR_END: lossy

    fn enter(&self, start: &[f64; 3]) -> rotation_dynamics::Result<[f64; 3]> {
        Ok(*start)
    }
    fn leave(&self, end: &[f64; 3], _elapsed: f64) -> rotation_dynamics::Result<[f64; 3]> {
        Ok(*end)
    }
    fn settle(&self, n: &mut [f64; 3]) {
        *n = unit(*n);
    }
}

fn unit(n: [f64; 3]) -> [f64; 3] {
    let length = hypot(hypot(n[0], n[1]), n[2]);
    n.map(|c| c / length)
}

/// The angle between two directions.
pub fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    let difference = hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
    2.0 * asin((0.5 * difference).min(1.0))
}

/// L this far from the middle axis, towards the least one.
pub fn start(aside: f64) -> [f64; 3] {
    let (s, c) = sincos(aside);
    [s, c, 0.0]
}

impl Lossy {
    /// A body with these moments over the middle one.
    pub fn new(least: f64, largest: f64, loss: f64) -> Result<Self> {
        let moments = PrincipalMoments::new(least, 1.0, largest)?;
        let inverse = [1.0 / least, 1.0, 1.0 / largest];
        Ok(Self { inverse, loss, free: FreeFlow::new(moments) })
    }

    /// 1/I1 - 1/I2 and 1/I2 - 1/I3.
    pub fn gaps(&self) -> [f64; 2] {
        let [one, two, three] = self.inverse;
        [one - two, two - three]
    }

    /// The angular velocity with L in this direction.
    pub fn rates(&self, n: [f64; 3]) -> BodyVector {
        BodyVector::from_array([0, 1, 2].map(|i| n[i] * self.inverse[i]))
    }

    /// Twice the energy, above that of a turn about the middle axis: 0 on the separatrix.
    pub fn above(&self, n: &[f64; 3]) -> f64 {
        let [one, three] = self.gaps();
        one * n[0] * n[0] - three * n[2] * n[2]
    }

    /// What a flip along the separatrix costs: twice the energy, 4 a|L| sqrt(gap gap).
    pub fn toll(&self) -> f64 {
        let [one, three] = self.gaps();
        4.0 * self.loss * (one * three).sqrt()
    }

    /// From a direction above the separatrix until it has fallen through: the flips on the way, and that.
    pub fn fall(&self, from: [f64; 3], step: f64) -> rotation_dynamics::Result<Solution<3>> {
        let [one, three] = self.gaps();
        let until = 1e3 / (self.loss * one.min(three));
        let flip = Event::crossing("flip", |_, n: &[f64; 3]| n[1]);
        let through = Event::falling("separatrix", |_, n: &[f64; 3]| self.above(n)).terminal();
        Dop853::new(step)?.solve(&self.equations(), 0.0, &from, until, &[flip, through])
    }

    /// About which end of the largest axis it turns in the end: once below the separatrix,
    /// the sign of n3 is kept.
    pub fn side(&self, aside: f64) -> Result<f64> {
        Ok(self.fall(start(aside), 1e-13)?.end_state()[2].signum())
    }

    /// Where `f` is zero for the nth time on the way from n.
    fn met(&self, n: [f64; 3], nth: u32, f: impl Fn(&[f64; 3]) -> f64) -> Result<LocatedEvent<3>> {
        Ok(Dop853::new(1e-15)?.zero(&self.equations(), n, nth, 1e6, f)?.0)
    }

    /// The flip of this number.
    fn flip(&self, aside: f64, count: u32) -> Result<LocatedEvent<3>> {
        self.met(start(aside), count, |n| n[1])
    }

    /// When half of what `aside` lies above the separatrix is lost.
    pub fn half_way(&self, aside: f64) -> Result<f64> {
        let half = 0.5 * self.above(&start(aside));
        Ok(self.met(start(aside), 1, |n| self.above(n) - half)?.t)
    }

    // ANCHOR: edges
    /// The starts that end on the middle axis itself: the way back from there in time.
    pub fn edges(&self, beyond: f64) -> rotation_dynamics::Result<Solution<3>> {
        let [one, three] = self.gaps();
        let (half, product) = (0.5 * self.loss * (one - three), one * three);
        let slow = -half - (half * half + product * (1.0 + self.loss * self.loss)).sqrt();
        let seed = 1e-8;
        let saddle = unit([seed * three, 1.0, -seed * (slow + self.loss * one)]);
        let edge = Event::crossing("edge", |_, n: &[f64; 3]| n[2]);
        let limit = (one * sin(beyond) * sin(beyond) + 5.0 * self.toll()).min(0.9999 * one);
        let enough = Event::rising("enough", move |_, n: &[f64; 3]| self.above(n) - limit);
        let (law, long) = (self.equations(), -1e3 / (self.loss * one.min(three)));
        Dop853::new(1e-15)?.solve(&law, 0.0, &saddle, long, &[edge, enough.terminal()])
    }
    // ANCHOR_END: edges

    /// The angles from the middle axis at which those starts lie.
    pub fn edge_angles(&self, beyond: f64) -> Result<Vec<f64>> {
        let met = self.edges(beyond)?;
        let edges = met.events().iter().filter(|event| event.name == "edge");
        Ok(edges.map(|event| atan2(event.state[0].abs(), event.state[1].abs())).collect())
    }

    /// An edge between two starts that end on different sides, by halving.
    pub fn halved(&self, low: f64, high: f64) -> Result<f64> {
        let (side, within) = (self.side(low)?, 1.5e-11 * (high - low));
        let same = |at: f64| -> Result<bool> { Ok(self.side(at)? == side) };
        let [low, high] = try_bisect([low, high], within, same)?;
        Ok(0.5 * (low + high))
    }

    // ANCHOR: averaged
    /// The mean over a free period of |w|^2 - (n w)^2, at `above`; and half that period.
    pub fn averaged(&self, above: f64) -> Result<[f64; 2]> {
        let [one, three] = self.gaps();
        // The polhode goes round the axis `near`.
        let (near, far) = if above > 0.0 { (one, three) } else { (three, one) };
        let (inside, outside) = (near - above.abs(), far + above.abs());
        let modulus = Modulus::from_m1((near + far) * above.abs() / (near * outside))?;
        let quarter = legendre::k(modulus)?;
        let square = inside / near * legendre::complete_d(modulus)? / quarter;
        Ok([inside * outside - near * far * square, 2.0 * quarter / (near * outside).sqrt()])
    }
    // ANCHOR_END: averaged

    /// The time from `from` down to `to` above the separatrix by the averaged loss, and the
    /// flips on the way.
    pub fn averaged_fall(&self, from: f64, to: f64) -> Result<[f64; 2]> {
        // In s, with above = to + (from - to) s^4, by Simpson's rule.
        let (pieces, mut sums) = (400, [0.0; 2]);
        for i in 1..=pieces {
            let s = f64::from(i) / f64::from(pieces);
            let [mean, half] = self.averaged(to + (from - to) * s * s * s * s)?;
            let weight = if i == pieces { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let slowness = weight * 4.0 * (from - to) * s * s * s / (2.0 * self.loss * mean);
            sums = [sums[0] + slowness, sums[1] + slowness / half];
        }
        Ok(sums.map(|sum| sum / (3.0 * f64::from(pieces))))
    }

    /// How fast a small sway about axis `i` grows: from two turns of it, located.
    pub fn sway(&self, i: usize) -> Result<f64> {
        let mut n = [0.0, 1e-5, 0.0];
        n[i] = 1.0;
        let met = |count| self.met(unit(n), count, |n| n[2 - i]);
        let (first, second) = (met(2)?, met(4)?);
        Ok(log(second.state[1] / first.state[1]) / (second.t - first.t))
    }
}

fn lossy(p: &Parameters) -> Result<Lossy> {
    let body = Lossy::new(p.least, p.largest, p.loss)?;
    let [one, three] = body.gaps();
    allowed! {
        "sqrt(gap gap)/(a |L|)": (one * three).sqrt() / p.loss, from_to(8.0, 1e9),
            "a body that is nearly symmetric flips so slowly that the loss is not weak";
    }?;
    Ok(body)
}

fn satellite(p: &Parameters, report: &mut Report) -> Result<()> {
    let sat = Opening::new(p)?;
    let solid = solids::cylinder(p.mass, 0.5 * p.diameter, p.length)?.about_centre_of_mass();
    let along = |x, z| solid.moment_about(DesignVector::new(x, 0.0, z));
    let (ia, it, thin) = (sat.axial, sat.transverse, sat.thin());
    let (scene, first) = sat.scene()?;
    let rate = scene.effects().1.rate(scene.body(), &first).abs();
    // The law knows t/tau alone: the runs lose as much in a few turns.
    let quick = sat.quickened();
    let late = quick.run(quick.settled(), 1e-9)?;
    let doubled = quick.reaches(tan(p.nutation) * if thin { 2.0 } else { 0.5 })?;
    let (from, ends) = (sat.energy(p.nutation), if thin { it } else { ia });
    let to = 0.5 * sat.momentum * sat.momentum / ends;
    let scale = p.growth / quick.tau();
    let (rpm, sense) = (60.0 / TAU, p.spin.signum());
    claims! { report,
        /// moment of inertia about the axis
        axial: ia, "kg m^2", "library's cylinder" => along(0.0, 1.0)?, within 1e-14 * ia, in "The satellite";
        /// moment of inertia across the axis
        transverse: it, "kg m^2", "library's cylinder" => along(1.0, 0.0)?, within 1e-14 * it, in "The satellite":
            it + 0.25 * p.mass * p.length * p.length => "through the centre, not the end";
        /// rate in the end
        final_rate: sense * sat.momentum / ends * rpm, "1/min", "simulated" => sense * late.rate * rpm,
        within 1e-5 * sat.momentum / ends * rpm, in "The satellite":
            p.spin * rpm => "the momentum is kept, not the rate",
            p.spin * rpm * (ia / it).sqrt() => "that keeps the energy, which is what gets lost";
        /// energy lost, in heat
        heat: from - to, "J", "simulated" => from - late.energy, within 1e-5 * from, in "The satellite";
        /// the part of the energy that is left
        left: to / from, "-", "simulated" => late.energy / from, within 1e-5;
        /// loss in a radian of the spin
        number: sat.loss(), "-", "library's rate" => sat.loss() / (p.growth * rate), within 1e-12 * sat.loss();
        /// time in which the tangent doubles (or halves)
        doubling: p.growth * core::f64::consts::LN_2, "s", "located event" => doubled * scale,
        within 1e-9 * p.growth, in "The satellite";
        /// time to 45 degrees
        time_to_45: p.growth * -log(tan(p.nutation)), "s", "located event" => quick.reaches(1.0)? * scale,
        within 1e-8 * p.growth, if thin && p.nutation < 0.78;
    }
}

fn flips(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, aside) = (lossy(p)?, p.aside);
    let free = Lossy { loss: 0.0, ..body };
    let [one, three] = body.gaps();
    let half = body.averaged(body.above(&start(aside)))?[1];
    let hundred = (free.flip(aside, 101)?.t - free.flip(aside, 1)?.t) / 100.0;
    let fallen = body.fall(start(aside), 1e-14)?;
    let (t, end) = (fallen.end_time(), *fallen.end_state());
    let split = split(&body, aside, t)?;
    let edges = body.edge_angles(aside)?;
    let below = edges.iter().filter(|edge| **edge < aside).count();
    let parity = if below % 2 == 0 { -1.0 } else { 1.0 };
    let near = edges.iter().copied().min_by(|a, b| (a - aside).abs().total_cmp(&(b - aside).abs()));
    let near = near.ok_or(rotation_dynamics::Error::NotReached { name: "edge", until: aside })?;
    let width = edges.windows(2).map(|pair| pair[1] - pair[0]).fold(edges[0], f64::min);
    let found = body.halved(near - 0.3 * width, near + 0.3 * width)?;
    let away = (near - aside).abs();
    let leaves = 0.5 * p.loss * (2.0 * one + three);
    let stays = 0.5 * p.loss * (one + 2.0 * three);
    let upset = 1.0 / away.max(1e-9);
    claims! { report,
        /// time between flips without a loss
        between: half, "I2/L", "a hundred flips, located" => hundred, within 1e-11 * half, in "The flips";
        /// time until the separatrix is crossed
        crossing: t, "I2/L", "splitting, to the same energy" => split.0, within 1e-8 * upset * t;
        /// end of the largest axis: +1 or -1
        side: end[2].signum(), "-", "edges below the start, counted" => parity, within 1e-12, in "The end";
        /// n3 where it crosses
        cross_3: end[2], "-", "splitting" => split.1[2], within 1e-8 * upset;
        /// start nearest to this one where the side changes
        edge: near, "rad", "halving between starts" => found, within 1e-8;
        /// condition: by which part of itself `aside` must change, turned over
        condition: aside / away, "-", "the halved edge" => aside / (found - aside).abs(), within 1e-7 * aside / (away * away);
        /// rate at which a sway about the least axis grows
        leaves: leaves, "L/I2", "two turns of the sway" => body.sway(0)?, within 1e-7 * leaves, in "Stays or leaves":
            -leaves => "which of the three axes has the most energy?";
        /// rate at which one about the largest axis changes
        stays: -stays, "L/I2", "two turns of the sway" => body.sway(2)?, within 1e-7 * stays, in "Stays or leaves":
            stays => "which of the three axes has the least energy?";
    }
}

/// The splitting from `aside` to near the time `t`: when it is on the separatrix, by Newton's
/// method, and where it is at `t`.
fn split(body: &Lossy, aside: f64, t: f64) -> Result<(f64, [f64; 3])> {
    let advance = |n: &[f64; 3], time: f64| -> Result<[f64; 3]> {
        // So many steps while the fastest rate turns by a radian.
        let steps = (4.0 * body.inverse[0] * time.abs()) as u64 + 1;
        Ok(Splitting::new(Scheme::KAHAN_LI17, steps)?.advance(body, 0.0, n, time)?.0)
    };
    let there = advance(&start(aside), t)?;
    let (mut n, mut met, [one, three]) = (there, t, body.gaps());
    for _ in 0..6 {
        let rates = body.equations().derivative(met, &n);
        let slope = 2.0 * (one * n[0] * rates[0] - three * n[2] * rates[2]);
        let step = -body.above(&n) / slope;
        (n, met) = (advance(&n, step)?, met + step);
    }
    Ok((met, there))
}

/// Weak losses, and bodies that are nearly symmetric.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let body = lossy(p)?;
    let weak = Lossy { loss: 1e-8, ..body };
    let [one, three] = weak.gaps();
    let edges = weak.edge_angles(1e-6)?;
    let [first, second] = [0, 1].map(|i| one * sin(edges[i]) * sin(edges[i]));
    let twin = Lossy::new(0.3, 1.0 + 1e-9, 1.0)?;
    let (b, e) = (twin.gaps()[0], 0.4 * twin.gaps()[0]);
    limits! { report,
        /// a flip along the separatrix costs the toll of (5)
        "loss = 1e-8: first edge over its formula": (first / weak.toll()).sqrt() => 1.0, within 1e-4;
        /// and the next one as much again
        "loss = 1e-8: energy from edge to edge over the toll": (second - first) / weak.toll() => 1.0, within 1e-4;
        /// near the least axis the mean loss is that of the linear sway
        "e -> 1/I1: mean loss over (1/I1 - e)":
            weak.averaged(one * (1.0 - 1e-7))?[0] / (one * 1e-7) => one + 0.5 * three, within 1e-6 * (one + three);
        /// a symmetric body needs no average: tan(theta) grows by itself
        "I2 = I3: mean loss over (1/I1 - e)(e - 1/I3)":
            twin.averaged(e)?[0] / ((b - e) * e) => 1.0, within 1e-7;
        /// nothing is lost: the same flips for ever
        "loss = 0: energy after a hundred flips over the first": {
            let free = Lossy { loss: 0.0, ..body };
            free.above(&free.flip(p.aside, 100)?.state) / free.above(&start(p.aside))
        } => 1.0, within 1e-11;
    }
}

/// What the tumbling satellite leaves out, over the time to 45 degrees.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let sat = Opening::new(p)?;
    let time = p.growth * log(1.0 / tan(p.nutation)).abs().max(1.0);
    let l = sat.momentum;
    // An orbit of 115 minutes, perigee at 360 km with 1e-11 kg/m^3, an arm of 5 cm.
    let orbit = TAU / 6900.0;
    let gravity = 1.5 * orbit * orbit * (sat.transverse - sat.axial).abs() / l;
    let air = 0.5 * 1e-11 * 8200.0 * 8200.0 * p.length * p.diameter * 2.2 * 0.05 / l;
    // Across the axis the whips have half of what they have about it.
    let (bent, whips) = (sat.loss(), 4.0 * 0.05 * 0.4 * 0.4);
    let (about, across) = (whips / sat.axial, 0.5 * whips / sat.transverse);
    let (thin, ends) = (sat.thin(), if sat.thin() { across } else { about });
    let faster = ((1.0 + about) / (1.0 + ends) - 1.0).abs();
    let whipped = Opening {
        axial: sat.axial * (1.0 + about),
        transverse: sat.transverse * (1.0 + across),
        momentum: l * (1.0 + about),
        ..sat
    };
    // To the end, as fast as in the claims.
    let ended = |sat: Opening| sat.quickened().run(sat.quickened().settled(), 1e-9);
    let without = ended(sat)?;
    // Unless they make a thin body flat, or nearly round.
    let ratio = whipped.transverse / whipped.axial;
    let with = when(if thin { ratio > 1.02 } else { ratio < 0.98 }, || ended(whipped))?;
    let seen = with.as_ref().map(|with| (with.rate / without.rate - 1.0).abs());
    let cost = with.map_or("-".into(), |with| {
        format!("{} derivatives, {} derivatives", without.work.derivatives, with.work.derivatives)
    });
    let turns = if thin { FRAC_PI_2 - p.nutation } else { p.nutation };
    effect_card! { report,
        "it is not rigid inside": "a times L" = bent, costs turns, "rad of nutation",
            measured (without.angle - p.nutation).abs(), within 1e-3, at_work without.work, included;
        "gravity is weaker above": "3 n^2 (I_t - I_a) t/(2 L)" = gravity * time, costs gravity * time, "rad of L, at most";
        "air at the perigee": "rho v^2 C S d t/(2 L)" = air * time, costs air * time, "rad of L, at most";
        "four whip antennas": "4 m d^2/I_a" = about, costs faster, "of the rate in the end",
            measured seen, within 1e-5, at_cost cost;
    }
}

/// The averaged loss against the motion itself.
fn averaging(p: &Parameters) -> Result<Table> {
    let columns = "loss, flips, averaged, half way, averaged to half way, off by flips, separatrix, averaged to it";
    Table::of("averaging", columns.split(", "), [4.0, 2.0, 1.0, 0.5], |part| {
        let body = Lossy { loss: part * p.loss, ..lossy(p)? };
        let fallen = body.fall(start(p.aside), 1e-12)?;
        let from = body.above(&start(p.aside));
        let [whole, passed] = body.averaged_fall(from, 0.0)?;
        let [time, _] = body.averaged_fall(from, 0.5 * from)?;
        let direct = body.half_way(p.aside)?;
        let off = (direct - time) / body.averaged(0.5 * from)?[1];
        let flips = fallen.events().len() - 1;
        let [loss, direct, time, end, whole] = [body.loss, direct, time, fallen.end_time(), whole]
            .map(|x| supported_digits(x, 1e-4 * x.abs()));
        let [passed, off] = [passed, off].map(|x| format!("{x:.2}"));
        Ok([loss, flips.to_string(), passed, direct, time, off, end, whole])
    })
}

/// The error of L's direction after forty radians, and the work: evaluations of the loss.
fn price(body: &Lossy, aside: f64, scheme: Option<Scheme>, fine: f64) -> Result<(f64, Work)> {
    let (law, n, time) = (body.equations(), start(aside), 40.0);
    let (reached, work) = match scheme {
        Some(scheme) => Splitting::new(scheme, fine as u64)?.advance(body, 0.0, &n, time)?,
        None => Dop853::new(fine)?.advance(&law, 0.0, &n, time)?,
    };
    Ok((apart(reached, after(time, &law, &n, 1e-15)?), work))
}

/// The work with the fewest evaluations of the loss for an error of 1e-8.
fn least_price(body: &Lossy, aside: f64, scheme: Option<Scheme>) -> Result<Work> {
    let settings = (0..60).map(|k| match scheme {
        Some(_) => (4.0 * pow(1.1, f64::from(k))).floor(),
        None => 0.1 * pow(0.6, f64::from(k)),
    });
    let runs = sampled(settings, |fine| price(body, aside, scheme, fine))?;
    let good = runs.into_iter().filter(|(error, _)| *error <= 1e-8).map(|(_, work)| work);
    Ok(good.min_by_key(Work::torques).unwrap_or_default())
}

/// What an error of 1e-8 costs, for weaker and weaker losses.
fn prices(p: &Parameters) -> Result<Table> {
    let columns = "loss, evaluations by the splitting, its free flows, evaluations by DOP853";
    Table::of("prices", columns.split(", "), [1.0, 0.1, 0.01], |part| {
        let body = Lossy { loss: part * p.loss, ..lossy(p)? };
        let split = least_price(&body, p.aside, Some(Scheme::ABA1064))?;
        let steps = least_price(&body, p.aside, None)?;
        let [kicks, flows, derivatives] =
            [split.kicks, split.flows, steps.derivatives].map(|n| n.to_string());
        Ok([supported_digits(body.loss, 1e-4 * body.loss), kicks, flows, derivatives])
    })
}

/// Strips: the satellite until the tangent is e^2 times as large, by the library's methods.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    report.add(averaging(p)?)?;
    report.add(prices(p)?)?;
    let quick = Opening::new(p)?.quickened();
    let end = 2.0 * quick.tau();
    let (scene, first) = quick.scene()?;
    let problem = Problem::new(scene, first, end, quick.state(end)?);
    report.in_closed_form(move |part| quick.state(part * end));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-6])
}

example! {
    effects_5_explorer: "Flips with and without a loss inside: Explorer 1 and the largest axis";
    "Flips that end", "A satellite that loses energy inside, and a body with three different moments.",
    [satellite, flips, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
