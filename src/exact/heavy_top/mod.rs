//! The heavy symmetric top in closed form: angles, attitude and rates at any time,
//! without stepping.
//!
//! The equations are the notes' (16.2 (4)-(6)). With u = cos(theta) the energy is
//! u'^2 = a cubic in u, so u is an elliptic function of time; the Cayley-Klein
//! parameters
//!
//!   alpha = cos(theta/2) e^{i(phi+zeta)/2},  beta = sin(theta/2) e^{i(phi-zeta)/2}
//!
//! are single quotients of theta functions, regular where the axis passes a pole. No
//! third-kind integral is formed and no regime needs its own formula, except a motion
//! that stays where it is. The set-up is done in double-double arithmetic: a sample
//! is as good as its time. Its cost does not depend on the time.
//!
//! | file | what it holds |
//! |---|---|
//! | `reduced` | the parameters a, b, c and the effective potential |
//! | `body` | the dimensional body |
//! | `roots` | the turning points and the gaps between the roots |
//! | `series`, `waves`, `ripples` | the theta functions: evaluation and set-up |
//! | `motion` | the phases in time |
//! | `sample`, `hyperbolic`, `rates` | attitude and rates without a branch, in either form, and the set-up of the rates |
//! | `batch`, `tops` | many times at once, many tops at one time |
//! | `asked` | the top as a [`Motion`](crate::motion::Motion), its condition |
//! | `queries`, `whole` | what can be asked at a time and of the motion as a whole |
//!
//! Not for: tops with friction or with three different moments; see
//! [`crate::integrators`].
//!
//! How it is derived, and which form loses no digit: `book/src/how_heavy_top.md`.
//!
//! Sources: the notes, 16.2; F. Klein, A. Sommerfeld, *Theorie des Kreisels*, VI;
//! E. T. Whittaker, *Analytical Dynamics*, 71-72. The forms without cancellation are
//! ours.

mod as_motion;
mod batch;
mod body;
mod construct;
mod hyperbolic;
mod motion;
mod queries;
mod rates;
mod reduced;
mod ripples;
mod roots;
mod sample;
mod series;
mod tops;
mod waves;
mod whole;

pub use body::SymmetricTop;
pub use reduced::ReducedTop;
pub use tops::HeavyTops;
pub use whole::Regime;

use crate::frame::BodyVector;
use crate::math::DoubleDouble as Dd;
use hyperbolic::Late;
use motion::Motion;
use sample::Sampler;

/// A turning point at which the motion starts, at rest in theta.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// The smaller angle from the upward vertical.
    ThetaMin,
    /// The larger angle.
    ThetaMax,
}

/// A motion of a heavy symmetric top, at any time.
///
/// Time is the notes' t' for a motion made from a [`ReducedTop`], seconds for one made
/// from a [`SymmetricTop`]; [how late](crate::exact#how-late) it may be.
///
/// ```
/// use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
/// let top = ReducedTop::new(2.0, 1.2, 0.2)?;
/// let motion = HeavyTop::from_energy(top, 0.55, Start::ThetaMin, 0.0, 0.0)?;
/// assert!((motion.nutation_period() - 3.870_867_767).abs() < 1e-9);
/// let late = motion.angles(1e6 * motion.nutation_period());
/// assert!((late.theta - motion.theta_min()).abs() < 1e-6);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// Accuracy, measured against 90-digit values in 400 cases: every angle, rate and matrix element is
/// within K eps (|value| + condition). The condition is the change per relative change of the
/// inputs and per radian of the initial angles; K has median 0.73 and maximum 2.5. The cases are
/// fast and needle-shaped tops, |b| within 1e-15 of 1, energies within 1e-15 of U_min and of the
/// cusps, 1 - m down to 1e-30, poles passed and started from, gravity down to c = 1e-60, and times
/// up to 1e6 periods. Turning points, period, m and U_min are within 2 eps of themselves, m within
/// 8 eps where it is below 1e-16; an advance of phi per period within 1 eps or 1e-31 rad. With
/// inputs and time taken as the doubles that they are, the attitude stays within 6.3 eps rad up to
/// 1e12 periods (`tests/exact/late.rs`).
///
/// Cost: about 85 sine-cosine pairs of `libm` for the set-up, 120 for m > 0.8, where the processor
/// has a fused multiplication, half as much again where not. Attitude and angular velocity cost
/// 2.1, whatever the time, and in a batch ([`HeavyTop::kinematics_at`]) 0.5 with AVX-512 and 0.6
/// with AVX2; for m > 0.8 2.5 to 2.7, 0.6 and 0.9. Many tops at one time: [`HeavyTops`].
/// (`benches`, binary `batch`.)
#[derive(Debug, Clone)]
pub struct HeavyTop {
    phi0: f64,
    zeta0: f64,
    /// +1, or -1 if gravity pulls towards theta = 0.
    flip: f64,
    /// B = L_z/I1, A - B and A + B.
    spin: Dd,
    difference: Dd,
    sum: Dd,
    /// omega_3.
    omega3: Dd,
    /// omega_3 - B, the spin that drops out of the motion of the axis.
    free_spin: Dd,
    /// alpha - beta in u: 2 E~ in the reduced top's units.
    excess: Dd,
    moments: [f64; 2],
    reduced: Option<ReducedTop>,
    body: Option<SymmetricTop>,
    given: Given,
    course: Course,
    /// The greatest |t| at which the phases are known.
    latest: f64,
}

/// The inputs it was made from, beside phi0 and zeta0: its condition changes them.
#[derive(Debug, Clone, Copy)]
enum Given {
    Energy {
        top: ReducedTop,
        energy: f64,
        start: Start,
    },
    Angles {
        top: ReducedTop,
        theta0: f64,
        theta_rate0: f64,
    },
    /// The attitude is taken at t = 0.
    Body {
        body: SymmetricTop,
        omega_body: BodyVector,
    },
}

/// The motion of the axis.
#[derive(Debug, Clone)]
enum Course {
    /// The axis stays at this angle; the body spins about it.
    Fixed { theta: f64 },
    /// The axis moves between turning points.
    Moving {
        motion: Box<Motion>,
        /// Turns of alpha and beta: rate, lag per half-period, start.
        turns: [Turns; 2],
        form: Form,
    },
}

/// A phase in turns: `start + rate t - lag n`.
#[derive(Debug, Clone, Copy)]
struct Turns {
    rate: Dd,
    lag: Dd,
    start: Dd,
}

/// In which form the theta functions converge fast.
#[derive(Debug, Clone)]
enum Form {
    Trigonometric(Box<Sampler>),
    Hyperbolic(Box<Late>),
}
