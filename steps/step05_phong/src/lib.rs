//! Step 5, stage 3 of the lecture: specular light and the whole Phong sum.

mod reflect;
mod specular;

mod light;
mod material;
mod phong;

mod scene;

mod picture;

pub use light::Light;
pub use material::Material;
pub use phong::{Phong, phong};
pub use picture::{colour, picture, terms};
pub use reflect::reflect;
pub use scene::{LIGHTS, MATERIALS};
pub use specular::specular;
pub use step04_diffuse::{
    AMBIENT_LIGHT, Attenuation, COLOURS, Camera, Hit, PointLight, Ray, SPHERES,
    Sphere, Surface, ambient, diffuse, direction_colour, nearest, normal, render,
    run,
};
