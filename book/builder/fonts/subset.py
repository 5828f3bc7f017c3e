"""Makes the book's fonts: subsets of three free families, as WOFF2, under names of their own.

    pip install fonttools brotli
    python book/builder/fonts/subset.py DIRECTORY

DIRECTORY holds the sources; the crate typst-assets 0.15.1 has them in files/fonts. Only
who changes the repertoire runs this: the results are kept in book/theme/fonts, and the
builder checks that they cover every page.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont
from fontTools.ttLib.tables import otTables

HERE = Path(__file__).parent
TARGET = HERE.parent.parent / "theme" / "fonts"

# Latin with names from all of Europe, Greek, punctuation, raised and lowered digits, arrows, operators.
TEXT = [
    (0x20, 0x7E), (0xA0, 0xFF), (0x106, 0x107), (0x10C, 0x10D), (0x118, 0x11B), (0x131, 0x131),
    (0x141, 0x144), (0x150, 0x153), (0x158, 0x161), (0x17D, 0x17E), (0x2C6, 0x2C7),
    (0x2D9, 0x2DC), (0x300, 0x304), (0x307, 0x308), (0x391, 0x3A9), (0x3B1, 0x3C9),
    (0x2009, 0x200A), (0x2010, 0x2015), (0x2018, 0x201E), (0x2020, 0x2022), (0x2026, 0x2026),
    (0x202F, 0x2030), (0x2032, 0x2033), (0x2070, 0x2070), (0x2074, 0x207B), (0x2080, 0x208E),
    (0x2190, 0x2194), (0x21A9, 0x21AA), (0x21D2, 0x21D2), (0x2202, 0x2202), (0x2206, 0x2208),
    (0x2211, 0x2213), (0x2215, 0x2215), (0x221A, 0x221A), (0x221E, 0x221E), (0x2225, 0x2225),
    (0x222B, 0x222B), (0x223C, 0x223C), (0x2248, 0x2248), (0x2260, 0x2261), (0x2264, 0x2265),
    (0x226A, 0x226B), (0x22A5, 0x22A5), (0x22C5, 0x22C5), (0xFB01, 0xFB02),
]
# A formula's text is the serif's; its letters are upright, slanted and bold. What stretches weighs
# most, and every reader carries it: the delimiters, roots, bars and accents that the pages use.
MATHS = [
    (0x20, 0x7E), (0xA0, 0xA0), (0xA8, 0xA8), (0xAF, 0xB1), (0xB4, 0xB5), (0xB7, 0xB7), (0xD7, 0xD7), (0xF7, 0xF7),
    (0x131, 0x131), (0x237, 0x237), (0x2C6, 0x2C7), (0x2D8, 0x2DA), (0x2DC, 0x2DC), (0x300, 0x308),
    (0x391, 0x3A9), (0x3B1, 0x3C9), (0x3D1, 0x3D1), (0x3D5, 0x3D6), (0x3F1, 0x3F1), (0x3F5, 0x3F5),
    (0x2002, 0x200A), (0x2010, 0x2014), (0x2016, 0x2016), (0x2020, 0x2022), (0x2026, 0x2026), (0x202F, 0x202F),
    (0x2032, 0x2034), (0x2061, 0x2064), (0x20D7, 0x20D7), (0x210E, 0x210F), (0x2112, 0x2113), (0x211D, 0x211D),
    (0x2190, 0x2194), (0x21A9, 0x21AA), (0x21D2, 0x21D2), (0x21D4, 0x21D4), (0x2200, 0x2200), (0x2202, 0x2203),
    (0x2206, 0x2209), (0x2211, 0x2213), (0x2215, 0x221A), (0x221D, 0x221E), (0x2220, 0x2220), (0x2225, 0x222B),
    (0x222E, 0x222E), (0x223C, 0x223C), (0x2243, 0x2243), (0x2245, 0x2245), (0x2248, 0x2248), (0x2254, 0x2254),
    (0x2260, 0x2261), (0x2264, 0x2265), (0x226A, 0x226B), (0x2295, 0x2299), (0x22A5, 0x22A5), (0x22C5, 0x22C5),
    (0x22EE, 0x22EF), (0x25A0, 0x25A1), (0x25CB, 0x25CF), (0x27E8, 0x27E9), (0x1D400, 0x1D467), (0x1D493, 0x1D493),
    (0x1D6A8, 0x1D6C1), (0x1D6E2, 0x1D71B), (0x1D736, 0x1D755),
]
# What programs and their comments need beside ASCII.
CODE = [
    (0x20, 0x7E), (0xA0, 0xFF), (0x391, 0x3A9), (0x3B1, 0x3C9), (0x2009, 0x200A), (0x2010, 0x2015), (0x2018, 0x201E),
    (0x2026, 0x2026), (0x202F, 0x202F), (0x2032, 0x2033), (0x2070, 0x2070), (0x2074, 0x207B), (0x2080, 0x208E),
    (0x2190, 0x2194), (0x2202, 0x2202), (0x2206, 0x2208), (0x2211, 0x2213), (0x221A, 0x221A), (0x221E, 0x221E),
    (0x2248, 0x2248), (0x2260, 0x2261), (0x2264, 0x2265), (0x22C5, 0x22C5), (0x2500, 0x2500), (0x2502, 0x2502),
    (0x2514, 0x2514), (0x251C, 0x251C),
]

READING = ["ccmp", "liga", "kern", "mark"]
# The MATH table brings its own variants; "ssty" (for scripts) would double the size.
SETTING = ["dtls"]

# File, source, family, style, repertoire, features. Hints would weigh a fifth of the text's fonts.
FONTS = [
    ("serif", "LibertinusSerif-Regular.otf", "Book Serif", "Regular", TEXT, READING),
    ("serif-italic", "LibertinusSerif-Italic.otf", "Book Serif", "Italic", TEXT, READING),
    ("serif-semibold", "LibertinusSerif-Semibold.otf", "Book Serif", "Semibold", TEXT, READING),
    ("serif-semibold-italic", "LibertinusSerif-SemiboldItalic.otf", "Book Serif", "Semibold Italic", TEXT, READING),
    ("maths", "NewCMMath-Book.otf", "Book Maths", "Regular", MATHS, SETTING),
    ("mono", "DejaVuSansMono.ttf", "Book Mono", "Regular", CODE, []),
]


# Where accents stand that the family gives no place to, in units of the font: on letters, whose dot
# would lie inside of them, and under the circumflex of slanted capitals.
ON_LETTERS = {
    "serif": {"θ": (245, 885), "ζ": (232, 885), "ψ": (315, 842)},
    "serif-italic": {"θ": (365, 885), "ζ": (407, 885), "ψ": (450, 885)},
}
UNDER_MARKS = {"serif-italic": {"circumflex.cap": (-6, 684)}}


def anchored(font, name):
    """Gives these letters and marks their places, in the table that has the dot above."""
    cmap, order = font.getBestCmap(), font.getReverseGlyphMap()

    def anchor(x, y):
        place = otTables.Anchor()
        place.Format, place.XCoordinate, place.YCoordinate = 1, x, y
        return place

    tables = [table for lookup in font["GPOS"].table.LookupList.Lookup for table in lookup.SubTable]
    [table] = [t for t in tables if t.LookupType == 4 and cmap[0x307] in t.MarkCoverage.glyphs]
    marks = dict(zip(table.MarkCoverage.glyphs, table.MarkArray.MarkRecord))
    bases = dict(zip(table.BaseCoverage.glyphs, table.BaseArray.BaseRecord))
    kind = marks[cmap[0x307]].Class
    for letter, place in ON_LETTERS.get(name, {}).items():
        record = otTables.BaseRecord()
        record.BaseAnchor = [anchor(*place) if c == kind else None for c in range(table.ClassCount)]
        bases[cmap[ord(letter)]] = record
    for glyph, place in UNDER_MARKS.get(name, {}).items():
        record = otTables.MarkRecord()
        record.Class, record.MarkAnchor = kind, anchor(*place)
        marks[glyph] = record
    table.MarkCoverage.glyphs = sorted(marks, key=order.get)
    table.MarkArray.MarkRecord = [marks[glyph] for glyph in table.MarkCoverage.glyphs]
    table.BaseCoverage.glyphs = sorted(bases, key=order.get)
    table.BaseArray.BaseRecord = [bases[glyph] for glyph in table.BaseCoverage.glyphs]


def named(font, family, style):
    """Gives the subset a name of its own; copyright and the licence's address stay as they are.
    (LICENSES.txt has its text.)"""
    names = font["name"]
    origin = names.getDebugName(4)
    version = names.getDebugName(5)
    names.names = [record for record in names.names if record.nameID in (0, 14)]
    postscript = f"{family}-{style}".replace(" ", "")
    own = {
        1: family,
        2: style,
        3: f"{postscript} of {origin} {version}",
        4: f"{family} {style}",
        5: version,
        6: postscript,
        10: f"A subset of {origin}",
    }
    for number, text in own.items():
        names.setName(text, number, 3, 1, 0x409)
    if "CFF " in font:
        cff = font["CFF "].cff
        cff.fontNames = [postscript]
        top = cff.topDictIndex[0]
        top.FullName, top.FamilyName = f"{family} {style}", family


def main(sources):
    total = 0
    for name, source, family, style, repertoire, features in FONTS:
        font = TTFont(Path(sources) / source)
        options = subset.Options()
        options.layout_features = features
        options.hinting = False
        # Brotli finds what outlines share better than the subroutines of CFF tell it.
        options.desubroutinize = True
        options.notdef_outline = True
        options.name_IDs = ["*"]
        options.drop_tables += ["FFTM", "PfEd", "GlyphOrder"]
        subsetter = subset.Subsetter(options)
        subsetter.populate(unicodes=[c for first, last in repertoire for c in range(first, last + 1)])
        subsetter.subset(font)
        named(font, family, style)
        if name in ON_LETTERS:
            anchored(font, name)
        font.flavor = "woff2"
        file = TARGET / f"{name}.woff2"
        font.save(file)
        total += file.stat().st_size
        print(f"{file.name:28} {file.stat().st_size:7}  {len(font.getBestCmap())} characters")
    print(f"{'together':28} {total:7}")


if __name__ == "__main__":
    main(sys.argv[1])
