use crate::markdown::inline;

/// The HTML of the figure called `name`.
pub fn html(name: &str) -> Result<String, String> {
    let figure = live::figure(name).ok_or(format!("there is no figure {name}"))?;
    let live = live::find(name)
        .map_or(String::new(), |live| format!(" data-live=\"{}\"", live.name));
    Ok(format!(
        "<figure class=\"drawing\" id=\"figure-{name}\"{live}>{}<figcaption>{}</figcaption></figure>\n",
        figure.drawing.html(figure.title),
        inline(figure.caption)?
    ))
}
