//! Times that are written as dates and times of day.

use std::time::UNIX_EPOCH;

/// Seconds since 1970 of `2024-05-01T12:00:00.5Z`, or since midnight of `12:00:00.5`; `None` where a cell is neither.
pub(super) fn moment(cell: &str) -> Option<f64> {
    if cell.contains('-') {
        // Without a zone a time is one of UTC: only differences count.
        let moment = humantime::parse_rfc3339_weak(cell).ok()?;
        return Some(moment.duration_since(UNIX_EPOCH).ok()?.as_secs_f64());
    }
    let mut parts = cell.split(':');
    let (hours, minutes, seconds) = (parts.next()?, parts.next()?, parts.next()?);
    let whole = |text: &str| text.parse::<u32>().ok().map(f64::from);
    let seconds = seconds.parse::<f64>().ok().filter(|seconds| (0.0..61.0).contains(seconds))?;
    (parts.next().is_none()).then_some(3600.0 * whole(hours)? + 60.0 * whole(minutes)? + seconds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_times_of_day_are_seconds() {
        assert_eq!(moment("1970-01-02T00:00:01.5Z"), Some(86_401.5));
        assert_eq!(moment("1970-01-02 00:00:01.5"), Some(86_401.5));
        assert_eq!(moment("01:02:03.25"), Some(3723.25));
        for wrong in
            ["-1", "1970-01-02", "1:2", "1:2:3:4", "a:b:c", "1:2:-3", "1:2:nan", "1969-01-01T00:00:00Z"]
        {
            assert_eq!(moment(wrong), None, "{wrong}");
        }
    }
}
