//! What is varied, as it is written on the command line: `key=from:to:n`, or `key=from:to:n:log`.

/// A key and the numbers that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The key.
    pub key: String,
    /// From the first number to the last.
    pub values: Vec<f64>,
    /// Whether they stand in equal ratios, and not at equal distances.
    pub logarithmic: bool,
}

const SHAPE: &str = "expected key=from:to:n or key=from:to:n:log, for example forces.0.stiffness=1:1e4:9:log";

impl Axis {
    /// Reads an axis.
    ///
    /// # Errors
    /// What is wrong with it, and what to write.
    pub fn parse(text: &str) -> Result<Axis, String> {
        let wrong = |what: &str| format!("{what}: {SHAPE}");
        let (key, range) = text.split_once('=').ok_or_else(|| wrong("no '='"))?;
        let parts: Vec<&str> = range.split(':').collect();
        let logarithmic = match parts[..] {
            [_, _, _] => false,
            [_, _, _, "log"] => true,
            [_, _, _, other] => return Err(wrong(&format!("'{other}' is no spacing"))),
            _ => return Err(wrong(&format!("{} parts after '='", parts.len()))),
        };
        let number = |text: &str| match text.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(wrong(&format!("'{text}' is no finite number"))),
        };
        let (from, to) = (number(parts[0])?, number(parts[1])?);
        let count = match parts[2].trim().parse::<usize>() {
            Ok(count) if (1..=100_000).contains(&count) => count,
            _ => return Err(wrong(&format!("'{}' is no count from 1 to 100000", parts[2]))),
        };
        if logarithmic && !(from > 0.0 && to > 0.0) {
            return Err(wrong("equal ratios need two numbers above 0"));
        }
        if count > 1 && from == to {
            return Err(wrong("the range is empty"));
        }
        Ok(Axis { key: key.trim().to_owned(), values: spaced(from, to, count, logarithmic), logarithmic })
    }
}

/// Numbers from one to another; the two ends are exact.
fn spaced(from: f64, to: f64, count: usize, logarithmic: bool) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1);
    let one = |index: usize| match index {
        0 => from,
        index if index == last => to,
        index => {
            let part = index as f64 / last as f64;
            if logarithmic { from * (to / from).powf(part) } else { from + part * (to - from) }
        }
    };
    (0..count).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_run_from_the_first_to_the_last() {
        let axis = Axis::parse("step=0.1:0.3:3").expect("an axis");
        assert_eq!((axis.key.as_str(), axis.values.len(), axis.logarithmic), ("step", 3, false));
        assert_eq!((axis.values[0], axis.values[2]), (0.1, 0.3));
        assert!((axis.values[1] - 0.2).abs() < 1e-15);
        let axis = Axis::parse("body.mass=1:100:3:log").expect("an axis");
        assert_eq!((axis.values[0], axis.values[2]), (1.0, 100.0));
        assert!((axis.values[1] - 10.0).abs() < 1e-13);
        assert_eq!(Axis::parse("duration=4:8:1").expect("an axis").values, [4.0]);
    }

    #[test]
    fn what_is_no_axis_is_refused_with_an_example() {
        for (text, word) in [
            ("step", "no '='"),
            ("step=1", "1 parts"),
            ("step=1:2", "2 parts"),
            ("step=1:2:x", "'x' is no count"),
            ("step=1:2:0", "'0' is no count"),
            ("step=a:2:3", "'a' is no finite number"),
            ("step=nan:2:3", "no finite number"),
            ("step=0:2:3:log", "above 0"),
            ("step=1:2:3:lin", "'lin' is no spacing"),
            ("step=2:2:3", "empty"),
        ] {
            let error = Axis::parse(text).expect_err(text);
            assert!(error.contains(word) && error.contains("key=from:to:n"), "{text}: {error}");
        }
    }
}
