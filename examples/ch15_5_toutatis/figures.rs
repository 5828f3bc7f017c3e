//! The drawings: how far off day by day, the way of the long axis, a flyby, and the forecast.

use super::*;
use kit::draw::{Axis, Curve, Ink, Panel, Side, View};
use kit::{Figure, times};
use rotation_dynamics::math::pow;

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let study = Study::new(p)?;
    Ok(vec![
        off_by_day(&study)?,
        spin_by_day(&study)?,
        long_axis(&study)?,
        forecast(p, &study)?,
        passing(p, &study)?,
    ])
}

/// The day of December 1992 of a time after the epoch.
pub fn december(t: f64) -> f64 {
    (t + seconds(EPOCH) - seconds("1992-12-01T00:00:00")) / DAY + 1.0
}

fn off_by_day(study: &Study) -> Result<Figure> {
    let over = |misses: &[f64]| {
        study
            .december
            .iter()
            .zip(misses.to_vec())
            .map(|(day, miss)| (december(day.t), miss))
            .collect::<Vec<_>>()
    };
    let alt = "Angle between computed and measured attitude on seventeen days of December 1992: dots between one and sixteen \
               degrees without a trend for the published start, rings a little lower for the fitted one.";
    let panel = Panel::new("off_by_day", alt)
        .x(Axis::linear("day of December 1992").range(1.0, 20.0).step(5.0))
        .y(Axis::linear("attitude off by / deg").range(0.0, 18.0).step(5.0))
        .curve(Curve::new(over(&study.misses), Ink::Body).dots().label_at(
            "published",
            9.0,
            15.6,
            Side::Right,
        ));
    let panel = over(&study.fitted_misses)
        .into_iter()
        .fold(panel, |panel, (x, y)| panel.ring(x, y, Ink::Ink, "", Side::Above));
    panel.note(13.6, 8.4, Ink::Ink, "rings: fitted", Side::Right).figure()
}

/// How far off the angular velocity is, in direction and in length.
fn spin_by_day(study: &Study) -> Result<Figure> {
    let motion = study.start.motion()?;
    let direction = |day: &Observed| {
        let found = motion.kinematics(day.t);
        let space = |v: BodyVector| found.attitude.to_space(v);
        angle_between(space(found.angular_velocity), space(day.angular_velocity))
    };
    let points = study.december.iter().map(|day| (december(day.t), direction(day)));
    let alt = "Angle between computed and measured angular velocity on seventeen days of December 1992: all but two dots \
               lie at five degrees or below, those of 7 and 14 December above twenty.";
    Panel::new("spin_by_day", alt)
        .x(Axis::linear("day of December 1992").range(1.0, 20.0).step(5.0))
        .y(Axis::linear("angular velocity off by / deg").range(0.0, 26.0).step(5.0))
        .curve(Curve::new(points, Ink::Velocity).dots())
        .figure()
}

/// The path of the long axis on the sphere of the sky, and the measured axes.
fn long_axis(study: &Study) -> Result<Figure> {
    let (motion, z) = (study.start.motion()?, BodyVector::new(0.0, 0.0, 1.0));
    let [from, to] = [study.december[0].t, study.december[16].t];
    let path = times(from, to, 200).map(|t| motion.attitude(t).to_space(z));
    let momentum = motion.angular_momentum();
    let pole = momentum * (-1.0 / momentum.norm());
    let alt = "A sphere with the pole of the ecliptic on top. The long axis runs round the point opposite to L, twice in \
               sixteen days, some fifty degrees from it; the measured axes lie on that path or beside it.";
    let view = View::new("long_axis", alt).sphere().trace(path, Ink::Body);
    let view = view.ring(pole, Ink::Momentum, "$-L$", Side::Right);
    let dots =
        |view: View, day: &Observed| view.dot(day.attitude.to_space(z), Ink::Ink, "", Side::Above);
    study.december.iter().fold(view, dots).figure()
}

