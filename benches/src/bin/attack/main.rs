//! Thousands of scenes made to break `solve`, each asked for two tolerances. Prints what
//! `benches/record/attack.txt` records.
//!
//! ```text
//! cargo run --release -p benches --bin attack -- kinked
//! ```
//!
//! Runs the attacks below whose name contains this word; all of them without a word.

#[cfg(test)]
mod tests;

use benches::attack::hostile::{self, unnamed_pulse};
use benches::attack::{attacked, held, kinked, laws, resisted, told};
use rotation_dynamics::Result;
use std::env;

type Attack = fn() -> Result<()>;

const ATTACKS: [(&str, Attack); 6] = [
    ("ten_thousand_scenes", ten_thousand_scenes),
    ("six_thousand_scenes_that_resist", six_thousand_scenes_that_resist),
    ("six_thousand_scenes_that_are_kinked", six_thousand_scenes_that_are_kinked),
    ("twelve_thousand_other_scenes_that_are_kinked", twelve_thousand_other_scenes_that_are_kinked),
    ("a_thousand_scenes_with_dozens_of_cusps", a_thousand_scenes_with_dozens_of_cusps),
    ("six_thousand_controls", six_thousand_controls),
];

fn main() -> Result<()> {
    let word = env::args().nth(1).unwrap_or_default();
    if !ATTACKS.iter().any(|(name, _)| name.contains(&word)) {
        let names = ATTACKS.map(|(name, _)| name).join(", ");
        eprintln!("there is no attack '{word}'; there are: {names}");
        std::process::exit(2);
    }
    for (name, attack) in ATTACKS.iter().filter(|(name, _)| name.contains(&word)) {
        println!("{name}");
        attack()?;
    }
    Ok(())
}

/// Of ten kinds, and two thousand pulses and bursts whose width nothing names. Seventeen minutes.
fn ten_thousand_scenes() -> Result<()> {
    held(&attacked(0..10_000, hostile::KINDS, hostile::case)?);
    held(&attacked(0..2000, 1, unnamed_pulse)?);
    Ok(())
}

fn six_thousand_scenes_that_resist() -> Result<()> {
    let chosen = resisted::Chosen::default();
    let case = |n| resisted::case(n, &chosen);
    held(&attacked(0..6000, resisted::KINDS, case)?);
    println!("{:?}", chosen.borrow());
    Ok(())
}

/// One is above its request, as the record says.
fn six_thousand_scenes_that_are_kinked() -> Result<()> {
    let attacked = attacked(0..6000, kinked::KINDS, kinked::case)?;
    told(&attacked);
    let (_, above) = attacked;
    assert_eq!(above.len(), 1);
    assert!(above[0].starts_with("jump in space 4247, 1e-12: 1.16"));
    Ok(())
}

fn twelve_thousand_other_scenes_that_are_kinked() -> Result<()> {
    held(&attacked(30_000..42_000, kinked::KINDS, kinked::case)?);
    Ok(())
}

fn a_thousand_scenes_with_dozens_of_cusps() -> Result<()> {
    held(&attacked(0..1000, 1, kinked::dozens)?);
    Ok(())
}

fn six_thousand_controls() -> Result<()> {
    held(&attacked(0..6000, laws::KINDS, laws::case)?);
    Ok(())
}
