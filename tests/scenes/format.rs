//! What a scene file means.

use nalgebra::{Matrix3, Vector3};
use polhode::model::body::Shape;
use polhode::model::difference;
use polhode::model::forces::{Attachment, Law, PerPoint, TorqueAxes};
use polhode::scenes::{Scene, SceneError};

use crate::common::program::scratch;
use crate::common::scene;
use crate::given::{EVERY_LAW, HEAD, INERTIA, POINTS, ROD, SINGLE, parse, start_of};

#[test]
fn a_user_scene_with_every_law_is_read_with_its_defaults() {
    let scene = parse(EVERY_LAW);
    assert_eq!((scene.title.as_str(), scene.why.as_str(), scene.built_in), ("every-law", "", false));
    let laws = scene.system.forces.laws();
    let mut names: Vec<_> = laws.iter().map(Law::name).collect();
    names.dedup();
    assert_eq!(names, Law::NAMES.map(|(name, _)| name), "in the order of the list");
    let center = Vector3::new(0.5, 2.125, 1.0) / 3.5;
    let [
        _,
        Law::Spring(point),
        Law::Spring(at),
        Law::Drag(drag),
        Law::CentralGravity(central),
        Law::Lorentz(lorentz),
        Law::Torque(torque),
        _,
        Law::GravityGradient(gradient),
        Law::Ground(ground),
        Law::RotationalDamping(damping),
        Law::Wheels(_),
        Law::OrbitingDipole(dipole),
        Law::MassCenterGravity(center_gravity),
        Law::TorquePulse(pulse),
    ] = laws
    else {
        panic!("{names:?}")
    };
    assert_eq!(
        (point.attachment.clone(), point.stiffness, point.rest_length),
        (Attachment::Point(2), 100.0, 1.0)
    );
    let Attachment::At(place) = &at.attachment else { panic!("{at:?}") };
    assert!((place - (Vector3::repeat(0.5) - center)).amax() < 1e-15);
    assert_eq!((at.stiffness, at.damping, at.rest_length, at.anchor), (16.0, 0.0, 0.0, Vector3::zeros()));
    assert_eq!(drag.coefficient, PerPoint::Same(0.1));
    assert_eq!(central.center, Vector3::zeros());
    assert_eq!(lorentz.charge, PerPoint::Each(vec![1.0, -2.0, 0.5]));
    assert_eq!((lorentz.electric, lorentz.frequency), (Vector3::zeros(), 0.0));
    assert_eq!((torque.axes, torque.constant), (TorqueAxes::Body, Vector3::zeros()));
    assert_eq!((gradient.normal, gradient.rate), (Vector3::z(), 0.0));
    assert!((gradient.direction - Vector3::new(0.6, 0.0, 0.8)).amax() < 1e-15);
    assert_eq!(damping.coefficients, Matrix3::from_diagonal(&Vector3::new(0.1, 0.2, 0.3)));
    assert_eq!((dipole.field, dipole.field_sine), (Vector3::zeros(), Vector3::zeros()));
    assert_eq!(center_gravity.center, Vector3::zeros());
    assert_eq!((pulse.start, pulse.end), (0.0, 2.0));
    assert_eq!((ground.normal, ground.height, ground.slip_velocity), (Vector3::z(), 0.0, 1e-3));
}

#[test]
fn points_are_in_body_axes_and_the_centre_of_mass_stays_where_they_are_given() {
    let scene = parse(&format!("{HEAD}{POINTS}[initial]\norientation = [0.5, 0.5, 0.5, 0.5]\n"));
    let center = Vector3::new(0.5, 2.125, 0.5 + 0.5) / 3.5;
    assert!((scene.system.start.position - center).amax() < 1e-15);
    // The orientation takes x to y, y to z and z to x.
    let first = scene.system.body.points[0].position;
    assert!((first - (Vector3::new(1.0, 0.0, 0.5) - center)).amax() < 1e-15);
    let turned = scene.system.start.orientation * Vector3::x();
    assert!((turned - Vector3::y()).amax() < 1e-15);
}

