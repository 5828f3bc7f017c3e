//! What it costs to step a body for a thousand periods to a given attitude error.
//!
//! `cargo run --release -p benches --bin stepping`
//!
//! Every line first shows that it reaches its error, against the closed form; else the
//! program fails. Then all lines of a table are timed in turn, in units of the first.
//! Gauss-Legendre is timed in each kind of registers; the bits are the same. The races
//! against other crates are elsewhere.

use benches::timing::{Task, interleaved};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::{BodyAxes, FreeRotation, Registers};
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Rk4, Scheme, SpinFree, Splitting, Work,
};
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::scene::Scene;
use std::hint::black_box;

const PERIODS: f64 = 1000.0;
const ROUNDS: usize = 15;

type Outcome = rotation_dynamics::Result<(State, Work)>;

/// A line of a table: a method, the error it claims, and its run.
struct Line<'a> {
    name: &'static str,
    claimed: f64,
    run: Box<dyn Fn() -> Outcome + 'a>,
}

/// The same method in each kind of registers.
fn in_all_registers<'a, P>(
    lines: &mut Vec<Line<'a>>,
    problem: &'a P,
    start: &'a State,
    end: f64,
    settings: [(f64, u64, f64); 3],
) -> rotation_dynamics::Result<()>
where
    GaussLegendre: Integrator<P, State>,
{
    for (claimed, steps, precision) in settings {
        let method = GaussLegendre::with_precision(steps, precision)?;
        for (name, registers) in [
            ("Gauss-Legendre 16, AVX-512", Registers::Avx512),
            ("Gauss-Legendre 16, AVX2", Registers::Avx2),
            ("Gauss-Legendre 16, common", Registers::Common),
        ] {
            let method = method.limited_to(registers);
            let run = Box::new(move || method.advance(problem, 0.0, start, end));
            lines.push(Line { name, claimed, run });
        }
    }
    Ok(())
}

/// Asserts every line's error, then times them all.
fn table(title: &str, exact: &Attitude, lines: &[Line]) -> Result<(), Box<dyn std::error::Error>> {
    let mut reached = Vec::new();
    for line in lines {
        let (end, work) = (line.run)()?;
        let error = end.attitude.angle_to(exact);
        if error.is_nan() || error > line.claimed {
            return Err(format!("{}: {error:.1e}, {:.0e} claimed", line.name, line.claimed).into());
        }
        reached.push((error, work));
    }
    let runs: Vec<_> = lines
        .iter()
        .map(|line| {
            || {
                assert!(black_box((line.run)()?).1.steps > 0);
                Ok(())
            }
        })
        .collect();
    let tasks: Vec<Task> = runs.iter().map(|run| run as Task).collect();
    println!("{title}");
    for ((line, (error, work)), time) in
        lines.iter().zip(&reached).zip(interleaved(&tasks, ROUNDS)?)
    {
        println!(
            "{:<27} {:>5.0e} {error:>8.1e} {:>9.3} ms {:>7.2}  {work}",
            line.name,
            line.claimed,
            time.seconds * 1e3,
            time.ratio
        );
    }
    println!();
    Ok(())
}

fn free_body() -> Result<(), Box<dyn std::error::Error>> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let motion = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
    let end = PERIODS * motion.rate_period();
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let free = FreeRotation::new(&scene);
    let y = free.components(&start);
    let mut lines = Vec::new();
    let settings = [
        (1e-6, 4500, 5e-12),
        (1e-9, 6750, 5e-15),
        (1e-11, 9000, 5e-16),
    ];
    in_all_registers(&mut lines, &free, &start, end, settings)?;
    for (claimed, tolerance) in [(1e-6, 1e-12), (1e-9, 1e-15)] {
        let (method, free) = (Dop853::new(tolerance)?, &free);
        let run = Box::new(move || {
            let (y, work) = method.advance(free, 0.0, &y, end)?;
            let attitude = Attitude::from_quaternion([y[0], y[1], y[2], y[3]])?;
            Ok((State { attitude, ..start }, work))
        });
        lines.push(Line {
            name: "DOP853",
            claimed,
            run,
        });
    }
    let method = Rk4::new(1_300_000)?;
    let run = Box::new(move || {
        let (y, work) = method.advance(&free, 0.0, &y, end)?;
        let attitude = Attitude::from_quaternion([y[0], y[1], y[2], y[3]])?;
        Ok((State { attitude, ..start }, work))
    });
    lines.push(Line {
        name: "RK4",
        claimed: 1e-6,
        run,
    });
    table(
        "free asymmetric body, I = 1, 2, 8/3, L = (0.8, 0.8, 0.9), 1000 periods of its rates",
        &motion.attitude(end),
        &lines,
    )
}

fn heavy_top() -> Result<(), Box<dyn std::error::Error>> {
    let theta = 0.359_515_098_053_132_17;
    let (a, b, c): (f64, f64, f64) = (2.0, 1.2, 0.2);
    let motion = HeavyTop::from_angles(ReducedTop::new(a, b, c)?, theta, 0.0, 0.0, 0.0)?;
    let end = PERIODS * motion.nutation_period();
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, a)?);
    let scene = Scene::new(body).with(GravityAtLever::new(c, 1.0)?);
    let precession = a.sqrt() * (b - cos(theta)) / sin(theta);
    let rates = BodyVector::new(0.0, precession, 1.0 / a.sqrt());
    let start = body.state(motion.attitude(0.0), rates)?;
    let (spin_free, axes) = (SpinFree::new(&scene)?, BodyAxes::new(&scene)?);
    let exact = motion.attitude(end);
    let scene = &scene;
    let mut lines = Vec::new();
    let settings = [
        (1e-6, 1800, 5e-10),
        (1e-9, 2800, 5e-13),
        (1e-11, 3250, 5e-15),
    ];
    in_all_registers(&mut lines, &spin_free, &start, end, settings)?;
    for (claimed, steps) in [(1e-6, 6000), (1e-9, 18_500)] {
        let method = Splitting::new(Scheme::SRKN14, steps)?;
        let run = Box::new(move || method.advance(scene, 0.0, &start, end));
        lines.push(Line {
            name: "SRKN 14a",
            claimed,
            run,
        });
    }
    for (claimed, tolerance) in [(1e-6, 1e-11), (1e-9, 2e-14)] {
        let (method, spin_free) = (Dop853::new(tolerance)?, &spin_free);
        let run = Box::new(move || method.advance(spin_free, 0.0, &start, end));
        lines.push(Line {
            name: "DOP853",
            claimed,
            run,
        });
    }
    let (method, problem) = (Rk4::new(310_000)?, &spin_free);
    let run = Box::new(move || method.advance(problem, 0.0, &start, end));
    lines.push(Line {
        name: "RK4",
        claimed: 1e-6,
        run,
    });
    table(
        "heavy top, a = 2, b = 1.2, c = 0.2, E = 0.55, without its spin, 1000 nutations",
        &exact,
        &lines,
    )?;
    let mut lines = Vec::new();
    let settings = [
        (1e-6, 1700, 5e-11),
        (1e-9, 2500, 5e-13),
        (1e-11, 4000, 5e-16),
    ];
    in_all_registers(&mut lines, &axes, &start, end, settings)?;
    table(
        "the same top on its own axes, as one that is not round",
        &exact,
        &lines,
    )
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    free_body()?;
    heavy_top()
}
