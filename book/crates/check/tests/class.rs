//! Reports on one's own folder, and on classes as learning platforms give them.

use crate::program::{run_check, write_files};
use crate::{assert_locked, create_empty_folder, draw_scene, encode, locked_file, map_locked};
use std::fs;
use std::io::Write;

fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut bytes = vec![];
    let mut archive = rawzip::ZipArchiveWriter::new(&mut bytes);
    for (name, content) in files {
        let method = rawzip::CompressionMethod::DEFLATE;
        let file = archive.new_file(*name).compression_method(method).start();
        let (mut entry, config) = file.expect("a file");
        let level = flate2::Compression::fast();
        let mut writer = config.wrap(flate2::write::DeflateEncoder::new(&mut entry, level));
        writer.write_all(content).expect("its bytes");
        let (encoder, descriptor) = writer.finish().expect("its end");
        encoder.finish().expect("its end");
        entry.finish(descriptor).expect("its end");
    }
    archive.finish().expect("an archive");
    bytes
}

#[test]
fn reports_on_folders_are_as_locked() {
    let folder = create_empty_folder("folders");
    let [rays, sphere] = ["step01_rays", "step02_sphere"].map(locked_file);
    let bgr = |name| encode(map_locked(name, |_, _, [r, g, b]| [b, g, r]));
    let scene = |name: &str| encode(draw_scene(name));
    let two_pictures = zip(&[("raycaster/step01_rays.png", &rays), ("__MACOSX/._a.png", b"")]);
    let nested = zip(&[("my/pictures.zip", &two_pictures), ("my/notes.txt", b"text")]);
    write_files(
        &folder,
        [
            ("moodle/A1/Ada L_471_assignsubmission_file/scene_of_me.png", scene("Ada L")),
            ("moodle/A1/Ada L_471_assignsubmission_file/out/Step1 (1).PNG", rays.clone()),
            ("moodle/A1/Ada L_471_assignsubmission_onlinetext/online.html", b"<html>".to_vec()),
            ("moodle/A1/Bob_472_assignsubmission_file/scene_of_me.png", scene("Ada L")),
            ("moodle/A1/Bob_472_assignsubmission_file/step02_sphere.jpg", b"\xff\xd8\xff".to_vec()),
            ("moodle/A1/Bob_473_assignsubmission_file/IMG_1.HEIC", b"heic".to_vec()),
            ("moodle/A1/Cleo_474_assignsubmission_file.zip", two_pictures.clone()),
            ("moodle/A1/Do\u{308}ra_475_assignsubmission_file/scene_of_me.png", scene("D\u{f6}ra")),
            ("moodle/A1/Emil_476_assignsubmission_file/all.zip", nested),
            ("moodle/A1/Fay_477_assignsubmission_file/all.zip", two_pictures[..99].to_vec()),
            ("moodle/A1/Gus_478_assignsubmission_file/.hidden.png", vec![]),
            ("moodle/A1/Sun Li_479_assignsubmission_file_Step1.png", rays.clone()),
            ("canvas/l\u{f6}velaceada_4711_99_step01_rays-2.png", rays.clone()),
            ("canvas/l\u{f6}velaceada_4711_98_step01_rays-1.png", sphere.clone()),
            ("canvas/bob_LATE_4712_97_step02_sphere.png", sphere.clone()),
            ("canvas/bob_4713_95_step01_rays.png", rays.clone()),
            ("canvas/l\u{f6}velaceada_4711_96_scene_of_me.png", scene("Ada L\u{f6}velace")),
            ("canvas/step01_rays.png", vec![]),
            (
                "canvas.zip",
                zip(&[
                    ("submissions/bob_4712_97_step01_rays.png", &rays),
                    ("submissions/cleo_4713_96_my.zip", &two_pictures),
                ]),
            ),
            ("names.txt", "\u{feff}Ada Lo\u{308}velace\r\n\n../Zo\u{eb}".as_bytes().to_vec()),
            ("own/glass.png", locked_file("glass")),
            ("own/sun.png", locked_file("plane")),
            ("own/Plane (1).PNG", locked_file("plane")),
            ("own/disc.png", b"text".to_vec()),
            ("own/hourglass.png", locked_file("glass")),
            ("own/step12.png", rays.clone()),
            ("own/Step 3 final.png", locked_file("step03_nearest")),
            ("github/raycaster-ada/step01_rays.png", bgr("step01_rays")),
            ("github/raycaster-ada/step02_sphere.png", bgr("step02_sphere")),
            ("github/raycaster-ada/glass.png", locked_file("glass")),
            ("github/raycaster-=bob/step01_rays.png", rays),
            ("github/raycaster-=bob/locked/tests/snapshots/step02_sphere.snap.png", sphere),
        ],
    );
    let required = "step01_rays,step02_sphere,scene";
    let dora = "moodle/A1/Do\u{308}ra_475_assignsubmission_file/scene_of_me.png";
    let runs: [&[&str]; 10] = [
        &["--in", "own"],
        &["--in", "own", "--require", "plane,glass", "--json"],
        &["--in", "moodle", "--require", required],
        &["--in", "canvas", "--require", required, "--names", "names.txt"],
        &["--in", "canvas.zip"],
        &["--in", "github", "--csv"],
        &["--in", "github", "--json"],
        &["--in", "canvas", "--require", "step01_rays,nowhere"],
        &["--names", "names.txt", "--out", "sheets", "--answers"],
        &["--scene", "Do\u{308}ra", dora],
    ];
    assert_locked("folders", runs.map(|arguments| run_check(&folder, arguments)));
    let sheet = fs::read_to_string(folder.join("sheets/___Zo\u{eb}.md"));
    assert_locked("sheet", [("___Zo\u{eb}.md".to_owned(), sheet.expect("a sheet"))]);
}
