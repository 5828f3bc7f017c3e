//! The drawings of exercise 15.7; lengths over h. What moves is the cone of the parameters, the
//! figures show that of the page.

use super::cone::{drawn, placed, sweep};
use super::*;
use kit::draw::Camera;

/// The half angle of the page.
const ALPHA: f64 = 0.4;

/// How much more room a cone takes than that of the page: it is 1 wide and 2 tan(alpha) high. A
/// slender one takes as much.
fn size(a: f64) -> f64 {
    let [room, page] = [a, ALPHA].map(|a| hypot(1.0, 2.0 * tan(a)));
    (room / page).max(1.0)
}

/// A cone of this half angle with its vertex on a post, its rim on the table, and the circle of the
/// rim.
fn on_post(a: f64, attitude: &Attitude) -> View {
    let (o, vertex, size) = (SpaceVector::zero(), UP * tan(a), size(a));
    let view = View::of(UP * (0.3 * size), 1.25 * size)
        .camera(Camera::new(0.6, 0.3))
        .size(340, 260)
        .ground(o, 1.25 * size)
        .dashed(sweep(0.0, TAU, 1.0), Ink::Frame)
        .solid(Solid::rod(o, vertex, 0.025 * size), Ink::Frame);
    drawn(view, a, vertex, attitude)
}

figures! { _: &Parameters;
    /// A cone with a level axis; its vertex O is held at the top of a post, its rim stands on the table. The
    /// post is as high as the radius of the base. The axis points along rho and turns about the vertical Z at
    /// the rate Omega.
    setup: {
        let (rho, vertex) = (level(1.75), UP * tan(ALPHA));
        on_post(ALPHA, &placed(0.0, 1.75, 2.2)?)
            .arrow(vertex + rho * 1.02, vertex + rho * 1.4, Ink::Frame, r"$\hat\rho$", Side::Right)
            .arrow(vertex, vertex + UP * 0.75, Ink::Frame, "$Z$", Side::Right)
            .turn(sweep(0.2, 2.6, 0.3).map(|p| p + UP * (tan(ALPHA) + 0.5)), Ink::Velocity)
            .text(UP * (tan(ALPHA) + 0.5) - level(2.17) * 0.3, r"$\Omega$", Ink::Velocity, Side::Left)
            .dot(vertex, Ink::Ink, "$O$", Side::Left)
    };

    /// The same from the side: the axis of the cone is level, at the height h tan alpha of the post; its length
    /// is h, and the lowest line of its side makes the angle alpha with it.
    side: {
        let (r, o) = (tan(ALPHA), (0.0, tan(ALPHA)));
        Sketch::within((-0.75, 1.35), (-0.3, 1.3))
            .wall((-0.7, 0.0), (1.3, 0.0))
            .curve(Curve::new([(0.0, 0.0), o], Ink::Frame).width(3.0))
            .body([o, (1.0, 0.0), (1.0, 2.0 * r)], Ink::Body, 0.2)
            .curve(Curve::new([o, (1.0, r)], Ink::Body).thin().dashed())
            .angle(o, 0.42, (-ALPHA, 0.0), r"$\alpha$")
            .dimension((0.0, 1.0), (1.0, 1.0), "$h$", Side::Above)
            .dimension((-0.2, 0.0), (-0.2, r), r"$h\,\tan\,\alpha$", Side::Left)
            .dot(o, Ink::Ink, "$O$", Side::Above)
    };

    /// The cone in the upright plane through its axis. A dashed line leads from the lowest point of the rim to
    /// the vertex O on its post; omega points on along it, up and away from the cone, and is the sum of Omega
    /// upward and a spin along the axis. The angular momentum points steeper. The weight acts at three quarters
    /// of the axis, the table at the rim.
    vectors: {
        let r = tan(ALPHA);
        let (o, contact) = ((0.0, r), (1.0, 0.0));
        let [lx, lz] = angular_momentum(ALPHA).map(|l| 1.3 * l);
        let [along, up] = angular_velocity(ALPHA).map(|x| 0.34 * x);
        Sketch::within((-1.05, 1.45), (-0.45, 1.4))
            .wall((-1.0, 0.0), (1.4, 0.0))
            .curve(Curve::new([(0.0, 0.0), o], Ink::Frame).width(3.0))
            .body([o, contact, (1.0, 2.0 * r)], Ink::Body, 0.2)
            .curve(Curve::new([contact, (along, r + up)], Ink::Ink).thin().dashed())
            .curve(Curve::new([(along, r), (along, r + up), (0.0, r + up)], Ink::Frame).thin().dotted())
            .arrow_to(o, (0.0, r + up), Ink::Velocity, r"$\Omega$", Side::Right)
            .arrow_to(o, (along, r), Ink::Velocity, "spin", Side::Below)
            .arrow_to(o, (along, r + up), Ink::Velocity, r"$\omega$", Side::Above)
            .arrow_to(o, (lx, r + lz), Ink::Momentum, "$L$", Side::Above)
            .arrow_to((0.75, r), (0.75, r - 0.36), Ink::Force, "$Mg$", Side::Left)
            .arrow_to((1.06, 0.0), (1.06, 0.5), Ink::Force, "$N$", Side::Right)
            .dot((0.75, r), Ink::Ink, "", Side::Above)
            .dot(contact, Ink::Ink, "at rest", Side::BelowRight)
            .dot(o, Ink::Ink, "$O$", Side::BelowLeft)
    };

    /// Two cones seen from the side. One lies on the table, and omega points along its lowest line; the other
    /// has a level axis, and omega points along its lowest line too, which is aslant now. The second omega is
    /// the longer one, in proportion 1 to cos alpha.
    two_cones: {
        let (slant, scale) = (1.0 / cos(ALPHA), 0.36);
        let lying = |turn: f64, (x, y): (f64, f64)| {
            let at = |angle: f64| (x + slant * cos(angle - turn), y + slant * sin(angle - turn));
            [(x, y), at(0.0), at(2.0 * ALPHA)]
        };
        let arrow = |(x, y): (f64, f64), turn: f64, size: f64| [(x, y), (x - size * cos(turn), y + size * sin(turn))];
        let (first, second) = ((-1.35, 0.0), (1.3, tan(ALPHA)));
        let (one, two) = (scale / tan(ALPHA), scale / sin(ALPHA));
        Sketch::within((-2.5, 2.6), (-0.35, 1.35))
            .wall((-2.4, 0.0), (-0.1, 0.0))
            .wall((0.15, 0.0), (2.5, 0.0))
            .curve(Curve::new([(1.3, 0.0), second], Ink::Frame).width(3.0))
            .body(lying(0.0, first), Ink::Body, 0.2)
            .body(lying(ALPHA, second), Ink::Body, 0.2)
            .arrow_along(arrow(first, 0.0, one), Ink::Velocity)
            .arrow_along(arrow(second, ALPHA, two), Ink::Velocity)
            .text((first.0 - one, 0.0), r"$\Omega/\tan\,\alpha$", Ink::Velocity, Side::Above)
            .text(arrow(second, ALPHA, two)[1], r"$\Omega/\sin\,\alpha$", Ink::Velocity, Side::Above)
    };
}

