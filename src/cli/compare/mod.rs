//! `polhode compare`: two schemes, or two records files, side by side, scene by scene.

mod cell;
mod format;
mod ladder;
mod row;
mod side;
mod summary;

use std::path::Path;

use clap::Args;

use self::cell::Cell;
use self::format::Format;
use self::row::{Row, Standing};
use self::side::Side;
use super::Failure;
use super::exit::UNDECIDED;
use super::output::print;
use super::progress::{with_bar, with_word};
use super::select;
use crate::campaign::{self, Campaign, SECONDS_A_COST};
use crate::record::Records;

/// Options of `polhode compare`.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub(super) struct Options {
    /// A scheme, or a records file
    a: String,
    /// Another scheme, or another records file
    b: String,
    #[command(flatten)]
    scenes: select::Scenes,
    /// Show the rows that are the same on either side too
    #[arg(long)]
    all: bool,
    /// Form of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

const EXAMPLES: &str = "\
Examples:
  polhode compare peskin-rk2 peskin-heun
  polhode compare peskin-rk2 rk4-quaternion --scene kovalevskaya
  polhode compare peskin-rk2 substepped-4-peskin-rk2
  polhode compare before.json after.json

Of every quantity: order, error constant C = e/h^p, their ratio, and the ratio of the errors at equal work, as many force
evaluations of either. Where no order is read on one side, the errors of the runs themselves at equal work. Of every drift: its
kind, its order in h, and its rate. Of the cost: force evaluations and time of a step. A time decides nothing.

Exit code: 0 the second is nowhere worse, 1 it is somewhere: an order lower by more than 0.15; at the same order an error
larger by more than 5 % at equal work; a drift of a worse kind or order, or larger by more than 10 %; more evaluations a step
without anything in the scene being better for it; in records files also what was measured before and is not any more.
2 nothing was compared: neither could be measured in any scene, or two files have no scene and scheme in common.";

pub(super) fn compare(options: &Options, quiet: bool) -> Result<u8, Failure> {
    let (a, b) = sides(options, quiet)?;
    let cells = Cell::pairs(&a, &b, &options.scenes.names());
    let rows: Vec<Row> = cells.iter().flat_map(Cell::rows).collect();
    if rows.is_empty() {
        eprintln!(
            "polhode: nothing was compared: {} and {} have no scene and scheme in common",
            a.name, b.name
        );
        return Ok(UNDECIDED);
    }
    let count = |standing| rows.iter().filter(|row| row.standing == standing).count();
    let compared = rows.iter().filter(|row| row.standing.compares()).count();
    let (worse, better) = (count(Standing::Worse), count(Standing::Better));
    let refused = count(Standing::NotApplicable);
    let shown: Vec<Row> =
        rows.iter().filter(|row| options.all || row.standing != Standing::Same).cloned().collect();
    print(&format::rows_as(options.format, &shown, a.scheme.is_none())?)?;
    let hidden = match rows.len() - shown.len() {
        0 => String::new(),
        count => format!("{count} rows that are the same are not shown; --all shows them\n"),
    };
    let said = format!(
        "{hidden}\nA = {}, B = {}: {compared} quantities compared, {better} better, {worse} worse, {} undecided; \
         not applicable in {refused} scene{}\n{}",
        a.name,
        b.name,
        count(Standing::Undecided),
        if refused == 1 { "" } else { "s" },
        summary::sentences(&rows, &a.name, &b.name),
    );
    match options.format {
        Format::Text => print(&said)?,
        // A table for a program holds rows alone.
        _ if quiet => {}
        _ => eprint!("{said}"),
    }
    Ok(match (worse, compared) {
        (0, 0) => UNDECIDED,
        (0, _) => 0,
        _ => 1,
    })
}

/// Two files, or two schemes measured in one campaign.
fn sides(options: &Options, quiet: bool) -> Result<(Side, Side), Failure> {
    let is_file = |name: &str| name.ends_with(".json") || Path::new(name).is_file();
    let file = |name: &str| Records::read(Path::new(name)).map(|records| Side::file(name, records));
    match (is_file(&options.a), is_file(&options.b)) {
        (true, true) => Ok((file(&options.a)?, file(&options.b)?)),
        (false, false) => {
            let mut contestants = vec![select::contestant(&options.a)?];
            if options.b != options.a {
                contestants.push(select::contestant(&options.b)?);
            }
            let scenes = options.scenes.open()?;
            let grid = Campaign::of(scenes.clone(), contestants.clone());
            let mut records = with_bar(quiet, "measuring", |progress| Campaign { progress, ..grid }.run());
            with_word(quiet, "timing", || {
                campaign::add_costs(&mut records, &scenes, &contestants, SECONDS_A_COST);
            });
            Ok((Side::scheme(&options.a, records.clone()), Side::scheme(&options.b, records)))
        }
        _ => Err(Failure::Usage("compare two schemes or two records files, not one of each".to_owned())),
    }
}
