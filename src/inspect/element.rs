//! The elements of an XML file: read by roxmltree, bounded in size, number and depth, and kept with their lines.
//!
//! A document type is refused: entities, and with them XML bombs, need one.

use std::ops::Range;
use std::sync::Arc;

use roxmltree::{Document, Error, Node, ParsingOptions};

use super::printed::Printed;
use crate::bounded::FileError;
use crate::scenes;

/// Most nodes of a file: a node takes some hundred bytes, so the tree stays below a gigabyte.
const MOST_NODES: u32 = 4_000_000;
/// Deepest nesting: robots on record stay below 60 (humanoid_CMU: 21); readers descend recursively.
pub(super) const DEEPEST: usize = 256;

/// One element.
#[derive(Clone, Debug)]
pub(super) struct Element {
    /// Name without its namespace.
    pub name: String,
    /// Line, from 1.
    pub line: usize,
    /// Its bytes in the file that is inspected, its children included.
    span: Range<usize>,
    /// The included file that it stands in, with its line there.
    inside: Option<Arc<str>>,
    attributes: Vec<(String, String)>,
    text: String,
    pub children: Vec<Element>,
}

/// Reads XML; `file` is its name in error messages.
pub(super) fn parse(text: &str, file: &str) -> Result<Element, FileError> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let refuse = |line, why| FileError::Content { file: file.to_owned(), line, why };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let line = usize::try_from(error.pos().row).unwrap_or(1);
        refuse(line, in_words(&error))
    })?;
    let starts: Vec<usize> =
        std::iter::once(0).chain(text.match_indices('\n').map(|(place, _)| place + 1)).collect();
    let line_of = |node: Node| starts.partition_point(|start| *start <= node.range().start);
    let root = document.root_element();
    if let Some(deep) = too_deep(root) {
        return Err(refuse(
            line_of(deep),
            format!("elements are nested deeper than {DEEPEST} levels, the most that is read"),
        ));
    }
    Ok(Element::of(root, &line_of))
}

fn in_words(error: &Error) -> String {
    match error {
        Error::DtdDetected => {
            "a document type (<!DOCTYPE) is not read, since its entities can grow without bound: remove it \
                               and write out what its entities stand for"
                .to_owned()
        }
        Error::NodesLimitReached => {
            format!("the file has more than {MOST_NODES} nodes, the most that is read")
        }
        other => format!("not XML: {other}"),
    }
}

/// The first element below the deepest level, found without recursion.
fn too_deep<'a, 'i>(root: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    let (mut node, mut depth) = (root, 1);
    loop {
        if depth > DEEPEST {
            return Some(node);
        }
        if let Some(child) = node.first_element_child() {
            node = child;
            depth += 1;
            continue;
        }
        while node.next_sibling_element().is_none() {
            node = node.parent_element()?;
            depth -= 1;
            if depth == 0 {
                return None;
            }
        }
        node = node.next_sibling_element()?;
    }
}

impl Element {
    fn of(node: Node, line_of: &impl Fn(Node) -> usize) -> Element {
        Element {
            name: node.tag_name().name().to_owned(),
            line: line_of(node),
            span: node.range(),
            inside: None,
            attributes: node
                .attributes()
                .map(|given| (given.name().to_owned(), given.value().trim().to_owned()))
                .collect(),
            text: node.text().unwrap_or_default().trim().to_owned(),
            children: node
                .children()
                .filter(Node::is_element)
                .map(|child| Element::of(child, line_of))
                .collect(),
        }
    }

    /// An element of an included file, in the place of `include`.
    pub fn included(&mut self, include: &Element, file: &str) {
        let further = self.inside.as_deref().unwrap_or_default();
        self.inside = Some(format!("line {} of {file}: {further}", self.line).into());
        (self.line, self.span) = (include.line, include.span.clone());
        self.children.iter_mut().for_each(|child| child.included(include, file));
    }

