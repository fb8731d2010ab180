use crate::modules_up_to_date::assert_same;
use crate::support::page_module::Module;
use crate::tries_all_cases;
use course::Place;
use course::workspace;
use course::{Mistake, TableRow, hash_picture, locked_hashes, mistakes, table_rows};
use page::answer;
use page::expressions::{draw_edited, editable_places, parse_expression};
use std::fs;

#[test]
fn expressions_wasm_is_up_to_date() {
    let mut module = Module::start_checked_in("expressions");
    let mut assert_answered = |request: &str| {
        let ours = answer(request, b"");
        assert_same("expressions", request, &ours, module.answer(request, b""));
    };
    for (k, place) in editable_places().iter().enumerate() {
        // A whole picture takes seconds here.
        let columns = if tries_all_cases() && k % 6 == 0 { 640 } else { 32 };
        let Place { name, code, .. } = place;
        assert_answered(&format!("edit {name} {columns} {code}"));
        assert_answered(&format!("edit {name} 32 ({code}) * 0.5"));
        assert_answered(&format!("edit {name} 32 2.0 * √2"));
        assert_answered(&format!("variables {name}"));
    }
}

/// A tenth of the listed mistakes that change one place and nothing else, all where THOROUGH is
/// set. A mistake that the table does not know yet is left out.
#[test]
fn listed_mistakes_are_drawn_by_an_edited_line() {
    let edits: Vec<_> = editable_places().iter().flat_map(edits_of_known_mistakes).collect();
    let step = if tries_all_cases() { 1 } else { 10 };
    let (mut count, mut refusals) = (0, vec![]);
    for (place, text, expected) in edits.iter().step_by(step) {
        count += 1;
        match parse_expression(place, text) {
            Ok(expression) => {
                let sum = hash_picture(&draw_edited(place, expression, 640));
                assert_eq!(sum, *expected, "{}: {text} draws another picture", place.name);
            }
            Err(mistake) => {
                refusals.push(format!("{}: {text}: {}\n", place.name, mistake.sentence));
            }
        }
    }
    let refused_count = refusals.len();
    let refusals = refusals.concat();
    assert!(10 * refused_count < count, "of {count}, these are refused:\n{refusals}");
}

/// The mistakes that change `place` alone: what is written there, and the sum of the picture.
fn edits_of_known_mistakes(place: &Place) -> Vec<(Place, String, u64)> {
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
        let is_known = row.key == TableRow::compute_key(&mistake, &text);
        is_known.then(|| (place.clone(), new.to_owned(), row.hashes[0].unwrap_or(right)))
    };
    mistakes().into_iter().zip(table_rows()).filter_map(edit).collect()
}
