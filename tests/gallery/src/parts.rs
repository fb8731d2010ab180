use crate::Step;
use glam::DVec3;
use image::{Rgb, RgbImage};
use step01_rays::{Camera, Ray, direction_colour};
use step02_sphere::{SPHERE, Sphere};
use step03_nearest::{COLOURS, Hit, SPHERES};
use step04_diffuse::{
    AMBIENT_LIGHT, Attenuation, PointLight, ambient, diffuse, normal,
};
use step05_phong::{LIGHTS, Light, MATERIALS, Material, Phong, reflect, specular};

/// The smallest t above 0 at which a ray meets a sphere.
pub type FirstHit = fn(&Sphere, &Ray) -> Option<f64>;

/// What the five steps are made of; a mistake replaces one part by a wrong one.
#[derive(Clone, Copy)]
pub struct Parts {
    /// C and the matrix.
    pub camera: Camera,
    /// What becomes of a ray before it is cast.
    pub ray: fn(Ray) -> Ray,
    /// The colour of a ray that meets nothing.
    pub miss: fn(&Ray) -> DVec3,
    /// The first hit with one sphere.
    pub first_hit: FirstHit,
    /// The nearest hit with many.
    pub nearest: fn(&[Sphere], &Ray, FirstHit) -> Option<Hit>,
    /// n.
    pub normal: fn(&Sphere, DVec3) -> DVec3,
    /// l and d.
    pub seen_from: fn(&PointLight, DVec3) -> (DVec3, f64),
    /// a + bd + cd².
    pub attenuation: fn(&Attenuation, f64) -> f64,
    /// R_a and L_a in I_a.
    pub ambient: fn(DVec3, DVec3) -> DVec3,
    /// I_d of one light.
    pub diffuse: fn(DVec3, DVec3, f64, DVec3, &PointLight) -> DVec3,
    /// v.
    pub to_eye: fn(&Ray) -> DVec3,
    /// Whether a light with these n and l can give a highlight.
    pub lit: fn(DVec3, DVec3) -> bool,
    /// r from l and n.
    pub reflect: fn(DVec3, DVec3) -> DVec3,
    /// I_s of one light.
    pub specular: fn(DVec3, DVec3, f64, &Material, &Light) -> DVec3,
    /// The lights that count.
    pub lights: &'static [Light],
    /// The sum of the terms.
    pub sum: fn(&Phong) -> DVec3,
    /// The byte of an intensity.
    pub byte: fn(f64) -> u8,
    /// The order of the three bytes.
    pub order: fn([u8; 3]) -> [u8; 3],
}

impl Parts {
    /// The right ones.
    pub fn right(camera: &Camera) -> Self {
        Self {
            camera: *camera,
            ray: |ray| ray,
            miss: direction_colour,
            first_hit: |sphere, ray| sphere.intersect(ray).first_hit(),
            nearest: |spheres, ray, first_hit| {
                hits(spheres, ray, first_hit).min_by(|a, b| a.t.total_cmp(&b.t))
            },
            normal,
            seen_from: PointLight::seen_from,
            attenuation: Attenuation::at,
            ambient,
            diffuse,
            to_eye: |ray| -ray.direction.normalize(),
            lit: |n, l| 0.0 < n.dot(l),
            reflect,
            specular,
            lights: &LIGHTS,
            sum: Phong::sum,
            byte: |intensity| (255.0 * intensity.clamp(0.0, 1.0) + 0.5) as u8,
            order: |rgb| rgb,
        }
    }

    /// The picture that these parts draw in `step`.
    pub fn picture(&self, step: Step, samples: u32) -> RgbImage {
        RgbImage::from_par_fn(self.camera.h_res, self.camera.v_res, |i, j| {
            self.pixel(step, samples, i, j)
        })
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
        let seen = match step {
            Step::Rays => None,
            Step::Sphere => (self.first_hit)(&SPHERE, ray).map(|_| COLOURS[0]),
            _ => (self.nearest)(&SPHERES, ray, self.first_hit).map(|hit| {
                if step == Step::Nearest {
                    return COLOURS[hit.index];
                }
                (self.sum)(&self.terms(step, ray, hit))
            }),
        };
        seen.unwrap_or_else(|| (self.miss)(ray))
    }

    /// The terms of the light at `hit`; in step 4 the specular one is 0.
    fn terms(&self, step: Step, ray: &Ray, hit: Hit) -> Phong {
        let p = ray.at(hit.t);
        let n = (self.normal)(&SPHERES[hit.index], p);
        let v = (self.to_eye)(ray);
        let material = &MATERIALS[hit.index];
        let mut sum = Phong {
            ambient: (self.ambient)(material.surface.ambient, AMBIENT_LIGHT),
            diffuse: DVec3::ZERO,
            specular: DVec3::ZERO,
        };
        for light in self.lights {
            let (l, d) = (self.seen_from)(&light.point, p);
            // The divisor, whatever it is, as a light's own: `diffuse` divides by it.
            let a = (self.attenuation)(&light.point.attenuation, d);
            let attenuation = Attenuation { a, b: 0.0, c: 0.0 };
            let point = PointLight { attenuation, ..light.point };
            sum.diffuse +=
                (self.diffuse)(n, l, d, material.surface.diffuse, &point);
            if step == Step::Phong && (self.lit)(n, l) {
                let (r, light) = ((self.reflect)(l, n), Light { point, ..*light });
                sum.specular += (self.specular)(r, v, d, material, &light);
            }
        }
        sum
    }
}

/// The first hit with every sphere that `ray` meets, in the order of the list.
pub fn hits<'a>(
    spheres: &'a [Sphere],
    ray: &'a Ray,
    first_hit: FirstHit,
) -> impl Iterator<Item = Hit> {
    spheres.iter().enumerate().filter_map(move |(index, sphere)| {
        Some(Hit { t: first_hit(sphere, ray)?, index })
    })
}
