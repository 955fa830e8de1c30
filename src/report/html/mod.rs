//! The report as pages of HTML: an index, a page a scene, a scheme and a subject, one script and one style sheet beside them.
//!
//! The script is written here. The one library whose crate brings its script along, plotly, weighs 4.7 MB, more than all pages
//! together, and its charts answer to no key.

mod chart;
mod leaves;
mod motion;
mod packed;

use std::io::Write;
use std::path::Path;

use minijinja::{AutoEscape, Environment, Value, context};

use super::page::Page;
use super::plot::Looks;
use super::{ReportError, template, write_page};
use crate::record::{Records, write_whole};

pub(in crate::report) use chart::largest_spin;
use leaves::{Leaf, leaves};

const SCRIPT: &str = concat!(
    include_str!("../template/script/page.js"),
    include_str!("../template/script/table.js"),
    include_str!("../template/script/chart.js"),
    include_str!("../template/script/motion.js"),
);
const STYLE: &str = include_str!("../template/style.css");

/// Templates by name.
const TEMPLATES: [(&str, &str); 17] = [
    ("macros.html", include_str!("../template/page/macros.html")),
    ("frame.html", include_str!("../template/page/frame.html")),
    ("single.html", include_str!("../template/page/single.html")),
    ("contents.html", include_str!("../template/page/contents.html")),
    ("index.html", include_str!("../template/page/index.html")),
    ("verdicts.html", include_str!("../template/page/verdicts.html")),
    ("schemes.html", include_str!("../template/page/schemes.html")),
    ("orders.html", include_str!("../template/page/orders.html")),
    ("cost.html", include_str!("../template/page/cost.html")),
    ("precision.html", include_str!("../template/page/precision.html")),
    ("drifts.html", include_str!("../template/page/drifts.html")),
    ("stability.html", include_str!("../template/page/stability.html")),
    ("scene.html", include_str!("../template/page/scene.html")),
    ("scheme.html", include_str!("../template/page/scheme.html")),
    ("method.html", include_str!("../template/page/method.html")),
    ("engines.html", include_str!("../template/page/engines.html")),
    ("published.html", include_str!("../template/page/published.html")),
];

/// The files that the pages of these records are.
pub(super) fn names(records: &Records) -> Vec<String> {
    let own = ["index.html", "report.css", "report.js"].map(str::to_owned);
    own.into_iter().chain(leaves(records).iter().map(Leaf::path)).collect()
}

/// Writes the pages into a folder.
pub(super) fn write(records: &Records, main: &Records, page: &Page, out: &Path) -> Result<(), ReportError> {
    let site = Site::new(records, main, page).map_err(|error| fault(out, &error))?;
    write_whole(&out.join("report.css"), STYLE.as_bytes())?;
    write_whole(&out.join("report.js"), SCRIPT.as_bytes())?;
    write_page(&out.join("index.html"), |file| site.index(file))?;
    for leaf in &site.leaves {
        write_page(&out.join(leaf.path()), |file| site.leaf(leaf, file))?;
    }
    Ok(())
}

/// Writes everything as one page.
pub(super) fn write_single(
    records: &Records,
    main: &Records,
    page: &Page,
    path: &Path,
) -> Result<(), ReportError> {
    let site = Site::new(records, main, page).map_err(|error| fault(path, &error))?;
    write_page(path, |file| site.single(file))
}

fn fault(path: &Path, error: &minijinja::Error) -> ReportError {
    ReportError::Page { path: path.into(), why: error.to_string() }
}

/// Where links of a page lead: up to the folder of the report, to another page with its ending, and to the index. None of it needs
/// an escape.
fn links(up: &str, here: &str, ending: &str, home: &str) -> Value {
    let [up, here, ending, home] =
        [up, here, ending, home].map(|text| Value::from_safe_string(text.to_owned()));
    context! { up, here, ending, home }
}

/// Everything that a page is made from.
struct Site<'a> {
    environment: Environment<'static>,
    main: &'a Records,
    records: &'a Records,
    looks: Looks,
    page: Value,
    leaves: Vec<Leaf>,
}

