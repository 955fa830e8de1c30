//! The tables of a paper: schemes, orders, error constants, drifts and rankings, in Markdown or LaTeX.

use crate::record::{Drift, DriftClass, Order, OrderStatus, Records};

use super::survey::{self, Outcome};
use super::{number, ranking};

/// The language that tables are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Tables of GitHub's Markdown.
    Markdown,
    /// Tables of LaTeX with the package booktabs.
    Latex,
}

/// A table.
pub(super) struct Table {
    /// Key in labels.
    pub name: &'static str,
    /// One sentence.
    pub caption: String,
    /// Heads of the columns; the first is left-aligned.
    pub head: Vec<String>,
    /// Rows of as many cells.
    pub rows: Vec<Vec<String>>,
}

/// The tables of a paper as one text.
pub fn paper_tables(records: &Records, language: Language) -> String {
    let main = records.without_apart();
    let tables = [schemes(&main), orders(&main), constants(&main), drifts(&main)].into_iter().flatten();
    let tables: Vec<Table> = tables.chain(rankings(records)).collect();
    let written: Vec<String> = tables.iter().map(|table| table.written(language)).collect();
    written.join("\n")
}

/// A scheme a row: claim, cost, measured orders, verdicts.
pub(super) fn schemes(records: &Records) -> Option<Table> {
    let row = |scheme: &str| {
        let card = records.schemes.iter().find(|row| row.name == scheme)?;
        let decided = || records.orders.iter().filter(|row| row.scheme == scheme && stands(records, row));
        let orders: Vec<f64> = decided().filter_map(|row| row.order).collect();
        let low = orders.iter().copied().reduce(f64::min);
        let high = orders.iter().copied().reduce(f64::max);
        let range = low.zip(high).map_or(number::NONE.into(), |(low, high)| format!("{low:.2} to {high:.2}"));
        let verdicts = records.verdicts.iter().filter(|row| row.scheme == scheme);
        let tally = survey::tally(verdicts);
        let count = |outcome| tally.iter().find(|(one, _)| *one == outcome).map_or(0, |(_, count)| *count);
        let bad = count(Outcome::Fail) + count(Outcome::Broken);
        let counts =
            [count(Outcome::Pass), count(Outcome::KnownDeviation), count(Outcome::Inconclusive), bad];
        let claim = survey::claimed_order(records, scheme).map_or(number::NONE.into(), |p| p.to_string());
        let evaluations = if card.evaluations > 0 { card.evaluations.to_string() } else { "implicit".into() };
        let first = vec![scheme.to_owned(), claim, evaluations, range, orders.len().to_string()];
        Some(first.into_iter().chain(counts.map(|count| count.to_string())).collect())
    };
    let rows: Vec<Vec<String>> = survey::schemes(records).into_iter().filter_map(row).collect();
    let head = [
        "scheme",
        "claimed order",
        "evaluations a step",
        "measured order",
        "scenes",
        "pass",
        "known deviations",
        "undecided",
        "fail",
    ];
    table(
        "schemes",
        "The schemes: claimed and measured order of the orientation, and their verdicts.",
        &head,
        rows,
    )
}

/// Whether an order is decided and of the quantity that stands for its scene.
fn stands(records: &Records, order: &Order) -> bool {
    order.status == OrderStatus::Decided && order.quantity == standing(records, &order.scene)
}

fn standing(records: &Records, scene: &str) -> &'static str {
    survey::base(ranking::quantity(records, scene))
}

