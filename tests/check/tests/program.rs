//! The program `check`: its arguments, its exit codes, and where it looks.

use super::{folder, locked, made, opened, right};
use gallery::{Step, workspace};
use image::{ImageFormat, Rgb, RgbaImage};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;
use std::{env, fs};
use tests::Program;

/// The program, built for this platform and profile.
fn command() -> Command {
    static PATH: LazyLock<PathBuf> =
        LazyLock::new(|| Program::new("check", "program").path());
    Command::new(&*PATH)
}

fn run(arguments: &[&str]) -> Output {
    command().args(arguments).output().expect("check runs")
}

#[test]
fn the_program_ends_with_0_1_or_2() {
    let folder = folder("codes");
    let path = |name: &str| folder.join(name).display().to_string();
    let right = right("step02_sphere");
    right.save(path("right.png")).expect("a file");
    made(Step::Sphere, &["a-is-a-length"], (640, 360), 1)
        .save(path("wrong.png"))
        .expect("a file");
    // Alpha and another name's end do not matter.
    let alpha = RgbaImage::from_fn(640, 360, |i, j| {
        let [r, g, b] = right.get_pixel(i, j).0;
        image::Rgba([r, g, b, 255])
    });
    alpha.save(path("alpha.png")).expect("a file");
    fs::copy(path("right.png"), path("right")).expect("a copy");

    for (file, name, code) in [
        ("right.png", None, 0),
        ("right.png", Some("step02_sphere"), 0),
        ("alpha.png", None, 0),
        ("right", None, 0),
        ("right.png", Some("step01_rays"), 1),
        ("wrong.png", Some("step02_sphere"), 1),
        ("wrong.png", None, 1),
    ] {
        let path = path(file);
        let arguments: Vec<_> = [path.as_str()].into_iter().chain(name).collect();
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert!(
            output.stderr.is_empty() && !output.stdout.is_empty(),
            "{output:?}"
        );
    }
    let wrong = run(&[&path("wrong.png")]).stdout;
    let wrong = String::from_utf8_lossy(&wrong);
    let (_, panels) = wrong.trim().rsplit_once("side by side: ").expect("a path");
    assert!(panels.ends_with("wrong.difference.png"), "{panels}");
    assert_eq!(opened(panels.as_ref()).dimensions(), (3 * 640, 380));
    let help = run(&["--help"]);
    assert!(help.status.success());
    assert!(String::from_utf8_lossy(&help.stdout).contains("step05_phong"));
}

