//! Every equation of the notes, each checked by a route that does not use it.
//!
//! For the gyroscope (Chapter 16, Section 2) the other route is the Lagrangian
//! summed over the particles of the body (`support/lagrangian.rs`), in six
//! states of motion. Each test ends with a damaged twin: the formula with one
//! thing wrong, which must miss by far more than the bound.

#[path = "support/lagrangian.rs"]
mod lagrangian;

use lagrangian::{Caught, Jet, PHI, STATES, THETA, ZETA, disagreement};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{Dop853, Ode};
use rotation_dynamics::math::{EPS, cos, sin, tan};

/// A damaged formula must miss by more than this many eps in every state.
const FAR: f64 = 1e10;

impl Caught {
    fn theta(&self) -> f64 {
        self.angles[THETA]
    }

    /// What the round-off of the particle route is measured by in an angular
    /// acceleration: the particles' own accelerations, (sum of |rates|)^2, cancel
    /// in the sum down to the ones that are left.
    fn acceleration_scale(&self) -> f64 {
        let turning: f64 = self.rates.iter().map(|r| r.abs()).sum();
        turning * turning + self.mgl.abs() / self.i1
    }

    /// (L_Z, L_z): the momenta of phi and of zeta.
    fn momenta(&self) -> (f64, f64) {
        (self.momentum(PHI), self.momentum(ZETA))
    }

    /// The parameters of the dimensionless equations: a, b, c and the unit of time.
    fn dimensionless(&self) -> (f64, f64, f64, f64) {
        let (vertical, spin) = self.momenta();
        (
            self.i3 / self.i1,
            vertical / spin,
            self.mgl / (spin * spin / self.i3),
            (self.i1 * self.i3).sqrt() / spin,
        )
    }
}

/// The notes' own instance of a quantity, to the printed digits.
fn instance(name: &str, value: f64, printed: f64, half_of_last_digit: f64) {
    assert!(
        (value - printed).abs() <= half_of_last_digit,
        "{name}: {value} is not {printed}"
    );
}

#[test]
fn eq_16_2_gyroscope_angular_velocity() {
    // Components on x (line of nodes), y, z (symmetry axis), against the
    // antisymmetric matrix R^T dR/dt turned from body axes to x, y, z by zeta.
    for component in 0..3 {
        let routes = |sign: f64| {
            move |s: &Caught| {
                let (rotation, rate) = s.rotation();
                let spin = |i: usize, j: usize| -> f64 {
                    (0..3)
                        .map(|k| rotation[k][i].value * rate[k][j].value)
                        .sum()
                };
                let body = [spin(2, 1), spin(0, 2), spin(1, 0)];
                let (sz, cz) = (sin(s.angles[ZETA]), cos(s.angles[ZETA]));
                let nodal = [
                    body[0] * cz - body[1] * sz,
                    body[0] * sz + body[1] * cz,
                    body[2],
                ];
                let [precession, nutation, turn] = s.rates;
                let (st, ct) = (sin(s.theta()), cos(s.theta()));
                let formula = [
                    sign * nutation,
                    sign * precession * st,
                    turn + sign * precession * ct,
                ];
                let scale = body.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                (nodal[component], formula[component], scale)
            }
        };
        let (_, worst) = disagreement(routes(1.0));
        assert!(worst <= 4.0, "component {component}: {worst} eps");
        let (least, _) = disagreement(routes(-1.0));
        assert!(least >= FAR, "component {component}: {least} eps");
    }
    let s = STATES[0];
    instance(
        "Omega_z",
        s.rates[ZETA] + s.rates[PHI] * cos(1.0),
        301.080604611736,
        5e-13,
    );
}

