use crate::controls;
use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::inline_html;
use crate::sources::Sources;
use course::mistakes;
use figures::{Figure, escape};

/// Attribute that makes a picture load when it comes into view.
pub const LAZY: &str = r#" loading="lazy""#;

/// A picture as a chapter asks for it: `![what it shows](generated/name.png "Caption")`, without
/// its caption; what a mistake's picture shows, the list of mistakes says.
pub fn markdown_html(markdown: &str, source: &str, sources: &Sources) -> ChapterResult<String> {
    // The caption may hold links of its own; the alt text ends before the first.
    let end = format!("]({source}");
    let alt = markdown.trim_start_matches("![").split(&end);
    let alt: Vec<_> = alt.take(1).flat_map(str::split_whitespace).collect();
    html(&effect_of_picture(source).unwrap_or(alt.join(" ")), source, sources)
}

/// The sentence of the list about the picture of a mistake; None for any other picture.
fn effect_of_picture(source: &str) -> Option<String> {
    let name = source.strip_prefix("generated/mistake-")?.strip_suffix(".png")?;
    let all = mistakes();
    let mistake = all.iter().find(|one| one.pictures.iter().any(|(known, _)| *known == name))?;
    Some(mistake.effect.replace('`', ""))
}

/// A picture with this alt text, in its size; it loads when it comes into view.
pub fn html(alt: &str, source: &str, sources: &Sources) -> ChapterResult<String> {
    if alt.is_empty() {
        return Err(ChapterError::MissingAltText(source.to_owned()));
    }
    if alt.contains("{{#") {
        return Err(ChapterError::DirectiveInAltText(source.to_owned()));
    }
    let size = sources.picture_size(source);
    let (width, height) = size.ok_or_else(|| ChapterError::UnknownPicture(source.to_owned()))?;
    Ok(format!(
        r#"<img src="{}" alt="{}" width="{width}" height="{height}"{LAZY}>"#,
        escape(source),
        escape(alt)
    ))
}

/// A figure of an image with its caption in Markdown, in which what is `live` answers.
pub fn figure_html(image: &str, caption: &str, live: Option<&Figure>) -> ChapterResult<String> {
    let data = live.map_or(String::new(), |live| format!(" data-live=\"{}\"", live.name));
    let controls_html = live.map_or(String::new(), controls::html);
    let caption = match caption {
        "" => String::new(),
        markdown => format!("<figcaption>{}</figcaption>", inline_html(markdown)?),
    };
    Ok(format!("<figure class=\"picture\"{data}>{image}{controls_html}{caption}</figure>\n"))
}
