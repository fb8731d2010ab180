//! Tests the reports on made-up downloads from learning platforms. The downloads are already
//! unpacked. The shell commands on the page for teachers turn each download into one folder per
//! student.

use crate::program::{run_check, write_files};
use crate::{
    TitledAnswer, assert_locked, create_empty_folder, encode, locked_file, locked_picture,
    map_locked,
};
use course::{Step, camera_with_size, workspace};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Finds the paragraph that contains `phrase` on the page for teachers, and returns the shell
/// commands below this paragraph.
fn read_commands_for_teachers(phrase: &str) -> String {
    let path = workspace().join("book/src/teaching.md");
    let page =
        fs::read_to_string(path).expect("the page for teachers can be read").replace('\r', "");
    let (_, text_below) = page.split_once(phrase).expect("the page contains the phrase");
    let (_, text_below) = text_below.split_once("\n```sh\n").expect("shell commands follow");
    text_below.split_once("\n```\n").expect("the shell commands end").0.to_owned()
}

/// Runs shell commands in a folder. Panics if the commands fail or print errors.
fn run_shell(folder: &Path, commands: &str) {
    let mut shell = Command::new("sh");
    let output =
        shell.args(["-ec", commands]).current_dir(folder).output().expect("`sh` can be run");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{commands}\n{errors}");
}

/// Runs the shell commands for a platform on a download from that platform. Returns the report on
/// the resulting folders.
fn report_on_download<const COUNT: usize>(
    platform: &str,
    phrase: &str,
    files: [(&str, Vec<u8>); COUNT],
) -> TitledAnswer {
    let folder = create_empty_folder(&format!("download of {platform}"));
    let download = folder.join("a download");
    fs::create_dir_all(&download).expect("the folder can be created");
    write_files(&download, files);
    run_shell(&download, &read_commands_for_teachers(phrase));
    run_shell(&download, &read_commands_for_teachers("**a Mac** leaves"));
    let arguments = ["--in", "class", "--require", "step01_rays,step02_sphere"];
    let (title, text) = run_check(&folder, &arguments);
    (format!("{platform}, {title}"), text)
}

/// The contents of right pictures, of wrong pictures, and of files that aren't pictures.
struct SubmittedContents {
    rays: Vec<u8>,
    sphere: Vec<u8>,
    /// `rays` upside down.
    flipped: Vec<u8>,
    /// `sphere` with red and blue exchanged.
    bgr: Vec<u8>,
    /// Step 2 at 320×180.
    small: Vec<u8>,
    jpeg: Vec<u8>,
    text: Vec<u8>,
}

fn submitted_contents() -> SubmittedContents {
    SubmittedContents {
        rays: locked_file("step01_rays"),
        sphere: locked_file("step02_sphere"),
        flipped: encode(image::imageops::flip_vertical(&locked_picture("step01_rays"))),
        bgr: encode(map_locked("step02_sphere", |_, _, [r, g, b]| [b, g, r])),
        small: encode((Step::Sphere.draw_function())(&camera_with_size(320, 180), 1)),
        jpeg: b"\xff\xd8\xff\xe0\0\x10JFIF".to_vec(),
        text: b"text".to_vec(),
    }
}

const FOLDERS: &str = "**Moodle, D2L Brightspace, Gradescope and GitHub**";

