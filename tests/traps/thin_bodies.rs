//! Needles, discs, near spheres and plates cost what a motion asks for, not what a moment does.
//!
//! The truth is Euler's equations in attitude and rates (q, omega), stepped finely; the other kind of
//! variables is the attitude with L on the fixed axes (q, L), those of a [`Scene`].

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityGradient, Torque, ViscousFriction};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::sin;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use support::{Errors, Random, assert_largest, assert_table};

/// A scene in attitude and rates: q' = q (0, omega)/2, I omega' = (I omega) x omega + torque.
struct InRates<'s, E> {
    scene: &'s Scene<E>,
    rate: f64,
}

impl<E: Effect> Ode<7> for InRates<'_, E> {
    fn derivative(&self, t: f64, y: &[f64; 7]) -> [f64; 7] {
        let [w, x, y1, z, p, q, r] = *y;
        let [i1, i2, i3] = self.scene.body().moments().to_array();
        let attitude = Attitude::from_quaternion([w, x, y1, z]).expect("a quaternion");
        let momentum = attitude.to_space(BodyVector::new(i1 * p, i2 * q, i3 * r));
        let state = State::new(attitude, momentum).expect("finite");
        let [a, b, c] = attitude.to_body(self.scene.torque(t, &state)).to_array();
        [
            0.5 * (-x * p - y1 * q - z * r),
            0.5 * (w * p + y1 * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y1 * p),
            ((i2 - i3) * q * r + a) / i1,
            ((i3 - i1) * r * p + b) / i2,
            ((i1 - i2) * p * q + c) / i3,
        ]
    }

    fn scale(&self, _: &[f64; 7]) -> [f64; 7] {
        let rate = self.rate;
        [1.0, 1.0, 1.0, 1.0, rate, rate, rate]
    }
}

/// A body, its start without rotation of its axes, and a span.
struct Case<E> {
    scene: Scene<E>,
    rates: [f64; 3],
    t_end: f64,
}

impl<E: Effect> Case<((), E)> {
    fn new([i1, i2, i3]: [f64; 3], rates: [f64; 3], effect: E, t_end: f64) -> Self {
        let moments = PrincipalMoments::new(i1, i2, i3).expect("a body");
        Self { scene: Scene::new(RigidBody::new(moments)).with(effect), rates, t_end }
    }
}

impl<E: Effect> Case<E> {
    /// The axes of body and space agree, so L = I omega without rounding between axes.
    fn start(&self) -> State {
        let rates = BodyVector::from_array(self.rates);
        (self.scene.body().state(Attitude::IDENTITY, rates)).expect("a start")
    }

    /// The attitude at the end by (q, omega) with this error of a step, and the derivatives taken.
    fn in_rates(&self, tolerance: f64) -> Result<(Attitude, u64)> {
        let [p, q, r] = self.rates;
        let rate = BodyVector::from_array(self.rates).norm();
        let ode = InRates { scene: &self.scene, rate };
        let start = [1.0, 0.0, 0.0, 0.0, p, q, r];
        let method = Dop853::new(tolerance)?;
        let ([w, x, y, z, ..], work) = method.advance(&ode, 0.0, &start, self.t_end)?;
        Ok((Attitude::from_quaternion([w, x, y, z])?, work.derivatives))
    }

    /// The same by (q, L), unless it takes more than so many steps.
    fn in_momentum(&self, tolerance: f64, steps: u64) -> Result<(Attitude, u64)> {
        let method = Dop853::new(tolerance)?.with_step_limit(steps)?;
        let start = components(&self.start());
        let (end, work) = method.advance(&self.scene, 0.0, &start, self.t_end)?;
        Ok((state(&end)?.attitude, work.derivatives))
    }

    /// The derivatives of the cheapest run of both kinds that comes so near to the truth, and those of
    /// this run with one forty times coarser beside it: the least that shows its error.
    fn cheapest(&self, truth: &Attitude, error: f64) -> [u64; 2] {
        let first = |run: &dyn Fn(f64) -> Result<(Attitude, u64)>| {
            (2..15).find_map(|digits: u8| {
                let tolerance = 10_f64.powi(-i32::from(digits));
                let (end, fine) = run(tolerance).ok()?;
                let (_, coarse) = run(40.0 * tolerance).ok()?;
                (end.angle_to(truth) <= error).then_some([fine, fine + coarse])
            })
        };
        let rates = first(&|tolerance| self.in_rates(tolerance)).expect("a fine run");
        let dearest = rates[0] / 12 + 100;
        let momentum = first(&|tolerance| self.in_momentum(tolerance, dearest));
        momentum.map_or(rates, |momentum| core::array::from_fn(|i| momentum[i].min(rates[i])))
    }
}

