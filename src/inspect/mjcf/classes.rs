//! `<default>`: attributes that an element takes from its class where it gives none itself.

use std::collections::BTreeMap;

use crate::inspect::element::Element;

/// Attributes by name.
pub(super) type Attributes<'e> = BTreeMap<&'e str, &'e str>;

/// Attributes of each kind of element in each class, those of the outer classes included.
pub(super) struct Classes(BTreeMap<String, BTreeMap<String, BTreeMap<String, String>>>);

/// Kinds of elements whose mass counts.
const KINDS: [&str; 2] = ["geom", "mesh"];
/// The class of the outermost `<default>`.
const MAIN: &str = "main";

impl Classes {
    pub fn read(root: &Element) -> Classes {
        let mut classes = Classes(BTreeMap::new());
        for element in root.all("default") {
            let name = element.attribute("class").unwrap_or(MAIN);
            let outer = classes.0.get(MAIN).cloned().unwrap_or_default();
            classes.enter(element, name, outer);
            if name != MAIN {
                // The outermost class is the main one, whatever it is called.
                let own = classes.0.get(name).cloned().unwrap_or_default();
                classes.0.insert(MAIN.to_owned(), own);
            }
        }
        classes
    }

    fn enter(&mut self, element: &Element, name: &str, outer: BTreeMap<String, BTreeMap<String, String>>) {
        let mut own = outer;
        for child in element.children.iter().filter(|child| KINDS.contains(&child.name.as_str())) {
            let kind = own.entry(child.name.clone()).or_default();
            kind.extend(child.attributes().map(|(key, value)| (key.to_owned(), value.to_owned())));
        }
        self.0.insert(name.to_owned(), own.clone());
        for inner in element.all("default") {
            if let Some(class) = inner.attribute("class") {
                self.enter(inner, class, own.clone());
            }
        }
    }

    /// The attributes of an element, its own first; `class` is the childclass in force.
    pub fn of<'e>(&'e self, kind: &str, element: &'e Element, class: Option<&'e str>) -> Attributes<'e> {
        let name = element.attribute("class").or(class).unwrap_or(MAIN);
        let inherited = self.0.get(name).or_else(|| self.0.get(MAIN)).and_then(|class| class.get(kind));
        let mut all: Attributes = BTreeMap::new();
        if let Some(inherited) = inherited {
            all.extend(inherited.iter().map(|(key, value)| (key.as_str(), value.as_str())));
        }
        all.extend(element.attributes());
        all
    }
}
