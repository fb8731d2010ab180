use crate::Step;
use crate::evidence::{Evidence, Pixel};
use crate::step_scene::{LIGHTS, OBJECT_COUNT, Scene, hits, object_name, scene};
use glam::DVec3;
use step05_phong::{Ray, normal, reflect, terms};

/// What our own program sees in a pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Region {
    /// The number of the object, None where it is the sky.
    pub object: Option<u8>,
    /// Whether the ray meets another one, too.
    pub is_crowded: bool,
    /// Whether each light is on the outer side there.
    pub lit: [bool; 2],
    /// Whether a light is so that its highlight, large or small, reaches there.
    pub shines: bool,
}

impl Region {
    /// What tells the region of a ray of a step; of an exercise nothing is known.
    pub fn reader(step: Option<Step>) -> impl Fn(&Ray) -> Self {
        let scene = step.map(|step| (step, scene(step)));
        move |ray| match &scene {
            Some((step, scene)) => Self::of(*step, scene, ray),
            None => Self::default(),
        }
    }

    fn of(step: Step, scene: &Scene, ray: &Ray) -> Self {
        let hits = hits(scene, ray);
        let mut region = Self { is_crowded: 1 < hits.len(), ..Self::default() };
        let Some((t, k)) = hits.first().copied() else { return region };
        region.object = u8::try_from(k).ok();
        if step < Step::Diffuse {
            return region;
        }
        let p = ray.at(t);
        let n = normal(&scene.objects[k].sphere, p);
        for (light, lit) in scene.lights.iter().zip(&mut region.lit) {
            let l = (light.point_light.position - p).normalize();
            *lit = 0.0 < n.dot(l);
            let shines = 0.0 < reflect(n, l).dot(-ray.direction);
            region.shines |= step == Step::Phong && *lit && shines;
        }
        region
    }
}

type InRegion = Box<dyn Fn(&Pixel) -> bool>;

/// The regions of a step, in the order of the stages that draw them, with their names.
pub(crate) fn regions(step: Step) -> Vec<(String, InRegion)> {
    let mut regions: Vec<(String, InRegion)> = vec![(
        "the sky".to_owned(),
        Box::new(|pixel| pixel.region.object.is_none()),
    )];
    if step < Step::Diffuse {
        let count = if step == Step::Rays { 0 } else { OBJECT_COUNT };
        regions.extend((0..count).filter(|k| step != Step::Sphere || *k == 0).map(
            |k| {
                let is_object: InRegion =
                    Box::new(move |pixel| pixel.region.object == Some(k as u8));
                (object_name(step, k).to_owned(), is_object)
            },
        ));
        return regions;
    }
    let lit = move |lit: [bool; 2]| -> InRegion {
        Box::new(move |pixel| {
            let Region { object, lit: own, shines, .. } = pixel.region;
            object.is_some() && own == lit && !shines
        })
    };
    let without = if step == Step::Phong { ", without highlights" } else { "" };
    regions.extend([
        ("what no light reaches".to_owned(), lit([false; 2])),
        (format!("what {} alone reaches{without}", LIGHTS[0]), lit([true, false])),
        (format!("what {} alone reaches{without}", LIGHTS[1]), lit([false, true])),
        (format!("what both lights reach{without}"), lit([true; 2])),
    ]);
    if step == Step::Phong {
        regions.push((
            "where highlights may be".to_owned(),
            Box::new(|pixel| pixel.region.shines),
        ));
    }
    regions
}

/// The names of all objects that have a wrong pixel, and how many there are.
pub(crate) fn wrong_objects(evidence: &Evidence, step: Step) -> Vec<&'static str> {
    let mut is_wrong = [false; OBJECT_COUNT];
    for pixel in evidence.wrong() {
        if let Some(k) = pixel.region.object {
            is_wrong[usize::from(k)] = true;
        }
    }
    let wrong = (0..OBJECT_COUNT).filter(|k| is_wrong[*k]);
    wrong.map(|k| object_name(step, k)).collect()
}

/// What our program computes for one pixel, in letters of the book.
pub(crate) fn computed(step: Step, ray: &Ray) -> String {
    let scene = scene(step);
    let Some((t, k)) = hits(&scene, ray).first().copied() else {
        return format!("the sky, V = {}", format_vector(ray.direction));
    };
    let mut text = format!("{} at t = {t:.4}", object_name(step, k));
    if Step::Diffuse <= step {
        let p = ray.at(t);
        let n = normal(&scene.objects[k].sphere, p);
        text += &format!(", n = {}", format_vector(n));
        for (light, name) in scene.lights.iter().zip(LIGHTS) {
            let to_light = light.point_light.position - p;
            let (l, d) = (to_light.normalize(), to_light.length());
            text +=
                &format!("; {name}: n·l = {}, d = {d:.4}", format_number(n.dot(l)));
        }
    }
    if step == Step::Phong
        && let Some(terms) = terms(&scene, ray)
    {
        let [a, d, s] =
            [terms.ambient, terms.diffuse, terms.specular].map(format_vector);
        text += &format!(";\n  I_a = {a}, I_d = {d}, I_s = {s}");
    }
    text
}

fn format_vector(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(format_number).join(", "))
}

fn format_number(number: f64) -> String {
    format!("{number:.4}").replace('-', "−")
}
