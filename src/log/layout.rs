//! Which column of a file is what: its separator, its header, and what the user says.

use super::columns;
use super::euler::Sequence;
use super::headless;
use super::names;
use super::recognise;
use super::row::{COLUMNS, Part, Parts};
use super::said::{Columns, NO_FIELD};

/// What a column may be called by `--columns`: those of [`COLUMNS`], then Euler angles in the order of a sequence, angles about the axes
/// x, y, z, and modified Rodrigues parameters.
pub(super) const FIELDS: [&str; 23] = [
    "t", "x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz", "e1", "e2", "e3", "roll",
    "pitch", "yaw", "s1", "s2", "s3",
];
/// First field of angles in order, of angles about axes, and of modified Rodrigues parameters.
pub(super) const ANGLES: usize = 14;
pub(super) const ROLL: usize = 17;
pub(super) const SIGMA: usize = 20;
/// Letters of a name in messages.
const SHOWN: usize = 40;
/// Most columns: the names of all are held against one another.
const MOST_COLUMNS: usize = 4096;
/// Names in messages.
const MOST_SHOWN: usize = 40;

/// What stands between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Sign(u8),
    Blanks,
}

impl Separator {
    fn of(line: &str) -> Separator {
        let signs = [b'\t', b';', b','];
        let found = signs.into_iter().find(|sign| line.trim().as_bytes().contains(sign));
        found.map_or(Separator::Blanks, Separator::Sign)
    }

    fn word(self) -> &'static str {
        match self {
            Separator::Sign(b'\t') => "tabs",
            Separator::Sign(b';') => "semicolons",
            Separator::Sign(_) => "commas",
            Separator::Blanks => "blanks",
        }
    }

    fn cut(self, line: &str) -> Vec<&str> {
        match self {
            Separator::Sign(sign) => line.split(char::from(sign)).map(clean).collect(),
            Separator::Blanks => line.split_ascii_whitespace().map(clean).collect(),
        }
    }
}

/// A cell without blanks and quotes.
pub(super) fn clean(cell: &str) -> &str {
    cell.trim().trim_matches('"')
}

/// What a column is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slot {
    /// Its place in [`FIELDS`].
    pub field: usize,
    /// SI units in the unit that the header states.
    pub unit: Option<f64>,
}

/// How a file is read.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reading {
    pub separator: Separator,
    /// What each column is, from left to right; those after the last that is read are left out.
    pub slots: Vec<Option<Slot>>,
    /// Whether the first line that is no comment is a header.
    pub header: bool,
    /// Whether units stand in a line of their own below it.
    pub units: bool,
    /// Whether names say that angular velocities are in body axes.
    pub spin_in_body_axes: bool,
    /// The sequence of Euler angles, where the orientation is made of them.
    pub sequence: Option<Sequence>,
    /// In words.
    pub words: String,
    /// Names of columns that are not read, the first of them.
    unread: Vec<String>,
}

impl Reading {
    /// The fields that the file has.
    pub fn has(&self, field: usize) -> bool {
        self.slots.iter().flatten().any(|slot| slot.field == field)
    }

    pub fn unit(&self, field: usize) -> Option<f64> {
        self.slots.iter().flatten().find(|slot| slot.field == field).and_then(|slot| slot.unit)
    }

    pub fn has_all(&self, from: usize, count: usize) -> bool {
        (from..from + count).all(|field| self.has(field))
    }

    /// The parts for which there are columns.
    pub fn parts(&self) -> Parts {
        let has = |part: &Part| {
            let columns = part.columns();
            self.has_all(columns.start, columns.len())
                || *part == Part::Orientation
                    && [ANGLES, ROLL, SIGMA].iter().any(|first| self.has_all(*first, 3))
        };
        Parts::of(&Part::ALL.into_iter().filter(has).collect::<Vec<_>>())
    }

    /// What there are no columns for.
    pub fn missing_columns(&self) -> Vec<String> {
        let parts = self.parts();
        let missing = Part::ALL.into_iter().filter(|part| !parts.has(*part));
        let note = |part: Part| {
            format!("no column {}: what needs it is not applicable", COLUMNS[part.columns()].join(", "))
        };
        let mut notes: Vec<String> = missing.map(note).collect();
        if !notes.is_empty() && !self.unread.is_empty() {
            let unread = self.unread.join(", ");
            notes.push(format!("columns that were not read: {unread}; --columns says what a column is"));
        }
        notes
    }