/// What a table of cases shows of `solve`: the error over the one asked for; the derivatives of the
/// run that is returned over those of the cheapest run of both kinds that is as good; the
/// derivatives of all runs over those of the cheapest two that show as good an error.
struct Table {
    refused: usize,
    error: Errors,
    run: Errors,
    all: Errors,
}

impl Table {
    fn of(shapes: &str) -> Self {
        let errors = |what| Errors::of(format!("{shapes}, {what}"));
        Self {
            refused: 0,
            error: errors("error over the one asked for"),
            run: errors("work of the run over the cheapest"),
            all: errors("work of all runs over the cheapest two"),
        }
    }

    fn add<E: Effect>(&mut self, case: &Case<E>, tolerance: f64) {
        let what = (case.scene.body().moments().to_array(), case.rates, case.t_end, tolerance);
        let solved = match case.scene.solve(&case.start(), case.t_end, tolerance) {
            Ok(solved) => solved,
            Err(Error::NotDelivered { condition: Some(_), .. }) => {
                self.refused += 1;
                return;
            }
            Err(error) => panic!("{what:?}: {error}"),
        };
        let (truth, _) = case.in_rates(1e-14).expect("a motion");
        let error = solved.state.attitude.angle_to(&truth);
        // What the truth itself may be off by.
        let [cheapest, two] = (case.cheapest(&truth, error.max(1e-12))).map(|n| n as f64);
        self.error.push_at(error / tolerance, what);
        self.run.push_at(solved.run.torques() as f64 / cheapest, what);
        self.all.push_at(solved.work.torques() as f64 / two, what);
    }
}

fn gradient() -> GravityGradient {
    let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
    GravityGradient::on_orbit(1.1e-3, normal, towards).expect("a low orbit")
}

fn friction(moments: [f64; 3]) -> ViscousFriction {
    ViscousFriction::isotropic(1e-4 * moments.into_iter().fold(f64::INFINITY, f64::min))
        .expect("friction")
}

fn motor(moments: [f64; 3]) -> impl Effect {
    let least = moments.into_iter().fold(f64::INFINITY, f64::min);
    let torque = move |t, _: &RigidBody, _: &State| {
        SpaceVector::new(1e-7 * least, 3e-7 * least * sin(0.003 * t), 0.0)
    };
    Torque::on_space("motor", torque).smooth()
}

