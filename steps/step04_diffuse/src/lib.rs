//! Step 4, stage 3 of the lecture "Ray Casting": ambient and diffuse light.
//!
//! A ray sees a [`SurfacePoint`]. Its colour is the [`ambient`] light that it
//! reflects, and the [`diffuse`] light of each [`PointLight`] in the [`Scene`].

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
