//! `check`: what a picture tells of the program that drew it.

mod answer;
mod check;
mod classes;
mod light;
mod listed;
mod locked;
mod mistake;
mod number;
mod options;
mod part;
mod place;
mod png;
mod quantity;
mod scenes;
mod sky;
mod stages;
mod step;
mod table;
mod whole;
mod whose;

pub use answer::Answer;
pub use check::{check, look};
pub use locked::{Locked, names};
pub use mistake::{Mistake, Shown, mistakes};
pub use place::{Place, places};
pub use png::read;
pub use step::{Step, camera};
pub use table::{Row, key, known, read as read_table, rows, sum};
pub use whose::by_file;
