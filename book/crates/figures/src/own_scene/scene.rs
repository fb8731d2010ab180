use super::parameters::ambient_light;
use super::parameters::{PARAMETERS, split_parameters};
use crate::parameter::array;
use course::examples::mirror::Mirror;
use course::without_mirrors;
use glam::DVec3;
use std::iter::zip;
use step05_phong::{Attenuation, Light, Material, Matte, Object, PointLight, Scene, Sphere};

/// The reader's own scene of these values, as step 5 has it.
pub fn own_scene(values: &[f64]) -> Scene<Material, Light> {
    without_mirrors(mirror_scene(values))
}

/// The same scene, each object with its k.
pub fn mirror_scene(values: &[f64]) -> Scene<Mirror, Light> {
    let (_, spheres, lights) = split_parameters(values);
    let (_, sphere_parameters, _) = split_parameters(&PARAMETERS);
    let names = sphere_parameters.map(|parameters| parameters[0].group);
    Scene {
        objects: zip(names, spheres).filter_map(|(name, values)| object(name, values)).collect(),
        ambient_light: ambient_light(values),
        lights: lights.filter_map(light).collect(),
    }
}

/// A sphere with its material; None if it is switched off.
fn object(name: &'static str, values: &[f64]) -> Option<Object<Mirror>> {
    let [is_there, x, y, z, radius, r_s, n, red, green, blue, k] = array(values);
    let sphere = Sphere { centre: DVec3::new(x, y, z), radius };
    let matte = Matte::of(DVec3::new(red, green, blue));
    let (specular, shininess) = (DVec3::splat(r_s), n as i32);
    let material = Mirror { material: Material { matte, specular, shininess }, k };
    (is_there == 1.0).then_some(Object { name, sphere, material })
}

/// A light; None if it is switched off.
fn light(values: &[f64]) -> Option<Light> {
    let [is_on, x, y, z, red, green, blue, r_s, g_s, b_s, a, b, c] = array(values);
    let point_light = PointLight {
        position: DVec3::new(x, y, z),
        diffuse: DVec3::new(red, green, blue),
        attenuation: Attenuation { a, b, c },
    };
    let specular = DVec3::new(r_s, g_s, b_s);
    (is_on == 1.0).then_some(Light { point_light, specular })
}
