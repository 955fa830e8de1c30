//! Springs and central gravity as series: (6) of [`loads`](super::loads).

use nalgebra::Vector3;

use super::loads::{Load, Scales, Seen, Term, by, plus, principal};
use super::series::{CAPACITY, Curves, Series, Vector, cross_product, norm_squared, power, times, zeros};
use crate::model::body::{Body, MassPoint};
use crate::model::forces::{Attachment, CentralGravity, MassCenterGravity, Spring};

/// Points that are taken at once: a register of AVX2.
const WIDTH: usize = 4;

/// (6) of points side by side: x, w, a, b, c of each and e of all, with the series of d, |d|² and |d|ᵉ.
#[derive(Debug)]
pub struct Pulls {
    arms: [Vector; WIDTH],
    anchors: [Vector; WIDTH],
    linear: [f64; WIDTH],
    factor: [f64; WIDTH],
    damping: [f64; WIDTH],
    /// e/2, and whether a factor is not zero.
    exponent: Option<f64>,
    lever: f64,
    /// Lanes with a point of their own.
    count: usize,
    /// w − X at the start of the step.
    ahead: [Vector; WIDTH],
    distance: Curves<WIDTH>,
    square: Series<WIDTH>,
    power: Series<WIDTH>,
}

/// A point that is pulled to a place.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    arm: Vector,
    anchor: Vector,
    linear: f64,
    factor: f64,
    damping: f64,
}

impl Pull {
    pub(super) fn spring(spring: &Spring, body: &Body, scales: &Scales) -> Pull {
        let arm = match &spring.attachment {
            Attachment::Point(index) => body.points[*index].position,
            Attachment::At(position) => *position,
        };
        let stiffness = spring.stiffness * scales.force() * scales.length;
        Pull {
            arm: principal(body, &(arm / scales.length)),
            anchor: (spring.anchor / scales.length).into(),
            linear: -stiffness,
            factor: stiffness * (spring.rest_length / scales.length),
            damping: spring.damping * scales.force() * (scales.length / scales.time),
        }
    }

    /// By the centre of attraction, of every point.
    pub(super) fn gravity(law: &CentralGravity, body: &Body, scales: &Scales) -> Vec<Pull> {
        let place = |position: &Vector3<f64>| principal(body, &(position / scales.length));
        let pull = |p: &MassPoint| Pull::attraction(law.mu, &law.center, p.mass, place(&p.position), scales);
        body.points.iter().map(pull).collect()
    }

    /// By the centre of attraction, of the whole mass in its centre.
    pub(super) fn on_center(law: &MassCenterGravity, body: &Body, scales: &Scales) -> Pull {
        let arm = principal(body, &(body.center / scales.length));
        Pull::attraction(law.mu, &law.center, body.mass, arm, scales)
    }

    fn attraction(mu: f64, center: &Vector3<f64>, mass: f64, arm: Vector, scales: &Scales) -> Pull {
        // μ in units of length³/time²; each point has its part of the mass.
        let mu = mu / scales.length * (scales.time / scales.length).powi(2);
        let anchor = (center / scales.length).into();
        Pull { arm, anchor, linear: 0.0, factor: -mu * (mass / scales.mass), damping: 0.0 }
    }
}

impl Pulls {
    /// Begins a step with the origin at a place.
    pub(super) fn start(&mut self, origin: &Vector3<f64>) {
        self.ahead = self.anchors.map(|anchor| (Vector3::from(anchor) - origin).into());
    }

    /// All of some points; a lane without one has the first, and no force.
    pub(super) fn all(pulls: &[Pull], exponent: f64, scales: &Scales) -> Vec<Term> {
        let together = |some: &[Pull]| {
            let lane = |lane: usize| match some.get(lane) {
                Some(pull) => *pull,
                None => Pull { linear: 0.0, factor: 0.0, damping: 0.0, ..some[0] },
            };
            let lanes: [Pull; WIDTH] = std::array::from_fn(lane);
            Term::Pulls(Box::new(Pulls {
                arms: lanes.map(|pull| pull.arm),
                anchors: lanes.map(|pull| pull.anchor),
                linear: lanes.map(|pull| pull.linear),
                factor: lanes.map(|pull| pull.factor),
                damping: lanes.map(|pull| pull.damping),
                exponent: lanes.iter().any(|pull| pull.factor != 0.0).then_some(exponent),
                lever: scales.lever(),
                count: some.len(),
                ahead: [[0.0; 3]; WIDTH],
                distance: zeros(),
                square: [[0.0; WIDTH]; CAPACITY],
                power: [[0.0; WIDTH]; CAPACITY],
            }))
        };
        pulls.chunks(WIDTH).map(together).collect()
    }

    #[inline(always)]
    pub(super) fn grow<const L: usize>(&mut self, seen: &Seen<L>, load: &mut Load) {
        let k = seen.k;
        for lane in 0..self.count {
            let ahead = seen.in_body(&self.ahead[lane..=lane]);
            for (c, distance) in self.distance[k].iter_mut().enumerate() {
                let arm = if k == 0 { self.arms[lane][c] } else { 0.0 };
                distance[lane] = seen.way[c] + arm - ahead[c];
            }
        }
        for distance in &mut self.distance[k] {
            let first = distance[0];
            distance[self.count..].fill(first);
        }
        let mut pull = self.distance[k];
        for pull in &mut pull {
            for (pull, linear) in pull.iter_mut().zip(&self.linear) {
                *pull *= linear;
            }
        }
        if let Some(exponent) = self.exponent {
            self.square[k] = norm_squared(&self.distance, k);
            self.power[k] = power(&self.square, exponent, &self.power, k);
            for (pull, product) in pull.iter_mut().zip(times(&self.distance, &self.power, k)) {
                for (lane, pull) in pull.iter_mut().enumerate() {
                    *pull += product[lane] * self.factor[lane];
                }
            }
        }
        for (lane, arm) in self.arms[..self.count].iter().enumerate() {
            let damped = by(&seen.velocity_at(arm), -self.damping[lane]);
            let force = plus(&[pull[0][lane], pull[1][lane], pull[2][lane]], &damped);
            load.add(&force, &by(&cross_product(arm, &force), self.lever)); // (6)
        }
    }
}
