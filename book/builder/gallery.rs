use ::gallery::mistakes;
use anyhow::{Context, Result};
use std::path::Path;
use std::time::SystemTime;
use std::{env, fs};
use step01_rays::Camera;

/// Draws the pictures of the gallery of mistakes into `folder`; returns their names.
///
/// Those that are newer than this program are right already.
pub fn draw(folder: &Path) -> Result<Vec<String>> {
    let program = env::current_exe().and_then(|path| modified(&path)).ok();
    let camera = Camera::new(320, 180, 60_f64.to_radians());
    let mut names = vec![];
    for mistake in mistakes() {
        for (step, name) in mistake.shown() {
            let name = format!("{name}.png");
            let path = folder.join(&name);
            let drawn = modified(&path).ok();
            if drawn.is_none() || drawn <= program {
                let picture = mistake.picture_in(step, &camera, 2);
                // Whole, or not at all: it will not be drawn again.
                let part = folder.join(format!("part-{name}"));
                picture.save(&part).with_context(|| name.clone())?;
                fs::rename(&part, &path).with_context(|| name.clone())?;
            }
            names.push(name);
        }
    }
    Ok(names)
}

fn modified(path: &Path) -> std::io::Result<SystemTime> {
    fs::metadata(path)?.modified()
}
