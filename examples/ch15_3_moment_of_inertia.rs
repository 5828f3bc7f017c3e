//! Section 15.3: the kinetic energy of a rigid body, its tensor of inertia, and its principal axes.

#[path = "ch15_3_moment_of_inertia/bodies.rs"]
mod bodies;
#[path = "ch15_3_moment_of_inertia/figures.rs"]
mod figures;
#[path = "ch15_3_moment_of_inertia/solids.rs"]
mod solids;

pub use bodies::*;
use core::f64::consts::PI;
use kit::prelude::*;
use kit::short;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, solids as uniform};
use rotation_dynamics::integrators::{Dop853, Integrator, Work, ode, size_or};
use rotation_dynamics::math::EPS;
pub use solids::compared;

parameters! {
    /// The plate of the examples, a square unless told otherwise, and how four masses turn.
    pub struct Parameters {
        /// mass of the plate
        mass: number(1.5, "kg", from_to(1e-9, 1e9).usually(0.5, 5.0));
        /// edge of the plate along x
        width: number(0.4, "m", from_to(1e-9, 1e9).usually(0.1, 1.0)).open("edge of the plate along x", "tall", "wide");
        /// edge of the plate along y; of a square the same
        height: number(0.4, "m", from_to(1e-9, 1e9).usually(0.1, 1.0)).open("edge of the plate along y", "wide", "tall");
        /// angle by which the axes in the plate are turned
        turn: number(0.3, "rad", from_to(-1e3, 1e3).usually(0.0, PI));
        /// angular velocity of the four masses, its component along x
        omega_x: number(0.4, "rad/s", from_to(-1e9, 1e9).usually(-3.0, 3.0));
        /// its component along y
        omega_y: number(-0.3, "rad/s", from_to(-1e9, 1e9).usually(-3.0, 3.0));
        /// its component along z
        omega_z: number(2.0, "rad/s", from_to(-1e9, 1e9).usually(-3.0, 3.0));
        /// relative error asked of the sum over the slices of a torus
        tolerance: number(1e-8, "-", from_to(1e-14, 1e-2));
    }
}

// ANCHOR: masses
/// The four masses of the page.
pub const FOUR: [Mass; 4] = [
    (1.0, DesignVector::new(0.1, 0.2, 0.3)),
    (2.0, DesignVector::new(-0.4, 0.5, 0.0)),
    (1.5, DesignVector::new(0.3, -0.2, 0.6)),
    (0.5, DesignVector::new(0.0, 0.7, -0.4)),
];

/// The velocity of their origin, m/s.
pub const REFERENCE: DesignVector = DesignVector::new(0.5, -0.2, 0.1);
// ANCHOR_END: masses

// ANCHOR: motion
/// A mass (kg) and its place (m).
pub type Mass = (f64, DesignVector);

/// A motion at one instant: the velocity of a point of the body, and its turning.
#[derive(Debug, Clone, Copy)]
pub struct Rigid {
    pub point: DesignVector,
    pub velocity: DesignVector,
    pub angular_velocity: DesignVector,
}

/// Equation (1): the velocity of the point at `place`.
pub fn velocity(motion: &Rigid, place: DesignVector) -> DesignVector {
    motion.velocity + motion.angular_velocity.cross(&(place - motion.point))
}

/// Equation (2): its three terms, with the point of `motion` for P.
pub fn split(masses: &[Mass], motion: &Rigid) -> [f64; 3] {
    let (v, omega) = (motion.velocity, motion.angular_velocity);
    let mut terms = [0.0; 3];
    for (m, place) in masses {
        let turning = omega.cross(&(*place - motion.point));
        terms[0] += 0.5 * m * v.dot(&v);
        terms[1] += 0.5 * m * turning.dot(&turning);
        terms[2] += m * v.dot(&turning);
    }
    terms
}

