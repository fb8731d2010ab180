//! The locked pictures, of the steps, the exercises, the chapters and the cover: what is
//! tested before all else.

use exercises::{mirror, slide_matrix, terms};
use glam::{DMat3, DVec3};
use image::RgbImage;
use step01_rays::Camera;
use step05_phong::*;
use tests::{Locking, camera};

#[test]
fn the_pictures_are_locked() {
    let mut locking = Locking::default();
    for (name, picture) in exercises::STEPS.iter().chain(exercises::PICTURES) {
        locking.assert(name, &picture(&camera(), 1));
    }
    let term = |term| terms::picture(&camera(), term);
    locking.assert("step05_ambient", &term(|phong| phong.ambient));
    locking.assert("step05_diffuse", &term(|phong| phong.diffuse));
    locking.assert("step05_specular", &term(|phong| phong.specular));
    locking.assert("slide_matrix", &step05_phong::picture(&slide_matrix(), 1));
    locking.assert("speckled", &speckled());
    locking.assert("shadowed", &shadowed());
    locking.assert("close_up", &mirror::picture(&close_up(), 2));
    let large = Camera::new(1280, 720, 60_f64.to_radians());
    locking.assert("cover", &step05_phong::picture(&large, 4));
    locking.assert("goodbye", &mirror::picture(&large, 2));
    locking.finish();
}

/// The shadows of rays that start on the surface itself.
fn speckled() -> RgbImage {
    let scene = scene();
    render(&camera(), 1, |ray| {
        let Some(point) = visible_point(&scene.objects, ray) else {
            return direction_colour(ray);
        };
        let bare = SurfacePoint { n: DVec3::ZERO, ..point };
        let hidden = |q: DVec3| mirror::hidden(&scene.objects, &bare, q);
        let mut lights = scene.lights.clone();
        lights.retain(|light| !hidden(light.point_light.position));
        phong(&point, ray, scene.ambient_light, &lights).sum()
    })
}

/// The program before it has mirrors: shadows alone.
fn shadowed() -> RgbImage {
    let scene = mirror::mirrors();
    render(&camera(), 1, |ray| mirror::colour(&scene, ray, 0))
}

/// The white sphere: a part of the picture with 2560 columns, from column 213 and row 926
/// on.
fn close_up() -> Camera {
    let whole = Camera::new(2560, 1440, 60_f64.to_radians());
    let corner = DVec3::new(213.0, 926.0, 1.0);
    let part = DMat3::from_cols(DVec3::X, DVec3::Y, corner);
    Camera { matrix: whole.matrix * part, ..camera() }
}
