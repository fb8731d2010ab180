//! Slips of the hand that no list has, one of each kind: told as the formula that they
//! are.

use ::check::{Verdict, stages};
use gallery::{Parts, Step, camera};
use glam::DVec3;
use image::RgbImage;
use std::f64::consts::PI;
use step01_rays::{Camera, Ray};
use step02_sphere::Roots;
use step04_diffuse::{Surface, diffuse};
use step05_phong::{
    Phong, SurfacePoint, direction_colour, reflect, render, specular, terms,
    visible_point,
};

/// Asserts that one slip is told as this formula, in its own stage and in no other.
fn assert_told(step: Step, change: fn(&mut Parts), stage: &str, formula: &str) {
    let mut parts = Parts::right(&camera(160, 90));
    change(&mut parts);
    assert_picture_told(&parts.picture(step, 1), step, stage, formula);
}

/// The same of a picture.
fn assert_picture_told(yours: &RgbImage, step: Step, stage: &str, formula: &str) {
    let stages = stages(yours, step);
    let wrong = stages.iter().filter(|one| one.verdict == Verdict::Wrong);
    let wrong: Vec<_> = wrong.collect();
    let is_it = wrong.iter().all(|one| one.name.starts_with(stage));
    assert!(is_it && !wrong.is_empty(), "{stage}: {stages:#?}");
    let told = wrong[0].numbers.join("; ");
    assert!(told.contains(formula), "{formula} is not in {told}");
}

#[test]
fn a_name_for_another_kind_of_thing() {
    let normal = "point and normal";
    assert_told(
        Step::Diffuse,
        |parts| parts.normal = |sphere, p| (p - sphere.centre) / p.length(),
        normal,
        "n = (p − centre) / |p|",
    );
    assert_told(
        Step::Diffuse,
        |parts| parts.normal = |sphere, p| (p - sphere.radius) / sphere.radius,
        normal,
        "n = (p − radius) / radius",
    );
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                let mut light = *light;
                light.diffuse = DVec3::splat(light.diffuse.x);
                diffuse(n, l, d, surface, &light)
            };
        },
        "diffuse",
        "max(l·n, 0) L_d_x",
    );
}

#[test]
fn a_part_that_is_forgotten() {
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                diffuse(n, l.with_z(0.0), d, surface, light)
            };
        },
        "diffuse",
        "(l_x, l_y, 0)·n",
    );
    assert_told(
        Step::Phong,
        |parts| {
            parts.seen_from = |light, p| {
                let w = light.position - p;
                (w.normalize(), w.z.abs())
            };
        },
        "attenuation",
        "d = |w_z|",
    );
    // Of v · v, too, where it is written out.
    assert_told(
        Step::Nearest,
        |parts| {
            parts.coefficients = |sphere, ray| {
                let (_, b, c) = sphere.coefficients(ray);
                let v = ray.direction;
                (v.x * v.x + v.z * v.z, b, c)
            };
        },
        "outlines",
        "a = v_x² + v_z²",
    );
}

#[test]
fn an_angle_that_is_nearly_right_and_a_light_of_one_brightness() {
    // No candidate among the numbers is nearer than ours is already.
    let camera = Camera::new(640, 360, 60.0 * 314.0 / 18_000.0);
    let yours = Parts::right(&camera).picture(Step::Phong, 1);
    assert_picture_told(&yours, Step::Phong, "rays", "θ = fov · 3.14 / 180");
    assert_told(
        Step::Diffuse,
        |parts| {
            let light = parts.scene.ambient_light.length();
            parts.scene.ambient_light = DVec3::splat(light);
        },
        "ambient",
        "I_a = R_a |L_a|",
    );
}

#[test]
fn samples_by_another_weight_and_a_pixel_apart() {
    let (camera, scene) = (camera(320, 180), step05_phong::scene());
    let colour = |ray: &Ray| {
        terms(&scene, ray)
            .map_or_else(|| direction_colour(ray), |terms| terms.sum())
    };
    let bright = render(&camera, 3, |ray| 1.5 * colour(ray));
    let told = "the sum of 3 × 3 samples is divided by 6";
    assert_picture_told(&bright, Step::Phong, "sum", told);
    let wide = render(&camera, 1, |ray| {
        let offsets = [-1.0, 0.0, 1.0];
        let (d_u, d_v) = (camera.matrix.x_axis, camera.matrix.y_axis);
        let mut sum = DVec3::ZERO;
        for v in offsets {
            for u in offsets {
                let direction = ray.direction + u * d_u + v * d_v;
                sum += colour(&Ray { direction, ..*ray });
            }
        }
        sum / 9.0
    });
    let told = "the 3 × 3 samples of a pixel are a pixel apart";
    assert_picture_told(&wide, Step::Phong, "rays", told);
}

