//! What the user says about a file.

use std::str::FromStr;

use super::euler::Sequence;
use super::layout::{FIELDS, shown};
use super::units::{AngleUnit, TimeUnit};

/// What the user says about a file.
#[derive(Clone, Debug, Default)]
pub struct Said {
    /// Which column is what.
    pub columns: Option<Columns>,
    /// Unit of times.
    pub time_unit: Option<TimeUnit>,
    /// Unit of Euler angles and of angular velocities that the header leaves open.
    pub angle_unit: Option<AngleUnit>,
    /// Sequence of Euler angles.
    pub sequence: Option<Sequence>,
}

/// `--columns`: a list of fields in the order of the file, or fields with the columns that hold them.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns(pub(super) Vec<(usize, Option<String>)>);

/// A place that `--columns` leaves out.
pub(super) const NO_FIELD: usize = usize::MAX;

impl FromStr for Columns {
    type Err = String;

    fn from_str(text: &str) -> Result<Columns, String> {
        let field = |name: &str| {
            let known = FIELDS.iter().position(|field| *field == name.trim());
            known.ok_or(format!("'{}' is no column; expected {}", shown(name), FIELDS.join(",")))
        };
        let items: Vec<&str> = text.split(',').collect();
        let named = items.iter().filter(|item| item.contains('=')).count();
        if named != 0 && named != items.len() {
            return Err("expected a list as t,x,y,z or pairs as t=stamp,qw=q_w".to_owned());
        }
        let item = |item: &&str| match item.split_once('=') {
            Some((name, column)) => Ok((field(name)?, Some(column.trim().to_owned()))),
            None if matches!(item.trim(), "-" | "_") => Ok((NO_FIELD, None)),
            None => Ok((field(item)?, None)),
        };
        items.iter().map(item).collect::<Result<_, _>>().map(Columns)
    }
}
