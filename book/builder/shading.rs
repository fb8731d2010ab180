//! The worked examples of steps 4 and 5: what the steps' own functions make of one
//! pixel.

use crate::worked::camera;
use glam::DVec3;
use step05_phong::{
    Hit, LIGHTS, MATERIALS, Material, Phong, Ray, SPHERES, Sphere, diffuse,
    nearest, normal, phong, picture, reflect, specular,
};

/// The pixel of both worked examples: its column i and its row j.
const PIXEL: (u32, u32) = (470, 120);

/// All that goes into the colour of a pixel.
#[derive(Debug)]
pub struct Shaded {
    /// The ray through the pixel.
    pub ray: Ray,
    /// Where it meets the nearest sphere.
    pub hit: Hit,
    /// That sphere.
    pub sphere: Sphere,
    /// What the sphere is made of.
    pub material: Material,
    /// The point it sees.
    pub p: DVec3,
    /// The unit normal there.
    pub n: DVec3,
    /// The unit vector to the eye.
    pub v: DVec3,
    /// The three terms.
    pub terms: Phong,
    /// The warm light, then the cool one.
    pub lights: [Lit; 2],
}

/// What one light does to a point.
#[derive(Debug)]
pub struct Lit {
    /// The unit vector to the light.
    pub l: DVec3,
    /// How far away it is.
    pub d: f64,
    /// a + bd + cd².
    pub divisor: f64,
    /// n·l.
    pub n_dot_l: f64,
    /// I_d of this light alone.
    pub diffuse: DVec3,
    /// The reflection of l.
    pub r: DVec3,
    /// r·v.
    pub r_dot_v: f64,
    /// I_s of this light alone, whether or not it faces the surface.
    pub specular: DVec3,
}

/// The pixel of the worked examples.
pub fn example() -> Shaded {
    at(PIXEL.0, PIXEL.1)
}

/// The pixel in column `i` and row `j`, which has to see a sphere.
pub fn at(i: u32, j: u32) -> Shaded {
    shaded(&camera().ray(i.into(), j.into())).expect("the pixel sees a sphere")
}

fn shaded(ray: &Ray) -> Option<Shaded> {
    let hit = nearest(&SPHERES, ray)?;
    let (sphere, material) = (SPHERES[hit.index], MATERIALS[hit.index]);
    let p = ray.at(hit.t);
    let n = normal(&sphere, p);
    let v = -ray.direction.normalize();
    let lights = LIGHTS.map(|light| {
        let (l, d) = light.point.seen_from(p);
        let r = reflect(l, n);
        Lit {
            l,
            d,
            divisor: light.point.attenuation.at(d),
            n_dot_l: n.dot(l),
            diffuse: diffuse(n, l, d, material.surface.diffuse, &light.point),
            r,
            r_dot_v: r.dot(v),
            specular: specular(r, v, d, &material, &light),
        }
    });
    let terms = phong(p, n, v, &material, step05_phong::AMBIENT_LIGHT, &LIGHTS);
    Some(Shaded { ray: *ray, hit, sphere, material, p, n, v, terms, lights })
}

/// The 8-bit colour of the example's pixel in the picture of step 4.
pub fn pixel_of_step_4() -> [u8; 3] {
    step04_diffuse::picture(&camera(), 1).get_pixel(PIXEL.0, PIXEL.1).0
}

/// The 8-bit colour of the example's pixel in the picture of step 5.
pub fn pixel_of_step_5() -> [u8; 3] {
    picture(&camera(), 1).get_pixel(PIXEL.0, PIXEL.1).0
}

/// The angle in degrees at which cosⁿ is 1/2.
pub fn half_width(n: f64) -> f64 {
    0.5_f64.powf(1.0 / n).acos().to_degrees()
}
