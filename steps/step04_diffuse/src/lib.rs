//! Step 4, stage 3 of the lecture: ambient and diffuse light.

pub use step03_nearest::{
    Camera, Hit, Object, Ray, Sphere, direction_colour, nearest, objects, render,
    run,
};

mod point;
pub use point::{Point, normal, seen};

mod ambient;
mod surface;
pub use ambient::ambient;
pub use surface::Surface;

mod diffuse;
mod light;
pub use diffuse::diffuse;
pub use light::{Attenuation, PointLight};

mod picture;
mod scene;
pub use picture::{colour, picture};
pub use scene::{COOL, Scene, WARM, scene};
