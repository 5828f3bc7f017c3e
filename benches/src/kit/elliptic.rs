//! Families A and B: Jacobi's functions, Carlson's and Legendre's integrals.
//!
//! Rows: A `u m` (`_k` families: `u k`, `_m1`: `u m1`) -> `sn cn dn`;
//! B `operation arguments` -> the value.

use super::{Answer, numbers};
use rotation_dynamics::Result as Checked;
use rotation_dynamics::exact::{Characteristic, Modulus, carlson, jacobi, legendre};

/// The function for a family of part A or B.
pub fn answerer(family: &str) -> Option<fn(&[&str]) -> Answer> {
    let part = family.chars().next()?;
    let given_k = family.ends_with("_k");
    match part {
        'A' if given_k => Some(|row| jacobi_row(row, Modulus::from_k)),
        'A' if family.ends_with("_m1") => Some(|row| jacobi_row(row, Modulus::from_m1)),
        'A' => Some(|row| jacobi_row(row, Modulus::from_m)),
        'B' if given_k => Some(|row| integral_row(row, Modulus::from_k)),
        'B' => Some(|row| integral_row(row, Modulus::from_m)),
        _ => None,
    }
}

type ModulusFrom = fn(f64) -> Checked<Modulus>;

fn jacobi_row(row: &[&str], modulus: ModulusFrom) -> Answer {
    let [u, parameter] = *numbers(row)? else {
        return Err("a row of family A has two columns".into());
    };
    modulus(parameter)
        .and_then(|modulus| jacobi::sn_cn_dn(u, modulus))
        .map(|(sn, cn, dn)| vec![sn, cn, dn])
        .map_err(|e| e.to_string())
}

fn integral_row(row: &[&str], modulus: ModulusFrom) -> Answer {
    let (operation, columns) = row.split_first().ok_or("an empty row")?;
    let value = match (*operation, &*numbers(columns)?) {
        ("rf", &[x, y, z]) => carlson::rf(x, y, z),
        ("rc", &[x, y]) => carlson::rc(x, y),
        ("rd", &[x, y, z]) => carlson::rd(x, y, z),
        ("rj", &[x, y, z, p]) => carlson::rj(x, y, z, p),
        ("F", &[phi, m]) => modulus(m).and_then(|m| legendre::f(phi, m)),
        ("E", &[phi, m]) => modulus(m).and_then(|m| legendre::e(phi, m)),
        ("Pi", &[n, phi, m]) => {
            modulus(m).and_then(|m| Characteristic::from_n(n).and_then(|n| legendre::pi(n, phi, m)))
        }
        _ => return Err(format!("not an operation of family B: {}", row.join(" "))),
    };
    value.map(|v| vec![v]).map_err(|e| e.to_string())
}
