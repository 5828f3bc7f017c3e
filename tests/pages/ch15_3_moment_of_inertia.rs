//! Section 15.3: each equation by a route that does not use it, and the slips of the notes.

use crate::answers::{cell, confirmed, measured, refused};
use pages::ch15_3_moment_of_inertia::*;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, PrincipalAxes, solids};
use rotation_dynamics::math::{EPS, cos, sin};
use std::f64::consts::{FRAC_PI_4, PI};
use support::{Errors, assert_error, assert_largest};

/// Numbers between -1 and 1 that repeat from run to run.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        let next = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = next.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> DesignVector {
        [self.next(), self.next(), self.next()].into()
    }

    /// Five masses, and a motion told by a point that is none of them.
    fn body(&mut self) -> (Vec<Mass>, Rigid) {
        let masses = (0..5).map(|_| (1.5 + self.next(), self.vector())).collect();
        (masses, Rigid { point: self.vector(), velocity: self.vector(), angular_velocity: self.vector() })
    }

    fn rotation(&mut self) -> Attitude {
        Attitude::from_rotation_vector((self.vector() * PI).to_array().into()).unwrap()
    }
}

const CASES: usize = 200;

/// The errors of as many random cases, for each of these twins.
fn over<T: Copy, const N: usize>(twins: [T; N], error: impl Fn(&mut Dice, T) -> f64) -> [Errors; N] {
    twins.map(|twin| {
        let (mut dice, mut errors) = (Dice(1), Errors::of("random bodies"));
        (0..CASES).for_each(|_| errors.push(error(&mut dice, twin)));
        errors
    })
}

/// The energy of a body, mass by mass, from speeds that are measured between two places.
fn energy(masses: &[Mass], motion: &Rigid) -> f64 {
    let square = |v: DesignVector| v.dot(&v);
    masses.iter().map(|(m, r)| 0.5 * m * square(displaced(motion, *r).unwrap())).sum()
}

fn principal(masses: &[Mass]) -> PrincipalAxes {
    InertiaTensor::new(tensor(masses)).unwrap().principal_axes()
}

/// The largest difference of two matrices.
fn apart(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> f64 {
    largest(a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a - b))
}

#[test]
fn eq_15_3_1_velocity_of_a_point() {
    // `turning` = 0 leaves Omega x r' out.
    let [errors, damaged] = over([1.0, 0.0], |dice, turning| {
        let (masses, motion) = dice.body();
        let around = velocity(&motion, masses[0].1) - motion.velocity;
        (motion.velocity + around * turning - displaced(&motion, masses[0].1).unwrap()).norm()
    });
    assert_largest!(errors, CASES, @"4.88e-14");
    damaged.exceed(1e-2, CASES);
}

#[test]
fn eq_15_3_2_three_terms_of_the_energy() {
    // (a): P is the centre of mass. (b): P is at rest, and its second term is the whole.
    let any = |_: &[Mass], motion: &Rigid| *motion;
    let centre = |masses: &[Mass], motion: &Rigid| motion.seen_from(centre_of_mass(masses));
    let rest = |_: &[Mass], motion: &Rigid| about_origin(motion.angular_velocity);
    // What the terms that count make of the energy, less one.
    type Told = fn(&[Mass], &Rigid) -> Rigid;
    let cases: [([f64; 3], Told); 4] =
        [([1.0; 3], any), ([1.0, 1.0, 0.0], centre), ([0.0, 1.0, 0.0], rest), ([1.0, 1.0, 0.0], any)];
    let [all, centre, rest, damaged] = over(cases, |dice, (count, told)| {
        let (masses, motion) = dice.body();
        let motion = told(&masses, &motion);
        let terms = split(&masses, &motion).into_iter().zip(count);
        terms.map(|(term, times)| term * times).sum::<f64>() / energy(&masses, &motion) - 1.0
    });
    assert_largest!(all, CASES, @"2.89e-14");
    assert_largest!(centre, CASES, @"1.67e-14");
    assert_largest!(rest, CASES, @"2.55e-14");
    damaged.exceed(1e-4, CASES);
}

