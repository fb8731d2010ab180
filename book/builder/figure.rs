use crate::controls;
use crate::markdown::inline;
use live::Live;

/// The HTML of the figure called `name`.
pub fn html(name: &str) -> Result<String, String> {
    let figure = live::figure(name).ok_or(format!("there is no figure {name}"))?;
    let beside = |live: &&&Live| live.beside.is_some_and(|(with, _)| with == name);
    let (live, knobs) = match (live::find(name), live::LIVE.iter().find(beside)) {
        (Some(live), _) => {
            (format!(" data-live=\"{}\"", live.name), controls::html(live))
        }
        (_, Some(live)) => {
            (format!(" data-beside=\"{}\"", live.name), String::new())
        }
        _ => Default::default(),
    };
    Ok(format!(
        "<figure class=\"drawing\" id=\"figure-{name}\"{live}>{}{knobs}\
         <figcaption>{}</figcaption></figure>\n",
        figure.drawing.html(figure.title),
        inline(figure.caption)?
    ))
}
