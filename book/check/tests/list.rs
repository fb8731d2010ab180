//! The list of mistakes; whether the table knows them is asked in `update`.

use check::{Row, Step, mistakes, names, places, step_of_exercise};
use compare::workspace;
use std::collections::HashSet;
use std::fs;

fn text(path: &str) -> String {
    fs::read_to_string(workspace().join(path)).unwrap_or_default()
}

#[test]
fn each_mistake_can_be_made() {
    let (mut wrong, mut seen) = (vec![], HashSet::new());
    for mistake in mistakes() {
        let applied = mistake.applied(&text(&mistake.file));
        let is_change = mistake.old != mistake.new;
        if applied.is_none() || !is_change || !seen.insert(Row::key(&mistake, "")) {
            wrong.push(format!(
                "{}: {}\n{}",
                mistake.file,
                mistake.title,
                mistake.diff()
            ));
        }
    }
    let wrong = wrong.join("\n");
    assert!(
        wrong.is_empty(),
        "there once, and told once, is none of these:\n{wrong}"
    );
}

#[test]
fn all_that_an_answer_leads_to_is_there() {
    for place in places() {
        let step = place.step.name();
        assert!(workspace().join(place.path()).exists(), "{}", place.path());
        let tests = text(&format!("steps/{step}/tests/by_hand.rs"));
        for test in place.tests.split(", ") {
            assert!(tests.contains(&format!("fn {test}()")), "{test}: {place:?}");
        }
        let chapter = text(&format!("book/chapters/{step}.md"));
        let heading = format!("# {}\n", place.section);
        assert!(chapter.contains(&heading), "{place:?}");
    }
    for mistake in mistakes().iter().filter(|one| !one.file.contains("/examples/"))
    {
        let file = &mistake.file;
        let is_known = places().any(|place| place.path() == *file);
        assert!(is_known, "{file} is not in source_files.txt");
        if let Some(shown) = &mistake.shown {
            let step = mistake.step().expect("a step").name();
            let chapter = text(&format!("book/chapters/{step}.md"));
            let heading = format!("# {}\n", shown.section);
            assert!(
                chapter.contains(&heading),
                "{}: {}",
                mistake.title,
                shown.section
            );
        }
    }
}

#[test]
fn the_step_of_each_exercise_is_known() {
    for name in names().into_iter().filter(|name| !name.starts_with("step")) {
        let step = step_of_exercise(name).map(Step::name).unwrap_or_default();
        let program = format!("steps/{step}/examples/{name}.rs");
        assert!(workspace().join(&program).exists(), "{program}");
    }
}
