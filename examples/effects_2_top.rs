//! A toy top on a rounded tip, from the throw to the fall: it slides and rises, sleeps, and dies.

#[path = "effects_2_top/figures.rs"]
mod figures;
#[path = "effects_2_top/ledger.rs"]
mod ledger;

use core::f64::consts::TAU;
use kit::prelude::*;
use models::tops::{
    Configuration, Dry, NoSlip, Patch, Shape, Smooth, Throw, TipFriction, Top, TopMotion,
};
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::integrators::Work;

parameters! {
    /// The toy top of 16.2, its tip a ball.
    pub struct Parameters {
        /// radius of the tip
        tip: number(0.005, "m", from_to(0.004, 0.007).because("a sharper tip hardly raises the top, a blunter one has the rim on the floor").usually(0.004, 0.007));
        /// tilt of the axis at the throw
        tilt: number(0.3, "rad", from_to(0.2, 0.35).because("the law of the rise is that of a top that leans a little").usually(0.2, 0.35));
        /// spin at the throw
        spin: number(150.0, "rad/s", from_to(130.0, 170.0).because("a slower top does not sleep, a faster one does not fall in the time that is simulated; the other way round it is its mirror image").usually(130.0, 170.0)).open("spin at the throw", "slow", "fast");
        /// coefficient of dry friction of tip and floor
        friction: number(0.05, "-", from_to(0.03, 0.08).because("with less it does not rise before it is slow, with more it rolls").usually(0.03, 0.08)).open("friction of tip and floor", "rises slowly", "rises quickly");
        /// effective modulus of both: 1/E* is the sum of (1 - nu^2)/E
        modulus: number(4e9, "Pa", from_to(2e9, 8e9).because("the contact is that of hard plastic or wood").usually(2e9, 8e9));
        /// slope of the floor
        slope: number(1e-3, "rad", from_to(3e-4, 2e-3).because("on a level floor it does not walk, on a steeper one it runs away").usually(3e-4, 2e-3));
        /// error of a step of the simulations: from 1e-12 to 1e-8
        tolerance: number(1e-10, "-", from_to(1e-12, 1e-8));
    }
}

// ANCHOR: toy
/// Mass, moments across and along the axis about the centre of mass, from there to the centre
/// of the tip, radius of the rim: SI units.
const MASS: f64 = 0.1;
const ACROSS: f64 = 4e-5;
const AXIAL: f64 = 4e-5;
const LEVER: f64 = 0.04;
const RIM: f64 = 0.03;
const GRAVITY: f64 = 9.80665;
const WEIGHT: f64 = MASS * GRAVITY;

/// A top of the page, with air and on a floor that slopes, and its motion.
type Toy<F> = Top<F, (), ((), DiscDrag)>;
type Motion<F> = TopMotion<F, (), ((), DiscDrag)>;
pub type Life = Motion<Patch>;

impl Parameters {
    fn shape(&self) -> rotation_dynamics::Result<Shape> {
        Shape::new(MASS, ACROSS, AXIAL, LEVER, self.tip)?.with_rim(RIM, 0.0)
    }

    fn air(&self) -> rotation_dynamics::Result<DiscDrag> {
        DiscDrag::new(RIM, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, self.spin)
    }

    /// The radius of the patch that the weight presses into tip and floor.
    pub fn patch(&self) -> rotation_dynamics::Result<f64> {
        Patch::hertz_radius(WEIGHT, self.tip, self.modulus)
    }

    /// Everything: air, a floor that is not quite level, and this friction.
    fn toy<F: TipFriction>(&self, friction: F) -> rotation_dynamics::Result<Toy<F>> {
        let top = Top::new(self.shape()?, GRAVITY)?.on(friction);
        top.in_effect(self.air()?)?.sloping(self.slope)
    }

    fn rubbing(&self) -> rotation_dynamics::Result<Patch> {
        Patch::new(self.friction, self.patch()?)
    }

