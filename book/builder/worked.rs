//! Worked examples that need more than one line: the cameras and the counts of the
//! last pages.

use ::gallery::{Difference, Parts, Step};
use glam::{DMat2, DMat3, DVec2, DVec3};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::FRAC_PI_3;
use std::sync::LazyLock;
use step01_rays::Row;
use step05_phong::{
    Camera, Ray, SPHERES, Sphere, nearest, normal, picture, reflect,
};

/// The camera of the course's pictures: 640 columns, 16:9, 60 degrees.
pub fn camera() -> Camera {
    Camera::new(640, 360, FRAC_PI_3)
}

/// The sum of `number` over all rays of the course's pictures.
pub fn count(number: impl Fn(&Ray) -> usize + Sync) -> usize {
    let camera = camera();
    let of_row = |j: u32| -> usize {
        let rays = (0..camera.h_res).map(|i| camera.ray(i.into(), j.into()));
        rays.map(|ray| number(&ray)).sum()
    };
    (0..camera.v_res).into_par_iter().map(of_row).sum()
}

/// The same camera with the matrix on the slide "A Basic 3D Camera Matrix".
pub fn slide_camera() -> Camera {
    let tan = (FRAC_PI_3 / 2.0).tan();
    let (h_res, v_res) = (640.0, 360.0);
    let d_u = DVec3::new(2.0 * tan / (h_res - 1.0), 0.0, 0.0);
    let d_v = DVec3::new(0.0, -2.0 * v_res * tan / (h_res - 1.0), 0.0);
    let v_0 = DVec3::new(-tan, v_res * tan / (h_res - 1.0), -1.0);
    Camera { matrix: DMat3::from_cols(d_u, d_v, v_0), ..camera() }
}

/// How many degrees below the horizon a camera looks through a row, in the middle
/// of it.
pub fn degrees_down(camera: &Camera, j: f64) -> f64 {
    let v = camera.ray(319.5, j).direction;
    (-v.y).atan2(-v.z).to_degrees()
}

/// The row of rays of the course's pictures.
pub fn row() -> Row {
    Row::new(640, FRAC_PI_3)
}

/// The direction V_i if D itself held a factor i, as on "Finding the Other Rays".
pub fn row_of_the_slide(i: f64) -> DVec2 {
    let [d, v_0] = [row().matrix.x_axis, row().matrix.y_axis];
    DMat2::from_cols(i * d, v_0) * DVec2::new(i, 1.0)
}

/// a, b and c for the sphere of step 2 and a ray along −z that starts at (x, 0, z).
pub fn ahead(x: f64, z: f64) -> (f64, f64, f64) {
    let ray = Ray { start: DVec3::new(x, 0.0, z), direction: DVec3::NEG_Z };
    step02_sphere::SPHERE.coefficients(&ray)
}

/// n·l and r·v where the light stands behind the surface y = 0 and low.
pub fn behind() -> (f64, f64) {
    let (n, v) = (DVec3::Y, DVec3::new(-0.8, 0.6, 0.0));
    let l = DVec3::new(4.0, -3.0, 0.0).normalize();
    (n.dot(l), reflect(l, n).dot(v))
}

/// Without the test of n·l: how many pixels of the final picture change, and by how
/// much at most.
pub static UNGATED: LazyLock<(usize, u8)> = LazyLock::new(ungated);

fn ungated() -> (usize, u8) {
    let parts = Parts { lit: |_, _| true, ..Parts::right(&camera()) };
    let wrong = parts.picture(Step::Phong, 1);
    match Difference::between(&picture(&camera(), 1), &wrong) {
        Some(Difference::Pixels { count, largest, .. }) => (count, largest),
        _ => (0, 0),
    }
}

/// How many pixels of the final picture show a sphere, and in how many of them the
/// mirrored ray meets that sphere again where it starts.
pub static MIRRORED: LazyLock<(usize, usize)> = LazyLock::new(mirrored);

fn mirrored() -> (usize, usize) {
    let again = |ray: &Ray| {
        let Some((p, n, index)) = seen(ray) else { return false };
        let v = ray.direction;
        let mirrored = Ray { start: p, direction: v - 2.0 * n.dot(v) * n };
        SPHERES[index].intersect(&mirrored).first_hit().is_some()
    };
    (count(|ray| seen(ray).is_some().into()), count(|ray| again(ray).into()))
}

/// The point that a ray sees, the normal there, and the sphere's place in its list.
fn seen(ray: &Ray) -> Option<(DVec3, DVec3, usize)> {
    let hit = nearest(&SPHERES, ray)?;
    let p = ray.at(hit.t);
    Some((p, normal(&SPHERES[hit.index], p), hit.index))
}

/// The basis x', y', z' of a camera at (4, 2, 0) that looks at the middle of the
/// largest sphere, as columns.
pub fn basis() -> DMat3 {
    let Sphere { centre, .. } = SPHERES[0];
    let z = (DVec3::new(4.0, 2.0, 0.0) - centre).normalize();
    let x = DVec3::Y.cross(z).normalize();
    DMat3::from_cols(x, z.cross(x), z)
}

/// The part of a screen's light that a byte of sRGB stands for.
pub fn light_of_byte(byte: f64) -> f64 {
    let x = byte / 255.0;
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}

/// The byte of sRGB that stands for a part of a screen's light.
pub fn byte_of_light(x: f64) -> f64 {
    let encoded =
        if x <= 0.0031308 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round()
}
