//! Putting things in order by a number: one sort for all of them. Written with `sort_by`,
//! each kind of thing would bring a sort of its own, of 10 kB each.

/// The places of these numbers, the least first; of equal ones, the first first.
pub fn order_of(numbers: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..numbers.len()).collect();
    order.sort_by(|&i, &j| numbers[i].total_cmp(&numbers[j]));
    order
}

/// The same of three, without a list.
pub(crate) fn order_of_three(numbers: [f64; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if numbers[order[i]].total_cmp(&numbers[order[j]]).is_gt() {
            order.swap(i, j);
        }
    }
    order
}

/// Puts things in the order of a number that each has, the least first; things with equal
/// numbers stay as they were.
pub fn sort_by_number<T: Clone>(things: &mut [T], number: impl Fn(&T) -> f64) {
    let numbers: Vec<f64> = things.iter().map(number).collect();
    let sorted: Vec<T> = (order_of(&numbers).iter()).map(|i| things[*i].clone()).collect();
    things.clone_from_slice(&sorted);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the standard library's sort, with equal numbers among them.
    #[test]
    fn as_the_standard_sort() {
        let mut dice = 1_u64;
        let mut things: Vec<(f64, usize)> = (0..200)
            .map(|n| {
                dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                ((dice >> 59) as f64 - 16.0, n)
            })
            .collect();
        let mut standard = things.clone();
        standard.sort_by(|a, b| a.0.total_cmp(&b.0));
        sort_by_number(&mut things, |thing| thing.0);
        assert_eq!(things, standard);
        // The damaged twin does not keep equal ones in order.
        standard.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
        assert_ne!(things, standard);
        let mut ran = 0;
        for (a, b, c) in (0..27).map(|n| (n % 3, n / 3 % 3, n / 9)) {
            let numbers = [a, b, c].map(f64::from);
            assert_eq!(order_of_three(numbers).to_vec(), order_of(&numbers));
            ran += 1;
        }
        assert_eq!(ran, 27);
    }
}