/// The tensor of inertia about the origin.
pub fn tensor(masses: &[Mass]) -> [[f64; 3]; 3] {
    let mut tensor = [[0.0; 3]; 3];
    for (m, r) in masses {
        for i in 0..3 {
            tensor[i][i] += m * r.dot(r);
            for j in 0..3 {
                tensor[i][j] -= m * (r[i] * r[j]);
            }
        }
    }
    tensor
}
// ANCHOR_END: motion

/// What a flat body has on two axes x, y in its plane: I_xx, I_yy and I_xy, kg m^2.
pub type Plane = [f64; 3];

// ANCHOR: plate
/// A plate of mass m with edges a along x and b along y, about its centre.
pub fn about_centre(m: f64, a: f64, b: f64) -> Plane {
    [m * b * b / 12.0, m * a * a / 12.0, 0.0]
}

/// The same plate about the corner at which x and y are its edges.
pub fn about_corner(m: f64, a: f64, b: f64) -> Plane {
    [m * b * b / 3.0, m * a * a / 3.0, -m * a * b / 4.0]
}

/// The same on axes turned by this angle, from x towards y.
pub fn turned([xx, yy, xy]: Plane, angle: f64) -> Plane {
    let (s, c) = sincos(2.0 * angle);
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let swing = half * c + xy * s;
    [mean + swing, mean - swing, xy * c - half * s]
}
// ANCHOR_END: plate

/// The smaller and the larger principal moment about the corner, and the angle of the first axis.
pub fn corner_axes(m: f64, a: f64, b: f64) -> [f64; 3] {
    let [xx, yy, xy] = about_corner(m, a, b);
    let half = 0.5 * (xx - yy);
    let large = 0.5 * (xx + yy) + hypot(half, xy);
    // Their product is that of the moments less the square of I_xy; the difference would cancel.
    let small = (7.0 / 144.0) * (m * a * b / large) * (m * a * b);
    [small, large, 0.5 * atan2(-xy, -half)]
}

/// The three roots of the characteristic polynomial of a symmetric matrix, ascending.
fn characteristic_roots(t: [[f64; 3]; 3]) -> [f64; 3] {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = t;
    let mean = (xx + yy + zz) / 3.0;
    let [x, y, z] = [xx - mean, yy - mean, zz - mean];
    let size = ((x * x + y * y + z * z + 2.0 * (xy * xy + xz * xz + yz * yz)) / 6.0).sqrt();
    if size == 0.0 {
        return [mean; 3];
    }
    let det = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    let angle = acos((0.5 * det / (size * size * size)).clamp(-1.0, 1.0)) / 3.0;
    [2.0, -2.0, 0.0].map(|turn| mean + 2.0 * size * cos(angle + turn * PI / 3.0))
}

