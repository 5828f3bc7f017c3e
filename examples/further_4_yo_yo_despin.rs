//! Further problem 4: yo-yo de-spin of a satellite, by two weights on strings.

#[path = "further_4_yo_yo_despin/figures.rs"]
mod figures;
#[path = "further_4_yo_yo_despin/strings.rs"]
pub mod strings;

use core::f64::consts::PI;
use kit::interval::above_to;
use kit::prelude::*;
use rotation_dynamics::planar::Run;
use strings::{Hangs, Reel, YoYo, zero};

parameters! {
    /// A satellite and its strings; the numbers are typical of a small one.
    pub struct Parameters {
        /// moment of inertia about the axis of the spin
        inertia: number(20.0, "kg m^2", above(0.0).usually(5.0, 80.0)).drawn(10.0, 30.0, 1.0);
        /// radius on which the strings are wound
        radius: number(0.5, "m", above(0.0).usually(0.2, 1.0)).drawn(0.40, 0.80, 0.05);
        /// mass of each of the two weights
        weight: number(0.5, "kg", above(0.0).usually(0.2, 2.0)).drawn(0.3, 1.0, 0.1).open("mass of each weight", "light", "heavy");
        /// spin before
        spin: number(10.0, "rad/s", any().usually(1.0, 20.0)).drawn(5.0, 15.0, 0.5);
        /// length of each string
        string: number(3.0, "m", above(0.0).usually(1.0, 5.0)).drawn(2.0, 4.0, 0.1).open("length of each string", "spins on", "reversed");
        /// spin that is wanted
        aim: number(1.0, "rad/s", any().usually(0.0, 5.0)).drawn(0.5, 2.0, 0.5);
        /// mass of a satellite that has one string only
        body: number(160.0, "kg", above(0.0).usually(50.0, 500.0));
        /// stiffness of the spring in each string of a stretch yo-yo
        spring: number(450.0, "N/m", above(0.0).usually(100.0, 2000.0));
        tolerance: step(1e-14, 1e-6);
    }
}

/// What energy and angular momentum say; lengths in R, masses in 2 m, spins in that before.
#[derive(Debug, Clone, Copy)]
pub struct Answer {
    /// I/(2 m R^2).
    pub inertia: f64,
}

impl Answer {
    /// Spin when a string of this length has unwound, or is let go there.
    pub fn spin_tangent(&self, length: f64) -> f64 {
        let c = self.inertia + 1.0;
        (c - length * length) / (c + length * length)
    }
    /// Spin when it is let go where it points outward.
    pub fn spin_outward(&self, length: f64) -> f64 {
        let (j, c, d) = (self.inertia, self.inertia + 1.0, 1.0 + length);
        let less = (c - d * d) * (c + d * d - 1.0) / ((j * c).sqrt() + d * (d * d - 1.0).sqrt());
        (c / j).sqrt() * less / (j + d * d)
    }
    /// The length for a spin, let go along the tangent.
    pub fn length_tangent(&self, spin: f64) -> f64 {
        ((self.inertia + 1.0) * (1.0 - spin) / (1.0 + spin)).sqrt()
    }
    /// The length for a spin, let go outward.
    pub fn length_outward(&self, spin: f64) -> f64 {
        let (j, c) = (self.inertia, self.inertia + 1.0);
        (c - j * spin) / (c - j * spin * spin).sqrt() - 1.0
    }
    /// Pull of each string when this length has unwound, over 2 m w0^2 R.
    pub fn tension(&self, length: f64) -> f64 {
        let c = self.inertia + 1.0;
        2.0 * self.inertia * c * length / ((c + length * length) * (c + length * length))
    }
    /// The same where it points outward.
    pub fn tension_outward(&self, length: f64) -> f64 {
        let spin = self.spin_outward(length);
        let across = self.speed(length) - spin;
        0.5 * (across * across / length + spin * spin)
    }
    /// Speed of the weights where they are let go outward.
    pub fn speed(&self, length: f64) -> f64 {
        (self.inertia + 1.0 - self.inertia * self.spin_outward(length)) / (1.0 + length)
    }
}

