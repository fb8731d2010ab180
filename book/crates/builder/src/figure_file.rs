//! The drawings as separate SVG files, for slides.

use anyhow::Result;
use figures::{Content, FIGURES};
use std::fs;
use std::path::Path;

/// Returns all drawings, with default parameters, as SVG files such as `figure-row.svg`. Each file
/// contains the theme's styles for drawings, in light colours.
pub fn svg_files_of_drawings(workspace: &Path) -> Result<Vec<(String, Vec<u8>)>> {
    let read = |file| fs::read_to_string(workspace.join("book/theme/css").join(file));
    let style = drawing_rules_without_variables(&read("drawing.css")?, &read("variables.css")?);
    let files = FIGURES.iter().filter_map(|figure| {
        let Content::Drawing { title, .. } = figure.content else { return None };
        let html = figure.draw(&figure.default_values())?.html(title);
        // Leave room on both sides, because a program without our fonts may use wider letters.
        let svg = html
            .replacen("\"0 0 480", "\"-24 0 528", 1)
            .replacen("<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"", 1)
            .replacen("<g>", &format!("<style>{style}</style><g>"), 1);
        Some((format!("figure-{}.svg", figure.name), svg.into_bytes()))
    });
    Ok(files.collect())
}

/// Returns the CSS rules in `stylesheet` that begin with `.drawing `, without that class. Replaces
/// CSS variables with their values in the light theme, since few programs other than browsers
/// support CSS variables.
fn drawing_rules_without_variables(stylesheet: &str, variables: &str) -> String {
    let rules = stylesheet.lines().filter(|rule| rule.starts_with(".drawing "));
    let mut style: String = rules.map(|rule| rule.replace(".drawing ", "")).collect();
    let lines = variables.lines().map(str::trim);
    for (name, value) in lines.filter_map(|line| line.strip_suffix(';')?.split_once(": ")) {
        let light_value =
            value.strip_prefix("light-dark(").and_then(|values| values.split(", ").next());
        style = style.replace(&format!("var({name})"), light_value.unwrap_or(value));
    }
    style
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn style_has_the_rules_of_drawings_with_values_in_place_of_variables() {
        let rules = ".drawing .ray { stroke: var(--ray); }\nbody { color: var(--text); }\n";
        let variables = ":root {\n    --ray: light-dark(#123, #456);\n}\n";
        assert_eq!(drawing_rules_without_variables(rules, variables), ".ray { stroke: #123; }");
        let plain =
            drawing_rules_without_variables(".drawing text { fill: var(--a); }", "--a: red;");
        assert_eq!(plain, "text { fill: red; }");
    }
}