/// The energy of the four masses, term by term.
fn energies(p: &Parameters, report: &mut Report) -> Result<()> {
    let (place, omega) = (FOUR[0].1, turning(p));
    let motion = Rigid { velocity: REFERENCE, ..about_origin(omega) };
    let [x, y, z] = velocity(&motion, place).to_array();
    let [dx, dy, dz] = displaced(&motion, place)?.to_array();
    let [first, rotation, third] = split(&FOUR, &motion);
    let centre = centre_of_mass(&FOUR);
    let [carried, about_centre, none] = split(&FOUR, &motion.seen_from(centre));
    let of_centre = MassProperties::of_points(&FOUR)?.about_centre_of_mass();
    let of_origin = InertiaTensor::new(tensor(&FOUR))?;
    let (rest, moved) = (5.0 * REFERENCE.dot(&REFERENCE), velocity(&motion, centre));
    let size = 64.0 * EPS * (rest + 3.0 * omega.dot(&omega));
    let speed = 5e-13 * (1.0 + omega.norm());
    claims! { report,
        /// velocity of the first mass along x
        v_x: x, "m/s", "two places of it" => dx, within speed, in "The first mass":
            x - 2.0 * (omega[1] * 0.3 - omega[2] * 0.2) => "Omega x r, not r x Omega";
        /// velocity of the first mass along y
        v_y: y, "m/s", "two places of it" => dy, within speed, in "The first mass";
        /// velocity of the first mass along z
        v_z: z, "m/s", "two places of it" => dz, within speed, in "The first mass";
        /// kinetic energy of the four masses
        energy: first + rotation + third, "J", "their speeds" => kinetic_energy(&FOUR, &motion), within size, in "Energy of the four masses":
            first + rotation => "the third term is missing: the origin is neither the centre of mass nor at rest",
            rotation => "the origin moves as well";
        /// first term, with the origin for P
        term_1: first, "J", "M V_P^2/2" => 0.5 * rest, within size;
        /// third term, with the origin for P
        term_3: third, "J", "V_P . (Omega x M R)" => 5.0 * REFERENCE.dot(&omega.cross(&centre)), within size;
        /// energy of the four masses as one, at their centre of mass
        energy_cm: carried, "J", "M V_CM^2/2" => 2.5 * moved.dot(&moved), within size, in "Energy of the four masses";
        /// energy of their rotation about the centre of mass
        rotation_cm: about_centre, "J", "tensor" => of_centre.kinetic_energy(omega), within size, in "Energy of the four masses":
            rotation => "that is about the origin";
        /// third term, with the centre of mass for P
        term_3_cm: none, "J", "it vanishes" => 0.0, within size;
        /// energy of the same rotation with the origin at rest
        energy_rotation: rotation, "J", "tensor" => of_origin.kinetic_energy(omega), within size, in "Energy of the four masses";
    }
}

/// How fast the four masses turn.
fn turning(p: &Parameters) -> DesignVector {
    [p.omega_x, p.omega_y, p.omega_z].into()
}

/// The tensor of the four masses about the origin, here, on turned axes, and on its principal axes.
fn elements(_: &Parameters, report: &mut Report) -> Result<()> {
    let t = tensor(&FOUR);
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = t;
    let energy = |axis: [f64; 3]| kinetic_energy(&FOUR, &about_origin(axis.into()));
    let [ex, ey, ez] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(energy);
    let [exy, exz, eyz] = [[1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]].map(energy);
    let askew = Attitude::from_euler(EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 })?;
    let again = tensor(&turned_masses(&FOUR, &askew))[0][0];
    let [one, two, three] = InertiaTensor::new(t)?.principal_axes().moments();
    let [low, middle, high] = characteristic_roots(t);
    let (size, loose, roots) = (16.0 * EPS, 32.0 * EPS, "roots of det(I - x 1)");
    claims! { report,
        /// I_xx of the four masses about the origin
        i_xx: xx, "kg m^2", "energies at 1 rad/s" => 2.0 * ex, within size, in "Tensor of the four masses";
        /// I_yy
        i_yy: yy, "kg m^2", "energies at 1 rad/s" => 2.0 * ey, within size, in "Tensor of the four masses";
        /// I_zz
        i_zz: zz, "kg m^2", "energies at 1 rad/s" => 2.0 * ez, within size, in "Tensor of the four masses";
        /// I_xy
        i_xy: xy, "kg m^2", "energies at 1 rad/s" => exy - ex - ey, within size, in "Tensor of the four masses":
            -xy => "products of inertia carry a minus sign";
        /// I_xz
        i_xz: xz, "kg m^2", "energies at 1 rad/s" => exz - ex - ez, within size, in "Tensor of the four masses":
            -xz => "products of inertia carry a minus sign";
        /// I_yz
        i_yz: yz, "kg m^2", "energies at 1 rad/s" => eyz - ey - ez, within size, in "Tensor of the four masses":
            -yz => "products of inertia carry a minus sign";
        /// I_xx on axes turned by the Euler angles 0.3, 0.7, -0.4
        i_xx_turned: on_axes(&t, &askew)[0][0], "kg m^2", "places on those axes" => again, within size;
        /// smallest principal moment of the four masses about the origin
        i_1: one, "kg m^2", roots => low, within loose, in "Principal moments of the four masses":
            yy => "that is I_yy; the axes are not principal";
        /// the middle one
        i_2: two, "kg m^2", roots => middle, within loose, in "Principal moments of the four masses";
        /// the largest
        i_3: three, "kg m^2", roots => high, within loose, in "Principal moments of the four masses";
    }
}

