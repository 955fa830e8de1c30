//! The report, made from records that no campaign wrote: what it must hold whatever was measured.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use super::synthetic::few;
use crate::common::plots;
use polhode::internals::report;
use polhode::record::{
    CostRow, Drift, Grows, Growth, Measurement, Order, OrderStatus, PrecisionRow, PrecisionRun, Reach,
    Records, RunStatus, SCHEMA, ScalingRow, SchemeRow, Series, Verdict,
};

/// Writes the report into a fresh folder.
fn written(records: &Records) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a file of the test itself");
    report::write(records, folder.path(), &|_, _| ()).expect("a file of the test itself");
    folder
}

#[test]
fn two_reports_of_the_same_records_are_the_same_to_the_byte() {
    let records = few(&[1, 3, 4]);
    let (first, second) = (written(&records), written(&records));
    for path in plots(first.path()) {
        let twin = second.path().join("plots").join(path.file_name().expect("a file of the test itself"));
        assert!(
            fs::read(&path).expect("a file of the test itself")
                == fs::read(twin).expect("a file of the test itself"),
            "{}",
            path.display()
        );
    }
    for name in [
        "index.html",
        "report.md",
        "records.json",
        "records.csv",
        "orders.csv",
        "constants.csv",
        "drifts.csv",
    ] {
        assert!(
            fs::read(first.path().join(name)).expect("a file of the test itself")
                == fs::read(second.path().join(name)).expect("a file of the test itself"),
            "{name}"
        );
    }
}

#[test]
fn markdown_tables_keep_their_columns_whatever_the_text_holds() {
    let folder = written(&few(&[5, 9]));
    let text = fs::read_to_string(folder.path().join("report.md")).expect("a file of the test itself");
    let mut columns = None;
    for line in text.lines() {
        let bars = line.replace("\\|", "").matches('|').count();
        if line.starts_with('|') {
            assert_eq!(*columns.get_or_insert(bars), bars, "{line}");
        } else {
            columns = None;
        }
    }
    assert!(text.contains("](plots/overview.png)") && text.contains("](plots/scene-09-convergence.png)"));
    assert!(text.contains("the motion is chaotic"));
}

#[test]
fn records_with_nothing_in_them_make_a_report() {
    let records = Records { schema: SCHEMA.into(), ..Records::default() };
    let folder = written(&records);
    let page = fs::read_to_string(folder.path().join("index.html")).expect("a file of the test itself");
    assert!(page.contains("The run was interrupted"));
    assert!(
        fs::read_to_string(folder.path().join("report.md"))
            .expect("a file of the test itself")
            .contains("The run was interrupted")
    );
    assert!(report::junit(&records).contains("<testsuites"));
    assert_eq!(report::annotations(&records), "");
    assert!(report::verdict_table(&records, true).contains("0 verdicts: no verdicts · interrupted"));
}

#[test]
fn rows_that_name_no_known_scene_or_hold_no_number_make_a_report() {
    let empty = Series { scene: "../odd".into(), quantity: "total-energy".into(), ..Series::default() };
    let broken = Measurement {
        scene: "../odd".into(),
        scheme: "x".into(),
        metric: "position-end".into(),
        status: RunStatus::Broken,
        step_s: 0.1,
        ..Measurement::default()
    };
    let not_a_number = Measurement { value: Some(f64::NAN), status: RunStatus::Ok, ..broken.clone() };
    let records = Records {
        schema: SCHEMA.into(),
        measurements: [broken, not_a_number, Measurement::default()].map(Arc::new).into(),
        orders: vec![Order {
            status: OrderStatus::Decided,
            quantity: "orientation".into(),
            ..Order::default()
        }],
        drifts: vec![Drift::default()],
        verdicts: vec![Verdict::default()],
        series: [empty, Series::default()].map(Arc::new).into(),
        ..Records::default()
    };
    let folder = written(&records);
    // A run that broke and a number that is none make no line.
    assert!(!folder.path().join("plots/-odd-convergence.png").exists());
    assert!(folder.path().join("index.html").exists());
    report::junit(&records);
    report::verdict_table(&records, true);
}

