//! Symmetric compositions of flow and kick: coefficients as data.

/// Which of the two a step begins and ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outer {
    /// flow, kick, flow, ..., flow.
    Flow,
    /// kick, flow, kick, ..., kick.
    Kick,
}

/// A symmetric splitting: a step is flows and kicks in turn, each over a
/// fraction of the step, the same read backwards.
///
/// Strang's has its order for any flow and kick. Those by Blanes and Moan need an
/// energy of motion quadratic in the momentum and a kick that depends on the
/// position only (Runge-Kutta-Nyström), as a body in a potential has them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheme {
    /// The name the literature uses.
    pub name: &'static str,
    /// The error at a fixed time shrinks as this power of the step.
    pub order: u32,
    /// Paper, with the table in it.
    pub source: &'static str,
    /// What a step begins and ends with.
    pub outer: Outer,
    /// Fractions of the step for the outer operation, one more than the inner ones.
    pub outer_parts: &'static [f64],
    /// Fractions of the step for the inner operation.
    pub inner_parts: &'static [f64],
}

impl Scheme {
    /// Order 2, one kick a step: half a flow, a kick, half a flow.
    pub const STRANG: Self = Self {
        name: "Strang",
        order: 2,
        source: "G. Strang, SIAM J. Numer. Anal. 5, 506 (1968)",
        outer: Outer::Flow,
        outer_parts: &[0.5, 0.5],
        inner_parts: &[1.0],
    };

    /// Order 4, six kicks a step.
    pub const SRKN6: Self = {
        const B: [f64; 3] = [
            0.082_984_406_417_405_2,
            0.396_309_801_498_368,
            -0.039_056_304_922_348_6,
        ];
        const B4: f64 = 1.0 - 2.0 * (B[0] + B[1] + B[2]);
        const A: [f64; 2] = [0.245_298_957_184_271, 0.604_872_665_711_080];
        const A3: f64 = 0.5 - (A[0] + A[1]);
        Self {
            name: "Blanes-Moan SRKN 6b",
            order: 4,
            source: "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142, 313 (2002), table 3",
            outer: Outer::Kick,
            outer_parts: &[B[0], B[1], B[2], B4, B[2], B[1], B[0]],
            inner_parts: &[A[0], A[1], A3, A3, A[1], A[0]],
        }
    };

    /// Order 6, fourteen kicks a step.
    pub const SRKN14: Self = {
        const A: [f64; 7] = [
            0.037_859_319_840_611_6,
            0.102_635_633_102_435,
            -0.025_867_888_266_558_7,
            0.314_241_403_071_447,
            -0.130_144_459_517_415,
            0.106_417_700_369_543,
            -0.008_794_243_128_510_58,
        ];
        const A8: f64 = 1.0 - 2.0 * (A[0] + A[1] + A[2] + A[3] + A[4] + A[5] + A[6]);
        const B: [f64; 6] = [
            0.091_719_152_624_461_65,
            0.183_983_170_005_006,
            -0.056_534_365_832_888_27,
            0.004_914_688_774_712_854,
            0.143_761_127_168_358,
            0.328_567_693_746_804,
        ];
        const B7: f64 = 0.5 - (B[0] + B[1] + B[2] + B[3] + B[4] + B[5]);
        Self {
            name: "Blanes-Moan SRKN 14a",
            order: 6,
            source: "S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142, 313 (2002), table 3",
            outer: Outer::Flow,
            outer_parts: &[
                A[0], A[1], A[2], A[3], A[4], A[5], A[6], A8, A[6], A[5], A[4], A[3], A[2], A[1],
                A[0],
            ],
            inner_parts: &[
                B[0], B[1], B[2], B[3], B[4], B[5], B7, B7, B[5], B[4], B[3], B[2], B[1], B[0],
            ],
        }
    };

    /// Kicks in a step, an outer kick shared by two steps counted once.
    pub const fn kicks(&self) -> u64 {
        // Either kind has as many as there are inner operations.
        self.inner_parts.len() as u64
    }
}
