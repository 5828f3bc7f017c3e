//! Every equation of the notes, each checked by a route that does not use it.
//!
//! For the gyroscope (Chapter 16, Section 2) the other route is the Lagrangian
//! summed over the particles of the body (`lagrangian.rs`), in six
//! states of motion. Each test ends with a damaged twin: the formula with one
//! thing wrong, which must miss by far more than the bound. What follows for
//! whole motions is in `motions.rs`; the corrections of the notes are in `errata.rs`; Euler's equations
//! with a torque, which the notes do not have, in `euler.rs`.

mod errata;
mod euler;
mod lagrangian;
mod motions;

use lagrangian::{Caught, Jet, PHI, STATES, THETA, ZETA, disagreement};
use rotation_dynamics::math::{cos, sin};
use support::{assert_largest, attained};

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
    assert!((value - printed).abs() <= half_of_last_digit, "{name}: {value} is not {printed}");
}

#[test]
fn eq_16_2_gyroscope_angular_velocity() {
    // Components on x (line of nodes), y, z (symmetry axis), against the
    // antisymmetric matrix R^T dR/dt turned from body axes to x, y, z by zeta.
    for (component, printed) in ["0.61", "0.43", "2.0"].into_iter().enumerate() {
        let routes = |sign: f64| {
            move |s: &Caught| {
                let (rotation, rate) = s.rotation();
                let spin = |i: usize, j: usize| -> f64 {
                    (0..3).map(|k| rotation[k][i].value * rate[k][j].value).sum()
                };
                let body = [spin(2, 1), spin(0, 2), spin(1, 0)];
                let (sz, cz) = (sin(s.angles[ZETA]), cos(s.angles[ZETA]));
                let nodal = [body[0] * cz - body[1] * sz, body[0] * sz + body[1] * cz, body[2]];
                let [precession, nutation, turn] = s.rates;
                let (st, ct) = (sin(s.theta()), cos(s.theta()));
                let formula =
                    [sign * nutation, sign * precession * st, turn + sign * precession * ct];
                let [x, y, z] = body.map(f64::abs);
                let scale = x + y + z;
                (nodal[component], formula[component], scale)
            }
        };
        attained(disagreement(routes(1.0)).largest(), printed, "component");
        disagreement(routes(-1.0)).exceed(FAR, 6);
    }
    let s = STATES[0];
    instance("Omega_z", s.rates[ZETA] + s.rates[PHI] * cos(1.0), 301.080604611736, 5e-13);
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
            (s.lagrangian().value, kinetic - potential, kinetic + s.mgl.abs())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"1.92");
    disagreement(routes(1.01)).exceed(FAR, 6);
    instance("L", STATES[0].lagrangian().value, 40.535760182883, 5e-13);
}

#[test]
fn eq_16_2_gyroscope_spin_momentum() {
    // dL/dzeta' = I3 (zeta' + phi' cos theta) = L_z, and nothing drives it.
    let routes = |projection: f64| {
        move |s: &Caught| {
            let formula = s.i3 * (s.rates[ZETA] + projection * s.rates[PHI] * cos(s.theta()));
            (s.momentum(ZETA), formula, s.i3 * (s.rates[ZETA].abs() + s.rates[PHI].abs()))
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"2.49");
    disagreement(routes(0.99)).exceed(FAR, 6);
    assert_largest!(disagreement(|s| (s.lagrangian().first[ZETA], 0.0, s.energy().abs())), 6, @"0");
    instance("L_z", STATES[0].momentum(ZETA), 0.270972544150563, 5e-16);
}

#[test]
fn eq_16_2_gyroscope_vertical_momentum() {
    // dL/dphi' = L_z cos theta + I1 phi' sin^2 theta = L_Z, and nothing drives it.
    let routes = |moment: f64| {
        move |s: &Caught| {
            let (vertical, spin) = s.momenta();
            let across = moment * s.i1 * s.rates[PHI] * sin(s.theta()) * sin(s.theta());
            (vertical, spin * cos(s.theta()) + across, spin.abs() + s.i1 * s.rates[PHI].abs())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"1.02");
    disagreement(routes(1.01)).exceed(FAR, 6);
    assert_largest!(disagreement(|s| (s.lagrangian().first[PHI], 0.0, s.energy().abs())), 6, @"0.530");
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
    assert_largest!(disagreement(routes(1.0)), 6, @"1.08");
    disagreement(routes(1.01)).exceed(FAR, 6);
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
            (s.accelerations()[THETA], formula / s.i1, s.acceleration_scale())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"1.87");
    disagreement(routes(-1.0)).exceed(FAR, 6);
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
    assert_largest!(disagreement(routes(1.0)), 6, @"2.93");
    disagreement(routes(-1.0)).exceed(FAR, 6);
    instance("theta''", theta_equation_3(&STATES[0], 1.0), -6.15030340437294, 5e-13);
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
            (reduced, formula, s.energy().abs() + s.mgl.abs() + potential.value.abs())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"3.36");
    disagreement(routes(0.99)).exceed(FAR, 6);
    instance("E", STATES[0].energy(), 41.0656157436672, 5e-13);
}

#[test]
fn eq_16_2_gyroscope_effective_potential() {
    // I1 theta'' = -dU_eff/dtheta: the time derivative of the energy equation is eq. (3).
    let routes = |gravity: f64| {
        move |s: &Caught| {
            let slope = effective_potential(&Caught { mgl: gravity * s.mgl, ..*s }).first[THETA];
            (s.accelerations()[THETA], -slope / s.i1, s.acceleration_scale())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"2.99");
    disagreement(routes(0.99)).exceed(FAR, 6);
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
    assert_largest!(disagreement(routes(0.5)), 6, @"3.43");
    disagreement(routes(0.51)).exceed(FAR, 6);
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
    assert_largest!(disagreement(routes(1.0)), 6, @"0.185");
    disagreement(routes(1.01)).exceed(FAR, 6);
    instance("theta''", theta_equation_4(2.0, 1.2, 0.2, 1.0), -0.610373896215554, 5e-16);
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
    assert_largest!(disagreement(routes(1.0)), 6, @"1.15");
    disagreement(routes(1.01)).exceed(FAR, 6);
    let s = STATES[0];
    instance("dphi/dt'", s.rates[PHI] * s.dimensionless().3, 0.0163464786882942, 5e-17);
}

#[test]
fn eq_16_2_6_spin_rate() {
    let routes = |power: f64| {
        move |s: &Caught| {
            let (a, _, _, unit) = s.dimensionless();
            let precession = s.rates[PHI] * unit;
            let formula = 1.0 / a.sqrt() - power * precession * cos(s.theta());
            (s.rates[ZETA] * unit, formula, 1.0 / a.sqrt() + precession.abs())
        }
    };
    assert_largest!(disagreement(routes(1.0)), 6, @"3.42");
    disagreement(routes(-1.0)).exceed(FAR, 6);
    let s = STATES[0];
    instance("dzeta/dt'", s.rates[ZETA] * s.dimensionless().3, 2.45197180324412, 5e-15);
}
