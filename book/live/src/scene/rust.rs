//! A scene as the Rust that its reader saves as an example of step 5.

use glam::{DVec3, dvec3};
use step05_phong::{Attenuation, Light, Material, Object, Scene};

/// The program that draws the scene, with a camera of this field of view.
pub fn text(scene: &Scene<Material, Light>, degrees: f64) -> String {
    let mut helpers = String::new();
    if !scene.objects.is_empty() {
        helpers += BALL;
    }
    if !scene.lights.is_empty() {
        helpers += LAMP;
    }
    let ambient = call("DVec3::new", &scene.ambient_light.to_array().map(float));
    let objects = list("objects", scene.objects.iter().map(object));
    let lights = list("lights", scene.lights.iter().map(light));
    let scene = format!(
        "/// The scene: what there is to see, and the light to see it in.\n\
         pub fn my_scene() -> Scene<Material, Light> {{\n    Scene {{\n{objects}        \
         ambient_light: {ambient},\n{lights}    }}\n}}\n"
    );
    let code = helpers + &scene + END;
    let options = match degrees {
        60.0 => String::new(),
        degrees => format!(" -- --fov {degrees}"),
    };
    format!(
        "{HEAD}{options}`\n\nuse glam::DVec3;\nuse image::RgbImage;\n{}\n{code}",
        imports(&code)
    )
}

const HEAD: &str = "//! A scene of your own. This draws it:\n\
                    //! `cargo run -p step05_phong --example my_scene";

const BALL: &str = "\
/// A ball of one colour, with R_s, the same for red, green and blue, and n.
fn ball(
    centre: [f64; 3],
    radius: f64,
    colour: [f64; 3],
    r_s: f64,
    n: i32,
) -> Object<Material> {
    let (surface, specular) = (Surface::of(colour.into()), DVec3::splat(r_s));
    let material = Material { surface, specular, shininess: n };
    Object { sphere: Sphere { centre: centre.into(), radius }, material }
}

";

const LAMP: &str = "\
/// A lamp at a position, with L_d, L_s, and a, b and c.
fn lamp(
    position: [f64; 3],
    diffuse: [f64; 3],
    specular: [f64; 3],
    [a, b, c]: [f64; 3],
) -> Light {
    let (position, diffuse) = (position.into(), diffuse.into());
    let attenuation = Attenuation { a, b, c };
    let point = PointLight { position, diffuse, attenuation };
    Light { point, specular: specular.into() }
}

";

const END: &str = "
/// The picture: your scene in the whole Phong sum.
pub fn picture(camera: &Camera, samples: u32) -> RgbImage {
    let scene = my_scene();
    render(camera, samples, |ray| colour(&scene, ray))
}

fn main() {
    run(env!(\"CARGO_CRATE_NAME\"), picture);
}";

/// What the code may have from step 5.
const NAMES: [&str; 12] = [
    "Attenuation",
    "Camera",
    "Light",
    "Material",
    "Object",
    "PointLight",
    "Scene",
    "Sphere",
    "Surface",
    "colour",
    "render",
    "run",
];

/// How long a line is at most.
const WIDTH: usize = 84;

/// The line that brings in what `code` has from step 5.
fn imports(code: &str) -> String {
    let words: Vec<_> = code.split(|c: char| !c.is_alphanumeric()).collect();
    let names = NAMES.into_iter().filter(|name| words.contains(name));
    let one = format!(
        "use step05_phong::{{{}}};\n",
        names.clone().collect::<Vec<_>>().join(", ")
    );
    if one.len() <= WIDTH + 1 {
        return one;
    }
    let mut lines = String::from("use step05_phong::{\n");
    let mut line = String::from("   ");
    for name in names {
        if WIDTH < line.len() + name.len() + 2 {
            lines += &(line + "\n");
            line = "   ".into();
        }
        line += &format!(" {name},");
    }
    lines + &line + "\n};\n"
}

/// A field of the scene that is a list.
fn list(name: &str, items: impl Iterator<Item = String>) -> String {
    let items: String =
        items.map(|item| format!("            {item},\n")).collect();
    match items.is_empty() {
        true => format!("        {name}: vec![],\n"),
        false => format!("        {name}: vec![\n{items}        ],\n"),
    }
}

fn object(Object { sphere, material }: &Object<Material>) -> String {
    let colour = material.surface.diffuse;
    call(
        "ball",
        &[
            floats(sphere.centre),
            float(sphere.radius),
            floats(colour),
            float(material.specular.x),
            material.shininess.to_string(),
        ],
    )
}

fn light(Light { point, specular }: &Light) -> String {
    let Attenuation { a, b, c } = point.attenuation;
    let [position, diffuse] = [point.position, point.diffuse].map(floats);
    call("lamp", &[position, diffuse, floats(*specular), floats(dvec3(a, b, c))])
}

/// A call in a list of the scene; its arguments have a line each where one is too
/// short for them.
fn call(name: &str, arguments: &[String]) -> String {
    let line = format!("{name}({})", arguments.join(", "));
    if line.len() + 13 <= WIDTH {
        return line;
    }
    let lines: String =
        arguments.iter().map(|one| format!("                {one},\n")).collect();
    format!("{name}(\n{lines}            )")
}

fn floats(all: DVec3) -> String {
    format!("{:?}", all.to_array())
}

fn float(number: f64) -> String {
    format!("{number:?}")
}
