//! Which modes follow: at the start, where a contact lets go or touches, where a slip ends.

use super::declare::{Contact, Mode, Press, Sense, State, dot};
use super::modal::{Modal, join, split};
use super::response::{Choices, Problem, Response, Unsolved, ZERO};
use super::{Mechanism, Modes};
use crate::error::{Error, FINITE, Result, finite};
use crate::math::EPS;

/// Corrections of coordinates that are brought back onto their contacts, at most.
const CORRECTIONS: usize = 3;

/// A bounce lower than this part of the size of its gap is not resolved: 64 eps.
const UNRESOLVED: f64 = 64.0 * EPS;

/// What ended the modes before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Trigger {
    /// A normal force came down to 0.
    Force(usize),
    /// A sticking contact is about to slip.
    Cone(usize, Sense),
    /// A slip came to an end.
    Slip(usize),
    /// A gap closed.
    Gap(usize),
}

/// Where the modes before ended: they, and why.
type Before<const C: usize> = Option<(Modes<C>, Trigger)>;

/// The modes that follow, and the state put onto their contacts, after impacts.
pub(super) fn enter<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    t: f64,
    before: Before<C>,
    state: &[f64; S],
) -> Result<(Modes<C>, [f64; S])> {
    const { assert!(C <= super::MOST_CONTACTS && N + 2 * C <= super::linear::SIZE) };
    let mut state = split(state);
    if let Some((modes, _)) = &before {
        put_on(scene, modes, &mut state);
    } else {
        check_start(scene, t, &state)?;
    }
    check_masses(scene, t, &state)?;
    let shut = shut(scene, &before, &state);
    let hit = impact(scene, t, &shut, &mut state)?;
    let contacts = scene.0.contacts(&state);
    let trigger = before.map(|(_, trigger)| trigger).filter(|_| !hit);
    let choices =
        core::array::from_fn(|i| choices(scene, i, &contacts[i], shut[i], trigger, &state));
    let mass = scene.0.mass(&state.q);
    let problem = scene.newton(&state, &mass, &contacts);
    let (modes, Response { rate, .. }) = problem
        .search(&choices)
        .map_err(|unsolved| named(unsolved, t, &contacts, &state))?;
    for i in (0..C).filter(|&i| hit && shut[i] && modes[i] == Mode::Open) {
        resolved(scene, i, &contacts[i], t, &state, &rate)?;
    }
    put_on(scene, &modes, &mut state);
    Ok((modes, join(&state)))
}

/// What contact `i` may do next.
fn choices<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    i: usize,
    contact: &Contact<N>,
    shut: bool,
    trigger: Option<Trigger>,
    state: &State<N>,
) -> Choices {
    let leaves = contact.normal.speed(&state.v) > ZERO * scene.normal_size(i, state);
    match contact.press {
        Press::TwoSided => return Choices::only(Mode::Smooth),
        Press::OneSided if !shut || leaves => return Choices::only(Mode::Open),
        Press::By(_) if !shut => return Choices::only(Mode::Open),
        _ => {}
    }
    let rubs = contact.friction.holding > 0.0;
    let slip = contact.tangent.speed(&state.v);
    let slips = trigger != Some(Trigger::Slip(i)) && slip.abs() > ZERO * scene.slip_size(i, state);
    let may_open = matches!(contact.press, Press::OneSided | Press::By(_));
    let sense = if slip > 0.0 {
        Sense::Forward
    } else {
        Sense::Backward
    };
    let all = if rubs && slips {
        Choices::of(
            &[Mode::Slip(sense), Mode::Open][..1 + usize::from(may_open)],
            false,
        )
    } else {
        Choices::shut(rubs, may_open)
    };
    match trigger {
        Some(Trigger::Force(k)) if k == i => all.retain(|m| m == Mode::Open).decided(),
        Some(Trigger::Cone(k, sense)) if k == i => all
            .retain(|m| m == Mode::Open || m == Mode::Slip(sense))
            .decided(),
        _ => all,
    }
}

/// Refuses a bounce of contact `i` that is too low to be seen in its gap.
fn resolved<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    i: usize,
    contact: &Contact<N>,
    t: f64,
    state: &State<N>,
    rate: &[f64; N],
) -> Result<()> {
    let Contact { normal, name, .. } = contact;
    // Up with u, back with the acceleration -a: u^2/(2a) high.
    let back = -dot(&normal.along, rate) - normal.bias;
    let height = 0.5 * normal.speed(&state.v) * normal.speed(&state.v) / back;
    if back > 0.0 && height < UNRESOLVED * scene.gap_size(i, state) {
        return Err(Error::BouncesUnresolved {
            contact: name,
            t,
            height,
        });
    }
    Ok(())
}

