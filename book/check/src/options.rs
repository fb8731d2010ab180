use crate::Step;
use crate::sky::Sky;
use image::RgbImage;
use step01_rays::Camera;

/// The field of view of the locked pictures, in degrees.
const FOV: f64 = 60.0;

/// Says so where our own step draws this very picture with other options.
pub(crate) fn options(
    step: Step,
    yours: &RgbImage,
    ours: &RgbImage,
) -> Option<String> {
    let (columns, rows) = yours.dimensions();
    let read = Sky::read(yours).map(|sky| fov(&sky, columns));
    let read = read.filter(|fov| 1.0 <= *fov);
    for fov in [Some(FOV), read].into_iter().flatten() {
        let camera = Camera::new(columns, rows, fov.to_radians());
        for samples in 1..=16 {
            let default = (fov, samples, ours.dimensions());
            if default == (FOV, 1, yours.dimensions())
                || !fits(step, yours, &camera, samples)
            {
                continue;
            }
            if step.picture(&camera, samples) == *yours {
                let name = step.name();
                return Some(format!(
                    "Right, but with other options: this is the picture of {name}, in every \
                     pixel, at {columns}×{rows} pixels, {fov}° and {samples}×{samples} rays a \
                     pixel.\nThe locked picture is drawn without options, which is --width \
                     640 --aspect 16:9 --fov 60 --samples 1. Did you give none? Then compare \
                     with camera.rs, render.rs, aspect_ratio.rs and program.rs in \
                     steps/step01_rays/src.\n"
                ));
            }
        }
    }
    None
}

/// The field of view that the sky tells, to a tenth of a degree.
fn fov(sky: &Sky, columns: u32) -> f64 {
    let tan = sky.x.x.abs() * f64::from(columns - 1) / 2.0;
    (20.0 * tan.atan().to_degrees()).round() / 10.0
}

/// Whether some rows of the picture may be those of this camera: they are soon drawn. The
/// edges of objects in them tell the numbers of rays apart.
fn fits(step: Step, yours: &RgbImage, camera: &Camera, samples: u32) -> bool {
    (2..7).all(|k| {
        let j = camera.v_res * k / 8;
        let mut row = Camera { v_res: 1, ..*camera };
        row.matrix.z_axis += f64::from(j) * row.matrix.y_axis;
        let row = step.picture(&row, samples);
        let its = (0..yours.width()).map(|i| yours.get_pixel(i, j));
        its.zip(row.pixels()).filter(|(a, b)| a != b).count() < 2
    })
}
