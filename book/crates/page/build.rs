//! Copies the source of the five steps into modules. In the copy, the code at each *place* (an
//! expression that a reader may edit) first checks whether the reader has edited this place.

#[path = "../course/src/source_code/crate_as_module.rs"]
mod crate_as_module;
#[path = "../course/src/source_code/place.rs"]
#[allow(dead_code, reason = "used in the library")]
mod place;

use crate_as_module::crate_as_module;
use place::{Place, all_listed_places};
use std::cmp::Reverse;
use std::error::Error;
use std::fs::{create_dir_all, read_dir, read_to_string, write};
use std::{collections::BTreeMap, env, path::Path};

const STEPS: &str = "../../../steps";

/// The contents of step 1's draw_pixels.rs in the copy. The original file draws the rows of a
/// picture on several threads. The copy can't do the same, because the context in
/// `edited_picture.rs` is thread-local.
const DRAW_PIXELS: &str =
    "pub use crate::expressions::draw_spaced_pixels_until_refusal as draw_pixels;\n";

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={STEPS}");
    println!("cargo::rerun-if-changed=../course/places.txt");
    println!("cargo::rerun-if-changed=../course/src");
    let places = all_listed_places();
    // `edited_picture.rs` has one bit of a u64 for each place.
    assert!(places.len() <= u64::BITS as usize, "places.txt has more places than a u64 has bits");
    let output_folder = env::var("OUT_DIR")?;
    let mut modules = String::new();
    for (name, text) in read_step_sources()? {
        let step = name.split('/').next().unwrap_or_default();
        let module = format!("expressions::steps::{step}");
        let copy = match &*name {
            "step01_rays/src/draw_pixels.rs" => DRAW_PIXELS.to_owned(),
            _ => with_editable_places_and_refusing_asserts(
                &crate_as_module(&text, &module, ["step0"]),
                &name,
                &places,
            ),
        };
        let path = Path::new(&output_folder).join(&name);
        create_dir_all(path.parent().unwrap_or(&path))?;
        write(&path, copy)?;
        if name.ends_with("/lib.rs") {
            modules += &format!("#[path = {name:?}]\npub mod {step};\n");
        }
    }
    Ok(write(Path::new(&output_folder).join("steps.rs"), modules)?)
}

/// Returns the text of each of the steps' source files, keyed by a path such as
/// `step01_rays/src/ray.rs`. The map is sorted, so that the copy is the same on every machine.
fn read_step_sources() -> Result<BTreeMap<String, String>, Box<dyn Error>> {
    let mut files = BTreeMap::new();
    for step in read_dir(STEPS)? {
        for file in step?.path().join("src").read_dir().into_iter().flatten() {
            let path = file?.path();
            let name = path.strip_prefix(STEPS)?.display().to_string().replace('\\', "/");
            files.insert(name, read_to_string(path)?.replace('\r', ""));
        }
    }
    Ok(files)
}

/// Rewrites a source file of a step. In the result, each place has the value of the reader's line,
/// if the reader has edited the place. A failed `debug_assert!` stops the drawing instead of
/// crashing the module.
///
/// The steps themselves have no hook for the reader's lines, because the book shows all of their
/// source. So a few words of their source are replaced, and the result is compiled as a second
/// copy. Replacing these words needs no parser:
///
/// - A place is a whole expression whose code occurs exactly once in its file. The replacement is
///   an expression, too.
/// - The function that replaces `debug_assert!` takes the same arguments: a condition and a
///   sentence.
///
/// If a change to a step breaks a replacement, the copy fails to compile or draws a wrong picture.
/// One test draws a picture for every place, and compares it with the locked picture. Another test
/// reports any place whose code isn't found. This function skips such a place instead of failing
/// the build, because that test couldn't run after a failed build.
fn with_editable_places_and_refusing_asserts(text: &str, file: &str, places: &[Place]) -> String {
    let places = places.iter().filter(|place| place.file == file);
    let ranges_and_places = places.filter_map(|place| Some((place.find_range(text).ok()?, place)));
    let mut edits: Vec<_> = ranges_and_places.collect();
    // Edit from the end of the file to its start, because each edit shifts the text after it.
    edits.sort_by_key(|(range, _)| Reverse(range.start));
    let mut copy = text.to_owned();
    for (range, Place { index, variables, .. }) in edits {
        let code = &text[range.clone()];
        let values: String =
            variables.iter().map(|(name, _)| format!("({name}).into(), ")).collect();
        let call = format!("crate::expressions::value_of_line({index}, || [{values}])");
        let replacement = format!("(match {call} {{ Some(value) => value, None => {code} }})");
        copy.replace_range(range, &replacement);
    }
    copy.replace("debug_assert!(", "crate::expressions::assert_or_refuse_first_line(")
}
