//! The exercises, a row each: numbers that are known otherwise, other numbers that the page must
//! confirm, and refusals by their words. Single parameters over their ranges are in `ranges`.

use crate::answers::{computed, confirmed, page, refused};
use pages::WHOLE;
use support::{EPS, Errors, assert_table};

/// An exercise, its flags, and claims with their values: the instances of the notes, to 15 digits, and
/// cases of the reference, to 25.
type Instance = (&'static str, &'static str, &'static [(&'static str, f64)]);

const INSTANCES: [Instance; 21] = [
    ("ch15_ex1_two_discs", "", &[("common", 8.75), ("lost", 23.4375), ("time", 1.875)]),
    ("ch15_ex2_gears", "", &[("rate_b", -60.0), ("momentum", 0.3), ("motor", 0.6)]),
    ("ch15_ex3_coins", "", &[("omega", 16.0 / 3.0), ("momentum", 2.432e-5), ("energy", 3.072e-5)]),
    ("ch15_ex5_centre_of_percussion", "", &[("centre", 0.566_666_666_666_667), ("reaction", 0.235_294_117_647_059)]),
    ("ch15_ex6_cone", "", &[
        ("omega", -3.547_833_630_058_67), ("l_rho", -0.089_755_429_562_472_2), ("l_up", 0.131_291_554_321_4),
        ("energy", 0.159_218_665_741_05), ("omega_tip", 6.231_600_004_822_99), ("turns", 2.567_932_455_547_78),
    ]),
    ("ch15_ex7_raised_cone", "", &[
        ("omega_rho", -3.547_833_630_058_67), ("l_rho", -0.034_246_250_717_791_1), ("l_up", 0.169_239_541_285_344),
        ("energy", 0.187_679_655_964_008), ("pressure", 14.881_206_253_589),
    ]),
    ("ch15_ex8_string", "", &[
        ("force", 2.304), ("angular_velocity", 4.8), ("speed", 2.402_082_429_892_863), ("angle", 9.0), ("work", 0.351),
    ]),
    ("ch15_ex9_dumbbell", "", &[
        ("v_ball", 1.0), ("v_cm", 2.0), ("omega", 20.0 / 3.0), ("v_hit", 4.0), ("impulse", 1.0), ("v_other", 0.0),
    ]),
    ("ch16_ex1_atwood", "", &[("a", 1.400_95), ("t1", 25.217_1), ("t2", 22.415_2)]),
    ("ch16_ex1_atwood", "--inertia=0.08 --radius=0.2", &[("a", 1.400_95)]),
    ("ch16_ex2_conical_pendulum", "", &[
        ("theta", 1.058_325_104_200_569_5), ("tension", 8.0), ("omega_threshold", 3.501_187_298_617_427_4),
    ]),
    ("ch16_ex3_corner", "", &[
        ("n_floor", 27.689_364_705_882_4), ("n_wall", 6.922_341_176_470_59), ("alpha", 57.686_176_470_588_2),
        ("t_stop", 1.040_110_537_237_49), ("turns", 4.966_162_000_899_39), ("t_roll", 0.815_772_970_382_343), ("v_roll", 2.0),
    ]),
    ("ch16_ex4_unwinding_disc", "", &[
        ("a", 6.537_766_666_666_666), ("tension", 9.806_65), ("omega", 16.344_416_666_666_667),
        ("t_end", 0.553_095_709_523_567_5), ("v_end", 3.616_010_693_199_528),
    ]),
    ("ch16_ex4_unwinding_disc", "--radius=0.1", &[("peak_long", 45.0)]),
    ("ch16_ex4_unwinding_disc", "--shape=1", &[("peak_long", 13.0)]),
    ("ch16_ex5_charged_ball", "", &[
        ("a", 1.785_714_285_714_285_7), ("friction", 0.001_428_571_428_571_428_6), ("mu_min", 0.072_836_872_355_566_3),
    ]),
    ("ch16_ex7_rod_and_disc", "", &[
        ("period_fixed", 1.949_715_482_117_194_6), ("period_free", 1.933_424_372_196_342_6),
        ("wide_fixed", 2.079_048_387_719_012_7), ("wide_free", 2.061_676_619_311_900_7),
    ]),
    ("ch16_ex8_plank_on_rollers", "", &[
        ("period", 2.590_263_258_624_38), ("growth", 2.425_693_715_208_08), ("widest", 0.123_675_960_455_817),
    ]),
    ("ch16_ex8_plank_on_rollers", "--distance=1.2 --kinetic=0.2 --holding=0.35 --speed=0.25", &[
        ("carried", 0.163_636_363_636_364), ("cycle", 4.170_363_984_318_52),
    ]),
    ("ch16_ex8_plank_on_rollers", "--holding=0.3", &[("stick", 0.175_177_030_501_247_4)]),
    ("ch16_ex8_plank_on_rollers", "--holding=0.35 --speed=0.8 --offset=0.01", &[
        ("stick_out", 1.727_046_577_034_775_5), ("tip", 1.939_603_911_730_871_6),
    ]),
];

