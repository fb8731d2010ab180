use crate::{Locked, Step};
use image::RgbImage;
use image::imageops::thumbnail;

/// The one of `names` that a file's own name tells: `step03_nearest.png`,
/// `my_lens-2.png`, `step3.png`.
pub fn by_file<'a>(
    file: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    let lower = file.to_ascii_lowercase();
    let file = lower.rsplit(['/', '\\']).next()?;
    let told = names.clone().filter(|name| has_word(file, name));
    told.max_by_key(|name| name.len()).or_else(|| {
        let is_told = |step: &Step| {
            let number = step.number();
            let words = [format!("step{number}"), format!("step0{number}")];
            words.iter().any(|word| has_word(file, word))
        };
        let step = Step::ALL.into_iter().find(is_told)?;
        names.clone().find(|name| *name == step.name())
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

/// The picture that is most like yours, whatever its size.
pub(crate) fn nearest<'a>(yours: &RgbImage, asked: &[&'a Locked]) -> &'a Locked {
    let small = |picture: &RgbImage| thumbnail(picture, 64, 36).into_raw();
    let yours = small(yours);
    let far = |one: &&&Locked| {
        let pairs = yours.iter().zip(small(&one.picture));
        pairs.map(|(a, b)| u64::from(a.abs_diff(b))).sum::<u64>()
    };
    asked.iter().min_by_key(far).unwrap_or(&asked[0])
}
