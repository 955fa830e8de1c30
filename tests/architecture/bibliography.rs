//! Every source that a card names stands in the bibliography.

use polhode::simulate::Contestant;

#[test]
fn every_key_that_a_card_cites_stands_in_the_bibliography() {
    let bibliography = include_str!("../../references/bibliography.bib");
    let has = |key: &str| {
        bibliography.lines().any(|line| line.starts_with('@') && line.contains(&format!("{{{key},")))
    };
    for contestant in Contestant::all() {
        for key in contestant.card.source.split("; ") {
            assert!(has(key), "{} cites {key}", contestant.card.name);
        }
    }
}

#[test]
fn the_main_schemes_are_in_the_list() {
    assert_eq!(Contestant::main().len(), polhode::schemes::MAIN.len());
    assert!(Contestant::all().len() >= 40);
}
