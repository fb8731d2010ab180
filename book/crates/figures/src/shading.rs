//! The shading of solid balls in a drawing.

use glam::{DVec2, DVec3};
use step04_diffuse::{
    AMBIENT_LIGHT, Matte, OBJECTS, Object, PointLight, Ray, Scene, Sphere, WARM_LIGHT, colour, rgb8,
};

/// The direction to the light. The x axis points to the right, the y axis upwards, and the z axis
/// out of the page. The light comes from over the reader's left shoulder, as the warm light does
/// for the red sphere in the picture of step 4.
pub const TO_LIGHT: DVec3 = DVec3::new(-3.35, 5.16, 5.4);

/// The distance from a ball to the light, in radii of the ball.
const LIGHT_DISTANCE: f64 = 8.0;

/// The number of steps from the first colour of the gradient to the last.
const STEPS: u32 = 6;

/// A radial gradient that shades the balls in a drawing. All balls that are seen from the same side
/// share a gradient. The gradient has the colours that step 4 computes for a teal ball in the
/// scene's ambient light and warm light.
#[derive(Clone, Debug)]
pub struct Shading {
    /// The gradient's id. It must be unique on a page.
    pub id: &'static str,
    /// The brightest point of the ball: the point nearest to the light. Its coordinates are
    /// measured from the ball's centre to the right and upwards, in radii.
    brightest: DVec2,
    /// The colours at equal steps along the line from the brightest point to the opposite side of
    /// the outline.
    colours: Vec<[u8; 3]>,
}

impl Shading {
    /// The shading by a light in the direction `to_light`, with axes as in `TO_LIGHT`.
    pub fn new(id: &'static str, to_light: DVec3) -> Self {
        let brightest = to_light.normalize().truncate();
        // A ray through the outline itself might miss the ball.
        let opposite = -0.999 * brightest.normalize_or(DVec2::X);
        let scene = teal_ball(to_light);
        let colours = (0..=STEPS).map(|k| {
            ball_colour_at(&scene, brightest.lerp(opposite, f64::from(k) / f64::from(STEPS)))
        });
        Self { id, brightest, colours: colours.collect() }
    }

    /// The gradient as an SVG element. The gradient's unit of length is the diameter of the ball.
    pub fn svg(&self) -> String {
        let Self { id, brightest: DVec2 { x, y }, colours } = self;
        let stops = colours.iter().zip(0..).map(|([red, green, blue], k)| {
            let offset = f64::from(k) / f64::from(STEPS);
            let colour = format!("#{red:02x}{green:02x}{blue:02x}");
            format!(r#"<stop offset="{offset:.3}" stop-color="{colour}"></stop>"#)
        });
        let [cx, cy, r] = [1.0 + x, 1.0 - y, 1.0 + self.brightest.length()].map(|x| x / 2.0);
        format!(
            r#"<radialGradient id="{id}" cx="{cx:.3}" cy="{cy:.3}" r="{r:.3}">{}</radialGradient>"#,
            stops.collect::<String>()
        )
    }
}

/// A teal ball of radius 1 at the origin, in the ambient light and the warm light of step 4.
fn teal_ball(to_light: DVec3) -> Scene<Matte, PointLight> {
    let [.., teal, _, _, _] = OBJECTS;
    let sphere = Sphere { centre: DVec3::ZERO, radius: 1.0 };
    let ball = Object { sphere, ..teal.with_material(Matte::of(teal.material)) };
    let light = PointLight { position: LIGHT_DISTANCE * to_light.normalize(), ..WARM_LIGHT };
    Scene { objects: vec![ball], ambient_light: AMBIENT_LIGHT, lights: vec![light] }
}

/// The colour of the ball at a point, as seen from the front. The point's coordinates are measured
/// from the ball's centre to the right and upwards, in radii.
fn ball_colour_at(scene: &Scene<Matte, PointLight>, point: DVec2) -> [u8; 3] {
    rgb8(colour(scene, &Ray { start: point.extend(2.0), direction: DVec3::NEG_Z })).0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The gradient's colour at a point. The point's coordinates are as in [`ball_colour_at`].
    fn gradient_colour_on_ball(shading: &Shading, point: DVec2) -> [u8; 3] {
        let offset = point.distance(shading.brightest) / (1.0 + shading.brightest.length());
        let (k, fraction) = ((offset * f64::from(STEPS)) as usize, offset * f64::from(STEPS) % 1.0);
        let [start_colour, end_colour] =
            [k, (k + 1).min(STEPS as usize)].map(|k| shading.colours[k]);
        let mix = |channel: usize| {
            f64::from(start_colour[channel]) * (1.0 - fraction)
                + f64::from(end_colour[channel]) * fraction
        };
        [0, 1, 2].map(|channel| mix(channel).round() as u8)
    }

    #[test]
    fn gradient_is_nearly_the_ball_that_step_4_draws() {
        let DVec3 { x, y, z } = TO_LIGHT;
        for to_light in [TO_LIGHT, DVec3::new(x, -z, y)] {
            let (shading, scene) = (Shading::new("ball", to_light), teal_ball(to_light));
            let points = (-9..10).flat_map(|i| (-9..10).map(move |j| (f64::from(i), f64::from(j))));
            let points = points.map(|(i, j)| DVec2::new(i, j) / 10.0);
            for point in points.filter(|point| point.length() < 1.0) {
                let [drawn_colour, expected] =
                    [gradient_colour_on_ball(&shading, point), ball_colour_at(&scene, point)];
                let is_near =
                    |channel: usize| drawn_colour[channel].abs_diff(expected[channel]) <= 16;
                assert!((0..3).all(is_near), "{drawn_colour:?} at {point}, not {expected:?}");
            }
        }
    }
}
