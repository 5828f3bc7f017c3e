//! The drawings of the page.

use super::*;
use core::f64::consts::PI;
use kit::draw::{Camera, Method};
use rotation_dynamics::attitude::{Attitude, EulerAngles};

/// Azimuth and elevation of the eye: the middle axis points to the reader.
const EYE: (f64, f64) = (0.4, 0.34);

/// A direction on the body's axes on the drawn sphere: 1 up, 2 to the reader, 3 to the right.
fn on_sphere([one, two, three]: [f64; 3]) -> SpaceVector {
    SpaceVector::new(two, three, one)
}

/// The sphere with the three axes.
fn sphere() -> View {
    let (eye, up) = (
        SpaceVector::new(-sin(EYE.0), cos(EYE.0), 0.0),
        SpaceVector::new(-sin(EYE.1) * cos(EYE.0), -sin(EYE.1) * sin(EYE.0), cos(EYE.1)),
    );
    let outline = times(0.0, TAU, 90).map(|turn| eye * cos(turn) + up * sin(turn));
    let axes = [
        ([1.0, 0.0, 0.0], "$1$", Side::Above),
        ([0.0, 1.0, 0.0], "$2$", Side::BelowLeft),
        ([0.0, 0.0, 1.0], "$3$", Side::Right),
    ];
    let view = View::of(SpaceVector::zero(), 1.3)
        .camera(Camera::new(EYE.0, EYE.1))
        .line(outline, Ink::Frame);
    axes.into_iter().fold(view, |view, (axis, label, side)| {
        let out = on_sphere(axis);
        view.arrow(out, out * 1.3, Ink::Body, label, side)
    })
}

/// A path on the sphere, in so many pieces.
fn path(run: &Solution<3>, pieces: u32) -> Result<Vec<SpaceVector>> {
    sampled(times(0.0, run.end_time(), pieces), |t| Ok(on_sphere(unit(run.at(t)?))))
}

/// The body's motion, for so long.
fn falling(body: &Lossy, aside: f64, time: f64) -> rotation_dynamics::Result<Solution<3>> {
    Dop853::new(1e-11)?.solve(&body.equations(), 0.0, &start(aside), time, &[])
}

/// The motion of the page, to some time beyond the separatrix.
fn shown(p: &Parameters, body: &Lossy) -> Result<Solution<3>> {
    Ok(falling(body, p.aside, 1.7 * body.fall(start(p.aside), 1e-12)?.end_time())?)
}

/// The body with as strong a loss as the page allows.
fn strong(body: &Lossy) -> Lossy {
    let [one, three] = body.gaps();
    let loss = ((one * three).sqrt() / 8.0).min(0.05);
    Lossy { loss, ..*body }
}

