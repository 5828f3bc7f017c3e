//! What a sample of a closed form costs, one by one, in a batch of one motion and side by side
//! with those of other motions, and its set-up: in units of one sine-cosine pair of `libm`
//! timed in the same run. Writes `benches/record/batch.txt`.
//!
//! ```text
//! cargo run --release -p benches --bin batch -- [--date DATE]
//! ```
//!
//! In a build with `--cfg registers` the environment's `REGISTERS` says which the run may use
//! (`avx2`), and the record is `batch_avx2.txt`.
//!
//! Rounds are interleaved and the least times taken, so the ratios stand also on a machine
//! that does other work. Fails if a motion is further from its 25 digits than claimed, or if a
//! batch does not have the scalar code's bits.

use benches::conditions::Conditions;
use benches::throughput::{Motion, motions, same_bits, times};
use benches::timing::{Clock, Task, interleaved_by};
use kit::cli::alive;
use kit::{Report, Table, short};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::math;
use std::cell::RefCell;
use std::error::Error;
use std::hint::black_box;
use std::path::Path;
use std::{env, fs};

/// Times of a batch.
const SAMPLES: u32 = 4096;
/// Motions side by side: as many as stay in a cache.
const MOTIONS: u32 = 512;
const ROUNDS: usize = 401;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The least times of these tasks, s.
fn least(tasks: &[Task]) -> Outcome<Vec<f64>> {
    let measured = interleaved_by(Clock::Thread, tasks, ROUNDS)?;
    Ok(measured.iter().map(|measured| measured.least).collect())
}

/// As many sine-cosine pairs as there are times.
fn pairs(times: &[f64]) {
    for t in black_box(times) {
        black_box(math::sincos(black_box(*t)));
    }
}

/// One by one and in a batch, in pairs.
fn samples(motion: &Motion) -> Outcome<[f64; 2]> {
    let closed = motion.set_up(0.0)?;
    let times = times(&closed, SAMPLES);
    let states = || RefCell::new(vec![Kinematics::REST; times.len()]);
    let (one_by_one, batch) = (states(), states());
    let found = least(&[
        &|| {
            pairs(&times);
            Ok(())
        },
        &|| {
            for (t, state) in black_box(&times)
                .iter()
                .zip(one_by_one.borrow_mut().iter_mut())
            {
                *state = closed.kinematics(*t);
            }
            black_box(&one_by_one);
            Ok(())
        },
        &|| Ok(closed.kinematics_at(black_box(&times), black_box(&mut batch.borrow_mut()))?),
    ])?;
    same_bits(motion.name, &one_by_one.borrow(), &batch.borrow())?;
    Ok([found[1] / found[0], found[2] / found[0]])
}

/// Many motions at one time: one by one and side by side, in pairs.
fn side_by_side(motion: &Motion) -> Outcome<[f64; 2]> {
    let many = motion.many(MOTIONS)?;
    let together = many.together();
    let closed = motion.set_up(0.0)?;
    let (times, late) = (times(&closed, MOTIONS), 1000.0 * closed.period() / 3.0);
    let states = || RefCell::new(vec![Kinematics::REST; times.len()]);
    let (one_by_one, batch) = (states(), states());
    let found = least(&[
        &|| {
            pairs(&times);
            Ok(())
        },
        &|| {
            many.one_by_one(black_box(late), black_box(&mut one_by_one.borrow_mut()));
            Ok(())
        },
        &|| Ok(together.kinematics(black_box(late), black_box(&mut batch.borrow_mut()))?),
    ])?;
    same_bits(motion.name, &one_by_one.borrow(), &batch.borrow())?;
    Ok([found[1] / found[0], found[2] / found[0]])
}

/// The set-up, in pairs and in seconds, and the pair in seconds.
fn set_up(motion: &Motion) -> Outcome<[f64; 3]> {
    let times = times(&motion.set_up(0.0)?, SAMPLES);
    let found = least(&[
        &|| {
            pairs(&times);
            Ok(())
        },
        &|| {
            black_box(black_box(motion).set_up(black_box(0.0))?);
            Ok(())
        },
    ])?;
    let pair = found[0] / f64::from(SAMPLES);
    Ok([found[1] / pair, found[1], pair])
}

fn main() -> Outcome<()> {
    alive(record)
}

fn record() -> Outcome<()> {
    let conditions = Conditions::read("batch", env::args().skip(1))?;
    let registers = env::var("REGISTERS").ok().filter(|_| cfg!(registers));
    let mut report = Report::new(
        "Samples of the closed forms",
        format!(
            "Attitude and body rates: of one motion at {SAMPLES} times over 1000 periods, and of \
             {MOTIONS} motions at one time, in sine-cosine pairs of libm; the least of {ROUNDS} \
             rounds; measured, not locked. Every batch has the bits of one by one, and every \
             motion its 25 digits within K eps (|value| + condition). \
             Measure again: benches/measure batch"
        ),
    )?;
    report.add_table(conditions.table()?)?;
    let mut table = Table::new(
        "samples",
        [
            "motion",
            "K",
            "one by one",
            "in a batch",
            "one by one of many",
            "side by side",
        ],
    )?;
    let mut set_ups = Table::new("set_up", ["motion", "pairs", "time / µs", "pair / ns"])?;
    for motion in motions()? {
        let ([one, batch], [of_many, together]) = (samples(&motion)?, side_by_side(&motion)?);
        let two = |x: f64| format!("{x:.2}");
        table.push([
            motion.name.to_owned(),
            format!("{:.1}", motion.factor),
            two(one),
            two(batch),
            two(of_many),
            two(together),
        ])?;
        let [pairs, seconds, pair] = set_up(&motion)?;
        set_ups.push([
            motion.name.to_owned(),
            format!("{pairs:.0}"),
            short(1e6 * seconds, 2),
            short(1e9 * pair, 2),
        ])?;
    }
    report.add_table(table)?;
    report.add_table(set_ups)?;
    let text = report.text()?;
    let name = registers.map_or("batch.txt".to_owned(), |of| format!("batch_{of}.txt"));
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("record")
        .join(name);
    fs::write(file, &text)?;
    print!("{text}");
    Ok(())
}
