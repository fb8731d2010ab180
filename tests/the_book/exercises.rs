//! Tests that each exercise has a section and a form on a practice page, and a solution on the
//! solutions page. Section, form and solution are named after the exercise's picture.

use super::assert_no_faults;
use super::built_book::built_book;
use builder::Page;
use std::collections::BTreeMap;

/// Exercises that have a solution on the solutions page, but no section on a practice page. The
/// exercise `fast` has its own page, "Faster".
const WITHOUT_PRACTICE: [&str; 1] = ["fast"];

/// Finds the exercises' sections on a page. Returns a map from the name of each section to the
/// names of the pictures that the section's forms check.
fn checked_pictures_by_section(page: &Page) -> BTreeMap<&str, Vec<&str>> {
    let (mut sections, mut section) = (BTreeMap::new(), None);
    for element in &page.elements {
        match &*element.tag {
            "h1" | "h2" => section = None,
            "h3" => {
                section = element.attr("id");
                sections.extend(section.map(|name| (name, vec![])));
            }
            "form" => {
                let forms = section.and_then(|name| sections.get_mut(name));
                forms.into_iter().for_each(|forms| forms.extend(element.attr("data-check")));
            }
            _ => {}
        }
    }
    sections
}

#[test]
fn each_exercise_has_its_section_its_form_and_its_solution() {
    let book = built_book();
    let solutions = checked_pictures_by_section(&book.pages["solutions.html"]);
    let practice = book.pages.values().filter(|page| page.name.ends_with("_practice.html"));
    let exercises: BTreeMap<_, _> = practice.flat_map(checked_pictures_by_section).collect();
    let mut faults = vec![];
    for name in solutions.keys().filter(|name| !WITHOUT_PRACTICE.contains(name)) {
        match exercises.get(name) {
            None => faults.push(format!("No practice page has a section {{#{name}}}.")),
            Some(forms) if forms != &[*name] => {
                faults.push(format!("The section {{#{name}}} has no {{{{#check {name}}}}}."));
            }
            Some(_) => {}
        }
    }
    for name in exercises.keys().filter(|name| !solutions.contains_key(*name)) {
        faults.push(format!("solutions.md has no section {{#{name}}}."));
    }
    assert!(!solutions.is_empty());
    assert_no_faults(&faults);
}
