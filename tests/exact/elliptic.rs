//! Elliptic functions and integrals against 40-digit references
//! (tests/data/elliptic.json), identities that share no code with them, and inputs
//! that must be refused.

use rotation_dynamics::exact::jacobi::Jacobi;
use rotation_dynamics::exact::{Characteristic, Modulus, carlson, legendre};
use rotation_dynamics::math::{EPS, cos, double_double::two_sum, sin};
use rotation_dynamics::{Error, Result};
use serde_json::Value;
use support::{Errors, assert_largest, assert_table, relative};

/// The families of the references.
fn families() -> Vec<String> {
    let data: Value = serde_json::from_str(include_str!("../data/elliptic.json")).expect("JSON");
    let families = data["families"].as_object().expect("families").keys();
    families.cloned().collect()
}

fn answers(family: &str, arguments: &[f64]) -> Result<Vec<f64>> {
    let jacobi_row = |modulus: Result<Modulus>| {
        let functions = Jacobi::new(modulus?);
        let (sn, cn, dn) = functions.sn_cn_dn(arguments[0])?;
        Ok(vec![sn, cn, dn, functions.am(arguments[0])?])
    };
    let last = arguments[arguments.len() - 1];
    let (m, m1) = (|| Modulus::from_m(last), || Modulus::from_m1(last));
    let one = |value: f64| vec![value];
    Ok(one(match (family, arguments) {
        ("jacobi_k", _) => return jacobi_row(Modulus::from_k(last)),
        ("jacobi_m1", _) => return jacobi_row(m1()),
        (name, _) if name.starts_with("jacobi") => return jacobi_row(m()),
        ("rf", &[x, y, z]) => carlson::rf(x, y, z)?,
        ("rc", &[x, y]) => carlson::rc(x, y)?,
        ("rd", &[x, y, z]) => carlson::rd(x, y, z)?,
        ("rj", &[x, y, z, p]) => carlson::rj(x, y, z, p)?,
        ("f", &[phi, _]) => legendre::f(phi, m()?)?,
        ("e", &[phi, _]) => legendre::e(phi, m()?)?,
        ("d", &[phi, _]) => legendre::d(phi, m()?)?,
        ("f_m1", &[phi, _]) => legendre::f(phi, m1()?)?,
        ("e_m1", &[phi, _]) => legendre::e(phi, m1()?)?,
        ("d_m1", &[phi, _]) => legendre::d(phi, m1()?)?,
        ("pi", &[n, phi, _]) => legendre::pi(Characteristic::from_n(n)?, phi, m()?)?,
        ("pi_n1_m1", &[n1, phi, _]) => legendre::pi(Characteristic::from_n1(n1)?, phi, m1()?)?,
        ("k", _) => legendre::k(m()?)?,
        ("k_m1", _) => legendre::k(m1()?)?,
        ("complete_e", _) => legendre::complete_e(m()?),
        ("complete_e_m1", _) => legendre::complete_e(m1()?),
        ("complete_d", _) => legendre::complete_d(m()?)?,
        ("complete_d_m1", _) => legendre::complete_d(m1()?)?,
        ("complete_pi", &[n, _]) => legendre::complete_pi(Characteristic::from_n(n)?, m()?)?,
        ("complete_pi_n1_m1", &[n1, _]) => {
            legendre::complete_pi(Characteristic::from_n1(n1)?, m1()?)?
        }
        other => panic!("unknown family {other:?}"),
    }))
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|v| v.as_f64().expect("a number")).collect()
}

