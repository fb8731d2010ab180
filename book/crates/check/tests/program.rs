//! The program `check`: its arguments, its exit codes, and where it looks.

use crate::{create_empty_folder, locked_picture};
use image::{Rgb, RgbImage};
use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs};

/// Runs it with these arguments in this folder; gives its exit code and its text.
fn run_check(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    let output = command.current_dir(folder).args(arguments).output();
    let Output { status, stdout, stderr } = output.expect("check runs");
    assert!(stdout.is_empty() != stderr.is_empty(), "{arguments:?}");
    let text = [stdout, stderr].concat();
    let text = String::from_utf8_lossy(&text).into_owned();
    // After a changed picture, nothing else can be told.
    assert!(!text.contains("of another version"), "{text}");
    (status.code(), text)
}

#[test]
fn exit_code_is_0_right_1_wrong() {
    let folder = create_empty_folder("codes");
    let ours = locked_picture("step02_sphere");
    ours.save(folder.join("step2.png")).expect("a file");
    let mut wrong = ours.clone();
    wrong.put_pixel(320, 180, Rgb([0; 3]));
    wrong.save(folder.join("my.png")).expect("a file");
    for (arguments, code) in [
        (&["step2.png"][..], 0),
        (&["step2.png", "step02_sphere"], 0),
        (&["step2.png", "step01_rays"], 1),
        (&["my.png"], 1),
    ] {
        assert_eq!(run_check(&folder, arguments).0, Some(code), "{arguments:?}");
    }
    let (_, text) = run_check(&folder, &["my.png"]);
    let (_, panels) = text.trim().rsplit_once("side by side: ").expect("a path");
    let panels = image::open(panels).expect("a picture");
    assert_eq!((panels.width(), panels.height()), (3 * 640, 360));
    assert!(text.contains("Column 320, row 180: yours is (0, 0, 0), ours (232, 87, 71)"), "{text}");
    assert!(text.contains("1 of 230400 pixels differ"), "{text}");
}

