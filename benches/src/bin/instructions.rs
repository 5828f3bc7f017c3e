//! Instructions of one evaluation, scene by scene: `benches/record/instructions.txt`.
//!
//! ```text
//! cargo run --release -p benches --bin instructions
//! ```
//!
//! It runs itself under valgrind's callgrind, twice for each scene, shorter and longer; the
//! difference is what the evaluations cost, without the start of the program. Nothing is
//! timed; another compiler or another libm gives other counts, another processor does not
//! (valgrind shows the program one with AVX2 and without AVX-512).

#[path = "../../../tests/integrators/by_hand.rs"]
#[allow(dead_code, reason = "the test compares more of them")]
mod by_hand;

use benches::record::{Outcome, conditions, save};
use by_hand::{ByHand, TurnAndPush};
use kit::cli::alive;
use kit::{Report, Table};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    DiscDrag, Effect, GravityAtLever, GravityGradient, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::components;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Resisted, Rk4, Scheme, Splitting,
};
use rotation_dynamics::scene::Scene;
use std::env;
use std::process::Command;

/// What is run: the scenes of the rows, the methods of the columns.
const SCENES: [&str; 8] = [
    "free body, by hand",
    "free body",
    "with gravity, by hand",
    "with gravity",
    "with gravity of strength 0",
    "with viscous friction",
    "with drag of the air",
    "with the gravity gradient",
];
const METHODS: [&str; 4] = ["RK4", "DOP853", "Gauss-Legendre 16", "ABA(10,4)"];

/// Seconds of the shorter run; the longer is three times as long.
const SHORT: u64 = 40;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match arguments.as_slice() {
        [flag, method, scene, seconds] if flag == "--run" => {
            println!("{}", evaluations(method, scene, seconds.parse()?)?);
            Ok(())
        }
        _ => alive(record),
    }
}

/// Counts every scene with every method, and writes the record.
fn record() -> Outcome<()> {
    let mut report = Report::new(
        "Instructions of an evaluation",
        "Of a derivative, and of ABA(10,4) of a kick with its flow, counted by valgrind's callgrind; \
         Gauss-Legendre sweeps its derivatives eight at a time. \
         Count again: benches/measure instructions",
    )?;
    report.add(conditions()?)?;
    let columns = core::iter::once("scene").chain(METHODS);
    let mut table = Table::new("instructions", columns)?;
    for scene in SCENES {
        let mut row = vec![scene.to_owned()];
        for method in METHODS {
            row.push(match counted(method, scene)? {
                Some(count) => format!("{count:.0}"),
                None => "-".to_owned(),
            });
        }
        table.push(row)?;
    }
    report.add(table)?;
    save("instructions", &report)
}

/// Instructions of an evaluation; `None` if the method does not apply.
fn counted(method: &str, scene: &str) -> Outcome<Option<f64>> {
    if evaluations(method, scene, SHORT)? == 0 {
        return Ok(None);
    }
    let run = |seconds: u64| -> Outcome<[f64; 2]> {
        let this = env::current_exe()?;
        let run = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(this)
            .args(["--run", method, scene, &seconds.to_string()])
            .output()
            .map_err(|error| format!("valgrind, which counts, does not run: {error}"))?;
        let (told, counts) = (String::from_utf8(run.stdout)?, String::from_utf8(run.stderr)?);
        let collected = counts.lines().find_map(|line| line.split_once("Collected : "));
        let (_, instructions) = collected.ok_or("valgrind tells no count")?;
        Ok([instructions.trim().parse()?, told.trim().parse()?])
    };
    let [[short, few], [long, many]] = [run(SHORT)?, run(3 * SHORT)?];
    Ok(Some((long - short) / (many - few)))
}

fn brick() -> Result<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::new(1.0, 1.7, 2.2)?))
}

fn round() -> Result<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::symmetric(1.0, 1.7)?))
}

fn start(body: &RigidBody) -> Result<State> {
    let (phi, theta, zeta) = (0.3, 0.9, -0.4);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    body.state(attitude, BodyVector::new(0.7, -0.4, 1.3))
}

