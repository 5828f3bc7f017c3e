//! What a page prepares once for its parameters.

use std::sync::{Arc, Mutex, PoisonError};

/// Something that takes long to compute from parameters, kept for those who ask again: a
/// page's report and its figures are called one after the other with the same ones. What was
/// asked for first is kept too: a reader comes back to a page's own parameters.
///
/// ```
/// use kit::Prepared;
/// static SQUARES: Prepared<u32, Vec<u32>> = Prepared::new();
/// fn squared(n: &u32) -> kit::Result<Vec<u32>> {
///     Ok((0..*n).map(|i| i * i).collect())
/// }
/// let squares = |n: &u32| SQUARES.get(n, squared);
/// let first = squares(&4)?;
/// assert_eq!((first[3], squares(&5)?.len()), (9, 5));
/// assert!(std::sync::Arc::ptr_eq(&first, &squares(&4)?));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug)]
pub struct Prepared<P, T>(Mutex<Vec<(P, Arc<T>)>>);

impl<P: PartialEq + Clone, T> Prepared<P, T> {
    /// Nothing yet.
    pub const fn new() -> Self {
        Self(Mutex::new(Vec::new()))
    }

    /// What belongs to these parameters: as it was made, first or last, or made now.
    ///
    /// # Errors
    /// Those of `make`; then nothing changes.
    pub fn get<E>(
        &self,
        parameters: &P,
        make: impl FnOnce(&P) -> Result<T, E>,
    ) -> Result<Arc<T>, E> {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, made)) = kept.iter().find(|(of, _)| of == parameters) {
            return Ok(Arc::clone(made));
        }
        let made = Arc::new(make(parameters)?);
        kept.truncate(1);
        kept.push((parameters.clone(), Arc::clone(&made)));
        Ok(made)
    }
}

impl<P: PartialEq + Clone, T> Default for Prepared<P, T> {
    fn default() -> Self {
        Self::new()
    }
}
