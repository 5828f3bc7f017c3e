//! Many bodies at one time, over all cores: their states, or the mean of their axes.
//!
//! A closed form needs nothing but its own set-up, so the bodies are independent and
//! their memory does not depend on how many times are asked for. Sums are formed in
//! chunks of fixed size, and the chunks are added in their order: the same bits
//! whatever the number of threads.
//!
//! Not for: stepping (an integrator carries one body after the other the same way, and
//! keeps nothing but states).

use rayon::prelude::*;
use rotation_dynamics::Result;
use rotation_dynamics::frame::SpaceVector;

/// Bodies that one thread takes at a time.
const CHUNK: usize = 512;

/// Times for which a body is kept at hand: enough that fetching it from memory does
/// not count, so few that the sums of all chunks stay small.
const TIMES: usize = 32;

/// Sums over the body axes of an ensemble.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Axes {
    count: usize,
    sum: [f64; 3],
    squared_tilt: f64,
}

impl Axes {
    /// One body more.
    fn push(&mut self, axis: SpaceVector) {
        let axis = axis.to_array();
        for (sum, component) in self.sum.iter_mut().zip(axis) {
            *sum += component;
        }
        self.squared_tilt += axis[2] * axis[2];
        self.count += 1;
    }

    fn add(mut self, other: &Self) -> Self {
        for (sum, more) in self.sum.iter_mut().zip(other.sum) {
            *sum += more;
        }
        self.squared_tilt += other.squared_tilt;
        self.count += other.count;
        self
    }

    /// The number of bodies.
    pub const fn count(&self) -> usize {
        self.count
    }

    /// The mean of the axes.
    pub fn mean(&self) -> SpaceVector {
        SpaceVector::from_array(self.sum.map(|sum| sum / self.count as f64))
    }

    /// The length of the mean's horizontal part: 0 when the azimuths are mixed.
    pub fn horizontal(&self) -> f64 {
        let [x, y, _] = self.mean().to_array();
        (x * x + y * y).sqrt()
    }

    /// The standard deviation of cos(theta).
    pub fn spread_of_tilt(&self) -> f64 {
        let mean = self.mean().z();
        (self.squared_tilt / self.count as f64 - mean * mean).max(0.0).sqrt()
    }
}

/// `number` bodies set up by `make`, in order.
///
/// # Errors
/// The first error of `make` that is met.
pub fn set_up<B: Send>(
    number: usize,
    make: impl Fn(usize) -> Result<B> + Sync + Send,
) -> Result<Vec<B>> {
    (0..number).into_par_iter().with_min_len(CHUNK).map(make).collect()
}

/// The axes of all bodies at each time, reduced as they are formed. Besides one [`Axes`]
/// for each time, the memory in use does not depend on how many times there are.
pub fn axes<B: Sync>(
    bodies: &[B],
    times: &[f64],
    axis: impl Fn(&B, f64) -> SpaceVector + Sync,
) -> Vec<Axes> {
    times
        .chunks(TIMES)
        .flat_map(|times| axes_of_chunks(bodies, times, &axis))
        .take(times.len())
        .collect()
}

/// The same at up to [`TIMES`] times.
fn axes_of_chunks<B: Sync>(
    bodies: &[B],
    times: &[f64],
    axis: &(impl Fn(&B, f64) -> SpaceVector + Sync),
) -> [Axes; TIMES] {
    let chunks: Vec<[Axes; TIMES]> = bodies
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut sums = [Axes::default(); TIMES];
            for body in chunk {
                for (sum, t) in sums.iter_mut().zip(times) {
                    sum.push(axis(body, *t));
                }
            }
            sums
        })
        .collect();
    let mut total = [Axes::default(); TIMES];
    for chunk in &chunks {
        for (total, sum) in total.iter_mut().zip(chunk) {
            *total = total.add(sum);
        }
    }
    total
}

/// The states of all bodies; as many as the shorter of the two lists has.
pub fn states<B: Sync, S: Send>(bodies: &[B], states: &mut [S], state: impl Fn(&B) -> S + Sync) {
    bodies.par_chunks(CHUNK).zip(states.par_chunks_mut(CHUNK)).for_each(|(bodies, states)| {
        for (body, slot) in bodies.iter().zip(states) {
            *slot = state(body);
        }
    });
}

/// The fraction in [0, 1) that is drawn for quantity `index` of body `body`: the same on
/// every machine and in every order (the mixing function of SplitMix64; G. L. Steele,
/// D. Lea, C. H. Flood, OOPSLA 2014).
pub fn drawn(body: usize, index: usize) -> f64 {
    let mut z = ((body as u64) << 8 | index as u64).wrapping_add(1);
    z = z.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(body: &f64, t: f64) -> SpaceVector {
        SpaceVector::new(body.sqrt() * t, 1.0 - body, *body)
    }

    /// More than are taken at once.
    fn times() -> Vec<f64> {
        (0..40).map(f64::from).collect()
    }

    fn pool(threads: usize) -> rayon::ThreadPool {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
    }

    /// 10 001 bodies, the last chunk is not full.
    fn bodies() -> Vec<f64> {
        set_up(10_001, |body| Ok(drawn(body, 0))).expect("numbers")
    }

    #[test]
    fn the_sums_are_the_same_bits_on_any_number_of_threads() {
        let bodies = bodies();
        let one = pool(1).install(|| axes(&bodies, &times(), axis));
        let mut others = 0;
        for threads in [2, 3, 7] {
            let many = pool(threads).install(|| axes(&bodies, &times(), axis));
            assert_eq!(one, many, "{threads} threads");
            others += 1;
        }
        assert_eq!(others, 3);
        assert_eq!(one.len(), 40);
        // Other chunks, other sums: the order is what keeps the bits.
        let mut differ = 0;
        for (t, mean) in times().into_iter().zip(&one) {
            assert_eq!(mean.count(), 10_001);
            let mut in_one_go = Axes::default();
            bodies.iter().for_each(|body| in_one_go.push(axis(body, t)));
            differ += usize::from(*mean != in_one_go);
            assert!((mean.mean() - in_one_go.mean()).norm() < 1e-12);
        }
        assert_eq!(differ, 40);
    }

    #[test]
    fn states_stand_in_the_order_of_the_bodies() {
        let bodies = bodies();
        let mut halves = vec![0.0; bodies.len()];
        pool(3).install(|| states(&bodies, &mut halves, |body| body * 0.5));
        assert!(bodies.iter().zip(&halves).all(|(b, h)| *h == b * 0.5));
    }

    #[test]
    fn draws_are_uniform() {
        let number = 100_000_u32;
        let draws: Vec<f64> = (0..number as usize).map(|body| drawn(body, 3)).collect();
        let count = f64::from(number);
        let mean = draws.iter().sum::<f64>() / count;
        let variance = draws.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
        // Three standard errors: 2.7e-3 and 7e-4.
        assert!((mean - 0.5).abs() < 2.7e-3, "{mean}");
        assert!((variance - 1.0 / 12.0).abs() < 7e-4, "{variance}");
        assert!(draws.iter().all(|x| (0.0..1.0).contains(x)));
    }
}
