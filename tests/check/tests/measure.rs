//! What `measure` reads out of pictures.

use ::check::{Stage, Verdict, stages};
use gallery::{Parts, Step, camera};
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray};
use step02_sphere::{Roots, quadratic};
use step05_phong::{reflect, specular};
use tests::some;

/// The stages of a picture that some parts draw in step 5 at 320×180.
fn of(step: Step, change: impl FnOnce(&mut Parts)) -> Vec<Stage> {
    let mut parts = Parts::right(&camera(320, 180));
    change(&mut parts);
    stages(&parts.picture(step, 1), step)
}

fn named<'a>(stages: &'a [Stage], name: &str) -> &'a Stage {
    let is_it = |stage: &&Stage| stage.name == name;
    stages.iter().find(is_it).unwrap_or_else(|| panic!("no stage {name}"))
}

/// Asserts that one stage is wrong, tells some words, and that all other wrong ones are
/// `also`.
fn assert_wrong(stages: &[Stage], name: &str, words: &str, also: &[&str]) {
    let stage = named(stages, name);
    assert_eq!(stage.verdict, Verdict::Wrong, "{stages:#?}");
    let told = stage.numbers.join("; ");
    assert!(told.contains(words), "{words} is not in {told}");
    let wrong = stages.iter().filter(|stage| stage.verdict == Verdict::Wrong);
    for other in wrong.filter(|stage| stage.name != name) {
        assert!(also.contains(&other.name), "{other:#?}");
    }
}

#[test]
fn every_stage_of_a_right_picture_is_right() {
    for step in Step::ALL {
        let sizes = [(320, 180, 1), (640, 360, 1), (200, 150, 2)];
        for (width, height, samples) in some(sizes, 3) {
            let picture = step.picture(&camera(width, height), samples);
            for stage in stages(&picture, step) {
                assert_eq!(stage.verdict, Verdict::Right, "{step:?} {stage:#?}");
            }
        }
    }
}

#[test]
fn one_wrong_pixel_is_never_right() {
    for step in some([Step::Phong, Step::Rays], 2) {
        let mut picture = step.picture(&camera(320, 180), 1);
        picture.put_pixel(160, 60, Rgb([12, 200, 90]));
        let stages = stages(&picture, step);
        assert!(stages.iter().any(|s| s.verdict != Verdict::Right), "{step:?}");
    }
}

#[test]
fn a_camera_is_read_from_the_sky() {
    for step in some(Step::ALL, 4) {
        let stages = of(step, |parts| parts.camera.matrix.y_axis.y *= 0.5);
        assert_wrong(&stages, "rays", "D_v = (0, (−1) h / columns, 0)", &[]);
    }
}

#[test]
fn a_sphere_is_read_from_its_outline() {
    for step in some([Step::Nearest, Step::Diffuse, Step::Phong], 3) {
        let stages = of(step, |parts| {
            parts.scene.objects[5].sphere.centre.x = 3.5;
        });
        assert_wrong(&stages, "outlines", "(3.5, −0.69, −6.4)", &[]);
    }
}

#[test]
fn a_colour_is_read() {
    for step in some([Step::Nearest, Step::Diffuse, Step::Phong], 3) {
        let stages = of(step, |parts| {
            let surface = &mut parts.scene.objects[1].material.material.surface;
            surface.ambient.y = 0.67;
            surface.diffuse.y = 0.67;
        });
        assert_wrong(&stages, "colours", "the ground", &[]);
        assert_wrong(&stages, "colours", "0.67", &[]);
    }
}

#[test]
fn the_weights_of_the_lights_are_read() {
    for step in some([Step::Diffuse, Step::Phong], 2) {
        let stages = of(step, |parts| parts.scene.ambient_light *= 0.5);
        assert_wrong(&stages, "ambient", "I_a = R_a L_a / 2", &[]);
        let stages =
            of(step, |parts| parts.scene.lights[1].point_light.diffuse *= 0.5);
        assert_wrong(&stages, "diffuse, cool", "(0.225, 0.3, 0.5)", &[]);
    }
    let stages = of(Step::Phong, |parts| parts.scene.lights[0].specular *= 2.0);
    assert_wrong(&stages, "specular, warm", "(2, 1.8, 1.6)", &[]);
}

