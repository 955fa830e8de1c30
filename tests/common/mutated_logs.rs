//! Logs with random changes of their bytes: each is refused with a short message, or judged without a false pass.

use polhode::internals::log::{Request, judge_text};
use polhode::model::Quantity;
use polhode::record::Ruling;
use polhode::scenes::Scene;

use crate::changed_logs::Chance;

/// One radian a second about z.
pub const STILL: &str = "name = \"still\"\nduration = 2.0\n[body]\nmass = 1.0\ninertia = [1.0, 2.0, 2.5]\n[initial]\nangular_velocity = [0.0, 0.0, 1.0]\n";
pub fn still() -> Scene {
    Scene::parse(STILL, "still.toml").expect("a scene")
}

/// A log with random changes of its bytes.
fn mutated(chance: &mut Chance) -> String {
    let mut text = "t,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n".to_owned();
    for k in 0..6 {
        text += &format!("{},0,0,0,1,0,0,{},0,0,0,0,0,1\n", 0.1 * f64::from(k), 0.05 * f64::from(k));
    }
    const PIECES: [&str; 22] = [
        "",
        ",",
        ";",
        "\t",
        "\n",
        "\r\n",
        "nan",
        "inf",
        "-",
        "1e308",
        "1e-320",
        "\"",
        "#",
        "%",
        " ",
        "=",
        "q",
        "t",
        "[deg]",
        "é",
        "99999999999999999999",
        ",,,,",
    ];
    for _ in 0..1 + chance.below(6) {
        let mut at = chance.below(text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let mut to = (at + chance.below(8)).min(text.len());
        while !text.is_char_boundary(to) {
            to -= 1;
        }
        text.replace_range(at..to.max(at), PIECES[chance.below(PIECES.len())]);
    }
    text
}

/// Judges so many mutated logs; returns how many were refused.
pub fn mutate(count: usize) -> usize {
    let mut chance = Chance::of(19);
    let scene = still();
    let mut refused = 0;
    for _ in 0..count {
        let text = mutated(&mut chance);
        match judge_text(&text, &scene, &Request::default()) {
            Ok(judgement) => {
                let verdict = judgement.against(Quantity::Orientation, 1e-9);
                let largest = verdict.largest.map_or(f64::NAN, |largest| largest.0);
                assert!(verdict.ruling != Ruling::Pass || largest <= 1e-9, "{text}");
            }
            Err(error) => {
                refused += 1;
                assert!(error.to_string().len() < 4000, "{error}");
            }
        }
    }
    refused
}
