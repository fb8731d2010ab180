//! The gallery of the mistakes that readers might make in a step. For each mistake, the gallery
//! shows the wrong picture and the diff, and says why the code is wrong.

use crate::Sources;
use crate::fault::{ChapterError, ChapterResult};
use crate::markdown::{html_block, inline_html};
use crate::picture::{self, LoadingTime};
use crate::sources::small_picture_name;
use crate::values::Values;
use course::{Mistake, MistakePicture, MistakePresentation, Step, escape_html, mistakes};

/// Returns the Markdown for a directive such as `{{#mistakes step01_rays}}`. The gallery begins
/// with a contact sheet, which has one small picture for each mistake that the book shows in that
/// step. A section for each of these mistakes follows. In each section, three pictures come first,
/// then the diff of the code, then the reason why the code is wrong.
pub fn gallery_markdown(
    step_name: &str,
    sources: &Sources,
    loading: &mut LoadingTime,
) -> ChapterResult<String> {
    let step = Step::from_name(step_name)
        .ok_or_else(|| ChapterError::UnknownStep(step_name.to_owned()))?;
    let (mut items, mut sections) = (String::new(), String::new());
    for mistake in mistakes() {
        let Some(presentation) = &mistake.presentation else { continue };
        let Some(MistakePicture { name, .. }) =
            presentation.pictures.first().filter(|picture| picture.step == step)
        else {
            continue;
        };
        let (title, source) =
            (title_html(mistake, &sources.values)?, format!("generated/mistake-{name}.png"));
        let picture =
            picture::image_html(&presentation.effect.replace('`', ""), &source, sources, loading)?;
        items += &format!("- [{picture} {title}](#{name})\n");
        sections += &format!("### {title} {{#{name}}}\n");
        sections += &html_block(&yours_ours_difference_html(&source, step, sources, loading)?);
        sections += &html_block(&changed_lines_html(mistake));
        sections += &(reason_markdown(mistake, presentation, &sources.values)? + "\n\n");
    }
    let [begin, end] = ["<div class=\"contacts\">", "</div>"].map(html_block);
    Ok([begin, items, end, sections].concat())
}

/// Returns the reason why the code is wrong, with a link to the section that the reader should read
/// again.
fn reason_markdown(
    mistake: &Mistake,
    MistakePresentation { section, reason, .. }: &MistakePresentation,
    values: &Values,
) -> ChapterResult<String> {
    let address = mistake.section_address("md").unwrap_or_default();
    let reason = inline_html(&symbols_as_formulas(reason), values)?;
    Ok(format!("{reason} [Step {}, “{section}”]({address})", mistake.step.number()))
}

/// Returns the HTML of three panels: the wrong picture, the step's correct picture, and the
/// difference. `yours` is the path of the wrong picture. The browser computes the difference by
/// blending the two pictures.
fn yours_ours_difference_html(
    yours: &str,
    step: Step,
    sources: &Sources,
    loading: &mut LoadingTime,
) -> ChapterResult<String> {
    let ours = format!("generated/{}", small_picture_name(step));
    let alt = format!("The picture of step {} with this mistake.", step.number());
    let wrong = picture::image_html(&alt, yours, sources, loading)?;
    let right = picture::image_html("The right picture.", &ours, sources, loading)?;
    let lazy = LoadingTime::InView.html_attribute();
    Ok(format!(
        "<div class=\"panels\"><span data-label=\"Yours\">{wrong}</span>\
         <span data-label=\"Ours\">{right}</span>\
         <span data-label=\"Difference\"><span class=\"differ\" role=\"img\" \
         aria-label=\"The difference.\">\
         <img src=\"{yours}\" alt=\"Yours.\" {lazy}>\
         <img src=\"{ours}\" alt=\"Ours.\" {lazy}></span></span></div>"
    ))
}

/// Returns the HTML of a mistake's title. If the first word has several letters, all of them in
/// lower case, its first letter becomes a capital. Any other first word is kept, because the word
/// may be a symbol, such as x.
fn title_html(Mistake { title, .. }: &Mistake, values: &Values) -> ChapterResult<String> {
    let word = title.split(' ').next().unwrap_or_default();
    let is_word = word.len() > 1 && word.chars().all(|c| c.is_ascii_lowercase());
    let title = match title.split_at_checked(1) {
        Some((first, remaining_letters)) if is_word => first.to_uppercase() + remaining_letters,
        _ => (*title).to_owned(),
    };
    inline_html(&symbols_as_formulas(&title), values)
}

/// Returns the HTML of a mistake's diff: the correct lines of code, then the wrong lines that
/// replace them.
fn changed_lines_html(mistake: &Mistake) -> String {
    let path = mistake.file.strip_prefix("steps/").unwrap_or(&mistake.file);
    let lines = |tag: &str, sign: &str, text: &str| {
        let lines = text
            .lines()
            .map(|line| format!("<{tag}>{sign} {}</{tag}>\n", escape_html(line.trim_end())));
        lines.collect::<String>()
    };
    format!(
        "<figure class=\"diff\"><figcaption>{}</figcaption><pre>{}</pre></figure>",
        escape_html(path),
        (lines("del", "−", &mistake.old) + &lines("ins", "+", &mistake.new)).trim_end(),
    )
}

/// Turns symbols such as D_u into formulas.
fn symbols_as_formulas(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_symbol = |k: usize| letters[k].is_uppercase() && letters.get(k + 1) == Some(&'_');
    let formula = |(k, letter): (usize, &char)| match *letter {
        _ if is_symbol(k) => format!("${letter}"),
        _ if k >= 2 && is_symbol(k - 2) => format!("{letter}$"),
        _ => letter.to_string(),
    };
    letters.iter().enumerate().map(formula).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_become_formulas() {
        assert_eq!(symbols_as_formulas("D_u is no step"), "$D_u$ is no step");
        assert_eq!(symbols_as_formulas("a_b, V and V_0."), "a_b, V and $V_0$.");
    }
}
