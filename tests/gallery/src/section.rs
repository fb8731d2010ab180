//! The sections of the book to which a mistake leads.
#![expect(missing_docs, reason = "the heading of each section tells what it is")]

use crate::Mistake;
use crate::Step::{self, Diffuse, Nearest, Phong, Rays, Sphere};

/// A section of the book: its chapter and its heading. All that the gallery sends
/// readers to are below, so that a new heading is a change in one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// The step of the chapter.
    pub step: Step,
    /// The file that it shows, in the folder `src` of the step.
    pub file: &'static str,
    /// The heading, as it stands in the chapter.
    pub heading: &'static str,
}

const fn section(step: Step, file: &'static str, heading: &'static str) -> Section {
    Section { step, file, heading }
}

pub const RAY: Section = section(Rays, "ray.rs", "A ray");
pub const CAMERA: Section = section(Rays, "camera.rs", "The camera");
pub const BYTES: Section = section(Rays, "rgb8.rs", "From rays to a picture");
pub const RENDER: Section = section(Rays, "render.rs", "Render");
pub const DIRECTIONS: Section =
    section(Rays, "picture.rs", "The direction as a colour");
pub const PROGRAM: Section = section(Rays, "program.rs", "The program around it");
pub const MEETING: Section = section(Sphere, "sphere.rs", "Where they meet");
pub const FORMULA: Section =
    section(Sphere, "quadratic.rs", "The quadratic formula");
pub const CENTRE: Section = section(Sphere, "sphere.rs", "Any centre");
pub const ROOT: Section = section(Sphere, "quadratic.rs", "Which root");
pub const ONE_COLOUR: Section =
    section(Sphere, "picture.rs", "A colour for every ray");
pub const SCENE: Section = section(Nearest, "objects.rs", "The scene");
pub const NEAREST: Section = section(Nearest, "nearest.rs", "The nearest hit");
pub const FLAT: Section = section(Nearest, "picture.rs", "A colour for every ray");
pub const SURFACE: Section = section(Diffuse, "surface.rs", "Colours are vectors");
pub const NORMAL: Section = section(Diffuse, "surface_point.rs", "The normal");
pub const AMBIENT: Section = section(Diffuse, "ambient.rs", "Ambient light");
pub const LAMBERT: Section = section(Diffuse, "diffuse.rs", "Facing away");
pub const ATTENUATION: Section = section(Diffuse, "light.rs", "Attenuation");
pub const LIGHT: Section = section(Diffuse, "light.rs", "Point lights");
pub const DIFFUSE: Section = section(Diffuse, "diffuse.rs", "The diffuse term");
pub const LIGHTS: Section = section(Diffuse, "picture.rs", "Two lights");
pub const LAMPS: Section = section(Diffuse, "scene.rs", "Two lights");
pub const REFLECT: Section = section(Phong, "reflect.rs", "The reflected vector");
pub const SPECULAR: Section = section(Phong, "specular.rs", "The specular term");
pub const SUM: Section = section(Phong, "phong.rs", "The sum");
pub const MATERIALS: Section = section(Phong, "scene.rs", "Nine materials");
pub const EYE: Section = section(Phong, "phong.rs", "The way to the eye");

impl Section {
    /// What is wrong in its code, to be told: it shows in its step.
    pub(crate) const fn mistake(self) -> Mistake {
        let (step, section, name) = (self.step, self, "");
        let (when, sees, says) = ("", "", "");
        Mistake { step, section, name, when, sees, says, change: |_| {} }
    }

    /// Where it is in the built book: `step01_rays.html#the-camera`.
    pub fn page(&self) -> String {
        format!("{}.html#{}", self.step.name(), self.anchor())
    }

    /// The file, seen from the root of the workspace.
    pub fn path(&self) -> String {
        format!("steps/{}/src/{}", self.step.name(), self.file)
    }

    /// The id that the book gives to its heading.
    pub fn anchor(&self) -> String {
        let kept = self.heading.chars().filter_map(|c| match c {
            ' ' => Some('-'),
            _ => c.is_alphanumeric().then(|| c.to_ascii_lowercase()),
        });
        kept.collect()
    }
}
