use crate::{COOL, Light, Material, Object, Scene, Surface, WARM, objects};
use glam::DVec3;

/// The scene of step 4, polished: R_s and n for each object, L_s for each light.
pub fn scene() -> Scene<Material, Light> {
    let [red, ground, golden, blue, green, teal, white, salmon, cream] = objects();
    Scene {
        objects: vec![
            polished(red, 0.7, 40),
            polished(ground, 0.15, 10),
            polished(golden, 0.8, 150),
            polished(blue, 0.4, 30),
            polished(green, 0.5, 30),
            polished(teal, 0.6, 16),
            polished(white, 0.9, 300),
            polished(salmon, 0.5, 40),
            polished(cream, 0.4, 20),
        ],
        ambient_light: step04_diffuse::scene().ambient_light,
        lights: vec![
            Light { point: WARM, specular: DVec3::new(1.0, 0.9, 0.8) },
            Light { point: COOL, specular: DVec3::new(0.5, 0.7, 1.0) },
        ],
    }
}

fn polished(object: Object<DVec3>, r_s: f64, n: i32) -> Object<Material> {
    let surface = Surface::of(object.material);
    let specular = DVec3::splat(r_s);
    Object {
        sphere: object.sphere,
        material: Material { surface, specular, shininess: n },
    }
}