    /// Thrown with the precession that goes with its weight, its centre of mass at rest.
    pub fn throw(&self) -> Throw {
        let (momentum, weight) = (AXIAL * self.spin, WEIGHT * LEVER);
        let four = 4.0 * ACROSS * cos(self.tilt) * weight;
        let precession = 2.0 * weight / (momentum + (momentum * momentum - four).sqrt());
        Throw::spinning(self.tilt, self.spin).precessing(precession)
    }

    /// From the throw to the fall.
    fn life(&self, tolerance: f64) -> rotation_dynamics::Result<Life> {
        self.life_on(self.rubbing()?, tolerance)
    }

    /// The same on this patch, with marks on the way.
    pub fn life_on(&self, patch: Patch, tolerance: f64) -> rotation_dynamics::Result<Life> {
        let top = self
            .toy(patch)?
            .passing("creeps", self.patch()?, |at, patch| {
                at.slip.norm() - patch * at.angular_velocity.z().abs()
            })
            .passing("sleeps", ASLEEP, |at, tilt| at.tilt() - tilt)
            .passing("unstable", self.least_spin(), |at, least| at.spin() - least)
            .passing("wakes", AWAKE, |at, tilt| tilt - at.tilt());
        top.simulate(&self.throw(), 2000.0, tolerance)
    }
}
// ANCHOR_END: toy

/// Tilts (rad) at which it is said to fall asleep, and to wake.
const ASLEEP: f64 = 0.01;
const AWAKE: f64 = 0.05;

// ANCHOR: laws
impl Parameters {
    /// How fast the tip's surface slides over the floor at the throw.
    pub fn first_slip(&self) -> f64 {
        let ((s, c), rate) = (sincos(self.tilt), self.throw().precession);
        s * (self.tip * (self.spin - rate * c) - LEVER * rate)
    }

    /// How fast friction turns the axis up while the tip slides.
    pub fn rise_rate(&self) -> f64 {
        let c = cos(self.tilt);
        let momentum = AXIAL * self.spin - 2.0 * ACROSS * self.throw().precession * c;
        self.friction * WEIGHT * (LEVER + self.tip * c) / momentum
    }

    /// How fast nods of this tilt grow while the tip slides, and how fast friction damps them.
    pub fn nods(&self) -> [f64; 2] {
        let (s, c) = sincos(self.tilt);
        let high = LEVER * c + self.tip;
        let heavier = ACROSS + MASS * LEVER * LEVER * s * s;
        let part = 0.5 * self.friction * MASS / heavier;
        let grow = part * LEVER * (LEVER + self.tip * c) * s * AXIAL * self.spin / ACROSS;
        [grow, part * GRAVITY * high * high / self.first_slip()]
    }

    /// The tilt at which the friction can carry the centre of mass round with the tip.
    pub fn grip_tilt(&self) -> f64 {
        let rate = self.throw().precession;
        self.friction * GRAVITY / (rate * (self.tip * self.spin - LEVER * rate))
    }

    /// The spin below which a creeping tip lets it fall.
    pub fn least_spin(&self) -> f64 {
        let high = LEVER + self.tip;
        high * (WEIGHT * LEVER / (self.tip * (AXIAL * high - ACROSS * self.tip))).sqrt()
    }

    /// The spin below which a rolling tip would let it fall.
    pub fn rolling_spin(&self) -> f64 {
        let high = LEVER + self.tip;
        let geared = AXIAL + MASS * self.tip * high;
        2.0 * ((ACROSS + MASS * high * high) * WEIGHT * LEVER).sqrt() / geared
    }

    /// Precession of a small tilt whose tip rolls, at this spin: the slow root.
    pub fn precession(&self, spin: f64) -> f64 {
        let high = LEVER + self.tip;
        let geared = (AXIAL + MASS * self.tip * high) * spin;
        let four = 4.0 * (ACROSS + MASS * high * high) * WEIGHT * LEVER;
        2.0 * WEIGHT * LEVER / (geared + (geared * geared - four).sqrt())
    }

