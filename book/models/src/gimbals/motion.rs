//! A motion of a gyroscope in gimbals with friction, through all stops of its bearings.

use super::bearings::{N, Rubbing, STOP, pose};
use super::{Bearings, Gimbals, Holds, Pose};
use core::f64::consts::TAU;
use rotation_dynamics::error::{Error, Result, finite};
use rotation_dynamics::integrators::{Dop853, Work};
use rotation_dynamics::planar::{Run, simulate};

/// A nod has at least so many steps while it is alive, so that no reversal of a bearing hides.
const STEPS: f64 = 32.0;
/// Nods solved in one piece.
const NODS: f64 = 40.0;
/// The nods are over where their rates are below this part of the precession's.
const OVER: f64 = 0.02;

/// A change in what the bearings do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// The event: `"tilt stops"`, `"tilt slips"`, the same of azimuth and axle, `"stop"`.
    pub name: &'static str,
    /// When, s.
    pub t: f64,
    /// Where.
    pub pose: Pose,
    /// The states of the bearings after it.
    pub to: Option<Holds>,
}

/// A motion with friction, known at any time until it ends.
///
/// A bearing with dry friction stops where its rate goes through zero. There it sticks or slips on
/// or back, as Coulomb's law has it, and slips again where more torque would be needed to hold it
/// than it has. All of these are events located by real steps, and between two of them the
/// equations are smooth. The two gimbal bearings stop in each nod.
///
/// While the axis nods, a step is at most a thirty-second part of a nod: with eight looks a
/// step, a reversal that is over within a 256th part of a nod may be missed. None was, in ten
/// motions with stops of all three bearings: the changes are the same at errors of a step of
/// 1e-8 and 1e-13, within 4e-13 s.
///
/// Accuracy, as measured: the energy lost is the heat within 1.3e-13 m g l at an error of a step
/// of 1e-12.
///
/// ```
/// use rotation_dynamics::exact::heavy_top::SymmetricTop;
/// use models::gimbals::{Bearing, Bearings, GimbalMotion, Gimbals};
/// # fn main() -> rotation_dynamics::Result<()> {
/// let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?;
/// let gimbals = Gimbals::new(rotor, [1.5e-4, 1.5e-4, 2e-5], 2e-4)?;
/// let bearings = Bearings { tilt: Bearing::new(0.0, 0.01)?, ..Bearings::SMOOTH };
/// let start = gimbals.released(1.0, 314.0);
/// let course = GimbalMotion::new(gimbals, bearings, start, None, 2.0, 1e-10)?;
/// // Dry friction stops the nods altogether; the precession goes on.
/// let end = course.at(2.0)?;
/// assert_eq!(end.theta_rate, 0.0);
/// assert!(end.phi_rate > 1.5);
/// // What the axis has lost is heat of the bearing.
/// let lost = gimbals.axis_energy(&start) - gimbals.axis_energy(&end);
/// assert!((lost - course.heat(2.0)?[0]).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct GimbalMotion {
    pieces: Vec<(f64, Run<Holds, N>)>,
    changes: Vec<Change>,
    end: f64,
    work: Work,
}

impl GimbalMotion {
    /// The motion from `start` at t = 0 until `until` (s), or until the tilt reaches `stop`
    /// (rad), with this error of a step of DOP853.
    ///
    /// Memory: some 100 numbers a step, 32 steps a nod while the axis nods and two beyond.
    ///
    /// # Errors
    /// A start that is not finite or beyond the stop; the errors of [`simulate`].
    pub fn new(
        gimbals: Gimbals,
        bearings: Bearings,
        start: Pose,
        stop: Option<f64>,
        until: f64,
        tolerance: f64,
    ) -> Result<Self> {
        start.check()?;
        finite("end time", until)?;
        let stop = stop.unwrap_or(f64::INFINITY);
        let scene = Rubbing { gimbals, bearings, stop };
        if start.theta >= stop {
            return Err(Error::out_of_range(
                "theta",
                start.theta,
                "less than the tilt at the stop",
            ));
        }
        let method = Dop853::new(tolerance)?;
        let mut state = [0.0; N];
        state[..6].copy_from_slice(&start.to_array());
        let (mut phase, first) = scene.at_start(&state);
        state = first;
        let mut course =
            Self { pieces: Vec::new(), changes: Vec::new(), end: 0.0, work: Work::default() };
        while course.end < until {
            let t = course.end;
            let (nod, alive) = nodding(&gimbals, &pose(&state));
            let step = if alive { nod / STEPS } else { 0.5 * nod };
            let method = method.with_longest_step(step)?;
            let span = (NODS * nod).min(until - t);
            let run = simulate(&scene, &method, phase, state, span)?;
            course.work += run.work();
            course.end = t + run.end_time();
            let changes = run.transitions().iter().map(|change| Change {
                name: change.name,
                t: t + change.t,
                pose: pose(&change.before),
                to: change.to,
            });
            course.changes.extend(changes);
            let (Some(last), Some(end)) = (run.pieces().last(), run.end_state()) else {
                break;
            };
            (phase, state) = (last.phase, *end);
            // A change at the very end of a piece.
            if let Some(change) = run.transitions().last()
                && change.t >= run.end_time()
            {
                match change.to {
                    Some(to) => (phase, state) = (to, change.after),
                    None => {
                        course.pieces.push((t, run));
                        break;
                    }
                }
            }
            if until - course.end < 1e-12 * until {
                course.end = until;
            }
            course.pieces.push((t, run));
        }
        Ok(course)
    }

