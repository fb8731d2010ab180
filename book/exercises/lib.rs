//! The steps' pictures and their examples as a library: what is drawn on the way and the
//! solutions of the exercises. Who wants to draw one takes it from here.

#![allow(dead_code, reason = "the main of an example runs as a program only")]
#![allow(
    clippy::duplicate_mod,
    reason = "`fast` has `many` in it, `crowd` has `mirror`"
)]
#![allow(
    missing_docs,
    reason = "each is a program, and says at its top what it draws"
)]

use image::RgbImage;
use step01_rays::Camera;

#[path = "../../steps/step03_nearest/examples/all_hits.rs"]
pub mod all_hits;
#[path = "../../steps/step01_rays/examples/checkerboard.rs"]
pub mod checkerboard;
#[path = "../../steps/step05_phong/examples/crowd.rs"]
pub mod crowd;
#[path = "../../steps/step03_nearest/examples/depth.rs"]
pub mod depth;
#[path = "../../steps/step02_sphere/examples/disc.rs"]
pub mod disc;
#[path = "../../steps/step05_phong/examples/fast.rs"]
pub mod fast;
#[path = "../../steps/step04_diffuse/examples/gamma.rs"]
pub mod gamma;
#[path = "../../steps/step05_phong/examples/glass.rs"]
pub mod glass;
#[path = "../../steps/step01_rays/examples/gradient.rs"]
pub mod gradient;
#[path = "../../steps/step01_rays/examples/graticule.rs"]
pub mod graticule;
#[path = "../../steps/step05_phong/examples/halfway.rs"]
pub mod halfway;
#[path = "../../steps/step05_phong/examples/highlight.rs"]
pub mod highlight;
#[path = "../../steps/step01_rays/examples/jitter.rs"]
pub mod jitter;
#[path = "../../steps/step02_sphere/examples/lens.rs"]
pub mod lens;
#[path = "../../steps/step01_rays/examples/look_at.rs"]
pub mod look_at;
#[path = "../../steps/step03_nearest/examples/many.rs"]
pub mod many;
#[path = "../../steps/step05_phong/examples/marbles.rs"]
pub mod marbles;
#[path = "../../steps/step05_phong/examples/mirror.rs"]
pub mod mirror;
#[path = "../../steps/step03_nearest/examples/my_scene.rs"]
pub mod my_scene;
#[path = "../../steps/step04_diffuse/examples/normals.rs"]
pub mod normals;
#[path = "../../steps/step01_rays/examples/panorama.rs"]
pub mod panorama;
#[path = "../../steps/step02_sphere/examples/plane.rs"]
pub mod plane;
#[path = "../../steps/step04_diffuse/examples/plaster.rs"]
pub mod plaster;
#[path = "../../steps/step02_sphere/examples/quadric.rs"]
pub mod quadric;
#[path = "../../steps/step01_rays/examples/rings.rs"]
pub mod rings;
#[path = "../../steps/step01_rays/examples/row.rs"]
pub mod row;
#[path = "../../steps/step04_diffuse/examples/shadows.rs"]
pub mod shadows;
#[path = "../../steps/step04_diffuse/examples/snowman.rs"]
pub mod snowman;
#[path = "../../steps/step04_diffuse/examples/spot.rs"]
pub mod spot;
#[path = "../../steps/step01_rays/examples/step01_starter.rs"]
pub mod step01_starter;
#[path = "../../steps/step02_sphere/examples/step02_starter.rs"]
pub mod step02_starter;
#[path = "../../steps/step03_nearest/examples/step03_starter.rs"]
pub mod step03_starter;
#[path = "../../steps/step04_diffuse/examples/step04_starter.rs"]
pub mod step04_starter;
#[path = "../../steps/step05_phong/examples/step05_starter.rs"]
pub mod step05_starter;
#[path = "../../steps/step04_diffuse/examples/sun.rs"]
pub mod sun;
#[path = "../../steps/step05_phong/examples/terms.rs"]
pub mod terms;

/// Draws a picture for a camera, with so many rays a pixel each way.
pub type Picture = fn(&Camera, u32) -> RgbImage;

/// The camera of the course's pictures: 640 columns, 16:9, 60 degrees, which the programs
/// turn into radians; π/3 is another number in its last digit.
pub fn camera() -> Camera {
    Camera::new(640, 360, 60_f64.to_radians())
}

/// The camera whose matrix is that of the slide "A Basic 3D Camera Matrix", to the letter.
pub fn slide_matrix() -> Camera {
    let mut camera = camera();
    let tan = -camera.matrix.z_axis.x;
    let upright = f64::from(camera.v_res) * tan / f64::from(camera.h_res - 1);
    camera.matrix.y_axis.y = -2.0 * upright;
    camera.matrix.z_axis.y = upright;
    camera
}

/// The five steps: the name of each, and its picture.
pub const STEPS: [(&str, Picture); 5] = [
    ("step01_rays", step01_rays::picture),
    ("step02_sphere", step02_sphere::picture),
    ("step03_nearest", step03_nearest::picture),
    ("step04_diffuse", step04_diffuse::picture),
    ("step05_phong", step05_phong::picture),
];

/// The pictures of the examples by their names, step by step.
pub const PICTURES: &[(&str, Picture)] = &[
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
