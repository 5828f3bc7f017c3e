//! The tables: day by day, the fit, what moves the attitude of 2008, and a flyby in any phase.

use super::*;
use kit::{Table, short, supported_digits};

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
pub type Shift = [f64; 3];

/// What is not known or left out, as shifts.
#[derive(Debug, Clone, Copy)]
pub struct Moved {
    /// The tide of the Sun.
    pub sun: Shift,
    /// The largest by the Earth in any phase, in 1992 and in 2004.
    pub first: Shift,
    pub own: Shift,
    /// The root of the sum of squares over the published numbers, each by half of its last digit.
    pub digits: Shift,
    /// What the runs with the Sun and, all phases together, with the Earth have cost.
    pub work: [Work; 3],
}

impl Moved {
    pub fn new(p: &Parameters, study: &Study) -> Result<Self> {
        let (start, end) = (study.start, study.last.t);
        let motion = start.motion()?;
        let (free, momentum) = (motion.attitude(end), motion.angular_momentum());
        let shift = |there: &Attitude| shift(&free, there, momentum);
        let earth = |path: Path| -> Result<(Shift, Work)> {
            let (mut most, mut work) = ([0.0; 3], Work::default());
            for path in phases(path) {
                let changed = Changed::simulated(&start, path)?;
                let shift = shift(&changed.in_2008(&start, path, end)?)?;
                most = [0, 1, 2].map(|i| largest([most[i], shift[i]]));
                work += changed.work;
            }
            Ok((most, work))
        };
        let (sunlit, _, by_sun) = simulated_under(&start, Path::orbit(), [0.0, end], 1e-13)?;
        let ((first, by_first), (own, by_own)) = (earth(first_flyby(p))?, earth(flyby(p))?);
        Ok(Self {
            sun: shift(&sunlit)?,
            first,
            own,
            digits: rounding(p, study)?,
            work: [by_sun, by_first, by_own],
        })
    }
}

fn shift(free: &Attitude, there: &Attitude, momentum: SpaceVector) -> Result<Shift> {
    let [azimuth, spin] = off_about(free, there, momentum)?;
    Ok([there.angle_to(free).to_degrees(), azimuth.abs(), spin.abs()])
}

/// What half of the last printed digits is worth: the root of the sum of squares.
pub fn rounding(p: &Parameters, study: &Study) -> Result<Shift> {
    let motion = study.start.motion()?;
    let (free, momentum) = (motion.attitude(study.last.t), motion.angular_momentum());
    let each = by_rounding(p, study.last.t)?;
    let each =
        each.iter().map(|there| shift(&free, there, momentum)).collect::<Result<Vec<_>>>()?;
    let square = |i: usize| each.iter().map(|shift| shift[i] * shift[i]).sum::<f64>();
    Ok([0, 1, 2].map(|i| square(i).sqrt()))
}

/// The attitude of the end if one published number after the other is half of its last printed
/// digit higher.
fn by_rounding(p: &Parameters, end: f64) -> Result<[Attitude; 8]> {
    let mut there = [Attitude::IDENTITY; 8];
    for (i, there) in there.iter_mut().enumerate() {
        let mut half = [0.0; 8];
        half[i] = [5e-4, 5e-4, 5e-4, 5e-3, 5e-4, 5e-4, 5e-5, 5e-4][i];
        let [a, b, c, x, y, z, moment_x, moment_y] = half;
        let start = Start {
            moments: [p.moment_x + moment_x, p.moment_y + moment_y, 1.0],
            attitude: attitude([145.498 + a, 65.865 + b, 241.524 + c])?,
            angular_velocity: rates([14.51 + x, 33.529 + y, -98.709 + z]),
        };
        *there = start.motion()?.attitude(end);
    }
    Ok(there)
}

pub fn add(p: &Parameters, study: &Study, moved: &Moved, report: &mut Report) -> Result<()> {
    report.add(days(study)?)?;
    report.add(unknowns_table(study)?)?;
    report.add(ledger(p, study, moved)?)?;
    report.add(flybys(p, study)?)
}

fn days(study: &Study) -> Result<Table> {
    let columns = "day,since the epoch,attitude off,long axis off,angular velocity off,its length,off after the fit";
    let mut table = Table::new("days", columns.split(','))?;
    let motion = study.start.motion()?;
    let z = BodyVector::new(0.0, 0.0, 1.0);
    for (i, day) in study.december.iter().chain([&study.last]).enumerate() {
        let found = motion.kinematics(day.t);
        let space = |v: BodyVector| found.attitude.to_space(v);
        let (w, seen) = (found.angular_velocity, day.angular_velocity);
        let after = study.fitted_misses.get(i).map_or("-".into(), |miss| format!("{miss:.1}"));
        table.push([
            day.date[..10].to_string(),
            format!("{:.2} d", day.t / DAY),
            format!("{:.1}", day.attitude.angle_to(&found.attitude).to_degrees()),
            format!("{:.1}", angle_between(space(z), day.attitude.to_space(z))),
            format!("{:.1}", angle_between(space(w), space(seen))),
            format!("{:.3}", seen.norm() / w.norm()),
            after,
        ])?;
    }
    Ok(table)
}

