//! Rows of evidence as columns: a file names a field once a list, where rows would name it once a row, and its numbers are packed. Files of former
//! versions have rows, and are read.

use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::evidence::{EnergyRung, OtherWorld, Rung};
use super::packed::{self, lists_of, text_of};
use crate::quantity::{PerQuantity, Quantity};

/// Rows that can be written as columns.
pub(super) trait Columns: Sized + Clone {
    /// What stands in the file.
    type Written: Serialize + DeserializeOwned;

    /// The columns of rows.
    fn write(rows: &[Self]) -> Self::Written;

    /// The rows of columns; `None` where these are of different lengths.
    fn read(written: Self::Written) -> Option<Vec<Self>>;
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Either<R, C> {
    Rows(Vec<R>),
    Columns(C),
}

pub(super) fn serialize<R: Columns, S: Serializer>(rows: &[R], serializer: S) -> Result<S::Ok, S::Error> {
    R::write(rows).serialize(serializer)
}

pub(super) fn deserialize<'de, R, D>(deserializer: D) -> Result<Vec<R>, D::Error>
where
    R: Columns + Deserialize<'de>,
    D: Deserializer<'de>,
{
    match Either::<R, R::Written>::deserialize(deserializer)? {
        Either::Rows(rows) => Ok(rows),
        Either::Columns(columns) => {
            R::read(columns).ok_or_else(|| D::Error::custom("columns of different lengths"))
        }
    }
}

/// A column that is left out where all of its values are nothing.
fn some<T: Default + PartialEq>(column: Vec<T>) -> Vec<T> {
    if column.iter().all(|value| *value == T::default()) { Vec::new() } else { column }
}

/// The value of a row, where the column is there.
fn at<T: Default + Clone>(column: &[T], row: usize) -> T {
    column.get(row).cloned().unwrap_or_default()
}

/// Whether a column has a value a row, or was left out.
fn fits<T>(column: &[T], rows: usize) -> bool {
    column.is_empty() || column.len() == rows
}

/// Columns of [`Rung`].
#[derive(Serialize, Deserialize)]
pub(super) struct Rungs {
    #[serde(with = "packed::list")]
    step: Vec<f64>,
    steps: Vec<u64>,
    evaluations: Vec<u64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    broken: Vec<Option<String>>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    unsolved: Vec<bool>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    solves: Vec<u64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    iterations: Vec<u64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    vertical_momentum: Vec<Option<f64>>,
    errors: Vec<String>,
    rounding: Vec<String>,
}

impl Columns for Rung {
    type Written = Rungs;

    fn write(rows: &[Rung]) -> Rungs {
        Rungs {
            step: rows.iter().map(|row| row.step).collect(),
            steps: rows.iter().map(|row| row.steps).collect(),
            evaluations: rows.iter().map(|row| row.evaluations).collect(),
            broken: some(rows.iter().map(|row| row.broken.clone()).collect()),
            unsolved: some(rows.iter().map(|row| row.unsolved).collect()),
            solves: some(rows.iter().map(|row| row.solves).collect()),
            iterations: some(rows.iter().map(|row| row.iterations).collect()),
            vertical_momentum: some(rows.iter().map(|row| row.vertical_momentum).collect()),
            errors: rows.iter().map(|row| each(&row.errors)).collect(),
            rounding: rows.iter().map(|row| each(&row.rounding)).collect(),
        }
    }

