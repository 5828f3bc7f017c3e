//! The Chandler wobble: from Euler's rigid Earth to the one that is observed, one effect after
//! the other.

#[path = "effects_3_chandler/excited.rs"]
pub mod excited;
#[path = "effects_3_chandler/figures.rs"]
mod figures;
#[path = "effects_3_chandler/parts.rs"]
pub mod parts;

use core::f64::consts::{PI, TAU};
use excited::Excited;
use kit::prelude::*;
use kit::supported_digits;
use parts::CoreAndMantle;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, ElasticYielding, InternalDissipation};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, ode};
use rotation_dynamics::scene::Scene;

/// One second of arc, rad.
pub const ARCSEC: f64 = PI / 648_000.0;
/// One day of 24 hours, s.
const DAY: f64 = 86_400.0;

parameters! {
    /// The Earth of the notes, as a body that yields, with a fluid core and oceans.
    pub struct Parameters {
        /// moment of inertia about an axis in the equator, over M R^2
        a: number(0.329_591, "-", between(0.0, 2.0 / 3.0).because("above 2/3 the mass would be outside").usually(0.32, 0.3304));
        /// moment of inertia about the figure axis, over M R^2
        c: number(0.330_675, "-", between(0.0, 2.0 / 3.0).because("above 2/3 the mass would be outside").usually(0.33, 0.34));
        /// one turn relative to the equinox, a sidereal day
        day: number(86_164.090_5, "s", between(1e4, 1e6).because("the pushes are those of a wobble of months, in days").usually(8e4, 9e4));
        /// Love number k_2 of the elastic mantle
        love: number(0.30, "-", at_least(0.0).because("what yields follows the pole").usually(0.0, 0.6));
        /// what the tide of the pole in the oceans adds to it
        ocean: number(0.045, "-", at_least(0.0).because("what yields follows the pole").usually(0.0, 0.1));
        /// what slow yielding of the mantle adds to it
        slow: number(0.0077, "-", at_least(0.0).because("what yields follows the pole").usually(0.0, 0.05));
        /// imaginary part of the Love number: what lags
        loss: number(0.0036, "-", from_to(1e-3, 0.02).because("with less the wobble lasts longer than the record, with more it is gone in a year").usually(1e-3, 0.02)).open("loss in the Earth", "it lasts", "it fades");
        /// Love number of a fluid Earth with this bulge
        fluid: number(0.938_319, "-", above_to(0.0, 20.0).because("the wobble fades in proportion to it, and is followed for a thousand such times").usually(0.8, 1.2));
        /// moment of inertia of the fluid core, as a part of that of the Earth
        core: number(0.113, "-", from_to(0.01, 0.5).because("a smaller core is none, and a larger one leaves no mantle").usually(0.05, 0.2));
        /// flattening of the core
        cavity: number(2.548e-3, "-", from_to(1e-3, 0.01).because("in a rounder core the fluid is not carried along, in a flatter one it is as if frozen").usually(1e-3, 0.01));
        /// size of the free wobble
        wobble: number(0.15, "arcsec", from_to(0.01, 1.0).because("the laws are those of a small wobble that is seen").usually(0.05, 0.3)).open("size of the free wobble", "small", "large");
        /// size of the yearly wobble
        annual: number(0.09, "arcsec", from_to(0.0, 1.0).because("the laws are those of a small wobble").usually(0.0, 0.2)).open("size of the yearly wobble", "none", "large");
        /// picks the random pushes
        seed: number(1891.0, "-", from_to(0.0, 1e6).because("it is a number of a list"));
        /// period that is observed
        observed: number(433.0, "d", from_to(300.0, 600.0).because("a free period of more than its rigid value and less than two years").usually(425.0, 440.0));
        /// error asked of the attitude after thirty turns
        tolerance: number(1e-6, "rad", from_to(1e-9, 1.0));
    }
}

/// (C - A)/A.
fn flattening(p: &Parameters) -> Result<f64> {
    let oblate = from_to(5e-4, 0.02).because("an oblate body that is nearly a sphere");
    oblate.check("(C - A)/A", (p.c - p.a) / p.a)
}

/// An Earth of the ledger: which effects it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    pub name: &'static str,
    /// does the mantle yield at once, does it go on yielding, do the oceans follow the pole
    pub elastic: bool,
    pub slow: bool,
    pub ocean: bool,
    /// is the core fluid
    pub core: bool,
}

