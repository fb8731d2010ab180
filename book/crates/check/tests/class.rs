//! Tests the reports on a class and on a reader's own pictures, and the sheets for a class.

use crate::program::{run_check, write_files};
use crate::{
    assert_locked, create_empty_folder, draw_generated_scene, encode, locked_file, map_locked,
};
use course::{Step, camera_with_fov, camera_with_size};
use std::fs;
use std::path::Path;

const REQUIRED: &str = "step01_rays,step02_sphere";

#[test]
fn reports_on_a_class_are_as_locked() {
    let folder = create_empty_folder("class");
    let [rays, sphere] = ["step01_rays", "step02_sphere"].map(locked_file);
    let bgr = |name| encode(map_locked(name, |_, _, [r, g, b]| [b, g, r]));
    let flipped = |name| encode(image::imageops::flip_vertical(&crate::locked_picture(name)));
    let by_one = |i, j, [r, g, b]: [u8; 3]| [r - u8::from((i, j) == (320, 180)), g, b];
    let by_one = encode(map_locked("step02_sphere", by_one));
    let wide = |step: Step| encode((step.draw_function())(&camera_with_fov(120.0, 640), 1));
    let small = encode((Step::Sphere.draw_function())(&camera_with_size(320, 180), 1));
    write_files(
        &folder,
        [
            ("class/Ada L/Step 01 - Rays.PNG", rays.clone()),
            ("class/Ada L/all/step2 (1).png", sphere.clone()),
            ("class/=Bob/step01_rays.png", bgr("step01_rays")),
            ("class/=Bob/step02_sphere.png", bgr("step02_sphere")),
            ("class/=Bob/glass.png", locked_file("glass")),
            ("class/Cleo/step01_rays.png", flipped("step01_rays")),
            ("class/Cleo/step02_sphere.png", flipped("step02_sphere")),
            ("class/Dan/step01_rays.png", wide(Step::Rays)),
            ("class/Dan/step02_sphere.png", wide(Step::Sphere)),
            ("class/Dora/step01_rays.png", wide(Step::Rays)),
            ("class/Dora/step02_sphere.png", small),
            ("class/Edith/step02_sphere.png", by_one),
            ("class/Emil/step01_rays.png", sphere.clone()),
            ("class/Emil/final/step01_rays.png", rays.clone()),
            ("class/Emil/final/step02_sphere.png", sphere.clone()),
            ("class/Fay/step02_sphere.jpg", b"\xff\xd8\xff".to_vec()),
            ("class/Fay/IMG_1.HEIC", b"heic".to_vec()),
            ("class/Fay/homework.zip", b"PK\x03\x04".to_vec()),
            ("class/Fay/.git/step01_rays.png", rays.clone()),
            ("class/Fay/a/b/c/d/e/f/g/h/step01_rays.png", rays.clone()),
            ("class/target/step01_rays.png", rays.clone()),
            ("class/target/step02_sphere.snap.png", sphere.clone()),
            ("class/index.html", b"<html>".to_vec()),
            ("class/Gus.zip", b"PK\x03\x04".to_vec()),
            ("right/Ada L/step01_rays.png", rays.clone()),
            ("wrong/Ada L/step01_rays.png", flipped("step01_rays")),
            ("beside/Ada L/step01_rays.png", rays.clone()),
            ("beside/Bob.zip", b"PK\x03\x04".to_vec()),
            ("flat/Ada L - step01_rays.png", rays.clone()),
            ("flat/Bob - step01_rays.png", bgr("step01_rays")),
            ("names.txt", "\u{feff}Ada L\r\n\nHeidi\nFay\n".as_bytes().to_vec()),
            ("no_names.txt", b"\n\n".to_vec()),
            ("latin1.txt", b"J\xf6rg".to_vec()),
        ],
    );
    fs::create_dir_all(folder.join("class/Ivo")).expect("the folder can be created");
    fs::create_dir_all(folder.join("empty")).expect("the folder can be created");
    let runs: [&[&str]; 16] = [
        &["--in", "class", "--require", REQUIRED],
        &["--in", "class", "--require", REQUIRED, "--csv"],
        &["--in", "class", "--require", REQUIRED, "--json"],
        &["--in", "class", "--names", "names.txt"],
        &["--in", "right"],
        &["--in", "wrong"],
        &["--in", "beside"],
        &["--in", "right", "--require", "step01_rays,glass"],
        &["--in", "right", "--names", "names.txt", "--require", "step01_rays"],
        &["--in", "right", "--names", "no_names.txt"],
        &["--in", "right", "--names", "latin1.txt"],
        &["--in", "right", "--require", "step01_rays,nowhere"],
        &["--in", "right", "--require", "\u{1b}[2J"],
        &["--in", "flat"],
        &["--in", "empty"],
        &["--in", "class/index.html"],
    ];
    assert_locked("class", runs.map(|arguments| run_check(&folder, arguments)));
}

