//! The mirrored twin of a link: equal masses, centres of mass and tensors mirrored in a plane through the link frames.

use std::collections::BTreeMap;

use nalgebra::{Matrix3, Vector3};

use super::super::change::Change;
use super::super::link::{Link, tensor_of};
use super::super::verdict::{Judged, Verdict};
use super::{CLOSE, Case, Repair, close};

/// Words for two sides.
const SIDES: [(&str, &str); 4] = [("left", "right"), ("fl", "fr"), ("rl", "rr"), ("l", "r")];
const AXES: [&str; 3] = ["x", "y", "z"];

/// A twin and the axis that changes sign.
struct Twin<'a> {
    name: &'a str,
    axis: usize,
    mass: f64,
    /// Tensor of the twin, mirrored [kg m²].
    tensor: Matrix3<f64>,
}

/// Links whose names differ by words for sides only: places in the list of links.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Sides(BTreeMap<Vec<String>, Vec<usize>>);

/// Links of one name but for the side; robots have two, and a file that repeats a name 1e5 times is read in bounded time.
const MOST_ALIKE: usize = 16;

impl Sides {
    pub fn of(links: &[(Link, Judged)]) -> Sides {
        let mut sides = Sides::default();
        for (place, (link, _)) in links.iter().enumerate() {
            let alike = sides.0.entry(without_sides(&link.name)).or_default();
            if alike.len() < MOST_ALIKE {
                alike.push(place);
            }
        }
        sides
    }
}

fn words(name: &str) -> Vec<String> {
    name.to_lowercase().split(|c: char| !c.is_alphanumeric()).map(str::to_owned).collect()
}

fn without_sides(name: &str) -> Vec<String> {
    let mut words = words(name);
    for word in &mut words {
        if let Some((left, _)) = SIDES.iter().find(|(left, right)| word == left || word == right) {
            *word = (*left).to_owned();
        }
    }
    words
}

pub(super) fn repairs(case: &Case, changes: &[Change]) -> Vec<Repair> {
    if case.judged.verdict == Verdict::Possible {
        return Vec::new();
    }
    let Some(twin) = find(case) else { return Vec::new() };
    let has = |finding: &str| case.judged.findings.contains(&finding);
    let (name, axis) = (twin.name, AXES[twin.axis]);
    if has("inertia-without-mass") {
        if !close(&case.inertial.tensor(), &twin.tensor, CLOSE) {
            return Vec::new();
        }
        let how =
            format!("{name} is its mirror image ({axis} changes sign), tensor included, and has this mass");
        let repair = case.repair("mass-from-twin", format!("mass {} kg", twin.mass), how, twin.tensor);
        return vec![Repair { mass: twin.mass, ..repair }];
    }
    if (twin.mass - case.mass()).abs() > CLOSE * twin.mass {
        return Vec::new();
    }
    let how = format!("{name} has the same mass and the mirrored centre of mass ({axis} changes sign)");
    let witnessed = changes.iter().filter_map(|change| {
        let tensor = case.inertial.pose.turned(&tensor_of(&change.six));
        let how = format!("{how}, and this tensor mirrored");
        close(&tensor, &twin.tensor, CLOSE)
            .then(|| case.repair(change.kind, change.label.clone(), how, tensor))
    });
    let found: Vec<Repair> = witnessed.collect();
    let empty =
        ["zero-inertia-with-geometry", "much-smaller-than-its-outline", "not-a-number"].into_iter().any(has);
    if found.is_empty() && empty {
        let what = format!("the tensor of {name}, mirrored: products with {axis} change sign");
        return vec![case.repair("tensor-from-twin", what, how, twin.tensor)];
    }
    found
}

fn find<'a>(case: &Case<'a>) -> Option<Twin<'a>> {
    let center = case.inertial.pose.position;
    let alike = case.sides.0.get(&without_sides(&case.link.name))?;
    alike.iter().filter_map(|place| case.all.get(*place)).find_map(|(other, judged)| {
        let given = other.inertial.as_ref()?;
        if !good(other, judged) || !are_sides(&case.link.name, &other.name) {
            return None;
        }
        let axis = mirrored(&center, &given.pose.position)?;
        let mut mirror = Matrix3::identity();
        mirror[(axis, axis)] = -1.0;
        let tensor = mirror * given.tensor() * mirror;
        Some(Twin { name: &other.name, axis, mass: given.mass.value, tensor })
    })
}

fn good(link: &Link, judged: &Judged) -> bool {
    judged.verdict == Verdict::Possible && link.inertials < 2
}

/// Whether a name becomes the other by exchanging the words for two sides.
fn are_sides(one: &str, other: &str) -> bool {
    let (one, other) = (words(one), words(other));
    let pair = |a: &str, b: &str| SIDES.iter().any(|(l, r)| (a, b) == (l, r) || (a, b) == (r, l));
    let differing: Vec<(&String, &String)> = one.iter().zip(&other).filter(|(a, b)| a != b).collect();
    one.len() == other.len() && !differing.is_empty() && differing.iter().all(|(a, b)| pair(a, b))
}

/// The one axis along which two centres are opposite; the others agree.
fn mirrored(a: &Vector3<f64>, b: &Vector3<f64>) -> Option<usize> {
    let near = |x: f64, y: f64| (x - y).abs() <= CLOSE * a.amax();
    (0..3).find(|axis| {
        a[*axis].abs() > CLOSE * a.amax()
            && (0..3).all(|i| if i == *axis { near(a[i], -b[i]) } else { near(a[i], b[i]) })
    })
}
