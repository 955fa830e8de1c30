//! Records on disk: JSON with a row a line, so that two files can be compared line by line, and tidy CSV. Both are written as they
//! are read out of memory, never held as text.

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use super::{Order, OrderStatus, RecordError, Records, WholeFile};

/// Writes a struct of lists as JSON, a row a line.
///
/// # Errors
/// The file cannot be written.
pub fn write_json(path: &Path, records: &impl Serialize) -> Result<(), RecordError> {
    let fail = |source| RecordError::File { path: path.into(), source };
    let mut file = WholeFile::begin(path)?;
    row_a_line(&mut file, records).map_err(fail)?;
    file.finish()
}

/// The tables that stand beside `records.json`: name, and what writes each.
type Table = (&'static str, fn(&mut csv::Writer<&mut WholeFile>, &Records) -> csv::Result<()>);

/// Tidy tables, a row a finding: every number as in `records.json`, units in the column `unit` or in the head.
const TABLES: [Table; 4] = [
    ("records.csv", |writer, records| each(writer, records.measurements.iter())),
    ("orders.csv", |writer, records| each(writer, records.orders.iter().map(OrderLine::new))),
    ("constants.csv", |writer, records| each(writer, records.orders.iter().filter_map(ConstantLine::new))),
    ("drifts.csv", |writer, records| each(writer, records.drifts.iter())),
];

/// Names of the files that [`write_csv`] writes.
pub const CSV_FILES: [&str; TABLES.len()] = ["records.csv", "orders.csv", "constants.csv", "drifts.csv"];

/// Writes measurements, orders, error constants and drifts as tidy CSV into a folder: a header, then one row each.
///
/// # Errors
/// A file cannot be written.
pub fn write_csv(folder: &Path, records: &Records) -> Result<(), RecordError> {
    write_tables(folder, records, &TABLES)
}

/// Names of the files that [`write_brief_csv`] writes.
pub const BRIEF_CSV_FILES: [&str; TABLES.len() - 1] = ["orders.csv", "constants.csv", "drifts.csv"];

/// The same without the measurements, which are most of it.
///
/// # Errors
/// A file cannot be written.
pub fn write_brief_csv(folder: &Path, records: &Records) -> Result<(), RecordError> {
    write_tables(folder, records, &TABLES[1..])
}

fn write_tables(folder: &Path, records: &Records, tables: &[Table]) -> Result<(), RecordError> {
    for (name, write) in tables {
        let path = folder.join(name);
        let fail = |error: csv::Error| RecordError::File { path: path.clone(), source: error.into() };
        let mut file = WholeFile::begin(&path)?;
        let mut writer = csv::Writer::from_writer(&mut file);
        write(&mut writer, records).map_err(fail)?;
        writer.flush().map_err(|source| RecordError::File { path: path.clone(), source })?;
        drop(writer);
        file.finish()?;
    }
    Ok(())
}

fn each(
    writer: &mut csv::Writer<&mut WholeFile>,
    mut rows: impl Iterator<Item = impl Serialize>,
) -> csv::Result<()> {
    rows.try_for_each(|row| writer.serialize(row))
}

/// An order as a line.
#[derive(Serialize)]
struct OrderLine<'a> {
    scene: &'a str,
    scheme: &'a str,
    quantity: &'a str,
    status: OrderStatus,
    order: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
    r: Option<f64>,
    until_s: Option<f64>,
    rungs_used: usize,
    rungs_dropped: usize,
    finest_step_used_s: Option<f64>,
    floor: Option<f64>,
    unit: &'a str,
    why: Option<&'a str>,
}

impl OrderLine<'_> {
    fn new(order: &Order) -> OrderLine<'_> {
        OrderLine {
            scene: &order.scene,
            scheme: &order.scheme,
            quantity: &order.quantity,
            status: order.status,
            order: order.order,
            low: order.low,
            high: order.high,
            r: order.r,
            until_s: order.until_s,
            rungs_used: order.rungs_used,
            rungs_dropped: order.rungs_dropped,
            finest_step_used_s: order.steps_used_s.iter().copied().reduce(f64::min),
            floor: order.floor,
            unit: &order.unit,
            why: order.why.as_deref(),
        }
    }
}

/// An error constant C of e = C hᵖ as a line.
#[derive(Serialize)]
struct ConstantLine<'a> {
    scene: &'a str,
    scheme: &'a str,
    quantity: &'a str,
    power_of_h: u32,
    constant: f64,
    relative_uncertainty: Option<f64>,
    unit: String,
}

impl ConstantLine<'_> {
    fn new(order: &Order) -> Option<ConstantLine<'_>> {
        let (constant, power) = (order.constant?, order.order?.round() as u32);
        Some(ConstantLine {
            scene: &order.scene,
            scheme: &order.scheme,
            quantity: &order.quantity,
            power_of_h: power,
            constant,
            relative_uncertainty: order.constant_uncertainty(),
            unit: format!("({})/s^{power}", if order.unit.is_empty() { "1" } else { &order.unit }),
        })
    }
}

