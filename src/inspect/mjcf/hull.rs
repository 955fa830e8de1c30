//! A mesh whose vertices stand in the file without faces: MuJoCo fills its convex hull.
//!
//! A facet is the polygon of all vertices in a plane that has no vertex beyond it; the body is the sum of the tetrahedra from the origin
//! to the triangles of the facets. For a tetrahedron 0 a b c of volume V = a·(b × c)/6, with s = a + b + c, the centre is s/4 and
//! ∫ x xᵀ dV = V/20 (s sᵀ + a aᵀ + b bᵀ + c cᵀ).

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Matrix3, Vector3};

use super::classes::Classes;
use crate::inspect::element::{Element, Fault, Faults, finite, printed};
use crate::inspect::pose::Pose;
use crate::model::body::second_moment_inertia;

/// Most vertices: planes through three of them are tried one by one, C(32, 3) · 32 = 1.6e5 distances, 0.5 ms.
const MOST_VERTICES: usize = 32;
/// Most hulls of a file: half a second.
const MOST_HULLS: usize = 1000;
/// Vertices within this share of the size of the mesh are in one plane.
const FLAT: f64 = 1e-9;

/// The hull as uniform matter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hull {
    /// [m³].
    pub volume: f64,
    /// Centre of mass [m].
    pub center: Vector3<f64>,
    /// Tensor of 1 kg about the centre [m²].
    pub tensor: Matrix3<f64>,
}

/// Hulls by the name of their mesh.
pub(super) type Hulls = BTreeMap<String, Hull>;

/// The hulls of meshes that have vertices in the file, no faces and no frame of their own.
pub(super) fn all(root: &Element, classes: &Classes, faults: &mut Faults) -> Hulls {
    let mut hulls = Hulls::new();
    for element in root.all("asset").flat_map(|asset| asset.all("mesh")) {
        let given = classes.of("mesh", element, None);
        let (Some(name), Some(text)) = (given.get("name"), given.get("vertex")) else { continue };
        let other = ["face", "refpos", "refquat", "file"].iter().any(|key| given.contains_key(key));
        if other || given.get("inertia") == Some(&"shell") || hulls.len() >= MOST_HULLS {
            continue;
        }
        let scale = given.get("scale").map_or(Ok([1.0; 3]), |text| finite::<3>(element, text));
        let vertices = scale.and_then(|scale| vertices(element, text, scale.into()));
        if let Some(hull) = faults.keep(vertices).and_then(|vertices| Hull::of(&vertices)) {
            hulls.insert((*name).to_owned(), hull);
        }
    }
    hulls
}

fn vertices(element: &Element, text: &str, scale: Vector3<f64>) -> Result<Vec<Vector3<f64>>, Fault> {
    let numbers: Vec<f64> = printed(element, text)?.into_iter().map(|number| number.value).collect();
    let vertex = |three: &[f64]| Vector3::from_column_slice(three).component_mul(&scale);
    Ok(numbers.chunks_exact(3).map(vertex).collect())
}

impl Hull {
    /// The hull of a mesh in the frame `pose`.
    pub fn placed(&self, pose: &Pose) -> Hull {
        let center = pose.position + pose.axes * self.center;
        Hull { center, tensor: pose.turned(&self.tensor), ..*self }
    }

    /// `None` for vertices in a plane, and for too many.
    pub fn of(vertices: &[Vector3<f64>]) -> Option<Hull> {
        if vertices.len() > MOST_VERTICES || vertices.iter().any(|v| !v.iter().all(|x| x.is_finite())) {
            return None;
        }
        let size = vertices.iter().map(Vector3::amax).fold(0.0, f64::max);
        let (mut volume, mut first, mut second) = (0.0, Vector3::zeros(), Matrix3::zeros());
        for [a, b, c] in triangles(vertices, FLAT * size) {
            let sum = a + b + c;
            let own = a.dot(&b.cross(&c)) / 6.0;
            volume += own;
            first += sum * (own / 4.0);
            second += [sum, a, b, c].iter().map(|v| v * v.transpose()).sum::<Matrix3<f64>>() * (own / 20.0);
        }
        if volume.is_nan() || volume <= FLAT * size * size * size {
            return None;
        }
        let (center, second) = (first / volume, second / volume);
        let about_origin = Matrix3::from_diagonal_element(second.trace()) - second;
        Some(Hull { volume, center, tensor: about_origin - second_moment_inertia(&center) })
    }
}

