//! Per scene: the errors of every quantity against what they cost: nanoseconds a simulated second, force evaluations a simulated
//! second, and against the step. A scheme is a line; the Pareto front, where nothing has a smaller error for less work, is
//! drawn over them, and what the reference leaves undecided is a band.

use crate::record::Records;
use crate::report::ranking::{self, Ladder, Work};
use crate::report::{number, survey};

use super::curves;
use super::labels;
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame};
use super::sketch::{Anchor, Sketch};
use super::work_precision_panel::{self as one, Names};

const WIDTH: f64 = 2600.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;
const ROW: f64 = 660.0;

/// The columns, with what stands under each.
const COLUMNS: [(Work, &str); 3] = [
    (Work::Nanoseconds, "nanoseconds a simulated second"),
    (Work::Evaluations, "force evaluations a simulated second"),
    (Work::Step, "step h [s]"),
];

/// Whose lines are drawn, and by what name they are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum Cast {
    /// The main schemes, each by itself.
    Main,
    /// Every scheme, by its family.
    Everyone,
}

/// Which quantities a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum Group {
    /// How the body turns.
    Rotation,
    /// Where it is: the centre of mass, and points of the body.
    Motion,
}

impl Group {
    /// Both.
    pub(in crate::report) const ALL: [Group; 2] = [Group::Rotation, Group::Motion];

    /// The word in file names and titles.
    pub(super) fn word(self) -> &'static str {
        match self {
            Group::Rotation => "rotation",
            Group::Motion => "motion",
        }
    }

    fn holds(self, quantity: &str) -> bool {
        let turns = matches!(quantity, "orientation" | "angular-velocity" | "angular-momentum");
        turns == (self == Group::Rotation)
    }
}

/// A quantity's ladders, one list a column.
struct Row<'a> {
    title: String,
    unit: String,
    ladders: [Vec<Ladder<'a>>; 3],
    floor: Option<f64>,
}

impl Row<'_> {
    /// Whether the floor of the reference is a band of the panels, and not far below them.
    fn shows_floor(&self) -> bool {
        let errors = self.ladders[2].iter().flat_map(|ladder| &ladder.points).map(|point| point.error);
        let least = errors.fold(f64::INFINITY, f64::min);
        self.floor.is_some_and(|floor| floor > least - one::FLOOR_IN_SIGHT)
    }
}

/// The picture; `None` where fewer than two schemes have errors, and for everyone where that is the main ones alone.
pub(super) fn sketch(
    records: &Records,
    main: &Records,
    scene: &str,
    (cast, group): (Cast, Group),
) -> Option<Sketch> {
    let records = if cast == Cast::Main { main } else { records };
    let rows = rows(records, main, scene, (cast, group));
    let schemes = survey::distinct(rows.iter().flat_map(|row| row.ladders[2].iter().map(|l| l.scheme)));
    if schemes.len() < 2 {
        return None;
    }
    // Schemes keep their looks from picture to picture; so do families.
    let palette = match cast {
        Cast::Main => Palette::new(survey::measured_schemes(main)),
        Cast::Everyone => {
            Palette::new(survey::distinct(records.schemes.iter().map(|row| row.family.as_str())))
        }
    };
    let shown = |name: &&&str| {
        rows.iter().flat_map(|row| &row.ladders[2]).any(|ladder| one::name(ladder, cast) == **name)
    };
    let entries = entries(&palette, palette.schemes().iter().filter(shown).copied().collect(), &rows);
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let strip = legend::height(&entries, room);
    let height = (TOP + ROW * rows.len() as f64 + strip + 2.0 * MARGIN).max(1000.0);
    let title = survey::title(records, scene);
    let mut sketch =
        Sketch::new(WIDTH, height, format!("{title}: errors of the {} against cost and step", group.word()));
    let timed = rows.iter().all(|row| row.ladders[0].len() == row.ladders[2].len());
    let whose = match cast {
        Cast::Main => "",
        Cast::Everyone if timed => " · every scheme, by family",
        Cast::Everyone => " · every scheme, by family; at the left those that were timed",
    };
    let subtitle = format!("{scene} · {}{whose} · error at the end of the run", group.word());
    panel::headline(&mut sketch, title, &subtitle);
    let bottom = TOP + ROW * rows.len() as f64;
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom };
    for (index, row) in rows.iter().enumerate() {
        draw_row(&mut sketch, &palette, row, all.cell((1, rows.len()), index), cast);
    }
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, bottom + MARGIN, room);
    Some(sketch)
}

