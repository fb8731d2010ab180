use figures::Figure;
use step03_nearest::OBJECTS;

/// The text about a pixel, with a number for each `{{#number name}}`. A line that
/// begins with `45` is for the pictures of these steps.
const TEXT: &str = include_str!("pixel_trace_template.md");

/// The same for the picture with mirrors.
const MIRROR_TEXT: &str = include_str!("mirror_trace_template.md");

/// The numbers of a sphere, in the columns of its row.
const COLUMNS: [&str; 6] = ["a", "b", "c", "D", "near", "far"];

/// The numbers of a hit of a mirrored ray, in the columns of its row.
const MIRROR_COLUMNS: [&str; 4] = ["object", "t", "k", "I"];

/// The rows of what a ray meets: the example `mirror` allows ten mirrors.
const MIRROR_ROWS: usize = 11;

/// Markdown of everything on the way from a pixel to its three bytes, of the one that the
/// reader of the page asks.
pub fn panel_markdown(live: &Figure) -> String {
    let name = live.name;
    let (text, rows): (_, Vec<_>) = if name == "mirror" {
        let rows = (0..MIRROR_ROWS).map(|k| row_markdown(&MIRROR_COLUMNS, k));
        (MIRROR_TEXT.to_owned(), rows.collect())
    } else {
        let lines = TEXT.lines().filter_map(|line| line_for_step(name, line));
        let count = if name.starts_with("step02") { 1 } else { OBJECTS.len() };
        let spheres = OBJECTS.iter().take(count).enumerate().map(|(k, object)| {
            let name = figures::short_name(object.name);
            format!("| {name} {}", row_markdown(&COLUMNS, k))
        });
        (lines.collect::<Vec<_>>().join("\n"), spheres.collect())
    };
    let text = text.replace("{{#rows}}", &rows.join("\n"));
    let text = text.replace("{{#number ", &format!("{{{{#number {name}:"));
    text.replace("NAME:", &format!("{name}:"))
}

/// The box with that text below a picture whose pixels can be asked.
///
/// Hidden where no script can answer; see book/theme/figure.js.
pub fn panel_html(live: &Figure, text: &str) -> String {
    format!(
        "<details data-panel=\"{}\" class=\"aside\" hidden>\
         <summary><span class=\"kind\">This pixel</span></summary>\n\n{text}\n</details>\n",
        live.name
    )
}

/// A line as it is for the picture of a step; None where it is for other steps.
fn line_for_step<'a>(name: &str, line: &'a str) -> Option<&'a str> {
    match line.split_once(' ').filter(|(steps, _)| steps.parse::<u32>().is_ok()) {
        Some((steps, rest)) => steps.contains(name.get(5..6)?).then_some(rest),
        None => Some(line),
    }
}

/// A row of these numbers, number `k` of the table.
fn row_markdown(columns: &[&str], k: usize) -> String {
    let cells: Vec<_> =
        columns.iter().map(|column| format!("{{{{#number {column}{k}}}}}")).collect();
    format!("| {} |", cells.join(" | "))
}
