//! What is in a scene, as Rust says it.

use glam::{DVec3, dvec3};
use step05_phong::{Attenuation, Light, Material, Object};

/// How long a line is at most.
pub const WIDTH: usize = 84;

/// A field of the scene that is a list.
pub fn list(name: &str, items: impl Iterator<Item = String>) -> String {
    let items: String =
        items.map(|item| format!("            {item},\n")).collect();
    match items.is_empty() {
        true => format!("        {name}: vec![],\n"),
        false => format!("        {name}: vec![\n{items}        ],\n"),
    }
}

/// A call of `ball`.
pub fn object(Object { sphere, material }: &Object<Material>) -> String {
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

/// A call of `lamp`.
pub fn light(Light { point_light, specular }: &Light) -> String {
    let Attenuation { a, b, c } = point_light.attenuation;
    let [position, diffuse] =
        [point_light.position, point_light.diffuse].map(floats);
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

/// Three numbers.
pub fn floats(all: DVec3) -> String {
    format!("{:?}", all.to_array())
}

fn float(number: f64) -> String {
    format!("{number:?}")
}
