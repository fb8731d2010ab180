use crate::camera_with_fov;
use crate::examples::look_at::look_at;
use glam::DVec3;
use step05_phong::Camera;

/// The settings of the picture: all that belongs to no sphere and to no light.
pub struct Settings {
    /// The columns of the picture.
    pub columns: f64,
    /// The camera's field of view, in degrees.
    pub fov_degrees: f64,
    /// The camera's position.
    pub position: DVec3,
    /// The point that the camera looks at.
    pub target: DVec3,
    /// The camera's roll, in degrees.
    pub roll_degrees: f64,
    /// Whether rays go on from the surfaces, for shadows and mirrors.
    pub has_mirrors: bool,
}

impl Default for Settings {
    /// The camera of the five steps, without shadows and mirrors.
    fn default() -> Self {
        Self {
            columns: 640.0,
            fov_degrees: 60.0,
            position: DVec3::ZERO,
            target: DVec3::NEG_Z,
            roll_degrees: 0.0,
            has_mirrors: false,
        }
    }
}

impl Settings {
    /// The camera of a picture with so many columns.
    pub fn camera(&self, columns: f64) -> Camera {
        let camera = camera_with_fov(self.fov_degrees, columns);
        let roll = self.roll_degrees.to_radians();
        look_at(&camera, self.position, self.target, roll)
    }

    /// Whether the camera is elsewhere than in the five steps, or turned.
    pub fn has_moved_camera(&self) -> bool {
        let Self { position, target, roll_degrees, .. } = *self;
        (position, target, roll_degrees) != (DVec3::ZERO, DVec3::NEG_Z, 0.0)
    }
}
