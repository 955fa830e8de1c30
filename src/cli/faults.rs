//! All that is wrong with a scene, settings or records file or a robot description, each with its line, the place marked, and a text to write instead.

use std::io::IsTerminal;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Patch, Renderer, Snippet};

use super::exit::Failure;
use crate::fault::Fault;
use crate::inspect::InspectError;
use crate::record::RecordError;
use crate::scenes::SceneError;

/// Bytes of a line above which it is not shown.
const LONGEST: usize = 1000;
/// Most faults that are shown.
const MOST: usize = 20;

/// The error for stderr: in colour on a terminal, but where `NO_COLOR` is set.
pub(super) fn shown(failure: &Failure) -> String {
    let (Failure::Scene(SceneError::Content { file, text, faults })
    | Failure::Inspect(
        InspectError::Scene(SceneError::Content { file, text, faults })
        | InspectError::Content { file, text, faults },
    )
    | Failure::Record(RecordError::Content { file, text, faults })
    | Failure::Config { file, text, faults }) = failure
    else {
        return format!("polhode: {failure}");
    };
    let coloured =
        std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty());
    let renderer = if coloured { Renderer::styled() } else { Renderer::plain() };
    render(&renderer, file, text, faults)
}

fn render(renderer: &Renderer, file: &str, text: &str, faults: &[Fault]) -> String {
    let mut blocks: Vec<String> =
        faults.iter().take(MOST).map(|fault| block(renderer, file, text, fault)).collect();
    let count = faults.len();
    if count > MOST {
        blocks.push(format!("{file}: and {} faults more", count - MOST));
    } else if count > 1 {
        blocks.push(format!("{file}: {count} faults"));
    }
    blocks.join("\n\n")
}

fn block(renderer: &Renderer, file: &str, text: &str, fault: &Fault) -> String {
    let Some(marked) = first_line(text, &fault.span) else {
        return format!("polhode: {file}:{}: {fault}", fault.line);
    };
    let parts = [&fault.key, &fault.message].map(String::as_str);
    let title = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(": ");
    let snippet = Snippet::source(text).path(file).annotation(AnnotationKind::Primary.span(marked));
    let mut groups: Vec<Group> = vec![Level::ERROR.primary_title(title).element(snippet)];
    let removes = fault.mend.as_ref().is_some_and(|mend| mend.text.is_empty());
    let advice = match fault.advice.as_str() {
        "" if removes => "remove it",
        "" => "write this instead",
        advice => advice,
    };
    match &fault.mend {
        Some(mend) => {
            let patch = Patch::new(mend.span.clone(), mend.text.as_str());
            let snippet = Snippet::source(text).path(file).patch(patch);
            groups.push(Level::HELP.secondary_title(advice).element(snippet));
        }
        None if !fault.advice.is_empty() => {
            groups = groups.into_iter().map(|group| group.element(Level::HELP.message(advice))).collect();
        }
        None => {}
    }
    renderer.render(&groups)
}

/// The part of a span that is on its first line; `None` where the text has no such place, or the line is too long to show.
fn first_line(text: &str, span: &Range<usize>) -> Option<Range<usize>> {
    let marked = text.get(span.start..span.end)?;
    let end = span.start + marked.find(['\n', '\r']).unwrap_or(marked.len());
    let start = text[..span.start].rfind('\n').map_or(0, |before| before + 1);
    let line = end - start + text[end..].find('\n').unwrap_or(text.len() - end);
    (!text.is_empty() && line <= LONGEST).then_some(span.start..end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::Scene;

    #[test]
    fn every_fault_is_shown_with_file_line_key_and_the_marked_text() {
        let text = "name = \"a\"\nduration = \"ten\"\n[body]\nmass = -1.0\ninertia = [1, 2, 2.5]\n";
        let Err(error) = Scene::parse(text, "my.toml") else { panic!("read") };
        let SceneError::Content { file, text, faults } = &error else { panic!("{error}") };
        let shown = render(&Renderer::plain(), file, text, faults);
        for part in ["my.toml:2:12", "my.toml:4:8", "body.mass", "duration", "\"ten\"", "^^^^^", "2 faults"] {
            assert!(shown.contains(part), "no {part} in\n{shown}");
        }
    }

    #[test]
    fn a_span_outside_the_text_and_an_empty_text_are_shown_as_a_line() {
        assert_eq!(first_line("", &(0..0)), None);
        assert_eq!(first_line("abc", &(2..9)), None);
        assert_eq!(first_line("ab\ncd", &(1..5)), Some(1..2));
    }
}
