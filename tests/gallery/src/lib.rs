//! The gallery of mistakes: what readers draw when one thing is wrong.

mod step;

mod parts;
mod scene;
pub mod section;

mod mistake;
mod mistakes;

mod difference;
mod label;
mod panels;
mod workspace;

mod drawn;

pub use difference::{Difference, apart};
pub use drawn::draw;
pub use mistake::Mistake;
pub use mistakes::{COUNT, by_step, mistakes};
pub use panels::panels;
pub use parts::{Nearest, Parts};
pub use scene::{Named, scene};
pub use section::Section;
pub use step::{Step, camera};
pub use workspace::workspace;
