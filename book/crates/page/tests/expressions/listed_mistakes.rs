//! A listed mistake that is typed into a line draws that mistake's picture.

use course::{
    Mistake, Place, TableRow, hash_picture, locked_hashes, mistakes, table_rows, workspace,
};
use page::expressions::{draw_edited, editable_places, parse_expression};
use std::{env, fs};

/// A tenth of the listed mistakes that change one place and nothing else, all where THOROUGH is
/// set.
#[test]
fn listed_mistakes_are_drawn_by_an_edited_line() {
    let edits: Vec<_> = editable_places().iter().flat_map(edits_of_listed_mistakes).collect();
    let step = if env::var_os("THOROUGH").is_some() { 1 } else { 10 };
    let (mut count, mut refusals) = (0, vec![]);
    for (place, text, expected) in edits.iter().step_by(step) {
        count += 1;
        let picture = parse_expression(place, text).and_then(|expression| {
            let edits = vec![(place.clone(), expression)];
            draw_edited(place.step_name(), edits, 640, u64::MAX).map_err(|(_, refusal)| refusal)
        });
        match picture {
            Ok(picture) => assert_eq!(
                hash_picture(&picture),
                *expected,
                "{}: {text} draws another picture than the table has; where the code or the list \
                 has changed, `cargo xtask` makes the table anew",
                place.name
            ),
            Err(refusal) => {
                refusals.push(format!("{}: {text}: {}\n", place.name, refusal.sentence));
            }
        }
    }
    let refused_count = refusals.len();
    let refusals = refusals.concat();
    assert!(10 * refused_count < count, "of {count}, these are refused:\n{refusals}");
}

/// The mistakes that change `place` alone: what is written there, and the hash of the picture.
fn edits_of_listed_mistakes(place: &Place) -> Vec<(Place, String, u64)> {
    let path = format!("steps/{}", place.file);
    let text = fs::read_to_string(workspace().join(&path)).expect("a file");
    let lines: Vec<_> = text.lines().map(str::trim_start).collect();
    let bare = lines.join("\n");
    let range = place.find_ranges(&bare).first().cloned().expect("the place");
    let (code_before, code_after) = (&bare[..range.start], &bare[range.end..]);
    let right = locked_hashes().find(|(name, _)| *name == place.step_name());
    let (_, right) = right.expect("a locked picture");
    let edit = |(mistake, row): (Mistake, TableRow)| {
        let edited = mistake.apply_and_unindent(&bare).filter(|_| mistake.file == path)?;
        let new = edited.strip_prefix(code_before)?.strip_suffix(code_after)?;
        Some((place.clone(), new.to_owned(), row.hashes.first()?.unwrap_or(right)))
    };
    mistakes().into_iter().zip(table_rows()).filter_map(edit).collect()
}
