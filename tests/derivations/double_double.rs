//! The page `how_double_double`: exact sums and products, the nome without a difference, the
//! quarter period, and the step that doubles the digits of an argument.

use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::math::double_double::{two_product, two_sum};
use rotation_dynamics::math::{DoubleDouble as Dd, EPS, atan, atan2, cos, pow, sin};
use support::{Errors, assert_largest};

/// A whole number below 2^53 that goes its own way with `n`.
fn whole(n: u64) -> i64 {
    let mixed = (n + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 11) as i64 - (1 << 52)
}

#[test]
fn pairs_are_exact() {
    // Against whole numbers of 128 bits: the sum of a and b 2^k, and the product.
    let apart = |damage: bool| {
        let mut wrong = 0;
        for n in 0..2000 {
            let (a, b) = (whole(n), whole(n + 5000));
            let shift = n % 11;
            let (hi, lo) = two_sum(a as f64, (b as f64) * pow(2.0, shift as f64));
            let lo = if damage { 0.0 } else { lo };
            let want = i128::from(a) + (i128::from(b) << shift);
            wrong += u32::from(hi as i128 + lo as i128 != want);
            let (hi, lo) = two_product(a as f64, b as f64);
            let lo = if damage { 0.0 } else { lo };
            wrong += u32::from(hi as i128 + lo as i128 != i128::from(a) * i128::from(b));
        }
        wrong
    };
    assert_eq!(apart(false), 0);
    // The rounded values alone.
    assert!(apart(true) > 3000);
}

#[test]
fn a_root_gains_as_many_digits_again() {
    // r + (a - r^2)/2r of the rounded root r: what is left is (a - r^2)^2/8r^3.
    let mut errors = Errors::of("square of the root, relative");
    let mut plain = Errors::of("square of the rounded root, relative");
    for n in 1..200 {
        let a = Dd::from(f64::from(n)) / 7.0;
        let root = a.to_f64().sqrt();
        let rest = a - Dd::product(root, root);
        let better = Dd::from(root) + rest / (2.0 * root);
        errors.push_at((better.square() / a - 1.0).to_f64(), n);
        plain.push_at((Dd::product(root, root) / a - 1.0).to_f64(), n);
    }
    assert_largest!(errors, 199, @"2.62e-32");
    assert!(plain.largest() > 1e-16);
}

#[test]
fn a_root_leaves_nine_eighths_of_a_squared_rounding() {
    // (a - r^2)^2/8r^4 over eps^2, where both roundings, of a and of the root, are as large as
    // can be, and over many others.
    let left = |a: Dd| {
        let root = a.to_f64().sqrt();
        let rest = (a - Dd::product(root, root)).to_f64() / (EPS * root * root);
        rest * rest / 8.0
    };
    let mut errors = Errors::of("what one step of Newton leaves of a root, over eps^2");
    // All but half of the last bit of a number from 1 to 2: a half goes to the even neighbour.
    let low = EPS * (1.0 - EPS);
    errors.push_at(left(Dd::sum(1.0 + 2.0 * EPS, low)), 0);
    for n in 0..2000 {
        let a = 1.0 + 3.0 * (whole(n) as f64 * EPS).abs();
        errors.push_at(left(Dd::sum(a, low)), n);
    }
    assert_largest!(errors, 2001, @"1.12");
    // With the root's own rounding alone it is less.
    assert!(left(Dd::from(1.0 + 2.0 * EPS)) <= 0.5);
}

/// lambda of the nome: (q + q^9 + q^25)/(1 + 2 q^4 + 2 q^16).
fn lambda(q: Dd) -> Dd {
    let power = |n: u32| (0..n).fold(Dd::ONE, |product, _| product * q);
    (power(1) + power(9) + power(25)) / (power(4) * 2.0 + power(16) * 2.0 + 1.0)
}

/// K by the mean of 1 and k'.
fn quarter(m1: Dd) -> Dd {
    let (mut a, mut b) = (Dd::ONE, m1.sqrt());
    for _ in 0..12 {
        (a, b) = ((a + b) * 0.5, (a * b).sqrt());
    }
    Dd::FRAC_PI_2 / a
}