#[test]
fn what_can_not_be_looked_at_is_told_in_one_sentence() {
    let folder = folder("refused");
    let path = |name: &str| folder.join(name).display().to_string();
    let right = fs::read(snapshot("step01_rays")).expect("a snapshot");
    fs::write(path("right.png"), &right).expect("a file");
    fs::write(path("empty.png"), "").expect("a file");
    fs::write(path("text.png"), "not a picture").expect("a file");
    fs::write(path("photo.png"), b"\xff\xd8\xff\xe0\0\x10JFIF\0\x01")
        .expect("a file");
    fs::write(path("short.png"), &right[..right.len() / 2]).expect("a file");
    fs::write(path("head.png"), &right[..20]).expect("a file");
    let mut flipped = right.clone();
    flipped[right.len() / 2] ^= 0x55;
    fs::write(path("flipped.png"), flipped).expect("a file");
    fs::write(path("huge.png"), huge()).expect("a file");
    fs::create_dir(path("folder.png")).expect("a folder");
    let (right, nowhere) = (path("right.png"), path("nowhere.png"));
    let all =
        "step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong";
    let cases: [(&[&str], &str); 11] = [
        (&[&nowhere], "can't read"),
        (&[&path("folder.png")], "is not a file"),
        (&[&path("empty.png")], "is not a PNG file"),
        (&[&path("text.png")], "is not a PNG file"),
        (&[&path("photo.png")], "is a JPEG, which has lost details"),
        (&[&path("short.png")], "is a damaged PNG file"),
        (&[&path("head.png")], "is a damaged PNG file"),
        (&[&path("flipped.png")], "is a damaged PNG file"),
        (&[&path("huge.png")], "is 200000×200000 pixels; allowed are 16384×16384"),
        (&[&right, "step06_mirror"], all),
        (&["--in", &nowhere], "is not a folder"),
    ];
    for (arguments, words) in cases {
        let output = run(arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        assert!(text.starts_with("error: ") && text.lines().count() == 1, "{text}");
        assert!(text.contains(words), "{arguments:?}: {text}");
    }
}

fn snapshot(name: &str) -> PathBuf {
    workspace().join(format!("tests/snapshots/{name}.snap.png"))
}

/// The beginning of a PNG file that says it has 200000×200000 pixels.
fn huge() -> Vec<u8> {
    let mut png = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".to_vec();
    png.extend([0, 3, 0x0D, 0x40, 0, 3, 0x0D, 0x40, 8, 2, 0, 0, 0]);
    png.extend([0x76, 0x59, 0x1F, 0x5D]); // their checksum
    png.extend(b"\0\0\x10\0IDAT\x78\x9c");
    png
}

/// A project with two pictures, the second of which no code draws.
fn project(test: &str) -> PathBuf {
    let folder = folder(test);
    let snapshots = folder.join("tests/snapshots");
    fs::create_dir_all(&snapshots).expect("a folder");
    fs::create_dir(folder.join("steps")).expect("a folder");
    fs::write(folder.join("Cargo.toml"), "").expect("a file");
    let mut other = right("step03_nearest");
    other.put_pixel(9, 9, Rgb([0; 3]));
    other.save(snapshots.join("step03_nearest.snap.png")).expect("a file");
    let whole = right("step02_sphere");
    whole.save(snapshots.join("step02_sphere.snap.png")).expect("a file");
    folder
}

#[test]
fn the_pictures_are_looked_up_when_the_program_runs() {
    let project = project("moved");
    let (inside, outside) = (project.join("tests"), env::temp_dir());
    let ours = command().get_program().to_owned();
    let copy = project.join("check").with_extension(env::consts::EXE_EXTENSION);
    fs::copy(&ours, &copy).expect("a copy");
    let copy = copy.into_os_string();
    let (two, all) =
        ("Names: step02_sphere, step03_nearest\n", "halfway, marbles, mirror\n");
    for (program, package, folder, names) in [
        (&ours, Some(&inside), &outside, two),
        (&ours, None, &inside, two),
        (&copy, None, &outside, two),
        (&ours, None, &outside, all),
    ] {
        let mut command = Command::new(program);
        command.arg("--help").current_dir(folder).env_remove("CARGO_MANIFEST_DIR");
        command.envs(package.map(|package| ("CARGO_MANIFEST_DIR", package)));
        let help = command.output().expect("check runs");
        let text = String::from_utf8_lossy(&help.stdout).into_owned();
        assert!(text.contains(names), "{folder:?}: {text}");
    }
}

#[test]
fn where_our_own_code_is_wrong_it_says_so_first() {
    let project = project("broken");
    let file = project.join("my.png");
    let asked = |step: Step, mistakes: &[&str]| {
        made(step, mistakes, (640, 360), 1).save(&file).expect("a file");
        let mut command = command();
        command.env("CARGO_MANIFEST_DIR", &project).arg(&file).arg(step.name());
        let output = command.output().expect("check runs");
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    for mistakes in [&[][..], &["farthest"]] {
        let text = asked(Step::Nearest, mistakes);
        let told = "The code in our folder does not draw the locked picture of step03_nearest";
        assert!(text.starts_with(told) && !text.contains(" when "), "{text}");
    }
    // The other step is whole.
    let text = asked(Step::Sphere, &["a-is-a-length"]);
    assert!(text.contains("is what you get when a is the length"), "{text}");
}

/// What it says with these arguments in this folder, and its exit code.
fn said(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = command().current_dir(folder).args(arguments).output();
    let Output { status, stdout, stderr } = output.expect("check runs");
    (
        status.code(),
        String::from_utf8_lossy(&[stdout, stderr].concat()).into_owned(),
    )
}

#[test]
fn without_a_file_it_ticks_off_every_picture_of_the_course() {
    let folder = folder("table");
    let (code, text) = said(&folder, &[]);
    assert_eq!(code, Some(2), "{text}");
    assert_eq!(text.matches(" not there\n").count(), locked().len(), "{text}");
    right("step01_rays").save(folder.join("step01_rays.png")).expect("a file");
    right("glass").save(folder.join("glass.png")).expect("a file");
    let (code, text) = said(&folder, &[]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("2 of ") && text.contains("\nglass           right\n"));
    let mirrored = made(Step::Nearest, &["mirrored"], (640, 360), 1);
    mirrored.save(folder.join("step03_nearest.png")).expect("a file");
    fs::write(folder.join("sun.png"), "no picture").expect("a file");
    let path = folder.display().to_string();
    let (code, text) = said(&env::temp_dir(), &["--in", &path]);
    assert_eq!(code, Some(1), "{text}");
    for row in [
        "step01_rays     right\n",
        "step03_nearest  not right: your picture of step03_nearest is what you get when x",
        "step02_sphere   not there\n",
        "sun             not right: sun.png is not a PNG file\n",
    ] {
        assert!(text.contains(row), "{row}: {text}");
    }
}

#[test]
fn the_name_of_the_file_tells_whose_picture_it_is() {
    let folder = folder("names");
    let picture = made(Step::Sphere, &["never-hits"], (640, 360), 1);
    for (file, words) in [
        ("my-step02_sphere.png", "your picture of step02_sphere is what you get"),
        ("step2.png", "your picture of step02_sphere is what you get"),
        (
            "Step05_2.PNG",
            "this is the picture of step01_rays, not of step05_phong.",
        ),
        ("glass (1).png", "this is the picture of step01_rays, not of glass."),
        ("glasses.png", "Right: this is the picture of step01_rays"),
        ("-dash.png", "Right: this is the picture of step01_rays"),
    ] {
        picture
            .save_with_format(folder.join(file), ImageFormat::Png)
            .expect("a file");
        let (_, text) = said(&folder, &["--", file]);
        assert!(text.contains(words), "{file}: {text}");
    }
    let (_, text) = said(&folder, &["step2.png", "step01_rays"]);
    assert!(text.starts_with("Right:"), "a name that is given counts: {text}");
}

#[test]
fn wrong_arguments_are_refused() {
    let folder = folder("arguments");
    for arguments in [
        &["a.png", "step01_rays", "more"][..],
        &["--width", "640"],
        &["a.png", "--in", "."],
        &["-dash.png"],
    ] {
        let (code, text) = said(&folder, arguments);
        assert_eq!(code, Some(2), "{text}");
        assert!(
            text.starts_with("error: ") && text.contains("Usage: check"),
            "{text}"
        );
    }
}
