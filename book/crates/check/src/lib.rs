//! `check` compares a reader's picture with the right one and, if they differ, works out why. In
//! names, comments and answers, *yours* is the reader's picture, and *ours* is the right one.
//!
//! Our picture is either locked or drawn from a scene that is generated from a name. A *target*
//! (`target`) contains our picture. Unless the picture belongs to an exercise, the target also
//! contains the scene, and the step whose functions draw the scene (`step_scene`).
//!
//! The [`Answer`] consists of a verdict, a headline, details and causes. What the answer says about
//! pixels is true of every pixel that the answer mentions. The modules `check` and `explain` look
//! for the following explanations:
//!
//! 1. The picture is **right**.
//! 2. A right program draws the picture **with other options** (`other_options`). Then no code is
//!    blamed.
//! 3. It is a **different picture** of the course.
//! 4. It is our picture, but **turned, cropped or enlarged**, or with two channels swapped. Or it
//!    is **one colour** in all pixels (`transformed`).
//! 5. **Causes**: all changes we know of that reproduce every byte of the picture. A cause is a
//!    listed mistake (`reader_picture`), a single changed number in the scene (`changed_number`),
//!    or a different camera (`camera_fit`). A change that we don't know of may reproduce the
//!    picture, too.
//! 6. If nothing else explains the picture, **facts** about the wrong pixels (`facts`). The facts
//!    say whether wrong pixels look as if the program never drew them (`undrawn`), what the bytes
//!    of the wrong pixels have in common (`byte_facts`), and which objects the pixels belong to
//!    (`regions`).
//!
//! An answer about a wrong picture of the right size also shows one wrong pixel (`wrong_pixel`).
//! Unless the picture belongs to an exercise, the answer also names the `by_hand` tests to run, and
//! says what our program computes at this pixel.
//!
//! `check` also reports on a whole class, given a folder that contains one folder per student
//! (`class`). For a list of names, `check` writes one sheet per name, with the numbers of the scene
//! that is generated from this name (`class::scene_sheet`).
//!
//! A `Budget` limits how many explanations are tried. The budget counts rays and pixels instead of
//! seconds, so that the answer is the same on every machine. There is also a limit on how many
//! bytes are read from a file.

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
    ClassReport, FolderError, NamesError, OwnPicturesReport, SheetError, WriteFolderError,
    compose_characters, format_sheet, read_names, report_on_class, report_on_own_pictures,
    write_sheets,
};
pub use png_file::PngError;
pub use read_file::{ReadFileError, escape_for_terminal, read_bounded_file};
pub use threads::run_on_threads;
