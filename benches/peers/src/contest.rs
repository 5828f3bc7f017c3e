//! Who can carry which problem, in which variables, at which settings.

use crate::contestants::{
    differential_equations, diffsol, ivp, numeris, ode_solvers, ours, rapier,
};
use crate::form::{Form, FreeMomentum, FreeQuaternion, TopAngles, TopMomentum, TopWithoutSpin};
use crate::open_contest;
use crate::problem::{Motion, Problem};
use core::fmt;
use core::str::FromStr;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::integrators::GaussLegendre;
use rotation_dynamics::integrators::splitting::Scheme;

/// What a contestant is told.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Setting {
    /// Nothing: it is exact.
    Exact,
    /// To hold the error of a step below this.
    Tolerance(f64),
    /// To take this many equal steps.
    Steps(u64),
    /// The same, with the stages of each solved to a precision.
    Stages(u64, f64),
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => write!(f, "-"),
            Self::Tolerance(tolerance) => write!(f, "tolerance {tolerance:e}"),
            Self::Steps(steps) => write!(f, "{steps} steps"),
            Self::Stages(steps, precision) => write!(f, "{steps} steps to {precision:e}"),
        }
    }
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words: Vec<&str> = text.split(' ').collect();
        let number = |word: &str| word.parse::<f64>().map_err(|e| format!("{word}: {e}"));
        let count = |word: &str| word.parse::<u64>().map_err(|e| format!("{word}: {e}"));
        match words.as_slice() {
            ["-"] => Ok(Self::Exact),
            ["tolerance", tolerance] => Ok(Self::Tolerance(number(tolerance)?)),
            [steps, "steps"] => Ok(Self::Steps(count(steps)?)),
            [steps, "steps", "to", precision] => {
                Ok(Self::Stages(count(steps)?, number(precision)?))
            }
            _ => Err(format!("no setting: {text}")),
        }
    }
}

/// The settings of a contestant, the cheapest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ladder {
    /// One setting.
    Exact,
    /// Tolerances.
    Tolerances,
    /// Numbers of steps.
    Steps,
    /// Numbers of steps, and precisions of the stages.
    Stages,
}

type Run = Box<dyn Fn(Setting) -> Result<Attitude, String>>;

/// A method on a problem, in certain variables.
pub struct Contestant {
    /// The crate; `-` for this library.
    pub peer: &'static str,
    /// The method.
    pub method: &'static str,
    /// The variables.
    pub form: &'static str,
    /// What it can be told.
    pub ladder: Ladder,
    /// The attitude at the end of the problem.
    pub run: Run,
}

impl Contestant {
    /// The name in the record.
    pub fn name(&self) -> String {
        match self.peer {
            OURS => self.method.to_owned(),
            peer => format!("{peer} {}", self.method).trim_end().to_owned(),
        }
    }

    /// Whether it is this library's.
    pub fn is_ours(&self) -> bool {
        self.peer == OURS
    }
}

/// This library, in the place of a peer's name.
pub const OURS: &str = "-";

fn wrong(setting: Setting) -> String {
    format!("not told so: {setting}")
}

pub(crate) fn in_words(error: rotation_dynamics::Error) -> String {
    error.to_string()
}

fn exact(run: impl Fn() -> rotation_dynamics::Result<Attitude> + 'static) -> Contestant {
    Contestant {
        peer: OURS,
        method: "closed form",
        form: "-",
        ladder: Ladder::Exact,
        run: Box::new(move |_| run().map_err(in_words)),
    }
}

fn adaptive(
    (peer, method): (&'static str, &'static str),
    form: &'static str,
    run: impl Fn(f64) -> Result<Attitude, String> + 'static,
) -> Contestant {
    Contestant {
        peer,
        method,
        form,
        ladder: Ladder::Tolerances,
        run: Box::new(move |setting| match setting {
            Setting::Tolerance(tolerance) => run(tolerance),
            _ => Err(wrong(setting)),
        }),
    }
}

fn stepping(
    (peer, method): (&'static str, &'static str),
    form: &'static str,
    run: impl Fn(u64) -> Result<Attitude, String> + 'static,
) -> Contestant {
    Contestant {
        peer,
        method,
        form,
        ladder: Ladder::Steps,
        run: Box::new(move |setting| match setting {
            Setting::Steps(steps) => run(steps),
            _ => Err(wrong(setting)),
        }),
    }
}

pub(crate) fn own(
    method: &'static str,
    form: &'static str,
    run: impl Fn(u64) -> rotation_dynamics::Result<Attitude> + 'static,
) -> Contestant {
    stepping((OURS, method), form, move |steps| run(steps).map_err(in_words))
}

pub(crate) fn own_adaptive(
    form: &'static str,
    run: impl Fn(f64) -> rotation_dynamics::Result<Attitude> + 'static,
) -> Contestant {
    adaptive((OURS, "DOP853"), form, move |tolerance| run(tolerance).map_err(in_words))
}

