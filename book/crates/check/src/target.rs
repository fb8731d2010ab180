//! The right picture that a reader's picture is compared with.

use crate::escape_for_terminal;
use crate::step_scene::StepScene;
use course::{Step, camera};
use image::RgbImage;
use step01_rays::render;

/// A right picture, which a reader's picture should equal. The right picture is either locked or
/// drawn from a scene that is generated from a name.
pub(crate) struct Target {
    /// The phrase that stands for the picture in a sentence, such as `the picture of glass`.
    pub title: String,
    /// The name of the locked picture. None if the picture isn't locked.
    pub name: Option<String>,
    /// The scene, and the step that draws it. None if the picture belongs to an exercise.
    pub scene: Option<StepScene>,
    pub picture: RgbImage,
}

impl Target {
    /// The target for a locked picture.
    pub fn of_locked(name: &str, picture: RgbImage) -> Self {
        let scene = Step::from_name(name).map(StepScene::of_step);
        let title = format!("the picture of {name}");
        Self { title, name: Some(name.to_owned()), scene, picture }
    }

    /// The target for the scene that is generated from a name.
    pub fn of_generated_scene(name: &str) -> Self {
        let scene = StepScene::of_generated_scene(name);
        let picture = render(&camera(), 1, |ray| scene.colour(ray));
        Self { title: generated_scene_title(name), name: None, scene: Some(scene), picture }
    }
}

/// Returns the phrase for the scene that is generated from `name`, such as `the scene of ada`.
pub(crate) fn generated_scene_title(name: &str) -> String {
    format!("the scene of {}", escape_for_terminal(name))
}

/// Finds one of `names` in a file name. Examples of file names are `step03_nearest.png`,
/// `my_lens-2.png` and `step3.png`. If a file name contains several of the names, returns the
/// longest of them.
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

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 6] =
        ["step01_rays", "step03_nearest", "rings", "sun", "my_scene", "look_at"];

    #[test]
    fn name_is_found_as_a_word_of_the_file_name() {
        let find = |file_name| find_name_in_file_name(file_name, NAMES.into_iter());
        assert_eq!(find("step03_nearest.png"), Some("step03_nearest"));
        assert_eq!(find("work\\Step 3 final.png"), Some("step03_nearest"));
        assert_eq!(find("a/rings/step-03.PNG"), Some("step03_nearest"));
        assert_eq!(find("step12.png"), None);
        assert_eq!(find("MyScene-2.png"), Some("my_scene"));
        assert_eq!(find("sunny.png"), None);
        assert_eq!(find("rings/picture.png"), None);
        // If the file name contains several names, the longest name is found.
        assert_eq!(find("sun rings.png"), Some("rings"));
        assert_eq!(find("step4.png"), None);
    }
}
