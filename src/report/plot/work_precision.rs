//! Per scene: the error of the orientation, or of the position, against what it costs: nanoseconds a simulated second, and force evaluations a
//! simulated second. A main scheme is a line in its colour, any other is grey; the Pareto front, where nothing has a smaller error for less
//! work, is drawn over them, and errors below the uncertainty of the reference lie in a band.

use crate::record::Records;
use crate::report::ranking::{self, Ladder, Work};
use crate::report::{number, survey};

use super::curves;
use super::key::{self, Key};
use super::legend::{self, Entry, Sign};
use super::palette::Palette;
use super::panel::{self, Frame};
use super::sketch::Sketch;
use super::work_precision_panel as one;

const WIDTH: f64 = 2600.0;
const TOP: f64 = 150.0;
const MARGIN: f64 = 30.0;
const ROW: f64 = 900.0;

/// The columns, with what stands under each. The error against the step is another picture.
const COLUMNS: [(Work, &str); 2] = [
    (Work::Nanoseconds, "nanoseconds a simulated second"),
    (Work::Evaluations, "force evaluations a simulated second"),
];

/// Whose lines are drawn, and by what name they are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum Cast {
    /// The main schemes, each by itself.
    Main,
    /// Every scheme: grey, with the main ones in their colours.
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

    /// The quantity that stands for the group: those of a group converge alike, and the error against the step shows all of them.
    fn quantity(self) -> &'static str {
        match self {
            Group::Rotation => "orientation",
            Group::Motion => "position",
        }
    }
}

/// A quantity's ladders, one list a column.
struct Row<'a> {
    title: String,
    ladders: [Vec<Ladder<'a>>; 2],
    floor: Option<f64>,
}

impl Row<'_> {
    /// Whether the floor of the reference is a band of the panels, and not far below them.
    fn shows_floor(&self) -> bool {
        let errors = self.ladders[1].iter().flat_map(|ladder| &ladder.points).map(|point| point.error);
        let least = errors.fold(f64::INFINITY, f64::min);
        self.floor.is_some_and(|floor| floor > least - one::FLOOR_IN_SIGHT)
    }
}

/// The picture; `None` where fewer than two schemes have errors, and for everyone where that is the main ones alone.
pub(super) fn sketch(
    records: &Records,
    main: &Records,
    palette: &Palette,
    scene: &str,
    (cast, group): (Cast, Group),
) -> Option<Sketch> {
    let records = if cast == Cast::Main { main } else { records };
    let rows = rows(records, main, scene, (cast, group));
    let ladders = || rows.iter().flat_map(|row| row.ladders.iter().flatten());
    let schemes = survey::distinct(ladders().map(|ladder| ladder.scheme));
    if schemes.len() < 2 {
        return None;
    }
    let named: Vec<&str> = palette.schemes().iter().copied().filter(|name| schemes.contains(name)).collect();
    let fronts = fronts(&rows, &named);
    let key = key(palette, &named);
    let entries = entries(&rows, &fronts, schemes.len() - named.len());
    let room = WIDTH - 2.0 * MARGIN - 20.0;
    let bottom = TOP + ROW * rows.len() as f64;
    let height = bottom + key.height(room) + legend::height(&entries, room) + 3.0 * MARGIN;
    let title = survey::title(records, scene);
    let mut sketch =
        Sketch::new(WIDTH, height, format!("{title}: errors of the {} against cost", group.word()));
    let subtitle = format!(
        "{scene} · {} · {} · error at the end of the run",
        group.word(),
        number::counted(schemes.len(), "scheme")
    );
    panel::headline(&mut sketch, title, &subtitle);
    let all = Frame { left: MARGIN, top: TOP, right: WIDTH - MARGIN, bottom };
    for (index, row) in rows.iter().enumerate() {
        draw_row(&mut sketch, palette, row, all.cell((1, rows.len()), index), &fronts);
    }
    key.draw(&mut sketch, MARGIN + 20.0, bottom + MARGIN, room);
    legend::draw(&mut sketch, &entries, MARGIN + 20.0, bottom + 1.5 * MARGIN + key.height(room), room);
    Some(sketch)
}

/// The quantities that some scheme has an error in that is not rounding, at two steps at least.
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
        Row { title, ladders, floor }
    };
    let tells = |ladder: &Ladder| ladder.points.len() > 1 && ladder.points.iter().any(|point| !point.lost);
    // Beside the main schemes, which have a picture to themselves, everyone must be more of them.
    let more = |row: &Row| cast == Cast::Main || row.ladders[1].iter().any(|l| is_apart(main, l.scheme));
    curves::at_the_end(records, scene)
        .into_iter()
        .filter(|one| one.name == group.quantity())
        .map(of)
        .filter(|row| row.ladders[1].iter().any(tells) && more(row))
        .collect()
}

fn is_apart(main: &Records, scheme: &str) -> bool {
    main.schemes.iter().all(|row| row.name != scheme)
}

/// The schemes on any front that have no colour, in the order of their first place.
fn fronts<'a>(rows: &[Row<'a>], named: &[&str]) -> Vec<&'a str> {
    let fronts = rows.iter().flat_map(|row| &row.ladders).flat_map(|ladders| ranking::front(ladders));
    let mut schemes = survey::distinct(fronts.map(|(scheme, ..)| scheme));
    schemes.retain(|scheme| !named.contains(scheme));
    schemes
}

/// A row a scheme.
fn key(palette: &Palette, named: &[&str]) -> Key {
    let row = |name: &&str| key::Row { look: palette.look(name), name: (*name).into(), cells: Vec::new() };
    Key { heads: Vec::new(), rows: named.iter().map(row).collect() }
}

fn entries(rows: &[Row], fronts: &[&str], others: usize) -> Vec<Entry> {
    let ladders = || rows.iter().flat_map(|row| &row.ladders[1]);
    let mut entries = vec![Entry::new(Sign::Front, "Pareto front")];
    let numbered = |(index, name): (usize, &&str)| Entry::new(Sign::Number(index + 1), *name);
    entries.extend(fronts.iter().enumerate().map(numbered));
    if others > fronts.len() {
        entries.push(Entry::new(Sign::Others, format!("{} other schemes", others - fronts.len())));
    }
    if ladders().any(|ladder| ladder.points.iter().any(|point| point.lost)) {
        entries.push(Entry::new(Sign::Hollow, "at the floor of reference or rounding"));
    }
    if rows.iter().any(Row::shows_floor) {
        entries.push(Entry::new(Sign::Band, "below the uncertainty of the reference"));
    }
    if ladders().any(|ladder| !ladder.broken.is_empty()) {
        entries.push(Entry::new(Sign::Cross, "run broke"));
    }
    if ladders().any(|ladder| ladder.points.iter().any(|point| point.error > one::HIGHEST)) {
        entries.push(Entry::new(Sign::Arrow, "error beyond the chart"));
    }
    entries
}

fn draw_row(sketch: &mut Sketch, palette: &Palette, row: &Row, cell: Frame, fronts: &[&str]) {
    for (index, (_, words)) in COLUMNS.iter().enumerate() {
        let frame = cell.cell((COLUMNS.len(), 1), index).inside(124.0, 66.0, 26.0, 116.0);
        let view = one::View {
            ladders: &row.ladders[index],
            all: &row.ladders[1],
            floor: row.floor,
            palette,
            fronts,
        };
        view.draw(sketch, frame, if index == 0 { &row.title } else { "" }, words);
    }
}
