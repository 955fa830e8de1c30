//! The bodies of robot descriptions and of scenes: can they exist, and which one repair makes them possible?
//!
//! URDF, MJCF and SDF are read as far as the mass of rigid links goes; joints are listed nowhere and left alone. `verdict` has the rules,
//! `repair` what may be called a repair.

mod change;
mod element;
mod error;
mod json;
mod link;
mod mjcf;
mod outline;
mod pose;
mod printed;
mod repair;
mod scene;
mod sdf;
mod solid;
mod urdf;
mod verdict;

use std::collections::BTreeMap;
use std::path::Path;

use nalgebra::Matrix3;
use rayon::prelude::*;

pub use error::InspectError;
pub use verdict::Verdict;

use crate::bounded::{self, FileError};
use crate::scenes::Scene;
use link::{Link, Robot};
use repair::{Advice, Case, Repair, Sides};
use verdict::Judged;

/// Most bodies of a file: an impossible one takes some 0.1 ms.
const MOST_BODIES: usize = 100_000;

/// The bodies of a file, judged.
#[derive(Clone, Debug)]
pub struct Inspection {
    /// File as the user named it.
    pub file: String,
    /// urdf, mjcf, sdf or scene.
    pub format: &'static str,
    bodies: Vec<(Link, Judged)>,
    advice: Vec<Advice>,
    /// Integrator and step that the file has in force.
    pub stepping: Option<Stepping>,
    /// Remarks about the file.
    pub notes: Vec<String>,
}

/// Which integrator a file has in force.
#[derive(Clone, Debug)]
pub struct Stepping {
    /// Its name, with where it comes from.
    pub integrator: String,
    /// Step [s].
    pub step: f64,
    /// Whether the file says the step; else it is the default of the format.
    pub step_given: bool,
    /// The scheme of this project that is nearest on a free body.
    pub scheme: Option<&'static str>,
}

/// A scene of one body.
#[derive(Clone, Debug)]
pub struct Written {
    /// Name of the body in the file.
    pub body: String,
    /// Name of the scene.
    pub name: String,
    /// The scene file.
    pub text: String,
    /// The scene, read back.
    pub scene: Scene,
    /// Whether it is the body as repaired.
    pub repaired: bool,
}

/// One body in words.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Name of the body.
    pub name: String,
    /// Line of the file.
    pub line: usize,
    /// The verdict.
    pub verdict: Verdict,
    /// Mass [kg] and principal moments, ascending [kg m²], where there are such.
    pub numbers: Option<(f64, [f64; 3])>,
    /// What was seen, with its numbers.
    pub seen: Vec<String>,
    /// What makes the body possible, or that several things would, or that nothing does.
    pub repair: Vec<String>,
    /// Remarks that are no fault.
    pub remarks: Vec<String>,
}

/// Reads a file and judges its bodies.
///
/// # Errors
/// [`InspectError`]: the file cannot be read, or is no URDF, MJCF, SDF or scene.
pub fn inspect(path: &Path) -> Result<Inspection, InspectError> {
    let file = path.display().to_string();
    let text = bounded::text(path, bounded::MOST_OF_A_SCENE)?;
    let robot = read(&text, &file, path)?;
    let bodies: Vec<(Link, Judged)> = robot
        .links
        .into_iter()
        .map(|link| {
            let judged = Judged::of(&link);
            (link, judged)
        })
        .collect();
    if bodies.len() > MOST_BODIES {
        let why = format!("{} bodies, and {MOST_BODIES} are the most that are judged", bodies.len());
        return Err(FileError::Content { file, line: 1, why }.into());
    }
    let sides = Sides::of(&bodies);
    let advise = |(link, judged): &(Link, Judged)| {
        let inertial = link.inertial.as_ref()?;
        let case = Case { link, judged, inertial, format: robot.format, all: &bodies, sides: &sides };
        Some(repair::find(&case))
    };
    let advice = bodies.par_iter().map(|body| advise(body).unwrap_or_default()).collect();
    Ok(Inspection {
        file,
        format: robot.format,
        bodies,
        advice,
        stepping: robot.stepping,
        notes: robot.notes,
    })
}

