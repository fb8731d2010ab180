//! Step 4, stage 3 of the lecture: ambient and diffuse light.

mod normal;

mod surface;

mod light;

mod ambient;
mod diffuse;

mod scene;

mod picture;

pub use ambient::ambient;
pub use diffuse::diffuse;
pub use light::{Attenuation, PointLight};
pub use normal::normal;
pub use picture::{colour, picture};
pub use scene::{AMBIENT_LIGHT, LIGHTS};
pub use step03_nearest::{
    COLOURS, Camera, Hit, Ray, SPHERES, Sphere, direction_colour, nearest, render,
    run,
};
pub use surface::Surface;
