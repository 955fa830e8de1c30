//! The typeface of the pictures, bundled so that a report needs nothing from the system: a subset of DejaVu Sans
//! (licence in src/report/font/LICENSE).

use std::sync::OnceLock;

use plotters::style::{FontStyle, register_font};

static REGULAR: &[u8] = include_bytes!("../font/DejaVuSans.ttf");
static BOLD: &[u8] = include_bytes!("../font/DejaVuSans-Bold.ttf");

/// The rasteriser's font size is ascent plus descent; DejaVu Sans has 1.164 of its em square.
pub(super) const HEIGHT_PER_EM: f64 = 1.164;

/// Makes the typeface known to plotters, once a process.
pub(super) fn register() -> Result<(), &'static str> {
    static RESULT: OnceLock<Result<(), &'static str>> = OnceLock::new();
    *RESULT.get_or_init(|| {
        let fault = |_| "the bundled typeface cannot be read";
        register_font("sans-serif", FontStyle::Normal, REGULAR).map_err(fault)?;
        register_font("sans-serif", FontStyle::Bold, BOLD).map_err(fault)
    })
}
