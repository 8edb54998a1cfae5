//! A slice of which every task of a stage uses an element of its own.

/// A slice whose elements are used by different threads at the same time, each element by one of them.
pub(super) struct SharedSlice<T> {
    start: *mut T,
    pub(super) count: usize,
}

// SAFETY: users of `get` promise that no two threads use the same element at the same time.
unsafe impl<T: Send> Sync for SharedSlice<T> {}

impl<T> SharedSlice<T> {
    pub(super) fn new(values: &mut [T]) -> Self {
        Self { start: values.as_mut_ptr(), count: values.len() }
    }
    pub(super) fn as_ptr(&self) -> *const T {
        self.start
    }
    /// # Safety
    /// Nobody else uses this element at the same time, and the slice is still there.
    #[allow(clippy::mut_from_ref)]
    pub(super) unsafe fn get(&self, index: usize) -> &mut T {
        assert!(index < self.count);
        // SAFETY: the caller's promise.
        unsafe { &mut *self.start.add(index) }
    }
}
