use crate::Step;

/// A section of the book: its chapter and its heading. All that the gallery sends
/// readers to are below, so that a new heading is a change in one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// The step of the chapter.
    pub step: Step,
    /// The heading, as it stands in the chapter.
    pub heading: &'static str,
}

const fn section(step: Step, heading: &'static str) -> Section {
    Section { step, heading }
}

pub(crate) const RAY: Section = section(Step::Rays, "A ray");
pub(crate) const CAMERA: Section = section(Step::Rays, "The camera");
pub(crate) const BYTES: Section = section(Step::Rays, "From rays to a picture");
pub(crate) const DIRECTIONS: Section =
    section(Step::Rays, "The direction as a colour");
pub(crate) const PROGRAM: Section = section(Step::Rays, "The program around it");
pub(crate) const MEETING: Section = section(Step::Sphere, "Where they meet");
pub(crate) const FORMULA: Section = section(Step::Sphere, "The quadratic formula");
pub(crate) const CENTRE: Section = section(Step::Sphere, "Any centre");
pub(crate) const ROOT: Section = section(Step::Sphere, "Which root");
pub(crate) const NEAREST: Section = section(Step::Nearest, "The nearest hit");
pub(crate) const NORMAL: Section = section(Step::Diffuse, "The normal");
pub(crate) const AMBIENT: Section = section(Step::Diffuse, "Ambient light");
pub(crate) const LAMBERT: Section = section(Step::Diffuse, "Facing away");
pub(crate) const ATTENUATION: Section = section(Step::Diffuse, "Attenuation");
pub(crate) const LIGHT: Section = section(Step::Diffuse, "Point lights");
pub(crate) const DIFFUSE: Section = section(Step::Diffuse, "The diffuse term");
pub(crate) const LIGHTS: Section = section(Step::Diffuse, "Two lights");
pub(crate) const REFLECT: Section = section(Step::Phong, "The reflected vector");
pub(crate) const SPECULAR: Section = section(Step::Phong, "The specular term");
pub(crate) const SUM: Section = section(Step::Phong, "The sum");
pub(crate) const EYE: Section = section(Step::Phong, "The way to the eye");

impl Section {
    /// Where it is in the built book: `step01_rays.html#the-camera`.
    pub fn page(&self) -> String {
        format!("{}.html#{}", self.step.name(), self.anchor())
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
