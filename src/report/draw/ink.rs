//! The palette: a colour has one meaning in the whole book.

/// What a colour stands for. In a figure each is a CSS variable with the light
/// theme's colour as fallback; [`PALETTE`] has the dark counterparts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    /// Text, axes, exact solutions.
    Ink,
    /// The vertical, space axes, construction lines: ink at 60 %.
    Frame,
    /// The background.
    Paper,
    /// Angular momentum.
    Momentum,
    /// Angular velocity.
    Velocity,
    /// The body axis e3 and whatever is fixed in the body.
    Body,
    /// Torque and force.
    Force,
    /// Energy and potential.
    Energy,
    /// A naive method or an erratum; draw it dashed and say so in its label.
    Wrong,
}

/// One colour in both themes. Lines keep a contrast of 3 to 1 against the theme's
/// paper, text 4.5 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour {
    /// Which ink.
    pub ink: Ink,
    /// The CSS variable of its lines, without the leading dashes; `NAME-text` is the one of its text.
    pub name: &'static str,
    /// Lines on light paper, `0xRRGGBB`.
    pub line: u32,
    /// Text on light paper.
    pub text: u32,
    /// Lines on dark paper.
    pub dark_line: u32,
    /// Text on dark paper.
    pub dark_text: u32,
}

const fn colour(ink: Ink, name: &'static str, light: [u32; 2], dark: [u32; 2]) -> Colour {
    Colour {
        ink,
        name,
        line: light[0],
        text: light[1],
        dark_line: dark[0],
        dark_text: dark[1],
    }
}

/// Every ink. After Okabe and Ito; the orange's lines and the text of most are
/// darker than theirs, which do not reach the contrast on white.
pub const PALETTE: [Colour; 9] = [
    colour(Ink::Ink, "fig-ink", [0x1F2328; 2], [0xE6E3DD; 2]),
    colour(
        Ink::Frame,
        "fig-axis",
        [0x6B7076, 0x5F646A],
        [0x9BA1A8, 0xA8AEB5],
    ),
    colour(Ink::Paper, "fig-paper", [0xFFFFFF; 2], [0x16191D; 2]),
    colour(Ink::Momentum, "fig-momentum", [0x0072B2; 2], [0x4FB0EA; 2]),
    colour(
        Ink::Velocity,
        "fig-rate",
        [0xD55E00, 0xB84E00],
        [0xF08A45; 2],
    ),
    colour(Ink::Body, "fig-body", [0x009E73, 0x007A59], [0x34C495; 2]),
    colour(
        Ink::Force,
        "fig-torque",
        [0xCC79A7, 0xAD5186],
        [0xE29CC6; 2],
    ),
    colour(
        Ink::Energy,
        "fig-energy",
        [0xC27C00, 0x8F5C00],
        [0xF0B030; 2],
    ),
    colour(Ink::Wrong, "fig-wrong", [0xD55E00, 0xB84E00], [0xF08A45; 2]),
];

impl Ink {
    /// Its entry in [`PALETTE`].
    pub fn colour(self) -> Colour {
        PALETTE[self as usize]
    }

    /// The CSS colour of its lines and areas.
    pub(super) fn line(self) -> String {
        let c = self.colour();
        format!("var(--{},#{:06X})", c.name, c.line)
    }

    /// So many percent of it on light paper, for readers that do not know `color-mix`.
    pub(super) fn mixed(self, percent: u32) -> String {
        let percent = percent.min(100);
        let (ink, paper) = (self.colour().line, Ink::Paper.colour().line);
        let channel = |shift: u32| {
            let (a, b) = ((ink >> shift) & 255, (paper >> shift) & 255);
            (a * percent + b * (100 - percent) + 50) / 100
        };
        format!("#{:02X}{:02X}{:02X}", channel(16), channel(8), channel(0))
    }

    /// The CSS colour of its text.
    pub(super) fn text(self) -> String {
        let c = self.colour();
        // A page that sets only the colour of lines still gets text of its theme.
        format!("var(--{0}-text,var(--{0},#{1:06X}))", c.name, c.text)
    }
}

/// The variables of the light or of the dark theme as CSS declarations, one per line.
pub fn css_variables(dark: bool) -> String {
    PALETTE
        .iter()
        .map(|c| {
            let (line, text) = if dark {
                (c.dark_line, c.dark_text)
            } else {
                (c.line, c.text)
            };
            format!("--{0}: #{line:06X};\n--{0}-text: #{text:06X};\n", c.name)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pow;

    /// Contrast of two colours after WCAG 2.1, 1 to 21.
    fn contrast(a: u32, b: u32) -> f64 {
        let luminance = |rgb: u32| -> f64 {
            let channel = |shift: u32| {
                let c = f64::from((rgb >> shift) & 255) / 255.0;
                if c <= 0.04045 {
                    c / 12.92
                } else {
                    pow((c + 0.055) / 1.055, 2.4)
                }
            };
            0.2126 * channel(16) + 0.7152 * channel(8) + 0.0722 * channel(0)
        };
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        if a > b { a / b } else { b / a }
    }

    #[test]
    fn entries_stand_at_their_own_place() {
        for (i, c) in PALETTE.iter().enumerate() {
            assert_eq!(c.ink as usize, i);
        }
    }

    /// Measured: the weakest line 3.06, the weakest text 4.89, both the torque on white.
    #[test]
    fn contrast_is_enough_in_both_themes() {
        let paper = Ink::Paper.colour();
        let (mut lines, mut texts) = (21.0_f64, 21.0_f64);
        for c in PALETTE.iter().filter(|c| c.ink != Ink::Paper) {
            lines = lines
                .min(contrast(c.line, paper.line))
                .min(contrast(c.dark_line, paper.dark_line));
            texts = texts
                .min(contrast(c.text, paper.line))
                .min(contrast(c.dark_text, paper.dark_line));
        }
        assert!((3.0..3.1).contains(&lines), "weakest line {lines}");
        assert!((4.5..4.9).contains(&texts), "weakest text {texts}");
        // The damaged twin: the orange as Okabe and Ito have it fails as a line.
        assert!(contrast(0xE69F00, paper.line) < 2.3);
    }
}
