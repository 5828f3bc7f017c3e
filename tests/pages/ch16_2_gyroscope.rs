//! The gyroscope: any motion asked for is confirmed by a second route or refused in words,
//! its picture moves, and what the page says of limits and errors holds elsewhere too.

use crate::answers::{answer, computed, confirmed, ledger, refused};
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::Moves;
use pages::ch16_2_gyroscope::{EXAMPLE, fast};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{Dop853, Integrator, ode, size_or};
use rotation_dynamics::math::cos;
use support::{Errors, assert_largest};

#[test]
fn every_motion_asked_for_is_confirmed() {
    let mut runs = Vec::new();
    for a in [0.1, 2.0] {
        for b in [-1.0, -0.4, 0.7, 1.0, 1.5] {
            for c in [-0.3, 0.0, 0.01, 0.4] {
                let (_, least) = ReducedTop::new(a, b, c).unwrap().minimum();
                let run = |above| format!("--a {a} --b {b} --c {c} --energy {}", least + above);
                runs.extend([1e-6, 0.05, 2.0].map(run));
            }
        }
    }
    confirmed(&EXAMPLE, runs, 2 * 5 * 4 * 3);
    confirmed(&EXAMPLE, [
        "--spin 628.3", "--precession 1.8", "--spin 60", "--spin -300 --theta 2", "--length -0.1 --theta 0.3 --spin 50",
        "--theta 0 --nutation 0.01", "--with gravity=1.62", "--without gravity", "--without gravity --precession 3",
        "--theta 1e-4",
    ], 10);
    // One motion has its own two figures.
    assert_eq!(EXAMPLE.page().figures_with(&[("b", 0.5)]).unwrap().len(), 2);
}

/// Beside a pole, and through it, the least tilt and the time of a nod are told as elsewhere:
/// once they were left out without a word.
#[test]
fn near_a_pole_nothing_is_left_out() {
    let mut errors = Errors::of("claims near a pole");
    for (a, b, c, energy) in [
        (2.0, 0.999, 0.45, 0.05), (2.0, 1.0, 0.45, 0.05), (0.7, 1.0001, 0.3, 0.4), (1.3, -0.999, 0.2, 0.6),
        (1.0, 0.9999999, -0.3, 1.0),
    ] {
        let flags = format!("--a={a} --b={b} --c={c} --energy={energy}");
        let top = ReducedTop::new(a, b, c).unwrap();
        let exact = HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0).unwrap();
        let (least, most) = (exact.theta_min(), exact.theta_max());
        assert!(least < 0.02 || most > PI - 0.02, "{flags}");
        for (key, value) in [("theta_min", least), ("theta_max", most), ("period", exact.nutation_period())] {
            errors.add(computed(&EXAMPLE, &flags, key), value, value.max(1e-3));
        }
    }
    assert_largest!(errors, 15, @"0");
}

/// Each line once made a bound that did not follow the conditioning refuse a right
/// number, or a route lose more digits than it said.
const SOUND: [&str; 16] = [
    // Close passages by the poles.
    "--a=1 --b=0.9646696516635528 --c=0.09456625415753794 --energy=0.5070211393342967 --start=theta_max",
    "--a=1e-6 --b=0.999999999995916 --c=2.479545711689449 --energy=-2.4763961121417832",
    "--a=0.0012 --b=1.2 --c=0.2 --energy=0.5535151071433231",
    "--a=1e-20",
    // No weight: thousands of equal terms to sum.
    "--a=1.9302412042847925 --b=0.8963056118753858 --c=0 --energy=0.35021288327062244",
    // Its least tilt and its period once were left out without a word.
    "--a=2 --b=0.999 --c=0.45 --energy=0.05",
    // A start next to the pole, given by an energy.
    "--a=1e-6 --b=-0.2156873134986519 --c=0.2 --energy=60.52874008892845 --start=theta_max",
    "--a=2 --b=0.9999733224702964 --c=0.2 --energy=16.99168787696426",
    // Fast: long steps overflow in the accuracy strip.
    "--a=2 --b=39.95210577961625 --c=-0.20061855862624917 --energy=92885.61526620826",
    // Spin the other way round: t' runs backwards.
    "--i1=0.008 --i3=0.0003 --mass=0.08 --length=0 --theta=0.3 --spin=-6.5 --precession=28",
    // b = 1 or -1 but for what rounding took.
    "--i1=0.0035 --i3=0.0011 --mass=0.2 --length=0 --theta=3.141592653589793 --spin=4282.5 --precession=0.8",
    "--i1=0.2 --i3=0.3 --mass=1 --length=0 --theta=1e-9 --spin=-847 --precession=-0.05",
    "--i1=0.038 --i3=0.038 --mass=0.3 --length=0 --theta=1e-4 --spin=-15.4",
    // A hair off the vertical, far below the critical spin: no run in steps can follow.
    "--i1=1.54e-5 --i3=1.28e-5 --mass=14.8 --length=0.074 --theta=1e-9 --spin=-624 --precession=7",
    // c/a near 1e-8: nods so small that the energy does not tell them from none.
    "--i1=0.00581566 --i3=0.0104872 --mass=0.1549 --length=0.05698 --theta=0.23509 --spin=11758.522",
    "--i1=0.176195 --i3=0.208972 --mass=0.05712 --length=0.2404 --theta=1.15607 --spin=22777.979",
];