/// The quantities that some scheme has an error in that is not rounding.
fn rows<'a>(
    records: &'a Records,
    main: &'a Records,
    scene: &str,
    (cast, group): (Cast, Group),
) -> Vec<Row<'a>> {
    let of = |quantity: curves::Quantity| {
        let metric = format!("{}-end", quantity.name);
        let ladders = COLUMNS.map(|(work, _)| ranking::ladders(records, scene, &metric, work));
        let floor = ranking::floor(records, scene, &metric);
        let words = survey::quantity_words(quantity.name);
        let title = format!("{} error [{}]", survey::capital(&words), quantity.unit);
        Row { title, unit: quantity.unit.to_owned(), ladders, floor }
    };
    let tells = |row: &Row| row.ladders[2].iter().any(|ladder| ladder.points.iter().any(|p| !p.lost));
    // Beside the main schemes, which have a picture of their own, everyone must be more of them.
    let more = |row: &Row| cast == Cast::Main || row.ladders[2].iter().any(|l| is_apart(main, l.scheme));
    curves::at_the_end(records, scene)
        .into_iter()
        .filter(|q| group.holds(q.name))
        .map(of)
        .filter(|row| tells(row) && more(row))
        .collect()
}

fn is_apart(main: &Records, scheme: &str) -> bool {
    main.schemes.iter().all(|row| row.name != scheme)
}

fn entries(palette: &Palette, names: Vec<&str>, rows: &[Row]) -> Vec<Entry> {
    let mut entries: Vec<Entry> =
        names.into_iter().map(|name| Entry::new(Sign::Scheme(palette.look(name)), name)).collect();
    let ladders = || rows.iter().flat_map(|row| &row.ladders[2]);
    entries.push(Entry::new(Sign::Front, "Pareto front"));
    if ladders().any(|ladder| ladder.points.iter().any(|point| point.lost)) {
        entries.push(Entry::new(Sign::Hollow, "at the floor of reference or rounding"));
    }
    if rows.iter().any(|row| row.shows_floor()) {
        entries.push(Entry::new(Sign::Band, "what the reference leaves undecided"));
    }
    if ladders().any(|ladder| !ladder.broken.is_empty()) {
        entries.push(Entry::new(Sign::Cross, "run broke"));
    }
    if ladders().any(|ladder| ladder.points.iter().any(|point| point.error > one::HIGHEST)) {
        entries.push(Entry::new(Sign::Arrow, "error beyond the chart"));
    }
    entries
}

fn draw_row(sketch: &mut Sketch, palette: &Palette, row: &Row, cell: Frame, cast: Cast) {
    // The lines of the main schemes are named once, at the right; on a front of many, those that hold it are named in each panel.
    let names = [Names::Front, Names::Front, Names::Ends].map(|names| match (cast, names) {
        (Cast::Main, Names::Front) => Names::None,
        (Cast::Everyone, Names::Ends) => Names::None,
        (_, names) => names,
    });
    let width = |(ladders, names): (&Vec<Ladder>, Names)| match one::names(ladders, names) {
        list if list.is_empty() => 24.0,
        list => labels::column_width(list.into_iter()),
    };
    let widths: Vec<f64> = row.ladders.iter().zip(names).map(width).collect();
    const LEFT: f64 = 118.0;
    let panel = (cell.right - cell.left - widths.iter().sum::<f64>()) / 3.0 - LEFT;
    let mut left = cell.left;
    for (index, (_, words)) in COLUMNS.iter().enumerate() {
        let frame = Frame {
            left: left + LEFT,
            top: cell.top + 66.0,
            right: left + LEFT + panel,
            bottom: cell.bottom - 116.0,
        };
        left = frame.right + widths[index];
        let title = if index == 0 { row.title.as_str() } else { "" };
        let view = one::View {
            ladders: &row.ladders[index],
            all: &row.ladders[2],
            floor: row.floor,
            front: index < 2,
            names: names[index],
            cast,
        };
        view.draw(sketch, palette, frame, title, words);
        if let Some(floor) = row.floor.filter(|_| index == 2) {
            let good = number::significant(10f64.powf(floor), 1);
            let words = format!("reference good to {}", number::joined(&good, &row.unit));
            sketch.text(&words, (frame.right, frame.top - 30.0), Anchor::End, panel::TICK);
        }
    }
}
