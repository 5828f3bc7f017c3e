//! Work-precision curves whose answers are known.

use rotation_dynamics::Error;
use rotation_dynamics::accuracy::{
    DigitPrice, Errors, Measure, Point, Sweep, WorkPrecision, front,
};
use rotation_dynamics::integrators::Work;
use rotation_dynamics::math::{exp2, pow};
use support::{Errors as Collected, assert_largest};

fn curve(points: &[(f64, f64)]) -> WorkPrecision {
    let points = points.iter().map(|&(work, error)| Point { work, error });
    WorkPrecision::new(points).unwrap()
}

/// A method of order p with error constant c, down to a floor that rises with work.
fn ideal(p: f64, c: f64, floor: f64) -> WorkPrecision {
    let points: Vec<(f64, f64)> = (0..160)
        .map(|k| 16.0 * exp2(0.125 * f64::from(k)))
        .map(|work| (work, c * pow(work, -p) + floor * work))
        .collect();
    curve(&points)
}

#[test]
fn price_of_a_digit_is_that_of_the_order() {
    let [mut orders, mut lines, mut scatters] =
        ["order", "line", "scatter in digits"].map(Collected::of);
    for p in [1.0, 2.0, 4.0, 6.0, 8.0, 16.0] {
        let price = ideal(p, pow(32.0, p), 0.0).price_of_a_digit(1e-12, 1.0).unwrap();
        orders.push_at(price.order / p - 1.0, p);
        // The line reaches 1 at 32 and 1e-6 where c work^-p does.
        let work = 32.0 * pow(10.0, 6.0 / p);
        lines.push_at(price.at_one / 32.0 - 1.0, p);
        lines.push_at(price.work_for(1e-6).unwrap() / work - 1.0, p);
        assert!(price.work_for(0.0).is_err());
        let predicted = DigitPrice::predicted(p as u32).unwrap();
        lines.push_at(price.factor / predicted - 1.0, p);
        scatters.push_at(price.scatter, p);
        assert!(price.runs >= 4, "{price:?}");
    }
    assert_largest!(orders, 6, @"3.33e-16");
    assert_largest!(lines, 3 * 6, @"2.66e-15");
    assert_largest!(scatters, 6, @"7.11e-15");
    assert!(DigitPrice::predicted(0).is_err());
    // The damaged twin: with the floor inside the window the order is not the method's.
    let price = ideal(4.0, 1e3, 1e-14).price_of_a_digit(1e-13, 1.0).unwrap();
    assert!((price.order - 4.0).abs() > 0.3, "{price:?}");
    // Too few runs, or work that buys nothing, have no price.
    assert!(ideal(4.0, 1e3, 0.0).price_of_a_digit(1e-3, 2e-3).is_none());
    let flat: Vec<(f64, f64)> = (1..9).map(|k| (f64::from(k), 1e-3)).collect();
    assert_eq!(curve(&flat).price_of_a_digit(1e-12, 1.0), None);
}

#[test]
fn luck_does_not_count() {
    // The third run is right by luck; the errors rise again at the end.
    let runs = curve(&[
        (80.0, 3e-9),
        (10.0, 1e-2),
        (20.0, 1e-3),
        (40.0, 1e-12),
        (60.0, 1e-6),
        (70.0, 2e-9),
    ]);
    assert_eq!(runs.points()[0].work, 10.0);
    let least = |requested| runs.least_work(requested).map(|p| p.work);
    assert_eq!(least(1e-2), Some(10.0));
    assert_eq!(least(1e-3), Some(20.0));
    assert_eq!(least(1e-6), Some(40.0));
    assert_eq!(least(1e-8), Some(70.0));
    assert_eq!(least(1e-9), None);
    assert_eq!(runs.floor(), Some(Point { work: 70.0, error: 3e-9 }));
    // The damaged twin: by its luckiest run the method would claim 1e-12.
    let luckiest = runs.points().iter().map(|p| p.error).fold(1.0, f64::min);
    assert!(luckiest < 1e-3 * runs.floor().unwrap().error);
}

#[test]
fn nothing_on_the_front_is_beaten() {
    let curves = [ideal(2.0, 1e2, 0.0), ideal(4.0, 1e5, 0.0), ideal(8.0, 1e16, 0.0)];
    let best = front(&curves);
    let all: Vec<Point> = curves.iter().flat_map(|c| c.points().to_vec()).collect();
    assert!(best.len() > 10);
    let beaten = |p: &Point| all.iter().any(|q| q.work <= p.work && q.error < p.error);
    assert!(best.iter().all(|(_, p)| !beaten(p)));
    assert!(best.windows(2).all(|w| w[0].1.work < w[1].1.work && w[0].1.error > w[1].1.error));
    // Low order first, high order last, and each has its part.
    let methods: Vec<usize> = best.iter().map(|(method, _)| *method).collect();
    assert!(
        methods.is_sorted() && methods[0] == 0 && methods.contains(&1) && methods.ends_with(&[2])
    );
    // The damaged twin: every run is not the front.
    assert!(!all.iter().all(|p| !beaten(p)));
    assert!(front(&[]).is_empty());
}

#[test]
fn refusals_are_kept_with_their_reason() {
    let none = Errors { attitude: 0.0, rates: 0.0, momentum: 0.0, energy: 0.0, invariants: 0.0 };
    let sweep = Sweep::over([1.0, 2.0, 3.0, 4.0], |setting| {
        let work = Work { derivatives: setting as u64, ..Work::default() };
        match setting {
            1.0 => Err(Error::LimitReached { what: "steps", t: 0.0, t_end: 1.0, limit: 1 }),
            2.0 => Ok((Errors { rates: f64::NAN, ..none }, work)),
            _ => Ok((Errors { attitude: 1.0 / setting, ..none }, work)),
        }
    });
    assert_eq!((sweep.runs().len(), sweep.refused().len()), (2, 2));
    assert!(matches!(sweep.refused()[0], (1.0, Error::LimitReached { what: "steps", .. })));
    assert!(matches!(sweep.refused()[1], (2.0, Error::NotFinite { .. })));
    let points = sweep.curve(Measure::Attitude, Work::torques).unwrap();
    assert_eq!(
        points.points(),
        [(3.0, 1.0 / 3.0), (4.0, 0.25)].map(|(work, error)| Point { work, error })
    );
    // No work is no point on a logarithmic axis.
    assert!(sweep.curve(Measure::Attitude, |work| work.kicks).is_err());
    assert!(WorkPrecision::new([Point { work: 1.0, error: -1.0 }]).is_err());
    assert!(WorkPrecision::new([Point { work: 1.0, error: f64::NAN }]).is_err());
}
