//! Angular momentum against the reference's, magnitude and direction apart.

use super::{Metric, Sight, read, scale};
use crate::rotation;

/// (|L| − |L_ref|) / max |L_ref|.
pub(super) const MAGNITUDE: Metric = Metric {
    name: "angular-momentum-magnitude",
    unit: "1",
    what: "| |L| - |L_ref| | over the largest |L_ref|",
    measure: |sight: &Sight| {
        let largest = scale(sight, |s| rotation::length(&s.angular_momentum))?;
        read(sight, |state, truth| {
            Some(
                (rotation::length(&state.angular_momentum) - rotation::length(&truth.angular_momentum))
                    / largest,
            )
        })
    },
};

/// The angle between L and L_ref.
pub(super) const DIRECTION: Metric = Metric {
    name: "angular-momentum-direction",
    unit: "rad",
    what: "angle between L and L_ref",
    measure: |sight: &Sight| {
        scale(sight, |s| rotation::length(&s.angular_momentum))?;
        read(sight, |state, truth| {
            Some(rotation::angle_between_directions(&state.angular_momentum, &truth.angular_momentum))
        })
    },
};
