//! Pictures at their defaults against the programs.

use course::{Step, find_picture};
use figures::{Output, find};
use image::RgbImage;

/// The picture of this name, where the parameter with these words, if any, is 1.
fn draw(name: &str, words: &str) -> RgbImage {
    let figure = find(name).expect("a picture");
    let values = figure.parameters.iter().map(|parameter| match &parameter.words {
        text if text == words => 1.0,
        _ => parameter.default,
    });
    match (figure.draw)(&values.collect::<Vec<_>>()) {
        Output::Pixels(image) => image,
        Output::Drawing(_) => panic!("{name} is drawn"),
    }
}

#[test]
fn default_picture_is_that_of_the_program() {
    let steps = Step::NAMES.map(|name| (name, "-", name));
    let others = [
        ("mirror", "-", "mirror"),
        ("own_scene", "-", "step05_phong"),
        ("own_scene", "shadows and mirrors", "mirror"),
    ];
    for (name, words, program) in steps.into_iter().chain(others) {
        let picture = find_picture(program).expect("a program");
        assert!(
            draw(name, words) == picture(&course::camera(), 1),
            "{name} is another picture than {program}"
        );
    }
}
