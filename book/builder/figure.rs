use crate::controls;
use crate::markdown::inline_html;
use live::{LIVE, Live, Sight};

/// The HTML of the figure called `name`.
pub fn html(name: &str) -> Result<String, String> {
    let Some((figure, Sight::Drawing(drawing))) =
        live::find(name).map(|figure| (figure, figure.printed()))
    else {
        return Err(format!("there is no figure {name}"));
    };
    let beside = |live: &&Live| live.beside.is_some_and(|(with, _)| with == name);
    let (live, knobs) = match LIVE.iter().find(beside) {
        Some(live) => (format!(" data-beside=\"{}\"", live.name), String::new()),
        None if figure.knobs.is_empty() => Default::default(),
        None => (format!(" data-live=\"{name}\""), controls::html(figure)),
    };
    Ok(format!(
        "<figure class=\"drawing\" id=\"figure-{name}\"{live}>{}{knobs}\
         <figcaption>{}</figcaption></figure>\n",
        drawing.html(figure.title),
        inline_html(figure.caption)?
    ))
}
