//! The book suffices: the crates compile at each heading and each command of their chapters.

use super::built_book::built_book;
use super::page_items::{PageItem, TypedFiles, page_items};
use super::reader_workspace::{ReaderWorkspace, pages_of_step};
use anyhow::{Result, ensure};
use builder::Site;
use course::{Step, crate_as_module};

/// The crate of a step, as far as its chapters have shown it at some heading or command: a name
/// of its own, and the text of each file in `src`, by name, but for `main.rs`.
type CrateState<'a> = (String, TypedFiles<'a>);

/// The manifest of a crate in which each state is a module.
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

/// The states of all crates from their `lib.rs` on, in the order of the book; each differs
/// from the one before.
fn crate_states(book: &Site) -> Vec<CrateState<'_>> {
    let mut states = Vec::<CrateState>::new();
    for step in Step::NAMES {
        let mut files = TypedFiles::new();
        let folder = format!("steps/{step}/src/");
        for item in pages_of_step(book, step).flat_map(page_items) {
            if let PageItem::Listing(path, code) = item {
                let file = path.strip_prefix(&folder).filter(|file| *file != "main.rs");
                if let Some(file) = file {
                    *files.entry(file).or_default() += &code;
                }
                continue;
            }
            let is_new = states.last().is_none_or(|(_, last)| *last != files);
            if is_new && files.contains_key("lib.rs") {
                states.push((format!("state_{step}_{}", states.len()), files.clone()));
            }
        }
    }
    states
}

#[test]
fn crates_compile_at_each_heading_and_command() -> Result<()> {
    let reader = ReaderWorkspace::typed();
    let (book, mut lib) = (built_book(), String::new());
    let states = crate_states(&book);
    assert!(20 <= states.len());
    // All at once, as modules of one crate.
    for (name, files) in &states {
        for (file, text) in files {
            let file = if *file == "lib.rs" { "mod.rs" } else { file };
            let text = crate_as_module(text, name, []);
            reader.write_if_changed(&format!("steps/states/src/{name}/{file}"), &text)?;
        }
        lib += &format!("mod {name};\n");
    }
    reader.write_if_changed("steps/states/Cargo.toml", STATES_MANIFEST)?;
    reader.write_if_changed("steps/states/src/lib.rs", &lib)?;
    let (code, text) = reader.run("cargo build -p states", "0")?;
    ensure!(code == Some(0), "{text}");
    Ok(())
}
