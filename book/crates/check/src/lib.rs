//! `check`: compares a reader's picture with the right one and, if they differ, works out why.
//!
//! The right one is the *target* (`target`): a locked picture, or the picture of the scene that is
//! generated from a name. Unless it is an exercise, a target also has a scene and the step whose
//! functions draw it (`step_scene`). The [`Answer`] consists of a verdict, a headline, details and
//! causes. It never claims more than is true of every pixel that it mentions. `check` and `explain`
//! try these explanations in turn:
//!
//! 1. The picture is **right**; or a right program draws it **with other options**
//!    (`other_options`), in which case no code is blamed; or it is the right picture of a different
//!    name.
//! 2. It is our whole picture, **turned, cropped or enlarged** (`transformed`).
//! 3. **Causes**: all changes we know of that reproduce every byte of the picture. Each is a listed
//!    mistake (`reader_picture`), one different number in the scene (`changed_number`), or a
//!    different camera (`camera_fit`). A change that we don't know of may reproduce it, too.
//! 4. Failing all of these, **facts** (`facts`): pixels that were never drawn (`undrawn`),
//!    sentences that are true of every wrong pixel (`byte_facts`) or of some of them, and which
//!    objects are right and which are wrong (`regions`).
//!
//! The answer ends with the `by_hand` tests of all steps that draw the picture, and with one wrong
//! pixel in full (`wrong_pixel`).
//!
//! For a class, each folder inside the given one is a student's (`class`), and each name can have a
//! sheet with the numbers of its scene (`class::scene_sheet`).
//!
//! A `Budget` limits how much is tried. It counts work instead of time, so the answer is the same
//! on every machine. There is also a limit on how many bytes are read from a file.

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
