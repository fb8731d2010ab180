//! A lens: the intersection of two spheres.

use glam::DVec3;
use image::RgbImage;
use step02_sphere::{
    Camera, Ray, Roots, Sphere, direction_colour, draw_and_save, render,
};

/// A piece of a ray: all t from where it enters a solid to where it leaves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The t where it begins.
    pub enter: f64,
    /// The t where it ends, greater than `enter`.
    pub leave: f64,
}

/// The whole ray: all t from 0 on.
pub const RAY: Interval = Interval { enter: 0.0, leave: f64::INFINITY };

impl Interval {
    /// The piece of `ray` inside `sphere`, even if it is behind the start. Returns
    /// None if the ray misses the sphere or only touches it.
    pub fn inside(sphere: &Sphere, ray: &Ray) -> Option<Self> {
        match sphere.intersect(ray) {
            Roots::Two(enter, leave) => Some(Self { enter, leave }),
            Roots::One(_) | Roots::Zero => None,
        }
    }

    /// The part that the two intervals share: from the later beginning to the
    /// earlier end. Returns None if there is none.
    pub fn overlap(self, other: Self) -> Option<Self> {
        let enter = self.enter.max(other.enter);
        let leave = self.leave.min(other.leave);
        (enter < leave).then_some(Self { enter, leave })
    }
}

/// The piece of `ray` that lies inside all `spheres`.
pub fn inside_all(spheres: &[Sphere], ray: &Ray) -> Option<Interval> {
    spheres.iter().try_fold(RAY, |piece, sphere| {
        piece.overlap(Interval::inside(sphere, ray)?)
    })
}

/// The two spheres.
pub const SPHERES: [Sphere; 2] =
    [Sphere::new([-0.75, -0.15, -5.4], 1.5), Sphere::new([0.75, 0.15, -4.6], 1.5)];

/// The colour `behind`, seen through coloured glass that fills the intersection of
/// all `spheres`. The longer the ray's path through the glass, the less of `behind`
/// is left.
fn through(spheres: &[Sphere], glass: DVec3, behind: DVec3, ray: &Ray) -> DVec3 {
    let Some(piece) = inside_all(spheres, ray) else { return behind };
    let length = (piece.leave - piece.enter) * ray.direction.length();
    glass.lerp(behind, 1.0 / (1.0 + 2.0 * length))
}

/// The colour that `ray` sees: spheres of pale glass, and a lens of red glass.
fn colour(spheres: &[Sphere], ray: &Ray) -> DVec3 {
    let mut behind = direction_colour(ray);
    for sphere in spheres {
        behind = through(&[*sphere], 0.5 * behind + 0.5, behind, ray);
    }
    through(spheres, DVec3::new(0.91, 0.20, 0.14), behind, ray)
}

/// The picture: two spheres of glass, and the lens in which they overlap.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    render(camera, samples, |ray| colour(&SPHERES, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
