//! Each place as it stands draws the locked picture; a listed mistake that is typed into it draws
//! that mistake's.

use course::{
    Mistake, Place, TableRow, all_listed_places, hash_picture, locked_hashes, mistakes, table_rows,
    workspace,
};
use page::expressions::{draw_edited, parse_expression};
use std::{env, fs};

/// The places as they stand, and a tenth of the listed mistakes that change one place and nothing
/// else, all where THOROUGH is set.
#[test]
fn places_and_listed_mistakes_are_drawn_by_an_edited_line() {
    let step = if env::var_os("THOROUGH").is_some() { 1 } else { 10 };
    let (mut count, mut refusals) = (0, String::new());
    let edits: Vec<_> = all_listed_places().iter().flat_map(edits_of_listed_mistakes).collect();
    let unedited_places = all_listed_places().into_iter().map(|place| {
        let hash = locked_hash(&place);
        (place.clone(), place.code.to_owned(), hash)
    });
    for (place, text, expected) in unedited_places.chain(edits.into_iter().step_by(step)) {
        count += 1;
        let picture = parse_expression(&place, &text).and_then(|expression| {
            draw_edited(&[expression], 640, i64::MAX).map_err(|(_, refusal)| refusal)
        });
        match picture {
            Ok(picture) => assert_eq!(
                hash_picture(&picture),
                expected,
                "{}: {text} draws another picture than the table has; where the code or the list \
                 has changed, `cargo xtask` makes the table anew",
                place.name
            ),
            Err(refusal) => {
                assert_ne!(text, place.code, "{}: {}", place.name, refusal.sentence);
                refusals += &format!("{}: {text}: {}\n", place.name, refusal.sentence);
            }
        }
    }
    let refused_count = refusals.lines().count();
    assert!(10 * refused_count < count, "of {count}, these are refused:\n{refusals}");
}

/// The hash of the right picture of a place's step.
fn locked_hash(place: &Place) -> u64 {
    let locked_picture = locked_hashes().find(|(name, _)| *name == place.step_name());
    locked_picture.expect("a locked picture").1
}

/// The mistakes that change `place` alone: what is written there, and the hash of the picture.
fn edits_of_listed_mistakes(place: &Place) -> Vec<(Place, String, u64)> {
    let path = format!("steps/{}", place.file);
    let text = fs::read_to_string(workspace().join(&path)).expect("a file");
    let lines: Vec<_> = text.lines().map(str::trim_start).collect();
    let bare = lines.join("\n");
    let range = place.find_range(&bare).expect("the place");
    let (code_before, code_after) = (&bare[..range.start], &bare[range.end..]);
    let edit = |(mistake, (_, hashes)): (Mistake, TableRow)| {
        let edited = mistake.apply_and_unindent(&bare).filter(|_| mistake.file == path)?;
        let new = edited.strip_prefix(code_before)?.strip_suffix(code_after)?;
        Some((place.clone(), new.to_owned(), hashes.first()?.unwrap_or(locked_hash(place))))
    };
    mistakes().into_iter().zip(table_rows()).filter_map(edit).collect()
}
