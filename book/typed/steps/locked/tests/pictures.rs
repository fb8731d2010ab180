//! The picture of each step, compared with a snapshot.

use std::{fs, path, process::Command};

fn lock(step: &str) {
    let run = Command::new("cargo").args(["run", "--quiet", "-p", step]).status();
    assert!(run.unwrap().success());
    let file = format!("{step}.png");
    let picture = fs::read(&file).unwrap();
    fs::remove_file(&file).unwrap();
    let folder = path::absolute("tests/snapshots").unwrap();
    insta::with_settings!({ snapshot_path => folder }, {
        insta::assert_binary_snapshot!(&file, picture);
    });
}

#[test]
fn step01_rays() {
    lock("step01_rays");
}

#[test]
fn step02_sphere() {
    lock("step02_sphere");
}

#[test]
fn step03_nearest() {
    lock("step03_nearest");
}

#[test]
fn step04_diffuse() {
    lock("step04_diffuse");
}

#[test]
fn step05_phong() {
    lock("step05_phong");
}
