//! The program `check`: its arguments, its exit codes, where it looks, and its JSON.

use crate::{assert_locked, create_empty_folder, draw_changed, locked_picture, map_locked};
use course::{camera_with_size, draw_named_scene};
use image::{DynamicImage, RgbImage};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Runs it with these arguments in this folder; gives them, its exit code and what it prints.
fn run_check(folder: &Path, arguments: &[&str]) -> (String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    let output = command.current_dir(folder).args(arguments).output();
    let Output { status, stdout, stderr } = output.expect("check runs");
    let [out, error] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    let code = status.code().unwrap_or(-1);
    let stream = if error.is_empty() { "" } else { ", standard error" };
    let text = format!("[exit code {code}{stream}]\n{out}{error}");
    // Paths are other ones on each machine.
    let text = match text.split_once("side by side: ") {
        Some((start, _)) => format!("{start}side by side: PATH"),
        None => text,
    };
    (format!("check {}", arguments.join(" ")), text)
}

/// Saves pictures in a folder and in those of its students.
fn save<const COUNT: usize>(folder: &Path, files: [(&str, DynamicImage); COUNT]) {
    for (file, picture) in files {
        let path = folder.join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        picture.save(path).expect("a file");
    }
}

#[test]
fn answers_about_one_file_are_as_locked() {
    let folder = create_empty_folder("one_file");
    let hole = |i, j, ours| if (i, j) == (320, 180) { [0; 3] } else { ours };
    save(
        &folder,
        [
            ("step2.png", locked_picture("step02_sphere").into()),
            ("my.png", map_locked("step02_sphere", hole).into()),
            ("red.png", map_locked("step05_phong", |_, _, [r, g, b]| [b, g, r]).into()),
            ("ada.png", draw_named_scene("ada").1.into()),
        ],
    );
    let odd_name = "a\u{1b}[2J\u{202e}.png";
    fs::write(folder.join(odd_name), "text").expect("a file");
    let runs: [&[&str]; 18] = [
        &["step2.png"],
        &["step2.png", "step01_rays"],
        &["my.png"],
        &["my.png", "--json"],
        &["red.png", "--json"],
        &["ada.png", "--scene", "ada"],
        &["ada.png", "--scene", "Ada", "--json"],
        &["nowhere.png"],
        &["nowhere.png", "--json"],
        &["."],
        &[odd_name],
        &["step2.png", "step06_mirror"],
        &["--in", "nowhere"],
        &["--in", "nowhere", "--json"],
        &["--scene", " \t"],
        &["a.png", "step01_rays", "more"],
        &["--width", "640", "--json"],
        &["--help"],
    ];
    assert_locked("one_file", runs.map(|arguments| run_check(&folder, arguments)));
    let (_, program) = run_check(&folder, &["--scene", "ada"]);
    assert_eq!(program, format!("[exit code 0]\n{}\n", draw_named_scene(" ada\t").0.trim_end()));
}

#[test]
fn answers_about_folders_are_as_locked() {
    let folder = create_empty_folder("folders");
    let [sky, glass] = ["step01_rays", "glass"].map(locked_picture);
    let scene = |name: &str| DynamicImage::from(draw_named_scene(name).1);
    let n_is_41 = draw_changed(step05_phong::scene(), |scene| {
        scene.objects[0].material.shininess = 41;
    });
    let mut clear = DynamicImage::from(sky.clone()).into_rgba8();
    clear.pixels_mut().for_each(|pixel| pixel[3] = 0);
    let sixteen_bits = DynamicImage::from(sky.clone()).into_rgb16();
    save(
        &folder,
        [
            ("mine/glass.png", glass.clone().into()),
            ("mine/sun.png", image::imageops::flip_vertical(&glass).into()),
            ("mine/plane (1).png", glass.clone().into()),
            ("class/ada/step01_rays.png", sky.clone().into()),
            ("class/ada/sun.png", glass.into()),
            ("class/ada/scene_of_me.png", scene("ada")),
            ("class/bob/scene_of_me.png", scene("ada")),
            ("class/bob/bob/steps/step01_rays.png", sky.clone().into()),
            ("class/cleo/step05_phong.png", n_is_41.into()),
            (
                "class/cleo/step01_rays.png",
                step01_rays::picture(&camera_with_size(64, 36), 1).into(),
            ),
            ("class/stray.png", sky.into()),
            ("class/dora/step01_rays.png", clear.into()),
            ("class/dora/step02_sphere.png", sixteen_bits.into()),
            ("class/emil/step01_rays.png", RgbImage::new(2, 2).into()),
        ],
    );
    fs::write(folder.join("mine/disc.png"), "text").expect("a file");
    fs::write(folder.join("class/emil/step3.jpg"), "").expect("a file");
    let runs: [&[&str]; 3] = [&["--in", "mine"], &["--in", "class"], &["--in", "class", "--json"]];
    assert_locked("folders", runs.map(|arguments| run_check(&folder, arguments)));
}

#[cfg(unix)]
#[test]
fn linked_and_locked_folders_go_by_their_names() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = create_empty_folder("linked");
    save(&folder, [("elsewhere/step01_rays.png", locked_picture("step01_rays").into())]);
    fs::create_dir_all(folder.join("class/locked")).expect("a folder");
    symlink(folder.join("elsewhere"), folder.join("class/ada")).expect("a link");
    let locked = folder.join("class/locked");
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o0)).expect("permissions");
    let is_root = fs::read_dir(&locked).is_ok();
    let answer = run_check(&folder, &["--in", "class"]);
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o755)).expect("permissions");
    if !is_root {
        assert_locked("linked_and_locked_folders", [answer]);
    }
}
