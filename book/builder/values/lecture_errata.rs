//! The numbers of the lecture's slips.

use super::Value;
use super::measure::{
    UNGATED, ahead, both, camera, discriminant, grouped, number, pixels, tenths,
};
use exercises::slide_matrix;
use glam::DVec3;
use live::Row;
use step01_rays::Camera;
use step02_sphere::SPHERE;
use step05_phong::reflect;

pub const VALUES: &[Value] = &[
    ("slips-first-v0-y", || number(upright())),
    ("slips-first-v0-pixels", || number(pixels(upright() - top(&camera())))),
    ("slips-slide-v0-y", || number(top(&slide_matrix()))),
    ("slips-slide-v0-pixels", || {
        number(pixels(top(&slide_matrix()) - top(&camera())))
    }),
    ("slips-slide-d-v", || number(slide_matrix().matrix.y_axis.y)),
    ("slips-meant-d-v", || format!("{:.6}", -2.0 * upright() / 359.0)),
    ("slips-meant-ratio", || number(pixels(2.0 * upright() / 359.0))),
    ("slips-slide-times", || {
        grouped(slide_matrix().matrix.y_axis.y / camera().matrix.y_axis.y)
    }),
    ("slips-slide-row-0", || row(0.0)),
    ("slips-slide-row-1", || row(1.0)),
    ("slips-slide-row-2", || row(2.0)),
    ("slips-slide-row-10", || row(10.0)),
    ("slips-slide-row-359", || row(359.0)),
    ("slips-slide-angle-0", || tenths(degrees_down(&slide_matrix(), 0.0))),
    ("slips-slide-angle-1", || tenths(degrees_down(&slide_matrix(), 1.0))),
    ("slips-slide-angle-2", || tenths(degrees_down(&slide_matrix(), 2.0))),
    ("slips-slide-angle-10", || tenths(degrees_down(&slide_matrix(), 10.0))),
    ("slips-slide-angle-359", || tenths(degrees_down(&slide_matrix(), 359.0))),
    ("slips-angle-0", || tenths(degrees_down(&camera(), 0.0))),
    ("slips-angle-1", || tenths(degrees_down(&camera(), 1.0))),
    ("slips-angle-2", || tenths(degrees_down(&camera(), 2.0))),
    ("slips-angle-10", || tenths(degrees_down(&camera(), 10.0))),
    ("slips-angle-359", || tenths(degrees_down(&camera(), 359.0))),
    ("slips-row-last", || number(flat().direction(639.0).x)),
    ("slips-row-beyond", || number(flat().direction(640.0).x)),
    ("slips-row-angle", || {
        let angle = flat().direction(640.0).angle_to(flat().direction(0.0));
        number(angle.to_degrees())
    }),
    ("slips-i-twice-2", || number(pixels(twice(2.0) - flat().direction(0.0).x))),
    ("slips-i-twice-last", || number(twice(639.0))),
    ("slips-pass-b", || number(SPHERE.coefficients(&ahead(1.1, 0.0)).1)),
    ("slips-pass-c", || number(SPHERE.coefficients(&ahead(1.1, 0.0)).2)),
    ("slips-pass-discriminant", || number(discriminant(&SPHERE, &ahead(1.1, 0.0)))),
    ("slips-pass-real", || {
        let (a, b, _) = SPHERE.coefficients(&ahead(1.1, 0.0));
        number(-b / (2.0 * a))
    }),
    ("slips-pass-imaginary", || {
        let ray = ahead(1.1, 0.0);
        let (a, _, _) = SPHERE.coefficients(&ray);
        number((-discriminant(&SPHERE, &ray)).sqrt() / (2.0 * a))
    }),
    ("slips-inside", || both(&SPHERE, &ahead(0.0, -5.0))),
    ("slips-behind", || both(&SPHERE, &ahead(0.0, -10.0))),
    ("slips-behind-discriminant", || {
        number(discriminant(&SPHERE, &ahead(0.0, -10.0)))
    }),
    ("slips-gate-n-l", || number(behind().0)),
    ("slips-gate-r-v", || number(behind().1)),
    ("slips-gate-pixels", || grouped(UNGATED.0 as f64)),
    ("slips-gate-most", || UNGATED.1.to_string()),
    ("slips-v-angle", || {
        number(degrees_down(&camera(), 359.0) - degrees_down(&camera(), 0.0))
    }),
];

/// vRes / hRes · tan(θ/2).
fn upright() -> f64 {
    360.0 / 640.0 * (60_f64.to_radians() / 2.0).tan()
}

/// The y of V_0.
fn top(camera: &Camera) -> f64 {
    camera.matrix.z_axis.y
}

/// The height of a row's directions with the matrix on the slide.
fn row(j: f64) -> String {
    number(slide_matrix().ray(0.0, j).direction.y)
}

/// How many degrees below the horizon a camera looks through a row, in the middle
/// of it.
fn degrees_down(camera: &Camera, j: f64) -> f64 {
    let v = camera.ray(319.5, j).direction;
    (-v.y).atan2(-v.z).to_degrees()
}

/// The row of rays of the course's pictures.
fn flat() -> Row {
    Row::new(640, 60_f64.to_radians())
}

/// The x of V_i if D itself held a factor i, as on "Finding the Other Rays".
fn twice(i: f64) -> f64 {
    flat().direction(i * i).x
}

/// n·l and r·v where the light stands behind the surface y = 0 and low.
fn behind() -> (f64, f64) {
    let (n, v) = (DVec3::Y, DVec3::new(-0.8, 0.6, 0.0));
    let l = DVec3::new(4.0, -3.0, 0.0).normalize();
    (n.dot(l), reflect(n, l).dot(v))
}
