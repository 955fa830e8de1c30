//! The outline as a witness: a change after which the tensor is that of the uniform solid.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Matrix3, Vector3};

use super::super::change::{self, Change};
use super::super::link::{MOMENTS, PRODUCTS, tensor_of};
use super::super::outline::{Outline, Uniform};
use super::super::verdict::{Verdict, principal};
use super::{CLOSE, Case, Repair, close};
use crate::model::body::second_moment_inertia;
use crate::rotation;

/// Osmium, the densest matter at hand [kg/m³]: 22 590.
const DENSEST: f64 = 22_600.0;
/// Slips of a unit of a tensor: gram for kilogram, millimetre for metre, both, either way.
const SLIPS: [i32; 6] = [-9, -6, -3, 3, 6, 9];
/// Slips of a unit of a mass: gram, tonne.
const SLIPS_OF_MASS: [i32; 2] = [-3, 3];
/// A hollow or a dense body differs from the uniform one by less than this; the next power of a slip by 1000.
const HOLLOW: f64 = 3.0;
/// The shape of a tensor, scaled to trace one, differs from that of the uniform solid by less than a tenth.
const ALIKE: f64 = 0.1;

/// The outline, where it is made of primitives only.
fn exact<'a>(case: &Case<'a>) -> Option<(Outline, Uniform)> {
    let outline = Outline::of(case.link).filter(|outline| outline.exact)?;
    let uniform = outline.uniform.clone()?;
    Some((outline, uniform))
}

pub(super) fn repairs(case: &Case, changes: &[Change]) -> Vec<Repair> {
    let Some((outline, uniform)) = exact(case) else { return Vec::new() };
    let has = |finding: &str| case.judged.findings.contains(&finding);
    let mass = case.mass();
    if has("inertia-without-mass") {
        return mass_of(case, &uniform);
    }
    if has("not-a-number") || has("negative-mass") || mass == 0.0 {
        return Vec::new();
    }
    let sound = |tensor: &Matrix3<f64>, mass: f64| {
        mass / uniform.volume <= DENSEST && close(tensor, &(uniform.tensor * mass), CLOSE)
    };
    let centered = (case.inertial.pose.position - uniform.center).norm() <= CLOSE * outline.size();
    let given = case.inertial.tensor();
    if has("zero-inertia-with-geometry") {
        return sphere_or_box(case, &uniform);
    }
    if !centered {
        return Vec::new();
    }
    if sound(&given, mass) {
        return if has("duplicate-inertial") { vec![remove_second(case, given)] } else { Vec::new() };
    }
    if case.judged.verdict == Verdict::Rounding {
        return Vec::new();
    }
    let mut tried = bodies(case, changes, &uniform);
    tried.retain(|repair| sound(&repair.tensor, repair.mass));
    for repair in &mut tried {
        let off = (repair.tensor - uniform.tensor * repair.mass).amax() / repair.tensor.trace();
        repair.how_known +=
            &format!("the tensor is then that of the uniform outline, to {off:.0e} of its trace");
        if repair.kind == "scale-mass" {
            let density = mass / uniform.volume;
            repair.how_known +=
                &format!("; as found the density is {density:.1e} kg/m³, and osmium has 22 590");
        }
    }
    tried
}

/// The mass under which a tensor without one is that of the uniform solid.
fn mass_of(case: &Case, uniform: &Uniform) -> Vec<Repair> {
    let tensor = case.inertial.tensor();
    let mass = tensor.trace() / uniform.tensor.trace();
    if mass / uniform.volume > DENSEST || !close(&tensor, &(uniform.tensor * mass), CLOSE) {
        return Vec::new();
    }
    let how = "the tensor has the proportions of the uniform outline, and is that of this mass".to_owned();
    vec![Repair { mass, ..case.repair("mass-from-outline", format!("mass {mass:.6} kg"), how, tensor) }]
}

fn remove_second(case: &Case, tensor: Matrix3<f64>) -> Repair {
    let how =
        "the first is the tensor of the uniform outline; parsers take the first, and every format admits one"
            .to_owned();
    case.repair("remove-second", "remove the second <inertial>".to_owned(), how, tensor)
}

/// Everything that is tried, with the body that it ends in.
fn bodies(case: &Case, changes: &[Change], uniform: &Uniform) -> Vec<Repair> {
    let (mass, given, pose) = (case.mass(), case.inertial.tensor(), case.inertial.pose);
    let plain = |kind, what, tensor| case.repair(kind, what, String::new(), tensor);
    let mut tried = Vec::new();
    for power in SLIPS {
        let what = format!("multiply all six numbers by 1e{power}");
        tried.push(plain("scale-inertia", what, given * 10f64.powi(power)));
    }
    for power in SLIPS_OF_MASS {
        let mass = mass * 10f64.powi(power);
        tried
            .push(Repair { mass, ..plain("scale-mass", format!("mass {mass} kg (times 1e{power})"), given) });
    }
    let possible = change::possible(&case.inertial.values(), case.format);
    for change in if changes.is_empty() { &possible } else { changes } {
        let tensor = pose.turned(&tensor_of(&change.six));
        tried.push(plain(change.kind, in_words(change), tensor));
    }
    let steiner = second_moment_inertia(&pose.position) * mass;
    if steiner.amax() > 0.0 {
        let what =
            "subtract m (|c|² E − c cᵀ), c the centre of mass: the numbers are about the origin of the link"
                .to_owned();
        tried.push(plain("parallel-axis", what, given - steiner));
    }
    if close(&given, &(uniform.parts * mass), CLOSE) {
        let what = "add Σ m_k (|d_k|² E − d_k d_kᵀ), d_k from the centre of mass to each part: the tensor found is the sum of the \
                    tensors of the parts about their own centres";
        tried.push(plain("parallel-axis-of-parts", what.to_owned(), uniform.tensor * mass));
    }
    tried.extend(quarter_turns(case));
    tried
}

