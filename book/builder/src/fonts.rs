//! The fonts of the book, taken from the crate `typst-assets`: New Computer Modern for
//! formulas (GUST Font License), Libertinus for text (SIL Open Font License), DejaVu
//! for code (Bitstream Vera license).

use std::sync::LazyLock;
use ttf_parser::Face;

/// The fonts that the style sheet names, by their PostScript names.
const NAMES: [&str; 6] = [
    "NewCMMath-Book",
    "LibertinusSerif-Regular",
    "LibertinusSerif-Italic",
    "LibertinusSerif-Semibold",
    "LibertinusSerif-SemiboldItalic",
    "DejaVuSansMono",
];

/// The name that OpenType files with PostScript outlines carry in their CFF table, or
/// TrueType files in their naming table, as ASCII and ended by what cannot be in a name.
fn is_called(font: &[u8], name: &str) -> bool {
    let name = name.as_bytes();
    font.windows(name.len() + 1).any(|window| {
        window.starts_with(name)
            && !(window[name.len()].is_ascii_alphanumeric()
                && window[name.len()].is_ascii_lowercase()
                || window[name.len()] == b'-')
    })
}

/// The font called `name`.
fn font(name: &str) -> Result<&'static [u8], String> {
    typst_assets::fonts()
        .find(|font| is_called(font, name))
        .ok_or(format!("typst-assets has no font {name}"))
}

/// Each font's file name in the book, and its bytes.
///
/// # Errors
/// If the crate no longer has a font.
pub fn files() -> Result<Vec<(String, &'static [u8])>, String> {
    NAMES
        .iter()
        .map(|name| font(name).map(|font| (format!("{name}.otf"), font)))
        .collect()
}

/// How far right of a letter's middle the mathematics font attaches accents, in em.
pub fn skew(letter: char) -> Option<f64> {
    static MATHS: LazyLock<Option<Face<'static>>> =
        LazyLock::new(|| Face::parse(font(NAMES[0]).ok()?, 0).ok());
    let face = MATHS.as_ref()?;
    let glyph = face.glyph_index(letter)?;
    let glyphs = face.tables().math?.glyph_info?;
    let attached = glyphs.top_accent_attachments?.get(glyph)?.value;
    let middle = f64::from(face.glyph_hor_advance(glyph)?) / 2.0;
    Some((f64::from(attached) - middle) / f64::from(face.units_per_em()))
}
