//! Moments that cancel: a body about a distant point and back, rods and plates that are turned.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::DesignedBody;
use rotation_dynamics::error::{Error, Result};
use rotation_dynamics::exact::heavy_top::SymmetricTop;
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, PrincipalMoments, solids};
use rotation_dynamics::math::EPS;
use support::{Errors, Random, assert_largest};

type Matrix = [[f64; 3]; 3];

fn attitude(random: &mut Random) -> Attitude {
    Attitude::from_quaternion(random.vector()).expect("not zero")
}

/// A unit vector.
fn direction(random: &mut Random) -> DesignVector {
    attitude(random).axis().to_array().into()
}

fn turn(axis: [f64; 3], angle: f64) -> Attitude {
    Attitude::about_body_axis(BodyVector::from(axis), angle).expect("an axis")
}

fn matrix_of(element: impl Fn(usize, usize) -> f64) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| element(i, j)))
}

/// The tensor about `p`, and what is left of it about the centre of mass again.
fn there_and_back(body: &MassProperties, p: DesignVector) -> Result<MassProperties> {
    let centre = body.centre_of_mass();
    MassProperties::from_tensor_about(p, body.mass(), centre, body.about(p)?)
}

/// I_P - m (d^2 1 - d d^T), judged as a tensor in which nothing has cancelled.
fn judged_by_what_is_left(body: &MassProperties, p: DesignVector) -> Result<InertiaTensor> {
    let d = (body.centre_of_mass() - p).to_array();
    let square: f64 = d.iter().map(|c| c * c).sum();
    let about = body.about(p)?.matrix();
    let step = |i: usize, j: usize| if i == j { square } else { 0.0 } - d[i] * d[j];
    InertiaTensor::new(matrix_of(|i, j| about[i][j] - body.mass() * step(i, j)))
}

/// Both roads name a rod, and say how much rounding hides.
fn assert_rod(tensor: &InertiaTensor, moment: f64) {
    let axes = tensor.principal_axes();
    let [own, across, high] = axes.moments();
    assert_eq!((own, across), (0.0, high));
    assert!((across - moment).abs() <= tensor.known_within());
    let by_axes = axes.principal_moments().unwrap_err();
    let by_body = DesignedBody::new(tensor).unwrap_err();
    for error in [by_axes, by_body] {
        let said = error.to_string();
        assert!(said.contains("are those of a rod"), "{said}");
        let Error::NotABody { excess: 0.0, slack: known_within, .. } = error else {
            panic!("{error:?}")
        };
        assert_eq!(known_within, tensor.known_within());
    }
}

#[test]
fn reported_bodies_about_a_point_and_back() -> Result<()> {
    let rod = solids::rod(1.0, 1.0)?;
    let askew = rod.turned(&turn([1.0, 1.0, 0.0], 0.2))?;
    let mut rods = 0;
    for (rod, p) in [
        (rod, [10.0, 0.0, 0.0]),
        (askew, [10.0, 0.0, 0.0]),
        (askew, [3.0, 0.0, 0.0]),
        (askew, [0.0, -7.0, 0.1]),
    ] {
        assert_rod(&there_and_back(&rod, p.into())?.about_centre_of_mass(), 1.0 / 12.0);
        rods += 1;
    }
    assert_eq!(rods, 4);

    let plate = solids::plate(0.1, 0.01, 0.01)?.turned(&turn([1.0, 2.0, 3.0], 0.7))?;
    let mut plates = 0;
    for p in [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.03, 0.02, 0.04]] {
        let tensor = there_and_back(&plate, p.into())?.about_centre_of_mass();
        let [a, b, c] = tensor.principal_axes().principal_moments()?.to_array();
        let side = 0.1 * 0.01 * 0.01 / 12.0;
        for (moment, exact) in [(a, side), (b, side), (c, 2.0 * side)] {
            assert!((moment - exact).abs() <= tensor.known_within());
        }
        plates += 1;
    }
    assert_eq!(plates, 3);

    // Nothing is left of a point mass.
    let point = MassProperties::of_points(&[(1.7, [0.1, 0.2, 0.3].into())])?;
    let tensor = there_and_back(&point, [-3.0, 5.0, 0.7].into())?.about_centre_of_mass();
    assert_eq!(tensor.principal_axes().moments(), [0.0; 3]);
    let said = DesignedBody::new(&tensor).unwrap_err().to_string();
    assert!(said.contains("are those of a point mass: it has no moment about any axis"), "{said}");
    Ok(())
}

