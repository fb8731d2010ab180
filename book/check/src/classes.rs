use crate::scenes::Scenes;
use crate::{Step, camera};
use image::RgbImage;
use step05_phong::{Light, Ray, Sphere, SurfacePoint, nearest, normal, reflect};

/// What our own program sees in one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Seen {
    /// The number of the object, None where it is the sky.
    pub object: Option<usize>,
    /// Whether the ray meets another one, too.
    pub is_crowded: bool,
    /// Whether each light is on the outer side there.
    pub is_lit: [bool; 2],
    /// Whether a light is so that its highlight, large or small, reaches there.
    pub shines: bool,
}

/// What is in each pixel, row by row.
pub(crate) fn classes(step: Step, yours: &RgbImage) -> Vec<Seen> {
    let scenes = Scenes::right();
    let spheres = scenes.spheres(step);
    let camera = camera(yours.width(), yours.height());
    let pixels = yours.enumerate_pixels();
    let seen = pixels.map(|(i, j, _)| {
        seen(step, &scenes, &spheres, &camera.ray(i.into(), j.into()))
    });
    seen.collect()
}

fn seen(step: Step, scenes: &Scenes, spheres: &[Sphere], ray: &Ray) -> Seen {
    let hits = spheres.iter().map(|sphere| sphere.intersect(ray).first_hit());
    let hits = hits.zip(0..).filter_map(|(t, k)| Some((t?, k)));
    let count = hits.clone().count();
    let Some((t, k)) = hits.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return Seen::default();
    };
    let mut seen =
        Seen { object: Some(k), is_crowded: 1 < count, ..Seen::default() };
    if step < Step::Diffuse {
        return seen;
    }
    let p = ray.at(t);
    let n = normal(&spheres[k], p);
    for (light, is_lit) in scenes.shiny.lights.iter().zip(&mut seen.is_lit) {
        let (l, _) = light.point_light.direction_from(p);
        *is_lit = 0.0 < n.dot(l);
        if step == Step::Phong && *is_lit {
            seen.shines |= 0.0 < reflect(n, l).dot(-ray.direction);
        }
    }
    seen
}

/// What our program computes for one pixel, in letters of the book.
pub(crate) fn computed(step: Step, ray: &Ray) -> String {
    let scenes = Scenes::right();
    let v = ray.direction;
    let sky = format!("the sky, V = {}", three(v));
    let objects = &scenes.shiny.objects;
    if step == Step::Sphere {
        let (a, b, c) = scenes.sphere.coefficients(ray);
        let t = scenes.sphere.intersect(ray).first_hit();
        let t = t.map_or("no hit".to_owned(), |t| format!("t = {t:.4}"));
        return format!("a = {a:.4}, b = {b:.4}, c = {c:.4}, {t}");
    }
    let Some(hit) = nearest(objects, ray).filter(|_| step != Step::Rays) else {
        return sky;
    };
    let k = objects.iter().position(|one| one.sphere == hit.object.sphere);
    let name = crate::scenes::OBJECTS[k.unwrap_or_default()];
    let start = format!("{name} at t = {:.4}", hit.t);
    if step == Step::Nearest {
        return start;
    }
    let p = ray.at(hit.t);
    let n = normal(&hit.object.sphere, p);
    let lights = scenes.shiny.lights.iter().zip(["warm", "cool"]);
    let each = lights.map(|(Light { point_light, .. }, name)| {
        let (l, d) = point_light.direction_from(p);
        format!("; {name} n·l = {}, d = {d:.4}", signed(n.dot(l)))
    });
    let mut text = format!("{start}, n = {}{}", three(n), each.collect::<String>());
    if step == Step::Phong {
        let point = SurfacePoint { p, n, material: &hit.object.material };
        let scene = &scenes.shiny;
        let sum =
            step05_phong::phong(&point, ray, scene.ambient_light, &scene.lights);
        text += &format!(
            ";\n  I_a = {}, I_d = {}, I_s = {}",
            three(sum.ambient),
            three(sum.diffuse),
            three(sum.specular)
        );
    }
    text
}

fn three(vector: glam::DVec3) -> String {
    format!("({})", vector.to_array().map(signed).join(", "))
}

fn signed(number: f64) -> String {
    format!("{number:.4}").replace('-', "−")
}
