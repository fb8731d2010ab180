use glam::{DVec2, dvec2};

/// A map from the world, where y runs up, to a drawing.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// The place of the world's origin.
    pub origin: DVec2,
    /// The length in the drawing of one unit of each axis.
    pub scale: DVec2,
}

impl View {
    /// The place of a point of the world.
    pub fn place(&self, point: DVec2) -> DVec2 {
        self.place_xy(point.x, point.y)
    }

    /// The place of the point (x, y).
    pub fn place_xy(&self, x: f64, y: f64) -> DVec2 {
        self.origin + self.scale * dvec2(x, -y)
    }

    /// The point of the world at a place in the drawing.
    pub fn point(&self, place: DVec2) -> DVec2 {
        (place - self.origin) / self.scale * dvec2(1.0, -1.0)
    }
}

/// The angle from straight up, to the left, of the line from `centre` to `place`, in
/// degrees.
pub fn degrees_left(centre: DVec2, place: DVec2) -> f64 {
    let DVec2 { x, y } = centre - place;
    x.atan2(y).to_degrees()
}
