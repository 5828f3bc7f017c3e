//! Exercise 16.6, the ladder.

use core::f64::consts::FRAC_PI_2;
use pages::ch16_ex6_ladder as example;
use pages::ch16_ex6_ladder::{Sliding, Wall};
use rotation_dynamics::report::Page;
use rotation_dynamics::Error;
use rotation_dynamics::exact::ladder::{Ladder, Phase};
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{EPS, cos, sin};
use rotation_dynamics::planar::{Bilateral, Run, simulate, simulate_within};
use rotation_dynamics::report::{Parsed, parse};

const G: f64 = 9.80665;

#[test]
fn what_is_no_ladder_is_refused() {
    let flat = FRAC_PI_2;
    let refused = [
        (3.0, G, 0.0),
        (3.0, G, -0.25),
        (3.0, G, flat),
        (3.0, G, 15.0),
        (3.0, G, f64::NAN),
        (3.0, G, f64::INFINITY),
        (3.0, G, 1e-200),
        (0.0, G, 0.25),
        (-3.0, G, 0.25),
        (f64::INFINITY, G, 0.25),
        (3.0, 0.0, 0.25),
        (3.0, f64::NAN, 0.25),
    ];
    for (length, gravity, theta0) in refused {
        let error = Ladder::new(length, gravity, theta0).unwrap_err();
        assert!(
            matches!(error, Error::NotFinite { .. } | Error::OutOfRange { .. }),
            "{error}"
        );
    }
    let message = Ladder::new(3.0, G, 1.6).unwrap_err().to_string();
    assert!(
        message.starts_with("theta0 = 1.6 is not allowed"),
        "{message}"
    );
    assert!(message.contains("pi/2 = 1.5708 (flat)"), "{message}");
}

#[test]
fn a_time_outside_the_motion_is_refused() {
    let ladder = Ladder::new(3.0, G, 0.25).unwrap();
    for t in [-1e-9, 1.2, f64::NAN, f64::INFINITY] {
        assert!(ladder.at(t).is_err(), "t = {t}");
    }
    let message = ladder.at(2.0).unwrap_err().to_string();
    assert!(message.contains("from 0 to 1.178352234699266"), "{message}");
    assert_eq!(ladder.at(ladder.landing_time()), Ok(ladder.landing()));
}

/// Both phases meet at the release, from either side, for every angle: four units of
/// round-off in `t` move no field by more than its rate allows.
#[test]
fn the_phases_join() {
    let angles = [
        1e-12,
        1e-3,
        0.25,
        1.0,
        1.55,
        core::f64::consts::FRAC_PI_2 - 1e-9,
    ];
    let (mut ran, mut worst) = (0, 0.0_f64);
    for theta0 in angles {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let (release, t) = (ladder.release(), ladder.release_time());
        for (t, phase) in [
            (t * (1.0 - 4.0 * EPS), Phase::OnWall),
            (t * (1.0 + 4.0 * EPS), Phase::OffWall),
        ] {
            let state = ladder.at(t).unwrap();
            assert_eq!(state.phase, phase);
            let unit = EPS * (1.0 + release.omega * t);
            worst = worst
                .max((state.theta - release.theta).abs() / unit)
                .max((state.omega - release.omega).abs() / (release.omega * unit))
                .max((state.vx_cm - release.vx_cm).abs() / (release.vx_cm * unit))
                .max((state.floor_force - release.floor_force).abs() / unit);
        }
        ran += 1;
    }
    assert_eq!(ran, angles.len());
    // Measured: 4.56, the four units and the rounding of t.
    assert!(worst <= 4.6, "{worst}");
}

const ANGLES: [f64; 7] = [1e-6, 1e-3, 0.1, 0.25, 0.7, 1.2, 1.5];

fn uniform() -> Sliding {
    Sliding {
        length: 3.0,
        gravity: G,
        inertia: 1.0,
    }
}

fn simulated(scene: &Sliding, tolerance: f64, theta0: f64) -> Run<Wall, 4> {
    let method = Dop853::new(tolerance).unwrap();
    simulate(scene, &method, Wall::Touches, scene.at_rest(theta0), 100.0).unwrap()
}

