//! `check`: compares a reader's picture with the right one and, if they differ, works out why. In
//! names, comments and answers, *yours* is the reader's picture, and *ours* is the right one.
//!
//! Ours is a locked picture, or the picture of the scene that is generated from a name. It is part
//! of a *target* (`target`), which also contains the scene and the step whose functions draw it
//! (`step_scene`), unless it is the picture of an exercise. The [`Answer`] consists of a verdict, a
//! headline, details and causes. It never claims more than is true of every pixel that it mentions.
//! The modules `check` and `explain` try these explanations in turn:
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
//! An answer about a wrong picture of the right size ends with two hints: which steps' `by_hand`
//! tests to run, and one wrong pixel, with what our program computes there (`wrong_pixel`).
//!
//! `check` also reports on a whole class, from a folder that contains a folder for each student
//! (`class`). And for each name in a list, it writes a sheet with the numbers of the scene that is
//! generated from this name (`class::scene_sheet`).
//!
//! A `Budget` limits how many of these explanations are tried. It counts rays and pixels instead of
//! seconds, so the answer is the same on every machine. There is also a limit on how many bytes are
//! read from a file.

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

pub use answer::{Answer, Cause, ComparedPictures, FAILURE_EXIT_CODE, Verdict};
pub use check::{CheckError, check_png, check_scene_png};
pub use class::{
    ClassReport, FolderError, NamesError, OwnReport, SheetError, WriteFolderError, format_sheet,
    normalize_name, read_names, report_on_class, report_on_own_pictures, write_sheets,
};
pub use png_file::PngError;
pub use read_file::{ReadFileError, escape_for_terminal, read_bounded_file};
pub use threads::run_on_threads;