/// The plate about its centre and about a corner, against the four points that stand for it.
fn plate(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, a, b, turn) = (p.mass, p.width, p.height, p.turn);
    let [xx, yy, xy] = about_centre(m, a, b);
    let [txx, _, txy] = turned([xx, yy, xy], turn);
    let [cxx, cyy, cxy] = about_corner(m, a, b);
    let [small, large, angle] = corner_axes(m, a, b);
    let at_centre = plate_points(m, [a, b], [0.0, 0.0]);
    let at_corner = plate_points(m, [a, b], [0.5 * a, 0.5 * b]);
    let (centre, corner) = (tensor(&at_centre), tensor(&at_corner));
    let on = |angle| Attitude::about_space_axis([0.0, 0.0, 1.0].into(), angle);
    let across = tensor(&turned_masses(&at_centre, &on(turn)?));
    let diagonal = tensor(&turned_masses(&at_corner, &on(angle)?));
    let uniform = uniform::plate(m, a, b)?;
    let stepped = uniform.about([-0.5 * a, -0.5 * b, 0.0].into())?.matrix()[2][2];
    let (size, sums) = (32.0 * EPS * m * (a * a + b * b), "four points");
    claims! { report,
        /// I_xx of the plate about its centre
        centre_xx: xx, "kg m^2", sums => centre[0][0], within size, in "Plate about its centre":
            cxx => "that is about an edge";
        /// I_yy
        centre_yy: yy, "kg m^2", sums => centre[1][1], within size, in "Plate about its centre";
        /// I_zz
        centre_zz: xx + yy, "kg m^2", sums => centre[2][2], within size, in "Plate about its centre":
            m * (a * a + b * b) / 3.0 => "that is about a corner";
        /// I_xy
        centre_xy: xy, "kg m^2", sums => centre[0][1], within size;
        /// I_x'x' about the centre, on the turned axes
        centre_turned_xx: txx, "kg m^2", sums => across[0][0], within size;
        /// I_x'y' about the centre, on the turned axes
        centre_turned_xy: txy, "kg m^2", sums => across[0][1], within size;
        /// I_xx of the plate about the corner
        corner_xx: cxx, "kg m^2", sums => corner[0][0], within size, in "Plate about a corner":
            xx => "that is about the centre";
        /// I_yy
        corner_yy: cyy, "kg m^2", sums => corner[1][1], within size, in "Plate about a corner";
        /// I_xy
        corner_xy: cxy, "kg m^2", sums => corner[0][1], within size, in "Plate about a corner":
            -cxy => "products of inertia carry a minus sign";
        /// I_zz
        corner_zz: cxx + cyy, "kg m^2", "parallel axes" => stepped, within size, in "Plate about a corner":
            xx + yy => "that is about the centre";
        /// smallest principal moment about the corner
        corner_1: small, "kg m^2", sums => diagonal[0][0], within size, in "Plate about a corner":
            large => "that is about the axis across the diagonal";
        /// the middle one
        corner_2: large, "kg m^2", sums => diagonal[1][1], within size, in "Plate about a corner":
            small => "that is about the diagonal";
        /// angle of the first principal axis from x
        corner_angle: angle, "rad", "I_x'y' there, over I_2" => angle + diagonal[0][1] / large, within 64.0 * EPS;
    }
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let trace: f64 = (0..3).map(|i| tensor(&FOUR)[i][i]).sum();
    let spread: f64 = FOUR.iter().map(|(m, r)| 2.0 * m * r.dot(r)).sum();
    let [strip, ..] = corner_axes(1.0, 1.0, 1e-6);
    let away = 1e9 * hypot(p.width, p.height);
    let far = uniform::plate(p.mass, p.width, p.height)?;
    let far = far.about([away, 0.0, 0.0].into())?.matrix()[2][2];
    let [round, _, hoop] = diagonal(&uniform::torus(1.0, 1.0, 1e-9)?);
    let [ball, ..] = diagonal(&uniform::ellipsoid(1.0, 1.0, 1.0, 1.0)?);
    limits! { report,
        /// each mass is counted by two of the three distances from the axes
        "four masses: trace of I over the sum of 2 m r^2": trace / spread => 1.0, within 4.0 * EPS;
        /// half a turn of the axes brings back the same
        "plate about a corner: I_xy after half a turn, over I_xy":
            turned(about_corner(1.0, 1.0, 0.7), PI)[2] / -0.175 => 1.0, within 4.0 * EPS;
        /// the sum of m (y - 3 b x/4 a)^2, which this slope makes least
        "narrow plate, corner: I_1/(M b^2)": strip / 1e-12 => 7.0 / 48.0, within 1e-11;
        /// all its mass is at the distance d
        "axis far away: I/(M d^2)": far / (p.mass * away * away) => 1.0, within 1e-9;
        /// all its mass is at the distance R
        "torus of thin tube: I_3/(M R^2)": hoop => 1.0, within 4.0 * EPS;
        /// a flat body: I_1 + I_2 = I_3
        "torus of thin tube: I_1/(M R^2)": round => 0.5, within 4.0 * EPS;
        /// a sphere
        "ellipsoid of equal axes: I/(M r^2)": ball => 0.4, within EPS;
    }
}

