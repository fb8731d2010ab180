//! Step 5, stage 3 of the lecture "Ray Casting": specular light and the Phong sum.
//! Here is all that the five crates offer, step by step:
//!
//! 1. [`Camera`] and [`Ray`]; [`render`] draws a function from rays to colours, and
//!    [`draw_pixels`], [`sub_pixel_offsets`], [`mean_colour`] and [`rgb8`] are its
//!    parts; [`direction_colour`] is the sky, and [`draw_and_save`] the program.
//! 2. [`Sphere`], and where a ray meets it.
//! 3. [`Object`], [`nearest`] and its [`Hit`]; [`OBJECTS`] are the nine of the book.
//! 4. [`SurfacePoint`], found by [`visible_point`]; [`Matte`] and [`PointLight`];
//!    [`ambient`] and [`diffuse`]; a [`Scene`] of any materials and lights.
//! 5. [`Material`] and [`Light`]; [`reflect`] and [`specular`]; [`light_terms`] of one
//!    light, and [`phong`], the sum; [`colour`] is what a ray sees of a scene, such as
//!    the book's [`scene`].

pub use step04_diffuse::{
    AMBIENT_LIGHT, Attenuation, COOL_LIGHT, Camera, Hit, Matte, OBJECTS, Object,
    PointLight, Ray, Scene, Sphere, SurfacePoint, WARM_LIGHT, ambient, diffuse,
    direction_colour, draw_and_save, draw_pixels, mean_colour, nearest, normal,
    render, rgb8, sub_pixel_offsets, visible_point,
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
pub use phong::{Terms, light_terms, phong};

mod picture;
mod scene;
pub use picture::{colour, picture, terms};
pub use scene::scene;