/// A scene a row and a scheme a column.
fn grid(records: &Records, cell: impl Fn(&str, &str) -> Option<String>) -> (Vec<String>, Vec<Vec<String>>) {
    let schemes = survey::schemes(records);
    let filled = |scheme: &&str| survey::scenes(records).iter().any(|scene| cell(scene, scheme).is_some());
    let schemes: Vec<&str> = schemes.into_iter().filter(filled).collect();
    let row = |scene: &str| {
        let cells: Vec<Option<String>> = schemes.iter().map(|scheme| cell(scene, scheme)).collect();
        let any = cells.iter().any(Option::is_some);
        let cells = cells.into_iter().map(|cell| cell.unwrap_or_else(|| number::NONE.into()));
        any.then(|| std::iter::once(scene.to_owned()).chain(cells).collect())
    };
    let head = std::iter::once("scene").chain(schemes.iter().copied()).map(str::to_owned).collect();
    (head, survey::scenes(records).into_iter().filter_map(row).collect())
}

/// Orders of the quantity that stands for each scene: the heads, and a row a scene.
pub(super) fn order_grid(
    records: &Records,
    words: impl Fn(&Order) -> String,
) -> (Vec<String>, Vec<Vec<String>>) {
    let order = |scene: &str, scheme: &str| survey::order(records, scene, scheme, standing(records, scene));
    grid(records, |scene, scheme| order(scene, scheme).map(&words))
}

/// Orders of the quantity that stands for each scene.
pub(super) fn orders(records: &Records) -> Option<Table> {
    let words = |order: &Order| match (order.status, order.order) {
        (OrderStatus::Decided, Some(value)) => format!("{value:.2}"),
        (status, _) => status.word().replace('-', " "),
    };
    let (head, rows) = order_grid(records, words);
    of(Table {
        name: "orders",
        caption: "Measured order of the orientation, or of a body point where nothing turns.".into(),
        head,
        rows,
    })
}

/// Error constants of the quantity that stands for each scene.
fn constants(records: &Records) -> Option<Table> {
    let cell = |scene: &str, scheme: &str| {
        let order = survey::order(records, scene, scheme, standing(records, scene))?;
        order.constant.filter(|_| order.status == OrderStatus::Decided).map(|c| number::significant(c, 3))
    };
    let (head, rows) = grid(records, cell);
    let caption = "Error constants C of e = C h^p of the same quantity, in its unit over s^p.".into();
    of(Table { name: "constants", caption, head, rows })
}

/// Drifts of the rotational energy of bodies without torque.
pub(super) fn drifts(records: &Records) -> Option<Table> {
    let cell = |scene: &str, scheme: &str| {
        let own =
            |row: &&Drift| row.scene == scene && row.scheme == scheme && row.quantity == "rotational-energy";
        let row = records.drifts.iter().find(own)?;
        Some(match (row.class, row.rate_order) {
            (DriftClass::Secular, Some(order)) => format!("secular, {order:.2}"),
            (class, _) => class.word().to_owned(),
        })
    };
    let (head, rows) = grid(records, cell);
    let caption = "Drift of the rotational energy without torque, with the order of its rate in h.".into();
    of(Table { name: "drifts", caption, head, rows })
}

/// The rankings without torque and with it.
pub(super) fn rankings(records: &Records) -> Vec<Table> {
    ranking::overall(records).iter().map(ranking_table).collect()
}

fn ranking_table(group: &ranking::Overall) -> Table {
    let (name, kind) =
        if group.torque_free { ("free", "without torque") } else { ("torqued", "under a torque") };
    let extreme = |(ratio, scene): (f64, &str)| format!("{} ({scene})", number::significant(ratio, 2));
    let row = |(index, place): (usize, &ranking::OverallPlace)| {
        vec![
            place.scheme.to_owned(),
            (index + 1).to_string(),
            number::significant(place.mean, 3),
            extreme(place.best),
            extreme(place.worst),
        ]
    };
    let left_out = match group.left_out.as_slice() {
        [] => String::new(),
        few if few.len() <= 3 => format!(" Not run on all of them: {}.", few.join(", ")),
        many => format!(" {} schemes were not run on all of them.", many.len()),
    };
    let caption = format!(
        "Error at equal work over that of {}, {kind}: geometric mean over {} common scenes and its range.{left_out}",
        group.yardstick,
        group.scenes.len()
    );
    let head = ["scheme", "place", "mean ratio", "smallest", "largest"].map(str::to_owned).to_vec();
    Table { name, caption, head, rows: group.places.iter().enumerate().map(row).collect() }
}

