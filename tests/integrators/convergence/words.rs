//! Order conditions, all of them: a scheme as a product of exponentials.
//!
//! With operators A (flow) and B (kick) that need not commute, a step is
//! exp(a1 A) exp(b1 B) ...; it has order p if every word of at most p letters has
//! the coefficient that it has in exp(A + B), 1/(number of letters)!.

use rotation_dynamics::integrators::Scheme;
use rotation_dynamics::integrators::splitting::Outer;
use support::Errors;

const LONGEST: usize = 10;

/// Coefficients of the words, by length and by the letters as bits (B is 1).
fn expanded(scheme: &Scheme) -> Vec<Vec<f64>> {
    let mut words: Vec<Vec<f64>> = (0..=LONGEST).map(|n| vec![0.0; 1 << n]).collect();
    words[0][0] = 1.0;
    let (first, second) = match scheme.outer {
        Outer::Flow => (0, 1),
        Outer::Kick => (1, 0),
    };
    for (i, part) in scheme.outer_parts.iter().enumerate() {
        words = times_exponential(&words, *part, first);
        if let Some(part) = scheme.inner_parts.get(i) {
            words = times_exponential(&words, *part, second);
        }
    }
    words
}

fn times_exponential(words: &[Vec<f64>], part: f64, letter: usize) -> Vec<Vec<f64>> {
    let mut product = words.to_vec();
    for (length, coefficients) in words.iter().enumerate() {
        for (word, &coefficient) in coefficients.iter().enumerate() {
            let (mut term, mut longer) = (coefficient, word);
            for more in 1..=LONGEST - length {
                term *= part / more as f64;
                longer = 2 * longer + letter;
                product[length + more][longer] += term;
            }
        }
    }
    product
}

/// The largest defect of the words with `kicks` letters B that have this many
/// letters, and how many words those are; 0 if there are none.
fn defect(words: &[Vec<f64>], length: usize, kicks: impl Fn(u32) -> bool) -> (f64, usize) {
    let factorial: f64 = (1..=length).map(|n| n as f64).product();
    let words = words[length].iter().enumerate();
    let chosen = words.filter(|(word, _)| kicks(word.count_ones()));
    let mut defects = Errors::of("words");
    let mut ran = 0;
    for (word, coefficient) in chosen {
        defects.push_at(coefficient - 1.0 / factorial, word);
        ran += 1;
    }
    (defects.largest(), ran)
}

/// The longest words that are right, for at most one letter B, two, and three or more.
fn orders(scheme: &Scheme) -> [usize; 3] {
    let words = expanded(scheme);
    let mut ran = 0;
    let orders = [(|n| n <= 1) as fn(u32) -> bool, |n| n == 2, |n| n >= 3].map(|kicks| {
        (1..=LONGEST)
            .take_while(|&length| {
                let (worst, count) = defect(&words, length, kicks);
                ran += count;
                // Measured: at most 2.1e-16. Beyond the order: at least 7e-9.
                worst <= 2.1e-16
            })
            .count()
    });
    assert!(ran >= 9, "{ran}");
    orders
}

const SCHEMES: [(Scheme, [usize; 3]); 7] = [
    (Scheme::STRANG, [2, 2, 3]),
    // Nyström's schemes may be wrong in words with three kicks or more, where
    // [B, [B, [B, A]]] = 0 helps.
    (Scheme::SRKN6, [4, 4, 4]),
    (Scheme::SRKN14, [6, 6, 4]),
    (Scheme::KAHAN_LI17, [8, 8, 8]),
    (Scheme::ABA82, [8, 2, 3]),
    (Scheme::ABA104, [10, 4, 4]),
    (Scheme::ABA1064, [10, 6, 4]),
];

#[test]
fn every_word_up_to_the_order() {
    let mut damaged = 0;
    for (scheme, want) in SCHEMES {
        assert_eq!(orders(&scheme), want, "{}", scheme.name);
        // Two coefficients off by 1e-13, their sum and the symmetry kept.
        let parts = scheme.outer_parts;
        let last = parts.len() - 1;
        for i in 0..(parts.len() - 1) / 2 {
            let mut parts = parts.to_vec();
            parts[i] += 1e-13;
            parts[last - i] += 1e-13;
            parts[last / 2] -= 1e-13;
            parts[last - last / 2] -= 1e-13;
            let scheme = Scheme { outer_parts: parts.leak(), ..scheme };
            assert!(orders(&scheme) < want, "{} {i}", scheme.name);
            damaged += 1;
        }
    }
    assert_eq!(damaged, 27);
}
