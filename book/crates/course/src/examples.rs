//! The steps' pictures and their examples as a library: what is drawn on the way and the
//! solutions of the exercises. Who wants to draw one takes it from here.

#![allow(dead_code, reason = "the main of an example runs as a program only")]
#![allow(clippy::duplicate_mod, reason = "`crowd` has `mirror` in it")]
#![allow(missing_docs, reason = "each is a program, and says at its top what it draws")]

use crate::Step;
use image::RgbImage;
use step01_rays::Camera;

/// Declares the examples as modules; a listing keeps the form that the steps have.
macro_rules! examples {
    ($($name:ident: $path:literal,)*) => {
        $(#[path = $path] pub mod $name;)*

        /// The path of each example, by its name.
        const PATHS: &[(&str, &str)] = &[$((stringify!($name), $path)),*];
    };
}

examples! {
    all_hits: "../../../../steps/step03_nearest/examples/all_hits.rs",
    checkerboard: "../../../../steps/step01_rays/examples/checkerboard.rs",
    crowd: "../../../../steps/step05_phong/examples/crowd.rs",
    depth: "../../../../steps/step03_nearest/examples/depth.rs",
    disc: "../../../../steps/step02_sphere/examples/disc.rs",
    gamma: "../../../../steps/step04_diffuse/examples/gamma.rs",
    glass: "../../../../steps/step05_phong/examples/glass.rs",
    gradient: "../../../../steps/step01_rays/examples/gradient.rs",
    graticule: "../../../../steps/step01_rays/examples/graticule.rs",
    halfway: "../../../../steps/step05_phong/examples/halfway.rs",
    highlight: "../../../../steps/step05_phong/examples/highlight.rs",
    jitter: "../../../../steps/step01_rays/examples/jitter.rs",
    lens: "../../../../steps/step02_sphere/examples/lens.rs",
    look_at: "../../../../steps/step01_rays/examples/look_at.rs",
    many: "../../../../steps/step03_nearest/examples/many.rs",
    marbles: "../../../../steps/step05_phong/examples/marbles.rs",
    mirror: "../../../../steps/step05_phong/examples/mirror.rs",
    my_scene: "../../../../steps/step03_nearest/examples/my_scene.rs",
    normals: "../../../../steps/step04_diffuse/examples/normals.rs",
    own_scene: "../../../../steps/step05_phong/examples/own_scene.rs",
    panorama: "../../../../steps/step01_rays/examples/panorama.rs",
    plane: "../../../../steps/step02_sphere/examples/plane.rs",
    plaster: "../../../../steps/step04_diffuse/examples/plaster.rs",
    quadric: "../../../../steps/step02_sphere/examples/quadric.rs",
    rings: "../../../../steps/step01_rays/examples/rings.rs",
    row: "../../../../steps/step01_rays/examples/row.rs",
    shadows: "../../../../steps/step04_diffuse/examples/shadows.rs",
    snowman: "../../../../steps/step04_diffuse/examples/snowman.rs",
    spot: "../../../../steps/step04_diffuse/examples/spot.rs",
    step01_starter: "../../../../steps/step01_rays/examples/step01_starter.rs",
    step02_starter: "../../../../steps/step02_sphere/examples/step02_starter.rs",
    step03_starter: "../../../../steps/step03_nearest/examples/step03_starter.rs",
    step04_starter: "../../../../steps/step04_diffuse/examples/step04_starter.rs",
    step05_starter: "../../../../steps/step05_phong/examples/step05_starter.rs",
    sun: "../../../../steps/step04_diffuse/examples/sun.rs",
    terms: "../../../../steps/step05_phong/examples/terms.rs",
}

/// Draws a picture for a camera, with so many rays a pixel each way.
pub type Picture = fn(&Camera, u32) -> RgbImage;

/// The picture of this name, of a step or an example.
pub fn find_picture(name: &str) -> Option<Picture> {
    PICTURES.iter().find(|(known, _)| *known == name).map(|(_, draw)| *draw)
}

/// The pictures of the five steps, then those of the examples, step by step, each by its name.
pub const PICTURES: &[(&str, Picture)] = &[
    ("step01_rays", step01_rays::picture),
    ("step02_sphere", step02_sphere::picture),
    ("step03_nearest", step03_nearest::picture),
    ("step04_diffuse", step04_diffuse::picture),
    ("step05_phong", step05_phong::picture),
    ("gradient", |_, _| gradient::picture()),
    ("checkerboard", |camera, _| checkerboard::picture(camera)),
    ("graticule", graticule::picture),
    ("jitter", jitter::picture),
    ("look_at", look_at::picture),
    ("panorama", panorama::picture),
    ("rings", rings::picture),
    ("disc", |camera, _| disc::picture(camera)),
    ("lens", lens::picture),
    ("plane", plane::picture),
    ("quadric", quadric::picture),
    ("all_hits", all_hits::picture),
    ("depth", depth::picture),
    ("many", many::picture),
    ("my_scene", my_scene::picture),
    ("gamma", gamma::picture),
    ("normals", normals::picture),
    ("plaster", plaster::picture),
    ("shadows", shadows::picture),
    ("snowman", snowman::picture),
    ("spot", spot::picture),
    ("sun", sun::picture),
    ("crowd", crowd::picture),
    ("glass", glass::picture),
    ("halfway", halfway::picture),
    ("highlight", highlight::picture),
    ("marbles", marbles::picture),
    ("mirror", mirror::picture),
];

impl Step {
    /// The function that draws its picture.
    pub fn picture(self) -> Picture {
        PICTURES[self as usize].1
    }
}

/// The step that an example extends: it lies in the folder of that step.
pub fn step_of_example(name: &str) -> Option<Step> {
    let (_, path) = PATHS.iter().find(|(known, _)| *known == name)?;
    Step::from_path(path)
}
