//! `check`: what a picture tells of the program that drew it.
//!
//! A picture is compared with the locked one of its name, or with the scene that belongs to a
//! name: a *target*, and, but for exercises, the *drawing* of it, a scene and the functions of a
//! step. An answer says only what holds in every pixel that it speaks of (`check`):
//!
//! 1. The picture is **right**, or right **with other options** (`other_options`), for which no
//!    code is blamed, or the picture of another name.
//! 2. It is ours as a whole, **turned, cut out or enlarged** (`transformed`).
//! 3. **Causes**, all that we know to give every byte, as others may: a listed mistake
//!    (`listed_mistake`), one other number of the scene (`changed_number`), another camera
//!    (`camera_fit`).
//! 4. Else **facts** (`facts`): pixels that nothing draws (`undrawn`), sentences that are true of
//!    each wrong pixel (`byte_facts`), or of a number of them; and the objects that are right and
//!    wrong (`regions`).
//!
//! In the end there are the tests by hand of all steps that draw it, and one pixel
//! (`wrong_pixel`).
//!
//! In the folder of a class, each folder is a student's (`class`), and each name has a sheet with
//! the numbers of its scene (`class::scene_sheet`). What is tried is bounded by a `Budget`, the same on
//! every machine, and what is read of a file by a number of bytes.

mod answer;
mod byte_facts;
mod camera_fit;
mod changed_number;
mod check;
mod class;
mod comparison;
mod drawing;
mod explain;
mod facts;
mod listed_mistake;
mod other_options;
mod png_file;
mod read_file;
mod regions;
mod target;
mod threads;
mod transformed;
mod undrawn;
mod wrong_pixel;

pub use answer::{Answer, Cause, Verdict};
pub use check::{check_png, check_scene_png};
pub use class::{
    ClassReport, OwnReport, format_sheet, normalize_name, read_names, report_on_class,
    report_on_own_pictures, write_sheets,
};
use png_file::{Picture, read_png};
pub use read_file::{escape_for_terminal, read_bounded_file};
use target::find_name_in_file_name;
pub use threads::run_on_threads;
