//! The program `check`: its arguments, its exit codes, where it looks, and its JSON.

use crate::{Answers, create_empty_folder, draw_changed_scene, locked_picture, map_locked};
use image::RgbImage;
use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs};

/// Runs it with these arguments in this folder; gives its exit code and what it prints.
fn run_check(folder: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    let output = command.current_dir(folder).args(arguments).output();
    let Output { status, stdout, stderr } = output.expect("check runs");
    let [out, error] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    let code = status.code().unwrap_or(-1);
    let stream = if error.is_empty() { "" } else { ", standard error" };
    let text = format!("[exit code {code}{stream}]\n{out}{error}");
    // Paths are other ones on each machine.
    match text.split_once("side by side: ") {
        Some((start, _)) => format!("{start}side by side: PATH"),
        None => text,
    }
}

fn add_runs(answers: &mut Answers, folder: &Path, runs: &[&[&str]]) {
    for arguments in runs {
        answers.add(&format!("check {}", arguments.join(" ")), &run_check(folder, arguments));
    }
}

fn save(folder: &Path, file: &str, picture: &RgbImage) {
    let path = folder.join(file);
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    picture.save(path).expect("a file");
}

#[test]
fn answers_about_one_file_are_as_locked() {
    let folder = create_empty_folder("one_file");
    let mut answers = Answers::new();
    save(&folder, "step2.png", &locked_picture("step02_sphere"));
    save(
        &folder,
        "my.png",
        &map_locked("step02_sphere", |i, j, ours| if (i, j) == (320, 180) { [0; 3] } else { ours }),
    );
    save(&folder, "red.png", &map_locked("step05_phong", |_, _, [r, g, b]| [b, g, r]));
    save(&folder, "ada.png", &course::draw_named_scene("ada").1);
    fs::write(folder.join("a\u{1b}[2J\u{202e}.png"), "text").expect("a file");
    add_runs(
        &mut answers,
        &folder,
        &[
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
            &["a\u{1b}[2J\u{202e}.png"],
            &["step2.png", "step06_mirror"],
            &["--in", "nowhere"],
            &["--in", "nowhere", "--json"],
            &["--scene", " \t"],
            &["--scene", "", "--json"],
            &["a.png", "step01_rays", "more"],
            &["--width", "640", "--json"],
            &["--help"],
        ],
    );
    let program = run_check(&folder, &["--scene", "ada"]);
    assert_eq!(program, run_check(&folder, &["--scene", " ada\t"]));
    answers.add("check --scene ada", &program.lines().take(4).collect::<Vec<_>>().join("\n"));
    answers.assert_locked("one_file");
}

#[test]
fn answers_about_folders_are_as_locked() {
    let folder = create_empty_folder("folders");
    let mut answers = Answers::new();
    let [sky, glass] = ["step01_rays", "glass"].map(locked_picture);
    let scene = |name: &str| course::draw_named_scene(name).1;
    save(&folder, "mine/glass.png", &glass);
    save(&folder, "mine/sun.png", &image::imageops::flip_vertical(&glass));
    save(&folder, "mine/plane (1).png", &glass);
    save(&folder, "mine/steps/plane.png", &glass);
    fs::write(folder.join("mine/disc.png"), "text").expect("a file");
    save(&folder, "class/ada/step01_rays.png", &sky);
    save(&folder, "class/ada/sun.png", &glass);
    save(&folder, "class/ada/scene_of_me.png", &scene("ada"));
    save(&folder, "class/bob/scene_of_me.png", &scene("ada"));
    save(&folder, "class/bob/bob/steps/step01_rays.png", &sky);
    save(
        &folder,
        "class/cleo/step05_phong.png",
        &draw_changed_scene(|scene| {
            scene.objects[0].material.shininess = 41;
        }),
    );
    save(
        &folder,
        "class/cleo/step01_rays.png",
        &step01_rays::picture(&course::camera_with_size(64, 36), 1),
    );
    save(&folder, "class/stray.png", &sky);
    let mut clear = image::DynamicImage::from(sky.clone()).into_rgba8();
    clear.pixels_mut().for_each(|pixel| pixel[3] = 0);
    fs::create_dir(folder.join("class/dora")).expect("a folder");
    clear.save(folder.join("class/dora/step01_rays.png")).expect("a file");
    image::DynamicImage::from(sky)
        .into_rgb16()
        .save(folder.join("class/dora/step02_sphere.png"))
        .expect("a file");
    fs::create_dir(folder.join("class/emil")).expect("a folder");
    fs::write(folder.join("class/emil/step3.jpg"), "").expect("a file");
    add_runs(
        &mut answers,
        &folder,
        &[
            &["--in", "mine"],
            &["--in", "mine", "--json"],
            &["--in", "class"],
            &["--in", "class/ada", "--json"],
            &["--in", "class/emil"],
        ],
    );
    let json = run_check(&folder, &["--in", "class", "--json"]);
    let (_, json) = json.split_once('\n').expect("lines");
    for student in json.lines().filter(|line| !line.contains("\"missing\"")) {
        answers.add("check --in class --json", student);
    }
    answers.assert_locked("folders");
}

#[cfg(unix)]
#[test]
fn linked_and_locked_folders_go_by_their_names() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = create_empty_folder("linked");
    save(&folder, "elsewhere/step01_rays.png", &locked_picture("step01_rays"));
    fs::create_dir_all(folder.join("class/locked")).expect("a folder");
    symlink(folder.join("elsewhere"), folder.join("class/ada")).expect("a link");
    let locked = folder.join("class/locked");
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o0)).expect("permissions");
    let text = run_check(&folder, &["--in", "class"]);
    let is_root = fs::read_dir(&locked).is_ok();
    fs::set_permissions(&locked, fs::Permissions::from_mode(0o755)).expect("permissions");
    assert!(text.contains("\nada     1 ") && !text.contains("elsewhere"), "{text}");
    let refusal = "locked  can't be read: no permission";
    assert!(is_root || text.matches("locked").count() == 1 && text.contains(refusal), "{text}");
}