    fn read(written: Rungs) -> Option<Vec<Rung>> {
        let Rungs { step, steps, evaluations, errors, rounding, .. } = &written;
        let count = step.len();
        let whole =
            [steps.len(), evaluations.len(), errors.len(), rounding.len()].iter().all(|n| *n == count)
                && fits(&written.broken, count)
                && fits(&written.unsolved, count)
                && fits(&written.solves, count)
                && fits(&written.iterations, count)
                && fits(&written.vertical_momentum, count);
        let row = |index: usize| {
            Some(Rung {
                step: step[index],
                steps: steps[index],
                broken: at(&written.broken, index),
                unsolved: at(&written.unsolved, index),
                evaluations: evaluations[index],
                solves: at(&written.solves, index),
                iterations: at(&written.iterations, index),
                errors: per_quantity(&errors[index])?,
                rounding: per_quantity(&rounding[index])?,
                vertical_momentum: at(&written.vertical_momentum, index),
            })
        };
        whole.then(|| (0..count).map(row).collect())?
    }
}

fn each(lists: &PerQuantity<Vec<f64>>) -> String {
    text_of(&Quantity::ALL.map(|quantity| lists[quantity].as_slice()))
}

fn per_quantity(text: &str) -> Option<PerQuantity<Vec<f64>>> {
    let lists: [Vec<f64>; Quantity::ALL.len()] = lists_of(text)?.try_into().ok()?;
    Some(PerQuantity::from(lists))
}

/// Columns of [`EnergyRung`].
#[derive(Serialize, Deserialize)]
pub(super) struct EnergyRungs {
    steps: Vec<u64>,
    evaluations: Vec<u64>,
    /// Step, rate, its uncertainty, level, gain, part of the largest, rounding.
    numbers: String,
}

impl Columns for EnergyRung {
    type Written = EnergyRungs;

    fn write(rows: &[EnergyRung]) -> EnergyRungs {
        let fields: [fn(&EnergyRung) -> f64; 7] = [
            |row| row.step,
            |row| row.rate,
            |row| row.uncertainty,
            |row| row.level,
            |row| row.gain,
            |row| row.of_largest,
            |row| row.rounding,
        ];
        let lists = fields.map(|field| rows.iter().map(field).collect::<Vec<f64>>());
        EnergyRungs {
            steps: rows.iter().map(|row| row.steps).collect(),
            evaluations: rows.iter().map(|row| row.evaluations).collect(),
            numbers: text_of(&lists.each_ref().map(Vec::as_slice)),
        }
    }

    fn read(written: EnergyRungs) -> Option<Vec<EnergyRung>> {
        let lists: [Vec<f64>; 7] = lists_of(&written.numbers)?.try_into().ok()?;
        let count = written.steps.len();
        let whole = written.evaluations.len() == count && lists.iter().all(|list| list.len() == count);
        let [step, rate, uncertainty, level, gain, of_largest, rounding] = &lists;
        let row = |index: usize| EnergyRung {
            step: step[index],
            steps: written.steps[index],
            rate: rate[index],
            uncertainty: uncertainty[index],
            level: level[index],
            gain: gain[index],
            of_largest: of_largest[index],
            rounding: rounding[index],
            evaluations: written.evaluations[index],
        };
        whole.then(|| (0..count).map(row).collect())
    }
}

/// Columns of [`OtherWorld`].
#[derive(Serialize, Deserialize)]
pub(super) struct OtherWorlds {
    name: Vec<String>,
    /// A letter a row: `b` where the arithmetic allows no difference, `d` in double-double, `e` where both hold.
    kind: String,
    /// One number where it is that of all rows.
    steps: Vec<u64>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    solves: Vec<u64>,
    /// A digit a row: place in [`Quantity::ALL`] of the worst difference.
    quantity: String,
    /// Difference over rounding, and the worst difference; none is NaN.
    numbers: String,
}

/// Letters of [`OtherWorlds::kind`]: every second one to the bit, every second pair in double-double, the second half not solved.
const KINDS: [char; 8] = ['-', 'b', 'd', 'e', 'u', 'v', 'w', 'x'];

impl OtherWorld {
    fn kind(&self) -> char {
        KINDS[usize::from(self.to_the_bit)
            + 2 * usize::from(self.double_double)
            + 4 * usize::from(self.unsolved)]
    }

    fn quantity(&self) -> char {
        let place = |(quantity, _)| Quantity::ALL.iter().position(|one| *one == quantity);
        let digit = self.worst.and_then(place).and_then(|place| char::from_digit(place as u32, 10));
        digit.unwrap_or('-')
    }
}

impl Columns for OtherWorld {
    type Written = OtherWorlds;

