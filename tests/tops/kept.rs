//! What is kept, and where energy goes.

use super::{G, others, simpson, toy};
use models::tops::*;
use rotation_dynamics::effects::{DiscDrag, Effect};
use support::{Errors, assert_largest};

/// Largest relative change of energy, Jellett's integral, L_Z and L_3 over a run.
fn drift<F: TipFriction, R: ResistingMoment, E: Effect>(run: &TopMotion<F, R, E>) -> [f64; 4] {
    let (top, end) = (run.top(), run.end_time());
    let values = |t: f64| {
        let at = run.configuration(t).unwrap();
        let along = at.angular_momentum.dot(&at.axis);
        [top.energy(&at), top.jellett(&at), at.angular_momentum.z(), along]
    };
    let first = values(0.0);
    let mut most = [0.0_f64; 4];
    for i in 1..=200 {
        let now = values(end * f64::from(i) / 200.0);
        for k in 0..4 {
            most[k] = most[k].max((now[k] / first[k] - 1.0).abs());
        }
    }
    most
}

const THROW: Throw = Throw::spinning(0.3, 150.0).precessing(6.0);

#[test]
fn each_law_keeps_what_it_must() {
    let (mut kept, mut lost) = (Errors::of("kept"), Errors::of("not kept"));
    for shape in [toy(0.005), toy(0.001), others()[0], others()[1]] {
        let top = || Top::new(shape, G).unwrap();
        let [e, j, z, s] = drift(&top().simulate(&THROW, 2.0, 1e-13).unwrap());
        [e, j, z, s].into_iter().for_each(|d| kept.push_at(d, "smooth"));
        let [e, j, z, _] = drift(&top().on(NoSlip).simulate(&THROW, 2.0, 1e-13).unwrap());
        [e, j].into_iter().for_each(|d| kept.push_at(d, "no slip"));
        lost.push_at(z, "no slip");
        let [e, j, ..] =
            drift(&top().on(Dry::new(0.05).unwrap()).simulate(&THROW, 1.0, 1e-13).unwrap());
        kept.push_at(j, "dry");
        lost.push_at(e, "dry");
        let drilled =
            top().on(Dry::new(0.05).unwrap()).resisted_by(Drilling::new(0.1, 1e-4).unwrap());
        lost.push_at(drift(&drilled.simulate(&THROW, 1.0, 1e-13).unwrap())[1], "drilled");
    }
    assert_largest!(kept, 28, @"1.05e-14");
    lost.exceed(1e-4, 12);
}

/// The energy that is gone is the work of friction, couples and air.
#[test]
fn the_energy_goes_where_the_powers_say() {
    let (mut errors, mut damaged) =
        (Errors::of("energy, relative"), Errors::of("without friction"));
    for shape in [toy(0.005), others()[0], others()[1]] {
        let air = DiscDrag::new(0.03, 1.2, 1.5e-5, 250.0).unwrap();
        let top = Top::new(shape, G).unwrap().on(Patch::new(0.05, 1e-4).unwrap());
        let top = top.resisted_by(RollingResistance::new(1e-4, 10.0).unwrap());
        let top = top.in_effect(air).unwrap().sloping(0.05).unwrap();
        let run = top.simulate(&THROW, 1.0, 1e-12).unwrap();
        let energy = |t: f64| top.energy(&run.configuration(t).unwrap());
        let power = |t: f64, part: f64| {
            let (at, forces) = run.forces(t).unwrap();
            let powers = top.powers(&at, &forces);
            part * powers.sliding + powers.couple + powers.effects
        };
        let change = energy(1.0) - energy(0.0);
        let work = |part: f64| simpson(0.0, 1.0, 4000, |t| power(t, part));
        errors.push(work(1.0) / change - 1.0);
        damaged.push(work(0.0) / change - 1.0);
    }
    assert_largest!(errors, 3, @"2.27e-11");
    damaged.exceed(0.05, 3);
}

/// A tip that is made to slip: rolling asks for more than friction gives. What follows does
/// not depend on the size of the steps, and a very small patch does the same.
#[test]
fn a_tip_slips_off_and_grips_again() {
    let shape = toy(0.005).with_rim(0.03, 0.0).unwrap();
    let throw = Throw::spinning(0.2, 90.0).precessing(9.0).rolling();
    let dry = |step: f64| {
        let top = Top::new(shape, G).unwrap().on(Dry::new(0.2).unwrap());
        top.simulate(&throw, 2.0, step).unwrap()
    };
    let (fine, coarse) = (dry(1e-12), dry(1e-9));
    let slips = fine.event("slips").unwrap();
    let mut errors = Errors::of("events, relative");
    for (a, b) in fine.run().transitions().iter().zip(coarse.run().transitions()) {
        assert_eq!(a.name, b.name);
        errors.push_at(a.t / b.t - 1.0, a.name);
    }
    let falls = fine.event("falls").unwrap().t;
    assert!(slips.t > 0.0 && falls > slips.t);
    assert_largest!(errors, 2, @"1.81e-7");
    // The smaller the patch, the nearer; the twin is a floor that holds.
    let off = |radius: f64| {
        let top = Top::new(shape, G).unwrap().on(Patch::new(0.2, radius).unwrap());
        top.simulate(&throw, 2.0, 1e-11).unwrap().event("falls").unwrap().t - falls
    };
    let [large, small] = [1e-6, 1e-7].map(off);
    let held = Top::new(shape, G).unwrap().on(NoSlip);
    let held = held.simulate(&throw, 2.0, 1e-11).unwrap().event("falls").unwrap().t - falls;
    assert!(
        (large / small - 11.86).abs() < 0.01 && small.abs() < 7e-6 && held.abs() > 1e-3,
        "{large} {small} {held}"
    );
}