#[test]
fn pictures_that_an_earlier_report_left_are_removed() {
    let folder = written(&few(&[1, 2]));
    report::write(&few(&[2]), folder.path(), &|_, _| ()).expect("a file of the test itself");
    let names: Vec<String> = plots(folder.path())
        .iter()
        .map(|path| path.file_name().expect("a file of the test itself").to_string_lossy().into_owned())
        .collect();
    assert_eq!(
        names,
        [
            "drift-rates.png",
            "overview-narrow.png",
            "overview.png",
            "scene-02-convergence.png",
            "scene-02-invariants.png",
            "scene-02-work-precision-motion.png",
            "scene-02-work-precision-rotation.png"
        ]
    );
}

/// Whether a picture of this name was drawn.
fn is_drawn(folder: &Path, name: &str) -> bool {
    folder.join("plots").join(name).exists()
}

#[test]
fn costs_stand_in_a_table_with_their_noise_and_gaps_are_said() {
    let cost = |scheme: &str, kind: &str, nanoseconds, again| CostRow {
        scheme: scheme.into(),
        kind: kind.into(),
        model: kind.into(),
        scene: format!("{kind} {nanoseconds}"),
        nanoseconds_per_step: nanoseconds,
        evaluations_per_step: 2.0,
        seconds: 0.25,
        again,
        ..CostRow::default()
    };
    let mut records = few(&[1, 2]);
    records.costs = vec![
        cost("peskin-rk2", "free", 50.0, false),
        cost("peskin-rk2", "forced", 100.0, false),
        cost("peskin-rk2", "forced", 180.0, false),
        cost("euler", "free", 30.0, false),
        CostRow { scene: "free 50".into(), ..cost("peskin-rk2", "free", 51.0, true) },
    ];
    let folder = written(&records);
    let text = fs::read_to_string(folder.path().join("report.md")).expect("a file of the test itself");
    assert!(text.contains("| peskin-rk2 | 50.0 (2) | 100 to 180 (2) |"), "{text}");
    assert!(text.contains("| euler | 30.0 (2) | – |"));
    assert!(text.contains("timed twice: the two differ by 2.0 %") && text.contains("at least 0.25 s"));
    let without = written(&few(&[1]));
    assert!(
        !fs::read_to_string(without.path().join("report.md"))
            .expect("a file of the test itself")
            .contains("## Cost")
    );
}

#[test]
fn the_overview_of_cost_needs_two_families_and_scaling_its_rows() {
    let mut records = few(&[1, 2]);
    let pictures = ["cheapest-by-time.png", "cheapest-by-evaluations.png", "scaling.png"];
    let folder = written(&records);
    assert!(pictures.iter().all(|name| !is_drawn(folder.path(), name)));
    records.schemes[1].family = "another".into();
    let row = |size, value| ScalingRow {
        what: Grows::Points,
        scheme: "peskin-rk2".into(),
        form: "points, free".into(),
        size,
        value,
        ..ScalingRow::default()
    };
    records.scaling = vec![row(1, 50.0), row(1000, 5e4)];
    assert!(!is_drawn(written(&records).path(), "scaling.png"));
    records.scaling.extend([row(10, 500.0), row(100, 5e3)]);
    let folder = written(&records);
    assert!(pictures.iter().all(|name| is_drawn(folder.path(), name)));
    let page = fs::read_to_string(folder.path().join("pages/cost.html")).expect("a file of the test itself");
    assert!(pictures.iter().all(|name| page.contains(&format!("../plots/{name}"))));
}

