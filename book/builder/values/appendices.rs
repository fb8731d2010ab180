//! The numbers of the appendices.

use super::{Value, grouped, short, vector};
use crate::worked::{self, camera};
use std::f64::consts::FRAC_PI_3;
use step02_sphere::{Roots, quadratic};
use step03_nearest::SPHERES;

pub(super) const VALUES: &[Value] = &[
    // slips.md
    ("slips-first-v0-y", || short(360.0 / 640.0 * tan())),
    ("slips-first-v0-pixels", || {
        let step = camera().matrix.x_axis.x;
        short((360.0 / 640.0 * tan() - camera().matrix.z_axis.y) / step)
    }),
    ("slips-slide-v0-y", || short(worked::slide_camera().matrix.z_axis.y)),
    ("slips-slide-v0-pixels", || {
        let step = camera().matrix.x_axis.x;
        let y = worked::slide_camera().matrix.z_axis.y;
        short((y - camera().matrix.z_axis.y) / step)
    }),
    ("slips-slide-d-v", || short(worked::slide_camera().matrix.y_axis.y)),
    ("slips-meant-d-v", || format!("{:.6}", -2.0 * 360.0 / 640.0 * tan() / 359.0)),
    ("slips-meant-ratio", || {
        short(2.0 * 360.0 / 640.0 * tan() / 359.0 / camera().matrix.x_axis.x)
    }),
    ("slips-slide-times", || {
        grouped(worked::slide_camera().matrix.y_axis.y / camera().matrix.y_axis.y)
    }),
    ("slips-slide-row-0", || slide_row(0.0)),
    ("slips-slide-row-1", || slide_row(1.0)),
    ("slips-slide-row-2", || slide_row(2.0)),
    ("slips-slide-row-10", || slide_row(10.0)),
    ("slips-slide-row-359", || slide_row(359.0)),
    ("slips-slide-angle-0", || slide_angle(0.0)),
    ("slips-slide-angle-1", || slide_angle(1.0)),
    ("slips-slide-angle-2", || slide_angle(2.0)),
    ("slips-slide-angle-10", || slide_angle(10.0)),
    ("slips-slide-angle-359", || slide_angle(359.0)),
    ("slips-angle-0", || angle(0.0)),
    ("slips-angle-1", || angle(1.0)),
    ("slips-angle-2", || angle(2.0)),
    ("slips-angle-10", || angle(10.0)),
    ("slips-angle-359", || angle(359.0)),
    ("slips-row-last", || short(worked::row().direction(639.0).x)),
    ("slips-row-beyond", || short(worked::row().direction(640.0).x)),
    ("slips-row-angle", || {
        let row = worked::row();
        let angle = row.direction(640.0).angle_to(row.direction(0.0));
        short(angle.to_degrees())
    }),
    ("slips-i-twice-2", || {
        let from_v_0 =
            worked::row_of_the_slide(2.0).x - worked::row().direction(0.0).x;
        short(from_v_0 / camera().matrix.x_axis.x)
    }),
    ("slips-i-twice-last", || short(worked::row_of_the_slide(639.0).x)),
    ("slips-pass-b", || short(worked::ahead(1.1, 0.0).1)),
    ("slips-pass-c", || short(worked::ahead(1.1, 0.0).2)),
    ("slips-pass-discriminant", || short(discriminant(worked::ahead(1.1, 0.0)))),
    ("slips-pass-real", || {
        let (a, b, _) = worked::ahead(1.1, 0.0);
        short(-b / (2.0 * a))
    }),
    ("slips-pass-imaginary", || {
        let (a, b, c) = worked::ahead(1.1, 0.0);
        short((-discriminant((a, b, c))).sqrt() / (2.0 * a))
    }),
    ("slips-inside", || both_roots(worked::ahead(0.0, -5.0))),
    ("slips-behind", || both_roots(worked::ahead(0.0, -10.0))),
    ("slips-behind-discriminant", || {
        short(discriminant(worked::ahead(0.0, -10.0)))
    }),
    ("slips-gate-n-l", || short(worked::behind().0)),
    ("slips-gate-r-v", || short(worked::behind().1)),
    ("slips-gate-pixels", || grouped(worked::UNGATED.0 as f64)),
    ("slips-gate-most", || worked::UNGATED.1.to_string()),
    ("slips-v-angle", || {
        let down = worked::degrees_down(&camera(), 359.0);
        short(down - worked::degrees_down(&camera(), 0.0))
    }),
    // where_next.md
    ("next-basis-x", || vector(worked::basis().x_axis)),
    ("next-basis-y", || vector(worked::basis().y_axis)),
    ("next-basis-z", || vector(worked::basis().z_axis)),
    ("next-mirrored-hits", || grouped(worked::MIRRORED.0 as f64)),
    ("next-mirrored-again", || grouped(worked::MIRRORED.1 as f64)),
    ("next-depth-9", || depth(0.9)),
    ("next-depth-5", || depth(0.5)),
    ("next-critical", || short((1.0_f64 / 1.5).asin().to_degrees())),
    ("next-tests", || grouped(640.0 * 360.0 * SPHERES.len() as f64)),
    ("next-tests-many", || grouped(640.0 * 360.0 * 1000.0)),
    ("next-half-byte", || short(worked::light_of_byte(128.0))),
    ("next-byte-of-half", || short(worked::byte_of_light(0.5))),
];

/// tan(θ/2) for 60 degrees.
fn tan() -> f64 {
    (FRAC_PI_3 / 2.0).tan()
}

fn discriminant((a, b, c): (f64, f64, f64)) -> f64 {
    b * b - 4.0 * a * c
}

/// Two roots, with "and" between them.
fn both_roots((a, b, c): (f64, f64, f64)) -> String {
    match quadratic(a, b, c) {
        Roots::Two(near, far) => format!("{} and {}", short(near), short(far)),
        Roots::One(t) => short(t),
        Roots::None => "none".to_string(),
    }
}

/// The height of a row's directions with the matrix on the slide.
fn slide_row(j: f64) -> String {
    short(worked::slide_camera().ray(0.0, j).direction.y)
}

fn slide_angle(j: f64) -> String {
    format!("{:.1}", worked::degrees_down(&worked::slide_camera(), j))
}

fn angle(j: f64) -> String {
    format!("{:.1}", worked::degrees_down(&camera(), j))
}

/// How many mirrors that reflect this part leave less than one step of 8 bits.
fn depth(part: f64) -> String {
    let left = |count: &i32| part.powi(*count) < 1.0 / 255.0;
    (1..).find(left).map_or("none".to_string(), |count| count.to_string())
}
