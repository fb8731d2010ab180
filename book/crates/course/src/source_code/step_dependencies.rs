//! The dependencies of a program that contains copies of the steps.

use crate::{Step, workspace};

/// The `[dependencies]` section for a generated program that contains copies of the steps: the
/// libraries that these copies use, and the original steps. The versions are `*`, because the
/// program also gets a copy of the course's Cargo.lock, which pins them.
pub fn step_dependencies() -> String {
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
