//! Scenes that no list has seen: every law, rods, single points, molecules and asteroids through the gate.

use polhode::campaign::Campaign;
use polhode::gates::{self, Baseline};
use polhode::record::{ClaimName, Records, Ruling};
use polhode::scenes::{Scene, SceneError};
use polhode::simulate::Contestant;

const POINT: &str = r#"
name = "point"
duration = 2.0
[body]
points = [{ mass = 1.5, position = [1, 2, 3] }]
[initial]
velocity = [1, 0, 4]
[[forces]]
law = "gravity"
acceleration = [0, 0, -9.81]
[[forces]]
law = "drag"
coefficient = 0.3
"#;

const ROD: &str = r#"
name = "rod"
duration = 3.0
[body]
points = [{ mass = 1, position = [-1, 0, 0] }, { mass = 2, position = [1, 0, 0] }]
[initial]
angular_velocity = [0, 0.5, 1.0]
[[forces]]
law = "spring"
point = 0
anchor = [-1, 0.5, 1]
stiffness = 6.0
damping = 0.2
rest_length = 0.3
[[forces]]
law = "lorentz"
charge = [1.0, -2.0]
electric = [0.5, -0.25, 1.0]
magnetic = [0, 0.5, 2.0]
"#;

const MOLECULE: &str = r#"
name = "molecule"
duration = 1e-12
[body]
points = [
  { mass = 2.66e-26, position = [0, 0, 0] },
  { mass = 1.67e-27, position = [7.6e-11, 5.9e-11, 0] },
  { mass = 1.67e-27, position = [-7.6e-11, 5.9e-11, 0] },
]
[initial]
angular_velocity = [3e12, 1e12, 2e12]
velocity = [300, 0, 100]
[[forces]]
law = "dipole"
moment = [0, 6.2e-30, 0]
field = [0, 0, 1e9]
"#;

const ASTEROID: &str = r#"
name = "asteroid"
duration = 1e7
[body]
mass = 1e24
inertia = [1e36, 1.5e36, 2e36]
pivot = [1e4, 0, 1e5]
[initial]
angular_momentum = [1e30, 2e30, 3e30]
[[forces]]
law = "torque"
axes = "world"
sine = [1e23, 0, 2e22]
frequency = 1e-6
[[forces]]
law = "gravity-gradient"
mu_over_r3 = 1e-13
direction = [1, 1, 0]
rate = 1e-7
"#;

fn gate(text: &str) -> Records {
    let scenes = vec![Scene::parse(text, "user.toml").expect("a scene")];
    let note = |c: &Contestant| matches!(c.card.name, "peskin-rk2" | "euler");
    let contestants = Contestant::all().into_iter().filter(note).collect();
    let baseline = Baseline::built_in();
    Campaign { baseline, ..Campaign::of(scenes, contestants) }.run()
}

#[test]
fn scenes_never_seen_before_pass_the_gate() {
    for text in [POINT, ROD, MOLECULE, ASTEROID] {
        let records = gate(text);
        let held_against: Vec<_> = records
            .verdicts
            .iter()
            .filter(|v| !matches!(v.verdict, Ruling::Pass | Ruling::NotApplicable))
            .map(|v| format!("{} {} {}: {}", v.scheme, v.claim, v.quantity, v.detail))
            .collect();
        assert_eq!(gates::exit_code(&records.verdicts), 0, "{text}\n{held_against:#?}");
        assert!(
            records.verdicts.iter().any(|v| v.claim == ClaimName::Order && v.verdict == Ruling::Pass),
            "{text}"
        );
    }
}

#[test]
fn a_torque_about_a_rod_is_refused_with_its_law() {
    let body = "name = \"rod\"\nduration = 1.0\n[body]\npoints = [{ mass = 1, position = [-1, 0, 0] }, { mass = 1, position = [1, 0, 0] }]\n";
    for law in [
        "law = \"torque\"\naxes = \"world\"\nconstant = [0, 0, 1]",
        "law = \"torque\"\naxes = \"body\"\nconstant = [1, 0, 1]",
        "law = \"dipole\"\nmoment = [0, 1, 0]\nfield = [0, 0, 1]",
    ] {
        let error = Scene::parse(&format!("{body}[[forces]]\n{law}\n"), "user.toml").expect_err("refused");
        let SceneError::Content { faults, .. } = error else { panic!("another error") };
        let [fault] = &faults[..] else { panic!("{faults:?}") };
        assert_eq!((fault.line, fault.key.as_str()), (6, "forces[0].law"), "{fault}");
        assert!(fault.message.contains("rod"), "{fault}");
    }
    for law in [
        "law = \"torque\"\naxes = \"body\"\nconstant = [0, 0, 1]",
        "law = \"dipole\"\nmoment = [1, 0, 0]\nfield = [0, 0, 1]",
    ] {
        assert!(Scene::parse(&format!("{body}[[forces]]\n{law}\n"), "user.toml").is_ok(), "{law}");
    }
}