const RIGID: Step = Step { name: "rigid", elastic: false, slow: false, ocean: false, core: false };
const ELASTIC: Step = Step { name: "the mantle yields", elastic: true, ..RIGID };
const FLUID: Step = Step { name: "the core is fluid", core: true, ..ELASTIC };
const OCEAN: Step = Step { name: "the oceans follow", ocean: true, ..FLUID };
const WHOLE: Step = Step { name: "the mantle creeps", slow: true, ..OCEAN };
/// A mantle that does not yield, with a fluid core.
const SHELL: Step = Step { name: "rigid, the core fluid", core: true, ..RIGID };
/// From Euler's Earth to ours.
pub const LEDGER: [Step; 5] = [RIGID, ELASTIC, FLUID, OCEAN, WHOLE];

// ANCHOR: ledger
impl Step {
    /// k/k_s: the part of the bulge that follows the pole.
    pub fn following(&self, p: &Parameters) -> Result<f64> {
        let part = |is: bool, love: f64| if is { love } else { 0.0 };
        let love = part(self.elastic, p.love) + part(self.slow, p.slow) + part(self.ocean, p.ocean);
        let part_of =
            from_to(0.0, 0.9).because("if all of the bulge follows, nothing calls the pole back");
        part_of.check("k/k_s, the part of the bulge that follows,", love / p.fluid)
    }

    /// The free period in turns of the Earth, to first order in its flattening: what the
    /// wobble has to move, over what calls it back.
    pub fn simple(&self, p: &Parameters) -> Result<f64> {
        let moved = if self.core { 1.0 - p.core } else { 1.0 };
        Ok(moved / ((1.0 - self.following(p)?) * flattening(p)?))
    }

    /// The same for a small wobble of this model, to every order.
    pub fn period(&self, p: &Parameters) -> Result<f64> {
        let (f, part) = (flattening(p)?, self.following(p)?);
        match self.core {
            true => Ok(1.0 / CoreAndMantle::of(p, self)?.rates()[0]),
            false => Ok((1.0 / f + part) / (1.0 - part)),
        }
    }

    /// The same, stepped until the pole of rotation is back.
    pub fn simulated(&self, p: &Parameters, step: f64) -> Result<f64> {
        let (body, alpha) = (body(p)?, p.wobble * ARCSEC);
        if self.core {
            return CoreAndMantle::of(p, self)?.circuit(alpha, step);
        }
        let yielding = ElasticYielding::following(self.following(p)?, &body, 1.0)?;
        let start = yielding.momentum(&body, BodyVector::new(alpha, 0.0, 1.0));
        let back = match self.elastic {
            true => back(&Scene::new(body).with(yielding), start, step)?,
            false => back(&Scene::new(body), start, step)?,
        };
        Ok(back.t / TAU)
    }
}
// ANCHOR_END: ledger

/// The Earth, in units of M R^2; time in 1/Omega.
fn body(p: &Parameters) -> Result<RigidBody> {
    flattening(p)?;
    Ok(RigidBody::new(PrincipalMoments::symmetric(p.a, p.c)?))
}

// ANCHOR: euler
/// Euler's equation L' = L x omega on the body's axes, with the angular velocity that the
/// body of this scene has; `sizes` against which errors count.
fn euler<E: Effect>(scene: &Scene<E>, sizes: [f64; 3]) -> impl Ode<3> {
    let law = ode(move |_, l: &[f64; 3]| {
        let momentum = BodyVector::from_array(*l);
        momentum.cross(&turning(scene, l)).to_array()
    });
    law.scaled(move |_| sizes)
}

/// The angular velocity of a body with this momentum, both on its axes.
fn turning<E: Effect>(scene: &Scene<E>, l: &[f64; 3]) -> BodyVector {
    let state =
        State { attitude: Attitude::IDENTITY, angular_momentum: SpaceVector::from_array(*l) };
    scene.angular_velocity(0.0, &state)
}
// ANCHOR_END: euler

/// The moment when the pole of rotation, which starts on the meridian of Greenwich, is back.
fn back<E: Effect>(scene: &Scene<E>, start: BodyVector, step: f64) -> Result<LocatedEvent<3>> {
    let start = start.to_array();
    let law = euler(scene, [start[0], start[0], start[2]]);
    let back = Dop853::new(step)?.zero(&law, start, 2, 1e6, |l| turning(scene, l).y())?;
    Ok(back.0)
}

