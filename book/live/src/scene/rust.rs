//! A scene as the Rust that its reader saves as an example of step 5.

use super::literal::{WIDTH, floats, light, list, object};
use step05_phong::{Light, Material, Scene};

/// The program that draws the scene, with a camera of this field of view.
pub fn text(scene: &Scene<Material, Light>, degrees: f64) -> String {
    let mut helpers = String::new();
    if !scene.objects.is_empty() {
        helpers += BALL;
    }
    if !scene.lights.is_empty() {
        helpers += LAMP;
    }
    let ambient = floats(scene.ambient_light);
    let ambient = ambient.trim_matches(['[', ']']);
    let objects = list("objects", scene.objects.iter().map(object));
    let lights = list("lights", scene.lights.iter().map(light));
    let scene = format!(
        "/// The scene: what there is to see, and the light to see it in.\n\
         pub fn my_scene() -> Scene<Material, Light> {{\n    Scene {{\n{objects}        \
         ambient_light: DVec3::new({ambient}),\n{lights}    }}\n}}\n"
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
/// A ball of one colour that mirrors `r_s` of the light; `n` is its shininess.
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
/// A lamp: where it is, L_d, L_s, and a, b and c.
fn lamp(
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
