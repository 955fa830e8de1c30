//! Rows in the registers that every machine of a target has.

use std::ops::{Add, Mul, Sub};

use wide::f64x4;

use super::{Number, Row};

/// A row in registers that every machine of the target has: pairs (SSE2, NEON), two at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Common<const R: usize>([f64x4; R]);

macro_rules! lane_by_lane {
    ($($operator:ident::$method:ident),*) => {$(
        impl<const R: usize> $operator for Common<R> {
            type Output = Common<R>;

            #[inline(always)]
            fn $method(mut self, other: Common<R>) -> Common<R> {
                for i in 0..R {
                    self.0[i] = self.0[i].$method(other.0[i]);
                }
                self
            }
        }
    )*};
}

lane_by_lane!(Add::add, Sub::sub, Mul::mul);

impl<const R: usize> Mul<f64> for Common<R> {
    type Output = Common<R>;

    #[inline(always)]
    fn mul(self, factor: f64) -> Common<R> {
        self * self.like(factor)
    }
}

impl<const R: usize> Number for Common<R> {
    #[inline(always)]
    fn like(self, value: f64) -> Common<R> {
        Common::splat((), value)
    }

    #[inline(always)]
    fn larger(mut self, other: Common<R>) -> Common<R> {
        for i in 0..R {
            self.0[i] = self.0[i].fast_max(other.0[i]);
        }
        self
    }
}

/// Numbers of one register of [`Common`].
const QUAD: usize = 4;

impl<const R: usize> Row for Common<R> {
    type Scalar = f64;
    type Proof = ();
    type Chunk = [[f64; QUAD]; R];
    const COUNT: usize = R * QUAD;

    #[inline(always)]
    fn splat(_: (), value: f64) -> Common<R> {
        Common([f64x4::splat(value); R])
    }

    #[inline(always)]
    fn chunks(values: &[f64]) -> &[[[f64; QUAD]; R]] {
        values.as_chunks().0.as_chunks().0
    }

    #[inline(always)]
    fn chunks_mut(values: &mut [f64]) -> &mut [[[f64; QUAD]; R]] {
        values.as_chunks_mut().0.as_chunks_mut().0
    }

    #[inline(always)]
    fn load(_: (), chunk: &[[f64; QUAD]; R]) -> Common<R> {
        Common(chunk.map(f64x4::new))
    }

    #[inline(always)]
    fn store(self, chunk: &mut [[f64; QUAD]; R]) {
        *chunk = self.0.map(f64x4::to_array);
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        self.0.into_iter().flat_map(f64x4::to_array).fold(f64::NEG_INFINITY, f64::max)
    }
}
