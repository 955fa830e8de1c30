//! `<compiler>` and `<option>`: what changes masses, and what steps the model.

use std::ops::RangeInclusive;

use super::moments;
use crate::inspect::Stepping;
use crate::inspect::element::{Element, Fault, Faults, finite};
use crate::inspect::link::Link;

/// Step where `<option>` gives none [s].
const STEP: f64 = 0.002;

/// When geoms give the inertia.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FromGeom {
    Always,
    WhereNoneIsGiven,
    Never,
}

/// The settings of `<compiler>` that matter to a body.
pub(super) struct Settings {
    degrees: bool,
    /// Axes of Euler angles.
    pub euler_sequence: [char; 3],
    pub from_geom: FromGeom,
    /// Groups of geoms that have mass.
    pub groups: RangeInclusive<i64>,
    balance: bool,
    least_mass: f64,
    least_moment: f64,
    total_mass: Option<f64>,
}

impl Settings {
    pub fn read(root: &Element, faults: &mut Faults) -> Settings {
        let mut settings = Settings {
            degrees: true,
            euler_sequence: ['x', 'y', 'z'],
            from_geom: FromGeom::WhereNoneIsGiven,
            groups: 0..=5,
            balance: false,
            least_mass: 0.0,
            least_moment: 0.0,
            total_mass: None,
        };
        for element in root.all("compiler") {
            for (key, value) in element.attributes() {
                faults.keep(settings.take(element, key, value));
            }
        }
        settings
    }

    fn take(&mut self, element: &Element, key: &str, value: &str) -> Result<(), Fault> {
        let one = || finite::<1>(element, value).map(|[number]| number);
        match key {
            "angle" => self.degrees = value != "radian",
            "balanceinertia" => self.balance = value == "true",
            "boundmass" => self.least_mass = one()?,
            "boundinertia" => self.least_moment = one()?,
            "settotalmass" => self.total_mass = Some(one()?).filter(|mass| *mass > 0.0),
            "inertiafromgeom" => {
                self.from_geom = match value {
                    "true" => FromGeom::Always,
                    "false" => FromGeom::Never,
                    _ => FromGeom::WhereNoneIsGiven,
                };
            }
            "inertiagrouprange" => {
                let [first, last] = finite::<2>(element, value)?;
                self.groups = first as i64..=last as i64;
            }
            "eulerseq" => {
                let letters: Vec<char> = value.chars().collect();
                self.euler_sequence = <[char; 3]>::try_from(letters)
                    .ok()
                    .filter(|letters| letters.iter().all(|letter| "xyzXYZ".contains(*letter)))
                    .ok_or_else(|| {
                        Fault::at(element, format!("eulerseq '{value}': expected three of x, y, z, X, Y, Z"))
                    })?;
            }
            _ => {}
        }
        Ok(())
    }

    /// An angle of the file [rad].
    pub fn radians(&self, angle: f64) -> f64 {
        if self.degrees { angle.to_radians() } else { angle }
    }
}

/// What the compiler makes of the bodies: bounds, then the mean of the moments where they break A + B ≥ C, then the scale of all masses.
pub(super) fn compile(settings: &Settings, links: &mut [Link]) {
    let mut compiled: Vec<Option<(f64, [f64; 3])>> = Vec::new();
    for link in links.iter() {
        compiled.push(
            moments(link)
                .filter(|(mass, moments)| mass.is_finite() && moments.iter().all(|m| m.is_finite()))
                .map(|(mass, moments)| {
                    let mass = mass.max(settings.least_mass);
                    let mut three: [f64; 3] = moments.map(|moment| moment.max(settings.least_moment)).into();
                    if settings.balance && three[0] + three[1] < three[2] {
                        three = [three.iter().sum::<f64>() / 3.0; 3];
                    }
                    (mass, three)
                }),
        );
    }
    let total: f64 = compiled.iter().flatten().map(|(mass, _)| mass).sum();
    let scale = settings.total_mass.filter(|_| total > 0.0).map_or(1.0, |wanted| wanted / total);
    for (link, compiled) in links.iter_mut().zip(compiled) {
        let Some((mass, three)) = compiled else { continue };
        let Some((own_mass, own)) = moments(link) else { continue };
        let (mass, three) = (mass * scale, three.map(|moment| moment * scale));
        let raised = own.iter().any(|moment| *moment < 0.0);
        if !raised && (mass != own_mass || three != <[f64; 3]>::from(own)) {
            link.compiled = Some((mass, three));
        }
    }
}

/// Integrator and step of `<option>`.
pub(super) fn stepping(root: &Element) -> Result<Stepping, Fault> {
    let mut stepping = Stepping {
        integrator: "Euler (MuJoCo's default)".to_owned(),
        step: STEP,
        step_given: false,
        scheme: Some("semi-implicit-euler-explicit-gyro"),
    };
    for option in root.all("option") {
        if let Some(text) = option.attribute("timestep") {
            [stepping.step] = finite::<1>(option, text)?;
            stepping.step_given = true;
        }
        if let Some(name) = option.attribute("integrator") {
            stepping.integrator = format!("{name} (MuJoCo)");
            stepping.scheme = match name {
                "RK4" => Some("rk4-quaternion"),
                "implicit" | "implicitfast" => Some("semi-implicit-euler-implicit-gyro"),
                "Euler" => stepping.scheme,
                _ => return Err(Fault::at(option, format!("'{name}' is no integrator of MuJoCo"))),
            };
        }
    }
    Ok(stepping)
}
