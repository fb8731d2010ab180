//! The HTML of a figure that is a drawing.

use crate::controls;
use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::inline_html;
use crate::values::Values;
use figures::{Content, find_figure};

/// Returns the HTML of the drawing called `name`, with its caption. A drawing that has parameters
/// of its own also gets controls.
pub fn drawing_html(name: &str, values: &Values) -> ChapterResult<String> {
    let unknown = || ChapterError::UnknownFigure(name.to_owned());
    let figure = find_figure(name).ok_or_else(unknown)?;
    let Content::Drawing { title, caption, .. } = figure.content else { return Err(unknown()) };
    let drawing = figure.draw(&figure.default_values()).ok_or_else(unknown)?;
    let (live, controls) = match figure.values_from {
        Some(figure_name) => (format!(" data-companion=\"{figure_name}\""), String::new()),
        None if figure.parameters.is_empty() => Default::default(),
        None => (format!(" data-live=\"{name}\""), controls::controls_html(figure)),
    };
    Ok(format!(
        "<figure class=\"drawing\" id=\"figure-{name}\"{live}>{}{controls}\
         <figcaption>{}</figcaption></figure>\n",
        drawing.html(title),
        inline_html(caption, values)?
    ))
}
