//! Section 16.2 (2): the free top by Lagrange's equations, judged by the library's free body,
//! whose closed form works with quaternions and knows no angle.

use crate::answers::{computed, confirmed, ledger, refused, value};
use kit::prelude::*;
use pages::ch16_2_torque_free::*;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::integrators::Ode;
use std::f64::consts::TAU;
use support::{Errors, assert_error, assert_largest};

/// A thin top, a flat one, and the vertical inside the cone of the axis.
fn tops() -> [Top; 3] {
    let top = wide(&Parameters::default()).unwrap();
    [top, Top { i1: 0.6 * top.i3, ..top }, Top { lean: 0.2, ..top }]
}

/// Angles, their rates and their second derivatives, from the library at five times.
fn seen(free: &FreeBody, t: f64) -> [[f64; 3]; 3] {
    let (h, middle) = (4e-4, free.attitude(t).euler_angles());
    let at = |k: f64| {
        let angles = free.attitude(t + k * h).euler_angles();
        let near = |a: f64, b: f64| a + TAU * ((b - a) / TAU).round();
        [angles.theta, near(angles.phi, middle.phi), near(angles.zeta, middle.zeta)]
    };
    let v = [-2.0, -1.0, 0.0, 1.0, 2.0].map(at);
    let rate = |i: usize| (8.0 * (v[3][i] - v[1][i]) - (v[4][i] - v[0][i])) / (12.0 * h);
    let second = |i: usize| {
        let sides = 16.0 * (v[3][i] + v[1][i]) - (v[4][i] + v[0][i]);
        (sides - 30.0 * v[2][i]) / (12.0 * h * h)
    };
    [v[2], [0, 1, 2].map(rate), [0, 1, 2].map(second)]
}

fn moments(top: &Top) -> Vec<[[f64; 3]; 3]> {
    let free = top.free_body().unwrap();
    times(0.03, 0.9, 29).map(|t| seen(&free, t * top.nod())).collect()
}

/// The two momenta are kept along the free motion, and are components of L. With the cosine alone,
/// as printed, neither is.
#[test]
fn eq_16_2_2_momenta() {
    let [mut errors, mut printed] = ["momenta over L", "with cos theta alone"].map(Errors::of);
    for top in tops() {
        for [[theta, ..], [_, turn, spin], _] in moments(&top) {
            let ((s, c), l) = (sincos(theta), top.momentum());
            let along = |rate: f64| top.i3 * (spin + rate * c);
            let upright = |along: f64| along * c + top.i1 * turn * s * s;
            errors.push((along(turn) - top.spin_momentum()) / l);
            errors.push((upright(along(turn)) - top.vertical_momentum()) / l);
            printed.push((along(1.0) - top.spin_momentum()) / l);
        }
    }
    assert_largest!(errors, 3 * 30 * 2, @"2.54e-8");
    assert!(printed.largest() > 0.1);
}

/// The equation of theta, with second derivatives from the library's motion.
#[test]
fn eq_16_2_2_theta() {
    let [mut errors, mut printed] = ["torque over I1 Omega^2", "with cos theta alone"].map(Errors::of);
    for top in tops() {
        let unit = top.i1 * top.along * top.along;
        for [[theta, ..], [_, turn, spin], [nod2, ..]] in moments(&top) {
            let (s, c) = sincos(theta);
            let rest = |rate: f64| {
                let bent = top.i1 * nod2 - top.i1 * turn * turn * s * c;
                (bent + top.i3 * (spin + rate * c) * turn * s) / unit
            };
            errors.push(rest(turn));
            printed.push(rest(1.0));
        }
    }
    assert_largest!(errors, 3 * 30, @"9.70e-7");
    assert!(printed.largest() > 0.05);
}

/// theta'' = 0: of all rates of precession only zero and I3 Omega_z/(I1 cos theta) leave the tilt
/// alone, at every tilt.
#[test]
fn eq_16_2_2_steady() {
    let (top, mut errors) = (tops()[0], Errors::of("rate by bisection, less one"));
    let pull = |theta: f64, turn: f64| {
        let spin = top.along - turn * cos(theta);
        top.equations().derivative(0.0, &[theta, 0.0, 0.0, 0.0, turn, spin])[3]
    };
    for theta in [0.1, 0.5, 1.0, 1.4] {
        let steady = top.spin_momentum() / (top.i1 * cos(theta));
        let [low, _] = bisect([0.3 * steady, 3.0 * steady], 0.0, |turn| pull(theta, turn) < 0.0);
        errors.push(low / steady - 1.0);
        assert_eq!(pull(theta, 0.0), 0.0);
        // Below it the tilt falls, above it and for turning back it rises.
        assert!(pull(theta, 0.5 * steady) < 0.0 && pull(theta, -0.5 * steady) > 0.0);
    }
    assert_largest!(errors, 4, @"3.33e-16");
    assert_error!(value(&EXAMPLE, "phi_rate") - 10.049_875_621_120_9, 7.11e-15);
}

