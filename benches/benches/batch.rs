//! Samples of the closed forms: one by one, in a batch of one motion at many times, of many
//! motions at one time; and their set-up.
//!
//! A bench is not timed before the motion is shown to have its 25 digits within what is
//! claimed, and the batch the bits of one by one.

use benches::throughput::{motions, same_bits, times};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rotation_dynamics::body::Kinematics;
use std::hint::black_box;

const SAMPLES: u32 = 4096;
const MOTIONS: u32 = 512;

fn batches(c: &mut Criterion) {
    for motion in motions().expect("each has its 25 digits") {
        let closed = motion.set_up(0.0).expect("a motion");
        let mut group = c.benchmark_group(motion.name);
        group.bench_function("set-up", |b| b.iter(|| black_box(&motion).set_up(0.0)));

        let times = times(&closed, SAMPLES);
        let mut one_by_one: Vec<_> = times.iter().map(|t| closed.kinematics(*t)).collect();
        let mut batch = vec![Kinematics::REST; times.len()];
        closed
            .kinematics_at(&times, &mut batch)
            .expect("a state for each time");
        same_bits(motion.name, &one_by_one, &batch).expect("the bits of one by one");
        group.throughput(Throughput::Elements(u64::from(SAMPLES)));
        group.bench_function("many times, one by one", |b| {
            b.iter(|| {
                for (t, state) in black_box(&times).iter().zip(&mut one_by_one) {
                    *state = closed.kinematics(*t);
                }
            });
        });
        group.bench_function("many times, in a batch", |b| {
            b.iter(|| closed.kinematics_at(black_box(&times), &mut batch));
        });

        let many = motion.many(MOTIONS).expect("motions");
        let together = many.together();
        let late = 1000.0 * closed.period() / 3.0;
        let mut one_by_one = vec![Kinematics::REST; MOTIONS as usize];
        let mut batch = one_by_one.clone();
        many.one_by_one(late, &mut one_by_one);
        together
            .kinematics(late, &mut batch)
            .expect("a state for each motion");
        same_bits(motion.name, &one_by_one, &batch).expect("the bits of one by one");
        group.throughput(Throughput::Elements(u64::from(MOTIONS)));
        group.bench_function("many motions, one by one", |b| {
            b.iter(|| many.one_by_one(black_box(late), &mut one_by_one));
        });
        group.bench_function("many motions, side by side", |b| {
            b.iter(|| together.kinematics(black_box(late), &mut batch));
        });
        group.finish();
    }
}

criterion_group!(benches, batches);
criterion_main!(benches);
