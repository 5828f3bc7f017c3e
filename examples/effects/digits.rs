//! Which model before which digit: six motions, what each leaves out, and what a digit costs.

use super::Parameters;
use super::desk::{Spinner, gradient, gyroscope, on_the_earth, toy_top};
use super::weigh::{LeftOut, Question};
use core::f64::consts::{PI, TAU};
use kit::{Result, Table, short};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Effect, GravityGradient, InternalDissipation, Properties, Torque,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, ode, size_or};
use rotation_dynamics::math::{EPS, acos, log10, sincos};
use rotation_dynamics::scene::Scene;

/// A motion, with what it leaves out, the largest first.
pub struct Case {
    pub key: &'static str,
    pub name: &'static str,
    pub model: &'static str,
    pub left_out: Vec<LeftOut>,
    /// Evaluations and error of runs, coarse to fine.
    pub runs: Vec<(f64, f64)>,
    /// The error of the closed form, if there is one, rad.
    pub closed: Option<f64>,
}

impl Case {
    fn of<E: Effect + Clone>(
        names: [&'static str; 3],
        question: &Question<E>,
        exact: Option<Attitude>,
        mut left_out: Vec<LeftOut>,
    ) -> Result<Self> {
        let [key, name, model] = names;
        left_out.sort_by(|a, b| b.error.total_cmp(&a.error));
        let (scene, start, end) = (&question.scene, &question.start, question.end);
        let solved = scene.solve(start, end, 1e-4)?;
        let closed = exact.map(|_| solved.estimate);
        let exact = match exact {
            Some(exact) => exact,
            None => scene.solve(start, end, 1e-11)?.state.attitude,
        };
        let runs = question.runs(&exact)?;
        Ok(Self {
            key,
            name,
            model,
            left_out,
            runs,
            closed,
        })
    }

    /// Evaluations of the first run that comes so near (rad), with all after it.
    pub fn price(&self, error: f64) -> Option<f64> {
        let far = self.runs.iter().rposition(|(_, off)| *off > error);
        self.runs.get(far.map_or(0, |n| n + 1)).map(|run| run.0)
    }
}

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Case>> {
    Ok(vec![
        on_the_desk(
            ["gyroscope", "gyroscope, 10 s", "weight"],
            &gyroscope(p),
            "bearing",
        )?,
        on_the_desk(
            ["top", "toy top, 10 s", "weight, fixed tip"],
            &toy_top(),
            "drilling tip",
        )?,
        book()?,
        year()?,
        great_year()?,
        satellite()?,
    ])
}

/// A spinner on the desk for ten seconds; its dry friction goes by this name.
fn on_the_desk(names: [&'static str; 3], spinner: &Spinner, dry: &'static str) -> Result<Case> {
    let (scene, start) = spinner.scene()?;
    let (end, of_axis) = (10.0, true);
    let exact = scene.exact(&start)?.try_attitude(end)?;
    let q = Question {
        scene,
        start,
        end,
        of_axis,
    };
    let mut left_out = vec![
        q.left_out("air", spinner.air()?)?,
        q.left_out(dry, spinner.dry()?)?,
        q.left_out("buoyancy", spinner.buoyancy())?,
        q.left_out("turning Earth", on_the_earth())?,
        q.left_out("weaker above", gradient()?)?,
    ];
    if spinner.pivot > 0.0 {
        left_out.push(q.left_out("pivot", spinner.pivot())?);
    }
    Case::of(names, &q, Some(exact), left_out)
}

/// The book of the page on three different moments: half a kilogram, 21 by 14 by 2.5 cm,
/// thrown with 12 rad/s about its middle axis but for a tenth of a radian.
fn book() -> Result<Case> {
    let (mass, [l, w, d]): (f64, [f64; 3]) = (0.5, [0.21, 0.14, 0.025]);
    let moment = |a: f64, b: f64| mass / 12.0 * (a * a + b * b);
    let moments = [moment(w, d), moment(l, d), moment(l, w)];
    let body = RigidBody::new(PrincipalMoments::new(moments[0], moments[1], moments[2])?);
    let (s, c) = sincos(0.1);
    let momentum = moments[1] * 12.0;
    let rates = BodyVector::new(momentum * s / moments[0], momentum * c / moments[1], 0.0);
    let start = body.state(Attitude::IDENTITY, rates)?;
    let scene = Scene::new(body);
    let (end, of_axis) = (1.0, false);
    let exact = scene.exact(&start)?.attitude(end);
    // Each half of a plate that turns about an edge in its plane pushes air: coefficient 1.2.
    let push = |half: f64, along: f64| 0.5 * 1.204 * 1.2 * along * half * half * half * half / 2.0;
    let (short_way, long_way) = (push(0.5 * w, l), push(0.5 * l, w));
    let air = Torque::on_body("air", move |_t, body: &RigidBody, state: &State| {
        let [p, q, _] = body.angular_velocity(state).to_array();
        BodyVector::new(-short_way * p * p.abs(), -long_way * q * q.abs(), 0.0)
    });
    // Paper creaks: it bends at 50 Hz with a quality factor of 20.
    let bent = 12.0 / (TAU * 50.0);
    let creaks = InternalDissipation::new(bent * bent / 20.0 / momentum)?;
    let q = Question {
        scene,
        start,
        end,
        of_axis,
    };
    let left_out = vec![
        q.left_out("air", air)?,
        q.left_out("creaking", creaks)?,
        q.left_out("turning Earth", on_the_earth())?,
        q.left_out("weaker above", gradient()?)?,
    ];
    Case::of(
        ["book", "thrown book, 1 s", "nothing"],
        &q,
        Some(exact),
        left_out,
    )
}

/// The Earth of the notes: A and C over M R^2, which is the unit of its moments here.
const A: f64 = 0.329_591;
const C: f64 = 0.330_675;
const DAY: f64 = 86_164.090_5;
const YEAR: f64 = 365.25 * 86_400.0;
/// The tilt of the equator to the orbit, 84381.448 arcsec (IAU 1976).
const OBLIQUITY: f64 = 84_381.448 / 648_000.0 * PI;

/// sqrt(G m/r^3) of Sun and Moon (rad/s): period, and mass over that of itself and the Earth.
fn attractors() -> [f64; 2] {
    let rate = |days: f64, mass: f64| TAU / (days * 86_400.0) * mass.sqrt();
    [rate(365.256_363, 1.0), rate(27.321_661, 0.012_150_5)]
}

/// An Earth whose bulge follows its axis in part: across it, L turns the body as if A were
/// A + part (C - A).
#[derive(Clone)]
struct Yielding {
    part: f64,
}

impl Effect for Yielding {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        slips: true,
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "yielding mantle"
    }

    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    fn slip(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let [l1, l2, _] = body.angular_momentum(state).to_array();
        let (i1, i3) = (body.moments().i1(), body.moments().i3());
        let more = self.part * (i3 - i1);
        let less = -more / (i1 * (i1 + more));
        (state.attitude).to_space(BodyVector::new(less * l1, less * l2, 0.0))
    }
}

/// A free Earth whose pole is ten metres from its figure axis.
fn earth() -> Result<(Scene<()>, State)> {
    let body = RigidBody::new(PrincipalMoments::symmetric(A, C)?);
    let tilted = Attitude::about_space_axis(SpaceVector::new(1.0, 0.0, 0.0), OBLIQUITY)?;
    let spin = TAU / DAY;
    let start = body.state(tilted, BodyVector::new(spin * 10.0 / 6.371e6, 0.0, spin))?;
    Ok((Scene::new(body), start))
}

fn year() -> Result<Case> {
    let (scene, start) = earth()?;
    let (end, of_axis) = (YEAR, true);
    let exact = scene.exact(&start)?.attitude(end);
    let q = Question {
        scene,
        start,
        end,
        of_axis,
    };
    let normal = SpaceVector::new(0.0, 0.0, 1.0);
    let equinox = SpaceVector::new(1.0, 0.0, 0.0);
    let [sun, moon] = attractors();
    let on_orbit = |rate: f64, whole: f64| {
        // The Moon attracts with a part of what its mean motion would need.
        let part = (rate / whole) * (rate / whole);
        let orbit = GravityGradient::on_orbit(whole, normal, equinox)?;
        let torque = move |t, body: &RigidBody, state: &State| orbit.torque(t, body, state) * part;
        Ok::<_, rotation_dynamics::Error>(Torque::on_space("attracting body", torque).smooth())
    };
    // k_2 = 0.30 over k_s = 0.938.
    let yielding = Yielding { part: 0.30 / 0.938 };
    let left_out = vec![
        q.left_out(
            "torque of the Moon",
            on_orbit(moon, TAU / (27.321_661 * 86_400.0))?,
        )?,
        q.left_out("torque of the Sun", on_orbit(sun, sun)?)?,
        q.left_out("yielding mantle", yielding)?,
    ];
    Case::of(
        ["year", "Earth, a year", "nothing"],
        &q,
        Some(exact),
        left_out,
    )
}

/// 26,000 years, in which the equinoxes go round: too long to follow day by day, so the torque
/// is averaged over day and orbit: u' = -k (n u) n x u.
fn great_year() -> Result<Case> {
    let (scene, start) = earth()?;
    let end = 26_000.0 * YEAR;
    let spin = TAU / DAY;
    let k: f64 = attractors()
        .map(|n| 1.5 * n * n * (C - A) / (C * spin))
        .iter()
        .sum();
    let (s, c) = sincos(OBLIQUITY);
    // Time in units of the span.
    let law = ode(move |_, [x, y, z]: &[f64; 3]| [k * end * z * y, -k * end * z * x, 0.0])
        .scaled(size_or([1.0; 3]));
    let run = Dop853::new(1e-12)?.solve(&law, 0.0, &[0.0, -s, c], 1.0, &[])?;
    let mut largest = 0.0_f64;
    for n in 1..=400 {
        let [_, y, z] = run.at(f64::from(n) / 400.0)?;
        largest = largest.max(acos((c * z - s * y).clamp(-1.0, 1.0)));
    }
    let degrees = PI / 180.0;
    let left_out = vec![
        LeftOut::new("torque of Sun and Moon", largest, "averaged"),
        // The obliquity goes from 22.1 to 24.5 degrees and back in 41,000 years (Berger 1978).
        LeftOut::new("the orbit tilts", (24.5 - 22.1) * degrees, "literature"),
        // The constant of nutation, 9.2025 arcsec (IAU 1980).
        LeftOut::new(
            "the Moon's nodes go round",
            9.2025 / 3600.0 * degrees,
            "literature",
        ),
    ];
    let closed = scene.solve(&start, end, 1e-3)?.estimate;
    Ok(Case {
        key: "great_year",
        name: "Earth, 26,000 a",
        model: "nothing",
        left_out,
        runs: Vec::new(),
        closed: Some(closed),
    })
}

/// The satellite of the page on the library, askew by a hundredth of a radian.
fn satellite() -> Result<Case> {
    let n0 = 1.1e-3;
    let normal = SpaceVector::new(0.0, 0.0, 1.0);
    let down = SpaceVector::new(-1.0, 0.0, 0.0);
    let gradient = GravityGradient::on_orbit(n0, normal, down)?;
    let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
    let askew = Attitude::about_space_axis(normal, 0.01)?;
    let start = body.state(askew, BodyVector::new(0.0, 0.0, n0))?;
    let (scene, end, of_axis) = (Scene::new(body).with(gradient), 86_400.0, false);
    // Sunlight, 4.5e-6 N/m^2, on 4 m^2, 5 cm beside the centre of mass; 0.1 A m^2 in 3e-5 T.
    let light = 4.5e-6 * 4.0 * 0.05;
    let sunlight = Torque::on_space("sunlight", move |_, _, _| SpaceVector::new(0.0, 0.0, light));
    let magnet = Torque::on_space("magnet", move |_t, _body: &RigidBody, state: &State| {
        let magnet = state
            .attitude
            .to_space(BodyVector::new(0.1 * 3e-5, 0.0, 0.0));
        magnet.cross(&SpaceVector::new(0.0, 0.0, 1.0))
    });
    // An orbit of eccentricity 0.001: ahead by 2 e sin(n t), nearer by e cos(n t).
    let ellipse = Torque::on_space("ellipse", move |t, body: &RigidBody, state: &State| {
        let (s, c) = sincos(n0 * t);
        let there = gradient.torque(t + 2e-3 * s / n0, body, state) * (1.0 + 3e-3 * c);
        there - gradient.torque(t, body, state)
    });
    let q = Question {
        scene,
        start,
        end,
        of_axis,
    };
    let left_out = vec![
        q.left_out("sunlight", sunlight.smooth())?,
        q.left_out("magnet on board", magnet.smooth())?,
        q.left_out("orbit no circle", ellipse.smooth())?,
    ];
    Case::of(
        ["satellite", "satellite, a day", "gradient of gravity"],
        &q,
        None,
        left_out,
    )
}

/// The table: for each the largest three, what a digit is worth, and what it costs.
pub fn table(cases: &[Case]) -> Result<Table> {
    let columns = [
        "motion",
        "first left out",
        "then",
        "and then",
        "digits",
        "evaluations",
        "at most",
    ];
    let mut table = Table::new("digits", columns)?;
    for case in cases {
        let told = |n: usize| {
            case.left_out.get(n).map_or("-".to_owned(), |one| {
                format!("{}: {} rad, {}", one.name, short(one.error, 2), one.how)
            })
        };
        let least = case.left_out[0].error;
        let finest = case
            .runs
            .iter()
            .map(|run| run.1)
            .fold(f64::INFINITY, f64::min);
        let finest = case.closed.map_or(finest, |closed| closed.min(finest));
        let price = case
            .price(least)
            .map_or("-".to_owned(), |price| short(price, 2));
        table.push([
            format!("{}, with {}", case.name, case.model),
            told(0),
            told(1),
            told(2),
            short((-log10(least)).max(0.0), 2),
            price,
            short(-log10(finest.max(EPS)), 2),
        ])?;
    }
    Ok(table)
}
