//! Who can carry which motion without a closed form.
//!
//! Every peer gets each choice of variables, and so do our own Gauss-Legendre, DOP853 and RK4;
//! besides, our methods for scenes take the effects as the library has them.

use crate::contest::{Contestant, gauss, own, own_adaptive, peers};
use crate::contestants::ours;
use crate::form::Form;
use crate::open::{self, Under};
use crate::open_form::{
    Damped, DampedWithoutSpin, Driven, DrivenByOscillator, Heavy, HeavyInSpace, Satellite,
    SatelliteOnOrbit,
};
use crate::problem::Problem;
use rotation_dynamics::Result;
use rotation_dynamics::body::State;
use rotation_dynamics::effects::Effect;
use rotation_dynamics::integrators::gauss_legendre::BodyAxes;
use rotation_dynamics::integrators::{Integrator, Resisted, Scheme, StageOde};
use rotation_dynamics::scene::Scene;
use std::rc::Rc;

const SCHEMES: [Scheme; 6] = [
    Scheme::SRKN6,
    Scheme::SRKN14,
    Scheme::KAHAN_LI17,
    Scheme::ABA82,
    Scheme::ABA104,
    Scheme::ABA1064,
];

/// Everyone who can carry this motion.
///
/// # Errors
/// None for the problems of this crate.
pub(crate) fn contestants(problem: &'static Problem, under: Under) -> Result<Vec<Contestant>> {
    let (body, start) = problem.start()?;
    let end = problem.end;
    let mut ours = Vec::new();
    let mut peers = Vec::new();
    match under {
        Under::Weight(weight) => {
            carried(Heavy::new(problem)?, end, &mut ours, &mut peers);
            carried(HeavyInSpace::new(problem)?, end, &mut ours, &mut peers);
            let scene = Rc::new(open::heavy(body, weight)?);
            ours.push(in_space(&scene, start, end));
            let same = scene.clone();
            ours.push(gauss("q, l", move |method| {
                let (end, _) = method.advance(&BodyAxes::new(&same)?, 0.0, &start, end)?;
                Ok(end.attitude)
            }));
            for scheme in SCHEMES {
                let same = scene.clone();
                ours.push(own(scheme.name, "q, L", move |n| {
                    let method = ours::splitting(scheme, n)?;
                    Ok(method.advance(&*same, 0.0, &start, end)?.0.attitude)
                }));
            }
        }
        Under::WeightAndFriction(weight, friction) => {
            carried(DampedWithoutSpin::new(problem)?, end, &mut ours, &mut peers);
            carried(Damped::new(problem)?, end, &mut ours, &mut peers);
            let scene = Rc::new(open::damped(body, weight, friction)?);
            ours.push(in_space(&scene, start, end));
            for scheme in SCHEMES {
                let same = scene.clone();
                ours.push(own(scheme.name, "S, L", move |n| {
                    let method = ours::splitting(scheme, n)?;
                    let resisted = Resisted::new(&same, 0.0)?;
                    Ok(method.advance(&resisted, 0.0, &start, end)?.0.attitude)
                }));
            }
        }
        Under::Gradient(mean_motion) => {
            carried(SatelliteOnOrbit::new(problem)?, end, &mut ours, &mut peers);
            carried(Satellite::new(problem)?, end, &mut ours, &mut peers);
            let scene = Rc::new(open::satellite(body, mean_motion)?);
            ours.push(in_space(&scene, start, end));
        }
        Under::Drive(torque, rate) => {
            carried(DrivenByOscillator::new(problem)?, end, &mut ours, &mut peers);
            carried(Driven::new(problem)?, end, &mut ours, &mut peers);
            let scene = Rc::new(open::driven(body, torque, rate));
            ours.push(in_space(&scene, start, end));
        }
    }
    ours.extend(peers);
    Ok(ours)
}

/// A form for our methods for any equations, and for the peers.
fn carried<const N: usize, F: Form<N> + StageOde<N>>(
    form: F,
    end: f64,
    ours: &mut Vec<Contestant>,
    others: &mut Vec<Contestant>,
) {
    ours.push(gauss(F::NAME, move |method| ours::form_of_lanes(form, end, method)));
    ours.push(own_adaptive(F::NAME, move |tolerance| {
        ours::form(form, end, &ours::dop853(tolerance)?)
    }));
    ours.push(own("RK4", F::NAME, move |n| ours::form(form, end, &ours::rk4(n)?)));
    others.extend(peers(form, end));
}

/// A scene as it is, by Gauss-Legendre: its torque is asked for one stage after the other.
fn in_space<E: Effect + 'static>(scene: &Rc<Scene<E>>, start: State, end: f64) -> Contestant {
    let scene = scene.clone();
    gauss("scene", move |method| Ok(method.advance(&*scene, 0.0, &start, end)?.0.attitude))
}
