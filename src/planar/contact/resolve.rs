//! Which modes follow: at the start, where a contact lets go or touches, where a slip ends.

use super::declare::{Contact, MechanismState, Mode, Press, Sense, dot};
use super::modal::Modal;
use super::response::{Choices, Problem, Response, Unsolved, ZERO};
use super::{Mechanism, Modes};
use crate::error::{Error, FINITE, Result, all_finite, finite};
use crate::math::EPS;
use crate::planar::{Entry, Rest};

/// Corrections of coordinates that are brought back onto their contacts, at most.
const CORRECTIONS: usize = 3;

/// The event that ended the modes before.
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

/// The consequence of an event.
pub(super) struct Entered<const N: usize, const C: usize> {
    pub modes: Modes<C>,
    pub state: MechanismState<N>,
    pub rest: Option<Rest>,
}

impl<const N: usize, const S: usize, const C: usize> From<Entered<N, C>> for Entry<Modes<C>, S> {
    fn from(Entered { modes, state, rest }: Entered<N, C>) -> Self {
        Self { phase: modes, state: state.to_array(), rest }
    }
}

/// The modes that follow, and the state put onto their contacts, after impacts.
pub(super) fn enter<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    t: f64,
    before: Before<C>,
    mut start: MechanismState<N>,
) -> Result<Entered<N, C>> {
    const { assert!(C <= super::MOST_CONTACTS && N + 2 * C <= super::linear::SIZE) };
    if let Some((modes, _)) = &before {
        put_on(scene, modes, &mut start);
    } else {
        check_start(scene, t, &start)?;
    }
    check_masses(scene, t, &start)?;
    let shut = shut(scene, &before, &start);
    let contacts = scene.0.contacts(&start);
    let speed = contacts.map(|c| c.normal.speed(&start.v));
    let hits: [bool; C] = core::array::from_fn(|i| {
        let pushes = contacts[i].press == Press::OneSided;
        pushes && shut[i] && speed[i] < -ZERO * scene.normal_size(i, &start)
    });
    let all = (0..C).filter(|&i| hits[i]);
    let fastest = all.min_by(|&i, &k| speed[i].total_cmp(&speed[k]));
    let trigger = before.map(|(_, trigger)| trigger);
    let trigger = trigger.filter(|_| fastest.is_none());
    let mass = scene.0.mass(&start.q);
    // A contact that would leave an impact and get no higher than counts as no gap is kept shut: by a
    // plastic impact, in the place of all bounces that follow. Until they are over, both bring the
    // same normal speed to 0 and the gap back to 0 under the same loads. So its impulses sum to the
    // same, and so do those of its friction while it slips. The difference is of the size of that
    // height.
    let (mut stay, mut rest) = ([false; C], None::<Rest>);
    loop {
        let mut state = start;
        if fastest.is_some() {
            state.v = impact(scene, t, [&shut, &hits, &stay], &start)?;
        }
        let contacts = scene.0.contacts(&state);
        let choices =
            core::array::from_fn(|i| choices(scene, i, &contacts[i], shut[i], trigger, &state));
        let (modes, Response { rate, .. }) = scene
            .newton(&state, &mass, &contacts)
            .search(&choices)
            .map_err(|unsolved| named(unsolved, t, &contacts, &state))?;
        let low = |i: usize| {
            let height = bounce(&contacts[i], &state, &rate)[0];
            modes[i] == Mode::Open && height < ZERO * scene.gap_size(i, &state)
        };
        let low = |i: &usize| shut[*i] && !stay[*i] && low(*i);
        let (Some(first), Some(i)) = (fastest, (0..C).find(low)) else {
            put_on(scene, &modes, &mut state);
            return Ok(Entered { modes, state, rest });
        };
        let [height, lasts] = bounce(&contacts[i], &state, &rate);
        // The part of the speed that a bounce leaves; where contacts hit in turn, the part here.
        let leaves = match hits[i] {
            true => contacts[i].restitution,
            false => contacts[i].normal.speed(&state.v) / -speed[first],
        };
        let last = t + lasts / (1.0 - leaves).max(0.0);
        if rest.is_none_or(|rest| rest.t < last) {
            let (contact, t) = (contacts[first].name, last);
            rest = Some(Rest { contact, height, t });
        }
        stay[i] = true;
    }
}

/// The modes that contact `i` may have next.
fn choices<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    i: usize,
    contact: &Contact<N>,
    shut: bool,
    trigger: Option<Trigger>,
    state: &MechanismState<N>,
) -> Choices {
    let leaves = contact.normal.speed(&state.v) > ZERO * scene.normal_size(i, state);
    match contact.press {
        Press::TwoSided => return Choices::only(Mode::Smooth),
        Press::OneSided if !shut || leaves => return Choices::only(Mode::Open),
        Press::By(_) if !shut => return Choices::only(Mode::Open),
        _ => {}
    }
    let slips = slips(scene, i, contact, state).filter(|_| trigger != Some(Trigger::Slip(i)));
    let may_open = matches!(contact.press, Press::OneSided | Press::By(_));
    let all = if let Some(sense) = slips {
        Choices::of(&[Mode::Slip(sense), Mode::Open][..1 + usize::from(may_open)], false)
    } else {
        Choices::shut(contact.friction.holding > 0.0, may_open)
    };
    match trigger {
        Some(Trigger::Force(k)) if k == i => all.retain(|m| m == Mode::Open).decided(),
        Some(Trigger::Cone(k, sense)) if k == i => {
            all.retain(|m| m == Mode::Open || m == Mode::Slip(sense)).decided()
        }
        _ => all,
    }
}