/// Triangles of the surface, counter-clockwise seen from outside.
fn triangles(vertices: &[Vector3<f64>], flat: f64) -> Vec<[Vector3<f64>; 3]> {
    let mut met = BTreeSet::new();
    let mut found = Vec::new();
    for (i, a) in vertices.iter().enumerate() {
        for (j, b) in vertices.iter().enumerate().skip(i + 1) {
            for c in vertices.iter().skip(j + 1) {
                let Some(normal) = (b - a).cross(&(c - a)).try_normalize(flat * flat) else { continue };
                for normal in [normal, -normal] {
                    let Some(facet) = facet(vertices, a, &normal, flat) else { continue };
                    // All vertices in one plane have no volume.
                    if facet.len() == vertices.len() {
                        return Vec::new();
                    }
                    if met.insert(facet.clone()) {
                        found.extend(fan(vertices, facet, &normal));
                    }
                }
            }
        }
    }
    found
}

/// The vertices in the plane, where none is beyond it.
fn facet(
    vertices: &[Vector3<f64>],
    at: &Vector3<f64>,
    normal: &Vector3<f64>,
    flat: f64,
) -> Option<Vec<usize>> {
    let heights = || vertices.iter().map(|vertex| (vertex - at).dot(normal));
    if heights().any(|height| height > flat) {
        return None;
    }
    Some(heights().enumerate().filter(|(_, height)| *height >= -flat).map(|(place, _)| place).collect())
}

/// The polygon of a facet as triangles about its middle; vertices inside it change nothing.
fn fan(vertices: &[Vector3<f64>], facet: Vec<usize>, normal: &Vector3<f64>) -> Vec<[Vector3<f64>; 3]> {
    let corners: Vec<Vector3<f64>> = facet.into_iter().map(|place| vertices[place]).collect();
    let ring = ring(corners, normal);
    let Some(first) = ring.first().copied() else { return Vec::new() };
    ring.windows(2).skip(1).map(|pair| [first, pair[0], pair[1]]).collect()
}

/// The convex polygon around points of a plane, counter-clockwise about its normal: Andrew's monotone chain.
fn ring(corners: Vec<Vector3<f64>>, normal: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let across = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
    let along = normal.cross(&across);
    let key = |v: &Vector3<f64>| (v.dot(&across), v.dot(&along));
    let mut sorted = corners;
    sorted.sort_by(|a, b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let turn = |a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>| (b - a).cross(&(c - b)).dot(normal);
    let half = |points: &mut dyn Iterator<Item = &Vector3<f64>>| {
        let mut chain: Vec<Vector3<f64>> = Vec::new();
        for point in points {
            while let [.., a, b] = chain.as_slice()
                && turn(a, b, point) <= 0.0
            {
                chain.pop();
            }
            chain.push(*point);
        }
        chain.pop();
        chain
    };
    let mut ring = half(&mut sorted.iter());
    ring.extend(half(&mut sorted.iter().rev()));
    ring
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_box_is_the_box_wherever_it_is() {
        let corners = |half: Vector3<f64>, at: Vector3<f64>| -> Vec<Vector3<f64>> {
            let sign = |bit: usize, place: usize| if bit >> place & 1 == 1 { 1.0 } else { -1.0 };
            (0..8).map(|bit| at + Vector3::from_fn(|i, _| sign(bit, i) * half[i])).collect()
        };
        let (half, at) = (Vector3::new(0.5, 1.0, 1.5), Vector3::new(3.0, -1.0, 2.0));
        let mut points = corners(half, at);
        // A vertex on a face and one inside change nothing.
        points.extend([at, at + Vector3::new(0.5, 0.2, 0.1)]);
        let hull = Hull::of(&points).expect("a solid");
        assert!((hull.volume - 6.0).abs() < 1e-13 && (hull.center - at).amax() < 1e-13);
        let squares = half.component_mul(&half) / 3.0;
        let moments = Vector3::repeat(squares.sum()) - squares;
        assert!((hull.tensor - Matrix3::from_diagonal(&moments)).amax() < 1e-12);
        assert!(Hull::of(&corners(Vector3::new(1.0, 1.0, 0.0), at)).is_none());
    }
}
