//! The elliptic integral of the first kind to the last digit of double-double arithmetic, for tests.
//!
//! Sources: B. C. Carlson, Numer. Algorithms 10, 13 (1995); DLMF 19.25, 19.36.

use crate::math::DoubleDouble as Dd;

/// Carlson's R_F(x, y, z), at most one argument zero.
pub(crate) fn carlson_rf(x: Dd, y: Dd, z: Dd) -> Dd {
    let (mut x, mut y, mut z) = (x, y, z);
    let mut mean = (x + y + z) / 3.0;
    // The deviations fall by 4 a step; the series to their seventh power leaves 1e-33.
    let spread = |mean: Dd, x: Dd, y: Dd, z: Dd| {
        let far = |v: Dd| (mean - v).abs().to_f64();
        far(x).max(far(y)).max(far(z)) / mean.to_f64()
    };
    while spread(mean, x, y, z) > 5e-5 {
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * ry + ry * rz + rz * rx;
        x = (x + shift).scaled(0.25);
        y = (y + shift).scaled(0.25);
        z = (z + shift).scaled(0.25);
        mean = (mean + shift).scaled(0.25);
    }
    let (dx, dy) = ((mean - x) / mean, (mean - y) / mean);
    let dz = -(dx + dy);
    let e2 = dx * dy - dz.square();
    let e3 = dx * dy * dz;
    let series = Dd::ONE - e2 / 10.0 + e3 / 14.0 + e2.square() / 24.0
        - e2 * e3 * 3.0 / 44.0
        - e2.square() * e2 * 5.0 / 208.0
        + e3.square() * 3.0 / 104.0
        + e2.square() * e3 / 16.0;
    series / mean.sqrt()
}