#[test]
fn a_rod_is_named_wherever_it_is_refused() -> Result<()> {
    let rod = solids::rod(1.0, 1.0)?;
    let turned = rod.turned(&turn([1.0, 2.0, 3.0], 1.1))?.about_centre_of_mass();
    let diagonal = InertiaTensor::diagonal([0.0, 2.0, 2.0])?;
    let refusals = [
        PrincipalMoments::new(0.0, 2.0, 2.0).err(),
        PrincipalMoments::new(2.0, 0.0, 2.0).err(),
        PrincipalMoments::symmetric(2.0, 0.0).err(),
        SymmetricTop::new(2.0, 0.0, 1.0, 0.5).err(),
        SymmetricTop::formal(2.0, 0.0, 1.0, 0.5).err(),
        diagonal.principal_axes().principal_moments().err(),
        DesignedBody::new(&diagonal).err(),
        turned.principal_axes().principal_moments().err(),
        DesignedBody::new(&turned).err(),
    ];
    for (n, error) in refusals.iter().enumerate() {
        let said = error.as_ref().expect("a rod").to_string();
        assert!(
            said.contains("are those of a rod: it has no moment about its own axis"),
            "{n}: {said}"
        );
        assert!(said.contains("needs each greater than 0"), "{n}: {said}");
    }
    let said = PrincipalMoments::new(0.0, 0.0, 0.0).unwrap_err().to_string();
    assert!(said.contains("(0, 0, 0) are those of a point mass"), "{said}");
    // A zero alone makes no rod: no body has these.
    let said = PrincipalMoments::new(0.0, 1.0, 1.5).unwrap_err().to_string();
    assert!(
        said.contains("belong to no body") && said.contains("the largest does by 0.5"),
        "{said}"
    );

    // What a rod can do, it does: energy and momentum of a turn across it.
    let line = turn([1.0, 2.0, 3.0], 1.1).axis().to_array().into();
    let across: DesignVector = DesignVector::new(1.0, 0.0, 0.0).cross(&line);
    let across = across * (3.0 / across.norm());
    assert!((turned.kinetic_energy(across) - 0.5 * 9.0 / 12.0).abs() < 1e-15);
    assert!(turned.moment_about(line)?.abs() <= turned.known_within());
    // A needle that a diagonal tensor states is no rod.
    let needle = InertiaTensor::diagonal([1.0, 1.0, 1e-17])?;
    assert_eq!(DesignedBody::new(&needle)?.rigid_body().moments().i3(), 1e-17);
    assert_eq!(needle.principal_axes().principal_moments()?.i1(), 1e-17);
    Ok(())
}

