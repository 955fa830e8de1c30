//! Cells of a map as an image inside an SVG: one element, however many cells there are.

use plotters::style::RGBColor;

use super::render::{Fault, encode};
use super::sketch::Place;

/// The cells as an SVG element.
pub(super) fn element(
    low: Place,
    high: Place,
    columns: usize,
    colours: &[RGBColor],
) -> Result<String, Fault> {
    let pixels: Vec<u8> =
        colours.iter().flat_map(|RGBColor(red, green, blue)| [*red, *green, *blue]).collect();
    let rows = colours.len() / columns.max(1);
    let bytes = encode(columns as u32, rows as u32, &pixels)?;
    Ok(format!(
        "<image x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" preserveAspectRatio=\"none\" \
         style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>",
        low.0,
        low.1,
        high.0 - low.0,
        high.1 - low.1,
        base64(&bytes)
    ))
}

/// Base64 with padding (RFC 4648, section 4).
pub(in crate::report) fn base64(bytes: &[u8]) -> String {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let bits = group.iter().fold(0, |bits, byte| bits << 8 | u32::from(*byte)) << (8 * (3 - group.len()));
        for place in 0..4 {
            let sextet = (bits >> (18 - 6 * place)) & 63;
            text.push(if place <= group.len() { char::from(ALPHABET[sextet as usize]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_rfc() {
        // The test vectors of RFC 4648, section 10.
        let expected = ["", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"];
        for (length, text) in expected.into_iter().enumerate() {
            assert_eq!(base64(&b"foobar"[..length]), text);
        }
    }
}
