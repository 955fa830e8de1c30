//! What formulas are written in that run on one body and on many at once: a number, or a row of them.
//!
//! A formula over [`Number`] takes the same sums and products in the same order for `f64` and for every lane of
//! a [`Row`], without fused ones, so that many bodies side by side give the numbers of one alone to the last bit, whatever
//! the width of the registers.

#[cfg(all(target_arch = "x86_64", feature = "cli"))]
mod asked;
mod analysis;
mod common;
mod double_double;
mod field;
mod real;
pub mod series;
mod single;
#[cfg(feature = "cli")]
mod timed;

use std::ops::{Add, Mul, Sub};

#[cfg(all(target_arch = "x86_64", feature = "cli"))]
use pulp::Simd;
#[cfg(all(target_arch = "x86_64", feature = "cli"))]
use pulp::x86::{V3, V4};

#[cfg(all(target_arch = "x86_64", feature = "cli"))]
use asked::Asking;
use common::Common;
pub use double_double::DoubleDouble;
pub use real::Real;
pub use single::Single;
#[cfg(feature = "cli")]
pub use timed::{Latencies, Timed, operations};

/// Sums and products.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self>
{
    /// A constant, of the kind of this number.
    fn like(self, value: f64) -> Self;

    /// The larger of two, lane by lane; either where one is NaN.
    fn larger(self, other: Self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn like(self, value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn larger(self, other: f64) -> f64 {
        self.max(other)
    }
}

/// Numbers side by side, one of each body.
pub trait Row: Number {
    /// The number of a lane.
    type Scalar: Real;

    /// Proof that the machine has the registers that they stand in.
    type Proof: Copy;

    /// How many.
    const COUNT: usize;

    /// The same in every lane.
    fn splat(proof: Self::Proof, value: Self::Scalar) -> Self;

    /// [`COUNT`](Row::COUNT) numbers in memory, as they are loaded and stored.
    type Chunk: Copy;

    /// Numbers by the row; those left over at the end are none.
    fn chunks(values: &[Self::Scalar]) -> &[Self::Chunk];

    /// The same, to be written to.
    fn chunks_mut(values: &mut [Self::Scalar]) -> &mut [Self::Chunk];

    /// A number a lane.
    fn load(proof: Self::Proof, chunk: &Self::Chunk) -> Self;

    /// Writes every lane.
    fn store(self, chunk: &mut Self::Chunk);

    /// The largest; NaN counts as none.
    fn largest(self) -> Self::Scalar;
}

/// The registers of this machine.
#[derive(Clone, Copy, Debug)]
pub struct Registers(Width);

#[derive(Clone, Copy, Debug)]
enum Width {
    /// Eight numbers each.
    #[cfg(all(target_arch = "x86_64", feature = "cli"))]
    Avx512(V4),
    /// Four.
    #[cfg(all(target_arch = "x86_64", feature = "cli"))]
    Avx2(V3),
    /// Two: what every machine has that this program was built for.
    Common,
}

/// Work on rows of numbers.
pub trait Work<T: Real> {
    /// What comes of it.
    type Output;

    /// Does it with rows of this kind.
    fn with_rows<R: Row<Scalar = T>>(self, proof: R::Proof) -> Self::Output;
}

impl Registers {
    /// The widest that the machine has.
    pub fn widest() -> Registers {
        Registers::all().pop().unwrap_or(Registers(Width::Common))
    }

    /// All that the machine has, the narrowest first.
    pub fn all() -> Vec<Registers> {
        #[cfg(all(target_arch = "x86_64", feature = "cli"))]
        let asked = [V3::try_new().map(Width::Avx2), V4::try_new().map(Width::Avx512)];
        #[cfg(not(all(target_arch = "x86_64", feature = "cli")))]
        let asked: [Option<Width>; 0] = [];
        std::iter::once(Width::Common).chain(asked.into_iter().flatten()).map(Registers).collect()
    }

    /// What they are called.
    pub fn name(self) -> &'static str {
        match self.0 {
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx512(_) => "AVX-512",
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx2(_) => "AVX2",
            Width::Common if cfg!(target_arch = "x86_64") => "SSE2",
            Width::Common => "common",
        }
    }

    /// Does work with rows of two registers, so that one computes while the other waits.
    #[inline(always)]
    pub fn by_two<W: Work<f64>>(self, work: W) -> W::Output {
        match self.0 {
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx512(eight) => Simd::vectorize(eight, Asking::<W, 2>(work)),
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx2(four) => Simd::vectorize(four, Asking::<W, 2>(work)),
            Width::Common => work.with_rows::<Common<1>>(()),
        }
    }

    /// Does work that holds many rows at a time: rows of two registers where the machine has thirty-two, of one where it has sixteen.
    #[inline(always)]
    pub fn by_fitting<W: Work<f64>>(self, work: W) -> W::Output {
        match self.0 {
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx512(eight) => Simd::vectorize(eight, Asking::<W, 2>(work)),
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx2(four) => Simd::vectorize(four, Asking::<W, 1>(work)),
            Width::Common => work.with_rows::<Common<1>>(()),
        }
    }

    /// Does work with rows of eight numbers, as many registers as that takes.
    #[inline(always)]
    pub fn by_eight<W: Work<f64>>(self, work: W) -> W::Output {
        match self.0 {
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx512(eight) => Simd::vectorize(eight, Asking::<W, 1>(work)),
            #[cfg(all(target_arch = "x86_64", feature = "cli"))]
            Width::Avx2(four) => Simd::vectorize(four, Asking::<W, 2>(work)),
            Width::Common => work.with_rows::<Common<2>>(()),
        }
    }
}
