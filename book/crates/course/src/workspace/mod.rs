//! Finds the project's folders, prepares commands that run Cargo, reads the environment variables
//! that control the tests, and replaces files atomically.

mod folders;
mod replace_file;
pub use folders::{WASM_MODULES, cargo_command, target_folder, workspace};
pub use replace_file::replace_file;

pub mod environment;
