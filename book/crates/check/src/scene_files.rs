use crate::{Answer, Verdict, escape_for_terminal, read_bounded_file};
use course::{NAMED_SCENE_EXAMPLE, draw_named_scene};
use std::fs;
use std::path::Path;

/// Writes the program of the scene of a name.
pub fn write_scene(name: &str, file: &Path) -> Result<Answer, String> {
    let path = escape_for_terminal(&file.display().to_string());
    let written = fs::write(file, draw_named_scene(name).0);
    written.map_err(|error| format!("{path} can't be written: {error}"))?;
    Ok(Answer::new(Verdict::Right, format!("{}: {path}", escape_for_terminal(name))))
}

/// The names in a list, one a line.
pub fn read_names(list: &Path) -> Result<Vec<String>, String> {
    let text = String::from_utf8(read_bounded_file(list)?);
    let text = text.map_err(|_| format!("{} is not in UTF-8", list.display()))?;
    let names = text.trim_start_matches('\u{feff}').lines().map(str::trim);
    Ok(names.filter(|name| !name.is_empty()).map(str::to_owned).collect())
}

/// Writes the program of the scene of each name, into a folder of this name.
pub fn write_scenes(names: &[String], folder: &Path) -> Result<Answer, String> {
    let mut lines = vec![];
    for name in names {
        let is_odd = |c: char| c.is_control() || "./\\:*?\"<>|".contains(c);
        let folder = folder.join(name.replace(is_odd, "_"));
        fs::create_dir_all(&folder)
            .map_err(|error| format!("{} can't be made: {error}", folder.display()))?;
        let file = folder.join(NAMED_SCENE_EXAMPLE).with_extension("rs");
        lines.push(write_scene(name, &file)?.text);
    }
    Ok(Answer::new(Verdict::Right, lines.join("\n")))
}
