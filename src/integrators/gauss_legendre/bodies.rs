//! The variables of the method for a body under effects: any scene, symmetric bodies without their
//! spin, and any body on its own axes.

use super::free_rotation::{inverse_moments, rates, rates_of};
use super::{GaussLegendre, StageOde};
use crate::attitude::Attitude;
use crate::attitude::product::vector_times;
use crate::body::State;
use crate::effects::Effect;
use crate::effects::erased::AnyEffect;
use crate::error::Result;
use crate::frame::{BodyVector, SpaceVector};
use crate::integrators::compensated::Compensated;
use crate::integrators::ode::check_span;
use crate::integrators::scene::{components, state};
use crate::integrators::spin_free::axis_only;
use crate::integrators::{Integrator, Ode, SpinFree, Work, advance_by_counting};
use crate::math::lane::WIDEST;
use crate::math::{DoubleDouble, Lane};
use crate::scene::Scene;

impl<E: AnyEffect + ?Sized, const STEADY: bool> Integrator<Scene<E>, State>
    for GaussLegendre<STEADY>
{
    advance_by_counting!(Scene<E>, State);

    fn advance_counting(
        &self,
        scene: &Scene<E>,
        t: f64,
        start: &State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<State> {
        self.advance_counting(&SideBySide::new(scene, true), t, start, t_end, work)
    }
}

/// A scene in the variables of its [`Ode`], all but the torque on lanes.
pub(crate) struct SideBySide<'s, E: ?Sized> {
    scene: &'s Scene<E>,
    inverse: [[f64; 2]; 3],
    slips: bool,
}

impl<'s, E: AnyEffect + ?Sized> SideBySide<'s, E> {
    /// The scene; of effects that may slip, whether they do.
    pub(crate) fn new(scene: &'s Scene<E>, slips: bool) -> Self {
        Self { scene, inverse: inverse_moments(scene.body()), slips }
    }
}

impl<'s, E: AnyEffect + ?Sized, const STEADY: bool> Integrator<SideBySide<'s, E>, State>
    for GaussLegendre<STEADY>
{
    advance_by_counting!(SideBySide<'s, E>, State);

    fn advance_counting(
        &self,
        scene: &SideBySide<'s, E>,
        t: f64,
        start: &State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<State> {
        let start = components(start);
        check_span(t, &start, t_end)?;
        if t == t_end {
            return state(&start);
        }
        let end = self.run(scene, t, Compensated::new(start), t_end, &mut (), work)?;
        state(&end)
    }
}

impl<E: AnyEffect + ?Sized> StageOde<7> for SideBySide<'_, E> {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, t: L, &[w, x, y, z, lx, ly, lz]: &[L; 7]) -> [L; 7] {
        let square = (w * w + x * x) + (y * y + z * z);
        let by = L::of(1.0) / square.sqrt();
        let unit = [w * by, x * by, y * by, z * by];
        let torque = |t, state: &State| self.scene.torque(t, state);
        let [a, b, c] = one_by_one(t, unit, [lx, ly, lz], torque);
        let l = turned_back(unit, [lx, ly, lz]);
        let [mut p, mut q, mut r] = rates_of(&self.inverse, l);
        if self.scene.effects().properties().slips && self.slips {
            let slip = |t, state: &State| self.scene.effects().slip(t, self.scene.body(), state);
            let slip = turned_back(unit, one_by_one(t, unit, [lx, ly, lz], slip));
            (p, q, r) = (p + slip[0], q + slip[1], r + slip[2]);
        }
        let (p, q, r) = (p * 0.5, q * 0.5, r * 0.5);
        [
            -(x * p + y * q + z * r),
            w * p + y * r - z * q,
            w * q + z * p - x * r,
            w * r + x * q - y * p,
            a,
            b,
            c,
        ]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        self.scene.scale(y)
    }
}

