use image::{Rgb, RgbImage};

/// The most pixels that are kept: those of a cinema's 4K picture.
const MOST: u64 = 4096 * 2160;

/// A reader's picture: all its pixels or, where these are more than a computer should
/// hold, those of every `stride`-th column in every `stride`-th row.
#[derive(Clone, Debug)]
pub(crate) struct View {
    /// The columns and rows of the whole picture.
    pub size: (u32, u32),
    /// 1 where all pixels are kept.
    pub stride: u32,
    /// Those that are kept.
    pub kept: RgbImage,
}

impl View {
    /// A black picture of this size, to be filled row by row.
    pub fn new(size: (u32, u32)) -> Self {
        let all = u64::from(size.0) * u64::from(size.1);
        let is_few = |stride: &u64| all.div_ceil(stride * stride) <= MOST;
        let stride = (1..).find(is_few).unwrap_or(1) as u32;
        let (width, height) = (size.0.div_ceil(stride), size.1.div_ceil(stride));
        Self { size, stride, kept: RgbImage::new(width, height) }
    }

    /// All pixels of a picture.
    pub fn whole(picture: RgbImage) -> Self {
        Self { size: picture.dimensions(), stride: 1, kept: picture }
    }

    /// Keeps what is to be kept of row `j`, whose pixels are `row`.
    pub fn fill(&mut self, j: u32, row: &[[u8; 3]]) {
        if j.is_multiple_of(self.stride) {
            for (i, colour) in row.iter().step_by(self.stride as usize).enumerate()
            {
                self.kept.put_pixel(i as u32, j / self.stride, Rgb(*colour));
            }
        }
    }

    /// How many pixels the whole picture has.
    pub fn pixels(&self) -> usize {
        self.size.0 as usize * self.size.1 as usize
    }

    /// The pixel in column `i` and row `j`, which must be kept.
    pub fn pixel(&self, i: u32, j: u32) -> &Rgb<u8> {
        self.kept.get_pixel(i / self.stride, j / self.stride)
    }

    /// Columns and rows of pixels that are kept, evenly over the picture.
    pub fn scattered(&self, count: u32) -> Vec<(u32, u32)> {
        let places = scattered(&self.kept, count).into_iter();
        places.map(|(i, j)| (i * self.stride, j * self.stride)).collect()
    }

    /// The colour of a picture that has one colour only, but for a few pixels.
    pub fn flat(&self) -> Option<Rgb<u8>> {
        let is_all = |colour: &Rgb<u8>| {
            let others =
                self.kept.pixels().filter(|pixel| *pixel != colour).count();
            others * 200 < self.kept.pixels().len()
        };
        let places = self.scattered(3).into_iter();
        places.map(|(i, j)| *self.pixel(i, j)).find(is_all)
    }
}

/// Places that lie evenly over a picture, whatever their number.
pub(crate) fn scattered(picture: &RgbImage, count: u32) -> Vec<(u32, u32)> {
    let (width, height) = picture.dimensions();
    // Roberts' sequence: multiples of these two numbers fill the square evenly.
    let at = |k: u32, step: f64, size: u32| {
        (((f64::from(k) + 0.5) * step).fract() * f64::from(size)) as u32
    };
    let columns = |k| at(k, 0.754_877_666_246_693, width);
    let rows = |k| at(k, 0.569_840_290_998_053, height);
    (0..count).map(|k| (columns(k), rows(k))).collect()
}
