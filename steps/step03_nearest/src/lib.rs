//! Step 3, stage 2 of the lecture "Ray Casting": the nearest of several objects.
//!
//! An [`Object`] is a sphere with a name and a material. Of all the objects that a
//! ray meets, [`nearest`] finds the first, as a [`Hit`].

pub use step02_sphere::{
    Camera, Ray, Sphere, direction_colour, draw_and_save, draw_pixels, mean_colour,
    render, rgb8, sub_pixel_offsets,
};

mod object;
mod objects;
pub use object::Object;
pub use objects::OBJECTS;

mod nearest;
mod picture;
pub use nearest::{Hit, nearest};
pub use picture::{colour, picture};
