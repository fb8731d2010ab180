//! What is told of each kind of picture, and that nothing is told of the others.

use crate::{locked_picture, text_of_wrong_picture};
use check::{Step, default_camera};
use glam::DVec3;
use image::imageops::{blur, rotate90};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray, render, rgb8};
use step05_phong::{Light, Material, Scene};

type PhongScene = Scene<Material, Light>;

fn assert_answer_contains(picture: &RgbImage, name: &str, words: &[&str]) {
    let text = text_of_wrong_picture(picture, name);
    for word in words {
        assert!(text.contains(word), "{word} is not in: {text}");
    }
}

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
            Step::Nearest if hit => {
                step03_nearest::colour(&step05_phong::OBJECTS, &ray)
            }
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

/// The picture of step 5 with another scene.
fn draw_changed_step05(change: impl Fn(&mut PhongScene)) -> RgbImage {
    let mut scene = step05_phong::scene();
    change(&mut scene);
    render(&default_camera(640, 360), 1, |ray| step05_phong::colour(&scene, ray))
}

/// Ours with each byte changed by its place.
fn map_bytes_of_locked(name: &str, change: impl Fn(usize, u8) -> u8) -> RgbImage {
    let mut picture = locked_picture(name);
    picture.iter_mut().enumerate().for_each(|(k, byte)| *byte = change(k, *byte));
    picture
}

#[test]
fn another_camera_is_read_from_the_sky() {
    let zoomed = |half_width: f64| {
        let mut camera = default_camera(640, 360);
        let factor = half_width / (60_f64 / 2.0).to_radians().tan();
        camera.matrix.x_axis *= factor;
        camera.matrix.y_axis *= factor;
        camera.matrix.z_axis *= DVec3::new(factor, factor, 1.0);
        camera
    };
    for (half_width, angle) in [(0.37, "40.6°"), (0.523, "55.2°"), (0.9, "84°")]
    {
        for step in [Step::Rays, Step::Phong] {
            let picture = draw_with_sky_and_bytes(
                step,
                &zoomed(half_width),
                our_sky,
                our_bytes,
            );
            let text = text_of_wrong_picture(&picture, step.name());
            let is_told =
                text.contains(angle) || text.contains("with other options");
            assert!(is_told, "{text}");
        }
    }
    let mut slanted = default_camera(640, 360);
    slanted.matrix.y_axis.x = 0.0004;
    let picture =
        draw_with_sky_and_bytes(Step::Phong, &slanted, our_sky, our_bytes);
    assert_answer_contains(
        &picture,
        "step05_phong",
        &["another camera: x and y of D_v", "camera.rs"],
    );
}

#[test]
fn other_sky_colour_is_named() {
    let white_to_blue = |ray: &Ray| {
        let t = 0.5 + 0.5 * ray.direction.normalize().y;
        (1.0 - t) * DVec3::ONE + t * DVec3::new(0.5, 0.7, 1.0)
    };
    let weak_gradient = |ray: &Ray| 0.55 + 0.2 * ray.direction;
    for step in [Step::Nearest, Step::Phong] {
        let camera = default_camera(640, 360);
        let picture =
            draw_with_sky_and_bytes(step, &camera, white_to_blue, our_bytes);
        assert_answer_contains(
            &picture,
            step.name(),
            &["red = 0.75 − 0.25 y", "of V/|V|", "step01_rays/src/picture.rs"],
        );
        let picture =
            draw_with_sky_and_bytes(step, &camera, weak_gradient, our_bytes);
        assert_answer_contains(
            &picture,
            step.name(),
            &["red = 0.55 + 0.20 x", "all else is right"],
        );
        let picture = draw_with_sky_and_bytes(
            step,
            &camera,
            |_| DVec3::splat(0.4),
            our_bytes,
        );
        assert_answer_contains(
            &picture,
            step.name(),
            &["red = 0.40, green = 0.40"],
        );
    }
}

