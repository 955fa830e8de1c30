//! The comparison in a sentence: how large the errors of the second are beside those of the first.

use super::row::Row;

/// The quantities that are summed up: how the body is turned, and where any point of it is.
const SUMMED_UP: [&str; 2] = ["body-point", "orientation"];

/// For each quantity that was compared the geometric mean over the scenes of the ratio of errors at equal work, with the least and the
/// largest.
pub(super) fn sentences(rows: &[Row], a: &str, b: &str) -> String {
    let sentence = |quantity: &str| {
        let own = rows.iter().filter(|row| row.quantity == quantity);
        let ratios: Vec<f64> =
            own.filter_map(|row| row.at_equal_work).filter(|r| r.is_finite() && *r > 0.0).collect();
        let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
        let least = ratios.iter().copied().reduce(f64::min)?;
        let largest = ratios.iter().copied().reduce(f64::max)?;
        let over = match ratios.len() {
            1 => "1 scene".to_owned(),
            count => format!("geometric mean of {count} scenes; {} … {}", short(least), short(largest)),
        };
        let words = quantity.replace('-', " ");
        Some(format!("{b}'s {words} error is {} × {a}'s at equal work ({over})\n", short(mean)))
    };
    SUMMED_UP.into_iter().filter_map(sentence).collect()
}

/// A ratio with three digits.
fn short(ratio: f64) -> String {
    match ratio {
        r if !(1e-3..1e4).contains(&r) => format!("{r:.1e}"),
        r if r < 0.995 => format!("{r:.*}", (2.0 - r.log10().floor()) as usize),
        r => format!("{r:.*}", (2.0 - r.log10().floor()).max(0.0) as usize),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::compare::row::Standing;

    #[test]
    fn the_mean_of_a_half_and_two_is_one() {
        let row = |ratio| Row {
            scene: String::new(),
            scheme: String::new(),
            quantity: "orientation".to_owned(),
            kinds: Default::default(),
            sizes: Default::default(),
            ratio: None,
            at_equal_work: ratio,
            standing: Standing::Same,
            why: None,
        };
        let rows = [row(Some(0.5)), row(Some(2.0)), row(None)];
        let said =
            "b's orientation error is 1.00 × a's at equal work (geometric mean of 2 scenes; 0.500 … 2.00)\n";
        assert_eq!(sentences(&rows, "a", "b"), said);
        assert_eq!(
            sentences(&rows[1..], "a", "b"),
            "b's orientation error is 2.00 × a's at equal work (1 scene)\n"
        );
        assert_eq!(sentences(&rows[2..], "a", "b"), "");
        assert_eq!(
            (short(0.0812), short(38.21), short(381.2)),
            ("0.0812".into(), "38.2".into(), "381".into())
        );
    }
}
