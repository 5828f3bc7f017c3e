//! A display list as words of 32 bits, for a painter in another language.

use super::display::{Anchor, Dash, Display, Place, Shape, Text};

/// Little-endian words, one after the other.
struct Words(Vec<u8>);

impl Words {
    fn int(&mut self, value: i32) {
        self.0.extend(value.to_le_bytes());
    }

    fn count(&mut self, value: usize) {
        // No drawing has 2^31 of anything.
        self.int(i32::try_from(value).unwrap_or(i32::MAX));
    }

    fn real(&mut self, value: f64) {
        self.0.extend((value as f32).to_le_bytes());
    }

    fn places(&mut self, places: &[Place]) {
        self.count(places.len());
        for &(x, y) in places {
            self.int(x);
            self.int(y);
        }
    }

    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Line(points, closed, stroke) => {
                self.int(0);
                self.int(stroke.ink as i32);
                self.int(i32::from(*closed));
                self.int(match stroke.dash {
                    Dash::Solid => 0,
                    Dash::Dashed => 1,
                    Dash::Dotted => 2,
                });
                self.real(stroke.width);
                self.real(stroke.opacity);
                self.places(points);
            }
            Shape::Area(points, ink, opacity) => {
                self.int(1);
                self.int(*ink as i32);
                self.real(*opacity);
                self.places(points);
            }
            Shape::Face(points, ink, light) => {
                self.int(2);
                self.int(*ink as i32);
                self.count(*light as usize);
                self.places(points);
            }
            Shape::Dot((x, y), radius, ink, ring) => {
                self.int(3);
                self.int(*ink as i32);
                self.int(i32::from(*ring));
                self.real(*radius);
                self.int(*x);
                self.int(*y);
            }
        }
    }

    fn text(&mut self, text: &Text) {
        self.int(text.at.0);
        self.int(text.at.1);
        self.int(match text.anchor {
            Anchor::Start => 0,
            Anchor::Middle => 1,
            Anchor::End => 2,
        });
        self.int(text.ink as i32);
        self.int(i32::from(text.halo));
        self.count(text.runs.len());
        for run in &text.runs {
            self.int(i32::from(run.slanted));
            self.real(run.size);
            self.real(run.drop);
            self.count(run.text.len());
            self.0.extend(run.text.bytes());
            self.0.resize(self.0.len().next_multiple_of(4), 0);
        }
    }
}

impl Display {
    /// The list in little-endian words of 32 bits, whole numbers unless `f32` is said. Places
    /// are hundredths of a px, an ink is its place in [`PALETTE`](super::PALETTE).
    ///
    /// | what | words |
    /// |---|---|
    /// | the list | width, height (px), count of shapes, count of texts, the shapes, the texts |
    /// | a line | 0, ink, closed, dash (0 solid, 1 dashed, 2 dotted), `f32` width, `f32` opacity, *places* |
    /// | an area | 1, ink, `f32` opacity, *places* |
    /// | a face | 2, ink, light in percent, *places* |
    /// | a dot | 3, ink, ring, `f32` radius, x, y |
    /// | *places* | count, then x, y of each |
    /// | a text | x, y, anchor (0 start, 1 middle, 2 end), ink, halo, count of runs, the runs |
    /// | a run | slanted, `f32` size, `f32` drop, count of bytes, the bytes of UTF-8, filled up to whole words |
    pub fn encoded(&self) -> Vec<u8> {
        let mut words = Words(Vec::new());
        words.count(self.size.0 as usize);
        words.count(self.size.1 as usize);
        words.count(self.shapes.len());
        words.count(self.texts.len());
        for shape in &self.shapes {
            words.shape(shape);
        }
        for text in &self.texts {
            words.text(text);
        }
        words.0
    }
}

#[cfg(test)]
mod tests {
    use crate::draw::{Ink, Side, Sketch};

    #[test]
    fn a_list_is_words() -> crate::Result<()> {
        let figure = Sketch::new("clock", "the hand of a clock points to the right")
            .window((-1.0, 1.0), (-1.0, 1.0))
            .disc((0.0, 0.0), 0.5, Ink::Body, 0.3)
            .arrow((0.0, 0.0), (1.0, 0.0), Ink::Force, "$F_é$", Side::Right)
            .figure()?;
        let bytes = figure.display.encoded();
        assert_eq!(bytes.len() % 4, 0);
        let word = |n: usize| i32::from_le_bytes([0, 1, 2, 3].map(|k| bytes[4 * n + k]));
        let (width, height) = figure.display.size;
        assert_eq!([word(0), word(1)], [width as i32, height as i32]);
        let counts = [figure.display.shapes.len(), figure.display.texts.len()];
        assert_eq!([word(2), word(3)], counts.map(|n| n as i32));
        // The end of the list is a letter of two bytes, filled up to a word.
        assert_eq!(&bytes[bytes.len() - 4..], [0xC3, 0xA9, 0, 0]);
        assert_eq!(word(bytes.len() / 4 - 2), 2);
        Ok(())
    }
}
