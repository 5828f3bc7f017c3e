//! A further problem: a spinning bicycle wheel whose axle hangs by one end from a rope.

#[path = "further_5_wheel_on_rope/figures.rs"]
mod figures;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::integrators::{
    Dop853, Event, LocatedEvent, Ode, Solution, after, ode, size_or,
};

parameters! {
    /// The bicycle wheel of section 16.2, on a rope.
    pub struct Parameters {
        /// mass, all of it in the rim
        mass: number(2.0, "kg", above(0.0).usually(0.5, 5.0)).drawn(1.5, 3.0, 0.1);
        /// radius of the rim
        radius: number(0.33, "m", above(0.0).usually(0.1, 0.5));
        /// from the rope to the hub
        lever: number(0.15, "m", above(0.0).usually(0.05, 0.3)).drawn(0.1, 0.18, 0.01);
        /// length of the rope
        rope: number(2.0, "m", above(0.0).usually(0.2, 5.0)).drawn(1.0, 2.0, 0.1);
        /// angular velocity along the axle, about an axis outward from the rope
        spin: number(12.0, "rad/s", any().usually(5.0, 60.0)).drawn(14.0, 24.0, 1.0).open("spin of the wheel", "walks quickly", "walks slowly");
        /// by how much the axle rises outward, in question 2
        rise: number(0.5, "rad", between(-FRAC_PI_2, FRAC_PI_2).because("an upright axle has no azimuth that could turn").usually(-1.2, 1.2));
        /// azimuthal rate with which the level axle is let go
        push: number(0.0, "rad/s", any().usually(-2.0, 3.0)).open("push at the release", "backward", "forward");
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// density of the air that brakes the wheel, for the claims about it
        air: effect(1.204, "kg/m^3", above_to(0.0, 1e3).because("what is denser is a liquid, and carries the wheel"));
        /// error of a step of the simulations: from 1e-14 to 1e-6
        tolerance: number(1e-13, "-", from_to(1e-14, 1e-6));
    }
}

/// A symmetric wheel, its axle hung by one end on a massless rope.
#[derive(Debug, Clone, Copy)]
pub struct Wheel {
    pub mass: f64,
    /// Moment of inertia across the axle, about the centre of mass.
    pub transverse: f64,
    /// Angular momentum along the axle, outward.
    pub momentum: f64,
    pub lever: f64,
    pub rope: f64,
    pub gravity: f64,
}

/// Directions of rope and axle, from the support outward, each with its rate.
pub struct Place {
    pub rope: [SpaceVector; 2],
    pub axle: [SpaceVector; 2],
}

/// A direction and its rate, without what round-off has added along the direction.
fn unit(n: &[f64], rate: &[f64]) -> [SpaceVector; 2] {
    let [n, rate] = [n, rate].map(|v| SpaceVector::new(v[0], v[1], v[2]));
    let n = n / n.norm();
    [n, rate - n * n.dot(&rate)]
}

/// Rope and axle of a state of [`Wheel::hung`].
pub fn place(y: &[f64; 12]) -> Place {
    let (rope, axle) = (unit(&y[0..3], &y[3..6]), unit(&y[6..9], &y[9..12]));
    Place { rope, axle }
}

// ANCHOR: newton
impl Wheel {
    /// By Newton's law and the rope's pull, in space: directions of rope and axle, each
    /// followed by its rate.
    pub fn hung(self) -> impl Ode<12> {
        ode(move |_, y: &[f64; 12]| self.rates(&place(y))).scaled(size_or([1.0; 12]))
    }

    pub fn rates(&self, now: &Place) -> [f64; 12] {
        let Place { rope: [r, v], axle: [e, u] } = *now;
        let pull = self.tension(now);
        let torque = (r - e * e.dot(&r)) * (self.lever * pull);
        let turned = (torque + e.cross(&u) * self.momentum) / self.transverse - e * u.dot(&u);
        let falls = SpaceVector::new(0.0, 0.0, -self.gravity) - r * (pull / self.mass);
        let each = [v, (falls - turned * self.lever) / self.rope, u, turned];
        let each = each.map(SpaceVector::to_array);
        core::array::from_fn(|i| each[i / 3][i % 3])
    }

