//! Tests what an edited line draws. The book's own code must draw the locked picture. The code of a
//! listed mistake must draw the picture of that mistake, unless the code is refused.

use course::environment::is_thorough;
use course::{
    Mistake, Place, TableRow, all_listed_places, hash_picture, hashes_of_right_pictures,
    mistakes_and_their_rows, workspace,
};
use page::expressions::{compile_line, draw_step_of_first_line};
use std::{fs, iter::once};

/// For every place, draws the book's code, and every tenth listed mistake that changes only this
/// place. With THOROUGH=1, draws every such mistake.
#[test]
fn places_and_listed_mistakes_are_drawn_by_an_edited_line() {
    let stride = if is_thorough() { 1 } else { 10 };
    let (mut count, mut refusals) = (0, vec![]);
    for place in all_listed_places() {
        for (text, expected) in
            right_and_mistaken_codes_with_hashes(&place).into_iter().step_by(stride)
        {
            count += 1;
            let picture = compile_line(&place, &text).and_then(|line| {
                draw_step_of_first_line(&[line], 640, u64::MAX).map_err(|error| error.refusal)
            });
            let line = format!("{}: {text}", place.name);
            match picture {
                Ok(picture) => assert_eq!(
                    hash_picture(&picture),
                    expected,
                    "{line} doesn't draw the picture that the table has for it; if the code or the \
                     list has changed, `cargo xtask` regenerates the table"
                ),
                Err(refusal) => {
                    assert_ne!(text, place.code, "{line}: {refusal}");
                    refusals.push(format!("{line}: {refusal}"));
                }
            }
        }
    }
    let refused_lines = refusals.join("\n");
    assert!(10 * refusals.len() < count, "too many of {count} lines are refused:\n{refused_lines}");
}

/// Returns the book's code for `place`, and the code of every mistake that changes only this place.
/// Each piece of code comes with the hash of the picture that it draws.
fn right_and_mistaken_codes_with_hashes(place: &Place) -> Vec<(String, u64)> {
    let path = format!("steps/{}", place.file);
    let text = fs::read_to_string(workspace().join(&path)).expect("the file can be read");
    let lines: Vec<_> = text.lines().map(str::trim_start).collect();
    let bare = lines.join("\n");
    let range = place.find_range(&bare).expect("the place");
    let (code_before, code_after) = (&bare[..range.start], &bare[range.end..]);
    let right = hashes_of_right_pictures().find(|(name, _)| *name == place.step().name());
    let (_, right) = right.expect("a locked picture");
    let edit = |(mistake, row): (&Mistake, &TableRow)| {
        let edited =
            mistake.apply_and_strip_indentation(&bare).ok().filter(|_| mistake.file == path)?;
        let new = edited.strip_prefix(code_before)?.strip_suffix(code_after)?;
        Some((new.to_owned(), row.hashes.first()?.unwrap_or(right)))
    };
    let edits = mistakes_and_their_rows().filter_map(edit);
    once((place.code.to_owned(), right)).chain(edits).collect()
}