#[test]
fn reports_on_a_readers_own_pictures_are_as_locked() {
    let folder = create_empty_folder("own");
    write_files(
        &folder,
        [
            ("own/glass.png", locked_file("glass")),
            ("own/sun.png", locked_file("plane")),
            ("own/Plane (1).PNG", locked_file("plane")),
            ("own/disc.png", b"text".to_vec()),
            ("own/hourglass.png", locked_file("glass")),
            ("own/step12.png", locked_file("step01_rays")),
            ("own/Step 3 final.png", locked_file("step03_nearest")),
            ("own/glass.rs", b"fn main() {}".to_vec()),
            ("own/below/step01_rays.png", locked_file("step02_sphere")),
            ("nothing/notes.txt", b"text".to_vec()),
        ],
    );
    let runs: [(&str, &[&str]); 4] = [
        ("own", &[]),
        ("own", &["--require", "plane,glass", "--json"]),
        ("own", &["--require", "plane,step01_rays"]),
        ("nothing", &[]),
    ];
    let answers = runs.map(|(subfolder, arguments)| run_check(&folder.join(subfolder), arguments));
    assert_locked("own_pictures", answers);
}

/// The names of the folders in this test are allowed only on Linux.
#[test]
#[cfg(target_os = "linux")]
fn odd_names_of_folders_stay_apart() {
    use std::ffi::OsStr;
    use std::os::unix::{ffi::OsStrExt, fs::symlink};
    let folder = create_empty_folder("odd_names");
    let [rays, sphere] = ["step01_rays", "step02_sphere"].map(locked_file);
    let write = |student: &[u8], file: &[u8]| {
        let student = folder.join("class").join(OsStr::from_bytes(student));
        fs::create_dir_all(&student).expect("the folder can be created");
        fs::write(student.join("step01_rays.png"), file).expect("the file can be written");
    };
    write(b"J\x94rg", &rays);
    write(b"J\x81rg", &sphere);
    write("D\u{f6}ra".as_bytes(), &rays);
    write("Do\u{308}ra".as_bytes(), &sphere);
    write(b"\x1b[2J\x07", &rays);
    write("\u{9b}2J\u{202e}\u{7f}".as_bytes(), &rays);
    write(b"\t=1+1", &rays);
    write("\u{ff1d}1+1".as_bytes(), &rays);
    symlink("J\u{9b}rg", folder.join("class/link")).expect("the link can be created");
    symlink("nowhere", folder.join("class/D\u{f6}ra/step02_sphere.png"))
        .expect("the link can be created");
    fs::write(folder.join("names.txt"), "D\u{f6}ra").expect("the file can be written");
    let runs: [&[&str]; 3] = [
        &["--in", "class", "--names", "names.txt"],
        &["--in", "class", "--csv"],
        &["--in", "class", "--json"],
    ];
    let answers = runs.map(|arguments| run_check(&folder, arguments));
    for (_, answer) in &answers {
        assert!(!answer.contains(|c: char| c.is_control() && c != '\n'), "{answer:?}");
    }
    assert_locked("odd_names", answers);
}

