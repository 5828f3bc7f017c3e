//! The heavy top from its particles: a route to every equation of motion that
//! shares no formula with the notes.
//!
//! Kinetic energy is the sum of m v^2 / 2 over the particles of the body,
//! v = d(R r)/dt, and R = Rz(phi) Rx(theta) Rz(zeta) is differentiated entry
//! by entry. No angular velocity, no moment of inertia formula and no momentum
//! is put in. Derivatives of the Lagrangian are taken by carrying values,
//! gradients and Hessians through the arithmetic ([`Jet`]), exact to round-off.

use core::ops::{Add, Mul, Sub};
use rotation_dynamics::math::{EPS, cos, sin};
use support::{Errors, relative};

/// Index of each variable in a gradient: the angles, then their rates.
pub const PHI: usize = 0;
pub const THETA: usize = 1;
pub const ZETA: usize = 2;
/// Rates follow the angles: the rate of angle `k` is variable `k + RATE`.
pub const RATE: usize = 3;

/// A value with its first and second derivatives with respect to six variables.
#[derive(Clone, Copy)]
pub struct Jet {
    pub value: f64,
    pub first: [f64; 6],
    pub second: [[f64; 6]; 6],
}

impl Jet {
    pub fn constant(value: f64) -> Self {
        Self { value, first: [0.0; 6], second: [[0.0; 6]; 6] }
    }

    pub fn variable(index: usize, value: f64) -> Self {
        let mut jet = Self::constant(value);
        jet.first[index] = 1.0;
        jet
    }

    /// f(self), given f, f' and f'' at the value.
    fn compose(self, f: f64, df: f64, ddf: f64) -> Self {
        let mut jet = Self::constant(f);
        for i in 0..6 {
            jet.first[i] = df * self.first[i];
            for j in 0..6 {
                jet.second[i][j] = df * self.second[i][j] + ddf * self.first[i] * self.first[j];
            }
        }
        jet
    }

    pub fn sin(self) -> Self {
        let (s, c) = (sin(self.value), cos(self.value));
        self.compose(s, c, -s)
    }

    pub fn cos(self) -> Self {
        let (s, c) = (sin(self.value), cos(self.value));
        self.compose(c, -s, -c)
    }

    pub fn reciprocal(self) -> Self {
        let r = 1.0 / self.value;
        self.compose(r, -r * r, 2.0 * r * r * r)
    }
}

impl Add for Jet {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let mut jet = self;
        jet.value += other.value;
        for i in 0..6 {
            jet.first[i] += other.first[i];
            for j in 0..6 {
                jet.second[i][j] += other.second[i][j];
            }
        }
        jet
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl Mul<f64> for Jet {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.compose(self.value * factor, factor, 0.0)
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut jet = Self::constant(self.value * other.value);
        for i in 0..6 {
            jet.first[i] = self.first[i] * other.value + self.value * other.first[i];
            for j in 0..6 {
                jet.second[i][j] = self.second[i][j] * other.value
                    + self.first[i] * other.first[j]
                    + self.first[j] * other.first[i]
                    + self.value * other.second[i][j];
            }
        }
        jet
    }
}

pub type Matrix = [[Jet; 3]; 3];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j])
    })
}

/// Turn about the third axis, and its derivative with respect to the angle.
fn turn_z(angle: Jet) -> (Matrix, Matrix) {
    let (s, c, o, l) = (angle.sin(), angle.cos(), Jet::constant(0.0), Jet::constant(1.0));
    let m = s * -1.0;
    let n = c * -1.0;
    ([[c, m, o], [s, c, o], [o, o, l]], [[m, n, o], [c, m, o], [o, o, o]])
}

/// Turn about the first axis, and its derivative with respect to the angle.
fn turn_x(angle: Jet) -> (Matrix, Matrix) {
    let (s, c, o, l) = (angle.sin(), angle.cos(), Jet::constant(0.0), Jet::constant(1.0));
    let m = s * -1.0;
    let n = c * -1.0;
    ([[l, o, o], [o, c, m], [o, s, c]], [[o, o, o], [o, m, n], [o, c, m]])
}

/// A heavy symmetric body with a fixed point, caught in one state of motion.
#[derive(Clone, Copy)]
pub struct Caught {
    /// Moments about the fixed point: across and along the symmetry axis, kg m^2.
    pub i1: f64,
    pub i3: f64,
    /// m g l: weight times distance of the centre of mass from the fixed point, N m.
    pub mgl: f64,
    /// phi, theta, zeta, rad.
    pub angles: [f64; 3],
    /// Their rates, rad/s.
    pub rates: [f64; 3],
}