#[test]
fn a_light_and_its_fading_are_read() {
    let stages = of(Step::Phong, |parts| {
        parts.scene.lights[1].point_light.attenuation.c = 0.002;
    });
    assert_wrong(&stages, "attenuation", "c in a + bd + cd² is 0.002", &[]);
    let stages = of(Step::Phong, |parts| {
        parts.scene.lights[0].point_light.position.z = 2.0;
    });
    assert_wrong(&stages, "diffuse, warm", "(−4, 5, 2)", &["diffuse, cool"]);
}

#[test]
fn a_shininess_is_read_from_its_highlights() {
    let stages = of(Step::Phong, |parts| {
        parts.scene.objects[2].material.material.shininess = 15;
    });
    let both = ["specular, warm", "specular, cool"];
    assert_wrong(&stages, "specular, warm", "n = 15; it should be 150", &both);
}

#[test]
fn two_stages_are_told_separately() {
    let stages = of(Step::Phong, |parts| {
        parts.camera.matrix.y_axis.y *= 0.5;
        parts.scene.ambient_light *= 0.5;
    });
    assert_wrong(&stages, "rays", "D_v = (0, (−1) h", &["ambient"]);
    assert_wrong(&stages, "ambient", "I_a = R_a L_a / 2", &["rays"]);
}

/// Neither of the two makes a pixel right, or only where it shows least.
#[test]
fn two_stages_are_told_separately_where_they_hide_each_other() {
    let stages = of(Step::Phong, |parts| {
        parts.camera.matrix.y_axis.y *= 319.0 / 179.0;
        parts.scene.ambient_light = DVec3::new(0.42, 0.32, 0.32);
    });
    assert_wrong(&stages, "rays", "D_v = (0, (−2) h / rows", &["ambient"]);
    assert_wrong(&stages, "ambient", "(0.42, 0.32, 0.32)", &["rays"]);
    let stages = of(Step::Diffuse, |parts| {
        parts.scene.lights[0].point_light.attenuation.a = 7.0;
        for material in parts.materials() {
            material.surface.ambient *= material.surface.ambient;
        }
    });
    assert_wrong(&stages, "ambient", "colour²", &["attenuation"]);
    assert_wrong(&stages, "attenuation", "a in a + bd + cd² is 7", &["ambient"]);
    let stages = of(Step::Phong, |parts| {
        parts.byte = |intensity| (255.0 * intensity) as u8;
        parts.materials().for_each(|material| material.shininess /= 2);
    });
    let both = ["specular, warm", "specular, cool"];
    let bytes = "sum, bytes, order";
    assert_wrong(&stages, bytes, "B = floor(255 M)", &both);
    assert_wrong(&stages, both[0], "/ 2", &[bytes, both[1]]);
    // What mends no pixel, beside what is white anyway.
    let stages = of(Step::Phong, |parts| {
        parts.seen_from = |light, p| {
            let (l, d) = light.direction_from(p);
            (l, d * d)
        };
        for material in parts.materials() {
            let red = material.surface.ambient.x;
            material.surface.ambient = DVec3::splat(red);
        }
    });
    assert_wrong(&stages, "ambient", "colour_x", &["attenuation"]);
    assert_wrong(&stages, "attenuation", "d = w·w", &["ambient"]);
    let stages = of(Step::Diffuse, |parts| {
        parts.normal = |sphere, p| (p + sphere.centre) / sphere.radius;
        parts.attenuation = |fade, d| 1.0 / fade.at(d);
    });
    assert_wrong(
        &stages,
        "point and normal",
        "(p + centre)",
        &["attenuation", "diffuse, warm", "diffuse, cool"],
    );
    // Not the camera of another angle, be it near.
    let stages = of(Step::Phong, |parts| {
        parts.camera = Camera::new(320, 180, 2.0 * 0.5_f64.atan());
        parts.reflect = |l, n| n.dot(l) * n - l;
    });
    assert_wrong(&stages, "rays", "h = sin(θ / 2)", &both);
    assert_wrong(&stages, both[0], "r = n·l n − l", &["rays", both[1]]);
}

