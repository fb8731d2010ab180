//! The HTML of a figure that is a drawing.

use crate::controls;
use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::inline_html;
use crate::values::Values;
use figures::Output;

/// The HTML of the figure called `name`.
pub fn html(name: &str, values: &Values) -> ChapterResult<String> {
    let Some((figure, Output::Drawing(drawing))) =
        figures::find(name).map(|figure| (figure, figure.default_output()))
    else {
        return Err(ChapterError::UnknownFigure(name.to_owned()));
    };
    let (live, controls) = match figure.followed {
        Some(followed) => (format!(" data-companion=\"{followed}\""), String::new()),
        None if figure.parameters.is_empty() => Default::default(),
        None => (format!(" data-live=\"{name}\""), controls::html(figure)),
    };
    Ok(format!(
        "<figure class=\"drawing\" id=\"figure-{name}\"{live}>{}{controls}\
         <figcaption>{}</figcaption></figure>\n",
        drawing.html(figure.title),
        inline_html(figure.caption, values)?
    ))
}
