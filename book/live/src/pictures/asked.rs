use crate::live::{Handle, Knob, Numbers, number, vector};
use crate::{discriminant, roots};
use glam::{DMat3, DVec2, DVec3, dvec2};
use step01_rays::{Camera, Ray, direction_colour, render};
use step02_sphere::Sphere;

/// The column of the pixel that is asked.
pub const COLUMN: Knob = Knob::new(["i", "column", ""], 470.0, [0.0, 639.0], 1.0);

/// Its row.
pub const ROW: Knob = Knob::new(["j", "row", ""], 120.0, [0.0, 359.0], 1.0);

/// How many columns the picture has; a page draws them all.
pub const COLUMNS: Knob =
    Knob::new(["hRes", "columns", ""], 640.0, [2.0, 640.0], 1.0).fixed();

/// Columns and rows of the pictures of the course.
pub const SIZE: DVec2 = dvec2(640.0, 360.0);

/// The cross at the pixel, for a picture whose first knobs are `COLUMN` and `ROW`.
pub const PIXEL: Handle = Handle {
    words: "the pixel that you ask",
    knobs: [0, 1],
    at: |values| dvec2(values[0], values[1]) + 0.5,
    drag: |values, to| {
        values[..2].copy_from_slice(&(to - 0.5).to_array());
    },
    is_down: true,
    is_asking: true,
};

/// Where in the picture of the course a point of the world is.
pub fn place(p: DVec3) -> DVec2 {
    place_by(&crate::camera(), p)
}

/// Where in the picture of a camera a point of the world is: in
/// p = d [D_u D_v V_0] (i, j, 1)ᵀ, d is how deep it lies. What is behind the eye is
/// left of the picture.
pub fn place_by(camera: &Camera, p: DVec3) -> DVec2 {
    let pixel = camera.matrix.inverse() * (p - camera.centre);
    if pixel.z <= 0.0 {
        return DVec2::NEG_X;
    }
    pixel.truncate() / pixel.z + 0.5
}

/// The point of the world that is seen at a place, `depth` ahead.
pub fn point(place: DVec2, depth: f64) -> DVec3 {
    let pixel = place - 0.5;
    crate::camera().ray(pixel.x, pixel.y).at(depth)
}

/// The camera of a picture of so many columns.
pub fn camera(columns: f64) -> Result<Camera, String> {
    super::step01::camera(&[60.0, 1.0, columns])
}

/// The camera of allowed columns.
pub fn seen(columns: f64) -> Camera {
    camera(columns).unwrap_or_else(|_| crate::camera())
}

/// The ray through the pixel that is asked, in the picture of the course.
pub fn ray(values: &[f64]) -> Ray {
    crate::camera().ray(values[0], values[1])
}

/// From the pixel to every root, sphere by sphere.
pub fn from_pixel<'a>(
    values: &[f64],
    spheres: impl Iterator<Item = &'a Sphere>,
) -> Numbers {
    let ray = ray(values);
    let mut numbers: Numbers = vec![
        ("i".into(), number(values[0])),
        ("j".into(), number(values[1])),
        ("V".into(), vector(&ray.direction.to_array())),
    ];
    for (k, sphere) in spheres.enumerate() {
        let (a, b, c) = sphere.coefficients(&ray);
        let [near, far] = roots(sphere, &ray).map(root);
        let d = number(discriminant(sphere, &ray));
        let row = [number(a), number(b), number(c), d, near, far];
        let names = ["a", "b", "c", "D", "near", "far"];
        numbers.extend(names.map(|name| format!("{name}{k}")).into_iter().zip(row));
    }
    numbers
}

/// What the ray meets and where, or else the colour of the sky; the one that there is
/// not is empty.
pub fn met(hit: Option<(&str, f64)>, ray: &Ray) -> Numbers {
    let (which, t) =
        hit.map_or_else(Default::default, |(which, t)| (which, number(t)));
    let sky = match hit {
        Some(_) => String::new(),
        None => vector(&direction_colour(ray).to_array()),
    };
    vec![("which".into(), which.into()), ("t".into(), t), ("sky".into(), sky)]
}

/// The three bytes of the pixel through which `ray` goes: a picture of this one ray.
pub fn bytes(ray: &Ray, colour: impl Fn(&Ray) -> DVec3 + Sync) -> (String, String) {
    let matrix = DMat3::from_cols(DVec3::ZERO, DVec3::ZERO, ray.direction);
    let camera = Camera { centre: ray.start, h_res: 1, v_res: 1, matrix };
    let pixel = render(&camera, 1, colour).get_pixel(0, 0).0;
    ("bytes".into(), vector(&pixel.map(f64::from)))
}

/// A root, or what is written where there is none.
fn root(t: f64) -> String {
    if t.is_nan() { "–".to_string() } else { number(t) }
}