#[test]
fn a_spring_and_a_pivot_are_in_the_frame_of_the_points() {
    let spring = "[[forces]]\nlaw = \"spring\"\nat = [1.0, 2.0, 3.0]\nstiffness = 1.0\n";
    let at = |text: &str| {
        let scene = parse(text);
        let Law::Spring(spring) = &scene.system.forces.laws()[0] else { panic!("no spring") };
        let Attachment::At(place) = spring.attachment else { panic!("no place") };
        place
    };
    let pivoted = format!("{HEAD}{POINTS}pivot = [0.5, 0.5, 0.5]\n{spring}");
    assert_eq!(at(&pivoted), Vector3::new(0.5, 1.5, 2.5));
    let by_inertia = format!("{HEAD}{INERTIA}{spring}");
    assert_eq!(at(&by_inertia), Vector3::new(1.0, 2.0, 3.0));
    let both = format!("{HEAD}{INERTIA}pivot = [0, 0, -1]\n{spring}");
    assert_eq!(at(&both), Vector3::new(1.0, 2.0, 4.0));
    let pivot = parse(&pivoted).system;
    assert!((pivot.origin() - Vector3::repeat(0.5)).amax() < 1e-15);
    let unmoved = parse(&both).system;
    assert_eq!(unmoved.start.position, Vector3::zeros());
    assert_eq!(unmoved.origin(), Vector3::new(0.0, 0.0, -1.0));
}

#[test]
fn a_body_from_points_and_the_same_body_from_its_inertia_are_one() {
    let start = "[initial]\nposition = [1, 2, 3]\norientation = [0.7, 0.1, -0.5, 0.5]\nangular_velocity = [1, -2, 0.5]\n";
    let from_points = parse(&format!("{HEAD}{POINTS}{start}"));
    let rows: Vec<String> = from_points
        .system
        .body
        .inertia
        .row_iter()
        .map(|row| format!("[{:?}, {:?}, {:?}]", row[0], row[1], row[2]))
        .collect();
    let body = format!("[body]\nmass = 3.5\ninertia = [{}]\n", rows.join(", "));
    let from_inertia = parse(&format!("{HEAD}{body}{start}"));
    let (a, b) = (&from_points.system, &from_inertia.system);
    assert_eq!(a.body.inertia, b.body.inertia);
    assert_eq!(a.start, b.start);
    assert_eq!(a.body.shape, b.body.shape);
    let apart = difference(&a.body, &start_of(&from_points), &start_of(&from_inertia));
    // Numbers of size 1 to 4 in, a handful of roundings.
    assert!(apart.values().all(|d| *d < 4e-15), "{apart:?}");
}

#[test]
fn a_rod_may_spin_across_itself_and_a_point_may_rest() {
    let rod = parse(&format!("{HEAD}{ROD}[initial]\nangular_velocity = [0, 1, 2]\n"));
    assert!(matches!(rod.system.body.shape, Shape::Rod { .. }));
    let point = parse(&format!("{HEAD}{SINGLE}[initial]\nvelocity = [1, 0, 0]\n"));
    assert_eq!(point.system.body.shape, Shape::Point);
    assert_eq!(point.system.start.position, Vector3::new(1.0, 2.0, 3.0));
}

#[test]
fn names_and_paths_are_told_apart() {
    assert!(scene("kovalevskaya").built_in);
    let Err(SceneError::Unknown { name, near }) = Scene::find("kovalevskya") else { panic!("found") };
    assert_eq!((name.as_str(), near.len(), near[0]), ("kovalevskya", 3, "kovalevskaya"));
    assert!(matches!(Scene::find("no/such/file"), Err(SceneError::Unreadable { .. })));
    assert!(matches!(Scene::find("nowhere.toml"), Err(SceneError::Unreadable { .. })));
    let folder = scratch();
    let path = folder.path().join("mine.toml");
    std::fs::write(&path, format!("{HEAD}{INERTIA}")).expect("written");
    let scene = Scene::find(&path.to_string_lossy()).expect("a scene");
    assert!(!scene.built_in && scene.name == "user-scene");
    std::fs::write(&path, b"name = \"a\"\ntitle = \"\xff\"\n").expect("written");
    let Err(SceneError::Content { faults, .. }) = Scene::find(&path.to_string_lossy()) else {
        panic!("read")
    };
    assert!(faults.len() == 1 && faults[0].line == 2 && faults[0].message.contains("UTF-8"), "{faults:?}");
}

#[test]
fn lines_are_counted_the_same_under_windows_line_ends() {
    let text = format!("{HEAD}{POINTS}[initial]\nvelocity = 1\n").replace('\n', "\r\n");
    let Err(SceneError::Content { faults, .. }) = Scene::parse(&text, "user.toml") else { panic!("read") };
    assert_eq!(faults.iter().map(|fault| fault.line).collect::<Vec<_>>(), [10]);
}
