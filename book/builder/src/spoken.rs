//! Formulas as text that can be read in a line and searched for: `\ddot\theta = W^2 \sin\theta`
//! becomes `theta'' = W^2 sin theta`. It stands in the search index only.

/// Commands with an argument that is kept without a mark.
const PLAIN: [&str; 13] = [
    "mathrm",
    "mathcal",
    "text",
    "mathbf",
    "boldsymbol",
    "operatorname",
    "vec",
    "hat",
    "bar",
    "tilde",
    "overline",
    "mathit",
    "boxed",
];
/// Commands and what stands for them; the empty ones only arrange.
const WORDS: [(&str, &str); 30] = [
    ("approx", "="),
    ("times", "x"),
    ("cdot", " "),
    ("le", "<="),
    ("leq", "<="),
    ("ge", ">="),
    ("geq", ">="),
    ("ne", "!="),
    ("to", "->"),
    ("rightarrow", "->"),
    ("infty", "infinity"),
    ("qquad", "; "),
    ("quad", "; "),
    ("left", ""),
    ("right", ""),
    ("big", ""),
    ("Big", ""),
    ("bigl", ""),
    ("bigr", ""),
    ("Bigl", ""),
    ("Bigr", ""),
    ("displaystyle", ""),
    ("limits", ""),
    ("dots", "..."),
    ("ldots", "..."),
    ("cdots", "..."),
    ("int", "integral"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("pm", "+-"),
];

/// The formula as text.
pub fn text(tex: &str) -> String {
    let mut reader = Reader { rest: tex };
    let spoken = reader.until(None);
    let words: Vec<&str> = spoken.split_whitespace().collect();
    let mut spoken = words.join(" ");
    let tight = [(" )", ")"), ("( ", "("), (" ;", ";"), (" ,", ","), (" _", "_"), (" ^", "^")];
    for (from, to) in tight {
        spoken = spoken.replace(from, to);
    }
    spoken
}

struct Reader<'t> {
    rest: &'t str,
}

impl Reader<'_> {
    /// Everything up to `end`, which is taken too, or to the end of the formula.
    fn until(&mut self, end: Option<char>) -> String {
        let mut spoken = String::new();
        while let Some(c) = self.rest.chars().next() {
            if Some(c) == end {
                self.rest = &self.rest[c.len_utf8()..];
                break;
            }
            let one = self.one();
            // Letters of different commands are different words.
            let parts = one.len() > 1 && one.starts_with(|c: char| c.is_alphabetic());
            if parts && spoken.ends_with(|c: char| c.is_alphanumeric()) {
                spoken.push(' ');
            }
            spoken += &one;
        }
        spoken
    }

    /// The next symbol, group or command.
    fn one(&mut self) -> String {
        let Some(c) = self.rest.chars().next() else {
            return String::new();
        };
        self.rest = &self.rest[c.len_utf8()..];
        match c {
            '{' => self.until(Some('}')),
            '\\' => self.command(),
            '_' | '^' => {
                let argument = self.argument();
                match argument.as_str() {
                    "'" | "" => argument,
                    _ if argument.chars().all(|c| c.is_alphanumeric()) => format!("{c}{argument} "),
                    _ => format!("{c}({argument}) "),
                }
            }
            '&' | '~' => " ".into(),
            '=' | '<' | '>' | '+' => format!(" {c} "),
            '-' => " - ".into(),
            c => c.into(),
        }
    }

    /// The argument of a command.
    fn argument(&mut self) -> String {
        self.rest = self.rest.trim_start();
        self.one().trim().to_owned()
    }

    fn command(&mut self) -> String {
        let end = self.rest.find(|c: char| !c.is_ascii_alphabetic());
        let (name, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        if name.is_empty() {
            // `\,` and the like are spaces, `\\` ends a line, `\{` is a brace.
            let c = rest.chars().next().unwrap_or(' ');
            self.rest = rest.get(c.len_utf8()..).unwrap_or("");
            return match c {
                '\\' => "; ".into(),
                '{' | '}' | '|' | '%' => c.into(),
                _ => " ".into(),
            };
        }
        match name {
            "begin" | "end" | "tag" | "label" => {
                self.argument();
                String::new()
            }
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (self.argument(), self.argument());
                format!("{}/{} ", whole(&above), whole(&below))
            }
            "sqrt" => format!("sqrt({}) ", self.argument()),
            "dot" => self.argument() + "'",
            "ddot" => self.argument() + "''",
            "tilde" | "widetilde" => self.argument() + "~",
            name if PLAIN.contains(&name) => self.argument(),
            name => match WORDS.iter().find(|(command, _)| *command == name) {
                Some((_, word)) => format!(" {word} "),
                None => format!("{name} "),
            },
        }
    }
}

/// In brackets, if it has more than one part.
fn whole(part: &str) -> String {
    match part.contains([' ', '+', '-', '/']) {
        true => format!("({part})"),
        false => part.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_can_be_read_and_found() {
        let cases = [
            (r"\ddot\theta = W^2 \sin\theta", "theta'' = W^2 sin theta"),
            (r"\cos\theta_r = \tfrac{2}{3}\cos\theta_0", "cos theta_r = 2/3 cos theta_0"),
            (
                r"\dot\theta^2 = \frac{3g}{l}\,(\cos\theta_0 - \cos\theta)",
                "theta'^2 = 3g/l (cos theta_0 - cos theta)",
            ),
            (r"t \approx 2\pi\sqrt{l/g}", "t = 2 pi sqrt(l/g)"),
            (r"E &= 1 \\ x &\to 0", "E = 1; x -> 0"),
            (r"N_\text{wall} \ge 0", "N_wall >= 0"),
            (r"\mathcal L = T - U", "L = T - U"),
        ];
        for (tex, spoken) in cases {
            assert_eq!(text(tex), spoken, "{tex}");
        }
        // A formula that is not closed ends where it ends.
        assert_eq!(text(r"\frac{1"), "1/");
    }
}
