//! Pictures: their alt text, their size, when they are loaded, and the figure around them.

use crate::controls;
use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::inline_html;
use crate::sources::Sources;
use crate::values::Values;
use course::{escape_html, mistakes};
use figures::Figure;
use std::mem;

/// The value of the attribute `sizes`, for a picture that comes in several sizes. This value tells
/// the browser how wide the picture will be. In a wide window, the picture is as wide as the text.
/// In a narrow window, the picture is as wide as the window without the gutters. The widths are in
/// pixels, because a rem in this attribute depends on the browser's default font size, not on the
/// page's font size.
const WIDTH_ON_PAGE: &str = "(min-width: 730px) 684px, calc(100vw - 43px)";

/// How a picture reacts to a reader.
#[derive(Clone, Copy)]
pub enum Interaction<'a> {
    /// The picture becomes interactive as soon as it comes near the viewport. The picture has all
    /// handles and controls of the figure.
    Live(&'a Figure),
    /// The picture becomes interactive when a reader points at it or focuses it. The picture has no
    /// controls. If the figure has a probe, the picture has no other handle.
    Preview(&'a Figure),
}

/// When a browser loads a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadingTime {
    /// At once, before all other pictures. This is for the first picture on a page.
    AtOnce,
    /// When the picture comes into view.
    InView,
}

impl LoadingTime {
    /// Returns the loading time of the next picture on a page. Sets `self` to `InView` for all
    /// later pictures.
    pub fn take_for_next_picture(&mut self) -> Self {
        mem::replace(self, Self::InView)
    }

    /// The HTML attribute that makes a browser load a picture at this time.
    pub fn html_attribute(self) -> &'static str {
        match self {
            Self::AtOnce => r#"fetchpriority="high""#,
            Self::InView => r#"loading="lazy""#,
        }
    }
}

/// In the HTML of the page for printing, makes the browser load every picture at once. A picture
/// that is only loaded when it comes into view would be missing on paper.
pub fn remove_lazy_loading(html: &str) -> String {
    html.replace(&format!(" {}", LoadingTime::InView.html_attribute()), "")
}

/// Returns the HTML of a picture such as `![alt text](generated/name.png "Caption")`. The caption
/// is left out. If the picture shows a mistake, the alt text comes from the list of mistakes, not
/// from the Markdown.
pub fn image_html_from_markdown(
    markdown: &str,
    source: &str,
    sources: &Sources,
    loading: &mut LoadingTime,
) -> ChapterResult<String> {
    // The alt text ends at the first `](` before this address. The caption may contain another `](`
    // before the same address, in a link to the picture.
    let end = format!("]({source}");
    let alt = markdown.trim_start_matches("![").split(&end).next().unwrap_or_default();
    let alt_words: Vec<_> = alt.split_whitespace().collect();
    image_html(
        &mistake_effect_of_picture(source).unwrap_or(alt_words.join(" ")),
        source,
        sources,
        loading,
    )
}

/// If a picture shows a mistake, returns the mistake's effect on the picture, as described in the
/// list of mistakes. Returns None for any other picture.
fn mistake_effect_of_picture(source: &str) -> Option<String> {
    let name = source.strip_prefix("generated/mistake-")?.strip_suffix(".png")?;
    let all_mistakes = mistakes();
    let mut presentations = all_mistakes.iter().filter_map(|mistake| mistake.presentation.as_ref());
    let presentation = presentations
        .find(|presentation| presentation.pictures.iter().any(|picture| picture.name == name))?;
    Some(presentation.effect.replace('`', ""))
}