const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Of both kinds of variables the better one is taken: the run that is returned never costs more than
/// 2.6 times the cheapest of both kinds that is as good. To 1e-9 needles are refused: the momentum of a state
/// is on the fixed axes, where rounding blurs the spin about the thin axis. All runs together cost at most 5.2 times the
/// cheapest two that show as good an error.
#[test]
fn shapes_effects_and_tolerances() {
    let shapes = [
        ("needle", [0.01, 100.0, 100.0], 3),
        ("needle that is not round", [0.01, 100.0, 100.005], 2),
        ("strip", [1e-4, 1.0, 1.0001], 1),
        ("thin disc", [1.0, 0.5, 0.50001], 0),
        ("near sphere", [1.0, 1.0001, 1.0002], 0),
        ("plate", [0.3, 0.7, 1.0], 0),
    ];
    let rates = [0.002, 0.01, 0.003];
    let tables = shapes.map(|(shape, moments, refused)| {
        let mut table = Table::of(shape);
        for tolerance in TOLERANCES {
            table.add(&Case::new(moments, rates, gradient(), 8640.0), tolerance);
            table.add(&Case::new(moments, rates, friction(moments), 8640.0), tolerance);
            table.add(&Case::new(moments, rates, motor(moments), 8640.0), tolerance);
        }
        assert_eq!(table.refused, refused, "{shape}");
        assert!(table.error.largest() <= 0.07, "{shape}: {}", table.error.largest());
        table
    });
    assert_table!(tables.iter().flat_map(|table| [&table.run, &table.all]), @"
    needle, work of the run over the cheapest: 2.03 of 6
    needle, work of all runs over the cheapest two: 3.01 of 6
    needle that is not round, work of the run over the cheapest: 2.45 of 7
    needle that is not round, work of all runs over the cheapest two: 5.14 of 7
    strip, work of the run over the cheapest: 1.62 of 8
    strip, work of all runs over the cheapest two: 2.56 of 8
    thin disc, work of the run over the cheapest: 1.37 of 9
    thin disc, work of all runs over the cheapest two: 2.31 of 9
    near sphere, work of the run over the cheapest: 1.08 of 9
    near sphere, work of all runs over the cheapest two: 1.18 of 9
    plate, work of the run over the cheapest: 1.31 of 9
    plate, work of all runs over the cheapest two: 1.61 of 9
    ");
}

/// Once over budget after 4.5e7 torques.
#[test]
fn a_needle_under_gravity_gradient_for_a_day() {
    let rates = [0.0, 0.01, 0.0];
    let mut table = Table::of("needle");
    let needle = Case::new([0.01, 100.0, 100.0], rates, gradient(), 86_400.0);
    for tolerance in [1e-2, 1e-6] {
        table.add(&needle, tolerance);
        table.add(&Case::new([0.01, 100.0, 100.005], rates, gradient(), 8640.0), tolerance);
    }
    assert!(table.refused == 0 && table.error.largest() <= 1.0);
    assert_largest!(table.run, 4, @"1.98");
    assert_largest!(table.all, 4, @"4.16");
    // The damaged twin: with L on the fixed axes it takes ten times the steps.
    let (_, derivatives) = needle.in_rates(1e-10).expect("a fine run");
    let steps = 10 * derivatives / 12;
    assert!(matches!(
        needle.in_momentum(1e-10, steps),
        Err(Error::LimitReached { what: "steps", .. })
    ));
}

/// The closed form judges what is stepped; once over budget, or 8.9e6 torques and more.
#[test]
fn slender_bodies_without_torque() {
    let cases = [
        ([0.01, 100.0, 100.005], [0.001, 0.01, 0.0], 86_400.0),
        ([0.01, 100.0, 100.005], [0.0, 0.01, 0.001], 86_400.0),
        ([1e-6, 1.0, 1.0 + 1e-9], [1.0, 1e3, 300.0], 6.3),
        ([1e-6, 1.0, 1.0 + 1e-9], [100.0, 900.0, 300.0], -6.3),
    ];
    let mut errors = Errors::of("error over the one asked for");
    let mut torques = Errors::of("torques");
    let mut refused = Vec::new();
    for ([i1, i2, i3], rates, t_end) in cases {
        let moments = PrincipalMoments::new(i1, i2, i3).expect("a body");
        let rates = BodyVector::from_array(rates);
        let exact = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a free body");
        let body = RigidBody::new(moments);
        let start = body.state(Attitude::IDENTITY, rates).expect("a start");
        for tolerance in [1e-3, 1e-6] {
            let solved = match Scene::new(body).solve_by_stepping(&start, t_end, tolerance) {
                Ok(solved) => solved,
                Err(Error::NotDelivered { best, condition: Some(_), .. }) => {
                    assert!(best > tolerance, "{rates:?} {tolerance}: {best}");
                    refused.push((i1, tolerance));
                    continue;
                }
                Err(error) => panic!("{rates:?} {tolerance}: {error}"),
            };
            let error = solved.state.attitude.angle_to(&exact.attitude(t_end));
            errors.push_at(error / tolerance, (rates, tolerance));
            torques.push_at(solved.work.torques() as f64, (rates, tolerance));
        }
    }
    // What rounding leaves of two moments a billionth apart turns a needle a million times as much.
    assert_eq!(refused, [(1e-6, 1e-6); 2]);
    assert_largest!(errors, 6, @"0.0626");
    assert_largest!(torques, 6, @"6.33e6");
}

#[test]
fn random_slender_bodies() {
    let mut random = Random(31);
    let mut table = Table::of("drawn");
    for _ in 0..60 {
        let least = random.size(1e-6, 0.03);
        let mut moments = [least, 1.0, 1.0 + least * random.unit()];
        let mut rates: [f64; 3] = random.vector().map(|rate: f64| 0.01 * rate);
        let turned = (3.0 * random.unit()) as usize;
        moments.rotate_right(turned);
        rates.rotate_right(turned);
        let tolerance = TOLERANCES[(2.0 * random.unit()) as usize];
        let t_end = random.between(-8640.0, 8640.0);
        match (3.0 * random.unit()) as u8 {
            0 => table.add(&Case::new(moments, rates, gradient(), t_end), tolerance),
            1 => table.add(&Case::new(moments, rates, friction(moments), t_end.abs()), tolerance),
            _ => table.add(&Case::new(moments, rates, motor(moments), t_end), tolerance),
        }
    }
    assert_eq!(table.refused, 0);
    assert_largest!(table.error, 60, @"8.53e-3");
    assert_largest!(table.run, 60, @"2.60");
    assert_largest!(table.all, 60, @"4.85");
}
