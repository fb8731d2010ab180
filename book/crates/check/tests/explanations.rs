//! What is told of each kind of picture, and that nothing is told of the others.

use crate::{
    PhongScene, assert_answer_contains, draw_changed_step05, locked_picture, text_of_wrong_picture,
};
use course::{Step, camera_with_size};
use glam::DVec3;
use image::imageops::{blur, rotate90};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray, render, rgb8};

/// A picture of step 1, 3 or 5 by a camera, with another colour of the sky and other bytes.
fn draw_with_sky_and_bytes(
    step: Step,
    camera: &Camera,
    sky: impl Fn(&Ray) -> DVec3 + Sync,
    bytes: impl Fn(DVec3) -> [u8; 3],
) -> RgbImage {
    let scene = step05_phong::scene();
    RgbImage::from_fn(camera.h_res, camera.v_res, |i, j| {
        let ray = camera.ray(i.into(), j.into());
        let hit = step05_phong::visible_point(&scene.objects, &ray).is_some();
        let intensity = match step {
            Step::Nearest if hit => step03_nearest::colour(&step05_phong::OBJECTS, &ray),
            Step::Phong if hit => step05_phong::colour(&scene, &ray),
            _ => sky(&ray),
        };
        Rgb(bytes(intensity))
    })
}

fn our_sky(ray: &Ray) -> DVec3 {
    step01_rays::direction_colour(ray)
}

fn our_bytes(intensity: DVec3) -> [u8; 3] {
    rgb8(intensity).0
}

/// Ours with each byte changed by its place.
fn map_bytes_of_locked(name: &str, change: impl Fn(usize, u8) -> u8) -> RgbImage {
    let mut picture = locked_picture(name);
    picture.iter_mut().enumerate().for_each(|(k, byte)| *byte = change(k, *byte));
    picture
}

#[test]
fn another_camera_is_read_from_the_sky() {
    let mut wider = camera_with_size(640, 360);
    wider.matrix.x_axis *= 1.1;
    wider.matrix.z_axis.x *= 1.1;
    let mut slanted = camera_with_size(640, 360);
    slanted.matrix.y_axis.x = 0.0004;
    for (camera, words) in [
        (wider, "another camera: x and y of D_u are (0.001988, 0), not (0.001807, 0)"),
        (slanted, "another camera: x and y of D_v are (0.0004, −0.001807)"),
    ] {
        for step in [Step::Rays, Step::Phong] {
            let picture = draw_with_sky_and_bytes(step, &camera, our_sky, our_bytes);
            assert_answer_contains(&picture, step.name(), &[words, "camera.rs"]);
        }
    }
}

#[test]
fn other_sky_colour_is_named() {
    let white_to_blue = |ray: &Ray| {
        let t = 0.5 + 0.5 * ray.direction.normalize().y;
        (1.0 - t) * DVec3::ONE + t * DVec3::new(0.5, 0.7, 1.0)
    };
    let weak_gradient = |ray: &Ray| 0.55 + 0.2 * ray.direction;
    for step in [Step::Nearest, Step::Phong] {
        let camera = camera_with_size(640, 360);
        let picture = draw_with_sky_and_bytes(step, &camera, white_to_blue, our_bytes);
        assert_answer_contains(
            &picture,
            step.name(),
            &["red = 0.75 − 0.25 y", "of V/|V|", "step01_rays/src/direction_colour.rs"],
        );
        let picture = draw_with_sky_and_bytes(step, &camera, weak_gradient, our_bytes);
        assert_answer_contains(
            &picture,
            step.name(),
            &["red = 0.55 + 0.20 x", "all else is right"],
        );
        let picture = draw_with_sky_and_bytes(step, &camera, |_| DVec3::splat(0.4), our_bytes);
        assert_answer_contains(&picture, step.name(), &["red = 0.40, green = 0.40"]);
    }
}

#[test]
fn other_bytes_are_named() {
    type Bytes = fn(DVec3) -> [u8; 3];
    let camera = camera_with_size(640, 360);
    let encodings: [(Bytes, &str); 3] = [
        (|i| i.to_array().map(|c| (255.99 * c) as u8), "255.99·I cut off"),
        (
            |i| i.to_array().map(|c| (255.0 * c.powf(1.0 / 2.2) + 0.5) as u8),
            "255·I^(1/2.2) (gamma)",
        ),
        (|i| i.to_array().map(|c| (255.0 * (1.0 - c) + 0.5) as u8), "a negative"),
    ];
    for (bytes, words) in encodings {
        let picture = draw_with_sky_and_bytes(Step::Phong, &camera, our_sky, bytes);
        assert_answer_contains(&picture, "step05_phong", &[words, "rgb8.rs"]);
    }
}

