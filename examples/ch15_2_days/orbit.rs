//! The independent route: the Earth's path by Newton's law, its turn as a rotating arrow, and
//! noons as located events.

use super::*;

/// Place and velocity of the Sun when it is nearest.
fn perigee(p: &Parameters) -> [f64; 4] {
    let (e, (s, c)) = (p.eccentricity, sincos(p.perigee));
    let (near, speed) = (1.0 - e, TAU / p.year * ((1.0 + e) / (1.0 - e)).sqrt());
    [near * c, near * s, -speed * s, speed * c]
}

/// The longitude of the Sun `t` days after it was nearest, and the work.
pub fn longitude(p: &Parameters, t: f64, step: f64) -> Result<(f64, Work)> {
    let ([x, y, ..], work) = Dop853::new(step)?.advance(&path(p.year), 0.0, &perigee(p), t)?;
    Ok((atan2(y, x), work))
}

/// Where the Sun is seen, from the time and `[x, y, x', y']` on the orbit.
pub type Seen<'a> = &'a dyn Fn(f64, [f64; 4]) -> [f64; 2];

/// The noons of a year from the epoch, in mean days, and the work of finding them.
pub fn noons(p: &Parameters, step: f64) -> Result<(Vec<f64>, Work)> {
    noons_seen(p, step, &|_, [x, y, ..]| [x, y])
}

/// The same if the Sun is seen elsewhere than the orbit alone has it.
pub fn noons_seen(p: &Parameters, step: f64, seen: Seen<'_>) -> Result<(Vec<f64>, Work)> {
    // From the last perigee that lies two days or more before the epoch.
    let mut start = (p.perigee - p.mean_longitude) * p.year / TAU;
    while start > -2.0 {
        start -= p.year;
    }
    let event = Event::rising("noon", |t, y: &[f64; 4]| past_meridian(p, t, seen(t, *y)));
    let method = Dop853::new(step)?.with_longest_step(1.0)?;
    let end = (p.year + 1.0).floor() + 0.5;
    let run = method.solve(&path(p.year), start, &perigee(p), end, &[event])?;
    let found = run.events().iter().map(|noon| noon.t).filter(|t| *t > -0.5);
    Ok((found.collect(), run.work()))
}

/// On a circle gone round at the rate `motion`, with an axis at right angles to it and OP
/// turning at `rate`: when OP faces the Sun again, and when it points at the same star again.
pub fn facing(rate: f64, motion: f64, step: f64) -> Result<[f64; 2]> {
    let arrows =
        ode(move |_, [x, y, u, v]: &[f64; 4]| [-motion * y, motion * x, -rate * v, rate * u])
            .scaled(size_or([1.0; 4]));
    let (method, start) = (Dop853::new(step)?, [1.0, 0.0, 1.0, 0.0]);
    let until = 3.0 * TAU / (rate - motion);
    let time = |f: fn(&[f64; 4]) -> f64| -> Result<_> {
        Ok(method.zero(&arrows, start, 2, until, f)?.0.t)
    };
    Ok([time(|[x, y, u, v]| x * v - y * u)?, time(|[_, _, _, v]| *v)?])
}
