//! A camera anywhere: position, target and roll.

use glam::{DMat3, DVec3};
use image::RgbImage;
use step01_rays::{Camera, Ray, direction_colour, draw_and_save, render};

/// `camera` moved to `position` and turned to `target`, then rolled by an angle.
///
/// Its right, up and back are the columns of an orthonormal matrix, which turns the
/// three columns of the camera's own.
pub fn look_at(
    camera: &Camera,
    position: DVec3,
    target: DVec3,
    roll: f64,
) -> Camera {
    let z = (position - target).normalize();
    // Straight up or down, any right will do.
    let x = DVec3::Y.cross(z).normalize_or(DVec3::X);
    let y = z.cross(x);
    let basis = DMat3::from_cols(x, y, z) * DMat3::from_rotation_z(roll);
    Camera { centre: position, matrix: basis * camera.matrix, ..*camera }
}

/// How close `ray` comes to the point `p`, or None if `p` is behind its start.
pub fn passes(ray: &Ray, p: DVec3) -> Option<f64> {
    let v = ray.direction;
    let t = (p - ray.start).dot(v) / v.dot(v);
    (t > 0.0).then(|| ray.at(t).distance(p))
}

/// The beads along the edges of a cube around the origin, nine to an edge.
fn beads() -> Vec<DVec3> {
    let ends = |at: f64| usize::from(at.abs() == 2.0);
    let mut beads = Vec::new();
    let along: Vec<f64> = (-4..=4).map(|k| f64::from(k) / 2.0).collect();
    for &x in &along {
        for &y in &along {
            for &z in &along {
                // On an edge, two of the three coordinates are at an end.
                if ends(x) + ends(y) + ends(z) >= 2 {
                    beads.push(DVec3::new(x, y, z));
                }
            }
        }
    }
    beads
}

/// The colour that `ray` sees: the first bead that it passes through, otherwise the
/// sky of step 1.
fn colour(beads: &[DVec3], ray: &Ray) -> DVec3 {
    let hit = |&&p: &&DVec3| passes(ray, p).is_some_and(|d| d < 0.15);
    match beads.iter().find(hit) {
        Some(&p) => 0.55 + 0.2 * p,
        None => {
            direction_colour(&Ray { direction: ray.direction.normalize(), ..*ray })
        }
    }
}

/// The picture: the cube seen from the upper right, with the head tilted.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let position = DVec3::new(5.8, 4.6, 8.4);
    let camera = look_at(camera, position, DVec3::ZERO, 20_f64.to_radians());
    // The nearest first, so that it hides those behind it.
    let mut beads = beads();
    beads.sort_by(|p, q| p.distance(position).total_cmp(&q.distance(position)));
    render(&camera, samples, |ray| colour(&beads, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
