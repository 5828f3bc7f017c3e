//! A scene seen from elsewhere: readers who turn a moving picture with their finger.
//!
//! What draws a frame makes its views deep within; so that each need not pass a camera on,
//! the turn lies beside them while one frame is drawn, on one thread, and nowhere else.

use super::solid::Camera;
use core::cell::Cell;
use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::math::atan2;

/// By how much the eye is moved: to the right about the vertical, and upwards (rad).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turn {
    /// About the vertical.
    pub about: f64,
    /// Upwards; no farther than to where it looks straight down or up.
    pub up: f64,
}

thread_local! {
    static TURN: Cell<Turn> = const { Cell::new(Turn { about: 0.0, up: 0.0 }) };
    static SEEN: Cell<bool> = const { Cell::new(false) };
}

/// What `draw` draws with every camera turned, and whether there was one.
pub(crate) fn turned<T>(turn: Turn, draw: impl FnOnce() -> T) -> (T, bool) {
    /// Puts things back, also if `draw` panics.
    struct Back(Turn, bool);
    impl Drop for Back {
        fn drop(&mut self) {
            TURN.set(self.0);
            SEEN.set(self.1);
        }
    }
    let _back = Back(TURN.replace(turn), SEEN.replace(false));
    let drawn = draw();
    (drawn, SEEN.get())
}

impl Camera {
    /// As the reader turned it; the same bits if nobody did.
    pub(super) fn as_turned(self) -> Self {
        SEEN.set(true);
        let turn = TURN.get();
        if turn == Turn::default() {
            return self;
        }
        let azimuth = atan2(-self.right.x(), self.right.y());
        let elevation = atan2(self.eye.z(), self.up.z());
        let raised = (elevation + turn.up).clamp(-FRAC_PI_2, FRAC_PI_2);
        Self::new(azimuth + turn.about, raised)
    }
}
