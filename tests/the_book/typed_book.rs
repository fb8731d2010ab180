//! The book suffices: typed from the first page to the last, its commands do what the
//! pages say. `source_listings` tests that all files are typed in the end.

use super::built_book::built_book;
use super::source_listings::SOURCE_FILES;
use super::support::page_items::{PageCommand, PageItem, page_items};
use super::support::reader_workspace::{ReaderWorkspace, TypedListings, typed_listings};
use super::support::verified_command::run_and_verify_command;
use anyhow::{Context, Result, ensure};
use builder::Page;
use course::Step;
use std::fs;

/// Types the listings of a page, and runs its commands between them. Fails unless they do
/// what the page says, and the program of a step has drawn its picture in the end.
fn type_and_run_page<'a>(
    page: &'a Page,
    reader: &ReaderWorkspace,
    typed: &mut TypedListings<'a>,
) -> Result<()> {
    let mut picture_names = vec![];
    for item in page_items(page) {
        match item {
            PageItem::Listing(listing) => {
                typed.entry(listing.path).or_default().push(listing);
            }
            PageItem::Command(command) if !runs_unlisted_solution(&command, typed) => {
                reader.write_listings(typed)?;
                let names = run_and_verify_command(reader, &command).with_context(|| {
                    let PageCommand { location, arguments, .. } = &command;
                    let line = arguments.join(" ");
                    format!("At {location}, {line} does not do what it says")
                })?;
                picture_names.extend(names);
            }
            PageItem::Command(_) | PageItem::Heading => {}
        }
    }
    let step = page.name.trim_end_matches(".html");
    let has_drawn = picture_names.iter().any(|name| name == step);
    ensure!(
        has_drawn || !Step::NAMES.contains(&step),
        "{}: no program {step} has drawn",
        page.name
    );
    Ok(())
}

/// Whether a command runs the solution of an exercise that no page has listed yet: the
/// reader's own.
fn runs_unlisted_solution(command: &PageCommand, typed: &TypedListings) -> bool {
    let Some(name) = command.option_value("--example") else { return false };
    let file = format!("/examples/{name}.rs");
    !typed.keys().any(|path| path.ends_with(&file))
        && SOURCE_FILES.0.keys().any(|path| path.ends_with(&file))
}

/// Types all listings of the book into the reader's workspace.
pub fn typed_workspace() -> ReaderWorkspace {
    let (book, reader) = (built_book(), ReaderWorkspace::open());
    let typed = typed_listings(book.chapters_in_order());
    reader.write_listings(&typed).expect("the files can be written");
    reader
}

#[test]
#[ignore = "takes minutes: cargo test -- --include-ignored"]
fn commands_do_what_their_pages_say() -> Result<()> {
    let (book, reader) = (built_book(), ReaderWorkspace::open());
    let _ = fs::remove_dir_all(reader.folder.join("steps"));
    let mut typed = TypedListings::new();
    let mut pages = book.chapters_in_order().into_iter();
    pages.try_for_each(|page| type_and_run_page(page, &reader, &mut typed))
}
