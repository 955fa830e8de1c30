//! What a scheme says of itself.

use crate::claim::Claim;

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
    /// A card of a scheme of your own: its name, kebab-case, and what it promises.
    pub const fn new(name: &'static str, claims: &'static [Claim]) -> Card {
        Card { name, title: name, family: "of its own", source: "", claims }
    }

    /// What the name of a scheme in equal parts of a step begins with; the number of parts and the scheme's own name follow.
    pub const SUBSTEPPED: &'static str = "substepped-";

    /// The number of parts of a step and the scheme's own name, of the name of a substepped scheme.
    pub fn parts(name: &str) -> Option<(u32, &str)> {
        let (parts, base) = name.strip_prefix(Card::SUBSTEPPED)?.split_once('-')?;
        Some((parts.parse().ok()?, base))
    }

    /// The claimed order of convergence; 0 where none is claimed.
    pub fn order(&self) -> u32 {
        self.claims.iter().find_map(|c| if let Claim::Order(p) = c { Some(*p) } else { None }).unwrap_or(0)
    }

    /// The claimed order of convergence in a scene without torque.
    pub fn order_without_torque(&self) -> u32 {
        let own = |claim: &Claim| if let Claim::OrderWithoutTorque(p) = claim { Some(*p) } else { None };
        self.claims.iter().find_map(own).unwrap_or_else(|| self.order())
    }

    /// The power of the step that stands for a tolerance; 0 for a scheme that is given a step.
    pub fn tolerance_exponent(&self) -> u32 {
        let own = |claim: &Claim| if let Claim::FollowsTolerance(n) = claim { Some(*n) } else { None };
        self.claims.iter().find_map(own).unwrap_or(0)
    }

    /// The claimed number of force evaluations a step; 0 where none is claimed.
    pub fn evaluations(&self) -> u32 {
        self.claims
            .iter()
            .find_map(|c| if let Claim::Evaluations(n) = c { Some(*n) } else { None })
            .unwrap_or(0)
    }
}
