//! A scene of your own. This draws it:
//! `cargo run -p step05_phong --example own_scene`

use glam::DVec3;
use image::RgbImage;
use step05_phong::{
    Attenuation, Camera, Light, Material, Matte, Object, PointLight, Scene, Sphere,
    draw_and_save, render,
};

/// A ball of one colour that mirrors `r_s` of the light; `n` is its shininess.
#[allow(dead_code, reason = "there may be no ball")]
pub fn ball(
    name: &'static str,
    centre: [f64; 3],
    radius: f64,
    colour: [f64; 3],
    r_s: f64,
    n: i32,
) -> Object<Material> {
    let (matte, specular) = (Matte::of(colour.into()), DVec3::splat(r_s));
    let material = Material { matte, specular, shininess: n };
    Object { name, sphere: Sphere::new(centre, radius), material }
}

/// A lamp: its position, L_d, L_s, and a, b and c of its attenuation.
#[allow(dead_code, reason = "there may be no lamp")]
pub fn lamp(
    position: [f64; 3],
    diffuse: [f64; 3],
    specular: [f64; 3],
    [a, b, c]: [f64; 3],
) -> Light {
    let (position, diffuse) = (position.into(), diffuse.into());
    let attenuation = Attenuation { a, b, c };
    let point_light = PointLight { position, diffuse, attenuation };
    Light { point_light, specular: specular.into() }
}

/// The scene: what there is to see, and the light to see it in.
#[rustfmt::skip]
pub fn my_scene() -> Scene<Material, Light> {
    Scene {
        objects: vec![
            ball("red sphere", [-0.65, -0.16, -7.4], 1.2, [0.91, 0.34, 0.28], 0.7, 40),
            ball("ground", [0.0, -41.2, -11.0], 40.0, [0.8, 0.76, 0.82], 0.15, 10),
            ball("golden sphere", [0.45, -1.12, -5.8], 0.42, [0.99, 0.76, 0.32], 0.8, 150),
            ball("blue sphere", [-3.0, -0.02, -10.2], 1.3, [0.44, 0.47, 0.78], 0.4, 30),
            ball("green sphere", [0.3, 0.4, 4.0], 1.2, [0.0, 1.0, 0.0], 0.5, 30),
            ball("teal sphere", [3.3, -0.69, -6.4], 0.9, [0.16, 0.6, 0.6], 0.6, 16),
            ball("white sphere", [-2.05, -1.05, -6.1], 0.5, [0.97, 0.94, 0.9], 0.9, 300),
            ball("salmon sphere", [1.55, 0.42, -10.8], 1.65, [0.96, 0.66, 0.56], 0.5, 40),
            ball("cream sphere", [-2.1, 2.3, -9.5], 0.34, [0.99, 0.87, 0.62], 0.4, 20),
        ],
        ambient_light: DVec3::new(0.32, 0.32, 0.42),
        lights: vec![
            lamp(
                [-4.0, 5.0, -2.0],
                [1.0, 0.84, 0.64],
                [1.0, 0.9, 0.8],
                [0.7, 0.02, 0.005],
            ),
            lamp(
                [5.5, 2.2, -11.5],
                [0.45, 0.6, 1.0],
                [0.5, 0.7, 1.0],
                [0.5, 0.0, 0.02],
            ),
        ],
    }
}

/// The camera, with the columns and rows of `camera`.
pub fn my_camera(camera: &Camera) -> Camera {
    *camera
}

/// The picture: your scene in the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    use step05_phong::colour;
    let (camera, scene) = (my_camera(camera), my_scene());
    render(&camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    draw_and_save(env!("CARGO_CRATE_NAME"), picture);
}
