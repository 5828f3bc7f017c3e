//! How rigid is a steel rod: hung up, spun, warmed, and pushed at one end.

use super::*;

/// The end of a rod of length 1 that is held at 0 and pulled lengthwise, per piece by
/// `strain * pull`: how far it moves, over the strain. The piece at s goes to
/// x = s + strain u with u'' = -pull(x), and no tension is left at the free end.
pub fn stretched(strain: f64, pull: fn(f64) -> f64) -> Result<(f64, Work)> {
    let rod =
        ode(|s, [u, slope]: &[f64; 2]| [*slope, -pull(s + strain * u)]).scaled(size_or([1.0; 2]));
    let pulled = |slope| Dop853::new(1e-14)?.advance(&rod, 0.0, &[0.0, slope], 1.0);
    // Of two guesses: the slope at the free end is linear in that at the held one.
    let (([a, left], once), ([b, more], again)) = (pulled(0.0)?, pulled(1.0)?);
    Ok((a + (b - a) * left / (left - more), once + again))
}

/// A rod as `N/2` masses on springs, one end of which is pushed off with the speed 1: by how much
/// it is shortened at most before it catches up. Lengths in that of the rod, and the time in
/// which a push goes through it as the unit.
pub fn pushed<const N: usize>() -> Result<(f64, Work)> {
    let masses = N / 2;
    let stiffness = (masses * masses) as f64;
    let chain = ode(|_, y: &[f64; N]| {
        let mut slope = [0.0; N];
        for i in 0..masses {
            // Seen from the pushed end, which rests. The last mass stands for half a piece, and
            // beyond it there is no spring: as if its neighbour were on both sides.
            let before = if i > 0 { y[i - 1] } else { 0.0 };
            let after = if i + 1 < masses { y[i + 1] } else { before };
            slope[i] = y[masses + i];
            slope[masses + i] = stiffness * (before - 2.0 * y[i] + after);
        }
        slope
    })
    .scaled(size_or([1.0; N]));
    let mut start = [0.0; N];
    start[masses..].fill(-1.0);
    let (most, work) = Dop853::new(1e-10)?.zero(&chain, start, 1, 2.0, |y| y[N - 1])?;
    Ok((-most.state[masses - 1], work))
}

/// The card of effects, for a rod as long as the two points are apart.
pub fn effects(_: &Parameters, report: &mut Report) -> Result<()> {
    let (density, modulus, expansion, length) = (7850.0, 2.0e11_f64, 1.2e-5, 0.656);
    let weight = density * 9.81 * length / modulus;
    let spin = density * (100.0 * length) * (100.0 * length) / modulus;
    let warm = expansion * 10.0;
    // A push arrives with the speed of sound; meanwhile the near end moves at 1 m/s.
    let late = 1.0 / (modulus / density).sqrt();
    // The spun rod is held in its middle: two halves, each half as long.
    let (hung, plumb) = stretched(weight, |_| 1.0)?;
    let (spun, turned) = stretched(0.25 * spin, |x| x)?;
    let (short, pushed) = pushed::<64>()?;
    let counted = |work: Work| format!("none, {} derivatives", work.derivatives);
    effect_card! { report,
        "stretch by its own weight, hung up": "rho g l/E" = weight, costs 0.5 * weight * length, "m of the distance",
            measured hung * weight * length, at_cost counted(plumb);
        "stretch by spinning at 100 rad/s": "rho omega^2 l^2/E" = spin, costs spin * length / 12.0, "m of the distance, to first order",
            measured spun * 0.25 * spin * length, at_cost counted(turned);
        "warmer by ten kelvin": "alpha T" = warm, costs warm * length, "m of the distance";
        "a push at a metre a second arrives late": "v/c" = late, costs late * length, "m of the distance, for a moment",
            measured short * late * length, at_cost counted(pushed);
    }
}
