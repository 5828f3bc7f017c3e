//! 100 000 gyroscopes and 100 000 tumbling bodies, no two alike, over all cores: how many
//! a second, how much memory, and how the gyroscopes' axes mix. Writes
//! `benches/record/ensemble.txt`.
//!
//! Before anything is timed: the closed forms of some bodies are compared with
//! Gauss-Legendre runs after a thousand periods, the mean axes with one thread and with
//! several are compared bit by bit, and the memory in use while many times are asked for
//! with that for few.

mod made;

use benches::ensemble::{Axes, axes, drawn, set_up, states};
use benches::record::{self, Outcome, Times};
use criterion::measurement::WallTime;
use criterion::{Criterion, Throughput};
use kit::{Table, short};
use made::{GYROSCOPE, TUMBLING, accuracy, gyroscope, quantities, tumbling};
use rayon::{ThreadPool, ThreadPoolBuilder};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::exp;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

const BODIES: usize = 100_000;

/// Bodies in one timed run, unless it must show what memory costs.
const TIMED: usize = 8192;

/// Counts the bytes in use, and the most there ever were.
struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every request goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = IN_USE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(now, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What `work` returns and the most bytes it had in use beyond those before it.
fn peak<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let before = IN_USE.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    let result = work();
    (result, MOST.load(Ordering::Relaxed) - before)
}

/// Bytes of each body, and the most in use while its axes are averaged at 8 and 512 times.
fn memory<B: Send + Sync>(
    kind: &str,
    table: &mut Table,
    make: impl Fn(usize) -> rotation_dynamics::Result<B> + Sync + Send,
    axis: impl Fn(&B, f64) -> SpaceVector + Sync,
) -> Outcome<()> {
    let before = IN_USE.load(Ordering::Relaxed);
    let bodies = set_up(TIMED, make)?;
    let each = (IN_USE.load(Ordering::Relaxed) - before) as f64 / TIMED as f64;
    let used = [8, 512].map(|count| {
        let times: Vec<f64> = (0..count).map(f64::from).collect();
        let (sums, peak) = peak(|| axes(&bodies, &times, &axis));
        peak - size_of_val(sums.as_slice())
    });
    // The threads' own queues may take some blocks more or less.
    if used[1] > used[0] + 16_384 {
        Err(format!("{kind}: {used:?} bytes for 8 and 512 times"))?;
    }
    table.push([
        kind.to_owned(),
        short(each, 3),
        short(used[0] as f64, 2),
        short(used[1] as f64, 2),
    ])?;
    Ok(())
}

/// How the mean axis of the gyroscopes decays; the last column needs no sample.
fn mixing(tops: &[HeavyTop]) -> Outcome<Table> {
    let rates: Vec<f64> =
        tops.iter().map(|top| top.precession_per_period() / top.nutation_period()).collect();
    let count = rates.len() as f64;
    let mean = rates.iter().sum::<f64>() / count;
    let variance = rates.iter().map(|r| (r - mean) * (r - mean)).sum::<f64>() / count;
    let columns = [
        "precession / turns",
        "t / s",
        "mean of cos(theta)",
        "its spread",
        "horizontal mean",
        "if the rates were normal",
    ];
    let mut table = Table::new("mixing", columns)?;
    let turns = [0.0, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 1e3, 1e5];
    let times = turns.map(|turns| turns * core::f64::consts::TAU / mean);
    for ((turns, t), at_t) in turns.iter().zip(times).zip(axes(tops, &times, HeavyTop::axis)) {
        let tilt = at_t.mean().z();
        let normal = (1.0 - tilt * tilt).sqrt() * exp(-0.5 * variance * t * t);
        table.push([
            turns.to_string(),
            short(t, 3),
            format!("{tilt:.4}"),
            format!("{:.4}", at_t.spread_of_tilt()),
            format!("{:.4}", at_t.horizontal()),
            format!("{normal:.4}"),
        ])?;
    }
    Ok(table)
}

/// What is timed, each by any number of threads: its group, and bodies or states in a run.
struct Works<'a> {
    criterion: &'a mut Criterion,
    pools: &'a [ThreadPool],
    done: Vec<(String, usize)>,
}

