//! What moves the attitude of 2008: what is not known, and what is left out.

use super::*;
use kit::{short, supported_digits};
use tide::{ORBIT, under_the_sun};

/// The Earth at the closest in six directions, at each of four moments of the tumbling.
pub fn phases(path: Path) -> impl Iterator<Item = Path> {
    // Half a turn further it is the same: a tide has two sides.
    (0..24).map(move |i| {
        let angles = [0.0, 0.0, PI * f64::from(i % 6) / 6.0];
        let when = path.when + f64::from(i / 6) * 2.0 * DAY;
        Path { angles, when, ..path }
    })
}

/// By how much something moves the attitude of 2008, its azimuth about L and its angle about
/// the long axis, degrees.
type Shift = [f64; 3];

fn shift(start: &Start, t: f64, there: &Attitude) -> Result<Shift> {
    let motion = start.motion()?;
    let off = off_about(&motion.attitude(t), there, motion.angular_momentum())?;
    Ok(off.map(f64::abs))
}

/// The root of the sum of squares over the published numbers, each half of its last printed digit
/// higher.
pub fn rounding(p: &Parameters, start: &Start, t: f64) -> Result<Shift> {
    let mut squares = [0.0; 3];
    for (i, half) in [5e-4, 5e-4, 5e-4, 5e-3, 5e-4, 5e-4, 5e-5, 5e-4].into_iter().enumerate() {
        let higher = Start::of(numbers(p).but(|numbers| numbers[i] += half))?;
        let shift = shift(start, t, &higher.motion()?.attitude(t))?;
        squares = [0, 1, 2].map(|k| squares[k] + shift[k] * shift[k]);
    }
    Ok(squares.map(f64::sqrt))
}

/// The largest shifts by the Earth in any phase of a flyby; the same to first order, by kicks along
/// the free motion, degrees; and the work of all phases.
fn by_earth(start: &Start, end: f64, path: Path) -> Result<(Shift, f64, Work)> {
    let (mut most, mut kicked, mut work) = ([0.0; 3], 0.0, Work::default());
    for path in phases(path) {
        let changed = Changed::simulated(start, path, path.span(), 1e-11)?;
        let shift = shift(start, end, &changed.in_2008(start, end)?)?;
        most = [0, 1, 2].map(|i| largest([most[i], shift[i]]));
        kicked = largest([kicked, by_kicks(start, path, path.span(), end)?.to_degrees()]);
        work += changed.work;
    }
    Ok((most, kicked, work))
}

pub fn add(p: &Parameters, report: &mut Report) -> Result<()> {
    let (start, (_, last)) = (published(p)?, observed()?);
    let (motion, end) = (start.motion()?, last.t);
    let (path, always) = (Path::orbit(), [0.0, end]);
    let sunlit = Changed::simulated(&start, path, always, 1e-13)?;
    let (sun, by_sun) = (shift(&start, end, &sunlit.after.attitude)?, sunlit.work);
    let (first, first_kicked, by_first) = by_earth(&start, end, first_flyby(p))?;
    let (own, own_kicked, by_own) = by_earth(&start, end, flyby(p))?;
    let again = under_the_sun(&start, end)?.angle_to(&motion.attitude(end)).to_degrees();
    claims! { report,
        /// attitude of 2008 moved by the tide of the Sun
        sun_2008: sun[0], "deg", "Gauss-Legendre 16" => again, within 1e-4;
    }?;
    report.add(ledger(p, [sun, first, own])?)?;
    // Light pushes a crooked body: a hundredth of its pressure on the cross-section of a ball with
    // a radius of 1.2 km, which is also the arm, and 1.9e13 kg.
    let [axis, eccentricity] = ORBIT;
    let round = ((1.0 - eccentricity) * (1.0 + eccentricity)).sqrt();
    let pressure = 4.56e-6 * (AU * AU) / (axis * axis * round);
    let torque = 0.01 * pressure * PI * 1.2e3 / (0.4 * 1.9e13);
    // Tumbling bends it: rigidity times quality 5e12 Pa, 2500 kg/m^3, shape factor 0.03 (Harris).
    let w = start.angular_velocity.norm();
    let damping = 5e12 / (2500.0 * 0.03 * 1.2e3 * 1.2e3 * w * w * w);
    let friction = end / damping;
    // As if all of it turned the body about its long axis.
    let (lit, by_light) = simulated(&start, push(torque), end, 1e-14)?;
    let lit = turned(lit)?.angle_to(&motion.attitude(end)).to_degrees();
    let kicked = by_kicks(&start, path, always, end)?.to_degrees();
    // What goes round too far comes back from the other side.
    let told = |predicted: f64, [moved, ..]: Shift| (predicted < 60.0).then_some(moved);
    effect_card! { report,
        "tide of the Earth, 2004": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &flyby(p))?,
            costs own_kicked, "deg in 2008, at most, to first order", measured told(own_kicked, own), within 1e-5, at_work by_own, included;
        "tide of the Earth, 1992": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &first_flyby(p))?,
            costs first_kicked, "deg in 2008, at most, to first order", measured told(first_kicked, first), within 1e-5, at_work by_first;
        "tide of the Sun": "3 (n/Omega)^2 (1 - I_z/I_max)" = number(&start, &path)?,
            costs kicked, "deg in 2008, to first order", measured told(kicked, sun), within 1e-5, at_work by_sun;
        "push of light on a crooked body": "torque x t/(I Omega)" = torque * end / w,
            costs (0.5 * torque * end * end).to_degrees(), "deg in 2008, about", measured lit, at_work by_light;
        "friction inside": "t over the time of damping" = friction, costs (friction * w * end).to_degrees(), "deg in 2008, about";
    }
}

/// What moves the attitude of 2008, in degrees, beside what it was off by.
fn ledger(p: &Parameters, [sun, first, own]: [Shift; 3]) -> Result<Table> {
    let columns =
        "not known or left out,how large,azimuth about L,angle about the long axis".split(',');
    let (start, (_, last)) = (published(p)?, observed()?);
    let motion = start.motion()?;
    let [spin, precession] = periods(&motion);
    let [a, b] = best()?.deviations_of_periods()?;
    let worth = |period: f64, error: f64| 360.0 * turns_lost(last.t, period, error);
    let known = 0.03 * DAY;
    let (digits, missed) = (rounding(p, &start, last.t)?, shift(&start, last.t, &last.attitude)?);
    let fitted = format!("{:.3} and {:.3} d", b / DAY, a / DAY);
    let nearest = format!("{} au, worst phase", short(p.closest / AU, 3));
    let about = |[_, azimuth, spin]: Shift| [azimuth, spin];
    let row = |what: &str, size: &str, shifts: [f64; 2]| {
        let [azimuth, spin] = shifts.map(|x| format!("{} deg", supported_digits(x, 0.004 * x)));
        [what.to_string(), size.into(), azimuth, spin]
    };
    let rows = [
        row("periods, fitted to December 1992", &fitted, [worth(precession, b), worth(spin, a)]),
        row("periods, published in 2015", "0.03 d", [worth(precession, known), worth(spin, known)]),
        row("state of the epoch, as printed", "half of its last digits", about(digits)),
        row("tide of the Sun since 1992", "orbit by Kepler", about(sun)),
        row("tide of the Earth, December 1992", "0.0242 au, worst phase", about(first)),
        row("tide of the Earth, September 2004", &nearest, about(own)),
        row("the miss of 2008 itself", "observed", about(missed)),
    ];
    Table::of("ledger", columns, rows, Ok)
}