fn row_a_line(mut writer: impl Write, records: &impl Serialize) -> io::Result<()> {
    records.serialize(&mut Serializer::with_formatter(&mut writer, RowALine::default()))?;
    writer.write_all(b"\n")
}

/// The outermost object has a line a key, the lists in it a line a row, and a row no white space.
#[derive(Default)]
struct RowALine {
    depth: usize,
    filled: bool,
}

/// Depth of the keys of the outermost object.
const KEYS: usize = 1;

/// Depth of the rows of its lists.
const ROWS: usize = 2;

impl RowALine {
    fn open<W: Write + ?Sized>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth += 1;
        self.filled = false;
        writer.write_all(bracket)
    }

    fn close<W: Write + ?Sized>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.depth -= 1;
        writer.write_all(bracket)
    }
}

impl Formatter for RowALine {
    fn begin_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"[")
    }

    fn begin_array_value<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.filled = true;
        writer.write_all(if first { b"" } else { b"," })?;
        if self.depth == ROWS { writer.write_all(b"\n") } else { Ok(()) }
    }

    fn end_array<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        let rows = self.depth == ROWS && self.filled;
        self.close(writer, if rows { b"\n]" } else { b"]" })
    }

    fn begin_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"{")
    }

    fn begin_object_key<W: Write + ?Sized>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        writer.write_all(if first { b"" } else { b"," })?;
        if self.depth == KEYS { writer.write_all(b"\n") } else { Ok(()) }
    }

    fn begin_object_value<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(if self.depth == KEYS { b": " } else { b":" })
    }

    fn end_object<W: Write + ?Sized>(&mut self, writer: &mut W) -> io::Result<()> {
        let outermost = self.depth == KEYS;
        self.filled = true;
        self.close(writer, if outermost { b"\n}" } else { b"}" })
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;
    use std::sync::Arc;

    use super::*;
    use crate::record::{Drift, Measurement, Series};

    fn text(records: &impl Serialize) -> String {
        let mut bytes = Vec::new();
        row_a_line(&mut bytes, records).expect("a vector takes every byte");
        String::from_utf8(bytes).expect("JSON is UTF-8")
    }

    #[test]
    fn json_has_a_line_a_key_and_a_line_a_row_and_is_read_back_to_the_letter() {
        let series = Arc::new(Series { time_s: vec![0.0, 0.5], value: vec![], ..Series::default() });
        let records = Records { series: vec![series.clone(), series], ..Records::default() };
        let text = text(&records);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.first(), Some(&"{"));
        assert_eq!(lines.last(), Some(&"}"));
        assert!(lines.contains(&"\"measurements\": [],"), "{text}");
        assert!(lines.contains(&"\"series\": ["), "{text}");
        let rows: Vec<&&str> = lines.iter().filter(|line| line.starts_with("{\"")).collect();
        assert_eq!(rows.len(), 2);
        assert!(
            rows[0].ends_with("\"time_s\":{\"to\":0.5,\"intervals\":1},\"value\":\"2\"},"),
            "{}",
            rows[0]
        );
        assert_eq!(serde_json::from_str::<Records>(&text).expect("records"), records);
        assert_eq!(
            serde_json::to_value(&records).expect("a value"),
            serde_json::from_str::<serde_json::Value>(&text).expect("a value")
        );
    }

    #[test]
    fn a_csv_has_a_header_and_a_row_a_finding() {
        let folder = tempfile::tempdir().expect("a folder");
        let row =
            Arc::new(Measurement { value: Some(0.25), why: Some("a, b".into()), ..Measurement::default() });
        let decided = Order {
            order: Some(1.98),
            constant: Some(3.5),
            r: Some(0.01),
            steps_used_s: vec![0.5, 0.25],
            unit: "rad".into(),
            ..Order::default()
        };
        let records = Records {
            measurements: vec![row.clone(), row],
            orders: vec![decided, Order::default()],
            drifts: vec![Drift::default()],
            ..Records::default()
        };
        write_csv(folder.path(), &records).expect("written");
        let rows = |name: &str| {
            let mut reader = csv::Reader::from_path(folder.path().join(name)).expect("a table");
            let head: Vec<String> = reader.headers().expect("a header").iter().map(str::to_owned).collect();
            let named = |row: csv::Result<csv::StringRecord>| {
                let row = row.expect("as many columns as heads");
                head.iter().cloned().zip(row.iter().map(str::to_owned)).collect::<HashMap<_, _>>()
            };
            reader.records().map(named).collect::<Vec<_>>()
        };
        assert_eq!(CSV_FILES.map(|name| rows(name).len()), [2, 2, 1, 1]);
        assert_eq!((&*rows("records.csv")[0]["value"], &*rows("records.csv")[1]["why"]), ("0.25", "a, b"));
        assert_eq!(rows("orders.csv")[0]["finest_step_used_s"], "0.25");
        let constant = &rows("constants.csv")[0];
        assert_eq!(
            (&*constant["power_of_h"], &*constant["constant"], &*constant["unit"]),
            ("2", "3.5", "(rad)/s^2")
        );
    }
}
