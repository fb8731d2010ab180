//! Tests the program `check`: its options, exit codes, errors and JSON.

use crate::{
    TitledAnswer, assert_locked, create_empty_folder, draw_generated_scene, encode, locked_file,
    map_locked,
};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Runs `check` with these arguments in this folder. Returns the command, and a text with the exit
/// code and the output.
pub fn run_check(folder: &Path, arguments: &[&str]) -> TitledAnswer {
    let mut command = Command::new(env!("CARGO_BIN_EXE_check"));
    let output = command.current_dir(folder).args(arguments).output().expect("`check` can be run");
    let Output { status, stdout, stderr } = output;
    let [out, error] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    let code = status.code().unwrap_or(-1);
    let stream = if error.is_empty() { "" } else { ", standard error" };
    let text = format!("[exit code {code}{stream}]\n{out}{error}");
    // The text after `side by side:` begins with a path that differs between machines. Cut off this
    // text.
    let text = text.split_inclusive("side by side:").next().unwrap_or_default();
    (format!("check {}", arguments.join(" ")), text.to_owned())
}

/// Writes files to a folder and to its subfolders.
pub fn write_files<const COUNT: usize>(folder: &Path, files: [(&str, Vec<u8>); COUNT]) {
    for (file, bytes) in files {
        let path = folder.join(file);
        fs::create_dir_all(path.parent().expect("the file is in a folder"))
            .expect("the folder can be created");
        fs::write(path, bytes).expect("the file can be written");
    }
}

#[test]
fn answers_about_one_file_are_as_locked() {
    let folder = create_empty_folder("one_file");
    let hole = |i, j, ours| if (i, j) == (320, 180) { [0; 3] } else { ours };
    let odd_name = "a\u{1b}[2J\u{202e}.png";
    write_files(
        &folder,
        [
            ("step2.png", locked_file("step02_sphere")),
            ("my.png", encode(map_locked("step02_sphere", hole))),
            ("red.png", encode(map_locked("step05_phong", |_, _, [r, g, b]| [b, g, r]))),
            ("ada.png", encode(draw_generated_scene("ada"))),
            (odd_name, b"text".to_vec()),
        ],
    );
    let runs: [&[&str]; 14] = [
        &["step2.png"],
        &["my.png"],
        &["my.png", "step02_sphere"],
        &["red.png", "--json"],
        &["ada.png", "--scene", "ada"],
        &["--scene", " ada\t"],
        &["--scene", "ada", "--csv"],
        &["nowhere.png", "--json"],
        &["."],
        &[odd_name],
        &["step2.png", "step06_mirror"],
        &["--in", "nowhere", "--json"],
        &["--width", "640", "--json"],
        &["--help"],
    ];
    assert_locked("one_file", runs.map(|arguments| run_check(&folder, arguments)));
}
