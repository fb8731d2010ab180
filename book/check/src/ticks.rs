use crate::{Answer, Locked, check};
use std::fs;
use std::path::Path;

/// The page to tick off: every picture of the course that there may be in `folder`,
/// and whether it is right, not right, or not there.
///
/// The exit code is 0 if those that are there are right, 1 if one is not, and 2 if none
/// is there.
pub fn ticks(folder: &Path, locked: &[Locked]) -> Answer {
    let width = locked.iter().map(|one| one.name.len()).max().unwrap_or(0) + 2;
    let (mut text, mut right, mut worst) = (String::new(), 0, None);
    for Locked { name, .. } in locked {
        let file = format!("{name}.png");
        let told = match fs::read(folder.join(&file)) {
            Err(_) => "not there".to_owned(),
            Ok(png) => {
                let Answer { code, text, .. } =
                    check(&png, &file, Some(name), locked);
                worst = worst.max(Some(code.min(1)));
                right += usize::from(code == 0);
                match code {
                    0 => "right".to_owned(),
                    _ => format!("not right: {}", why(&text)),
                }
            }
        };
        text += &format!("{name:width$}{told}\n");
    }
    text += &format!("{right} of {} are right.", locked.len());
    Answer::new(worst.unwrap_or(2), text)
}

/// One line of an answer: the first, without what the table says itself.
fn why(text: &str) -> &str {
    let line = text.lines().next().unwrap_or_default();
    let starts = ["Not right: ", "Not right yet, ", "error: "];
    starts.iter().find_map(|start| line.strip_prefix(start)).unwrap_or(line)
}
