//! Needles, discs, near spheres and plates cost what a motion asks for, not what a moment does.
