use crate::mistakes;
use std::path::Path;
use std::time::SystemTime;
use std::{fs, io};

/// Draws the pictures of the gallery, as the book shows them, into `folder`, and
/// returns their names.
///
/// Those that are newer than the program, which was built at `built`, are right
/// already; where that time is unknown, none is.
pub fn draw(folder: &Path, built: Option<SystemTime>) -> io::Result<Vec<String>> {
    let mut names = vec![];
    for mistake in mistakes() {
        for (step, name) in mistake.shown() {
            let name = format!("{name}.png");
            let path = folder.join(&name);
            let drawn = fs::metadata(&path).and_then(|file| file.modified());
            if !drawn.is_ok_and(|drawn| built.is_some_and(|built| built < drawn)) {
                // Whole, or not at all: it will not be drawn again.
                let part = folder.join(format!("part-{name}"));
                let saved = mistake.show(step).save(&part);
                saved.map_err(|error| {
                    io::Error::other(format!("{}: {error}", part.display()))
                })?;
                fs::rename(&part, &path)?;
            }
            names.push(name);
        }
    }
    Ok(names)
}
