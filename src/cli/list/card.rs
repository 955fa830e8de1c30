//! All that is known of one scheme or one scene.

use crate::claim::Claim;
use crate::record::stability::Stability;
use crate::scenes::Scene;
use crate::schemes::Card;

/// A scheme: what it is, what it claims, where it fails, where it comes from.
pub(super) fn scheme(card: &Card) -> String {
    let mut text = format!("{}: {}\n", card.name, card.title);
    text += &format!("family       {}\n", card.family);
    let claims = promises(card.claims);
    for (index, claim) in claims.iter().enumerate() {
        text += &format!("{:12} {claim}\n", if index == 0 { "claims" } else { "" });
    }
    text += &format!("fails where  {}\n", Stability::built_in().line(card.name).unwrap_or("not on record"));
    text + &format!("source       {} (references/bibliography.bib)\n", card.source)
}

/// Claims in words; those of exactness that are made for the same scenes in one.
fn promises(claims: &[Claim]) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for (index, claim) in claims.iter().enumerate() {
        let Claim::Exact(_, when) = claim else {
            words.push(claim.to_string());
            continue;
        };
        let alike = |other: &Claim| match other {
            Claim::Exact(quantity, same) if same == when => Some(quantity.name()),
            _ => None,
        };
        if !claims[..index].iter().any(|earlier| alike(earlier).is_some()) {
            let quantities: Vec<&str> = claims.iter().filter_map(alike).collect();
            words.push(format!("exact {when}: {}", quantities.join(", ")));
        }
    }
    words
}

/// A scene: what it is, what it shows, and which claims are judged in it.
pub(super) fn scene(scene: &Scene) -> String {
    let laws = scene.system.forces.laws().iter().map(|law| law.name()).collect::<Vec<_>>().join(", ");
    let mut text = format!("{}: {}\n", scene.name, scene.title);
    let mut line = |key: &str, value: &str| {
        if !value.is_empty() {
            text += &format!("{key:12} {value}\n");
        }
    };
    line("why", &scene.why);
    line("duration", &format!("{} s", scene.duration));
    line("model", scene.system.least().name());
    line("forces", if laws.is_empty() { "none" } else { &laws });
    line("no order", scene.not_for_order.as_deref().unwrap_or_default());
    line("no claim", scene.only_for_stability.as_deref().unwrap_or_default());
    line("file", &scene.file);
    text
}