    fn write(rows: &[OtherWorld]) -> OtherWorlds {
        let of_rounding: Vec<f64> = rows.iter().map(|row| row.of_rounding.unwrap_or(f64::NAN)).collect();
        let worst: Vec<f64> = rows.iter().map(|row| row.worst.map_or(f64::NAN, |(_, size)| size)).collect();
        let mut steps: Vec<u64> = rows.iter().map(|row| row.steps).collect();
        if steps.iter().all(|count| *count == steps[0]) {
            steps.truncate(1);
        }
        OtherWorlds {
            name: rows.iter().map(|row| row.name.clone()).collect(),
            kind: rows.iter().map(OtherWorld::kind).collect(),
            steps,
            solves: some(rows.iter().map(|row| row.solves).collect()),
            quantity: rows.iter().map(OtherWorld::quantity).collect(),
            numbers: text_of(&[&of_rounding, &worst]),
        }
    }

    fn read(written: OtherWorlds) -> Option<Vec<OtherWorld>> {
        let [of_rounding, worst]: [Vec<f64>; 2] = lists_of(&written.numbers)?.try_into().ok()?;
        let count = written.name.len();
        let steps = match written.steps.as_slice() {
            [all] => vec![*all; count],
            each => each.to_vec(),
        };
        let kind = |letter| KINDS.iter().position(|one| *one == letter);
        let kinds: Vec<usize> = written.kind.chars().map(kind).collect::<Option<_>>()?;
        let quantity = |letter: char| Some(*Quantity::ALL.get(letter.to_digit(10)? as usize)?);
        let quantities: Vec<Option<Quantity>> = written.quantity.chars().map(quantity).collect();
        let lengths = [steps.len(), kinds.len(), quantities.len(), of_rounding.len(), worst.len()];
        let whole = lengths.iter().all(|n| *n == count) && fits(&written.solves, count);
        let row = |index: usize| OtherWorld {
            name: written.name[index].clone(),
            to_the_bit: kinds[index] % 2 == 1,
            of_rounding: Some(of_rounding[index]).filter(|number| !number.is_nan()),
            worst: quantities[index].map(|quantity| (quantity, worst[index])),
            steps: steps[index],
            solves: at(&written.solves, index),
            double_double: kinds[index] / 2 % 2 == 1,
            unsolved: kinds[index] >= 4,
        };
        whole.then(|| (0..count).map(row).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct File {
        #[serde(with = "super")]
        rungs: Vec<Rung>,
        #[serde(with = "super")]
        drift: Vec<EnergyRung>,
        #[serde(with = "super")]
        worlds: Vec<OtherWorld>,
    }

    fn file() -> File {
        let errors = PerQuantity::from([vec![0.0, 0.125], vec![], vec![-3.25e-9], vec![], vec![], vec![]]);
        let rung = Rung { step: 0.1, steps: 4, evaluations: 8, errors, ..Rung::default() };
        let broken = Rung { broken: Some("step 3".into()), solves: 2, ..rung.clone() };
        let energy = EnergyRung { step: 0.3, steps: 7, rate: -0.0, level: 1e-300, ..EnergyRung::default() };
        let world = OtherWorld {
            name: "turned".into(),
            of_rounding: Some(std::f64::consts::PI),
            worst: Some((Quantity::Orientation, 1.0 / 3.0)),
            steps: 16,
            double_double: true,
            unsolved: true,
            ..OtherWorld::default()
        };
        let gone = OtherWorld { name: "shifted".into(), ..OtherWorld::default() };
        File { rungs: vec![rung, broken], drift: vec![energy; 2], worlds: vec![world, gone] }
    }

    #[test]
    fn columns_come_back_as_the_rows_to_the_last_bit() {
        let text = serde_json::to_string(&file()).expect("JSON");
        let back: File = serde_json::from_str(&text).expect("columns");
        assert_eq!(back, file());
        assert_eq!(back.drift[0].rate.to_bits(), (-0.0f64).to_bits());
    }

    #[test]
    fn rows_of_former_files_are_read_and_columns_of_different_lengths_are_not() {
        let file = file();
        let rows = serde_json::json!({ "rungs": file.rungs, "drift": file.drift, "worlds": file.worlds });
        assert_eq!(serde_json::from_value::<File>(rows).expect("rows"), file);
        let mut columns = serde_json::to_value(&file).expect("JSON");
        columns["worlds"]["kind"] = serde_json::json!("d");
        assert!(serde_json::from_value::<File>(columns).is_err());
    }
}