/// A vector at each time and state, one after the other.
#[inline(always)]
fn one_by_one<L: Lane>(
    t: L,
    q: [L; 4],
    l: [L; 3],
    vector: impl Fn(f64, &State) -> SpaceVector,
) -> [L; 3] {
    let mut times = [0.0; WIDEST];
    t.store(&mut times);
    let (mut turned, mut momenta) = ([[0.0; WIDEST]; 4], [[0.0; WIDEST]; 3]);
    for (from, to) in q.iter().zip(&mut turned) {
        from.store(to);
    }
    for (from, to) in l.iter().zip(&mut momenta) {
        from.store(to);
    }
    let ([w, x, y, z], [lx, ly, lz]) = (&turned, &momenta);
    let mut vectors = [[0.0; WIDEST]; 3];
    for i in 0..L::WIDTH {
        let state = State {
            attitude: Attitude::from_unit([w[i], x[i], y[i], z[i]]),
            angular_momentum: SpaceVector::new(lx[i], ly[i], lz[i]),
        };
        let [a, b, c] = vector(times[i], &state).to_array();
        (vectors[0][i], vectors[1][i], vectors[2][i]) = (a, b, c);
    }
    vectors.map(|components| L::load(&components))
}

/// R^T v of the unit quaternion q.
#[inline(always)]
fn turned_back<L: Lane>([w, x, y, z]: [L; 4], [a, b, c]: [L; 3]) -> [L; 3] {
    let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
    [
        a * ((ww + xx) - (yy + zz)) + (b * (x * y + w * z) + c * (x * z - w * y)) * 2.0,
        b * ((ww + yy) - (xx + zz)) + (c * (y * z + w * x) + a * (x * y - w * z)) * 2.0,
        c * ((ww + zz) - (xx + yy)) + (a * (x * z + w * y) + b * (y * z - w * x)) * 2.0,
    ]
}

/// S and m = L/(2 I1): S' = (0, m) S, m' = torque/(2 I1). With six components m_Z is kept.
///
/// The torque belongs to an axis of length |S|^2; Gauss's methods keep that length.
struct Precession<'s, E> {
    scene: &'s Scene<E>,
    half: f64,
    vertical: f64,
    scale: [f64; 7],
}

impl<E: Effect> Precession<'_, E> {
    #[inline(always)]
    fn rates<L: Lane>(&self, quaternion: [L; 4], momentum: [L; 3]) -> ([L; 4], [L; 3]) {
        let [w, x, y, z] = quaternion;
        let axis =
            [(x * z + w * y) * 2.0, (y * z - w * x) * 2.0, (w * w + z * z) - (x * x + y * y)];
        let [a, b, c] = (self.scene.effects()).torques_on_axis(self.scene.body(), axis);
        let torque = [a * self.half, b * self.half, c * self.half];
        (vector_times(momentum, quaternion), torque)
    }
}

impl<E: Effect> StageOde<6> for Precession<'_, E> {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, p, q]: &[L; 6]) -> [L; 6] {
        let (turn, torque) = self.rates([w, x, y, z], [p, q, L::of(self.vertical)]);
        [turn[0], turn[1], turn[2], turn[3], torque[0], torque[1]]
    }

    fn scale(&self, _: &[f64; 6]) -> [f64; 6] {
        let [w, x, y, z, p, q, _] = self.scale;
        [w, x, y, z, p, q]
    }
}

impl<E: Effect> StageOde<7> for Precession<'_, E> {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let ([w, x, y, z], [p, q, r]) = self.rates([w, x, y, z], [p, q, r]);
        [w, x, y, z, p, q, r]
    }

    fn scale(&self, _: &[f64; 7]) -> [f64; 7] {
        self.scale
    }
}

