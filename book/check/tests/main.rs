//! `check`: its list of mistakes, and what it says of every picture that a reader may
//! bring.

mod answers;
mod damaged;
mod explanations;
mod list;
mod program;

use check::{Answer, Locked, check_picture};
use image::RgbImage;
use std::path::PathBuf;
use std::{fs, sync::LazyLock};

/// All pictures that there are to compare with.
fn locked() -> &'static [Locked] {
    static LOCKED: LazyLock<Result<Vec<Locked>, String>> =
        LazyLock::new(Locked::read_all);
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

/// The answer about a PNG file of a picture, which ends with this exit code.
fn text_with_exit_code(picture: &RgbImage, name: &str, code: u8) -> String {
    let mut png = std::io::Cursor::new(vec![]);
    picture.write_to(&mut png, image::ImageFormat::Png).expect("a file");
    let answer = check::check_png(png.get_ref(), "my.png", Some(name), locked());
    assert_eq!(answer.code, code, "{}", answer.text);
    answer.text
}

/// An empty folder of this test.
fn create_empty_folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder in the target folder");
    folder
}
