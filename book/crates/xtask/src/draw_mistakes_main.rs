//! Draws the mistakes: a line with the columns and the rows of each picture, then its bytes;
//! `0 0` where it panics. Ends where one takes a minute.
#![allow(warnings)]

use image::RgbImage;
use std::io::{Write, stdout};
use std::process::exit;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::{fs, panic, thread, time::Duration};

fn main() {
    panic::set_hook(Box::new(|_| {}));
    for draw in PICTURES {
        let (sender, receiver) = channel();
        thread::spawn(move || sender.send(draw()));
        let picture = match receiver.recv_timeout(Duration::from_secs(60)) {
            Ok(picture) => picture,
            Err(RecvTimeoutError::Disconnected) => RgbImage::new(0, 0),
            Err(RecvTimeoutError::Timeout) => exit(1),
        };
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
