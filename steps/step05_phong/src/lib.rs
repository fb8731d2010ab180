//! Step 5, stage 3 of the lecture "Ray Casting": specular light and the Phong sum.

pub use step04_diffuse::{
    AMBIENT, Attenuation, COOL, Camera, Hit, Matte, OBJECTS, Object, PointLight,
    Ray, Scene, Sphere, SurfacePoint, WARM, ambient, diffuse, direction_colour,
    draw_pixels, mean, nearest, normal, render, rgb8, run, sub_pixels,
    visible_point,
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
