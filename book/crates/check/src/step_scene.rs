use course::Step;
use glam::DVec3;
use step01_rays::rgb8;
use step05_phong::{Light, Material, OBJECTS, Ray};

/// A scene of step 5. The steps before it have less of the same numbers.
pub(crate) type Scene = step05_phong::Scene<Material, Light>;

/// Function that turns an intensity into bytes.
pub(crate) type Encode = fn(DVec3) -> [u8; 3];

/// The encoding of the course.
pub(crate) const ENCODE: Encode = |intensity| rgb8(intensity).0;

/// How many objects there are.
pub(crate) const OBJECT_COUNT: usize = OBJECTS.len();

/// Names of the lights, in their order.
pub(crate) const LIGHTS: [&str; 2] = ["the warm light", "the cool light"];

/// The name of object `k` of a step, with its article.
pub(crate) fn object_name_with_article(step: Step, object_index: usize) -> String {
    let name = if step == Step::Sphere { "sphere" } else { OBJECTS[object_index].name };
    format!("the {name}")
}

/// The scene of a step, without the objects that it has not got.
pub(crate) fn scene_of_step(step: Step) -> Scene {
    let mut scene = step05_phong::scene();
    match step {
        Step::Rays => scene.objects.clear(),
        Step::Sphere => {
            scene.objects.truncate(1);
            scene.objects[0].sphere = step02_sphere::SPHERE;
        }
        _ => {}
    }
    scene
}

/// The intensity that a ray gets of a scene, by the functions of a step.
pub(crate) fn intensity_function(step: Step, scene: &Scene) -> Box<dyn Fn(&Ray) -> DVec3> {
    match step {
        Step::Rays => Box::new(step01_rays::direction_colour),
        Step::Sphere => match scene.objects.first().map(|object| object.sphere) {
            Some(sphere) => Box::new(move |ray| step02_sphere::colour(&sphere, ray)),
            None => Box::new(step01_rays::direction_colour),
        },
        Step::Nearest => {
            let flat = scene
                .objects
                .iter()
                .map(|object| object.with_material(object.material.matte.diffuse));
            let flat: Vec<_> = flat.collect();
            Box::new(move |ray| step03_nearest::colour(&flat, ray))
        }
        Step::Diffuse => {
            let matte =
                scene.objects.iter().map(|object| object.with_material(object.material.matte));
            let matte = step04_diffuse::Scene {
                objects: matte.collect(),
                ambient_light: scene.ambient_light,
                lights: scene.lights.iter().map(|one| one.point_light).collect(),
            };
            Box::new(move |ray| step04_diffuse::colour(&matte, ray))
        }
        Step::Phong => {
            let scene = scene.clone();
            Box::new(move |ray| step05_phong::colour(&scene, ray))
        }
    }
}

/// The t and the number of each object that a ray meets, the nearest first.
pub(crate) fn hits_nearest_first(scene: &Scene, ray: &Ray) -> Vec<(f64, usize)> {
    let hit = |k: usize| Some((scene.objects[k].sphere.intersect(ray).first_hit()?, k));
    let mut hits: Vec<_> = (0..scene.objects.len()).filter_map(hit).collect();
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    hits
}