/// How much of a small wobble is left after a circuit of a body that yields and loses energy
/// inside, at this quality.
fn faded(p: &Parameters, quality: f64) -> Result<f64> {
    let (body, alpha) = (body(p)?, p.wobble * ARCSEC);
    let yielding = ElasticYielding::following(ELASTIC.following(p)?, &body, 1.0)?;
    let start = yielding.momentum(&body, BodyVector::new(alpha, 0.0, 1.0));
    let decay = 0.5 / (quality * ELASTIC.period(p)?);
    let loss = InternalDissipation::new(decay * p.a / (p.c * (p.c - p.a)))?;
    let scene = Scene::new(body).with(yielding).with(loss);
    let back = back(&scene, start, 1e-13)?;
    Ok(back.state[0] / start.x())
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let days = p.day / DAY;
    let period = |step: Step| -> Result<f64> { Ok(step.period(p)? * days) };
    let stepped = |step: Step| -> Result<f64> { Ok(step.simulated(p, 1e-12)? * days) };
    let (whole, all) = (period(WHOLE)?, stepped(WHOLE)?);
    let (rigid, elastic, fluid) = (period(RIGID)?, period(ELASTIC)?, period(FLUID)?);
    // The formulas are those of a small wobble; that of the quality is of first order.
    let (bound, first, year) = (1e-9 * whole, 2.0 * flattening(p)?, excited::YEAR);
    let quality = 0.5 * (p.fluid * (1.0 - WHOLE.following(p)?)) / p.loss;
    let complex = CoreAndMantle::of(p, &WHOLE)?.quality(p.loss / p.fluid * (p.c - p.a));
    let core = CoreAndMantle::of(p, &FLUID)?;
    let nutation = |rate: f64| days / (1.0 + rate);
    let alpha = p.wobble * ARCSEC;
    let excited = Excited::new(p)?;
    let beat = 1.0 / (1.0 / year - 1.0 / whole).abs() / year;
    claims! { report,
        /// Euler's rigid Earth
        rigid: rigid, "d", "simulated" => stepped(RIGID)?, within bound, in "The period":
            rigid / days => "these are sidereal days";
        /// with a mantle that yields
        elastic: elastic, "d", "simulated with the effect" => stepped(ELASTIC)?, within bound, in "The period":
            elastic / days => "these are sidereal days",
            rigid * (1.0 - ELASTIC.following(p)?) => "what yields calls the pole back less strongly";
        /// with a fluid core in a rigid mantle
        shell: period(SHELL)?, "d", "simulated, core and mantle" => stepped(SHELL)?, within bound, in "The period":
            rigid / (1.0 - p.core) => "the core need not be moved: the wobble is faster",
            rigid => "the core is fluid, and moves otherwise";
        /// with both
        fluid: fluid, "d", "simulated, core and mantle" => stepped(FLUID)?, within bound, in "The period":
            fluid / days => "these are sidereal days";
        /// with oceans that follow the pole
        ocean: period(OCEAN)?, "d", "simulated, core and mantle" => stepped(OCEAN)?, within bound;
        /// with a mantle that has time to yield
        whole: whole, "d", "simulated, core and mantle" => all, within bound, in "The period":
            whole / days => "these are sidereal days";
        /// what is left to the period observed
        left: p.observed - whole, "d", "simulated, core and mantle" => p.observed - all, within bound;
        /// free nutation of the core, a period among the stars, backward
        nutation: nutation(core.rates()[1]), "d",
        "simulated, core and mantle" => nutation(core.nutation(alpha, 1e-12)?), within 1e-6 * whole;
        /// quality of the wobble, 2 pi over the part of its energy that is lost in a circuit
        quality: quality, "-", "complex root for core and mantle" => complex, within first * quality, in "Fading":
            2.0 * quality => "the energy goes as the square";
        /// the part of the wobble that is left after a circuit, at this quality
        left_over: exp(-PI / quality), "-", "simulated with both effects" => faded(p, quality)?,
        within 5e-3 / (quality * quality), in "Fading":
            exp(-2.0 * PI / quality) => "that is the energy";
        /// time in which it fades to 1/e
        fading: quality * whole / (PI * year), "yr", "complex root for core and mantle" => complex * whole / (PI * year),
        within first * quality * whole / (PI * year), in "Fading":
            2.0 * quality * whole / (PI * year) => "that is of the energy: a factor of two";
        /// from one beat with the year to the next
        beat: beat, "yr", "located on the path" => excited.located_beat()?,
        within 1e-9 * beat, if p.annual > 0.01 * p.wobble && beat < 50.0 && beat > 1.5, in "The beat":
            (whole - year) / year => "subtract the frequencies, not the periods";
        /// monthly pushes that keep up the wobble, root mean square of each component
        push: 1e3 * excited.push, "mas", "a thousand fading times of pushes" => 1e3 * excited.push * p.wobble / excited.kept_up(),
        within 100.0 * excited.push;
        /// the pole after four years of pushes, from Greenwich to the east
        pole: excited.at(1461.0)[1], "arcsec", "stepped month by month" => excited.stepped(1461.0)?[1], within 1e-9;
    }
}