#[test]
fn the_instances_of_the_notes_come_out() {
    let (mut all, mut damaged) = (Vec::new(), Errors::in_units_of(EPS, "off by 1e-9"));
    for (stem, flags, known) in INSTANCES {
        let Some(page) = page(stem) else { continue };
        let mut errors = Errors::in_units_of(EPS, format!("{stem} {flags}").trim());
        for (key, wanted) in known {
            let got = computed(page, flags, key);
            let scale = if *wanted == 0.0 { 1.0 } else { wanted.abs() };
            errors.add(got, *wanted, scale);
            damaged.add(got, wanted + 1e-9 * scale, scale);
        }
        assert!(errors.largest() <= 64.0, "{stem} {flags}: {}", errors.largest());
        all.push(errors);
    }
    assert!(damaged.smallest() > 4e6);
    if WHOLE {
        assert_table!(&all, @"
        ch15_ex1_two_discs: 0 of 3
        ch15_ex2_gears: 0 of 3
        ch15_ex3_coins: 3.97 of 3
        ch15_ex5_centre_of_percussion: 5.29 of 2
        ch15_ex6_cone: 36.2 of 6
        ch15_ex7_raised_cone: 28.0 of 5
        ch15_ex8_string: 2.85 of 5
        ch15_ex9_dumbbell: 1.2 of 6
        ch16_ex1_atwood: 0 of 3
        ch16_ex1_atwood --inertia=0.08 --radius=0.2: 0 of 1
        ch16_ex2_conical_pendulum: 0 of 3
        ch16_ex3_corner: 26.9 of 7
        ch16_ex4_unwinding_disc: 1.96 of 5
        ch16_ex4_unwinding_disc --radius=0.1: 0 of 1
        ch16_ex4_unwinding_disc --shape=1: 0 of 1
        ch16_ex5_charged_ball: 3.43 of 3
        ch16_ex7_rod_and_disc: 0 of 4
        ch16_ex8_plank_on_rollers: 33.4 of 3
        ch16_ex8_plank_on_rollers --distance=1.2 --kinetic=0.2 --holding=0.35 --speed=0.25: 22.9 of 2
        ch16_ex8_plank_on_rollers --holding=0.3: 1.43 of 1
        ch16_ex8_plank_on_rollers --holding=0.35 --speed=0.8 --offset=0.01: 1.16 of 2
        ");
    }
}

/// An exercise, and numbers that its page confirms: each of the first list with each of the second.
const OTHERS: [(&str, &str, &str); 21] = [
    // Discs that are laid down, that slip backward, light and heavy, slow and fast.
    ("ch15_ex1_two_discs", "--upper=0.0001 --drop=0 | --lower=80 | --upper-rate=-3 --lower-rate=-2.9 --drop=0 | \
        --upper-rate=0 --friction=0.001 --drop=5 | --upper-rate=900 --lower-rate=-900 --tolerance=1e-6", ""),
    ("ch15_ex2_gears", "--radius-a=0.01 --arm-rate=-5 | --radius-a=3 --radius-b=0.02 --arm-rate=30 | --inertia-a=0.01 | \
        --inertia-a=1000 --inertia-b=0.000001 | --inertia-b=10 --mass-b=1000 --friction=0.001 | \
        --rate=0.002 --arm-rate=700 | --with bearing=0.98", ""),
    ("ch15_ex3_coins", "--outer=0.0005 | --outer=0.012 | --outer=0.3 | --outer=1.5", "--rate=0.3 | --tolerance=1e-6"),
    ("ch15_ex3_coins", "--outer=0.001 | --outer=0.0133333 | --outer=0.01979", "--side=inside"),
    ("ch15_ex4_rod_and_particle", "--length=0.01 --speed=300 | --mass=30 --speed=0.1", "--tolerance=1e-9"),
    ("ch15_ex4_rod_and_particle", "--particle=1000 --mass=0.001 | \
        --particle=0.001 --mass=1000 --length=0.001 --speed=1000", ""),
    ("ch15_ex5_centre_of_percussion", "--hands=0.1 --hit=0.5 | --hit=0.05 --restitution=1 | --hit=0 | --ball=900 --hit=0.8 | \
        --length=3 --hands=1.2 --hit=2.9 --contact=0.01 | --mass=0.02 --ball=0.003 --hit=0.85 | --contact=0.00001 --hit=0.3", ""),
    ("ch15_ex6_cone", "--half-angle=0.01 | --half-angle=0.1 | --half-angle=0.8 | --half-angle=1.2 | --half-angle=1.5",
        "--rate=0.01 --height=0.1 | --rate=1 --height=0.1"),
    ("ch15_ex6_cone", "--mass=0.01 --gravity=1.62 | --friction=5 --rate=6.2 | --tolerance=1e-6", ""),
    ("ch15_ex7_raised_cone", "--half-angle=0.05 | --half-angle=0.1 | --half-angle=0.8 | --half-angle=1.4",
        "--rate=0.5 --height=0.1 | --rate=50 --height=0.1 | --mass=0.01 --gravity=1.62 --tolerance=1e-6"),
    ("ch15_ex8_string", "--pull=10 --time=0.07 | --pull=0.005 --time=130 | --speed=30 --mass=5 --pull=0.5 --time=1 | \
        --hole=0.01 --tolerance=1e-6", ""),
    ("ch15_ex9_dumbbell", "--slant=1.5707963267948966 | --slant=0.7 --restitution=0.2 | --ball=0.8 | \
        --tolerance=1e-6 --restitution=0.5", ""),
    // The masses exchanged; ropes that slip, that hold, that weigh.
    ("ch16_ex1_atwood", "--friction=0 | --friction=0.02 | --spin=300 --rope=5 | --tolerance=1e-3 | \
        --rope=1e-9 --height=1000 | --height=0.001 --gravity=1000 --tolerance=1e-15", " | --m1=2 --m2=3"),
    ("ch16_ex1_atwood", "--m1=300 --spin=5 | --spin=5 --friction=1 | --m2=2.9999999 | --inertia=0", ""),
    ("ch16_ex2_conical_pendulum", "--rate=0 | --rate=1e-9 | --rate=1 | --rate=3.49 | --rate=3.51 | --rate=5 | --rate=30 | \
        --rate=1e6", "--release=0.01 | --release=0.5 | --release=1.5 | --release=3.1"),
    ("ch16_ex3_corner", "--friction=0.001 | --friction=0.9 | --friction=1 | --friction=2.5 | --friction=8",
        "--spin=0.05 | --spin=-1 | --spin=900"),
    ("ch16_ex3_corner", "--radius=1e-4 | --fading=0 | --fading=10 | --sense=away --tolerance=1e-4 | --with lean=1.2", ""),
    ("ch16_ex4_unwinding_disc", "--shape=0.1 --time=0.4 | --shape=50 --time=0.3 | --wound=10 --free=5 | --free=100 | \
        --wound=0.25 --time=0.2 | --radius=0.02 --free=0.1 | --mass=0.05 --stiffness=100 | --tolerance=1e-6", ""),
    ("ch16_ex5_charged_ball", "--mass=0.002 | --shape 1 --mass 0.05 | --charge=-1e-8",
        "--friction 0.05 | --friction 0.6 --field 2e5 | --field 1.5e6 --shot 0.4 | --spot=0 --shot=0 | --length 5"),
    ("ch16_ex7_rod_and_disc", "--radius=1.5 --friction=0.5 | --radius=30 | --radius=1e-5 | --length=0.05 --radius=0.05 | \
        --release=3.1 --tolerance=1e-15 | --release=-3.1 --tolerance=1e-7 | --release=3.14159265 | --friction=1e4", ""),
    ("ch16_ex8_plank_on_rollers", "--distance=0.03 --offset=0.01 | --kinetic=1.5 --holding=4 | --kinetic=20 --holding=30 | \
        --thickness=3.2 --offset=0.01 | --thickness=3.333 --offset=1e-5 | --speed=0.9 --holding=2 --offset=0.45 | \
        --holding=0.30003 --offset=0.45 | --offset=-0.3 --sense=out | --offset=-1e-9 | --speed=1e4 | --kinetic=1e-4 | --with falling", ""),
];

#[test]
fn other_numbers_are_confirmed() {
    let mut ran = 0;
    for (stem, first, second) in OTHERS {
        let Some(page) = page(stem) else { continue };
        let both = |one| second.split('|').map(move |other| format!("{} {}", str::trim(one), other.trim()));
        let runs: Vec<String> = first.split('|').flat_map(both).collect();
        confirmed(page, &runs, runs.len());
        ran += runs.len();
    }
    assert!(!WHOLE || ran == 178, "{ran} runs");
}

/// What an exercise refuses, and words of the reason.
const REFUSED: [(&str, &str, &str); 62] = [
    ("ch15_ex1_two_discs", "--upper=0", "upper = 0 is not allowed"),
    ("ch15_ex1_two_discs", "--upper-rate=0 --lower-rate=0", "the larger of the two rates = 0 is not allowed"),
    ("ch15_ex1_two_discs", "--lower-rate=40", "over the larger rate, = 0 is not allowed"),
    ("ch15_ex1_two_discs", "--friction=400", "with time left to slip, = 0.2 is not allowed"),
    ("ch15_ex1_two_discs", "--upper-rate=nan", "not a finite number"),
    ("ch15_ex2_gears", "--radius-a=10 --radius-b=0.001", "radius_a/radius_b = 10000"),
    ("ch15_ex2_gears", "--friction=0", "friction = 0 is not allowed"),
    ("ch15_ex2_gears", "--with bearing=2", "bearing over the torque of the rims = 2 is not allowed"),
    ("ch15_ex3_coins", "--outer=0.02 --side=inside", "inside a ring, = 1 is not allowed"),
    ("ch15_ex3_coins", "--outer=50", "outer/inner = 2500"),
    ("ch15_ex3_coins", "--rate=0", "at rest nothing rolls"),
    ("ch15_ex3_coins", "--side=under", "invalid value"),
    ("ch15_ex4_rod_and_particle", "--speed=0", "at rest nothing is hit"),
    ("ch15_ex4_rod_and_particle", "--mass=1e-12", "it must be from 0.001 to 1000"),
    ("ch15_ex5_centre_of_percussion", "--hit=0.9", "hit/length = 1.05"),
    ("ch15_ex5_centre_of_percussion", "--hands=0.4", "hands/length = 0.47"),
    ("ch15_ex5_centre_of_percussion", "--hands=0.3 --hit=0.2", "hit/length = 0.23"),
    ("ch15_ex5_centre_of_percussion", "--restitution=1.2", "restitution = 1.2 is not allowed"),
    ("ch15_ex5_centre_of_percussion", "--contact=0.1", "the angle in the time of contact, = 1.37"),
    ("ch15_ex6_cone", "--half-angle=1.6", "from 0.001 to 1.5698"),
    ("ch15_ex6_cone", "--rate=7 --friction=2", "beyond which the cone tips, = 7 is not allowed"),
    ("ch15_ex6_cone", "--rate=5", "beyond which the cone slips, = 5 is not allowed"),
    ("ch15_ex6_cone", "--rate=0", "rate = 0 is not allowed"),
    ("ch15_ex7_raised_cone", "--rate=0", "rate = 0 is not allowed"),
    ("ch15_ex7_raised_cone", "--rate=0.1", "h Omega^2/g = 0.000305"),
    ("ch15_ex8_string", "--pull=0", "pull = 0 is not allowed"),
    ("ch15_ex8_string", "--time=8e-9", "what is pulled in, = 1e-9 is not"),
    ("ch15_ex8_string", "--time=7.6", "what is left of the string, = 0.04"),
    ("ch15_ex8_string", "--hole=0.9", "hole/radius = 1.125"),
    ("ch15_ex8_string", "--pull=400 --time=1e-3", "pull/|speed| = 266.6"),
    ("ch15_ex9_dumbbell", "--slant=-0.1", "slant = -0.1"),
    ("ch15_ex9_dumbbell", "--knob=0.3", "knob/length = 0.5 is not allowed"),
    ("ch15_ex9_dumbbell", "--ball=7", "(ball + knob)/length = 11.7"),
    ("ch16_ex1_atwood", "--friction=-0.2", "friction = -0.2 is not allowed"),
    ("ch16_ex1_atwood", "--m1=1e-12", "lighter mass/heavier mass = 5e-13 is not allowed"),
    ("ch16_ex1_atwood", "--spin=-40", "for the other sense exchange the masses"),
    ("ch16_ex1_atwood", "--radius=1e-9", "a heavier pulley hardly turns"),
    ("ch16_ex1_atwood", "--m2=3", "equal masses rest"),
    ("ch16_ex2_conical_pendulum", "--release=4", "release = 4 is not allowed"),
    ("ch16_ex2_conical_pendulum", "--rate=3.5011873", "at this threshold nothing drives the bob back or away"),
    ("ch16_ex2_conical_pendulum", "--release=0", "at rest there the bob stays"),
    ("ch16_ex2_conical_pendulum", "--gravity=10 --release=1.5707963267948966", "creeps up to the vertical"),
    ("ch16_ex2_conical_pendulum", "--gravity=10 --release=1.0471975511965976", "as on the cone"),
    ("ch16_ex3_corner", "--spin=0", "without spin the cylinder stays at rest"),
    ("ch16_ex3_corner", "--spin=1e15", "spin sqrt(R/g)"),
    ("ch16_ex3_corner", "--friction=0", "less is none"),
    ("ch16_ex3_corner", "--with lean=-0.5", "backward, and not down to the floor"),
    ("ch16_ex3_corner", "--friction=100", "dry friction allows two motions"),
    ("ch16_ex3_corner", "--fading=1e6", "fading*spin*radius = 6000000"),
    ("ch16_ex3_corner", "--with lean=1.5", "climbs out"),
    ("ch16_ex4_unwinding_disc", "--time=0.6", "no string is left to unwind"),
    ("ch16_ex4_unwinding_disc", "--free=0.1", "at 1 the disc touches the roof"),
    ("ch16_ex4_unwinding_disc", "--wound=0.001 --time=0.01", "wound/radius = 0.005"),
    ("ch16_ex4_unwinding_disc", "--shape=1e-4 --time=0.4", "near the axis falls"),
    ("ch16_ex5_charged_ball", "--charge=0", "below which nothing drives the ball"),
    ("ch16_ex5_charged_ball", "--shape=1.5", "shape = 1.5 is not allowed"),
    ("ch16_ex7_rod_and_disc", "--release=0", "smaller swings are small swings"),
    ("ch16_ex7_rod_and_disc", "--release=3.1415926535", "released upright it stays there"),
    ("ch16_ex8_plank_on_rollers", "--holding=0.2", "what rests holds no less than what slips"),
    ("ch16_ex8_plank_on_rollers", "--speed=0", "at 0 the rollers rest"),
    ("ch16_ex8_plank_on_rollers", "--offset=-0.6", "at an end it lifts off a roller"),
    ("ch16_ex8_plank_on_rollers", "--thickness=4", "jams the plank"),
];

#[test]
fn what_is_no_question_is_refused() {
    for (stem, flags, words) in REFUSED {
        if let Some(page) = page(stem) {
            refused(page, [(flags, words)]);
        }
    }
}