/// How the error of a forecast grows with what is not known.
fn forecast(p: &Parameters, study: &Study) -> Result<Figure> {
    let [spin, _] = study.start.periods()?;
    let per_day = |error: f64| 360.0 * DAY * error / (spin * spin);
    let rounding = tables::rounding(p, study)?[0] / (study.last.t / DAY);
    let sd = study.deviation_of_period(0)?;
    let days = times(0.0, 3.8, 38).map(|x| pow(10.0, x));
    let line = |slope: f64, ink| {
        Curve::of(days.clone().filter(move |t| slope * t >= 0.1), move |t| slope * t, ink)
    };
    let dots = study.december.iter().zip(&study.misses).map(|(day, miss)| (day.t / DAY, *miss));
    let alt = "Error of the attitude against days after the epoch, both logarithmic. Three rising lines: the fit to December, \
               the periods of 2015, and lowest the printed digits. A level line at the mean of random attitudes. The measured misses of 1992 \
               lie below ten degrees or near it, that of 2008 on the level of chance.";
    let random = at_random();
    Panel::new("forecast", alt)
        .x(Axis::log("days after the epoch").range(1.0, 6300.0))
        .y(Axis::log("attitude off by / deg").range(0.1, 4000.0))
        .curve(line(per_day(sd), Ink::Ink).label_at(
            "fit to 1992",
            60.0,
            per_day(sd) * 60.0,
            Side::AboveLeft,
        ))
        .curve(line(per_day(0.03 * DAY), Ink::Ink).dashed().label_at(
            "±0.03 d",
            8.0,
            per_day(0.03 * DAY) * 8.0,
            Side::BelowRight,
        ))
        .curve(line(rounding, Ink::Ink).dotted().label_at(
            "printed digits",
            1500.0,
            rounding * 1500.0,
            Side::AboveLeft,
        ))
        .level(random, Ink::Frame, "")
        .note(1.2, random, Ink::Frame, "chance", Side::AboveRight)
        .curve(Curve::new(dots, Ink::Body).dots())
        .dot(study.last.t / DAY, last_miss(study)?, Ink::Body, "2008", Side::BelowLeft)
        .figure()
}

fn last_miss(study: &Study) -> Result<f64> {
    let found = study.start.motion()?.attitude(study.last.t);
    Ok(found.angle_to(&study.last.attitude).to_degrees())
}

/// How L changes while the Earth goes by, for four directions of the Earth.
fn passing(p: &Parameters, study: &Study) -> Result<Figure> {
    let (start, motion) = (study.start, study.start.motion()?);
    let free = motion.angular_momentum();
    let ends: Vec<f64> = times(0.5, 12.0, 46).collect();
    let alt = "Change of L, in thousandths, against days from the closest approach, for four directions of the Earth. All begin at zero, \
               change within three days about the closest, and stay; by how much depends on the direction.";
    let mut panel = Panel::new("passing", alt)
        .x(Axis::linear("days from the closest").range(-6.0, 6.0))
        .y(Axis::linear("change of $L$ over $L$ / $10^{-3}$"));
    for (path, dash) in tables::phases(flyby(p)).take(6).step_by(2).zip(0..) {
        let begin = path.when - 6.0 * DAY;
        let scene = Scene::new(start.body()?).with(tide(path, begin)?);
        let clock: Vec<f64> = ends.iter().map(|t| t * DAY).collect();
        let states = scene.solve_at(&motion.state(begin), &clock, 1e-7, &Default::default())?;
        let change =
            states.iter().map(|state| 1e3 * (state.angular_momentum - free).norm() / free.norm());
        let points: Vec<_> = ends.iter().map(|t| t - 6.0).zip(change).collect();
        let label = format!("{:.0}°", path.angles[2].to_degrees());
        let curve =
            Curve::new([(-6.0, 0.0)].into_iter().chain(points), Ink::Momentum).label_end(&label);
        panel = panel
            .curve([curve.clone(), curve.clone().dashed(), curve.dotted()][dash as usize].clone());
    }
    panel.figure()
}
