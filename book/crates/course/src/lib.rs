//! Code and data shared by the book's crates, in six folders and four files:
//!
//! - `steps`: the five steps as an enum, the camera that takes their pictures, the discriminant of
//!   a sphere and a ray, and the steps' examples as a library. This folder also lists every picture
//!   that a step or an example draws.
//! - `source_code`: the steps' source code as text. A *place* is an expression in this code that a
//!   reader may edit on a page.
//! - `mistakes`: the mistakes that readers make, each as a diff; a table with the hashes of the
//!   wrong pictures that these mistakes produce; and small versions of some wrong pictures, for the
//!   book.
//! - `scenes`: the scene that is generated from a person's name, the scene that a reader puts
//!   together on a page, a table of the numbers in a scene, and the names of the lights.
//! - `pictures`: reads the locked pictures, hashes a picture, describes or draws the difference
//!   between two pictures, and encodes PNG files.
//! - `workspace`: finds the project's folders, lists the pages' WebAssembly modules, prepares
//!   commands that run Cargo, reads the environment variables that control the tests, and replaces
//!   files atomically.
//! - `hash.rs`, `html.rs`, `json.rs` and `terminal.rs`: a hash function, an HTML escaper, a JSON
//!   writer, and a predicate for characters that a terminal would act on.
//!
//! All items are re-exported here, so other crates don't see the folders.

mod steps;
pub use steps::{
    DrawPicture, FOV_DEGREES, PICTURE_COLUMNS, PICTURE_ROWS, PICTURES, Step, camera,
    camera_with_fov, camera_with_size, colour_without_highlight_gate, discriminant, examples,
    find_draw_function, primary_rays,
};

mod source_code;
pub use source_code::{
    OccurrenceError, Place, PlaceNote, ValueType, all_listed_places, crate_as_module,
    dependencies_of_step_copies,
};

mod mistakes;
pub use mistakes::{
    Mistake, MistakeFiles, MistakeListError, MistakePicture, MistakePresentation, MistakeTable,
    RightPicture, SMALL_SIZE, TableError, TableRow, find_mistakes_with_hash,
    hashes_of_right_pictures, make_small_picture, mistake_files, mistake_table, mistakes,
    mistakes_and_their_rows, names_of_right_pictures, parse_mistake_lists, provide_mistake_files,
    read_small_mistake_pictures, small_pictures_file_path,
};

mod scenes;
pub use scenes::{
    Component, GROUND, LIGHT_NAMES, LightName, OwnScene, Owner, QUANTITIES, Quantity, Scalar,
    TypedRange, generate_scene,
};

mod pictures;
pub use pictures::{
    LockedPictureError, describe_difference, draw_with_difference, encode_png, hash_picture,
    largest_channel_difference, locked_picture_path, read_locked_picture,
};

mod workspace;
pub use workspace::{
    WASM_MODULES, cargo_command, environment, replace_file, target_folder, workspace,
};

mod hash;
mod html;
pub mod json;
mod terminal;
pub use hash::fnv_1a;
pub use html::escape_html;
pub use terminal::is_terminal_control;
