use crate::LockedPictures;
use course::Step;
use image::RgbImage;
use image::imageops::thumbnail;

/// The one of `names` that a file's own name tells: `step03_nearest.png`,
/// `my_lens-2.png`, `step3.png`.
pub fn find_name_in_file_name<'a>(
    file_name: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    let lower = file_name.to_ascii_lowercase();
    let file_name = lower.rsplit(['/', '\\']).next()?;
    let has = |word: &str| contains_whole_word(file_name, word);
    let named = names.clone().filter(|name| has(name) || has(&name.replace('_', "")));
    named.max_by_key(|name| name.len()).or_else(|| {
        let words = ["step", "step0", "step ", "step_", "step-"];
        let is_numbered =
            |step: &Step| words.iter().any(|word| has(&format!("{word}{}", step.number())));
        let step = Step::ALL.into_iter().find(is_numbered)?;
        names.clone().find(|name| *name == step.name())
    })
}

/// Whether `word` is in `text` with no letter or digit before it or after it.
fn contains_whole_word(text: &str, word: &str) -> bool {
    let is_end = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(word).any(|(k, _)| {
        let (text_before, text_after) = (&text[..k], &text[k + word.len()..]);
        is_end(text_before.chars().next_back()) && is_end(text_after.chars().next())
    })
}

/// The one of some locked pictures that is most like yours, whatever its size.
pub(crate) fn find_most_similar<'a>(
    yours: &RgbImage,
    names: &[&'a str],
    locked: &LockedPictures,
) -> Result<&'a str, String> {
    let small = |picture: &RgbImage| thumbnail(picture, 64, 36).into_raw();
    let yours = small(yours);
    let mut distances = vec![];
    for name in names {
        let pairs = yours.iter().zip(small(&locked.get(name)?.picture));
        distances.push((pairs.map(|(a, b)| u64::from(a.abs_diff(b))).sum::<u64>(), *name));
    }
    let nearest = distances.into_iter().min_by_key(|(distance, _)| *distance);
    Ok(nearest.map_or("", |(_, name)| name))
}