figures! { p: &Parameters, body = lossy(p)?, run = shown(p, &body)?;

    /// Energy over its least value against the nutation angle for a rod and for a plate of the
    /// same momentum. The rod's falls from 3 to 1 as its axis goes from
    /// upright to lying; the plate's rises from 1 to 2. Arrows point downhill along both.
    landscape: {
        let energy = |axial: f64| move |theta: f64| {
            let (s, c) = sincos(theta);
            (c * c / axial + s * s) * axial.max(1.0)
        };
        let (rod, plate) = (energy(1.0 / 3.0), energy(2.0));
        let down = |from: f64, to: f64| times(from, to, 60);
        Panel::over_axes(Axis::linear(r"nutation angle $\theta$ / rad").range(0.0, 1.6).step(0.4),
                Axis::linear("$E/E_{min}$").range(1.0, 3.0).step(0.5))
            .curve(Curve::of(down(0.0, FRAC_PI_2), rod, Ink::Energy).arrow(0.5).label_at("rod", 0.6, rod(0.6), Side::AboveRight))
            .curve(Curve::of(down(FRAC_PI_2, 0.0), plate, Ink::Energy).dashed().arrow(0.5).label_at("plate", 1.1, plate(1.1), Side::BelowRight))
    };

    /// Nutation angle against the time in units of tau. That of the satellite stays small,
    /// rises, and comes to a right angle; that of a flat body falls to nothing. Dots of the
    /// simulation lie on both lines.
    opening: {
        let quick = Opening::new(p)?.quickened();
        let (thin, end) = (Opening { axial: 1.0, transverse: 3.0, nutation: p.nutation, ..quick }.quickened(), 8.0);
        let flat = Opening { axial: 2.0, transverse: 1.0, nutation: 1.3, ..quick }.quickened();
        let dots = |o: Opening| sampled(times(0.5, end - 0.5, 7), |x| {
            Ok((x, o.run(x * o.tau(), 1e-9)?.angle))
        });
        let line = |o: Opening| Curve::of(times(0.0, end, 120), move |x| o.angle(x * o.tau()), Ink::Ink);
        Panel::over_axes(r"$t/\tau$", Axis::linear(r"nutation angle $\theta$ / rad").range(0.0, 1.6).step(0.4))
            .curve(line(thin).label_at("thin", 5.2, thin.angle(5.2 * thin.tau()), Side::Right))
            .curve(line(flat).dashed().label_at("flat", 1.6, flat.angle(1.6 * flat.tau()), Side::Right))
            .curve(Curve::new(dots(thin)?, Ink::Body).dots())
            .curve(Curve::new(dots(flat)?, Ink::Body).dots())
    };

    /// The sphere of the body with the two great circles of the separatrix. A curve winds
    /// outward about axis 1, from loop to loop, passes through the separatrix near an end of
    /// axis 2 and winds inward to an end of axis 3.
    spiral: {
        // On these circles the energy is that of the middle axis.
        let [one, three] = body.gaps();
        let lean = atan2(one.sqrt(), three.sqrt());
        let circle = |lean: f64| times(0.0, TAU, 90).map(move |turn| {
            let (s, c) = sincos(turn);
            on_sphere([s * cos(lean), c, s * sin(lean)])
        });
        sphere()
            .trace(circle(lean), Ink::Frame)
            .trace(circle(-lean), Ink::Frame)
            .trace(path(&run, 2400)?, Ink::Momentum)
            .dot(on_sphere(start(p.aside)), Ink::Momentum, "", Side::Right)
    };

    /// The part of L along axis 2 against time, with and without the loss. Without, it goes to
    /// and fro for ever in the same time. With it the flips follow one another more slowly
    /// until the separatrix, then faster and ever less wide.
    flips: {
        let free = Lossy { loss: 0.0, ..body };
        let steady = falling(&free, p.aside, run.end_time())?;
        let of = |run: &Solution<3>| sampled(times(0.0, run.end_time(), 900), |t| Ok((t, run.at(t)?[1])));
        Panel::over_axes("$tL/I_2$", Axis::linear("$L_2/L$").range(-1.0, 1.0).step(0.5))
            .upright(body.fall(start(p.aside), 1e-12)?.end_time(), Ink::Frame, "separatrix")
            .curve(Curve::new(of(&steady)?, Ink::Frame).thin().dashed())
            .curve(Curve::new(of(&run)?, Ink::Momentum))
    };

    /// Energy against time: a staircase, with a step at each flip and a tread in each wait,
    /// along a smooth line of the average. At the separatrix the treads are longest.
    staircase: {
        let aside = 0.3;
        let run = falling(&body, aside, 2.0 * body.fall(start(aside), 1e-12)?.end_time())?;
        let twice = |t: f64| Ok(body.above(&run.at(t)?) + 1.0);
        let top = body.above(&start(aside));
        let mean = sampled(times(0.0, 1.0, 60), |s| {
            let above = top * (1.0 - s * s * (2.0 - s * s)).max(1e-9);
            Ok((body.averaged_fall(top, above)?[0], above + 1.0))
        })?;
        Panel::over_axes("$tL/I_2$", "$2EI_2/L^2$")
            .level(1.0, Ink::Frame, "")
            .curve(Curve::sampled(times(0.0, run.end_time(), 900), twice, Ink::Energy)?.label_at("with the loss", 0.62 * run.end_time(), 1.0, Side::BelowLeft))
            .curve(Curve::new(mean, Ink::Ink).dashed())
    };

    /// The upper half of the sphere, about axis 1, is cut into spiral bands by two curves that
    /// come from the ends of axis 2. Dots and rings, in bands by turns, are
    /// starts that end about the plus and about the minus end of axis 3.
    basins: {
        let strong = strong(&body);
        let back = strong.edges(1.2)?;
        let curve = path(&back, 2400)?;
        let turned = curve.iter().map(|n| SpaceVector::new(-n.x(), -n.y(), n.z()));
        let view = sphere().trace(turned, Ink::Momentum).trace(curve.iter().copied(), Ink::Momentum);
        // Directions about axis 1 on the side of the reader.
        let grid = times(-0.9, 1.5, 5).flat_map(|turn| times(0.5, 1.3, 6).map(move |lean| {
            let ((s, c), (a, b)) = (sincos(lean), sincos(turn));
            [c, s * b, s * a]
        }));
        grid.filter(|n| strong.above(n) > 0.0).try_fold(view, |view, n| {
            let plus = strong.fall(n, 1e-10)?.end_state()[2] > 0.0;
            let mark = if plus { View::dot } else { View::ring };
            Ok::<_, rotation_dynamics::Error>(mark(view, on_sphere(n), Ink::Body, "", Side::Right))
        })?
    };

    /// Starts at which the end changes, against the loss, both on logarithmic axes: a ladder of
    /// straight lines with the slope one half. Dots, found by halving between starts, lie on
    /// the lines; a mark shows the body of the page between two of them.
    stripes: {
        let edges = |log: f64| {
            let tried = Lossy { loss: pow(10.0, log), ..body };
            let far = asin((12.0 * tried.toll() / body.gaps()[0]).sqrt().min(0.9));
            Ok((tried, tried.edge_angles(far)?))
        };
        let strongest = log(strong(&body).loss) / core::f64::consts::LN_10;
        let lines = sampled(times(-3.0, strongest, 24), edges)?;
        let axis = Axis::log("start off axis 2 / rad").range(0.04, 1.0);
        let mut panel = Panel::over_axes(Axis::log("$a L$").range(1e-3, 0.05), axis);
        for k in 0..12 {
            let line = lines.iter().filter_map(|(body, at)| Some((body.loss, *at.get(k)?)));
            panel = panel.curve(Curve::new(line.filter(|(_, at)| *at < 1.0), Ink::Ink).thin());
        }
        let tried = [-2.5, -2.0, -1.5].into_iter().filter(|log| *log <= strongest);
        for (tried, at) in sampled(tried, edges)? {
            let found = sampled(at.iter().copied().take(4), |at| Ok((tried.loss, tried.halved(0.97 * at, 1.03 * at)?)))?;
            panel = panel.curve(Curve::new(found, Ink::Body).dots());
        }
        panel.dot(p.loss, p.aside, Ink::Momentum, "the page's", Side::Left)
    };

    /// Error against evaluations of the loss, both on logarithmic axes, for the fixed time of
    /// forty radians. The splittings with the exact free part lie far to the left of DOP853,
    /// the farther the weaker the loss.
    cost: {
        let weak = Lossy { loss: 1e-3, ..body };
        let mut panel = Panel::over_axes(Axis::log("evaluations of the loss"), Axis::log("error / rad"));
        for (scheme, settings) in PRICED {
            let points = sampled(settings.iter().copied(), |fine| {
                let (error, work) = price(&weak, p.aside, scheme, fine)?;
                Ok((work.torques() as f64, error.max(1e-15)))
            })?;
            let method = scheme.map_or(Method::Dop853, |scheme| Method::named(scheme.name));
            let curve = method.curve(points.iter().copied()).with_dots();
            let (x, y) = points[points.len() - 1];
            panel = panel.curve(match scheme {
                Some(_) => curve.label_at(method.label(), x, y, Side::BelowLeft),
                None => curve.label_end(method.label()),
            });
        }
        panel
    };
}