#[test]
fn shifted_rays_are_named() {
    let mut camera = camera_with_size(640, 360);
    camera.matrix.z_axis += -0.5 * camera.matrix.x_axis + 1.0 * camera.matrix.y_axis;
    let picture = render(&camera, 1, |ray| step03_nearest::colour(&step03_nearest::OBJECTS, ray));
    let words = ["through i − 0.5 and j + 1"];
    assert_answer_contains(&picture, "step03_nearest", &words);
}

#[test]
fn rounding_differences_are_named() {
    for step in ["step03_nearest", "step05_phong"] {
        let picture = map_bytes_of_locked(step, |k, byte| match k % 19946 {
            0 => byte.saturating_sub(1),
            9973 => byte.saturating_add(1),
            _ => byte,
        });
        let text = text_of_wrong_picture(&picture, step);
        assert!(text.contains("the formulas are right"), "{text}");
        assert!(!text.contains("compare with"), "{text}");
    }
}

#[test]
fn noisy_and_blurred_pictures_are_ours_with_loss() {
    let noisy = map_bytes_of_locked("step05_phong", |k, byte| {
        byte.saturating_add((k * 7919 % 5) as u8).saturating_sub(2)
    });
    for picture in [noisy, blur(&locked_picture("step05_phong"), 2.0)] {
        let words = ["in each small square about as bright"];
        assert_answer_contains(&picture, "step05_phong", &words);
    }
}

#[test]
fn missing_terms_and_objects_are_named() {
    type Change = fn(&mut PhongScene);
    let changes: [(Change, &str); 5] = [
        (|scene| scene.lights.truncate(1), "the cool light"),
        (|scene| scene.ambient_light *= 0.0, "without the ambient term"),
        (|scene| scene.ambient_light *= 2.0, "the ambient term twice"),
        (
            |scene| scene.objects.retain(|one| one.material.shininess != 300),
            "the white sphere is missing",
        ),
        (|scene| scene.objects.truncate(3), "only the first 3 objects"),
    ];
    for (change, words) in changes {
        let text = text_of_wrong_picture(&draw_changed_step05(change), "step05_phong");
        assert!(text.contains(words) || text.contains("mistakes that we know"), "{words}: {text}");
    }
    for (name, of, words) in [
        ("step05_phong", "step04_diffuse", "The highlights are missing"),
        ("step04_diffuse", "step03_nearest", "The light is missing"),
        ("step03_nearest", "step01_rays", "no ray meets one"),
        ("sun", "step04_diffuse", "First ask about step 4's picture"),
    ] {
        assert_answer_contains(&locked_picture(of), name, &["this is the picture of", words]);
    }
}

#[test]
fn where_nothing_explains_a_picture_no_file_is_blamed() {
    let two_mistakes = draw_changed_step05(|scene| {
        scene.lights[0].point_light.position *= 1.07;
        scene.objects[4].sphere.radius *= 1.01;
    });
    let half = map_bytes_of_locked(
        "step05_phong",
        |k, byte| {
            if k % 1920 < 960 { byte } else { byte ^ 0x15 }
        },
    );
    let waves = RgbImage::from_fn(640, 360, |i, j| Rgb([(i * j / 64) as u8, (i ^ j) as u8, 255]));
    for (picture, name) in [
        (&two_mistakes, "step05_phong"),
        (&half, "step05_phong"),
        (&waves, "step02_sphere"),
        (&waves, "step01_rays"),
        (&waves, "glass"),
    ] {
        let text = text_of_wrong_picture(picture, name);
        assert!(text.starts_with("Not right yet, compared with "), "{text}");
        assert!(!text.contains("compare with steps"), "{text}");
        assert!(text.contains("--test by_hand") || text.contains("First ask"), "{text}");
    }
}

#[test]
fn picture_of_another_size_is_right_with_other_options() {
    let picture = (Step::Nearest.picture())(&camera_with_size(2560, 1440), 1);
    let words = ["in the 3145728 pixels of 3686400", "at 2560×1440 pixels"];
    assert_answer_contains(&picture, "step03_nearest", &words);
    let turned = rotate90(&locked_picture("step03_nearest"));
    assert_answer_contains(&turned, "step03_nearest", &["a quarter to the right"]);
}
