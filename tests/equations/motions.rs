//! What the equations say about whole motions: the gyroscope's angles in time, its
//! steady precession, cusps, and the sleeping top.

use super::lagrangian::STATES;
use super::{instance, theta_equation_4};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{Dop853, Ode, size_or};
use rotation_dynamics::math::{EPS, cos, sin, tan};
use support::{Errors, assert_largest};

/// Equations (4) to (6) for theta, dtheta/dt', phi, zeta; `factor` damages (5).
struct FourToSix {
    a: f64,
    b: f64,
    c: f64,
    factor: f64,
}

impl Ode<4> for FourToSix {
    fn derivative(&self, _t: f64, &[theta, nutation, _, _]: &[f64; 4]) -> [f64; 4] {
        let (st, ct) = (sin(theta), cos(theta));
        let precession = self.factor * self.a.sqrt() * (self.b - ct) / (st * st);
        [
            nutation,
            theta_equation_4(self.a, self.b, self.c, theta),
            precession,
            1.0 / self.a.sqrt() - precession * ct,
        ]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

#[test]
fn eq_16_2_4_to_6_describe_the_motion() {
    // The closed form at 80 times of each motion of figures 3 and 4, against the three
    // equations integrated at a tolerance of 1e-14.
    let motions = [
        (1.2, 0.55, Start::ThetaMin),
        (0.6, 0.11, Start::ThetaMin),
        (0.6, -0.08, Start::ThetaMin),
        (0.6, -0.085, Start::ThetaMax),
    ];
    let apart = |factor: f64| {
        let mut of_all = Errors::of("motions of figures 3 and 4");
        for (b, energy, start) in motions {
            let top = ReducedTop::new(2.0, b, 0.2).expect("the notes' parameters");
            let exact = HeavyTop::from_energy(top, energy, start, 0.0, 0.0).expect("a motion");
            let equations = FourToSix { a: 2.0, b, c: 0.2, factor };
            let state = [exact.angles(0.0).theta, 0.0, 0.0, 0.0];
            let run = Dop853::new(1e-14)
                .and_then(|method| method.solve(&equations, 0.0, &state, 20.0, &[]))
                .expect("smooth");
            let mut of_this_motion = Errors::of("motion");
            for k in 1..=80 {
                let t = 0.25 * f64::from(k);
                let [theta, nutation, phi, zeta] = run.at(t).expect("within the run");
                let angles = exact.angles(t);
                of_this_motion.push(theta - angles.theta);
                of_this_motion.push(nutation - exact.theta_rate(t));
                of_this_motion.push(phi - angles.phi);
                of_this_motion.push(zeta - angles.zeta);
            }
            of_all.push_at(of_this_motion.largest(), (b, energy));
        }
        of_all
    };
    assert_largest!(apart(1.0), 4, @"1.21e-13");
    apart(1.0 + 1e-6).exceed(1e-7, 4);
}

#[test]
fn eq_16_2_steady_precession() {
    // At the bottom of the valley: u p^2 - sqrt(a) p + c = 0 for p = dphi/dt'.
    let mut residuals = Errors::in_units_of(EPS, "steady precession");
    let mut damaged = Errors::in_units_of(EPS, "steady precession, the weight turned round");
    for (a, b, c) in [(2.0, 1.2, 0.2), (2.0, 0.6, 0.2), (0.165, 0.57, 0.006), (1.25, 0.6, -0.3)] {
        let top = ReducedTop::new(a, b, c).expect("a top");
        let (theta, _) = top.minimum();
        let u = cos(theta);
        let precession =
            HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0).expect("steady").phi_rate(0.0);
        let residual = |sign: f64| u * precession * precession - a.sqrt() * precession + sign * c;
        let scale = a.sqrt() * (1.0 + b.abs()) / (1.0 - u * u);
        residuals.push_at(residual(1.0) / scale, a);
        damaged.push_at(residual(-1.0) / scale, a);
    }
    assert_largest!(residuals, 4, @"0.279");
    damaged.exceed(1e10, 4);
}

#[test]
fn eq_16_2_cusps_of_a_thin_disc() {
    // Released at rest with a = 2: sin^2(theta) sin^2(zeta) = (b - cos(theta))/c, so zeta
    // gains exactly half a turn from cusp to cusp. Not so for a = 1.9.
    let errors = |a: f64| {
        let mut errors = Errors::of("half a turn, and the height");
        for (b, c) in [(0.6, 0.2), (0.0, 0.5), (-0.5, 0.3), (0.9, 0.1)] {
            let top = ReducedTop::new(a, b, c).expect("a top");
            let energy = top.cusp_energy().expect("|b| < 1");
            let exact =
                HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0).expect("cusps");
            errors.push(exact.spin_per_period() - core::f64::consts::PI);
            for k in 1..20 {
                let angles = exact.angles(0.37 * f64::from(k));
                let height = sin(angles.theta) * sin(angles.zeta);
                errors.push(c * height * height - (b - cos(angles.theta)));
            }
        }
        errors
    };
    assert_largest!(errors(2.0), 4 * 20, @"3.89e-16");
    assert!(errors(1.9).largest() > 1e-2);
}