pub(crate) fn gauss(
    form: &'static str,
    run: impl Fn(&GaussLegendre<true>) -> rotation_dynamics::Result<Attitude> + 'static,
) -> Contestant {
    Contestant {
        peer: OURS,
        method: "Gauss-Legendre 16",
        form,
        ladder: Ladder::Stages,
        run: Box::new(move |setting| match setting {
            Setting::Stages(steps, precision) => GaussLegendre::with_precision(steps, precision)
                .map(GaussLegendre::steady)
                .and_then(|method| run(&method))
                .map_err(in_words),
            _ => Err(wrong(setting)),
        }),
    }
}

/// Every peer that carries any equations, in this form.
pub(crate) fn peers<const N: usize, F: Form<N>>(form: F, end: f64) -> Vec<Contestant> {
    type Solver<const N: usize, F> = fn(F, f64, f64) -> Result<[f64; N], String>;
    let solvers: [(&'static str, &'static str, Solver<N, F>); 7] = [
        ("numeris", "RKV98", numeris::rkv98),
        ("ode_solvers", "Dop853", ode_solvers::dop853),
        ("ode_solvers", "Dopri5", ode_solvers::dopri5),
        ("differential-equations", "DOP853", differential_equations::dop853),
        ("differential-equations", "RKV98", differential_equations::rkv98),
        ("ivp", "DOP853", ivp::dop853),
        ("diffsol", "Tsit45", diffsol::tsit45),
    ];
    let carried = solvers.map(|(peer, method, solver)| {
        adaptive((peer, method), F::NAME, move |tolerance| {
            let y = solver(form, end, tolerance)?;
            Attitude::from_quaternion(form.quaternion(end, &y)).map_err(in_words)
        })
    });
    carried.into()
}

/// Everyone who can carry `problem`.
///
/// # Errors
/// None for the problems of this crate.
pub fn contestants(problem: &'static Problem) -> rotation_dynamics::Result<Vec<Contestant>> {
    if let Motion::Open { under, .. } = problem.motion {
        return open_contest::contestants(problem, under);
    }
    let end = problem.end;
    let mut all = vec![exact(move || ours::closed_form(problem))];
    match problem.motion {
        Motion::Open { .. } => {}
        Motion::Free { .. } => {
            let form = FreeMomentum::new(problem)?;
            let name = <FreeMomentum as Form<7>>::NAME;
            all.push(gauss(name, move |method| ours::free_on_lanes(problem, method)));
            all.push(own_adaptive(name, move |tolerance| {
                ours::free(problem, &ours::dop853(tolerance)?)
            }));
            all.push(own("RK4", name, move |n| ours::free(problem, &ours::rk4(n)?)));
            all.push(own("Munthe-Kaas 4", "q, L", move |n| {
                ours::free_scene(problem, &ours::munthe_kaas(n)?)
            }));
            all.extend(peers(form, end));
            all.extend(peers(FreeQuaternion::new(problem)?, end));
        }
        Motion::Top { .. } if problem.angles => {
            let form = TopAngles::new(problem)?;
            let name = <TopAngles as Form<4>>::NAME;
            all.push(gauss(name, move |method| ours::form_on_lanes(form, end, method)));
            all.push(own_adaptive(name, move |tolerance| {
                ours::form(form, end, &ours::dop853(tolerance)?)
            }));
            all.push(own_adaptive("theta, phi, zeta, t", move |tolerance| {
                ours::angles_at_pace(form, end, &ours::dop853(tolerance)?)
            }));
            all.push(own("RK4", name, move |n| ours::form(form, end, &ours::rk4(n)?)));
            all.extend(peers(form, end));
        }
        Motion::Top { .. } => {
            let form = TopWithoutSpin::new(problem)?;
            let name = <TopWithoutSpin as Form<6>>::NAME;
            all.push(gauss(name, move |method| ours::spin_free(problem, method)));
            all.push(gauss("q, l", move |method| ours::top_on_its_axes(problem, method)));
            for scheme in [
                Scheme::SRKN6,
                Scheme::SRKN14,
                Scheme::KAHAN_LI17,
                Scheme::ABA82,
                Scheme::ABA104,
                Scheme::ABA1064,
            ] {
                all.push(own(scheme.name, name, move |n| {
                    ours::top(problem, &ours::splitting(scheme, n)?)
                }));
            }
            all.push(own_adaptive(name, move |tolerance| {
                ours::form(form, end, &ours::dop853(tolerance)?)
            }));
            let on_axes = TopMomentum::new(problem)?;
            all.push(own_adaptive(<TopMomentum as Form<7>>::NAME, move |tolerance| {
                ours::form(on_axes, end, &ours::dop853(tolerance)?)
            }));
            all.push(own("RK4", name, move |n| ours::spin_free(problem, &ours::rk4(n)?)));
            all.push(own("Munthe-Kaas 4", "q, L", move |n| {
                ours::top(problem, &ours::munthe_kaas(n)?)
            }));
            all.extend(peers(form, end));
            all.extend(peers(on_axes, end));
        }
    }
    if !problem.angles {
        all.push(stepping(("rapier3d", ""), "-", move |n| {
            rapier::steps(problem, n).and_then(Attitude::from_quaternion).map_err(in_words)
        }));
    }
    Ok(all)
}