    /// The pull that keeps the end of the axle at the rope's length from the support.
    pub fn tension(&self, place: &Place) -> f64 {
        let Place { rope: [r, v], axle: [e, u] } = place;
        let (along, l) = (e.dot(r), self.lever);
        let gyroscopic = self.momentum * e.cross(u).dot(r) / self.transverse;
        let needed =
            self.rope * v.dot(v) - self.gravity * r.z() + l * (u.dot(u) * along - gyroscopic);
        needed / (1.0 / self.mass + l * l * (1.0 - along * along) / self.transverse)
    }
}
// ANCHOR_END: newton

// ANCHOR: lagrange
/// The coordinates of the Lagrangian: the rope's direction `x` along the axle's azimuth and
/// `y` across it, the axle's angle from the vertical and its azimuth; then their rates.
pub type Coordinates = [f64; 8];

impl Wheel {
    /// By Lagrange's equations.
    pub fn free(self) -> impl Ode<8> {
        ode(move |_, q: &Coordinates| {
            let a = self.accelerations(q);
            [q[4], q[5], q[6], q[7], a[0], a[1], a[2], a[3]]
        })
        .scaled(size_or([1.0; _]))
    }

    /// What rope and axle gain per rate of each coordinate, and what is left of their second
    /// derivatives if the rates are constant; on axes that turn with the axle's azimuth.
    fn geometry(&self, q: &Coordinates) -> [([SpaceVector; 4], SpaceVector); 2] {
        let [x, y, theta, _, vx, vy, nod, turn] = *q;
        let (z, (s, c), v) = ((1.0 - x * x - y * y).sqrt(), sincos(theta), SpaceVector::new);
        let sinking = -(x * vx + y * vy) / z;
        let up = (vx * vx + vy * vy + sinking * sinking) / z;
        let zero = SpaceVector::zero();
        [
            (
                [v(1.0, 0.0, x / z), v(0.0, 1.0, y / z), zero, v(-y, x, 0.0)],
                v(-2.0 * turn * vy - turn * turn * x, 2.0 * turn * vx - turn * turn * y, up),
            ),
            (
                [zero, zero, v(c, 0.0, -s), v(0.0, s, 0.0)],
                v(-s * (nod * nod + turn * turn), 2.0 * nod * turn * c, -c * nod * nod),
            ),
        ]
    }

    fn accelerations(&self, q: &Coordinates) -> [f64; 4] {
        let [(rope, rope_left), (axle, axle_left)] = self.geometry(q);
        let moved = [0, 1, 2, 3].map(|i| rope[i] * self.rope + axle[i] * self.lever);
        let left = rope_left * self.rope + axle_left * self.lever;
        let fall = SpaceVector::new(0.0, 0.0, -self.gravity) - left;
        let twist = self.momentum * sin(q[2]);
        let gyroscopic = [0.0, 0.0, -twist * q[7], twist * q[6]];
        let mass = [0, 1, 2, 3].map(|i| {
            [0, 1, 2, 3].map(|j| {
                self.mass * moved[i].dot(&moved[j]) + self.transverse * axle[i].dot(&axle[j])
            })
        });
        let force = [0, 1, 2, 3].map(|i| {
            self.mass * moved[i].dot(&fall) - self.transverse * axle[i].dot(&axle_left)
                + gyroscopic[i]
        });
        kit::solved(mass, force)
    }
}
// ANCHOR_END: lagrange

impl Wheel {
    pub fn new(p: &Parameters) -> Self {
        let &Parameters { mass, lever, rope, gravity, .. } = p;
        let rim = mass * p.radius * p.radius;
        Self { mass, transverse: 0.5 * rim, momentum: rim * p.spin, lever, rope, gravity }
    }

