//! What instruments and files do to numbers: clipping, wrapping, noise.

use std::f64::consts::{PI, TAU};

use super::{Case, Change, LEFT, Part, Tried, VECTORS, vector};

/// Rows that a mean of noise is taken over, at least.
const FEWEST: usize = 30;
/// Standard deviations of a mean or a correlation of noise: of five numbers, chance exceeds four once in three thousand logs.
const DEVIATIONS: f64 = 4.0;
/// Fewest rows at a limit.
const AT_LIMIT: usize = 2;

pub(super) fn tried(case: &Case) -> Vec<Tried> {
    let parts = VECTORS.into_iter().filter(|part| case.parts().has(*part));
    parts.flat_map(|part| [clipped(case, part), wrapped(case, part)]).flatten().collect()
}

/// Components equal a limit wherever they are off, and the reference is beyond it there.
fn clipped(case: &Case, part: Part) -> Option<Tried> {
    let size = case.sizes[part as usize];
    let off = |log: f64, truth: f64| (log - truth).abs() > LEFT * LEFT * size;
    let components = || case.vectors(part).flat_map(|(log, truth)| (0..3).map(move |k| (log[k], truth[k])));
    let limit =
        components().filter(|(log, truth)| off(*log, *truth)).map(|(log, _)| log.abs()).fold(0.0, f64::max);
    let beyond = |log: f64, truth: f64| {
        (log.abs() - limit).abs() <= LEFT * LEFT * size && truth.abs() > limit && truth * log > 0.0
    };
    let count = components().filter(|(log, truth)| off(*log, *truth)).count();
    let all = components().filter(|(log, truth)| off(*log, *truth)).all(|(log, truth)| beyond(log, truth));
    if count < AT_LIMIT || !all || limit == 0.0 {
        return None;
    }
    let mut truth = case.truth.clone();
    for (state, truth) in case.states.iter().zip(&mut truth) {
        let (log, mut own) = (vector(part, state), vector(part, truth));
        for k in 0..3 {
            if off(log[k], own[k]) {
                own[k] = own[k].clamp(-limit, limit);
            }
        }
        *truth = super::with_vector(part, truth, own);
    }
    let words = format!("the {} is clipped at {limit:.6}: other rows agree", part.word());
    Some(Tried { change: Change::Clipped, words, left: case.residual(&case.states, &truth) })
}

/// Components within ±π that are whole turns off.
fn wrapped(case: &Case, part: Part) -> Option<Tried> {
    let within = case.vectors(part).all(|(log, _)| log.amax() <= PI * (1.0 + LEFT));
    let whole = |log: f64, truth: f64| ((truth - log) / TAU).round() * TAU;
    let any = case.vectors(part).any(|(log, truth)| (0..3).any(|k| whole(log[k], truth[k]) != 0.0));
    if !within || !any {
        return None;
    }
    let states: Vec<_> = case
        .states
        .iter()
        .zip(&case.truth)
        .map(|(state, truth)| {
            let (log, own) = (vector(part, state), vector(part, truth));
            super::with_vector(part, state, log.zip_map(&own, |log, truth| log + whole(log, truth)))
        })
        .collect();
    let words = format!("the {} is wrapped at ±π", part.word());
    Some(Tried { change: Change::Wrapped, words, left: case.residual(&states, &case.truth) })
}

/// Noise: errors without mean and without memory.
pub(super) fn noise(case: &Case, before: f64) -> Option<Tried> {
    let count = case.rows.len();
    if count < FEWEST {
        return None;
    }
    let mut sizes = Vec::new();
    for part in case.parts().each() {
        let errors: Vec<_> = case
            .states
            .iter()
            .zip(&case.truth)
            .map(|(state, truth)| match part {
                Part::Orientation => {
                    crate::rotation::vector_of(&(truth.orientation.inverse() * state.orientation))
                }
                _ => vector(part, state) - vector(part, truth),
            })
            .collect();
        let size = case.sizes[part as usize];
        for k in 0..3 {
            let squares: f64 = errors.iter().map(|e| e[k] * e[k]).sum();
            if squares.sqrt() <= super::SMALL * size * (count as f64).sqrt() {
                continue;
            }
            let mean = errors.iter().map(|e| e[k]).sum::<f64>() / squares.sqrt();
            let memory: f64 = errors.windows(2).map(|pair| pair[0][k] * pair[1][k]).sum::<f64>() / squares;
            // Both have a standard deviation: of one, and of 1/√n.
            if mean.abs() > DEVIATIONS || memory.abs() * (count as f64).sqrt() > DEVIATIONS {
                return None;
            }
        }
        let squares: f64 = errors.iter().map(|e| e.norm_squared()).sum();
        let each = (squares / (3 * count) as f64).sqrt();
        if each > super::SMALL * size {
            sizes.push(format!("{} {each:.3e}", part.word()));
        }
    }
    let words = format!(
        "the errors are noise without mean and memory, of a standard deviation of {}",
        sizes.join(", ")
    );
    (!sizes.is_empty()).then_some(Tried { change: Change::Noise, words, left: before })
}