impl Works<'_> {
    fn time<T>(&mut self, work: String, items: usize, run: impl Fn() -> T + Sync)
    where
        T: Send,
    {
        let mut group = self.criterion.benchmark_group(&work);
        group.throughput(Throughput::Elements(items as u64));
        for pool in self.pools {
            let threads = pool.current_num_threads().to_string();
            group.bench_function(threads, |b| b.iter(|| pool.install(&run)));
        }
        group.finish();
        self.done.push((work, items));
    }

    /// What each kind of work takes, for one kind of body.
    fn all<B: Send + Sync>(
        &mut self,
        kind: &str,
        make: impl Fn(usize) -> rotation_dynamics::Result<B> + Sync + Send + Copy,
        state: impl Fn(&B, f64) -> Kinematics + Sync + Copy,
        axis: impl Fn(&B, f64) -> SpaceVector + Sync + Copy,
    ) -> Outcome<()> {
        self.time(format!("{kind}: set-up"), TIMED, || set_up(TIMED, make));
        self.time(format!("{kind}: set-up and one state"), TIMED, || {
            set_up(TIMED, |body| Ok(state(&make(body)?, LATE)))
        });
        let bodies = set_up(BODIES, make)?;
        self.time(format!("{kind}: state at one time"), BODIES, || {
            let mut out = vec![Kinematics::REST; BODIES];
            states(&bodies, &mut out, |body| state(body, LATE));
            out
        });
        let times: Vec<f64> = (0..128).map(|n| LATE + f64::from(n)).collect();
        let often = format!("{kind}: axis at 128 times");
        self.time(often, TIMED * times.len(), || axes(&bodies[..TIMED], &times, axis));
        Ok(())
    }

    /// A row per number of threads.
    fn table(&self, times: &Times) -> Outcome<Table> {
        let columns = "work, threads, per second, each / ns, speed-up";
        let mut table = Table::new("throughput", columns.split(", "))?;
        for (work, items) in &self.done {
            let alone = times.of(&format!("{work}/1"))?.median;
            for threads in self.pools.iter().map(ThreadPool::current_num_threads) {
                let time = times.of(&format!("{work}/{threads}"))?.median;
                let each = time / *items as f64;
                table.push([
                    work.clone(),
                    threads.to_string(),
                    short(1e9 / each, 2),
                    short(each, 2),
                    short(alone / time, 2),
                ])?;
            }
        }
        Ok(table)
    }
}

/// What the machine gives to more threads, now: arithmetic that shares nothing.
fn control(body: usize) -> f64 {
    (0..1000).fold(drawn(body, 0), |x, _| 4.0 * x * (1.0 - x))
}

/// A time (s) after many periods.
const LATE: f64 = 1000.0;

fn main() -> Outcome<()> {
    let cores = thread::available_parallelism()?.get();
    let pool = |threads| ThreadPoolBuilder::new().num_threads(threads).build();
    let pools = (1..=cores).map(pool).collect::<Result<Vec<_>, _>>()?;
    let accuracy = accuracy()?;

    let made_top = |body| gyroscope(quantities(GYROSCOPE, body));
    let made_body = |body| tumbling(quantities(TUMBLING, body));
    let axis_of_body = |body: &FreeBody, t| body.attitude(t).axis();
    let columns = "bodies, bytes each, bytes for 8 times, bytes for 512 times";
    let mut memories = Table::new("memory", columns.split(", "))?;
    memory("gyroscopes", &mut memories, made_top, HeavyTop::axis)?;
    memory("tumbling bodies", &mut memories, made_body, axis_of_body)?;

    let tops = set_up(BODIES, made_top)?;
    let on = |threads: usize| -> Outcome<Vec<Axes>> {
        Ok(pool(threads)?.install(|| axes(&tops, &[1.0, LATE], HeavyTop::axis)))
    };
    let alone = on(1)?;
    for threads in [2, 3, 7] {
        if on(threads)? != alone {
            Err(format!("other sums with {threads} threads than with one"))?;
        }
    }
    let mixing = mixing(&tops)?;
    drop(tops);

    // The threads of a pool have the work, so the clock is the one on the wall.
    let mut criterion = record::criterion().with_measurement(WallTime);
    let mut works = Works { criterion: &mut criterion, pools: &pools, done: Vec::new() };
    let numbers = || set_up(TIMED, |body| Ok(control(body)));
    works.time("control".into(), TIMED, numbers);
    works.all("gyroscope", made_top, HeavyTop::kinematics, HeavyTop::axis)?;
    works.all("tumbling body", made_body, FreeBody::kinematics, axis_of_body)?;
    works.criterion.final_summary();
    let description = format!(
        "{BODIES} gyroscopes and {BODIES} tumbling bodies in closed form, each quantity within 1 % \
         of its nominal value, over the cores of one machine; the control is what the \
         machine gave to more threads"
    );
    let again = "cargo bench -p benches --bench ensemble";
    record::write("ensemble", ["Ensembles", &description, again], |times| {
        Ok(vec![accuracy, memories, mixing, works.table(times)?])
    })
}
