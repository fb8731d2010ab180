use crate::Locked;
use image::RgbImage;

/// The usual greys, as weights of red, green and blue.
const GREYS: [(&str, [f64; 3]); 6] = [
    ("0.299 red + 0.587 green + 0.114 blue", [0.299, 0.587, 0.114]),
    ("0.2126 red + 0.7152 green + 0.0722 blue", [0.2126, 0.7152, 0.0722]),
    ("the mean of red, green and blue", [1.0 / 3.0; 3]),
    ("red alone", [1.0, 0.0, 0.0]),
    ("green alone", [0.0, 1.0, 0.0]),
    ("blue alone", [0.0, 0.0, 1.0]),
];

/// Says whether the picture is grey where ours is not, and how it became so.
pub(super) fn told(yours: &RgbImage, ours: &Locked) -> Option<String> {
    if !is_grey(yours) || is_grey(&ours.picture) {
        return None;
    }
    let how = GREYS.iter().find(|(_, weights)| is_made(yours, ours, weights));
    let how = match how {
        Some((how, _)) => {
            format!(
                "each is {how} of the picture of {}. Keep all three.",
                ours.name
            )
        }
        None => "a colour needs three numbers.".to_owned(),
    };
    Some(format!(
        "Not right yet: it is grey. Red, green and blue are equal in every pixel; {how}"
    ))
}

fn is_grey(picture: &RgbImage) -> bool {
    picture.pixels().all(|pixel| pixel.0 == [pixel[0]; 3])
}

/// Whether nearly every pixel is made from ours with these weights.
fn is_made(yours: &RgbImage, ours: &Locked, weights: &[f64; 3]) -> bool {
    let is_made = |(yours, ours): &(&image::Rgb<u8>, &image::Rgb<u8>)| {
        let parts = ours.0.iter().zip(weights).map(|(c, w)| f64::from(*c) * w);
        (parts.sum::<f64>() - f64::from(yours[0])).abs() < 1.6
    };
    let pairs = || yours.pixels().zip(ours.picture.pixels());
    yours.dimensions() == ours.picture.dimensions()
        && pairs().count() < pairs().filter(is_made).count() * 100 / 99
}
