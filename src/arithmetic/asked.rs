//! Rows in registers that a machine is asked for when the program runs.

use std::ops::{Add, Mul, Sub};

use pulp::{Simd, WithSimd};

use super::{Number, Row, Work};

/// A row in `R` registers that the machine was asked for when the program ran.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked<S: Simd, const R: usize> {
    simd: S,
    registers: [S::f64s; R],
}

macro_rules! lane_by_lane {
    ($($operator:ident::$method:ident by $instruction:ident),*) => {$(
        impl<S: Simd, const R: usize> $operator for Asked<S, R> {
            type Output = Asked<S, R>;

            #[inline(always)]
            fn $method(mut self, other: Asked<S, R>) -> Asked<S, R> {
                for i in 0..R {
                    self.registers[i] = self.simd.$instruction(self.registers[i], other.registers[i]);
                }
                self
            }
        }
    )*};
}

lane_by_lane!(Add::add by add_f64s, Sub::sub by sub_f64s, Mul::mul by mul_f64s);

impl<S: Simd, const R: usize> Mul<f64> for Asked<S, R> {
    type Output = Asked<S, R>;

    #[inline(always)]
    fn mul(self, factor: f64) -> Asked<S, R> {
        self * self.like(factor)
    }
}

impl<S: Simd, const R: usize> Number for Asked<S, R> {
    #[inline(always)]
    fn like(self, value: f64) -> Asked<S, R> {
        Asked::splat(self.simd, value)
    }

    #[inline(always)]
    fn larger(mut self, other: Asked<S, R>) -> Asked<S, R> {
        for i in 0..R {
            self.registers[i] = self.simd.max_f64s(self.registers[i], other.registers[i]);
        }
        self
    }
}

impl<S: Simd, const R: usize> Row for Asked<S, R> {
    type Scalar = f64;
    type Proof = S;
    type Chunk = [S::f64s; R];
    const COUNT: usize = R * S::F64_LANES;

    #[inline(always)]
    fn splat(simd: S, value: f64) -> Asked<S, R> {
        Asked { simd, registers: [simd.splat_f64s(value); R] }
    }

    #[inline(always)]
    fn chunks(values: &[f64]) -> &[[S::f64s; R]] {
        S::as_simd_f64s(values).0.as_chunks().0
    }

    #[inline(always)]
    fn chunks_mut(values: &mut [f64]) -> &mut [[S::f64s; R]] {
        S::as_mut_simd_f64s(values).0.as_chunks_mut().0
    }

    #[inline(always)]
    fn load(simd: S, chunk: &[S::f64s; R]) -> Asked<S, R> {
        Asked { simd, registers: *chunk }
    }

    #[inline(always)]
    fn store(self, chunk: &mut [S::f64s; R]) {
        *chunk = self.registers;
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        self.registers.into_iter().map(|one| self.simd.reduce_max_f64s(one)).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Work on rows of `R` registers.
pub(super) struct Asking<W, const R: usize>(pub(super) W);

impl<W: Work<f64>, const R: usize> WithSimd for Asking<W, R> {
    type Output = W::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> W::Output {
        self.0.with_rows::<Asked<S, R>>(simd)
    }
}
