//! The list of mistakes, and what was made of it.

use check::{Mistake, Row, known, locked_sums, mistakes, places, rows, sum};
use compare::workspace;
use std::collections::HashSet;
use std::process::Command;
use std::{env, fs};

const AGAIN: &str = "`cargo run --bin mistakes` makes it anew";

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
fn the_table_knows_each_mistake() {
    let (all, rows) = (mistakes(), rows().collect::<Vec<_>>());
    let is_known = |mistake: &Mistake, row: Option<&Row>| {
        let pictures = mistake.shown.iter().flat_map(|shown| &shown.pictures);
        let mut pictures = pictures.map(|(name, _)| {
            workspace().join(format!("book/check/mistakes/pictures/{name}.png"))
        });
        row.is_some_and(|row| {
            row.key == Row::key(mistake, &text(&mistake.file))
                && row.sums.iter().any(Option::is_some)
        }) && pictures.all(|path| path.exists())
    };
    let pairs = all.iter().zip(0..).filter(|(one, k)| !is_known(one, rows.get(*k)));
    let wrong: Vec<_> =
        pairs.map(|(one, _)| format!("{}: {}", one.file, one.title)).collect();
    assert!(wrong.is_empty(), "the table is old, {AGAIN}:\n{}", wrong.join("\n"));
    assert_eq!(all.len(), rows.len(), "{AGAIN}");
}

#[test]
fn the_table_knows_what_is_right() {
    for (name, right) in locked_sums() {
        assert_eq!(right, sum(&crate::right(name)), "{name}: {AGAIN}");
        assert!(
            known(right).iter().all(|(_, of)| of != name),
            "{name}: it is right"
        );
    }
    assert_eq!(locked_sums().count(), crate::locked().len(), "{AGAIN}");
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
        assert!(
            is_known || file.ends_with("/main.rs"),
            "{file} is not in files.txt"
        );
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

/// Five of the list, others each time: it takes a minute, so it is done where
/// THOROUGH is set.
#[test]
fn some_of_the_list_are_drawn_again() {
    if env::var_os("THOROUGH").is_some() {
        let program = env!("CARGO_BIN_EXE_mistakes");
        let output = Command::new(program).args(["--again", "5"]).output();
        let output = output.expect("the program runs");
        assert!(output.status.success(), "{output:?}");
    }
}
