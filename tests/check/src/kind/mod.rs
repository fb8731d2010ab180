//! Pictures that are no render: what became of them after they were drawn.

mod gamma;
mod grey;
mod jpeg;
mod part;
mod repeated;
mod scaled;

use crate::png::Notes;
use crate::view::View;
use crate::{Locked, whose};

const LOSSY: &str = "Not right yet: save it in full colour, and ask again.";

/// What became of a picture that is none of those `asked` for, in plain words.
///
/// None where it may be a render: then its numbers tell of the program that drew it.
pub(crate) fn kind(
    yours: &View,
    asked: &[&Locked],
    notes: &Notes,
) -> Option<String> {
    if yours.stride != 1 || yours.flat().is_some() {
        return None;
    }
    let (yours, whole) = (&yours.kept, yours);
    let nearest = asked.iter().min_by_key(|ours| whose::distance(whole, ours))?;
    let told = (asked.iter().find_map(|ours| part::told(yours, ours)))
        .or_else(|| scaled::told(yours, nearest))
        .or_else(|| grey::told(yours, nearest))
        .or_else(|| gamma::told(yours, nearest))
        .or_else(|| repeated::told(yours))
        .or_else(|| jpeg::told(yours))
        .or_else(|| notes.is_lossy.then(|| LOSSY.to_owned()))?;
    Some(format!("{told}\n"))
}
