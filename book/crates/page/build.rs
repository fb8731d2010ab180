//! Writes the five steps anew, as modules in which each place asks for the reader's expression.

#[path = "../course/src/crate_as_module.rs"]
mod crate_as_module;
#[path = "../course/src/place.rs"]
#[allow(dead_code, reason = "used in the library")]
mod place;

use crate_as_module::crate_as_module;
use place::all_listed_places;
use std::cmp::Reverse;
use std::error::Error;
use std::fs::{create_dir_all, read_dir, read_to_string, write};
use std::{collections::BTreeMap, env, path::Path};

const STEPS: &str = "../../../steps";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={STEPS}");
    println!("cargo::rerun-if-changed=../course/places.txt");
    println!("cargo::rerun-if-changed=../course/src");
    let mut files = BTreeMap::new();
    for step in read_dir(STEPS)? {
        for file in step?.path().join("src").read_dir().into_iter().flatten() {
            let path = file?.path();
            let name = path.strip_prefix(STEPS)?.display().to_string().replace('\\', "/");
            files.insert(name, read_to_string(path)?.replace('\r', ""));
        }
    }
    let edits = all_listed_places().into_iter().filter_map(|place| {
        let range = place.find_range(files.get(place.file)?).ok()?;
        Some((range, place))
    });
    let mut edits: Vec<_> = edits.collect();
    // From the end of a file to its start, as each edit moves what comes behind it.
    edits.sort_by_key(|(range, _)| Reverse(range.start));
    for (range, place) in edits {
        let Some(text) = files.get_mut(place.file) else { continue };
        let variables: Vec<_> = place.variables.iter().map(|(name, _)| *name).collect();
        let (code, variables) = (&text[range.clone()], variables.join(", "));
        let question = format!("editable!({}, {code}, [{variables}])", place.index);
        text.replace_range(range, &question);
    }
    let out = env::var("OUT_DIR")?;
    let mut modules = String::new();
    for (name, text) in &files {
        let path = Path::new(&out).join(name);
        create_dir_all(path.parent().unwrap_or(&path))?;
        let step = name.split('/').next().unwrap_or_default();
        let module = format!("expressions::steps::{step}");
        write(&path, crate_as_module(text, &module, ["step0"]))?;
        if name.ends_with("/lib.rs") {
            modules += &format!("#[path = {name:?}]\npub mod {step};\n");
        }
    }
    Ok(write(Path::new(&out).join("steps.rs"), modules)?)
}
