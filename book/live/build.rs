//! Writes the example `mirror` anew, with an offset that can be set while it runs.

use std::error::Error;
use std::fs::{read_to_string, write};
use std::{env, path::Path};

const SHADOWS: &str = "../../steps/step04_diffuse/examples/shadows.rs";
const MIRROR: &str = "../../steps/step05_phong/examples/mirror.rs";

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::var("OUT_DIR")?;
    let path = |name| Path::new(&folder).join(name);
    let (constant, variable) = ("const OFFSET: f64 = 1e-9;", "use super::super::OFFSET;");
    let shadows = read_listing(SHADOWS, constant)?.replace(constant, variable);
    let shadows_path = path("shadows.rs");
    write(&shadows_path, shadows)?;
    let listed_path = "\"../../step04_diffuse/examples/shadows.rs\"";
    let mirror = read_listing(MIRROR, listed_path)?;
    let mirror = mirror.replace(listed_path, &format!("{shadows_path:?}"));
    // `include!` takes no inner documentation.
    Ok(write(path("mirror.rs"), mirror.replace("//!", "//"))?)
}

/// Reads a listing, which must have this part.
fn read_listing(path: &str, part: &str) -> Result<String, Box<dyn Error>> {
    println!("cargo::rerun-if-changed={path}");
    let text = read_to_string(path)?;
    if text.contains(part) { Ok(text) } else { Err(format!("{path} has no {part}").into()) }
}