/// Made to roll ever faster, evenly, from rest to the rate `LAST` in the time `END`; another cone
/// than that of the page to as much beyond the rate at which its joint begins to pull.
const END: f64 = 6.0;
const LAST: f64 = 12.0;

/// The rate, how far the axis has turned, and the force of the table over the weight, at `t`.
fn sped_up(p: &Parameters, t: f64) -> [f64; 3] {
    let last = p.rate.signum() * LAST * (lifting(p) / lifting(&Parameters::default()));
    let rate = last * t / END;
    let share = pressure(p.half_angle, p.height * rate * rate / p.gravity);
    [rate, 0.5 * last * t * t / END, share]
}

/// A circuit at the rate of the parameters, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "t [s], phi [rad], zeta [rad], rim x [m], rim y [m], rim z [m]";
    let all = times(0.0, TAU / p.rate.abs(), 240);
    Trajectory::sampled(columns.split(", "), all, |t| {
        let (turn, a) = (p.rate * t, p.half_angle);
        let mark = BodyVector::new(tan(a), 0.0, 1.0) * p.height;
        let [x, y, z] = rolled(a, turn)?.to_space(mark).to_array();
        Ok([t, turn, -turn / tan(a), x, y, z + p.height * tan(a)])
    })
}

/// Ever faster, with the forces that hold the cone up. In the end omega and L are as long beside
/// the cone as those of the cone of the page.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, a, page) = (p.clone(), p.half_angle, Parameters::default());
    let share = |t: f64| sped_up(&p, t)[2];
    let table = Curve::of(times(0.0, END, 120), share, Ink::Force);
    let joint = Curve::of(times(0.0, END, 120), |t| 1.0 - share(t), Ink::Force);
    let graph = Panel::over_axes("$t$ / s", Axis::linear("force$/Mg$").range(-0.4, 1.4))
        .level(0.0, Ink::Frame, "")
        .curve(table.label_at("table", 2.0, 0.84, Side::Above))
        .curve(joint.dashed().label_at("joint", 2.0, 0.3, Side::Above));
    let swift = size(a) * (sped_up(&page, END)[0] / sped_up(&p, END)[0].abs());
    MovingPicture::above(graph, 0.0..=END, [1.4, 3.3, END], move |t| {
        let [rate, turn, table] = sped_up(&p, t);
        let (rho, o, joint) = (level(turn + 3.45), UP * tan(a), 1.0 - table);
        let (way, pushes) = (["up", "down"][usize::from(joint < 0.0)], joint.abs());
        let [[x, y], [u, v]] = [angular_velocity(a), angular_momentum(a)];
        let steeper = ["less steep", "steeper"][usize::from(v * x < y * u)];
        let omega = match rate < 0.0 {
            true => "from the vertex to the lowest point of the rim",
            false => "from the lowest point of the rim through the vertex and on",
        };
        let alt = format!(
            "The cone after {t:.1} s, at {rate:.1} rad/s. Omega points {omega}, L {steeper}. The table presses up with {table:.2} of the weight, and the joint \
             pushes the vertex {way} with {pushes:.2} of it. Below, both forces against time."
        );
        let vector = |of: fn(f64) -> [f64; 2], scale: f64| {
            let ([along, up], [length, page]) =
                (of(a), [a, ALPHA].map(|a| hypot(of(a)[0], of(a)[1])));
            o + (rho * along + UP * up) * (scale * rate * (swift * (page / length)))
        };
        let (rim, beside) = (rho * (1.0 + 0.03 * size(a)), o - rho * (0.07 * size(a)));
        let lift = |force: f64| UP * (0.6 * force * size(a));
        let view = on_post(a, &rolled(a, turn + 3.45)?)
            .arrow(o, vector(angular_velocity, 0.028), Ink::Velocity, r"$\omega$", Side::Left)
            .arrow(o, vector(angular_momentum, 0.1), Ink::Momentum, "$L$", Side::Right)
            .arrow(rim, rim + lift(table), Ink::Force, "$N$", Side::Right)
            .arrow(beside, beside + lift(joint), Ink::Force, "", Side::Left)
            .dot(o, Ink::Ink, "", Side::Below);
        Ok((alt, view))
    })
}
