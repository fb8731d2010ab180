//! The course's cameras, and the rays through the pixels of the course's pictures.

use step01_rays::{AspectRatio, Camera, Ray};

/// The number of columns of the course's pictures.
pub const PICTURE_COLUMNS: u32 = 640;
/// The number of rows of the course's pictures.
pub const PICTURE_ROWS: u32 = 360;
/// The field of view of the course's pictures, in degrees.
pub const FOV_DEGREES: f64 = 60.0;

/// The camera that the course's pictures are taken with: 640 columns, 16:9, 60 degrees.
pub fn camera() -> Camera {
    camera_with_size(PICTURE_COLUMNS, PICTURE_ROWS)
}

/// The rays of [`camera()`], one through each pixel, row by row.
pub fn primary_rays() -> impl Iterator<Item = Ray> {
    let camera = camera();
    let pixels = (0..PICTURE_ROWS).flat_map(|j| (0..PICTURE_COLUMNS).map(move |i| (i, j)));
    pixels.map(move |(i, j)| camera.ray(i.into(), j.into()))
}

/// The course's camera with this many columns and rows. We convert 60° with `to_radians`, as the
/// steps' programs do. The constant `FRAC_PI_3` differs from the result in the last digit, so the
/// constant would give different rays.
pub fn camera_with_size(columns: u32, rows: u32) -> Camera {
    Camera::new(columns, rows, FOV_DEGREES.to_radians())
}

/// A 16:9 camera with this field of view, in degrees, and this many columns.
pub fn camera_with_fov(fov_degrees: f64, columns: u32) -> Camera {
    let aspect_ratio = AspectRatio { width: 16.0, height: 9.0 };
    Camera::new(columns, aspect_ratio.v_res(columns), fov_degrees.to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn camera_of_the_course_has_its_size_and_angle() {
        let (camera, wide) = (camera(), camera_with_fov(60.0, 640));
        assert_eq!((camera.h_res, camera.v_res), (640, 360));
        assert_eq!((camera.matrix, wide.v_res), (wide.matrix, 360));
    }

    #[test]
    fn primary_rays_go_through_the_pixels_row_by_row() {
        let directions: Vec<_> = primary_rays().map(|ray| ray.direction).collect();
        assert_eq!(directions.len(), 640 * 360);
        assert_eq!(directions[640], camera().ray(0.0, 1.0).direction);
    }
}
