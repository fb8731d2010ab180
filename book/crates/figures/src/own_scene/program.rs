//! Formats a scene as a Rust program, which the reader saves as an example of step 5. The program
//! is step 5's example `own_scene`, with some function bodies replaced.

use course::{FOV_DEGREES, OwnScene};
use glam::DVec3;
use std::iter::zip;
use std::ops::Range;
use step05_phong::{Attenuation, Light, Material, Object};

/// The example `own_scene`, which draws the scene of step 5.
const EXAMPLE: &str = include_str!("../../../../../steps/step05_phong/examples/own_scene.rs");

/// The solution of the exercise `look_at`. If the reader has moved or turned the camera, the
/// formatted program contains the body of this solution's function `look_at`.
const LOOK_AT: &str = include_str!("../../../../../steps/step01_rays/examples/look_at.rs");

/// Formats the program that draws the scene.
pub fn format_program(own_scene: &OwnScene) -> String {
    let mut program = EXAMPLE.trim_end().to_owned();
    replace_body(&mut program, "my_scene", &scene_body(own_scene));
    replace_body(&mut program, "my_camera", &camera_body(own_scene));
    if own_scene.has_shadows_and_mirrors {
        replace_body(&mut program, "picture", &picture_body_with_mirrors(own_scene));
    }
    program
}

/// The byte range in `program` of a function's body, without the braces.
///
/// # Panics
///
/// Panics if the program has no such function.
fn body_range(program: &str, function: &str) -> Range<usize> {
    let signature =
        program.find(&format!("pub fn {function}(")).expect("the program has the function");
    let start = signature + program[signature..].find("{\n").expect("a brace opens the body") + 2;
    start..start + program[start..].find("\n}").expect("a brace closes the body")
}

fn replace_body(program: &mut String, function: &str, body: &str) {
    program.replace_range(body_range(program, function), body);
}

/// The body of `my_scene`: the scene as an expression.
fn scene_body(own_scene: &OwnScene) -> String {
    let objects = indented_lines(own_scene.scene.objects.iter().map(ball_call));
    let lights = indented_lines(own_scene.scene.lights.iter().map(lamp_call));
    let ambient_light = vector_call(own_scene.scene.ambient_light);
    format!(
        "    Scene {{
        objects: vec![{objects}],
        ambient_light: {ambient_light},
        lights: vec![{lights}],
    }}"
    )
}

/// The body of `my_camera`. If the field of view isn't the default, the body sets it. If the
/// camera's position, target or roll isn't the default, the body moves the camera as `look_at`
/// does.
fn camera_body(own_scene: &OwnScene) -> String {
    let mut body = String::new();
    if own_scene.fov_degrees != FOV_DEGREES {
        let fov = format!("f64::to_radians({:?})", own_scene.fov_degrees);
        body = format!("    let camera = &Camera::new(camera.h_res, camera.v_res, {fov});\n");
    }
    let OwnScene { position, target, roll_degrees: roll, .. } = *own_scene;
    if (position, target, roll) == (DVec3::ZERO, DVec3::NEG_Z, 0.0) {
        return body + "    *camera";
    }
    let [position, target] = [position, target].map(vector_call);
    let look_at = &LOOK_AT[body_range(LOOK_AT, "look_at")];
    format!(
        "    use glam::DMat3;
{body}    let position = {position};
    let target = {target};
    let roll = f64::to_radians({roll:?});
{look_at}"
    )
}

/// The body of `picture` for a scene with shadows and mirrors. The body calls the function `colour`
/// of `mirror.rs`, and gives each ball a `k`: the fraction of the ball's colour that is a mirror
/// image.
fn picture_body_with_mirrors(own_scene: &OwnScene) -> String {
    let arms = zip(&own_scene.scene.objects, &own_scene.mirror_parts)
        .map(|(object, k)| format!("            {:?} => {k:?},\n", object.name));
    format!(
        r#"    #[path = "mirror.rs"]
    #[allow(dead_code, reason = "it is a program of its own, too")]
    mod mirror;
    use mirror::{{Mirror, OFFSET, colour}};

    let camera = my_camera(camera);
    let Scene {{ objects, ambient_light, lights }} = my_scene();
    // How much of the colour of each ball is a mirror image.
    let k = |name| match name {{
{}            _ => 0.0,
        }};
    let objects = objects.into_iter().map(|object| {{
        let material = object.material;
        object.with_material(Mirror {{ material, k: k(object.name) }})
    }});
    let scene = Scene {{ objects: objects.collect(), ambient_light, lights }};
    render(&camera, samples, |ray| colour(&scene, ray, 10, OFFSET))"#,
        arms.collect::<String>()
    )
}

/// Formats each item on its own line.
fn indented_lines(items: impl Iterator<Item = String>) -> String {
    let lines: String = items.map(|item| format!("\n            {item},")).collect();
    if lines.is_empty() { lines } else { lines + "\n        " }
}

fn ball_call(Object { name, sphere, material }: &Object<Material>) -> String {
    let (centre, colour) = (array_literal(sphere.centre), array_literal(material.matte.diffuse));
    let (radius, r_s, n) = (sphere.radius, material.specular.x, material.shininess);
    format!("ball({name:?}, {centre}, {radius:?}, {colour}, {r_s:?}, {n})")
}

/// A call to `lamp`, with each argument on its own line.
fn lamp_call(Light { point_light, specular }: &Light) -> String {
    let Attenuation { a, b, c } = point_light.attenuation;
    let vectors = [point_light.position, point_light.diffuse, *specular, DVec3::new(a, b, c)];
    let lines = vectors.map(|vector| format!("\n                {},", array_literal(vector)));
    format!("lamp({}\n            )", lines.concat())
}

fn array_literal(vector: DVec3) -> String {
    format!("{:?}", vector.to_array())
}

fn vector_call(DVec3 { x, y, z }: DVec3) -> String {
    format!("DVec3::new({x:?}, {y:?}, {z:?})")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: &str = "pub fn one() -> f64 {\n    1.0\n}\n\npub fn two() {\n    2;\n}\n";

    #[test]
    fn body_of_a_function_is_replaced() {
        assert_eq!(&PROGRAM[body_range(PROGRAM, "two")], "    2;");
        let mut program = PROGRAM.to_owned();
        replace_body(&mut program, "one", "    f64::MAX");
        assert_eq!(program, PROGRAM.replace("1.0", "f64::MAX"));
    }

    #[test]
    fn numbers_are_written_as_rust_reads_them() {
        assert_eq!(array_literal(DVec3::new(1.0, -0.5, 0.0)), "[1.0, -0.5, 0.0]");
        assert_eq!(vector_call(DVec3::X), "DVec3::new(1.0, 0.0, 0.0)");
    }

    #[test]
    fn items_have_a_line_each() {
        assert_eq!(
            indented_lines(["a", "b"].into_iter().map(str::to_owned)).trim(),
            "a,\n            b,"
        );
        assert_eq!(indented_lines([].into_iter()), "");
    }
}
