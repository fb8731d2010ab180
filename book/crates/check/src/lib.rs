//! `check`: what a picture says about the program that drew it.
//!
//! A picture is compared with a *target* (`target`): the locked picture of its name, or the scene
//! that belongs to a name. Except for exercises, the target has a scene and the functions of the
//! step that draws it (`step_scene`). The [`Answer`] has a verdict, a headline, details and causes.
//! It says only what holds in every pixel that it speaks of. This is how it is found (`check`,
//! `explain`):
//!
//! 1. The picture is **right**, or it is right **with other options** (`other_options`), for which
//!    no code is blamed, or it is the picture of a different name.
//! 2. It is ours as a whole, **turned, cut out or enlarged** (`transformed`).
//! 3. **Causes**: everything we know of that gives every byte of it. That is a listed mistake
//!    (`reader_picture`), one different number of the scene (`changed_number`), or a different
//!    camera (`camera_fit`). Something that we don't know may give it, too.
//! 4. If none of these explains it, **facts** (`facts`): pixels that were never drawn
//!    (`undrawn`), sentences that are true of each wrong pixel (`byte_facts`) or of some of them,
//!    and which objects are right and wrong (`regions`).
//!
//! At the end come the tests by hand of all steps that draw the picture, and one pixel in full
//! (`wrong_pixel`).
//!
//! In the folder of a class, each folder is a student's (`class`), and each name has a sheet with
//! the numbers of its scene (`class::scene_sheet`).
//!
//! A `Budget` limits what is tried, by the same count on every machine, and a number of bytes
//! limits what is read of a file.

mod answer;
mod byte_facts;
mod camera_fit;
mod changed_number;
mod check;
mod class;
mod comparison;

mod explain;
mod facts;
mod number_format;
mod other_options;
mod png_file;
mod read_file;
mod reader_picture;
mod regions;
mod step_scene;
mod target;
mod threads;
mod transformed;
mod undrawn;
mod wrong_pixel;

pub use answer::{Answer, Cause, ComparedPictures, Verdict};
pub use check::{CheckError, check_png, check_scene_png};
pub use class::{
    ClassReport, FolderError, NamesError, OwnReport, SheetError, WriteFolderError, format_sheet,
    normalize_name, read_names, report_on_class, report_on_own_pictures, write_sheets,
};
pub use png_file::PngError;
pub use read_file::{ReadFileError, escape_for_terminal, read_bounded_file};
pub use threads::run_on_threads;
