//! The list of locked pictures.

use course::examples::{checkerboard::colour as floor, mirror, terms};
use course::{DrawPicture, camera, camera_with_size, colour_without_highlight_gate};
use glam::{DMat3, DVec3};
use image::RgbImage;
use image::imageops::{FilterType, resize};
use step01_rays::Camera;
use step05_phong::*;

/// A locked picture: its name, its camera, and the function that draws the picture.
pub type LockedPicture = (&'static str, Camera, DrawPicture);

/// Returns all locked pictures: those of the steps, the exercises and the chapters, and the cover.
pub fn locked_pictures() -> Vec<LockedPicture> {
    let with_camera = |(name, draw): &(_, _)| (*name, camera(), *draw);
    course::PICTURES.iter().map(with_camera).chain(chapter_pictures()).collect()
}

/// Lists the chapters' pictures, and defines the macro `with_chapter_picture_names`, which passes
/// the pictures' names to another macro. Only a macro can declare a test function for each name.
macro_rules! chapter_pictures {
    ($dollar:tt $($name:ident: $camera:expr, $draw:expr;)*) => {
        /// The cover, and the chapters' pictures that belong to no step or exercise.
        fn chapter_pictures() -> Vec<LockedPicture> {
            vec![$((stringify!($name), $camera, $draw)),*]
        }

        /// Passes the names of the pictures in `chapter_pictures` to a macro.
        #[macro_export]
        macro_rules! with_chapter_picture_names {
            ($dollar callback:ident) => { $dollar callback! { $($name)* } };
        }
    };
}

chapter_pictures! {
    $
    slide_matrix: camera_with_slide_matrix(), step05_phong::picture;
    step05_ambient: camera(), |camera, _| terms::picture(camera, |phong| phong.ambient);
    step05_diffuse: camera(), |camera, _| terms::picture(camera, |phong| phong.diffuse);
    step05_specular: camera(), |camera, _| terms::picture(camera, |phong| phong.specular);
    one_ray: checkerboard_detail_camera(), |camera, _| enlarge(render(camera, 1, floor));
    sixteen_rays: checkerboard_detail_camera(), |camera, _| enlarge(render(camera, 4, floor));
    open_gate: highlight_gate_close_up_camera(), |camera, _| {
        let scene = scene();
        enlarge(render(camera, 1, |ray| colour_without_highlight_gate(&scene, ray)))
    };
    shut_gate: highlight_gate_close_up_camera(), |camera, _| enlarge(picture(camera, 1));
    speckled: camera_with_hard_coded_tangent(), |camera, _| draw_mirrors_without_reflections(camera, 0.0);
    shadowed: camera(), |camera, _| draw_mirrors_without_reflections(camera, mirror::OFFSET);
    close_up: white_sphere_detail_camera(), |camera, _| mirror::picture(camera, 2);
    cover: camera_with_size(1280, 720), |camera, _| step05_phong::picture(camera, 4);
    goodbye: camera_with_size(1280, 720), |camera, _| mirror::picture(camera, 2);
}

/// The course's camera, but with the matrix exactly as it is on the slide "A Basic 3D Camera
/// Matrix".
fn camera_with_slide_matrix() -> Camera {
    let mut camera = camera();
    let tan = -camera.matrix.z_axis.x;
    let upright = f64::from(camera.v_res) * tan / f64::from(camera.h_res - 1);
    camera.matrix.y_axis.y = -2.0 * upright;
    camera.matrix.z_axis.y = upright;
    camera
}

/// A camera for a close-up of four tiles of the checkerboard.
fn checkerboard_detail_camera() -> Camera {
    crop_camera(camera(), [366.0, 264.0], [40, 30])
}

/// A camera for a close-up of the pixels that the gate changes. The gate is the test of n·l:
/// without the gate, these pixels would show a highlight.
fn highlight_gate_close_up_camera() -> Camera {
    crop_camera(camera(), [585.0, 150.0], [40, 30])
}

/// A camera for a close-up of the white sphere.
fn white_sphere_detail_camera() -> Camera {
    crop_camera(camera_with_size(2560, 1440), [213.0, 926.0], [640, 360])
}

/// The course's camera, with the tangent as a literal. A picture drawn with this camera shows
/// rounding errors, and a computed tangent might be rounded differently on another machine.
fn camera_with_hard_coded_tangent() -> Camera {
    const TAN_30: f64 = 0.577_350_269_189_625_7;
    let d = 2.0 * TAN_30 / 639.0;
    let matrix = DMat3::from_cols(
        DVec3::new(d, 0.0, 0.0),
        DVec3::new(0.0, -d, 0.0),
        DVec3::new(-TAN_30, 359.0 / 639.0 * TAN_30, -1.0),
    );
    Camera { matrix, ..camera() }
}

/// Draws the mirror scene with shadows but without reflections. The rays to the lights start at the
/// distance `shadow_offset` above a surface.
fn draw_mirrors_without_reflections(camera: &Camera, shadow_offset: f64) -> RgbImage {
    let scene = mirror::mirrors();
    render(camera, 1, |ray| mirror::colour(&scene, ray, 0, shadow_offset))
}

/// Crops a camera to a rectangle of the camera's picture. `corner` is the rectangle's first column
/// and row. `h_res` and `v_res` are the rectangle's numbers of columns and rows.
fn crop_camera(camera: Camera, corner: [f64; 2], [h_res, v_res]: [u32; 2]) -> Camera {
    let crop = DMat3::from_translation(corner.into());
    Camera { h_res, v_res, matrix: camera.matrix * crop, ..camera }
}

/// Enlarges a picture, so that each pixel becomes a square of 16×16 pixels.
fn enlarge(picture: RgbImage) -> RgbImage {
    resize(&picture, 16 * picture.width(), 16 * picture.height(), FilterType::Nearest)
}
