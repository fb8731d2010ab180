//! Draws step 4: the scene in ambient and diffuse light.

use std::process::ExitCode;

fn main() -> ExitCode {
    step04_diffuse::run(env!("CARGO_PKG_NAME"), step04_diffuse::picture)
}
