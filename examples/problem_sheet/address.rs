//! The address at which a page's answer box judges for the numbers of a sheet:
//!
//! ```text
//! STEM.html?length=5.0&angle=0.40&sheet=CODE.CHECKSUM#check-your-answer
//! CODE      the checks, parted by `;`, in base64 (with - and _): key,value,bound,within,slip,slip…
//! CHECKSUM  of the stem, all parameters of the page and the code: FNV-1a, 64 bits, hexadecimal
//! ```
//! The box has no program that could compute, so the address brings what it judges by. That cannot
//! be read at a glance, but it is no secret. `book/theme/answer.js` reads it.

use super::draw::{Drawn, hash};
use super::exercise::asked;
use kit::{name_of_flag, rounded_up, supported_digits};

/// Name, value, unit and meaning of each parameter of the page, but for the error asked for.
pub fn parameters(drawn: &Drawn) -> Result<Vec<[String; 4]>, String> {
    let table = drawn.report.section("parameters").map_err(|e| e.to_string())?;
    let rows = table.as_ref().map_or(&[][..], |table| table.rows());
    let one = |row: &Vec<String>| {
        let name = name_of_flag(&row[0]).to_owned();
        let own = drawn.flags.iter().find(|(flag, _)| *flag == name);
        let value = own.map_or(&row[1], |(_, value)| value).clone();
        (name != "tolerance").then(|| [name, value, row[2].clone(), row[3].clone()])
    };
    Ok(rows.iter().filter_map(one).collect())
}

/// The address, without that of the book.
pub fn of(drawn: &Drawn) -> Result<String, String> {
    let check = |claim: &kit::Claim| {
        let slips = claim.slips.iter().map(|slip| supported_digits(slip.value, claim.bound));
        let (key, judged) = (claim.key.clone(), rounded_up(claim.judged_within));
        let fields = [key, claim.printed(), claim.printed_bound(), judged];
        fields.into_iter().chain(slips).collect::<Vec<String>>().join(",")
    };
    let checks: Vec<String> = asked(&drawn.report).into_iter().map(check).collect();
    let code = base64(checks.join(";").as_bytes());
    let code = code.replace('+', "-").replace('/', "_").replace('=', "");
    let stem = drawn.exercise.page.stem();
    let all = parameters(drawn)?.into_iter().map(|[name, value, ..]| format!("{name}={value}"));
    let all = all.collect::<Vec<_>>().join("&");
    let sum = hash(&format!("{stem}?{all}&sheet={code}"));
    let own = drawn.flags.iter().map(|(flag, value)| format!("{flag}={value}"));
    let own = own.collect::<Vec<_>>().join("&");
    Ok(format!("{stem}.html?{own}&sheet={code}.{sum:016x}#check-your-answer"))
}

/// Bytes in base64 (RFC 4648), as fonts stand in a style sheet.
pub fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let all = three.iter().fold(0, |all, byte| all << 8 | u32::from(*byte));
        let all = all << (8 * (3 - three.len()));
        for n in 0..4 {
            let letter = LETTERS[(all >> (18 - 6 * n)) as usize & 63];
            text.push(if n <= three.len() { letter.into() } else { '=' });
        }
    }
    text
}
