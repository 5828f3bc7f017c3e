//! Torque-free motion with two equal moments: two steady rotations. A steady rotation
//! is the first of them alone.

use super::norm3;
use super::sample::{Columns, combined, placed};
use crate::attitude::Attitude;
use crate::attitude::product::product;
use crate::exact::batch::{Branchless, Sampled};
use crate::math::lane::{Constant, Gathered, Pair, Phased, Row, WIDEST};
use crate::math::{Clock, DoubleDouble as Dd, Reduced, Time, sincos_of};

/// R(t) = exp(t L/I1) R0 exp(t Omega_S e), notes 15.5 (9), (10).
#[derive(Debug, Clone, Copy)]
pub(super) struct Symmetric<V = f64> {
    /// Omega_P = L/I1 (rad/s).
    pub(super) precession_rate: V,
    /// The rate at which the transverse rate turns in the body, -Omega_S.
    pub(super) body_rate: V,
    /// Half of either angle, in quarter turns.
    clocks: Clock<[V; 2]>,
    /// The contributions of cos cos, sin cos, cos sin and sin sin of the half angles to the
    /// quaternion, the precession's first.
    columns: Columns<V>,
    /// The rates on three axes, the body's own the last; and the place of each axis there.
    omega: [V; 3],
    pub(super) place: [usize; 3],
    /// The greatest |t|.
    until: f64,
}

impl Symmetric {
    /// Two equal moments, the third about `axis`.
    pub(super) fn new(moments: [f64; 3], omega: [f64; 3], axis: usize, attitude: Attitude) -> Self {
        let transverse = moments[(axis + 1) % 3];
        let spin = Dd::sum(transverse, -moments[axis]) * omega[axis] / transverse;
        let precession = [0, 1, 2].map(|i| Dd::product(moments[i], omega[i]) / transverse);
        Self::turning(precession, spin, omega, axis, attitude)
    }

    /// A rotation that stays as it is.
    pub(super) fn steady(omega: [f64; 3], attitude: Attitude) -> Self {
        Self::turning(omega.map(Dd::from), Dd::ZERO, omega, 2, attitude)
    }

    /// L/I1 on the body axes at t = 0, and Omega_S = (1 - I3/I1) w3, at which the body
    /// turns about its axis.
    fn turning(
        precession: [Dd; 3],
        spin: Dd,
        omega: [f64; 3],
        axis: usize,
        attitude: Attitude,
    ) -> Self {
        let rate = norm3(precession);
        let direction =
            if rate == 0.0 { [0.0; 3] } else { precession.map(|c| (c / rate).to_f64()) };
        // exp(t L/I1) acts in space; moved to the right of R0 it acts on body components.
        let start = attitude.quaternion();
        let about_momentum = product(start, [0.0, direction[0], direction[1], direction[2]]);
        let mut own = [0.0; 4];
        own[1 + axis] = 1.0;
        let columns = [start, about_momentum, product(start, own), product(about_momentum, own)];
        let clocks = [rate, spin].map(|rate| Clock::new(rate / Dd::PI, Dd::ZERO));
        Self {
            precession_rate: rate.to_f64(),
            body_rate: -spin.to_f64(),
            until: clocks[0].until().min(clocks[1].until()),
            clocks: clocks[0].beside(&clocks[1]),
            columns: columns.map(|[w, x, y, z]| [[w, x], [y, z]]),
            omega: [1, 2, 3].map(|beyond| omega[(axis + beyond) % 3]),
            place: [0, 1, 2].map(|i| (i + 2 - axis) % 3),
        }
    }
}

impl<V: Constant> Symmetric<V> {
    /// The unit quaternion and the body rates.
    #[inline(always)]
    fn sample<L: Phased>(&self, clocks: Reduced<L::Pair>, first: usize) -> ([L; 4], [L; 3]) {
        let (sin, cos) = sincos_of(clocks);
        let (one, other) = (sin * sin + cos * cos).parts();
        let ((sin_p, sin_s), (cos_p, cos_s)) = (sin.parts(), cos.parts());
        let scale = L::of(1.0) / (one * other).sqrt();
        let (sin_p, cos_p) = (sin_p * scale, cos_p * scale);
        let parts = [cos_p * cos_s, sin_p * cos_s, cos_p * sin_s, sin_p * sin_s];
        let quaternion = combined(&self.columns, parts, first);
        // The transverse rate turns by the whole angle, the other way.
        let sin = sin_s * cos_s * 2.0;
        let cos = L::of(1.0) - sin_s * sin_s * 2.0;
        let [p, q, r] = &self.omega;
        let (p, q) = (p.lane::<L>(first), q.lane::<L>(first));
        (quaternion, placed(self.place, [cos * p + sin * q, cos * q - sin * p, r.lane(first)]))
    }
}

impl<V: Constant> Branchless<V> for Symmetric<V> {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]) {
        self.sample(self.clocks.both_at(&Time::new(t), first), first)
    }
}

impl Sampled for Symmetric {}

/// The rates of several bodies are left on the three axes with the own one the last.
impl Gathered for Symmetric {
    type Rows = Symmetric<Row>;
    fn gathered(each: [Self; WIDEST]) -> Symmetric<Row> {
        Symmetric {
            precession_rate: each.map(|of| of.precession_rate),
            body_rate: each.map(|of| of.body_rate),
            clocks: Gathered::gathered(each.map(|of| of.clocks)),
            columns: Gathered::gathered(each.map(|of| of.columns)),
            omega: Gathered::gathered(each.map(|of| of.omega)),
            place: [0, 1, 2],
            until: each.iter().fold(f64::INFINITY, |until, of| until.min(of.until)),
        }
    }
}
