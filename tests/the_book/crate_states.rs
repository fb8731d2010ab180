//! Tests that the reader's crates compile at each heading and at each command, where a reader may
//! stop. The *state* of a crate is the part of it that the reader has typed so far.

use super::built_book::built_book;
use super::page_items::{PageItem, TypedFiles, headings_listings_and_commands};
use super::reader_workspace::{ReaderWorkspace, pages_of_step};
use anyhow::{Result, ensure};
use course::{Step, crate_as_module};

/// The manifest of a crate that has a module for each state.
const STATES_MANIFEST: &str = "
    package = { name = \"states\", edition.workspace = true }
    [dependencies]
    clap.workspace = true
    glam.workspace = true
    image.workspace = true
    rayon.workspace = true
    step01_rays = { path = \"../step01_rays\" }
    step02_sphere = { path = \"../step02_sphere\" }
    step03_nearest = { path = \"../step03_nearest\" }
    step04_diffuse = { path = \"../step04_diffuse\" }
";

/// Compiles all states of all crates at once, as modules of a single crate.
#[test]
fn crates_compile_at_each_heading_and_command() -> Result<()> {
    let (reader, mut modules) = (ReaderWorkspace::with_typed_book(), String::new());
    let book = built_book();
    for step in Step::NAMES {
        let (mut files, mut is_new) = (TypedFiles::new(), false);
        for item in pages_of_step(book, step).flat_map(headings_listings_and_commands) {
            if let PageItem::Listing(path, code) = item {
                let file = path.strip_prefix(&format!("steps/{step}/src/"));
                if let Some(file) = file.filter(|file| *file != "main.rs") {
                    *files.entry(file).or_default() += &code;
                    is_new = true;
                }
            } else if is_new && files.contains_key("lib.rs") {
                let name = format!("state_{step}_{}", modules.lines().count());
                for (file, text) in &files {
                    let file = if *file == "lib.rs" { "mod.rs" } else { file };
                    let text = crate_as_module(text, &name, []);
                    reader.write_if_changed(&format!("steps/states/src/{name}/{file}"), &text)?;
                }
                modules += &format!("mod {name};\n");
                is_new = false;
            }
        }
    }
    assert!(modules.lines().count() >= 20);
    reader.write_if_changed("steps/states/Cargo.toml", STATES_MANIFEST)?;
    reader.write_if_changed("steps/states/src/lib.rs", &modules)?;
    let (code, text) = reader.run_command(&["cargo", "build", "-p", "states"], "0")?;
    ensure!(code == Some(0), "{text}");
    Ok(())
}
