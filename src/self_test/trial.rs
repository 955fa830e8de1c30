//! A defect planted in a scene, and what the gates say of it.

use std::collections::BTreeSet;

use super::planted::{self, Plant};
use super::{copy, measured};
use crate::campaign::{self, Campaign};
use crate::claim::Claim;
use crate::gates::{self, Baseline};
use crate::measure;
use crate::model::System;
use crate::record::{Evidence, Verdict};
use crate::reference::{Reference, stored};
use crate::scenes::Scene;
use crate::schemes::{Card, PeskinRk2, Scheme};
use crate::simulate::Contestant;

/// Samples of a reference.
const SAMPLES: usize = 64;

/// What right schemes have on record in a scene, as `bless` writes it.
pub(super) fn on_record(scene: &str, schemes: &BTreeSet<&str>) -> Baseline {
    let right = Contestant::all().into_iter().filter(|contestant| schemes.contains(contestant.card.name));
    Scene::find(scene).map_or_else(
        |_| Baseline::default(),
        |scene| Baseline::from_records(&Campaign::of(vec![scene], right.collect()).run()),
    )
}

/// The verdicts on a defect in a scene, against what is on record.
pub(super) fn verdicts(plant: &Plant, scene: &str, baseline: &Baseline) -> Vec<Verdict> {
    let judge = |contestant, scene| judge(contestant, scene, baseline);
    match *plant {
        Plant::Scheme(flaw) => judge(copy::contestant(flaw), scene),
        Plant::Other(contestant) => judge(contestant(), scene),
        Plant::Law(change) => judge(bent(move |system| planted::under(system, change), |_, _| ()), scene),
        Plant::Start(change) => {
            let other = move |system: &System| {
                let mut other = system.clone();
                change(&mut other);
                other
            };
            judge(bent(other, |_, _| ()), scene)
        }
        Plant::Shown(change) => judge(bent(System::clone, change), scene),
        Plant::Claims(name, claims) => judge(claiming(name, claims), scene),
        Plant::Reference(change) => judge_against(change, None, (scene, baseline)),
        Plant::Metric(measure) => judge_against(|_| (), Some(measure), (scene, baseline)),
    }
}

/// The scheme on another system than it is judged in, or showing another state than it has.
fn bent(
    other: impl Fn(&System) -> System + Send + Sync + 'static,
    shown: fn(&mut crate::model::Snapshot, &System),
) -> Contestant {
    let scheme = Contestant::new(PeskinRk2);
    Contestant::foreign(PeskinRk2.card(), move |system, form, plan, store| {
        let other = other(system);
        scheme.stream(&other, form, plan, &mut |snapshot| {
            let mut bent = *snapshot;
            shown(&mut bent, system);
            store(&bent);
        })
    })
}

/// Whether a card makes one of the two claims: it has one order, and says once how the energy changes.
fn exclude(one: Claim, other: Claim) -> bool {
    let order = |claim| matches!(claim, Claim::Order(_) | Claim::SolvesAnotherMotion);
    let exact = matches!(one, Claim::Exact(..));
    (order(one) && order(other)) || (one.name() == other.name() && !exact)
}

/// A scheme with these claims in the place of those that they exclude.
fn claiming(name: &str, claims: &'static [Claim]) -> Contestant {
    let all = Contestant::all();
    let mut scheme =
        all.into_iter().find(|c| c.card.name == name).unwrap_or_else(|| Contestant::new(PeskinRk2));
    let other = |own: &&Claim| !claims.iter().any(|claim| exclude(*claim, **own));
    let all: Vec<Claim> = scheme.card.claims.iter().filter(other).chain(claims).copied().collect();
    scheme.card = Card { claims: all.leak(), ..scheme.card };
    scheme
}

/// The verdicts on a contestant in a scene.
pub(super) fn judge(contestant: Contestant, scene: &str, baseline: &Baseline) -> Vec<Verdict> {
    let Ok(scene) = Scene::find(scene) else { return Vec::new() };
    let campaign = Campaign::of(vec![scene], vec![contestant]);
    Campaign { baseline: baseline.clone(), ..campaign }.run().verdicts
}

/// The scheme against a reference that is wrong, or with errors that are measured wrongly.
fn judge_against(
    change: fn(&mut Reference),
    measure: Option<planted::Measure>,
    (scene, baseline): (&str, &Baseline),
) -> Vec<Verdict> {
    let Ok(scene) = Scene::find(scene) else { return Vec::new() };
    let stored = stored::find(&scene.name).ok().flatten();
    let Ok(mut reference) = Reference::of(&scene.system, scene.duration, SAMPLES, stored.as_ref()) else {
        return Vec::new();
    };
    change(&mut reference);
    let contestant = Contestant::new(PeskinRk2);
    let climbed = measure::climb(&contestant, &scene.system, &reference, Some(2));
    let ladder = match measure {
        Some(measure) => measured::mismeasured(&contestant, &scene.system, &reference, &climbed, measure),
        None => climbed.ladder,
    };
    gates::judge(&Evidence { ladder, ..campaign::unmeasured(&scene, &contestant) }, baseline)
}
