use course::{BookEntry, Mistake, mistakes};
use std::sync::LazyLock;

static MISTAKES: LazyLock<Vec<Mistake>> = LazyLock::new(mistakes);

/// The mistakes that the book shows, with its words about them.
pub fn shown_mistakes() -> impl Iterator<Item = (&'static Mistake, &'static BookEntry)> {
    MISTAKES.iter().filter_map(|mistake| Some((mistake, mistake.book_entry.as_ref()?)))
}

/// The sentence of the list about the picture of a mistake; None for any other picture.
pub fn effect_of_picture(source: &str) -> Option<String> {
    let name = source.strip_prefix("generated/mistake-")?.strip_suffix(".png")?;
    let shows = |entry: &BookEntry| entry.pictures.iter().any(|(known, _)| *known == name);
    let (_, entry) = shown_mistakes().find(|(_, entry)| shows(entry))?;
    Some(entry.effect.replace('`', ""))
}
