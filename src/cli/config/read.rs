//! Reads `polhode.toml`: every fault of the file at once, each with its line and the word that is wrong.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

use super::keys::{Form, Key, Kind, SECTIONS, Section};
use crate::cli::select::meant;
use crate::fault::Fault;
use crate::model::Quantity;
use crate::simulate::Contestant;

/// Powers of two that a number of steps may be: four steps show an order, and 2^20 take a slow program hours.
pub(super) const STEPS: std::ops::RangeInclusive<u32> = 2..=20;

/// The faults of a file.
pub(super) struct Faults<'t> {
    text: &'t str,
    found: Vec<Fault>,
}

impl<'t> Faults<'t> {
    pub(super) fn of(text: &'t str) -> Faults<'t> {
        Faults { text, found: Vec::new() }
    }

    fn add(&mut self, place: Range<usize>, why: String) {
        self.found.push(Fault::at(self.text, place, "", why));
    }

    /// In the order of the file.
    pub(super) fn finish(mut self) -> Vec<Fault> {
        self.found.sort_by_key(|fault| fault.span.start);
        self.found
    }

    /// Looks at the whole file.
    pub(super) fn check(&mut self) {
        match DeTable::parse(self.text) {
            Ok(root) => self.top(root.get_ref()),
            Err(error) => {
                self.add(error.span().unwrap_or(0..0), format!("not TOML: {}", error.message()));
            }
        }
    }

    fn top(&mut self, root: &DeTable) {
        let Some(top) = SECTIONS.iter().find(|section| section.form == Form::Top) else { return };
        for (key, value) in root {
            let named =
                SECTIONS.iter().find(|section| section.form != Form::Top && section.name == key.get_ref());
            match named {
                Some(section) => self.section(section, value),
                None => {
                    let tables = SECTIONS.iter().map(|section| section.name).filter(|name| !name.is_empty());
                    self.entry(top, tables.collect(), key, value);
                }
            }
        }
    }

    fn section(&mut self, section: &Section, value: &Spanned<DeValue>) {
        match (value.get_ref(), section.form) {
            (DeValue::Table(table), Form::One | Form::Named) => self.table(section, table),
            (DeValue::Array(list), Form::Many) => {
                for each in list {
                    match each.get_ref() {
                        DeValue::Table(table) => self.table(section, table),
                        _ => self.add(each.span(), format!("{}: expected a table", section.name)),
                    }
                }
            }
            (_, Form::Many) => self.add(value.span(), format!("{0}: expected tables [[{0}]]", section.name)),
            _ => self.add(value.span(), format!("{0}: expected a table [{0}]", section.name)),
        }
    }

    fn table(&mut self, section: &Section, table: &DeTable) {
        for (key, value) in table {
            match (section.form, section.keys.first()) {
                (Form::Named, Some(pattern)) => {
                    self.own_name(key);
                    self.value(pattern, key.get_ref(), value);
                }
                _ => self.entry(section, Vec::new(), key, value),
            }
        }
    }

    /// A name of the user's hides no scheme of the list.
    fn own_name(&mut self, key: &Spanned<toml::de::DeString>) {
        let name = key.get_ref();
        if name == "all" || Contestant::everyone().iter().any(|one| one.card.name == name) {
            self.add(
                key.span(),
                format!("'{name}' is the name of a scheme of the list: choose another name"),
            );
        }
    }

    fn entry(
        &mut self,
        section: &Section,
        others: Vec<&str>,
        key: &Spanned<toml::de::DeString>,
        value: &Spanned<DeValue>,
    ) {
        let word = key.get_ref();
        if let Some(known) = section.keys.iter().find(|known| known.name == word) {
            return self.value(known, word, value);
        }
        let known: Vec<&str> = section.keys.iter().map(|key| key.name).chain(others).collect();
        let (meant, keys) = (meant(word, known.iter().copied()), known.join(", "));
        self.add(key.span(), format!("no such key '{word}'{meant} the keys here are {keys}"));
    }

    fn value(&mut self, key: &Key, name: &str, value: &Spanned<DeValue>) {
        if !fits(key.kind, value.get_ref()) {
            let found = &self.text[value.span()];
            let (expected, example) = (expected(key.kind), key.example);
            self.add(
                value.span(),
                format!("{name}: expected {expected}, found {found}: write {name} = {example}"),
            );
        }
    }
}

fn fits(kind: Kind, value: &DeValue) -> bool {
    let text = |value: &DeValue| value.as_str().filter(|text| !text.trim().is_empty()).map(str::to_owned);
    match kind {
        Kind::Texts => value
            .as_array()
            .is_some_and(|list| !list.is_empty() && list.iter().all(|each| text(each.get_ref()).is_some())),
        Kind::Text => text(value).is_some(),
        Kind::Quantity => text(value).is_some_and(|text| Quantity::ALL.iter().any(|one| one.name() == text)),
        Kind::Positive => number(value).is_some_and(|number| number > 0.0 && number.is_finite()),
        Kind::Order => integer(value).is_some_and(|order| (1..=12).contains(&order)),
        Kind::Steps => {
            integer(value).is_some_and(|steps| steps.is_power_of_two() && STEPS.contains(&steps.ilog2()))
        }
    }
}

fn expected(kind: Kind) -> String {
    match kind {
        Kind::Texts => "a list of names".to_owned(),
        Kind::Text => "a text in quotes".to_owned(),
        Kind::Quantity => format!("one of {}", Quantity::ALL.map(Quantity::name).join(", ")),
        Kind::Positive => "a number above 0".to_owned(),
        Kind::Order => "an order from 1 to 12".to_owned(),
        Kind::Steps => format!("a power of two from {} to {}", 1u64 << STEPS.start(), 1u64 << STEPS.end()),
    }
}

fn integer(value: &DeValue) -> Option<u64> {
    let whole = |integer: &DeInteger| u64::from_str_radix(integer.as_str(), integer.radix()).ok();
    value.as_integer().and_then(whole)
}

fn number(value: &DeValue) -> Option<f64> {
    let float = value.as_float().and_then(|float| float.as_str().parse().ok());
    float.or_else(|| integer(value).map(|integer| integer as f64))
}