/// The satellite in the units of the simulation, and the answer for it.
pub fn scene(p: &Parameters) -> Result<(YoYo, Answer)> {
    let inertia = p.inertia / (2.0 * p.weight * p.radius * p.radius);
    let (length, answer, aim) = (p.string / p.radius, Answer { inertia }, p.aim / p.spin);
    let most = -((inertia + 1.0) / inertia).sqrt();
    allowed! {
        "size of the spin": p.spin.abs(), above_to(0.0, 1e8), "without a spin the weights stay where they are, and a rim is slower than light";
        "I/(2 m R^2)": inertia, from_to(1e-6, 5e6), "lighter weights need thousands of turns of string";
        "string/radius": length, from_to(1e-3, 1e4), "a shorter one hardly unwinds, a longer one unwinds for thousands of turns";
        "aim/spin": aim, between(most, 1.0), "1 needs no string, and the weights only take energy";
        "string for the aim, over the radius,": answer.length_outward(aim), from_to(0.0, 1e4), "at the limit of the energy it has no end";
    }?;
    Ok((YoYo { inertia, length }, answer))
}

/// The unit of the pull of each string, 2 m w0^2 R.
fn newton(p: &Parameters) -> f64 {
    2.0 * p.weight * p.spin * p.spin * p.radius
}

/// Dawn in 2007: both weights 3 kg, cables of 12 m, from 46 to -3 turns a minute; the radius on
/// which they were wound is a guess.
const DAWN: [f64; 4] = [3.0, 12.0, -3.0 / 46.0, 0.6];

