//! Data inside a page: JSON, compressed, as text that a script tag can hold.

use minijinja::Value;
use miniz_oxide::deflate::compress_to_vec_zlib;
use serde::Serialize;

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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

/// Bytes in base 64 (RFC 4648).
pub(super) fn base64(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let at = |index: usize| u32::from(three.get(index).copied().unwrap_or(0));
        let word = at(0) << 16 | at(1) << 8 | at(2);
        for digit in 0..4 {
            let letter = DIGITS[(word >> (18 - 6 * digit)) as usize % 64];
            text.push(if digit > three.len() { '=' } else { char::from(letter) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64_is_that_of_the_rfc() {
        let texts = [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")];
        for (bytes, text) in texts {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