/// The errors of a family, one per value, in units of 2^-53 (|value| + condition), with the
/// first argument multiplied by 1 - `damage`.
fn errors(family: &str, damage: f64) -> Errors {
    let data: Value = serde_json::from_str(include_str!("../data/elliptic.json")).expect("JSON");
    let rows = data["families"][family].as_array().expect("a family");
    let mut errors = Errors::in_units_of(EPS, family);
    for row in rows {
        let mut arguments = numbers(&row["arguments"]);
        arguments[0] *= 1.0 - damage;
        let got = answers(family, &arguments).expect("an answer");
        let wanted = row["results"].as_array().expect("results");
        assert_eq!(got.len(), wanted.len());
        for (i, (got, want)) in got.iter().zip(wanted).enumerate() {
            let text = want["value"].as_str().expect("digits");
            let high: f64 = text.parse().expect("a number");
            let low = want["low"].as_f64().expect("a number");
            // Exact difference of the nearest doubles, then the rest of the reference.
            let (difference, rest) = two_sum(*got, -high);
            let error = (difference - low + rest).abs();
            let condition = row.get("condition").map_or(0.0, |c| numbers(c)[i]);
            errors.push_at(relative(error, 0.0, high.abs() + condition), &arguments);
        }
    }
    errors
}

#[test]
fn references_to_half_a_unit_in_the_last_place() {
    let all: Vec<Errors> = families().iter().map(|f| errors(f, 0.0)).collect();
    assert_table!(&all, @"
    complete_d: 0.904 of 8
    complete_d_m1: 0.904 of 10
    complete_e: 0.686 of 8
    complete_e_m1: 0.923 of 10
    complete_pi: 0.656 of 7
    complete_pi_n1_m1: 0.742 of 6
    d: 0.625 of 18
    d_m1: 0.843 of 6
    e: 0.986 of 22
    e_m1: 0.891 of 6
    f: 0.896 of 21
    f_m1: 0.733 of 6
    jacobi_far: 0.322 of 32
    jacobi_far_near_one: 0.545 of 40
    jacobi_generic: 0.556 of 84
    jacobi_k: 0.466 of 36
    jacobi_m1: 0.610 of 52
    jacobi_near_one: 0.508 of 52
    jacobi_small: 0.434 of 32
    k: 0.481 of 8
    k_m1: 0.648 of 10
    pi: 0.631 of 20
    pi_n1_m1: 0.799 of 10
    rc: 0.693 of 27
    rd: 0.610 of 23
    rf: 0.898 of 23
    rj: 0.894 of 34
    ");
}

#[test]
fn damaged_argument_fails_in_every_family() {
    for family in families() {
        assert!(errors(&family, 1e-14).largest() > 10.0, "{family}");
    }
}

#[test]
fn forms_that_cancel_fail_where_ours_hold() -> Result<()> {
    // cn and dn from sn, next to m = 1: sn has rounded to -1.
    let (u, m) = (-19.272227646232718, 1.0 - 2.0 * EPS);
    let (sn, cn, dn) = Jacobi::new(Modulus::from_m(m)?).sn_cn_dn(u)?;
    let (cn_naive, dn_naive) = ((1.0 - sn * sn).sqrt(), (1.0 - m * sn * sn).sqrt());
    assert_eq!(cn_naive, 0.0);
    assert!(cn > 2.0e-9);
    assert!(relative(dn_naive, dn, dn) > 8e13 * EPS); // measured 8.3e13
    // 1 - m sin^2 phi as written, next to phi = pi/2 and m = 1.
    let (phi, m) = (1.5707963164346344, 1.0 - 2.0 * EPS);
    let (s, c) = (sin(phi), cos(phi));
    let naive = s * carlson::rf(c * c, 1.0 - m * s * s, 1.0)?;
    let exact = legendre::f(phi, Modulus::from_m(m)?)?;
    assert!(relative(naive, exact, exact) > 4e13 * EPS); // measured 5e13
    Ok(())
}

#[test]
fn legendre_relation() -> Result<()> {
    // E K' + E' K - K K' = pi/2, in units of 2^-53 K K'.
    let mut errors = Errors::in_units_of(EPS, "Legendre's relation");
    for i in 1..100 {
        let m = Modulus::from_m(f64::from(i) / 100.0)?;
        let other = m.complement();
        let (k, k1) = (legendre::k(m)?, legendre::k(other)?);
        let (e, e1) = (legendre::complete_e(m), legendre::complete_e(other));
        let rest = e * k1 + e1 * k - k * k1 - core::f64::consts::FRAC_PI_2;
        errors.add(rest, 0.0, k * k1);
    }
    assert_largest!(errors, 99, @"2.27");
    Ok(())
}

#[test]
fn addition_theorem() -> Result<()> {
    // DLMF 22.8.1, on arguments whose sum is exact.
    let mut errors = Errors::in_units_of(EPS, "addition theorem");
    for m in [0.0, 0.2, 0.5, 0.7, 0.99, 1.0] {
        let functions = Jacobi::new(Modulus::from_m(m)?);
        for i in -20..=20 {
            for j in -20..=20 {
                let (u, v) = (f64::from(i) / 8.0, f64::from(j) / 16.0);
                let (s, c, d) = functions.sn_cn_dn(u)?;
                let (s2, c2, d2) = functions.sn_cn_dn(v)?;
                let sum = (s * c2 * d2 + s2 * c * d) / (1.0 - m * s * s * s2 * s2);
                let direct = functions.sn_cn_dn(u + v)?.0;
                errors.push(sum - direct);
            }
        }
    }
    assert_largest!(errors, 6 * 41 * 41, @"5");
    Ok(())
}

#[test]
fn first_kind_undoes_the_amplitude() -> Result<()> {
    // F(am u) = u; the rounded amplitude moves it by am/dn, the rounded u by u.
    let mut errors = Errors::in_units_of(EPS, "F(am u)");
    for m1 in [1.0, 0.8, 0.5, 0.3, 1e-3, 1e-10] {
        let modulus = Modulus::from_m1(m1)?;
        let functions = Jacobi::new(modulus);
        for i in -300..=300 {
            let u = f64::from(i) * 0.1;
            let am = functions.am(u)?;
            let dn = functions.sn_cn_dn(u)?.2;
            let back = legendre::f(am, modulus)?;
            let condition = u.abs() + (am / dn).abs();
            errors.add(back, u, condition);
        }
    }
    assert_largest!(errors, 6 * 601, @"0.895");
    Ok(())
}

#[test]
fn symmetric_integrals_reduce_to_elementary_ones() -> Result<()> {
    let mut rd = Errors::in_units_of(EPS, "sum of three R_D");
    let mut rj = Errors::in_units_of(EPS, "R_J of equal arguments");
    for x in [0.01, 0.3, 1.0, 7.0] {
        for y in [0.02, 0.5, 2.0, 90.0] {
            for z in [0.05, 0.7, 3.0, 1e4] {
                // DLMF 19.21.9: the three R_D add up to 3/sqrt(xyz).
                let sum = carlson::rd(x, y, z)? + carlson::rd(y, z, x)? + carlson::rd(z, x, y)?;
                let whole = 3.0 / (x * y * z).sqrt();
                rd.add(sum, whole, whole);
                // DLMF 19.20.8: R_J(x, y, y, p) = 3 (R_C(x, y) - R_C(x, p))/(p - y).
                let (a, b) = (carlson::rc(x, y)?, carlson::rc(x, z)?);
                let elementary = 3.0 * (a - b) / (z - y);
                let condition = 3.0 * (a + b) / (z - y).abs();
                let rest = carlson::rj(x, y, y, z)? - elementary;
                rj.add(rest, 0.0, condition);
            }
        }
    }
    assert_largest!(rd, 64, @"1.98");
    assert_largest!(rj, 64, @"1.72");
    Ok(())
}

#[test]
fn symmetries_hold_bit_for_bit() -> Result<()> {
    let up = 2.0_f64.powi(200);
    let four = up * up;
    assert_eq!(carlson::rf(four, 2.0 * four, 0.3 * four)? * up, carlson::rf(1.0, 2.0, 0.3)?);
    assert_eq!(carlson::rc(1.0 / four, 0.3 / four)? / up, carlson::rc(1.0, 0.3)?);
    assert_eq!(
        carlson::rj(four, 2.0 * four, 0.3 * four, 0.1 * four)? * up * up * up,
        carlson::rj(1.0, 2.0, 0.3, 0.1)?
    );
    let (m, n) = (Modulus::from_m(0.8)?, Characteristic::from_n(-0.4)?);
    for phi in [0.3, 1.4, 2.0, 8.0] {
        assert_eq!(legendre::f(-phi, m)?, -legendre::f(phi, m)?);
        assert_eq!(legendre::e(-phi, m)?, -legendre::e(phi, m)?);
        assert_eq!(legendre::d(-phi, m)?, -legendre::d(phi, m)?);
        assert_eq!(legendre::pi(n, -phi, m)?, -legendre::pi(n, phi, m)?);
        let functions = Jacobi::new(m);
        let (sn, cn, dn) = functions.sn_cn_dn(phi)?;
        assert_eq!(functions.sn_cn_dn(-phi)?, (-sn, cn, dn));
        assert_eq!(functions.am(-phi)?, -functions.am(phi)?);
    }
    Ok(())
}

#[test]
fn bad_input_is_refused_with_its_numbers() -> Result<()> {
    let m = Modulus::from_m(0.5)?;
    let one = Modulus::from_m(1.0)?;
    let n = Characteristic::from_n(0.5)?;
    let at_pole = Characteristic::from_n(1.0)?;
    let beyond = Characteristic::from_n(4.0)?;
    let out_of_range = [
        Modulus::from_m(1.0 + 2.0 * EPS).map(|m| m.m()),
        Modulus::from_m(-1e-300).map(|m| m.m()),
        Modulus::from_m1(-1e-300).map(|m| m.m()),
        Modulus::from_m1(1.5).map(|m| m.m()),
        Modulus::from_k(-0.5).map(|m| m.m()),
        Characteristic::from_n(-1e301).map(|n| n.n()),
        carlson::rf(-1.0, 2.0, 3.0),
        carlson::rf(0.0, 0.0, 1.0),
        carlson::rf(0.0, 0.0, 0.0),
        carlson::rf(1e-160, 1.0, 1e160),
        carlson::rc(1.0, 0.0),
        carlson::rc(1.0, -1.0),
        carlson::rd(1.0, 2.0, 0.0),
        carlson::rd(0.0, 0.0, 2.0),
        carlson::rd(1e-250, 1e-250, 1e-250),
        carlson::rd(1e250, 1e250, 1e250),
        carlson::rj(1.0, 2.0, 3.0, 0.0),
        carlson::rj(1.0, 2.0, 3.0, -1.0),
        carlson::rj(0.0, 2.0, 0.0, 1.0),
        legendre::k(one),
        legendre::complete_d(one),
        legendre::complete_pi(n, one),
        legendre::complete_pi(at_pole, m),
        legendre::f(2.0, one),
        legendre::f(2e15, m),
        legendre::d(2.0, one),
        legendre::pi(n, 2.0, one),
        legendre::pi(at_pole, 2.0, m),
        legendre::pi(beyond, 0.6, m),
        Jacobi::new(m).am(1e16),
    ];
    for (i, result) in out_of_range.iter().enumerate() {
        assert!(matches!(result, Err(Error::OutOfRange { .. })), "{i}: {result:?}");
    }
    let not_finite = [
        Modulus::from_m(f64::NAN).map(|m| m.m()),
        Modulus::from_m1(f64::INFINITY).map(|m| m.m()),
        Modulus::from_k(f64::NAN).map(|m| m.m()),
        Characteristic::from_n(f64::NAN).map(|n| n.n()),
        Characteristic::from_n1(f64::NEG_INFINITY).map(|n| n.n()),
        carlson::rf(1.0, f64::NAN, 1.0),
        carlson::rc(f64::INFINITY, 1.0),
        carlson::rd(1.0, 1.0, f64::NAN),
        carlson::rj(1.0, 1.0, 1.0, f64::NAN),
        legendre::f(f64::NAN, m),
        legendre::e(f64::INFINITY, m),
        legendre::d(f64::NAN, m),
        legendre::pi(n, f64::NAN, m),
        Jacobi::new(one).sn_cn_dn(f64::NAN).map(|v| v.0),
        Jacobi::new(m).am(f64::INFINITY),
    ];
    for (i, result) in not_finite.iter().enumerate() {
        assert!(matches!(result, Err(Error::NotFinite { .. })), "{i}: {result:?}");
    }
    Ok(())
}
