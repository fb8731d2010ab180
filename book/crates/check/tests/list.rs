//! The list of mistakes; whether the table knows them is asked in `xtask`.

use check::sections;
use course::{Step, mistakes, workspace};
use std::collections::HashSet;
use std::fs;

fn read_in_workspace(path: &str) -> String {
    fs::read_to_string(workspace().join(path)).unwrap_or_default()
}

#[test]
fn each_listed_mistake_applies_once_and_is_unique() {
    let mut changes = HashSet::new();
    for mistake in mistakes() {
        let applied = mistake.apply_and_unindent(&read_in_workspace(&mistake.file));
        let is_change = mistake.old != mistake.new;
        let is_new = changes.insert((mistake.file.clone(), mistake.old_and_new_lines()));
        assert!(applied.is_some() && is_change && is_new, "{}: {}", mistake.file, mistake.title);
    }
}

#[test]
fn files_and_sections_of_answers_exist() {
    let assert_heading = |file: &str, section: &str| {
        let step = Step::from_path(file).expect("a step");
        let last = if step == Step::Rays { "step01_program" } else { step.name() };
        let paths = [step.name(), last].map(|name| format!("book/src/{name}.md"));
        let heading = format!("# {section}");
        let has_heading =
            |path: &String| read_in_workspace(path).lines().any(|line| line.ends_with(&heading));
        assert!(paths.iter().any(has_heading), "{section}");
    };
    for (file, section) in sections() {
        let path = file.replacen('/', "/src/", 1);
        assert!(workspace().join("steps").join(&path).exists(), "{path}");
        assert_heading(file, section);
    }
    for mistake in mistakes() {
        let file = mistake.file.replace("steps/", "").replace("/src/", "/");
        assert!(sections().any(|(name, _)| name == file), "{file} is not in sections.txt");
        mistake.book_entry.iter().for_each(|shown| assert_heading(&file, shown.section));
    }
}