#[test]
fn a_sign_a_factor_or_a_square_in_another_place() {
    assert_told(
        Step::Phong,
        |parts| parts.reflect = |l, n| 2.0 + n.dot(l) * n - l,
        "specular",
        "r = 2 + n·l n − l",
    );
    assert_told(
        Step::Phong,
        |parts| parts.reflect = |l, n| n.dot(l) * n - 2.0 * l,
        "specular",
        "r = n·l n − 2 l",
    );
    assert_told(
        Step::Nearest,
        |parts| {
            parts.coefficients = |sphere, ray| {
                let (a, b, _) = sphere.coefficients(ray);
                let s = ray.start - sphere.centre;
                (a, b, (s.length() - sphere.radius).powi(2))
            };
        },
        "outlines",
        "c = (|s| − radius)²",
    );
}

#[test]
fn another_number_or_bound() {
    assert_told(
        Step::Phong,
        |parts| {
            parts.specular = |r, v, d, material, light| match r.dot(v) {
                ..=0.9 => DVec3::ZERO,
                _ => specular(r, v, d, material, light),
            };
        },
        "specular",
        "0 if r·v ≤ 0.9",
    );
    assert_told(
        Step::Diffuse,
        |parts| {
            for object in &mut parts.scene.objects {
                object.material.material.surface.diffuse /= std::f64::consts::PI;
            }
        },
        "diffuse",
        "R_d = colour · 0.3183",
    );
    assert_told(
        Step::Rays,
        |parts| parts.byte = |x| (255.0 * (x / (1.0 + x)) + 0.5) as u8,
        "s",
        "B = floor(255 (M / (M + 1)) + 0.5)",
    );
}

#[test]
fn bytes_of_numbers_from_minus_one_and_whole_numbers_divided() {
    assert_told(
        Step::Diffuse,
        |parts| parts.byte = |intensity| (127.5 * (intensity + 1.0) + 0.5) as u8,
        "sum",
        "B = floor(127.5 (M + 1) + 0.5)",
    );
    assert_told(
        Step::Phong,
        |parts| parts.materials().for_each(|material| material.shininess /= 4),
        "specular",
        "n = floor((n of the nearest) / 4)",
    );
    assert_told(
        Step::Phong,
        |parts| parts.materials().for_each(|material| material.shininess /= 10),
        "specular",
        "n = floor((n of the nearest) / 10)",
    );
}

#[test]
fn colours_that_are_what_the_highlights_leave() {
    assert_told(
        Step::Phong,
        |parts| {
            for material in parts.materials() {
                material.surface.ambient *= 1.0 - material.specular;
                material.surface.diffuse *= 1.0 - material.specular;
            }
        },
        "colours",
        "colour (1 − R_s)",
    );
}

#[test]
fn bytes_rounded_too_soon_and_a_channel_taken_twice() {
    assert_told(
        Step::Diffuse,
        |parts| parts.byte = |intensity| (255.0 * intensity.round()) as u8,
        "sum",
        "B = floor(255 floor(M + 0.5) + 0.5)",
    );
    assert_told(
        Step::Phong,
        |parts| {
            for material in parts.materials() {
                for colour in
                    [&mut material.surface.ambient, &mut material.surface.diffuse]
                {
                    colour.z = colour.y;
                }
            }
        },
        "colours",
        "(colour of the nearest)_y, (colour of the nearest)_y)",
    );
    assert_told(
        Step::Rays,
        |parts| {
            let camera = camera(161, 91);
            parts.camera = Camera { matrix: camera.matrix, ..parts.camera };
        },
        "rays",
        "columns = hRes and rows = vRes",
    );
}

