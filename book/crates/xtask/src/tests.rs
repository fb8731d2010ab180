//! What is checked in and made from the code is what the code says today.

use crate::mistake_program::title_and_file;
use crate::mistakes::{Table, key};
use crate::modules;
use course::environment::is_ci;
use course::{Step, mistake_texts, mistakes};
use std::collections::HashSet;
use std::io::{Write, stderr};

#[test]
fn modules_are_made_from_the_code_of_today() {
    let note = "The modules of the pages are older than the code: `cargo xtask` compiles them.";
    let is_stale = modules::are_stale().expect("the sources can be read");
    assert!(!is_stale || !is_ci(), "{note}");
    if is_stale {
        // What a test prints is hidden where it passes; this is not.
        let _ = writeln!(stderr(), "\nNote: {note}");
    }
}

#[test]
fn the_table_knows_each_mistake_and_what_is_right() {
    let table = Table::read().expect("each mistake has its place, and the table can be read");
    let unknown: Vec<_> = table.unknown().map(|(_, mistake)| title_and_file(mistake)).collect();
    assert!(unknown.is_empty(), "`cargo xtask` draws what is new:\n{}", unknown.join("\n"));
    let [.., text] = mistake_texts();
    assert!(table.text() == text, "the table is another: `cargo xtask` writes it anew");
}

#[test]
fn picture_of_another_name_or_step_is_drawn_again() {
    let mut mistake = mistakes().remove(0);
    let known = key(&mistake, &[]).ok();
    for picture in [("degrees", Step::Phong), ("another", Step::Rays)] {
        mistake.pictures = vec![picture];
        assert_ne!(known, key(&mistake, &[]).ok(), "{picture:?}");
    }
}

#[test]
fn each_mistake_is_a_change_and_listed_once() {
    let mut changes = HashSet::new();
    for mistake in mistakes() {
        let title = title_and_file(&mistake);
        assert_ne!(mistake.old, mistake.new, "{title}");
        let is_of_step = |(name, step): &(&str, _)| !name.contains(' ') && mistake.step <= *step;
        assert!(mistake.pictures.iter().all(is_of_step), "{title}: {:?}", mistake.pictures);
        let is_new = changes.insert((mistake.file.clone(), mistake.old_and_new_lines()));
        assert!(is_new, "{title} is listed twice");
    }
}
