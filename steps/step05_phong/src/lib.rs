//! Step 5, stage 3 of the lecture "Ray Casting": specular light and the Phong sum.
//!
//! What the five crates offer, step by step:
//!
//! 1. A [`Camera`] gives the [`Ray`] of each pixel. [`render`] draws a function from rays
//!    to colours; its parts are [`draw_pixels`], [`sub_pixel_offsets`], [`mean_colour`]
//!    and [`rgb8`]. [`direction_colour`] is the sky. [`draw_and_save`] is the program
//!    around a picture.
//! 2. A [`Sphere`] finds where a ray meets it.
//! 3. [`nearest`] finds the first [`Hit`] among many objects. An [`Object`] is a sphere
//!    with a material, and [`OBJECTS`] are the nine of the book.
//! 4. [`visible_point`] finds the [`SurfacePoint`] that a ray sees. A [`Scene`] has
//!    objects and lights. [`ambient`] and [`diffuse`] are the light on a [`Matte`]
//!    material, from everywhere and from a [`PointLight`].
//! 5. [`reflect`] and [`specular`] are the highlight of a [`Light`] on a [`Material`].
//!    [`light_terms`] has all that one light brings to a point, and [`phong`] the sum
//!    over all lights, in [`Terms`]. [`colour`] is what a ray sees of a scene, and
//!    [`scene`] the scene of the book.

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
