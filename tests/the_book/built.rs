use book::{Files, Page, Site};
use compare::workspace;
use std::sync::LazyLock;

/// Our book, built now.
pub static BOOK: LazyLock<Site> = LazyLock::new(|| {
    let built = book::build(&workspace().join("book"));
    built.unwrap_or_else(|error| panic!("{error:#}")).1
});

/// The files in a folder of the workspace.
pub fn files(folder: &str) -> Files {
    let files = Files::read(&workspace().join(folder));
    files.unwrap_or_else(|error| panic!("{folder}: {error}"))
}

#[test]
fn the_steps_are_chapters_in_their_order() {
    let chapters = BOOK.chapters();
    let steps = chapters.iter().filter(|page| page.name.starts_with("step"));
    let names: Vec<_> =
        steps.filter_map(|page| page.name.strip_suffix(".html")).collect();
    assert_eq!(names, super::typist::STEPS);
    let first = |name: &str| BOOK.pages[name].all("main").next().map(|m| &m.text);
    assert_eq!(first("index.html"), first(&chapters[0].name));
}

#[test]
fn elements_have_their_text_place_and_attributes() {
    let html = "<p>a<br>b <i class=\"x y\">&lt;c</i></p>\n<script>\"<p>\"</script>";
    let Page { elements, text, .. } = Page::new("a.html", html);
    let tags: Vec<_> =
        elements.iter().map(|e| (e.tag.as_str(), e.parent)).collect();
    let (p, in_p) = (None, Some(0));
    assert_eq!(tags, [("p", p), ("br", in_p), ("i", in_p), ("script", None)]);
    let texts: Vec<_> =
        elements.iter().map(|e| (e.text.as_str(), e.line)).collect();
    assert_eq!(texts, [("ab <c", 1), ("", 1), ("<c", 1), ("\"<p>\"", 2)]);
    assert!(elements[2].is("i", "y") && !elements[2].is("i", "z"));
    assert_eq!(&text[elements[0].place.clone()], " a b  <c ");
}