#[test]
fn other_byte_curve_is_named() {
    type Bytes = fn(DVec3) -> [u8; 3];
    let camera = default_camera(640, 360);
    let curves: [(Bytes, &str); 6] = [
        (|i| i.to_array().map(|c| (255.99 * c) as u8), "255.99·I cut off"),
        (|i| i.to_array().map(|c| (240.0 * c + 0.5) as u8), "0.941 times ours"),
        (|i| i.to_array().map(|c| (255.0 * (1.0 - (-c).exp())) as u8), "1 − e^−I"),
        (
            |i| i.to_array().map(|c| (255.0 * c.powf(1.0 / 1.9) + 0.5) as u8),
            "1/1.9 (gamma)",
        ),
        (
            |i| if i.max_element() > 1.0 { [0; 3] } else { rgb8(i).0 },
            "black where a channel",
        ),
        (|i| (i * 200.0 + 40.0).to_array().map(|c| c as u8), "follow from ours"),
    ];
    for (bytes, words) in curves {
        let picture = draw_with_sky_and_bytes(Step::Phong, &camera, our_sky, bytes);
        assert_answer_contains(&picture, "step05_phong", &[words, "rgb8.rs"]);
    }
}

#[test]
fn two_mistakes_are_named_if_one_is_in_rgb8() {
    let mut scene = step04_diffuse::scene();
    scene.ambient_light *= 0.37;
    let camera = default_camera(640, 360);
    let cut = |i: DVec3| i.to_array().map(|c| (255.0 * c) as u8);
    let picture = RgbImage::from_fn(640, 360, |i, j| {
        Rgb(cut(step04_diffuse::colour(&scene, &camera.ray(i.into(), j.into()))))
    });
    let words =
        ["255·I cut off, not rounded", "the ambient term times 0.37", "ambient.rs"];
    assert_answer_contains(&picture, "step04_diffuse", &words);
}

#[test]
fn shifted_and_random_rays_are_named() {
    let random = |i: u32, j: u32, k: u32| {
        let hash = (i * 640 + j * 1009 + k * 77).wrapping_mul(2_654_435_761);
        f64::from(hash >> 8) / f64::from(1 << 24) - 0.5
    };
    let camera = default_camera(640, 360);
    for step in [Step::Sphere, Step::Nearest] {
        let picture = |place: &dyn Fn(u32, u32) -> (f64, f64)| {
            RgbImage::from_fn(640, 360, |i, j| {
                let (u, v) = place(i, j);
                let ray = camera.ray(f64::from(i) + u, f64::from(j) + v);
                rgb8(match step {
                    Step::Sphere => {
                        step02_sphere::colour(&step02_sphere::SPHERE, &ray)
                    }
                    _ => step03_nearest::colour(&step03_nearest::OBJECTS, &ray),
                })
            })
        };
        let anywhere = picture(&|i, j| (random(i, j, 1), random(i, j, 2)));
        assert_answer_contains(
            &anywhere,
            step.name(),
            &["rays within one pixel", "render.rs"],
        );
        let shifted = picture(&|_, _| (-0.5, 1.0));
        assert_answer_contains(
            &shifted,
            step.name(),
            &["through i − 0.5 and j + 1"],
        );
    }
}

#[test]
fn undrawn_rows_columns_and_pixels_are_named() {
    for (is_gone, words) in [
        ((|_, j| j >= 200) as fn(u32, u32) -> bool, "rows 200 to 359"),
        (|i, _| i % 2 == 1, "columns 1, 3, 5 and so on, 320 of them"),
        (|_, j| j == 7, "rows 7, all"),
        (
            |i, j| (i * 7919 + j * 104_729) % 97 == 0,
            " of 230400 pixels, all of them",
        ),
    ] {
        for name in ["step01_rays", "step04_diffuse"] {
            let mut picture = locked_picture(name);
            for (i, j, pixel) in picture.enumerate_pixels_mut() {
                if is_gone(i, j) {
                    *pixel = Rgb([0; 3]);
                }
            }
            assert_answer_contains(
                &picture,
                name,
                &["ever drawn", words, "render.rs"],
            );
        }
    }
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
fn noisy_blurred_and_quantised_pictures_are_named() {
    let noisy = |name| {
        map_bytes_of_locked(name, |k, byte| {
            byte.saturating_add((k * 7919 % 5) as u8).saturating_sub(2)
        })
    };
    let quantised = map_bytes_of_locked("step05_phong", |_, byte| {
        (byte / 48 * 48).saturating_add(24)
    });
    for (picture, name, words) in [
        (noisy("step05_phong"), "step05_phong", "something random"),
        (noisy("glass"), "glass", "something random"),
        (blur(&locked_picture("step05_phong"), 2.0), "step05_phong", "blurred"),
        (quantised, "step05_phong", "follow from ours"),
    ] {
        assert_answer_contains(&picture, name, &[words]);
    }
}

#[test]
fn wrong_byte_layout_is_named() {
    for name in ["step03_nearest", "step05_phong", "sun"] {
        let ours = locked_picture(name);
        let pixels: Vec<_> = ours.pixels().copied().collect();
        let of_pixels = |place: &dyn Fn(usize) -> usize| {
            RgbImage::from_fn(640, 360, |i, j| {
                pixels[place(j as usize * 640 + i as usize) % pixels.len()]
            })
        };
        let of_bytes = |bytes: Vec<u8>| {
            RgbImage::from_raw(640, 360, bytes[..3 * 640 * 360].to_vec())
                .expect("bytes")
        };
        let planes = |k: usize| ours.pixels().map(move |pixel| pixel[k]);
        let padded =
            ours.pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]);
        for (picture, words) in [
            (of_pixels(&|n| n % 360 * 640 + n / 360), "column by column"),
            (of_pixels(&|n| n + 640 * 360 - 2), "2 pixels late"),
            (of_bytes((0..3).flat_map(planes).collect()), "first all red"),
            (of_bytes(padded.collect()), "four bytes a pixel (RGBA)"),
        ] {
            assert_answer_contains(&picture, name, &[words]);
        }
    }
}

