use crate::comparison::{Budget, scattered_places};
use crate::drawing::Drawing;
use course::largest_channel_difference;
use image::RgbImage;
use step01_rays::{Camera, mean_colour, rgb8, sub_pixel_offsets};

/// How many rays are drawn to find out whether a picture has some options; to try all, twice as
/// many.
const RAYS: u32 = 3 << 20;

/// Sentences about a picture that a drawing gives with other options: another size, field of
/// view or number of samples.
pub(crate) fn describe_other_options(
    drawing: &Drawing,
    title: &str,
    yours: &RgbImage,
) -> Option<String> {
    let (columns, rows) = yours.dimensions();
    if columns < 2 {
        return None;
    }
    let samples: Vec<_> = (1..=16).map(sub_pixel_offsets).collect();
    let budget = Budget::new(2 * RAYS);
    let mut places: Vec<_> = scattered_places((columns, rows)).take(RAYS as usize).collect();
    // First that of the locked pictures.
    for tenths in [600].into_iter().chain(10..1800) {
        let fov_degrees = f64::from(tenths) / 10.0;
        let camera = Camera::new(columns, rows, fov_degrees.to_radians());
        let largest_difference = |(i, j): (u32, u32), sub_pixel_offsets: &[(f64, f64)]| {
            let (x, y) = (f64::from(i), f64::from(j));
            let ours = rgb8(mean_colour(sub_pixel_offsets, |u, v| {
                drawing.colour(&camera.ray(x + u, y + v))
            }));
            largest_channel_difference(yours.get_pixel(i, j), &ours)
        };
        // The sky in the corner hardly depends on the samples.
        if 1 < largest_difference((0, 0), &samples[0]) {
            continue;
        }
        for (side, sub_pixel_offsets) in (1..).zip(&samples) {
            let rays = side * side;
            let compared = places.len().min((RAYS / rays) as usize);
            let is_equal = |place: &_| largest_difference(*place, sub_pixel_offsets) == 0;
            if budget.all(&mut places[..compared], rays, is_equal) {
                let all = yours.pixels().len();
                return Some(format!(
                    "As with other options: {compared} of {all} pixels were compared, and are \
                     those of {title} at {columns}×{rows} pixels, {fov_degrees}° and {side}×{side} \
                     rays per pixel.\n\
                     Ours is drawn with the default options: --width 640 --aspect 16:9 --fov 60 \
                     --samples 1."
                ));
            }
        }
    }
    None
}
