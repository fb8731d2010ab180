//! `check`: what a picture tells of the program that drew it.
//!
//! A picture is compared with the locked one of its name, and [`look`] says the first of
//! these that is true:
//!
//! 1. It is **right** in every pixel, or the picture of another name.
//! 2. It is right **with other options**: our own step draws it at that size, with the
//!    field of view that its sky tells, and so many rays a pixel (`options`).
//! 3. Ours **as a whole**, but turned, with its channels swapped, in grey, along a curve
//!    such as gamma (`whole`), cut out or scaled (`part`).
//! 4. It is **in the list**: these very pixels are what a mistake that we know gives
//!    (`listed`). The lists are the text files in `mistakes/`: a title, a file, what
//!    stands there and what is written instead. The package `update` draws them all,
//!    and the table has the sum of each picture.
//! 5. **One number** of the scene is another: all numbers that somebody may have typed are
//!    tried with the functions of the steps, as a scene is a value (`number`).
//! 6. Else **where to look** (`stages`): the rays, read out of the sky (`sky`), the
//!    outlines, which object is in front, where no light reaches, each light, the
//!    highlights. Our own program says what is in each pixel (`seen`). The first of these
//!    that is wrong is told, with its files and tests by hand (`place`).
//!
//! In the end there is one pixel, yours and ours, and how many differ. 3 to 5 hold in
//! every pixel, or nothing of them is said.

mod answer;
mod byte_curve;
mod camera_from_sky;
mod check;
mod crop_or_scale;
mod disturbed;
mod evidence;
mod explanation;
mod file;
mod file_format;
mod fingerprints;
mod folder_report;
mod listed_mistake;
mod locked;
mod missing_parts;
mod mistake;
mod other_options;
mod pixel_regions;
mod png_file;
mod scene_parameter;
mod source_ref;
mod step;
mod step_scene;
mod transformed;
mod which_picture;
mod wrong_regions;

pub use answer::Answer;
pub use check::{check, look};
pub use file::{printable, read_file};
pub use fingerprints::{Row, known, locked_sums, rows, sum};
pub use folder_report::folder_report;
pub use locked::{Locked, names};
pub use mistake::{Mistake, Shown, mistakes};
pub use png_file::{Picture, read};
pub use source_ref::{Place, places};
pub use step::{Step, camera};
pub use which_picture::{by_file, step_of_exercise};