/// Which contacts can act: those that did, that has just closed, or whose gap is round-off.
fn shut<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    before: &Before<C>,
    state: &State<N>,
) -> [bool; C] {
    let contacts = scene.0.contacts(state);
    let shut: [bool; C] = core::array::from_fn(|i| {
        let acted = before
            .is_some_and(|(modes, trigger)| modes[i] != Mode::Open || trigger == Trigger::Gap(i));
        acted
            || contacts[i].press != Press::OneSided
            || contacts[i].gap <= ZERO * scene.gap_size(i, state)
    });
    core::array::from_fn(|i| match contacts[i].press {
        Press::By(by) => shut[by],
        _ => shut[i],
    })
}

/// Changes the velocities by the impulses of contacts that are shut and still closing;
/// whether there were any.
fn impact<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    t: f64,
    shut: &[bool; C],
    state: &mut State<N>,
) -> Result<bool> {
    let contacts = scene.0.contacts(state);
    let speed = contacts.map(|c| c.normal.speed(&state.v));
    let hits = |i: usize| {
        let pushes = contacts[i].press == Press::OneSided;
        pushes && shut[i] && speed[i] < -ZERO * scene.normal_size(i, state)
    };
    if !(0..C).any(hits) {
        return Ok(false);
    }
    let mass = scene.0.mass(&state.q);
    let problem = Problem {
        mass: &mass,
        load: momentum(&mass, &state.v),
        contacts: &contacts,
        aim: core::array::from_fn(|i| {
            let returned = if hits(i) {
                -contacts[i].restitution * speed[i]
            } else {
                0.0
            };
            let surface = [contacts[i].normal.surface, contacts[i].tangent.surface];
            [surface[0] + returned, surface[1]]
        }),
        impact: true,
    };
    let choices = core::array::from_fn(|i| match contacts[i].press {
        Press::TwoSided => Choices::only(Mode::Smooth),
        Press::OneSided | Press::By(_) if shut[i] => {
            Choices::shut(contacts[i].friction.kinetic > 0.0, true)
        }
        _ => Choices::only(Mode::Open),
    });
    let (_, Response { rate, .. }) = problem
        .search(&choices)
        .map_err(|unsolved| named(unsolved, t, &contacts, state))?;
    let energy = |v: &[f64; N]| 0.5 * dot(v, &momentum(&mass, v));
    let (before, after) = (energy(&state.v), energy(&rate));
    let moved = contacts
        .iter()
        .any(|c| c.normal.surface != 0.0 || c.tangent.surface != 0.0);
    if !moved && after > before * (1.0 + 1e3 * ZERO) {
        return Err(Error::ImpactGainsEnergy { t, before, after });
    }
    state.v = rate;
    Ok(true)
}

fn momentum<const N: usize>(mass: &[[f64; N]; N], v: &[f64; N]) -> [f64; N] {
    core::array::from_fn(|j| dot(&mass[j], v))
}

/// Moves coordinates and velocities onto the contacts that act, by least action on the
/// masses: what the integration has drifted away.
pub(super) fn put_on<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    modes: &Modes<C>,
    state: &mut State<N>,
) {
    let correct = |state: &mut State<N>, of_coordinates: bool| {
        let contacts = scene.0.contacts(state);
        let mass = scene.0.mass(&state.q);
        let modes = core::array::from_fn(|i| match (contacts[i].press, modes[i]) {
            (_, Mode::Open) => Mode::Open,
            (_, Mode::Stick) if !of_coordinates => Mode::Stick,
            (Press::Given(_) | Press::By(_), _) => Mode::Open,
            _ => Mode::Smooth,
        });
        let aim = core::array::from_fn(|i| {
            let contact = &contacts[i];
            if of_coordinates {
                [-contact.gap, 0.0]
            } else {
                [
                    -contact.normal.speed(&state.v),
                    -contact.tangent.speed(&state.v),
                ]
            }
        });
        let problem = Problem {
            mass: &mass,
            load: [0.0; N],
            contacts: &contacts,
            aim,
            impact: true,
        };
        // Contacts that cannot be met together are left as they are.
        if let Some(response) = problem.respond(&modes) {
            let moved = if of_coordinates {
                &mut state.q
            } else {
                &mut state.v
            };
            for (c, more) in moved.iter_mut().zip(response.rate) {
                *c += more;
            }
        }
    };
    for _ in 0..CORRECTIONS {
        correct(state, true);
    }
    correct(state, false);
}