/// Its moment of inertia, kg m^2, from these.
fn dawn() -> f64 {
    let [weights, cable, ratio, radius] = DAWN;
    let d = 1.0 + cable / radius;
    // u = (j (1 - r) + 1)/d in j (1 - r^2) + 1 = u^2: a quadratic in j.
    let two = (1.0 - ratio) * (1.0 - ratio);
    let one = (1.0 - ratio) * (2.0 - d * d * (1.0 + ratio));
    let none = 1.0 - d * d;
    weights * radius * radius * (-one + (one * one - 4.0 * two * none).sqrt()) / (2.0 * two)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (yoyo, a) = scene(p)?;
    let (j, l, bound) = (yoyo.inertia, yoyo.length, 1e3 * p.tolerance);
    let (w, r, newton) = (p.spin, p.radius, newton(p));
    // An error of the rate at which the weights swing counts 1 + l times in their speed.
    let fast = a.speed(l).max(1e-3 * (1.0 + l));
    let pulled = bound * fast / a.speed(l);
    let run = yoyo.run(p.tolerance)?;
    let (ends, out) = (run.transition("unwound")?, run.transition("outward")?);
    let [_, [vx, vy]] = yoyo.weight(&out.before);
    let with = |length| YoYo { length, ..yoyo };
    let (stop, stop_tangent, aim) = (a.length_outward(0.0), a.length_tangent(0.0), p.aim / w);
    let found = |aim: f64| {
        let wanted = a.length_outward(aim);
        let between = [(1e-3 * stop).min(0.5 * wanted), 1.5 * stop.max(wanted)];
        zero(between, |length| Ok(with(length).last_spin(1e-13)? - aim))
    };
    // Without an end of the string the spin goes through zero on the tangent.
    let long = with(3.0 * stop_tangent).run(1e-13)?;
    let still = zero([0.1 * stop_tangent, 2.0 * stop_tangent], |t| Ok(long.at(t)?.1[2]))?;
    let near = |length: f64, more: f64| YoYo { inertia: j * (1.0 + more), length }.last_spin(1e-14);
    let by_inertia = (near(stop, 1e-4)? - near(stop, -1e-4)?) / 2e-4;
    let [longer, shorter] = [1.0 + 1e-4, 1.0 - 1e-4].map(|part| near(stop * part, 0.0));
    let by_length = (longer? - shorter?) / 2e-4;
    // One string: the weight and the satellite move about their common centre of mass.
    let share = p.body / (p.weight + p.body);
    let single = Answer { inertia: 2.0 * j / share };
    let (lone, speed) = (single.spin_outward(l), single.speed(l));
    let reel = Reel { inertia: 2.0 * j, weight: share, length: l, stiffness: None };
    let [lone_spin, lone_speed] = reel.last(1.0, 1e-13)?;
    let push = |speed: f64| w.abs() * r * speed * p.weight / (p.weight + p.body);
    let [weights, cable, ratio, guess] = DAWN;
    let dawned = zero([1.5, 0.5], |part| {
        let inertia = part * dawn() / (weights * guess * guess);
        Ok(YoYo { inertia, length: cable / guess }.last_spin(1e-13)? - ratio)
    })?;
    let (rate, skater) = (w.abs(), w * (j + 1.0) / (j + (1.0 + l) * (1.0 + l)));
    let spin = w * a.spin_outward(l);
    claims! { report,
        /// string that stops it, let go outward
        stop: r * stop, "m", "simulated, zero found" => r * found(0.0)?, within 1e-10 * r * stop, in "To a stop":
            r * stop_tangent => "that is for strings that are let go along the tangent",
            r * ((j + 1.0) * 2.0).sqrt() - r => "there are two weights",
            r * (stop + 1.0) => "that is the distance from the axis";
        /// string that stops it, let go along the tangent
        stop_tangent: r * stop_tangent, "m", "simulated, zero found" => r * still, within 1e-10 * r * stop_tangent, in "To a stop":
            r * stop => "that is for strings that are let go outward",
            r * j.sqrt() => "the weights turn with the satellite before";
        /// string for the spin that is wanted, let go outward
        string_for_aim: r * a.length_outward(aim), "m", "simulated, zero found" => r * found(aim)?, within 1e-10 * r * stop,
        in "To a given spin":
            r * a.length_tangent(aim.max(1e-9 - 1.0)) => "that is for strings that are let go along the tangent";
        /// spin with the given string, let go outward
        spin_outward: spin, "rad/s", "Lagrange, simulated" => w * out.before[2], within bound * rate, in "To a given spin":
            skater => "the strings are no rigid arms: at the end they turn faster than the satellite",
            w * a.spin_tangent(l) => "that is for strings that are let go along the tangent";
        /// spin with the given string, let go along the tangent
        spin_tangent: w * a.spin_tangent(l), "rad/s", "Lagrange, simulated" => w * ends.before[2], within bound * rate,
        in "To a given spin":
            spin => "that is for strings that are let go outward";
        /// time until the string is unwound
        time_unwound: l / rate, "s", "located event" => ends.t / rate, within bound * l / rate;
        /// speed of the weights when they are let go outward
        speed: rate * r * a.speed(l), "m/s", "Lagrange, simulated" => rate * r * hypot(vx, vy), within bound * rate * r * fast;
        /// part of the energy that the weights take along
        taken: 1.0 - j * a.spin_outward(l) * a.spin_outward(l) / (j + 1.0), "-", "Lagrange, simulated" => (vx * vx + vy * vy) / (j + 1.0), within bound;
        /// pull of each string when it is unwound
        tension_unwound: newton * a.tension(l), "N", "Lagrange, simulated" => newton * yoyo.tension(Hangs::Tangent, &ends.before),
        within pulled * newton * a.tension(l), in "The pull of a string";
        /// the same when it points outward
        tension_outward: newton * a.tension_outward(l), "N", "Lagrange, simulated" => newton * yoyo.tension(Hangs::Hook, &out.before),
        within 10.0 * pulled * newton * a.tension_outward(l), in "The pull of a string";
        /// spin that is left for a part of I too much, over w0
        per_inertia: 0.5, "-", "simulated, differences" => by_inertia, within 1e-6;
        /// the same for a part of the string too much
        per_string: -(j + 1.0) / j * stop / (1.0 + stop), "-", "simulated, differences" => by_length, within 1e-6;
        /// spin with one string and one weight
        one_spin: w * lone, "rad/s", "Newton, polar" => w * lone_spin, within 1e-6 * rate;
        /// speed that this gives the satellite
        one_push: push(speed), "m/s", "Newton, polar" => push(lone_speed), within 1e-6 * push(speed);
        /// moment of inertia of Dawn with its third stage
        dawn: dawn(), "kg m^2", "simulated, zero found" => dawned * dawn(), within 1e-9 * dawn();
        /// wrong: spin with rigid arms of that length
        naive_arms: skater, "rad/s", "a ring of 2 m" => w / (1.0 + (2.0 * l + l * l) / (j + 1.0)), within bound * rate;
    }
}