/// Methods and settings of the last figure: steps, or errors of a step.
const PRICED: [(Option<Scheme>, &[f64]); 3] = [
    (Some(Scheme::STRANG), &[20.0, 40.0, 80.0, 160.0, 320.0, 640.0]),
    (Some(Scheme::ABA1064), &[5.0, 8.0, 12.0, 20.0, 32.0, 48.0]),
    (None, &[1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13]),
];

/// The body's motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let body = lossy(p)?;
    let run = shown(p, &body)?;
    let columns = ["t [I2/L]", "n1 [-]", "n2 [-]", "n3 [-]", "2 E I2/L^2 [-]"];
    Trajectory::of(&run, columns, 1200, |t, n| [t, n[0], n[1], n[2], 1.0 + body.above(&n)])
}

/// The satellite of the picture: its outline, with whips.
fn satellite(view: View, attitude: &Attitude, roll: f64) -> View {
    let place = |x: f64, y: f64, z: f64| attitude.to_space(BodyVector::new(x, y, z));
    let (s, c) = sincos(roll);
    let whip = |turn: f64| {
        let (x, y) = (cos(turn + roll), sin(turn + roll));
        [place(0.09 * x, 0.09 * y, -0.1), place(0.42 * x, 0.42 * y, -0.16)]
    };
    let seam = [place(0.092 * c, 0.092 * s, -0.85), place(0.092 * c, 0.092 * s, 0.7)];
    let [foot, shoulder, tip] = [-0.85, 0.7, 1.0].map(|z| place(0.0, 0.0, z));
    let hull = Solid::cylinder(foot, shoulder, 0.09).with(Solid::cone(shoulder, tip, 0.09));
    let view = view.solid(hull, Ink::Body).line(seam, Ink::Paper);
    (0..4).fold(view, |view, k| view.line(whip(0.5 * PI * f64::from(k)), Ink::Ink))
}

