//! The damped nutation of a real gyroscope: gimbals with inertia, bearings with friction,
//! from the release to the stop.

#[path = "effects_1_gyroscope/figures.rs"]
mod figures;
#[path = "effects_1_gyroscope/ledger.rs"]
pub mod ledger;
#[path = "effects_1_gyroscope/measured.rs"]
pub mod measured;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use models::gimbals::{Bearing, Bearings, Decay, GimbalMotion, Gimbals, NutationCycle, Pose};
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::exact::heavy_top::SymmetricTop;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::integrators::Dop853;

parameters! {
    /// The half-kilogram gyroscope of the notes' section, in light gimbals with plain bearings.
    pub struct Parameters {
        /// turns of the rotor in a minute
        rpm: number(3000.0, "1/min", from_to(2000.0, 1e4).because("a slower rotor nods too widely, a faster one takes too long; one that turns the other way is its mirror image").usually(2000.0, 6000.0)).open("turns of the rotor", "nods deeply", "hardly nods");
        /// tilt of the axis at the release
        theta: number(PI / 3.0, "rad", from_to(0.3, 1.65).because("a more upright axis hardly nods, a lower one is at its stop").usually(0.7, 1.2));
        /// moment of the ring about the line of nodes, and across the axle
        ring: number(1.5e-4, "kg m^2", from_to(0.0, 5e-3).because("gimbals are lighter than what they hold").usually(2e-5, 1e-3));
        /// moment of the ring along the axle
        ring_along: number(2e-5, "kg m^2", from_to(0.0, 5e-3).because("gimbals are lighter than what they hold").usually(0.0, 1e-4));
        /// moment of the fork about the vertical
        fork: number(2e-4, "kg m^2", from_to(0.0, 5e-3).because("gimbals are lighter than what they hold").usually(0.0, 2e-3));
        /// dry friction of the tilt bearing
        tilt_dry: number(3e-3, "N m", at_least(0.0).usually(1e-3, 2e-2));
        /// viscous friction of the tilt bearing
        tilt_viscous: number(1e-3, "N m s", from_to(1e-5, 0.02).because("with less the nods do not end, with more there are none").usually(1e-4, 1e-2)).open("viscous friction of the tilt bearing", "nods long", "nods die soon");
        /// dry friction of the vertical pivot
        pivot_dry: number(1e-4, "N m", from_to(5e-5, 2e-3).because("with less the axis hardly sinks, with more it falls").usually(5e-5, 5e-4));
        /// viscous friction of the vertical pivot
        pivot_viscous: number(1e-5, "N m s", from_to(0.0, 1e-3).because("with more the axis falls").usually(0.0, 1e-4));
        /// dry friction of the axle's ball bearings
        axle_dry: number(1.5e-5, "N m", from_to(0.0, 2e-4).because("with more the rotor is slow before the axis is at its stop").usually(0.0, 2e-4));
        /// tilt at which the ring meets its stop
        stop: number(2.0, "rad", from_to(1.7, 2.8).because("the stop is below the release and above the pivot").usually(1.8, 2.4));
        /// error of a step of the simulations: from 1e-13 to 1e-8
        tolerance: number(1e-11, "-", from_to(1e-13, 1e-8));
    }
}

/// Disc of half a kilogram and 6 cm radius, its middle 10 cm from the pivot: m g l is in N m.
pub const MASS: f64 = 0.5;
const GRAVITY: f64 = 9.80665;
const LENGTH: f64 = 0.1;
const RADIUS: f64 = 0.06;
const I1: f64 = 5.45e-3;
const I3: f64 = 9e-4;

/// The longest simulation, s.
const LONGEST: f64 = 4000.0;

/// The gyroscope: what is heavy, what rubs, and how it starts.
#[derive(Debug, Clone, Copy)]
pub struct Gyroscope {
    pub gimbals: Gimbals,
    pub bearings: Bearings,
    pub start: Pose,
}