    /// The rate of precession of the lecture: weight times lever over angular momentum.
    pub fn lecture(&self) -> f64 {
        self.mass * self.gravity * self.lever / self.momentum
    }

    /// Moment of inertia about the end of the axle.
    fn at_end(&self) -> f64 {
        self.transverse + self.mass * self.lever * self.lever
    }

    /// The tangent of the rope's angle if the axle goes round at a rate of which `w` is the square
    /// over g: by Newton's method, from this one on, and how far off it is.
    fn leaning(&self, w: f64, rise: f64, mut tangent: f64) -> [f64; 2] {
        let reach = self.lever * cos(rise);
        let off = |t: f64| t - w * (self.rope * t / (1.0 + t * t).sqrt() + reach);
        for _ in 0..200 {
            let slope = 1.0 - w * self.rope / pow(1.0 + tangent * tangent, 1.5);
            tangent -= off(tangent) / slope;
        }
        [tangent, off(tangent)]
    }

    /// The rope's angle, outward, if the axle goes round at this rate: the one zero above 0 of a
    /// function that is convex there, from above.
    pub fn outward(&self, rate: f64, rise: f64) -> f64 {
        let w = rate * rate / self.gravity;
        atan2(self.leaning(w, rise, w * (self.rope + self.lever * cos(rise)))[0], 1.0)
    }

    /// The steady precession with the axle at this rise: its rate and the rope's angle.
    pub fn steady(&self, rise: f64) -> rotation_dynamics::Result<[f64; 2]> {
        let ((s, c), start, spun) = (sincos(rise), self.lecture().abs(), self.momentum.abs());
        let missing = |rate: f64| {
            let across = self.mass * self.rope * self.lever * sin(self.outward(rate, rise));
            start + rate * rate * s / c * (self.at_end() * c + across) / spun - rate
        };
        let steps = times(0.0, 20.0 * start, 400).collect::<Vec<_>>();
        let found = steps.windows(2).find(|w| missing(w[1]) <= 0.0);
        let slow = "it must be faster, or the axle lower: no slow precession holds the axle up";
        let (name, value) = ("spin", self.momentum / (2.0 * self.transverse));
        let found = found.ok_or(Error::out_of_range(name, value, slow))?;
        let [_, high] = bisect([found[0], found[1]], 0.0, |rate| missing(rate) > 0.0);
        Ok([high * self.momentum.signum(), self.outward(high, rise)])
    }

    /// The coordinates of that motion.
    pub fn going(&self, rise: f64) -> Result<Coordinates> {
        let [rate, angle] = self.steady(rise)?;
        Ok([sin(angle), 0.0, FRAC_PI_2 - rise, 0.0, 0.0, 0.0, 0.0, rate])
    }

    /// The other steady precession of a level axle, the rope leaning inward; there is one
    /// if the wheel goes round so fast that the rope cannot follow.
    pub fn inward(&self) -> Option<Coordinates> {
        let rate = self.lecture();
        let [tangent, off] = self.leaning(rate * rate / self.gravity, 0.0, 0.0);
        let x = tangent / (1.0 + tangent * tangent).sqrt();
        (tangent < 0.0 && off.abs() <= 1e-12)
            .then_some([x, 0.0, FRAC_PI_2, 0.0, 0.0, 0.0, 0.0, rate])
    }

    /// A state in space with these coordinates.
    pub fn in_space(&self, q: &Coordinates) -> [f64; 12] {
        let ([x, y, theta, ..], (sa, ca)) = (*q, sincos(q[3]));
        let z = -(1.0 - x * x - y * y).sqrt();
        let turned = |v: SpaceVector| [ca * v.x() - sa * v.y(), sa * v.x() + ca * v.y(), v.z()];
        let geometry = self.geometry(q);
        let rate = |k: usize| {
            let sum = |i: usize| geometry[k].0[i] * q[4 + i];
            sum(0) + sum(1) + sum(2) + sum(3)
        };
        let axle = SpaceVector::new(sin(theta), 0.0, cos(theta));
        let parts = [SpaceVector::new(x, y, z), rate(0), axle, rate(1)].map(turned);
        core::array::from_fn(|i| parts[i / 3][i % 3])
    }