/// The moments of a solid about its centre of mass.
fn diagonal(solid: &MassProperties) -> [f64; 3] {
    let t = solid.about_centre_of_mass().matrix();
    [t[0][0], t[1][1], t[2][2]]
}

/// By how much I_xx of a plate grows that turns about the x axis and yields, over the number
/// 5 q = rho Omega^2 b^2/E: the piece at the part s of the half edge goes to s + q u, with
/// u'' = -(s + q u) and no tension at the free edge.
pub fn yielded(number: f64) -> Result<(f64, Work)> {
    let q = 1.25 * number;
    let plate = ode(|s, [u, slope, _]: &[f64; 3]| [*slope, -(s + q * u), (2.0 * s + q * u) * u])
        .scaled(size_or([1.0; 3]));
    let method = Dop853::new(1e-14)?;
    let pulled = |slope| method.advance(&plate, 0.0, &[0.0, slope, 0.0], 1.0);
    // The slope at the free edge is linear in that in the middle.
    let (([_, left, _], one), ([_, more, _], two)) = (pulled(0.0)?, pulled(1.0)?);
    let ([.., grown], three) = pulled(left / (left - more))?;
    Ok((3.0 * 1.25 * grown, one + two + three))
}

/// What a plate of aluminium in air (2700 kg/m^3, 70 GPa, 23e-6/K) has besides.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (m, a, b, omega) = (p.mass, p.width, p.height, turning(p).norm());
    let thickness = m / (a * b) / 2700.0;
    let (flat, air) = (thickness / b, 3.0 * PI * 1.204 * a * b * b / (32.0 * m));
    let (grown, stretch) = (23e-6 * 10.0, 2700.0 * (omega * b) * (omega * b) / 3.5e11);
    // The library's solids, over the flat plate.
    let [plain, ..] = diagonal(&uniform::plate(m, a, b)?);
    let [thick, ..] = diagonal(&uniform::cuboid(m, a, b, thickness)?);
    let [warm, ..] = diagonal(&uniform::plate(m, a * (1.0 + grown), b * (1.0 + grown))?);
    let yields = when(stretch < 0.1, || yielded(stretch))?;
    effect_card! { report,
        "air that turns with the plate, at most": "3 pi rho b^2 a/(32 M)" = air, costs air, "of I_xx";
        "warmer by ten kelvin": "2 alpha (T - T_0)" = 2.0 * grown, costs 2.0 * grown, "of I_xx, to first order",
            measured warm / plain - 1.0, within 4.0 * EPS, at_cost "closed form, closed form";
        "thickness of aluminium": "h^2/b^2" = flat * flat, costs flat * flat, "of I_xx",
            measured thick / plain - 1.0, within 4.0 * EPS, at_cost "closed form, closed form";
        "stretch by the turning": "rho_p Omega^2 b^2/(5 E)" = stretch, costs stretch, "of I_xx, to first order",
            measured yields.map(|(part, _)| part * stretch), at_work yields.map(|(_, work)| work);
    }
}

