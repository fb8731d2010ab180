//! Everything that a ray hits, at once: as if the spheres were ghosts.

use glam::DVec3;
use image::RgbImage;
use step03_nearest::{
    Camera, OBJECTS, Object, Ray, direction_colour, draw_and_save, render,
};

/// The mean colour of all objects that `ray` hits, or else the colour of the sky.
fn colour(objects: &[Object<DVec3>], ray: &Ray) -> DVec3 {
    let hits = objects
        .iter()
        .filter(|object| object.sphere.intersect(ray).first_hit().is_some());
    let colours: Vec<DVec3> = hits.map(|object| object.material).collect();
    if colours.is_empty() {
        return direction_colour(ray);
    }
    colours.iter().sum::<DVec3>() / colours.len() as f64
}

/// The picture: the scene's objects, seen through one another.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&OBJECTS, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
