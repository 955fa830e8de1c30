//! Two hundred kills at random moments lose nothing but the row that is under way.

use crate::killing::{commands, random};

/// Kills of each command.
const KILLS: usize = 50;

#[test]
fn two_hundred_kills_at_random_moments_lose_no_finished_row() {
    for (command, seed) in commands().iter().zip(100..) {
        let whole = command.unbroken();
        let mut random = random(seed);
        let mut kills = 0;
        while kills < KILLS {
            kills += command.killed_until_it_ends(&whole, 25, &mut random);
        }
    }
}
