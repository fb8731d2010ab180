//! The locked pictures, of the steps, the exercises, the chapters and the cover: each is
//! compared with its snapshot by the test of its own name, before everything else.

use tests::{assert_matches_snapshot, locked_pictures};

/// Defines a test for each of the names, and lists them in `TEST_NAMES`.
macro_rules! test_pictures {
    ($($name:ident)*) => {
        const TEST_NAMES: &[&str] = &[$(stringify!($name)),*];
        $(
            #[test]
            fn $name() {
                assert_locked_picture(stringify!($name));
            }
        )*
    };
}

test_pictures! {
    step01_rays step02_sphere step03_nearest step04_diffuse step05_phong
    gradient checkerboard graticule jitter look_at panorama rings
    disc lens plane quadric
    all_hits depth many my_scene
    gamma normals plaster shadows snowman spot sun
    crowd glass halfway highlight marbles mirror
    slide_matrix step05_ambient step05_diffuse step05_specular
    one_ray sixteen_rays speckled shadowed close_up cover goodbye
}

/// Draws the picture `name`, and compares it with its snapshot.
fn assert_locked_picture(name: &str) {
    let pictures = locked_pictures();
    let picture = pictures.iter().find(|(picture_name, ..)| *picture_name == name);
    let (_, camera, draw) = picture.unwrap_or_else(|| panic!("no picture {name}"));
    assert_matches_snapshot(name, &draw(camera, 1));
}

#[test]
fn each_locked_picture_has_a_test_of_its_name() {
    let names: Vec<_> = locked_pictures().into_iter().map(|(name, ..)| name).collect();
    assert_eq!(names, TEST_NAMES);
}
