//! Step 4, stage 3 of the lecture "Ray Casting": ambient and diffuse light.
//!
//! What a ray sees is the [`SurfacePoint`] of its nearest hit, in the light of a
//! [`Scene`]: R_a L_a, and R_d / (a + bd + cd²) · max(n·l, 0) · L_d for each light.

pub use step03_nearest::{
    Camera, Hit, OBJECTS, Object, Ray, Sphere, direction_colour, draw_and_save,
    draw_pixels, mean_colour, nearest, render, rgb8, sub_pixel_offsets,
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
pub use scene::{AMBIENT_LIGHT, COOL_LIGHT, Scene, WARM_LIGHT, scene};

mod diffuse;
mod picture;
pub use diffuse::{diffuse, diffuse_at};
pub use picture::{colour, picture};
