//! The list of mistakes; whether the table knows them is asked in `xtask`.

use course::{mistakes, workspace};
use std::collections::HashSet;
use std::fs;

#[test]
fn each_listed_mistake_applies_once_and_is_unique() {
    let mut changes = HashSet::new();
    for mistake in mistakes() {
        let text = fs::read_to_string(workspace().join(&mistake.file)).unwrap_or_default();
        let applied = mistake.apply_and_unindent(&text);
        let is_change = mistake.old != mistake.new;
        let is_new = changes.insert((mistake.file.clone(), mistake.old_and_new_lines()));
        assert!(applied.is_some() && is_change && is_new, "{}: {}", mistake.file, mistake.title);
    }
}
