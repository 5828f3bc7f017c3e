//! The tide: the side near a planet or the Sun is attracted more than the far side.

use super::*;
use rotation_dynamics::accuracy::{Resolution, Variables};
use rotation_dynamics::integrators::Method;

/// G M of the Earth and of the Sun, m^3/s^2; the astronomical unit, m.
pub const EARTH: f64 = 3.986_004_418e14;
const SUN: f64 = 1.327_124_400_18e20;
pub const AU: f64 = 1.495_978_707e11;
/// The asteroid's orbit of November 2008: half of its long axis (m), its eccentricity.
pub const ORBIT: [f64; 2] = [2.5321 * AU, 0.6288];

/// The orbit of an attracting body, as it is seen from the asteroid.
#[derive(Debug, Clone, Copy)]
pub struct Path {
    pub attracts: f64,
    pub eccentricity: f64,
    /// Distance at the closest (m), and when (s after the epoch).
    pub closest: f64,
    pub when: f64,
    /// Node, inclination, and from the node to the closest, rad.
    pub angles: [f64; 3],
}

impl Path {
    /// The Earth goes past in the plane of the ecliptic.
    pub fn flyby(p: &Parameters, closest: f64, date: &str) -> Self {
        Self {
            attracts: EARTH,
            eccentricity: 1.0 + closest * p.speed * p.speed / EARTH,
            closest,
            when: since_epoch(date),
            angles: [0.0, 0.0, p.longitude],
        }
    }

    /// The Sun, by the elements of the asteroid's orbit of November 2008.
    pub fn orbit() -> Self {
        let [axis, eccentricity] = ORBIT;
        let mean_motion = (SUN / (axis * axis * axis)).sqrt();
        let since = 5.1220_f64.to_radians() / mean_motion;
        // Node, inclination, argument of the perihelion; the Sun is on the other side.
        let [node, inclination, argument] = [124.30_f64, 0.4460, 278.75].map(f64::to_radians);
        Self {
            attracts: SUN,
            eccentricity,
            closest: axis * (1.0 - eccentricity),
            when: since_epoch("2008-11-27T00:00:00") - since,
            angles: [node, inclination, argument + PI],
        }
    }

    /// When its tide is put in, if it is a flyby.
    pub fn span(&self) -> [f64; 2] {
        [self.when - HALF, self.when + HALF]
    }

    /// Where the attracting body is seen from the asteroid, m.
    pub fn place(&self, t: f64) -> Result<SpaceVector> {
        Ok(tide(*self, 0.0)?.orbit().place(t))
    }
}

/// What a tide adds to the slopes of the rates, by [`tumbling`].
fn pulled([a, b, c]: [f64; 3], tide: OrbitingBody) -> impl Fn(f64, &[f64; 8]) -> [f64; 3] {
    move |t, &[_, _, _, w, x, y, z, _]| {
        let (v, strength) = tide.pull(t * DAY);
        // The direction on the body's axes: v + 2 (v x u) w + 2 (v x u) x u.
        let u = SpaceVector::new(x, y, z);
        let across = v.cross(&u) * 2.0;
        let [l, m, n] = (v + across * w + across.cross(&u)).to_array();
        let pull = 3.0 * strength * (DAY * DAY);
        [pull * (c - b) * m * n / a, pull * (a - c) * n * l / b, pull * (b - a) * l * m / c]
    }
}

/// How long before and after the closest the tide of a flyby is put in.
pub const HALF: f64 = 20.0 * DAY;

/// What a tide changes.
#[derive(Debug, Clone, Copy)]
pub struct Changed {
    /// The state at the time t after it, and without it.
    pub t: f64,
    pub after: State,
    pub free: State,
    /// What it cost to find out.
    pub work: Work,
}

impl Changed {
    pub fn by(start: &Start, path: Path, tolerance: f64) -> Result<Self> {
        let ([begin, t], motion) = (path.span(), start.motion()?);
        let scene = Scene::new(start.body()?).with(tide(path, begin)?);
        let solved = scene.solve(&motion.state(begin), 2.0 * HALF, tolerance)?;
        Ok(Self { t, after: solved.state, work: solved.work, free: motion.state(t) })
    }

