//! Friction in the three bearings of a gyroscope in gimbals.

use super::{Gimbals, Pose};
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::error::{Result, not_negative};
use rotation_dynamics::math::{cos, sincos};
use rotation_dynamics::planar::{Condition, Next, Phased};

/// Friction of one bearing: the torque -c q' - tau sign(q') against its rate q', and, at
/// rest, whatever is needed up to tau.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    viscous: f64,
    dry: f64,
}

impl Bearing {
    /// A bearing without friction.
    pub const SMOOTH: Self = Self { viscous: 0.0, dry: 0.0 };

    /// A bearing with this viscous coefficient c (N m s) and dry torque tau (N m).
    ///
    /// # Errors
    /// One that is negative or not finite.
    pub fn new(viscous: f64, dry: f64) -> Result<Self> {
        Ok(Self {
            viscous: not_negative("viscous coefficient of a bearing", viscous)?,
            dry: not_negative("dry torque of a bearing", dry)?,
        })
    }

    /// The viscous coefficient c, N m s.
    pub const fn viscous(&self) -> f64 {
        self.viscous
    }

    /// The dry torque tau, N m.
    pub const fn dry(&self) -> f64 {
        self.dry
    }
}

/// The bearings of a gyroscope in gimbals, and the air about its rotor.
///
/// The two parts that each acts between decide its effect. Friction of the axle is between rotor
/// and ring: it changes L_z and, since ring and fork take its reaction, leaves L_Z alone. The air
/// is outside: it takes L_z and with it L_z cos theta of L_Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearings {
    /// Between ring and fork, about the line of nodes.
    pub tilt: Bearing,
    /// Between fork and base, about the vertical.
    pub azimuth: Bearing,
    /// Between rotor and ring, about the axle.
    pub axle: Bearing,
    /// Drag of the air on the rotor.
    pub air: Option<DiscDrag>,
}

impl Bearings {
    /// No friction anywhere.
    pub const SMOOTH: Self =
        Self { tilt: Bearing::SMOOTH, azimuth: Bearing::SMOOTH, axle: Bearing::SMOOTH, air: None };

    const fn all(&self) -> [Bearing; 3] {
        [self.tilt, self.azimuth, self.axle]
    }
}

/// The state of a bearing with dry friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// It holds: its rate is zero.
    Sticks,
    /// Its angle grows.
    Forward,
    /// Its angle falls.
    Back,
}

impl Hold {
    const fn sense(self) -> f64 {
        match self {
            Self::Sticks => 0.0,
            Self::Forward => 1.0,
            Self::Back => -1.0,
        }
    }

    const fn of(rate: f64) -> Self {
        if rate < 0.0 { Self::Back } else { Self::Forward }
    }
}

/// The states of the bearings of tilt, azimuth and axle.
pub type Holds = [Hold; 3];

const STOPS: [&str; 3] = ["tilt stops", "azimuth stops", "axle stops"];
const SLIPS: [&str; 3] = ["tilt slips", "azimuth slips", "axle slips"];
/// The end of the scene: the ring meets the fork.
pub(super) const STOP: &str = "stop";

/// Numbers of a state: a pose, then the heat of the three bearings and the work of the air, J.
pub(super) const N: usize = 10;

pub(super) fn pose(y: &[f64; N]) -> Pose {
    let [theta, theta_rate, phi, phi_rate, zeta, axial_momentum, ..] = *y;
    Pose::from_array([theta, theta_rate, phi, phi_rate, zeta, axial_momentum])
}

/// Gimbals, their bearings, and the tilt at which the ring meets its stop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rubbing {
    pub(super) gimbals: Gimbals,
    pub(super) bearings: Bearings,
    pub(super) stop: f64,
}

/// Accelerations and torques at one state.
struct Moved {
    /// theta'', phi'', L_z'.
    rates: [f64; 3],
    /// The torques of the three bearings, on tilt, azimuth and rotor, N m.
    torques: [f64; 3],
    /// The torque of the air on the rotor, N m.
    air: f64,
}

impl Rubbing {
    /// The rates theta', phi', zeta' of the bearings.
    fn bearing_rates(&self, at: &Pose) -> [f64; 3] {
        [at.theta_rate, at.phi_rate, self.gimbals.spin_in_ring(at)]
    }

    /// P theta'' = F + M_theta, N phi'' = G + M_phi - M_zeta cos theta, L_z' = M_zeta + air,
    /// with the torque of a bearing that sticks such that its rate stays zero.
    fn moved(&self, holds: Holds, at: &Pose) -> Moved {
        let g = &self.gimbals;
        let (s, c) = sincos(at.theta);
        let ([force, walk], i3) = (g.driven(at), g.rotor().i3());
        let (p, n) = (g.tilting(), g.turning(at.theta));
        let spin = at.axial_momentum / i3;
        let air = self.bearings.air.map_or(0.0, |air| air.axial_torque(spin));
        let rates = self.bearing_rates(at);
        let all = self.bearings.all();
        let mut torques: [f64; 3] =
            core::array::from_fn(|i| -all[i].viscous * rates[i] - all[i].dry * holds[i].sense());
        let stuck = holds.map(|hold| hold == Hold::Sticks);
        let tilt = if stuck[0] {
            torques[0] = -force;
            0.0
        } else {
            (force + torques[0]) / p
        };
        // zeta'' = L_z'/I3 - phi'' cos theta + phi' theta' sin theta.
        let turned = at.phi_rate * at.theta_rate * s;
        let azimuth = match (stuck[1], stuck[2]) {
            (true, locked) => {
                if locked {
                    torques[2] = -i3 * turned - air;
                }
                torques[1] = torques[2] * c - walk;
                0.0
            }
            (false, true) => {
                let rate = (walk + torques[1] + c * (i3 * turned + air)) / (n + i3 * c * c);
                torques[2] = i3 * (rate * c - turned) - air;
                rate
            }
            (false, false) => (walk + torques[1] - torques[2] * c) / n,
        };
        Moved { rates: [tilt, azimuth, torques[2] + air], torques, air }
    }

