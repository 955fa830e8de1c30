//! What the author of a scheme needs, and a test of it: `use polhode::prelude::*;`.

#[doc(no_inline)]
pub use crate::arithmetic::Real;
#[doc(no_inline)]
pub use crate::assertion::{assert_order, assert_order_in, assert_order_in_body_axes};
pub use crate::campaign::{Campaign, Survey};
pub use crate::model::{Broken, Model, Quantity, Rates, Snapshot, System, Turning};
pub use crate::record::{Records, Ruling, Verdict};
#[cfg(feature = "cli")]
#[doc(no_inline)]
pub use crate::report::write_report;
pub use crate::scenes::Scene;
pub use crate::schemes::{Card, Claim, EnergyOfFreeBody, Scheme, Step, TurningScheme, When, Workspace};
pub use crate::simulate::{Contestant, Form, Plan};
