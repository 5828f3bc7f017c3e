//! What a sample of a closed form costs, one by one and in a batch, in units of one
//! sine-cosine pair of `libm` timed in the same run.
//!
//! `cargo run --release -p benches --bin batch`
//!
//! Rounds are interleaved and medians taken, so the ratios stand also on a machine
//! that does other work. Fails if the batch does not have the scalar code's bits, or
//! if L or the energy, rebuilt from the states, are off by more than 21 eps (measured 18.6; the bound of `tests/free_body.rs`).

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{self, EPS};
use std::hint::black_box;
use std::time::Instant;

const SAMPLES: usize = 4096;
const ROUNDS: usize = 201;

fn nanoseconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e9 / SAMPLES as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The largest relative error of L and of the energy, in eps.
fn invariants(motion: &FreeBody, states: &[(Attitude, BodyVector)]) -> f64 {
    let (momentum, energy) = (motion.angular_momentum(), motion.kinetic_energy());
    states.iter().fold(0.0, |largest: f64, (attitude, omega)| {
        let own = motion.body_momentum(*omega);
        let drift = (attitude.to_space(own) - momentum).norm() / momentum.norm();
        let kinetic = 0.5 * own.dot(omega);
        largest
            .max(drift / EPS)
            .max((kinetic / energy - 1.0).abs() / EPS)
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let start = BodyVector::new(0.8, 0.4, 0.3375);
    let motion = FreeBody::new(moments, start, Attitude::IDENTITY)?;
    let step = 1000.0 * motion.rate_period() / SAMPLES as f64;
    let times: Vec<f64> = (0..SAMPLES).map(|k| k as f64 * step).collect();
    let mut one_by_one = vec![(Attitude::IDENTITY, start); SAMPLES];
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
                *state = motion.state_at(*t);
            }
            black_box(&mut one_by_one);
        }));
        let mut done = Ok(());
        rounds[2].push(nanoseconds(|| {
            done = motion.states_at(black_box(&times), &mut batch);
            black_box(&mut batch);
        }));
        done?;
    }
    if one_by_one != batch {
        return Err("the batch does not have the scalar bits".into());
    }
    let error = invariants(&motion, &batch);
    if error > 21.0 {
        return Err(format!("L or E off by {error:.1} eps, and 21 are claimed").into());
    }
    let [pair, scalar, vector] = rounds.map(median);
    println!("free body, attitude and body rates, 1000 periods, error in L and E {error:.1} eps");
    println!("sine-cosine pair   {pair:6.1} ns");
    println!(
        "one by one         {scalar:6.1} ns  {:5.2} pairs",
        scalar / pair
    );
    println!(
        "batch              {vector:6.1} ns  {:5.2} pairs",
        vector / pair
    );
    Ok(())
}
