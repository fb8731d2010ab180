//! Two pictures: how they differ, in a sentence and side by side.

mod difference;
mod panels;
mod workspace;

pub use difference::{Difference, largest_channel_difference};
pub use panels::draw_panels;
pub use workspace::{target_folder, workspace};
