use crate::chapter::expand_directives;
use live::Live;
use std::path::Path;
use step03_nearest::OBJECTS;

/// The text about a pixel, with a number for each `{{#number name}}`. A line that
/// begins with `2-4` is for the pictures of these steps.
pub const TEXT: &str = include_str!("pixel_panel.md");

/// The numbers of a sphere, in the columns of its row.
const COLUMNS: [&str; 6] = ["a", "b", "c", "D", "near", "far"];

/// The box below a picture whose pixels can be asked: everything on the way from a
/// pixel to its three bytes, of the one that the reader of the page asks.
///
/// Hidden until the first is asked; see book/theme/live.js.
pub fn html(live: &Live, workspace: &Path) -> Result<String, String> {
    let name = live.name;
    let count = if name.starts_with("step02") { 1 } else { OBJECTS.len() };
    let names = OBJECTS.iter().map(|object| live::short_name(object.name));
    let rows: Vec<_> =
        names.take(count).enumerate().map(object_row_markdown).collect();
    let lines: Vec<_> =
        TEXT.lines().filter_map(|line| line_for_step(name, line)).collect();
    let text = lines.join("\n").replace("{{#spheres}}", &rows.join("\n"));
    let text = text.replace("{{#number ", &format!("{{{{#number {name}:"));
    let text = text.replace("NAME:", &format!("{name}:"));
    let (markdown, faults) = expand_directives(&text, workspace);
    if let Some((_, what)) = faults.first() {
        return Err(format!("this pixel of {name}: {what}"));
    }
    Ok(format!(
        "<details data-panel=\"{name}\" class=\"aside\" open hidden>\
         <summary><span class=\"kind\">This pixel</span></summary>\n\n{markdown}\n</details>\n"
    ))
}

/// A line as it is for the picture of a step; None where it is for other steps.
fn line_for_step<'a>(name: &str, line: &'a str) -> Option<&'a str> {
    let steps = line.split_once(' ').and_then(|(steps, rest)| {
        let (first, last) = steps.split_once('-')?;
        Some((first.parse::<u32>().ok()?..=last.parse().ok()?, rest))
    });
    let Some((steps, rest)) = steps else { return Some(line) };
    let step = name.strip_prefix("step")?.get(..2)?.parse().ok()?;
    steps.contains(&step).then_some(rest)
}

/// The row of one object.
fn object_row_markdown((k, name): (usize, &str)) -> String {
    let cells: Vec<_> = COLUMNS
        .iter()
        .map(|column| format!("{{{{#number {column}{k}}}}}"))
        .collect();
    format!("| {name} | {} |", cells.join(" | "))
}
