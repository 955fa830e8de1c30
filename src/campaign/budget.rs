//! Which runs there is time for: short runs say what a step costs, and ladders are cut where the budget ends.
//!
//! First every scheme gets in every scene the fewest runs that decide anything, the cheapest first; then all get the runs of a usual ladder, and then
//! those that only an undecided order asks for, the cheapest run first.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::{Campaign, Prepared, cell};
use crate::interrupt;
use crate::measure::{Bounds, Price};

/// What a scheme in a scene may take.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Share {
    /// Steps of the finest run; `None` where there is time for all.
    pub(super) finest: Option<u64>,
    /// Estimate of the time of a usual ladder and what is measured beside it [s].
    pub(super) seconds: f64,
}

/// What all runs of a campaign take, and what is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Usual ladders of all schemes in all scenes, in so many threads at once [s].
    pub seconds: f64,
    /// Schemes in scenes that are run, …
    pub cells: usize,
    /// … and those that get less than a usual ladder.
    pub cut: usize,
}

/// A scheme in a scene while time is given out.
struct Cell {
    price: Price,
    runs: usize,
}

impl Cell {
    fn seconds(&self) -> f64 {
        self.price.seconds(self.runs)
    }
}

/// The shares of every scheme in every scene: a row a scene, in the order of the campaign.
pub(super) fn shares(
    campaign: &Campaign,
    prepared: &[Option<Prepared>],
    (budget, begun): (Duration, Instant),
) -> (Vec<Vec<Share>>, Estimate) {
    let count = campaign.contestants.len();
    let grid: Vec<(usize, usize)> =
        (0..prepared.len()).flat_map(|scene| (0..count).map(move |one| (scene, one))).collect();
    let price = |(scene, one): &(usize, usize)| price(campaign, prepared[*scene].as_ref()?, *one);
    let prices: Vec<Option<Price>> = grid.par_iter().with_max_len(1).map(price).collect();
    let places: Vec<usize> = (0..prices.len()).filter(|place| prices[*place].is_some()).collect();
    let mut cells: Vec<Cell> = prices.into_iter().flatten().map(|price| Cell { price, runs: 0 }).collect();
    let left = budget.saturating_sub(begun.elapsed()).as_secs_f64();
    give_out(&mut cells, left, rayon::current_num_threads());
    let mut shares = vec![Share::default(); grid.len()];
    for (place, cell) in places.iter().zip(&cells) {
        shares[*place] = cell.share();
    }
    let estimate = Estimate {
        seconds: in_threads(cells.iter().map(|cell| cell.price.seconds(cell.price.usual()))),
        cells: cells.len(),
        cut: cells.iter().filter(|cell| cell.runs < cell.price.usual()).count(),
    };
    (shares.chunks(count.max(1)).map(<[Share]>::to_vec).collect(), estimate)
}

/// `None` where nothing is run.
fn price(campaign: &Campaign, prepared: &Prepared, one: usize) -> Option<Price> {
    let (scene, contestant) = (prepared.scene, &campaign.contestants[one]);
    let reference = prepared.reference.as_ref()?.as_ref().ok()?;
    let runs = contestant.refusal(&scene.system).is_none() && !interrupt::requested();
    let bounds: Bounds = (campaign.bounds)(&scene.name, contestant.card.name);
    let order = cell::asked_order(scene, contestant);
    runs.then(|| Price::of(contestant, &scene.system, reference, (order, bounds)))
}

/// Time of pieces of work that threads take as they become free, at most [s].
fn in_threads(seconds: impl Iterator<Item = f64>) -> f64 {
    let (sum, most) = seconds.fold((0.0, 0.0f64), |(sum, most), one| (sum + one, most.max(one)));
    let threads = rayon::current_num_threads() as f64;
    (sum + (threads - 1.0) * most) / threads
}

/// Gives out so many seconds of so many threads.
fn give_out(cells: &mut [Cell], left: f64, threads: usize) {
    let mut spent = Spent { left, threads: threads as f64, sum: 0.0, most: 0.0 };
    let mut order: Vec<usize> = (0..cells.len()).collect();
    let least = |index: &usize| cells[*index].price.seconds(cells[*index].price.fewest());
    order.sort_by(|a, b| least(a).total_cmp(&least(b)));
    for index in order {
        let fewest = cells[index].price.fewest();
        spent.raise(&mut cells[index], fewest);
    }
    let usual = |cell: &Cell| cell.price.usual();
    raise_all(cells, &mut spent, usual);
    raise_all(cells, &mut spent, |cell| cell.price.steps.len());
}

/// A run more where it is cheapest, until none is wanted or affordable. Cells without a run get none.
fn raise_all(cells: &mut [Cell], spent: &mut Spent, wanted: impl Fn(&Cell) -> usize) {
    // Numbers above zero stand in the order of their bits.
    let next = |(index, cell): (usize, &Cell)| {
        let able = cell.runs > 0 && cell.runs < wanted(cell);
        able.then(|| Reverse(((cell.price.seconds(cell.runs + 1) - cell.seconds()).to_bits(), index)))
    };
    let mut open: BinaryHeap<Reverse<(u64, usize)>> = cells.iter().enumerate().filter_map(next).collect();
    while let Some(Reverse((_, index))) = open.pop() {
        let runs = cells[index].runs + 1;
        if spent.raise(&mut cells[index], runs) {
            open.extend(next((index, &cells[index])));
        }
    }
}

/// The time that is given out.
struct Spent {
    left: f64,
    threads: f64,
    sum: f64,
    most: f64,
}

impl Spent {
    /// Gives a cell so many runs where there is time. Threads that take pieces of work as they become free end within their mean and the
    /// largest piece (Graham 1969).
    fn raise(&mut self, cell: &mut Cell, runs: usize) -> bool {
        let seconds = cell.price.seconds(runs);
        let (sum, most) = (self.sum + seconds - cell.seconds(), self.most.max(seconds));
        let fits = sum + (self.threads - 1.0) * most <= self.threads * self.left;
        if fits {
            (self.sum, self.most, cell.runs) = (sum, most, runs);
        }
        fits
    }
}

impl Cell {
    fn share(&self) -> Share {
        let all = self.runs == self.price.steps.len();
        let finest = self.runs.checked_sub(1).map_or(0, |last| self.price.steps[last]);
        Share { finest: (!all).then_some(finest), seconds: self.price.seconds(self.price.usual()) }
    }
}