    /// What the first lines of a file say: the last comment before `line`, which is the first that is none, and the line below.
    pub fn find(
        comment: Option<&str>,
        line: &str,
        below: &str,
        asked: Option<&Columns>,
    ) -> Result<Reading, String> {
        let separator = Separator::of(line);
        let cells = separator.cut(line);
        let header = cells.iter().any(|cell| !cell.is_empty() && number(cell, separator).is_none());
        if header {
            let reading = Reading::of_names(separator, &cells, true, asked)?;
            return Ok(reading.with_units(&cells, &separator.cut(below)));
        }
        if let Some(comment) = comment {
            let bare = comment.trim_start_matches(['#', '%', '/', ' ']);
            let names = Separator::of(bare).cut(bare);
            let known = names.iter().filter(|name| columns::meaning(name).is_some()).count();
            if names.len() == cells.len() && known > 1 {
                return Reading::of_names(separator, &names, false, asked);
            }
        }
        let numbers: Vec<String> = (1..=cells.len()).map(|n| n.to_string()).collect();
        let names: Vec<&str> = numbers.iter().map(String::as_str).collect();
        match asked {
            Some(_) => Reading::of_names(separator, &names, false, asked),
            None if headless::is_tum(separator, &cells) => {
                let tum = headless::TUM.parse().ok();
                let mut reading = Reading::of_names(separator, &names, false, tum.as_ref())?;
                reading.words += ", the format of TUM, which has no header";
                Ok(reading)
            }
            None => Err(headless::refusal(separator, &cells)),
        }
    }

    fn of_names(
        separator: Separator,
        names: &[&str],
        header: bool,
        asked: Option<&Columns>,
    ) -> Result<Reading, String> {
        if names.len() > MOST_COLUMNS {
            return Err(format!("there are {} columns, more than {MOST_COLUMNS}", names.len()));
        }
        let mut slots: Vec<Option<Slot>> = vec![None; names.len()];
        let in_body_axes = recognise::recognise(names, &mut slots);
        if let Some(asked) = asked {
            obey(asked, names, &mut slots)?;
        }
        one_of_each(names, &mut slots)?;
        while slots.last().is_some_and(Option::is_none) {
            slots.pop();
        }
        let mut reading = Reading {
            separator,
            slots,
            header,
            units: false,
            spin_in_body_axes: false,
            sequence: None,
            words: String::new(),
            unread: Vec::new(),
        };
        reading.spin_in_body_axes = in_body_axes && reading.parts().has(Part::Spin);
        if !reading.has(0) {
            return Err(format!("there is no column t; {}", reading.line_to_paste(names)));
        }
        if reading.parts() == Parts::default() {
            return Err(format!("there is no whole quantity beside t; {}", reading.line_to_paste(names)));
        }
        if !reading.has_all(4, 4) && reading.parts().has(Part::Orientation) && !reading.has_all(SIGMA, 3) {
            reading.sequence = Some(Sequence::YAW_PITCH_ROLL);
        }
        reading.words = reading.in_words(names);
        let unread = reading.free(names).map(|place| shown(names[place])).filter(|name| !name.is_empty());
        reading.unread = unread.take(MOST_SHOWN).collect();
        Ok(reading)
    }

    /// The same, where the cells below the header are units: those that no name states count.
    fn with_units(mut self, names: &[&str], below: &[&str]) -> Reading {
        let is_number = |cell: &&str| !cell.is_empty() && number(cell, self.separator).is_some();
        if below.iter().any(is_number) || !below.iter().any(|cell| names::is_unit(cell)) {
            return self;
        }
        self.units = true;
        for ((slot, name), cell) in self.slots.iter_mut().zip(names).zip(below) {
            if let Some(slot) = slot {
                slot.unit = slot.unit.or_else(|| names::unit_below(name, cell));
            }
        }
        self.words = self.in_words(names);
        self
    }

    fn in_words(&self, names: &[&str]) -> String {
        let column = |(slot, name): (&Option<Slot>, &&str)| {
            let slot = (*slot)?;
            let unit =
                slot.unit.filter(|unit| *unit != 1.0).map_or(String::new(), |unit| format!(" × {unit:?}"));
            let same = FIELDS[slot.field] == *name && unit.is_empty();
            Some(if same {
                (*name).to_owned()
            } else {
                format!("{} = {}{unit}", FIELDS[slot.field], shown(name))
            })
        };
        let columns: Vec<String> = self.slots.iter().zip(names).filter_map(column).collect();
        format!("columns between {}: {}", self.separator.word(), columns.join(", "))
    }

    /// The columns that are not read.
    fn free(&self, names: &[&str]) -> impl Iterator<Item = usize> {
        (0..names.len()).filter(|place| self.slots.get(*place).is_none_or(Option::is_none))
    }

    /// The columns that there are, and an option that reads one quantity: the first that is found in part, else those in their order.
    fn line_to_paste(&self, names: &[&str]) -> String {
        let listed: Vec<String> = names.iter().take(MOST_SHOWN).map(|name| shown(name)).collect();
        let more = if names.len() > MOST_SHOWN { ", …" } else { "" };
        let known =
            format!("the columns are {}{more}; expected are {}", listed.join(", "), COLUMNS.join(","));
        let of =
            |field: usize| self.slots.iter().position(|slot| slot.is_some_and(|slot| slot.field == field));
        let begun = Part::ALL.into_iter().find(|part| part.columns().any(|field| of(field).is_some()));
        let part = begun.unwrap_or(if names.len() > 4 { Part::Orientation } else { Part::Position });
        let mut free = self.free(names);
        let fields = std::iter::once(0).chain(part.columns());
        let pair = |field| {
            let column = of(field).or_else(|| free.next())?;
            Some(format!("{}={}", FIELDS[field], to_paste(names, column)))
        };
        match fields.map(pair).collect::<Option<Vec<String>>>() {
            Some(pairs) => format!("{known}; say which is which, as in --columns '{}'", pairs.join(",")),
            None => format!("{known}: there are too few for --columns to name a quantity"),
        }
    }
}