/// Evaluations that a run of this many seconds took.
fn evaluations(method: &str, scene: &str, seconds: u64) -> Result<u64> {
    let free = Scene::new(if method == "ABA(10,4)" { round()? } else { brick()? });
    let gravity = |strength: f64| GravityAtLever::new(0.37, 0.9 * strength);
    let (x, z) = (SpaceVector::new(1.0, 0.0, 0.0), SpaceVector::new(0.0, 0.0, 1.0));
    match scene {
        "free body" => carried(&free, method, seconds),
        "with gravity" => carried(&free.with(gravity(1.0)?), method, seconds),
        "with gravity of strength 0" => carried(&free.with(gravity(0.0)?), method, seconds),
        "with viscous friction" => {
            carried(&free.with(ViscousFriction::new(1e-3, 2e-3)?), method, seconds)
        }
        "with drag of the air" => {
            let (rho, nu) = (DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY);
            carried(&free.with(DiscDrag::new(0.3, rho, nu, 1.3)?), method, seconds)
        }
        "with the gravity gradient" => {
            carried(&free.with(GravityGradient::on_orbit(0.01, z, x)?), method, seconds)
        }
        "free body, by hand" => by_hand(false, method, seconds),
        _ => by_hand(true, method, seconds),
    }
}

const STEPS_A_SECOND: u64 = 10;

fn carried<E: Effect>(scene: &Scene<E>, method: &str, seconds: u64) -> Result<u64> {
    let (start, end) = (start(scene.body())?, seconds as f64);
    let steps = STEPS_A_SECOND * seconds;
    let (_, work) = match method {
        "RK4" => Rk4::new(steps)?
            .advance(scene, 0.0, &components(&start), end)
            .map(|(_, work)| ((), work))?,
        "DOP853" => Dop853::new(1e-10)?
            .advance(scene, 0.0, &components(&start), end)
            .map(|(_, work)| ((), work))?,
        "Gauss-Legendre 16" => GaussLegendre::new(2 * seconds)?
            .advance(scene, 0.0, &start, end)
            .map(|(_, work)| ((), work))?,
        _ => {
            let split = Splitting::new(Scheme::ABA104, steps)?;
            if const { E::PROPERTIES.axis_only } {
                split.advance(scene, 0.0, &start, end).map(|(_, work)| ((), work))?
            } else if let Ok(resisted) = Resisted::new(scene, 0.0) {
                split.advance(&resisted, 0.0, &start, end).map(|(_, work)| ((), work))?
            } else {
                return Ok(0);
            }
        }
    };
    Ok(work.torques())
}

/// The same by equations that are written out for one scene.
fn by_hand(heavy: bool, method: &str, seconds: u64) -> Result<u64> {
    let moment = 0.37 * 0.9;
    if method == "ABA(10,4)" {
        let split = Splitting::new(Scheme::ABA104, STEPS_A_SECOND * seconds)?;
        let (y, end) = (components(&start(&round()?)?), seconds as f64);
        let (_, work) = if heavy {
            split.advance(&TurnAndPush::heavy(1.0, moment), 0.0, &y, end)?
        } else {
            split.advance(&TurnAndPush::free(1.0), 0.0, &y, end)?
        };
        return Ok(work.torques());
    }
    let (y, end, moments) = (components(&start(&brick()?)?), seconds as f64, [1.0, 1.7, 2.2]);
    let (free, weighed) = (ByHand::free(moments), ByHand::heavy(moments, moment));
    let (_, work) = match (method, heavy) {
        ("RK4", false) => Rk4::new(STEPS_A_SECOND * seconds)?.advance(&free, 0.0, &y, end)?,
        ("RK4", true) => Rk4::new(STEPS_A_SECOND * seconds)?.advance(&weighed, 0.0, &y, end)?,
        ("DOP853", false) => Dop853::new(1e-10)?.advance(&free, 0.0, &y, end)?,
        ("DOP853", true) => Dop853::new(1e-10)?.advance(&weighed, 0.0, &y, end)?,
        _ => return Ok(0),
    };
    Ok(work.torques())
}
