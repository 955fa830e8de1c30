//! The arms of mass points, coordinate by coordinate, so that eight points are turned and summed at a time.
//!
//! (1)  X̃ ← X̃ + (R − E) X̃                                   every arm
//! (2)  Σ M x²  and  Σ M x y, …  of the turned arms           what I = Σ M (|X̃|² E − X̃ X̃ᵀ) is made of
//!
//! in one pass. Sums run in eight parts, whatever the width of the registers, and the parts are put together in one order:
//! every machine gives the same numbers. The columns are filled up with points without mass.

use nalgebra::{Matrix3, Vector3};

use super::forces::Arms;
use crate::arithmetic::Real;
use crate::arithmetic::{Registers, Row, Work};
use crate::rotation::formulas;

/// Parts of a sum.
const PARTS: usize = 8;

/// Arms [m], one column a coordinate; a multiple of eight long.
#[derive(Debug, PartialEq)]
pub(super) struct Columns<T: Real = f64> {
    x: Vec<T>,
    y: Vec<T>,
    z: Vec<T>,
}

/// A column filled up with zeros to a multiple of eight.
pub(super) fn filled<T: Real>(mut column: Vec<T>) -> Vec<T> {
    column.resize(column.len().next_multiple_of(PARTS), T::zero());
    column
}

impl<T: Real> Clone for Columns<T> {
    fn clone(&self) -> Columns<T> {
        Columns { x: self.x.clone(), y: self.y.clone(), z: self.z.clone() }
    }

    /// Into the buffers that are there.
    fn clone_from(&mut self, other: &Columns<T>) {
        self.x.clone_from(&other.x);
        self.y.clone_from(&other.y);
        self.z.clone_from(&other.z);
    }
}

impl<T: Real> Columns<T> {
    pub(super) fn new(arms: &[Vector3<T>]) -> Columns<T> {
        let column = |i: usize| filled(arms.iter().map(|arm| arm[i]).collect());
        Columns { x: column(0), y: column(1), z: column(2) }
    }

    pub(super) fn at(&self, k: usize) -> Vector3<T> {
        Vector3::new(self.x[k], self.y[k], self.z[k])
    }

    pub(super) fn set(&mut self, k: usize, arm: &Vector3<T>) {
        (self.x[k], self.y[k], self.z[k]) = (arm.x, arm.y, arm.z);
    }

    /// How many, with those that fill up.
    pub(super) fn len(&self) -> usize {
        self.x.len()
    }

    pub(super) fn view(&self) -> Arms<'_, T> {
        Arms::Columns { x: &self.x, y: &self.y, z: &self.z }
    }

    pub(super) fn is_finite(&self) -> bool {
        [&self.x, &self.y, &self.z].into_iter().flatten().all(|x| x.is_finite())
    }
}

/// Sums (2): squares, then products yz, zx, xy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sums<T: Real = f64> {
    squares: Vector3<T>,
    products: Vector3<T>,
}

impl<T: Real> Sums<T> {
    /// Of arms as they stand.
    pub(super) fn of(arms: &Columns<T>, masses: &[T]) -> Sums<T> {
        let (mut squares, mut products) = ([Vector3::zeros(); PARTS], [Vector3::zeros(); PARTS]);
        for (k, mass) in masses.iter().enumerate() {
            let x: Vector3<T> = arms.at(k);
            let weighted = x * *mass;
            squares[k % PARTS] += weighted.component_mul(&x);
            products[k % PARTS] += Vector3::new(weighted.y * x.z, weighted.z * x.x, weighted.x * x.y);
        }
        let total = |parts: [Vector3<T>; PARTS], i: usize| together(parts.map(|part| part[i]));
        let vector = |parts| Vector3::new(total(parts, 0), total(parts, 1), total(parts, 2));
        Sums { squares: vector(squares), products: vector(products) }
    }

    /// I [kg m²], world.
    pub(super) fn inertia(&self) -> Matrix3<T> {
        let (s, p) = (&self.squares, &self.products);
        Matrix3::new(s.y + s.z, -p.z, -p.y, -p.z, s.z + s.x, -p.x, -p.y, -p.x, s.x + s.y)
    }
}

/// Eight parts of a sum put together.
#[inline(always)]
fn together<T: Real>(p: [T; PARTS]) -> T {
    ((p[0] + p[4]) + (p[1] + p[5])) + ((p[2] + p[6]) + (p[3] + p[7]))
}

/// Turns all arms of `from` by (1), with `change` = R − E, and sums them by (2).
pub(super) fn turn<T: Real>(
    registers: Registers,
    change: &[[T; 3]; 3],
    from: &Columns<T>,
    masses: &[T],
    into: &mut Columns<T>,
) -> Sums<T> {
    T::by_eight(registers, Turn { change, from, masses, into })
}

