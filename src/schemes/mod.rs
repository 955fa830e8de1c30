//! The trait, the list, and one file a scheme; nothing else.
//!
//! A scheme is written in the two verbs of [`Model`] alone. It sees no scene, no reference and no gate: it
//! cannot know that it is being examined.

use crate::claim::Claim;
use crate::model::{Broken, Model};

/// What a scheme says of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// Name as on the command line, kebab-case.
    pub name: &'static str,
    /// One line.
    pub title: &'static str,
    /// Family it belongs to.
    pub family: &'static str,
    /// Keys in references/bibliography.bib.
    pub source: &'static str,
    /// Its promises.
    pub claims: &'static [Claim],
}

impl Card {
    /// The claimed order of convergence; 0 where none is claimed.
    pub fn order(&self) -> u32 {
        self.claims.iter().find_map(|c| if let Claim::Order(p) = c { Some(*p) } else { None }).unwrap_or(0)
    }

    /// The claimed number of force evaluations a step; 0 where none is claimed.
    pub fn evaluations(&self) -> u32 {
        self.claims
            .iter()
            .find_map(|c| if let Claim::Evaluations(n) = c { Some(*n) } else { None })
            .unwrap_or(0)
    }
}

/// A time-stepping scheme.
pub trait Scheme: 'static {
    /// What it says of itself.
    const CARD: Card;
    /// Buffers that a step needs besides the states it goes from and to.
    const STAGES: usize;

    /// One step from `t` to `t + h`: reads `from`, writes `to`, may use `stages` in between.
    ///
    /// # Errors
    /// The step cannot be made.
    fn step<M: Model>(
        model: &M,
        t: f64,
        h: f64,
        from: &M::State,
        to: &mut M::State,
        stages: &mut [M::State],
    ) -> Result<(), Broken>;
}

/// Something to be done with a scheme whose type is known.
pub trait Visitor {
    /// What comes of it.
    type Output;
    /// Does it.
    fn visit<S: Scheme>(&self) -> Self::Output;
}

macro_rules! list {
    ($($module:ident::$scheme:ident),* $(,)?) => {
        $(mod $module; pub use $module::$scheme;)*

        /// Calls the visitor with every scheme, in the order of the list.
        pub fn visit_all<V: Visitor>(visitor: &V) -> Vec<V::Output> {
            vec![$(visitor.visit::<$scheme>()),*]
        }
    };
}

list! {
    peskin_rk2::PeskinRk2,
    euler::Euler,
}
