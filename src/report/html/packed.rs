//! Data inside a page: JSON, compressed, as text that a script tag can hold.

use minijinja::Value;
use miniz_oxide::deflate::compress_to_vec_zlib;
use serde::Serialize;

use crate::report::plot::base64;

/// Level of compression: above 8 a page is made ten times slower for 1 % less.
const LEVEL: u8 = 8;

/// Data as zlib in base 64: no letter of it ends a script tag.
pub(super) fn packed(data: &impl Serialize) -> Result<Value, minijinja::Error> {
    let fault = |error: serde_json::Error| {
        minijinja::Error::new(minijinja::ErrorKind::BadSerialization, error.to_string())
    };
    let json = serde_json::to_vec(data).map_err(fault)?;
    Ok(Value::from_safe_string(base64(&compress_to_vec_zlib(&json, LEVEL))))
}