struct Turn<'a, T: Real> {
    change: &'a [[T; 3]; 3],
    from: &'a Columns<T>,
    masses: &'a [T],
    into: &'a mut Columns<T>,
}

impl<T: Real> Work<T> for Turn<'_, T> {
    type Output = Sums<T>;

    #[inline(always)]
    fn with_rows<R: Row<Scalar = T>>(self, proof: R::Proof) -> Sums<T> {
        let Turn { change, from, masses, into } = self;
        let (x, y, z, masses) =
            (R::chunks(&from.x), R::chunks(&from.y), R::chunks(&from.z), R::chunks(masses));
        let (x1, y1, z1) =
            (R::chunks_mut(&mut into.x), R::chunks_mut(&mut into.y), R::chunks_mut(&mut into.z));
        let [p, q, r] = change;
        let change = [splat::<R>(proof, p), splat(proof, q), splat(proof, r)];
        let zero = R::splat(proof, T::zero());
        let (mut squares, mut products) = ([zero; 3], [zero; 3]);
        for at in 0..masses.len() {
            let before = [R::load(proof, &x[at]), R::load(proof, &y[at]), R::load(proof, &z[at])];
            let moved = formulas::apply(&change, before);
            let [a, b, c] = [before[0] + moved[0], before[1] + moved[1], before[2] + moved[2]];
            a.store(&mut x1[at]);
            b.store(&mut y1[at]);
            c.store(&mut z1[at]);
            let m = R::load(proof, &masses[at]);
            let (ma, mb, mc) = (m * a, m * b, m * c);
            squares = [squares[0] + ma * a, squares[1] + mb * b, squares[2] + mc * c];
            products = [products[0] + mb * c, products[1] + mc * a, products[2] + ma * b];
        }
        let [xx, yy, zz] = squares;
        let [yz, zx, xy] = products;
        Sums {
            squares: Vector3::new(total(xx), total(yy), total(zz)),
            products: Vector3::new(total(yz), total(zx), total(xy)),
        }
    }
}

/// Entry by entry: a closure would not be compiled for the registers of `R`.
#[inline(always)]
fn splat<R: Row>(proof: R::Proof, row: &[R::Scalar; 3]) -> [R; 3] {
    [R::splat(proof, row[0]), R::splat(proof, row[1]), R::splat(proof, row[2])]
}

#[inline(always)]
fn total<R: Row>(sum: R) -> R::Scalar {
    let mut parts = [R::Scalar::of(0.0); PARTS];
    sum.store(&mut R::chunks_mut(&mut parts)[0]);
    together(parts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::body::second_moment_inertia;
    use crate::rotation;

    #[test]
    fn registers_of_every_width_turn_and_sum_points_as_plain_loops_do() {
        let spin = Vector3::new(0.3, -0.9, 0.4);
        let change = rotation::change_of_turn(&spin, 0.5);
        let plain = rotation::turn(&(spin * 0.5)).to_rotation_matrix().into_inner();
        for count in [1, 4, 7, 8, 9, 100] {
            let point = |k: usize| {
                let part = k as f64;
                Vector3::new((0.7 * part).cos(), 0.5 * (0.3 * part).sin(), 0.02 * part - 1.0)
            };
            let arms: Vec<_> = (0..count).map(point).collect();
            let masses: Vec<f64> = (0..count).map(|k| 1.0 + 0.1 * k as f64).collect();
            let from = Columns::new(&arms);
            let mut results = Registers::all().into_iter().map(|registers| {
                let mut into = from.clone();
                let sums = turn(registers, &change, &from, &filled(masses.clone()), &mut into);
                (into, sums)
            });
            let first = results.next().expect("one number a register");
            assert!(results.len() > 0 || !cfg!(target_arch = "x86_64"));
            for other in results {
                assert_eq!(first, other, "{count} points");
            }
            let (into, sums) = first;
            assert_eq!(sums, Sums::of(&into, &masses), "{count} points");
            let turned: Vec<_> = arms.iter().map(|arm| plain * arm).collect();
            let inertia: Matrix3<f64> =
                turned.iter().zip(&masses).map(|(x, m)| second_moment_inertia(x) * *m).sum();
            // A point rounds a few times; a sum of n once for every term.
            for (k, x) in turned.iter().enumerate() {
                assert!((into.at(k) - x).amax() < 4.0 * f64::EPSILON * x.norm());
            }
            let bound = f64::EPSILON * (8.0 + count as f64) * inertia.trace();
            assert!((sums.inertia() - inertia).amax() < bound, "{count} points");
        }
    }
}