/// Largest relative error of the simulation against the closed form, at the two events
/// and at 40 times between, over the size of each coordinate.
fn disagreement(ladder: &Ladder, run: &Run<Wall, 4>) -> f64 {
    let let_go = run.transition("wall lets go").unwrap();
    let lands = run.transition("lands").unwrap();
    let rate = (1.5 * G / 3.0_f64).sqrt();
    let mut worst = (let_go.t / ladder.release_time() - 1.0).abs();
    worst = worst.max((lands.t / ladder.landing_time() - 1.0).abs());
    let end = ladder.landing_time().min(lands.t);
    for i in 0..=40 {
        let t = end * f64::from(i) / 40.0;
        let (_, y) = run.at(t).unwrap();
        let s = ladder.at(t).unwrap();
        for (got, want, size) in [
            (y[0], s.theta, s.theta),
            (y[1], s.omega, rate * s.theta),
            (y[2], s.x_cm, s.x_cm),
            (y[3], s.vx_cm, rate * s.x_cm),
        ] {
            worst = worst.max((got - want).abs() / size);
        }
    }
    worst
}

#[test]
fn the_simulation_agrees_with_the_closed_form() {
    let mut worst = 0.0_f64;
    for theta0 in ANGLES {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        worst = worst.max(disagreement(&ladder, &simulated(&uniform(), 1e-14, theta0)));
    }
    // Measured: 3.50e-14, at 1e-6 rad, where it takes longest.
    assert!(worst <= 3.6e-14, "{worst:e}");
    // The damaged twin: a moment of inertia off by 1e-9.
    let damaged = Sliding {
        inertia: 1.0 + 1e-9,
        ..uniform()
    };
    let ladder = Ladder::new(3.0, G, 0.25).unwrap();
    assert!(disagreement(&ladder, &simulated(&damaged, 1e-14, 0.25)) > 1e-10);
}

/// The moment of the release is located to the accuracy of the run, not to that of
/// the interpolant: its error falls with the tolerance down to round-off.
#[test]
fn the_release_is_located() {
    let ladder = Ladder::new(3.0, G, 0.25).unwrap();
    let error = |scene: &Sliding, tolerance: f64| {
        let run = simulated(scene, tolerance, 0.25);
        let release = run.transition("wall lets go").unwrap();
        (release.t / ladder.release_time() - 1.0).abs()
    };
    let tolerances = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];
    for tolerance in tolerances {
        // Measured: 0.0003, 0.0007, 0.0028, 0.0127, 0.0178, 0.0111 of the tolerance.
        let error = error(&uniform(), tolerance);
        assert!(error <= 0.018 * tolerance, "{tolerance:e}: {error:e}");
    }
    // The damaged twin: a moment of inertia off by 1e-9.
    let damaged = Sliding {
        inertia: 1.0 + 1e-9,
        ..uniform()
    };
    assert!(error(&damaged, 1e-12) > 1e-10);
}

/// Newton's laws along the closed form: second differences of the motion against the
/// forces that the closed form states.
#[test]
fn the_closed_form_obeys_newton() {
    let (mut worst, mut damaged) = (0.0_f64, 0.0_f64);
    let mut ran = 0;
    for theta0 in [0.1, 0.25, 0.7, 1.2] {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let (release, end) = (ladder.release_time(), ladder.landing_time());
        let h = 1e-3 * (end - release);
        for i in 1..40 {
            let t = end * f64::from(i) / 40.0;
            if (t - release).abs() < 3.0 * h || t < 3.0 * h || t > end - 3.0 * h {
                continue;
            }
            // Fourth-order central differences.
            let second = |f: &dyn Fn(f64) -> f64| {
                let sides = 16.0 * (f(t + h) + f(t - h)) - (f(t + 2.0 * h) + f(t - 2.0 * h));
                (sides - 30.0 * f(t)) / (12.0 * h * h)
            };
            let at = |t: f64| ladder.at(t).unwrap();
            let s = at(t);
            let across = second(&|t| at(t).x_cm) / G - s.wall_force;
            let up = second(&|t| at(t).y_cm) / G + 1.0 - s.floor_force;
            // (l/6g) theta'' = N_floor sin - N_wall cos
            let turning = 3.0 / (6.0 * G) * second(&|t| at(t).theta);
            let moment = s.floor_force * sin(s.theta) - s.wall_force * cos(s.theta);
            let turn = turning - moment;
            damaged = damaged.max((turning * (1.0 + 1e-7) - moment).abs());
            worst = worst.max(across.abs()).max(up.abs()).max(turn.abs());
            ran += 1;
        }
    }
    assert!(ran >= 150, "{ran}");
    // Measured: 4.70e-9, the error of the differences (h^4, and round-off over h^2).
    assert!(worst <= 4.8e-9, "{worst:e}");
    // The damaged twin: a moment of inertia off by 1e-7.
    assert!(damaged > 2e-8, "{damaged:e}");
}

