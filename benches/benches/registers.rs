//! What it costs Gauss-Legendre to step a body for a thousand periods, in each kind of vector
//! registers: the bits are the same. What other methods take on these motions, and other crates,
//! is in `benches/record/peers.txt`.
//!
//! A bench is not timed before the error that it claims is shown to be reached, against the
//! closed form.

use benches::record::{self, Outcome, ProcessorTime};
use criterion::{BenchmarkId, Criterion};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::{BodyAxes, FreeRotation, Registers};
use rotation_dynamics::integrators::{GaussLegendre, Integrator, SpinFree};
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::scene::Scene;

const PERIODS: f64 = 1000.0;

/// A group: each of the settings, which are an error, steps and a precision, in all registers.
fn registers<P>(
    criterion: &mut Criterion<ProcessorTime>,
    name: &str,
    problem: &P,
    (start, end, exact): (&State, f64, Attitude),
    settings: [(f64, u64, f64); 3],
) -> Outcome<()>
where
    GaussLegendre: Integrator<P, State>,
{
    let mut group = criterion.benchmark_group(name);
    for (claimed, steps, precision) in settings {
        for registers in [Registers::Avx512, Registers::Avx2, Registers::Common] {
            let method = GaussLegendre::with_precision(steps, precision)?.limited_to(registers);
            let run = || method.advance(problem, 0.0, start, end);
            let error = run()?.0.attitude.angle_to(&exact);
            assert!(error <= claimed, "{name}: {error:e} is reached, not {claimed:e}");
            let id = BenchmarkId::new(format!("{registers:?}"), format!("{claimed:e}"));
            group.bench_function(id, |b| b.iter(run));
        }
    }
    group.finish();
    Ok(())
}

/// I = 1, 2, 8/3, L = (0.8, 0.8, 0.9).
fn free_body(criterion: &mut Criterion<ProcessorTime>) -> Outcome<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let motion = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
    let end = PERIODS * motion.rate_period();
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let settings = [(1e-6, 4500, 5e-12), (1e-9, 6750, 5e-15), (1e-11, 9000, 5e-16)];
    let way = (&start, end, motion.attitude(end));
    registers(criterion, "free body", &FreeRotation::new(&scene), way, settings)
}

/// a = 2, b = 1.2, c = 0.2, E = 0.55.
fn heavy_top(criterion: &mut Criterion<ProcessorTime>) -> Outcome<()> {
    let theta = 0.359_515_098_053_132_17;
    let (a, b, c): (f64, f64, f64) = (2.0, 1.2, 0.2);
    let motion = HeavyTop::from_angles(ReducedTop::new(a, b, c)?, theta, 0.0, 0.0, 0.0)?;
    let end = PERIODS * motion.nutation_period();
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, a)?);
    let scene = Scene::new(body).with(GravityAtLever::new(c, 1.0)?);
    let precession = a.sqrt() * (b - cos(theta)) / sin(theta);
    let rates = BodyVector::new(0.0, precession, 1.0 / a.sqrt());
    let start = body.state(motion.attitude(0.0), rates)?;
    let way = (&start, end, motion.attitude(end));
    let settings = [(1e-6, 1800, 5e-10), (1e-9, 2800, 5e-13), (1e-11, 3250, 5e-15)];
    registers(criterion, "heavy top without its spin", &SpinFree::new(&scene)?, way, settings)?;
    // As one that is not round.
    let settings = [(1e-6, 1700, 5e-11), (1e-9, 2500, 5e-13), (1e-11, 4000, 5e-16)];
    registers(criterion, "heavy top on its own axes", &BodyAxes::new(&scene)?, way, settings)
}

fn main() -> Outcome<()> {
    let mut criterion = record::criterion();
    free_body(&mut criterion)?;
    heavy_top(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}