    /// The states of the bearings from this state on, and the state with the rates of those in
    /// `still` at zero; the others go on as `holds` says.
    ///
    /// The friction torques of bearings at rest and their accelerations are the one solution
    /// of Coulomb's law, since the mass matrix is positive definite: found by trying all.
    pub(super) fn decide(&self, holds: Holds, still: [bool; 3], y: &[f64; N]) -> (Holds, [f64; N]) {
        let mut y = *y;
        for (i, at) in [(0, 1), (1, 3)] {
            if still[i] {
                y[at] = 0.0;
            }
        }
        let g = &self.gimbals;
        if still[2] {
            y[5] = g.rotor().i3() * y[3] * cos(y[0]);
        }
        let at = pose(&y);
        let inertia = [g.tilting(), g.turning(at.theta), g.rotor().i3()];
        let all = self.bearings.all();
        let mut best = (f64::INFINITY, holds);
        for trial in 0..27 {
            let choice = [trial % 3, trial / 3 % 3, trial / 9];
            if (0..3).any(|i| !still[i] && choice[i] != 0) {
                continue;
            }
            let mut tried = holds;
            for i in 0..3 {
                if still[i] {
                    tried[i] = [Hold::Sticks, Hold::Forward, Hold::Back][choice[i]];
                }
            }
            let moved = self.moved(tried, &at);
            let (s, c) = sincos(at.theta);
            let [tilt, azimuth, axial] = moved.rates;
            let spin = axial / inertia[2] - azimuth * c + at.phi_rate * at.theta_rate * s;
            let gained = [tilt, azimuth, spin];
            // By how much, as a torque, Coulomb's law is broken.
            let broken = (0..3).filter(|i| still[*i]).map(|i| match tried[i] {
                Hold::Sticks => moved.torques[i].abs() - all[i].dry,
                slips => -gained[i] * slips.sense() * inertia[i],
            });
            let worst = broken.fold(0.0, f64::max);
            if worst < best.0 {
                best = (worst, tried);
            }
        }
        (best.1, y)
    }

    /// The states of the bearings at the start.
    pub(super) fn at_start(&self, y: &[f64; N]) -> (Holds, [f64; N]) {
        let rates = self.bearing_rates(&pose(y));
        let all = self.bearings.all();
        let still = core::array::from_fn(|i| rates[i] == 0.0 && all[i].dry > 0.0);
        self.decide(rates.map(Hold::of), still, y)
    }
}

impl Phased<N> for Rubbing {
    type Phase = Holds;

    fn derivative(&self, holds: Holds, y: &[f64; N]) -> [f64; N] {
        let at = pose(y);
        let moved = self.moved(holds, &at);
        let [tilt, azimuth, axial] = moved.rates;
        let rates = self.bearing_rates(&at);
        let heat: [f64; 3] = core::array::from_fn(|i| -moved.torques[i] * rates[i]);
        let work = -moved.air * at.axial_momentum / self.gimbals.rotor().i3();
        let [a, b, c] = heat;
        [at.theta_rate, tilt, at.phi_rate, azimuth, rates[2], axial, a, b, c, work]
    }

    fn conditions(&self, holds: Holds) -> Vec<Condition<'_, Holds, N>> {
        let mut all = Vec::new();
        if self.stop.is_finite() {
            all.push(Condition::gap(STOP, |y| self.stop - y[0], Next::End));
        }
        for i in 0..3 {
            let dry = self.bearings.all()[i].dry;
            if dry == 0.0 {
                continue;
            }
            if holds[i] == Hold::Sticks {
                for slips in [Hold::Forward, Hold::Back] {
                    let mut after = holds;
                    after[i] = slips;
                    // Friction at its greatest against the coming slip.
                    let left = move |y: &[f64; N]| {
                        dry + slips.sense() * self.moved(holds, &pose(y)).torques[i]
                    };
                    all.push(Condition::opening_gap(SLIPS[i], left, Next::Enter(after)));
                }
            } else {
                let rate = move |y: &[f64; N]| holds[i].sense() * self.bearing_rates(&pose(y))[i];
                let decide = move |_t: f64, y: &[f64; N]| {
                    let mut still = holds.map(|hold| hold == Hold::Sticks);
                    still[i] = true;
                    Ok(self.decide(holds, still, y))
                };
                all.push(Condition::opening_gap(STOPS[i], rate, Next::decide(decide)));
            }
        }
        all
    }

    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        let [a, b, c, d, e, f] = self.gimbals.sizes(&pose(y).to_array());
        let weight = self.gimbals.weight_moment().abs().max(1e-300);
        let spin = y[5].abs() * y[5].abs() / self.gimbals.rotor().i3();
        let spin = spin.max(weight);
        [a, b, c, d, e, f, weight, weight, spin, spin]
    }
}
