use crate::controls;
use crate::markdown::inline_html;
use crate::mistake_list::effect_of_picture;
use crate::sources::Sources;
use figures::{Figure, escape};

/// Attribute that makes a picture load when it comes into view.
pub const LAZY: &str = r#" loading="lazy""#;

/// A picture as a chapter asks for it: `![what it shows](generated/name.png "Caption")`, without
/// its caption; what a mistake's picture shows, the list of mistakes says.
pub fn markdown_html(markdown: &str, source: &str, sources: &Sources) -> Result<String, String> {
    // The caption may hold links of its own; the alt text ends before the first.
    let end = format!("]({source}");
    let alt = markdown.trim_start_matches("![").split(&end);
    let alt: Vec<_> = alt.take(1).flat_map(str::split_whitespace).collect();
    html(&effect_of_picture(source).unwrap_or(alt.join(" ")), source, sources)
}

/// A picture with this alt text, in its size; it loads when it comes into view.
pub fn html(alt: &str, source: &str, sources: &Sources) -> Result<String, String> {
    if alt.is_empty() {
        return Err(format!("the picture {source} has no alt text: say what it shows"));
    }
    if alt.contains("{{#") {
        return Err(format!("the alt text of {source} is words alone, without directives"));
    }
    let (width, height) =
        sources.picture_size(source).ok_or(format!("there is no picture {source}"))?;
    Ok(format!(
        r#"<img src="{}" alt="{}" width="{width}" height="{height}"{LAZY}>"#,
        escape(source),
        escape(alt)
    ))
}

/// A figure of the pictures of a paragraph, each with its caption in Markdown, side by side if
/// there are several. Where a picture is `live`, what is so called answers in it, and what
/// `panel_html` says of a pixel stands below.
pub fn figures_html(
    pictures: &[(Result<String, String>, String)],
    live: Option<&str>,
    panel_html: &dyn Fn(&Figure) -> Result<String, String>,
) -> Result<String, String> {
    let mut figures = String::new();
    for (image, caption) in pictures {
        let image = image.clone()?;
        let (mut data, mut controls_html, mut below) = Default::default();
        if let Some(name) = live {
            let answers = figures::find(name).ok_or(format!("nothing called {name:?} answers"))?;
            data = format!(" data-live=\"{}\"", answers.name);
            controls_html = controls::html(answers);
            if answers.has_probe() {
                below = panel_html(answers)?;
            }
        }
        let caption = match caption.as_str() {
            "" => String::new(),
            markdown => format!("<figcaption>{}</figcaption>", inline_html(markdown)?),
        };
        figures += &format!(
            "<figure class=\"picture\"{data}>{image}{controls_html}{caption}</figure>\n{below}"
        );
    }
    Ok(match pictures {
        [_] => figures,
        // A reader view of a browser takes a `div` of pictures for decoration.
        _ => format!("<section class=\"pictures\">\n{figures}</section>\n"),
    })
}