    /// The rate at which a small tilt dies by creep, at this spin.
    pub fn settling(&self, spin: f64) -> Result<f64> {
        let (high, rate) = (LEVER + self.tip, self.precession(spin));
        let viscous = 3.0 * TAU / 16.0 * self.friction * WEIGHT / (self.patch()? * spin);
        let (geared, moment) = (AXIAL + MASS * self.tip * high, ACROSS + MASS * high * high);
        let driven = high * MASS * MASS * rate * rate * (self.tip * spin - high * rate);
        Ok(driven / (viscous * (geared * spin - 2.0 * moment * rate)))
    }

    /// What slows an upright spin, rad/s^2: air and pivoting.
    fn braking(&self, spin: f64) -> Result<f64> {
        let pivoting = 3.0 * TAU / 32.0 * self.friction * WEIGHT * self.patch()?;
        Ok((pivoting - self.air()?.axial_torque(spin)) / AXIAL)
    }
}
// ANCHOR_END: laws

/// The load (N) of the pressure 2 a E*/(pi r) sqrt(1 - (rho/a)^2) on the patch.
fn load(p: &Parameters) -> Result<f64> {
    let a = p.patch()?;
    let middle = 4.0 * a * p.modulus / (TAU * p.tip);
    // Over the angle whose sine is rho/a.
    let ring = |(s, c): (f64, f64)| Ok(TAU * a * a * middle * s * c * c);
    kit::simpson([0.0, 0.25 * TAU], 2000, |angle| ring(sincos(angle)))
}

/// How fast a small tilt grows (1/s) on a level floor without air, at this spin.
pub fn growth(p: &Parameters, spin: f64) -> Result<f64> {
    // A tenth of the friction and of the patch: as viscous, with a hundredth of the pivoting.
    let firm = Patch::new(0.1 * p.friction, 0.1 * p.patch()?)?;
    let top = Top::new(p.shape()?, GRAVITY)?.on(firm);
    let precession = p.precession(spin.max(1.02 * p.rolling_spin()));
    let start = Throw::spinning(1e-5, spin).precessing(precession).rolling();
    let run = top.simulate(&start, 18.0, 1e-12)?;
    // Over whole turns of the precession what is left of a nod averages out.
    let turn = TAU / precession;
    let size =
        |from: f64| mean(times(from, from + turn, 200), |t| Ok(log(run.configuration(t)?.tilt())));
    let (from, to) = (8.0, 8.0 + 10.0 * turn.min(0.7));
    Ok((size(to)? - size(from)?) / (to - from))
}

/// The mean of what `of` gives at these times.
fn mean(times: impl Iterator<Item = f64>, of: impl FnMut(f64) -> Result<f64>) -> Result<f64> {
    let samples = sampled(times, of)?;
    Ok(samples.iter().sum::<f64>() / samples.len() as f64)
}

