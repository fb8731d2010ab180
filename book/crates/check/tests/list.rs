//! The list of mistakes; whether the table knows them is asked in `xtask`.

use check::sections;
use course::workspace;
use course::{Step, mistakes};
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
fn files_and_sections_of_answers_exist() {
    let has_heading =
        |step: Step, section: &str| read_chapters(step).contains(&format!("# {section}\n"));
    for (file, section) in sections() {
        let path = file.replacen('/', "/src/", 1);
        assert!(workspace().join("steps").join(&path).exists(), "{path}");
        let step = Step::from_path(file).expect("a step");
        assert!(has_heading(step, section), "{file}: {section}");
    }
    for mistake in mistakes() {
        let file = mistake.file.replace("steps/", "").replace("/src/", "/");
        assert!(sections().any(|(name, _)| name == file), "{file} is not in sections.txt");
        if let Some(shown) = &mistake.book_entry {
            let step = mistake.step().expect("a step");
            assert!(has_heading(step, shown.section), "{}: {}", mistake.title, shown.section);
        }
    }
}
