//! A time that is none gives no place.