/// The spin at which a small tilt neither grows nor dies.
fn least_by_growth(p: &Parameters) -> Result<f64> {
    let least = p.least_spin();
    let grows = |spin: f64| -> Result<bool> { Ok(growth(p, spin)? > 0.0) };
    let [low, high] = try_bisect([0.985 * least, 1.015 * least], 1.2e-4 * least, grows)?;
    Ok(0.5 * (low + high))
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    allowed! {
        "spin over the least spin of a sleeping top": p.spin / p.least_spin(), above(1.25), "a slower one does not sleep";
    }?;
    let (life, again) = (p.life(p.tolerance)?, p.life(0.1 * p.tolerance)?);
    let when = |name| -> Result<[f64; 2]> { Ok([life.event(name)?.t, again.event(name)?.t]) };
    let first = life.configuration(0.0)?;
    // With so little friction it goes on at one rate, and without a nod.
    let gentle = Top::new(p.shape()?, GRAVITY)?.on(Dry::new(1e-3 * p.friction)?);
    let gentle = gentle.simulate(&p.throw(), 3.0, 1e-12)?.configuration(3.0)?;
    let risen = 1e3 * (p.tilt - gentle.tilt()) / 3.0;
    let [creeps, creeps_again] = when("creeps")?;
    let [asleep, asleep_again] = when("sleeps")?;
    let [wakes, wakes_again] = when("wakes")?;
    let [falls, falls_again] = when("falls")?;
    let fallen = life.configuration_at(life.event("falls")?);
    let fallen_again = again.configuration_at(again.event("falls")?);
    let least = p.least_spin();
    // Between two spins of the sleep.
    let unstable = life.event("unstable")?.t;
    let (early, late) = (0.5 * unstable, 0.9 * unstable);
    let [fast, slow] = [life.configuration(early)?, life.configuration(late)?].map(|at| at.spin());
    let slept = kit::simpson([slow, fast], 200, |w| Ok::<_, kit::Error>(1.0 / p.braking(w)?))?;
    let crossed = least_by_growth(p)?;
    let (leans, settles) = (p.slope * (LEVER + p.tip) / LEVER, p.settling(p.spin)?);
    let bound = 1e3 * p.tolerance;
    // What wakes it is a tiny deviation, to which the steps add: a tenth of the tolerance leaves a tenth
    // of it. Its two components are due to chance, so that it is below a thirtieth of that once in 900
    // runs (1/(1 + 30^2) if both are normal); it takes so much longer (s) to grow.
    let grown = log(life.configuration(wakes)?.tilt() / life.configuration(wakes - 1.0)?.tilt());
    let later = log(300.0) / grown;
    let touches = asin(p.tip / hypot(RIM, LEVER)) + atan2(LEVER, RIM);
    let grip = |step: f64| -> Result<[f64; 2]> {
        let point = p.toy(Dry::new(p.friction)?)?.simulate(&p.throw(), 5.0, step)?;
        let event = point.event("grips")?;
        Ok([event.t, point.configuration_at(event).tilt()])
    };
    let [grips, gripped] = grip(p.tolerance)?;
    let [grips_again, gripped_again] = grip(0.01 * p.tolerance)?;
    claims! { report,
        /// precession of the throw
        precession: p.throw().precession, "rad/s", "the simulated axis" => first.precession(), within 1e-10;
        /// radius of the patch of contact
        patch: 1e3 * p.patch()?, "mm", "load of its pressure, summed" =>
            1e3 * p.patch()? * cbrt(WEIGHT / load(p)?), within 1e-9, in "The contact";
        /// speed of the slip at the throw
        slip: p.first_slip(), "m/s", "the simulated contact" => first.slip.norm(), within 1e-12, in "Sliding":
            p.tip * p.spin * sin(p.tilt) => "the ball's centre moves as well, because the axis precesses";
        /// rate at which the axis rises at first
        rise: p.rise_rate(), "rad/s", "a thousandth of the friction, for 3 s" => risen, within 0.01 * p.rise_rate(), in "Sliding":
            p.rise_rate() * LEVER / (LEVER + p.tip) => "the arm reaches to the floor";
        /// with dry friction at a point it would grip after this time
        grips: grips, "s", "finer steps" => grips_again, within 1e4 * p.tolerance;
        /// at this tilt
        gripped: gripped, "rad", "finer steps" => gripped_again, within 1e4 * p.tolerance;
        /// it creeps from this time on
        creeps: creeps, "s", "finer steps" => creeps_again, within bound * creeps;
        /// rate at which a small tilt dies, at the spin of the throw
        settling: settles, "1/s", "a small tilt simulated" => -growth(p, p.spin)?, within 0.02 * settles, in "Creeping";
        /// it is asleep from this time on
        asleep: asleep, "s", "finer steps" => asleep_again, within bound * asleep;
        /// tilt in its sleep, by the slope of the floor
        leans: leans, "rad", "simulated" => life.configuration(late)?.tilt(), within 1e-3 * leans, in "Sleeping":
            p.slope => "the centre of mass stands above the contact, not above the centre of the tip";
        /// time in which it sleeps from a half to nine tenths of the way to instability
        slept: slept, "s", "simulated" => late - early, within 5e-4 * slept;
        /// least spin at which it can sleep
        least: least, "rad/s", "zero of the simulated growth" => crossed, within 5e-4 * least, in "Sleeping":
            p.rolling_spin() => "that is for a tip that rolls",
            2.0 * ((ACROSS + MASS * LEVER * LEVER) * WEIGHT * LEVER).sqrt() / AXIAL => "that is for a sharp tip that does not slip";
        /// it wakes
        wakes: wakes, "s", "finer steps" => wakes_again, within later;
        /// its rim touches the floor
        falls: falls, "s", "finer steps" => falls_again, within later;
        /// tilt at the fall
        fallen: touches, "rad", "simulated" => fallen.tilt(), within 1e-10, in "The fall";
        /// spin at the fall
        last_spin: fallen.spin(), "rad/s", "finer steps" => fallen_again.spin(), within 5e-3 * least;
    }
}

