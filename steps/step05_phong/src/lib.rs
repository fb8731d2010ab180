//! Step 5, stage 3 of the lecture "Ray Casting": specular light and the Phong sum.
//!
//! What the five crates offer, step by step:
//!
//! 1. A [`Camera`] gives the [`Ray`] of each pixel. [`render`] draws a function from
//!    rays to colours; its parts are [`draw_pixels`], [`sub_pixel_offsets`],
//!    [`mean_colour`] and [`rgb8`]. [`direction_colour`] is the sky.
//!    [`draw_and_save`] is the program around a picture.
//! 2. A [`Sphere`] finds where a ray meets it.
//! 3. [`nearest`] finds the first [`Hit`] among many objects. An [`Object`] is a
//!    sphere with a material, and [`OBJECTS`] are the nine of the course.
//! 4. [`visible_point`] finds the [`SurfacePoint`] that a ray sees. A [`Scene`] has
//!    objects and lights. On a [`Matte`] material, [`ambient`] is the light from
//!    everywhere, and [`diffuse`] the light from one [`PointLight`].
//! 5. On a shiny [`Material`], [`specular`] is the highlight of one [`Light`].
//!    [`reflect`] mirrors the direction to the light, as [`specular`] needs it.
//!    [`light_terms`] computes what one light contributes at a point, and [`phong`]
//!    adds up all the lights; both return [`Terms`]. [`colour`] is the colour that a
//!    ray sees, and [`scene`] the scene of the course.

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
