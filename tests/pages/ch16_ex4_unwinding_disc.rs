//! Exercise 16.4, a disc that unwinds from a string. That Newton's law in the plane and Lagrange's
//! equations in angles confirm each other is part of the report.

use kit::{simpson, times};
use pages::ch16_ex4_unwinding_disc::physics::{Disc, Leaves};
use pages::ch16_ex4_unwinding_disc::*;
use rotation_dynamics::math::{acos, atan2, cos, hypot, sin, sincos};
use support::{Errors, assert_largest};

/// The solver knows accelerations only. The string has its length all the way, measured along its
/// straight part and the rim, and the energy stays; without the rotation it does not.
#[test]
fn length_and_energy_are_kept_over_the_knot() {
    let (mut length, mut energy) = (Errors::of("length, R"), Errors::of("energy, M g R"));
    let (mut damaged, mut phases) = (Errors::of("energy without the rotation"), [0; 3]);
    for d in [usual(), Disc { shape: 1.0, wound: 3.0, free: 1.2 }, Disc { shape: 5.0, wound: 10.0, free: 4.0 }] {
        let run = d.run(1e-14).unwrap();
        for k in 1..=60 {
            let (leaves, y) = run.at(run.end_time() * f64::from(k) / 60.0).unwrap();
            phases[leaves as usize] += 1;
            let ([x, height, ..], (s, c)) = (y, sincos(y[2]));
            let far = hypot(x, height);
            // Where the knot is if the string has its length: on the rim, beyond the point where
            // a tangent from the hook touches it.
            let on_rim = |side: f64| {
                let touches = atan2(-height, -x) + side * acos(1.0 / far);
                let knot = touches + side * (d.length() - (far * far - 1.0).sqrt());
                hypot(cos(knot) - c, sin(knot) - s)
            };
            length.push(match leaves {
                Leaves::Unwinding => on_rim(-1.0),
                Leaves::Knot => hypot(x + c, height + s) - d.length(),
                Leaves::Winding => on_rim(1.0),
            });
            energy.push(d.energy(&y) + d.free);
            damaged.push(d.energy(&y) + d.free - 0.5 * d.shape * y[5] * y[5]);
        }
    }
    assert!(phases.iter().all(|count| *count > 5), "{phases:?}");
    assert_largest!(length, 180, @"3.82e-14");
    assert_largest!(energy, 180, @"2.38e-14");
    damaged.exceed(4.6e-4, 180);
}

/// Where the last of the string leaves the rim the knot is at rest and the tension goes on as it
/// was; a solver that reverses the velocity has no time for the change of momentum.
#[test]
fn the_tension_does_not_jump_at_either_end_of_the_turn() {
    let mut errors = Errors::of("jump of T, M g");
    for d in [usual(), Disc { shape: 1.0, ..usual() }, Disc { wound: 50.0, ..usual() }] {
        let run = d.run(1e-14).unwrap();
        for (name, sides) in [("all unwound", [Leaves::Unwinding, Leaves::Knot]), ("winds up", [Leaves::Knot, Leaves::Winding])] {
            let state = run.transition(name).unwrap().before;
            let [before, after] = sides.map(|leaves| d.taut(leaves, &state).tension);
            errors.push(after - before);
        }
        // But a little later it is many times the weight.
        assert!(d.peak(&run).unwrap() > 10.0);
    }
    assert_largest!(errors, 6, @"5.95e-14");
    // On the way up it is well below the weight again, though the string swings.
    let (d, run) = (usual(), usual().run(1e-14).unwrap());
    let [up, top] = ["winds up", "top"].map(|name| run.transition(name).unwrap().t);
    let step = (top - up) / 100.0;
    let pull = |t| d.taut(Leaves::Winding, &run.at(t).unwrap().1).tension;
    let most = times(up + 0.5 * step, top - 0.5 * step, 99).map(pull).fold(0.0, f64::max);
    assert!((0.462..0.463).contains(&most), "{most}");
}

/// The impulse of the string in the turn is what the momentum changes by, with gravity: the same
/// for a turn and for a bounce. Simpson's rule over the tension.
#[test]
fn the_turn_gives_the_impulse_of_a_bounce() {
    let d = Disc { free: 1e6, ..usual() };
    let run = d.run(1e-14).unwrap();
    let [from, to] = ["all unwound", "winds up"].map(|name| run.transition(name).unwrap().t);
    let pull = |t| Ok::<_, kit::Error>(d.taut(Leaves::Knot, &run.at(t)?.1).tension);
    let impulse = simpson([from, to], 2000, pull).unwrap();
    let left = impulse - 2.0 * (2.0 * d.wound / (1.0 + d.shape)).sqrt();
    // Without gravity too much is left.
    assert!((left - (to - from)).abs() < 2.96e-12 && left > 0.9, "{left}");
}

/// The stiffer the string, the nearer its largest tension is to that of one that does not give.
#[test]
fn a_stiff_string_is_one_that_does_not_give() {
    let d = usual();
    let run = d.run(1e-14).unwrap();
    let (start, firm) = (run.transition("all unwound").unwrap().before, d.peak(&run).unwrap());
    let mut errors = Errors::of("peak, relative");
    for stiffness in [1e6, 1e8] {
        errors.add(d.softly(&start, stiffness, 1e-12).unwrap()[0], firm, firm);
    }
    assert_largest!(errors, 2, @"1.56e-3");
    assert!(d.softly(&start, 100.0, 1e-12).unwrap()[0] < 0.7 * firm);
    assert!(d.softly(&start, 2000.0, 1e-12).unwrap()[0] > 1.1 * firm);
}

fn usual() -> Disc {
    disc(&Parameters::default()).unwrap()
}
