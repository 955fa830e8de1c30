//! Closed forms meet the double-double series, to a few rounding units for every radian turned.

mod any_body;
mod found;
mod known;
mod points;
mod sources;
mod tops;