/// One of the two mends every pixel that no light reaches, and few others.
#[test]
fn what_mends_whole_groups_is_the_first_of_two() {
    let stages = of(Step::Phong, |parts| {
        parts.scene.ambient_light =
            DVec3::splat(parts.scene.ambient_light.length());
        parts.attenuation = |fade, d| fade.a + fade.b * d + fade.c * d;
    });
    assert_wrong(&stages, "ambient", "I_a = R_a |L_a|", &["attenuation"]);
    assert_wrong(&stages, "attenuation", "a + b d + c d", &["ambient"]);
}

/// What no light reaches has one colour all over, wherever the lights are.
#[test]
fn what_is_dark_tells_the_first_of_two_stages() {
    let its = ["diffuse, warm", "diffuse, cool", "specular, warm"];
    let stages = of(Step::Phong, |parts| {
        parts.scene.ambient_light *= 0.1;
        parts.scene.lights[0].point_light.position.x = 4.0;
    });
    assert_wrong(&stages, "ambient", "L_a is (0.032, 0.032, 0.042)", &its);
    assert_wrong(&stages, its[0], "the warm light is at (4, 5, −2)", &["ambient"]);
    // The dark colour of another object is another object.
    let stages = of(Step::Phong, |parts| {
        parts.scene.objects[4].sphere.centre.z *= -1.0;
        parts.reflect = |l, n| reflect(l, n);
    });
    let both = ["specular, warm", "specular, cool"];
    assert_wrong(&stages, "outlines", "sphere is at (0.3, 0.4, −4)", &both);
    assert_wrong(&stages, both[0], "r = 2 l·n l − n", &["outlines", both[1]]);
}

/// The sky tells the one of two that it shows, whatever becomes of the objects; or both.
#[test]
fn a_sky_that_is_another_tells_the_first_of_two_stages() {
    let stages = of(Step::Phong, |parts| {
        parts.camera.matrix.y_axis.y *= 319.0 / 179.0;
        parts.normal = |sphere, p| (sphere.centre - p) / sphere.radius;
    });
    let normal = "point and normal";
    assert_wrong(&stages, "rays", "D_v = (0, (−2) h / rows", &[normal]);
    assert_wrong(&stages, normal, "n = (centre − p) / radius", &["rays"]);
    let swapped = "0.3 (V_y, V_x, −V_z)";
    // Without an object, bytes may as well have changed places.
    for (step, name) in [(Step::Rays, "sum, bytes, order"), (Step::Phong, "sky")] {
        let stages = of(step, |parts| {
            parts.camera.matrix.y_axis.y *= 0.5;
            parts.miss = |ray| {
                let v = ray.direction;
                0.7 + 0.3 * DVec3::new(v.y, v.x, -v.z)
            };
        });
        assert_wrong(&stages, "rays", "D_v = (0, (−1) h", &[name]);
        assert_wrong(&stages, name, swapped, &["rays"]);
    }
}

/// What may be what is wrong, as it gives the same picture, is not called right.
#[test]
fn no_stage_is_right_that_may_be_wrong_as_well() {
    let is_open = |stages: &[Stage], name: &str| {
        let verdict = &named(stages, name).verdict;
        assert!(matches!(verdict, Verdict::Unknown(_)), "{name}: {stages:#?}");
    };
    // A bound of D leaves fewer hits.
    let stages = of(Step::Phong, |parts| {
        parts.quadratic = |a, b, c| match b * b - 4.0 * a * c < 1.0 {
            true => Roots::None,
            false => quadratic(a, b, c),
        };
    });
    assert_wrong(&stages, "nearest", "no hit if D < 1", &[]);
    is_open(&stages, "outlines");
    let unit: fn(&Ray) -> DVec3 =
        |ray| step01_rays::direction_colour(ray).normalize();
    // A step that only passes on what another has computed.
    let stages = of(Step::Rays, |parts| parts.miss = unit);
    assert_wrong(&stages, "sky", "normalised(", &[]);
    is_open(&stages, "sum, bytes, order");
    // The same beside another slip.
    let turned: fn(&Ray) -> DVec3 = |ray| {
        let v = ray.direction;
        0.7 + 0.3 * DVec3::new(v.y, v.x, -v.z)
    };
    let stages = of(Step::Rays, |parts| {
        parts.miss = turned;
        parts.camera.matrix.y_axis.y *= 0.5;
    });
    is_open(&stages, "sky");
    // Of other rays, or of other numbers in the colours.
    let stages = of(Step::Rays, |parts| {
        parts.camera = Camera::new(320, 180, 44.6_f64.to_radians());
        parts.miss = |ray| {
            let v = ray.direction;
            0.31 + 0.69 * DVec3::new(v.x, v.y, -v.z)
        };
    });
    is_open(&stages, "rays");
    is_open(&stages, "sky");
}