/// Students submit files on seven platforms. Each picture appears in a report: the
/// report either calls the picture right, or points the teacher to the picture.
#[test]
fn made_up_downloads_are_reported_as_locked() {
    let SubmittedContents { rays, sphere, flipped, bgr, small, jpeg, text } = submitted_contents();
    let zip = || b"PK\x03\x04".to_vec();
    let reports = [
        report_on_download(
            "Moodle",
            FOLDERS,
            [
                ("Anna Müller_1201_assignsubmission_file/step01_rays.png", rays.clone()),
                ("Anna Müller_1201_assignsubmission_file/step02_sphere.png", sphere.clone()),
                ("Anna Müller_1202_assignsubmission_file/step01_rays.png", flipped.clone()),
                ("Anna Müller_1202_assignsubmission_file/step02_sphere.png", sphere.clone()),
                ("Bob O'Brien_1203_assignsubmission_file/homework.zip", zip()),
                ("Cleo [x]_1204_assignsubmission_file/step01_rays.jpg", jpeg.clone()),
                ("Dora_1205_assignsubmission_onlinetext/onlinetext.html", text.clone()),
                ("Emil_1206_assignsubmission_file/a/step01_rays.png", rays.clone()),
                ("Emil_1206_assignsubmission_file/a/__MACOSX/._step01_rays.png", text.clone()),
                ("Emil_1206_assignsubmission_file/.DS_Store", text.clone()),
                ("Emil_1206_assignsubmission_file/a/step02_sphere.png", sphere.clone()),
                (".DS_Store", text.clone()),
            ],
        ),
        report_on_download(
            "Moodle without folders",
            "**Moodle without folders**",
            [
                ("Fay Ng_1207_assignsubmission_file_step01_rays.png", rays.clone()),
                ("Fay Ng_1207_assignsubmission_file_step02_sphere.png", bgr.clone()),
                ("Sun Li [x]_1208_assignsubmission_file_Step_1.png", rays.clone()),
                ("notes.txt", text.clone()),
            ],
        ),
        report_on_download(
            "D2L",
            FOLDERS,
            [
                ("118-2034 - Ada Lovelace - Nov 28, 2026 1015 AM/step01_rays.png", rays.clone()),
                (
                    "118-2034 - Ada Lovelace - Nov 28, 2026 1015 AM/step02_sphere.png",
                    sphere.clone(),
                ),
                ("119-2034 - Bob Stone - Nov 27, 2026 900 AM/step01_rays.png", flipped.clone()),
                ("119-2034 - Bob Stone - Nov 28, 2026 915 AM/step01_rays.png", rays.clone()),
                ("119-2034 - Bob Stone - Nov 28, 2026 915 AM/step02_sphere.png", sphere.clone()),
                ("index.html", text.clone()),
            ],
        ),
        report_on_download(
            "Gradescope",
            FOLDERS,
            [
                ("submission_301/step01_rays.png", rays.clone()),
                ("submission_301/step02_sphere.png", small),
                ("submission_302/final/step01_rays.png", rays.clone()),
                ("submission_302/step01_rays.png", flipped.clone()),
                ("submission_metadata.yml", text.clone()),
            ],
        ),
        report_on_download(
            "GitHub",
            FOLDERS,
            [
                ("course-xX_bob_Xx/step01_rays.png", rays.clone()),
                ("course-xX_bob_Xx/.git/HEAD", text.clone()),
                (
                    "course-xX_bob_Xx/steps/locked/tests/snapshots/step02_sphere.snap.png",
                    sphere.clone(),
                ),
                ("course-ada/steps/step01_rays/src/main.rs", text.clone()),
                ("course-cleo/step01_rays.png", flipped.clone()),
                ("course-cleo/step02_sphere.png", bgr.clone()),
            ],
        ),
        report_on_download(
            "Canvas",
            "**Canvas**",
            [
                ("lovelaceada_4711_9901_step01_rays.png", rays.clone()),
                ("lovelaceada_4711_9902_step02_sphere.png", sphere.clone()),
                ("stonebob_LATE_4712_9903_step01_rays-1.png", flipped.clone()),
                ("stonebob_LATE_4712_9904_step01_rays-2.png", rays.clone()),
                ("stonebob_4713_9905_step_01_02_rays.png", rays.clone()),
                ("anon_i5D3f_88002_step01_rays.png", rays.clone()),
                ("anon_i5D3f_88003_step02_sphere.png", sphere.clone()),
                ("readme.txt", text.clone()),
            ],
        ),
        report_on_download(
            "Blackboard",
            "**Blackboard**",
            [
                ("Homework 1_alov1_attempt_2026-11-28-10-15-00.txt", text.clone()),
                ("Homework 1_alov1_attempt_2026-11-28-10-15-00_step01_rays.png", rays.clone()),
                ("Homework 1_alov1_attempt_2026-11-28-10-15-00_step02_sphere.png", sphere.clone()),
                ("Homework 1_bsto2_attempt_2026-11-27-09-00-00_step01_rays.png", flipped),
                ("Homework 1_bsto2_attempt_2026-11-28-09-15-00_step01_rays.png", rays.clone()),
                (
                    "Homework 1_bsto2_attempt_2026-11-28-09-15-00_step02_sphere.png",
                    locked_file("step03_nearest"),
                ),
            ],
        ),
        report_on_download(
            "Google Classroom",
            "**Google Classroom**",
            [
                ("Ada Lovelace - step01_rays.png", rays.clone()),
                ("Ada Lovelace - step 2 - sphere.png", sphere),
                ("Anna-Lena Meier - step01_rays.png", rays.clone()),
                ("Sun * Li - Step1.png", rays.clone()),
                ("Anna-Maria Huber - step02_sphere.png", bgr),
                ("step01_rays.png", rays),
                ("-rf - step01_rays.png", jpeg),
            ],
        ),
    ];
    assert_locked("downloads", reports);
}