impl Gyroscope {
    // ANCHOR: scene
    /// The gyroscope of the page, released at rest.
    pub fn new(p: &Parameters) -> Result<Self> {
        let rotor = SymmetricTop::from_mass(I1, I3, MASS, GRAVITY, LENGTH)?;
        let gimbals = Gimbals::new(rotor, [p.ring, p.ring, p.ring_along], p.fork)?;
        let spin = p.rpm * TAU / 60.0;
        let (density, viscosity) = (DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY);
        let bearings = Bearings {
            tilt: Bearing::new(p.tilt_viscous, p.tilt_dry)?,
            azimuth: Bearing::new(p.pivot_viscous, p.pivot_dry)?,
            axle: Bearing::new(0.0, p.axle_dry)?,
            air: Some(DiscDrag::new(RADIUS, density, viscosity, spin)?),
        };
        let start = gimbals.released(p.theta, spin);
        Self { gimbals, bearings, start }.dying()
    }

    /// Its motion until `until` (s) or to the stop at this tilt (rad).
    pub fn run(&self, stop: Option<f64>, until: f64, step: f64) -> Result<GimbalMotion> {
        let Self { gimbals, bearings, start } = *self;
        Ok(GimbalMotion::new(gimbals, bearings, start, stop, until, step)?)
    }
    // ANCHOR_END: scene

    /// The same gyroscope with other bearings.
    pub fn with(self, bearings: Bearings) -> Self {
        Self { bearings, ..self }
    }

    /// m g l sin theta of the release, N m.
    pub fn pull(&self) -> f64 {
        self.gimbals.weight_moment() * sin(self.start.theta)
    }

    /// m g l N/(L_z^2 sin^2 theta), small for a fast rotor: the dip over 2 sin theta.
    pub fn slowness(&self) -> f64 {
        let (theta, axial) = (self.start.theta, self.start.axial_momentum);
        let momentum = axial * sin(theta);
        self.gimbals.weight_moment() * self.gimbals.turning(theta) / (momentum * momentum)
    }

    /// The bottom of the valley at the release.
    pub fn bottom(&self) -> rotation_dynamics::Result<f64> {
        self.bottom_at(&self.start, 0.0)
    }

    /// Where the axis would precess steadily with the momenta it has there, if a torque `held`
    /// takes over a part of the weight's.
    pub fn bottom_at(&self, at: &Pose, held: f64) -> rotation_dynamics::Result<f64> {
        let (g, axial) = (&self.gimbals, at.axial_momentum);
        let vertical = g.vertical_momentum(at);
        let mut theta = at.theta;
        for _ in 0..60 {
            let rate = g.steady_rate(theta, axial, held)?;
            let there = g.turning(theta) * rate + axial * cos(theta);
            theta -= (vertical - there) / (axial * sin(theta));
        }
        Ok(theta)
    }

    /// Theory of friction at the bottom.
    pub fn fading(&self) -> rotation_dynamics::Result<Decay> {
        let axial = self.start.axial_momentum;
        Decay::of(&self.gimbals, &self.bearings, self.bottom()?, axial)
    }

    /// How long nods of this size (rad) last: until they are a fiftieth, or stick.
    pub fn lasting(&self, size: f64) -> Result<f64> {
        let (f, viscous) = (self.fading()?, 1.0 / self.fading()?.decay);
        let dry = f.shortening * f.frequency / PI;
        Ok(viscous * log(1.0 + (1.0 / viscous) * size / dry.max(0.02 * size / viscous)))
    }