    /// The tension of [`Wheel::free`]: what the centre's acceleration asks of the rope.
    pub fn tension_of(&self, q: &Coordinates) -> f64 {
        let [(rope, rope_left), (axle, axle_left)] = self.geometry(q);
        let a = self.accelerations(q);
        let gained = |per: [SpaceVector; 4], left| (0..4).fold(left, |sum, i| sum + per[i] * a[i]);
        let centre = gained(rope, rope_left) * self.rope + gained(axle, axle_left) * self.lever;
        let [x, y, ..] = *q;
        let r = SpaceVector::new(x, y, -(1.0 - x * x - y * y).sqrt());
        -self.mass * (centre + SpaceVector::new(0.0, 0.0, self.gravity)).dot(&r)
    }
}

/// Angle of the rope from the vertical, outward along the axle's azimuth, and the axle's rise.
pub fn angles(y: &[f64; 12]) -> [f64; 2] {
    let Place { rope: [r, _], axle: [e, _] } = place(y);
    let out = (r.x() * e.x() + r.y() * e.y()) / hypot(e.x(), e.y());
    [atan2(out, -r.z()), atan2(e.z(), hypot(e.x(), e.y()))]
}

// ANCHOR: modes
/// Small oscillations about a steady precession: a squared frequency, and the rates of
/// `ODD` with which it starts.
pub struct Mode {
    pub frequency: f64,
    pub start: [f64; 3],
}

/// Places among the coordinates: those that a reflection in the plane of rope and axle,
/// with time reversed, leaves alone, and those that change their sign.
const EVEN: [usize; 4] = [0, 2, 5, 7];
const ODD: [usize; 3] = [1, 4, 6];

impl Wheel {
    /// The three modes, the slowest first, from the Jacobian matrix of Lagrange's equations:
    /// even' = B odd and odd' = C even, so odd'' = C B odd.
    pub fn modes(&self, rest: Coordinates) -> rotation_dynamics::Result<[Mode; 3]> {
        let jacobian = |to: usize, by: usize| {
            let moved = |h: f64| {
                let mut q = rest;
                q[by] += h;
                self.free().derivative(0.0, &q)[to]
            };
            let slope = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
            (4.0 * slope(1e-3) - slope(2e-3)) / 3.0
        };
        let b = EVEN.map(|to| ODD.map(|by| jacobian(to, by)));
        let c = ODD.map(|to| EVEN.map(|by| jacobian(to, by)));
        let squared =
            [0, 1, 2].map(|i| [0, 1, 2].map(|j| -(0..4).map(|k| c[i][k] * b[k][j]).sum::<f64>()));
        let (name, value) = ("spin", self.momentum / (2.0 * self.transverse));
        let allowed = "another one is needed: this steady precession is not stable";
        eigen(squared).ok_or(Error::out_of_range(name, value, allowed))
    }
}
// ANCHOR_END: modes

/// The eigenvalues of a matrix as squared frequencies, with their eigenvectors.
fn eigen(a: [[f64; 3]; 3]) -> Option<[Mode; 3]> {
    let row = |i: usize| SpaceVector::from_array(a[i]);
    let trace = a[0][0] + a[1][1] + a[2][2];
    let minor = |i: usize, j: usize| a[i][i] * a[j][j] - a[i][j] * a[j][i];
    let minors = minor(0, 1) + minor(1, 2) + minor(2, 0);
    let det = row(0).dot(&row(1).cross(&row(2)));
    let at = |x: f64| ((x - trace) * x + minors) * x - det;
    // The turning points of the characteristic polynomial part its zeros.
    let turn = (trace * trace - 3.0 * minors).max(0.0).sqrt();
    let [low, high] = [(trace - turn) / 3.0, (trace + turn) / 3.0];
    if !(at(0.0) < 0.0 && at(low) > 0.0 && at(high) < 0.0) {
        return None;
    }
    let mode = |from: f64, to: f64| {
        let [below, above] = bisect([from, to], 0.0, |x| (at(x) < 0.0) == (at(from) < 0.0));
        let x = 0.5 * (below + above);
        let mut less = a;
        (0..3).for_each(|i| less[i][i] -= x);
        let [r, s, t] = less.map(SpaceVector::from_array);
        let longer = |a: SpaceVector, b: SpaceVector| if b.norm() > a.norm() { b } else { a };
        let across = longer(longer(r.cross(&s), s.cross(&t)), t.cross(&r));
        Mode { frequency: x.sqrt(), start: (across / across.norm()).to_array() }
    };
    Some([mode(0.0, low), mode(low, high), mode(high, trace)])
}

