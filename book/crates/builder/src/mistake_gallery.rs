use crate::Sources;
use crate::markdown::inline_html;
use crate::mistake_list::shown_mistakes;
use crate::picture::{self, LAZY};
use crate::sources::small_picture_name;
use course::{BookEntry, Mistake, Step};
use figures::escape;

/// The Markdown for `{{#mistakes step01_rays}}`: a contact sheet of the mistakes that are
/// shown in the picture of that step, and then each with its picture, ours, where they
/// differ, the diff, and what is to be said of it.
pub fn html(name: &str, sources: &Sources) -> Result<String, String> {
    let step = Step::from_name(name).ok_or(format!("there is no step {name}"))?;
    let shown = shown_mistakes().filter_map(|(mistake, book_entry)| {
        let (picture, pictured_step) = book_entry.pictures.first()?;
        (*pictured_step == step).then_some(Shown { mistake, book_entry, name: picture, step })
    });
    let shown: Vec<_> = shown.collect();
    let items: Result<String, String> =
        shown.iter().map(|one| one.contact_item_markdown(sources)).collect();
    let sections: Result<String, String> =
        shown.iter().map(|one| one.section_markdown(sources)).collect();
    let style = format!("--items: {}", shown.len());
    Ok(format!("<div class=\"contacts\" style=\"{style}\">\n\n{}\n</div>\n{}", items?, sections?))
}

struct Shown {
    mistake: &'static Mistake,
    book_entry: &'static BookEntry,
    name: &'static str,
    step: Step,
}

impl Shown {
    /// The item on the contact sheet, a link to its section.
    fn contact_item_markdown(&self, sources: &Sources) -> Result<String, String> {
        let effect = self.book_entry.effect.replace('`', "");
        let picture = picture::html(&effect, &self.source(), sources)?;
        Ok(format!("- [{picture} {}](#{})\n", self.capitalised_title_html()?, self.name))
    }

    fn section_markdown(&self, sources: &Sources) -> Result<String, String> {
        let Self { mistake, book_entry, name, step } = self;
        let is_of_program = mistake.file.ends_with("/program.rs");
        let chapter = if is_of_program { "step01_program" } else { mistake.step.name() };
        let is_kept = |c: &char| c.is_alphanumeric() || *c == '-';
        let id = book_entry.section.to_lowercase().replace(' ', "-");
        let id: String = id.chars().filter(is_kept).collect();
        let ours = format!("generated/{}", small_picture_name(*step));
        Ok(format!(
            "\n### {} {{#{name}}}\n\n{}\n\n{}\n\n{} [Step {}, “{}”]({chapter}.md#{id})\n",
            self.capitalised_title_html()?,
            self.panels_html(&ours, sources)?,
            changed_lines_html(mistake),
            inline_html(&symbols_as_formulas(book_entry.reason))?,
            mistake.step.number(),
            book_entry.section,
        ))
    }

    /// The picture with the mistake, `ours`, and where they differ: the browser blends two
    /// pictures, one upon the other.
    fn panels_html(&self, ours: &str, sources: &Sources) -> Result<String, String> {
        let number = self.step.number();
        let alt = format!("The picture of step {number} with this mistake.");
        let yours = self.source();
        let wrong = picture::html(&alt, &yours, sources)?;
        let right = picture::html("The right picture.", ours, sources)?;
        Ok(format!(
            "<div class=\"panels\"><span data-label=\"Yours\">{wrong}</span>\
             <span data-label=\"Ours\">{right}</span>\
             <span data-label=\"Difference\"><span class=\"differ\" role=\"img\" \
             aria-label=\"The difference.\">\
             <img src=\"{yours}\" alt=\"Yours.\"{LAZY}>\
             <img src=\"{ours}\" alt=\"Ours.\"{LAZY}></span></span></div>"
        ))
    }

    fn source(&self) -> String {
        format!("generated/mistake-{}.png", self.name)
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

/// The lines of the file, and those that are written instead.
fn changed_lines_html(mistake: &Mistake) -> String {
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