/// In the picture the axis precesses so often while the angle opens, and it rolls so many times
/// slower than it would.
const TURNS: f64 = 14.0;
const SLOWED: f64 = 40.0;

/// The satellite from its spin to its tumble, the loss as in so few turns.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let sat = Opening::new(p)?;
    let end = sat.to_go().max(0.0) + if sat.thin() { 2.5 } else { 4.0 };
    // In units of tau, with a precession that the eye can follow.
    let unit_time = Opening { rate: sat.rate.signum(), ..sat };
    let line = Curve::of(times(0.0, end, 200), move |x| unit_time.angle(x), Ink::Body);
    let axis = Axis::linear(r"$\theta$ / rad").range(0.0, 1.6).step(0.8);
    let graph = Panel::over_axes(r"$t/\tau$", axis).curve(line);
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.62 * end, end], move |x| {
        let place = |x: f64| (unit_time.angle(x), TAU * TURNS * x / end);
        let nose = |x: f64| {
            let (theta, phi) = place(x);
            let (s, c) = sincos(theta);
            SpaceVector::new(s * sin(phi), -s * cos(phi), c)
        };
        let (theta, phi) = place(x);
        let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 })?;
        // d zeta/d phi = cos(theta) (It - Ia)/Ia, and slowed.
        let lean = |theta: f64| log(tan(0.5 * theta));
        let turned = (lean(theta) - lean(unit_time.nutation)) * unit_time.rate.signum();
        let slower = (sat.transverse / sat.axial - 1.0) / SLOWED;
        let up = SpaceVector::new(0.0, 0.0, 1.0);
        let alt = format!(
            "{x:.1} tau after the start: a long thin satellite with four whips, its axis {:.0} degrees \
             from the upright L; a line shows where its nose has been; below, the angle against time.",
            theta.to_degrees()
        );
        let shown = (x - 1.4 * end / TURNS).max(0.0);
        let view = View::of(up * 0.05, 1.2)
            .trail(sampled(times(shown, x, 60), |x| Ok(nose(x)))?, Ink::Body)
            .vector(SpaceVector::zero(), up * 1.25, Ink::Momentum, "$L$", Side::Above);
        Ok((alt, satellite(view, &attitude, TAU * TURNS / end * slower * turned)))
    })
}