/// Which way contact `i` slips, if it rubs and does.
fn slips<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    i: usize,
    contact: &Contact<N>,
    state: &MechanismState<N>,
) -> Option<Sense> {
    let slip = contact.tangent.speed(&state.v);
    let slips = slip.abs() > ZERO * scene.slip_size(i, state);
    (contact.friction.holding > 0.0 && slips).then_some(if slip > 0.0 {
        Sense::Forward
    } else {
        Sense::Backward
    })
}

/// How high a contact bounces that leaves with these velocities and accelerations, and how long;
/// for ever if it is not brought back.
fn bounce<const N: usize>(
    contact: &Contact<N>,
    state: &MechanismState<N>,
    rate: &[f64; N],
) -> [f64; 2] {
    let speed = contact.normal.speed(&state.v);
    let back = -dot(&contact.normal.along, rate) - contact.normal.bias;
    if back > 0.0 { [0.5 * speed * speed / back, 2.0 * speed / back] } else { [f64::INFINITY; 2] }
}

/// Which contacts can act: those that did, that has just closed, or whose gap is round-off.
fn shut<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    before: &Before<C>,
    state: &MechanismState<N>,
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

/// The velocities after the impulses of all contacts that are `shut`, of which some hit. Those
/// that `stay` shut neither return anything nor let go, though they had to pull.
fn impact<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    t: f64,
    [shut, hits, stay]: [&[bool; C]; 3],
    state: &MechanismState<N>,
) -> Result<[f64; N]> {
    let mut contacts = scene.0.contacts(state);
    let aim = core::array::from_fn(|i| {
        let Contact { normal, tangent, restitution, .. } = &contacts[i];
        let returned =
            if hits[i] && !stay[i] { -restitution * normal.speed(&state.v) } else { 0.0 };
        [normal.surface + returned, tangent.surface]
    });
    let choices = core::array::from_fn(|i| match contacts[i].press {
        Press::TwoSided => Choices::only(Mode::Smooth),
        // What would let go is pulled back: friction that holds could not say how.
        _ if stay[i] && !hits[i] => Choices::only(match slips(scene, i, &contacts[i], state) {
            Some(sense) => Mode::Slip(sense),
            None => Mode::Smooth,
        }),
        Press::OneSided | Press::By(_) if shut[i] => {
            Choices::shut(contacts[i].friction.kinetic > 0.0, !stay[i])
        }
        _ => Choices::only(Mode::Open),
    });
    for i in (0..C).filter(|&i| stay[i]) {
        contacts[i].press = Press::TwoSided;
    }
    let mass = scene.0.mass(&state.q);
    let problem = Problem {
        mass: &mass,
        load: momentum(&mass, &state.v),
        contacts: &contacts,
        aim,
        impact: true,
    };
    let (_, Response { rate, .. }) =
        problem.search(&choices).map_err(|unsolved| named(unsolved, t, &contacts, state))?;
    let energy = |v: &[f64; N]| 0.5 * dot(v, &momentum(&mass, v));
    let (before, after) = (energy(&state.v), energy(&rate));
    let moved = contacts.iter().any(|c| c.normal.surface != 0.0 || c.tangent.surface != 0.0);
    if !moved && after > before * (1.0 + 1e3 * ZERO) {
        return Err(Error::ImpactGainsEnergy { t, before, after });
    }
    Ok(rate)
}

fn momentum<const N: usize>(mass: &[[f64; N]; N], v: &[f64; N]) -> [f64; N] {
    core::array::from_fn(|j| dot(&mass[j], v))
}

/// Moves coordinates and velocities onto the contacts that act, by least action on the masses: this
/// takes back the drift of the integration.
pub(super) fn put_on<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    modes: &Modes<C>,
    state: &mut MechanismState<N>,
) {
    let correct = |state: &mut MechanismState<N>, of_coordinates: bool| {
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
                [-contact.normal.speed(&state.v), -contact.tangent.speed(&state.v)]
            }
        });
        let problem =
            Problem { mass: &mass, load: [0.0; N], contacts: &contacts, aim, impact: true };
        // Contacts that cannot be met together are left as they are.
        if let Some(response) = problem.respond(&modes) {
            let moved = if of_coordinates { &mut state.q } else { &mut state.v };
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
fn check_masses<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    t: f64,
    state: &MechanismState<N>,
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
fn check_start<M: Mechanism<N, C>, const N: usize, const C: usize>(
    scene: &Modal<M, N, C>,
    t: f64,
    state: &MechanismState<N>,
) -> Result<()> {
    all_finite("coordinates", &state.q)?;
    all_finite("velocities", &state.v)?;
    let contacts = scene.0.contacts(state);
    for (i, contact) in contacts.iter().enumerate() {
        let Contact { gap, friction, restitution, .. } = *contact;
        for (name, value, good, allowed) in [
            ("friction", friction.kinetic, friction.kinetic >= 0.0, "it must not be negative"),
            (
                "friction that holds",
                friction.holding,
                friction.holding >= friction.kinetic,
                "it must be at least that of slipping",
            ),
            ("restitution", restitution, (0.0..=1.0).contains(&restitution), "from 0 to 1"),
        ] {
            finite(name, value)?;
            if !good {
                return Err(Error::out_of_range(name, value, allowed));
            }
        }
        let speed = contact.normal.speed(&state.v);
        let (no_gap, no_speed) =
            (ZERO * scene.gap_size(i, state), ZERO * scene.normal_size(i, state));
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
            return Err(Error::CannotHold { name: contact.name, t, value: gap, rate: Some(speed) });
        }
    }
    Ok(())
}

fn named<const N: usize, const C: usize>(
    unsolved: Unsolved<C>,
    t: f64,
    contacts: &[Contact<N>; C],
    state: &MechanismState<N>,
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
