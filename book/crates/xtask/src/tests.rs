//! What is checked in and made from the code is what the code says today.

use crate::mistakes::{Table, compute_key};
use crate::modules;
use course::{Mistake, TableRow, find_mistakes_with_hash, locked_hashes, mistakes, table_rows};
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
    let table = Table::read().expect("the pictures and the table can be read");
    let right: Vec<_> = locked_hashes().collect();
    assert!(table.right == right, "pictures have changed: `cargo xtask` makes the table anew");
    let (all, rows) = (mistakes(), table_rows().collect::<Vec<_>>());
    let is_known = |(mistake, row): (&Mistake, Option<&TableRow>)| {
        table.knows(mistake).unwrap_or(false)
            && row.map(|row| row.key) == compute_key(mistake, &right).ok()
    };
    let rows = (0..).map(|k| rows.get(k));
    let unknown: Vec<_> = all.iter().zip(rows).filter(|pair| !is_known(*pair)).collect();
    let unknown: Vec<_> =
        unknown.iter().map(|(one, _)| format!("{}: {}", one.file, one.title)).collect();
    assert!(unknown.is_empty(), "`cargo xtask` draws what is new:\n{}", unknown.join("\n"));
    for (name, hash) in right {
        let mistakes = find_mistakes_with_hash(hash);
        assert!(mistakes.iter().all(|(_, drawn)| *drawn != name), "{name} is right");
    }
}
