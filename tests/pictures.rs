//! Draws every locked picture, and compares it with its snapshot. Each picture has its own test,
//! which has the picture's name. The locked pictures are the cover and the pictures of the steps,
//! the exercises and the chapters. `cargo test` runs these tests before all other tests, so that a
//! changed picture is reported first.

use course::{draw_with_difference, workspace};
use image::{Rgb, RgbImage};
use insta::assert_binary_snapshot;
use std::fs;
use std::path::{Path, PathBuf};
use support::{assert_picture_snapshot, locked_pictures};

/// Defines a test for each of these pictures.
macro_rules! test_pictures {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                draw_and_assert_snapshot(stringify!($name));
            }
        )*
    };
}

course::with_picture_names!(test_pictures);
support::with_chapter_picture_names!(test_pictures);

/// Draws the locked picture called `name`, and compares it with its snapshot.
fn draw_and_assert_snapshot(name: &str) {
    let pictures = locked_pictures();
    let picture = pictures.iter().find(|(picture_name, ..)| *picture_name == name);
    let (_, camera, draw) = picture.unwrap_or_else(|| panic!("no locked picture is called {name}"));
    assert_picture_snapshot(name, &draw(camera, 1), |png| {
        assert_binary_snapshot!(&format!("{name}.png"), png);
    });
}

#[test]
fn each_snapshot_has_a_test_of_its_name() {
    let files = fs::read_dir(workspace().join("tests/snapshots"))
        .expect("the folder can be read")
        .flatten();
    let names = files.map(|file| file.file_name().to_string_lossy().into_owned());
    let tested: Vec<_> = locked_pictures().into_iter().map(|(name, ..)| name).collect();
    let is_tested = |file: &String| {
        let (name, extension) = file.split_once('.').unwrap_or((file, ""));
        extension.starts_with("snap.new")
            || tested.contains(&name) && ["snap", "snap.png"].contains(&extension)
    };
    let orphans: Vec<_> = names.filter(|file| !is_tested(file)).collect();
    assert!(orphans.is_empty(), "no test uses the snapshots {orphans:?}");
}

/// Returns all files in a folder and its subfolders.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let paths =
        fs::read_dir(folder).expect("the folder can be read").flatten().map(|entry| entry.path());
    let files = paths.map(|path| if path.is_dir() { files_below(&path) } else { vec![path] });
    files.flatten().collect()
}

/// The name of a text snapshot is either the name of a test function or a string literal in the
/// same crate. So if the name occurs nowhere in the crate's source, no test uses the snapshot. This
/// test doesn't find every unused snapshot, but `cargo insta test --unreferenced=reject` does.
#[test]
fn name_of_each_text_snapshot_occurs_in_its_crate_source() {
    let (mut orphans, mut count) = (vec![], 0);
    for crate_folder in
        fs::read_dir(workspace().join("book/crates")).expect("the folder can be read").flatten()
    {
        let files = files_below(&crate_folder.path());
        let files_with_extension = |extension: &'static str| {
            files.iter().filter(move |path| path.extension() == Some(extension.as_ref()))
        };
        let sources: String = files_with_extension("rs")
            .map(|path| fs::read_to_string(path).expect("the source file can be read"))
            .collect();
        for path in files_with_extension("snap") {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            let name = stem.rsplit("__").next().unwrap_or_default();
            let is_named = |text: String| sources.contains(&text);
            if !is_named(format!("fn {name}(")) && !is_named(format!("\"{name}\"")) {
                orphans.push(path.clone());
            }
            count += 1;
        }
    }
    assert!(orphans.is_empty() && count > 0, "no test uses the snapshots {orphans:#?}");
}

#[test]
fn pixel_that_differs_is_orange_if_it_is_brighter_and_blue_if_it_is_darker() {
    let new = RgbImage::from_fn(3, 1, |i, _| Rgb([90, 89 + i as u8, 90]));
    let panels = draw_with_difference(&new, &RgbImage::from_pixel(3, 1, Rgb([90; 3])));
    let [darker, equal, brighter] = [6, 7, 8].map(|i| panels.get_pixel(i, 0).0);
    assert!(darker[0] < darker[2] && equal == [15; 3] && brighter[2] < brighter[0]);
}