/// The coordinates of a level axle and a hanging rope, pushed round at this rate.
pub const fn level(push: f64) -> Coordinates {
    [0.0, 0.0, FRAC_PI_2, 0.0, 0.0, 0.0, 0.0, push]
}

/// The frequency of a mode, simulated: two sizes of either sign, a period between zeros of
/// the rope's angle or, `nods`, of the axle's.
pub fn measured(wheel: Wheel, rest: Coordinates, mode: &Mode, nods: bool) -> Result<f64> {
    let mut period = 0.0;
    let most = mode.start.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for size in [1e-4, -1e-4] {
        let mut q = rest;
        ODD.into_iter().zip(mode.start).for_each(|(k, x)| q[k] += size * x / most);
        let start = wheel.in_space(&q);
        let read = |y: &[f64; 12]| angles(y)[usize::from(nods)];
        let (rest, until) = (read(&start), 20.0 / mode.frequency);
        let back = Dop853::new(1e-15)?.zero(&wheel.hung(), start, 2, until, |y| read(y) - rest)?;
        period += 0.5 * back.0.t;
    }
    Ok(2.0 * PI / period)
}

impl Wheel {
    /// Let go with a level axle and a hanging rope, pushed round at this rate, until the
    /// rope goes slack.
    pub fn let_go(self, push: f64, end: f64, step: f64) -> Result<Solution<12>> {
        let start = self.in_space(&level(push));
        let pull = self.tension(&place(&start)) / (self.mass * self.gravity);
        allowed! { "tension at the start over the weight": pull, above(0.0), "a rope does not push"; }?;
        let slack = Event::falling("slack", move |_, y| self.tension(&place(y))).terminal();
        Ok(Dop853::new(step)?.solve(&self.hung(), 0.0, &start, end, &[slack])?)
    }

    /// The first time at which the axle is lowest or highest.
    pub fn turning(self, push: f64, step: f64) -> Result<LocatedEvent<12>> {
        let start = self.in_space(&level(push));
        Ok(Dop853::new(step)?.zero(&self.hung(), start, 1, 100.0, |y| y[11])?.0)
    }

    /// A forward push with which it goes slack at the top of the first nod, nearly.
    pub fn forward(&self) -> f64 {
        let end = self.at_end() + self.mass * self.lever * self.lever;
        self.gravity * end / (self.lever * self.momentum)
    }

    /// A backward push with which the rope is slack at once.
    pub fn backward(&self) -> f64 {
        -self.gravity * self.transverse / (self.lever * self.momentum)
    }
}

/// Rate, rope's angle and tension after three seconds of steady precession.
pub fn after_a_while(wheel: Wheel, rise: f64, step: f64) -> Result<[f64; 3]> {
    let (q, time) = (wheel.going(rise)?, 3.0);
    let end = after(time, &wheel.hung(), &wheel.in_space(&q), step)?;
    let Place { axle: [e, _], .. } = place(&end);
    let (s, c) = sincos(atan2(e.y(), e.x()) - q[7] * time);
    let ahead = atan2(s, c);
    Ok([q[7] + ahead / time, angles(&end)[0], wheel.tension(&place(&end))])
}