#[test]
fn nome_comes_by_a_series_without_a_difference() {
    const SERIES: [f64; 12] = [
        1.0,
        2.0,
        15.0,
        150.0,
        1707.0,
        20_910.0,
        268_616.0,
        3_567_400.0,
        48_555_069.0,
        673_458_874.0,
        9_481_557_398.0,
        135_119_529_972.0,
    ];
    let errors = |damage: f64| {
        let mut errors = Errors::of("lambda of the nome, K and K', relative");
        for m in [1e-30, 1e-6, 0.1, 0.5, 0.8] {
            let (m, m1) = (Dd::from(m), 1.0 - Dd::from(m));
            let k1 = m1.sqrt();
            let spread = (k1.sqrt() + 1.0).square();
            let small = m / (spread * (k1 + 1.0) * 2.0);
            let x = small.square().square() * damage;
            let series = SERIES.iter().rev().fold(Dd::ZERO, |sum, c| sum * x + *c);
            let q = small * series;
            errors.push_at((lambda(q) / small - 1.0).to_f64(), m.to_f64());
            // 2 theta_3(q^4) = theta_3(q) (1 + sqrt k').
            let q4 = q.square().square() * damage;
            let outer = q4 * 2.0 + q4.square().square() * 2.0 + 1.0;
            let own = Dd::FRAC_PI_2 * outer.square() * 4.0 / spread;
            errors.push_at((own / quarter(m1) - 1.0).to_f64(), m.to_f64());
            let conjugate = -(own * q.ln()) / Dd::PI;
            errors.push_at((conjugate / quarter(m) - 1.0).to_f64(), m.to_f64());
        }
        errors
    };
    assert_largest!(errors(1.0), 5 * 3, @"2.87e-32");
    assert!(errors(1.01).largest() > 1e-6);
    // (1 - sqrt k')/2(1 + sqrt k') as it stands, in doubles.
    let plainly = |m: f64| {
        let root = (1.0 - m).sqrt().sqrt();
        (1.0 - root) / (2.0 * (1.0 + root))
    };
    let product = |m: f64| {
        let k1 = (1.0 - m).sqrt();
        let root = k1.sqrt();
        m / (2.0 * (1.0 + root) * (1.0 + root) * (1.0 + k1))
    };
    let m = 1e-9;
    let better = {
        let k1 = (1.0 - Dd::from(m)).sqrt();
        (Dd::from(m) / ((k1.sqrt() + 1.0).square() * (k1 + 1.0) * 2.0)).to_f64()
    };
    assert_eq!(product(m), better);
    assert!((plainly(m) / better - 1.0).abs() > 1e-9);
}

#[test]
fn one_step_doubles_the_digits_of_an_argument() {
    // sc^2 = tan^2 z (theta_1/sin over theta_2/cos)^2/k' with z by doubles, and its Newton step.
    let mut before = Errors::of("sc^2 before, relative");
    let mut after = Errors::of("sc^2 after, relative");
    let mut damaged = Errors::of("sc^2 after a step of half the length, relative");
    for m in [0.1, 0.5, 0.8] {
        let (dm, m1) = (Dd::from(m), 1.0 - Dd::from(m));
        let k1 = m1.sqrt();
        let per_angle = quarter(m1) / Dd::FRAC_PI_2;
        let q = (-(Dd::PI * quarter(dm) / quarter(m1))).exp();
        let square = |z: Dd| {
            let (mut one, mut two) = (Dd::ZERO, Dd::ZERO);
            let mut weight = Dd::ONE;
            for n in 0..9 {
                let (s, c) = (z * f64::from(2 * n + 1)).sin_cos();
                one += s * weight * if n % 2 == 0 { 1.0 } else { -1.0 };
                two += c * weight;
                weight = weight * (0..2 * (n + 1)).fold(Dd::ONE, |product, _| product * q);
            }
            (one / two).square() / k1
        };
        for part in [0.01, 0.3, 1.0, 1.4] {
            let (num, den) = (Dd::from(part), k1);
            let modulus = Modulus::from_m(m).expect("below 1");
            let amplitude = atan((num / den).to_f64().sqrt());
            let u = legendre::f(amplitude, modulus).expect("finite");
            let z = u / per_angle.to_f64();
            let lacks = (num / den - square(Dd::from(z))) / square(Dd::from(z));
            // d ln sc^2/du = 2 dn/(sn cn).
            let (n, d) = (num.to_f64(), den.to_f64());
            let slope = 2.0 * (((d + m1.to_f64() * n) / d) * ((d + n) / n)).sqrt();
            let step = lacks.to_f64() / (slope * per_angle.to_f64());
            let off = |z: Dd| (square(z) * den / num - 1.0).to_f64();
            before.push_at(off(Dd::from(z)), (m, part));
            after.push_at(off(Dd::sum(z, step)), (m, part));
            damaged.push_at(off(Dd::sum(z, 0.5 * step)), (m, part));
        }
    }
    assert!(before.largest() > 1e-17 && before.largest() < 1e-14);
    assert_largest!(after, 12, @"3.94e-31");
    assert!(damaged.largest() > 1e-17);
}

#[test]
fn an_arc_tangent_is_turned_back() {
    // guess + across/along: what is left is a third of the cube of a rounding.
    let errors = |third: f64| {
        let mut errors = Errors::of("angle, turned back by hand");
        for n in 0..60 {
            let angle = Dd::from(0.1 * f64::from(n) - 3.0);
            let (y, x) = angle.sin_cos();
            // A guess that is off by 1e-3 leaves 3e-10.
            let guess = atan2(y.to_f64(), x.to_f64()) + third;
            let (s, c) = (sin(guess), cos(guess));
            let (across, along) =
                (y.to_f64() * c - x.to_f64() * s, x.to_f64() * c + y.to_f64() * s);
            errors.push_at(guess + across / along - angle.to_f64(), n);
        }
        errors
    };
    assert_largest!(errors(0.0), 60, @"1.11e-16");
    assert_largest!(errors(1e-3), 60, @"3.33e-10");
    let mut library = Errors::of("the same in pairs");
    for n in 0..60 {
        let angle = Dd::from(0.1 * f64::from(n) - 3.0);
        let (y, x) = angle.sin_cos();
        library.push_at((y.atan2(x) - angle).to_f64(), n);
    }
    assert_largest!(library, 60, @"1.23e-32");
}
