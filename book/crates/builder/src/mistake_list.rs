use course::{BookEntry, Mistake, Step, mistakes};
use std::sync::LazyLock;

static MISTAKES: LazyLock<Vec<Mistake>> = LazyLock::new(mistakes);

/// The mistakes that the book shows, with its words about them.
pub fn shown_mistakes() -> impl Iterator<Item = (&'static Mistake, &'static BookEntry)> {
    MISTAKES.iter().filter_map(|mistake| Some((mistake, mistake.book_entry.as_ref()?)))
}

/// The sentence of the list about the picture of a mistake, and the step that is drawn in
/// it; None for any other picture.
pub fn effect_and_step_of_picture(source: &str) -> Option<(String, Step)> {
    let name = source.strip_prefix("generated/mistake-")?.strip_suffix(".png")?;
    shown_mistakes().find_map(|(_, entry)| {
        let (_, step) = *entry.pictures.iter().find(|(known, _)| *known == name)?;
        Some((entry.effect.replace('`', ""), step))
    })
}