/// Where the centre of mass is, by the linear theory: a pendulum whose support goes round.
pub fn drawn_round(wheel: &Wheel, t: f64) -> (f64, f64) {
    let p = wheel.lecture();
    let (w, l) = ((wheel.gravity / wheel.rope).sqrt(), wheel.lever);
    let steady = l * w * w / ((w - p) * (w + p));
    let (there, back) = (-0.5 * l * p / (w - p), 0.5 * l * p / (w + p));
    (
        steady * cos(p * t) + (there + back) * cos(w * t),
        steady * sin(p * t) + (there - back) * sin(w * t),
    )
}

/// Centre of mass and end of the axle, seen from above.
pub fn from_above(wheel: &Wheel, y: &[f64; 12]) -> [(f64, f64); 2] {
    let Place { rope: [r, _], axle: [e, _] } = place(y);
    let end = r * wheel.rope;
    let centre = end + e * wheel.lever;
    [(centre.x(), centre.y()), (end.x(), end.y())]
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (wheel, weight) = (Wheel::new(p), p.mass * p.gravity);
    let (rest, bound) = (wheel.going(0.0)?, 1e-9 + 1e4 * p.tolerance);
    let [rate, rope] = wheel.steady(0.0)?;
    let nods = 10.0 * wheel.momentum.abs() / (wheel.transverse * wheel.at_end()).sqrt();
    allowed! {
        "angle of the rope with a level axle": rope, from_to(0.0, 1.4), "farther out it is swung round like a stone on a string";
        "rope over lever": p.rope / p.lever, from_to(0.05, 1e6), "a shorter rope is a pivot";
        "radians of nutation in ten seconds": nods, from_to(0.0, 3e4), "more of them take too long to simulate";
    }?;
    let [risen, leaning] = wheel.steady(p.rise)?;
    let [slow, fast, nod] = wheel.modes(rest)?;
    let [flat, up] = [0.0, p.rise].map(|rise| after_a_while(wheel, rise, p.tolerance));
    let ([flat_rate, flat_rope, pull], [up_rate, up_rope, _]) = (flat?, up?);
    let run = wheel.let_go(p.push, 10.0, p.tolerance)?;
    let slack = run.stopped_by().is_some();
    let nods = wheel.turning(p.push, p.tolerance)?;
    // The same by Lagrange's equations.
    let (free, method) = (wheel.free(), Dop853::new(p.tolerance)?);
    let (again, _) = method.zero(&free, level(p.push), 1, 100.0, |q| q[6])?;
    let gives = Event::falling("slack", move |_, q| wheel.tension_of(q)).terminal();
    let free = method.solve(&free, 0.0, &level(p.push), 10.0, &[gives])?;
    // A rod would go on to its turning point; a rope that is slack before does not.
    let turns = nods.t < run.end_time();
    let (dip, fixed) = (-angles(&nods.state)[1], weight * p.lever * wheel.at_end());
    let small = |mode: &Mode, nods: bool| measured(wheel, rest, mode, nods);
    let (back, l2) = (wheel.backward(), wheel.momentum * wheel.momentum);
    let at = |push| wheel.tension_of(&level(push));
    claims! { report,
        /// level axle: rate
        level_rate: rate, "rad/s", "after 3 s" => flat_rate, within bound * rate.abs(), in "Level":
            rate * 0.5 => "the momentum is that of the spin about the axle, with m R^2 for a rim",
            1.0 / rate => "turn it over";
        /// level axle: rope from the vertical
        level_rope: rope, "rad", "after 3 s" => flat_rope, within bound, in "Level":
            rate * rate * p.lever / p.gravity => "the end of the axle is not on the vertical any more";
        /// level axle: pull of the rope
        pull: weight / cos(rope), "N", "after 3 s" => pull, within 10.0 * bound * weight, in "Level";
        /// risen axle: rate
        rate: risen, "rad/s", "after 3 s" => up_rate, within bound * risen.abs(), in "Risen":
            rate => "that is exact for a level axle only";
        /// risen axle: rope from the vertical
        rope: leaning, "rad", "after 3 s" => up_rope, within bound, in "Risen":
            rope => "the rate is another, and so is the lever";
        /// slow swing of the rope, as seen from the turning plane
        slow: slow.frequency, "rad/s", "simulated" => small(&slow, false)?, within 1e-6 * slow.frequency;
        /// fast swing of the rope, as seen from there
        fast: fast.frequency, "rad/s", "simulated" => small(&fast, false)?, within 1e-6 * fast.frequency;
        /// nutation
        nutation: nod.frequency, "rad/s", "simulated" => small(&nod, true)?, within 1e-6 * nod.frequency, in "Oscillations":
            wheel.momentum.abs() / wheel.at_end() => "that is about a fixed point; the end of the axle is free to move sideways";
        /// let go: how far the axle first dips
        dip: dip, "rad", "Lagrange" => again.state[2] - FRAC_PI_2, within bound, if turns, in "Let go":
            2.0 * fixed / l2 => "that is about a fixed point";
        /// let go: when
        dip_time: nods.t, "s", "Lagrange" => again.t, within bound, if turns;
        /// let go at rest: pull of the rope at that moment
        first_pull: weight * wheel.transverse / wheel.at_end(), "N", "tension by Lagrange" => at(0.0), within 1e-12 * weight, in "Let go":
            weight => "the hub begins to fall";
        /// push that makes the rope slack at once
        backward: back, "rad/s", "tension by Lagrange" => back - at(back) * back / weight, within 1e-12 * back.abs(), in "Let go";
        /// let go: when the rope goes slack
        slack: run.end_time(), "s", "Lagrange" => free.end_time(), within bound, if slack;
    }
}

