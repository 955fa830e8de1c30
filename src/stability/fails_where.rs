//! One line a scheme: where it fails, made from the records alone.

use crate::record::stability::{Limit, LinearLimit};

/// Scenes that the line speaks of: a free body, one that tumbles, and one held at a point under gravity.
pub const SCENES: [&str; 3] = ["free-asymmetric", "dzhanibekov", "heavy-asymmetric-top"];

/// How the line calls the scenes.
const CALLED: [&str; 3] = ["free body", "tumbling body", "heavy top"];

/// The line of a scheme; `None` where nothing of it was measured.
pub fn line(scheme: &str, limits: &[Limit], linear: &[LinearLimit]) -> Option<String> {
    let mut parts = Vec::new();
    if let Some(row) = linear.iter().find(|row| row.scheme == scheme) {
        parts.push(spring(row));
    }
    for (scene, called) in SCENES.iter().zip(CALLED) {
        let of = |meaning: &str| {
            limits.iter().find(|row| row.scheme == scheme && row.scene == *scene && row.meaning == meaning)
        };
        let words: Vec<String> = ["bounded", "energy", "orientation"]
            .iter()
            .filter_map(|meaning| of(meaning).and_then(|row| edge(meaning, row)))
            .collect();
        if !words.is_empty() {
            parts.push(format!("{called}: {}", words.join(", ")));
        } else if of("bounded").is_some_and(|row| row.status == "unlimited") {
            parts.push(format!("{called}: at no step tried"));
        }
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn spring(row: &LinearLimit) -> String {
    let body = if row.zeta > 0.0 {
        format!("spring-held body (ζ = {:.3})", row.zeta)
    } else {
        "spring-held body".to_owned()
    };
    match row.h_omega {
        Some(limit) => format!("{body}: h·ω > {limit:.3} ({})", row.failure),
        None if row.failure.starts_with("stable") => format!("{body}: at no step tried"),
        None => format!("{body}: at every step ({})", row.failure),
    }
}

/// What happens above a limit, where there is one.
fn edge(meaning: &str, row: &Limit) -> Option<String> {
    let what = match meaning {
        "bounded" => "unbounded",
        "energy" => "energy off by 1 %",
        _ => "0.1 rad off",
    };
    let how = row.failure.as_deref().unwrap_or("unknown");
    match (row.status.as_str(), row.radians_per_step) {
        ("limit", Some(radians)) => Some(format!("{what} above {radians:.2e} rad a step ({how})")),
        ("none", _) => Some(format!("{what} at every step tried ({how})")),
        _ => None,
    }
}
