use course::{Step, hash_picture, locked_hashes};
use image::RgbImage;

/// The one of `names` that a file's own name tells: `step03_nearest.png`,
/// `my_lens-2.png`, `step3.png`.
pub(crate) fn find_name_in_file_name<'a>(
    file_name: &str,
    names: impl Iterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    let file_name = file_name.rsplit(['/', '\\']).next()?.to_ascii_lowercase();
    let words = format!("-{file_name}-").replace(|c: char| !c.is_alphanumeric(), "-");
    let has = |word: &str| words.contains(&format!("-{word}-"));
    let is_named = |name: &&str| ["-", ""].iter().any(|between| has(&name.replace('_', between)));
    let named = names.clone().filter(is_named);
    named.max_by_key(|name| name.len()).or_else(|| {
        let is_numbered = |step: &Step| {
            ["step", "step0", "step-"].iter().any(|word| has(&format!("{word}{}", step.number())))
        };
        let step = Step::ALL.into_iter().find(is_numbered)?;
        names.clone().find(|name| *name == step.name())
    })
}

/// The name of the locked picture that a picture is.
pub(crate) fn find_equal(picture: &RgbImage) -> Option<&'static str> {
    let hash = hash_picture(picture);
    locked_hashes().find(|(_, one)| *one == hash).map(|(name, _)| name)
}
