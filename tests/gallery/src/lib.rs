//! The gallery of mistakes: what readers draw when one thing is wrong, and `check`,
//! which knows each mistake by its picture.

mod step;

mod parts;
mod scene;
mod section;

mod mistake;
mod mistakes;

mod difference;
mod locked;
mod png;
mod workspace;

mod drawn;

mod cause;
mod recognise;
mod sight;

mod measure;

mod check;

mod appendix;

pub use appendix::appendix;
pub(crate) use cause::Cause;
pub use check::{Answer, check, look};
pub use difference::Difference;
pub use drawn::draw;
pub use locked::{locked, names};
pub use measure::{Stage, Verdict, pixel, stages};
pub use mistake::Mistake;
pub use mistakes::mistakes;
pub use parts::{Nearest, Parts};
pub(crate) use recognise::{Found, recognise};
pub use scene::Named;
pub use section::Section;
pub use step::{Step, camera};
pub use workspace::workspace;