#[test]
fn eq_16_2_sleeping_top_threshold() {
    // With b = 1 the barrier is (a/2) tan^2(theta/2): U'' at the pole is a/4 - c.
    // Stable while a/4 > c, that is I3 w3 > 2 sqrt(I1 m g l).
    let mut errors = Errors::of("curvature at the pole");
    for (a, critical) in [(2.0, 0.5), (0.2, 0.05), (1.0, 0.25)] {
        let curvature = |c: f64| {
            let half = tan(0.5e-3);
            let potential = 0.5 * a * half * half - c * (1.0 - cos(1e-3));
            2.0 * potential / 1e-6
        };
        // The next term of the series is 1e-6 (a/24 + c/12), below 1e-6.
        for c in [0.9 * critical, critical, 1.1 * critical] {
            errors.push_at(curvature(c) - (a / 4.0 - c), (a, c));
        }
        assert!(curvature(0.9 * critical) > 0.0 && curvature(1.1 * critical) < 0.0);
        // Damaged: a threshold of a/2 is far off.
        assert!((curvature(critical) - (a / 2.0 - critical)).abs() > 0.04);
    }
    assert_largest!(errors, 9, @"1.29e-7");
    // The notes' rotor: a/4 = c at w3 = 2 sqrt(I1 m g l)/I3.
    let s = STATES[0];
    let spin = 2.0 * (s.i1 * s.mgl).sqrt() / s.i3;
    instance("critical spin", spin, 114.876468810718, 5e-13);
    let c = s.mgl * s.i3 / (s.i3 * spin * s.i3 * spin);
    instance("c at the critical spin", c, 0.25 * s.i3 / s.i1, 1e-16);
}

#[test]
fn eq_16_2_top_moment_about_the_tip() {
    // I1' = I1 + m l^2: the particles of a body carried along its axis by l.
    let (across, mass, lever): (f64, f64, f64) = (4.5e-4, 0.5, 0.1);
    let ring = (across / mass).sqrt();
    let mut about_centre = 0.0;
    let mut about_tip = 0.0;
    for k in 0..12 {
        let angle = core::f64::consts::TAU * f64::from(k) / 12.0;
        // A ring of twelve particles in the plane x z: its moment about y is m ring^2.
        let (x, z) = (ring * cos(angle), ring * sin(angle));
        about_centre += mass / 12.0 * (x * x + z * z);
        about_tip += mass / 12.0 * (x * x + (z + lever) * (z + lever));
    }
    instance("I1", about_centre, across, 1e-18);
    instance("I1'", about_tip, across + mass * lever * lever, 1e-17);
    instance("I1'", about_tip, 0.00545, 1e-17);
    assert!((about_tip - (across + mass * lever)).abs() > 1e-2);
}
