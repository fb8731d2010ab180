//! `check`: what a picture tells of the program that drew it.
//!
//! A picture is compared with the locked one of its name, and the first of these is told:
//!
//! 1. It is **right**, or right **with other options** (`other_options`), or the locked
//!    picture of another name, or one colour (`check`).
//! 2. It is ours as a whole, **turned, cut out or scaled** (`transformed`).
//! 3. It is **in the list** (`listed_mistake`): these very pixels are what a mistake that we
//!    know gives. The lists are the text files in `mistakes/`; the package `update` draws
//!    them, and the hashes of what they give are in a table (`fingerprints`). What 1 and 2
//!    say, or 4 of other bytes, is told along with it.
//! 4. An *explanation* holds (`explanation`): a sentence, files to go back to, and a function
//!    from pixels to colours. It is told if it gives the reader's colour in every pixel, or,
//!    where a number in it was fitted, within one of 255. One loop, `find_first_that_holds`,
//!    tries them: other bytes (`byte_encodings`); an object or a term of the light that **is
//!    missing** (`missing_parts`); **one number** of the scene (`scene_parameter`); the
//!    **camera or the colour that the sky tells** (`sky`); what was **disturbed**: last
//!    digits, shifted rays, loss (`disturbed`).
//! 5. Else the wrong pixels are **counted** by regions of our own scene (`pixel_regions`), and
//!    no file is blamed (`wrong_regions`).
//!
//! In the end there is one pixel, yours and ours.
//!
//! Explanations are asked of pictures of our size alone (`evidence`); of another size, those
//! of 1 and 2 are told. Each ray that they draw is taken from a `RayBudget`, so that every
//! answer comes soon, and is the same on every machine; of a file, no more is read than a
//! picture has (`read_file`, `png_file`).

mod byte_encodings;
mod check;
mod disturbed;
mod evidence;
mod explanation;
mod file_format;
mod folder_report;
mod listed_mistake;
mod locked;
mod missing_parts;
mod named_scene;
mod other_options;
mod pixel_regions;
mod png_file;
mod read_file;
mod scene_parameter;
mod sky;
mod source_ref;
mod step_scene;
mod transformed;
mod which_picture;
mod wrong_regions;

pub use check::{Answer, check_picture, check_png};
pub use folder_report::report_on_folder_or_class;
pub use locked::Locked;
pub use named_scene::check_named_scene;
pub use png_file::{Picture, read_png};
pub use read_file::{escape_for_terminal, read_bounded_file};
pub use source_ref::{SourceRef, source_refs};
pub use which_picture::find_name_in_file_name;