#[test]
fn two_numbers_of_a_light_and_a_margin_of_the_nearest() {
    assert_told(
        Step::Diffuse,
        |parts| {
            let fade = &mut parts.scene.lights[0].point_light.attenuation;
            (fade.a, fade.b) = (fade.b, fade.a);
        },
        "attenuation",
        "a and b in a + bd + cd² have changed places, those of the warm light",
    );
    assert_told(
        Step::Nearest,
        |parts| {
            parts.nearest =
                |all| all.reduce(|a, b| if b.t < a.t + 1.0 { b } else { a });
        },
        "nearest",
        "that of the last with t < t so far + 1",
    );
}

#[test]
fn another_operation_between_two_terms() {
    assert_told(
        Step::Diffuse,
        |parts| {
            let light = parts.scene.ambient_light;
            for material in parts.materials() {
                let r_a = &mut material.surface.ambient;
                *r_a = (*r_a + light) / 2.0 / light;
            }
        },
        "ambient",
        "I_a = (R_a + L_a) / 2",
    );
    assert_told(
        Step::Diffuse,
        |parts| parts.attenuation = |k, d| k.a - (k.b * d + k.c * d * d),
        "attenuation",
        "divisor = a − (b d + c d²)",
    );
    assert_told(
        Step::Phong,
        |parts| parts.reflect = |l, n| n + l,
        "specular",
        "r = n + l",
    );
    assert_told(
        Step::Nearest,
        |parts| {
            parts.coefficients = |sphere, ray| {
                let (a, b, _) = sphere.coefficients(ray);
                (a, b, (ray.start - sphere.centre).length() - sphere.radius)
            };
        },
        "outlines",
        "c = |s| − radius",
    );
}

#[test]
fn the_last_of_four_samples_alone() {
    assert_told(
        Step::Nearest,
        |parts| {
            parts.ray = |ray| {
                let matrix = camera(160, 90).matrix;
                let offset = (matrix.x_axis + matrix.y_axis) / 4.0;
                Ray { direction: ray.direction + offset, ..ray }
            };
            parts.byte = |x| (255.0 * x / 4.0 + 0.5) as u8;
        },
        "",
        "of 2 × 2 samples in a pixel the last one alone is kept",
    );
}

#[test]
fn a_bound_in_a_picture_of_many_rays_a_pixel_or_of_a_wide_view() {
    let bound = |camera: Camera| {
        let mut parts = Parts::right(&camera);
        parts.lit = |n, l| 0.3 < n.dot(l);
        parts
    };
    let formula = "G = I_s if 0.3 < n·l, else 0";
    let wide = Camera::new(160, 90, PI / 2.0);
    let large = camera(480, 270);
    for (camera, samples) in [(camera(160, 90), 2), (large, 4), (wide, 1)] {
        let yours = bound(camera).picture(Step::Phong, samples);
        // Of very many rays, only some are cast.
        let told = if samples == 4 { " that was looked at" } else { "" };
        let told = format!("in every pixel{told}, {formula}");
        assert_picture_told(&yours, Step::Phong, "specular", &told);
    }
}

#[test]
fn no_light_is_divided_by_a_thousand_where_it_is_absent() {
    let mut parts = Parts::right(&camera(160, 90));
    parts.quadratic = |a, b, c| match b * b - 4.0 * a * c {
        ..0.0 => Roots::None,
        d => Roots::Two(-b - d.sqrt() / 2.0 * a, -b + d.sqrt() / 2.0 * a),
    };
    let stages = stages(&parts.picture(Step::Diffuse, 1), Step::Diffuse);
    let fades = stages.iter().find(|stage| stage.name == "attenuation");
    assert!(fades.is_some_and(|one| one.verdict != Verdict::Wrong), "{stages:#?}");
}

#[test]
fn a_plus_or_a_minus_within_a_product() {
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                let fade = light.attenuation.at(d);
                surface.diffuse - fade * l.dot(n).max(0.0) * light.diffuse
            };
        },
        "diffuse",
        "I_d = R_d − (a + b d + c d²) max(l·n, 0) L_d",
    );
}

