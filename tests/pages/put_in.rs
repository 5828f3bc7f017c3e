//! What `--with` puts in: the claims that only then are told, on the pages that simulate one effect
//! of their card for it.

use crate::answers::{computed, page, refused, with_report};
use kit::Page;
use pages::WHOLE;
use support::{Errors, assert_largest};

/// Page, effect, its usual strength, and a claim that is told of it.
const PUT_IN: [(&str, &str, f64, &str); 15] = [
    ("ch15_2_rolling", "resistance", 0.005, "resisted_speed"),
    ("ch15_4_angular_momentum", "air", 1.2, "air_lost"),
    ("ch15_ex1_two_discs", "bearing", 0.05, "rough_common"),
    ("ch15_ex3_coins", "table", 0.2, "rubbed_work"),
    ("ch15_ex6_cone", "air", 1.204, "blown_rate"),
    ("ch15_ex6_cone", "rolling", 2e-5, "rolled_rate"),
    ("ch15_ex7_raised_cone", "air", 1.204, "blown_rate"),
    ("ch16_1_incline", "air", 1.0, "blown_way"),
    ("ch16_1_incline", "rolling", 2e-4, "rolled_way"),
    ("ch16_ex1_atwood", "air", 0.02, "blown_time"),
    ("ch16_ex3_corner", "lean", 0.0175, "t_leaning"),
    ("ch16_ex4_unwinding_disc", "air", 1.0, "blown_speed"),
    ("ch16_ex5_charged_ball", "air", 0.47, "blown_speed"),
    ("ch16_ex8_plank_on_rollers", "falling", 0.1, "falling_growth"),
    ("further_5_wheel_on_rope", "air", 1.204, "blown_spin"),
];

/// Those of the pages that are tested.
fn put_in() -> impl Iterator<Item = (&'static dyn Page, &'static str, f64, &'static str)> {
    PUT_IN.into_iter().filter_map(|(stem, effect, usual, key)| Some((page(stem)?, effect, usual, key)))
}

/// A weak effect changes what is claimed in proportion to its strength; the twin is four times as
/// strong, not twice.
#[test]
fn twice_a_weak_effect_does_twice_as_much() {
    let (mut errors, mut twin) = (Errors::of("twice the strength"), Errors::of("four times the strength"));
    for (page, effect, usual, key) in put_in() {
        let at = |part: f64| computed(page, &format!("--with {effect}={:e}", part * usual), key);
        let [none, once, twice, more] = [1e-7, 1e-3, 2e-3, 4e-3].map(at);
        errors.push_at((twice - none) / (once - none) / 2.0 - 1.0, (page.stem(), effect));
        twin.push((more - none) / (once - none) / 2.0 - 1.0);
        // Without a number it has its usual strength, five times as strong it is confirmed as well.
        assert_eq!(computed(page, &format!("--with {effect}"), key), at(1.0), "{effect}");
        assert!((at(5.0) - at(1.0)).abs() > 2.0 * (at(1.0) - none).abs(), "{effect}");
    }
    if WHOLE {
        assert_largest!(errors, 15, @"1.51e-3");
    }
    assert!(errors.largest() <= 1.6e-3 && twin.smallest() > 0.9);
}

/// Its strength is positive and not too large, and without the effect nothing is told of it.
#[test]
fn what_cannot_be_put_in_is_refused() {
    for (page, effect, _, key) in put_in() {
        let flag = |rest: &str| format!("--with {effect}{rest}");
        refused(page, [
            (&flag("=0"), &format!("{effect} = 0 is not allowed")),
            (&flag("=-1"), &format!("{effect} = -1 is not allowed")),
            (&flag("=1e9"), &format!("{effect} = ")),
            (&flag("=much"), "that is not a number"),
            (&format!("{} --without {effect}", flag("")), "is it in or out?"),
        ]);
        assert!(with_report(page, |report| report.claim(key).is_none()), "{key}");
    }
    // What the law does not cover.
    for (stem, flags, words) in [
        ("ch15_ex1_two_discs", "--with bearing=1", "bearing over the friction of the discs = 2"),
        ("ch15_ex6_cone", "--with air=1000", "part of the energy that the air takes in a circuit"),
        ("ch15_ex6_cone", "--with rolling=0.1", "part of the energy that rolling resistance takes"),
        ("ch15_ex7_raised_cone", "--with air=1000", "part of the energy that the air takes"),
        ("ch15_4_angular_momentum", "--with air=1000 --height=10 --tilt=1.5", "takes in a radian"),
        ("ch16_1_incline", "--with air --friction=0.01", "less does not let it roll"),
        ("ch16_ex1_atwood", "--with air --friction=0", "for a rope that holds"),
        ("ch16_ex8_plank_on_rollers", "--with falling=10", "growth over the rate of the swing"),
        ("ch16_ex8_plank_on_rollers", "--with falling --thickness=0.05", "thickness"),
    ] {
        if let Some(page) = page(stem) {
            refused(page, [(flags, words)]);
        }
    }
}