/// Closed forms that the sweep knows: what the body is called, and the moments, ascending.
fn known_bodies(
    m: f64,
    l: f64,
    [p, q]: [f64; 2],
) -> Result<Vec<(&'static str, MassProperties, [f64; 3])>> {
    let unit = m * l * l;
    let rod = solids::rod(m, l)?;
    let ends = [0.5 * l, -0.5 * l].map(|z| (m, DesignVector::new(0.0, 0.0, z)));
    let dumbbell = MassProperties::of_parts(&[rod, MassProperties::of_points(&ends)?])?;
    // From e3 onto e1.
    let other = rod.turned(&turn([0.0, 1.0, 0.0], core::f64::consts::FRAC_PI_2))?;
    let crossed = MassProperties::of_parts(&[rod, other])?;
    let wheel = MassProperties::of_parts(&[solids::disc(m, p * l)?, rod])?;
    let (j, disc) = (unit / 12.0, unit * p * p / 4.0);
    let cuboid = [p * p + q * q, p * p + 1.0, q * q + 1.0].map(|e| e * unit / 12.0);
    let sorted = |mut moments: [f64; 3]| {
        moments.sort_by(f64::total_cmp);
        moments
    };
    Ok(vec![
        ("rod", rod, [0.0, j, j]),
        ("rod", dumbbell, [0.0, j + 0.5 * unit, j + 0.5 * unit]),
        ("plate", solids::plate(m, l, p * l)?, sorted([j * p * p, j, j * (1.0 + p * p)])),
        ("symmetric", solids::disc(m, p * l)?, [disc, disc, 2.0 * disc]),
        ("symmetric", crossed, [j, j, 2.0 * j]),
        ("symmetric", wheel, sorted([j + disc, j + disc, 2.0 * disc])),
        ("symmetric", solids::sphere(m, l)?, [0.4 * unit; 3]),
        ("body", solids::cuboid(m, l, p * l, q * l)?, sorted(cuboid)),
    ])
}

/// The same about a point `d` away from the centre, typed with 16 digits; centre and point are
/// known to a rounding, far from the origin.
fn typed_and_back(body: &MassProperties, d: DesignVector) -> Result<MassProperties> {
    let centre = body.centre_of_mass();
    let at_origin = body.displaced(centre * -1.0)?.about(d)?.matrix();
    let typed = |e: f64| format!("{e:.15e}").parse().expect("a number");
    let typed = InertiaTensor::new(at_origin.map(|row| row.map(typed)))?;
    MassProperties::from_tensor_about(centre + d, body.mass(), centre, typed)
}

#[test]
fn bodies_of_every_kind_about_points_near_and_far_and_back() -> Result<()> {
    let mut random = Random(31);
    let [mut off, mut off_typed] = ["computed", "typed"].map(Errors::of);
    let (mut cases, mut refused_by_what_is_left) = (0, 0);
    for _ in 0..400 {
        let (mass, length) = (random.size(1e-6, 1e6), random.size(1e-3, 1e3));
        let ratios = [random.between(0.2, 0.5), random.between(0.6, 0.9)];
        for (kind, body, exact) in known_bodies(mass, length, ratios)? {
            let place = direction(&mut random) * (length * random.size(0.1, 1e3));
            let body = body.turned(&attitude(&mut random))?.displaced(place)?;
            let d = direction(&mut random) * (length * random.size(1.0, 1e3));
            let p = place + d;
            refused_by_what_is_left += usize::from(judged_by_what_is_left(&body, p).is_err());
            let computed = there_and_back(&body, p).expect(kind).about_centre_of_mass();
            let typed = typed_and_back(&body, d).expect(kind).about_centre_of_mass();
            // The stated slack: of what was added, at most four times.
            let terms = 2.0 * exact[2] + body.mass() * d.norm() * (place.norm() + p.norm());
            for (tensor, off) in [(computed, &mut off), (typed, &mut off_typed)] {
                let known_within = tensor.known_within();
                assert!(known_within <= 4.0 * 32.0 * EPS * terms);
                let moments = tensor.principal_axes().moments();
                for (moment, exact) in moments.iter().zip(exact) {
                    off.push_at((moment - exact) / known_within, (kind, mass, length));
                }
                if kind == "rod" {
                    assert_rod(&tensor, exact[2]);
                } else {
                    tensor.principal_axes().principal_moments().expect(kind);
                    let rigid = DesignedBody::new(&tensor).expect(kind).rigid_body();
                    let [a, b, c] = rigid.moments().to_array();
                    let symmetric = a == b || b == c || c == a;
                    assert_eq!(symmetric, kind == "symmetric", "{kind} {a} {b} {c}");
                }
                cases += 1;
            }
        }
    }
    assert_eq!(cases, 2 * 400 * 8);
    assert_largest!(off, 3 * cases / 2, @"0.0115");
    assert_largest!(off_typed, 3 * cases / 2, @"0.0500");
    // Damaged: a third is refused if nothing is known of what cancelled.
    assert!(refused_by_what_is_left > 1000, "{refused_by_what_is_left}");
    Ok(())
}

