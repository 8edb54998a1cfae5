//! The time derivative of a system, and room for the states it is asked at.

use super::problem::System;
use crate::scalar::{Computation, Scalar};
use core::mem::MaybeUninit;

/// The time derivative, as a function of its own: every stage of every method calls the one copy.
#[inline(always)]
pub(super) fn rate_of<P: System<S, N>, S: Scalar, const N: usize>(problem: &P, y: &[S; N]) -> [S; N] {
    let mut rate = Room::new();
    rate_into(problem, y, &mut rate);
    // SAFETY: all components were written.
    unsafe { *rate.read() }
}

/// The same, written into room for it.
#[inline(always)]
pub(super) fn rate_into<P: System<S, N>, S: Scalar, const N: usize>(
    problem: &P,
    y: &[S; N],
    rate: &mut Room<S, N>,
) {
    S::outline(Rate { problem, y, rate });
}

/// Room for a state that is written as a whole: an array that need not be filled first.
pub(super) struct Room<S, const N: usize>([MaybeUninit<S>; N]);

impl<S: Copy, const N: usize> Room<S, N> {
    #[inline(always)]
    pub(super) const fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; N])
    }
    #[inline(always)]
    pub(super) fn write(&mut self, n: usize, value: S) {
        self.0[n].write(value);
    }
    /// What was written.
    ///
    /// # Safety
    /// All of it must have been written.
    #[inline(always)]
    pub(super) unsafe fn read(&self) -> &[S; N] {
        // SAFETY: an array of written elements has the layout of the array of their values.
        unsafe { &*self.0.as_ptr().cast() }
    }
}

struct Rate<'a, P, S, const N: usize> {
    problem: &'a P,
    y: &'a [S; N],
    rate: &'a mut Room<S, N>,
}

impl<P: System<S, N>, S: Scalar, const N: usize> Computation for Rate<'_, P, S, N> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        let rate = self.problem.rhs(self.y);
        for n in 0..N {
            self.rate.write(n, rate[n]);
        }
    }
}