/// Where one thing is wrong in the dark, the ambient light tells it.
#[test]
fn numbers_are_read_where_little_else_shows() {
    let stages = of(Step::Phong, |parts| {
        parts.scene.ambient_light *= 3.0;
        for material in parts.materials() {
            material.specular = material.surface.diffuse;
        }
    });
    let both = ["specular, warm", "specular, cool"];
    assert_wrong(&stages, "ambient", "(0.96, 0.96, 1.26)", &both);
    assert_wrong(&stages, both[0], "R_d", &["ambient", both[1]]);
}

#[test]
fn a_wrong_t_leaves_the_point_open() {
    let stages = of(Step::Diffuse, |parts| parts.point = |ray, t| ray.at(t - 0.1));
    let point = "or else t is right and the point p = S + t V";
    assert_wrong(&stages, "nearest", point, &[]);
    assert_ne!(named(&stages, "point and normal").verdict, Verdict::Right);
}

#[test]
fn what_one_number_explains_needs_no_second_one() {
    let stages = of(Step::Diffuse, |parts| {
        parts.scene.lights[1].point_light.position.y = 22.0;
    });
    assert_wrong(&stages, "diffuse, cool", "(5.5, 22, −11.5)", &[]);
}

#[test]
fn what_depends_on_more_than_the_distance_is_no_attenuation() {
    let stages = of(Step::Diffuse, |parts| {
        parts.normal = |sphere, p| (p - sphere.centre) / (p.length() + 0.7);
    });
    assert_ne!(
        named(&stages, "attenuation").verdict,
        Verdict::Wrong,
        "{stages:#?}"
    );
}

#[test]
fn one_colour_is_no_camera() {
    for odd in [0, 3] {
        let mut picture = Step::Phong.picture(&camera(320, 180), 1);
        for byte in picture.iter_mut() {
            *byte = (*byte).min(127) ^ if *byte < 127 { odd } else { 0 };
        }
        let stages = stages(&picture, Step::Phong);
        assert_ne!(named(&stages, "rays").verdict, Verdict::Wrong, "{stages:#?}");
        if odd == 0 {
            assert_wrong(&stages, "sum, bytes, order", "bytes end at 127", &[]);
        }
    }
}

#[test]
fn a_darker_sky_is_no_camera() {
    // As where the mean is that of the last of four rays.
    let mut parts = Parts::right(&camera(320, 180));
    let [d_u, d_v, v_0] = [0, 1, 2].map(|k| parts.camera.matrix.col(k));
    parts.camera.matrix.z_axis = v_0 + 0.25 * d_u + 0.25 * d_v;
    let mut picture = parts.picture(Step::Phong, 1);
    picture.pixels_mut().for_each(|pixel| pixel.0 = pixel.0.map(|byte| byte / 4));
    for stage in stages(&picture, Step::Phong) {
        assert!(matches!(stage.verdict, Verdict::Unknown(_)), "{stage:#?}");
    }
}

/// Highlights that no formula explains.
fn spoil(parts: &mut Parts) {
    parts.specular = |r, v, d, material, light| {
        specular(r, v, d, material, light) * (1.5 + (40.0 * d).sin())
    };
}

