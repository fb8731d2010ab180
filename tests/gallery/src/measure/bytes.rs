use super::words::list;
use super::{Eye, Look, Stage, Verdict};
use crate::view::scattered;
use crate::{Parts, Step, camera, section};
use glam::DVec3;
use image::{Rgb, RgbImage};
use std::cmp::Reverse;

/// How an intensity became a byte.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve {
    /// What it does, to be read after "your bytes are".
    pub says: &'static str,
    /// From an intensity to its byte.
    pub write: fn(f64) -> u8,
    /// From a byte to the middle of the intensities that it stands for.
    pub read: fn(f64) -> f64,
}

/// How three intensities became a pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bytes {
    /// Which of red, green and blue (0 to 2) each channel of the file holds.
    pub order: [usize; 3],
    /// How each became a byte.
    pub curve: &'static Curve,
}

const fn curve(
    says: &'static str,
    write: fn(f64) -> u8,
    read: fn(f64) -> f64,
) -> Curve {
    Curve { says, write, read }
}

/// The right curve first.
static CURVES: [Curve; 18] = [
    curve("round(255 · I)", rounded, |b| b / 255.0),
    curve(
        "255 · I cut off, not rounded: they are darker by 1 where the fraction is above ½",
        |i| (255.0 * i) as u8,
        |b| (b + 0.5) / 255.0,
    ),
    curve(
        "255 · I rounded up: 1 is added before the cut, where it should be 0.5",
        |i| (255.0 * i + 1.0) as u8,
        |b| (b - 0.5) / 255.0,
    ),
    curve(
        "255 · I rounded up",
        |i| (255.0 * i).ceil() as u8,
        |b| (b - 0.5) / 255.0,
    ),
    curve(
        "255 · I − 0.5, cut off: too dark by 1",
        |i| (255.0 * i - 0.5) as u8,
        |b| (b + 1.0) / 255.0,
    ),
    curve("255.999 · I, cut off", |i| (255.999 * i) as u8, |b| (b + 0.5) / 255.999),
    curve("256 · I, cut off", |i| (256.0 * i) as u8, |b| (b + 0.5) / 256.0),
    curve("round(256 · I)", |i| (256.0 * i + 0.5) as u8, |b| b / 256.0),
    curve("round(254 · I)", |i| (254.0 * i + 0.5) as u8, |b| b / 254.0),
    curve("round(100 · I)", |i| (100.0 * i + 0.5) as u8, |b| b / 100.0),
    curve(
        "255 (I + 0.5): the 0.5 is added before the 255 is multiplied",
        |i| (255.0 * (i + 0.5)) as u8,
        |b| b / 255.0 - 0.5,
    ),
    curve(
        "gamma-encoded, I to the power of 1/2.2",
        |i| rounded(i.max(0.0).powf(1.0 / 2.2)),
        |b| (b / 255.0).powf(2.2),
    ),
    curve(
        "gamma-encoded, the square root of I",
        |i| rounded(i.max(0.0).sqrt()),
        |b| (b / 255.0).powi(2),
    ),
    curve(
        "I to the power of 2.2, gamma the wrong way round",
        |i| rounded(i.max(0.0).powf(2.2)),
        |b| (b / 255.0).powf(1.0 / 2.2),
    ),
    curve(
        "the square of I, a gamma of 2 the wrong way round",
        |i| rounded(i * i),
        |b| (b / 255.0).sqrt(),
    ),
    curve("1 − I, a negative: inverted", |i| rounded(1.0 - i), |b| 1.0 - b / 255.0),
    curve(
        "255 · I without a clamp: above 1 they wrap, counting from 255 on to 0 as if modulo 256",
        |i| (255.0 * i + 0.5) as i64 as u8,
        |b| b / 255.0,
    ),
    curve("round(I), without the 255", |i| (i + 0.5) as u8, |b| b),
];

/// In the order of the file's red, green and blue: which of I's channels each holds.
const ORDERS: [[usize; 3]; 9] = [
    [0, 1, 2],
    [2, 1, 0],
    [1, 0, 2],
    [0, 2, 1],
    [1, 2, 0],
    [2, 0, 1],
    [0, 0, 0],
    [1, 1, 1],
    [2, 2, 2],
];

fn rounded(intensity: f64) -> u8 {
    (255.0 * intensity + 0.5) as u8
}

impl Bytes {
    /// The course's.
    pub const RIGHT: Self = Self { order: ORDERS[0], curve: &CURVES[0] };

    /// Those of a picture, as far as its right pixels tell.
    pub fn of(yours: &RgbImage, step: Step) -> Self {
        let (width, height) = yours.dimensions();
        let parts = Parts::right(&camera(width, height));
        let places = scattered(yours, 1200);
        let pairs: Vec<_> = (places.into_iter())
            .map(|(i, j)| (parts.intensity(step, i, j), *yours.get_pixel(i, j)))
            .collect();
        // What is clamped anyway tells nothing, unless nearly all is.
        let is_clamped =
            |yours: &Rgb<u8>| yours.0.iter().all(|b| matches!(b, 0 | 255));
        let few = pairs.iter().filter(|(_, yours)| !is_clamped(yours)).count();
        let is_dull = few * 20 < pairs.len();
        let explains = |bytes: &Self| {
            let its =
                pairs.iter().filter(|(_, yours)| is_dull || !is_clamped(yours));
            its.filter(|(ours, yours)| bytes.write(*ours) == *yours).count()
        };
        let most = if is_dull { pairs.len() } else { few };
        let all = CURVES.iter().flat_map(|curve| {
            ORDERS.into_iter().map(move |order| Self { order, curve })
        });
        let right = explains(&Self::RIGHT);
        let best = all.map(|bytes| (explains(&bytes), bytes));
        let best = best.min_by_key(|(count, _)| Reverse(*count));
        // All is explained, or much more than by the right ones.
        let is_it = |count: usize| {
            right < count
                && (count == most || !is_dull && right + pairs.len() / 20 < count)
        };
        best.filter(|(count, _)| is_it(*count))
            .map_or(Self::RIGHT, |(_, bytes)| bytes)
    }

