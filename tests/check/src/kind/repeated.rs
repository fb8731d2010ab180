use image::RgbImage;

/// Says whether every pixel stands there several times, in a square.
pub(super) fn told(yours: &RgbImage) -> Option<String> {
    let (width, height) = yours.dimensions();
    let is_repeated = |k: &u32| {
        let corner = |i: u32, j: u32| yours.get_pixel(i / k * k, j / k * k);
        width % k + height % k == 0
            && yours.enumerate_pixels().all(|(i, j, pixel)| pixel == corner(i, j))
    };
    let k = (2..=16).rev().find(is_repeated)?;
    let (w, h) = (width / k, height / k);
    Some(format!(
        "Not right yet: it was scaled up. Each pixel stands there {k}×{k} times, and {w}×{h} of them were \
         drawn. Draw it with --width {width}."
    ))
}
