//! `check`: what a picture tells of the program that drew it.

mod locked;
mod png;
mod view;

mod cause;
mod each;
mod fov;
mod recognise;
mod rest;
mod sight;
mod sort;

mod formula;
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
pub(crate) use each::{at_once, each};
pub use formula::by_formulas;
pub use locked::{Locked, locked, names};
pub use measure::{Stage, Verdict, stages};
pub(crate) use options::Options;
pub use png::picture;
pub(crate) use recognise::{Found, recognise};
pub(crate) use rest::Rest;
pub(crate) use sort::{key, sort};
pub use table::table;
pub use whose::by_file;

use gallery::{
    Mistake, Named, Parts, Section, Step, apart, camera, mistakes, panels, section,
    workspace,
};
