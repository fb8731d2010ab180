//! The lecture's formulas as data, and what becomes of a picture where one is changed.

mod context;
mod dark;
mod drawn;
mod edits;
mod eval;
mod explain;
mod halves;
mod node;
mod numbers;
mod parse;
mod print;
mod search;
mod tree;
mod value;

pub(crate) use context::{Change, Context};
pub use drawn::by_formulas;
pub(crate) use edits::{Edit, edits};
pub(crate) use eval::{Changed, Values, batch};
pub(crate) use explain::{Cause, Riddle};
pub(crate) use node::{Kind, Node, Op};
pub(crate) use numbers::{Where, solved, unknowns};
use parse::parse;
pub(crate) use print::shown;
pub(crate) use search::{
    Evidence, Known, Part, Pixel, is_smooth, kept, misses, spread,
};
pub(crate) use tree::{Line, Of, Place, Tree};
pub(crate) use value::Value;
