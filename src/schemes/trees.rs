//! Rooted trees and the order conditions of Runge–Kutta methods that they stand for, for tests of tableaux.
//!
//! A method with aᵢⱼ and bᵢ has order p where γ(t) Σ bᵢ Φᵢ(t) = 1 for every tree t of at most p nodes, with Φᵢ the product over the
//! subtrees u at the root of Σ aᵢⱼ Φⱼ(u). Source: hairer1993, theorem II.2.13.

use crate::arithmetic::Real;

/// A rooted tree: the subtrees at its root, sorted.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tree(Vec<Tree>);

/// The forests of so many nodes whose trees are `below` at most, the trees given by their size.
fn forests(nodes: usize, below: Option<&Tree>, by_size: &[Vec<Tree>]) -> Vec<Vec<Tree>> {
    if nodes == 0 {
        return vec![Vec::new()];
    }
    let trees = (1..=nodes).flat_map(|size| &by_size[size]);
    let mut all = Vec::new();
    for tree in trees.filter(|tree| below.is_none_or(|below| *tree <= below)) {
        for mut rest in forests(nodes - tree.nodes(), Some(tree), by_size) {
            rest.push(tree.clone());
            all.push(rest);
        }
    }
    all
}

impl Tree {
    /// All trees of so many nodes.
    pub fn all(nodes: usize) -> Vec<Tree> {
        let mut by_size = vec![Vec::new()];
        for size in 1..=nodes {
            by_size.push(forests(size - 1, None, &by_size).into_iter().map(Tree).collect());
        }
        by_size.swap_remove(nodes)
    }

    fn nodes(&self) -> usize {
        1 + self.0.iter().map(Tree::nodes).sum::<usize>()
    }

    /// γ: the nodes of the tree times γ of every subtree.
    fn density(&self) -> f64 {
        self.0.iter().map(Tree::density).product::<f64>() * self.nodes() as f64
    }

    /// Φᵢ.
    fn stages<T: Real, const S: usize>(&self, a: &[[T; S]; S]) -> [T; S] {
        self.0.iter().fold([T::of(1.0); S], |product, subtree| {
            let below = subtree.stages(a);
            std::array::from_fn(|i| product[i] * a[i].iter().zip(&below).map(|(a, x)| *a * *x).sum::<T>())
        })
    }

    /// |γ Σ bᵢ Φᵢ − wanted| over the same sum of the sizes of all terms.
    pub fn off<T: Real, const S: usize>(&self, a: &[[T; S]; S], b: &[T; S], wanted: f64) -> f64 {
        let sum = |a: &[[T; S]; S], b: &[T; S]| {
            self.stages(a).iter().zip(b).map(|(x, b)| *x * *b).sum::<T>() * self.density()
        };
        let sizes = sum(&a.map(|row| row.map(|x| x.abs())), &b.map(|x| x.abs()));
        ((sum(a, b) - wanted) / sizes).abs().to_f64()
    }

    /// The largest of these over all trees of at most so many nodes.
    pub fn worst<T: Real, const S: usize>(nodes: usize, a: &[[T; S]; S], b: &[T; S], wanted: f64) -> f64 {
        let trees = (1..=nodes).flat_map(Tree::all);
        trees.map(|tree| tree.off(a, b, wanted)).fold(0.0, f64::max)
    }
}

#[test]
fn there_are_as_many_trees_as_cayley_counted() {
    let counts: Vec<usize> = (1..=9).map(|nodes| Tree::all(nodes).len()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115, 286]);
}