    /// The same over this span by Euler's equations, another method in other variables: less sure,
    /// and five times faster.
    pub fn simulated(start: &Start, path: Path, [begin, t]: [f64; 2], step: f64) -> Result<Self> {
        let ([a, b, c], tide) = (start.moments, pulled(start.moments, tide(path, begin)?));
        let (there, work) = simulated(&start.at(begin)?, tide, t - begin, step)?;
        let (attitude, [p, q, r, ..]) = (turned(there)?, there);
        let momentum = attitude.to_space(BodyVector::new(a * p, b * q, c * r) / DAY);
        Ok(Self { t, after: State::new(attitude, momentum)?, work, free: start.motion()?.state(t) })
    }

    /// The change of L over L.
    pub fn momentum(&self) -> f64 {
        let free = self.free.angular_momentum;
        (self.after.angular_momentum - free).norm() / free.norm()
    }

    /// By how much the attitude is another one, degrees.
    pub fn attitude(&self) -> f64 {
        self.after.attitude.angle_to(&self.free.attitude).to_degrees()
    }

    /// The attitude at the end, if nothing else happens.
    pub fn in_2008(&self, start: &Start, end: f64) -> Result<Attitude> {
        Ok(onward(&start.body()?, &self.after)?.attitude(end - self.t))
    }
}

/// The free motion that goes on from here.
pub fn onward(body: &RigidBody, from: &State) -> rotation_dynamics::Result<FreeBody> {
    FreeBody::new(body.moments(), from.attitude, body.angular_velocity(from))
}

/// The number of a tide: 3 (n/omega)^2 times the larger difference of moments over the larger.
pub fn number(start: &Start, path: &Path) -> Result<f64> {
    let state = start.motion()?.state(0.0);
    Ok(tide(*path, 0.0)?.number(&start.body()?, &state))
}

/// The attitude of the end with the tide of the Sun since the epoch, by one run in steps of a
/// day and a half.
pub fn under_the_sun(start: &Start, end: f64) -> Result<Attitude> {
    let scene = Scene::new(start.body()?).with(tide(Path::orbit(), 0.0)?);
    let from = start.motion()?.state(0.0);
    let steps = Resolution::Steps((end / (1.5 * DAY)) as u64);
    let problem = Problem::new(scene, from, end, from);
    Ok(problem.run(Method::GaussLegendre16, Variables::Space, steps)?.0.attitude)
}

/// By how much (rad) the tide along a path between two times turns the attitude at `end`, to
/// first order in it: each quarter of a day of it is a kick of L on the free motion, which is
/// free again from there on, and what the kicks do at the end adds up.
pub fn by_kicks(start: &Start, path: Path, [from, to]: [f64; 2], end: f64) -> Result<f64> {
    let (motion, body) = (start.motion()?, start.body()?);
    let (free, tide) = (motion.attitude(end), tide(path, 0.0)?);
    // So small that the turn by it is in proportion, also after a thousand revolutions.
    let small = 1e-8 * motion.angular_momentum().norm();
    // Gauss's two points to each half of a day.
    let pieces = ((to - from) / (0.5 * DAY)).ceil();
    let (piece, aside) = ((to - from) / pieces, 0.5 / 3.0_f64.sqrt());
    let middles = (0..pieces as u32).map(|k| f64::from(k) + 0.5);
    let mut turn = SpaceVector::zero();
    for at in middles.flat_map(|middle| [middle - aside, middle + aside]) {
        let (t, mut state) = (from + at * piece, motion.state(from + at * piece));
        let torque = tide.torque(t, &body, &state);
        if torque.norm() > 0.0 {
            state.angular_momentum += torque * (small / torque.norm());
            let there = turn_between(&free, &onward(&body, &state)?.attitude(end - t));
            turn += there * (torque.norm() / small * 0.5 * piece);
        }
    }
    Ok(turn.norm())
}
