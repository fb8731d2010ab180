//! What is checked in and made from the code is what the code says today.

use crate::mistake_program::title_and_file;
use crate::mistakes::Table;
use crate::modules;
use course::mistake_texts;
use std::env;
use std::io::{Write, stderr};

#[test]
fn modules_are_made_from_the_code_of_today() {
    let note = "The modules of the pages are older than the code: `cargo xtask` compiles them.";
    let is_stale = modules::are_stale().expect("the sources can be read");
    assert!(!is_stale || env::var("CI").as_deref() != Ok("true"), "{note}");
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
