use anyhow::{Context, Result};
use std::path::Path;
use std::{env, fs};

/// Draws the pictures of the gallery of mistakes into `folder`; returns their names.
pub fn draw(folder: &Path) -> Result<Vec<String>> {
    let program = env::current_exe().and_then(fs::metadata);
    let built = program.and_then(|program| program.modified()).ok();
    ::gallery::draw(folder, built)
        .with_context(|| format!("no gallery in {}", folder.display()))
}