#[test]
fn folders_with_too_many_entries_are_reported() {
    let folder = create_empty_folder("many_entries");
    write_files(&folder, [("class/Ada/step01_rays.png", locked_file("step01_rays"))]);
    for k in 0..9 {
        let file = format!("class/Bob/step01_rays-{k}.png");
        write_files(&folder, [(&file, locked_file("step01_rays"))]);
    }
    fs::create_dir_all(folder.join("class/Ada/more")).expect("the folder can be created");
    for k in 0..10_000 {
        fs::write(folder.join(format!("class/Ada/more/{k}")), "").expect("the file can be written");
    }
    let runs: [&[&str]; 2] = [&["--in", "class"], &["--in", "class/Ada/more"]];
    assert_locked("many_entries", runs.map(|arguments| run_check(&folder, arguments)));
    let _ = fs::remove_dir_all(&folder);
}

/// Returns the names and texts of all files in a folder.
fn read_folder(folder: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(folder).expect("the folder can be read").flatten();
    let mut files: Vec<_> = entries
        .map(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, fs::read_to_string(entry.path()).expect("the file is a text"))
        })
        .collect();
    files.sort();
    files
}

#[test]
fn scene_sheets_are_as_locked() {
    let folder = create_empty_folder("sheets");
    let dora = encode(draw_generated_scene("D\u{f6}ra"));
    write_files(
        &folder,
        [
            ("names.txt", "\u{feff}Ada Lo\u{308}velace\r\n\n../Zo\u{eb} <b>".as_bytes().to_vec()),
            ("twice.txt", b"Anna M\nBob\nAnna M\n".to_vec()),
            ("alike.txt", b"a/b\na:B\n".to_vec()),
            ("long.txt", format!("Bob\n{}\n", "x".repeat(300)).into_bytes()),
            ("full/other.txt", b"text".to_vec()),
            ("dora.png", dora),
        ],
    );
    let runs: [&[&str]; 11] = [
        &["--names", "names.txt", "--out", "sheets", "--answers"],
        &["--names", "names.txt", "--out", "others", "--secret", "walrus"],
        &["--scene", "Bob", "--out", "for Bob"],
        &["--names", "names.txt", "--out", "full"],
        &["--names", "twice.txt", "--out", "new"],
        &["--names", "alike.txt", "--out", "new"],
        &["--names", "names.txt", "--out", ".."],
        &["--names", "names.txt", "--out", "new", "--csv"],
        &["--names", "names.txt"],
        &["--scene", "Do\u{308}ra", "dora.png"],
        &["dora.png", "--scene", "Dora", "--secret", "walrus"],
    ];
    assert_locked("writing_sheets", runs.map(|arguments| run_check(&folder, arguments)));
    assert_locked("sheets", read_folder(&folder.join("sheets")));
    // These answers aren't in a snapshot, because the system's error message differs between
    // machines.
    for arguments in [["long.txt", "new"], ["names.txt", "full/other.txt/new"]] {
        let [names, out] = arguments;
        let (_, text) = run_check(&folder, &["--names", names, "--out", out]);
        assert!(text.starts_with("[exit code 2, standard error]"), "{text}");
    }
    let entries = fs::read_dir(&folder).expect("the folder can be read").flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name()).collect();
    names.sort();
    let expected = [
        "alike.txt",
        "dora.png",
        "for Bob",
        "full",
        "long.txt",
        "names.txt",
        "others",
        "sheets",
        "twice.txt",
    ];
    assert_eq!(names, expected);
    assert_eq!(read_folder(&folder.join("full")), [("other.txt".into(), "text".into())]);
    let sheets_with_secret = read_folder(&folder.join("others"));
    assert!(
        sheets_with_secret.iter().all(|(name, text)| !format!("{name} {text}").contains("walrus"))
    );
    assert_ne!(sheets_with_secret, read_folder(&folder.join("sheets")));
}

#[test]
fn most_scene_sheets_ask_about_a_ray_that_meets_two_balls() {
    let sheets = (0..40).map(|k| check::format_sheet(&format!("student {k}"), None));
    let has_two_balls = |sheet: &String| sheet.contains("first meet each of them");
    let count = sheets.filter(has_two_balls).count();
    assert!(count > 30, "{count} of 40");
}
