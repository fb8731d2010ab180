use crate::discriminant;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use step03_nearest::{Ray, Sphere};

/// The angles between two balls and, seen from the eye, across half of one, in
/// degrees.
pub const BETWEEN: f64 = 20.0;
pub const HALF: f64 = 8.0;

/// How far from the eye the balls are; the image plane is at 1.
const DISTANCE: f64 = 0.7;

/// The ball `k`, which is `k` times 20° off the axis.
pub fn ball(k: i32) -> Sphere {
    let phi = (BETWEEN * f64::from(k)).to_radians();
    let centre = DISTANCE * DVec3::new(phi.sin(), 0.0, -phi.cos());
    Sphere { centre, radius: DISTANCE * HALF.to_radians().sin() }
}

/// Where on the image plane the ray to the centre of a ball passes.
pub fn middle(ball: &Sphere) -> DVec2 {
    (ball.centre / -ball.centre.z).truncate()
}

/// The outline of a ball on the image plane: where, on the way out from its middle,
/// the discriminant falls below 0.
pub fn outline(k: i32) -> Vec<DVec2> {
    let (ball, middle) = (ball(k), middle(&ball(k)));
    let edge = |side: DVec2| {
        let [mut inside, mut outside] = [0.0, 8.0];
        for _ in 0..30 {
            let between = (inside + outside) / 2.0;
            let direction = (middle + between * side).extend(-1.0);
            let ray = Ray { start: DVec3::ZERO, direction };
            if discriminant(&ball, &ray) < 0.0 {
                outside = between;
            } else {
                inside = between;
            }
        }
        middle + inside * side
    };
    let angles = (0..120).map(|k| TAU * f64::from(k) / 120.0);
    angles.map(|angle| edge(DVec2::from_angle(angle))).collect()
}

/// How long an outline is, sideways, and how wide.
pub fn size(outline: &[DVec2]) -> [f64; 2] {
    let largest = outline.iter().copied().fold(DVec2::MIN, DVec2::max);
    let smallest = outline.iter().copied().fold(DVec2::MAX, DVec2::min);
    (largest - smallest).to_array()
}
