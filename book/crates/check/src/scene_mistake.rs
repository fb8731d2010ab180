//! Listed mistakes drawn with any scene: our formulas, one of which is another.

use crate::drawing::Scene;
use course::{Mistake, mistakes};
use glam::DVec3;
use step05_phong::{
    Hit, Light, Material, Matte, PointLight, Ray, Sphere, ambient, diffuse, direction_colour,
    nearest, normal, reflect, specular,
};

/// The functions of which a picture of step 5 is made.
#[derive(Clone, Copy)]
pub(crate) struct Formulas {
    normal: fn(&Sphere, DVec3) -> DVec3,
    eye: fn(&Ray) -> DVec3,
    diffuse: fn(DVec3, DVec3, f64, &Matte, &PointLight) -> DVec3,
    gate: fn(f64) -> bool,
    reflect: fn(DVec3, DVec3) -> DVec3,
    specular: fn(DVec3, DVec3, f64, &Material, &Light) -> DVec3,
}

/// The formulas of the steps.
const OURS: Formulas = Formulas {
    normal,
    eye: |ray| -ray.direction.normalize(),
    diffuse,
    gate: |cosine| 0.0 < cosine,
    reflect,
    specular,
};

/// A change of the formulas.
type Change = fn(&mut Formulas);

/// Changes of the formulas, each by the title of the mistake in the list.
const MISTAKES: [(&str, Change); 13] = [
    ("normals point into the spheres", |ours| ours.normal = |one, p| -normal(one, p)),
    ("n is not a unit vector", |ours| ours.normal = |one, p| p - one.centre),
    ("n is the direction of p, without the centre", |ours| ours.normal = |_, p| p.normalize()),
    ("light does not fade with distance", |ours| {
        ours.diffuse = |n, l, _, one, light| one.diffuse * n.dot(l).max(0.0) * light.diffuse;
    }),
    ("l·n may be below 0", |ours| {
        ours.diffuse = |n, l, d, one, light| faded(one, light, d) * n.dot(l) * light.diffuse;
    }),
    ("|n·l| is taken for max(n·l, 0)", |ours| {
        ours.diffuse = |n, l, d, one, light| faded(one, light, d) * n.dot(l).abs() * light.diffuse;
    }),
    ("r points the wrong way", |ours| ours.reflect = |n, l| -reflect(n, l)),
    ("r has lost its 2: (n·l)n − l", |ours| ours.reflect = |n, l| n.dot(l) * n - l),
    ("n is mirrored in l", |ours| ours.reflect = |n, l| reflect(l, n)),
    ("v is −V and not a unit vector", |ours| ours.eye = |ray| -ray.direction),
    ("lights behind the surface give highlights", |ours| ours.gate = |_| true),
    ("the exponent n is left out", |ours| {
        ours.specular =
            |r, v, d, one, light| specular(r, v, d, &Material { shininess: 1, ..*one }, light);
    }),
    ("the specular term is not divided by a + bd + cd²", |ours| {
        ours.specular = |r, v, d, one, light| {
            specular(r, v, d, one, light) * light.point_light.attenuation.divisor(d)
        };
    }),
];

/// R_d / (a + bd + cd²).
fn faded(one: &Matte, light: &PointLight, d: f64) -> DVec3 {
    one.diffuse / light.attenuation.divisor(d)
}

/// The mistakes of the list that can be drawn with any scene, and what each draws.
pub(crate) fn scene_mistakes() -> Vec<(Mistake, Formulas)> {
    let all = mistakes();
    let find = |title| all.iter().find(|mistake| mistake.title == title).cloned();
    let formulas = |change: Change| {
        let mut formulas = OURS;
        change(&mut formulas);
        formulas
    };
    let known = MISTAKES.into_iter().filter_map(|(title, one)| Some((find(title)?, formulas(one))));
    known.collect()
}

impl Formulas {
    /// The intensity that a ray gets of a scene.
    pub fn colour(&self, scene: &Scene, ray: &Ray) -> DVec3 {
        let Some(Hit { t, object }) = nearest(&scene.objects, ray) else {
            return direction_colour(ray);
        };
        let (p, v) = (ray.at(t), (self.eye)(ray));
        let (n, material) = ((self.normal)(&object.sphere, p), &object.material);
        let (mut diffuse_sum, mut specular_sum) = (DVec3::ZERO, DVec3::ZERO);
        for light in &scene.lights {
            let (l, d) = light.point_light.direction_from(p);
            diffuse_sum += (self.diffuse)(n, l, d, &material.matte, &light.point_light);
            if (self.gate)(n.dot(l)) {
                specular_sum += (self.specular)((self.reflect)(n, l), v, d, material, light);
            }
        }
        ambient(&material.matte, scene.ambient_light) + diffuse_sum + specular_sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use course::{camera_with_size, find_mistakes_with_hash, hash_picture};
    use step05_phong::render;

    #[test]
    fn each_formula_draws_the_picture_of_its_mistake() {
        let scene = step05_phong::scene();
        let draw = |formulas: &Formulas| {
            render(&camera_with_size(640, 360), 1, |ray| formulas.colour(&scene, ray))
        };
        let locked = course::locked_hashes().find(|(name, _)| *name == "step05_phong");
        assert_eq!(locked.map(|(_, hash)| hash), Some(hash_picture(&draw(&OURS))));
        assert_eq!(scene_mistakes().len(), MISTAKES.len());
        for (mistake, formulas) in scene_mistakes() {
            let same = find_mistakes_with_hash(hash_picture(&draw(&formulas)));
            assert!(same.iter().any(|(one, _)| *one == mistake), "{}", mistake.title);
        }
    }
}
