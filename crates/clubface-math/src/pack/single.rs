//! What packs without derivatives have in common.

/// Packs that are themselves a quad.
macro_rules! single_quad {
    () => {
        type Quad = Self;
        #[inline(always)]
        fn quad(self, _which: usize) -> Self {
            self
        }
        #[inline(always)]
        unsafe fn read_quads(at: [*const f64; 2], stride: usize) -> Self {
            // SAFETY: the caller's promise.
            unsafe { Self::read_parts(at[0], stride) }
        }
    };
}

/// Plain packs that are themselves a quad.
macro_rules! single_four {
    () => {
        type Four = Self;
        #[inline(always)]
        fn four(self, _which: usize) -> Self {
            self
        }
    };
}

/// Packs without derivatives: one part, one pass.
macro_rules! single_part {
    ($type:ty) => {
        impl Part<$type> for $type {
            #[inline(always)]
            fn from_pack(pack: &Self, _pass: usize) -> Self {
                *pack
            }
            #[inline(always)]
            fn places(_pass: usize) -> [usize; 2] {
                [0, 0]
            }
            #[inline(always)]
            unsafe fn coefficient(value: *const f64, _derivative: *const f64) -> Self {
                // SAFETY: the caller's promise.
                unsafe { Self::read(value) }
            }
            #[inline(always)]
            fn into_value(self) -> Self {
                self
            }
            #[inline(always)]
            fn from_value(value: Self) -> Self {
                value
            }
        }
    };
}

/// What these store.
macro_rules! single_storage {
    () => {
        type Value = Self;
        type Pair = Self;
        #[inline(always)]
        fn part(self, _which: usize) -> Self {
            self
        }
        #[inline(always)]
        fn set_part(&mut self, _which: usize, part: Self) {
            *self = part;
        }
        #[inline(always)]
        unsafe fn read_parts(at: *const f64, _stride: usize) -> Self {
            // SAFETY: the caller's promise.
            unsafe { Self::read(at) }
        }
        #[inline(always)]
        unsafe fn write_parts(self, at: *mut f64, _stride: usize) {
            // SAFETY: the caller's promise.
            unsafe { self.write(at) };
        }
    };
}
pub(super) use {single_four, single_part, single_quad, single_storage};