/// Printed whole, with the accuracy strip.
#[test]
fn sound_far_from_the_notes() {
    for line in SOUND {
        let told = answer(&EXAMPLE, line);
        assert_eq!(told.code, 0, "{line}: {}", told.stderr);
        let sound = |word| !["NaN", "inf", "-inf"].contains(&word);
        assert!(told.stdout.split_whitespace().all(sound), "{line}");
    }
}

#[test]
fn refused_with_a_reason_one_can_act_on() {
    refused(&EXAMPLE, [
        ("--b 1.2 --energy 0.40", "E~ = 0.4 is not allowed: no motion is below U_min = 0.404262"),
        ("--a 2.5", "no body has I3 > 2 I1"), ("--a 0", "a = 0"), ("--i3 1", "I3 <= 2 I1"), ("--i1 -1", "I1 = -1"),
        ("--mass -0.5", "mass = -0.5"), ("--spin 0", "the axis must spin"), ("--start top", "invalid value"),
        ("--energy nan", "not a finite number"), ("--i1 inf", "not a finite number"), ("--tolerance 0", "tolerance = 0"),
        ("--tolerance 4", "above 0 and at most pi"), ("--tolerance 1e-20", "doubles allow 4.3e-14 at best"),
        ("--tolerance=1e-300", "1e-300 rad is asked for, and doubles allow"), ("--a=1e-300", "too far apart"),
        ("--b=1e308", "too far apart"), ("--energy=1e308", "too far apart"), ("--a=1e308", "a = 1e308 is not allowed"),
        ("--with friction=-1", "friction = -1 is not allowed"), ("--with gravity=0", "gravity = 0 is not allowed"),
        ("--a 1 --mass 2", "dimensionless and SI flags together"),
        ("--b 0.6 --with friction", "dimensionless and SI flags together"),
        ("--a 1 --without gravity", "dimensionless and SI flags together"),
        ("--with air --with bearing", "must be the only torque about the body's axis"),
        ("--with air --tolerance 1e-20", "1e-20 rad is asked for"),
    ]);
}

/// Through waves, cusps and loops, and far from the notes: poles, hanging tops, no weight,
/// fast spins, thousands of nods.
#[test]
fn the_picture_moves_for_any_motion() {
    let mut frames = 0;
    for settings in [
        "", "b=0.6 energy=-0.0872", "b=0.6 energy=-0.085", "b=0.6 energy=-0.08", "b=0.6 energy=0.11",
        "b=0.6 energy=3", "b=1 energy=0", "b=1 c=0.6 energy=0", "b=-1 c=-0.3 energy=2", "c=0 energy=0.55",
        "a=1e-6 b=0.5 energy=3", "spin=-628.3 theta=2.5", "spin=20000 theta=0.01",
    ] {
        let picture = EXAMPLE.opened(&settings.replace(' ', "\n")).unwrap().expect("it moves");
        let (from, to) = picture.span().into_inner();
        for t in kit::times(from, to, 8) {
            let svg = picture.frame(t).unwrap_or_else(|e| panic!("{settings} at {t}: {e}")).svg();
            assert!(svg.contains("<svg") && !svg.contains("NaN"), "{settings} at {t}");
            frames += 1;
        }
        assert_eq!(picture.stills().map(|stills| stills.len()).ok(), Some(3), "{settings}");
    }
    assert_eq!(frames, 13 * 9);
}

/// To first order in e = c/a the three formulas of the fast rotor miss by e cos(theta),
/// -2 e cos(theta) and 3 e cos(theta), for other shapes and tilts than the page's; what
/// then is left shrinks as e^2.
#[test]
fn the_formulas_miss_as_the_expansion_says() {
    let mut errors = Errors::of("errors of the formulas over c/a, less the expansion's");
    let mut without = Errors::of("the same, less nothing");
    for a in [0.05, 0.9, 1.9] {
        for theta in [0.4, 1.2, FRAC_PI_2, 2.6] {
            let found = fast::coefficients_measured(a, theta).unwrap();
            for (found, expected) in found.into_iter().zip(fast::coefficients(theta)) {
                errors.add(found, expected, 1.0);
                without.add(found, 0.0, 1.0);
            }
        }
    }
    assert_largest!(errors, 36, @"2.08e-7");
    // The damaged twin: at 0.4 rad the dip's coefficient is 2.76.
    assert_largest!(without, 36, @"2.76");
}

