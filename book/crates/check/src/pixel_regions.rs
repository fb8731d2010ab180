use crate::step_scene::{
    LIGHTS, Scene, hits_nearest_first, object_name_with_article, scene_of_step,
};
use course::Step;
use glam::DVec3;
use step05_phong::{Ray, normal, reflect, terms};

/// Region of our own scene in which a pixel is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Region {
    /// The number of the object, None where it is the sky.
    pub object: Option<u8>,
    /// Whether each light is on the outer side there.
    pub lit: [bool; 2],
    /// Whether a light is so that its highlight, large or small, reaches there.
    pub in_highlight: bool,
}

impl Region {
    /// Function from a ray to its region in the scene of a step; in an exercise to the default.
    pub fn function_of_ray(step: Option<Step>) -> impl Fn(&Ray) -> Self {
        let scene = step.map(|step| (step, scene_of_step(step)));
        move |ray| match &scene {
            Some((step, scene)) => Self::of_ray(*step, scene, ray),
            None => Self::default(),
        }
    }

    fn of_ray(step: Step, scene: &Scene, ray: &Ray) -> Self {
        let hits = hits_nearest_first(scene, ray);
        let mut region = Self::default();
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
            let in_highlight = 0.0 < reflect(n, l).dot(-ray.direction);
            region.in_highlight |= step == Step::Phong && *lit && in_highlight;
        }
        region
    }
}

/// Half a sentence: the values that our program computes for one pixel, in the book's letters.
pub(crate) fn computed_values_clause(step: Step, ray: &Ray) -> String {
    let scene = scene_of_step(step);
    let Some((t, k)) = hits_nearest_first(&scene, ray).first().copied() else {
        return format!("the sky, V = {}", format_vector_4_decimals(ray.direction));
    };
    let mut text = format!("{} at t = {t:.4}", object_name_with_article(step, k));
    if Step::Diffuse <= step {
        let p = ray.at(t);
        let n = normal(&scene.objects[k].sphere, p);
        text += &format!(", n = {}", format_vector_4_decimals(n));
        for (light, name) in scene.lights.iter().zip(LIGHTS) {
            let to_light = light.point_light.position - p;
            let (l, d) = (to_light.normalize(), to_light.length());
            text += &format!("; {name}: n·l = {}, d = {d:.4}", format_4_decimals(n.dot(l)));
        }
    }
    if step == Step::Phong
        && let Some(terms) = terms(&scene, ray)
    {
        let [a, d, s] =
            [terms.ambient, terms.diffuse, terms.specular].map(format_vector_4_decimals);
        text += &format!(";\n  I_a = {a}, I_d = {d}, I_s = {s}");
    }
    text
}

fn format_vector_4_decimals(vector: DVec3) -> String {
    format!("({})", vector.to_array().map(format_4_decimals).join(", "))
}

fn format_4_decimals(number: f64) -> String {
    format!("{number:.4}").replace('-', "−")
}
