//! Tests that the book lists every line of every file of the five crates exactly once.

use super::assert_no_faults;
use super::built_book::{built_book, read_workspace_folder};
use super::page_items::typed_files;
use builder::Files;
use std::sync::LazyLock;

/// The files that a reader types, keyed by path. The files come from the folders `steps` (the five
/// crates and their rustfmt settings), `book/reader` and `book/typed`.
pub static SOURCE_FILES: LazyLock<Files> = LazyLock::new(|| {
    let in_workspace = |(path, bytes)| (format!("steps/{path}"), bytes);
    let mut files = Files(read_workspace_folder("steps").0.into_iter().map(in_workspace).collect());
    files.0.extend(read_workspace_folder("book/reader").0);
    files.0.extend(read_workspace_folder("book/typed").0);
    files
});

#[test]
fn every_line_of_every_file_is_listed_once() {
    let (book, mut faults) = (built_book(), vec![]);
    let typed = typed_files(book.pages_in_order());
    let files = SOURCE_FILES.texts_with_suffix("");
    for (path, text) in files.filter(|(path, _)| path.starts_with("steps/")) {
        let listed_text = typed.get(path).map_or("", String::as_str);
        if listed_text != text {
            let pairs = text.lines().zip(listed_text.lines());
            let equal_count = pairs.take_while(|(line, listed_line)| line == listed_line).count();
            let line = equal_count + 1;
            faults.push(format!(
                "From line {line} on, the pages' listings of {path} differ from the file."
            ));
        }
    }
    assert_no_faults(&faults);
}