/// Below L_z^2 = 4 I1 m g l cos(theta) equation (4) pulls the axis down whatever L_Z is;
/// above it, some L_Z holds it there. The level and the hanging axis can always be held.
#[test]
fn below_the_least_spin_nothing_holds_the_axis() {
    let (mut cases, mut held) = (0, 0);
    for a in [0.1_f64, 1.0, 1.9] {
        for theta in [0.3, 1.0, 1.5, FRAC_PI_2, 2.0] {
            for share in [0.9, 0.999, 1.001, 1.1] {
                // a/(4 c cos(theta)) = L_z^2/(4 I1 m g l cos(theta)) is the share squared.
                let c = a / (4.0 * cos(theta).abs().max(0.05) * share * share);
                let holds = |b: f64| ReducedTop::new(a, b, c).unwrap().torque(theta) <= 0.0;
                let can = (0..=4000).any(|k| holds(-5.0 + 0.005 * f64::from(k)));
                assert_eq!(can, cos(theta) < 1e-9 || share > 1.0, "{a} {theta} {share}");
                held += u32::from(can);
                cases += 1;
            }
        }
    }
    assert_eq!((cases, held), (60, 3 * (3 * 2 + 2 * 4)));
}

/// With what no closed form knows: two routes agree on the end, whatever is put in.
#[test]
fn what_is_put_in_is_confirmed_by_a_second_route() {
    confirmed(&EXAMPLE, [
        "--with friction", "--with friction=0.5 --theta 2.5", "--with friction=1e-7", "--with air",
        "--with air=1000", "--with bearing", "--with bearing=0.5", "--with friction --with air --spin 628.3",
        "--with friction --with bearing --precession 1.8", "--with friction --without gravity --precession 3",
        "--with air --without gravity", "--with air --theta 0 --nutation 0.01", "--with friction --theta 1e-4",
        "--with friction --length -0.1 --theta 0.3 --spin 50", "--with bearing --spin -300 --theta 2",
        "--with friction --spin 60 --tolerance 1e-6",
    ], 16);
    // What needs the closed form is left out, and the report says so.
    let told = answer(&EXAMPLE, "--with friction").stdout;
    assert!(["theta_end", "spin_end", "energy_lost", "\neffects\n"].iter().all(|part| told.contains(part)), "{told}");
    assert!(!told.contains("\naccuracy\n") && told.contains("are left out"), "{told}");
}

/// A response is linear only while the number of the effect is small as well: of a bearing that
/// takes most of the nods the card says that it predicts to first order, and what is measured is
/// half of that; a weak one does what is predicted, and needs no such words.
#[test]
fn a_bearing_that_takes_the_nods_is_weighed_to_first_order() {
    let mut ran = 0;
    for (flags, strong) in [("--with friction", true), ("--with friction=0.001", false)] {
        let [[said, found]] = ledger(&EXAMPLE, flags)[..] else { panic!("{flags}") };
        assert_eq!(answer(&EXAMPLE, flags).stdout.contains(", of the axis, to first order"), strong, "{flags}");
        assert_eq!(found < 0.6 * said, strong, "{flags}: {said} {found}");
        assert_eq!(found > 0.9 * said, !strong, "{flags}: {said} {found}");
        ran += 1;
    }
    assert_eq!(ran, 2);
}

/// The stresses of a spinning disc of steel, ring by ring: by so much its moment grows, and by so
/// much it precesses more slowly.
#[test]
fn a_spinning_disc_has_a_larger_moment() {
    // At x = r/R: its stretch around, the stress along the radius, and the moment's growth so far.
    let nu = 0.3;
    let disc = ode(|x, [e, s, _]: &[f64; 3]| {
        let (along, around) = ((1.0 - nu * nu) * s - nu * e, nu * s + e);
        [(along - e) / x, (around - s) / x - x, 8.0 * e * x * x * x]
    })
    .scaled(size_or([1.0; 3]));
    let run = |e: f64| Dop853::new(1e-12).unwrap().advance(&disc, 1e-2, &[e, e / (1.0 - nu), 0.0], 1.0).unwrap().0;
    // No stress is left at the rim, and it is linear in the stretch of the middle.
    let ([_, left, a], [_, more, b]) = (run(0.0), run(1.0));
    let grown = a + (b - a) * left / (left - more);
    let report = EXAMPLE.page().report().unwrap();
    let line = report.effects().iter().find(|line| line.effect == "stretch of the spinning disc").unwrap();
    let (mut errors, mut damaged) = (Errors::of("growth of the moment"), Errors::of("a hoop"));
    errors.push(line.error / (line.value * grown * TAU) - 1.0);
    damaged.push(line.error / (2.0 * line.value * TAU) - 1.0);
    assert_largest!(errors, 1, @"2.71e-8");
    damaged.exceed(0.1, 1);
}
