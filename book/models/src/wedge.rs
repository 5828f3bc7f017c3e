//! A round body on the slope of a wedge, in three dimensions.

use core::f64::consts::FRAC_PI_2;
use kit::draw::{Camera, Ink, Side, Solid, View};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

const ACROSS: SpaceVector = SpaceVector::new(0.0, 1.0, 0.0);
const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// A slope that rises to the right at `angle` (rad) over this length, and the radius of the body.
#[derive(Debug, Clone, Copy)]
pub struct Wedge {
    pub angle: f64,
    pub length: f64,
    pub radius: f64,
}

impl Wedge {
    /// The unit vectors up the slope and off it.
    pub fn directions(&self) -> [SpaceVector; 2] {
        let (s, c) = sincos(self.angle);
        [SpaceVector::new(c, 0.0, s), SpaceVector::new(-s, 0.0, c)]
    }

    /// How far the view reaches: all of the slope is seen, with the body at its top.
    fn reach(&self) -> f64 {
        let (s, c) = sincos(self.angle);
        (0.44 * self.length * c).max(0.58 * self.length * s + 1.6 * self.radius)
    }

    /// The length at which a force as large as the weight is drawn.
    pub fn force(&self) -> f64 {
        0.42 * self.reach()
    }

    /// From the middle of the body to the face that is seen: vectors lie before it.
    pub fn front(&self) -> SpaceVector {
        ACROSS * (-0.86 * self.radius)
    }

    /// The cylinder whose place of contact is so far up the slope, turned by `turn` (rad, as wheels
    /// roll up), its weight, and what the slope does to it: push and friction over the weight, the
    /// friction three times as long.
    pub fn with_body(&self, way: f64, turn: f64, [push, rub]: [f64; 2]) -> View {
        let ([up, off], (length, r)) = (self.directions(), (self.length, self.radius));
        let contact = up * way;
        let middle = contact + off * r;
        let (half, near, far) = (ACROSS * (0.8 * r), self.front() * 0.99, ACROSS * (2.6 * r));
        let (foot, top) = (SpaceVector::zero(), up * length);
        let under = SpaceVector::new(top.x(), 0.0, 0.0);
        // Its front and its back; the slope itself is ground.
        let wedge = Solid::new([
            vec![foot + near, under + near, top + near],
            vec![under + near, under + far, top + far, top + near],
        ]);
        let (s, c) = sincos(self.angle + FRAC_PI_2 + turn);
        let (at, touch, size) = (middle + self.front(), contact + self.front(), self.force());
        let view = View::of(top * 0.5 + off * (0.5 * r), self.reach())
            .camera(Camera::new(-FRAC_PI_2 - 0.32, 0.26))
            .size(340, 250)
            .slope((top + near + far) * 0.5, top * 0.5, (far - near) * 0.5)
            .solid(wedge, Ink::Frame)
            .solid(Solid::cylinder(middle - half, middle + half, r), Ink::Body)
            .line([at, at + SpaceVector::new(c, 0.0, s) * r], Ink::Paper)
            .arrow(at, at - UP * size, Ink::Force, "$mg$", Side::Below)
            .arrow(touch, touch + off * (push * size), Ink::Force, "$N$", Side::Above);
        let tip = touch + up * (3.0 * rub * size);
        view.only_if(rub.abs() > 0.04, |view| {
            view.arrow(touch, tip, Ink::Force, "$F$", Side::BelowRight)
        })
    }
}
