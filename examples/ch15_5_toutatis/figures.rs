//! The drawings: how far off day by day, the way of the long axis, a flyby, and the forecast; and the
//! asteroid as it tumbles, with L upright, and as it was seen.

use super::*;
use kit::draw::smooth;

/// The day of December 1992 of a time after the epoch.
fn december(t: f64) -> f64 {
    (t + seconds(EPOCH) - seconds("1992-12-01T00:00:00")) / DAY + 1.0
}

/// A panel over the days of December 1992.
fn by_day(label: &str, highest: f64) -> Panel {
    let days = Axis::linear("day of December 1992").range(1.0, 20.0).step(5.0);
    Panel::over_axes(days, Axis::linear(label).range(0.0, highest).step(5.0))
}

figures! { p: &Parameters, start = published(p)?, motion = start.motion()?, (days, last) = observed()?,
        missed = misses(&start, in_closed_form)?, fit = best()?;
    /// Angle between computed and measured attitude on seventeen days of December 1992: dots between one and sixteen
    /// degrees without a trend for the published start, rings a little lower for the fitted one.
    off_by_day: {
        let over = |misses: &[f64]| {
            let at = days.iter().map(|day| december(day.t));
            at.zip(misses.to_vec()).collect::<Vec<_>>()
        };
        let published = Curve::new(over(&missed), Ink::Body).dots();
        let panel = by_day("attitude off by / deg", 18.0)
            .curve(published.label_at("published", 9.0, 15.6, Side::Right));
        let ring = |panel: Panel, (x, y)| panel.ring(x, y, Ink::Ink, "", Side::Above);
        let panel = over(&misses(&fit::start(&fit.at)?, in_closed_form)?).into_iter().fold(panel, ring);
        panel.note(13.6, 8.4, Ink::Ink, "rings: fitted", Side::Right)
    };

    /// Angle between computed and measured angular velocity on seventeen days of December 1992: all but two dots
    /// lie at five degrees or below, those of 7 and 14 December above twenty.
    spin_by_day: {
        let off = days.iter().map(|day| {
            let found = motion.kinematics(day.t);
            let space = |v: BodyVector| found.attitude.to_space(v);
            (december(day.t), angle_between(space(found.angular_velocity), space(day.angular_velocity)))
        });
        by_day("angular velocity off by / deg", 26.0).curve(Curve::new(off, Ink::Velocity).dots())
    };

    /// A sphere with the pole of the ecliptic on top. The long axis runs round the point opposite to L, twice in
    /// sixteen days, some fifty degrees from it; the measured axes lie on that path or beside it.
    long_axis: {
        let path = times(days[0].t, days[16].t, 200).map(|t| motion.attitude(t).axis());
        let momentum = motion.angular_momentum();
        let view = View::of(SpaceVector::zero(), 1.12).sphere().trace(path, Ink::Body)
            .ring(momentum * (-1.0 / momentum.norm()), Ink::Momentum, "$-L$", Side::Right);
        let seen = |view: View, day: &Observed| view.dot(day.attitude.axis(), Ink::Ink, "", Side::Above);
        days.iter().fold(view, seen)
    };

    /// Error of the attitude against days after the epoch, both logarithmic. Three rising lines: the fit to December,
    /// the periods of 2015, and lowest the printed digits. A level line at the mean of random attitudes. The measured
    /// misses of 1992 lie below ten degrees or near it, that of 2008 on the level of chance.
    forecast: {
        let [spin, _] = start.periods()?;
        let per_day = |error: f64| 360.0 * DAY * error / (spin * spin);
        let fitted = per_day(fit.deviations_of_periods()?[0]);
        let (published, digits) = (per_day(0.03 * DAY), moved::rounding(p, &start, last.t)?[0] / (last.t / DAY));
        let since = times(0.0, 3.8, 38).map(|x| pow(10.0, x));
        let line = |slope: f64| {
            Curve::of(since.clone().filter(move |t| slope * t >= 0.1), move |t| slope * t, Ink::Ink)
        };
        let misses = days.iter().zip(&missed).map(|(day, miss)| (day.t / DAY, *miss));
        let miss = motion.attitude(last.t).angle_to(&last.attitude).to_degrees();
        Panel::over_axes(
            Axis::log("days after the epoch").range(1.0, 6300.0),
            Axis::log("attitude off by / deg").range(0.1, 4000.0),
        )
            .curve(line(fitted).label_at("fit to 1992", 60.0, fitted * 60.0, Side::AboveLeft))
            .curve(line(published).dashed().label_at("±0.03 d", 8.0, published * 8.0, Side::BelowRight))
            .curve(line(digits).dotted().label_at("printed digits", 1500.0, digits * 1500.0, Side::AboveLeft))
            .level(at_random(), Ink::Frame, "")
            .note(1.2, at_random(), Ink::Frame, "chance", Side::AboveRight)
            .curve(Curve::new(misses, Ink::Body).dots())
            .dot(last.t / DAY, miss, Ink::Body, "2008", Side::BelowLeft)
    };

    /// Change of L, in thousandths, against days from the closest approach, for three directions of the Earth. All begin at zero,
    /// change within three days about the closest, and stay; by how much depends on the direction.
    passing: {
        let free = motion.angular_momentum();
        let clock: Vec<f64> = times(0.5, 12.0, 46).map(|t| t * DAY).collect();
        let mut panel = Panel::over_axes(
            Axis::linear("days from the closest").range(-6.0, 6.0),
            r"change of $L$ over $L$ / $10^{-3}$",
        );
        let dashes: [fn(Curve) -> Curve; 3] = [|curve| curve, Curve::dashed, Curve::dotted];
        for (path, dashes) in moved::phases(flyby(p)).take(6).step_by(2).zip(dashes) {
            let begin = path.when - 6.0 * DAY;
            let scene = Scene::new(start.body()?).with(tide(path, begin)?);
            let states = scene.solve_at(&motion.state(begin), &clock, 1e-7, &Default::default())?;
            let change = states.iter().map(|state| 1e3 * (state.angular_momentum - free).norm() / free.norm());
            let points = times(0.5, 12.0, 46).map(|t| t - 6.0).zip(change);
            let curve = Curve::new([(-6.0, 0.0)].into_iter().chain(points), Ink::Momentum);
            panel = panel.curve(dashes(curve.label_end(&format!("{:.0}°", path.angles[2].to_degrees()))));
        }
        panel
    };
}

