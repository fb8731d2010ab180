//! A scene, drawn by the functions of a step.

use course::{LIGHT_NAMES, OwnScene, Step, generate_scene};
use glam::DVec3;
use step01_rays::rgb8;
use step05_phong::{Light, Ray, Terms, ambient, direction_colour, light_terms, normal};

/// A scene, and the step whose functions draw it.
pub(crate) struct StepScene {
    pub step: Step,
    pub own_scene: OwnScene,
    /// The names of the lights, in the order of the scene.
    pub light_names: [&'static str; 2],
}

/// The first point where a ray hits an object.
#[derive(Clone, Copy)]
pub(crate) struct ObjectHit {
    pub t: f64,
    /// The index of the object in the scene.
    pub object: usize,
}

impl StepScene {
    /// The scene of a step. The scene of step 1 has no objects, and the scene of step 2 has only
    /// the sphere.
    pub fn of_step(step: Step) -> Self {
        let mut scene = step05_phong::scene();
        match step {
            Step::Rays => scene.objects.clear(),
            Step::Sphere => {
                scene.objects.truncate(1);
                scene.objects[0].sphere = step02_sphere::SPHERE;
                scene.objects[0].name = "sphere";
            }
            _ => {}
        }
        let light_names = LIGHT_NAMES.map(|light| light.with_article);
        Self { step, own_scene: OwnScene::new(scene), light_names }
    }

    /// The scene that is generated from a name, drawn by step 5.
    pub fn of_generated_scene(name: &str) -> Self {
        let light_names = ["the first light", "the second light"];
        Self { step: Step::Phong, own_scene: OwnScene::new(generate_scene(name)), light_names }
    }

    /// The names of the objects. Names that don't end in a number get an article.
    pub fn object_names(&self) -> Vec<String> {
        let names = self.own_scene.scene.objects.iter().map(|object| object.name);
        let has_number = |name: &str| name.ends_with(|c: char| c.is_numeric());
        names
            .map(|name| if has_number(name) { name.into() } else { format!("the {name}") })
            .collect()
    }

    /// The intensity of the light that arrives along a ray.
    pub fn colour(&self, ray: &Ray) -> DVec3 {
        let hit = self.visible_hit(ray);
        hit.map_or_else(|| direction_colour(ray), |hit| self.colour_at_hit(ray, hit))
    }

    /// The bytes of a pixel whose light arrives along this ray.
    pub fn bytes(&self, ray: &Ray) -> [u8; 3] {
        rgb8(self.colour(ray)).0
    }

    /// The first hit of a ray on each object, whether or not the hit is visible.
    pub fn first_hits_on_objects(&self, ray: &Ray) -> impl Iterator<Item = ObjectHit> {
        self.own_scene.scene.objects.iter().enumerate().filter_map(|(k, object)| {
            let t = object.sphere.intersect(ray).first_hit()?;
            Some(ObjectHit { t, object: k })
        })
    }

    /// The nearest of all hits along a ray. Only this hit is visible.
    pub fn visible_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        self.first_hits_on_objects(ray).min_by(|a, b| a.t.total_cmp(&b.t))
    }

    /// The intensity of the light from an object at a hit, whether or not the hit is visible.
    pub fn colour_at_hit(&self, ray: &Ray, hit: ObjectHit) -> DVec3 {
        match self.step < Step::Diffuse {
            true => self.own_scene.scene.objects[hit.object].material.matte.diffuse,
            false => self.terms_at_hit(ray, hit).sum(),
        }
    }

    /// The terms at a hit, whether or not the hit is visible. The diffuse term and the specular
    /// term are sums over all lights.
    pub fn terms_at_hit(&self, ray: &Ray, hit: ObjectHit) -> Terms {
        let ambient = self.ambient_at_hit(hit);
        let mut terms = Terms { ambient, ..Terms::default() };
        for light in &self.own_scene.scene.lights {
            terms += self.light_terms_at_hit(ray, hit, light);
        }
        terms
    }

    /// The ambient term I_a at a hit.
    pub fn ambient_at_hit(&self, hit: ObjectHit) -> DVec3 {
        let scene = &self.own_scene.scene;
        ambient(&scene.objects[hit.object].material.matte, scene.ambient_light)
    }

    /// One light's terms at a hit, whether or not the hit is visible. Before step 5, the specular
    /// term is zero.
    pub fn light_terms_at_hit(&self, ray: &Ray, hit: ObjectHit, light: &Light) -> Terms {
        let object = &self.own_scene.scene.objects[hit.object];
        let p = ray.at(hit.t);
        let v = -ray.direction.normalize();
        let terms = light_terms(p, normal(&object.sphere, p), v, &object.material, light);
        match self.step {
            Step::Phong => terms,
            _ => Terms { specular: DVec3::ZERO, ..terms },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scene_of_a_step_has_the_objects_of_that_step() {
        let counts = Step::ALL.map(|step| StepScene::of_step(step).own_scene.scene.objects.len());
        assert_eq!(counts, [0, 1, 9, 9, 9]);
        let sphere = StepScene::of_step(Step::Sphere);
        assert_eq!(sphere.own_scene.scene.objects[0].sphere, step02_sphere::SPHERE);
    }
}