#[test]
fn schemes_that_stand_apart_have_pictures_that_the_page_names_and_does_not_hold() {
    let mut records = few(&[1]);
    let apart = SchemeRow { name: "apart".into(), apart: true, ..records.schemes[0].clone() };
    records.schemes.push(apart);
    let more: Vec<Measurement> = records
        .measurements
        .iter()
        .filter(|row| row.scheme == "euler")
        .map(|row| Measurement { scheme: "apart".into(), ..(**row).clone() })
        .collect();
    let main = written(&few(&[1]));
    records.measurements.extend(more.into_iter().map(Arc::new));
    let folder = written(&records);
    let name = "scene-01-work-precision-of-all-rotation.png";
    assert!(is_drawn(folder.path(), name) && !is_drawn(main.path(), name));
    let page = folder.path().join("pages/scene-scene-01.html");
    let page = fs::read_to_string(page).expect("a file of the test itself");
    assert!(page.contains(&format!("href=\"../plots/{name}\"")));
    assert!(folder.path().join("pages/scheme-apart.html").exists());
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error_with_its_name() {
    let folder = tempfile::tempdir().expect("a file of the test itself");
    let file = folder.path().join("file");
    fs::write(&file, "").expect("a file of the test itself");
    let error = report::write(&few(&[1]), &file.join("out"), &|_, _| ()).unwrap_err();
    assert!(matches!(error, report::ReportError::File(_)), "{error}");
    assert!(error.to_string().contains("file"), "{error}");
}

#[test]
fn precision_has_a_picture_and_a_table_that_says_bounds() {
    let mut records = few(&[1]);
    let run = |n: u32, error| PrecisionRun {
        steps: 16 << n,
        step_s: 0.5 / f64::from(1 << n),
        error_rad: Some(error),
        rounding_rad: Some(1e-6),
    };
    let row = |arithmetic: &str, reach, errors: [f64; 3]| PrecisionRow {
        scene: records.scenes[0].name.clone(),
        scheme: records.schemes[0].name.clone(),
        arithmetic: arithmetic.into(),
        smallest_error_rad: Some(errors[1]),
        at_step_s: Some(0.25),
        reach,
        growth: Some(Growth::new(0.52, 0.1)),
        runs: (0u32..).zip(errors).map(|(n, error)| run(n, error)).collect(),
    };
    let rows = vec![
        row("f32", Some(Reach::Rounding), [1e-3, 2e-5, 5e-5]),
        row("f64", Some(Reach::Falling), [1e-3, 1.5e-5, 1e-6]),
        row("double-double", None, [1e-3, 1.5e-5, 1e-6]),
    ];
    assert!(!is_drawn(written(&records).path(), "precision.png"));
    records.precision = rows;
    let folder = written(&records);
    assert!(is_drawn(folder.path(), "precision.png"));
    let text = fs::read_to_string(folder.path().join("report.md")).expect("a file of the test itself");
    assert!(
        text.contains(
            "| 2.0×10⁻⁵ | 0.25 | 0.52 ± 0.10: √n | ≤ 1.5×10⁻⁵, still falls | ≤ 0.25 | 0.52 ± 0.10: √n |"
        ),
        "{text}"
    );
    let page = folder.path().join("pages/precision.html");
    assert!(fs::read_to_string(page).expect("a file of the test itself").contains("../plots/precision.png"));
    assert_eq!(
        Records::read(&folder.path().join("records.json")).expect("records").precision,
        records.precision
    );
}

#[test]
fn a_picture_asked_for_as_svg_stands_beside_its_png() {
    let folder = tempfile::tempdir().expect("a file of the test itself");
    let write = |pictures| {
        report::write_with(&few(&[1]), folder.path(), pictures, &|_, _| ())
            .expect("a file of the test itself");
    };
    write(report::Pictures::PngAndSvg);
    for path in plots(folder.path()).iter().filter(|path| path.extension().is_some_and(|end| end == "png")) {
        let svg = fs::read_to_string(path.with_extension("svg")).expect("an SVG");
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>"));
    }
    write(report::Pictures::Png);
    assert!(!folder.path().join("plots/overview.svg").exists());
}

#[test]
fn a_brief_report_links_files_that_exist_and_counts_every_verdict_that_is_not_green() {
    let folder = tempfile::tempdir().expect("a file of the test itself");
    let records = few(&[1, 2, 4, 9]);
    report::write_brief(&records, folder.path(), &|_, _| ()).expect("a file of the test itself");
    let text = fs::read_to_string(folder.path().join("report.md")).expect("a page");
    let links: Vec<&str> = text.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(links.len() > 6);
    for link in links {
        assert!(folder.path().join(link).is_file(), "{link}");
    }
    let json = fs::read_to_string(folder.path().join("verdicts.json")).expect("verdicts");
    let kept = json.matches("\"verdict\":").count();
    let judged = records.verdicts.iter().filter(|one| one.verdict != polhode::record::Ruling::NotApplicable);
    assert_eq!(kept, judged.count());
}

#[test]
fn tables_of_a_paper_have_every_main_scheme_in_both_languages() {
    let records = few(&[1, 2, 4]);
    for language in [report::Language::Markdown, report::Language::Latex] {
        let text = report::paper_tables(&records, language);
        assert!(records.schemes.iter().all(|row| text.contains(&row.name)), "{text}");
    }
    let latex = report::paper_tables(&records, report::Language::Latex);
    assert_eq!(latex.matches("\\begin{table}").count(), latex.matches("\\end{table}").count());
    assert!(latex.matches("\\begin{table}").count() > 1);
}