    /// The value of an attribute.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// Every attribute.
    pub fn attributes(&self) -> impl Iterator<Item = (&str, &str)> {
        self.attributes.iter().map(|(name, value)| (name.as_str(), value.as_str()))
    }

    /// The text directly inside, without the blanks around it.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Children of a name.
    pub fn all<'e>(&'e self, name: &'e str) -> impl Iterator<Item = &'e Element> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// The first child of a name.
    pub fn child(&self, name: &str) -> Option<&Element> {
        self.children.iter().find(|child| child.name == name)
    }
}

/// A fault of an element.
#[derive(Debug)]
pub(super) struct Fault(scenes::Fault);

impl Fault {
    /// What is wrong with an element, and what to write instead.
    pub fn at(element: &Element, why: impl std::fmt::Display) -> Fault {
        let inside = element.inside.as_deref().unwrap_or_default();
        Fault(scenes::Fault {
            line: element.line,
            key: format!("<{}>", element.name),
            message: format!("{inside}{why}"),
            advice: String::new(),
            span: element.span.clone(),
            mend: None,
        })
    }
}

/// All faults of a file so far.
#[derive(Debug, Default)]
pub(super) struct Faults(Vec<scenes::Fault>);

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Faults {
        Faults(vec![fault.0])
    }
}

impl Faults {
    /// What was found; or nothing, and the faults are kept.
    pub fn keep<T>(&mut self, found: Result<T, impl Into<Faults>>) -> Option<T> {
        found.map_err(|faults| self.0.extend(faults.into().0)).ok()
    }

    /// What was read; or the faults, where there are any.
    pub fn or<T>(self, read: Option<T>) -> Result<T, Faults> {
        match read {
            Some(read) if self.0.is_empty() => Ok(read),
            _ => Err(self),
        }
    }

    /// In the order of the file.
    pub fn sorted(mut self) -> Vec<scenes::Fault> {
        self.0.sort_by_key(|fault| (fault.line, fault.span.start));
        self.0
    }
}

/// The numbers of a text, as many as there are.
pub(super) fn printed(element: &Element, text: &str) -> Result<Vec<Printed>, Fault> {
    text.split_whitespace()
        .map(|word| Printed::parse(word).ok_or_else(|| Fault::at(element, not_a_number(word))))
        .collect()
}

fn not_a_number(word: &str) -> String {
    if word.contains("${") || word.contains("$(") {
        let shown: String = word.chars().take(40).collect();
        return format!(
            "'{shown}' is an expression of xacro: run `xacro FILE > robot.urdf` and inspect that"
        );
    }
    let shown: String = word.chars().take(40).collect();
    format!("'{shown}' is not a number: write one as in 0.35 or 3.5e-1")
}

/// `N` numbers of a text.
pub(super) fn numbers<const N: usize>(element: &Element, text: &str) -> Result<[f64; N], Fault> {
    let found = printed(element, text)?;
    let count = found.len();
    let values: Vec<f64> = found.into_iter().map(|number| number.value).collect();
    <[f64; N]>::try_from(values).map_err(|_| Fault::at(element, format!("{count} numbers, expected {N}")))
}

/// `N` finite numbers of a text.
pub(super) fn finite<const N: usize>(element: &Element, text: &str) -> Result<[f64; N], Fault> {
    let values = numbers(element, text)?;
    match values.iter().find(|value| !value.is_finite()) {
        Some(odd) => Err(Fault::at(element, format!("{odd} stands where a finite number is needed"))),
        None => Ok(values),
    }
}

/// One number of a text.
pub(super) fn number(element: &Element, text: &str) -> Result<Printed, Fault> {
    let mut found = printed(element, text)?;
    match (found.len(), found.pop()) {
        (1, Some(number)) => Ok(number),
        (count, _) => Err(Fault::at(element, format!("{count} numbers, expected one"))),
    }
}
