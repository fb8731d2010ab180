//! A scene as a Rust program, which the reader saves as an example of step 5.

use glam::DVec3;
use step05_phong::{Attenuation, Light, Material, Object, Scene};

/// The program that draws the scene, with a camera of this field of view.
pub fn program(scene: &Scene<Material, Light>, degrees: f64) -> String {
    let options = match degrees {
        60.0 => String::new(),
        degrees => format!(" -- --fov {degrees}"),
    };
    let ball_attribute = dead_code_attribute(scene.objects.is_empty());
    let lamp_attribute = dead_code_attribute(scene.lights.is_empty());
    let objects = lines(scene.objects.iter().map(ball_call));
    let lights = lines(scene.lights.iter().map(lamp_call));
    let DVec3 { x: red, y: green, z: blue } = scene.ambient_light;
    format!(
        r#"//! A scene of your own. This draws it:
//! `cargo run -p step05_phong --example my_scene{options}`

use glam::DVec3;
use image::RgbImage;
use step05_phong::{{
    Attenuation, Camera, Light, Material, Matte, Object, PointLight, Scene, Sphere,
    colour, render, run,
}};

/// A ball of one colour that mirrors `r_s` of the light; `n` is its shininess.
{ball_attribute}fn ball(
    name: &'static str,
    centre: [f64; 3],
    radius: f64,
    colour: [f64; 3],
    r_s: f64,
    n: i32,
) -> Object<Material> {{
    let (matte, specular) = (Matte::of(colour.into()), DVec3::splat(r_s));
    let material = Material {{ matte, specular, shininess: n }};
    Object {{ name, sphere: Sphere {{ centre: centre.into(), radius }}, material }}
}}

/// A lamp: where it is, L_d, L_s, and a, b and c.
{lamp_attribute}fn lamp(
    position: [f64; 3],
    diffuse: [f64; 3],
    specular: [f64; 3],
    [a, b, c]: [f64; 3],
) -> Light {{
    let (position, diffuse) = (position.into(), diffuse.into());
    let attenuation = Attenuation {{ a, b, c }};
    let point_light = PointLight {{ position, diffuse, attenuation }};
    Light {{ point_light, specular: specular.into() }}
}}

/// The scene: what there is to see, and the light to see it in.
pub fn my_scene() -> Scene<Material, Light> {{
    Scene {{
        objects: vec![{objects}],
        ambient_light: DVec3::new({red:?}, {green:?}, {blue:?}),
        lights: vec![{lights}],
    }}
}}

/// The picture: your scene in the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {{
    let scene = my_scene();
    render(camera, samples, |ray| colour(&scene, ray))
}}

fn main() {{
    run(env!("CARGO_CRATE_NAME"), picture);
}}"#
    )
}

/// The attribute that allows a function to be unused, where it is.
fn dead_code_attribute(is_unused: bool) -> &'static str {
    if is_unused { "#[allow(dead_code)]\n" } else { "" }
}

/// Each item in a line of its own.
fn lines(items: impl Iterator<Item = String>) -> String {
    let lines: String =
        items.map(|item| format!("\n            {item},")).collect();
    if lines.is_empty() { lines } else { lines + "\n        " }
}

/// A call of `ball`.
fn ball_call(Object { name, sphere, material }: &Object<Material>) -> String {
    let (centre, colour) =
        (array_literal(sphere.centre), array_literal(material.matte.diffuse));
    let (r_s, n) = (material.specular.x, material.shininess);
    format!("ball({name:?}, {centre}, {:?}, {colour}, {r_s:?}, {n})", sphere.radius)
}

/// A call of `lamp`, with a line for each of its arguments.
fn lamp_call(Light { point_light, specular }: &Light) -> String {
    let Attenuation { a, b, c } = point_light.attenuation;
    let vectors =
        [point_light.position, point_light.diffuse, *specular, DVec3::new(a, b, c)];
    let lines = vectors
        .map(|vector| format!("\n                {},", array_literal(vector)));
    format!("lamp({}\n            )", lines.concat())
}

fn array_literal(vector: DVec3) -> String {
    format!("{:?}", vector.to_array())
}