    /// The intensities that a pixel stands for.
    pub fn read(&self, pixel: &Rgb<u8>) -> DVec3 {
        let read = |k: usize| (self.curve.read)(f64::from(pixel[self.channel(k)]));
        DVec3::new(read(0), read(1), read(2))
    }

    /// How much the intensity changes at most from each of its bytes to the next.
    pub fn size(&self, pixel: &Rgb<u8>) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|k| {
            let byte = f64::from(pixel[self.channel(k)]);
            let read = |by: f64| (self.curve.read)((byte + by).max(0.0));
            (read(1.0) - read(0.0)).max(read(0.0) - read(-1.0)).max(1e-9)
        }))
    }

    /// The pixel of three intensities.
    pub fn write(&self, intensity: DVec3) -> Rgb<u8> {
        let mut pixel = Rgb([0; 3]);
        for (channel, k) in self.order.into_iter().enumerate() {
            pixel[channel] = (self.curve.write)(intensity[k]);
        }
        pixel
    }

    /// Whether the byte of red, green or blue (0 to 2) was clamped.
    pub fn is_clamped(&self, pixel: &Rgb<u8>, k: usize) -> bool {
        !self.order.contains(&k) || matches!(pixel[self.channel(k)], 0 | 255)
    }

    /// Whether an intensity of red, green or blue (0 to 2) gives the byte of a pixel.
    pub fn is_from(&self, pixel: &Rgb<u8>, k: usize, intensity: f64) -> bool {
        !self.order.contains(&k)
            || pixel[self.channel(k)] == (self.curve.write)(intensity)
    }

    /// The right order, and each of the curves but the right one.
    pub fn others() -> impl Iterator<Item = Self> {
        CURVES.iter().skip(1).map(|curve| Self { order: ORDERS[0], curve })
    }

    /// Which channel of the file holds red, green or blue (0 to 2); red's, if none does.
    fn channel(&self, k: usize) -> usize {
        self.order.iter().position(|held| *held == k).unwrap_or(0)
    }

    /// Whether red, green and blue are not in this order.
    pub fn is_swapped(&self) -> bool {
        self.order != ORDERS[0]
    }

    /// What is wrong with them.
    pub fn faults(&self) -> Vec<String> {
        let mut faults = vec![];
        let names = self.order.map(|k| ["red", "green", "blue"][k]);
        match self.order {
            [0, 1, 2] => {}
            [a, b, _] if a == b => faults.push(format!(
                "your picture is grey: all three bytes are those of {}",
                names[0]
            )),
            order => {
                let moved: Vec<_> = (0..3).filter(|&k| order[k] != k).collect();
                let moved: Vec<_> = moved
                    .into_iter()
                    .map(|k| ["red", "green", "blue"][k].to_owned())
                    .collect();
                faults.push(format!(
                    "{} have changed places: the file's red, green and blue hold {}, {} and {}",
                    list(&moved), names[0], names[1], names[2]
                ));
            }
        }
        if !std::ptr::eq(self.curve, &CURVES[0]) {
            faults.push(format!(
                "your bytes are {}; they should be round(255 · I)",
                self.curve.says
            ));
        }
        faults
    }
}

/// The last column or row, where it is black though the one before is not.
fn black(yours: &RgbImage) -> Option<String> {
    let (width, height) = yours.dimensions();
    let is_black = |i: u32, j: u32| yours.get_pixel(i, j).0 == [0; 3];
    let column = |i: u32| (0..height).all(|j| is_black(i, j));
    let row = |j: u32| (0..width).all(|i| is_black(i, j));
    let told = |what: &str, k: u32| {
        format!("the last {what}, {what} {k}, is black: nothing is drawn there")
    };
    if 2 < width && column(width - 1) && !column(width - 2) {
        return Some(told("column", width - 1));
    }
    let is_row = 2 < height && row(height - 1) && !row(height - 2);
    is_row.then(|| told("row", height - 1))
}

/// The stage of the sum, its bytes and their order.
pub(super) fn stage(look: &Look) -> Stage {
    let mut numbers = look.bytes.faults();
    numbers.extend(black(look.yours));
    let verdict = match numbers.is_empty() {
        true if [Eye::Right, Eye::Exact].contains(&look.eye) => Verdict::Right,
        true => Verdict::Unknown("too little else is right".to_owned()),
        false => Verdict::Wrong,
    };
    let test = Some("colour_of_a_pixel");
    Stage {
        name: "sum, bytes, order",
        verdict,
        numbers,
        section: section::BYTES,
        test,
    }
}