#[test]
fn eq_16_2_gyroscope_lagrangian() {
    let routes = |transverse: f64| {
        move |s: &Caught| {
            let [precession, nutation, turn] = s.rates;
            let across = precession * sin(s.theta());
            let along = turn + precession * cos(s.theta());
            let kinetic = 0.5 * transverse * s.i1 * (nutation * nutation + across * across)
                + 0.5 * s.i3 * along * along;
            let potential = s.mgl * cos(s.theta());
            (
                s.lagrangian().value,
                kinetic - potential,
                kinetic + s.mgl.abs(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 2.0, "{worst} eps"); // measured 1.92
    let (least, _) = disagreement(routes(1.01));
    assert!(least >= FAR, "{least} eps");
    instance("L", STATES[0].lagrangian().value, 40.535760182883, 5e-13);
}

#[test]
fn eq_16_2_gyroscope_spin_momentum() {
    // dL/dzeta' = I3 (zeta' + phi' cos theta) = L_z, and nothing drives it.
    let routes = |projection: f64| {
        move |s: &Caught| {
            let formula = s.i3 * (s.rates[ZETA] + projection * s.rates[PHI] * cos(s.theta()));
            (
                s.momentum(ZETA),
                formula,
                s.i3 * (s.rates[ZETA].abs() + s.rates[PHI].abs()),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 2.5, "{worst} eps"); // measured 2.49
    let (least, _) = disagreement(routes(0.99));
    assert!(least >= FAR, "{least} eps");
    let (_, drive) = disagreement(|s| (s.lagrangian().first[ZETA], 0.0, s.energy().abs()));
    assert!(drive <= 4.0, "{drive} eps");
    instance("L_z", STATES[0].momentum(ZETA), 0.270972544150563, 5e-16);
}

#[test]
fn eq_16_2_gyroscope_vertical_momentum() {
    // dL/dphi' = L_z cos theta + I1 phi' sin^2 theta = L_Z, and nothing drives it.
    let routes = |moment: f64| {
        move |s: &Caught| {
            let (vertical, spin) = s.momenta();
            let across = moment * s.i1 * s.rates[PHI] * sin(s.theta()) * sin(s.theta());
            (
                vertical,
                spin * cos(s.theta()) + across,
                spin.abs() + s.i1 * s.rates[PHI].abs(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 1.5, "{worst} eps"); // measured 1.03
    let (least, _) = disagreement(routes(1.01));
    assert!(least >= FAR, "{least} eps");
    let (_, drive) = disagreement(|s| (s.lagrangian().first[PHI], 0.0, s.energy().abs()));
    assert!(drive <= 4.0, "{drive} eps");
    instance("L_Z", STATES[0].momentum(PHI), 0.154125090690687, 5e-16);
}

#[test]
fn eq_16_2_2_precession_rate() {
    // phi' = (L_Z - L_z cos theta) / (I1 sin^2 theta), against the phi' that the state has.
    let routes = |factor: f64| {
        move |s: &Caught| {
            let (vertical, spin) = s.momenta();
            let below = s.i1 * sin(s.theta()) * sin(s.theta());
            let formula = (vertical - factor * spin * cos(s.theta())) / below;
            (formula, s.rates[PHI], (vertical.abs() + spin.abs()) / below)
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 1.5, "{worst} eps"); // measured 1.08
    let (least, _) = disagreement(routes(1.01));
    assert!(least >= FAR, "{least} eps");
}

#[test]
fn eq_16_2_gyroscope_theta_equation_with_rates() {
    // I1 theta'' - I1 phi'^2 sin cos + I3 (zeta' + phi' cos) phi' sin = m g l sin.
    let routes = |projection: f64| {
        move |s: &Caught| {
            let [precession, _, turn] = s.rates;
            let (st, ct) = (sin(s.theta()), cos(s.theta()));
            let along = turn + projection * precession * ct;
            let formula = s.mgl * st + s.i1 * precession * precession * st * ct
                - s.i3 * along * precession * st;
            (
                s.accelerations()[THETA],
                formula / s.i1,
                s.acceleration_scale(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 3.0, "{worst} eps"); // measured 2.93
    let (least, _) = disagreement(routes(-1.0));
    assert!(least >= FAR, "{least} eps");
}

/// theta'' from eq. (3), the momenta being numbers.
fn theta_equation_3(s: &Caught, bracket_sign: f64) -> f64 {
    let (vertical, spin) = s.momenta();
    let (st, ct) = (sin(s.theta()), cos(s.theta()));
    let across = vertical - spin * ct;
    let bracket = spin * st - bracket_sign * across / st * ct;
    (s.mgl * st - bracket * (across / (s.i1 * st * st))) / s.i1
}

#[test]
fn eq_16_2_3_theta_equation() {
    let routes = |bracket_sign: f64| {
        move |s: &Caught| {
            let formula = theta_equation_3(s, bracket_sign);
            (s.accelerations()[THETA], formula, s.acceleration_scale())
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 3.0, "{worst} eps"); // measured 2.93
    let (least, _) = disagreement(routes(-1.0));
    assert!(least >= FAR, "{least} eps");
    instance(
        "theta''",
        theta_equation_3(&STATES[0], 1.0),
        -6.15030340437294,
        5e-13,
    );
}

/// U_eff(theta), with derivatives in theta.
fn effective_potential(s: &Caught) -> Jet {
    let (vertical, spin) = s.momenta();
    let theta = Jet::variable(THETA, s.theta());
    let across = Jet::constant(vertical) - theta.cos() * spin;
    let sine = theta.sin();
    across * across * (sine * sine).reciprocal() * (0.5 / s.i1)
        - (Jet::constant(1.0) - theta.cos()) * s.mgl
}

#[test]
fn eq_16_2_gyroscope_energy() {
    // E = I1 (theta'^2 + phi'^2 sin^2)/2 + L_z^2/(2 I3) + m g l cos theta, and
    // E' = E - m g l - L_z^2/(2 I3) = I1 theta'^2/2 + U_eff.
    let routes = |offset: f64| {
        move |s: &Caught| {
            let spin = s.momentum(ZETA);
            let reduced = s.energy() - offset * s.mgl - spin * spin / (2.0 * s.i3);
            let nutation = s.rates[THETA];
            let potential = effective_potential(s);
            let formula = 0.5 * s.i1 * nutation * nutation + potential.value;
            (
                reduced,
                formula,
                s.energy().abs() + s.mgl.abs() + potential.value.abs(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 3.5, "{worst} eps"); // measured 3.37
    let (least, _) = disagreement(routes(0.99));
    assert!(least >= FAR, "{least} eps");
    instance("E", STATES[0].energy(), 41.0656157436672, 5e-13);
}

#[test]
fn eq_16_2_gyroscope_effective_potential() {
    // I1 theta'' = -dU_eff/dtheta: the time derivative of the energy equation is eq. (3).
    let routes = |gravity: f64| {
        move |s: &Caught| {
            let slope = effective_potential(&Caught {
                mgl: gravity * s.mgl,
                ..*s
            })
            .first[THETA];
            (
                s.accelerations()[THETA],
                -slope / s.i1,
                s.acceleration_scale(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 3.0, "{worst} eps"); // measured 2.99
    let (least, _) = disagreement(routes(0.99));
    assert!(least >= FAR, "{least} eps");
}

#[test]
fn eq_16_2_gyroscope_dimensionless_energy() {
    // (theta_t')^2/2 + (a/2)((b - cos)/sin)^2 - c(1 - cos) = E'/(L_z^2/I3), t = t' sqrt(I1 I3)/L_z.
    let routes = |half: f64| {
        move |s: &Caught| {
            let (a, b, c, unit) = s.dimensionless();
            let (st, ct) = (sin(s.theta()), cos(s.theta()));
            let rate = s.rates[THETA] * unit;
            let ratio = (b - ct) / st;
            let formula = 0.5 * rate * rate + half * a * ratio * ratio - c * (1.0 - ct);
            let spin = s.momentum(ZETA);
            let share = spin * spin / s.i3;
            let reduced = s.energy() - s.mgl - 0.5 * share;
            let scale = (s.energy().abs() + s.mgl.abs()) / share;
            (reduced / share, formula, scale)
        }
    };
    let (_, worst) = disagreement(routes(0.5));
    assert!(worst <= 3.5, "{worst} eps"); // measured 3.44
    let (least, _) = disagreement(routes(0.51));
    assert!(least >= FAR, "{least} eps");
    let (a, b, c, unit) = STATES[0].dimensionless();
    instance("a", a, 0.165137614678899, 5e-16);
    instance("b", b, 0.568784897281141, 5e-16);
    instance("c", c, 0.00601011263978853, 5e-18);
    instance("t unit", unit, 0.00817323934414708, 5e-18);
}

/// Right-hand side of eq. (4): d^2 theta/dt'^2.
fn theta_equation_4(a: f64, b: f64, c: f64, theta: f64) -> f64 {
    let (st, ct) = (sin(theta), cos(theta));
    c * st - a / (st * st * st) * (b - ct) * (1.0 - b * ct)
}

#[test]
fn eq_16_2_4_theta_equation() {
    let routes = |factor: f64| {
        move |s: &Caught| {
            let (a, b, c, unit) = s.dimensionless();
            let st = sin(s.theta());
            let formula = theta_equation_4(a, factor * b, c, s.theta());
            let scale = c.abs() + a * (b.abs() + 1.0) * (b.abs() + 1.0) / (st * st * st);
            (s.accelerations()[THETA] * unit * unit, formula, scale)
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 0.5, "{worst} eps"); // measured 0.186
    let (least, _) = disagreement(routes(1.01));
    assert!(least >= FAR, "{least} eps");
    instance(
        "theta''",
        theta_equation_4(2.0, 1.2, 0.2, 1.0),
        -0.610373896215554,
        5e-16,
    );
}

#[test]
fn eq_16_2_5_precession_rate() {
    let routes = |power: f64| {
        move |s: &Caught| {
            let (a, b, _, unit) = s.dimensionless();
            let st = sin(s.theta());
            let formula = power * a.sqrt() * (b - cos(s.theta())) / (st * st);
            let scale = a.sqrt() * (b.abs() + 1.0) / (st * st);
            (s.rates[PHI] * unit, formula, scale)
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 1.5, "{worst} eps"); // measured 1.16
    let (least, _) = disagreement(routes(1.01));
    assert!(least >= FAR, "{least} eps");
    let s = STATES[0];
    instance(
        "dphi/dt'",
        s.rates[PHI] * s.dimensionless().3,
        0.0163464786882942,
        5e-17,
    );
}

#[test]
fn eq_16_2_6_spin_rate() {
    let routes = |power: f64| {
        move |s: &Caught| {
            let (a, _, _, unit) = s.dimensionless();
            let precession = s.rates[PHI] * unit;
            let formula = 1.0 / a.sqrt() - power * precession * cos(s.theta());
            (
                s.rates[ZETA] * unit,
                formula,
                1.0 / a.sqrt() + precession.abs(),
            )
        }
    };
    let (_, worst) = disagreement(routes(1.0));
    assert!(worst <= 3.5, "{worst} eps"); // measured 3.43
    let (least, _) = disagreement(routes(-1.0));
    assert!(least >= FAR, "{least} eps");
    let s = STATES[0];
    instance(
        "dzeta/dt'",
        s.rates[ZETA] * s.dimensionless().3,
        2.45197180324412,
        5e-15,
    );
}

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
        let (mut least, mut worst, mut ran) = (f64::INFINITY, 0.0_f64, 0);
        for (b, energy, start) in motions {
            let top = ReducedTop::new(2.0, b, 0.2).expect("the notes' parameters");
            let exact = HeavyTop::from_energy(top, energy, start, 0.0, 0.0).expect("a motion");
            let equations = FourToSix {
                a: 2.0,
                b,
                c: 0.2,
                factor,
            };
            let state = [exact.angles(0.0).theta, 0.0, 0.0, 0.0];
            let run = Dop853::new(1e-14)
                .and_then(|method| method.solve(&equations, 0.0, &state, 20.0, &[]))
                .expect("smooth");
            let mut of_this_motion = 0.0_f64;
            for k in 1..=80 {
                let t = 0.25 * f64::from(k);
                let [theta, nutation, phi, zeta] = run.at(t).expect("within the run");
                let angles = exact.angles(t);
                of_this_motion = of_this_motion
                    .max((theta - angles.theta).abs())
                    .max((nutation - exact.theta_rate(t)).abs())
                    .max((phi - angles.phi).abs())
                    .max((zeta - angles.zeta).abs());
                ran += 1;
            }
            least = least.min(of_this_motion);
            worst = worst.max(of_this_motion);
        }
        assert_eq!(ran, 4 * 80);
        (least, worst)
    };
    let (_, worst) = apart(1.0);
    assert!(worst <= 1.2e-13, "{worst}"); // measured 1.1e-13
    let (least, _) = apart(1.0 + 1e-6);
    assert!(least >= 1e-7, "{least}");
}

#[test]
fn eq_16_2_steady_precession() {
    // At the bottom of the valley: u p^2 - sqrt(a) p + c = 0 for p = dphi/dt'.
    let mut ran = 0;
    for (a, b, c) in [
        (2.0, 1.2, 0.2),
        (2.0, 0.6, 0.2),
        (0.165, 0.57, 0.006),
        (1.25, 0.6, -0.3),
    ] {
        let top = ReducedTop::new(a, b, c).expect("a top");
        let (theta, _) = top.minimum();
        let u = cos(theta);
        let precession = HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)
            .expect("steady")
            .phi_rate(0.0);
        let residual = |sign: f64| u * precession * precession - a.sqrt() * precession + sign * c;
        let scale = a.sqrt() * (1.0 + b.abs()) / (1.0 - u * u);
        assert!(
            residual(1.0).abs() <= 8.0 * EPS * scale,
            "a = {a}: {}",
            residual(1.0) / (EPS * scale)
        );
        assert!(residual(-1.0).abs() >= 1e10 * EPS * scale);
        ran += 1;
    }
    assert_eq!(ran, 4);
}

#[test]
fn eq_16_2_cusps_of_a_thin_disc() {
    // Released at rest with a = 2: sin^2(theta) sin^2(zeta) = (b - cos(theta))/c, so zeta
    // gains exactly half a turn from cusp to cusp. Not so for a = 1.9.
    let worst = |a: f64| {
        let (mut worst, mut ran) = (0.0_f64, 0);
        for (b, c) in [(0.6, 0.2), (0.0, 0.5), (-0.5, 0.3), (0.9, 0.1)] {
            let top = ReducedTop::new(a, b, c).expect("a top");
            let energy = top.cusp_energy().expect("|b| < 1");
            let exact =
                HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0).expect("cusps");
            worst = worst.max((exact.spin_per_period() - core::f64::consts::PI).abs());
            for k in 1..20 {
                let angles = exact.angles(0.37 * f64::from(k));
                let height = sin(angles.theta) * sin(angles.zeta);
                worst = worst.max((c * height * height - (b - cos(angles.theta))).abs());
                ran += 1;
            }
        }
        assert_eq!(ran, 4 * 19);
        worst
    };
    assert!(worst(2.0) <= 1e-15, "{}", worst(2.0)); // measured 4e-16
    assert!(worst(1.9) >= 1e-2);
}

#[test]
fn eq_16_2_sleeping_top_threshold() {
    // With b = 1 the barrier is (a/2) tan^2(theta/2): U'' at the pole is a/4 - c.
    // Stable while a/4 > c, that is I3 w3 > 2 sqrt(I1 m g l).
    for (a, critical) in [(2.0, 0.5), (0.2, 0.05), (1.0, 0.25)] {
        let curvature = |c: f64| {
            let half = tan(0.5e-3);
            let potential = 0.5 * a * half * half - c * (1.0 - cos(1e-3));
            2.0 * potential / 1e-6
        };
        // The next term of the series is 1e-6 (a/24 + c/12), below 1e-6.
        for c in [0.9 * critical, critical, 1.1 * critical] {
            assert!(
                (curvature(c) - (a / 4.0 - c)).abs() < 1e-6,
                "a = {a}, c = {c}"
            );
        }
        assert!(curvature(0.9 * critical) > 0.0 && curvature(1.1 * critical) < 0.0);
        // Damaged: a threshold of a/2 is far off.
        assert!((curvature(critical) - (a / 2.0 - critical)).abs() > 0.04);
    }
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
