//! One of the two that are compared: a scheme of a campaign, or a records file.

use std::sync::Arc;

use crate::record::{Drift, Measurement, Order, Records};

/// The rows of one side.
pub(super) struct Side {
    pub(super) name: String,
    pub(super) records: Records,
    /// The one scheme that is compared; any of a records file, by its own name.
    pub(super) scheme: Option<String>,
}

impl Side {
    pub(super) fn file(name: &str, records: Records) -> Side {
        Side { name: name.to_owned(), records, scheme: None }
    }

    pub(super) fn scheme(name: &str, records: Records) -> Side {
        Side { name: name.to_owned(), records, scheme: Some(name.to_owned()) }
    }

    /// Scenes and schemes in the order in which their rows stand.
    pub(super) fn places(&self) -> Vec<(&str, &str)> {
        let of_orders = self.records.orders.iter().map(|row| (row.scene.as_str(), row.scheme.as_str()));
        let of_runs = self.records.measurements.iter().map(|row| (row.scene.as_str(), row.scheme.as_str()));
        let mut places: Vec<(&str, &str)> = Vec::new();
        // Rows of one cell stand together, those of a scene that a scheme does not take between them.
        for place in of_runs.chain(of_orders) {
            let mine = self.scheme.as_deref().is_none_or(|own| own == place.1);
            if mine && !places.contains(&place) {
                places.push(place);
            }
        }
        places
    }

    pub(super) fn orders(&self, scene: &str, scheme: &str) -> Vec<&Order> {
        let rows = self.records.orders.iter();
        rows.filter(|row| row.scene == scene && row.scheme == scheme).collect()
    }

    pub(super) fn drifts(&self, scene: &str, scheme: &str) -> Vec<&Drift> {
        let rows = self.records.drifts.iter();
        rows.filter(|row| row.scene == scene && row.scheme == scheme).collect()
    }

    pub(super) fn runs(&self, scene: &str, scheme: &str) -> Vec<&Measurement> {
        let rows = self.records.measurements.iter().map(Arc::as_ref);
        rows.filter(|row| row.scene == scene && row.scheme == scheme).collect()
    }

    /// The order that a scheme claims, where the records say.
    pub(super) fn claimed_order(&self, scheme: &str) -> Option<u32> {
        self.records.schemes.iter().find(|row| row.name == scheme).map(|row| row.order)
    }
}
