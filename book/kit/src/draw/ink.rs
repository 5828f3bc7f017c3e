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
    /// Runge-Kutta methods of order 4. The methods' inks are [`super::Method`]'s: a
    /// method has its ink, dash and marker from there, the same on every page.
    RungeKutta,
    /// Runge-Kutta of high order with a step of its own choice.
    Adaptive,
    /// Splittings into the exact flow and kicks.
    Splitting,
    /// Splittings for weak kicks.
    WeakKicks,
    /// Gauss-Legendre collocation.
    Gauss,
    /// Where less light falls on the ground: dark in both themes.
    Shadow,
}

/// One colour in both themes. Lines keep a contrast of 3 to 1 against the theme's
/// paper, text 4.5 to 1, but for paper and shadow.
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
    pub(crate) dark_line: u32,
    /// Text on dark paper.
    pub(crate) dark_text: u32,
}

const fn colour(ink: Ink, name: &'static str, light: [u32; 2], dark: [u32; 2]) -> Colour {
    Colour { ink, name, line: light[0], text: light[1], dark_line: dark[0], dark_text: dark[1] }
}

/// Every ink. The quantities after Okabe and Ito; the orange's lines and the text of most
/// are darker than theirs, which do not reach the contrast on white. The methods' five are
/// chosen to be told apart by those who see no red or no green.
pub const PALETTE: [Colour; 15] = [
    colour(Ink::Ink, "fig-ink", [0x1F2328; 2], [0xE6E3DD; 2]),
    colour(Ink::Frame, "fig-axis", [0x6B7076, 0x5F646A], [0x9BA1A8, 0xA8AEB5]),
    colour(Ink::Paper, "fig-paper", [0xFFFFFF; 2], [0x16191D; 2]),
    colour(Ink::Momentum, "fig-momentum", [0x0072B2; 2], [0x4FB0EA; 2]),
    colour(Ink::Velocity, "fig-rate", [0xD55E00, 0xB84E00], [0xF08A45; 2]),
    colour(Ink::Body, "fig-body", [0x009E73, 0x007A59], [0x34C495; 2]),
    colour(Ink::Force, "fig-torque", [0xCC79A7, 0xAD5186], [0xE29CC6; 2]),
    colour(Ink::Energy, "fig-energy", [0xC27C00, 0x8F5C00], [0xF0B030; 2]),
    colour(Ink::Wrong, "fig-wrong", [0xD55E00, 0xB84E00], [0xF08A45; 2]),
    colour(Ink::RungeKutta, "fig-runge-kutta", [0x85502A; 2], [0xC49A6C; 2]),
    colour(Ink::Adaptive, "fig-adaptive", [0x8C1D4F; 2], [0xE6508A; 2]),
    colour(Ink::Splitting, "fig-splitting", [0x6E7A00; 2], [0xD2DD60; 2]),
    colour(Ink::WeakKicks, "fig-weak-kicks", [0x00757D; 2], [0x5CCBD2; 2]),
    colour(Ink::Gauss, "fig-gauss", [0x5A3FC0; 2], [0xA08CFF; 2]),
    colour(Ink::Shadow, "fig-shadow", [0x1F2328; 2], [0x000000; 2]),
];

/// `percent` of `a` with the rest `b`, channel by channel.
fn mixture(a: u32, b: u32, percent: u32) -> u32 {
    let percent = percent.min(100);
    [16, 8, 0].into_iter().fold(0, |rgb, shift| {
        let channel = |c: u32| (c >> shift) & 255;
        rgb << 8 | ((channel(a) * percent + channel(b) * (100 - percent) + 50) / 100)
    })
}

