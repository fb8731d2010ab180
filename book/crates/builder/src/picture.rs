use crate::controls;
use crate::markdown::inline_html;
use crate::mistake_list::effect_of_picture;
use crate::sources::Sources;
use figures::{Figure, escape};

/// Attribute that makes a picture load when it comes into view.
pub const LAZY: &str = r#" loading="lazy""#;

/// A picture as a chapter asks for it: `![what it shows](generated/name.png
/// "Caption")`.
#[derive(Debug)]
pub struct Picture {
    alt: String,
    source: String,
    caption: String,
}

impl Picture {
    /// Takes the alt text from the Markdown of the picture; what a mistake's picture shows, the
    /// list of mistakes says.
    pub fn from_markdown(markdown: &str, source: &str, caption: &str) -> Self {
        // The caption may hold links of its own; the alt text ends before the first.
        let end = format!("]({source}");
        let alt = markdown.trim_start_matches("![").split(&end);
        let alt: Vec<_> = alt.take(1).flat_map(str::split_whitespace).collect();
        let alt = effect_of_picture(source).unwrap_or(alt.join(" "));
        let (source, caption) = (source.to_string(), caption.to_string());
        Self { alt, source, caption }
    }

    /// A picture without a caption.
    pub fn without_caption(alt: &str, source: &str) -> Self {
        let (alt, source) = (alt.to_owned(), source.to_owned());
        Self { alt, source, caption: String::new() }
    }

    /// The picture alone, in its size; it loads when it comes into view.
    pub fn html(&self, sources: &Sources) -> Result<String, String> {
        let Self { alt, source, .. } = self;
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
}

/// A figure of the pictures of a paragraph, side by side if there are several. Where a picture
/// is `live`, what is so called answers in it, and what `panel_html` says of a pixel stands below.
pub fn figures_html(
    pictures: &[Picture],
    live: Option<&str>,
    sources: &Sources,
    panel_html: &dyn Fn(&Figure) -> Result<String, String>,
) -> Result<String, String> {
    let mut figures = String::new();
    for picture in pictures {
        let image = picture.html(sources)?;
        let (mut data, mut controls_html, mut below) = Default::default();
        if let Some(name) = live {
            let answers = figures::find(name).ok_or(format!("nothing called {name:?} answers"))?;
            data = format!(" data-live=\"{}\"", answers.name);
            controls_html = controls::html(answers);
            if answers.has_probe() {
                below = panel_html(answers)?;
            }
        }
        let caption = match picture.caption.as_str() {
            "" => String::new(),
            markdown => {
                format!("<figcaption>{}</figcaption>", inline_html(markdown)?)
            }
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
