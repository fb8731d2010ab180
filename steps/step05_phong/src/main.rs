//! Draws step 5: the scene in the light of the whole Phong sum.

use std::process::ExitCode;

fn main() -> ExitCode {
    step05_phong::run(env!("CARGO_PKG_NAME"), step05_phong::picture)
}
