use crate::Step;
use glam::DVec3;
use step01_rays::rgb8;
use step05_phong::{Light, Material, OBJECTS, Ray};

/// A scene of step 5. The steps before it have less of the same numbers.
pub(crate) type Scene = step05_phong::Scene<Material, Light>;

/// How many objects there are.
pub(crate) const COUNT: usize = OBJECTS.len();

/// What the lights are called, in their order.
pub(crate) const LIGHTS: [&str; 2] = ["the warm light", "the cool light"];

/// What object `k` of a step is called.
pub(crate) fn object(step: Step, k: usize) -> String {
    let name = if step == Step::Sphere { "sphere" } else { OBJECTS[k].name };
    format!("the {name}")
}

/// The scene of a step, without the objects that it has not got.
pub(crate) fn scene(step: Step) -> Scene {
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

/// The colour that a ray gets of a scene, by the functions of a step.
pub(crate) fn colour<'a>(
    step: Step,
    scene: &'a Scene,
) -> Box<dyn Fn(&Ray) -> DVec3 + 'a> {
    match step {
        Step::Rays => Box::new(step01_rays::direction_colour),
        Step::Sphere => {
            let sphere = scene.objects[0].sphere;
            Box::new(move |ray| step02_sphere::colour(&sphere, ray))
        }
        Step::Nearest => {
            let flat = scene
                .objects
                .iter()
                .map(|object| object.with_material(object.material.matte.diffuse));
            let flat: Vec<_> = flat.collect();
            Box::new(move |ray| step03_nearest::colour(&flat, ray))
        }
        Step::Diffuse => {
            let matte = scene
                .objects
                .iter()
                .map(|object| object.with_material(object.material.matte));
            let matte = step04_diffuse::Scene {
                objects: matte.collect(),
                ambient_light: scene.ambient_light,
                lights: scene.lights.iter().map(|one| one.point_light).collect(),
            };
            Box::new(move |ray| step04_diffuse::colour(&matte, ray))
        }
        Step::Phong => Box::new(|ray| step05_phong::colour(scene, ray)),
    }
}

/// The pixel that a ray gets of a scene, by the functions of a step.
pub(crate) fn pixel<'a>(
    step: Step,
    scene: &'a Scene,
) -> impl Fn(&Ray) -> [u8; 3] + 'a {
    let colour = colour(step, scene);
    move |ray| rgb8(colour(ray)).0
}