/// Where rounding is about as large as the moments, each road says the same: a body, a rod or a point
/// mass.
#[test]
fn roads_agree_where_rounding_is_as_large_as_the_moments() -> Result<()> {
    let mut random = Random(7);
    let (mut bodies, mut rods, mut points, mut hidden) = (0, 0, 0, 0);
    for _ in 0..3000 {
        let size = random.size(1e-3, 10.0);
        let (a, b) = (size, size * random.between(0.2, 1.0));
        let plate = solids::plate(random.size(1e-3, 1e3), a, b)?.turned(&attitude(&mut random))?;
        let p = direction(&mut random) * (size * random.size(1e5, 1e8));
        let tensor = there_and_back(&plate, p)?.about_centre_of_mass();
        let axes = tensor.principal_axes();
        let [own, across, high] = axes.moments();
        assert_eq!(
            axes.principal_moments().is_ok(),
            DesignedBody::new(&tensor).is_ok(),
            "{tensor:?}"
        );
        match axes.principal_moments() {
            Ok(_) => bodies += 1,
            Err(_) if high == 0.0 => points += 1,
            Err(_) => {
                assert_rod(&tensor, high);
                assert_eq!((own, across), (0.0, high));
                rods += 1;
                // Rounding hides by how much it is not a ball.
                hidden += usize::from(high <= tensor.known_within());
            }
        }
    }
    assert_eq!(bodies + rods + points, 3000);
    assert!(bodies > 500 && rods > 100 && points > 500 && hidden > 10);
    Ok(())
}

#[test]
fn what_rounding_does_not_explain_is_refused_with_the_excess() -> Result<()> {
    let mut random = Random(7);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..500 {
        let (mass, length) = (random.size(1e-6, 1e6), random.size(1e-3, 1e3));
        let attitude = attitude(&mut random);
        let plate = solids::plate(mass, length, 0.7 * length)?.turned(&attitude)?;
        let n = attitude.axis().to_array();
        let above = DesignVector::from(n) * (length * random.size(1.0, 1e3));
        let p = above + direction(&mut random) * (0.5 * length);
        let about = plate.about(p)?.matrix();
        // A plate, and something more about its normal, as no body has.
        let more = |by: f64| {
            let tensor = InertiaTensor::new(matrix_of(|i, j| about[i][j] + by * (n[i] * n[j])))?;
            MassProperties::from_tensor_about(p, mass, DesignVector::zero(), tensor)
        };
        let slack = more(0.0)?.about_centre_of_mass().known_within();
        let within = more(0.5 * slack)?.about_centre_of_mass();
        within.principal_axes().principal_moments()?;
        accepted += 1;
        let error = more(2.0 * slack).unwrap_err();
        let Error::NotABody { excess, slack: said, .. } = error else { panic!("{error:?}") };
        assert!((excess / slack - 2.0).abs() < 0.2 && (said / slack - 1.0).abs() < 1e-6);
        assert!(error.to_string().contains("and the largest does by"));
        // The mass of another body.
        let about = plate.about(p)?;
        let heavier =
            MassProperties::from_tensor_about(p, 1.001 * mass, DesignVector::zero(), about);
        assert!(
            matches!(heavier, Err(Error::NotABody { excess, slack, .. }) if excess > 1e6 * slack)
        );
        refused += 2;
    }
    assert_eq!((accepted, refused), (500, 1000));
    Ok(())
}

