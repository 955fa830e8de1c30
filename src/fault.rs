//! What is wrong with a file of the user, one thing at a time: where, what, and a text that mends it.

use std::fmt;
use std::ops::Range;

/// One thing that is wrong with a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Line, from 1.
    pub line: usize,
    /// Full key, as in `forces[1].stiffness`; empty where the text has none there.
    pub key: String,
    /// What is wrong.
    pub message: String,
    /// What to do about it; empty where the message says all.
    pub advice: String,
    /// The bytes of the text that it is about.
    pub span: Range<usize>,
    /// A change of the text that mends it, where one is known.
    pub mend: Option<Box<Mend>>,
}

/// A text in the place of another.
#[derive(Clone, Debug, PartialEq)]
pub struct Mend {
    /// The bytes that go.
    pub span: Range<usize>,
    /// What comes in their place.
    pub text: String,
}

impl Fault {
    /// At some bytes of a text, without advice.
    pub(crate) fn at(text: &str, span: Range<usize>, key: &str, message: impl Into<String>) -> Fault {
        let before = &text.as_bytes()[..span.start.min(text.len())];
        Fault {
            line: 1 + before.iter().filter(|byte| **byte == b'\n').count(),
            key: key.to_owned(),
            message: message.into(),
            advice: String::new(),
            span,
            mend: None,
        }
    }

    /// The same with what to do about it.
    pub(crate) fn advised(mut self, advice: impl Into<String>) -> Fault {
        self.advice = advice.into();
        self
    }

    /// The same with a text that mends it.
    pub(crate) fn mended(mut self, mend: Option<Mend>) -> Fault {
        self.mend = mend.map(Box::new);
        self
    }

    /// The same with a text in the place of what is marked.
    pub(crate) fn replaced(self, text: impl Into<String>) -> Fault {
        let mend = Mend { span: self.span.clone(), text: text.into() };
        self.mended(Some(mend))
    }
}

/// A fault a line.
pub(crate) fn lines(file: &str, faults: &[Fault]) -> String {
    faults.iter().map(|fault| format!("{file}:{}: {fault}", fault.line)).collect::<Vec<_>>().join("\n")
}

/// `key: message: advice`.
impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let parts = [&self.key, &self.message, &self.advice].map(String::as_str);
        let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        f.write_str(&parts.join(": "))
    }
}

impl Mend {
    /// The text after the change.
    pub fn apply(&self, text: &str) -> String {
        format!("{}{}{}", &text[..self.span.start], self.text, &text[self.span.end..])
    }
}
