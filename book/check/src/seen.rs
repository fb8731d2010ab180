use crate::scene::{COUNT, LIGHTS, Scene, colour, object, scene};
use crate::{Step, camera};
use glam::DVec3;
use image::RgbImage;
use step01_rays::rgb8;
use step05_phong::{Ray, normal, reflect, terms};

/// A pixel: what our own program sees there, and what is in the picture.
pub(crate) struct Seen {
    /// The number of the object, None where it is the sky.
    pub object: Option<usize>,
    /// Whether the ray meets another one, too.
    pub is_crowded: bool,
    /// Whether each light is on the outer side there.
    pub lit: [bool; 2],
    /// Whether a light is so that its highlight, large or small, reaches there.
    pub shines: bool,
    /// Whether the pixel is right.
    pub is_right: bool,
    /// Whether it is that of the sky, behind all objects.
    pub shows_sky: bool,
    /// The picture's.
    pub yours: [u8; 3],
}

/// All pixels of a picture of a step.
pub(crate) struct Pixels {
    pub step: Step,
    /// Row by row.
    pub all: Vec<Seen>,
}

impl Pixels {
    pub fn new(step: Step, yours: &RgbImage, ours: &RgbImage) -> Self {
        let scene = scene(step);
        let sky = colour(Step::Rays, &scene);
        let camera = camera(yours.width(), yours.height());
        let pairs = yours.enumerate_pixels().zip(ours.pixels());
        let all = pairs.map(|((i, j, yours), ours)| {
            let ray = camera.ray(i.into(), j.into());
            Seen {
                is_right: yours == ours,
                shows_sky: rgb8(sky(&ray)) == *yours,
                yours: yours.0,
                ..seen(step, &scene, &ray)
            }
        });
        Self { step, all: all.collect() }
    }

    /// How many pixels of a class are of another class, too, and how many there are.
    pub fn count(
        &self,
        is_in: impl Fn(&Seen) -> bool,
        is_too: impl Fn(&Seen) -> bool,
    ) -> (usize, usize) {
        let all = self.all.iter().filter(|seen| is_in(seen));
        all.fold((0, 0), |(some, all), seen| {
            (some + usize::from(is_too(seen)), all + 1)
        })
    }

    /// How many pixels of a class are wrong, and how many there are.
    pub fn wrong(&self, is_in: impl Fn(&Seen) -> bool) -> (usize, usize) {
        self.count(is_in, |seen| !seen.is_right)
    }

    /// The objects of which something holds, and their names.
    pub fn those(&self, is_one: impl Fn(usize) -> bool) -> (Vec<usize>, String) {
        let those: Vec<_> = (0..COUNT).filter(|k| is_one(*k)).collect();
        let names: Vec<_> = those.iter().map(|k| object(self.step, *k)).collect();
        let names = match names.len() {
            5.. => format!("{} objects", names.len()),
            _ => names.join(", "),
        };
        (those, names)
    }
}

fn seen(step: Step, scene: &Scene, ray: &Ray) -> Seen {
    let hits = hits(scene, ray);
    let mut seen = Seen {
        object: hits.first().map(|(_, k)| *k),
        is_crowded: 1 < hits.len(),
        lit: [false; 2],
        shines: false,
        is_right: true,
        shows_sky: false,
        yours: [0; 3],
    };
    if let Some((t, k)) = hits.first().filter(|_| Step::Diffuse <= step) {
        let p = ray.at(*t);
        let n = normal(&scene.objects[*k].sphere, p);
        for (light, lit) in scene.lights.iter().zip(&mut seen.lit) {
            let (l, _) = light.point_light.direction_from(p);
            *lit = 0.0 < n.dot(l);
            let shines = 0.0 < reflect(n, l).dot(-ray.direction);
            seen.shines |= step == Step::Phong && *lit && shines;
        }
    }
    seen
}

/// The t and the number of each object that a ray meets, the nearest first.
fn hits(scene: &Scene, ray: &Ray) -> Vec<(f64, usize)> {
    let hit =
        |k: usize| Some((scene.objects[k].sphere.intersect(ray).first_hit()?, k));
    let mut hits: Vec<_> = (0..scene.objects.len()).filter_map(hit).collect();
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    hits
}

/// What our program computes for one pixel, in letters of the book.
pub(crate) fn computed(step: Step, ray: &Ray) -> String {
    let scene = scene(step);
    let Some((t, k)) = hits(&scene, ray).first().copied() else {
        return format!("the sky, V = {}", three(ray.direction));
    };
    let mut text = format!("{} at t = {t:.4}", object(step, k));
    if Step::Diffuse <= step {
        let p = ray.at(t);
        let n = normal(&scene.objects[k].sphere, p);
        text += &format!(", n = {}", three(n));
        for (light, name) in scene.lights.iter().zip(LIGHTS) {
            let (l, d) = light.point_light.direction_from(p);
            text += &format!("; {name}: n·l = {}, d = {d:.4}", signed(n.dot(l)));
        }
    }
    if step == Step::Phong
        && let Some(terms) = terms(&scene, ray)
    {
        let [a, d, s] = [terms.ambient, terms.diffuse, terms.specular].map(three);
        text += &format!(";\n  I_a = {a}, I_d = {d}, I_s = {s}");
    }
    text
}

fn three(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(signed).join(", "))
}

fn signed(number: f64) -> String {
    format!("{number:.4}").replace('-', "−")
}
