use crate::Locked;
use crate::place::{Place, place};
use image::RgbImage;
use image::imageops::{flip_horizontal, rotate90, rotate180, rotate270};

/// What was made of a whole picture: half a sentence after "your picture is", and where
/// to look for the reason, if that is clear.
pub(crate) struct Whole {
    /// Such as "step05_phong upside down".
    pub text: String,
    /// Where to go back to.
    pub place: Option<Place>,
}

type Turn = fn(&RgbImage) -> RgbImage;

const TURNS: [(&str, Turn); 8] = [
    ("", RgbImage::clone),
    (" upside down", |one| rotate180(&flip_horizontal(one))),
    (" mirrored, left for right", flip_horizontal),
    (" turned half around", rotate180),
    (" transposed, its rows as columns", |one| rotate270(&flip_horizontal(one))),
    (" turned a quarter to the right", rotate90),
    (" turned a quarter to the left", rotate270),
    (" transposed and turned", |one| rotate90(&flip_horizontal(one))),
];

/// The orders of red, green and blue.
const ORDERS: [(&str, [usize; 3]); 6] = [
    ("", [0, 1, 2]),
    (", with red and blue swapped", [2, 1, 0]),
    (", with red and green swapped", [1, 0, 2]),
    (", with green and blue swapped", [0, 2, 1]),
    (", with green, blue, red for red, green, blue", [1, 2, 0]),
    (", with blue, red, green for red, green, blue", [2, 0, 1]),
];

/// What was made of ours as a whole, if that explains the picture.
pub(crate) fn whole(yours: &RgbImage, ours: &Locked) -> Option<Whole> {
    let name = &ours.name;
    let first = yours.get_pixel_checked(0, 0)?;
    if yours.pixels().all(|pixel| pixel == first) {
        let [r, g, b] = first.0;
        let text = format!("one colour, ({r}, {g}, {b}), in all pixels");
        return Some(Whole { text, place: None });
    }
    let ours = &ours.picture;
    for (turned, turn) in TURNS {
        let ours = turn(ours);
        if ours.dimensions() != yours.dimensions() {
            continue;
        }
        for (swapped, order) in ORDERS {
            let few = yours.pixels().len() / 500;
            let pairs = yours.pixels().zip(ours.pixels());
            let wrong = pairs.filter(|(a, b)| a.0 != order.map(|k| b[k]));
            let beyond = wrong.take(few + 1).count();
            if beyond <= few {
                if turned.is_empty() && swapped.is_empty() {
                    // A few pixels are wrong, and nothing was made of the whole.
                    return None;
                }
                let but = match beyond {
                    0 => String::new(),
                    beyond => format!(" but for {beyond} pixels"),
                };
                let text = format!("{name}{turned}{swapped}{but}");
                let place = match turned {
                    "" => place("step01_rays/rgb8.rs"),
                    _ => place("step01_rays/camera.rs"),
                };
                return Some(Whole { text, place });
            }
        }
    }
    let is_grey =
        |picture: &RgbImage| picture.pixels().all(|pixel| pixel.0 == [pixel[0]; 3]);
    let text = match is_grey(yours) && !is_grey(ours) {
        true => "grey in every pixel".to_owned(),
        false => format!("{name} {}", curve(yours, ours)?),
    };
    Some(Whole { text, place: place("step01_rays/rgb8.rs") })
}

/// Whether each byte follows from ours alone, as where it is gamma-encoded or cut off,
/// and most of them are others.
fn curve(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    let mut ranges = [(255_u8, 0_u8); 256];
    for (yours, ours) in yours.as_raw().iter().zip(ours.as_raw()) {
        let (least, most) = &mut ranges[usize::from(*ours)];
        (*least, *most) = ((*least).min(*yours), (*most).max(*yours));
    }
    let known: Vec<_> =
        (0..=255).zip(ranges).filter(|(_, (least, most))| least <= most).collect();
    // The sky alone has few of them, and what was clamped may be anything.
    let is_curve = 16 <= known.len()
        && yours.dimensions() == ours.dimensions()
        && known.iter().all(|(from, (a, b))| *from == 255 || b - a < 2);
    let changed: Vec<_> =
        known.iter().filter(|(from, (a, b))| (*a, *b) != (*from, *from)).collect();
    if !is_curve || changed.len() < known.len().div_ceil(2) {
        return None;
    }
    let middle = |(from, _): &&&(u8, (u8, u8))| from.abs_diff(128);
    let (from, (to, _)) = changed.iter().min_by_key(middle)?;
    let power = (f64::from(*to) / 255.0).ln() / (f64::from(*from) / 255.0).ln();
    let gamma = match power {
        0.3..0.8 => format!(", as by the power 1/{:.1} (gamma)", 1.0 / power),
        1.2..3.0 => format!(", as by the power {power:.1} (gamma)"),
        _ => String::new(),
    };
    Some(format!(
        "with bytes that follow from ours, whatever they show: {from} is {to}{gamma}"
    ))
}