impl<'s, E: Effect, const STEADY: bool> Integrator<SpinFree<'s, E>, State>
    for GaussLegendre<STEADY>
{
    advance_by_counting!(SpinFree<'s, E>, State);

    fn advance_counting(
        &self,
        problem: &SpinFree<'s, E>,
        t: f64,
        start: &State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<State> {
        let y = components(start);
        check_span(t, &y, t_end)?;
        if t == t_end {
            return Ok(*start);
        }
        let twice = 2.0 * problem.scene().body().moments().i1();
        let [w, x, y1, z, ..] = y;
        let [p, q, r] = start.angular_momentum.to_array().map(|l| DoubleDouble::from(l) / twice);
        let scale = Ode::scale(problem, &y);
        let precession = Precession {
            scene: problem.scene(),
            half: 1.0 / twice,
            vertical: r.hi(),
            scale: core::array::from_fn(|i| if i < 4 { scale[i] } else { scale[i] / twice }),
        };
        let [_, _, vertical] = start.angular_momentum.to_array();
        let ([w, x, y, z], [lx, ly, lz]) = if const { E::PROPERTIES.conserved.momentum[2] } {
            let from = Compensated {
                value: [w, x, y1, z, p.hi(), q.hi()],
                carry: [0.0, 0.0, 0.0, 0.0, p.lo(), q.lo()],
            };
            let end = self.run(&precession, t, from, t_end, &mut (), work)?;
            let [w, x, y, z, p, q] = end;
            ([w, x, y, z], [p * twice, q * twice, vertical])
        } else {
            let from = Compensated {
                value: [w, x, y1, z, p.hi(), q.hi(), r.hi()],
                carry: [0.0, 0.0, 0.0, 0.0, p.lo(), q.lo(), r.lo()],
            };
            let end = self.run(&precession, t, from, t_end, &mut (), work)?;
            let [w, x, y, z, p, q, r] = end;
            ([w, x, y, z], [p * twice, q * twice, r * twice])
        };
        let spin = problem.spin_rate(start) * (t_end - t);
        problem.state(&[w, x, y, z, lx, ly, lz], spin)
    }
}

/// The scene of any body under effects that see its axis only, by attitude and
/// momentum on the body's own axes:
///
/// ```text
/// q' = q (0, omega) / 2,   l' = l x omega + R^T torque(e3),   omega = I^-1 l.
/// ```
///
/// The kinetic energy is quadratic in l, and so is the potential of gravity in q. So Gauss's
/// methods keep the energy of a heavy body but for round-off, and the error grows with the time,
/// not with its square as it does in the variables of [`Scene`].
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, EulerAngles};
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::GravityAtLever;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::gauss_legendre::BodyAxes;
/// use rotation_dynamics::integrators::{GaussLegendre, Integrator};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A top that is not round: there is no closed form.
/// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.2, 2.0)?);
/// let scene = Scene::new(body).with(GravityAtLever::new(0.2, 1.0)?);
/// let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 0.4, zeta: 0.0 })?;
/// let start = body.state(tilted, BodyVector::new(0.1, 0.5, 0.7))?;
/// let problem = BodyAxes::new(&scene)?;
/// let (end, _) = GaussLegendre::new(1000)?.advance(&problem, 0.0, &start, 1000.0)?;
/// assert!((scene.energy(&end) / scene.energy(&start) - 1.0).abs() < 1e-14);
/// # Ok(())
/// # }
/// ```
///
/// Source: L. Euler's equations with a torque, notes 15.5; L. D. Landau, E. M. Lifshitz,
/// *Mechanics*, 36.
#[derive(Debug, Clone, Copy)]
pub struct BodyAxes<'s, E> {
    scene: &'s Scene<E>,
    inverse: [[f64; 2]; 3],
}

impl<'s, E: Effect> BodyAxes<'s, E> {
    /// The scene on the axes of its body.
    ///
    /// Errors: effects that see more than the body's axis.
    pub fn new(scene: &'s Scene<E>) -> Result<Self> {
        axis_only(scene.effects())?;
        let inverse = inverse_moments(scene.body());
        Ok(Self { scene, inverse })
    }

