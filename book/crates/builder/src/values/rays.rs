//! The rays of the course's pictures, and what they meet.

pub use figures::{camera, discriminant};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use step05_phong::{Material, Object, Ray, nearest, scene};

/// The ray through a pixel.
pub fn pixel_ray([i, j]: [u32; 2]) -> Ray {
    camera().ray(i.into(), j.into())
}

/// The object that a pixel of step 5's picture shows.
pub fn object_of_pixel(pixel: [u32; 2]) -> Object<Material> {
    *nearest(&scene().objects, &pixel_ray(pixel)).expect("an object").object
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
