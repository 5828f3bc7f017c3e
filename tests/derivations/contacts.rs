//! The page `how_contacts`: forces, impulses and corrections of a rod with one end on the floor,
//! by the two-by-two matrix of its contact, and where Painlevé's paradoxes begin.

use rotation_dynamics::error::Error;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Surface, entry, motion, motion_within,
};
use support::{Errors, assert_error, assert_largest};

const G: f64 = 9.81;

/// A uniform rod of 1 kg and half-length 1 m, whose angle is that of its upper end.
#[derive(Clone, Copy)]
struct Rod {
    friction: f64,
    restitution: f64,
}

fn arm(angle: f64) -> [f64; 2] {
    let (sin, cos) = sincos(angle);
    [-cos, -sin]
}

impl Mechanism<3, 1> for Rod {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0 / 3.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, rod: &MechanismState<3>) -> [Contact<3>; 1] {
        let end = Contact::corner("end", rod, arm(rod.q[2]), Surface::FLOOR);
        [end.friction(self.friction).restitution(self.restitution)]
    }
}

/// What the page calls W and a: the contact's own two by two, and what it would do if free.
struct Plain {
    normal: [f64; 3],
    tangent: [f64; 3],
    w: [f64; 3],
    free: [f64; 2],
}

impl Plain {
    fn new(state: &MechanismState<3>) -> Self {
        let [x, y] = arm(state.q[2]);
        let (normal, tangent) = ([0.0, 1.0, x], [1.0, 0.0, -y]);
        let over_mass = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + 3.0 * a[2] * b[2];
        let square = state.v[2] * state.v[2];
        Self {
            normal,
            tangent,
            w: [over_mass(normal, normal), over_mass(normal, tangent), over_mass(tangent, tangent)],
            free: [-G - square * y, -square * x],
        }
    }

    fn speeds(&self, v: &[f64; 3]) -> [f64; 2] {
        let dot = |a: [f64; 3]| a[0] * v[0] + a[1] * v[1] + a[2] * v[2];
        [dot(self.normal), dot(self.tangent)]
    }

    /// N of a slip in this sense.
    fn pushes(&self, friction: f64, sense: f64) -> f64 {
        -self.free[0] / (self.w[0] - sense * friction * self.w[1])
    }
}

/// The rod on its end, at this angle, with this slip and this rate.
fn on_its_end(angle: f64, slip: f64, rate: f64) -> MechanismState<3> {
    let [x, y] = arm(angle);
    MechanismState { q: [0.0, -y, angle], v: [slip + y * rate, -x * rate, rate] }
}

