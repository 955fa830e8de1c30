//! Numbers as files have them: rounded, left out where they are 0, and `null` where they are not finite.

/// Whether a count is 0, and so left out of a file.
pub(super) fn is_nothing(count: &u64) -> bool {
    *count == 0
}

/// A number that may be infinite or none: `null` in files, and infinite when read.
pub(super) mod or_infinite {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        value.is_finite().then_some(*value).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
    }
}

/// A number to so many significant digits.
pub fn to_digits(value: f64, digits: usize) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
