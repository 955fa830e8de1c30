//! The rows of a comparison as text, CSV, JSON, Markdown and LaTeX.

use clap::ValueEnum;
use comfy_table::{ColumnConstraint, ContentArrangement, Table, TableComponent, presets};
use serde_json::{Value, json};

use super::row::Row;
use crate::cli::Failure;

/// Form of the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Csv,
    Json,
    Markdown,
    Latex,
}

/// Columns of a page: where there is no terminal a table is no wider.
const WIDTH: u16 = 100;

const COLUMNS: [&str; 8] =
    ["quantity", "order A", "order B", "constant A", "constant B", "B/A", "same work", "B is"];

/// The rows in a form. Text has a table a scene, the others name the scene in every row.
pub(super) fn rows_as(format: Format, rows: &[Row], names_schemes: bool) -> Result<String, Failure> {
    Ok(match format {
        Format::Text => tables(rows, names_schemes),
        Format::Csv => csv(rows)?,
        Format::Json => format!("{:#}\n", Value::Array(rows.iter().map(object).collect())),
        Format::Markdown => {
            let line = |cells: Vec<String>| {
                let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
                format!("| {} |\n", cells.join(" | "))
            };
            let rule = format!("|{}\n", "---|".repeat(header().len()));
            line(header()) + &rule + &rows.iter().map(|row| line(cells(row))).collect::<String>()
        }
        Format::Latex => {
            let line = |cells: Vec<String>| {
                let cells: Vec<String> = cells.iter().map(|cell| latex(cell)).collect();
                format!("{} \\\\\n", cells.join(" & "))
            };
            let (head, columns) = (line(header()), "l".repeat(header().len()));
            let body: String = rows.iter().map(|row| line(cells(row))).collect();
            format!(
                "\\begin{{tabular}}{{{columns}}}\n\\hline\n{head}\\hline\n{body}\\hline\n\\end{{tabular}}\n"
            )
        }
    })
}

fn header() -> Vec<String> {
    ["scene", "scheme"].into_iter().chain(COLUMNS).map(str::to_owned).collect()
}

fn cells(row: &Row) -> Vec<String> {
    [row.scene.clone(), row.scheme.clone()].into_iter().chain(row.words()).collect()
}

fn csv(rows: &[Row]) -> Result<String, Failure> {
    let fail = |error: csv::Error| Failure::Write { name: "stdout".to_owned(), source: error.into() };
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut lines = std::iter::once(header()).chain(rows.iter().map(cells));
    lines.try_for_each(|line| writer.write_record(line)).map_err(fail)?;
    Ok(String::from_utf8_lossy(&writer.into_inner().unwrap_or_default()).into_owned())
}

/// A text whose signs mean nothing to LaTeX.
fn latex(text: &str) -> String {
    let sign = |letter: char| match letter {
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{letter}"),
        '\\' => "\\textbackslash{}".to_owned(),
        '^' => "\\^{}".to_owned(),
        '~' => "\\~{}".to_owned(),
        '–' => "--".to_owned(),
        'µ' => "$\\mu$".to_owned(),
        '²' => "$^2$".to_owned(),
        'ᵖ' => "$^p$".to_owned(),
        '×' => "$\\times$".to_owned(),
        '…' => "\\dots{}".to_owned(),
        other => other.to_string(),
    };
    text.chars().map(sign).collect()
}

fn object(row: &Row) -> Value {
    let [kind_a, kind_b] = &row.kinds;
    let [size_a, size_b] = &row.sizes;
    json!({
        "scene": row.scene, "scheme": row.scheme, "quantity": row.quantity,
        "order_a": kind_a, "order_b": kind_b, "constant_a": size_a, "constant_b": size_b,
        "ratio": row.ratio.filter(|ratio| ratio.is_finite()),
        "ratio_at_equal_work": row.at_equal_work.filter(|ratio| ratio.is_finite()),
        "standing": row.standing.word(), "why": row.why,
    })
}

fn tables(rows: &[Row], names_schemes: bool) -> String {
    let same_place = |a: &Row, b: &Row| (&a.scene, &a.scheme) == (&b.scene, &b.scheme);
    let blocks = rows.chunk_by(same_place).map(|rows| {
        let scheme = if names_schemes { format!(", {}", rows[0].scheme) } else { String::new() };
        format!("{}{scheme}\n{}\n", rows[0].scene, table(rows))
    });
    blocks.collect::<Vec<_>>().join("\n")
}

fn table(rows: &[Row]) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(WIDTH);
    }
    for between_rows in [
        TableComponent::HorizontalLines,
        TableComponent::MiddleIntersections,
        TableComponent::LeftBorderIntersections,
        TableComponent::RightBorderIntersections,
    ] {
        table.remove_style(between_rows);
    }
    table.set_header(COLUMNS);
    for row in rows {
        table.add_row(row.words());
    }
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
    }
    if let Some(quantity) = table.column_mut(0) {
        quantity.set_constraint(ColumnConstraint::ContentWidth);
    }
    table
}