/// Where one part hardly matters.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let wheel = Wheel::new(p);
    let fast = Wheel { momentum: 1e3 * wheel.momentum, ..wheel };
    let [slow, quick, nod] = fast.modes(fast.going(0.0)?)?;
    let short = Wheel { rope: 1e-4, ..fast };
    let swing = (p.gravity / p.rope).sqrt();
    let sideways = (wheel.transverse * wheel.at_end()).sqrt();
    let [rate, angle] = fast.steady(p.rise)?;
    let dip = angles(&fast.turning(0.0, 1e-14)?.state)[1] * -wheel.momentum * wheel.momentum * 1e6;
    let moment = 2.0 * p.mass * p.gravity * p.lever * wheel.transverse;
    limits! { report,
        /// the rope swings as if no wheel turned
        "fast spin: sum of the swings/(2 w)": (slow.frequency + quick.frequency) / (2.0 * swing) => 1.0, within 1e-4;
        /// seen from the turning plane
        "fast spin: their difference/(2 p)": (quick.frequency - slow.frequency) / (2.0 * fast.lecture().abs()) => 1.0, within 1e-3;
        /// upright the end of the axle is held, sideways it is not
        "fast spin: nutation": nod.frequency * sideways / fast.momentum.abs() => 1.0, within 1e-5;
        /// nothing leans, nothing nods
        "fast spin: rate/p": rate / fast.lecture() => 1.0, within 1e-4;
        /// its place is l cos(rise) from the vertical
        "fast spin: g delta/(p^2 l cos)": angle * p.gravity / (rate * rate * p.lever * cos(p.rise)) => 1.0, within 1e-4;
        /// it dips twice as far as where it would rest
        "fast spin: dip": dip / moment => 1.0, within 1e-4;
        /// the rope is a string that holds a point
        "no rope: tan(delta)": tan(short.steady(0.0)?[1]) * p.gravity / (short.lecture() * short.lecture() * p.lever) => 1.0, within 1e-6;
    }
}