/// The third case: on the cylinder over the circle of Thales between the axis through the centre
/// of mass and the axis that moves along itself; not beside it.
#[test]
fn the_third_term_vanishes_on_a_circle() {
    let [errors, damaged] = over([1.0, 0.8], |dice, part| {
        let ((masses, motion), angle) = (dice.body(), PI * dice.next());
        let (centre, omega) = (centre_of_mass(&masses), motion.angular_velocity);
        // From the centre of mass to the axis that moves along itself: the diameter.
        let radius = omega.cross(&velocity(&motion, centre)) / (2.0 * omega.dot(&omega));
        let across = omega.cross(&radius) / omega.norm();
        let round = (radius * cos(angle) + across * sin(angle)) * part;
        let point = motion.seen_from(centre + radius + round + omega * dice.next());
        split(&masses, &point)[2] / (whole(&masses) * radius.dot(&radius) * omega.dot(&omega))
    });
    assert_largest!(errors, CASES, @"5.41e-15");
    damaged.exceed(0.3, CASES);
}

#[test]
fn eq_15_3_3_energy_of_rotation() {
    // `products` = 0 keeps the diagonal elements alone.
    let [errors, damaged] = over([1.0, 0.0], |dice, products| {
        let (masses, motion) = dice.body();
        let (t, w) = (tensor(&masses), motion.angular_velocity);
        let pairs = (0..9).map(|k| (k / 3, k % 3));
        let term = |(i, j): (usize, usize)| 0.5 * t[i][j] * w[i] * w[j] * if i == j { 1.0 } else { products };
        pairs.map(term).sum::<f64>() / energy(&masses, &about_origin(w)) - 1.0
    });
    assert_largest!(errors, CASES, @"2.55e-14");
    damaged.exceed(1e-4, CASES);
}

/// Symmetric, and of second rank: the masses turned, then summed, give Q I Q^T, and not Q^T I Q.
#[test]
fn eq_15_3_4_tensor_law() {
    let [errors, damaged] = over([false, true], |dice, inverse| {
        let ((masses, _), axes) = (dice.body(), dice.rotation());
        let t = tensor(&masses);
        assert_eq!([t[0][1], t[0][2], t[1][2]], [t[1][0], t[2][0], t[2][1]]);
        let by_law = on_axes(&t, &if inverse { axes.inverse() } else { axes });
        apart(by_law, tensor(&turned_masses(&masses, &axes))) / t[0][0]
    });
    assert_largest!(errors, CASES, @"1.16e-15");
    damaged.exceed(4e-4, CASES);
}

/// The theorem: on the axes found, which are right-handed, summing over the masses leaves no
/// product; with the third axis kept and the others turned by a thousandth it does.
#[test]
fn eq_15_3_5_principal_axes() {
    let [errors, damaged] = over([0.0, 1e-3], |dice, turn| {
        let (masses, _) = dice.body();
        let (found, [x, y, z]) = (principal(&masses), principal(&masses).axes());
        assert!(x.cross(&y).dot(&z) > 0.999);
        let axes = found.attitude().unwrap().turned_in_body([0.0, 0.0, turn].into()).unwrap();
        let [[_, xy, xz], [_, _, yz], _] = tensor(&turned_masses(&masses, &axes));
        largest([xy, xz, yz]) / (found.moments()[1] - found.moments()[0])
    });
    assert_largest!(errors, CASES, @"5.21e-15");
    damaged.exceed(0.99e-3, CASES);
}

