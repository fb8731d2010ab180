//! Maps points in the world to positions in a drawing, and back.

use glam::{DVec2, dvec2};

/// A map from the world, where y points up, to a drawing, where y points down.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The position of the world's origin in the drawing.
    pub origin: DVec2,
    /// For each axis of the world, the length of one unit in the drawing.
    pub scale: DVec2,
}

impl View {
    /// The position at which a point in the world is drawn.
    pub fn to_drawing(self, world_point: DVec2) -> DVec2 {
        self.xy_to_drawing(world_point.x, world_point.y)
    }

    /// The position at which the point (x, y) is drawn.
    pub fn xy_to_drawing(self, x: f64, y: f64) -> DVec2 {
        self.origin + self.scale * dvec2(x, -y)
    }

    /// The point in the world that is drawn at a position.
    pub fn to_world(self, position: DVec2) -> DVec2 {
        (position - self.origin) / self.scale * dvec2(1.0, -1.0)
    }

    /// The angle between straight up and the direction from the origin to a position, in degrees.
    /// The angle is positive if the position is on the left.
    pub fn degrees_left_of_up(self, position: DVec2) -> f64 {
        let DVec2 { x, y } = self.origin - position;
        x.atan2(y).to_degrees()
    }
}

/// The unit vector in the world that points this many degrees to the left of straight up.
pub fn direction_left_of_up(degrees: f64) -> DVec2 {
    let angle = degrees.to_radians();
    dvec2(-angle.sin(), angle.cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn point_comes_back_from_the_drawing() {
        let view = View { origin: dvec2(100.0, 50.0), scale: dvec2(10.0, 20.0) };
        assert_eq!(view.xy_to_drawing(2.0, 1.0), dvec2(120.0, 30.0));
        assert_eq!(view.to_world(dvec2(120.0, 30.0)), dvec2(2.0, 1.0));
    }

    #[test]
    fn angle_is_measured_from_straight_up_to_the_left() {
        let view = View { origin: dvec2(100.0, 50.0), scale: DVec2::ONE };
        assert_eq!(view.degrees_left_of_up(dvec2(100.0, 0.0)), 0.0);
        assert_eq!(view.degrees_left_of_up(dvec2(50.0, 50.0)), 90.0);
        let position = view.to_drawing(direction_left_of_up(-30.0));
        assert!((view.degrees_left_of_up(position) + 30.0).abs() < 1e-9);
    }
}
