//! Gates for a scheme of your own, in your own `cargo test`.
//!
//! The guide has an example. In a test file of your crate the assertion stands in a `#[test]`. Where the order is another one it panics
//! with a line such as `my-heun: order 1.00 measured, 2 claimed, in 21 of 21 quantities`, and with what was measured in each of them.

use crate::campaign::Campaign;
use crate::claim::Claim;
use crate::gates::Baseline;
use crate::record::{ClaimName, Ruling, Verdict};
use crate::scenes::{Scene, SceneError};
use crate::schemes::{Scheme, TurningScheme};
use crate::simulate::Contestant;

/// Scenes that an order is asserted in: without torque, about a pivot, under forces on points, with time and
/// velocity in the forces.
const SCENES: [&str; 4] = ["free-asymmetric", "kovalevskaya", "tether-springs", "gravity-drag"];

/// Asserts that a scheme has an order, from above and from below, in every quantity: in `free-asymmetric`, `kovalevskaya`,
/// `tether-springs` and `gravity-drag`.
///
/// # Panics
/// It has another, none can be read, or a run breaks; the message says where and what was measured.
#[track_caller]
pub fn assert_order<S: Scheme>(scheme: &S, order: u32) {
    assert_order_in(&Contestant::new(scheme.clone()), order, &SCENES);
}

/// The same for a scheme in body axes.
///
/// # Panics
/// As [`assert_order`].
#[track_caller]
pub fn assert_order_in_body_axes<S: TurningScheme>(scheme: &S, order: u32) {
    assert_order_in(&Contestant::turning(scheme.clone()), order, &SCENES);
}

/// The same for anything that can be measured, in scenes of your own: built-in names or paths of scene files.
///
/// # Panics
/// As [`assert_order`]; or a scene cannot be read.
#[track_caller]
pub fn assert_order_in(contestant: &Contestant, order: u32, scenes: &[&str]) {
    match orders(contestant, order, scenes) {
        Err(error) => panic!("{error}"),
        Ok(verdicts) => {
            if let Some(complaint) = complaint(contestant.card.name, order, scenes, &verdicts) {
                panic!("{complaint}");
            }
        }
    }
}

/// What the order gate says, with `order` in the place of what the scheme claims of itself.
fn orders(contestant: &Contestant, order: u32, scenes: &[&str]) -> Result<Vec<Verdict>, SceneError> {
    let mut contestant = contestant.clone();
    let others = contestant.card.claims.iter().filter(|claim| matches!(claim, Claim::Exact(..)));
    contestant.card.claims = others.copied().chain([Claim::Order(order)]).collect::<Vec<_>>().leak();
    let scenes = scenes.iter().map(|name| Scene::find(name)).collect::<Result<_, _>>()?;
    let campaign = Campaign { baseline: Baseline::default(), ..Campaign::of(scenes, vec![contestant]) };
    let judged = |verdict: &Verdict| is_of_order(verdict) || verdict.scheme == "reference";
    Ok(campaign.run().verdicts.into_iter().filter(judged).collect())
}

/// Most lines of a complaint about a scene.
const MOST_LINES: usize = 10;

/// What is wrong, the summary first; `None` where nothing is.
fn complaint(name: &str, order: u32, scenes: &[&str], verdicts: &[Verdict]) -> Option<String> {
    let settled = |verdict: &Verdict| matches!(verdict.verdict, Ruling::Pass | Ruling::NotApplicable);
    let wrong: Vec<&Verdict> = verdicts.iter().filter(|verdict| !settled(verdict)).collect();
    let judged = verdicts.iter().filter(|v| is_of_order(v) && v.verdict != Ruling::NotApplicable).count();
    if wrong.is_empty() {
        let nothing = || format!("{name}: no order could be measured in {}", scenes.join(", "));
        return (judged == 0).then(nothing);
    }
    let same_scene = |a: &&Verdict, b: &&Verdict| a.scene == b.scene;
    let details = wrong.chunk_by(same_scene).flat_map(details);
    Some(std::iter::once(summary(name, order, &wrong, judged)).chain(details).collect::<Vec<_>>().join("\n"))
}