/// Returns the HTML of a picture, with this alt text and with the picture's width and height. If
/// the picture is the first on its page, the HTML also lists the smaller versions, so that a phone
/// can load one of those.
pub fn image_html(
    alt: &str,
    source: &str,
    sources: &Sources,
    loading: &mut LoadingTime,
) -> ChapterResult<String> {
    if alt.is_empty() {
        return Err(ChapterError::MissingAltText(source.to_owned()));
    }
    if alt.contains("{{#") {
        return Err(ChapterError::DirectiveInAltText(source.to_owned()));
    }
    let (width, height) = sources.picture_size(source).ok_or_else(|| {
        let source = source.to_owned();
        match mistake_effect_of_picture(&source) {
            Some(_) => ChapterError::UndrawnMistake(source),
            None => ChapterError::UnknownPicture(source),
        }
    })?;
    let loading = loading.take_for_next_picture();
    let smaller = match loading {
        LoadingTime::AtOnce => sources.smaller_versions(source),
        // The page doesn't wait for a picture that is out of view, so a large file does less harm.
        LoadingTime::InView => vec![],
    };
    let srcset = if smaller.is_empty() {
        String::new()
    } else {
        let own_size = (width, source.to_owned());
        let sizes = smaller.into_iter().chain([own_size]);
        let sizes: Vec<_> =
            sizes.map(|(columns, source)| format!("{} {columns}w", escape_html(&source))).collect();
        format!(r#" srcset="{}" sizes="{WIDTH_ON_PAGE}""#, sizes.join(", "))
    };
    Ok(format!(
        r#"<img src="{}"{srcset} alt="{}" width="{width}" height="{height}" {}>"#,
        escape_html(source),
        escape_html(alt),
        loading.html_attribute(),
    ))
}

/// Returns the HTML of a figure that contains a picture. `image` is the picture's HTML. `caption`
/// is Markdown, and may be empty. A live figure also gets controls, and a preview gets a hint.
pub fn figure_html(
    image: &str,
    caption: &str,
    interaction: Option<Interaction>,
    values: &Values,
) -> ChapterResult<String> {
    let (data, controls_html) = match interaction {
        None => Default::default(),
        Some(Interaction::Live(figure)) => {
            (format!(" data-live=\"{}\"", figure.name), controls::controls_html(figure))
        }
        Some(Interaction::Preview(figure)) => {
            (format!(" data-preview=\"{}\"", figure.name), controls::preview_hint_html(figure))
        }
    };
    let caption = match caption {
        "" => String::new(),
        markdown => format!("<figcaption>{}</figcaption>", inline_html(markdown, values)?),
    };
    Ok(format!("<figure class=\"picture\"{data}>{image}{controls_html}{caption}</figure>\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Page;
    use course::workspace;

    #[test]
    fn error_for_an_undrawn_mistake_names_the_command_that_draws_it() {
        let mut sources = Sources::read(&workspace()).expect("the sources can be read");
        let fault = |sources: &Sources, name: &str| {
            let source = format!("generated/{name}.png");
            let html = image_html("A picture.", &source, sources, &mut LoadingTime::AtOnce);
            html.err().map(|error| error.to_string())
        };
        assert_eq!(fault(&sources, "mistake-first-in-list"), None);
        sources.generated.0.remove("mistake-first-in-list.png");
        let drawn_later = fault(&sources, "mistake-first-in-list").expect("the picture is missing");
        assert!(drawn_later.contains("`cargo xtask`"), "{drawn_later}");
        let unknown = fault(&sources, "mistake-of-nobody").expect("the picture is missing");
        assert_eq!(unknown, "there is no picture generated/mistake-of-nobody.png");
    }

    #[test]
    fn only_the_first_picture_is_loaded_at_once() {
        let mut loading = LoadingTime::AtOnce;
        let order = [(); 3].map(|()| loading.take_for_next_picture());
        assert_eq!(order, [LoadingTime::AtOnce, LoadingTime::InView, LoadingTime::InView]);
    }

    #[test]
    fn only_the_cover_at_the_top_comes_in_several_sizes() {
        let sources = Sources::read(&workspace()).expect("the sources can be read");
        let srcset_of = |name: &str, mut loading: LoadingTime| {
            let source = format!("generated/{name}.png");
            let html = image_html("A picture.", &source, &sources, &mut loading);
            let html = html.expect("the picture exists");
            let page = Page::parse("a.html", &html);
            page.elements[0].attr("srcset").map(str::to_owned)
        };
        assert_eq!(
            srcset_of("cover", LoadingTime::AtOnce).as_deref(),
            Some(
                "generated/cover-720.png 720w, generated/cover-960.png 960w, \
                 generated/cover.png 1280w"
            )
        );
        assert_eq!(srcset_of("cover", LoadingTime::InView), None);
        assert_eq!(srcset_of("mirror", LoadingTime::AtOnce), None);
        for columns in [720, 960] {
            let size = sources.picture_size(&format!("generated/cover-{columns}.png"));
            assert_eq!(size, Some((columns, columns * 9 / 16)));
        }
    }

    #[test]
    fn printed_page_loads_all_pictures() {
        let html = r#"<img src="a" loading="lazy"><img src="b" fetchpriority="high">"#;
        let printed_html = r#"<img src="a"><img src="b" fetchpriority="high">"#;
        assert_eq!(remove_lazy_loading(html), printed_html);
    }
}
