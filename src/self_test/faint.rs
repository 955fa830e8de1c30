//! Defects that are faint: a small part of a lower order, or one coefficient that is slightly off.

use super::planted::{Plant, Row};
use crate::model::{Broken, Model};
use crate::schemes::{Card, PeskinRk2, PeskinRk4, Scheme, Step};
use crate::simulate::Contestant;

/// Faint defects, and the scenes that show them.
pub(super) const FAINT: &[Row] = &[
    (
        "a ten-thousandth of Euler in the second stage",
        Plant::Other(|| Contestant::new(Contaminated::<1>)),
        &["free-asymmetric", "kovalevskaya", "tether-springs"],
    ),
    (
        "a coefficient of fourth order off by 1e-7",
        Plant::Other(|| Contestant::new(OffCoefficient)),
        &["free-asymmetric", "kovalevskaya", "tether-springs"],
    ),
];

/// Peskin's scheme whose second stage takes so many ten-thousandths of its rates from the start: first order, under a second-order part
/// that is the larger one at large steps.
#[derive(Clone, Copy)]
pub(super) struct Contaminated<const PARTS: u32>;

impl<const PARTS: u32> Scheme for Contaminated<PARTS> {
    fn card(&self) -> Card {
        Card {
            name: match PARTS {
                100 => "1 % of Euler in peskin-rk2",
                1000 => "10 % of Euler in peskin-rk2",
                _ => PeskinRk2.card().name,
            },
            title: "Peskin's scheme with a part of Euler's",
            ..PeskinRk2.card()
        }
    }

    const STATES: usize = 1;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [half] = work.buffers();
        let k0 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k0, half);
        let k1 = model.rates(t + h / 2.0, half)?;
        let part = f64::from(PARTS) / 10_000.0;
        model.advance(from, h, &(k1 * (1.0 - part) + k0 * part), to);
        Ok(())
    }
}

/// peskin-rk4 with its last weight off by 1e-7.
#[derive(Clone, Copy)]
struct OffCoefficient;

impl Scheme for OffCoefficient {
    fn card(&self) -> Card {
        PeskinRk4.card()
    }

    const STATES: usize = 2;

    fn step<M: Model>(&self, model: &M, Step { t, h, from, to, work }: Step<M>) -> Result<(), Broken> {
        let [early, stage] = work.buffers();
        let k1 = model.rates(t, from)?;
        model.advance(from, h / 2.0, &k1, early);
        let k2 = model.rates(t + h / 2.0, early)?;
        model.advance(from, h / 2.0, &k2, stage);
        let k3 = model.rates(t + h / 2.0, stage)?;
        model.advance(early, h, &(k3 + k1 * (-1.0 / 2.0)), stage);
        let k4 = model.rates(t + h, stage)?;
        let middle = (k2 + k3) * (1.0 / 6.0);
        model.advance(from, h, &(k1 * (1.0 / 4.0) + middle + k4 * (-1.0 / 12.0)), early);
        model.advance(early, h, &(k1 * (-1.0 / 12.0) + middle + k4 * (1.0 / 4.0 + 1e-7)), to);
        Ok(())
    }
}
