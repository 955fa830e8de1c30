//! Which pages there are.

use serde::Serialize;

use crate::record::Records;
use crate::report::survey;

/// A page beside the index.
#[derive(Serialize)]
pub(super) struct Leaf {
    /// File name without its ending, and anchor where all pages are one.
    pub file: String,
    /// What its link says.
    pub title: String,
    /// `scene`, `scheme` or `subject`.
    pub group: &'static str,
    /// The template of its body.
    pub template: &'static str,
    /// The scene or scheme, …
    pub name: String,
    /// … and its place among them.
    pub index: usize,
}

impl Leaf {
    /// Path inside the folder of the report.
    pub(super) fn path(&self) -> String {
        format!("pages/{}.html", self.file)
    }

    fn subject(file: &'static str, title: &str, template: &'static str) -> Leaf {
        Leaf {
            file: file.into(),
            title: title.into(),
            group: "subject",
            template,
            name: String::new(),
            index: 0,
        }
    }
}

/// The pages of these records, subjects first.
pub(super) fn leaves(records: &Records) -> Vec<Leaf> {
    let subjects = [
        ("verdicts", "What does not hold", "verdicts.html", !records.verdicts.is_empty()),
        ("schemes", "Schemes", "schemes.html", !records.schemes.is_empty()),
        ("orders", "Orders", "orders.html", !records.orders.is_empty()),
        ("cost", "Cost and ranking", "cost.html", !records.measurements.is_empty()),
        ("drifts", "Drifts", "drifts.html", !records.drifts.is_empty()),
        ("stability", "Stability", "stability.html", !records.schemes.is_empty()),
        ("precision", "Precision", "precision.html", !records.precision.is_empty()),
        ("engines", "Engines", "engines.html", !records.engines.is_empty()),
        ("published", "Published numbers", "published.html", !records.published.is_empty()),
        ("method", "Method", "method.html", true),
    ];
    let mut leaves: Vec<Leaf> = subjects
        .into_iter()
        .filter(|(.., holds)| *holds)
        .map(|(file, title, template, _)| Leaf::subject(file, title, template))
        .collect();
    let of = |group: &'static str, template: &'static str, index: usize, name: &str| Leaf {
        file: format!("{group}-{}", survey::file_stem(name)),
        title: name.into(),
        group,
        template,
        name: name.into(),
        index,
    };
    let scenes = survey::scenes(records).into_iter().enumerate();
    leaves.extend(scenes.map(|(index, name)| of("scene", "scene.html", index, name)));
    let schemes = records.schemes.iter().enumerate();
    leaves.extend(schemes.map(|(index, row)| of("scheme", "scheme.html", index, &row.name)));
    leaves
}
