//! The rays of the course's pictures, and what they meet.

pub use course::camera;
use course::examples::row::Row;
pub use figures::discriminant;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use step05_phong::{Material, Object, Ray, Sphere, nearest, scene};

/// A row of so many rays in 2D, with the angle of the course's camera.
pub fn row(rays: u32) -> Row {
    Row::new(rays, course::FIELD_OF_VIEW)
}

/// The ray through a pixel.
pub fn pixel_ray([i, j]: [u32; 2]) -> Ray {
    camera().ray(i.into(), j.into())
}

/// The ray with a direction of length 1.
pub fn unit_ray(ray: &Ray) -> Ray {
    Ray { direction: ray.direction.normalize(), ..*ray }
}

/// The t of the first hit of a ray that meets the sphere.
pub fn first_hit(sphere: &Sphere, ray: &Ray) -> f64 {
    sphere.intersect(ray).first_hit().expect("a hit")
}

/// The object that a pixel of step 5's picture shows.
pub fn object_of_pixel(pixel: [u32; 2]) -> Object<Material> {
    *nearest(&scene().objects, &pixel_ray(pixel)).expect("an object").object
}

/// The angle in radians, from r, at which a highlight of this shininess is half as bright.
pub fn half_angle(shininess: f64) -> f64 {
    0.5_f64.powf(1.0 / shininess).acos()
}

/// The sum of a number over all rays.
pub fn sum_over_rays(number: impl Fn(&Ray) -> usize + Sync) -> usize {
    let camera = camera();
    let row_sum = |j: u32| -> usize {
        let rays = (0..camera.h_res).map(|i| camera.ray(i.into(), j.into()));
        rays.map(|ray| number(&ray)).sum()
    };
    (0..camera.v_res).into_par_iter().map(row_sum).sum()
}

/// The number of rays of which a predicate holds.
pub fn count_rays(predicate: impl Fn(&Ray) -> bool + Sync) -> usize {
    sum_over_rays(|ray| predicate(ray).into())
}

/// A length on the image plane, in pixels.
pub fn length_in_pixels(length: f64) -> f64 {
    length / camera().matrix.x_axis.x
}