/// Where moments are equal, the axes in their plane are a choice, and any choice will do; a fly
/// of any mass on a corner of the square decides, on a corner of a rectangle it does not.
#[test]
fn equal_moments_leave_the_axes_free() {
    let [errors, damaged] = over([1.0, 1.1], |dice, edge| {
        let t = solids::cuboid(1.0, 1.0, 1.0, edge).unwrap().about_centre_of_mass().matrix();
        apart(on_axes(&t, &dice.rotation()), t)
    });
    assert_largest!(errors, CASES, @"1.11e-16");
    damaged.exceed(1e-4, CASES);
    let p = Parameters::default();
    assert_eq!(with_fly(&p, 0.0).unwrap()[0], 0.0);
    for fly in [1e-9, 1e-6, 1e-3, 0.1, 10.0] {
        assert_error!(with_fly(&p, fly).unwrap()[0] / FRAC_PI_4 - 1.0, 0.0);
    }
    let long = Parameters { height: 0.3, ..p };
    assert!(with_fly(&long, 1e-6).unwrap()[0].abs() < 1e-5);
}

#[test]
fn any_axes_of_a_square_about_its_centre_are_principal() {
    let [mut errors, mut rectangle, mut corner] = ["square", "rectangle", "corner"].map(Errors::of);
    for angle in (1..150).map(|i| 0.01 * f64::from(i)) {
        let [xx, yy, xy] = turned(about_centre(1.0, 1.0, 1.0), angle);
        errors.push((xx - 1.0 / 12.0).abs() + (yy - 1.0 / 12.0).abs() + xy.abs());
        rectangle.push(turned(about_centre(1.0, 1.0, 0.9), angle)[2]);
        corner.push(turned(about_corner(1.0, 1.0, 1.0), angle + FRAC_PI_4)[2]);
    }
    assert_largest!(errors, 149, @"0");
    rectangle.exceed(1e-4, 149);
    corner.exceed(1e-3, 149);
}

/// Matrix (1) of the corner and its diagonal form, by sums over many pieces.
#[test]
fn eq_15_3_ex2_1_corner_matrix() {
    let n = 64;
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(n);
    let piece = |k: u32| (1.0 / f64::from(n * n), [at(k % n), at(k / n), 0.0].into());
    let pieces: Vec<Mass> = (0..n * n).map(piece).collect();
    // A piece has moments of its own, by which the sums of its middle fall short.
    let own = 1.0 / (12.0 * f64::from(n * n));
    let mut t = tensor(&pieces);
    [1.0, 1.0, 2.0].into_iter().enumerate().for_each(|(i, times)| t[i][i] += times * own);
    let matrix = |xy: f64| [[1.0 / 3.0, xy, 0.0], [xy, 1.0 / 3.0, 0.0], [0.0, 0.0, 2.0 / 3.0]];
    assert_error!(apart(t, matrix(-0.25)), 0.0);
    assert!(apart(t, matrix(0.25)) > 0.4);
    let [one, two, three] = principal(&pieces).moments();
    let diagonal = [one + own, two + own, three + 2.0 * own];
    for (moment, want) in diagonal.into_iter().zip([1.0 / 12.0, 7.0 / 12.0, 2.0 / 3.0]) {
        assert_error!(moment, want, 0.0 eps);
    }
}

/// From the centre of mass to any point, in full; from another point it fails.
#[test]
fn eq_15_6_8_parallel_axes() {
    let [errors, damaged] = over([0.0, 1.0], |dice, beside| {
        let ((masses, _), to) = (dice.body(), dice.vector());
        let from = centre_of_mass(&masses) + dice.vector() * beside;
        let about = |point: DesignVector| {
            tensor(&masses.iter().map(|(m, r)| (*m, *r - point)).collect::<Vec<_>>())
        };
        let (start, step, want) = (about(from), tensor(&[(whole(&masses), to - from)]), about(to));
        let sum = [0, 1, 2].map(|i| [0, 1, 2].map(|j| start[i][j] + step[i][j]));
        let size = want[0][0] + want[1][1] + want[2][2];
        let library = MassProperties::of_points(&masses).unwrap().about(to).unwrap();
        assert!(apart(library.matrix(), want) < 32.0 * EPS * size);
        apart(sum, want) / size
    });
    assert_largest!(errors, CASES, @"2.77e-16");
    damaged.exceed(1e-3, CASES);
}

