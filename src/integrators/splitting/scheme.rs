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
/// Those by Blanes and Moan need an energy of motion quadratic in the momentum and a kick that
/// depends on the position only (Runge-Kutta-Nyström), as a body in a potential has them. The
/// others have their order for any flow and kick.
///
/// The methods (10, 6, 4), (10, 4) and (8, 2) are for weak kicks. With a torque of relative size e
/// the error of the first is of the size e h^10 + e^2 h^6 + e^3 h^4. Their order is the last
/// number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheme {
    /// The name the literature uses.
    pub name: &'static str,
    /// The error at a fixed time shrinks as this power of the step.
    pub order: u32,
    /// Paper, with the table in it.
    pub source: &'static str,
    /// The first and last part of a step.
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
        const B: [f64; 3] =
            [0.082_984_406_417_405_2, 0.396_309_801_498_368, -0.039_056_304_922_348_6];
        const B4: f64 = 1.0 - 2.0 * (B[0] + B[1] + B[2]);
        const A: [f64; 2] = [0.245_298_957_184_271, 0.604_872_665_711_080];
        const A3: f64 = 0.5 - (A[0] + A[1]);
        Self {
            name: "SRKN 6b",
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
            name: "SRKN 14a",
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

    /// Order 8, seventeen kicks a step.
    pub const KAHAN_LI17: Self = {
        const G: [f64; 8] = [
            0.127_136_927_734_878_58,
            0.561_702_537_988_802_7,
            -0.382_534_719_948_830_2,
            0.160_076_056_294_647_43,
            -0.401_816_374_326_806_97,
            0.187_366_716_542_278_5,
            0.260_708_709_207_792_4,
            0.290_397_388_125_161_6,
        ];
        const G9: f64 = 1.0 - 2.0 * (G[0] + G[1] + G[2] + G[3] + G[4] + G[5] + G[6] + G[7]);
        const GAMMA: [f64; 17] = [
            G[0], G[1], G[2], G[3], G[4], G[5], G[6], G[7], G9, G[7], G[6], G[5], G[4], G[3], G[2],
            G[1], G[0],
        ];
        // Strang's steps of these lengths; the half flows between two are one.
        const FLOWS: [f64; 18] = {
            let mut flows = [0.5 * GAMMA[0]; 18];
            let mut i = 1;
            while i < 17 {
                flows[i] = 0.5 * (GAMMA[i - 1] + GAMMA[i]);
                i += 1;
            }
            flows
        };
        Self {
            name: "Kahan-Li 17b",
            order: 8,
            source: "W. Kahan, R.-C. Li, Math. Comput. 66, 1089 (1997), s17odr8b",
            outer: Outer::Flow,
            outer_parts: &FLOWS,
            inner_parts: &GAMMA,
        }
    };

    /// For weak kicks, orders (8, 2), four kicks a step: Gauss's quadrature.
    pub const ABA82: Self = {
        const A: [f64; 2] = [0.069_431_844_202_973_71, 0.260_577_634_004_598_16];
        const A3: f64 = 1.0 - 2.0 * (A[0] + A[1]);
        const B: f64 = 0.173_927_422_568_726_93;
        Self {
            name: "ABA(8,2)",
            order: 2,
            source: "R. I. McLachlan, BIT 35, 258 (1995); \
                     J. Laskar, P. Robutel, Celest. Mech. 80, 39 (2001), SABA4",
            outer: Outer::Flow,
            outer_parts: &[A[0], A[1], A3, A[1], A[0]],
            inner_parts: &[B, 0.5 - B, 0.5 - B, B],
        }
    };

    /// For weak kicks, orders (10, 4), seven kicks a step.
    pub const ABA104: Self = {
        const A: [f64; 3] =
            [0.047_067_100_645_972_506, 0.184_756_935_417_088_1, 0.282_706_005_679_836_2];
        const A4: f64 = 0.5 - (A[0] + A[1] + A[2]);
        const B: [f64; 3] =
            [0.118_881_917_368_197_02, 0.241_050_460_551_501_57, -0.273_286_666_705_323_8];
        const B4: f64 = 1.0 - 2.0 * (B[0] + B[1] + B[2]);
        Self {
            name: "ABA(10,4)",
            order: 4,
            source: "S. Blanes, F. Casas, A. Farrés, J. Laskar, J. Makazaga, A. Murua, \
                     Appl. Numer. Math. 68, 58 (2013)",
            outer: Outer::Flow,
            outer_parts: &[A[0], A[1], A[2], A4, A4, A[2], A[1], A[0]],
            inner_parts: &[B[0], B[1], B[2], B4, B[2], B[1], B[0]],
        }
    };

    /// For weak kicks, orders (10, 6, 4), eight kicks a step.
    pub const ABA1064: Self = {
        const A: [f64; 4] = [
            0.038_094_497_422_412_195,
            0.145_298_716_116_913_75,
            0.207_627_695_725_541_25,
            0.435_909_703_651_526_16,
        ];
        const A5: f64 = 1.0 - 2.0 * (A[0] + A[1] + A[2] + A[3]);
        const B: [f64; 3] =
            [0.095_858_880_837_075_21, 0.204_446_153_142_998_78, 0.217_070_347_978_991_1];
        const B4: f64 = 0.5 - (B[0] + B[1] + B[2]);
        Self {
            name: "ABA(10,6,4)",
            order: 4,
            source: "S. Blanes, F. Casas, A. Farrés, J. Laskar, J. Makazaga, A. Murua, \
                     Appl. Numer. Math. 68, 58 (2013)",
            outer: Outer::Flow,
            outer_parts: &[A[0], A[1], A[2], A[3], A5, A[3], A[2], A[1], A[0]],
            inner_parts: &[B[0], B[1], B[2], B4, B4, B[2], B[1], B[0]],
        }
    };

    /// Kicks in a step, an outer kick shared by two steps counted once.
    pub const fn kicks(&self) -> u64 {
        // Either kind has as many as there are inner operations.
        self.inner_parts.len() as u64
    }
}