fn is_of_order(verdict: &Verdict) -> bool {
    verdict.claim == ClaimName::Order
}

/// The median of the orders that are wrong, and how many are.
fn summary(name: &str, order: u32, wrong: &[&Verdict], judged: usize) -> String {
    let wrong: Vec<&&Verdict> = wrong.iter().filter(|verdict| is_of_order(verdict)).collect();
    if wrong.is_empty() {
        return format!("{name}: order {order} is not certain: a reference does not hold");
    }
    let measured = median(wrong.iter().filter_map(|verdict| verdict.measured).collect());
    let measured = measured.map_or("no order".to_owned(), |order| format!("order {order:.2}"));
    format!("{name}: {measured} measured, {order} claimed, in {} of {judged} quantities", wrong.len())
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let upper = values.get(values.len() / 2)?;
    let lower = values[(values.len() - 1) / 2];
    Some((lower + upper) / 2.0)
}

/// The lines on a scene, [`MOST_LINES`] at most.
fn details(wrong: &[&Verdict]) -> Vec<String> {
    let line = |v: &&Verdict| format!("  {}, {}: {}: {}", v.scene, v.quantity, v.verdict.word(), v.detail);
    let mut lines: Vec<String> = wrong.iter().map(line).collect();
    if lines.len() > MOST_LINES {
        let shown = MOST_LINES - 1;
        let more = format!("  {}: and {} more", wrong[0].scene, lines.len() - shown);
        lines.truncate(shown);
        lines.push(more);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(scene: &str, quantity: usize, verdict: Ruling, measured: Option<f64>) -> Verdict {
        let (scene, quantity) = (scene.to_owned(), format!("quantity-{quantity}"));
        Verdict { scene, scheme: "mine".to_owned(), quantity, verdict, measured, ..Verdict::default() }
    }

    fn of_first_order(scene: &str, quantities: usize) -> Vec<Verdict> {
        (0..quantities).map(|index| verdict(scene, index, Ruling::Fail, Some(1.0))).collect()
    }

    #[test]
    fn the_first_line_says_what_was_measured_and_in_how_many_quantities() {
        let mut verdicts = of_first_order("one", 3);
        verdicts.push(verdict("one", 3, Ruling::Fail, Some(1.5)));
        verdicts.push(verdict("one", 4, Ruling::Pass, Some(2.0)));
        verdicts.push(verdict("one", 5, Ruling::Inconclusive, None));
        verdicts.push(verdict("one", 6, Ruling::NotApplicable, None));
        let text = complaint("mine", 2, &["one"], &verdicts).expect("a complaint");
        assert_eq!(text.lines().next(), Some("mine: order 1.00 measured, 2 claimed, in 5 of 6 quantities"));
        assert_eq!(text.lines().count(), 6);
    }

    #[test]
    fn a_scene_has_ten_lines_at_most() {
        let verdicts = [of_first_order("one", 12), of_first_order("two", 10)].concat();
        let text = complaint("mine", 2, &["one", "two"], &verdicts).expect("a complaint");
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 1 + 10 + 10);
        assert_eq!(lines[10], "  one: and 3 more");
    }

    #[test]
    fn nothing_measured_and_a_reference_that_does_not_hold_are_complaints() {
        let none = [verdict("one", 0, Ruling::NotApplicable, None)];
        assert!(complaint("mine", 2, &["one"], &none).is_some());
        let passed = verdict("one", 0, Ruling::Pass, Some(2.0));
        assert!(complaint("mine", 2, &["one"], std::slice::from_ref(&passed)).is_none());
        let reference = Verdict {
            scheme: "reference".to_owned(),
            claim: ClaimName::ReferencesAgree,
            ..Verdict::default()
        };
        assert!(complaint("mine", 2, &["one"], &[passed, reference]).is_some());
    }

    #[test]
    fn a_median_is_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![1.0, 2.0]), Some(1.5));
        assert_eq!(median(Vec::new()), None);
    }
}
