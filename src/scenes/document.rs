//! The text of a scene file, and what has been found wrong with it so far.

use std::cell::RefCell;
use std::ops::Range;

use crate::fault::{Fault, Mend};

/// The text of a scene file while it is read.
pub(super) struct Document<'t> {
    /// What it says.
    pub text: &'t str,
    faults: RefCell<Vec<Fault>>,
}

impl<'t> Document<'t> {
    /// A text with which nothing is wrong so far.
    pub fn of(text: &'t str) -> Document<'t> {
        Document { text, faults: RefCell::default() }
    }

    /// A fault at some bytes of the text.
    pub fn fault(&self, span: Range<usize>, key: &str, message: impl Into<String>) -> Fault {
        Fault::at(self.text, span, key, message)
    }

    /// Notes a fault, and goes on.
    pub fn note(&self, fault: Fault) {
        self.faults.borrow_mut().push(fault);
    }

    /// What was read; a fault is noted.
    pub fn keep<T>(&self, read: Result<T, Fault>) -> Option<T> {
        read.map_err(|fault| self.note(fault)).ok()
    }

    /// Whether nothing is wrong so far.
    pub fn is_sound(&self) -> bool {
        self.faults.borrow().is_empty()
    }

    /// All faults, in the order of the file.
    pub fn into_faults(self) -> Vec<Fault> {
        let mut faults = self.faults.into_inner();
        faults.sort_by_key(|fault| (fault.span.start, fault.span.end));
        faults
    }

    /// The text from a byte on.
    fn after(&self, start: usize) -> &'t str {
        self.text.get(start..).unwrap_or_default()
    }

    /// The change that adds a line to the table that begins at a byte: under its header, in its braces, or at the top of the file. `None`
    /// where the table has neither, as that of a dotted key.
    pub fn addition(&self, start: usize, at_top: bool, is_empty: bool, line: &str) -> Option<Mend> {
        let rest = self.after(start);
        let (place, text) = match rest.bytes().next() {
            _ if at_top => (0, format!("{line}\n")),
            Some(b'[') => {
                let header = rest.find('\n').unwrap_or(rest.len());
                let header = header - usize::from(rest[..header].ends_with('\r'));
                (start + header, format!("\n{line}"))
            }
            Some(b'{') => (start + 1, format!(" {line}{}", if is_empty { " " } else { "," })),
            _ => return None,
        };
        Some(Mend { span: place..place, text })
    }

    /// A word that should stand in quotes, in quotes: the whole of a value that is no number and no list.
    pub fn quoted(&self, span: Range<usize>) -> Option<String> {
        let word = self.text.get(span.clone())?;
        let is_word = |letter: char| letter.is_alphanumeric() || "-_".contains(letter);
        let whole = self.text[..span.start].trim_end_matches(' ').ends_with('=')
            && self.after(span.end).lines().next().unwrap_or_default().trim().is_empty();
        (whole && word.starts_with(char::is_alphabetic) && word.chars().all(is_word))
            .then(|| format!("\"{word}\""))
    }

    /// The change that removes an entry that shares no line with others.
    pub fn removal(&self, key: Range<usize>, value: Range<usize>) -> Option<Mend> {
        let line = self.text.get(..key.start)?.rfind('\n').map_or(0, |end| end + 1);
        let rest = self.after(value.end);
        let end = value.end + rest.find('\n').map_or(rest.len(), |end| end + 1);
        let between = |range: Range<usize>| self.text.get(range).unwrap_or("x").trim();
        let after = between(value.end..end);
        let alone = between(line..key.start).is_empty() && (after.is_empty() || after.starts_with('#'));
        alone.then(|| Mend { span: line..end, text: String::new() })
    }
}