/// R is the nearest to E in a convex cone if R.(E - R) = 0 and B.(E - R) <= 0 for all of the
/// B that span it; here these are the tensors 1 - u u^T of point masses.
#[test]
fn the_nearest_body_is_taken() -> Result<()> {
    let mut random = Random(3);
    let dot = |a: &Matrix, b: &Matrix| -> f64 {
        a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a * b).sum()
    };
    let p = DesignVector::new(10.0, 0.0, 0.0);
    let mut kinds = [0; 4];
    for _ in 0..3000 {
        // Noise about the centre of a point mass of 1 kg, and a little more; in units of the
        // last place of 100 kg m^2, so that nothing is rounded below.
        let ulp = 64.0 * f64::EPSILON;
        let mut six = [(); 6].map(|()| random.between(-3.0, 3.0).round() * ulp);
        let more = random.between(0.0, 6.0).round() * ulp;
        six[..3].iter_mut().for_each(|moment| *moment += more);
        let [xx, yy, zz, xy, xz, yz] = six;
        let noise = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let far = matrix_of(|i, j| noise[i][j] + if i == j && i > 0 { 100.0 } else { 0.0 });
        let tensor = InertiaTensor::new(far)?;
        let back = MassProperties::from_tensor_about(p, 1.0, DesignVector::zero(), tensor)?;
        let nearest = back.about_centre_of_mass().matrix();
        let rest = matrix_of(|i, j| noise[i][j] - nearest[i][j]);
        let size = dot(&noise, &noise).sqrt();
        assert!(dot(&rest, &nearest).abs() <= 1e-14 * size * size);
        let trace: f64 = (0..3).map(|i| rest[i][i]).sum();
        for _ in 0..30 {
            let u = direction(&mut random).to_array();
            let along = dot(&rest, &matrix_of(|i, j| u[i] * u[j]));
            assert!(trace - along <= 1e-14 * size);
        }
        // Untouched, plate, rod, point mass.
        let largest = nearest.as_flattened().iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        let [low, ..] = InertiaTensor::new(nearest)?.principal_axes().moments();
        kinds[match () {
            () if rest == [[0.0; 3]; 3] => 0,
            () if largest == 0.0 => 3,
            () if low == 0.0 => 2,
            () => 1,
        }] += 1;
    }
    assert_eq!(kinds.iter().sum::<i32>(), 3000);
    assert!(kinds.iter().all(|n| *n >= 20), "{kinds:?}");
    Ok(())
}

#[test]
fn a_thousand_turns_leave_a_rod_a_rod_and_a_disc_round() -> Result<()> {
    let mut random = Random(11);
    let mut rod = solids::rod(2.0, 1.0)?;
    let mut disc = solids::disc(2.0, 1.0)?;
    for n in 1..=1000 {
        let attitude = attitude(&mut random);
        rod = rod.turned(&attitude)?;
        disc = disc.turned(&attitude)?;
        // Each turn may add its rounding, and says so.
        let known_within = f64::from(n) * 32.0 * EPS / 6.0;
        assert!((rod.about_centre_of_mass().known_within() / known_within - 1.0).abs() < 1e-9);
        if n % 50 == 0 {
            assert_rod(&rod.about_centre_of_mass(), 1.0 / 6.0);
            let round = DesignedBody::new(&disc.about_centre_of_mass())?;
            let [a, b, c] = round.rigid_body().moments().to_array();
            assert!(a == b || b == c || c == a);
        }
    }
    Ok(())
}

#[test]
fn a_line_of_many_points_is_a_rod() -> Result<()> {
    let mut random = Random(5);
    let mut lines = 0;
    for _ in 0..8 {
        let line = direction(&mut random);
        let points: Vec<_> =
            (0..100_000).map(|_| (random.unit(), line * random.between(-1.0, 1.0))).collect();
        let points = MassProperties::of_points(&points)?;
        let tensor = points.about_centre_of_mass();
        assert_rod(&tensor, tensor.principal_axes().moments()[2]);
        assert!(tensor.known_within() < 64.0 * EPS * tensor.principal_axes().moments()[2]);
        lines += 1;
    }
    assert_eq!(lines, 8);
    Ok(())
}
