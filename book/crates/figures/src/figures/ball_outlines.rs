use crate::discriminant;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use step03_nearest::{Ray, Sphere};

/// The angle between the centres of two balls, seen from the eye, in degrees.
pub const SPACING: f64 = 20.0;

/// The angle from the centre of a ball to its outline, in degrees.
pub const HALF_ANGLE: f64 = 8.0;

/// The distance of the balls from the eye; the image plane is at 1.
const DISTANCE: f64 = 0.7;

/// The ball `k`, which is `k` times 20° off the axis.
pub fn ball(k: i32) -> Sphere {
    let phi = (SPACING * f64::from(k)).to_radians();
    let centre = DISTANCE * DVec3::new(phi.sin(), 0.0, -phi.cos());
    Sphere { centre, radius: DISTANCE * HALF_ANGLE.to_radians().sin() }
}

/// The point of the image plane on the ray to the centre of a ball.
pub fn image_of_centre(ball: &Sphere) -> DVec2 {
    (ball.centre / -ball.centre.z).truncate()
}

/// The outline of the ball `k` on the image plane: on each line from the image of the
/// centre, the point where the discriminant falls below 0.
pub fn outline(k: i32) -> Vec<DVec2> {
    let ball = ball(k);
    let centre = image_of_centre(&ball);
    let edge = |line: DVec2| {
        let [mut inside, mut outside] = [0.0, 8.0];
        for _ in 0..30 {
            let middle = (inside + outside) / 2.0;
            let direction = (centre + middle * line).extend(-1.0);
            let ray = Ray { start: DVec3::ZERO, direction };
            if discriminant(&ball, &ray) < 0.0 {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        centre + inside * line
    };
    let angles = (0..120).map(|k| TAU * f64::from(k) / 120.0);
    angles.map(|angle| edge(DVec2::from_angle(angle))).collect()
}

/// The length of an outline, sideways, and its width.
pub fn outline_size(outline: &[DVec2]) -> [f64; 2] {
    let largest = outline.iter().copied().fold(DVec2::MIN, DVec2::max);
    let smallest = outline.iter().copied().fold(DVec2::MAX, DVec2::min);
    (largest - smallest).to_array()
}
