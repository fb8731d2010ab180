use exercises::{Picture, camera, mirror, terms};
use glam::{DMat3, DVec3};
use image::RgbImage;
use step01_rays::Camera;
use step05_phong::*;

/// A locked picture: its name, its camera and how it is drawn.
pub type LockedPicture = (&'static str, Camera, Picture);

/// The locked pictures: of the steps, the exercises, the chapters and the cover.
pub fn locked_pictures() -> Vec<LockedPicture> {
    let drawn = exercises::STEPS.iter().chain(exercises::PICTURES);
    let mut all: Vec<LockedPicture> =
        drawn.map(|(name, picture)| (*name, camera(), *picture)).collect();
    let large = Camera::new(1280, 720, 60_f64.to_radians());
    let more: [LockedPicture; 9] = [
        ("slide_matrix", exercises::slide_matrix(), step05_phong::picture),
        ("step05_ambient", camera(), |camera, _| {
            terms::picture(camera, |phong| phong.ambient)
        }),
        ("step05_diffuse", camera(), |camera, _| {
            terms::picture(camera, |phong| phong.diffuse)
        }),
        ("step05_specular", camera(), |camera, _| {
            terms::picture(camera, |phong| phong.specular)
        }),
        ("speckled", camera_without_tan(), draw_speckled),
        ("shadowed", camera(), draw_shadowed),
        ("close_up", close_up_camera(), |camera, _| mirror::picture(camera, 2)),
        ("cover", large, |camera, _| step05_phong::picture(camera, 4)),
        ("goodbye", large, |camera, _| mirror::picture(camera, 2)),
    ];
    all.extend(more);
    all
}

/// The camera of the course, with a tangent that is the same on every machine.
fn camera_without_tan() -> Camera {
    const TAN_30: f64 = 0.577_350_269_189_625_7;
    let d = 2.0 * TAN_30 / 639.0;
    let matrix = DMat3::from_cols(
        DVec3::new(d, 0.0, 0.0),
        DVec3::new(0.0, -d, 0.0),
        DVec3::new(-TAN_30, 359.0 / 639.0 * TAN_30, -1.0),
    );
    Camera { matrix, ..camera() }
}

/// The shadows of rays that start on the surface itself.
fn draw_speckled(camera: &Camera, samples: u32) -> RgbImage {
    let scene = scene();
    render(camera, samples, |ray| {
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
fn draw_shadowed(camera: &Camera, samples: u32) -> RgbImage {
    let scene = mirror::mirrors();
    render(camera, samples, |ray| mirror::colour(&scene, ray, 0))
}

/// The white sphere: a part of the picture with 2560 columns, from column 213 and row 926
/// on.
fn close_up_camera() -> Camera {
    let whole = Camera::new(2560, 1440, 60_f64.to_radians());
    let corner = DVec3::new(213.0, 926.0, 1.0);
    let part = DMat3::from_cols(DVec3::X, DVec3::Y, corner);
    Camera { matrix: whole.matrix * part, ..camera() }
}
