//! Polhode: a verification and benchmark harness for rigid-body time-stepping schemes.
//!
//! The [`guide`] says how to gate a scheme of your own, how to write a scene and how to read the records; the [`prelude`] has what
//! that needs. The feature `cli`, on by default, adds the program and [`write_report`]; without it the crate is a library for tests.
//!
//! ```text
//! scene ──► system (body + forces, the least model that the scene needs)
//!              │
//! scheme ──► simulate ──► trajectory ──► measure ──► records (JSON, CSV)
//!              ▲                            ▲           │
//! engine, log ─┘    reference, at any time ─┘           ├──► gates ──► verdicts ──► exit code, JUnit
//!                                                       └──► report ──► PNG, HTML, Markdown
//! ```
//!
//! Modules stand in the order of dependency; a test reads their `use` lines and fails on any edge that goes the
//! other way.

#![cfg_attr(
    not(feature = "cli"),
    allow(dead_code, unused_imports, reason = "the rooms also serve the program, which is not built")
)]

mod interrupt;
mod journal;
mod words;
mod bounded;
mod fault;
mod quantity;
mod claim;
mod arithmetic;
mod rotation;
pub mod record;
pub mod model;
mod ode;
pub mod schemes;
pub mod reference;
pub mod scenes;
pub mod simulate;
pub mod measure;
pub mod gates;
mod study;
#[cfg(feature = "cli")]
mod engine;
pub mod campaign;
mod assertion;
#[cfg(feature = "cli")]
mod inspect;
#[cfg(feature = "cli")]
mod log;
#[cfg(feature = "cli")]
mod self_test;
#[cfg(feature = "cli")]
mod report;
#[cfg(feature = "cli")]
mod cli;

pub mod prelude;
pub mod guide;

pub use assertion::{assert_order, assert_order_in, assert_order_in_body_axes};
#[cfg(feature = "cli")]
pub use report::{ReportError, write_report};

/// What the program, the benches and the tests of this repository use besides: no promise, it changes without notice.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod internals {
    pub use crate::cli::main;

    macro_rules! rooms {
        ($($room:ident),*) => {
            $(pub mod $room {
                pub use crate::$room::*;
            })*
        };
    }

    rooms!(arithmetic, engine, inspect, log, ode, report, rotation, self_test, study);

    pub mod campaign {
        pub use crate::campaign::cell::setting;
        pub use crate::campaign::*;
    }

    pub mod gates {
        pub use crate::gates::baseline::{Constants, OfScene};
        pub use crate::gates::reference::judge_reference;
        pub use crate::gates::*;
    }

    pub mod schemes {
        pub mod dormand_prince_8 {
            pub use crate::schemes::dormand_prince_8::*;
        }
        pub mod taylor {
            pub use crate::schemes::taylor::*;
        }
    }

    pub mod measure {
        pub use crate::measure::climb::*;
        pub use crate::measure::copies::*;
        pub use crate::measure::drift::*;
        pub use crate::measure::flips::*;
        pub use crate::measure::invariance::*;
        pub use crate::measure::ladder::*;
        pub use crate::measure::order::*;
        pub use crate::measure::points::*;
        pub use crate::measure::reversal::*;
        pub use crate::measure::symplecticity::*;
        pub use crate::measure::*;
        pub use crate::model::copies::*;
    }

    pub mod model {
        pub use crate::model::change::Change;
        pub use crate::model::free::{Free, FreeRates};
        pub use crate::model::system::AnyModel;
        pub use crate::model::*;
        pub mod retold {
            pub use crate::model::retold::*;
        }
    }

    pub mod reference {
        pub use crate::reference::stored::{Stored, StoredError};
        pub use crate::reference::*;
        pub mod closed {
            pub use crate::reference::closed::*;
        }
        pub mod precise {
            pub use crate::reference::precise::*;
        }
        pub mod stored {
            pub use crate::reference::stored::*;
        }
    }

    pub mod scenes {
        pub use crate::scenes::*;
        pub mod random {
            pub use crate::scenes::random::*;
        }
    }
}
