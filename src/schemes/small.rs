//! Products and solutions of small matrices, written out where they are used: nalgebra's are calls of loops that are compiled apart
//! from the code around them. The sums run in nalgebra's order and give its numbers.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::arithmetic::Real;
use crate::rotation::applied;

/// A B.
#[inline]
pub(super) fn product<T: Real>(a: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
    let column = |j: usize| applied(a, &Vector3::new(b[(0, j)], b[(1, j)], b[(2, j)]));
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

/// A D of a diagonal D.
#[inline]
pub(super) fn scaled_columns<T: Real>(a: &Matrix3<T>, d: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_fn(|i, j| a[(i, j)] * d[j])
}

/// a bᵀ.
#[inline]
pub(super) fn outer<T: Real>(a: &Vector3<T>, b: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_fn(|i, j| a[i] * b[j])
}

/// ∂(v × I v)/∂v = [v]× I − [I v]× for moments I.
#[inline]
pub(super) fn gyroscopic_slope<T: Real>(v: &Vector3<T>, moments: &Vector3<T>) -> Matrix3<T> {
    scaled_columns(&v.cross_matrix(), moments) - moments.component_mul(v).cross_matrix()
}

/// x of A x = b, by Gauss' elimination with a pivot of each column; `None` where A is singular.
#[inline]
pub(super) fn solved<T: Real, const N: usize>(
    mut a: SMatrix<T, N, N>,
    mut b: SVector<T, N>,
) -> Option<SVector<T, N>> {
    for k in 0..N {
        let largest = (k + 1..N).fold(k, |at, i| if a[(i, k)].abs() > a[(at, k)].abs() { i } else { at });
        if a[(largest, k)] == T::zero() {
            return None;
        }
        for j in 0..N {
            (a[(k, j)], a[(largest, j)]) = (a[(largest, j)], a[(k, j)]);
        }
        (b[k], b[largest]) = (b[largest], b[k]);
        let inverse = T::one() / a[(k, k)];
        for i in k + 1..N {
            let part = a[(i, k)] * inverse;
            for j in k + 1..N {
                let above = a[(k, j)];
                a[(i, j)] -= above * part;
            }
            let above = b[k];
            b[i] -= above * part;
        }
    }
    for k in (0..N).rev() {
        b[k] /= a[(k, k)];
        for i in 0..k {
            let below = b[k];
            b[i] -= below * a[(i, k)];
        }
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix6, Vector6};

    use super::*;
    use crate::arithmetic::DoubleDouble;

    #[test]
    fn products_and_solutions_have_the_bits_of_nalgebra() {
        for round in 0..200 {
            let part = |k: usize| (0.7 + f64::from(round) + 1.3 * (k * k) as f64).sin();
            let a = Matrix6::from_fn(|i, j| part(6 * i + j));
            let b = Vector6::from_fn(|i, _| part(36 + i));
            let (small, other) =
                (a.fixed_view::<3, 3>(0, 0).into_owned(), a.fixed_view::<3, 3>(3, 3).into_owned());
            let (x, y) = (b.fixed_rows::<3>(0).into_owned(), b.fixed_rows::<3>(3).into_owned());
            assert_eq!(solved(a, b), a.lu().solve(&b));
            assert_eq!(solved(small, x), small.lu().solve(&x));
            assert_eq!(product(&small, &other), small * other);
            assert_eq!(applied(&small, &x), small * x);
            assert_eq!(outer(&x, &y), x * y.transpose());
            assert_eq!(scaled_columns(&small, &x), small * Matrix3::from_diagonal(&x));
            let (wide, right) = (small.map(DoubleDouble::of), x.map(DoubleDouble::of));
            assert_eq!(solved(wide, right), wide.lu().solve(&right));
            assert_eq!(applied(&wide, &right), wide * right);
        }
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        assert_eq!(solved(Matrix3::new(1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 0.0, 0.0, 1.0), Vector3::x()), None);
    }

    #[test]
    fn the_gyroscopic_slope_is_that_of_differences() {
        let (v, moments) = (Vector3::new(0.3, -0.7, 1.1), Vector3::new(1.0, 1.5, 2.25));
        let term = |v: &Vector3<f64>| v.cross(&moments.component_mul(v));
        for axis in 0..3 {
            let off = Vector3::ith(axis, 1e-6);
            let slope = (term(&(v + off)) - term(&(v - off))) / 2e-6;
            // The term is of second degree: central differences leave rounding, 1e-16 over 1e-6.
            assert!((slope - gyroscopic_slope(&v, &moments).column(axis)).amax() < 1e-9);
        }
    }
}
