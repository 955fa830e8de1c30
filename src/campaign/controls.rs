//! What a scheme shows in a generic scene, which tells a scene that is too easy from an order that is mis-declared.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::{cell, prepare};
use crate::gates::Control;
use crate::scenes::Scene;
use crate::simulate::Contestant;

/// Generic scenes without torque, …
const WITHOUT_TORQUE: &[&str] = &["free-asymmetric"];
/// … and with it: three moments, products of inertia, a spin off every axis; the first that a scheme takes.
const WITH_TORQUE: &[&str] = &["heavy-asymmetric-top", "tether-springs"];

/// Whether a built-in scene is one of these.
pub(super) fn is_generic(scene: &Scene) -> bool {
    scene.built_in && WITHOUT_TORQUE.iter().chain(WITH_TORQUE).any(|name| *name == scene.name)
}

/// The controls of a campaign's schemes, each measured when it is first asked for. Clones share what was measured.
#[derive(Clone, Default)]
pub struct Controls {
    found: Arc<Mutex<HashMap<(String, bool), Found>>>,
}

type Found = Arc<OnceLock<Control>>;

impl Controls {
    /// The control of a scheme, without torque or with it; empty where it takes no such scene.
    pub(super) fn of(&self, contestant: &Contestant, torque_free: bool) -> Control {
        let key = (contestant.card.name.to_owned(), torque_free);
        let found = self.found.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default().clone();
        found.get_or_init(|| measure(contestant, torque_free).unwrap_or_default()).clone()
    }
}

fn measure(contestant: &Contestant, torque_free: bool) -> Option<Control> {
    let scenes = if torque_free { WITHOUT_TORQUE } else { WITH_TORQUE };
    let mut taken = scenes.iter().filter_map(|name| Scene::find(name).ok());
    let scene = taken.find(|scene| contestant.refusal(&scene.system).is_none())?;
    let prepared = prepare(&scene);
    let reference = prepared.reference.as_ref()?.as_ref().ok()?;
    Some(Control { verdicts: cell::orders_alone(&scene, reference, contestant) })
}
