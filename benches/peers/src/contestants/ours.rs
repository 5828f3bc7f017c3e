//! This library's own methods, through its public interface.

use crate::form::{Form, Own, TopAngles};
use crate::problem::Problem;
use core::f64::consts::PI;
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::integrators::gauss_legendre::{BodyAxes, FreeRotation, LaneByLane};
use rotation_dynamics::integrators::splitting::Scheme;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, MuntheKaas4, Rk4, SpinFree, Splitting, StageOde, ode,
};
use rotation_dynamics::scene::Scene;

type TopScene = Scene<((), GravityAtLever)>;

/// A free body by quaternion and momentum on the body axes.
pub fn free<M>(problem: &Problem, method: &M) -> Result<Attitude>
where
    M: Integrator<FreeRotation, [f64; 7]>,
{
    let (scene, start) = problem.free_scene()?;
    let rotation = FreeRotation::new(&scene);
    let start = rotation.components(&start);
    let ([w, x, y, z, ..], _) = method.advance(&rotation, 0.0, &start, problem.end)?;
    Attitude::from_quaternion([w, x, y, z])
}

/// A free body as a scene.
pub fn free_scene<M: Integrator<Scene<()>, State>>(
    problem: &Problem,
    method: &M,
) -> Result<Attitude> {
    let (scene, start) = problem.free_scene()?;
    Ok(method.advance(&scene, 0.0, &start, problem.end)?.0.attitude)
}

/// A top as a scene.
pub fn top<M: Integrator<TopScene, State>>(problem: &Problem, method: &M) -> Result<Attitude> {
    let (scene, start) = problem.top_scene()?;
    Ok(method.advance(&scene, 0.0, &start, problem.end)?.0.attitude)
}

/// A top without its spin.
pub fn spin_free<M>(problem: &Problem, method: &M) -> Result<Attitude>
where
    M: for<'s> Integrator<SpinFree<'s, ((), GravityAtLever)>, State>,
{
    let (scene, start) = problem.top_scene()?;
    let problem_without = SpinFree::new(&scene)?;
    let (end, _) = method.advance(&problem_without, 0.0, &start, problem.end)?;
    Ok(end.attitude)
}

/// A top by quaternion and momentum on the body axes, by Gauss-Legendre.
pub fn top_on_its_axes(problem: &Problem, method: &GaussLegendre<true>) -> Result<Attitude> {
    let (scene, start) = problem.top_scene()?;
    let (end, _) = method.advance(&BodyAxes::new(&scene)?, 0.0, &start, problem.end)?;
    Ok(end.attitude)
}

/// Any form, by a method for any equations.
pub fn form<const N: usize, F: Form<N>, M: Integrator<Own<F>, [f64; N]>>(
    form: F,
    end: f64,
    method: &M,
) -> Result<Attitude> {
    let (y, _) = method.advance(&Own(form), 0.0, &form.start(), end)?;
    Attitude::from_quaternion(form.quaternion(end, &y))
}

/// The notes' angles by steps in a time of their own, which the distance from either pole paces.
pub fn angles_at_pace(form: TopAngles, end: f64, method: &Dop853) -> Result<Attitude> {
    let timed = ode(move |t, &[theta, rate, phi, zeta, _]: &[f64; 5]| {
        let [theta, rate, phi, zeta] = form.rates(t, &[theta, rate, phi, zeta]);
        [theta, rate, phi, zeta, 1.0]
    })
    .scaled(|_| [1.0; 5]);
    let [theta, rate, phi, zeta] = form.start();
    let start = [theta, rate, phi, zeta, 0.0];
    let pace = |&[theta, ..]: &[f64; 5]| theta * (PI - theta);
    let ([theta, rate, phi, zeta, _], _) = method.advance_at_pace(&timed, &start, end, pace)?;
    Attitude::from_quaternion(form.quaternion(end, &[theta, rate, phi, zeta]))
}

/// Any form, by Gauss-Legendre.
pub fn form_on_lanes<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    method: &GaussLegendre<true>,
) -> Result<Attitude> {
    let (y, _) = method.advance(&LaneByLane(Own(form)), 0.0, &form.start(), end)?;
    Attitude::from_quaternion(form.quaternion(end, &y))
}

/// A form that is written over lanes, by Gauss-Legendre.
pub fn form_of_lanes<const N: usize, F: Form<N> + StageOde<N>>(
    form: F,
    end: f64,
    method: &GaussLegendre<true>,
) -> Result<Attitude> {
    let (y, _) = method.advance(&form, 0.0, &form.start(), end)?;
    Attitude::from_quaternion(form.quaternion(end, &y))
}

/// A free body by quaternion and momentum on the body axes, by Gauss-Legendre.
pub fn free_on_lanes(problem: &Problem, method: &GaussLegendre<true>) -> Result<Attitude> {
    let (scene, start) = problem.free_scene()?;
    let (end, _) = method.advance(&FreeRotation::new(&scene), 0.0, &start, problem.end)?;
    Ok(end.attitude)
}

/// The closed form: set up, and one sample.
pub fn closed_form(problem: &Problem) -> Result<Attitude> {
    Ok(problem.exact()?.attitude(problem.end))
}

/// The methods that take a number of steps.
pub fn rk4(steps: u64) -> Result<Rk4> {
    Rk4::new(steps)
}

/// See [`rk4`].
pub fn munthe_kaas(steps: u64) -> Result<MuntheKaas4> {
    MuntheKaas4::new(steps)
}

/// See [`rk4`].
pub fn splitting(scheme: Scheme, steps: u64) -> Result<Splitting> {
    Splitting::new(scheme, steps)
}

/// See [`rk4`].
pub fn dop853(tolerance: f64) -> Result<Dop853> {
    Dop853::new(tolerance)?.with_step_limit(super::MOST_STEPS as u64)
}