#[test]
fn unusable_input_gives_one_line_and_exit_code_2() {
    let folder = create_empty_folder("refused");
    let mut right = vec![];
    let picture = crate::locked_picture("step01_rays");
    picture.write_with_encoder(image::codecs::png::PngEncoder::new(&mut right)).expect("a picture");
    let write = |name: &str, bytes: &[u8]| {
        fs::write(folder.join(name), bytes).expect("a file");
    };
    write("right.png", &right);
    write("empty.png", b"");
    write("text.png", b"not a picture");
    write("photo.png", b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01");
    write("short.png", &right[..right.len() / 2]);
    let mut huge = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    huge.extend([0, 3, 0x0D, 0x40, 0, 3, 0x0D, 0x40, 8, 2, 0, 0, 0]);
    huge.extend(b"\x76\x59\x1f\x5d\0\0\x10\0IDAT\x78\x9c");
    write("huge.png", &huge);
    for (arguments, words) in [
        (&["nowhere.png"][..], "can't read"),
        (&["."], "is not a file"),
        (&["empty.png"], "is not a PNG file"),
        (&["text.png"], "is not a PNG file, but text"),
        (&["photo.png"], "is a JPEG, which has lost details"),
        (&["short.png"], "is a damaged PNG file"),
        (&["huge.png"], "is too large: pictures of up to 4096×4096"),
        (&["right.png", "step06_mirror"], "step01_rays, step02_sphere"),
        (&["--in", "nowhere"], "is not a folder"),
    ] {
        let (code, text) = run_check(&folder, arguments);
        assert_eq!(code, Some(2), "{text}");
        assert!(text.starts_with("error: ") && text.lines().count() == 1, "{text}");
        assert!(text.contains(words), "{text}");
    }
    for arguments in [&["a.png", "step01_rays", "more"][..], &["--width", "640"]] {
        let (code, text) = run_check(&folder, arguments);
        assert!(code == Some(2) && text.contains("Usage: check"), "{text}");
    }
    let (code, help) = run_check(&folder, &["--help"]);
    assert!(code == Some(0) && help.contains("step05_phong, "), "{help}");
}

#[test]
fn without_a_file_each_picture_of_the_course_is_reported() {
    let folder = create_empty_folder("table");
    let count = crate::locked().len();
    let (code, text) = run_check(&folder, &["--in", "."]);
    assert!(code == Some(1) || code == Some(2), "{text}");
    assert_eq!(text.matches(" missing\n").count(), count, "{text}");
    locked_picture("glass").save(folder.join("glass.png")).expect("a file");
    let (code, text) = run_check(&folder, &[]);
    assert!(code == Some(0) && text.contains("\nglass "), "{text}");
    image::imageops::flip_vertical(&locked_picture("glass"))
        .save(folder.join("sun.png"))
        .expect("a file");
    let (code, text) = run_check(&env::temp_dir(), &["--in", &folder.display().to_string()]);
    assert!(code == Some(1) && text.contains("not right: "), "{text}");
    assert!(text.contains(&format!("1 of {count} are right.")), "{text}");
}

#[test]
fn the_name_of_the_file_tells_whose_picture_it_is() {
    let names = || ["step01_rays", "step02_sphere", "glass"].into_iter();
    for (file, name) in [
        ("my-step02_sphere.png", Some("step02_sphere")),
        ("step2.png", Some("step02_sphere")),
        ("Step01_2.PNG", Some("step01_rays")),
        ("a/glass (1).png", Some("glass")),
        ("glasses.png", None),
    ] {
        assert_eq!(check::find_name_in_file_name(file, names()), name, "{file}");
    }
}

#[test]
fn pipes_folders_and_huge_files_are_unreadable() {
    let folder = create_empty_folder("devices");
    let pipe = folder.join("sun.png");
    let is_made = Command::new("mkfifo").arg(&pipe).status();
    let is_made = is_made.is_ok_and(|status| status.success());
    let file = fs::File::create(folder.join("glass.png")).expect("a file");
    file.set_len(3 << 30).expect("a sparse file");
    fs::create_dir(folder.join("plane.png")).expect("a folder");
    fs::write(folder.join("lens.png"), "<!doctype html><p>404").expect("a file");
    let (code, text) = run_check(&folder, &["--in", "."]);
    assert_eq!(code, Some(1), "{text}");
    for (name, words) in [
        ("glass", "is too large: a picture has at most 128 MB"),
        ("plane", "is not a file"),
        ("lens", "is a web page"),
    ] {
        let line = text.lines().find(|line| line.starts_with(name));
        let line = line.expect("a line for each picture");
        assert!(line.contains("unreadable: ") && line.contains(words), "{line}");
    }
    assert!(!is_made || text.contains("sun.png is not a file"), "{text}");
    let (code, text) = run_check(&folder, &["a\u{1b}[2J\u{202e}.png"]);
    assert!(code == Some(2) && text.contains("a\\u{1b}[2J\\u{202e}.png"), "{text}");
}

#[test]
fn folder_of_folders_gets_one_line_each() {
    let folder = create_empty_folder("class");
    for student in ["ada", "bob", "cleo"] {
        fs::create_dir(folder.join(student)).expect("a folder");
    }
    let save = |picture: &RgbImage, path: &str| {
        picture.save(folder.join(path)).expect("a file");
    };
    let [sky, glass] = ["step01_rays", "glass"].map(locked_picture);
    let (_, ada) = course::draw_named_scene("ada");
    save(&sky, "ada/step01_rays.png");
    save(&glass, "ada/sun.png");
    save(&glass, "ada/glass.png");
    save(&ada, "ada/scene_of_me.png");
    save(&ada, "bob/scene_of_me.png");
    let (code, text) = run_check(&folder, &[]);
    assert_eq!(code, Some(1), "{text}");
    let lines = [
        "      right  step01_rays  scene_of_me  others",
        "ada   3      right        right        1 of 2",
        "bob   0      missing      not right    0 of 0",
        "cleo  0      missing      missing      0 of 0",
    ];
    assert_eq!(text.trim_end(), lines.join("\n"));
    let (code, json) = run_check(&folder, &["--json"]);
    assert_eq!(code, Some(1), "{json}");
    let entry = "{\"picture\": \"glass\", \"verdict\": \"right\", \"text\": \"\"}";
    assert!(json.starts_with("[\n  {\"folder\": \"ada\", ") && json.contains(entry), "{json}");
    let reason = "\"not right\", \"text\": \"Not the scene of bob: ";
    assert!(json.contains(reason), "{json}");
    let count = crate::locked().len() + 1;
    assert_eq!(json.matches("\"verdict\": ").count(), 3 * count, "{json}");
}

#[test]
fn pictures_under_another_name_are_told() {
    let folder = create_empty_folder("unchecked");
    for path in ["ada/old", "bob/bob/steps", "cleo"] {
        fs::create_dir_all(folder.join(path)).expect("a folder");
    }
    let sky = locked_picture("step01_rays");
    let sky = |path: &str| sky.save(folder.join(path)).expect("a file");
    sky("step01_rays.png");
    sky("ada/step01_rays.png");
    sky("ada/step01_rays (1).png");
    sky("ada/old/step01_rays.png");
    sky("bob/bob/step01_rays.png");
    for name in ["my depth.PNG", "step03.jpg", "notes.txt", ".hidden.png"] {
        fs::write(folder.join("cleo").join(name), "").expect("a file");
    }
    let (code, text) = run_check(&folder, &[]);
    assert_eq!(code, Some(0), "{text}");
    let lines = [
        "      right  step01_rays",
        "ada   1      right",
        "bob   0      missing",
        "cleo  0      missing",
        "Not looked at: step01_rays.png, ada/step01_rays (1).png, ada/old/, bob/bob/, \
         cleo/my depth.PNG, cleo/step03.jpg.",
    ];
    assert_eq!(text.trim_end(), lines.join("\n"));
    let (_, json) = run_check(&folder, &["--json"]);
    assert!(json.contains("\"not_looked_at\": [\"bob/\"]"), "{json}");
    for k in 0..9 {
        sky(&format!("x{k}.png"));
    }
    let (_, text) = run_check(&folder, &[]);
    assert!(text.trim_end().ends_with(", x5.png, x6.png and 7 more."), "{text}");
    // A workspace is one folder, whatever folders it has.
    fs::write(folder.join("Cargo.toml"), "").expect("a file");
    let (_, text) = run_check(&folder, &[]);
    assert!(text.contains(" are right.\nNot looked at: x0.png, "), "{text}");
}

#[test]
fn scene_of_a_name_is_printed_and_compared() {
    let folder = create_empty_folder("scene");
    let (code, program) = run_check(&folder, &["--scene", "ada"]);
    assert_eq!(code, Some(0), "{program}");
    assert!(program.starts_with("//! The scene of ada. This draws it:\n"), "{program}");
    let command = "\n//! `cargo run -p step05_phong --example scene_of_me`\n";
    assert!(program.contains(command), "{program}");
    let (_, other) = run_check(&folder, &["--scene", " ada\t"]);
    assert_eq!(other, program);
    let (_, mut picture) = course::draw_named_scene("ada");
    let path = folder.join("ada.png");
    picture.save(&path).expect("a file");
    let run = |name| run_check(&folder, &["--scene", name, "ada.png"]);
    let (code, text) = run("ada");
    assert_eq!((code, text.starts_with("Right: ")), (Some(0), true), "{text}");
    let (code, text) = run("Ada");
    assert_eq!((code, text.contains(" pixels differ")), (Some(1), true), "{text}");
    picture.get_pixel_mut(7, 5).0[1] ^= 2;
    picture.save(&path).expect("a file");
    let (_, text) = run("ada");
    let words = "1 of 230400 pixels differ, by up to 2 of 255; the first is in column 7, row 5";
    assert!(text.contains(words), "{text}");
    RgbImage::new(2, 1).save(&path).expect("a file");
    let (_, text) = run("ada");
    assert!(text.contains("it has 2×1 pixels, and ours 640×360"), "{text}");
    let (code, text) = run_check(&folder, &["--scene", "ada", "nowhere.png"]);
    assert!(code == Some(2) && text.starts_with("error: can't read"), "{text}");
    for blanks in ["", " \t"] {
        let (code, text) = run_check(&folder, &["--scene", blanks]);
        let words = "a name is more than blanks";
        assert!(code == Some(2) && text.contains(words), "{text}");
    }
    let (code, text) = run_check(&folder, &["--scene", "ada", "--json"]);
    assert!(code == Some(2) && text.contains("cannot be used with"), "{text}");
}

#[test]
fn changed_picture_is_of_another_version() {
    let mut ours = crate::locked()[0].clone();
    ours.picture.put_pixel(9, 9, Rgb([0; 3]));
    assert!(!ours.has_compiled_hash());
}