    /// Itself, if friction takes its nods in a time that can be simulated.
    fn dying(self) -> Result<Self> {
        let (size, f) = (self.bottom()? - self.start.theta, self.fading()?);
        let nods = self.lasting(size)? * f.frequency / TAU;
        allowed! {
            "nods until friction has taken them": nods, from_to(0.0, 3000.0), "with less friction they take too long to simulate";
            "dry friction of the tilt bearing over m g l sin(theta)": self.bearings.tilt.dry() / self.pull(),
                between(-1.0, 0.5), "from 1 on the bearing holds the axis where it is";
        }?;
        Ok(self)
    }
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let (g, axial) = (&y.gimbals, y.start.axial_momentum);
    let nod = NutationCycle::of(g, &y.start)?;
    let [low, back] = measured::nod(&y, p.tolerance)?;
    let (dip, bottom) = (nod.theta_max - nod.theta_min, y.bottom()?);
    let (at, small) = measured::steady(&y)?;
    let steady = at.phi_rate;
    let bare = measured::bare(&y)?;
    let leading = g.weight_moment() / axial;
    let (smooth, heat) = measured::damped(&y, p.tolerance)?;
    let fallen = g.weight_moment() * (cos(p.theta) - cos(bottom));
    let walking = 0.5 * g.turning(bottom) * steady * steady;
    let (fading, slowness) = (y.fading()?, y.slowness());
    // The axis sinks, and that changes the nods as well.
    let sinks = slowness * p.pivot_viscous / g.turning(bottom);
    // Nods of a thousandth of a radian drown where it sinks nearly as fast as they swing.
    let sinking = p.pivot_viscous * steady / (axial * sin(bottom));
    let free = y.with(y.bearings.but(|bearings| bearings.tilt = Bearing::SMOOTH));
    let sag = free.fading()?.sag;
    // In the time of the measurement the axis has sunk, too.
    let part = 0.003 + 0.1 * slowness + 2.0 * sag.abs() / steady;
    let about = p.pivot_dry + p.pivot_viscous * steady + p.axle_dry;
    let noise = 1e3 * p.tolerance;
    claims! { report,
        /// time of one nod, gimbals and all
        nod: nod.period, "s", "simulated, located event" => back.t, within noise, in "One nod":
            bare => "the gimbals have to be moved as well",
            TAU * I3 / axial => "that is a turn of the spin";
        /// the same without gimbals
        bare_nod: bare, "s", "quadrature" => measured::nod_without_gimbals(&y)?.period, within 1e-13;
        /// how far the axis dips
        dip: dip, "rad", "simulated, located event" => low.state[0] - p.theta, within noise, in "One nod":
            0.5 * dip => "that is the middle of the nod",
            2.0 * g.weight_moment() * I1 * sin(p.theta) / (axial * axial) => "what walks around the vertical is more than I1 sin^2";
        /// mean rate of precession
        precession: nod.precession / nod.period, "rad/s", "simulated" => back.state[2] / back.t, within 1e2 * noise, in "One nod":
            leading * sin(p.theta) => "the torque has a factor sin(theta), and so has the momentum it turns";
        /// angular frequency of the smallest nods
        small: small, "rad/s", "simulated" => measured::smallest(&y)?, within 1e-8 * small, in "One nod";
        /// tilt that friction of the tilt bearing leaves
        smooth: bottom, "rad", "simulated, viscous" => smooth, within 1e-9 + noise, in "When the nods are over":
            p.theta => "it cannot precess at the height at which it was released",
            p.theta + dip => "that is the lowest point of the first nod";
        /// rate of the smooth precession there
        smooth_rate: steady, "rad/s", "simulated, a turn" => measured::walk(&y, p.tolerance)?, within noise,
        in "When the nods are over":
            leading * sin(bottom) => "the torque has a factor sin(theta), and so has the momentum it turns";
        /// heat of the nods over what the fall gives
        heat_share: (fallen - walking) / fallen, "-", "simulated heat" => heat / fallen, within 1e-7 + noise,
        in "When the nods are over":
            1.0 => "the precession has a share of it, too";
        /// rate at which viscous friction takes the nods
        decay: fading.decay, "1/s", "simulated swings" => measured::decay(&y, p.tolerance)?,
        within 1e-3 * fading.decay + 3.0 * sinks, if 30.0 * sinks < fading.decay && sinking < 1e-4 * small;
    }?;
    let count = measured::half_nods(&y, p.tolerance)?;
    let halves = f64::from(ledger::half_nods(&y));
    let end = measured::to_the_stop(&y, p)?;
    let [[t, spin], [t_slow, spin_slow]] = end.unwrap_or_default();
    claims! { report,
        /// half nods until dry friction holds the tilt
        half_nods: halves, "-", "simulated, counted" => count.unwrap_or_default(),
        within 0.4, judged 0.05, if count.is_some(), in "When the nods are over":
            2.0 * halves => "each half nod loses on both sides of the balance";
        /// sinking of the axis, at first
        sag: sag, "rad/s", "simulated without tilt friction" => measured::sinking(&y, free.bearings, p.tolerance)?,
        within part * about / (axial * sin(bottom)) + 1e-6, judged 0.02, in "The sag":
            -sag => "the pivot takes angular momentum about the vertical";
        /// time to the stop
        to_stop: t_slow, "s", "simulated, all of it" => t, within 0.2 + 2e-4 * t, judged 0.05, if end.is_some(), in "The sag";
        /// spin of the rotor when the ring meets its stop
        spin_left: spin_slow, "rad/s", "simulated, all of it" => spin, within 0.05 + 1e-3 * spin, if end.is_some();
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let (g, axial, rotor) = (&y.gimbals, y.start.axial_momentum, *y.gimbals.rotor());
    let with = |fork: f64| Gimbals::new(rotor, [0.0; 3], fork);
    let bare = measured::nod_without_gimbals(&y)?.period / measured::bare(&y)?;
    let walks = |fork: f64| with(fork)?.steady_rate(p.theta, axial, 0.0);
    let fast = y.start.but(|start| start.axial_momentum = 1e3 * axial);
    let (quick, fast) = (NutationCycle::of(g, &fast)?, fast.axial_momentum);
    let walk = quick.precession / quick.period * fast / g.weight_moment();
    let nods = TAU / quick.period / (fast * sin(p.theta));
    let fixed = with(1e18)?;
    let pendulum = Suspension { moment: I1, mass: MASS, gravity: GRAVITY, lever: LENGTH };
    let pendulum = Pendulum::new(pendulum, PI - p.theta, 0.0)?.period();
    let axle = Bearings { axle: Bearing::new(0.0, 0.1)?, ..Bearings::SMOOTH };
    let braked = y.with(axle).run(None, 0.5, p.tolerance)?.at(0.5)?;
    limits! { report,
        /// a top on a pivot, by elliptic functions
        "no gimbals: period over that of the heavy top": bare => 1.0, within 1e-13;
        /// at a constant rate its inertia asks for no torque
        "fork: steady precession over that without": walks(p.fork)? / walks(0.0)? => 1.0, within 1e-15;
        /// the spin alone carries the torque
        "fast rotor: mean precession over m g l/L_z": walk => 1.0, within 1e-5;
        /// tilt and azimuth exchange one angular momentum
        "fast rotor: nods over L_z sin/sqrt(P N)":
            nods * (g.tilting() * g.turning(p.theta)).sqrt() => 1.0, within 1e-5;
        /// what cannot turn about the vertical is a pendulum
        "fork of any mass: period over a pendulum's": NutationCycle::of(&fixed, &y.start)?.period / pendulum => 1.0, within 1e-13;
        /// rotor and ring act on each other
        "axle braked: (change of L_Z)/L_z":
            (g.vertical_momentum(&braked) - g.vertical_momentum(&y.start)) / axial => 0.0, within 1e3 * p.tolerance;
    }
}

/// The accuracy strip: one nod without friction.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let y = Gyroscope::new(p)?;
    let nod = NutationCycle::of(&y.gimbals, &y.start)?;
    let asked = [p.tolerance, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
    let (gimbals, start) = (y.gimbals, y.start);
    let period = move |_| Ok(NutationCycle::of(&gimbals, &start)?.period);
    report.set_closed_form(ClosedForm::new(period));
    let back = move |step: f64| {
        Dop853::new(step)?.zero(&y.gimbals, y.start.to_array(), 2, 3.0 * nod.period, |y| y[1])
    };
    report.dial_of_return(asked, back, nod.period, p.theta)
}

example! {
    effects_1_gyroscope: "The damped nutation of a real gyroscope: gimbals, bearings, to the stop";
    "The damped nutation of a real gyroscope", "A rotor in a ring and a fork that have inertia, with friction in all bearings.",
    [claims, limits, ledger::ledger, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
