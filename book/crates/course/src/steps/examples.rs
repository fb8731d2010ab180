//! The steps' examples as a library, and a list of all pictures that a step or an example draws.
//! The examples are the programs that the chapters run along the way, and the solutions to the
//! exercises.

#![allow(dead_code, reason = "an example's `main` is called only if the example runs as a program")]
#![allow(clippy::duplicate_mod, reason = "`crowd` also declares the module `mirror`")]
#![allow(missing_docs, reason = "each example says at its top what it draws")]

use crate::Step;
use image::RgbImage;
use step01_rays::Camera;

/// A function that draws what a camera sees. The function's second argument is a number n: each
/// pixel is split into n×n sub-pixels.
pub type DrawPicture = fn(&Camera, u32) -> RgbImage;

/// Declares each example as a module. The macro hides the modules from rustfmt. Otherwise, rustfmt
/// would format the examples with our settings instead of the steps'.
///
/// Also defines the macro `with_picture_names`, with which tests declare a test function for each
/// picture. A constant wouldn't do, because only a macro can turn a name into a function.
macro_rules! examples {
    ($dollar:tt
        pictures { $($name:ident: $path:literal => $draw:expr,)* }
        others { $($other:ident: $other_path:literal,)* }
    ) => {
        $(#[path = $path] pub mod $name;)*
        $(#[path = $other_path] pub mod $other;)*

        /// The name of every picture, and the function that draws the picture. The five steps'
        /// pictures come first. The examples' pictures follow, in the order of the steps.
        pub const PICTURES: &[(&str, DrawPicture)] = &[
            ("step01_rays", step01_rays::picture),
            ("step02_sphere", step02_sphere::picture),
            ("step03_nearest", step03_nearest::picture),
            ("step04_diffuse", step04_diffuse::picture),
            ("step05_phong", step05_phong::picture),
            $((stringify!($name), $draw),)*
        ];

        /// Calls a macro with the names of all [`PICTURES`].
        #[macro_export]
        macro_rules! with_picture_names {
            ($dollar callback:ident) => {
                $dollar callback! {
                    step01_rays step02_sphere step03_nearest step04_diffuse step05_phong $($name)*
                }
            };
        }
    };
}

// Lists the examples that this library contains, each with its path. In `pictures`, each path is
// followed by the function that draws the example's locked picture.
examples! {
    $
    pictures {
        gradient: "../../../../../steps/step01_rays/examples/gradient.rs" => |_, _| gradient::picture(),
        checkerboard: "../../../../../steps/step01_rays/examples/checkerboard.rs" => |camera, _| checkerboard::picture(camera),
        graticule: "../../../../../steps/step01_rays/examples/graticule.rs" => graticule::picture,
        jitter: "../../../../../steps/step01_rays/examples/jitter.rs" => jitter::picture,
        look_at: "../../../../../steps/step01_rays/examples/look_at.rs" => look_at::picture,
        panorama: "../../../../../steps/step01_rays/examples/panorama.rs" => panorama::picture,
        rings: "../../../../../steps/step01_rays/examples/rings.rs" => rings::picture,
        disc: "../../../../../steps/step02_sphere/examples/disc.rs" => |camera, _| disc::picture(camera),
        lens: "../../../../../steps/step02_sphere/examples/lens.rs" => lens::picture,
        plane: "../../../../../steps/step02_sphere/examples/plane.rs" => plane::picture,
        quadric: "../../../../../steps/step02_sphere/examples/quadric.rs" => quadric::picture,
        shapes: "../../../../../steps/step02_sphere/examples/shapes.rs" => shapes::picture,
        all_hits: "../../../../../steps/step03_nearest/examples/all_hits.rs" => all_hits::picture,
        depth: "../../../../../steps/step03_nearest/examples/depth.rs" => depth::picture,
        many: "../../../../../steps/step03_nearest/examples/many.rs" => many::picture,
        my_scene: "../../../../../steps/step03_nearest/examples/my_scene.rs" => my_scene::picture,
        gamma: "../../../../../steps/step04_diffuse/examples/gamma.rs" => gamma::picture,
        normals: "../../../../../steps/step04_diffuse/examples/normals.rs" => normals::picture,
        plaster: "../../../../../steps/step04_diffuse/examples/plaster.rs" => plaster::picture,
        shadows: "../../../../../steps/step04_diffuse/examples/shadows.rs" => shadows::picture,
        snowman: "../../../../../steps/step04_diffuse/examples/snowman.rs" => snowman::picture,
        spot: "../../../../../steps/step04_diffuse/examples/spot.rs" => spot::picture,
        sun: "../../../../../steps/step04_diffuse/examples/sun.rs" => sun::picture,
        crowd: "../../../../../steps/step05_phong/examples/crowd.rs" => crowd::picture,
        glass: "../../../../../steps/step05_phong/examples/glass.rs" => glass::picture,
        halfway: "../../../../../steps/step05_phong/examples/halfway.rs" => halfway::picture,
        highlight: "../../../../../steps/step05_phong/examples/highlight.rs" => highlight::picture,
        marbles: "../../../../../steps/step05_phong/examples/marbles.rs" => marbles::picture,
        mirror: "../../../../../steps/step05_phong/examples/mirror.rs" => mirror::picture,
    }
    others {
        directions: "../../../../../steps/step01_rays/examples/directions.rs",
        own_scene: "../../../../../steps/step05_phong/examples/own_scene.rs",
        row: "../../../../../steps/step01_rays/examples/row.rs",
        terms: "../../../../../steps/step05_phong/examples/terms.rs",
    }
}

/// Finds the function that draws the picture of the step or example with this name.
pub fn find_draw_function(name: &str) -> Option<DrawPicture> {
    PICTURES.iter().find(|(key, _)| *key == name).map(|(_, draw)| *draw)
}

impl Step {
    /// The function that draws this step's picture.
    pub fn draw_function(self) -> DrawPicture {
        PICTURES[self as usize].1
    }
}
