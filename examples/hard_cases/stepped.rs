//! What moves where something is stepped: torques, contacts, impacts, and steps that are too long.

use super::motions::DOP853;
use super::pictures::{THIRD, TIME, ZERO, axes, graph, picture};
use super::*;

/// A wheel that turns by `exact` and, dashed, by `wrong`.
fn wheels(exact: f64, wrong: f64) -> Sketch {
    let spoke = |angle: f64| (cos(angle), sin(angle));
    Sketch::within((-1.7, 1.7), (-1.15, 1.15))
        .disc((0.0, 0.0), 1.0, Ink::Body, 0.2)
        .arrow_along([(0.0, 0.0), spoke(exact)], Ink::Body)
        .curve(Curve::new([(0.0, 0.0), spoke(wrong)], Ink::Wrong).dashed())
        .dot(spoke(wrong), Ink::Wrong, "", Side::Right)
        .text((-1.65, -0.95), "exact", Ink::Body, Side::Right)
        .text((1.65, -0.95), "wrong", Ink::Wrong, Side::Left)
}

/// A bell of torque, a hundredth of a second wide, between two looks of RK4 in steps of 0.2 s.
pub fn bell() -> Result<MovingPicture> {
    const H: f64 = 0.2;
    let (centre, width, gain) = (5.05, 0.01, 50.0 / 1.6);
    let torque = move |t: f64| gain * exp(-0.5 * pow((t - centre) / width, 2.0));
    // Its area, as if it came all at once.
    let jump = gain * width * TAU.sqrt();
    // The torque knows the time alone: the four stages of RK4 are Simpson's rule.
    let mut seen = vec![[0.0, 2.0]];
    for n in 0..50 {
        let (t, [turned, spin]) = (H * f64::from(n), seen[n as usize]);
        let [a, b, c] = [0.0, 0.5, 1.0].map(|part| torque(t + part * H));
        let next = spin + H / 6.0 * (a + 4.0 * b + c);
        seen.push([turned + H * spin + H * H / 6.0 * (a + 2.0 * b), next]);
    }
    picture(
        axes(TIME, r"$\Omega_3$ / (rad/s)", [1.5, 3.0, 0.5]),
        (10.0, 400),
        [4.0, 7.0],
        // The angles turned and the spins.
        move |t| {
            let angle = 2.0 * t + jump * (t - centre).max(0.0);
            let spin = 2.0 + if t > centre { jump } else { 0.0 };
            Ok([[angle, spin], seen[((t / H).round() as usize).min(50)]])
        },
        |both| both.map(|[_, spin]| spin),
        |t, both| {
            let alt = format!(
                "A wheel with a mark after {t:.0} s, and dashed where RK4 has the mark; below, the spin against time, which jumps \
                 after five seconds, and the one by RK4, which does not."
            );
            let [exact, wrong] = both.map(|[angle, _]| angle + FRAC_PI_2);
            (alt, wheels(exact, wrong))
        },
    )
}

/// A top that just gets up, and a tight run of DOP853 that was believed.
pub fn risen() -> Result<MovingPicture> {
    let motion = findings::gets_up()?;
    let grid: Vec<f64> = times(0.0, motion.end, 160).collect();
    let step = grid[1];
    let path = sampled(grid, |t| {
        let at = motion.until(t);
        let run = at.reached(DOP853, QUATERNION, 0.0)?;
        Ok([at.truth_as_given(QUATERNION)?, run].map(|a| a.to_space(THIRD)))
    })?;
    picture(
        axes(TIME, "height of the tip", [-1.05, 1.05, 1.0]),
        (motion.end, 160),
        [20.0, 76.0],
        move |t| Ok(path[((t / step).round() as usize).min(path.len() - 1)]),
        |axes| axes.map(|axis| axis.z()),
        |t, [truth, naive]| {
            let alt = format!(
                "A top {t:.0} s after a push that just lifts it to the vertical, and dashed the axis by one run of DOP853; \
                 below, the height of its tip against time."
            );
            let scene = View::of(ZERO, 1.2)
                .camera(Camera::new(0.9, 0.3))
                .sphere()
                .solid(Solid::top(ZERO, truth, 1.0, 0.3), Ink::Body)
                .arrow(ZERO, naive, Ink::Wrong, "wrong", Side::Left);
            (alt, scene)
        },
    )
}

/// The height of a ball that returns with half of its speed: bounce n is at 3 - 4/2^n s, and what
/// follows lasts 2/2^n s.
fn bouncing(t: f64) -> f64 {
    if t < 1.0 {
        return 5.0 - 5.0 * t * t;
    }
    let (mut from, mut lasts) = (1.0, 1.0);
    while lasts > 1e-6 {
        if t < from + lasts {
            return 5.0 * (t - from) * (from + lasts - t);
        }
        (from, lasts) = (from + lasts, 0.5 * lasts);
    }
    0.0
}

