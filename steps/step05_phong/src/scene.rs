use crate::{
    AMBIENT_LIGHT, COOL_LIGHT, Light, Material, Matte, OBJECTS, Object, Scene,
    WARM_LIGHT,
};
use glam::DVec3;

/// The scene of step 4, polished. Each object gets its R_s and its shininess, and
/// each light its L_s.
pub fn scene() -> Scene<Material, Light> {
    let [red, ground, golden, blue, green, teal, white, salmon, cream] = OBJECTS;
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
        ambient_light: AMBIENT_LIGHT,
        lights: vec![
            Light { point_light: WARM_LIGHT, specular: DVec3::new(1.0, 0.9, 0.8) },
            Light { point_light: COOL_LIGHT, specular: DVec3::new(0.5, 0.7, 1.0) },
        ],
    }
}

fn polished(object: Object<DVec3>, r_s: f64, shininess: i32) -> Object<Material> {
    let matte = Matte::of(object.material);
    let specular = DVec3::splat(r_s);
    object.with_material(Material { matte, specular, shininess })
}
