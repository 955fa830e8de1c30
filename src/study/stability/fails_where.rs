//! One line a scheme: where it fails, made from the records alone.

use crate::record::stability::{Limit, LimitStatus, LinearLimit, Meaning};

/// Scenes that the line speaks of: a free body, one that tumbles, and one held at a point under gravity.
pub const SCENES: [&str; 3] = ["free-asymmetric", "dzhanibekov", "heavy-asymmetric-top"];

/// How the line calls the scenes.
const CALLED: [&str; 3] = ["free body", "tumbling body", "heavy top"];

/// The line of a scheme; `None` where nothing of it was measured.
pub fn line(scheme: &str, limits: &[Limit], linear: &[LinearLimit]) -> Option<String> {
    let spring = linear.iter().find(|row| row.scheme == scheme).map(spring);
    let scenes = SCENES.iter().zip(CALLED).filter_map(|(scene, called)| {
        let of = |meaning: &Meaning| {
            limits.iter().find(|row| row.scheme == scheme && row.scene == *scene && row.meaning == *meaning)
        };
        let rows: Vec<&Limit> = Meaning::ALL.iter().filter_map(of).filter(|row| row.step_or_none()).collect();
        (!rows.is_empty()).then(|| format!("{called}: {}", edges(&rows)))
    });
    let parts: Vec<String> = spring.into_iter().chain(scenes).collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn spring(row: &LinearLimit) -> String {
    let body = if row.zeta > 0.0 {
        format!("spring-held body at ζ = {:.3}", row.zeta)
    } else {
        "spring-held body, undamped".to_owned()
    };
    match row.h_omega {
        Some(limit) => format!("{body}: above h·ω = {limit:.3} ({})", row.failure),
        None if row.failure.starts_with("stable") => format!("{body}: at no step tried"),
        None => format!("{body}: at every step ({})", row.failure),
    }
}

/// The steps from which on a motion is unbounded, its energy 1 % off and its orientation 0.1 rad, and how it fails at the smallest of
/// them.
fn edges(rows: &[&Limit]) -> String {
    if rows.iter().all(|row| row.status == LimitStatus::Unlimited) {
        return "at no step tried".to_owned();
    }
    let edge = |row: &&Limit| match (row.status, row.radians_per_step) {
        (LimitStatus::Limit, Some(radians)) => {
            Some(format!("{} above {}", what(row.meaning), digits(radians)))
        }
        (LimitStatus::None, _) => Some(format!("{} at every step", what(row.meaning))),
        _ => None,
    };
    let words: Vec<String> = rows.iter().filter_map(edge).collect();
    let first = rows.iter().min_by(|a, b| a.edge().total_cmp(&b.edge()));
    let how = first.and_then(|row| row.failure.as_deref()).unwrap_or("unknown");
    // The unit stands after the last number.
    let unit = if words.last().is_some_and(|last| last.ends_with("step")) { "" } else { " rad a step" };
    format!("{}{unit} ({how})", words.join(", "))
}

fn what(meaning: Meaning) -> &'static str {
    match meaning {
        Meaning::Bounded => "unbounded",
        Meaning::Energy => "energy 1 % off",
        Meaning::Orientation => "0.1 rad off",
    }
}

/// Two digits, without an exponent.
fn digits(value: f64) -> String {
    let decimals = (1.0 - value.abs().log10().floor()).clamp(0.0, 8.0) as usize;
    format!("{value:.decimals$}")
}
