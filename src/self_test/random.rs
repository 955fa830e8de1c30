//! Correct schemes in random scenes: none may fail, and what is left undecided must say why.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::campaign::Campaign;
use crate::interrupt;
use crate::record::{ClaimName, Ruling, Verdict};
use crate::scenes::random::{self, Family};
use crate::simulate::Contestant;

/// Correct schemes of seven families: the note's, a classical Runge–Kutta, one in rotation vectors, a splitting, an implicit
/// rule, and one of several steps.
pub const SCHEMES: [&str; 7] = [
    "peskin-rk2",
    "euler",
    "rk4-quaternion",
    "rkmk4",
    "strang-rotations",
    "implicit-midpoint",
    "adams-bashforth-2",
];

/// A verdict that is against a correct scheme, or that is none, and where.
#[derive(Clone, Debug)]
pub struct Finding {
    /// Family of the scene.
    pub family: Family,
    /// Number of the scene.
    pub number: u64,
    /// The verdict.
    pub verdict: Verdict,
}

/// How often each verdict was given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Holds.
    pub pass: usize,
    /// Does not hold.
    pub fail: usize,
    /// Undecided.
    pub inconclusive: usize,
    /// Not applicable, exact motion included.
    pub not_applicable: usize,
    /// A run broke.
    pub broken: usize,
}

impl Tally {
    pub(super) fn count(&mut self, ruling: Ruling) {
        match ruling {
            Ruling::Pass => self.pass += 1,
            Ruling::Fail => self.fail += 1,
            Ruling::Inconclusive => self.inconclusive += 1,
            Ruling::NotApplicable => self.not_applicable += 1,
            Ruling::Broken => self.broken += 1,
        }
    }

    /// Verdicts of any kind.
    pub fn all(&self) -> usize {
        self.pass + self.fail + self.inconclusive + self.not_applicable + self.broken
    }

    /// The part that is decided.
    pub fn decided(&self) -> f64 {
        1.0 - self.inconclusive as f64 / self.all().max(1) as f64
    }
}

/// What the random scenes showed.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Scenes that were judged.
    pub scenes: usize,
    /// Scenes without any reference, in which nothing is judged.
    pub without_reference: usize,
    /// Verdicts by scheme; the reference is one of them.
    pub verdicts: BTreeMap<String, Tally>,
    /// A scheme in a scene, as the gate of that one scene ends: its worst verdict.
    pub gates: Tally,
    /// Failures and broken runs.
    pub against: Vec<Finding>,
    /// What is undecided.
    pub undecided: Vec<Finding>,
    /// False where the user ended it early.
    pub complete: bool,
}

impl Findings {
    /// Whether nothing was held against a correct scheme.
    pub fn sound(&self) -> bool {
        self.complete && self.against.is_empty()
    }

    /// How often each cause left a verdict undecided, by family and by scheme: claim, quantity without its place, and the reason without its
    /// numbers.
    pub fn causes(&self) -> BTreeMap<String, BTreeMap<(Family, String), usize>> {
        let mut causes: BTreeMap<String, BTreeMap<(Family, String), usize>> = BTreeMap::new();
        for Finding { family, verdict, .. } in &self.undecided {
            let kinds = causes.entry(cause(verdict)).or_default();
            *kinds.entry((*family, verdict.scheme.clone())).or_default() += 1;
        }
        causes
    }

    fn take(&mut self, family: Family, number: u64, verdicts: Vec<Verdict>) {
        self.scenes += 1;
        let mut worst: BTreeMap<String, Ruling> = BTreeMap::new();
        for verdict in verdicts {
            if verdict.claim == ClaimName::ReferencesAgree && verdict.quantity == "all" {
                self.without_reference += 1;
            }
            self.verdicts.entry(verdict.scheme.clone()).or_default().count(verdict.verdict);
            let own = worst.entry(verdict.scheme.clone()).or_insert(Ruling::NotApplicable);
            if weight(verdict.verdict) > weight(*own) {
                *own = verdict.verdict;
            }
            match verdict.verdict {
                Ruling::Fail | Ruling::Broken => self.against.push(Finding { family, number, verdict }),
                Ruling::Inconclusive => self.undecided.push(Finding { family, number, verdict }),
                Ruling::Pass | Ruling::NotApplicable => {}
            }
        }
        worst.remove("reference");
        worst.into_values().for_each(|ruling| self.gates.count(ruling));
    }
}

/// How bad a ruling is.
pub(super) fn weight(ruling: Ruling) -> u8 {
    match ruling {
        Ruling::NotApplicable => 0,
        Ruling::Pass => 1,
        Ruling::Inconclusive => 2,
        Ruling::Broken => 3,
        Ruling::Fail => 4,
    }
}

/// Why a verdict is undecided, without the numbers.
pub(super) fn cause(verdict: &Verdict) -> String {
    let is_number = |word: &str| word.contains(|letter: char| letter.is_ascii_digit());
    let mut words: Vec<&str> = Vec::new();
    for word in verdict.detail.split_whitespace().map(|word| if is_number(word) { "#" } else { word }) {
        if !(word == "#" && words.last() == Some(&"#")) {
            words.push(word);
        }
    }
    format!("{}: {}", verdict.claim, words.join(" "))
}

/// Judges [`SCHEMES`] in the first `count` random scenes of a seed, whose families take turns. `progress` is called as (done, of all).
pub fn run(families: &[Family], seed: u64, count: u64, progress: &(dyn Fn(usize, usize) + Sync)) -> Findings {
    let done = AtomicUsize::new(0);
    let family = |number: u64| families[number as usize % families.len()];
    let judged: Vec<Option<Vec<Verdict>>> = (0..count)
        .into_par_iter()
        .map(|number| {
            let verdicts = (!interrupt::requested()).then(|| judge(family(number), seed, number));
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, count as usize);
            verdicts.filter(|_| !interrupt::requested())
        })
        .collect();
    let mut findings = Findings { complete: !interrupt::requested(), ..Findings::default() };
    for (number, verdicts) in (0..count).zip(judged) {
        if let Some(verdicts) = verdicts {
            findings.take(family(number), number, verdicts);
        }
    }
    findings
}

/// The verdicts on the schemes in one scene; a text that is no scene counts against the generator.
fn judge(family: Family, seed: u64, number: u64) -> Vec<Verdict> {
    let scene = match random::scene(family, seed, number) {
        Ok(scene) => scene,
        Err(error) => {
            let (scene, detail) = (format!("{family}-{seed}-{number}"), error.to_string());
            let scheme = "generator".to_owned();
            return vec![Verdict { scene, scheme, verdict: Ruling::Broken, detail, ..Verdict::default() }];
        }
    };
    let all = Contestant::all();
    let named = |name: &&str| all.iter().find(|contestant| contestant.card.name == *name).cloned();
    let contestants = SCHEMES.iter().filter_map(named).collect();
    Campaign::of(vec![scene], contestants).run().verdicts
}
