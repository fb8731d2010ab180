use crate::{COLOURS, Light, Material, Surface};
use glam::DVec3;
use step04_diffuse::LIGHTS as POINT_LIGHTS;

/// The material of each sphere, in the order of the spheres.
pub const MATERIALS: [Material; 9] = [
    shiny(0, 0.7, 40.0),
    shiny(1, 0.15, 10.0),
    shiny(2, 0.8, 150.0),
    shiny(3, 0.4, 30.0),
    shiny(4, 0.5, 30.0),
    shiny(5, 0.6, 16.0),
    shiny(6, 0.9, 300.0),
    shiny(7, 0.5, 40.0),
    shiny(8, 0.4, 20.0),
];

/// The lights of step 4, and the colour of their highlights.
pub const LIGHTS: [Light; 2] = [
    Light { point: POINT_LIGHTS[0], specular: DVec3::new(1.0, 0.9, 0.8) },
    Light { point: POINT_LIGHTS[1], specular: DVec3::new(0.5, 0.7, 1.0) },
];

const fn shiny(index: usize, r_s: f64, n: f64) -> Material {
    Material {
        surface: Surface::of(COLOURS[index]),
        specular: DVec3::splat(r_s),
        shininess: n,
    }
}