#[test]
fn force_of_a_slip_and_of_a_hold() {
    let errors = |damage: f64| {
        let mut errors = Errors::of("N and T, in units of the weight");
        for angle in [0.3, 0.9, 1.4, 2.2] {
            for rate in [0.0, 0.7] {
                for (friction, slip) in [(0.3, 1.0), (0.3, -1.0), (5.0, 0.0)] {
                    let rod = Rod { friction, restitution: 0.0 };
                    let start = on_its_end(angle, slip, rate);
                    let motion = motion_within(rod, 1e-10, start, 1e-3).expect("a motion");
                    let [force] = motion.forces(0.0).expect("at the start");
                    let plain = Plain::new(&start);
                    let [nn, nt, tt] = plain.w;
                    let nt = damage * nt;
                    let [a, b] = plain.free;
                    let (normal, tangential) = if slip == 0.0 {
                        let det = nn * tt - nt * nt;
                        ((nt * b - tt * a) / det, (nt * a - nn * b) / det)
                    } else {
                        let w = [nn, nt, tt];
                        let normal = Plain { w, ..plain }.pushes(friction, slip.signum());
                        (normal, -slip.signum() * friction * normal)
                    };
                    let off = (force.normal - normal).abs() + (force.tangential - tangential).abs();
                    errors.push_at(off / G, (angle, rate, friction, slip));
                }
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 24, @"3.62e-16");
    errors(1.1).exceed(1e-4, 24);
}

#[test]
fn paradoxes_begin_at_four_thirds() {
    // The least friction with which W_nn - mu |W_nt| has a zero, over all angles.
    let critical = |angle: f64| {
        let [nn, nt, _] = Plain::new(&on_its_end(angle, 0.0, 0.0)).w;
        nn / nt.abs()
    };
    let least = (1..1570).map(|k| critical(1e-3 * f64::from(k))).fold(f64::INFINITY, f64::min);
    // As near as the angles tried come to that of tangent 2.
    assert_error!(least, 4.0 / 3.0, 6.9e-8);
    // Below it there is one answer; above none, or, turned so fast that it would lift, two.
    let method = Dop853::new(1e-9).expect("a tolerance");
    let mut ran = 0;
    for angle in [0.6, 1.1, 1.3] {
        for side in [1.0, -1.0] {
            let angle = if side > 0.0 { angle } else { core::f64::consts::PI - angle };
            for (part, rate, which) in [(0.99, 0.0, 1), (1.01, 0.0, 0), (1.01, 9.0, 2)] {
                let friction = part * critical(angle);
                let rod = Rod { friction, restitution: 0.0 };
                let sense = Plain::new(&on_its_end(angle, 0.0, 0.0)).w[1].signum();
                let start = on_its_end(angle, sense, rate);
                let plain = Plain::new(&start);
                assert_eq!(plain.free[0] > 0.0, which == 2);
                let found = match motion(rod, &method, start, 1e-4) {
                    Ok(_) => 1,
                    Err(Error::ContactsUndetermined { motions, .. }) if motions.is_empty() => 0,
                    Err(Error::ContactsUndetermined { motions, .. }) => motions.len(),
                    Err(other) => panic!("{other}"),
                };
                assert_eq!(found, which, "{angle} {part} {rate}");
                ran += 1;
            }
        }
    }
    assert_eq!(ran, 3 * 2 * 3);
}

#[test]
fn impulse_of_a_bounce() {
    let errors = |damage: f64| {
        let mut errors = Errors::of("velocities after, and energy lost");
        for angle in [0.4, 1.0, 2.0] {
            for (friction, restitution) in [(0.0, 0.6), (0.2, 0.6), (0.2, 0.0)] {
                let rod = Rod { friction, restitution };
                let mut start = on_its_end(angle, 40.0, 0.3);
                start.q[1] += 0.5;
                let motion = motion_within(rod, 1e-10, start, 0.6).expect("a motion");
                let name = if restitution > 0.0 { "end bounces" } else { "end touches" };
                let event = motion.event(name).expect("it falls");
                let plain = Plain::new(&event.before);
                let [closing, _] = plain.speeds(&event.before.v);
                let normal = -(1.0 + damage * restitution) * closing
                    / (plain.w[0] - damage * friction * plain.w[1]);
                let tangential = -friction * normal;
                let over_mass = [1.0, 1.0, 3.0];
                let mut off = 0.0;
                for (j, over) in over_mass.into_iter().enumerate() {
                    let more = plain.normal[j] * normal + plain.tangent[j] * tangential;
                    off += (event.after.v[j] - event.before.v[j] - over * more).abs();
                }
                if friction == 0.0 {
                    let energy =
                        |v: &[f64; 3]| 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] / 3.0);
                    let lost = energy(&event.before.v) - energy(&event.after.v);
                    let e = damage * restitution;
                    off += (lost - 0.5 * (1.0 - e * e) * closing * closing / plain.w[0]).abs();
                }
                errors.push_at(off, (angle, friction, restitution));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 9, @"3.72e-13");
    errors(1.01).exceed(1e-3, 9);
}

#[test]
fn what_has_drifted_goes_back_by_least_action() {
    // delta q = -gap M^-1 n / W_nn.
    let errors = |damage: f64| {
        let mut errors = Errors::of("correction over the gap");
        for angle in [0.4, 1.0, 2.0] {
            let rod = Rod { friction: 0.0, restitution: 0.0 };
            let gap = 4e-13;
            let mut start = on_its_end(angle, 1.0, 0.0);
            start.q[1] += gap;
            let plain = Plain::new(&start);
            let gap = start.q[1] + arm(angle)[1];
            let (_, state) = entry(&rod, start).expect("a contact");
            for (j, over) in [1.0, 1.0, 3.0].into_iter().enumerate() {
                let want = -gap * over * plain.normal[j] / (damage * plain.w[0]);
                errors.push_at((state.q[j] - start.q[j] - want) / gap, (angle, j));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 9, @"1.55e-4");
    assert!(errors(1.1).largest() > 0.04);
}
