//! Whether the body stays rigid.

use super::{Metric, Sight, read};

/// Largest change of a distance between points, over the extent of the body.
pub(super) const RIGIDITY: Metric = Metric {
    name: "rigidity",
    unit: "1",
    what: "largest change of a distance between body points over the extent of the body",
    measure: |sight: &Sight| read(sight, |state, _| Some(state.stretch)),
};
