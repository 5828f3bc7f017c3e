//! What a sample of a closed form costs, one by one, in a batch of one motion at many times and
//! side by side with those of other motions at one time, and its set-up: in units of one
//! sine-cosine pair of `libm`. Writes `benches/record/batch.txt`.
//!
//! In a build with `--cfg registers` the environment's `REGISTERS` says which the run may use
//! (`avx2`), and the record is `batch_avx2.txt`.
//!
//! A bench is not timed before the motion is shown to have its 25 digits within what is
//! claimed, and the batch the bits of one by one.

use benches::record::{self, Outcome, ProcessorTime};
use benches::throughput::{Motion, motions, same_bits, times};
use criterion::{Criterion, Throughput};
use kit::{Table, short};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::math;
use std::env;
use std::hint::black_box;

/// Times of a batch.
const SAMPLES: u32 = 4096;
/// Motions side by side: as many as stay in a cache.
const MOTIONS: u32 = 512;

const PAIRS: &str = "sine-cosine pairs";
const SET_UP: &str = "set-up";
/// The benches, with how many samples each forms.
const SAMPLED: [(&str, u32); 4] = [
    ("many times, one by one", SAMPLES),
    ("many times, in a batch", SAMPLES),
    ("many motions, one by one", MOTIONS),
    ("many motions, side by side", MOTIONS),
];

fn time(c: &mut Criterion<ProcessorTime>, motion: &Motion) -> Outcome<()> {
    let closed = motion.set_up(0.0)?;
    let mut group = c.benchmark_group(motion.name);
    group.bench_function(SET_UP, |b| b.iter(|| black_box(motion).set_up(0.0)));

    let times = times(&closed, SAMPLES);
    let mut one_by_one: Vec<_> = times.iter().map(|t| closed.kinematics(*t)).collect();
    let mut batch = vec![Kinematics::REST; times.len()];
    closed.kinematics_at(&times, &mut batch)?;
    same_bits(motion.name, &one_by_one, &batch)?;
    group.throughput(Throughput::Elements(u64::from(SAMPLES)));
    group.bench_function(PAIRS, |b| {
        b.iter(|| {
            for t in black_box(&times) {
                black_box(math::sincos(black_box(*t)));
            }
        });
    });
    group.bench_function(SAMPLED[0].0, |b| {
        b.iter(|| {
            for (t, state) in black_box(&times).iter().zip(&mut one_by_one) {
                *state = closed.kinematics(*t);
            }
        });
    });
    group.bench_function(SAMPLED[1].0, |b| {
        b.iter(|| closed.kinematics_at(black_box(&times), &mut batch));
    });

    let many = motion.many(MOTIONS)?;
    let together = many.together();
    let late = 1000.0 * closed.period() / 3.0;
    let mut one_by_one = vec![Kinematics::REST; MOTIONS as usize];
    let mut batch = one_by_one.clone();
    many.one_by_one(late, &mut one_by_one);
    together.kinematics(late, &mut batch)?;
    same_bits(motion.name, &one_by_one, &batch)?;
    group.throughput(Throughput::Elements(u64::from(MOTIONS)));
    group.bench_function(SAMPLED[2].0, |b| {
        b.iter(|| many.one_by_one(black_box(late), &mut one_by_one));
    });
    group.bench_function(SAMPLED[3].0, |b| {
        b.iter(|| together.kinematics(black_box(late), &mut batch));
    });
    group.finish();
    Ok(())
}

fn main() -> Outcome<()> {
    let registers = env::var("REGISTERS").ok().filter(|_| cfg!(registers));
    let name = registers.map_or("batch".into(), |of| format!("batch_{of}"));
    let motions = motions()?;
    let mut criterion = record::criterion();
    for motion in &motions {
        time(&mut criterion, motion)?;
    }
    criterion.final_summary();
    let description = format!(
        "Attitude and body rates: of one motion at {SAMPLES} times over 1000 periods, and of \
         {MOTIONS} motions at one time, in sine-cosine pairs of libm. Every batch has the bits of \
         one by one, and every motion its 25 digits within K eps (|value| + condition)"
    );
    let title = "Samples of the closed forms";
    record::write(&name, [title, &description, "benches/measure batch"], |times| {
        let columns = "motion, K, one by one, in a batch, one by one of many, side by side";
        let mut samples = Table::new("samples", columns.split(", "))?;
        let mut set_ups = Table::new("set_up", ["motion", "pairs", "time / µs", "pair / ns"])?;
        for motion in &motions {
            let name = motion.name;
            let of = |bench| times.of(&format!("{name}/{bench}"));
            let pair = of(PAIRS)?.median / f64::from(SAMPLES);
            let mut row = vec![name.to_owned(), format!("{:.1}", motion.factor)];
            for (bench, count) in SAMPLED {
                row.push(format!("{:.2}", of(bench)?.median / f64::from(count) / pair));
            }
            samples.push(row)?;
            let set_up = of(SET_UP)?.median;
            set_ups.push([
                name.to_owned(),
                format!("{:.0}", set_up / pair),
                short(1e-3 * set_up, 2),
                short(pair, 2),
            ])?;
        }
        Ok(vec![samples, set_ups])
    })
}
