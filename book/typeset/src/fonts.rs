//! The book's fonts, as the theme ships them: which characters they have, and where the
//! mathematics font attaches accents. `book/builder/fonts/subset.py` makes the files.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId, RawFaceTables};

macro_rules! shipped {
    ($($name:literal),*) => {
        [$(($name, include_bytes!(concat!("../../theme/fonts/", $name, ".woff2")))),*]
    };
}

/// The files of `book/theme/fonts`, without `.woff2`.
static FILES: [(&str, &[u8]); 6] =
    shipped!("serif", "serif-italic", "serif-semibold", "serif-semibold-italic", "maths", "mono");

/// The fonts that every page needs: they are asked for with the page.
pub const FIRST: [&str; 4] = ["serif", "serif-italic", "serif-semibold", "maths"];

/// What the style sheet sets in a font of the book.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// Text; also what the reader's own sans serif lacks.
    Serif,
    /// Formulas.
    Maths,
    /// Code.
    Mono,
}

impl Family {
    /// Whether `c` is in every style of the family, or in the mathematics font, which the style
    /// sheet names behind the others.
    pub fn covers(self, c: char) -> bool {
        let all = |family: &str| {
            let mut styles = FACES.iter().filter(|(name, _)| name.starts_with(family));
            styles.all(|(_, face)| face.as_ref().is_some_and(|f| f.glyph_index(c).is_some()))
        };
        all("maths")
            || match self {
                Self::Serif => all("serif"),
                Self::Maths => false,
                Self::Mono => all("mono"),
            }
    }
}

static FACES: LazyLock<Vec<(&str, Option<Face<'static>>)>> = LazyLock::new(|| {
    FILES.iter().map(|(name, file)| (*name, unpacked(file).as_ref().and_then(face))).collect()
});

/// The tables that are read here, by their names.
type Tables = BTreeMap<[u8; 4], &'static [u8]>;

fn face(tables: &Tables) -> Option<Face<'static>> {
    let get = |name: &[u8; 4]| tables.get(name).copied();
    let raw = RawFaceTables {
        head: get(b"head")?,
        hhea: get(b"hhea")?,
        maxp: get(b"maxp")?,
        cmap: get(b"cmap"),
        hmtx: get(b"hmtx"),
        math: get(b"MATH"),
        ..RawFaceTables::default()
    };
    Face::from_raw_tables(raw).ok()
}

/// The tables of a WOFF2 file that are kept as they are. The format: W3C, WOFF File Format 2.0,
/// sections 4 and 5.
fn unpacked(file: &[u8]) -> Option<Tables> {
    /// The first of the names that WOFF2 numbers, as far as they are read.
    const KNOWN: [&[u8; 4]; 12] = [
        b"cmap", b"head", b"hhea", b"hmtx", b"maxp", b"name", b"OS/2", b"post", b"cvt ", b"fpgm",
        b"glyf", b"loca",
    ];
    const MATH: usize = 31;
    const HEADER: usize = 48;
    let short = |at: usize| Some(u16::from_be_bytes(file.get(at..at + 2)?.try_into().ok()?));
    let long = |at: usize| Some(u32::from_be_bytes(file.get(at..at + 4)?.try_into().ok()?));
    if file.get(..4)? != b"wOF2" {
        return None;
    }
    let mut at = HEADER;
    let number = |at: &mut usize| {
        let mut value = 0_usize;
        loop {
            let byte = *file.get(*at)?;
            *at += 1;
            value = value << 7 | usize::from(byte & 0x7f);
            if byte & 0x80 == 0 {
                return Some(value);
            }
        }
    };
    let mut lengths = Vec::new();
    for _ in 0..short(12)? {
        let flags = *file.get(at)?;
        at += 1;
        let index = usize::from(flags & 0x3f);
        let name: Cow<[u8]> = match index {
            0x3f => {
                at += 4;
                Cow::Borrowed(file.get(at - 4..at)?)
            }
            MATH => Cow::Borrowed(b"MATH"),
            known => Cow::Borrowed(KNOWN.get(known).map_or(b"----", |name| *name)),
        };
        let outlines = matches!(&*name, b"glyf" | b"loca");
        let changed = (flags >> 6 != 0) != outlines;
        let mut length = number(&mut at)?;
        if changed {
            length = number(&mut at)?;
        }
        lengths.push((<[u8; 4]>::try_from(&*name).ok()?, changed, length));
    }
    let packed = file.get(at..at + long(20)? as usize)?;
    let mut data = Vec::new();
    brotli_decompressor::BrotliDecompress(&mut &*packed, &mut data).ok()?;
    // The fonts are read once and stay.
    let data: &'static [u8] = data.leak();
    let mut tables = Tables::new();
    let mut from = 0;
    for (name, changed, length) in lengths {
        let table = data.get(from..from + length)?;
        if !changed {
            tables.insert(name, table);
        }
        from += length;
    }
    Some(tables)
}

/// How far right of a letter's middle the mathematics font attaches accents, in em.
pub fn skew(letter: char) -> Option<f64> {
    let (face, glyph) = glyph(letter)?;
    let glyphs = face.tables().math?.glyph_info?;
    let attached = glyphs.top_accent_attachments?.get(glyph)?.value;
    let middle = f64::from(face.glyph_hor_advance(glyph)?) / 2.0;
    Some((f64::from(attached) - middle) / f64::from(face.units_per_em()))
}

/// How far a slanted letter of the mathematics font leans out of its width, in em.
pub fn overhang(letter: char) -> Option<f64> {
    let (face, glyph) = glyph(letter)?;
    let glyphs = face.tables().math?.glyph_info?;
    let corrected = glyphs.italic_corrections?.get(glyph)?.value;
    Some(f64::from(corrected) / f64::from(face.units_per_em()))
}

fn glyph(letter: char) -> Option<(&'static Face<'static>, GlyphId)> {
    let (_, face) = FACES.iter().find(|(name, _)| *name == "maths")?;
    let face = face.as_ref()?;
    Some((face, face.glyph_index(letter)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a first visit may load, in bytes.
    const MOST: usize = 250_000;

    #[test]
    fn the_fonts_are_read_and_light() {
        assert_eq!(FACES.iter().filter(|(_, face)| face.is_some()).count(), 6);
        let total: usize = FILES.iter().map(|(_, file)| file.len()).sum();
        assert!(total <= MOST, "{total}"); // 168724
        // The damaged twin: the fonts that were not cut down had 3.1 MB.
        assert!(unpacked(&FILES[0].1[1..]).is_none());
        let mut half = FILES[0].1.to_vec();
        half.truncate(total / 20);
        assert!(unpacked(&half).is_none());
    }

    #[test]
    fn each_family_has_its_characters_and_no_others() {
        let cases = [
            (Family::Serif, "Ač\u{3c6}\u{2032}\u{2212}\u{21a9}", "\u{2500}\u{6f22}"),
            (Family::Maths, "\u{1d711}\u{1d714}\u{2112}\u{221a}\u{2061}", "č\u{2500}\u{6f22}"),
            (Family::Mono, "\u{2500}\u{3b8}~", "\u{6f22}"),
        ];
        for (family, has, lacks) in cases {
            let found: String = has.chars().filter(|&c| family.covers(c)).collect();
            assert_eq!(found, has, "{family:?}");
            let found: String = lacks.chars().filter(|&c| family.covers(c)).collect();
            assert_eq!(found, "", "{family:?}");
        }
    }
}