/// That ball, and one that is looked at every 0.1 s.
pub fn bounces() -> Result<MovingPicture> {
    const H: f64 = 0.1;
    let (mut y, mut v, mut seen) = (5.0, 0.0, vec![5.0]);
    for _ in 0..50 {
        (y, v) = (y + H * v - 5.0 * H * H, v - 10.0 * H);
        if y < 0.0 {
            (y, v) = (0.0, -0.5 * v);
        }
        seen.push(y);
    }
    picture(
        axes(TIME, "height / m", [0.0, 5.0, 1.0]),
        (5.0, 400),
        [1.7, 2.2],
        move |t| {
            let (n, part) = ((t / H).floor().min(49.0), t / H);
            let [a, b] = [seen[n as usize], seen[n as usize + 1]];
            Ok([bouncing(t), a + (b - a) * (part - n)])
        },
        |heights| *heights,
        |t, [exact, naive]| {
            let alt = format!(
                "A ball over a floor {t:.1} s after it was let go, and a ring where the one is that was looked at ten times a \
                 second; below, both heights against time."
            );
            let scene = Sketch::within((-4.0, 4.0), (-0.6, 5.4))
                .wall((3.0, 0.0), (-3.0, 0.0))
                .disc((-0.6, exact + 0.25), 0.25, Ink::Body, 1.0)
                .text((-0.95, exact + 0.3), "exact", Ink::Body, Side::Left)
                .ring((0.6, naive + 0.25), Ink::Wrong, "wrong", Side::Right);
            (alt, scene)
        },
    )
}

/// A body of 1e17 kg runs into one of 1 kg, whose speed is taken from what is left of the energy.
pub fn pushed() -> Result<MovingPicture> {
    const MASS: f64 = 1e17;
    let exact = impacts::SPEED * 2.0 * MASS / (MASS + 1.0);
    let speeds = [exact, impacts::by_energy(MASS, 1.0)];
    picture(
        axes(TIME, "way of the light one / m", [0.0, 8.0, 2.0]),
        (3.0, 150),
        [0.5, 2.0],
        move |t| Ok(speeds.map(|speed| (t - 1.0).max(0.0) * speed)),
        |places| *places,
        |t, [exact, naive]| {
            let alt = format!(
                "A large block and a small one on a line after {t:.1} s, one second after which they meet, and a ring where the small \
                 one is by what is left of the energy; below, its way against time, exact and wrong."
            );
            let block = |x: f64, half: f64| {
                let (left, right, high) = (x - half, x + half, 2.0 * half);
                [(left, 0.0), (right, 0.0), (right, high), (left, high)]
            };
            let heavy = block(impacts::SPEED * (t - 1.0) - 1.0, 0.8);
            let scene = Sketch::within((-3.0, 8.0), (-0.8, 3.2))
                .wall((8.0, 0.0), (-3.0, 0.0))
                .body(heavy, Ink::Frame, 0.3)
                .body(block(exact, 0.2), Ink::Body, 1.0)
                .text((exact, 0.5), "exact", Ink::Body, Side::Above)
                .ring((naive, 0.2), Ink::Wrong, "wrong", Side::Below);
            (alt, scene)
        },
    )
}

/// A wheel that is braked at once, and what RK4 makes of it with steps of 3 over the rate.
pub fn braked() -> Result<MovingPicture> {
    let (rate, z) = (2.0, 3.0);
    let (grown, h) = (stability::factor(z), z / rate);
    let steps = move |t: f64| (t * rate / z).floor();
    let spins = graph(
        axes(TIME, r"$\Omega_3$ / (rad/s)", [0.0, 9.0, 3.0]),
        times(0.0, 10.5, 300),
        |t| Ok([exp(-rate * t), pow(grown, steps(t))]),
        |spins| *spins,
    )?;
    MovingPicture::above(spins, 0.0..=10.4, [1.0, 9.5], move |t| {
        let alt = format!(
            "A wheel that is braked, after {t:.1} s: its mark stands, and dashed the one of RK4 with too long a step turns ever \
             faster; below, the spins against time."
        );
        // The angle at the last step and what its spin makes since.
        let n = steps(t);
        let angle = h * (pow(grown, n) - 1.0) / (grown - 1.0) + pow(grown, n) * (t - n * h);
        Ok((alt, wheels((1.0 - exp(-rate * t)) / rate, angle)))
    })
}
