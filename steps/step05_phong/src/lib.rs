//! Step 5, stage 3 of the lecture "Ray Casting": specular light and the Phong sum.

pub use step04_diffuse::{
    AMBIENT, Attenuation, COOL, Camera, Hit, OBJECTS, Object, PointLight, Ray,
    Scene, Sphere, Surface, SurfacePoint, WARM, ambient, diffuse, direction_colour,
    nearest, normal, render, run, visible_point,
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
