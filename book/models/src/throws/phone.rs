//! A phone in flight, drawn: the page's own throw, and one that was recorded.

use super::Thrown;
use kit::draw::{Camera, Ink, Side, Solid, View};
use kit::{MovingPicture, Result};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::{BodyVector, SpaceVector};

/// From behind the thrower's right shoulder: away from the hand is to the right and back, the
/// thrower's right is to the right and in front.
pub fn camera() -> Camera {
    Camera::new(-2.3, 0.5)
}

/// A phone of this length, width and thickness about `centre`: its screen dark, with a light strip at
/// its lower end, and on its back a camera. Its axes: 1 along the long edge, 2 along the short one, 3 out
/// of the back.
pub fn phone(
    view: View,
    [length, width, thickness]: [f64; 3],
    attitude: &Attitude,
    centre: SpaceVector,
) -> View {
    // A thinner one could not be told from a sheet.
    let lengths = [length, width, thickness.max(0.05 * length)];
    let axis = |i: usize| BodyVector::from_array([0, 1, 2].map(|k| f64::from(u8::from(k == i))));
    let edges = [0, 1, 2].map(|i| attitude.to_space(axis(i)) * lengths[i]);
    // The screen is on the side -3; in percent of light it is dark in both themes.
    let (phone, screen) = ((centre, edges), 8);
    view.solid(Solid::cuboid(centre, edges), Ink::Body)
        .patch_on(phone, (2, -1.04), [[-0.95, 0.95], [-0.9, 0.9]], Ink::Ink, screen)
        .patch_on(phone, (2, -1.08), [[-0.87, -0.84], [-0.3, 0.3]], Ink::Paper, 100)
        .patch_on(phone, (2, 1.04), [[0.5, 0.88], [-0.78, -0.1]], Ink::Ink, screen)
        .patch_on(phone, (2, 1.08), [[0.73, 0.84], [-0.68, -0.46]], Ink::Paper, 100)
        .patch_on(phone, (2, 1.08), [[0.54, 0.65], [-0.68, -0.46]], Ink::Paper, 100)
}

impl Thrown {
    /// The throw once more, by a phone of this length, width and thickness, with its rates below. Where it
    /// was thrown to is not recorded: as it leaves the hand it lies flat, screen up.
    ///
    /// # Errors
    /// Those of the fit and of the drawings.
    pub fn again(self, lengths: [f64; 3], gravity: f64) -> Result<MovingPicture> {
        let (length, end) = (lengths[0], self.duration());
        // The sensor's axes x, y, z in space at the start; the drawing's 1, 2, 3 on x, y, z.
        let start = Attitude::from_matrix([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])?;
        let edges = Attitude::from_matrix([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])?;
        let momentum = BodyVector::from(self.momentum().to_array());
        let momentum = start.to_space(momentum) * (0.72 * length);
        let rise = 0.125 * gravity * end * end;
        // The height is drawn reduced, so that the phone is large.
        let reduced = 0.1_f64.min(0.38 * length / rise);
        let middle = SpaceVector::new(0.0, 0.0, 0.5 * reduced * rise);
        MovingPicture::above(self.rates_panel()?, 0.0..=end, [0.0, 0.5 * end, end], move |t| {
            let attitude = start * self.turned(t)? * edges;
            let centre = SpaceVector::new(0.0, 0.0, reduced * 0.5 * gravity * t * (end - t));
            let up = attitude.to_space(BodyVector::new(0.0, 0.0, -1.0)).z() > 0.0;
            let looks = if up { "up" } else { "down" };
            let alt = format!(
                "The recorded phone {t:.2} s after it has left the hand; its screen looks {looks}. L stays where it \
                 is. Below, its three rates against time, samples as dots on the fitted curves."
            );
            let view = View::of(middle, 0.92 * length).camera(camera()).size(340, 220);
            let view = phone(view, lengths, &attitude, centre);
            Ok((alt, view.vector(centre, centre + momentum, Ink::Momentum, "$L$", Side::Below)))
        })
    }
}