/// Half of the lengths of the body along x, y and the long axis, over the last: 4.6 km in all.
const HALF_AXES: [f64; 3] = [0.52, 0.42, 1.0];

/// The body in this attitude, so many times as large.
fn body(attitude: &Attitude, size: f64) -> Solid {
    // Two lobes: the height along the long axis and the share of the width.
    let heights = [-1.0, -0.92, -0.72, -0.42, -0.1, 0.18, 0.34, 0.55, 0.78, 0.94, 1.0];
    let widths = [0.0, 0.42, 0.8, 1.0, 0.93, 0.68, 0.55, 0.66, 0.62, 0.36, 0.0];
    let outline: Vec<_> = heights.into_iter().zip(widths).collect();
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    Solid::turned(SpaceVector::zero(), up, &smooth(&outline)).carried(|at| {
        let [x, y, z] = HALF_AXES;
        attitude.to_space(BodyVector::new(x * at.x(), y * at.y(), z * at.z())) * size
    })
}

/// Its attitude and angular velocity through December 1992, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "t [s],phi [rad],theta [rad],zeta [rad],wx [rad/s],wy [rad/s],wz [rad/s]";
    let motion = Start::of(numbers(p))?.motion()?;
    Trajectory::sampled(columns.split(','), times(0.0, 40.0 * DAY, 800), |t| {
        let found = motion.kinematics(t);
        let EulerAngles { phi, theta, zeta } = found.attitude.euler_angles();
        let [x, y, z] = found.angular_velocity.to_array();
        Ok([t, phi, theta, zeta, x, y, z])
    })
}

/// The tumbling of December 1992 with L, the angular velocity, and the nearest image; below it
/// two components of the angular velocity, measured and computed.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (motion, (days, _)) = (Start::of(numbers(p))?.motion()?, observed()?);
    let up = upright(motion.angular_momentum())?;
    let per_day = (1.0 * DAY).to_degrees();
    let [from, to] = [days[0].t, days[16].t];
    let computed = |i: usize, ink| {
        let rate = |t| (december(t), motion.angular_velocity(t)[i] * per_day);
        Curve::new(times(from, to, 300).map(rate), ink)
    };
    let seen = |i: usize, ink| {
        let rate = |day: &Observed| (december(day.t), day.angular_velocity[i] * per_day);
        Curve::new(days.iter().map(rate), ink).dots()
    };
    let day = Axis::linear("day of December 1992").step(4.0);
    let graph = Panel::over_axes(day, Axis::linear("deg/d").step(50.0))
        .curve(computed(0, Ink::Velocity).label_end(r"$\Omega_x$"))
        .curve(computed(1, Ink::Ink).dashed().label_end(r"$\Omega_y$"))
        .curve(seen(0, Ink::Velocity))
        .curve(seen(1, Ink::Ink));
    let stills = [4, 8, 15].map(|i| december(days[i].t));
    MovingPicture::above(graph, december(from)..=december(to), stills, move |day| {
        let t = (day - december(0.0)) * DAY;
        let found = motion.kinematics(t);
        let shown = up * found.attitude;
        let off = |other: &Observed| (other.t - t).abs();
        let nearest = days.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let image = nearest.filter(|other| off(other) < 0.25 * DAY);
        let speed = shown.to_space(found.angular_velocity) * (0.6 * DAY);
        let (origin, momentum) = (SpaceVector::zero(), SpaceVector::new(0.0, 0.0, 1.3));
        let behind = ", and a grey silhouette behind it shows the attitude seen by radar";
        let alt = format!(
            "The asteroid on day {day:.1} of December 1992, its long axis {:.0} degrees from L, which points up; the angular \
             velocity leans beside it{}; below, two components of the angular velocity against time, measured values as dots.",
            acos(shown.axis().z().clamp(-1.0, 1.0)).to_degrees(),
            image.map_or("", |_| behind),
        );
        let view = View::of(SpaceVector::new(0.0, 0.0, 0.1), 1.3)
            .solid(body(&shown, 1.0), Ink::Body)
            .arrow(origin, momentum, Ink::Momentum, "$L$", Side::Right)
            .arrow(origin, speed, Ink::Velocity, r"$\Omega$", Side::Left);
        let ghost =
            |view: View, seen: &Observed| view.ghost(body(&(up * seen.attitude), 1.06), Ink::Ink);
        Ok((alt, image.into_iter().fold(view, ghost)))
    })
}
