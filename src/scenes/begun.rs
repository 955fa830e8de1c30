//! Scene files to begin with.

use super::{FILES, Scene, SceneError, wording};

/// A commented scene with all that is often needed.
const TEMPLATE: &str = include_str!("template.toml");

/// The text of a new scene of this name: a template, or a built-in scene under another name.
///
/// # Errors
/// [`SceneError::Unknown`].
pub fn begun(name: &str, from: Option<&str>) -> Result<String, SceneError> {
    let name = wording::kebab(name);
    let Some(from) = from else { return Ok(TEMPLATE.replacen("NAME", &name, 1)) };
    let unknown = || SceneError::Unknown {
        name: from.to_owned(),
        near: wording::three_nearest(from, FILES.iter().map(|(name, _)| *name)),
    };
    let (_, text) = FILES.iter().find(|(known, _)| *known == from).ok_or_else(unknown)?;
    let old = Scene::parse(text, from)?.name;
    Ok(text.replacen(&format!("name = \"{old}\""), &format!("name = \"{name}\""), 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_and_every_built_in_scene_begin_a_scene_of_the_new_name() {
        let origins = std::iter::once(None).chain(FILES.iter().map(|(name, _)| Some(*name)));
        for from in origins {
            let text = begun("My Scene", from).expect("a text");
            assert_eq!(Scene::parse(&text, "new.toml").expect("a scene").name, "my-scene", "{from:?}");
        }
        assert!(matches!(begun("mine", Some("no-such-scene")), Err(SceneError::Unknown { .. })));
    }
}