impl<'a> Site<'a> {
    fn new(records: &'a Records, main: &'a Records, page: &Page) -> Result<Site<'a>, minijinja::Error> {
        let mut environment = template::environment(AutoEscape::Html)?;
        for (name, text) in TEMPLATES {
            environment.add_template(name, text)?;
        }
        let page = Value::from(minijinja::value::Serde(page));
        let looks = Looks::new(records);
        Ok(Site { environment, main, records, looks, page, leaves: leaves(records) })
    }

    fn render(&self, template: &str, context: Value, writer: impl Write) -> Result<(), minijinja::Error> {
        let page = self.page.clone();
        let leaves = Value::from(minijinja::value::Serde(&self.leaves));
        let context = context! { page, leaves, ..context };
        self.environment.get_template(template)?.render_captured_to(context, writer)?;
        Ok(())
    }

    fn index(&self, writer: impl Write) -> Result<(), minijinja::Error> {
        let links = links("", "pages/", ".html", "index.html");
        let body = context! { body => "index.html", chart => self.overview()?, ..links };
        self.render("frame.html", body, writer)
    }

    fn leaf(&self, leaf: &Leaf, writer: impl Write) -> Result<(), minijinja::Error> {
        let links = links("../", "", ".html", "../index.html");
        self.render("frame.html", context! { ..self.of_leaf(leaf)?, ..links }, writer)
    }

    fn single(&self, writer: impl Write) -> Result<(), minijinja::Error> {
        let links = links("", "#", "", "#top");
        let bodies: Result<Vec<Value>, _> = self.leaves.iter().map(|leaf| self.of_leaf(leaf)).collect();
        let bodies = bodies?;
        let (style, script) = (Value::from_safe_string(STYLE.into()), Value::from_safe_string(SCRIPT.into()));
        let chart = self.overview()?;
        self.render("single.html", context! { bodies, style, script, chart, single => true, ..links }, writer)
    }

    /// What a leaf's template reads, beside the page.
    fn of_leaf(&self, leaf: &Leaf) -> Result<Value, minijinja::Error> {
        let leaf_value = Value::from(minijinja::value::Serde(leaf));
        let own = match leaf {
            Leaf { group: "scene", .. } => self.of_scene(leaf)?,
            Leaf { group: "scheme", .. } => self.of_scheme(leaf)?,
            Leaf { file, .. } if file == "precision" => self.of_precision()?,
            _ => context! {},
        };
        Ok(context! { body => leaf.template, leaf => leaf_value, ..own })
    }

    fn of_scene(&self, leaf: &Leaf) -> Result<Value, minijinja::Error> {
        let scene = leaf.name.as_str();
        let words = |row: &crate::record::Measurement| {
            (row.scheme.clone(), String::new(), self.looks.of(&row.scheme))
        };
        let title = format!("Errors at the end of a run, {scene}");
        let errors = chart::errors(self.records, &title, |row| row.scene == scene, words);
        let time = chart::against_time(self.main, &self.looks, scene);
        let motion = motion::Motions::new(self.main, &self.looks, scene);
        let own = self.page.get_attr("scenes")?.get_item(&Value::from(leaf.index))?;
        Ok(context! {
            verdicts => packed::packed(&own.get_attr("verdicts")?)?,
            attention => own.get_attr("attention")?,
            scene => own,
            errors => errors.as_ref().map(packed::packed).transpose()?,
            time => time.as_ref().map(packed::packed).transpose()?,
            motion => motion.as_ref().map(packed::packed).transpose()?,
        })
    }

    fn of_scheme(&self, leaf: &Leaf) -> Result<Value, minijinja::Error> {
        let scheme = leaf.name.as_str();
        let scenes = super::survey::scenes(self.records);
        let words = |row: &crate::record::Measurement| {
            let place = scenes.iter().position(|scene| *scene == row.scene).unwrap_or(0);
            (row.scene.clone(), String::new(), Looks::by_place(place))
        };
        let title = format!("Errors of {scheme} at the end of a run, a line a scene");
        let errors = chart::errors(self.records, &title, |row| row.scheme == scheme, words);
        let index = Value::from(leaf.index);
        Ok(context! {
            scheme => self.page.get_attr("schemes")?.get_item(&index)?,
            errors => errors.as_ref().map(packed::packed).transpose()?,
        })
    }

    fn of_precision(&self) -> Result<Value, minijinja::Error> {
        let scenes = super::survey::distinct(self.records.precision.iter().map(|row| row.scene.as_str()));
        let one = |scene: &str| {
            let chart = chart::precision(self.records, &self.looks, scene);
            let data = chart.as_ref().map(packed::packed).transpose()?;
            Ok(context! { scene, data })
        };
        let charts: Result<Vec<Value>, minijinja::Error> = scenes.into_iter().map(one).collect();
        Ok(context! { charts => charts? })
    }

    /// The errors of every scene and main scheme.
    fn overview(&self) -> Result<Option<Value>, minijinja::Error> {
        let words = |row: &crate::record::Measurement| {
            (row.scheme.clone(), row.scene.clone(), self.looks.of(&row.scheme))
        };
        let wanted = |row: &crate::record::Measurement| row.metric == "orientation-end";
        let chart = chart::errors(self.main, "Errors in every scene", wanted, words);
        chart.as_ref().map(packed::packed).transpose()
    }
}
