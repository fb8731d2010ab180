//! Applies all suggested cures to the lines in lines.txt. If a cured line is accepted, writes the
//! line into a copy of its step. The copy must compile, and must draw the same picture that a page
//! of the book draws with this line.

use crate::lines::cure_line;
use course::{
    Place, Step, all_listed_places, cargo_command, crate_as_module, dependencies_of_step_copies,
    target_folder, workspace,
};
use page::expressions::{compile_line, draw_step_of_first_line};
use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

/// The beginning of the manifest of the program that contains the copies of steps. The rest is the
/// dependencies, which `dependencies_of_step_copies` returns.
const MANIFEST: &str = r#"
workspace = {}
package = { name = "lines", edition = "2024" }
profile.dev = { debug = false, incremental = false }
"#;

/// The beginning of the program's main.rs. For each line, the test appends a module, and a call of
/// `print_hash`.
const MAIN: &str = "#![allow(warnings)]
use std::hash::{DefaultHasher, Hash, Hasher};

fn print_hash(picture: image::RgbImage) {
    let mut hasher = DefaultHasher::new();
    picture.as_raw().hash(&mut hasher);
    println!(\"{}\", hasher.finish());
}
";

const COLUMNS: u32 = 64;

/// Returns the accepted lines that draw a picture, without duplicates. Each line comes with its
/// place and the hash of its picture.
fn accepted_lines_with_hashes() -> Vec<(Place, String, u64)> {
    let mut known_lines = BTreeSet::new();
    let lines = include_str!("lines.txt").lines().filter_map(|line| {
        let (name, text) = line.split_once(' ')?;
        let place = all_listed_places().into_iter().find(|place| place.name == name)?;
        let text = cure_line(&place, text);
        let line = compile_line(&place, &text).ok()?;
        let picture = draw_step_of_first_line(&[line], COLUMNS, u64::MAX).ok()?;
        let mut hasher = DefaultHasher::new();
        picture.as_raw().hash(&mut hasher);
        known_lines.insert(format!("{name} {text}")).then(|| (place, text, hasher.finish()))
    });
    lines.collect()
}

/// Writes a copy of the step that contains `place`, as the module `module`. In the copy, `text`
/// replaces the code at the place.
fn write_step(source_folder: &Path, place: &Place, text: &str, module: &str) {
    let step = place.step().name();
    let folder = source_folder.join(module);
    fs::create_dir_all(&folder).expect("the folder can be created");
    for file in
        workspace().join("steps").join(step).join("src").read_dir().expect("the folder can be read")
    {
        let path = file.expect("the folder can be read").path();
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        let mut code = fs::read_to_string(&path).expect("the file can be read");
        if place.file == format!("{step}/src/{name}") {
            let range = place.find_range(&code).expect("the place");
            code.replace_range(range, text);
        }
        let name = if name == "lib.rs" { "mod.rs" } else { name };
        fs::write(folder.join(name), crate_as_module(&code, module, []))
            .expect("the file can be written");
    }
}

#[test]
#[ignore = "compiles sixty copies of steps"]
fn accepted_lines_draw_the_same_picture_in_their_steps() {
    let folder = target_folder().join("lines");
    let _ = fs::remove_dir_all(folder.join("src"));
    let manifest = MANIFEST.to_owned() + &dependencies_of_step_copies();
    let (mut modules, mut calls) = (String::new(), String::new());
    let lines = accepted_lines_with_hashes();
    for (index, (place, text, _)) in lines.iter().enumerate() {
        let module = format!("m{index}");
        write_step(&folder.join("src"), place, text, &module);
        modules += &format!("mod {module};\n");
        // A copy of step 1 defines its own `Camera`. The copies of other steps use the `Camera` in
        // the crate `step01_rays`.
        let owner = if place.step() == Step::Rays { &module } else { "step01_rays" };
        let camera = format!("{owner}::Camera::new({COLUMNS}, 36, 60_f64.to_radians())");
        calls += &format!("print_hash({module}::picture(&{camera}, 1));\n");
    }
    let main = format!("{MAIN}\n{modules}\nfn main() {{\n{calls}}}\n");
    fs::write(folder.join("src/main.rs"), main).expect("the file can be written");
    fs::write(folder.join("Cargo.toml"), manifest).expect("the file can be written");
    fs::copy(workspace().join("Cargo.lock"), folder.join("Cargo.lock"))
        .expect("the lock file can be copied");
    let mut cargo = cargo_command();
    cargo.args(["run", "--quiet", "--offline", "--message-format=short", "--target-dir=target"]);
    let output = cargo.current_dir(&folder).output().expect("cargo runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}\nin {}", folder.display());
    let hashes = String::from_utf8_lossy(&output.stdout);
    let hashes: Vec<_> = hashes.lines().collect();
    assert_eq!(hashes.len(), lines.len());
    for ((place, text, expected), hash) in lines.iter().zip(hashes) {
        assert_eq!(hash, expected.to_string(), "{}: {text}", place.name);
    }
}
