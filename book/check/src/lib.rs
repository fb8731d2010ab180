//! `check`: what a picture tells of the program that drew it.

mod answer;
mod check;
mod locked;
mod mistake;
mod png;
mod step;
mod whose;

pub use answer::Answer;
pub use check::{check, look};
pub use locked::{Locked, names};
pub use mistake::{Mistake, Shown, mistakes};
pub use png::read;
pub use step::{Step, camera};
pub use whose::by_file;
