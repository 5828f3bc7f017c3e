//! A clock of our own, for what criterion cannot do: two codes in turn, in one run.
//!
//! The speed of a machine wanders while it works; what a computation takes in units of another,
//! measured a moment earlier, wanders much less. So in the races against other crates all are run
//! in turn, round after round, and each round gives a ratio; their median is the answer. A page's
//! report is likewise timed in its module and as a program, one after the other.

use kit::Result;
use std::time::Duration;

/// The time that this thread had a processor, s: other programs in the queue do not count. Where
/// the system does not tell, the clock on the wall.
pub fn now() -> f64 {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
    }
    #[cfg(not(unix))]
    {
        static START: std::sync::OnceLock<std::time::Instant> = std::sync::OnceLock::new();
        let start = START.get_or_init(std::time::Instant::now);
        start.elapsed().as_secs_f64()
    }
}

/// Something to be timed.
pub type Task<'a> = &'a dyn Fn() -> Result<()>;

/// What a task took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The median time of one run, s.
    pub seconds: f64,
    /// The median over all rounds of the time in units of the first task's.
    pub ratio: f64,
    /// The lower and upper quartile of that ratio.
    pub quartiles: [f64; 2],
}

/// A batch is repeated until it takes this long: enough that the clock's own step does not
/// count, so little that another program rarely gets its turn within it.
const BATCH: Duration = Duration::from_micros(200);

/// Times `tasks` in turn, `rounds` times over (at least 3); the first is the unit.
///
/// # Errors
/// The first error of a task.
pub fn interleaved(tasks: &[Task], rounds: usize) -> Result<Vec<Measured>> {
    let sizes: Vec<u32> = tasks.iter().map(|task| batch(task)).collect::<Result<_>>()?;
    let mut times = vec![Vec::new(); tasks.len()];
    for _ in 0..rounds.max(3) {
        for ((task, &size), times) in tasks.iter().zip(&sizes).zip(&mut times) {
            times.push(time(task, size)? / f64::from(size));
        }
    }
    let unit = &times[0];
    let measured = times.iter().map(|times| {
        let ratios = times.iter().zip(unit).map(|(time, unit)| time / unit);
        let ratios = sorted(ratios);
        let times = sorted(times.iter().copied());
        Measured {
            seconds: quantile(&times, 0.5),
            ratio: quantile(&ratios, 0.5),
            quartiles: [quantile(&ratios, 0.25), quantile(&ratios, 0.75)],
        }
    });
    Ok(measured.collect())
}

/// How many runs take as long as a batch should; this also warms up.
fn batch(task: Task) -> Result<u32> {
    let mut size = 1_u32;
    while time(task, size)? < BATCH.as_secs_f64() && size < 1 << 24 {
        size *= 2;
    }
    Ok(size)
}

fn time(task: Task, size: u32) -> Result<f64> {
    let start = now();
    for _ in 0..size {
        task()?;
    }
    Ok(now() - start)
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The value below which `part` of them lie, of values in order.
fn quantile(values: &[f64], part: f64) -> f64 {
    let at = (part * (values.len() - 1) as f64).round() as usize;
    values[at]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_values_of_the_sample() {
        let values = sorted([3.0, 1.0, 5.0, 2.0, 4.0].into_iter());
        assert_eq!(
            [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| quantile(&values, part)),
            [1.0, 2.0, 3.0, 4.0, 5.0]
        );
    }

    #[test]
    fn the_clock_does_not_go_back() {
        let times: Vec<f64> = (0..100).map(|_| now()).collect();
        assert!(times.is_sorted());
    }

    #[test]
    fn the_unit_is_one_of_itself() {
        let idle: Task = &|| Ok(());
        let measured = interleaved(&[idle, idle], 3).expect("nothing can fail");
        assert_eq!(measured.len(), 2);
        assert_eq!(measured[0].ratio, 1.0);
        assert_eq!(measured[0].quartiles, [1.0, 1.0]);
    }
}