#[test]
fn a_sky_that_other_rays_would_see_is_no_camera_where_the_objects_are_seen_by_ours()
{
    let turned: fn(&Ray) -> DVec3 = |ray| {
        let sky = step01_rays::direction_colour(ray);
        DVec3::new(sky.y, sky.x, sky.z)
    };
    let stages = of(Step::Phong, |parts| {
        parts.miss = turned;
        spoil(parts);
    });
    let sky = "by the sky's colours, D_u is about (0, 0.00362, 0)";
    let both = ["specular, warm", "specular, cool"];
    assert_wrong(&stages, "sky", sky, &both);
    assert_ne!(named(&stages, "outlines").verdict, Verdict::Wrong);
    assert_eq!(named(&stages, "ambient").verdict, Verdict::Right);
    // Objects that neither sees leave it open.
    let stages = of(Step::Phong, |parts| {
        parts.miss = turned;
        parts.camera.matrix.y_axis.y *= -1.0;
        parts.camera.matrix.z_axis.y *= -1.0;
        spoil(parts);
    });
    assert_ne!(named(&stages, "rays").verdict, Verdict::Wrong, "{stages:#?}");
    // Those that the sky's rays see tell the camera.
    let stages = of(Step::Phong, |parts| {
        parts.camera.matrix.y_axis.y *= -1.0;
        parts.camera.matrix.z_axis.y *= -1.0;
        spoil(parts);
    });
    assert_wrong(&stages, "rays", "your D_v is about (0, 0.00362, 0)", &[]);
}

#[test]
fn blurred_edges_are_no_wrong_outlines() {
    let steps = [Step::Phong, Step::Sphere, Step::Nearest, Step::Diffuse];
    for step in some(steps, 1) {
        let sharp = step.picture(&camera(640, 360), 1);
        // As where the rays of a pixel go through its neighbours, too.
        let picture = RgbImage::from_fn(640, 360, |i, j| {
            let near = |k: u32, l: u32| {
                let (i, j) = ((i + k).clamp(2, 641), (j + l).clamp(2, 361));
                sharp.get_pixel(i - 2, j - 2).0.map(u32::from)
            };
            let all = (0..25).map(|k| near(k % 5, k / 5));
            let sum = all.fold([0; 3], |sum, p| [0, 1, 2].map(|k| sum[k] + p[k]));
            Rgb(sum.map(|sum| ((sum + 12) / 25) as u8))
        });
        let stages = stages(&picture, step);
        let outlines = &named(&stages, "outlines").verdict;
        assert_ne!(*outlines, Verdict::Wrong, "{step:?} {stages:#?}");
    }
}

#[test]
fn a_sky_like_that_of_another_angle_is_not_right() {
    let camera = camera(640, 360);
    let picture = RgbImage::from_fn(640, 360, |i, j| {
        let v = camera.ray(i.into(), j.into()).direction;
        let sky = [v.x, v.y, -v.z].map(|v| 255.0 * (0.7 + 0.35 * v) + 0.5);
        Rgb(sky.map(|byte| byte as u8))
    });
    let stages = stages(&picture, Step::Rays);
    assert_ne!(named(&stages, "sky").verdict, Verdict::Right, "{stages:#?}");
}

#[test]
fn columns_and_rows_that_are_not_drawn_are_told_and_a_black_sky_is_not() {
    let right = Step::Phong.picture(&camera(320, 180), 1);
    let without = |is_drawn: fn(u32, u32) -> bool| {
        let picture = RgbImage::from_fn(320, 180, |i, j| {
            if is_drawn(i, j) { *right.get_pixel(i, j) } else { Rgb([0; 3]) }
        });
        stages(&picture, Step::Phong)
    };
    let sum = "sum, bytes, order";
    let first = "the first column, column 0, is black";
    assert_wrong(&without(|i, _| 0 < i), sum, first, &[]);
    let last = "the last 20 rows, 160 to 179, are black";
    assert_wrong(&without(|_, j| j < 160), sum, last, &[]);
    let second = "only one column of 2 is drawn, from column 0 on";
    assert_wrong(&without(|i, _| i % 2 == 0), sum, second, &[]);
    let black = of(Step::Nearest, |parts| parts.miss = |_| glam::DVec3::ZERO);
    let told = black.iter().flat_map(|stage| &stage.numbers);
    assert!(!told.into_iter().any(|told| told.contains("drawn")), "{black:#?}");
}

#[test]
fn no_picture_is_too_small_or_too_odd() {
    for (width, height) in [(1, 1), (1, 9), (2, 1), (3, 2), (17, 200)] {
        for step in some([Step::Phong, Step::Rays, Step::Nearest], 3) {
            stages(&RgbImage::new(width, height), step);
            let odd = RgbImage::from_fn(width, height, |i, j| {
                Rgb([(i * 97 + j * 31) as u8, (i * j) as u8, (i ^ j) as u8])
            });
            stages(&odd, step);
        }
    }
}
