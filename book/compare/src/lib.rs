//! Two pictures: how they differ, in a sentence and side by side.

mod difference;
mod panels;
mod workspace;

pub use difference::{Difference, apart};
pub use panels::panels;
pub use workspace::{target_folder, workspace};