/// Where the motion is known.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let top = || Top::new(p.shape()?, GRAVITY);
    let change =
        |of: &dyn Fn(f64) -> Result<f64>| -> Result<f64> { Ok((of(2.0)? / of(0.0)? - 1.0).abs()) };
    let point = top()?.on(Dry::new(p.friction)?).simulate(&p.throw(), 2.0, p.tolerance)?;
    let smooth = top()?.simulate(&p.throw(), 2.0, p.tolerance)?;
    let rolls = top()?.on(NoSlip).simulate(&p.throw().rolling(), 2.0, p.tolerance)?;
    // The spins at which a top can sleep, for a tip that shrinks to a point.
    let sharp = p.but(|p| p.tip = 1e-9);
    let notes = 2.0 * ((ACROSS + MASS * LEVER * LEVER) * WEIGHT * LEVER).sqrt() / AXIAL;
    let within = 1e3 * p.tolerance;
    limits! { report,
        /// friction of the tip has no moment about the line from the centre of mass to the contact
        "sliding, then rolling: change of Jellett's integral": change(&|t| Ok(point.top().jellett(&point.configuration(t)?)))? => 0.0, within within;
        /// nothing rubs
        "smooth floor: change of the energy": change(&|t| Ok(smooth.top().energy(&smooth.configuration(t)?)))? => 0.0, within within;
        /// the point that is held does not move
        "no slip: change of the energy": change(&|t| Ok(rolls.top().energy(&rolls.configuration(t)?)))? => 0.0, within within;
        /// then the tip is the fixed point of 16.2
        "sharp tip that rolls: its critical spin over that of 16.2": sharp.rolling_spin() / notes => 1.0, within 1e-5;
    }
}

/// The accuracy strip: dry friction at a point, from the throw until the tip grips.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let top = p.toy(Dry::new(p.friction)?)?;
    let throw = p.throw();
    let exact = top.simulate(&throw, 5.0, 1e-14)?.event("grips")?.t;
    let grips = move |step: f64| -> rotation_dynamics::Result<(f64, Work)> {
        let run = top.simulate(&throw, 5.0, step)?;
        Ok((run.event("grips")?.t, run.work()))
    };
    let error = move |(t, _): &(f64, Work)| Ok((t / exact - 1.0).abs());
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12];
    report.stepped(asked, grips, |run| run.1, error)
}

example! {
    effects_2_top: "The rising, sleeping and dying top, from throw to fall";
    "A top from throw to fall", "The toy top of 16.2 on a rounded tip that slides and creeps, in air.",
    [claims, ledger::phases, ledger::without, limits, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
