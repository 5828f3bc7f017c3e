//! An absent effect costs nothing: the motion is, bit by bit, that of equations written out by
//! hand for just this scene; what is absent is not called and not stored.

#[path = "by_hand.rs"]
mod by_hand;

use by_hand::{ByHand, EulersEquations, TurnAndPush};
use core::cell::Cell;
use core::mem::size_of;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, Effect, GravityAtLever, Properties, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::{BodyAxes, LaneByLane};
use rotation_dynamics::integrators::scene::components;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Rk4, Scheme, Separable, Splitting,
};
use rotation_dynamics::scene::Scene;

/// Moments of the brick (kg m^2), and m g l where it is heavy (N m).
const BRICK: [f64; 3] = [1.0, 1.7, 2.2];
const MOMENT: f64 = 0.37 * 0.9;

fn brick() -> RigidBody {
    let [i1, i2, i3] = BRICK;
    RigidBody::new(PrincipalMoments::new(i1, i2, i3).expect("a brick"))
}

fn round() -> RigidBody {
    RigidBody::new(PrincipalMoments::symmetric(1.0, 1.7).expect("a body"))
}

fn gravity() -> GravityAtLever {
    GravityAtLever::new(0.37, 0.9).expect("gravity")
}

fn start(body: &RigidBody) -> State {
    let (phi, theta, zeta) = (0.3, 0.9, -0.4);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
    (body.state(attitude, BodyVector::new(0.7, -0.4, 1.3))).expect("a state")
}

/// The splitting of a scene as a splitting of its components, without the spin.
struct Components<'s, E>(&'s Scene<E>);

impl<E: Effect> Separable for Components<'_, E> {
    type State = [f64; 7];
    type Point = <Scene<E> as Separable>::Point;

    fn enter(&self, y: &[f64; 7]) -> rotation_dynamics::Result<Self::Point> {
        self.0.enter(&rotation_dynamics::integrators::scene::state(y)?)
    }

    fn leave(&self, point: &Self::Point, _: f64) -> rotation_dynamics::Result<[f64; 7]> {
        let (q, l) = (point.quaternion(), point.momentum());
        Ok([q[0], q[1], q[2], q[3], l[0], l[1], l[2]])
    }

    fn flow(&self, point: &mut Self::Point, dt: f64) {
        self.0.flow(point, dt);
    }

    fn kick(&self, point: &mut Self::Point, dt: f64) {
        self.0.kick(point, dt);
    }

    fn settle(&self, point: &mut Self::Point) {
        self.0.settle(point);
    }
}

/// Of two problems with the same method, all components at the end of runs of so many steps
/// (of 0.02 s), bit by bit: how many bits differ in all, and how many runs there were.
fn different_bits<A, B>(
    method: impl Fn(u64) -> Box<dyn Both<A, B>>,
    (a, b): (&A, &B),
    start: &[f64; 7],
    lengths: &[u64],
) -> (u32, usize) {
    let (mut different, mut ran) = (0, 0);
    for &n in lengths {
        let (one, other) = method(n).ends(a, b, start, 0.02 * n as f64);
        for (one, other) in one.into_iter().zip(other) {
            different += (one.to_bits() ^ other.to_bits()).count_ones();
        }
        ran += 1;
    }
    (different, ran)
}

/// One method on two problems.
trait Both<A, B> {
    fn ends(&self, a: &A, b: &B, start: &[f64; 7], end: f64) -> ([f64; 7], [f64; 7]);
}

impl<A, B, M> Both<A, B> for M
where
    M: Integrator<A, [f64; 7]> + Integrator<B, [f64; 7]>,
{
    fn ends(&self, a: &A, b: &B, start: &[f64; 7], end: f64) -> ([f64; 7], [f64; 7]) {
        let one = self.advance(a, 0.0, start, end).expect("smooth").0;
        (one, self.advance(b, 0.0, start, end).expect("smooth").0)
    }
}

/// Runs of so many steps: each of the first few, and then longer ones.
const LENGTHS: [u64; 10] = [1, 2, 3, 5, 8, 50, 500, 2000, 5000, 10000];