/// No string, heavy weights, a satellite that is nothing but its weights.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let (light, heavy) = (Answer { inertia: 80.0 }, Answer { inertia: 1e8 });
    let stiff = Reel { inertia: 80.0, weight: 1.0, length: 6.0, stiffness: Some(1e6) };
    limits! { report,
        /// nothing has unwound
        "l/R = 0: omega/w0": light.spin_outward(0.0) => 1.0, within 1e-15;
        /// far out the weights keep no energy: as fast as before, backward
        "l/R = 1/x, tangent: omega/w0": light.spin_tangent(1e9) => -1.0, within 1e-15;
        /// where the strings are let go does not matter
        "I/(2 m R^2) = 1/x: stop sqrt(x)/R": heavy.length_outward(0.0) / 1e4 => 1.0, within 2e-4;
        /// twice the angular velocity of the satellite at the start
        "l/R = x, unwound: Omega/w0": YoYo { inertia: 80.0, length: 1e-3 }.run(1e-13)?.transition("unwound")?.before[3] => 2.0, within 1e-6;
        /// springs that hardly give, by Newton's law
        "stiff springs: omega/w0": stiff.last(1.0, 1e-12)?[0] => light.spin_outward(6.0), within 1e-5;
    }
}

/// Strings of Kevlar 1.5 mm thick (70 GPa, 1440 kg/m^3), long enough for a stop, and weights of
/// 4 cm that turn with them.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let a = scene(p)?.1;
    let (j, stop) = (a.inertia, a.length_outward(0.0));
    let area = 0.25 * PI * 1.5e-3 * 1.5e-3;
    let heavy = 1440.0 * area * p.radius / p.weight;
    let shorter = 1.0 - heavy_stop(&a, heavy)? / stop;
    let most = a.tension(((j + 1.0) / 3.0).sqrt().min(stop)).max(a.tension_outward(stop));
    let stretch = newton(p) * most / (70e9 * area);
    let size = 0.4 * 0.02 * 0.02 / (p.radius * p.radius);
    let thick = 0.75e-3 / p.radius;
    let per = (j + 1.0) / j * stop / (1.0 + stop);
    let left = YoYo { inertia: 1.01 * j, length: stop }.last_spin(1e-12)?;
    effect_card! { report,
        "moment of inertia, known to 1 %": "dI/I" = 0.01, costs 0.005, "of w0", measured left;
        "mass of the strings": "mu/(2 m)" = heavy * stop, costs shorter.abs() * per, "of w0";
        "thickness of the strings": "d/(2 R)" = thick, costs thick * per / (1.0 + stop), "of w0";
        "stretch of the strings": "T/(E A)" = stretch, costs stretch * per, "of w0, at most";
        "size of the weights": "2 b^2/(5 R^2)" = size, costs size / (2.0 * j * stop * stop), "of w0";
    }
}