fn table(name: &'static str, caption: &str, head: &[&str], rows: Vec<Vec<String>>) -> Option<Table> {
    let head = head.iter().map(|head| (*head).to_owned()).collect();
    of(Table { name, caption: caption.to_owned(), head, rows })
}

/// A table that has rows.
fn of(table: Table) -> Option<Table> {
    (!table.rows.is_empty()).then_some(table)
}

impl Table {
    pub(super) fn written(&self, language: Language) -> String {
        match language {
            Language::Markdown => self.markdown(),
            Language::Latex => self.latex(),
        }
    }

    fn markdown(&self) -> String {
        let line = |cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|cell| super::markdown::cell(cell)).collect();
            format!("| {} |\n", cells.join(" | "))
        };
        let rule = format!("|---|{}\n", "---:|".repeat(self.head.len().saturating_sub(1)));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        format!("{}\n\n{}{rule}{rows}", self.caption, line(&self.head))
    }

    fn latex(&self) -> String {
        let line = |cells: &[String]| {
            let cells: Vec<String> = cells.iter().map(|cell| latex(cell)).collect();
            format!("{} \\\\\n", cells.join(" & "))
        };
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        format!(
            "\\begin{{table}}\n\\centering\n\\caption{{{}}}\n\\label{{tab:{}}}\n\\begin{{tabular}}{{l{}}}\n\\toprule\n{}\\midrule\n{rows}\\bottomrule\n\\end{{tabular}}\n\\end{{table}}\n",
            latex(&self.caption),
            self.name,
            "r".repeat(self.head.len().saturating_sub(1)),
            line(&self.head),
        )
    }
}

/// A text as LaTeX writes it: signs escaped, superscripts as powers.
fn latex(text: &str) -> String {
    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let mut written = String::new();
    let mut raised = String::new();
    for letter in text.chars().chain(['\0']) {
        if let Some(digit) = RAISED.chars().position(|one| one == letter) {
            raised += &digit.to_string();
            continue;
        }
        if letter == '⁻' {
            raised.push('-');
            continue;
        }
        if !raised.is_empty() {
            written += &format!("$^{{{}}}$", std::mem::take(&mut raised));
        }
        match letter {
            '\0' => {}
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => written.extend(['\\', letter]),
            '^' => written += "\\^{}",
            '~' => written += "\\~{}",
            '\\' => written += "\\textbackslash{}",
            '×' => written += "$\\times$",
            '±' => written += "$\\pm$",
            '−' => written += "$-$",
            '–' => written += "--",
            '<' | '>' => written += &format!("${letter}$"),
            other => written.push(other),
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latex_escapes_signs_and_raises_powers() {
        assert_eq!(latex("1.2×10⁻⁸ & 50 %_"), "1.2$\\times$10$^{-8}$ \\& 50 \\%\\_");
        assert_eq!(latex("2.00 ± 0.01 –"), "2.00 $\\pm$ 0.01 --");
    }

    #[test]
    fn every_row_has_as_many_cells_as_the_head_in_both_languages() {
        let table =
            table("t", "A table.", &["a", "b"], vec![vec!["x | y".into(), "1".into()]]).expect("rows");
        let text = table.written(Language::Markdown);
        let bars = |line: &str| line.replace("\\|", "").matches('|').count();
        assert!(text.lines().filter(|line| line.starts_with('|')).all(|line| bars(line) == 3), "{text}");
        let text = table.written(Language::Latex);
        assert!(text.contains("\\begin{tabular}{lr}") && text.contains("x | y & 1 \\\\"), "{text}");
        assert!(super::table("t", "None.", &["a"], Vec::new()).is_none());
    }
}
