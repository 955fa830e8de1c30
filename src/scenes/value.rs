//! A value of a scene file together with the place it stands at, so that what is wrong with it can be said.

use nalgebra::{Matrix3, Vector3, Vector4};
use toml::Spanned;
use toml::de::{DeInteger, DeValue};

use super::SceneError;
use super::table::Table;
use super::wording;
use crate::model::forces::{PerPoint, TorqueAxes};
use crate::rotation;

/// A scene file and its name.
pub(super) struct Document<'t> {
    /// Name as the user gave it.
    pub file: &'t str,
    /// What it says.
    pub text: &'t str,
}

impl Document<'_> {
    /// An error at a byte of the text.
    pub fn refuse(&self, offset: usize, key: &str, message: impl Into<String>) -> SceneError {
        let before = &self.text.as_bytes()[..offset.min(self.text.len())];
        SceneError::Content {
            file: self.file.to_string(),
            line: 1 + before.iter().filter(|byte| **byte == b'\n').count(),
            key: key.to_string(),
            message: message.into(),
        }
    }
}

/// A value, its full key and where it stands.
#[derive(Clone)]
pub(super) struct Value<'t> {
    document: &'t Document<'t>,
    path: String,
    value: &'t Spanned<DeValue<'t>>,
}

impl<'t> Value<'t> {
    /// The value under a full key.
    pub fn new(document: &'t Document<'t>, path: String, value: &'t Spanned<DeValue<'t>>) -> Value<'t> {
        Value { document, path, value }
    }

    /// Says what is wrong here.
    pub fn refuse(&self, message: impl Into<String>) -> SceneError {
        self.document.refuse(self.value.span().start, &self.path, message)
    }

    /// Says what should stand here.
    pub fn expected(&self, what: &str) -> SceneError {
        let found = described(self.value.get_ref());
        self.refuse(format!("expected {what}, found {found}: write {}", wording::example(&self.path)))
    }

    /// A finite number; an integer counts as one.
    pub fn number(&self) -> Result<f64, SceneError> {
        let number = match self.value.get_ref() {
            DeValue::Integer(integer) => integer_as_number(integer),
            DeValue::Float(float) => float.as_str().parse::<f64>().ok(),
            _ => None,
        };
        match number {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(self.expected("a finite number")),
            None => Err(self.expected("a number")),
        }
    }

    /// A finite number above zero.
    pub fn positive(&self) -> Result<f64, SceneError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.expected("a number above zero")) }
    }

    /// An index, counted from 0.
    pub fn index(&self) -> Result<usize, SceneError> {
        let index = match self.value.get_ref() {
            DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        };
        index.ok_or_else(|| self.expected("the number of a mass point, counted from 0"))
    }

    /// A text.
    pub fn text(&self) -> Result<&'t str, SceneError> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(text.as_ref()),
            _ => Err(self.expected("a text in quotes")),
        }
    }

    /// True or false.
    pub fn flag(&self) -> Result<bool, SceneError> {
        match self.value.get_ref() {
            DeValue::Boolean(flag) => Ok(*flag),
            _ => Err(self.expected("true or false")),
        }
    }

    /// World or body axes.
    pub fn axes(&self) -> Result<TorqueAxes, SceneError> {
        let word = self.text()?;
        let named = TorqueAxes::ALL.into_iter().find(|axes| axes.word() == word);
        named.ok_or_else(|| self.expected("\"world\" or \"body\""))
    }

    /// Whether a table stands here.
    pub fn is_table(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Table(_))
    }

    /// Whether a list stands here.
    pub fn is_list(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Array(_))
    }

    /// The items of a list; `what` says of what.
    pub fn list(&self, what: &str) -> Result<Vec<Value<'t>>, SceneError> {
        match self.value.get_ref() {
            DeValue::Array(items) => Ok(items
                .iter()
                .enumerate()
                .map(|(i, item)| Value::new(self.document, format!("{}[{i}]", self.path), item))
                .collect()),
            _ => Err(self.expected(what)),
        }
    }

    /// A list of N finite numbers.
    pub fn numbers<const N: usize>(&self, what: &str) -> Result<[f64; N], SceneError> {
        let items = self.list(what)?;
        if items.len() != N {
            return Err(self.expected(what));
        }
        let mut numbers = [0.0; N];
        for (number, item) in numbers.iter_mut().zip(&items) {
            *number = item.number()?;
        }
        Ok(numbers)
    }

    /// Three numbers.
    pub fn vector(&self) -> Result<Vector3<f64>, SceneError> {
        self.numbers::<3>("a list of three numbers").map(Vector3::from)
    }

    /// Three numbers on a diagonal, or three rows; `what` says what they are.
    pub fn matrix(&self, what: &str) -> Result<Matrix3<f64>, SceneError> {
        let items = self.list(what)?;
        if !items.iter().any(Value::is_list) {
            return self.numbers::<3>(what).map(|moments| Matrix3::from_diagonal(&Vector3::from(moments)));
        }
        if items.len() != 3 {
            return Err(self.expected(what));
        }
        let mut matrix = Matrix3::zeros();
        for (row, item) in items.iter().enumerate() {
            matrix.set_row(row, &item.vector()?.transpose());
        }
        Ok(matrix)
    }

    /// Four numbers.
    pub fn quaternion(&self) -> Result<Vector4<f64>, SceneError> {
        self.numbers::<4>("a unit quaternion of four numbers w, x, y, z").map(Vector4::from)
    }

    /// Three numbers that say a direction, brought to length one.
    pub fn direction(&self) -> Result<Vector3<f64>, SceneError> {
        let given = self.vector()?;
        let scale = given.amax();
        if scale == 0.0 {
            return Err(self
                .refuse(format!("a zero vector has no direction: write {}", wording::example(&self.path))));
        }
        let scaled = given / scale;
        // A scale below the normal range loses digits, and its inverse may overflow.
        if !scaled.iter().all(|x| x.is_finite()) {
            return Err(self.expected("a direction of ordinary size"));
        }
        Ok(scaled / rotation::length(&scaled))
    }

    /// One number for all mass points, or a list of one each.
    pub fn per_point(&self) -> Result<PerPoint, SceneError> {
        if !self.is_list() {
            return self.number().map(PerPoint::Same);
        }
        let items = self.list("a number, or a list of one for each point")?;
        items.iter().map(Value::number).collect::<Result<_, _>>().map(PerPoint::Each)
    }

    /// A table that may have these keys and no others.
    pub fn table(&self, keys: &[&str]) -> Result<Table<'t>, SceneError> {
        match self.value.get_ref() {
            DeValue::Table(entries) => {
                Table::open(self.document, self.path.clone(), self.value.span().start, entries, keys)
            }
            _ => Err(self.expected("a table")),
        }
    }

    /// Says that the table that should stand here lacks a key.
    pub fn lacks(&self, key: &str) -> SceneError {
        match self.value.get_ref() {
            DeValue::Table(_) => {
                let message = format!("is missing: write {}", wording::example(key));
                self.document.refuse(self.value.span().start, &format!("{}.{key}", self.path), message)
            }
            _ => self.expected("a table"),
        }
    }

    /// A value of the table that stands here, whatever other keys it has.
    pub fn member(&self, key: &str) -> Option<Value<'t>> {
        match self.value.get_ref() {
            DeValue::Table(entries) => {
                entries.get(key).map(|value| Value::new(self.document, format!("{}.{key}", self.path), value))
            }
            _ => None,
        }
    }
}

fn integer_as_number(integer: &DeInteger) -> Option<f64> {
    match integer.radix() {
        10 => integer.as_str().parse::<f64>().ok(),
        radix => u128::from_str_radix(integer.as_str(), radix).ok().map(|value| value as f64),
    }
}

fn described(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => format!("the text \"{}\"", shortened(text)),
        DeValue::Integer(integer) => shortened(&integer.to_string()),
        DeValue::Float(float) => shortened(float.as_str()),
        DeValue::Boolean(flag) => flag.to_string(),
        DeValue::Datetime(_) => "a date".to_string(),
        DeValue::Array(items) => match items.len() {
            0 => "an empty list".to_string(),
            1 => "a list of 1".to_string(),
            length => format!("a list of {length}"),
        },
        DeValue::Table(_) => "a table".to_string(),
    }
}

/// A text short enough for a message, on one line.
fn shortened(text: &str) -> String {
    let mut shown: String = text.chars().take(40).flat_map(char::escape_debug).collect();
    if text.chars().nth(40).is_some() {
        shown.push('…');
    }
    shown
}
