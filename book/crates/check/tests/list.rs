//! The list of mistakes; whether the table knows them is asked in `update`.

use check::source_refs;
use course::workspace;
use course::{Step, locked_names, mistakes};
use std::collections::HashSet;
use std::fs;

fn read_in_workspace(path: &str) -> String {
    fs::read_to_string(workspace().join(path)).unwrap_or_default()
}

/// The chapters of a step, one after the other.
fn read_chapters(step: Step) -> String {
    let chapters = step.chapters().into_iter();
    chapters.map(|name| read_in_workspace(&format!("book/src/{name}.md"))).collect()
}

#[test]
fn each_listed_mistake_applies_once_and_is_unique() {
    let (mut wrong, mut seen) = (vec![], HashSet::new());
    for mistake in mistakes() {
        let applied = mistake.apply_and_unindent(&read_in_workspace(&mistake.file));
        let is_change = mistake.old != mistake.new;
        let is_new = seen.insert((mistake.file.clone(), mistake.old.clone(), mistake.new.clone()));
        if applied.is_none() || !is_change || !is_new {
            wrong.push(format!(
                "{}: {}\n{}",
                mistake.file,
                mistake.title,
                mistake.old_and_new_lines()
            ));
        }
    }
    let wrong = wrong.join("\n");
    assert!(wrong.is_empty(), "there once, and told once, is none of these:\n{wrong}");
}

#[test]
fn files_tests_and_sections_of_answers_exist() {
    for place in source_refs() {
        let step = place.step.name();
        assert!(workspace().join(place.workspace_path()).exists(), "{}", place.workspace_path());
        let tests = read_in_workspace(&format!("steps/{step}/tests/by_hand.rs"));
        for test in place.tests.split(", ") {
            assert!(tests.contains(&format!("fn {test}()")), "{test}: {place:?}");
        }
        let heading = format!("# {}\n", place.section);
        assert!(read_chapters(place.step).contains(&heading), "{place:?}");
    }
    for mistake in mistakes().iter().filter(|one| !one.file.contains("/examples/")) {
        let file = &mistake.file;
        let is_known = source_refs().any(|place| place.workspace_path() == *file);
        assert!(is_known, "{file} is not in sections_and_tests.txt");
        if let Some(shown) = &mistake.book_entry {
            let step = mistake.step().expect("a step");
            let heading = format!("# {}\n", shown.section);
            assert!(read_chapters(step).contains(&heading), "{}: {}", mistake.title, shown.section);
        }
    }
}

#[test]
fn the_step_of_each_exercise_is_known() {
    for name in locked_names().into_iter().filter(|name| !name.starts_with("step")) {
        let step = course::step_of_example(name).map(Step::name).unwrap_or_default();
        let program = format!("steps/{step}/examples/{name}.rs");
        assert!(workspace().join(&program).exists(), "{program}");
    }
}