#[test]
fn missing_terms_and_objects_are_named() {
    type Change = fn(&mut PhongScene);
    let changes: [(Change, &str); 6] = [
        (|scene| scene.lights.truncate(1), "the cool light"),
        (
            |scene| scene.lights.iter_mut().for_each(|one| one.specular *= 0.3),
            "times 0.3",
        ),
        (|scene| scene.ambient_light *= 0.0, "without the ambient term"),
        (|scene| scene.ambient_light *= 2.0, "the ambient term twice"),
        (
            |scene| scene.objects.retain(|one| one.material.shininess != 300),
            "the white sphere is missing",
        ),
        (|scene| scene.objects.truncate(3), "only the first 3 objects"),
    ];
    for (change, words) in changes {
        let text =
            text_of_wrong_picture(&draw_changed_step05(change), "step05_phong");
        assert!(
            text.contains(words) || text.contains("mistakes that we know"),
            "{words}: {text}"
        );
    }
    for (name, of, words) in [
        ("step05_phong", "step04_diffuse", "The highlights are missing"),
        ("step04_diffuse", "step03_nearest", "The light is missing"),
        ("step03_nearest", "step01_rays", "no ray meets one"),
        ("sun", "step04_diffuse", "First ask about step 4's picture"),
    ] {
        assert_answer_contains(
            &locked_picture(of),
            name,
            &["this is the picture of", words],
        );
    }
}

#[test]
fn where_nothing_explains_a_picture_no_file_is_blamed() {
    let two_mistakes = draw_changed_step05(|scene| {
        scene.lights[0].point_light.position *= 1.07;
        scene.objects[4].sphere.radius *= 1.01;
    });
    let half = map_bytes_of_locked("step05_phong", |k, byte| {
        if k % 1920 < 960 { byte } else { byte ^ 0x15 }
    });
    let waves = RgbImage::from_fn(640, 360, |i, j| {
        Rgb([(i * j / 64) as u8, (i ^ j) as u8, 255])
    });
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
        assert!(
            text.contains("--test by_hand") || text.contains("First ask"),
            "{text}"
        );
    }
}

#[test]
fn large_pictures_are_compared_in_rows() {
    let large = default_camera(2560, 1440);
    let picture = Step::Nearest.draw_picture(&large, 1);
    let text = crate::text_with_exit_code(&picture, "step03_nearest", 0);
    assert!(text.starts_with("Right in the 64 rows of 1440"), "{text}");
    let text_of_turned = crate::text_with_exit_code(
        &rotate90(&rotate90(&picture)),
        "step03_nearest",
        1,
    );
    assert!(text_of_turned.contains("turned half around"), "{text_of_turned}");
}

#[test]
fn an_exercise_by_another_camera_is_not_called_lossy() {
    for (name, picture) in exercises::PICTURES {
        // Some take long, and `jitter` is random itself.
        if ["crowd", "gradient", "jitter", "many", "marbles", "panorama"]
            .contains(name)
        {
            continue;
        }
        for shift in [0.3, 1.5] {
            let mut camera = default_camera(640, 360);
            camera.matrix.z_axis += shift * camera.matrix.x_axis;
            let picture = picture(&camera, 1);
            if picture == locked_picture(name) {
                continue;
            }
            let text = text_of_wrong_picture(&picture, name);
            assert!(!text.contains("packed with loss"), "{name}, {shift}: {text}");
            assert!(!text.contains("follow from ours"), "{name}, {shift}: {text}");
        }
    }
}