/// The spherical triangle, Lagrange's equations in steps, and the library.
#[test]
fn three_routes_give_one_motion() {
    let [mut triangle, mut stepped, mut twin] = ["triangle", "steps", "a cone off by 1e-6"].map(Errors::of);
    for top in tops() {
        let (free, run) = (top.free_body().unwrap(), top.stepped(3.0 * top.nod(), 1e-15).unwrap());
        let damaged = Top { cone: top.cone + 1e-6, ..top };
        for t in times(0.1 * top.nod(), 2.9 * top.nod(), 40) {
            let (angles, exact) = (top.angles(t).unwrap(), free.attitude(t).euler_angles());
            let off = |a: f64, b: f64| (a - b) - TAU * ((a - b) / TAU).round();
            triangle.push(hypot(off(angles.theta, exact.theta), off(angles.phi, exact.phi)));
            triangle.push(off(angles.zeta, exact.zeta));
            let [theta, phi, zeta, ..] = run.at(t).unwrap();
            stepped.push(hypot(off(theta, exact.theta), off(phi, exact.phi)));
            stepped.push(off(zeta, exact.zeta));
            twin.push(damaged.angles(t).unwrap().theta - exact.theta);
        }
    }
    assert_largest!(triangle, 3 * 41 * 2, @"8.44e-15");
    assert_largest!(stepped, 3 * 41 * 2, @"7.11e-15");
    assert!(twin.largest() > 5e-7);
}

/// The energy of the nodding along the library's motion, and the bottoms of the two valleys.
#[test]
fn eq_16_2_2_effective_potential() {
    let (mut errors, mut damaged) = (Errors::of("energy over E'"), Errors::of("without V"));
    for top in tops() {
        for [[theta, ..], [nod, ..], _] in moments(&top) {
            let moving = 0.5 * top.i1 * nod * nod / top.energy();
            errors.push(moving + top.potential(theta) / top.energy() - 1.0);
            damaged.push(moving - 1.0);
        }
    }
    assert_largest!(errors, 3 * 30, @"1.24e-7");
    assert!(damaged.largest() > 0.5);
    let [outside, _, inside] = tops();
    let ratio = outside.vertical_momentum() / outside.spin_momentum();
    assert!(outside.potential(acos(ratio)) < 1e-15 * outside.energy());
    let bottom = acos(inside.spin_momentum() / inside.vertical_momentum());
    let v = |by: f64| inside.potential(bottom + by) / inside.energy();
    assert!(v(0.0) > 0.1 && v(0.01) > v(0.0) && v(-0.01) > v(0.0));
}

/// The card of effects: with I2 = I1 (1 + d) the cone is no circle. The prediction and the closed
/// form; the damaged twin forgets how wide the cone is.
#[test]
fn unequal_moments_squeeze_the_cone_as_predicted() {
    let (mut errors, mut damaged) = (Errors::of("squeeze over prediction, less one"), Errors::of("as if narrow"));
    for cone in [0.01, 0.1, 0.35, 1.0] {
        let wide = Top { cone, ..tops()[0] };
        let ratio = squeezed(&wide, 1e-3).unwrap().unwrap() / unequal(&wide, 1e-3);
        errors.push(ratio - 1.0);
        if cone > 0.3 {
            damaged.push(ratio * tan(cone) / cone - 1.0);
        }
    }
    assert_largest!(errors, 4, @"1.25e-3");
    damaged.exceed(0.04, 2);
    assert_eq!(ledger(&EXAMPLE, "").len(), 3);
    // A body that is a sphere but for the hundredth, and a needle that cannot have it.
    for flags in ["--height 0.0866025403784", "--radius 0.004 --height 0.3"] {
        assert_eq!(ledger(&EXAMPLE, flags).len(), 2, "{flags}");
    }
}

#[test]
fn other_tops_are_confirmed() {
    let bodies = ["", "--height 0", "--height 0.0866025403784", "--radius 0.01 --omega-z 300"];
    let motions = ["--lean 0.2", "--lean 1.5 --cone 1.2", "--cone 0.01 --lean 0.02", "--omega-y 40"];
    let runs = bodies.iter().flat_map(|body| motions.iter().map(move |motion| format!("{body} {motion}")));
    confirmed(&EXAMPLE, runs, 16);
    let others = ["--omega-z=-20", "--omega-y=-1", "--lean=2.5", "--cone=1.5 --lean=0.3", "--omega-z=-20 --lean=0.2"];
    confirmed(&EXAMPLE, others, 5);
}

/// With the spin the other way round all angles go the other way, in the same time.
#[test]
fn the_other_spin_is_a_mirror() {
    for (key, turns) in [
        ("spin_momentum", -1.0), ("vertical_momentum", -1.0), ("phi_rate_max", -1.0), ("phi_rate_min", -1.0),
        ("phi_advance", -1.0), ("zeta_advance", -1.0), ("theta_max", 1.0), ("theta_min", 1.0), ("nod", 1.0), ("energy", 1.0),
    ] {
        let [there, here] = ["--lean=0.2", "--lean=0.2 --omega-z=-20"].map(|flags| computed(&EXAMPLE, flags, key));
        assert_eq!(there, turns * here, "{key}");
    }
}

#[test]
fn what_has_no_nod_is_refused() {
    refused(&EXAMPLE, [
        ("--lean 0.35", "at 0 the axis meets Z"),
        ("--lean 0 --cone 0.2", "lean = 0 is not allowed: it must be from 0.001 to 3.1"),
        ("--lean 2.8", "pi - lean - cone"),
        ("--omega-y 0", "at 0 it does not wobble"),
        ("--omega-z 0", "without spin it only tumbles"),
        ("--cone 1.6", "cone = 1.6 is not allowed"),
        ("--radius=-1", "radius = -1 is not allowed"),
        ("--radius 0.001 --height 10", "a thinner needle has no spin"),
    ]);
}
