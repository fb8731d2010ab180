//! Step 3, stage 2 of the lecture "Ray Casting": the nearest of several objects.
//!
//! An [`Object`] is a sphere with a name and a material of any kind, and [`nearest`]
//! finds the [`Hit`] with the smallest t.

pub use step02_sphere::{
    Camera, Ray, Sphere, direction_colour, draw_pixels, mean, render, rgb8, run,
    sub_pixels,
};

mod object;
mod objects;
pub use object::Object;
pub use objects::OBJECTS;

mod nearest;
mod picture;
pub use nearest::{Hit, nearest};
pub use picture::{colour, picture};
