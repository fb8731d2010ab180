//! Draws the mistakes: a line with the columns and the rows of each picture, then its bytes;
//! `0 0` where it panics.
#![allow(warnings)]

use image::RgbImage;
use std::io::{Write, stdout};
use std::{fs, panic};

fn main() {
    panic::set_hook(Box::new(|_| {}));
    for draw in PICTURES {
        let picture = panic::catch_unwind(draw).unwrap_or_default();
        let (columns, rows) = picture.dimensions();
        println!("{columns} {rows}");
        stdout().write_all(picture.as_raw()).unwrap();
    }
    stdout().flush().unwrap();
}

/// The picture that a program writes, without other options.
fn draw_with_program(run: fn()) -> RgbImage {
    let _ = fs::remove_file("picture.png");
    run();
    image::open("picture.png").unwrap().to_rgb8()
}
