//! The ground on a tape: two branches for every mass point, and what tells which of them holds.
//!
//! ```text
//! (1) d = height − x·n,  N = k d − c u·n
//! (2) F = N (n − μ s/√(s·s + v₀²)),  s = u − (u·n) n      where d > 0 and N > 0, else 0
//! ```
//!
//! Either branch is analytic, and d and N are functions of the state: no switch makes them jump. A force does jump, by
//! c ḋ, where a damped point touches. A moment of touching that is off by ε/ḋ, because d is off by ε, then moves the
//! momentum by c ε, however slowly the point comes down: a contact that grazes amplifies no error.

use super::laws::{Load, Motion};
use super::sheet::Node;
use super::triple::Triple;
use crate::model::forces::Ground;

/// A value that must be above zero for a contact to hold, and the size of what it is the difference of.
#[derive(Clone, Copy)]
pub(super) struct Guard<'a> {
    pub node: Node<'a>,
    pub size: f64,
}

/// The contacts of a branch, law by law and point by point.
pub(super) struct Contacts<'a, 'b> {
    /// Whether each holds; none does beyond the end.
    pub touching: &'b [bool],
    /// What must be above zero for each to hold.
    pub guards: Vec<Vec<Guard<'a>>>,
}

impl<'a> Motion<'a> {
    /// What the ground does to the points that touch it.
    pub(super) fn ground(&self, ground: &Ground, contacts: &mut Contacts<'a, '_>) -> Load<'a> {
        let normal = Triple::constant(self.sheet, &ground.normal);
        let height = self.scale.plain(ground.height, [0, 1, 0]);
        let stiffness = self.scale.plain(ground.stiffness, [1, 0, -2]);
        let damping = self.scale.plain(ground.damping, [1, 0, -1]);
        // A length of the scene, and what a point's own place adds to it.
        let reach = 1.0 + height.abs() + self.scale.plain(self.system.body.extent(), [0, 1, 0]);
        self.on_points(|motion, _, x| {
            let velocity = motion.velocity_of(x);
            let approach = velocity.dot(normal);
            let depth = motion.sheet.constant(height) - (motion.origin + motion.arm(x)).dot(normal);
            let push = depth.times(stiffness) - approach.times(damping); // (1)
            let mut guards = vec![Guard { node: depth, size: reach }];
            if damping != 0.0 || stiffness <= 0.0 {
                guards.push(Guard {
                    node: push,
                    size: stiffness.abs() * reach + damping.abs() * motion.scale.speed,
                });
            }
            let touches = contacts.touching.get(contacts.guards.len()).is_some_and(|touches| *touches);
            contacts.guards.push(guards);
            if !touches {
                return Triple::zero(motion.sheet);
            }
            let support = normal.times(push);
            if ground.friction == 0.0 {
                return support;
            }
            let sliding = velocity - normal.times(approach);
            let least = motion.sheet.constant(motion.scale.plain(ground.slip_velocity, [0, 1, -1]));
            let speed = (sliding.dot(sliding) + least * least).sqrt();
            support - sliding.times((push / speed).times(ground.friction)) // (2)
        })
    }
}
