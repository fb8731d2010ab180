use super::parameters::split_parameters;
use crate::parameter::array;
use crate::pictures::step01::{self, WIDESCREEN};
use exercises::look_at::look_at;
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
    /// L_a.
    pub ambient_light: DVec3,
    /// Whether rays go on from the surfaces, for shadows and mirrors.
    pub has_mirrors: bool,
}

impl Settings {
    /// The settings of these values of all parameters.
    pub fn from_values(values: &[f64]) -> Self {
        let (settings, _, _) = split_parameters(values);
        let (camera, others) = settings.split_at(9);
        let [columns, fov_degrees, x, y, z, target @ .., roll_degrees] = array::<9>(camera);
        let [red, green, blue, mirrors] = array(others);
        Self {
            columns,
            fov_degrees,
            position: DVec3::new(x, y, z),
            target: target.into(),
            roll_degrees,
            ambient_light: DVec3::new(red, green, blue),
            has_mirrors: mirrors == 1.0,
        }
    }

    /// The camera of a picture with so many columns.
    pub fn camera(&self, columns: f64) -> Camera {
        let camera = step01::camera(self.fov_degrees, WIDESCREEN, columns);
        let roll = self.roll_degrees.to_radians();
        look_at(&camera, self.position, self.target, roll)
    }

    /// Whether the camera is elsewhere than in the five steps, or turned.
    pub fn has_moved_camera(&self) -> bool {
        let Self { position, target, roll_degrees, .. } = *self;
        (position, target, roll_degrees) != (DVec3::ZERO, DVec3::NEG_Z, 0.0)
    }
}
