//! The precession of the equinoxes. That each level of simulation confirms the formulas is part
//! of the report; here they are asked for other Earths and Moons, and damaged twins miss.

use crate::told::{cell, confirmed, refused, value};
use pages::effects_4_equinoxes::*;

#[test]
fn every_earth_and_moon_is_confirmed() {
    let runs = [
        "--obliquity=0.2",
        "--obliquity=0.7 --moon-inclination=0",
        "--ellipticity=0.01 --days=5",
    ];
    confirmed(&EXAMPLE, runs, 3);
}