    /// The scene.
    pub const fn scene(&self) -> &'s Scene<E> {
        self.scene
    }

    /// The state as it is carried: w, x, y, z and the momentum on the body axes.
    pub fn components(&self, state: &State) -> [f64; 7] {
        let [w, x, y, z] = state.attitude.quaternion();
        let [l1, l2, l3] = self.scene.body().angular_momentum(state).to_array();
        [w, x, y, z, l1, l2, l3]
    }

    /// The state that these components describe; the quaternion is normalised.
    ///
    /// Errors: a component that is not finite; a quaternion of length 0.
    pub fn state(&self, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> Result<State> {
        let attitude = Attitude::from_quaternion([w, x, y, z])?;
        State::new(attitude, attitude.to_space(BodyVector::new(l1, l2, l3)))
    }

    #[inline(always)]
    fn rates<L: Lane>(&self, y7: &[L; 7]) -> [L; 7] {
        let [w, x, y, z, ..] = *y7;
        let axis =
            [(x * z + w * y) * 2.0, (y * z - w * x) * 2.0, (w * w + z * z) - (x * x + y * y)];
        let [a, b, c] = (self.scene.effects()).torques_on_axis(self.scene.body(), axis);
        let [w1, x1, y1, z1, l1, l2, l3] = rates(&self.inverse, y7);
        // The torque has no component along e3.
        let [first, second, _] = turned_back([w, x, y, z], [a, b, c]);
        [w1, x1, y1, z1, l1 + first, l2 + second, l3]
    }
}

impl<E: Effect> Ode<7> for BodyAxes<'_, E> {
    fn derivative(&self, _t: f64, y: &[f64; 7]) -> [f64; 7] {
        self.rates(y)
    }

    /// As for the scene itself.
    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        Ode::scale(self.scene, y)
    }
}

impl<E: Effect> StageOde<7> for BodyAxes<'_, E> {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, y: &[L; 7]) -> [L; 7] {
        self.rates(y)
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        Ode::scale(self.scene, y)
    }
}

impl<'s, E: Effect, const STEADY: bool> Integrator<BodyAxes<'s, E>, State>
    for GaussLegendre<STEADY>
{
    advance_by_counting!(BodyAxes<'s, E>, State);

    fn advance_counting(
        &self,
        problem: &BodyAxes<'s, E>,
        t: f64,
        start: &State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<State> {
        let end = self.advance_counting(problem, t, &problem.components(start), t_end, work)?;
        problem.state(&end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::GravityAtLever;
    use crate::inertia::PrincipalMoments;

    /// On the body's axes: l' = l x omega + torque, q' = q omega/2.
    #[test]
    fn the_axes_of_the_body_obey_euler() {
        let moments = PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body");
        let gravity = GravityAtLever::new(2.0, 0.4).expect("a weight");
        let scene = Scene::new(crate::body::RigidBody::new(moments)).with(gravity);
        let attitude = Attitude::from_quaternion([0.5, 0.1, -0.7, 0.3]).expect("a rotation");
        let omega = BodyVector::new(0.3, -0.8, 2.0);
        let state = scene.body().state(attitude, omega).expect("a state");
        let axes = BodyAxes::new(&scene).expect("it sees the axis alone");
        let y = axes.components(&state);
        let [w, x, y_, z, l1, l2, l3] = y;
        let torque = state.attitude.to_body(scene.torque(0.0, &state));
        let turned = BodyVector::new(l1, l2, l3).cross(&omega) + torque;
        let [p, q, r] = omega.to_array();
        let half = [
            -x * p - y_ * q - z * r,
            w * p + y_ * r - z * q,
            w * q + z * p - x * r,
            w * r + x * q - y_ * p,
        ];
        let want = [half.map(|c| 0.5 * c).to_vec(), turned.to_array().to_vec()].concat();
        for (got, want) in axes.rates(&y).into_iter().zip(want) {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
    }
}
