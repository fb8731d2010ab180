use crate::Locked;
use crate::place::{Place, place};
use glam::{DMat3, DVec3};
use image::RgbImage;

/// What was made of a whole picture: half a sentence after "your picture is", and where
/// to look for the reason, if that is clear.
pub(crate) struct Whole {
    /// Such as "ours upside down".
    pub text: String,
    /// Where to go back to.
    pub place: Option<Place>,
}

type Turn = fn((u32, u32), (u32, u32)) -> (u32, u32);

/// Where each place of a picture comes from in one that has `(w, h)` pixels.
const TURNS: [(&str, Turn); 8] = [
    ("as it is", |_, (i, j)| (i, j)),
    ("upside down", |(_, h), (i, j)| (i, h - 1 - j)),
    ("mirrored, left for right", |(w, _), (i, j)| (w - 1 - i, j)),
    ("turned half around", |(w, h), (i, j)| (w - 1 - i, h - 1 - j)),
    ("transposed, its rows as columns", |_, (i, j)| (j, i)),
    ("turned a quarter to the right", |(_, h), (i, j)| (j, h - 1 - i)),
    ("turned a quarter to the left", |(w, _), (i, j)| (w - 1 - j, i)),
    ("transposed and turned", |(w, h), (i, j)| (w - 1 - j, h - 1 - i)),
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
        for (swapped, order) in ORDERS {
            if let Some(beyond) = turn_explains(yours, ours, turn, order) {
                let but = match beyond {
                    0 => String::new(),
                    beyond => format!(" but for {beyond} pixels"),
                };
                let text = format!("{name} {turned}{swapped}{but}");
                let place = match turned {
                    "as it is" => place("step01_rays/rgb8.rs"),
                    _ => place("step01_rays/camera.rs"),
                };
                return Some(Whole { text, place });
            }
        }
    }
    if yours.dimensions() != ours.dimensions() {
        return None;
    }
    let told = grey(yours, ours).or_else(|| curve(yours, ours))?;
    let text = format!("{name} {told}");
    Some(Whole { text, place: place("step01_rays/rgb8.rs") })
}

/// How many pixels are not those of ours, turned and with its channels in another order;
/// None where they are more than a few, or where nothing was changed.
fn turn_explains(
    yours: &RgbImage,
    ours: &RgbImage,
    turn: Turn,
    order: [usize; 3],
) -> Option<usize> {
    let (w, h) = ours.dimensions();
    let (columns, rows) = yours.dimensions();
    let is_upright = (columns, rows) == (w, h);
    // A turn by a quarter asks for a picture of the other shape.
    let is_quarter = turn((8, 8), (1, 0)).1 != turn((8, 8), (0, 0)).1;
    let fits = if is_quarter { (columns, rows) == (h, w) } else { is_upright };
    if !fits {
        return None;
    }
    let few = yours.pixels().len() / 500;
    let differs = yours.enumerate_pixels().filter(|(i, j, pixel)| {
        let (k, l) = turn((w, h), (*i, *j));
        let from = ours.get_pixel(k, l).0;
        pixel.0 != order.map(|channel| from[channel])
    });
    let beyond = differs.take(few + 1).count();
    let is_same = order == [0, 1, 2] && turn((8, 8), (1, 2)) == (1, 2);
    (beyond <= few && !is_same).then_some(beyond)
}

/// Whether all is grey that is not in ours, and of which weights it was made.
fn grey(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    let is_grey =
        |picture: &RgbImage| picture.pixels().all(|pixel| pixel.0 == [pixel[0]; 3]);
    if !is_grey(yours) || is_grey(ours) {
        return None;
    }
    let (mut matrix, mut right) = (DMat3::ZERO, DVec3::ZERO);
    let pairs = || {
        let ours = ours.pixels().map(|pixel| DVec3::from(pixel.0.map(f64::from)));
        ours.zip(yours.pixels().map(|pixel| f64::from(pixel[0])))
    };
    for (rgb, grey) in pairs() {
        matrix += DMat3::from_cols(rgb * rgb.x, rgb * rgb.y, rgb * rgb.z);
        right += rgb * grey;
    }
    let weights = matrix.inverse() * right;
    pairs().all(|(rgb, grey)| (weights.dot(rgb) - grey).abs() < 1.5).then(|| {
        let [r, g, b] = weights.to_array().map(|one| {
            let hundredths = (100.0 * one).round() + 0.0;
            format!("{:.2}", hundredths / 100.0)
        });
        format!("in grey, of {r} red + {g} green + {b} blue").replace('-', "−")
    })
}

/// Whether each byte follows from ours alone, as where it is gamma-encoded or cut off.
fn curve(yours: &RgbImage, ours: &RgbImage) -> Option<String> {
    let mut ranges = [(255_u8, 0_u8); 256];
    for (yours, ours) in yours.as_raw().iter().zip(ours.as_raw()) {
        let (least, most) = &mut ranges[usize::from(*ours)];
        (*least, *most) = ((*least).min(*yours), (*most).max(*yours));
    }
    let known =
        || (0..=255_u8).zip(ranges).filter(|(_, (least, most))| least <= most);
    let is_curve =
        |(from, (least, most)): (u8, (u8, u8))| from == 255 || most - least < 2;
    if known().count() < 16 || !known().all(is_curve) {
        // The sky alone has few of them that are not changed.
        return None;
    }
    let is_clear = |from: u8| from == 0 || from == 255;
    let wrong =
        known().find(|(from, range)| *range != (*from, *from) && 100 <= *from);
    let all_right =
        known().all(|(from, range)| is_clear(from) || range == (from, from));
    if all_right {
        return Some(
            "but for what is brighter than 1, which is not clamped".to_owned(),
        );
    }
    let changed = known().filter(|(from, range)| *range != (*from, *from)).count();
    if 2 * changed < known().count() {
        return None;
    }
    if known()
        .all(|(from, (least, _))| from <= least.saturating_add(1) && least <= from)
    {
        return Some("with bytes that are cut off, not rounded".to_owned());
    }
    let power = |(from, (least, most)): (u8, (u8, u8))| {
        let [a, b] = [f64::from(from), f64::midpoint(least.into(), most.into())];
        (30..220).contains(&from).then(|| (b / 255.0).ln() / (a / 255.0).ln())
    };
    let powers: Vec<f64> = known().filter_map(power).collect();
    let mean = powers.iter().sum::<f64>() / powers.len() as f64;
    if !powers.is_empty()
        && powers.iter().all(|one| (one / mean - 1.0).abs() < 0.05)
    {
        let power = if mean < 1.0 {
            format!("1/{:.1}", 1.0 / mean)
        } else {
            format!("{mean:.1}")
        };
        return Some(format!("with each intensity to the power {power} (gamma)"));
    }
    let (from, (to, _)) = wrong?;
    Some(format!("with each byte changed, whatever it shows: {from} is {to}"))
}
