//! The order of a scheme of each kind under each law that reads a velocity or the time, in generic scenes: three
//! different moments, a start in Euler angles and a spin off every axis.

use polhode::campaign::Campaign;
use polhode::gates::Baseline;
use polhode::record::{ClaimName, Ruling};
use polhode::scenes::Scene;
use polhode::simulate::Contestant;

/// A scene under a law.
fn scene(name: &str, law: &str) -> Scene {
    let text = format!(
        "name = \"{name}\"\nduration = 4.0\n[body]\nmass = 2.0\ninertia = [1.0, 2.0, 2.5]\n[initial]\n\
         position = [3.0, 0.5, -0.25]\nvelocity = [0.0, 1.0, 0.5]\n\
         orientation = {{ euler = [20.0, -35.0, 50.0], sequence = \"zxz\", unit = \"deg\" }}\n\
         angular_velocity_body = [0.5, 1.0, -0.75]\n[[forces]]\n{law}\n"
    );
    Scene::parse(&text, &format!("{name}.toml")).unwrap_or_else(|error| panic!("{error}"))
}

fn scenes() -> Vec<Scene> {
    [
        ("damped", "law = \"rotational-damping\"\ncoefficients = [[0.3, 0.05, 0.0], [0.05, 0.2, 0.1], [0.0, 0.1, 0.4]]"),
        ("gyrostat", "law = \"wheels\"\nmomentum = [0.5, -1.0, 0.75]"),
        (
            "magnetic",
            "law = \"orbiting-dipole\"\nmoment = [0.5, 1.0, 0.25]\nfield = [0.5, 0.0, 0.25]\nfield_cosine = [0.0, 1.0, 0.5]\nfield_sine = [1.0, 0.0, -0.5]\nfrequency = 1.5",
        ),
        ("orbit", "law = \"mass-center-gravity\"\nmu = 4.0\ncenter = [0.0, 0.25, 0.0]"),
    ]
    .map(|(name, law)| scene(name, law))
    .to_vec()
}

#[test]
fn orders_hold_under_every_new_law() {
    let named = ["euler", "peskin-rk2", "peskin-rk4", "rk4-quaternion", "rkmk4"];
    let schemes: Vec<Contestant> =
        Contestant::all().into_iter().filter(|c| named.contains(&c.card.name)).collect();
    assert_eq!(schemes.len(), named.len());
    let campaign = Campaign { baseline: Baseline::default(), ..Campaign::of(scenes(), schemes) };
    let records = campaign.run();
    let orders = || records.verdicts.iter().filter(|v| v.claim == ClaimName::Order);
    for scene in scenes() {
        for scheme in named {
            let of_pair = || orders().filter(|v| v.scene == scene.name && v.scheme == scheme);
            let passed = of_pair().filter(|v| v.verdict == Ruling::Pass).count();
            // Orientation, spin and momentum at least; translation besides where a force acts.
            assert!(passed >= 3, "{scheme} in {}: {passed}", scene.name);
            let wrong: Vec<_> = of_pair().filter(|v| v.verdict == Ruling::Fail).collect();
            assert!(wrong.is_empty(), "{wrong:#?}");
        }
    }
}

#[test]
fn euler_angles_and_a_spin_in_body_axes_are_what_they_say() {
    let start = |text: &str| {
        let text = format!(
            "name = \"a\"\nduration = 1.0\n[body]\nmass = 1.0\ninertia = [1.0, 2.0, 2.5]\n[initial]\n{text}\n"
        );
        Scene::parse(&text, "a.toml").expect("a scene").system.start
    };
    // A quarter about z, then a quarter about the body's own x, which is the world's y: x to y, y to z.
    let own = start("orientation = { euler = [90, 90, 0], sequence = \"zxz\", unit = \"deg\" }").orientation;
    let (x, y) = (nalgebra::Vector3::x(), nalgebra::Vector3::y());
    assert!((own * x - y).amax() < 1e-15 && (own * y - nalgebra::Vector3::z()).amax() < 1e-15);
    // The same two about axes that stay, in the other order.
    let fixed =
        start("orientation = { euler = [0, 90, 90], sequence = \"zxz\", axes = \"world\", unit = \"deg\" }");
    assert!(fixed.orientation.angle_to(&own) < 1e-15);
    let radians = start(
        "orientation = { euler = [1.5707963267948966, 1.5707963267948966, 0], sequence = \"zxz\", unit = \"rad\" }",
    );
    assert!(radians.orientation.angle_to(&own) < 1e-15);
    let turned = "orientation = { euler = [90, 0, 0], sequence = \"zyx\", unit = \"deg\" }\n";
    let in_body = start(&format!("{turned}angular_velocity_body = [1, 0, 2]"));
    let in_world = start(&format!("{turned}angular_velocity = [0, 1, 2]"));
    assert!((in_body.angular_momentum - in_world.angular_momentum).amax() < 1e-14);
}