/// A rolling wheel's energy, over M V^2, with several points of it for P.
fn references(_: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "P, M V_P^2/2, rotation about P, third term, sum".split(", ");
    report.add(Table::of("references", columns, WHEEL_POINTS, |(name, at)| {
        let [carried, rotation, third] = split(&wheel(), &rolling().seen_from(at.into()));
        // Rounding leaves a zero with a sign.
        let shown = |x: f64| format!("{:.2}", if x.abs() < 1e-12 { 0.0 } else { x });
        let numbers = [carried, rotation, third, carried + rotation + third].map(shown);
        Ok([name.to_owned()].into_iter().chain(numbers))
    })?)
}

/// A number to the digits that matter; what is below `size` is zero.
fn rounded(x: f64, size: f64) -> String {
    if x.abs() < size { "0".into() } else { short(x, 4) }
}

/// The square about its centre with a fly on one corner: where its first axis lies.
fn fly(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "fly / kg, first axis / rad, I_2 - I_1".split(", ");
    report.add(Table::of("fly", columns, [0.0, 1e-6, 1e-3, 0.1], |fly| {
        let [angle, apart] = with_fly(p, fly)?;
        let mass = if fly == 0.0 { "none".into() } else { short(fly, 3) };
        Ok([mass, rounded(angle, 1e-12), rounded(apart, 1e-15)])
    })?)
}

/// With a fly of this mass at (a/2, b/2): the angle of the first principal axis about the common
/// centre of mass, and by how much the next moment is larger than the smallest.
pub fn with_fly(p: &Parameters, fly: f64) -> Result<[f64; 2]> {
    let plate = uniform::plate(p.mass, p.width, p.height)?;
    let corner = DesignVector::new(0.5 * p.width, 0.5 * p.height, 0.0);
    let mut parts = vec![plate];
    if fly > 0.0 {
        parts.push(MassProperties::of_points(&[(fly, corner)])?);
    }
    let axes = MassProperties::of_parts(&parts)?.about_centre_of_mass().principal_axes();
    let ([first, ..], [one, two, _]) = (axes.axes(), axes.moments());
    Ok([atan2(first.y() * first.x().signum(), first.x().abs()), two - one])
}

/// The plates that the page asks about.
fn tries(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns = "plate / m, I_xx, I_xx turned, product turned, first axis / rad".split(", ");
    report.add(Table::of("try", columns, [1.0, 0.75, 0.1], |part| {
        let (a, b) = (p.width, part * p.height);
        let plane = about_centre(p.mass, a, b);
        let [xx, _, xy] = turned(plane, p.turn);
        let [.., angle] = corner_axes(p.mass, a, b);
        let numbers = [plane[0], xx, xy, angle].map(|x| rounded(x, 1e-15));
        Ok([format!("{} by {}", short(a, 3), short(b, 3))].into_iter().chain(numbers))
    })?)
}

example! {
    ch15_3_moment_of_inertia: "Section 15.3: kinetic energy, tensor of inertia, principal axes";
    "Moment of inertia and kinetic energy", "Four masses and a plate: energy, tensor of inertia, principal axes.",
    [energies, elements, plate, limits, effects, solids::strip, references, fly, tries, solids::table];
    figures::figures, figures::trajectory, figures::moving_picture
}
