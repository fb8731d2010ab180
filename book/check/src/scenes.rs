use crate::Step;
use glam::DVec3;
use step01_rays::rgb8;
use step05_phong::{
    Light, Material, Object, PointLight, Ray, Scene, Sphere, Surface,
};

/// What the objects of the course are called, in their order.
pub(crate) const OBJECTS: [&str; 9] = [
    "the red sphere",
    "the ground",
    "the golden sphere",
    "the blue sphere",
    "the green sphere",
    "the teal sphere",
    "the white sphere",
    "the salmon sphere",
    "the cream sphere",
];

/// What the lights are called, in their order.
pub(crate) const LIGHTS: [&str; 2] = ["the warm light", "the cool light"];

/// The scenes of the steps, with the same numbers in them.
#[derive(Clone)]
pub(crate) struct Scenes {
    /// That of step 2.
    pub sphere: Sphere,
    /// That of step 3.
    pub flat: Vec<Object<DVec3>>,
    /// That of step 4.
    pub matt: Scene<Surface, PointLight>,
    /// That of step 5.
    pub shiny: Scene<Material, Light>,
}

impl Scenes {
    /// Those of the course.
    pub fn right() -> Self {
        Self {
            sphere: step02_sphere::SPHERE,
            flat: step03_nearest::OBJECTS.into(),
            matt: step04_diffuse::scene(),
            shiny: step05_phong::scene(),
        }
    }

    /// The pixel that a ray gives.
    pub fn pixel(&self, step: Step, ray: &Ray) -> [u8; 3] {
        let colour = match step {
            Step::Rays => step01_rays::direction_colour(ray),
            Step::Sphere => step02_sphere::colour(&self.sphere, ray),
            Step::Nearest => step03_nearest::colour(&self.flat, ray),
            Step::Diffuse => step04_diffuse::colour(&self.matt, ray),
            Step::Phong => step05_phong::colour(&self.shiny, ray),
        };
        rgb8(colour).0
    }

    /// The spheres of a step.
    pub fn spheres(&self, step: Step) -> Vec<Sphere> {
        match step {
            Step::Rays => vec![],
            Step::Sphere => vec![self.sphere],
            _ => self.flat.iter().map(|object| object.sphere).collect(),
        }
    }

    /// Changes a sphere, in each scene.
    pub fn set_sphere(
        &mut self,
        step: Step,
        k: usize,
        change: impl Fn(&mut Sphere),
    ) {
        if step == Step::Sphere {
            return change(&mut self.sphere);
        }
        change(&mut self.flat[k].sphere);
        change(&mut self.matt.objects[k].sphere);
        change(&mut self.shiny.objects[k].sphere);
    }

    /// Changes the colour of an object, in each scene.
    pub fn set_colour(&mut self, k: usize, colour: DVec3) {
        self.flat[k].material = colour;
        self.matt.objects[k].material = Surface::of(colour);
        self.shiny.objects[k].material.surface = Surface::of(colour);
    }

    /// Changes the ambient light, in each scene.
    pub fn set_ambient(&mut self, light: DVec3) {
        self.matt.ambient_light = light;
        self.shiny.ambient_light = light;
    }

    /// Changes a light, in each scene.
    pub fn set_light(&mut self, k: usize, change: impl Fn(&mut PointLight)) {
        change(&mut self.matt.lights[k]);
        change(&mut self.shiny.lights[k].point_light);
    }
}
