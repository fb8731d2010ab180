use crate::drawing::Drawing;
use crate::escape_for_terminal;
use course::{Step, camera, hash_picture, locked_hashes};
use image::RgbImage;
use step01_rays::render;

/// A picture to compare with: a locked one, or the scene of a name.
pub(crate) struct Target {
    /// Such as `the picture of glass`.
    pub title: String,
    /// The name of a locked picture; None of the scene of a name.
    pub name: Option<String>,
    /// None of an exercise.
    pub drawing: Option<Drawing>,
    pub picture: RgbImage,
}

impl Target {
    /// The locked picture of a name.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        let drawing = Step::from_name(name).map(Drawing::of_step);
        let title = format!("the picture of {name}");
        Self { title, name: Some(name.to_owned()), drawing, picture }
    }

    /// The scene that belongs to a name.
    pub fn of_scene(name: &str) -> Self {
        let drawing = Drawing::of_name(name);
        let picture = render(&camera(), 1, |ray| drawing.colour(ray));
        Self { title: scene_title(name), name: None, drawing: Some(drawing), picture }
    }
}

/// A title such as `the scene of ada`.
pub(crate) fn scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}

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
            ["step", "step0", "step-", "step-0"]
                .iter()
                .any(|word| has(&format!("{word}{}", step.number())))
        };
        let step = Step::ALL.into_iter().find(is_numbered)?;
        names.clone().find(|name| *name == step.name())
    })
}

/// The most pixels of a picture with a known hash: those of the default options, and of mistakes
/// with these.
const MOST_HASHED_PIXELS: usize = 1 << 20;

/// The hash of a picture; None of one that is too large to have a known hash.
pub(crate) fn hash_if_small(picture: &RgbImage) -> Option<u64> {
    (picture.pixels().len() <= MOST_HASHED_PIXELS).then(|| hash_picture(picture))
}

/// The name of the locked picture that a picture is.
pub(crate) fn find_equal(picture: &RgbImage) -> Option<&'static str> {
    let hash = hash_if_small(picture)?;
    locked_hashes().find(|(_, one)| *one == hash).map(|(name, _)| name)
}
