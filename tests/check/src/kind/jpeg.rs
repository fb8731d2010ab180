use image::{Rgb, RgbImage, imageops};

/// Says whether the picture was a JPEG once: that goes by squares of eight pixels, and
/// jumps where they meet.
pub(super) fn told(yours: &RgbImage) -> Option<String> {
    if yours.width() < 64 || yours.height() < 64 {
        return None;
    }
    let is_square = is_square(&jumps(yours))
        && is_square(&jumps(&imageops::rotate90(&imageops::flip_vertical(yours))));
    is_square.then(|| {
        "Not right yet: it was a JPEG, for it jumps after every eighth column and row, and no byte of it can \
         be trusted. Save it as PNG from the start."
            .to_owned()
    })
}

/// Whether every eighth column begins with a jump, and the others do not.
fn is_square([first, second, others @ .., last]: &[f64; 8]) -> bool {
    let is_small = |jump: &f64| jump.abs() < 0.65 * first;
    0.25 < *first && second.max(*last) < -0.08 && others.iter().all(is_small)
}

/// How much more a column differs from the one before it than the columns around do,
/// for the first of every eight columns, the second, and so on.
fn jumps(picture: &RgbImage) -> [f64; 8] {
    let (mut sums, mut counts) = ([0.0; 8], [0.0; 8]);
    let far = |a: &Rgb<u8>, b: &Rgb<u8>| {
        let [red, green, blue] =
            [0, 1, 2].map(|k| f64::from(a[k]) - f64::from(b[k]));
        // An outline is no jump that counts.
        (red + 2.0 * green + blue).abs().min(24.0)
    };
    for j in 0..picture.height() {
        let at = |i: u32| picture.get_pixel(i, j);
        for i in 2..picture.width() - 1 {
            let around = far(at(i - 1), at(i - 2)) + far(at(i + 1), at(i));
            sums[i as usize % 8] += far(at(i), at(i - 1)) - 0.5 * around;
            counts[i as usize % 8] += 1.0;
        }
    }
    std::array::from_fn(|k| sums[k] / counts[k])
}
