//! Moments that cancel: a body about a distant point and back, rods and plates that are turned.
