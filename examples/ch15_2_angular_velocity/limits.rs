//! Limits where the answer is known.

use super::{
    EulerAngles, FRAC_PI_2, Gyroscope, Parameters, Report, Result, SpaceVector, UP, body,
    from_two_points, gap, rates, seen_from, velocity,
};
use kit::{Table, short};

/// Tests the formulas where one knows what must come out.
pub fn add(p: &Parameters, report: &mut Report) -> Result<()> {
    let g = Gyroscope::of(p, 1.0);
    let at = |theta| Gyroscope { angles: EulerAngles { theta, ..g.angles }, ..g };
    let (upright, level) = (at(1e-9), at(FRAC_PI_2));
    let omega = SpaceVector::new(0.4, -0.3, 2.0);
    let [r, s] = [SpaceVector::new(0.1, 0.2, 0.3), SpaceVector::new(0.7, -0.2, 0.5)];
    let found = from_two_points(velocity(omega, r), velocity(omega, s), s);
    let sum = p.precession.abs() + p.nutation.abs() + p.spin.abs();
    let near = 1e-14 * sum;
    // What a solver of the angles meets at a small tilt, the components being the same.
    let [quick, _, _] = rates(g.nodal(), 1e-9);
    kit::limits! { report,
        /// z lies along Z: precession and spin are one rotation
        "upright, theta = 0: Omega_z": upright.nodal()[2] => p.precession + p.spin, within near;
        /// Z lies along y
        "level, theta = pi/2: Omega_y": level.nodal()[1] => p.precession, within near;
        /// the rate of phi grows as 1/theta, the component stays
        "theta = 1e-9: theta times the rate of phi": 1e-9 * quick => g.nodal()[1], within near;
        /// the plate turns with the frame and seems at rest
        "frame as fast as the body: Omega seen":
            seen_from(1.0, UP)?.norm() => 0.0, within 1e-14;
        /// the second order is what the two orders differ by
        "turns of x = 1e-6: gap / x^2": gap(1e-6) * 1e12 => 1.0, within 1e-12;
        /// Omega is what moves them
        "from two points: Omega off by": (found - omega).norm() => 0.0,
        within 1e-14;
    }?;
    report.add(variations(p)?)
}

/// What the page asks its reader to try, one flag changed at a time.
fn variations(p: &Parameters) -> Result<Table> {
    let with = |change: fn(&mut Parameters)| {
        let mut changed = p.clone();
        change(&mut changed);
        changed
    };
    let backward = Gyroscope::of(&with(|p| p.spin = -30.0), 1.0).angular_velocity();
    let level = Gyroscope::of(&with(|p| p.theta = FRAC_PI_2), 1.0).nodal();
    let upright = Gyroscope::of(&with(|p| p.theta = 1e-6), 1.0).nodal();
    let against = seen_from(-2.0, body(p)[0])?;
    let mut table = Table::new("variations", ["flag", "key", "value", "unit"])?;
    for (flag, key, value) in [
        ("--spin -30", "size", backward.norm()),
        ("--theta 1.5707963", "omega_z", level[2]),
        ("--theta 1e-6", "omega_z", upright[2]),
        ("--frame -2", "seen_z", against.z()),
    ] {
        table.push([flag, key, &short(value, 6), "rad/s"])?;
    }
    Ok(table)
}
