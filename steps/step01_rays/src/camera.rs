use crate::Ray;
use glam::{DMat3, DVec3};

/// A pinhole camera: the slide "A Basic 3D Camera Matrix", with its slips mended.
/// ```
/// let camera = step01_rays::Camera::new(3, 3, 90_f64.to_radians());
/// assert_eq!(camera.ray(1.0, 1.0).direction, glam::DVec3::NEG_Z);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// C, the centre of projection: every ray starts here.
    pub centre: DVec3,
    /// hRes, the columns of the picture; at least 2.
    pub h_res: u32,
    /// vRes, the rows of the picture; at least 1.
    pub v_res: u32,
    /// [D_u D_v V_0]: one pixel right, one pixel down, the direction of pixel (0, 0).
    pub matrix: DMat3,
}

impl Camera {
    /// A camera at the origin that looks along −z with y up; its pixels are square.
    /// The rays through its outermost columns enclose the angle `field_of_view`, θ, in
    /// radians; 0 < θ < π. At π, the picture would be infinitely wide.
    /// # Panics
    /// If there are fewer than two columns, or no rows.
    pub fn new(h_res: u32, v_res: u32, field_of_view: f64) -> Self {
        assert!(h_res >= 2 && v_res >= 1, "{h_res}×{v_res} is not 2×1 or more");
        let tan = (field_of_view / 2.0).tan();
        let (columns, rows) = (f64::from(h_res - 1), f64::from(v_res - 1));
        let d_u = DVec3::new(2.0 * tan / columns, 0.0, 0.0);
        let d_v = DVec3::new(0.0, -2.0 * tan / columns, 0.0);
        let v_0 = DVec3::new(-tan, rows / columns * tan, -1.0);
        let matrix = DMat3::from_cols(d_u, d_v, v_0);
        Self { centre: DVec3::ZERO, h_res, v_res, matrix }
    }

    /// The ray through column `i` and row `j`, V_ij = [D_u D_v V_0] (i, j, 1)ᵀ.
    /// Whole numbers give the centres of pixels, and fractions the points around them.
    pub fn ray(&self, i: f64, j: f64) -> Ray {
        Ray { start: self.centre, direction: self.matrix * DVec3::new(i, j, 1.0) }
    }
}