/// E11: with delta for eta the sum over the indices is no energy.
#[test]
fn e11_index_of_the_second_epsilon() {
    let epsilon = |i: usize, j: usize, k: usize| {
        let [i, j, k] = [i, j, k].map(|index| index as f64);
        (j - i) * (k - i) * (k - j) / 2.0
    };
    let (w, r) = ([0.4, -0.3, 2.0], [0.1, 0.2, 0.3]);
    // Summed over i, alpha, beta, gamma and one index more; eta is that index, or left open.
    let sum = |open: Option<usize>| -> f64 {
        let term = |n: usize| {
            let [i, a, b, c, last] = [1, 3, 9, 27, 81].map(|power| n / power % 3);
            let eta = open.unwrap_or(last);
            epsilon(i, a, b) * w[a] * r[b] * epsilon(i, c, eta) * w[c] * r[eta]
        };
        (0..243).map(term).sum()
    };
    let turning = DesignVector::from(w).cross(&r.into());
    assert_error!(sum(None), turning.dot(&turning), 1.9 eps);
    let mut printed = Errors::of("printed sum over the right one, less one");
    (0..3).for_each(|eta| printed.push(sum(Some(eta)) / turning.dot(&turning) - 1.0));
    printed.exceed(0.1, 3);
}

/// E12: with P at rest the first term is not the energy of the centre of mass. A rod of mass and
/// length 1 about its end, at 1 rad/s: 1/6, of which 1/24 about its middle.
#[test]
fn e12_a_fixed_point_is_not_the_centre_of_mass() {
    let off = 0.5 / 3.0_f64.sqrt();
    let rod = [0.5 - off, 0.5 + off].map(|x| (0.5, DesignVector::new(x, 0.0, 0.0)));
    let motion = about_origin([0.0, 0.0, 1.0].into());
    let [first, second, third] = split(&rod, &motion);
    assert_eq!((first, third), (0.0, 0.0));
    assert_error!(second, 1.0 / 6.0, 0.0 eps);
    let [carried, about_centre, _] = split(&rod, &motion.seen_from(centre_of_mass(&rod)));
    assert_error!(carried, 0.125, 0.0 eps);
    assert_error!(about_centre, 1.0 / 24.0, 1.5 eps);
}

/// E13: four unequal masses in general position have principal axes and no symmetry: no half turn
/// about one of these, and no mirror across it, brings a mass near an equal one.
#[test]
fn e13_principal_axes_without_symmetry() {
    let lands = |m: f64, r: DesignVector| FOUR.iter().any(|(n, q)| *n == m && (*q - r).norm() < 0.05);
    for axis in principal(&FOUR).axes() {
        for (m, r) in FOUR {
            let turned = axis * (2.0 * axis.dot(&r)) - r;
            assert!(!lands(m, turned) && !lands(m, -turned));
        }
    }
}

/// E14: of the three axes through the corner the diagonal passes through the centre of mass.
#[test]
fn e14_the_diagonal_passes_through_the_centre_of_mass() {
    let plate = solids::plate(1.0, 1.0, 1.0).unwrap();
    let plate = plate.about([-0.5, -0.5, 0.0].into()).unwrap();
    let centre = DesignVector::new(0.5, 0.5, 0.0);
    let [x, y, z] = plate.principal_axes().axes().map(|axis| axis.cross(&centre).norm());
    assert_error!(x, 0.0);
    assert_error!(y, 0.5_f64.sqrt(), 1.4 eps);
    assert_error!(z, 0.5_f64.sqrt(), 0.0 eps);
}

