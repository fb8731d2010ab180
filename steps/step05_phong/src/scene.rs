use crate::{COLOURS, Light, Material, Surface};
use glam::DVec3;
use step04_diffuse::LIGHTS as POINT_LIGHTS;

/// The material of each sphere, in the order of the spheres.
pub const MATERIALS: [Material; 9] = [
    shiny(0, 0.7, 40),
    shiny(1, 0.15, 10),
    shiny(2, 0.8, 150),
    shiny(3, 0.4, 30),
    shiny(4, 0.5, 30),
    shiny(5, 0.6, 16),
    shiny(6, 0.9, 300),
    shiny(7, 0.5, 40),
    shiny(8, 0.4, 20),
];

/// The lights of step 4, and the colour of their highlights.
pub const LIGHTS: [Light; 2] = [
    Light { point: POINT_LIGHTS[0], specular: DVec3::new(1.0, 0.9, 0.8) },
    Light { point: POINT_LIGHTS[1], specular: DVec3::new(0.5, 0.7, 1.0) },
];

const fn shiny(index: usize, r_s: f64, n: i32) -> Material {
    Material {
        surface: Surface::of(COLOURS[index]),
        specular: DVec3::splat(r_s),
        shininess: n,
    }
}