/// What a solver does that keeps the wall: the wall pulls, the ladder lands early and
/// too fast, and no tolerance helps.
#[test]
fn a_kept_wall_pulls() {
    let scene = uniform();
    let mut ran = 0;
    for theta0 in ANGLES {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let start = scene.at_rest(theta0);
        let kept = simulate_within(&Bilateral(&scene), 1e-9, Wall::Touches, start, 100.0).unwrap();
        assert_eq!(kept.run.transitions().len(), 1);
        let flat = kept.run.transition("lands").unwrap();
        let pull = scene.forces(Wall::Touches, &flat.before).wall / G;
        assert!(
            (pull + 1.5 * cos(theta0)).abs() <= 1e-7 * cos(theta0),
            "{pull}"
        );
        assert!((flat.t / ladder.held_landing_time() - 1.0).abs() <= 1e-9);
        // omega is too large by 1/sqrt(1 - cos^2 theta0/9): 6 % from upright, 0 from flat.
        let excess = flat.before[1] / ladder.landing().omega;
        let square = cos(theta0) * cos(theta0);
        assert!(
            (excess * (1.0 - square / 9.0).sqrt() - 1.0).abs() <= 1e-8,
            "{excess}"
        );
        assert!(flat.t < ladder.landing_time());
        ran += 1;
    }
    assert_eq!(ran, ANGLES.len());
}

/// After the release: the top moves away and never comes back, the floor carries
/// between nothing and a quarter of the weight, and a quarter at both ends.
#[test]
fn the_top_never_comes_back_and_the_floor_always_carries() {
    let (mut least, mut ran) = (f64::INFINITY, 0);
    for i in 1..150 {
        let ladder = Ladder::new(1.0, G, 0.0104 * f64::from(i)).unwrap();
        let (from, to) = (ladder.release_time(), ladder.landing_time());
        let mut last = 0.0;
        for j in 1..=50 {
            let s = ladder.at(from + (to - from) * f64::from(j) / 50.0).unwrap();
            assert!(s.x_top > last, "{s:?}");
            assert!(s.floor_force <= 0.25 + EPS);
            last = s.x_top;
            least = least.min(s.floor_force);
            ran += 1;
        }
        assert_eq!(ladder.release().floor_force, 0.25);
        assert!((ladder.landing().floor_force - 0.25).abs() <= EPS);
    }
    assert_eq!(ran, 149 * 50);
    // Measured: 0.18918, from the most upright start.
    assert!((0.1891..0.1892).contains(&least), "{least}");
}

fn printed() -> Parsed {
    let text = Page::report(&example::EXAMPLE).unwrap().text().unwrap();
    parse(&text).unwrap()
}

/// The column of a table, as numbers.
fn column(table: &str, name: &str) -> Vec<f64> {
    let parsed = printed();
    let table = parsed.table(table).expect("the table is printed");
    let at = table
        .columns()
        .iter()
        .position(|c| c == name)
        .expect("the column exists");
    table
        .rows()
        .iter()
        .filter_map(|row| row[at].parse().ok())
        .collect()
}

/// Two thirds, wherever the mass sits, as long as the centre is in the middle.
#[test]
fn two_thirds_do_not_depend_on_the_mass() {
    let ratios = column("table mass", "height ratio");
    assert_eq!(ratios.len(), 3);
    for ratio in ratios {
        assert!((ratio - 2.0 / 3.0).abs() <= 1e-7, "{ratio}");
    }
    let times = column("table mass", "t_release");
    assert!(times.windows(2).all(|t| t[1] > t[0] + 0.05), "{times:?}");
}

/// With friction everything is later and lower, and at mu = tan(theta0/2) the ladder
/// stays: the wall's and the floor's limits balance exactly there.
#[test]
fn friction_holds_the_ladder_at_the_tangent_of_half_the_angle() {
    let releases = column("table friction", "t_release/s");
    let ratios = column("table friction", "height ratio");
    assert_eq!((releases.len(), ratios.len()), (5, 5));
    assert!(releases.windows(2).all(|t| t[1] > t[0]));
    assert!(ratios.windows(2).all(|r| r[1] < r[0]));
    // Without friction it is the smooth ladder.
    let smooth = Ladder::new(3.0, G, 0.25).unwrap();
    assert!((releases[0] - smooth.release_time()).abs() <= 1e-7);
    // Moments about the middle with both ends at the limit of friction.
    let (s, c) = (sin(0.25_f64), cos(0.25_f64));
    let mu = rotation_dynamics::math::tan(0.125);
    let floor = 1.0 / (1.0 + mu * mu);
    let wall = mu * floor;
    let moment = s * floor - c * wall - mu * (s * wall + c * floor);
    assert!(moment.abs() <= EPS, "{moment:e}");
}