/// The ledger: one effect after the other.
fn ledger(p: &Parameters, report: &mut Report) -> Result<()> {
    let days = p.day / DAY;
    let columns = "step, k/k_s, first order, exact, simulated, to the observed";
    report.add(Table::of("ledger", columns.split(", "), LEDGER, |step| {
        let (exact, simulated) = (step.period(p)? * days, step.simulated(p, 1e-10)? * days);
        let off = (exact - simulated).abs().max(1e-3);
        Ok([
            step.name.to_string(),
            supported_digits(step.following(p)?, 5e-5),
            supported_digits(step.simple(p)? * days, 0.05),
            supported_digits(exact, off),
            supported_digits(simulated, off),
            supported_digits(p.observed - exact, 0.05),
        ])
    })?)
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let f = flattening(p)?;
    let sphere = p.but(|p| (p.cavity, p.love) = (0.0, 0.0));
    let tiny = p.but(|p| p.core = 1e-9);
    let nearly = p.but(|p| p.love = p.fluid * 0.899_999);
    let round = CoreAndMantle::of(&sphere, &SHELL)?.rates();
    limits! { report,
        /// a fluid in a round cavity takes no notice: the mantle is a body of its own
        "round core, rigid mantle: T (C - A)/A_m": 1.0 / round[0] * f / (1.0 - p.core) => 1.0, within 1e-12;
        /// and the fluid keeps its axis among the stars
        "round core: 1 + rate of the nutation": 1.0 + round[1] => 0.0, within 1e-12;
        /// hardly any core
        "A_f = 1e-9 A: T/T without core": FLUID.period(&tiny)? / ELASTIC.period(p)? => 1.0, within 1e-8;
        /// the exact period of a round enough Earth is the formula's
        "k = 0.9 k_s: T/first order": FLUID.period(&nearly)? / FLUID.simple(&nearly)? => 1.0, within 0.05;
    }
}

