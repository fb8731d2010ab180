//! Code and data shared by the book's crates.
//!
//! - The five *steps*, the *camera* that takes their pictures, their *examples* as a library, and a
//!   list of every picture that a step or an example draws.
//! - The *mistakes* that readers make, each as a diff; a *table* with the hashes of the wrong
//!   pictures that they produce; and the small versions of these pictures that the book shows.
//! - The *places* in the listings that a reader may edit.
//! - *Scenes*: one that is generated from a person's *name*, one that a reader puts together on a
//!   page, and the table of the numbers in a scene.
//! - The *locked* pictures, the *difference* between two pictures, in a sentence or side by side,
//!   and a PNG encoder.
//! - A function that rewrites the source of a crate as the source of a Rust *module*.
//! - A function that *replaces* a file atomically.
//! - The folders of the *workspace*, the names of the pages' WebAssembly modules, a command that
//!   runs Cargo, the *environment* variables that control the tests, a hash function, and a JSON
//!   writer.

mod camera;
mod step;
pub use camera::{
    FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS, camera, camera_with_fov, camera_with_size,
    primary_rays,
};
pub use step::Step;

pub mod examples;
pub use examples::{DrawPicture, PICTURES, find_picture};

mod mistake;
mod mistake_files;
mod mistake_table;
pub use mistake::{
    Mistake, MistakeListError, MistakePicture, ShownMistake, mistakes, parse_mistake_lists,
};
pub use mistake_files::{MistakeTexts, mistake_texts, provide_mistake_texts};
pub use mistake_table::{
    MistakeTable, RightPicture, SMALL_SIZE, TableError, TableRow, find_mistakes_with_hash,
    hash_picture, hashes_of_right_pictures, make_small_picture, mistake_table, mistakes_with_rows,
    names_of_right_pictures, read_small_pictures, small_pictures_path,
};

mod place;
pub use place::{OccurrenceError, Place, PlaceNote, ValueType, all_listed_places};

mod crate_as_module;
pub use crate_as_module::crate_as_module;

mod hash;
pub use hash::fnv_1a;

mod named_scene;
mod own_scene;
mod scene_quantity;
mod ungated_colour;
pub use named_scene::named_scene;
pub use own_scene::OwnScene;
pub use scene_quantity::{Component, GROUND, Owner, QUANTITIES, Quantity, Scalar, Typed};
pub use ungated_colour::ungated_colour;

mod difference;
mod encode_png;
mod locked_picture;
mod panels;
pub use difference::{describe_difference, largest_channel_difference};
pub use encode_png::encode_png;
pub use locked_picture::{LockedPictureError, locked_picture_path, read_locked_picture};
pub use panels::draw_panels;

mod replace_file;
pub use replace_file::replace_file;

mod terminal;
pub use terminal::is_obeyed_by_terminals;

mod workspace;
pub use workspace::{MODULES, cargo_command, step_dependencies, target_folder, workspace};

pub mod environment;
pub mod json;
