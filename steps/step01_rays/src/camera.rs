use crate::Ray;
use glam::{DMat3, DVec3};

/// A pinhole camera: the slide "A Basic 3D Camera Matrix", with the slide's
/// errors corrected.
/// ```
/// let camera = step01_rays::Camera::new(3, 3, 90_f64.to_radians());
/// assert_eq!(camera.ray(1.0, 1.0).direction, glam::DVec3::NEG_Z);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// C, the centre of projection: every ray starts here.
    pub centre: DVec3,
    /// hRes, the number of columns of the picture; at least 2.
    pub h_res: u32,
    /// vRes, the number of rows of the picture; at least 1.
    pub v_res: u32,
    /// The matrix [D_u D_v V_0]. Its columns are the step to the next pixel on the
    /// right, the step to the next one down, and the direction of pixel (0, 0).
    pub matrix: DMat3,
}

impl Camera {
    /// A camera at the origin that looks along −z, with y up. Its pixels are
    /// square. `field_of_view` is θ, the angle in radians between the rays through
    /// the centres of the first and the last column. It has to be above 0 and below
    /// π.
    /// # Panics
    /// If there are fewer than two columns, or no rows.
    pub fn new(h_res: u32, v_res: u32, field_of_view: f64) -> Self {
        assert!(
            h_res >= 2 && v_res >= 1,
            "a picture has at least 2×1 pixels, not {h_res}×{v_res}"
        );
        // Half of the way from the first column to the last, at a distance of 1.
        let tan = (field_of_view / 2.0).tan();
        // The number of steps from the first column to the last, and from the first
        // row to the last.
        let (steps_right, steps_down) =
            (f64::from(h_res - 1), f64::from(v_res - 1));
        // Pixels are square, so a step down is as long as a step to the right. From
        // the middle, (0, 0, −1), half of the steps lead left to V_0, and half up.
        let d_u = DVec3::new(2.0 * tan / steps_right, 0.0, 0.0);
        let d_v = DVec3::new(0.0, -2.0 * tan / steps_right, 0.0);
        let v_0 = DVec3::new(-tan, steps_down / steps_right * tan, -1.0);
        let matrix = DMat3::from_cols(d_u, d_v, v_0);
        Self { centre: DVec3::ZERO, h_res, v_res, matrix }
    }

    /// The ray through column `i` and row `j`, V_ij = [D_u D_v V_0] (i, j, 1)ᵀ.
    /// Whole numbers give the centres of pixels, and fractions the points around
    /// them.
    pub fn ray(&self, i: f64, j: f64) -> Ray {
        Ray { start: self.centre, direction: self.matrix * DVec3::new(i, j, 1.0) }
    }
}
