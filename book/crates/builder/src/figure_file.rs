//! The drawings as SVG files of their own, for slides.

use anyhow::Result;
use figures::{FIGURES, Output};
use std::fs;
use std::path::Path;

/// All drawings with their default parameters, as SVG files such as `figure-row.svg`. Each contains
/// the rules of the theme, in its light colours.
pub fn svg_files(workspace: &Path) -> Result<Vec<(String, Vec<u8>)>> {
    let read = |file| fs::read_to_string(workspace.join("book/theme/css").join(file));
    let style = standalone_style(&read("drawing.css")?, &read("variables.css")?);
    // Pictures, which have no title, are left out: they take long to draw.
    let figures = FIGURES.iter().filter(|figure| !figure.title.is_empty());
    let files = figures.filter_map(|figure| {
        let Output::Drawing(drawing) = figure.default_output() else { return None };
        let svg = drawing.html(figure.title);
        // Leave room on both sides, since the program that shows it may use a wider font.
        let svg = svg.replacen("\"0 0 480", "\"-24 0 528", 1);
        let svg = svg.replacen("<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"", 1);
        let svg = svg.replacen("<g>", &format!("<style>{style}</style><g>"), 1);
        Some((format!("figure-{}.svg", figure.name), svg.into_bytes()))
    });
    Ok(files.collect())
}

/// The rules that begin with `.drawing `, without that class. Variables are replaced by their
/// values, since few programs except browsers support them.
fn standalone_style(rules: &str, variables: &str) -> String {
    let rules = rules.lines().filter(|rule| rule.starts_with(".drawing "));
    let mut style: String = rules.map(|rule| rule.replace(".drawing ", "")).collect();
    let lines = variables.lines().map(str::trim);
    for (name, value) in lines.filter_map(|line| line.strip_suffix(';')?.split_once(": ")) {
        let light = value.strip_prefix("light-dark(").and_then(|both| both.split(", ").next());
        style = style.replace(&format!("var({name})"), light.unwrap_or(value));
    }
    style
}
