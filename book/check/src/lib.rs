//! `check`: what a picture tells of the program that drew it.
//!
//! A picture is compared with the locked one of its name. What is said of it is an
//! *explanation* (`explanation`): a sentence, files to go back to, and a function from pixels
//! to colours. It is told if it gives the reader's colour in every pixel, or, where a number
//! in it was fitted, within one of 255. One loop, `find_first_that_holds`, tries them; the
//! strongest come first:
//!
//! 1. It is **right**, or the locked picture of another name (`check`).
//! 2. It is right **with other options** (`other_options`), **cut out or scaled**
//!    (`crop_or_scale`), or one colour.
//! 3. It is ours **as a whole**, but turned or with its bytes in other places (`transformed`),
//!    or with another curve of the bytes (`byte_curve`).
//! 4. It is **in the list** (`listed_mistake`): these very pixels are what a mistake that we
//!    know gives. The lists are the text files in `mistakes/`; the package `update` draws
//!    them, and the hashes of what they give are in a table (`fingerprints`).
//! 5. Something **is missing**, pixels, objects or terms of the light, or counted otherwise
//!    (`missing_parts`); **one number** of the scene is another (`scene_parameter`); the
//!    **camera or the sky's colour** is another, as read from the sky (`camera_from_sky`); it
//!    was **disturbed**: last digits, random places in the pixel, loss (`disturbed`).
//! 6. Two mistakes, one of them in `rgb8`: the curve is asked of the sky alone, and 5 again.
//!
//! Where nothing explains the whole, the wrong pixels are counted by regions of our own scene
//! (`pixel_regions`), what explains one region alone is told of that region, and no file is
//! blamed: the tests by hand of the stages that may be wrong are named (`wrong_regions`). In
//! the end there is one pixel, yours and ours.
//!
//! What is compared is the `evidence`: both pictures pixel by pixel. It is bounded: a file is
//! read row by row (`png_file`), of what is larger than 1920×1080 only 64 rows are kept, and
//! explanations are asked in as many pixels as a locked picture has. Each ray that is drawn
//! is taken from a `RayBudget`, so that every answer comes soon, and is the same on every machine.

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
pub use check::{check_picture, check_png};
pub use file::{escape_for_terminal, read_bounded_file};
pub use fingerprints::{
    TableRow, find_mistakes_with_hash, hash_picture, locked_hashes, table_rows,
};
pub use folder_report::report_on_folder_or_class;
pub use locked::{Locked, locked_names};
pub use mistake::{BookEntry, Mistake, mistakes};
pub use png_file::{Picture, read_png};
pub use source_ref::{SourceRef, source_refs};
pub use step::{Step, default_camera};
pub use which_picture::{find_name_in_file_name, step_of_exercise};
