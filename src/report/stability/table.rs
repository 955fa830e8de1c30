//! The largest usable steps, a line a scene and scheme.

use comfy_table::{ContentArrangement, Table, TableComponent, presets};

use super::super::number;
use super::super::survey;
use crate::record::stability::{Limit, LimitStatus, Meaning, Stability};

/// Columns that the table is fit to.
const WIDTH: u16 = 150;
/// The meanings of usable, in the order of the table.
pub(super) const MEANINGS: [(Meaning, &str); 3] = [
    (Meaning::Bounded, "stays bounded"),
    (Meaning::Energy, "energy within 1 %"),
    (Meaning::Orientation, "within 0.1 rad"),
];

/// The largest usable steps as text: step, radians a step and h·ω for each meaning, then how the scheme fails first.
pub fn table(study: &Stability) -> String {
    let mut table = Table::new();
    table.load_preset(presets::UTF8_HORIZONTAL_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(WIDTH).remove_style(TableComponent::HorizontalLines);
    let titles = MEANINGS.map(|(_, title)| format!("{title}: h [s], rad a step, h·ω"));
    table.set_header(
        ["scene", "scheme"].into_iter().chain(titles.iter().map(String::as_str)).chain(["fails by"]),
    );
    for (scene, scheme) in cells(study) {
        let rows = MEANINGS.map(|(meaning, _)| find(study, scene, scheme, meaning));
        let words = rows.map(|row| row.map_or_else(String::new, words));
        let [bounded, energy, orientation] = words;
        table.add_row([scene, scheme, &bounded, &energy, &orientation, &fails_by(&rows)]);
    }
    let cut = if study.complete { "" } else { "\ninterrupted: not everything was measured" };
    format!(
        "{table}\n≥: usable at every step tried; <: at none tried; ~: some larger steps are usable again{cut}\n"
    )
}

/// Scenes and schemes in the order of the study.
fn cells(study: &Stability) -> Vec<(&str, &str)> {
    let scenes = survey::distinct(study.limits.iter().map(|row| row.scene.as_str()));
    let schemes = survey::distinct(study.limits.iter().map(|row| row.scheme.as_str()));
    scenes.into_iter().flat_map(|scene| schemes.iter().map(move |scheme| (scene, *scheme))).collect()
}

pub(super) fn find<'a>(
    study: &'a Stability,
    scene: &str,
    scheme: &str,
    meaning: Meaning,
) -> Option<&'a Limit> {
    study.limits.iter().find(|row| row.scene == scene && row.scheme == scheme && row.meaning == meaning)
}

/// A limit in print.
pub(super) fn words(row: &Limit) -> String {
    let sign = match row.status {
        LimitStatus::Unlimited => "≥ ",
        LimitStatus::None => {
            return format!(
                "< {}",
                row.fails_at_s.map_or(String::new(), |step| number::significant(step, 3))
            );
        }
        LimitStatus::NotApplicable => return "n/a".to_owned(),
        LimitStatus::Broken => return "no reference".to_owned(),
        _ if row.ragged => "~ ",
        _ => "",
    };
    let three = |value: Option<f64>| value.map_or_else(String::new, |value| number::significant(value, 3));
    format!("{sign}{}, {}, {}", three(row.step_s), three(row.radians_per_step), three(row.h_omega))
}

/// How the scheme fails above its limits, the loosest first; the reason where it cannot take the scene.
pub(super) fn fails_by(rows: &[Option<&Limit>; 3]) -> String {
    let refused = rows.iter().flatten().find(|row| !row.step_or_none());
    if let Some(row) = refused {
        return row.detail.clone().unwrap_or_default();
    }
    let classes = rows.iter().flatten().filter_map(|row| row.failure.as_deref());
    survey::distinct(classes).join(", ")
}
