//! The project's folders, a command that runs Cargo there, the environment variables that control
//! the tests, and files that are replaced atomically.

mod folders;
mod replace_file;
pub use folders::{WASM_MODULES, cargo_command, target_folder, workspace};
pub use replace_file::replace_file;

pub mod environment;
