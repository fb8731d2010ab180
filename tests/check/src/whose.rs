use crate::view::{View, scattered};
use crate::{Locked, Step};

/// The one of `names` that a file's own name tells: `step03_nearest.png`,
/// `my_lens-2.png`, `step3.png`.
pub fn by_file<'a>(
    file: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    let lower = file.to_ascii_lowercase();
    let file = lower.rsplit(['/', '\\']).next()?;
    let names = || names.clone();
    let told = names().filter(|name| has_word(file, name));
    told.max_by_key(|name| name.len()).or_else(|| {
        let is_told = |step: &Step| {
            let number = step.number();
            let words = [format!("step{number}"), format!("step0{number}")];
            words.iter().any(|word| has_word(file, word))
        };
        let step = Step::ALL.into_iter().find(is_told)?;
        names().find(|name| *name == step.name())
    })
}

/// Whether `word` is in `text` with no letter or digit before it or after it.
fn has_word(text: &str, word: &str) -> bool {
    let is_end = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(word).any(|(k, _)| {
        let (before, after) = (&text[..k], &text[k + word.len()..]);
        is_end(before.chars().next_back()) && is_end(after.chars().next())
    })
}

/// How far apart two pictures of any sizes are, at places all over them.
pub(crate) fn distance(yours: &View, ours: &Locked) -> u64 {
    let places = scattered(&ours.picture, 2000).into_iter();
    let pairs = yours.scattered(2000).into_iter().zip(places);
    let apart = pairs.map(|((i, j), (k, l))| {
        let [a, b] = [yours.pixel(i, j).0, ours.picture.get_pixel(k, l).0];
        a.into_iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(b))).sum::<u64>()
    });
    apart.sum()
}
