use book::{Files, Site};
use compare::workspace;
use std::sync::LazyLock;

/// Our book, built now.
pub static BOOK: LazyLock<Site> = LazyLock::new(|| {
    let built = book::build(&workspace());
    built.unwrap_or_else(|error| panic!("{error:#}")).1
});

/// The files in a folder of the workspace.
pub fn files(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}

#[test]
fn the_steps_are_chapters_in_their_order() {
    let names = BOOK.chapters().into_iter().map(|page| &page.name[..]);
    let steps = names.filter_map(|name| name.strip_suffix(".html"));
    let steps: Vec<_> = steps.filter(|name| name.starts_with("step")).collect();
    assert_eq!(steps, super::typist::STEPS);
}