    /// When it ends, s.
    pub const fn end_time(&self) -> f64 {
        self.end
    }

    /// Whether the tilt has reached the stop.
    pub fn stopped(&self) -> bool {
        self.changes.last().is_some_and(|c| c.name == STOP)
    }

    /// All changes in what the bearings do, in order.
    pub fn changes(&self) -> &[Change] {
        &self.changes
    }

    /// Its cost.
    pub const fn work(&self) -> Work {
        self.work
    }

    fn state(&self, t: f64) -> Result<(Holds, [f64; N])> {
        let (start, end) = (0.0, self.end);
        if !(start..=end).contains(&t) {
            return Err(Error::OutsideRun { t, start, end });
        }
        let next = self.pieces.partition_point(|(from, _)| *from <= t);
        let outside = Error::OutsideRun { t, start, end };
        let (from, run) = self.pieces.get(next.saturating_sub(1)).ok_or(outside)?;
        run.at((t - from).min(run.end_time()))
    }

    /// The pose at `t` (s).
    ///
    /// # Errors
    /// [`Error::OutsideRun`].
    pub fn at(&self, t: f64) -> Result<Pose> {
        Ok(pose(&self.state(t)?.1))
    }

    /// The states of the bearings at `t`; at a change, before it.
    ///
    /// # Errors
    /// [`Error::OutsideRun`].
    pub fn holds(&self, t: f64) -> Result<Holds> {
        Ok(self.state(t)?.0)
    }

    /// The times (s) and poses in which the tilt turns back, in order.
    pub fn turning_points(&self) -> Vec<(f64, Pose)> {
        let mut found = Vec::new();
        for (start, run) in &self.pieces {
            for (i, piece) in run.pieces().iter().enumerate() {
                let mut from = piece.solution.start_time();
                for to in piece.solution.step_times() {
                    for k in 0..8 {
                        let part = |k: u32| from + (to - from) * f64::from(k) / 8.0;
                        let rate = |t: f64| piece.solution.at(t).map_or(f64::NAN, |y| y[1]);
                        if let Some(t) = crossing(rate, [part(k), part(k + 1)])
                            && let Ok(y) = piece.solution.at(t)
                        {
                            found.push((start + t, pose(&y)));
                        }
                    }
                    from = to;
                }
                // A dry bearing stops there, by a rate that round-off leaves on either side.
                let next = run.pieces().get(i + 1).map(|next| next.solution.start_state());
                let last = piece.solution.end_state();
                if next.is_some_and(|y| y[1] == 0.0)
                    && last[1] != 0.0
                    && found.last().is_none_or(|(t, _)| *t < start + from)
                {
                    found.push((start + from, pose(last)));
                }
            }
        }
        found
    }

    /// The heat made until `t` in the bearings of tilt, azimuth and axle, and by the air, J.
    ///
    /// # Errors
    /// [`Error::OutsideRun`].
    pub fn heat(&self, t: f64) -> Result<[f64; 4]> {
        let [.., a, b, c, d] = self.state(t)?.1;
        Ok([a, b, c, d])
    }
}

/// The time of a nod, and whether the axis nods.
fn nodding(gimbals: &Gimbals, at: &Pose) -> (f64, bool) {
    let sizes = gimbals.sizes(&at.to_array());
    let Ok(rate) = gimbals.steady_rate(at.theta, at.axial_momentum, 0.0) else {
        // No steady precession: the axis falls.
        return (TAU / sizes[1], true);
    };
    let nods = gimbals.nodding(at.theta, at.axial_momentum, rate);
    let nod = if nods > 0.0 { TAU / nods } else { TAU / sizes[1] };
    let inertia = (gimbals.turning(at.theta) / gimbals.tilting()).sqrt();
    let nodding = at.theta_rate.abs().max((at.phi_rate - rate).abs() * inertia);
    (nod, nodding > OVER * rate.abs())
}

/// The place in `[a, b]` at which `f` changes its sign, by bisection; `b` if it is zero there.
fn crossing(f: impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2]) -> Option<f64> {
    let (at_a, at_b) = (f(a), f(b));
    if at_a == 0.0 || at_a * at_b > 0.0 || !(at_a * at_b).is_finite() {
        return None;
    }
    loop {
        let middle = 0.5 * (a + b);
        if middle == a || middle == b {
            return Some(b);
        }
        if f(middle) * at_a > 0.0 {
            a = middle;
        } else {
            b = middle;
        }
    }
}
