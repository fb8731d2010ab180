//! What is said of pictures, by the lines of an answer.

use crate::{locked, right, said};
use check::{Step, camera, look, mistakes, rows};
use glam::DVec3;
use image::imageops::{self, FilterType, crop_imm, overlay, resize};
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray, render};
use step05_phong::{Light, Material, Scene};

fn assert_said(picture: &RgbImage, name: &str, words: &[&str]) {
    let text = said(picture, name);
    for word in words {
        assert!(text.contains(word), "{word} is not in: {text}");
    }
}

/// The picture of step 5 with another scene.
fn shiny(change: impl Fn(&mut Scene<Material, Light>)) -> RgbImage {
    let mut scene = step05_phong::scene();
    change(&mut scene);
    render(&camera(640, 360), 1, |ray| step05_phong::colour(&scene, ray))
}

#[test]
fn what_is_right_is_told() {
    for one in locked() {
        let answer = look(&one.picture, Some(&one.name), locked());
        assert_eq!(answer.code, 0, "{}", answer.text);
    }
    assert_said(
        &right("glass"),
        "sun",
        &["this is the picture of glass, not of sun"],
    );
}

#[test]
fn other_options_are_told() {
    for (size, fov, samples) in
        [((320, 180), 60.0_f64, 1), ((100, 75), 75.5, 2), ((640, 360), 110.0, 1)]
    {
        let camera = Camera::new(size.0, size.1, fov.to_radians());
        let picture = Step::Phong.picture(&camera, samples);
        let words = format!("{fov}° and {samples}×{samples} rays");
        assert_said(
            &picture,
            "step05_phong",
            &["Right, but with other options", &words],
        );
    }
    let mut picture = Step::Phong.picture(&camera(320, 180), 1);
    picture.put_pixel(9, 9, Rgb([0; 3]));
    assert_said(&picture, "step05_phong", &["draw it with the default options"]);
}

#[test]
fn what_was_made_of_the_whole_is_told() {
    let mapped = |picture: &RgbImage, change: &dyn Fn([u8; 3]) -> [u8; 3]| {
        let mut picture = picture.clone();
        picture.pixels_mut().for_each(|pixel| pixel.0 = change(pixel.0));
        picture
    };
    for name in ["step05_phong", "plane"] {
        let ours = right(name);
        let power =
            |c: u8| (255.0 * (f64::from(c) / 255.0).powf(1.0 / 1.8)).round() as u8;
        let mut shot = RgbImage::from_pixel(800, 500, Rgb([220; 3]));
        overlay(&mut shot, &ours, 30, 60);
        for (picture, words) in [
            (imageops::flip_vertical(&ours), "upside down"),
            (imageops::flip_horizontal(&ours), "mirrored"),
            (imageops::rotate180(&ours), "turned half around"),
            (imageops::rotate90(&ours), "turned a quarter to the right"),
            (mapped(&ours, &|[r, g, b]| [b, g, r]), "red and blue swapped"),
            (
                mapped(&ours, &|[_, g, _]| [g; 3]),
                "in grey, of 0.00 red + 1.00 green",
            ),
            (mapped(&ours, &|c| c.map(power)), "to the power 1/1.8"),
            (mapped(&ours, &|_| [7, 8, 9]), "one colour, (7, 8, 9)"),
            (resize(&ours, 240, 135, FilterType::Triangle), "made into 240×135"),
            (crop_imm(&ours, 100, 150, 300, 200).to_image(), "columns 100 to 399"),
            (shot, "from column 30 and row 60 on"),
        ] {
            let text = said(&picture, name);
            let told = text.lines().next().unwrap_or_default();
            assert!(told.contains(words), "{name}: {words}: {text}");
        }
    }
}

