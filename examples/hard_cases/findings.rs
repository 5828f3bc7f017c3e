//! What an attack on the library found, each as it was found: motions of which too much was once
//! promised, that ran for ever, or gave no number; and where the other findings are tested.

use super::naive::{BELIEVED, COARSE, FEWER};
use super::rotations::start;
use super::*;

/// Exactly about the middle axis.
pub fn on_the_middle(end: f64) -> Solved<Motion> {
    let from = turned(1.0, 0.5, 2.0)?;
    Ok(Motion::free([1.0, 2.0, 2.5], from, [0.0, 1.0, 0.0], end))
}

/// A top without spin whose push just lifts it to the vertical.
fn gets_up() -> Solved<Motion> {
    let (rate, (s, c)) = (2.0 * sin(1.25), sincos(1.0));
    let (tilted, rates) = (turned(0.3, 2.5, 1.0)?, [rate * c, -rate * s, 0.0]);
    Ok(Motion::top([1.0, 0.5], 1.0, tilted, rates, 80.0))
}

/// Released upside down at rest: taken for the motion that never leaves, and then no number.
fn inverted(moments: [f64; 2], pull: f64, end: f64) -> Solved<Motion> {
    let down = turned(0.597, PI, -7.354)?;
    Ok(Motion::top(moments, pull, down, [0.0; 3], end))
}

family! { FINDINGS, "findings": "Found by attack", |_| [SOLVE], in NAMES;
    // Granted once 4e-5, 1e-10, 3e-3 and 1e-3 rad, and off by 0.046, 1.4e-6, 3.14 and 1.83.
    "middle axis, 100 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        on_the_middle(100.0)?.promised(How::Request, 4e-5, BELIEVED);
    "middle axis, 100 s, stepped", "a condition felt on changes of 1e-12 is that of a tame motion":
        on_the_middle(100.0)?.promised(How::Solve, 4e-5, BELIEVED);
    "5e-15 off the middle axis, 100 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        Motion::free([1.0, 2.0, 2.5], start()?, [5e-15, 1.0, 0.0], 100.0).promised(How::Request, 1e-10, BELIEVED);
    "middle axis of another, 200 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        Motion::free([1.0, 1.5, 2.0], start()?, [0.0, 1.0, 0.0], 200.0).promised(How::Request, 3e-3, BELIEVED);
    "a top that just gets up, 80 s", "a condition felt on changes of 1e-12 is that of a tame motion":
        gets_up()?.promised(How::Request, 1e-3, BELIEVED);
    "the same, stepped", "a condition felt on changes of 1e-12 is that of a tame motion":
        gets_up()?.promised(How::Solve, 1e-3, BELIEVED);
    "rates of 4e-81 beside one of 1 rad/s", "an argument beside 1e-81 was halved for ever":
        Motion::free([1.0, 2.0, 2.5], start()?, [4e-81, 4e-81, 1.0], 30.0).promised(How::Request, 1e-9, COARSE);
    "inverted at rest, a weak weight, 200 s", "pi as a double is 6e-17 off, which is a fall":
        inverted([0.3, 0.5], -0.00981, 200.0)?.promised(How::Request, 1e-6, FEWER);
    "inverted at rest, 1000 s", "pi as a double is 6e-17 off, which is a fall":
        inverted([1.0, 1.0], -46.246_407_947_939_46 * 0.043_441_341_552_221_39, 1000.0)?
            .promised(How::Request, 1e-6, FEWER);
}

/// What else was found, and the test that sees it.
#[rustfmt::skip]
pub const ELSEWHERE: [[&str; 2]; 18] = [
    ["pulses narrower than a step, unnamed", "narrow_pulses_are_seen"],
    ["momentum that grows 300 times: a probe that failed ended the answer", "the_truth_costs_no_answer"],
    ["a start at rest, a million turns, without end", "no_run_without_end"],
    ["dry friction on L to a stop, and a brake of 1e7/s: a billion stable steps", "no_run_without_end"],
    ["a torque that is no number", "what_is_no_number_is_named"],
    ["an effect that sees the axis and has no form for that was integrated without its torque", "no_torque_is_forgotten"],
    ["a torque whose scale is negative, or no number", "contradictions_are_named"],
    ["angles of so many turns that they are no number", "angles_of_too_many_turns_are_refused"],
    ["--csv put a file in the place of a device, a pipe, a link", "links_and_pipes_are_written_through_and_devices_refused"],
    ["a full disk, and an exit status of 0", "a_full_disk_is_an_error_and_a_reader_gone_is_none"],
    ["jumps without a name, refused with a wrong reason", "jumps_without_a_name_are_found"],
    ["least tilt and period left out beside a pole", "near_a_pole_nothing_is_left_out"],
    ["up to 262 times the torques of the cheapest method", "the_price_of_not_knowing_is_bounded"],
    ["the torques of a run that failed", "work_that_came_to_nothing_is_counted"],
    ["a tenth of all torques, which the sum left out", "all_torques_are_counted"],
    ["an error control of scenes in phases that takes 16 times the error", "two_runs_agree_within_half_the_tolerance"],
    ["one that does not look at the states at events", "states_at_events_are_compared"],
    ["a pendulum that is harmonic up to k^2 = 1e-9", "small_swings_are_not_harmonic"],
];
