//! Draws step 2: one sphere before step 1's picture.

use std::process::ExitCode;

fn main() -> ExitCode {
    step02_sphere::run(env!("CARGO_PKG_NAME"), step02_sphere::picture)
}
