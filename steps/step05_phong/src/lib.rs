//! Step 5, stage 3 of the lecture: specular light and the whole Phong sum.

pub use step04_diffuse::{
    Attenuation, COOL, Camera, Hit, Object, Point, PointLight, Ray, Scene, Sphere,
    Surface, WARM, ambient, diffuse, direction_colour, nearest, normal, objects,
    render, run, seen,
};

mod reflect;
pub use reflect::reflect;

mod light;
mod material;
mod specular;
pub use light::Light;
pub use material::Material;
pub use specular::specular;

mod phong;
pub use phong::{Phong, phong};

mod picture;
mod scene;
pub use picture::{colour, picture, terms};
pub use scene::scene;
