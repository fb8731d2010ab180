//! The time of each exercise, as its heading says it: two minutes for each line of our
//! solution that its starter does not have.

use super::assert_no_faults;
use super::built_book::built_book;
use super::source_listings::SOURCE_FILES;
use builder::inner_text;
use std::collections::HashSet;

/// The text of an example of any step.
fn example_text(name: &str) -> Option<&'static str> {
    let file = format!("/examples/{name}.rs");
    let mut all = SOURCE_FILES.texts_with_suffix(&file);
    all.next().map(|(_, text)| text)
}

/// The example that an exercise begins from.
fn starter_name(exercise: &str, page: &str) -> String {
    match exercise {
        "glass" => "mirror".to_owned(),
        "fast" => "many".to_owned(),
        _ => format!("{}_starter", page.split('_').next().unwrap_or_default()),
    }
}

/// The minutes, to the nearest ten, or from three quarters of an hour the hours, to the
/// nearest half.
fn format_minutes(minutes: usize) -> String {
    match (minutes + 15) / 30 {
        0 | 1 => format!("{} minutes", (minutes + 5) / 10 * 10),
        2 => "1 hour".to_owned(),
        halves if halves % 2 == 0 => format!("{} hours", halves / 2),
        halves => format!("{}.5 hours", halves / 2),
    }
}

#[test]
fn exercises_take_two_minutes_a_line() {
    let (book, mut faults, mut count) = (built_book(), vec![], 0);
    for page in book.chapters_in_order() {
        if page.name == "solutions.html" {
            continue;
        }
        for heading in page.select_all("main :is(h2, h3)[id]") {
            let id = heading.attr("id").unwrap_or_default();
            let starter = example_text(&starter_name(id, &page.name));
            let (Some(solution), Some(starter)) = (example_text(id), starter) else {
                continue;
            };
            let known: HashSet<_> = starter.lines().map(str::trim).collect();
            let lines = solution.lines().map(str::trim);
            let lines = lines.filter(|line| !line.is_empty() && !known.contains(line));
            let time = format_minutes(2 * lines.count());
            let title = inner_text(heading);
            if !title.trim().ends_with(&format!(": {time}")) {
                faults.push(format!("{title:?} on {} takes {time}.", page.name));
            }
            count += 1;
        }
    }
    assert_no_faults(&faults);
    assert_eq!(count, 16, "exercises that say how long they take");
}
