//! The gallery of mistakes: what readers draw when one thing is wrong, and `check`,
//! which knows each mistake by its picture.

mod step;

mod parts;
mod scene;
mod section;

mod mistake;
mod mistakes;

mod difference;
mod label;
mod locked;
mod panels;
mod png;
mod view;
mod workspace;

mod drawn;

mod cause;
mod fov;
mod recognise;
mod rest;
mod sight;

mod kind;
mod measure;

mod answer;
mod case;
mod check;
mod options;
mod table;
mod told;
mod turned;
mod verdict;
mod whose;

mod appendix;

pub use answer::Answer;
pub use appendix::appendix;
pub(crate) use cause::Cause;
pub use check::{check, look};
pub use difference::Difference;
pub use drawn::draw;
pub use locked::{Locked, locked, names};
pub use measure::{Stage, Verdict, pixel, stages};
pub use mistake::Mistake;
pub use mistakes::mistakes;
pub use parts::{Nearest, Parts};
pub(crate) use recognise::{Found, recognise};
pub(crate) use rest::Rest;
pub use scene::Named;
pub use section::Section;
pub use step::{Step, camera};
pub use table::table;
pub use workspace::workspace;
