//! The references agree with each other and with stored solutions, and say how well.

mod agreement;
mod building;
mod contacts;
mod motions;
mod scaling;
mod solvers;
mod stored;
