//! Pictures at their defaults against the programs.

use figures::{Output, find, own_scene};
use image::RgbImage;

/// The picture of this name, where the parameter with these words, if any, is 1.
fn draw(name: &str, words: &str) -> RgbImage {
    let figure = find(name).expect("a picture");
    let values = figure.parameters.iter().map(|parameter| match &parameter.words {
        known if known == words => 1.0,
        _ => parameter.default,
    });
    match (figure.draw)(&values.collect::<Vec<_>>()) {
        Output::Pixels(image) => image,
        Output::Drawing(_) => panic!("{name} is drawn"),
    }
}

#[test]
fn default_picture_is_that_of_the_program() {
    let mirror: course::Picture = course::examples::mirror::picture;
    for (name, picture) in course::PICTURES[..5].iter().copied().chain([("mirror", mirror)]) {
        assert!(draw(name, "-") == picture(&figures::camera(), 1), "{name} is another picture");
    }
}

#[test]
fn own_scene_is_that_of_step_5_and_with_mirrors_that_of_the_example() {
    let values = find("own_scene").expect("a picture").default_values();
    assert_eq!(own_scene(&values).scene, step05_phong::scene());
    let mirror = course::examples::mirror::picture(&figures::camera(), 1);
    assert!(draw("own_scene", "shadows and mirrors") == mirror);
}
