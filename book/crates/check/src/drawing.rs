use course::{Step, named_scene};
use glam::DVec3;
use step01_rays::rgb8;
use step05_phong::{
    Light, Material, Phong, Ray, SurfacePoint, ambient, diffuse, direction_colour, normal, phong,
    reflect, visible_point,
};

/// A scene of step 5. The steps before it have less of the same numbers.
pub(crate) type Scene = step05_phong::Scene<Material, Light>;

/// A scene, and the functions of a step that draw it.
pub(crate) struct Drawing {
    pub step: Step,
    pub scene: Scene,
    /// Names of the lights, in their order.
    pub light_names: [&'static str; 2],
}

/// The first place where a ray meets an object.
#[derive(Clone, Copy)]
pub(crate) struct ObjectHit {
    pub t: f64,
    /// The number of the object.
    pub object: usize,
}

impl Drawing {
    /// The drawing of a step: its scene has only the objects that the step has.
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
        Self { step, scene, light_names: ["the warm light", "the cool light"] }
    }

    /// The drawing of the scene that belongs to a name.
    pub fn of_name(name: &str) -> Self {
        let scene = named_scene(name);
        Self { step: Step::Phong, scene, light_names: ["the first light", "the second light"] }
    }

    /// The name of an object, with its article where it needs one.
    pub fn object_name(&self, object: usize) -> String {
        let name = self.scene.objects[object].name;
        if name.ends_with(|c: char| c.is_numeric()) { name.into() } else { format!("the {name}") }
    }

    /// The intensity that a ray gets.
    pub fn colour(&self, ray: &Ray) -> DVec3 {
        colour(self.step, &self.scene, ray)
    }

    /// The bytes that a ray gets.
    pub fn bytes(&self, ray: &Ray) -> [u8; 3] {
        bytes(self.colour(ray))
    }

    /// The first place on each object that a ray meets, whatever hides it there.
    pub fn object_hits(&self, ray: &Ray) -> impl Iterator<Item = ObjectHit> {
        self.scene.objects.iter().enumerate().filter_map(|(object, one)| {
            let t = one.sphere.intersect(ray).first_hit()?;
            Some(ObjectHit { t, object })
        })
    }

    /// The hit that a ray sees.
    pub fn visible_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        self.object_hits(ray).min_by(|a, b| a.t.total_cmp(&b.t))
    }

    /// Whether each light is on the outer side at a hit, and whether a highlight of one, large
    /// or small, reaches there.
    pub fn lights_at_hit(&self, ray: &Ray, hit: ObjectHit) -> ([bool; 2], bool) {
        let p = ray.at(hit.t);
        let n = normal(&self.scene.objects[hit.object].sphere, p);
        let (mut lit, mut in_highlight) = ([false; 2], false);
        for (light, lit) in self.scene.lights.iter().zip(&mut lit) {
            let (l, _) = light.point_light.direction_from(p);
            *lit = 0.0 < n.dot(l);
            in_highlight |= *lit && reflect(n, l).dot(ray.direction) < 0.0;
        }
        (lit, in_highlight)
    }

    /// The terms of the light at a hit, whatever hides it there; those of one light alone, or
    /// of all.
    pub fn terms_at_hit(&self, ray: &Ray, hit: ObjectHit, light: Option<usize>) -> Phong {
        let object = &self.scene.objects[hit.object];
        let p = ray.at(hit.t);
        let point = SurfacePoint { p, n: normal(&object.sphere, p), material: &object.material };
        let lights = match light {
            Some(k) => &self.scene.lights[k..=k],
            None => &self.scene.lights,
        };
        let terms = phong(&point, ray, self.scene.ambient_light, lights);
        match self.step {
            Step::Phong => terms,
            _ => Phong { specular: DVec3::ZERO, ..terms },
        }
    }

    /// The bytes that an object has at a hit, whatever hides it there.
    pub fn bytes_at_hit(&self, ray: &Ray, hit: ObjectHit) -> [u8; 3] {
        let flat = self.scene.objects[hit.object].material.matte.diffuse;
        let is_lit = Step::Diffuse <= self.step;
        bytes(if is_lit { self.terms_at_hit(ray, hit, None).sum() } else { flat })
    }
}

/// The intensity that a ray gets of a scene, by the functions of a step.
pub(crate) fn colour(step: Step, scene: &Scene, ray: &Ray) -> DVec3 {
    if step == Step::Phong {
        return step05_phong::colour(scene, ray);
    }
    let Some(point) = visible_point(&scene.objects, ray) else { return direction_colour(ray) };
    let matte = &point.material.matte;
    if step < Step::Diffuse {
        return matte.diffuse;
    }
    let mut intensity = ambient(matte, scene.ambient_light);
    for Light { point_light, .. } in &scene.lights {
        let (l, d) = point_light.direction_from(point.p);
        intensity += diffuse(point.n, l, d, matte, point_light);
    }
    intensity
}

/// The bytes of an intensity, as the course encodes it.
pub(crate) fn bytes(intensity: DVec3) -> [u8; 3] {
    rgb8(intensity).0
}