impl Caught {
    /// Kinetic minus potential energy, with derivatives.
    pub fn lagrangian(&self) -> Jet {
        let (kinetic, potential) = self.energies();
        kinetic - potential
    }

    /// Kinetic plus potential energy, J.
    pub fn energy(&self) -> f64 {
        let (kinetic, potential) = self.energies();
        kinetic.value + potential.value
    }

    /// The rotation matrix R, body to space, and its rate of change.
    pub fn rotation(&self) -> (Matrix, Matrix) {
        let q: [Jet; 3] = core::array::from_fn(|k| Jet::variable(k, self.angles[k]));
        let v: [Jet; 3] = core::array::from_fn(|k| Jet::variable(k + RATE, self.rates[k]));
        let (a, da) = turn_z(q[PHI]);
        let (b, db) = turn_x(q[THETA]);
        let (c, dc) = turn_z(q[ZETA]);
        let parts = [
            product(&product(&da, &b), &c),
            product(&product(&a, &db), &c),
            product(&product(&a, &b), &dc),
        ];
        let rate = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                parts[PHI][i][j] * v[PHI]
                    + parts[THETA][i][j] * v[THETA]
                    + parts[ZETA][i][j] * v[ZETA]
            })
        });
        (product(&product(&a, &b), &c), rate)
    }

    fn energies(&self) -> (Jet, Jet) {
        let (rotation, rate) = self.rotation();
        // Sums of m x^2, m y^2, m z^2 over the particles: I1 = sum m (y^2 + z^2), and so on.
        let spread = [self.i3 / 2.0, self.i3 / 2.0, self.i1 - self.i3 / 2.0];
        let mut kinetic = Jet::constant(0.0);
        for row in rate {
            for (velocity, moment) in row.into_iter().zip(spread) {
                kinetic = kinetic + velocity * velocity * (moment / 2.0);
            }
        }
        (kinetic, rotation[2][2] * self.mgl)
    }

    /// The momentum that belongs to an angle: dL / d(rate).
    pub fn momentum(&self, angle: usize) -> f64 {
        self.lagrangian().first[angle + RATE]
    }

    /// The second time derivatives of the angles, from Lagrange's equations.
    pub fn accelerations(&self) -> [f64; 3] {
        let l = self.lagrangian();
        let mass: [[f64; 3]; 3] =
            core::array::from_fn(|i| core::array::from_fn(|j| l.second[i + RATE][j + RATE]));
        let force: [f64; 3] = core::array::from_fn(|i| {
            let drift: f64 = (0..3).map(|j| l.second[i + RATE][j] * self.rates[j]).sum();
            l.first[i] - drift
        });
        let whole = determinant(&mass);
        core::array::from_fn(|k| {
            let mut replaced = mass;
            for i in 0..3 {
                replaced[i][k] = force[i];
            }
            determinant(&replaced) / whole
        })
    }
}

fn determinant(m: &[[f64; 3]; 3]) -> f64 {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

/// The reference instance of the notes' gyroscope first, then states that are
/// slow and fast, near each pole, flat and slender, standing and hanging.
pub const STATES: [Caught; 6] = [
    Caught {
        i1: 5.45e-3,
        i3: 9e-4,
        mgl: 0.5 * 9.80665 * 0.1,
        angles: [0.0, 1.0, 0.0],
        rates: [2.0, 0.5, 300.0],
    },
    Caught {
        i1: 2e-4,
        i3: 4e-5,
        mgl: 0.1 * 9.80665 * 0.04,
        angles: [0.5, 0.4, 0.2],
        rates: [7.0, -0.3, 150.0],
    },
    Caught {
        i1: 0.1539,
        i3: 0.2178,
        mgl: 2.0 * 9.80665 * 0.15,
        angles: [-1.0, 1.55, 4.0],
        rates: [0.675, 0.1, 20.0],
    },
    Caught { i1: 1.0, i3: 1.9, mgl: 0.7, angles: [2.0, 0.15, -3.0], rates: [-0.4, 1.1, 1.3] },
    Caught { i1: 1.0, i3: 0.05, mgl: 3.0, angles: [0.3, 2.9, 1.0], rates: [1.7, 0.2, -6.0] },
    Caught { i1: 0.8, i3: 1.0, mgl: -0.24, angles: [6.0, 1.2, 0.4], rates: [0.9, -0.7, 1.6] },
];

/// How far two routes disagree in each of the [`STATES`], in units of eps times a
/// scale. A state gives (one route, the other route, scale).
pub fn disagreement(routes: impl Fn(&Caught) -> (f64, f64, f64)) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "two routes");
    for (i, state) in STATES.iter().enumerate() {
        let (one, other, scale) = routes(state);
        errors.push_at(relative(one, other, scale), format!("state {i}"));
    }
    errors
}
