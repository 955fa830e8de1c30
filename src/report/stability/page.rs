//! The study as a Markdown page.

use super::super::number;
use super::super::survey;
use super::table::{MEANINGS, fails_by, find, words};
use crate::record::stability::{LinearLimit, LongRun, Map, Stability};

/// The page.
pub(super) fn compose(study: &Stability) -> String {
    let mut text = format!("# Where methods fail\n\nPolhode {}, {}.\n\n", study.polhode, study.made_at);
    text += "The largest usable step is the one below which every step tried is usable. ω is the fastest natural frequency of the \
             springs or the touched ground, else the largest |Ω|. A run that fails is a row like any other.\n\n";
    if !study.complete {
        text += "**Interrupted: not everything was measured.**\n\n";
    }
    text += &fails_where(study);
    text += &linear(&study.linear);
    text += &maps(&study.maps);
    text += &long_runs(&study.long_runs);
    text += &law_and_kinks(study);
    text + &limits(study)
}

fn row(cells: &[&str]) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    format!("| {} |\n", cells.join(" | "))
}

fn header(cells: &[&str]) -> String {
    row(cells) + &row(&vec!["---"; cells.len()])
}

fn three(value: Option<f64>) -> String {
    value.map_or_else(|| number::NONE.to_owned(), |value| number::significant(value, 4))
}

fn fails_where(study: &Stability) -> String {
    if study.fails_where.is_empty() {
        return String::new();
    }
    let rows = study.fails_where.iter().map(|one| row(&[&one.scheme, &one.line]));
    format!("## Fails where\n\n{}{}\n", header(&["scheme", "fails where"]), rows.collect::<String>())
}

fn linear(rows: &[LinearLimit]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let one = |limit: &LinearLimit| {
        row(&[
            &limit.scheme,
            &limit.scene,
            &three(Some(limit.zeta)),
            &three(limit.h_omega),
            &three(limit.theory_h_omega),
            limit.theory.as_deref().unwrap_or("none: its iteration ends first"),
            &limit.failure,
        ])
    };
    let columns = ["scheme", "body and spring of", "ζ", "largest h·ω", "theory", "which", "above it"];
    let rows: String = rows.iter().map(one).collect();
    format!(
        "## The spring-held body at rest\n\n![Largest usable steps](limits.png)\n\nLargest h·ω at which a small displacement grows by less than 1e-4 a step.\n\n{}{rows}\n",
        header(&columns)
    )
}

fn maps(maps: &[Map]) -> String {
    let one = |map: &Map| {
        let off = map.edge_off_theory.map_or_else(String::new, |off| {
            format!(" The edge is {:.2} % off the theory (median over the rows).", off * 100.0)
        });
        format!(
            "### {} ({})\n\n{}.{off} {} × {} cells, {} steps, {:.1} s.\n\n![{}](maps/{}.png)\n\n",
            map.title,
            map.scheme,
            map.what,
            map.cells,
            map.cells,
            map.steps,
            map.seconds,
            map.title,
            super::map_file(map)
        )
    };
    if maps.is_empty() {
        return String::new();
    }
    format!("## Maps\n\n{}", maps.iter().map(one).collect::<String>())
}

fn long_runs(runs: &[LongRun]) -> String {
    if runs.is_empty() {
        return String::new();
    }
    let one = |run: &LongRun| {
        let last = run.energy_change.last().map_or_else(String::new, |value| format!("{value:.2e}"));
        row(&[
            &run.scene,
            &run.scheme,
            &run.steps.to_string(),
            &last,
            &three(run.growth_power),
            run.class.word(),
            &run.final_axis,
            run.why.as_deref().unwrap_or(""),
        ])
    };
    let columns = [
        "scene",
        "scheme",
        "steps",
        "energy change",
        "grows as n to the power",
        "class",
        "spin ends on",
        "broke",
    ];
    let rows: String = runs.iter().map(one).collect();
    format!(
        "## Long runs\n\nRelative change of the rotational energy at {:.2} rad a step.\n\n![Energy over many steps](long-runs.png)\n\n{}{rows}\n",
        runs[0].radians_per_step,
        header(&columns)
    )
}

fn law_and_kinks(study: &Stability) -> String {
    let mut text = String::new();
    if !study.energy_law.is_empty() {
        text += "## Peskin's law of the energy\n\ndE/dt = h³ β⁴ l⁶ sin²θ cos⁴θ / (8A) on the symmetric free body.\n\n\
                 ![Drift rate and law](energy-law.png)\n\n";
        text += &header(&["h [s]", "measured [W]", "law [W]", "ratio"]);
        for rate in &study.energy_law {
            text += &row(&[
                &number::significant(rate.step_s, 4),
                &format!("{:.5e}", rate.measured_w),
                &format!("{:.5e}", rate.law_w),
                &format!("{:.4}", rate.measured_w / rate.law_w),
            ]);
        }
        text += "\n";
    }
    if !study.kink_orders.is_empty() {
        text += "## Order across a bounce\n\nMedian over many drops: the force of an elastic ground has a kink, that of a damped one \
                 a jump, and no scheme keeps its order across either.\n\n";
        text += &header(&["scheme", "claimed", "elastic ground", "damped ground"]);
        for one in &study.kink_orders {
            let two = |value: Option<f64>| value.map_or("n/a".to_owned(), |value| format!("{value:.2}"));
            text += &row(&[&one.scheme, &one.claimed.to_string(), &two(one.elastic), &two(one.damped)]);
        }
        text += "\n";
    }
    text
}

fn limits(study: &Stability) -> String {
    let mut text = "## Largest usable steps\n\n≥: usable at every step tried; <: at none tried; ~: some larger steps are usable \
                    again.\n\n"
        .to_owned();
    let schemes = survey::distinct(study.limits.iter().map(|row| row.scheme.as_str()));
    for scene in survey::distinct(study.limits.iter().map(|row| row.scene.as_str())) {
        let titles = MEANINGS.map(|(_, title)| format!("{title}: h [s], rad a step, h·ω"));
        text += &format!("### {scene}\n\n");
        if let Some(first) = study.limits.iter().find(|row| row.scene == scene && row.omega_rad_s.is_some()) {
            text += &format!("ω = {} rad/s, the {}.\n\n", three(first.omega_rad_s), first.omega_is);
        }
        text += &header(&["scheme", &titles[0], &titles[1], &titles[2], "fails by"]);
        for scheme in &schemes {
            let rows = MEANINGS.map(|(meaning, _)| find(study, scene, scheme, meaning));
            let [bounded, energy, orientation] = rows.map(|row| row.map_or_else(String::new, words));
            text += &row(&[scheme, &bounded, &energy, &orientation, &fails_by(&rows)]);
        }
        text += "\n";
    }
    text
}
