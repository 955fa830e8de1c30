//! A value of a scene file together with the place it stands at, so that what is wrong with it can be said.

use nalgebra::{Matrix3, Vector3, Vector4};
use toml::Spanned;
use toml::de::{DeInteger, DeValue};

use super::document::Document;
use super::table::Table;
use super::wording;
use crate::fault::Fault;
use crate::model::forces::{PerPoint, TorqueAxes};
use crate::rotation;

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
    pub fn refuse(&self, message: impl Into<String>) -> Fault {
        self.document.fault(self.value.span(), &self.path, message)
    }

    /// Says what should stand here.
    pub fn expected(&self, what: &str) -> Fault {
        let fault = self.refuse(format!("expected {what}, found {}", described(self.value.get_ref())));
        match wording::value(&self.path) {
            Some(value) => fault.advised(format!("write {}", wording::example(&self.path))).replaced(value),
            None => fault.advised(format!("write {}", wording::example(&self.path))),
        }
    }

    /// A finite number; an integer counts as one.
    pub fn number(&self) -> Result<f64, Fault> {
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
    pub fn positive(&self) -> Result<f64, Fault> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.expected("a number above zero")) }
    }

    /// An index, counted from 0.
    pub fn index(&self) -> Result<usize, Fault> {
        let index = match self.value.get_ref() {
            DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        };
        index.ok_or_else(|| self.expected("the number of a mass point, counted from 0"))
    }

    /// A text.
    pub fn text(&self) -> Result<&'t str, Fault> {
        match self.value.get_ref() {
            DeValue::String(text) => Ok(text.as_ref()),
            _ => Err(self.expected("a text in quotes")),
        }
    }

    /// True or false.
    pub fn flag(&self) -> Result<bool, Fault> {
        match self.value.get_ref() {
            DeValue::Boolean(flag) => Ok(*flag),
            _ => Err(self.expected("true or false")),
        }
    }

    /// World or body axes.
    pub fn axes(&self) -> Result<TorqueAxes, Fault> {
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

    /// The first item of a list of numbers, as TOML writes it.
    pub fn first_item(&self) -> Option<String> {
        let number = self.list("").ok()?.first()?.number().ok()?;
        Some(format!("{number:?}"))
    }

    /// The items of a list; `what` says of what.
    pub fn list(&self, what: &str) -> Result<Vec<Value<'t>>, Fault> {
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
    pub fn numbers<const N: usize>(&self, what: &str) -> Result<[f64; N], Fault> {
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
    pub fn vector(&self) -> Result<Vector3<f64>, Fault> {
        self.numbers::<3>("a list of three numbers").map(Vector3::from)
    }

    /// Three numbers on a diagonal, or three rows; `what` says what they are.
    pub fn matrix(&self, what: &str) -> Result<Matrix3<f64>, Fault> {
        let items = self.list(what)?;
        if !items.iter().any(Value::is_list) {
            return self.numbers::<3>(what).map(|moments| Matrix3::from_diagonal(&Vector3::from(moments)));
        }
        if items.len() != 3 {
            return Err(self.expected(what));
        }
        let mut matrix = Matrix3::zeros();
        for (row, item) in items.iter().enumerate() {
            let instead = ["[1.0, 0.0, 0.0]", "[0.0, 2.0, 0.0]", "[0.0, 0.0, 2.5]"][row];
            if !item.is_list() {
                return Err(item.expected("a row of three numbers").replaced(instead));
            }
            matrix.set_row(row, &item.numbers::<3>("a row of three numbers")?.into());
        }
        Ok(matrix)
    }

    /// Four numbers.
    pub fn quaternion(&self) -> Result<Vector4<f64>, Fault> {
        self.numbers::<4>("a unit quaternion of four numbers w, x, y, z").map(Vector4::from)
    }

    /// Three numbers that say a direction, brought to length one.
    pub fn direction(&self) -> Result<Vector3<f64>, Fault> {
        let given = self.vector()?;
        let scale = given.amax();
        if scale == 0.0 {
            let fault = self.refuse("a zero vector has no direction");
            let advice = format!("write {}", wording::example(&self.path));
            return Err(fault.advised(advice).replaced(wording::value(&self.path).unwrap_or_default()));
        }
        let scaled = given / scale;
        // A scale below the normal range loses digits, and its inverse may overflow.
        if !scaled.iter().all(|x| x.is_finite()) {
            return Err(self.expected("a direction of ordinary size"));
        }
        Ok(scaled / rotation::length(&scaled))
    }

    /// One number for all mass points, or a list of one each.
    pub fn per_point(&self) -> Result<PerPoint, Fault> {
        if !self.is_list() {
            return self.number().map(PerPoint::Same);
        }
        let items = self.list("a number, or a list of one for each point")?;
        items.iter().map(Value::number).collect::<Result<_, _>>().map(PerPoint::Each)
    }

    /// A table that may have these keys and no others.
    pub fn table(&self, keys: &[&str]) -> Result<Table<'t>, Fault> {
        match self.value.get_ref() {
            DeValue::Table(entries) => {
                Ok(Table::open(self.document, self.path.clone(), self.value.span(), entries, keys))
            }
            _ => Err(self.expected("a table")),
        }
    }

    /// Says that the table that should stand here lacks a key.
    pub fn lacks(&self, key: &str) -> Fault {
        match self.value.get_ref() {
            DeValue::Table(entries) => {
                let keys: Vec<&str> = entries.iter().map(|(key, _)| key.get_ref().as_ref()).collect();
                let table = Table::open(self.document, self.path.clone(), self.value.span(), entries, &keys);
                table.missing(key, &wording::line(&format!("{}.{key}", self.path)))
            }
            _ => self.expected("a table"),
        }
    }

    /// The document that it is in.
    pub fn document(&self) -> &'t Document<'t> {
        self.document
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
        DeValue::String(text) => format!("the text \"{}\"", wording::shortened(text)),
        DeValue::Integer(integer) => wording::shortened(&integer.to_string()),
        DeValue::Float(float) => wording::shortened(float.as_str()),
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
