//! What a sample of a closed form costs, one by one and in a batch, in units of one
//! sine-cosine pair of `libm` timed in the same run.
//!
//! `cargo run --release -p benches --bin batch`
//!
//! Rounds are interleaved and medians taken, so the ratios stand also on a machine
//! that does other work. Fails if a batch does not have the scalar code's bits, or if
//! what the motion keeps, rebuilt from the states, is off by more than claimed.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{Kinematics, RigidBody};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{self, EPS};
use rotation_dynamics::scene::Scene;
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 4096;
const ROUNDS: usize = 401;

type Many<'a> = dyn Fn(&[f64], &mut [Kinematics]) -> rotation_dynamics::Result<()> + 'a;
type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

/// A closed form and what it claims.
struct Motion<'a> {
    name: &'a str,
    one: &'a dyn Fn(f64) -> Kinematics,
    many: &'a Many<'a>,
    /// The largest relative error of what is kept, rebuilt from a state.
    error: &'a dyn Fn(&Kinematics) -> f64,
    /// The most that it may be, eps.
    claimed: f64,
    span: f64,
}

fn nanoseconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9 / SAMPLES as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn measure(motion: &Motion) -> Outcome<()> {
    let step = motion.span / SAMPLES as f64;
    let times: Vec<f64> = (0..SAMPLES).map(|k| k as f64 * step).collect();
    let mut one_by_one = vec![(motion.one)(0.0); SAMPLES];
    let mut batch = one_by_one.clone();
    let mut rounds = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        rounds[0].push(nanoseconds(|| {
            for t in black_box(&times) {
                black_box(math::sincos(black_box(*t)));
            }
        }));
        rounds[1].push(nanoseconds(|| {
            for (t, state) in black_box(&times).iter().zip(&mut one_by_one) {
                *state = (motion.one)(*t);
            }
            black_box(&mut one_by_one);
        }));
        let mut done = Ok(());
        rounds[2].push(nanoseconds(|| {
            done = (motion.many)(black_box(&times), &mut batch);
            black_box(&mut batch);
        }));
        done?;
    }
    if one_by_one != batch {
        return Err(format!("{}: the batch does not have the scalar bits", motion.name).into());
    }
    let error = batch.iter().map(motion.error).fold(0.0, f64::max) / EPS;
    if error > motion.claimed {
        let (name, claimed) = (motion.name, motion.claimed);
        return Err(format!("{name}: off by {error:.1} eps, and {claimed} are claimed").into());
    }
    let [pair, scalar, vector] = rounds.map(median);
    println!("{}, error {error:.1} eps", motion.name);
    for (name, time) in [
        ("sine-cosine pair", pair),
        ("one by one", scalar),
        ("batch", vector),
    ] {
        println!("{name:18} {time:6.1} ns  {:5.2} pairs", time / pair);
    }
    println!();
    Ok(())
}

fn main() -> Outcome<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let start = BodyVector::new(0.8, 0.4, 0.3375);
    let free = FreeBody::new(moments, Attitude::IDENTITY, start)?;
    let momentum = free.angular_momentum();
    measure(&Motion {
        name: "free body, attitude and body rates, 1000 periods",
        one: &|t| free.kinematics(t),
        many: &|times, states| free.kinematics_at(times, states),
        error: &|now| {
            let own = free.body_momentum(now.angular_velocity);
            let drift = (now.attitude.to_space(own) - momentum).norm() / momentum.norm();
            let energy = 0.5 * own.dot(&now.angular_velocity);
            drift.max((energy / free.kinetic_energy() - 1.0).abs())
        },
        // Measured: 17.2 eps.
        claimed: 21.0,
        span: 1000.0 * free.rate_period(),
    })?;

    let top = HeavyTop::from_energy(
        ReducedTop::new(2.0, 1.2, 0.2)?,
        0.55,
        Start::ThetaMin,
        0.0,
        0.0,
    )?;
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 2.0)?);
    let scene = Scene::new(body).with(GravityAtLever::new(0.2, 1.0)?);
    // Energy, L_Z and L_z, all of order one.
    let kept = |now: &Kinematics| {
        let state = body
            .state(now.attitude, now.angular_velocity)
            .expect("finite rates");
        let own = body.angular_momentum(&state);
        [scene.energy(&state), state.angular_momentum.z(), own.z()]
    };
    let first = kept(&top.kinematics(0.0));
    measure(&Motion {
        name: "heavy top of figure 3(b), attitude and body rates, 1000 nods",
        one: &|t| top.kinematics(t),
        many: &|times, states| top.kinematics_at(times, states),
        error: &|state| {
            let now = kept(state);
            (now.iter().zip(&first)).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
        },
        // Measured: 18.0 eps, against a first sample that is rounded itself.
        claimed: 21.0,
        span: 1000.0 * top.nutation_period(),
    })
}
