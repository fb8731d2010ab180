//! The dependencies of a program that contains copies of the steps.

use crate::{Step, workspace};

/// Returns the `[dependencies]` section of a generated program that contains copies of the steps.
/// The section lists the original steps, and the libraries that the copies use. All versions are
/// `*`: a copy of our Cargo.lock comes with the program, and pins the versions.
pub fn dependencies_of_step_copies() -> String {
    let mut dependencies = r#"
[dependencies]
clap = { version = "*", default-features = false }
glam = { version = "*", default-features = false }
image = { version = "*", default-features = false }
rayon = "*"
"#
    .to_owned();
    for step in Step::NAMES {
        let path = workspace().join("steps").join(step);
        dependencies += &format!("{step} = {{ path = {path:?} }}\n");
    }
    dependencies
}