fn read(text: &str, file: &str, path: &Path) -> Result<Robot, InspectError> {
    if path.extension().is_some_and(|extension| extension == "toml") {
        return scene::read(text, file);
    }
    let mut root = element::parse(text, file)?;
    match root.name.as_str() {
        "robot" => urdf::read(&root),
        "sdf" => sdf::read(&root),
        "mujoco" => mjcf::read(&mut root, path),
        other => {
            let shown: String = other.chars().take(40).collect();
            let why = format!("<{shown}> begins no robot: expected <robot> (URDF), <mujoco> (MJCF), <sdf>, or a scene that ends in .toml");
            return Err(FileError::Content { file: file.to_owned(), line: root.line, why }.into());
        }
    }
    .map_err(|faults| InspectError::Content {
        file: file.to_owned(),
        text: text.to_owned(),
        faults: faults.sorted(),
    })
}

impl Inspection {
    /// How many bodies have each verdict, the worst first.
    pub fn counts(&self) -> Vec<(Verdict, usize)> {
        let count = |verdict| self.bodies.iter().filter(|(_, judged)| judged.verdict == verdict).count();
        Verdict::ALL
            .into_iter()
            .map(|verdict| (verdict, count(verdict)))
            .filter(|(_, count)| *count > 0)
            .collect()
    }

    /// Whether some body has a fault: impossible by its numbers or its outline, with a repair that has a witness, or given twice.
    pub fn has_faults(&self) -> bool {
        let bad = |judged: &Judged| {
            judged.verdict <= Verdict::Suspect || judged.findings.contains(&"duplicate-inertial")
        };
        let repairable = |advice: &Advice, judged: &Judged| {
            judged.verdict != Verdict::Rounding && (advice.repair.is_some() || !advice.several.is_empty())
        };
        self.bodies
            .iter()
            .zip(&self.advice)
            .any(|((_, judged), advice)| bad(judged) || repairable(advice, judged))
    }

    /// Whether any body has numbers to judge.
    pub fn is_empty(&self) -> bool {
        self.bodies.iter().all(|(link, _)| link.inertial.is_none())
    }

    /// Every body in words, in the order of the file.
    pub fn summaries(&self) -> Vec<Summary> {
        self.bodies
            .iter()
            .zip(&self.advice)
            .map(|((link, judged), advice)| summary(link, judged, advice))
            .collect()
    }

    /// A scene of each body that can exist, and of each that can after its one repair.
    pub fn scenes(&self) -> Vec<Written> {
        let path = Path::new(&self.file);
        let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let stem = stem.trim_end_matches(".mjcf").to_owned();
        let mut taken = BTreeMap::new();
        let mut written = Vec::new();
        for ((link, judged), advice) in self.bodies.iter().zip(&self.advice) {
            let Some(inertial) = &link.inertial else { continue };
            let unique = advice.repair.as_ref().filter(|repair| repair.unique);
            if judged.verdict >= Verdict::Limit && judged.verdict <= Verdict::Possible {
                let found = (inertial.mass.value, inertial.tensor(), false);
                written.extend(self.scene(&stem, link, found, &mut taken));
            }
            if let Some(Repair { mass, tensor, .. }) = unique {
                written.extend(self.scene(&stem, link, (*mass, *tensor, true), &mut taken));
            }
        }
        written
    }

    fn scene(
        &self,
        stem: &str,
        link: &Link,
        (mass, tensor, repaired): (f64, Matrix3<f64>, bool),
        taken: &mut BTreeMap<String, usize>,
    ) -> Option<Written> {
        let base = scene::name_of(stem, &link.name) + if repaired { "-repaired" } else { "" };
        let mut count = taken.get(&base).copied().unwrap_or(1);
        let mut name = base.clone();
        while taken.contains_key(&name) {
            count += 1;
            name = format!("{base}-{count}");
        }
        let state = if repaired { "repaired, " } else { "" };
        let why = format!(
            "the body {} of {}, {state}about its centre of mass, in the axes of its link",
            link.name, self.file
        );
        let text = scene::text(&name, &why, mass, &tensor);
        let scene = Scene::parse(&text, &format!("{name}.toml")).ok()?;
        taken.insert(base, count);
        taken.entry(name.clone()).or_insert(1);
        Some(Written { body: link.name.clone(), name, text, scene, repaired })
    }

    /// As JSON, schema polhode/inspect/1.
    pub fn to_json(&self) -> serde_json::Value {
        json::of(self)
    }
}

