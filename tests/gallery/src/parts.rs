use crate::{Named, Step, scene::scene};
use glam::DVec3;
use image::{Rgb, RgbImage};
use std::slice;
use step01_rays::{Camera, Ray, direction_colour};
use step02_sphere::{Roots, SPHERE, Sphere, quadratic};
use step03_nearest::{Hit, Object};
use step04_diffuse::{
    Attenuation, PointLight, Scene, Surface, SurfacePoint, ambient, diffuse, normal,
};
use step05_phong::{Light, Material, Phong, reflect, specular};

/// What the five steps are made of; a mistake replaces one part by a wrong one.
#[derive(Clone)]
pub struct Parts {
    /// C and the matrix.
    pub camera: Camera,
    /// The one object of step 2.
    pub sphere: Object<Named>,
    /// The objects of the later steps, and the lights that count.
    pub scene: Scene<Named, Light>,
    /// What becomes of a ray before it is cast.
    pub ray: fn(Ray) -> Ray,
    /// The colour of a ray that meets nothing.
    pub miss: fn(&Ray) -> DVec3,
    /// a, b and c.
    pub coefficients: fn(&Sphere, &Ray) -> (f64, f64, f64),
    /// The roots from a, b and c.
    pub quadratic: fn(f64, f64, f64) -> Roots,
    /// The first hit of them.
    pub first_hit: fn(Roots) -> Option<f64>,
    /// The nearest hit of those with each sphere, which come in the list's order.
    pub nearest: Nearest,
    /// p, from the ray and its t.
    pub point: fn(&Ray, f64) -> DVec3,
    /// n.
    pub normal: fn(&Sphere, DVec3) -> DVec3,
    /// l and d.
    pub seen_from: fn(&PointLight, DVec3) -> (DVec3, f64),
    /// a + bd + cd².
    pub attenuation: fn(&Attenuation, f64) -> f64,
    /// I_d of one light, from n, l and d.
    pub diffuse: fn(DVec3, DVec3, f64, &Surface, &PointLight) -> DVec3,
    /// v.
    pub to_eye: fn(&Ray) -> DVec3,
    /// Whether a light with these n and l can give a highlight.
    pub lit: fn(DVec3, DVec3) -> bool,
    /// r from l and n.
    pub reflect: fn(DVec3, DVec3) -> DVec3,
    /// I_s of one light, from r, v and d.
    pub specular: fn(DVec3, DVec3, f64, &Material, &Light) -> DVec3,
    /// The byte of an intensity.
    pub byte: fn(f64) -> u8,
    /// The order of the three bytes.
    pub order: fn([u8; 3]) -> [u8; 3],
}

/// Chooses one hit of many.
pub type Nearest =
    for<'a> fn(&mut dyn Iterator<Item = Hit<'a, Named>>) -> Option<Hit<'a, Named>>;

impl Parts {
    /// The right ones.
    pub fn right(camera: &Camera) -> Self {
        let scene = scene();
        let material = Named { name: "the sphere", ..scene.objects[0].material };
        Self {
            camera: *camera,
            sphere: Object { sphere: SPHERE, material },
            scene,
            ray: |ray| ray,
            miss: direction_colour,
            coefficients: Sphere::coefficients,
            quadratic,
            first_hit: Roots::first_hit,
            nearest: |hits| hits.min_by(|a, b| a.t.total_cmp(&b.t)),
            point: Ray::at,
            normal,
            seen_from: PointLight::direction_from,
            attenuation: Attenuation::at,
            diffuse,
            to_eye: |ray| -ray.direction.normalize(),
            lit: |n, l| 0.0 < n.dot(l),
            reflect,
            specular,
            byte: |intensity| (255.0 * intensity.clamp(0.0, 1.0) + 0.5) as u8,
            order: |rgb| rgb,
        }
    }

    /// The materials of the scene, to be changed.
    pub fn materials(&mut self) -> impl Iterator<Item = &mut Material> {
        let objects = self.scene.objects.iter_mut();
        objects.map(|object| &mut object.material.material)
    }

    /// The picture that these parts draw in `step`.
    pub fn picture(&self, step: Step, samples: u32) -> RgbImage {
        let pixel = |i, j| self.pixel(step, samples, i, j);
        let Camera { h_res, v_res, .. } = self.camera;
        RgbImage::from_fn(h_res, v_res, pixel)
    }

    /// One pixel of that picture: the mean of the rays through it, as `render` takes it.
    pub fn pixel(&self, step: Step, samples: u32, i: u32, j: u32) -> Rgb<u8> {
        let side = f64::from(samples);
        let place =
            |at: u32, k: u32| f64::from(at) + ((f64::from(k) + 0.5) / side - 0.5);
        let mut sum = DVec3::ZERO;
        for v in 0..samples {
            for u in 0..samples {
                let ray = self.camera.ray(place(i, u), place(j, v));
                sum += self.colour(step, &(self.ray)(ray));
            }
        }
        let mean = sum * (1.0 / (side * side));
        Rgb((self.order)(mean.to_array().map(self.byte)))
    }

    fn colour(&self, step: Step, ray: &Ray) -> DVec3 {
        match self.seen(step, ray) {
            None => (self.miss)(ray),
            Some(point) if step <= Step::Nearest => {
                point.material.material.surface.diffuse
            }
            Some(point) => self.terms(step, ray, &point).sum(),
        }
    }

    /// The objects that there are in `step`.
    pub fn objects(&self, step: Step) -> &[Object<Named>] {
        match step {
            Step::Rays => &[],
            Step::Sphere => slice::from_ref(&self.sphere),
            _ => &self.scene.objects,
        }
    }

    /// The point that `ray` sees of them.
    pub fn seen(&self, step: Step, ray: &Ray) -> Option<SurfacePoint<'_, Named>> {
        let mut hits = self.objects(step).iter().filter_map(|object| {
            let (a, b, c) = (self.coefficients)(&object.sphere, ray);
            let t = (self.first_hit)((self.quadratic)(a, b, c))?;
            Some(Hit { t, object })
        });
        let hit = (self.nearest)(&mut hits)?;
        let p = (self.point)(ray, hit.t);
        let n = (self.normal)(&hit.object.sphere, p);
        Some(SurfacePoint { p, n, material: &hit.object.material })
    }

    /// The terms of the light at `point`; in step 4 the specular one is 0.
    fn terms(&self, step: Step, ray: &Ray, point: &SurfacePoint<Named>) -> Phong {
        let SurfacePoint { p, n, material: Named { material, .. } } = point;
        let (n, v) = (*n, (self.to_eye)(ray));
        let mut sum = Phong {
            ambient: ambient(&material.surface, self.scene.ambient_light),
            diffuse: DVec3::ZERO,
            specular: DVec3::ZERO,
        };
        for light in &self.scene.lights {
            let (l, d) = (self.seen_from)(&light.point_light, *p);
            // The divisor, whatever it is, as a light's own: `diffuse` divides by it.
            let a = (self.attenuation)(&light.point_light.attenuation, d);
            let attenuation = Attenuation { a, b: 0.0, c: 0.0 };
            let point_light = PointLight { attenuation, ..light.point_light };
            sum.diffuse += (self.diffuse)(n, l, d, &material.surface, &point_light);
            if step == Step::Phong && (self.lit)(n, l) {
                let (r, light) =
                    ((self.reflect)(l, n), Light { point_light, ..*light });
                sum.specular += (self.specular)(r, v, d, material, &light);
            }
        }
        sum
    }
}
