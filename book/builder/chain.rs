use crate::draft::expand;
use std::path::Path;

/// What is said of a pixel, with a number for each `{{#number name}}`.
const TEXT: &str = include_str!("chain.md");

/// The numbers of a sphere, in the columns of its row.
const COLUMNS: [&str; 6] = ["a", "b", "c", "D", "near", "far"];

/// The box for `{{#chain name}}`: everything on the way from a pixel to its three
/// bytes, of the pixel that the reader of the page asks.
///
/// It is hidden until the first is asked; see book/theme/live.js.
pub fn html(name: &str, workspace: &Path) -> Result<String, String> {
    let rows: Vec<_> = live::OBJECTS.into_iter().enumerate().map(row).collect();
    let text = TEXT.replace("{{#spheres}}", &rows.join("\n"));
    let text = text.replace("{{#number ", &format!("{{{{#number {name}:"));
    let chain = expand(&text, workspace);
    if let Some((_, what)) = chain.faults.first() {
        return Err(format!("the chain of {name}: {what}"));
    }
    Ok(format!(
        "<details data-chain=\"{name}\" class=\"aside\" open hidden>\
         <summary><span class=\"kind\">This pixel</span></summary>\n\n{}\n</details>\n",
        chain.markdown
    ))
}

/// The row of one object.
fn row((k, name): (usize, &str)) -> String {
    let cells: Vec<_> = COLUMNS
        .iter()
        .map(|column| format!("{{{{#number {column}{k}}}}}"))
        .collect();
    format!("| {name} | {} |", cells.join(" | "))
}
