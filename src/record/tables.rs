//! Records on disk: JSON with a row a line, so that two files can be compared line by line, and tidy CSV. Both are written as they
//! are read out of memory, never held as text.

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use super::{RecordError, Records, WholeFile};

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

/// Writes the measurements as tidy CSV: a header, then one row each.
///
/// # Errors
/// The file cannot be written.
pub fn write_csv(path: &Path, records: &Records) -> Result<(), RecordError> {
    let fail = |error: csv::Error| RecordError::File { path: path.into(), source: error.into() };
    let mut file = WholeFile::begin(path)?;
    let mut writer = csv::Writer::from_writer(&mut file);
    records.measurements.iter().try_for_each(|row| writer.serialize(row)).map_err(fail)?;
    writer.flush().map_err(|source| RecordError::File { path: path.into(), source })?;
    drop(writer);
    file.finish()
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
    use std::sync::Arc;

    use super::*;
    use crate::record::{Measurement, Series};

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
    fn csv_has_a_header_and_a_row_a_measurement() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("records.csv");
        let row =
            Arc::new(Measurement { value: Some(0.25), why: Some("a, b".into()), ..Measurement::default() });
        let records = Records { measurements: vec![row.clone(), row], ..Records::default() };
        write_csv(&path, &records).expect("written");
        let text = std::fs::read_to_string(&path).expect("text");
        assert_eq!(text.lines().count(), 3);
        assert!(text.starts_with("scene,scheme,model,step_s,"), "{text}");
        assert!(text.contains("0.25") && text.contains("\"a, b\""), "{text}");
    }
}