fn summary(link: &Link, judged: &Judged, advice: &Advice) -> Summary {
    let numbers =
        link.inertial.as_ref().zip(judged.moments).map(|(inertial, moments)| (inertial.mass.value, moments));
    let mut remarks = link.notes.clone();
    if let Some((mass, moments)) = link.compiled {
        let [a, b, c] = moments;
        remarks.push(format!(
            "the compiler makes of it mass {mass:.6e} kg, moments {a:.6e} {b:.6e} {c:.6e} kg m², silently"
        ));
    }
    Summary {
        name: link.name.clone(),
        line: link.line,
        verdict: judged.verdict,
        numbers,
        seen: judged
            .findings
            .iter()
            .map(|finding| in_words(finding, link, judged))
            .chain(advice.oddities.iter().cloned())
            .collect(),
        repair: repair_in_words(judged, advice),
        remarks,
    }
}

fn in_words(finding: &str, link: &Link, judged: &Judged) -> String {
    let largest = judged.moments.map_or(f64::NAN, |moments| moments[2]);
    let meshes = if judged.outline.as_ref().is_some_and(|outline| !outline.exact) {
        " (it has meshes beside its primitives, so this proves nothing)"
    } else {
        ""
    };
    let ratio = judged.uniform_ratio.unwrap_or(f64::NAN);
    match finding {
        "triangle" => format!(
            "I₁ + I₂ < I₃: short by {:.2e} kg m², {:.2} % of I₃; the printed digits can hide {:.2e} kg m²",
            -judged.slack,
            -100.0 * judged.slack / largest,
            judged.resolution
        ),
        "triangle-by-rounding" => format!(
            "I₁ + I₂ < I₃ by {:.2e} kg m², which the printed digits can hide ({:.2e} kg m²)",
            -judged.slack, judged.resolution
        ),
        "negative-moment" | "negative-moment-by-rounding" => {
            let moment = judged.moments.map_or(f64::NAN, |moments| moments[0]);
            format!(
                "a principal moment is {moment:.3e} kg m², below zero: the tensor is not positive definite"
            )
        }
        "zero-moment" => "a principal moment is zero: all mass on a line".to_owned(),
        "flat" => "I₁ + I₂ = I₃: all mass in a plane".to_owned(),
        "point-mass" => "no inertia: all mass in a point".to_owned(),
        "not-a-number" => "a number is not finite".to_owned(),
        "inertia-without-mass" => "inertia without mass".to_owned(),
        "negative-mass" => "a mass below zero".to_owned(),
        "zero-inertia-with-geometry" => "mass without inertia, and shapes of finite size".to_owned(),
        "zero-mass-with-geometry" => "shapes without mass: a frame".to_owned(),
        "com-outside-outline" => format!("the centre of mass is outside its outline{meshes}"),
        "larger-than-its-outline" => {
            format!(
                "{:.4} times the largest inertia that mass inside its outline has{meshes}",
                judged.fill.unwrap_or(f64::NAN)
            )
        }
        "much-smaller-than-its-outline" => {
            format!("tr I is {ratio:.2e} of that of the uniform solid of its outline{meshes}")
        }
        "duplicate-inertial" => format!("{} elements <inertial>: the first is judged", link.inertials),
        other => other.to_owned(),
    }
}

fn repair_in_words(judged: &Judged, advice: &Advice) -> Vec<String> {
    let line = |repair: &Repair| [repair.what.clone(), format!("  witness: {}", repair.how_known)];
    if let Some(repair) = &advice.repair {
        let word = if repair.unique { "repair" } else { "one of several that would do" };
        let [what, witness] = line(repair);
        return vec![format!("{word}: {what}"), witness];
    }
    if !advice.several.is_empty() {
        let all = advice.several.iter().flat_map(line).map(|line| format!("  {line}"));
        return std::iter::once("several repairs have a witness, and the file does not decide:".to_owned())
            .chain(all)
            .collect();
    }
    match &advice.candidates {
        Some(candidates) if candidates.is_empty() => vec![
            "no repair: no power of ten on one number, no sign, no other order of the six makes it possible"
                .to_owned(),
        ],
        Some(candidates) => vec![format!(
            "no repair has a witness in the file; each of these alone would make the numbers possible, as a guess: {}",
            candidates.join("; ")
        )],
        None if judged.verdict <= Verdict::Suspect => {
            vec!["no repair: nothing in the file says which number is wrong".to_owned()]
        }
        None => Vec::new(),
    }
}
