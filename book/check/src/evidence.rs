use crate::pixel_regions::Region;
use crate::step_scene::Encode;
use crate::{Picture, Step};
use glam::DVec3;
use image::RgbImage;
use step01_rays::{Camera, Ray};

/// A reader's picture beside ours, in the rows that are compared.
pub(crate) struct Evidence<'a> {
    /// The name of our picture.
    pub name: &'a str,
    /// The step that draws it; None where an exercise does.
    pub step: Option<Step>,
    /// The reader's.
    pub yours: &'a Picture,
    /// The same rows of ours.
    pub ours: RgbImage,
    /// The camera that draws ours.
    pub camera: Camera,
    /// Function that turns intensities into bytes: `rgb8`, or the one in its place.
    pub encode: Encode,
    /// All pixels that are compared, in an order in which a wrong explanation soon fails:
    /// those that are wrong first, scattered.
    pub pixels: Vec<Pixel>,
}

/// A pixel of the reader's picture and of ours.
#[derive(Clone, Copy)]
pub(crate) struct Pixel {
    /// Column.
    pub i: u32,
    /// Row.
    pub j: u32,
    pub yours: [u8; 3],
    pub ours: [u8; 3],
    /// Region of our own scene there.
    pub region: Region,
}

impl Pixel {
    pub fn is_wrong(&self) -> bool {
        self.yours != self.ours
    }

    /// How far the channel is apart that differs most.
    pub fn largest_channel_difference(&self) -> u8 {
        (0..3).map(|k| self.yours[k].abs_diff(self.ours[k])).max().unwrap_or(0)
    }
}

impl<'a> Evidence<'a> {
    /// Compares two pictures of the same rows.
    pub fn new(
        name: &'a str,
        step: Option<Step>,
        yours: &'a Picture,
        ours: RgbImage,
        camera: Camera,
        encode: Encode,
    ) -> Self {
        let columns = u64::from(yours.size.0);
        let count = columns * yours.rows.len() as u64;
        // 7919 is a prime, so that it visits every place where it divides no count.
        let stride = if count.is_multiple_of(7919) { 1 } else { 7919 };
        let region = Region::function_of_ray(step);
        let pixel = |n: u64| {
            let place = n * stride % count;
            let (i, k) = ((place % columns) as u32, (place / columns) as u32);
            let j = yours.rows[k as usize];
            let region = region(&camera.ray(i.into(), j.into()));
            let [yours, ours] =
                [&yours.pixels, &ours].map(|one| one.get_pixel(i, k).0);
            Pixel { i, j, yours, ours, region }
        };
        let (mut pixels, right): (Vec<_>, Vec<_>) =
            (0..count).map(pixel).partition(Pixel::is_wrong);
        pixels.extend(right);
        Self { name, step, yours, ours, camera, encode, pixels }
    }

    /// The pixels that are wrong.
    pub fn wrong_pixels(&self) -> &[Pixel] {
        let count = self.pixels.partition_point(Pixel::is_wrong);
        &self.pixels[..count]
    }

    /// Whether it has the size and the rows of a locked picture.
    pub fn has_all_rows(&self) -> bool {
        self.yours.has_all_rows()
    }

    /// The ray of our camera through a pixel.
    pub fn our_ray(&self, pixel: &Pixel) -> Ray {
        self.camera.ray(pixel.i.into(), pixel.j.into())
    }

    /// The pixel that an intensity gives.
    pub fn encode(&self, intensity: DVec3) -> [u8; 3] {
        (self.encode)(intensity)
    }

    /// How many of the pixels in a region are wrong, and how many there are.
    pub fn count_wrong_and_all(
        &self,
        is_in_region: impl Fn(&Pixel) -> bool,
    ) -> (usize, usize) {
        let pixels = self.pixels.iter().filter(|pixel| is_in_region(pixel));
        pixels.fold((0, 0), |(wrong, all), pixel| {
            (wrong + usize::from(pixel.is_wrong()), all + 1)
        })
    }
}
