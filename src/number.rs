//! What formulas are written in that run on one body and on many at once: a number, or a row of them.
//!
//! A formula over [`Number`] takes the same sums and products in the same order for `f64` and for every lane of
//! [`Lanes`], without fused ones, so that many bodies side by side give the numbers of one alone to the last bit, whatever
//! the width of the registers.

use std::ops::{Add, Mul, Sub};

use pulp::{Arch, Scalar, Simd, WithSimd};

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

/// Numbers side by side, one of each body: `R` registers of whatever width the machine has.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Simd, const R: usize> {
    simd: S,
    registers: [S::f64s; R],
}

impl<S: Simd, const R: usize> Lanes<S, R> {
    /// How many.
    pub const COUNT: usize = R * S::F64_LANES;

    /// The same in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f64) -> Lanes<S, R> {
        Lanes { simd, registers: [simd.splat_f64s(value); R] }
    }

    /// One number a lane; lanes beyond the end of `values` hold zero.
    #[inline(always)]
    pub fn load(simd: S, values: &[f64]) -> Lanes<S, R> {
        let mut lanes = Lanes::splat(simd, 0.0);
        for (register, values) in lanes.registers.iter_mut().zip(values.chunks(S::F64_LANES)) {
            *register = simd.partial_load_f64s(values);
        }
        lanes
    }

    /// The first `R` registers of a row.
    #[inline(always)]
    pub fn take(simd: S, row: &[S::f64s]) -> Lanes<S, R> {
        let mut lanes = Lanes::splat(simd, 0.0);
        lanes.registers.copy_from_slice(&row[..R]);
        lanes
    }

    /// Writes them over the first `R` registers of a row.
    #[inline(always)]
    pub fn put(self, row: &mut [S::f64s]) {
        row[..R].copy_from_slice(&self.registers);
    }

    /// Writes all lanes to `values`, which has room for them.
    #[inline(always)]
    pub fn store(self, values: &mut [f64]) {
        for (register, values) in self.registers.iter().zip(S::as_mut_simd_f64s(values).0) {
            *values = *register;
        }
    }

    /// The largest; NaN counts as none.
    #[inline(always)]
    pub fn largest(self) -> f64 {
        let mut largest = f64::NEG_INFINITY;
        for register in self.registers {
            largest = largest.max(self.simd.reduce_max_f64s(register));
        }
        largest
    }
}

macro_rules! lane_by_lane {
    ($($operator:ident::$method:ident by $instruction:ident),*) => {$(
        impl<S: Simd, const R: usize> $operator for Lanes<S, R> {
            type Output = Lanes<S, R>;

            #[inline(always)]
            fn $method(mut self, other: Lanes<S, R>) -> Lanes<S, R> {
                for i in 0..R {
                    self.registers[i] = self.simd.$instruction(self.registers[i], other.registers[i]);
                }
                self
            }
        }
    )*};
}

lane_by_lane!(Add::add by add_f64s, Sub::sub by sub_f64s, Mul::mul by mul_f64s);

impl<S: Simd, const R: usize> Mul<f64> for Lanes<S, R> {
    type Output = Lanes<S, R>;

    #[inline(always)]
    fn mul(self, factor: f64) -> Lanes<S, R> {
        self * Lanes::splat(self.simd, factor)
    }
}

impl<S: Simd, const R: usize> Number for Lanes<S, R> {
    #[inline(always)]
    fn like(self, value: f64) -> Lanes<S, R> {
        Lanes::splat(self.simd, value)
    }

    #[inline(always)]
    fn larger(mut self, other: Lanes<S, R>) -> Lanes<S, R> {
        for i in 0..R {
            self.registers[i] = self.simd.max_f64s(self.registers[i], other.registers[i]);
        }
        self
    }
}

/// The registers of this machine.
#[derive(Clone, Copy, Debug)]
pub struct Registers(Width);

#[derive(Clone, Copy, Debug)]
enum Width {
    /// Eight numbers each (AVX-512), four (AVX2), or one.
    Known(Arch),
    /// Two (SSE 4.2).
    #[cfg(target_arch = "x86_64")]
    Two(pulp::x86::V2),
}

/// Work on eight numbers at a time, as many registers as that takes.
pub trait Eighths {
    /// What comes of it.
    type Output;

    /// Does it with `R` registers of `S`, eight numbers in all.
    fn with_registers<S: Simd, const R: usize>(self, simd: S) -> Self::Output;
}

impl Registers {
    /// The widest that the machine has.
    pub fn widest() -> Registers {
        #[cfg(target_arch = "x86_64")]
        if let (Arch::Scalar, Some(two)) = (Arch::new(), pulp::x86::V2::try_new()) {
            return Registers(Width::Two(two));
        }
        Registers(Width::Known(Arch::new()))
    }

    /// All that the machine has, from one number each on.
    pub fn all() -> Vec<Registers> {
        let mut all = vec![Registers(Width::Known(Arch::Scalar))];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V2::try_new().map(|two| Registers(Width::Two(two))));
            all.extend(pulp::x86::V3::try_new().map(|four| Registers(Width::Known(Arch::V3(four)))));
        }
        all.push(Registers::widest());
        all
    }

    /// How many numbers one of them holds.
    pub fn numbers(self) -> usize {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Width::Known(Arch::V4(_)) => 8,
            #[cfg(target_arch = "x86_64")]
            Width::Known(Arch::V3(_)) => 4,
            #[cfg(target_arch = "x86_64")]
            Width::Two(_) => 2,
            Width::Known(_) => 1,
        }
    }

    /// Does work in them.
    #[inline(always)]
    pub fn dispatch<W: WithSimd>(self, work: W) -> W::Output {
        match self.0 {
            Width::Known(arch) => arch.dispatch(work),
            #[cfg(target_arch = "x86_64")]
            Width::Two(two) => Simd::vectorize(two, work),
        }
    }

    /// Does work on eight numbers at a time.
    #[inline(always)]
    pub fn by_eights<W: Eighths>(self, work: W) -> W::Output {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Width::Known(Arch::V4(eight)) => Simd::vectorize(eight, Eight::<W, 1>(work)),
            #[cfg(target_arch = "x86_64")]
            Width::Known(Arch::V3(four)) => Simd::vectorize(four, Eight::<W, 2>(work)),
            #[cfg(target_arch = "x86_64")]
            Width::Two(two) => Simd::vectorize(two, Eight::<W, 4>(work)),
            Width::Known(_) => Simd::vectorize(Scalar, Eight::<W, 8>(work)),
        }
    }
}

struct Eight<W, const R: usize>(W);

impl<W: Eighths, const R: usize> WithSimd for Eight<W, R> {
    type Output = W::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> W::Output {
        self.0.with_registers::<S, R>(simd)
    }
}
