//! Tests what `check` says about every kind of picture that a reader may have. The answers are in
//! snapshots. When you review a snapshot, read the answers as a reader of the book would.

mod class;
#[cfg(unix)]
mod downloads;
mod files;
mod laws;
mod pictures;
mod program;
mod small_pictures;

use check::{Answer, CheckError, check_png};
use course::{camera, generate_scene, locked_picture_path, read_locked_picture};
use glam::DVec3;
use image::{DynamicImage, ImageFormat, Rgb, RgbImage};
use insta::{assert_snapshot, with_settings};
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use step01_rays::{Ray, render};

/// A title and an answer of `check`, in the form that a snapshot contains.
type TitledAnswer = (String, String);

fn locked_file(name: &str) -> Vec<u8> {
    fs::read(locked_picture_path(name)).expect("the locked picture can be read")
}

fn locked_picture(name: &str) -> RgbImage {
    read_locked_picture(name).expect("the locked picture can be read")
}

/// Returns the locked picture `name` with changed pixels. `change` turns a pixel's column, row and
/// colour into a new colour.
fn map_locked(name: &str, change: impl Fn(u32, u32, [u8; 3]) -> [u8; 3]) -> RgbImage {
    let ours = locked_picture(name);
    RgbImage::from_fn(640, 360, |i, j| Rgb(change(i, j, ours.get_pixel(i, j).0)))
}

/// Draws a picture with the course's camera. `colour` returns the colour of each ray.
fn draw(colour: impl Fn(&Ray) -> DVec3 + Sync) -> RgbImage {
    render(&camera(), 1, colour)
}

/// Draws the scene that is generated from a name.
fn draw_generated_scene(name: &str) -> RgbImage {
    let scene = generate_scene(name);
    draw(|ray| step05_phong::colour(&scene, ray))
}

fn encode(picture: impl Into<DynamicImage>) -> Vec<u8> {
    let mut png = Cursor::new(vec![]);
    picture.into().write_to(&mut png, ImageFormat::Png).expect("the picture can be encoded");
    png.into_inner()
}

fn check(picture: RgbImage, name: &str) -> Answer {
    let answer = check_png(&encode(picture), "my.png", Some(name), read_locked_picture);
    answer.expect("the file can be checked")
}

/// Formats an answer for a snapshot.
fn format_answer(result: Result<Answer, CheckError>) -> String {
    let answer = match result {
        Ok(answer) => answer,
        Err(error) => return format!("[error]\n{error}"),
    };
    let text = answer.to_string();
    assert!(text.lines().count() <= 12, "the answer has more than 12 lines:\n{text}");
    if let Some((line, _)) = answer.section_link() {
        assert!(
            text.lines().any(|answer_line| answer_line == line),
            "the line {line} is missing:\n{text}"
        );
    }
    let causes: String = answer.causes.iter().map(|cause| format!("\n[{cause}]")).collect();
    format!("[{}]\n{text}{causes}", answer.verdict.label())
}

/// Compares answers with the snapshot `name`. In the snapshot, each answer follows its title.
#[track_caller]
fn assert_locked(name: &str, answers: impl IntoIterator<Item = TitledAnswer>) {
    let answers = answers.into_iter();
    let text = answers.map(|(title, text)| format!("## {title}\n{}\n\n", text.trim_end()));
    with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        assert_snapshot!(name, text.collect::<String>());
    });
}

fn create_empty_folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder can be created");
    folder
}