#[test]
fn a_sum_that_begins_with_something() {
    let (camera, scene) = (camera(160, 90), step05_phong::scene());
    let picture =
        render(&camera, 1, |ray| match visible_point(&scene.objects, ray) {
            Some(point) => {
                let right = terms(&scene, ray).map_or(DVec3::ZERO, |sum| sum.sum());
                right + point.material.specular
            }
            None => direction_colour(ray),
        });
    let told = "E_s = R_s + (the sum of G over all lights)";
    assert_picture_told(&picture, Step::Phong, "specular", told);
}

#[test]
fn the_highlights_of_the_last_light_that_shines() {
    let (camera, scene) = (camera(160, 90), step05_phong::scene());
    let picture = render(&camera, 1, |ray| {
        let mut last = DVec3::ZERO;
        let Some(SurfacePoint { p, n, material }) =
            visible_point(&scene.objects, ray)
        else {
            return direction_colour(ray);
        };
        let v = -ray.direction.normalize();
        for light in &scene.lights {
            let (l, d) = light.point_light.direction_from(p);
            if 0.0 < n.dot(l) {
                last = specular(reflect(n, l), v, d, material, light);
            }
        }
        let sum = terms(&scene, ray)
            .map_or(DVec3::ZERO, |terms| terms.sum() - terms.specular);
        sum + last
    });
    assert_picture_told(
        &picture,
        Step::Phong,
        "specular",
        "those of the last light that shines on the point, not their sum",
    );
}

#[test]
fn two_vectors_that_are_made_unit_vectors() {
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.seen_from = |light, p| {
                let w = light.position.normalize() - p.normalize();
                (w.normalize(), w.length())
            };
        },
        "diffuse",
        "w = normalised(P) − normalised(p)",
    );
}

#[test]
fn a_step_by_another_number_of_pixels() {
    assert_told(
        Step::Sphere,
        |parts| parts.camera.matrix.y_axis.y = -(30_f64.to_radians().tan()) / 89.0,
        "rays",
        "D_v = (0, −h / rows, 0)",
    );
    assert_told(
        Step::Sphere,
        |parts| parts.camera.matrix.y_axis.y *= 89.0 / 159.0,
        "rays",
        "D_v = (0, (−2) h rows / columns / columns, 0)",
    );
    assert_told(
        Step::Sphere,
        |parts| parts.camera.matrix.x_axis.z = -1.0 / 159.0,
        "rays",
        "where ours is D_u = (2 h / columns, 0, 0)",
    );
    assert_told(
        Step::Rays,
        |parts| parts.camera.matrix.y_axis.y *= -1.0,
        "rays",
        "in every pixel, V = i D_u − j D_v + V_0",
    );
}

#[test]
fn a_sphere_that_few_pixels_show() {
    assert_told(
        Step::Nearest,
        |parts| parts.scene.objects[7].sphere.radius = 1.56,
        "outlines",
        "the salmon sphere has a radius of 1.56",
    );
    assert_told(
        Step::Nearest,
        |parts| parts.scene.objects[0].sphere.centre.z = -14.8,
        "outlines",
        "the red sphere is at (−0.65, −0.16, −14.8)",
    );
    assert_told(
        Step::Diffuse,
        |parts| parts.scene.objects[8].sphere.centre.y = 3.2,
        "outlines",
        "the cream sphere is at (−2.1, 3.2, −9.5)",
    );
}

#[test]
fn one_light_twice() {
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.scene.lights[1].point_light = parts.scene.lights[0].point_light
        },
        "diffuse, cool",
        "of the warm one (steps/step04_diffuse/src/scene.rs)",
    );
}

#[test]
fn a_polynomial_of_which_one_term_is_left() {
    assert_told(
        Step::Phong,
        |parts| parts.attenuation = |_, d| d * d,
        "attenuation",
        "divisor = d²",
    );
    assert_told(
        Step::Diffuse,
        |parts| parts.attenuation = |k, d| 1.0 + k.c * d * d,
        "attenuation",
        "divisor = 1 + c d²",
    );
    assert_told(
        Step::Diffuse,
        |parts| parts.attenuation = |k, d| k.at(d) - 0.25,
        "attenuation",
        "divisor = a + b d + c d² − 0.25",
    );
}

