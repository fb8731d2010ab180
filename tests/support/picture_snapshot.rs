//! Compares a picture with its snapshot.

use course::environment::{SnapshotUpdate, snapshot_update};
use course::{
    describe_difference, draw_with_difference, encode_png, locked_picture_path,
    read_locked_picture, target_folder,
};
use image::RgbImage;
use insta::Settings;
use std::fs;
use std::path::PathBuf;

/// Compares `picture` with the locked picture `name`, pixel by pixel. `assert_png` receives a PNG
/// file and hands it to insta. If all pixels are equal, the PNG file is the locked file itself,
/// because a different version of the encoder might write different bytes for the same pixels.
///
/// If any pixels differ, first prints a sentence that describes the difference, and the command
/// that accepts the new picture. Also saves a comparison of both pictures in the target folder.
pub fn assert_picture_snapshot(name: &str, picture: &RgbImage, assert_png: impl FnOnce(Vec<u8>)) {
    let mut settings = Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    // The description is the comparison's path in the default target folder. We don't mention a
    // custom target folder, because the description is part of the snapshot, and the snapshot has
    // to be the same on every machine.
    settings.set_description(format!("target/differences/{name}.png"));
    let mismatch = describe_and_save_mismatch(name, picture);
    match &mismatch {
        Some(text) => {
            let command = "INSTA_UPDATE=always cargo test --test pictures";
            println!("{name}: {text}\nIf this is intended, accept it: {command} {name}");
        }
        None => drop(fs::remove_file(panels_path(name))),
    }
    let update = snapshot_update();
    if update == SnapshotUpdate::No {
        // Don't call `assert_png`: insta would delete a picture that is still waiting for review.
        return assert!(mismatch.is_none(), "{name} differs from the locked picture");
    }
    let locked_png = fs::read(locked_picture_path(name)).ok();
    let png = locked_png.filter(|_| mismatch.is_none()).unwrap_or_else(|| encode_png(picture));
    settings.bind(|| assert_png(png));
    if update == SnapshotUpdate::InPlace {
        // A failed test leaves two files for review. When insta accepts the picture, insta deletes
        // only one of the two files.
        let _ = fs::remove_file(locked_picture_path(name).with_extension("new"));
    }
}

/// Describes how a picture differs from the locked picture, and saves panels that show the
/// difference. If there is no locked picture, says so. Returns None if the two pictures are equal.
fn describe_and_save_mismatch(name: &str, picture: &RgbImage) -> Option<String> {
    let path = locked_picture_path(name);
    let has_text = path.with_extension("").exists();
    let Some(locked) = read_locked_picture(name).ok().filter(|_| has_text) else {
        return Some(format!(
            "there is no picture {} with its .snap file beside it.",
            path.display()
        ));
    };
    let difference = describe_difference(&locked, picture)?;
    let path = panels_path(name);
    let _ = fs::create_dir_all(path.with_file_name(""));
    let caption = match draw_with_difference(picture, &locked).save(&path) {
        Ok(()) => {
            "New picture, locked picture and difference (orange where the new picture is brighter):"
        }
        Err(_) => "The difference can't be written to",
    };
    Some(format!("{difference}.\n{caption} {}", path.display()))
}

/// The file for the panels that compare the picture called `name` with its snapshot.
fn panels_path(name: &str) -> PathBuf {
    target_folder().join(format!("differences/{name}.png"))
}