/// E22: the printed triad is left-handed; the library's is not.
#[test]
fn e22_hand_of_the_triad() {
    let hand = |[x, y, z]: [DesignVector; 3]| x.cross(&y).dot(&z);
    let [x, y, z] = [[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 0.0, 1.0]].map(DesignVector::from);
    assert_eq!((hand([x, y, z]), hand([x, -y, z])), (-2.0, 2.0));
    let corner = InertiaTensor::new([[4.0, -3.0, 0.0], [-3.0, 4.0, 0.0], [0.0, 0.0, 8.0]]);
    assert_error!(hand(corner.unwrap().principal_axes().axes()), 1.0, 2.0 eps);
}

/// E39: a symmetry axis that misses the centre of mass will not do, and one through it need not be
/// a symmetry axis: a box about an askew axis.
#[test]
fn e39_from_the_centre_of_mass() {
    let plate = solids::plate(1.0, 1.0, 1.0).unwrap();
    let about = |x: f64| plate.about([x, 0.0, 0.0].into()).unwrap().matrix()[1][1];
    assert!((about(-0.5) + 1.0 - about(0.5)).abs() > 0.9);
    let (brick, axis) = (solids::cuboid(1.0, 0.2, 0.5, 0.9).unwrap(), DesignVector::new(0.6, 0.0, 0.8));
    let here = brick.about_centre_of_mass().moment_about(axis).unwrap();
    let there = brick.about([0.0, 2.0, 0.0].into()).unwrap();
    assert_error!(there.moment_about(axis).unwrap(), here + 4.0, 2.0 eps);
}

/// Every solid of the table against its points; a moment off by 1e-13 is seen.
#[test]
fn solids_are_their_points() {
    let error = |damage: f64| {
        let mut errors = Errors::in_units_of(EPS, "solids");
        compared(damage).unwrap().into_iter().for_each(|(solid, _, off)| errors.push_at(off, solid.name));
        errors
    };
    assert_largest!(error(0.0), 12, @"26.7");
    error(1e-13).exceed(100.0, 12);
}

/// The card: what is predicted of thickness and warmth, against the library's solids.
#[test]
fn the_effects_are_what_the_bodies_say() {
    let [[_, warm], [_, thick], _] = measured(&EXAMPLE);
    let card = |row| cell(&EXAMPLE, "", ["effects", row, "error if left out"]);
    assert_error!(thick - card("thickness of aluminium"), 3.5e-7);
    assert_error!(warm - card("warmer by ten kelvin"), 5.3e-8);
}

/// A plate that turns and yields, against its exact form: the piece at s goes to sin(ks)/(k cos(k)).
#[test]
fn a_turning_plate_stretches() {
    let (mut errors, mut first) = (Errors::of("growth"), Errors::of("first order"));
    for number in [1e-3, 0.01, 0.1, 0.5] {
        let k = (1.25_f64 * number).sqrt();
        let part = (1.0 - sin(2.0 * k) / (2.0 * k)) / (k * k * cos(k) * cos(k));
        errors.push(yielded(number).unwrap().0 * number - (1.5 * part - 1.0));
        first.push((1.5 * part - 1.0 - number) / (number * number));
    }
    assert_largest!(errors, 4, @"7.81e-14");
    first.exceed(0.7, 4);
}

#[test]
fn other_plates_and_motions_are_confirmed() {
    let plates = ["", "--height 0.3", "--width 2 --height 0.01 --mass 1e-3", "--mass 1e6 --width 1e-6"];
    let motions = ["--turn 0", "--turn -7 --omega-z 0", "--omega-x 300 --omega-y=-200 --omega-z 1e-9"];
    let runs = plates.iter().flat_map(|plate| motions.map(|motion| format!("{plate} {motion}")));
    confirmed(&EXAMPLE, runs, 12);
}

#[test]
fn what_is_no_plate_is_refused() {
    refused(&EXAMPLE, [
        ("--mass 0", "mass = 0 is not allowed"),
        ("--width=-0.4", "width = -0.4 is not allowed"),
        ("--height nan", "not a finite number"),
        ("--tolerance 1e-20", "tolerance = 1e-20 is not allowed"),
        ("--omega-x 1e200", "is not allowed"),
    ]);
}
