//! A scene as a Rust program, which the reader saves as an example of step 5.

use crate::OwnScene;
use glam::DVec3;
use std::iter::zip;
use step05_phong::{Attenuation, Light, Material, Object};

/// The text of the exercise `look_at`.
const LOOK_AT: &str = include_str!("../../../../steps/step01_rays/examples/look_at.rs");

/// The program that draws the scene with these own.
pub fn format_scene_program(own: &OwnScene) -> String {
    let mut program = plain_program(own);
    if own.has_mirrors {
        program = apply_edits(program, &MIRROR_EDITS);
    }
    if own.has_moved_camera() {
        program = apply_edits(program, &camera_edits(own));
    }
    program
}

/// The text after these edits, each of an old part, where it is first, and a new one.
fn apply_edits(text: String, edits: &[(&str, impl AsRef<str>)]) -> String {
    edits.iter().fold(text, |text, (old, new)| text.replacen(old, new.as_ref(), 1))
}

/// The edits that shadows and mirrors ask for: `mirror.rs` draws, and a ball has its k.
const MIRROR_EDITS: [(&str, &str); 10] = [
    (
        "use glam::",
        r#"#[path = "mirror.rs"]
#[allow(dead_code, reason = "it is a program of its own, too")]
mod mirror;

use glam::"#,
    ),
    ("use step05_phong::", "use mirror::{Mirror, OFFSET, colour};\nuse step05_phong::"),
    ("    colour, render,", "    render,"),
    ("is its shininess.", "is its shininess, and\n/// `k` the part of its colour that it mirrors."),
    ("    n: i32,\n", "    n: i32,\n    k: f64,\n"),
    ("Object<Material>", "Object<Mirror>"),
    ("    Object {", "    let material = Mirror { material, k };\n    Object {"),
    ("Scene<Material, Light>", "Scene<Mirror, Light>"),
    ("in the whole Phong sum", "with shadows and mirrors"),
    ("colour(&scene, ray)", "colour(&scene, ray, 10, OFFSET)"),
];

/// The edits that a moved camera asks for: `look_at` moves it.
fn camera_edits(own: &OwnScene) -> [(&'static str, String); 4] {
    let mut items = LOOK_AT.split("\n\n");
    let function = items.find(|item| item.contains("pub fn look_at("));
    let function = function.expect("the exercise has it");
    let [position, target] = [own.position, own.target].map(vector_call);
    let call = format!(
        "    let position = {position};
    let target = {target};
    let roll = f64::to_radians({:?});
    let camera = look_at(camera, position, target, roll);
    let scene =",
        own.roll_degrees
    );
    [
        ("use glam::DVec3;", "use glam::{DMat3, DVec3};".into()),
        ("/// The picture", format!("{function}\n\n/// The picture")),
        ("    let scene =", call),
        ("render(camera", "render(&camera".into()),
    ]
}

/// The program with the camera of the five steps, and without shadows and mirrors; the
/// calls of `ball` have a k where there are mirrors.
fn plain_program(own: &OwnScene) -> String {
    let options = match own.fov_degrees {
        60.0 => String::new(),
        degrees => format!(" -- --fov {degrees}"),
    };
    let ball_attribute = dead_code_attribute(own.scene.objects.is_empty());
    let lamp_attribute = dead_code_attribute(own.scene.lights.is_empty());
    let objects = zip(&own.scene.objects, &own.mirror_parts);
    let objects =
        lines(objects.map(|(object, k)| ball_call(object, own.has_mirrors.then_some(*k))));
    let lights = lines(own.scene.lights.iter().map(lamp_call));
    let ambient_light = vector_call(own.scene.ambient_light);
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
        ambient_light: {ambient_light},
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
    let lines: String = items.map(|item| format!("\n            {item},")).collect();
    if lines.is_empty() { lines } else { lines + "\n        " }
}

/// A call of `ball`, with its k where there are mirrors.
fn ball_call(object: &Object<Material>, k: Option<f64>) -> String {
    let Object { name, sphere, material } = object;
    let (centre, colour) = (array_literal(sphere.centre), array_literal(material.matte.diffuse));
    let (radius, r_s, n) = (sphere.radius, material.specular.x, material.shininess);
    let k = k.map_or(String::new(), |k| format!(", {k:?}"));
    format!("ball({name:?}, {centre}, {radius:?}, {colour}, {r_s:?}, {n}{k})")
}

/// A call of `lamp`, with a line for each of its arguments.
fn lamp_call(Light { point_light, specular }: &Light) -> String {
    let Attenuation { a, b, c } = point_light.attenuation;
    let vectors = [point_light.position, point_light.diffuse, *specular, DVec3::new(a, b, c)];
    let lines = vectors.map(|vector| format!("\n                {},", array_literal(vector)));
    format!("lamp({}\n            )", lines.concat())
}

fn array_literal(vector: DVec3) -> String {
    format!("{:?}", vector.to_array())
}

/// A call of `DVec3::new`.
fn vector_call(DVec3 { x, y, z }: DVec3) -> String {
    format!("DVec3::new({x:?}, {y:?}, {z:?})")
}