/// The string that stops the satellite, let go outward, if the strings have mass: each unit of
/// length `heavy` times a weight.
pub fn heavy_stop(a: &Answer, heavy: f64) -> Result<f64> {
    // At the stop: angular momentum = turns * moment, energy = turns^2 * square.
    let stop = a.length_outward(0.0);
    zero([0.1 * stop, 2.0 * stop], |l| {
        let mu = heavy * l;
        let moment = l * ((1.0 + l) + mu * (0.5 + l / 3.0));
        let square = l * l * (1.0 + mu / 3.0);
        Ok((a.inertia + 1.0 + mu) * square / (moment * moment) - 1.0)
    })
}

/// The accuracy strip: the spin after the release.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (yoyo, a) = scene(p)?;
    let last = a.spin_outward(yoyo.length);
    report.set_closed_form(ClosedForm::new(move |part| {
        let l = part * yoyo.length;
        Ok::<_, rotation_dynamics::Error>([a.spin_tangent(l), a.spin_outward(l), a.tension(l)])
    }));
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
    let error = move |run: &Run<Hangs, 4>| Ok(run.transition("outward")?.before[2] - last);
    report.stepped(asked, move |step| yoyo.run(step), Run::work, error)
}

/// Strings with a spring and without, both made for the spin that is wanted, for other spins
/// before and another moment of inertia: what is left.
fn stretch(p: &Parameters, report: &mut Report) -> Result<()> {
    let (yoyo, a) = scene(p)?;
    let (w, aim) = (p.spin, p.aim / p.spin);
    // A spring that is too soft, or longer than the string, leaves no spin that is wanted.
    let (springs, length) = (sprung(p), a.length_outward(aim));
    let columns =
        ["spin before / (rad/s)", "I / that foreseen", "rigid / (rad/s)", "with springs / (rad/s)"];
    let spins = [0.8, 0.9, 1.0, 1.1, 1.2].map(|before| [before, 1.0]);
    let cases = spins.into_iter().chain([[1.0, 0.95], [1.0, 1.05]]);
    report.add(Table::of("stretch", columns, cases, |[before, part]| {
        let inertia = part * yoyo.inertia;
        let rigid = before * YoYo { inertia, length }.last_spin(1e-12)?;
        let sprung = match &springs {
            Ok(springs) => {
                let left = springs.but(|springs| springs.inertia = inertia).last(before, 1e-10)?;
                format!("{:.3}", w * left[0])
            }
            Err(_) => "none holds".into(),
        };
        let [before, part, rigid] = [w * before, part, w * rigid].map(|x| format!("{x:.3}"));
        Ok([before, part, rigid, sprung])
    })?)
}

/// The stretch yo-yo that leaves the spin that is wanted.
pub fn sprung(p: &Parameters) -> Result<Reel> {
    let ((yoyo, a), aim) = (scene(p)?, p.aim / p.spin);
    let stiffness = p.spring / (p.weight * p.spin * p.spin);
    allowed! { "spring/(m w0^2)": stiffness, above(2.0), "a softer spring is drawn out without an end"; }?;
    // A stiffer one gives less than a millionth of its length.
    let stiffness = Some(stiffness).filter(|stiffness| *stiffness <= 1e6);
    let reel = |length| Reel { inertia: yoyo.inertia, weight: 1.0, length, stiffness };
    let (rigid, left) = (a.length_outward(aim), |length| reel(length).last(1.0, 1e-10));
    Ok(reel(zero([0.05 * rigid, 1.2 * rigid], |length| Ok(left(length)?[0] - aim))?))
}

example! {
    further_4_yo_yo_despin: "Further problem 4: two weights on strings stop the spin of a satellite";
    "Yo-yo de-spin", "Two weights on strings unwind from a spinning satellite and take its spin.",
    [claims, limits, effects, accuracy, stretch];
    figures::figures, figures::trajectory, figures::moving_picture
}