fn unknowns_table(study: &Study) -> Result<Table> {
    let columns = ["quantity", "published", "fitted", "by the curvature", "by leaving a day out"];
    let mut table = Table::new("fit", columns)?;
    let guess = unknowns(&study.printed)?;
    let loose = jackknife(&study.december, &study.printed, study.fit.at)?;
    let turn = 1.0_f64.to_degrees();
    let rows: [(&str, f64); 8] = [
        ("turn about X, deg", turn),
        ("turn about Y, deg", turn),
        ("turn about Z, deg", turn),
        ("rate about x, deg/d", turn),
        ("rate about y, deg/d", turn),
        ("rate about the long axis, deg/d", turn),
        ("moment about x", 1.0),
        ("moment about y", 1.0),
    ];
    for (i, (name, unit)) in rows.into_iter().enumerate() {
        let cell = |value: f64| format!("{:.2}", value * unit);
        table.push([
            name.into(),
            cell(guess[i]),
            cell(study.fit.at[i]),
            cell(study.fit.deviation(i)),
            cell(loose[i]),
        ])?;
    }
    Ok(table)
}

/// What moves the attitude of 2008, in degrees, beside what it was off by.
fn ledger(p: &Parameters, study: &Study, moved: &Moved) -> Result<Table> {
    let columns =
        ["not known or left out", "how large", "azimuth about L", "angle about the long axis"];
    let mut table = Table::new("ledger", columns)?;
    let (start, last) = (study.start, study.last);
    let [spin, precession] = start.periods()?;
    let [a, b] = [study.deviation_of_period(0)?, study.deviation_of_period(1)?];
    let worth = |period: f64, error: f64| 360.0 * study.turns_lost(period, error);
    let degrees = |x: f64| format!("{} deg", supported_digits(x, 0.004 * x));
    let motion = start.motion()?;
    let [off, spin_off] =
        off_about(&motion.attitude(last.t), &last.attitude, motion.angular_momentum())?;
    let published = 0.03 * DAY;
    let fitted = format!("{:.3} and {:.3} d", b / DAY, a / DAY);
    let mut row = |what: &str, size: &str, [azimuth, spin]: [f64; 2]| {
        table.push([what.into(), size.into(), degrees(azimuth), degrees(spin)])
    };
    row("periods, fitted to December 1992", &fitted, [worth(precession, b), worth(spin, a)])?;
    row(
        "periods, published in 2015",
        "0.03 d",
        [worth(precession, published), worth(spin, published)],
    )?;
    row(
        "state of the epoch, as printed",
        "half of its last digits",
        [moved.digits[1], moved.digits[2]],
    )?;
    row("tide of the Sun since 1992", "orbit by Kepler", [moved.sun[1], moved.sun[2]])?;
    row(
        "tide of the Earth, December 1992",
        "0.0242 au, worst phase",
        [moved.first[1], moved.first[2]],
    )?;
    row(
        "tide of the Earth, September 2004",
        &format!("{} au, worst phase", short(p.closest / AU, 3)),
        [moved.own[1], moved.own[2]],
    )?;
    row("the miss of 2008 itself", "observed", [off.abs(), spin_off.abs()])?;
    Ok(table)
}

/// The flyby with the Earth in six directions, at the one moment of the parameters.
fn flybys(p: &Parameters, study: &Study) -> Result<Table> {
    let columns = [
        "longitude",
        "change of L",
        "turn of L",
        "change of 2 pi/T_1",
        "change of 2 pi/T_2",
        "moves 2008 by",
    ];
    let mut table = Table::new("flybys", columns)?;
    let (start, end) = (study.start, study.last.t);
    let (before, free) = (start.periods()?, start.motion()?.attitude(end));
    for path in phases(flyby(p)).take(6) {
        let changed = Changed::simulated(&start, path)?;
        let onward = changed.onward(&start)?;
        let one = onward.rate_period();
        let after = [one, one * TAU / onward.precession_per_period().abs()];
        let rate = |i: usize| format!("{:.4} deg/d", (360.0 / after[i] - 360.0 / before[i]) * DAY);
        let turn = angle_between(changed.after.angular_momentum, changed.free.angular_momentum);
        table.push([
            format!("{:.0} deg", path.angles[2].to_degrees()),
            format!("{:.2e}", changed.momentum()),
            format!("{turn:.3} deg"),
            rate(0),
            rate(1),
            format!("{:.1} deg", changed.in_2008(&start, path, end)?.angle_to(&free).to_degrees()),
        ])?;
    }
    Ok(table)
}