/// The card of effects: what each makes of the whole, and what is left out.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (whole, days) = (WHOLE.period(p)?, p.day / DAY);
    let without = |step: Step| -> Result<f64> { Ok((whole - step.period(p)?) * days) };
    let stiff = Step { elastic: false, ..WHOLE };
    let prompt = Step { slow: false, ..WHOLE };
    let dry = Step { ocean: false, ..WHOLE };
    let frozen = Step { core: false, ..WHOLE };
    let (left, uneven, whole) = (p.fluid * (1.0 - WHOLE.following(p)?), 0.0053, whole * days);
    let year = TAU / excited::YEAR;
    // The simulations that confirm the claims, and three more circuits.
    let told = |key| report.claim(key).map_or(f64::NAN, |claim| claim.oracle.value);
    let (all, lasting) = (told("whole"), told("left_over"));
    let slower = all - told("ocean");
    let ran = |step: Step| -> Result<f64> { Ok(all - step.simulated(p, 1e-10)? * days) };
    // Euler's small wobble of three moments, in closed form; none of what is no body.
    let apart = |part: f64| -> Result<f64> {
        let side = part * (p.c - p.a);
        let moments = PrincipalMoments::new(p.a - side, p.a + side, p.c)?;
        let rates = BodyVector::new(1e-4, 0.0, 1.0);
        Ok(FreeBody::new(moments, Attitude::IDENTITY, rates)?.rate_period())
    };
    let longer = apart(0.00335).ok().zip(apart(0.0).ok());
    effect_card! { report,
        "yielding of the mantle":
            "k_2/k_s" = p.love / p.fluid, costs without(stiff)?, "d of the period", measured ran(stiff)?, within 1e-5, included;
        "fluid core":
            "A_f/A" = p.core, costs without(frozen)?, "d of the period", measured ran(frozen)?, within 1e-5, included;
        "tide of the pole in the oceans":
            "k_ocean/k_s" = p.ocean / p.fluid, costs without(dry)?, "d of the period", measured ran(dry)?, within 1e-5, included;
        "slow yielding of the mantle":
            "k_slow/k_s" = p.slow / p.fluid, costs without(prompt)?, "d of the period", measured slower, within 1e-5, included;
        "loss in the mantle":
            "Im k/(k_s - k)" = p.loss / left, costs 2.0 * PI * p.loss / left, "of the wobble in a circuit, to first order",
            measured 1.0 - lasting, within 1e-6, included;
        "yearly wobble, by weather and water":
            "yearly/free wobble" = p.annual / p.wobble, costs p.annual, "arcsec of the pole", included;
        "oceans that lie unevenly":
            "half difference of k_ocean/(k_s - k)" = uneven / left, costs 0.5 * (uneven / left) * (uneven / left) * whole, "d of the period";
        "solid inner core":
            "A_s/A" = 7.3e-4, costs 7.3e-4 / (1.0 - p.core) * whole, "d of the period, at most";
        "two different moments in the equator":
            "(B - A)/(C - A)" = 0.0067, costs 0.5 * 0.00335 * 0.00335 * whole, "d of the period",
            measured longer.map(|(with, without)| (with / without - 1.0) * whole), within 1e-9 * whole;
        "torque of Sun and Moon":
            "rate of the equinox/rate of the wobble" = whole / (25_770.0 * excited::YEAR), costs 0.055, "arcsec of the axis among the stars in a day";
        "backward part of the yearly wobble":
            "year/free period" = TAU / (year * whole), costs 0.01, "arcsec of the pole";
    }
}

/// The runs that the page asks the reader to predict.
fn tries(_: &Parameters, report: &mut Report) -> Result<()> {
    let ours = Parameters::default();
    let runs = [
        ("as it is", ours.clone()),
        ("a small core", ours.but(|p| p.core = 0.05)),
        ("a flatter core", ours.but(|p| p.cavity = 0.0027)),
        ("half the loss", ours.but(|p| p.loss = 0.0018)),
        ("a soft mantle", ours.but(|p| p.love = 0.6)),
    ];
    let columns = ["run", "period", "nutation", "fading", "beat"];
    report.add(Table::of("tries", columns, runs, |(name, p)| {
        let (days, core) = (p.day / DAY, CoreAndMantle::of(&p, &WHOLE)?);
        let (period, year) = (WHOLE.period(&p)? * days, excited::YEAR);
        let simulated = WHOLE.simulated(&p, 1e-9)? * days;
        let quality = core.quality(p.loss / p.fluid * (p.c - p.a));
        Ok([
            name.to_string(),
            supported_digits(period, (period - simulated).abs().max(0.05)),
            supported_digits(days / (1.0 + core.rates()[1]), 0.5),
            supported_digits(quality * period / (PI * year), 0.05),
            supported_digits(1.0 / (1.0 / year - 1.0 / period).abs() / year, 5e-3),
        ])
    })?)
}

/// The attitude of the yielding Earth after thirty turns.
fn strip(p: &Parameters, report: &mut Report) -> Result<()> {
    let (body, rate) = (body(p)?, TAU / p.day);
    let yielding = ElasticYielding::following(ELASTIC.following(p)?, &body, rate)?;
    let turning = BodyVector::new(p.wobble * ARCSEC, 0.0, 1.0) * rate;
    let start = yielding.state(&body, Attitude::IDENTITY, turning)?;
    let moments = yielding.moments(&body, &start)?;
    let motion = FreeBody::new(moments, start.attitude, turning)?;
    let end = 30.0 * p.day;
    let scene = Scene::new(body).with(yielding);
    let problem = Problem::new(scene, start, end, motion.state(end));
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-9])
}

example! {
    effects_3_chandler: "The Chandler wobble, from the rigid Earth to the observed period, one effect after the other";
    "The Chandler wobble", "The Earth wobbles; each effect has its share in the period.",
    [claims, ledger, limits, effects, tries, strip];
    figures::figures, figures::trajectory, figures::moving_picture
}