/// Refuses masses and forces that no motion follows from.
fn check_masses<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    t: f64,
    state: &State<N>,
) -> Result<()> {
    let mass = scene.0.mass(&state.q);
    if !is_positive(&mass) {
        return Err(Error::of_function(
            "mass matrix, row after row,",
            t,
            ("coordinates", state.q.to_vec()),
            &mass.concat(),
            "it must be symmetric and positive definite",
        ));
    }
    let force = scene.0.force(state);
    if !force.iter().all(|f| f.is_finite()) {
        return Err(Error::of_function(
            "force",
            t,
            ("coordinates and velocities", [state.q, state.v].concat()),
            &force,
            FINITE,
        ));
    }
    Ok(())
}

/// Whether a matrix is symmetric and positive definite, but for round-off: whether Gauss
/// elimination leaves a positive part of each element of the diagonal.
fn is_positive<const N: usize>(mass: &[[f64; N]; N]) -> bool {
    let mut left = *mass;
    for k in 0..N {
        let pivot = left[k];
        // Written so that NaN is not positive.
        if !(pivot[k] > EPS * mass[k][k] && pivot[k].is_finite()) {
            return false;
        }
        for i in k + 1..N {
            let round_off = ZERO * mass[i][i].sqrt() * mass[k][k].sqrt();
            let symmetric = (mass[i][k] - mass[k][i]).abs() <= round_off;
            if !symmetric {
                return false;
            }
            let factor = left[i][k] / pivot[k];
            for j in k..N {
                left[i][j] -= factor * pivot[j];
            }
        }
    }
    true
}

/// Refuses contacts that cannot hold at the start, and coefficients that mean nothing.
fn check_start<M: Mechanism<N, S, C>, const N: usize, const S: usize, const C: usize>(
    scene: &Modal<M, N, S, C>,
    t: f64,
    state: &State<N>,
) -> Result<()> {
    let contacts = scene.0.contacts(state);
    for (i, contact) in contacts.iter().enumerate() {
        let Contact {
            gap,
            friction,
            restitution,
            ..
        } = *contact;
        for (name, value, good, allowed) in [
            (
                "friction",
                friction.kinetic,
                friction.kinetic >= 0.0,
                "it must not be negative",
            ),
            (
                "friction that holds",
                friction.holding,
                friction.holding >= friction.kinetic,
                "it must be at least that of slipping",
            ),
            (
                "restitution",
                restitution,
                (0.0..=1.0).contains(&restitution),
                "from 0 to 1",
            ),
        ] {
            finite(name, value)?;
            if !good {
                return Err(Error::out_of_range(name, value, allowed));
            }
        }
        let speed = contact.normal.speed(&state.v);
        let (no_gap, no_speed) = (
            ZERO * scene.gap_size(i, state),
            ZERO * scene.normal_size(i, state),
        );
        // Written so that NaN does not hold.
        let holds = match contact.press {
            Press::OneSided => gap > no_gap || (gap >= -no_gap && speed >= -no_speed),
            Press::TwoSided => gap.abs() <= no_gap && speed.abs() <= no_speed,
            Press::Given(force) => {
                finite("force that presses", force)?;
                force >= 0.0
            }
            Press::By(by) => {
                let other = contacts.get(by).map(|other| other.press);
                if by == i || matches!(other, None | Some(Press::By(_) | Press::TwoSided)) {
                    return Err(Error::out_of_range(
                        "place of the contact that presses",
                        by as f64,
                        "that of another contact, which pushes and does not pull",
                    ));
                }
                true
            }
        };
        if !holds {
            return Err(Error::CannotHold {
                name: contact.name,
                t,
                value: gap,
                rate: Some(speed),
            });
        }
    }
    Ok(())
}

fn named<const N: usize, const C: usize>(
    unsolved: Unsolved<C>,
    t: f64,
    contacts: &[Contact<N>; C],
    state: &State<N>,
) -> Error {
    let say = |modes: &Modes<C>| {
        let each: Vec<_> = contacts
            .iter()
            .zip(modes)
            .map(|(contact, mode)| {
                let does = match mode {
                    Mode::Open => "opens",
                    Mode::Smooth => "pushes",
                    Mode::Stick => "sticks",
                    Mode::Slip(Sense::Forward) => "slips forward",
                    Mode::Slip(Sense::Backward) => "slips backward",
                };
                format!("{} {does}", contact.name)
            })
            .collect();
        each.join(", ")
    };
    Error::ContactsUndetermined {
        t,
        state: [state.q, state.v].concat(),
        tried: unsolved.tried,
        motions: unsolved.motions.iter().map(say).collect(),
    }
}
