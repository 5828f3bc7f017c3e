//! The methods by name: the kind, invariants and origin of each.
//!
//! This is the one list. `solve` takes its methods from it, pages and figures name and colour
//! methods by it. How a method is run on a scene is in [`crate::accuracy`].

use super::splitting::Scheme;

/// A method of integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Method {
    /// Euler's method on the Euler angles and their rates: a foil.
    EulerOnAngles,
    /// The semi-implicit Euler step of game engines: a foil.
    SemiImplicitEuler,
    /// The classical Runge-Kutta method.
    Rk4,
    /// Runge-Kutta on rotations.
    MuntheKaas4,
    /// The splitting of order 2.
    Strang,
    /// A splitting of order 4.
    Srkn6,
    /// A splitting of order 6.
    Srkn14,
    /// A splitting of order 8.
    KahanLi17,
    /// A splitting for weak kicks.
    Aba82,
    /// A splitting for weak kicks.
    Aba104,
    /// A splitting for weak kicks.
    Aba1064,
    /// The pair of orders 8, 5 and 3 by Dormand and Prince.
    Dop853,
    /// The Gauss-Legendre method with eight stages.
    GaussLegendre16,
}

/// The description of a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About {
    /// For the keys of claims, files and colours: `[a-z0-9]+`.
    pub key: &'static str,
    /// The name the literature uses, short enough for a table.
    pub name: &'static str,
    /// The idea, in a line.
    pub idea: &'static str,
    /// The error at a fixed time shrinks as this power of the step.
    pub order: u32,
    /// The quantities it keeps to round-off, and how it treats the energy.
    pub conserved: &'static str,
    /// Paper or book, with the place in it.
    pub source: &'static str,
}

use Method::{
    Aba82, Aba104, Aba1064, Dop853, EulerOnAngles, GaussLegendre16, KahanLi17, MuntheKaas4, Rk4,
    SemiImplicitEuler, Srkn6, Srkn14, Strang,
};

impl Method {
    /// All of them, from the simplest to the most accurate.
    pub const ALL: [Self; 13] = [
        EulerOnAngles,
        SemiImplicitEuler,
        Rk4,
        MuntheKaas4,
        Strang,
        Srkn6,
        Srkn14,
        KahanLi17,
        Aba82,
        Aba104,
        Aba1064,
        Dop853,
        GaussLegendre16,
    ];

    /// The coefficients, if it is a splitting.
    pub const fn scheme(self) -> Option<Scheme> {
        Some(match self {
            Strang => Scheme::STRANG,
            Srkn6 => Scheme::SRKN6,
            Srkn14 => Scheme::SRKN14,
            KahanLi17 => Scheme::KAHAN_LI17,
            Aba82 => Scheme::ABA82,
            Aba104 => Scheme::ABA104,
            Aba1064 => Scheme::ABA1064,
            _ => return None,
        })
    }

    /// The name the literature uses.
    pub const fn name(self) -> &'static str {
        self.about().name
    }

    /// For the keys of claims, files and colours.
    pub const fn key(self) -> &'static str {
        self.about().key
    }

    /// The error at a fixed time shrinks as this power of the step.
    pub const fn order(self) -> u32 {
        self.about().order
    }

    /// Its kind.
    pub const fn about(self) -> About {
        match self {
            EulerOnAngles => About {
                key: "euler",
                name: "Euler on angles",
                idea: "add rate times step to each Euler angle",
                order: 1,
                conserved: "-",
                source: "L. Euler, Institutionum calculi integralis I, ch. 7 (1768)",
            },
            SemiImplicitEuler => About {
                key: "semi",
                name: "semi-implicit Euler",
                idea: "the rates first, then the attitude with the new rates",
                order: 1,
                conserved: "-",
                source: "the stepping of rigid bodies in game engines",
            },
            Rk4 => About {
                key: "rk4",
                name: "RK4",
                idea: "four slopes a step, averaged",
                order: 4,
                conserved: "L_Z; loses energy",
                source: "W. Kutta, Z. Math. Phys. 46, 435 (1901)",
            },
            MuntheKaas4 => About {
                key: "mk4",
                name: "Munthe-Kaas 4",
                idea: "RK4 for the turn of a step, which is then applied to the attitude",
                order: 4,
                conserved: "L_Z; loses energy",
                source: "H. Munthe-Kaas, Appl. Numer. Math. 29, 115 (1999)",
            },
            Strang => split(
                "strang",
                "half a free rotation, a kick by the torque, half a free rotation",
                Scheme::STRANG,
            ),
            Srkn6 => split(
                "srkn6",
                "six kicks a step, their errors cancelling to order 4",
                Scheme::SRKN6,
            ),
            Srkn14 => split(
                "srkn14",
                "fourteen kicks a step, their errors cancelling to order 6",
                Scheme::SRKN14,
            ),
            KahanLi17 => {
                split("kl17", "seventeen Strang steps of chosen lengths in one", Scheme::KAHAN_LI17)
            }
            Aba82 => split(
                "aba82",
                "four kicks a step; errors linear in the torque cancel to order 8",
                Scheme::ABA82,
            ),
            Aba104 => split(
                "aba104",
                "seven kicks a step; errors linear in the torque cancel to order 10",
                Scheme::ABA104,
            ),
            Aba1064 => split(
                "aba1064",
                "eight kicks a step; as ABA(10,4), quadratic errors to order 6",
                Scheme::ABA1064,
            ),
            Dop853 => About {
                key: "dop853",
                name: "DOP853",
                idea: "twelve slopes a step; two inner estimates of the error choose the step",
                order: 8,
                conserved: "L_Z; loses energy",
                source: "E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.5",
            },
            GaussLegendre16 => About {
                key: "gauss",
                name: "Gauss-Legendre 16",
                idea: "eight slopes a step that depend on each other, found by sweeps",
                order: 16,
                conserved: "L_Z and what is quadratic: energy, |L| of a free body",
                source: "J. C. Butcher, Math. Comp. 18, 50 (1964)",
            },
        }
    }
}

const fn split(key: &'static str, idea: &'static str, scheme: Scheme) -> About {
    About {
        key,
        name: scheme.name,
        idea,
        order: scheme.order,
        conserved: "L_Z, L_z; energy swings, does not drift",
        source: scheme.source,
    }
}
