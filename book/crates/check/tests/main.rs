//! `check`: its list of mistakes, and what it says of every picture that a reader may
//! bring.

mod answers;
mod explanations;
mod file_formats;
mod list;
mod program;

use check::{Answer, Locked, check_picture};
use course::camera_with_size;
use image::RgbImage;
use std::path::PathBuf;
use std::{fs, sync::LazyLock};
use step01_rays::render;
use step05_phong::{Light, Material, Scene};

/// All pictures that there are to compare with.
fn locked() -> &'static [Locked] {
    static LOCKED: LazyLock<Result<Vec<Locked>, String>> = LazyLock::new(Locked::read_all);
    LOCKED.as_ref().expect("locked pictures")
}

/// The locked picture `name`.
fn locked_picture(name: &str) -> RgbImage {
    let locked_one = locked().iter().find(|locked_one| locked_one.name == name);
    locked_one.expect("a locked picture").picture.clone()
}

/// The answer about a picture that is not right; it has a dozen lines at most.
fn text_of_wrong_picture(picture: &RgbImage, name: &str) -> String {
    let Answer { code, text, .. } = check_picture(picture, Some(name), locked());
    assert!(code == 1 && text.lines().count() <= 12, "{text}");
    text
}

fn assert_answer_contains(picture: &RgbImage, name: &str, words: &[&str]) {
    let text = text_of_wrong_picture(picture, name);
    for word in words {
        assert!(text.contains(word), "{word} is not in: {text}");
    }
}

type PhongScene = Scene<Material, Light>;

/// The picture of step 5 with another scene.
fn draw_changed_step05(change: impl Fn(&mut PhongScene)) -> RgbImage {
    let mut scene = step05_phong::scene();
    change(&mut scene);
    render(&camera_with_size(640, 360), 1, |ray| step05_phong::colour(&scene, ray))
}

/// An empty folder of this test.
fn create_empty_folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