/// A column as `--columns` finds it: its name, or its number where the name cannot stand there.
fn to_paste(names: &[&str], column: usize) -> String {
    let name = names[column];
    let plain = !name.is_empty() && !name.contains([',', '=', '\'']) && shown(name) == name;
    if plain && place_of(name, names) == Some(column) { name.to_owned() } else { (column + 1).to_string() }
}

/// Puts in what the user says.
fn obey(asked: &Columns, names: &[&str], slots: &mut [Option<Slot>]) -> Result<(), String> {
    let list = asked.0.iter().all(|(_, column)| column.is_none());
    if list {
        slots.fill(None);
    }
    for (place, (field, column)) in asked.0.iter().enumerate() {
        let index = match column {
            None => Some(place).filter(|place| *place < names.len()),
            Some(column) => place_of(column, names),
        };
        let Some(index) = index else {
            let wanted = column.as_deref().unwrap_or(FIELDS.get(*field).copied().unwrap_or("-"));
            let listed: Vec<String> = names.iter().take(MOST_SHOWN).map(|name| shown(name)).collect();
            return Err(format!(
                "--columns: there is no column {}; there are {}",
                shown(wanted),
                listed.join(", ")
            ));
        };
        for slot in slots.iter_mut().filter(|slot| slot.is_some_and(|slot| slot.field == *field)) {
            *slot = None;
        }
        let unit = columns::meaning(names[index]).and_then(|meaning| meaning.unit);
        slots[index] = (*field != NO_FIELD).then_some(Slot { field: *field, unit });
    }
    Ok(())
}

/// A column by its name, or by its number from 1.
fn place_of(column: &str, names: &[&str]) -> Option<usize> {
    let named = names.iter().position(|name| *name == column);
    named.or_else(|| column.parse::<usize>().ok()?.checked_sub(1).filter(|place| *place < names.len()))
}

/// Of two columns for one field the one that bears its very name is meant.
fn one_of_each(names: &[&str], slots: &mut [Option<Slot>]) -> Result<(), String> {
    let mut twice = Vec::new();
    for (field, own) in FIELDS.iter().enumerate() {
        let is = |slot: &Option<Slot>| slot.is_some_and(|slot| slot.field == field);
        let places: Vec<usize> = (0..slots.len()).filter(|index| is(&slots[*index])).collect();
        if places.len() < 2 {
            continue;
        }
        let of = |is_own: &dyn Fn(&str) -> bool| -> Vec<usize> {
            places.iter().copied().filter(|place| is_own(names[*place])).collect()
        };
        let mut exact = of(&|name| name == *own);
        if exact.len() != 1 && field == 0 {
            // `Time` beside `header.stamp.secs`.
            exact = of(&|name| names::is_time(name, false));
        }
        match exact[..] {
            [one] => places.into_iter().filter(|place| *place != one).for_each(|place| slots[place] = None),
            _ => twice.push((*own, places[0], places[1])),
        }
    }
    let Some((own, first, second)) = twice.first() else { return Ok(()) };
    let pairs: Vec<String> =
        twice.iter().map(|(own, first, _)| format!("{own}={}", to_paste(names, *first))).collect();
    Err(format!(
        "the column {own} stands twice, as {} and as {}; say which is meant, as in --columns '{}'",
        shown(names[*first]),
        shown(names[*second]),
        pairs.join(",")
    ))
}

/// A cell as a number; between semicolons and tabs a comma may be the decimal point, and Fortran writes 1.0D+00.
pub(super) fn number(cell: &str, separator: Separator) -> Option<f64> {
    if let Ok(value) = cell.parse() {
        return Some(value);
    }
    match cell {
        "" | "null" | "NULL" | "None" | "NA" | "N/A" | "-nan" | "-NaN" | "nan(ind)" | "-nan(ind)" => {
            Some(f64::NAN)
        }
        _ if separator != Separator::Sign(b',') && cell.contains(',') && cell.len() < SHOWN => {
            cell.replacen(',', ".", 1).parse().ok()
        }
        _ if cell.len() < SHOWN && cell.ends_with(|letter: char| letter.is_ascii_digit()) => {
            cell.replacen(['d', 'D'], "e", 1).parse().ok()
        }
        _ => None,
    }
}

/// A name as messages show it.
pub(super) fn shown(name: &str) -> String {
    let visible = |letter: char| if letter.is_control() { char::REPLACEMENT_CHARACTER } else { letter };
    let mut letters = name.chars().map(visible);
    let head: String = letters.by_ref().take(SHOWN).collect();
    if letters.next().is_some() { head + "…" } else { head }
}