#[test]
fn one_number_is_told_with_its_owner() {
    let golden = "the golden sphere is at (0.45, −1.27, −5.8) in your picture; it should \
                  be at (0.45, −1.12, −5.8)";
    let cases: [(RgbImage, &str); 5] = [
        (shiny(|scene| scene.objects[2].sphere.centre.y = -1.27), golden),
        (
            shiny(|scene| scene.objects[0].material.shininess = 41),
            "n of the red sphere is 41",
        ),
        (
            shiny(|scene| scene.lights[1].specular.x = 0.55),
            "L_s of the cool light is (0.55, ",
        ),
        (
            shiny(|scene| scene.ambient_light.y = 0.23),
            "L_a of the scene is (0.32, 0.23, ",
        ),
        (
            shiny(|scene| scene.lights[0].point_light.attenuation.b = 0.025),
            "(a, b, c) of the warm light is (0.7, 0.025, ",
        ),
    ];
    for (picture, words) in cases {
        assert_said(&picture, "step05_phong", &[words]);
    }
}

#[test]
fn where_to_look_is_told() {
    let camera = camera(640, 360);
    let scene = step05_phong::scene();
    let drawn = |camera: &Camera, colour: &(dyn Fn(&Ray) -> DVec3 + Sync)| {
        render(camera, 1, |ray| colour(ray))
    };
    let right = |ray: &Ray| step05_phong::colour(&scene, ray);
    let terms = |ray: &Ray| step05_phong::terms(&scene, ray);
    let sky = step01_rays::direction_colour;
    let mut higher = camera;
    higher.matrix.y_axis.y *= 1.07;
    let mut moved = step05_phong::scene();
    moved.objects[7].sphere.centre += DVec3::new(0.123, 0.0456, 0.0);
    let dim =
        |ray: &Ray| terms(ray).map_or(sky(ray), |i| i.sum() - 0.31 * i.ambient);
    let flat =
        |ray: &Ray| terms(ray).map_or(sky(ray), |i| i.sum() - 0.31 * i.diffuse);
    let dull =
        |ray: &Ray| terms(ray).map_or(sky(ray), |i| i.sum() - 0.31 * i.specular);
    let cases: [(RgbImage, &[&str]); 6] = [
        (drawn(&higher, &right), &["First wrong: the rays", "D_v", "camera.rs"]),
        (
            drawn(&camera, &sky),
            &["this is the picture of step01_rays, not of step05"],
        ),
        (
            drawn(&camera, &|ray| step05_phong::colour(&moved, ray)),
            &["outline of the salmon sphere", "objects.rs"],
        ),
        (drawn(&camera, &dim), &["Right: the rays, the outlines", "ambient.rs"]),
        (drawn(&camera, &flat), &["the light of both lamps", "diffuse.rs"]),
        (
            drawn(&camera, &dull),
            &["diffuse light.\nFirst wrong: the highlights", "specular.rs"],
        ),
    ];
    for (picture, words) in cases {
        assert_said(&picture, "step05_phong", words);
    }
}

#[test]
fn a_listed_one_is_told_with_its_diff() {
    let all = mistakes();
    let upright = all.iter().find(|one| one.new == "2.0 * n.dot(l) * n + l");
    let mistake = upright.expect("r with a plus is in the list");
    let row = rows().find(|row| row.mistake == mistake.key()).expect("a row");
    let picture = render(&camera(640, 360), 1, |ray| {
        let scene = step05_phong::scene();
        let Some(point) = step05_phong::visible_point(&scene.objects, ray) else {
            return step01_rays::direction_colour(ray);
        };
        let none =
            step05_phong::phong(&point, ray, scene.ambient_light, &scene.lights);
        let v = -ray.direction.normalize();
        let shine = scene.lights.iter().map(|light| {
            let (l, d) = light.point_light.direction_from(point.p);
            let r = 2.0 * point.n.dot(l) * point.n + l;
            let shine = step05_phong::specular(r, v, d, point.material, light);
            if 0.0 < point.n.dot(l) { shine } else { DVec3::ZERO }
        });
        none.ambient + none.diffuse + shine.sum::<DVec3>()
    });
    assert_eq!(row.sums, [Some(check::sum(&picture))]);
    assert_said(
        &picture,
        "step05_phong",
        &[&mistake.diff().lines().next().expect("a line")[2..]],
    );
    assert_said(
        &picture,
        "step04_diffuse",
        &["pixels of step05_phong with a mistake in it, not of step04"],
    );
}