#[test]
fn what_other_books_do_to_the_sum_or_to_the_lobe() {
    let of_terms = |sum: fn(Phong) -> DVec3| {
        let scene = step05_phong::scene();
        render(&camera(160, 90), 1, |ray| {
            terms(&scene, ray).map_or_else(|| direction_colour(ray), sum)
        })
    };
    let gamma = of_terms(|terms| terms.sum().powf(1.0 / 2.2));
    let told = "I = (I_a + E_d + E_s)^0.4545";
    assert_picture_told(&gamma, Step::Phong, "sum", told);
    let most = of_terms(|its| its.ambient + its.diffuse.max(its.specular));
    let told = "I = I_a + max(E_d, E_s)";
    assert_picture_told(&most, Step::Phong, "s", told);
    assert_told(
        Step::Phong,
        |parts| {
            parts.specular = |r, v, d, material, light| {
                let lobe = f64::from(material.shininess + 2) / (2.0 * PI);
                lobe * specular(r, v, d, material, light)
            };
        },
        "specular",
        "((n + 2) / 6.283)",
    );
}

#[test]
fn one_number_for_all_that_there_are() {
    assert_told(
        Step::Diffuse,
        |parts| {
            parts.diffuse = |n, l, d, surface, light| {
                let surface = Surface { diffuse: DVec3::splat(0.45), ..*surface };
                diffuse(n, l, d, &surface, light)
            };
        },
        "diffuse",
        "R_d = (0.45, 0.45, 0.45)",
    );
    assert_told(
        Step::Nearest,
        |parts| parts.miss = |_| DVec3::ZERO,
        "s",
        "seen = 0 if nearest < 0, else I",
    );
    // As the slide has it.
    assert_told(
        Step::Rays,
        |parts| parts.camera.matrix.y_axis.y *= 89.0,
        "rays",
        "D_v = (0, (−2) h rows / columns, 0)",
    );
}

#[test]
fn colours_in_a_picture_of_many_rays_a_pixel() {
    // No pixel of an object is ours: outlines tell how many rays there are.
    for samples in [4, 6] {
        let mut parts = Parts::right(&camera(160, 90));
        for material in parts.materials() {
            material.surface.diffuse = material.surface.diffuse.powf(2.2);
        }
        let yours = parts.picture(Step::Nearest, samples);
        assert_picture_told(&yours, Step::Nearest, "colours", "I = colour^2.2");
    }
}

#[test]
fn bytes_of_each_sample() {
    let mut parts = Parts::right(&camera(160, 90));
    let scene = step05_phong::scene();
    let cut = render(&parts.camera, 3, |ray| {
        let colour = terms(&scene, ray)
            .map_or_else(|| direction_colour(ray), |terms| terms.sum());
        (255.0 * colour).floor() / 255.0
    });
    let told = "each sample is cut off to a byte, before the mean of all is taken";
    assert_picture_told(&cut, Step::Phong, "sum", told);
    // Half a byte, here and there, is no other camera.
    parts.byte = |x| (255.0 * x.clamp(0.0, 1.0)) as u8;
    parts.materials().for_each(|material| material.shininess /= 2);
    let stages = stages(&parts.picture(Step::Phong, 1), Step::Phong);
    assert_ne!(stages[0].verdict, Verdict::Wrong, "{stages:#?}");
}

#[test]
fn what_two_options_hide() {
    let view =
        |degrees: f64| Parts::right(&Camera::new(320, 180, degrees.to_radians()));
    let mut parts = view(45.0);
    for material in parts.materials() {
        material.specular *= material.surface.diffuse;
    }
    let yours = parts.picture(Step::Phong, 2);
    let told = "R_s = (g, g, g) R_d";
    assert_picture_told(&yours, Step::Phong, "specular", told);
    // No outline is where ours is: the shares of two colours tell how many rays there are.
    let mut parts = view(50.0);
    for object in &mut parts.scene.objects {
        object.sphere.radius /= 2.0;
    }
    let yours = parts.picture(Step::Nearest, 4);
    let told = "radius = radius / 2";
    assert_picture_told(&yours, Step::Nearest, "outlines", told);
    // Nor is any where the rows are a fraction of a pixel too high.
    let mut parts = view(60.0);
    parts.camera.matrix.z_axis.y *= 180.0 / 179.0;
    let yours = parts.picture(Step::Phong, 4);
    assert_picture_told(&yours, Step::Phong, "rays", "rows = vRes");
}
