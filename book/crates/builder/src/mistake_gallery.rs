use crate::files::CHAPTERS;
use crate::generated_files::THUMBNAIL_SUFFIX;
use crate::markdown::inline_html;
use crate::picture::{LAZY, Picture};
use course::{BookEntry, Mistake, Step, mistakes};
use figures::escape;
use std::fs;
use std::path::Path;

/// The Markdown for `{{#mistakes step01_rays}}`: a contact sheet of the mistakes that are
/// shown in the picture of that step, and then each with its picture, ours, where they
/// differ, the diff, and what is to be said of it.
pub fn html(name: &str, workspace: &Path) -> Result<String, String> {
    let step = Step::from_name(name).ok_or(format!("there is no step {name}"))?;
    let all = mistakes();
    let book_entry = all.iter().filter_map(|mistake| {
        let book_entry = mistake.book_entry.as_ref()?;
        let (picture, pictured_step) = book_entry.pictures.first()?;
        (*pictured_step == step).then_some(Entry { mistake, book_entry, name: picture, step })
    });
    let entries: Vec<_> = book_entry.collect();
    let mut text = format!("<div class=\"contacts\" style=\"--items: {}\">\n\n", entries.len());
    for entry in &entries {
        text += &entry.contact_item_markdown(workspace)?;
    }
    text += "\n</div>\n";
    for entry in &entries {
        text += &entry.section_markdown(workspace)?;
    }
    Ok(text)
}

/// The sentence of the list about the picture of a mistake, and the step that is drawn in
/// it; None for any other picture.
pub fn effect_and_step_of_picture(source: &str) -> Option<(String, Step)> {
    let name = source.strip_prefix("generated/mistake-")?.strip_suffix(".png")?;
    mistakes().into_iter().filter_map(|mistake| mistake.book_entry).find_map(|entry| {
        let (_, step) = *entry.pictures.iter().find(|(known, _)| *known == name)?;
        Some((entry.effect.replace('`', ""), step))
    })
}

/// A mistake in the picture of a step.
struct Entry<'a> {
    mistake: &'a Mistake,
    book_entry: &'a BookEntry,
    name: &'a str,
    step: Step,
}

impl Entry<'_> {
    /// The item on the contact sheet, a link to its section.
    fn contact_item_markdown(&self, workspace: &Path) -> Result<String, String> {
        let picture = self.picture(&self.book_entry.effect.replace('`', ""));
        let picture = picture.html(workspace)?;
        Ok(format!("- [{picture} {}](#{})\n", self.capitalised_title_html()?, self.name))
    }

    fn section_markdown(&self, workspace: &Path) -> Result<String, String> {
        let Self { mistake, book_entry, name, step } = self;
        let right = format!("generated/{}{THUMBNAIL_SUFFIX}", step.name());
        let ours = Picture::without_caption("The right picture.", &right).html(workspace)?;
        let alt = format!("The picture of step {} with this mistake.", step.number());
        let wrong = self.picture(&alt).html(workspace)?;
        // The difference is blended by the browser: two pictures, one upon the other.
        let blended_source =
            |source: &str, alt: &str| format!("<img src=\"{source}\" alt=\"{alt}\"{LAZY}>");
        let mistaken = format!("generated/mistake-{name}.png");
        let blended = blended_source(&mistaken, "Yours.") + &blended_source(&right, "Ours.");
        let step_of_file = mistake.step().ok_or("a mistake that is shown is in a step")?;
        let is_kept = |c: &char| c.is_alphanumeric() || *c == '-';
        let id = book_entry.section.to_lowercase().replace(' ', "-");
        let id: String = id.chars().filter(is_kept).collect();
        let chapter = chapter_with_section(step_of_file, book_entry.section, workspace)?;
        Ok(format!(
            "\n### {} {{#{name}}}\n\n\
             <div class=\"panels\"><span data-label=\"Yours\">{wrong}</span>\
             <span data-label=\"Ours\">{ours}</span>\
             <span data-label=\"Difference\"><span class=\"differ\" role=\"img\" \
             aria-label=\"The difference.\">{blended}</span></span></div>\n\n{}\n\n{} [Step {}, “{}”]({chapter}.md#{id})\n",
            self.capitalised_title_html()?,
            diff_figure_html(mistake),
            inline_html(&symbols_as_formulas(book_entry.reason))?,
            step_of_file.number(),
            book_entry.section,
        ))
    }

    fn picture(&self, alt: &str) -> Picture {
        Picture::without_caption(alt, &format!("generated/mistake-{}.png", self.name))
    }

    /// HTML of the title, with a capital letter, unless it begins with a symbol.
    fn capitalised_title_html(&self) -> Result<String, String> {
        let title = self.mistake.title;
        let word = title.split(' ').next().unwrap_or_default();
        let is_word = 1 < word.len() && word.chars().all(|c| c.is_ascii_lowercase());
        inline_html(&symbols_as_formulas(&match title.split_at_checked(1) {
            Some((first, rest)) if is_word => first.to_uppercase() + rest,
            _ => title.to_owned(),
        }))
    }
}

/// The name of the chapter of a step that has a section with this heading.
fn chapter_with_section(
    step: Step,
    section: &str,
    workspace: &Path,
) -> Result<&'static str, String> {
    let has_section = |chapter: &&str| {
        let path = workspace.join(CHAPTERS).join(format!("{chapter}.md"));
        let text = fs::read_to_string(path).unwrap_or_default();
        text.lines().any(|line| line.strip_prefix("## ") == Some(section))
    };
    let chapter = step.chapters().into_iter().find(has_section);
    chapter.ok_or(format!("no chapter of {} has “{section}”", step.name()))
}

/// The lines of the file, and those that are written instead.
fn diff_figure_html(mistake: &Mistake) -> String {
    let path = mistake.file.strip_prefix("steps/").unwrap_or(&mistake.file);
    let lines = |tag: &str, sign: &str, text: &str| {
        let lines =
            text.lines().map(|line| format!("<{tag}>{sign} {}</{tag}>\n", escape(line.trim_end())));
        lines.collect::<String>()
    };
    format!(
        "<figure class=\"diff\"><figcaption>{}</figcaption><pre>{}</pre></figure>",
        escape(path),
        (lines("del", "−", &mistake.old) + &lines("ins", "+", &mistake.new)).trim_end(),
    )
}

/// The text, with symbols such as D_u as formulas.
fn symbols_as_formulas(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let is_symbol = |k: usize| letters[k].is_uppercase() && letters.get(k + 1) == Some(&'_');
    let formula = |(k, letter): (usize, &char)| match *letter {
        _ if is_symbol(k) => format!("${letter}"),
        _ if 2 <= k && is_symbol(k - 2) => format!("{letter}$"),
        _ => letter.to_string(),
    };
    letters.iter().enumerate().map(formula).collect()
}