fn in_words(change: &Change) -> String {
    match change.kind {
        "flip-products" | "flip-diagonal" if change.label.contains(' ') => {
            format!("{} change their signs", change.label.replace(' ', ", "))
        }
        "flip-products" | "flip-diagonal" => format!("{} changes its sign", change.label),
        _ => change.label.clone(),
    }
}

/// The frame of the inertial turned by a quarter about an axis, or cyclically.
fn quarter_turns(case: &Case) -> Vec<Repair> {
    let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let third = Vector3::repeat(2.0 * PI / 3.0 / 3f64.sqrt());
    let turns = [
        (x * FRAC_PI_2, "turn the axes of the inertial by 1.5707963 about x (or exchange iyy and izz)"),
        (y * FRAC_PI_2, "turn the axes of the inertial by 1.5707963 about y (or exchange ixx and izz)"),
        (z * FRAC_PI_2, "turn the axes of the inertial by 1.5707963 about z (or exchange ixx and iyy)"),
        (third, "exchange the axes of the inertial cyclically (x to y, y to z, z to x)"),
        (-third, "exchange the axes of the inertial cyclically (x to z, z to y, y to x)"),
    ];
    let own = tensor_of(&case.inertial.values());
    turns
        .into_iter()
        .map(|(turn, what)| {
            let axes = rotation::axes(&rotation::turn(&turn));
            let tensor = case.inertial.pose.turned(&(axes * own * axes.transpose()));
            case.repair(
                "rotate-inertial-frame",
                what.to_owned(),
                "the moments are those of the outline on other axes; ".to_owned(),
                tensor,
            )
        })
        .collect()
}

/// A slip of a unit where the body is not uniform: the only power of ten that comes within a factor of three.
pub(super) fn slips_of_unit(case: &Case) -> Vec<Repair> {
    let Some((outline, uniform)) = exact(case) else { return Vec::new() };
    if case.judged.verdict != Verdict::Suspect || is_placeholder(case) || case.judged.fill.is_none() {
        return Vec::new();
    }
    let given = case.inertial.tensor();
    let alike = close(&(given / given.trace()), &(uniform.tensor / uniform.tensor.trace()), ALIKE);
    if !alike || case.mass() / uniform.volume > DENSEST {
        return Vec::new();
    }
    let ratio = given.trace() / (case.mass() * uniform.tensor.trace());
    SLIPS
        .into_iter()
        .filter_map(|power| {
            let scale = 10f64.powi(power);
            let fits = (1.0 / HOLLOW..=HOLLOW).contains(&(ratio * scale));
            let fill = outline.fill(case.mass(), &case.inertial.pose.position, &(given * scale))?;
            let how = format!(
                "tr I is then {:.2} times that of the uniform outline, with the moments in the same proportions; no other unit comes \
                 within a factor of {HOLLOW}",
                ratio * scale
            );
            let what = format!("multiply all six numbers by 1e{power}");
            (fits && fill <= 1.0).then(|| case.repair("scale-inertia", what, how, given * scale))
        })
        .collect()
}

/// Three equal moments and no products: no shape was measured.
fn is_placeholder(case: &Case) -> bool {
    let six = case.inertial.values();
    let first = six[MOMENTS[0]];
    MOMENTS.iter().all(|place| six[*place] == first) && PRODUCTS.iter().all(|place| six[*place] == 0.0)
}

/// A placeholder or no number at all: the uniform solid is one body of many.
pub(super) fn placeholders(case: &Case) -> Vec<Repair> {
    let Some((_, uniform)) = exact(case) else { return Vec::new() };
    let unread = case.judged.findings.contains(&"not-a-number");
    let placeholder = case.judged.verdict == Verdict::Suspect && is_placeholder(case);
    let mass = case.mass();
    if !(unread || placeholder) || !(mass > 0.0 && mass.is_finite()) || mass / uniform.volume > DENSEST {
        return Vec::new();
    }
    let how = if unread {
        "nothing in the file knows the tensor; the uniform solid is one of many that fit".to_owned()
    } else {
        "three equal moments are a placeholder, and no unit gives them the shape of the outline; the uniform solid is one of many that fit"
            .to_owned()
    };
    let what = format!("the tensor of the uniform outline of {mass} kg");
    let repair = case.repair("tensor-from-outline", what, how, uniform.tensor * mass);
    vec![Repair { unique: false, center: uniform.center, ..repair }]
}

/// No tensor at all beside a single shape.
fn sphere_or_box(case: &Case, uniform: &Uniform) -> Vec<Repair> {
    let tensor = uniform.tensor * case.mass();
    let what = format!("the tensor of the uniform outline of {} kg", case.mass());
    let how = "a massive body with an outline of finite size has moments above zero".to_owned();
    let single = case.link.solids.len().max(case.link.drawn.len()) == 1;
    let (moments, _) = principal(&tensor);
    let repair = case.repair("tensor-from-outline", what, how, tensor);
    let repair = Repair { unique: single, center: uniform.center, ..repair };
    if moments[0] > 0.0 { vec![repair] } else { Vec::new() }
}