#[test]
fn a_scene_is_its_equations_written_out_by_hand() {
    let (free, heavy) = (Scene::new(brick()), Scene::new(brick()).with(gravity()));
    let (round_free, round_heavy) = (Scene::new(round()), Scene::new(round()).with(gravity()));
    let (y, at_round) = (components(&start(&brick())), components(&start(&round())));
    let rk4 = |n| -> Rk4 { Rk4::new(n).expect("steps") };
    let dop = |n: u64| Dop853::new(1e-9 / n as f64).expect("a tolerance");
    let split = |n| Splitting::new(Scheme::SRKN14, n).expect("steps");
    let gauss = |n| GaussLegendre::new(n).expect("steps");
    let on_axes = BodyAxes::new(&free).expect("free");
    let heavy_on_axes = BodyAxes::new(&heavy).expect("axis only");
    let l = on_axes.components(&start(&brick()));
    let rows = [
        (
            "RK4, free",
            different_bits(|n| Box::new(rk4(n)), (&free, &ByHand::free(BRICK)), &y, &LENGTHS),
        ),
        (
            "RK4, heavy",
            different_bits(
                |n| Box::new(rk4(n)),
                (&heavy, &ByHand::heavy(BRICK, MOMENT)),
                &y,
                &LENGTHS,
            ),
        ),
        (
            "DOP853, free",
            different_bits(|n| Box::new(dop(n)), (&free, &ByHand::free(BRICK)), &y, &LENGTHS),
        ),
        (
            "DOP853, heavy",
            different_bits(
                |n| Box::new(dop(n)),
                (&heavy, &ByHand::heavy(BRICK, MOMENT)),
                &y,
                &LENGTHS,
            ),
        ),
        (
            "splitting, free",
            different_bits(
                |n| Box::new(split(n)),
                (&Components(&round_free), &TurnAndPush::free(1.0)),
                &at_round,
                &LENGTHS,
            ),
        ),
        (
            "splitting, heavy",
            different_bits(
                |n| Box::new(split(n)),
                (&Components(&round_heavy), &TurnAndPush::heavy(1.0, MOMENT)),
                &at_round,
                &LENGTHS,
            ),
        ),
        (
            "Gauss, free",
            different_bits(
                |n| Box::new(gauss(n)),
                (&on_axes, &LaneByLane(EulersEquations(ByHand::free(BRICK)))),
                &l,
                &LENGTHS,
            ),
        ),
        (
            "Gauss, heavy",
            different_bits(
                |n| Box::new(gauss(n)),
                (&heavy_on_axes, &LaneByLane(EulersEquations(ByHand::heavy(BRICK, MOMENT)))),
                &l,
                &LENGTHS,
            ),
        ),
    ];
    let mut ran = 0;
    for (name, (different, runs)) in rows {
        assert_eq!(different, 0, "{name}: bits that differ");
        ran += runs;
    }
    assert_eq!(ran, 8 * LENGTHS.len());
    // The damaged twin: equations with the weight for a scene without it, and a moment that
    // is off by its last bit.
    let (seen, _) =
        different_bits(|n| Box::new(rk4(n)), (&free, &ByHand::heavy(BRICK, MOMENT)), &y, &[8]);
    assert!(seen > 50, "{seen}");
    let [i1, i2, i3] = brick().moments().to_array();
    let other = PrincipalMoments::new(i1, i2, i3.next_up()).expect("a brick");
    let other = Scene::new(RigidBody::new(other));
    let (seen, _) =
        different_bits(|n| Box::new(rk4(n)), (&other, &ByHand::free(BRICK)), &y, &[500]);
    assert!(seen > 10, "{seen}");
}

/// Gravity that counts how often it is asked.
struct Counted<'c> {
    gravity: GravityAtLever,
    torques: &'c Cell<u64>,
    others: &'c Cell<u64>,
}

impl Effect for Counted<'_> {
    const PROPERTIES: Properties = GravityAtLever::PROPERTIES;

    fn name(&self) -> &'static str {
        "counted gravity"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.torques.set(self.torques.get() + 1);
        self.gravity.torque(t, body, state)
    }

    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.others.set(self.others.get() + 1);
        self.gravity.potential_energy(t, body, state)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.gravity.torque_scale(t, body, state)
    }
}

/// As often as the method says where it is there, with strength 0 just as often, and never
/// where it is not.
#[test]
fn what_is_absent_is_not_called() {
    let (torques, others) = (Cell::new(0), Cell::new(0));
    let counted = |strength: f64| Counted {
        gravity: GravityAtLever::new(0.37, 0.9 * strength).expect("gravity"),
        torques: &torques,
        others: &others,
    };
    let body = round();
    let absent = Scene::new(body);
    let mut ran = 0;
    for (strength, present) in [1.0, 0.0].map(|s| (s, Scene::new(body).with(counted(s)))) {
        let runs = [
            run(&Rk4::new(700).expect("steps"), &absent, &present, &torques),
            run(&Dop853::new(1e-10).expect("valid"), &absent, &present, &torques),
            run(&Splitting::new(Scheme::SRKN14, 150).expect("steps"), &absent, &present, &torques),
            run(&Splitting::new(Scheme::STRANG, 900).expect("steps"), &absent, &present, &torques),
            run(&GaussLegendre::new(80).expect("steps"), &absent, &present, &torques),
        ];
        for (calls_absent, calls, expected, apart) in runs {
            assert_eq!(calls_absent, 0);
            assert_eq!(calls, expected);
            // With strength 0 all was in vain: the motion is the same.
            assert_eq!(apart == 0.0, strength == 0.0, "{apart:e}");
            ran += 1;
        }
    }
    assert_eq!((ran, others.get()), (10, 0));
}

/// Calls without and with the effect, those expected, and how far apart the ends are.
fn run<M>(
    method: &M,
    absent: &Scene<()>,
    present: &Scene<((), Counted<'_>)>,
    torques: &Cell<u64>,
) -> (u64, u64, u64, f64)
where
    M: for<'c> Integrator<Scene<((), Counted<'c>)>, State> + Integrator<Scene<()>, State>,
{
    let start = start(absent.body());
    torques.set(0);
    let (free, _) = method.advance(absent, 0.0, &start, 10.0).expect("smooth");
    let without = torques.get();
    let (heavy, work) = method.advance(present, 0.0, &start, 10.0).expect("smooth");
    let apart = free.attitude.angle_to(&heavy.attitude);
    (without, torques.get() - without, work.torques(), apart)
}

#[test]
fn what_is_absent_is_not_stored() {
    let body = size_of::<RigidBody>();
    assert_eq!(body, 3 * size_of::<f64>());
    assert_eq!(size_of::<Scene<()>>(), body);
    assert_eq!(size_of::<Scene<((), ())>>(), body);
    assert_eq!(size_of::<Scene<((), ViscousFriction)>>(), body + size_of::<ViscousFriction>());
    assert_eq!(
        size_of::<Scene<(((), GravityAtLever), CoulombBearing)>>(),
        body + size_of::<GravityAtLever>() + size_of::<CoulombBearing>()
    );
    // The twin: an effect that might be there takes its room whether it is or not.
    assert!(size_of::<Option<GravityAtLever>>() > 0);
}
