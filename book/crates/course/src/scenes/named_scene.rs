//! Generates a scene from a person's name.

use crate::GROUND;
use crate::hash::fnv_1a;
use glam::DVec3;
use step05_phong::{Light, Material, Matte, OBJECTS, Scene, scene};

/// The objects' names, in the order of `OBJECTS`. The names don't mention colours, because the
/// colours vary from scene to scene.
const NAMES: [&str; OBJECTS.len()] =
    ["ball 1", "ground", "ball 2", "ball 3", "ball 4", "ball 5", "ball 6", "ball 7", "ball 8"];

/// Generates the scene that belongs to a person's name: the course's scene or its mirror image,
/// with sizes, colours, highlights and lights chosen by a hash of the name.
///
/// Each ball is at most as large as its counterpart in the course's scene, and has the same lowest
/// point. So each ball lies inside its counterpart, and no two balls touch each other.
///
/// Whitespace around the name is ignored, and any whitespace between two words counts as one space.
/// The caller should convert the name to NFC, Unicode's composed form: in a different form, the
/// same letters have different bytes, and so give a different scene.
pub fn generate_scene(person_name: &str) -> Scene<Material, Light> {
    let person_name = person_name.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut choices = 0;
    let mut choose = |count: usize| {
        choices += 1;
        // FNV-1a does one round per byte. Four zeros at the end add four more rounds, which spread
        // the last letter across all bits.
        let bytes = [choices].into_iter().chain(person_name.bytes()).chain([0; 4]);
        (fnv_1a(bytes) >> 32) as usize % count
    };
    let mut scene = scene();
    let side = DVec3::new([1.0, -1.0][choose(2)], 1.0, 1.0);
    for (k, (object, name)) in scene.objects.iter_mut().zip(NAMES).enumerate() {
        object.name = name;
        if k == GROUND {
            continue;
        }
        object.sphere.centre *= side;
        let smaller = (choose(16) as f64 * object.sphere.radius).round();
        for length in [&mut object.sphere.centre.y, &mut object.sphere.radius] {
            *length = ((100.0 * *length).round() - smaller) / 100.0;
        }
        let colours = OBJECTS.map(|object| object.material);
        let colour = [0, 2, 3, 5, 6, 7, 8][choose(7)];
        let material = &mut object.material;
        material.matte = Matte::of(colours[colour]);
        material.specular = DVec3::splat([0.2, 0.4, 0.6, 0.8][choose(4)]);
        material.shininess = [10, 20, 40, 80, 160][choose(5)];
    }
    for light in &mut scene.lights {
        light.point_light.position *= side;
    }
    // The first light is moved in front of the balls. The second light stays behind the balls, as
    // in the course's scene.
    let positions = [[4.0, 5.0, -2.0], [3.0, 6.0, -3.0], [5.0, 4.0, -1.0], [2.0, 5.0, -4.0]];
    scene.lights[0].point_light.position = side * DVec3::from_array(positions[choose(4)]);
    let tints = [[1.0, 0.84, 0.64], [0.8, 0.9, 1.0], [1.0, 0.7, 0.8], [0.8, 1.0, 0.75]];
    scene.lights[0].point_light.diffuse = tints[choose(4)].into();
    scene
}

#[cfg(test)]
mod tests {
    use super::*;
    use step05_phong::Sphere;

    fn sphere_and_light_numbers_in_generated_scene(person_name: &str) -> Vec<f64> {
        let Scene { objects, lights, .. } = generate_scene(person_name);
        let spheres = objects.iter().flat_map(|object| {
            let centre = object.sphere.centre.to_array();
            centre.into_iter().chain([object.sphere.radius, object.material.specular.x])
        });
        spheres
            .chain(lights.iter().flat_map(|light| light.point_light.position.to_array()))
            .collect()
    }

    #[test]
    fn scene_depends_on_the_name_but_not_on_extra_whitespace() {
        let numbers = sphere_and_light_numbers_in_generated_scene("Ada Lovelace");
        assert_eq!(numbers, sphere_and_light_numbers_in_generated_scene("  Ada   Lovelace "));
        for other_name in ["Ada Lovelacf", "AdaLovelace"] {
            assert_ne!(
                numbers,
                sphere_and_light_numbers_in_generated_scene(other_name),
                "{other_name}"
            );
        }
    }

    #[test]
    fn spheres_are_inside_those_of_the_course() {
        for name in ["Ada", "Grace", "Alan", "Edsger"] {
            for (object, course) in generate_scene(name).objects.iter().zip(OBJECTS) {
                let Sphere { mut centre, radius } = object.sphere;
                // The scene may be mirrored.
                centre.x = centre.x.abs() * course.sphere.centre.x.signum();
                let distance = centre.distance(course.sphere.centre);
                assert!(
                    distance + radius <= course.sphere.radius + 0.01,
                    "{name}, {}",
                    object.name
                );
            }
        }
    }
}