impl Colour {
    /// A body of this colour in full light and in the shade, light theme or dark. In both
    /// themes what is lit is the lighter.
    fn body(&self, dark: bool) -> [u32; 2] {
        if dark {
            [mixture(self.dark_line, 0xFFFFFF, 86), mixture(self.dark_line, 0x000000, 30)]
        } else {
            [mixture(self.line, 0xFFFFFF, 14), mixture(self.line, 0x000000, 82)]
        }
    }
}

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

    /// The colour of a face with so many percent of light, in the light theme: for readers
    /// that do not know `color-mix`.
    pub(super) fn lit(self, light: u32) -> String {
        let [lit, shade] = self.colour().body(false);
        format!("#{:06X}", mixture(lit, shade, light))
    }

    /// The CSS colour of a face with so many percent of light.
    pub(super) fn lit_css(self, light: u32) -> String {
        let c = self.colour();
        let [lit, shade] = c.body(false);
        format!(
            "color-mix(in srgb,var(--{0}-lit,#{lit:06X}) {light}%,var(--{0}-shade,#{shade:06X}))",
            c.name
        )
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
            let (line, text) = if dark { (c.dark_line, c.dark_text) } else { (c.line, c.text) };
            let [lit, shade] = c.body(dark);
            format!(
                "--{0}: #{line:06X};\n--{0}-text: #{text:06X};\n\
                 --{0}-lit: #{lit:06X};\n--{0}-shade: #{shade:06X};\n",
                c.name
            )
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rotation_dynamics::math::pow;

    /// Red, green and blue as amounts of light, 0 to 1.
    fn linear(rgb: u32) -> [f64; 3] {
        [16, 8, 0].map(|shift| {
            let c = f64::from((rgb >> shift) & 255) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { pow((c + 0.055) / 1.055, 2.4) }
        })
    }

    fn luminance(rgb: u32) -> f64 {
        let [r, g, b] = linear(rgb);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// Contrast of two colours after WCAG 2.1, 1 to 21.
    fn contrast(a: u32, b: u32) -> f64 {
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        if a > b { a / b } else { b / a }
    }

    /// The inks of which lines and letters are drawn.
    fn drawn() -> impl Iterator<Item = &'static Colour> {
        PALETTE.iter().filter(|c| !matches!(c.ink, Ink::Paper | Ink::Shadow))
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
        for c in drawn() {
            lines =
                lines.min(contrast(c.line, paper.line)).min(contrast(c.dark_line, paper.dark_line));
            texts =
                texts.min(contrast(c.text, paper.line)).min(contrast(c.dark_text, paper.dark_line));
        }
        assert!((3.0..3.1).contains(&lines), "weakest line {lines}");
        assert!((4.5..4.9).contains(&texts), "weakest text {texts}");
        // The damaged twin: the orange as Okabe and Ito have it fails as a line.
        assert!(contrast(0xE69F00, paper.line) < 2.3);
    }

    #[test]
    fn a_lit_face_is_lighter_than_one_in_the_shade_in_both_themes() {
        let mut seen = 0;
        for c in drawn() {
            for dark in [false, true] {
                let [lit, shade] = c.body(dark);
                assert!(contrast(lit, shade) > 1.6, "{} {dark}", c.name);
                assert!(luminance(lit) > luminance(shade), "{} {dark}", c.name);
                seen += 1;
            }
        }
        assert_eq!(seen, 26);
    }

    /// The colour as seen without red cones or without green ones (Machado, Oliveira and
    /// Fernandes, 2009), in CIE Lab.
    fn seen(rgb: u32, cones: [[f64; 3]; 3]) -> [f64; 3] {
        let light = linear(rgb);
        let [r, g, b] =
            cones.map(|row| (0..3).map(|i| row[i] * light[i]).sum::<f64>().clamp(0.0, 1.0));
        let f = |t: f64| {
            if t > 0.008856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 }
        };
        let x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
        let y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
        let z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    const FULL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    const NO_RED: [[f64; 3]; 3] = [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ];
    const NO_GREEN: [[f64; 3]; 3] = [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ];

    fn apart(a: u32, b: u32) -> f64 {
        let distance = |cones| {
            let (a, b) = (seen(a, cones), seen(b, cones));
            (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
        };
        [FULL, NO_RED, NO_GREEN].map(distance).into_iter().fold(f64::INFINITY, f64::min)
    }

    /// Measured: the least distance of two inks of methods is 18.
    #[test]
    fn methods_are_told_apart_without_red_or_green() {
        let inks =
            [Ink::Ink, Ink::RungeKutta, Ink::Adaptive, Ink::Splitting, Ink::WeakKicks, Ink::Gauss];
        let (mut least, mut pairs) = (f64::INFINITY, 0);
        for (i, a) in inks.iter().enumerate() {
            for b in &inks[..i] {
                let (a, b) = (a.colour(), b.colour());
                least = least.min(apart(a.line, b.line)).min(apart(a.dark_line, b.dark_line));
                pairs += 1;
            }
        }
        assert_eq!(pairs, 15);
        assert!((15.0..25.0).contains(&least), "{least}");
        // The damaged twin: the inks of quantities could not serve, orange and olive are one.
        assert!(apart(0xC27C00, 0x7F8A00) < 2.0);
    }
}
