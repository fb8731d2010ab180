//! The locked pictures: of the steps, the exercises, the chapters and the cover. They are
//! tested before all else, each by the test of its own name.

use tests::{assert_locked, locked_pictures};

/// Names the locked pictures, and makes a test of each.
macro_rules! locked_pictures {
    ($($name:ident)*) => {
        const NAMES: &[&str] = &[$(stringify!($name)),*];
        $(
            #[test]
            fn $name() {
                assert_picture(stringify!($name));
            }
        )*
    };
}

locked_pictures! {
    step01_rays step02_sphere step03_nearest step04_diffuse step05_phong
    gradient graticule look_at panorama rings
    disc lens plane quadric
    all_hits depth jitter many my_scene
    gamma normals plaster shadows snowman spot sun
    crowd glass halfway highlight marbles mirror
    slide_matrix step05_ambient step05_diffuse step05_specular
    speckled shadowed close_up cover goodbye
}

/// Draws the picture `name`, and compares it with its snapshot.
fn assert_picture(name: &str) {
    let pictures = locked_pictures();
    let found = pictures.iter().find(|(known, ..)| *known == name);
    let (_, camera, draw) = found.unwrap_or_else(|| panic!("no picture {name}"));
    assert_locked(name, &draw(camera, 1));
}

#[test]
fn each_picture_has_a_test_of_its_name() {
    let names: Vec<_> =
        locked_pictures().into_iter().map(|(name, ..)| name).collect();
    assert_eq!(names, NAMES);
}
