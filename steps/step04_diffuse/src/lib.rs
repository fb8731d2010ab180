//! Step 4, stage 3 of the lecture "Ray Casting": ambient and diffuse light.
//!
//! What a ray sees is the [`SurfacePoint`] of its nearest hit, in the light of a
//! [`Scene`]: R_a L_a, and R_d / (a + bd + cd²) · max(n·l, 0) · L_d of each light.

pub use step03_nearest::{
    Camera, Hit, OBJECTS, Object, Ray, Sphere, direction_colour, draw_pixels, mean,
    nearest, render, rgb8, run, sub_pixels,
};

mod surface_point;
pub use surface_point::{SurfacePoint, normal, visible_point};

mod ambient;
mod matte;
pub use ambient::ambient;
pub use matte::Matte;

mod light;
mod scene;
pub use light::{Attenuation, PointLight};
pub use scene::{AMBIENT, COOL, Scene, WARM, scene};

mod diffuse;
mod picture;
pub use diffuse::diffuse;
pub use picture::{colour, picture};
