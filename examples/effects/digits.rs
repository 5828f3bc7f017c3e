//! Which model before which digit: six motions, what each leaves out, and what a digit costs.

use super::*;
use core::f64::consts::{PI, TAU};
use rotation_dynamics::effects::{ElasticYielding, InternalDissipation, Torque};
use rotation_dynamics::math::{EPS, log10, sort_by_number};

/// An effect that a model leaves out: its name, the error of that (rad), and how it is known.
pub type LeftOut = (&'static str, (f64, &'static str));

/// A motion, with what it leaves out, the largest first.
pub struct Case {
    pub key: &'static str,
    /// With its model.
    name: &'static str,
    pub left_out: Vec<LeftOut>,
    /// Evaluations and error of runs, coarse to fine.
    pub runs: Vec<(f64, f64)>,
    /// The error of the closed form, if there is one, rad.
    closed: Option<f64>,
}

impl Case {
    fn of<E: Effect + Clone>(
        [key, name]: [&'static str; 2],
        question: &Question<E>,
        exact: Option<Attitude>,
        mut left_out: Vec<LeftOut>,
    ) -> Result<Self> {
        sort_by_number(&mut left_out, |(_, (error, _))| -error);
        let solved = |tolerance| (question.scene).solve(&question.start, question.end, tolerance);
        let estimate = solved(1e-4)?.estimate;
        let closed = exact.map(|_| estimate);
        let exact = match exact {
            Some(exact) => exact,
            None => solved(1e-11)?.state.attitude,
        };
        let runs = question.runs(&exact)?;
        Ok(Self { key, name, left_out, runs, closed })
    }

    /// Evaluations of the first run that comes so near (rad), with all after it.
    fn price(&self, error: f64) -> Option<f64> {
        let far = self.runs.iter().rposition(|(_, off)| *off > error);
        self.runs.get(far.map_or(0, |n| n + 1)).map(|run| run.0)
    }

    /// The smallest error of a run or of the closed form.
    fn finest(&self) -> f64 {
        let runs = self.runs.iter().map(|run| run.1);
        runs.chain(self.closed).fold(f64::INFINITY, f64::min)
    }
}

/// All of them.
pub fn all(p: &Parameters) -> Result<Vec<Case>> {
    let rotor = ["gyroscope", "gyroscope, 10 s, with weight"];
    let top = ["top", "toy top, 10 s, with weight, fixed tip"];
    Ok(vec![
        on_the_desk(rotor, &gyroscope(p), "bearing")?,
        on_the_desk(top, &toy_top(), "drilling tip")?,
        book()?,
        year()?,
        great_year()?,
        satellite()?,
    ])
}

/// A spinner on the desk for ten seconds; its dry friction goes by this name.
fn on_the_desk(names: [&'static str; 2], spinner: &Spinner, dry: &'static str) -> Result<Case> {
    let (scene, start) = spinner.scene()?;
    let q = Question::new(scene, start, 10.0).of_axis();
    let exact = scene.exact(&start)?.try_attitude(q.end)?;
    Case::of(names, &q, Some(exact), acting(&q, spinner, dry)?)
}

/// What acts on a spinner beside its weight.
pub fn acting(q: &Question<Weight>, spinner: &Spinner, dry: &'static str) -> Result<Vec<LeftOut>> {
    Ok(vec![
        ("air", q.error_without(spinner.air()?)?),
        (dry, q.error_without(spinner.dry()?)?),
        ("pivot", q.error_without(spinner.pivot())?),
        ("buoyancy", q.error_without(spinner.buoyancy())?),
        ("turning Earth", q.error_without(on_the_earth())?),
        ("weaker above", q.error_without(gradient()?)?),
    ])
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
    let q = Question::new(Scene::new(body), start, 1.0);
    let exact = q.scene.exact(&start)?.attitude(q.end);
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
    let left_out = vec![
        ("air", q.error_without(air)?),
        ("creaking", q.error_without(creaks)?),
        ("turning Earth", q.error_without(on_the_earth())?),
        ("weaker above", q.error_without(gradient()?)?),
    ];
    let names = ["book", "thrown book, 1 s, with nothing"];
    Case::of(names, &q, Some(exact), left_out)
}

/// The Earth of the notes: A and C over M R^2, which is the unit of its moments here.
const A: f64 = 0.329_591;
const C: f64 = 0.330_675;
/// How fast it turns among the stars, rad/s; day and year, s.
const SPIN: f64 = TAU / 86_164.090_5;
const DAY: f64 = 86_400.0;
const YEAR: f64 = 365.25 * DAY;
/// The tilt of the equator to the orbit, 84381.448 arcsec (IAU 1976).
const OBLIQUITY: f64 = 84_381.448 / 648_000.0 * PI;

/// sqrt(G m/r^3) of Sun and Moon, and their mean motions (rad/s): by the period, and the mass over
/// that of itself and the Earth.
fn attractors() -> [(f64, f64); 2] {
    [(365.256_363, 1.0_f64), (27.321_661, 0.012_150_5)].map(|(days, mass)| {
        let whole = TAU / (days * DAY);
        (whole * mass.sqrt(), whole)
    })
}

/// A free Earth whose pole is ten metres from its figure axis.
fn earth() -> Result<(Scene<()>, State)> {
    let body = RigidBody::new(PrincipalMoments::symmetric(A, C)?);
    let tilted = Attitude::about_space_axis(ASIDE, OBLIQUITY)?;
    let rates = BodyVector::new(SPIN * 10.0 / EARTH_RADIUS, 0.0, SPIN);
    Ok((Scene::new(body), body.state(tilted, rates)?))
}

fn year() -> Result<Case> {
    let (scene, start) = earth()?;
    let q = Question::new(scene, start, YEAR).of_axis();
    let exact = scene.exact(&start)?.attitude(q.end);
    let on_orbit = |(rate, whole): (f64, f64)| {
        // The Moon attracts with a part of what its mean motion would need.
        let part = (rate / whole) * (rate / whole);
        let orbit = GravityGradient::on_orbit(whole, UP, ASIDE)?;
        let torque = move |t, body: &RigidBody, state: &State| orbit.torque(t, body, state) * part;
        Ok::<_, kit::Error>(Torque::on_space("attracting body", torque).smooth())
    };
    let [sun, moon] = attractors();
    // k_2 = 0.30 over k_s = 0.938: this part of the bulge follows the axis.
    let yielding = ElasticYielding::following(0.30 / 0.938, scene.body(), SPIN)?;
    let left_out = vec![
        ("torque of the Moon", q.error_without(on_orbit(moon)?)?),
        ("torque of the Sun", q.error_without(on_orbit(sun)?)?),
        ("yielding mantle", q.error_without(yielding)?),
    ];
    let names = ["year", "Earth, a year, with nothing"];
    Case::of(names, &q, Some(exact), left_out)
}

/// 26,000 years, in which the equinoxes go round: too long to follow day by day, so the torque
/// is averaged over day and orbit: u' = -k (n u) n x u.
fn great_year() -> Result<Case> {
    let (scene, start) = earth()?;
    let end = 26_000.0 * YEAR;
    let k: f64 = attractors().map(|(n, _)| 1.5 * n * n * (C - A) / (C * SPIN)).iter().sum();
    let (s, c) = sincos(OBLIQUITY);
    // Time in units of the span.
    let law = ode(move |_, [x, y, z]: &[f64; 3]| [k * end * z * y, -k * end * z * x, 0.0])
        .scaled(size_or([1.0; 3]));
    let run = Dop853::new(1e-12)?.solve(&law, 0.0, &[0.0, -s, c], 1.0, &[])?;
    let turned = largest(sampled(times(0.0, 1.0, 400), |t| {
        let [_, y, z] = run.at(t)?;
        Ok(acos((c * z - s * y).clamp(-1.0, 1.0)))
    })?);
    // The obliquity goes from 22.1 to 24.5 degrees and back in 41,000 years (Berger 1978); the
    // constant of nutation is 9.2025 arcsec (IAU 1980).
    let degrees = PI / 180.0;
    let (tilts, nodes) = ((24.5 - 22.1) * degrees, 9.2025 / 3600.0 * degrees);
    let left_out = vec![
        ("torque of Sun and Moon", (turned, "averaged")),
        ("the orbit tilts", (tilts, "literature")),
        ("the Moon's nodes go round", (nodes, "literature")),
    ];
    Ok(Case {
        key: "great_year",
        name: "Earth, 26,000 a, with nothing",
        left_out,
        runs: Vec::new(),
        closed: Some(scene.solve(&start, end, 1e-3)?.estimate),
    })
}

/// The satellite of the page on the library, askew by a hundredth of a radian.
fn satellite() -> Result<Case> {
    let n0 = 1.1e-3;
    let gradient = GravityGradient::on_orbit(n0, UP, -ASIDE)?;
    let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
    let askew = Attitude::about_space_axis(UP, 0.01)?;
    let start = body.state(askew, BodyVector::new(0.0, 0.0, n0))?;
    let q = Question::new(Scene::new(body).with(gradient), start, DAY);
    // Sunlight, 4.5e-6 N/m^2, on 4 m^2, 5 cm beside the centre of mass; 0.1 A m^2 in 3e-5 T.
    let light = 4.5e-6 * 4.0 * 0.05;
    let sunlight = Torque::on_space("sunlight", move |_, _, _| UP * light);
    let magnet = Torque::on_space("magnet", |_t, _body: &RigidBody, state: &State| {
        let magnet = BodyVector::new(0.1 * 3e-5, 0.0, 0.0);
        state.attitude.to_space(magnet).cross(&UP)
    });
    // An orbit of eccentricity 0.001: ahead by 2 e sin(n t), nearer by e cos(n t).
    let ellipse = Torque::on_space("ellipse", move |t, body: &RigidBody, state: &State| {
        let (s, c) = sincos(n0 * t);
        let there = gradient.torque(t + 2e-3 * s / n0, body, state) * (1.0 + 3e-3 * c);
        there - gradient.torque(t, body, state)
    });
    let left_out = vec![
        ("sunlight", q.error_without(sunlight.smooth())?),
        ("magnet on board", q.error_without(magnet.smooth())?),
        ("orbit no circle", q.error_without(ellipse.smooth())?),
    ];
    let names = ["satellite", "satellite, a day, with gradient of gravity"];
    Case::of(names, &q, None, left_out)
}

/// The table: for each the largest three, what a digit is worth, and what it costs.
pub fn table(cases: &[Case]) -> Result<Table> {
    let columns = "motion, first left out, then, and then, digits, evaluations, at most";
    Table::of("digits", columns.split(", "), cases, |case| {
        let told = |n: usize| match case.left_out.get(n) {
            Some((name, (error, how))) => format!("{name}: {} rad, {how}", short(*error, 2)),
            None => "-".to_owned(),
        };
        let least = case.left_out[0].1.0;
        let price = case.price(least).map(|price| short(price, 2));
        Ok([
            case.name.to_owned(),
            told(0),
            told(1),
            told(2),
            short((-log10(least)).max(0.0), 2),
            price.unwrap_or("-".to_owned()),
            short(-log10(case.finest().max(EPS)), 2),
        ])
    })
}