/// Torque of air of this density over that of the weight, and the part of the spin that it leaves
/// after a turn about the rope, followed in time: the torque goes as the square of the spin, the
/// rate as one over it. The unit of time is that of a radian at the first rate.
fn braked(p: &Parameters, wheel: &Wheel, density: f64) -> Result<[f64; 2]> {
    let torque = 0.0066 * density * p.spin * p.spin * p.radius.powi(5);
    let slowing = torque / (wheel.momentum * wheel.steady(0.0)?[0]);
    let law = ode(|_, &[spin, _]: &[f64; 2]| [-slowing * spin * spin, 1.0 / spin])
        .scaled(size_or([1.0; 2]));
    let round = |&[_, turned]: &[f64; 2]| turned - 2.0 * PI;
    let (once, _) = Dop853::new(1e-13)?.zero(&law, [1.0, 0.0], 1, 7.0, round)?;
    Ok([slowing, once.state[0]])
}

/// What `--with air` adds: the spin s that is left, in parts of the first. As the wheel goes round
/// faster by 1/s, an angle costs s^3 of M/(L p), and 1/s^2 grows evenly with the angle.
fn blown(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(density) = p.air else { return Ok(()) };
    let [slowing, left] = braked(p, &Wheel::new(p), density)?;
    let spin = p.spin / (1.0 + 4.0 * PI * slowing).sqrt();
    claims! { report,
        /// in air: spin after a turn about the rope
        blown_spin: spin, "rad/s", "simulated" => left * p.spin, within 1e-10 * p.spin.abs();
    }
}

/// The card of effects; the rope is of nylon, 6 mm thick, as heavy as 25 g a metre.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let wheel = Wheel::new(p);
    let [rate, rope] = wheel.steady(0.0)?;
    let (mass, stretch) = (0.025 * p.rope / p.mass, p.mass * p.gravity / (1e9 * 0.25 * PI * 36e-6));
    let [slowing, spun] = braked(p, &wheel, 1.204)?;
    let bound = wheel.at_end() * rate / wheel.momentum;
    // tan(lean) g = rate^2 (lever + rope sin(lean)), by the length of the rope.
    let ((s, c), far) = (sincos(rope), rate * rate * p.rope / p.gravity);
    let left = 1.0 - far * c * c * c;
    let longer = far * s * c * c / left / rope;
    // By the mass of the rope: less by its mean weight, more by its centrifugal force.
    let heavier = s * c * (0.5 - far * c / 3.0) / left;
    let stretched = Wheel { rope: p.rope * (1.0 + stretch), ..Wheel::new(p) };
    effect_card! { report,
        "lean of the rope": "p^2 b/g" = rate * rate * p.rope / p.gravity, costs rope, "rad of the rope", included;
        "precession not slow": "J p/L" = bound, costs bound * tan(p.rise).abs(), "of the rate", included;
        "mass of the rope": "m_r/m" = mass, costs heavier * mass, "rad of the rope";
        "stretch of the rope": "mg/(E A)" = stretch, costs longer * stretch * rope, "rad of the rope",
            measured stretched.outward(rate, 0.0) - rope, within 1e-14;
        "air on the wheel": "M/(L p)" = slowing, costs 1.0 - 1.0 / (1.0 + 4.0 * PI * slowing).sqrt(),
            "of the spin a turn", measured 1.0 - spun;
        "turning of the Earth": "Omega_E/p" = 7.292e-5 / rate.abs(), costs 7.292e-5 / rate.abs(), "of the rate, at most";
    }
}

/// The accuracy strip: let go, for ten seconds, against Lagrange's equations.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let wheel = Wheel::new(p);
    let end = wheel.in_space(&after(10.0, &wheel.free(), &level(0.0), 1e-15)?);
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
    let run = move |step| {
        Dop853::new(step)?.solve(&wheel.hung(), 0.0, &wheel.in_space(&level(0.0)), 10.0, &[])
    };
    report.set_closed_form(ClosedForm::new(move |_| wheel.steady(0.5)));
    report.stepped(asked, run, Solution::work, move |run| {
        Ok(largest([0, 1, 6, 7, 8].map(|i| run.end_state()[i] - end[i])))
    })
}

example! {
    further_5_wheel_on_rope: "A further problem: a spinning wheel hung by its axle from a rope";
    "A wheel on a rope", "A spinning bicycle wheel whose axle hangs by one end from a rope.",
    [claims, blown, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
