use crate::pixel_regions::Region;
use course::{Step, camera_with_size};
use image::RgbImage;
use step01_rays::{Camera, Ray};

/// A reader's picture beside ours of the same size.
pub(crate) struct Evidence {
    /// The step that draws ours; None where an exercise does.
    pub step: Option<Step>,
    /// The camera that draws ours.
    pub camera: Camera,
    /// All pixels, in an order in which a wrong explanation soon fails: those that are
    /// wrong first, scattered.
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

    pub fn is_sky(&self) -> bool {
        self.region.object.is_none()
    }

    /// How far the channel is apart that differs most.
    pub fn largest_channel_difference(&self) -> u8 {
        (0..3).map(|k| self.yours[k].abs_diff(self.ours[k])).max().unwrap_or(0)
    }
}

impl Evidence {
    /// Compares two pictures of the same size.
    pub fn new(step: Option<Step>, yours: &RgbImage, ours: &RgbImage) -> Self {
        let (columns, rows) = ours.dimensions();
        let camera = camera_with_size(columns, rows);
        let region = Region::function_of_ray(step);
        let pixel = |(i, j): (u32, u32)| {
            let region = region(&camera.ray(i.into(), j.into()));
            let [yours, ours] = [yours, ours].map(|one| one.get_pixel(i, j).0);
            Pixel { i, j, yours, ours, region }
        };
        let (mut pixels, right): (Vec<_>, Vec<_>) =
            scattered_places(columns, rows).map(pixel).partition(Pixel::is_wrong);
        pixels.extend(right);
        Self { step, camera, pixels }
    }

    /// The pixels that are wrong.
    pub fn wrong_pixels(&self) -> &[Pixel] {
        let count = self.pixels.partition_point(Pixel::is_wrong);
        &self.pixels[..count]
    }

    /// About so many of the wrong pixels, spread over all of them.
    pub fn some_wrong_pixels(&self, count: usize) -> Vec<&Pixel> {
        let wrong = self.wrong_pixels();
        wrong.iter().step_by(wrong.len().div_ceil(count).max(1)).collect()
    }

    /// The ray of our camera through a pixel.
    pub fn our_ray(&self, pixel: &Pixel) -> Ray {
        self.camera.ray(pixel.i.into(), pixel.j.into())
    }

    /// How many of the pixels in a region are wrong, and how many there are.
    pub fn count_wrong_and_all(&self, is_in_region: impl Fn(&Pixel) -> bool) -> (usize, usize) {
        let pixels = self.pixels.iter().filter(|pixel| is_in_region(pixel));
        pixels.fold((0, 0), |(wrong, all), pixel| (wrong + usize::from(pixel.is_wrong()), all + 1))
    }
}

/// Column and row of every pixel, in an order that soon comes to each part of the picture.
pub(crate) fn scattered_places(columns: u32, rows: u32) -> impl Iterator<Item = (u32, u32)> {
    let (columns, count) = (u64::from(columns), u64::from(columns) * u64::from(rows));
    // 7919 is a prime, so that it visits every place where it divides no count.
    let stride = if count.is_multiple_of(7919) { 1 } else { 7919 };
    let place = move |n: u64| n * stride % count;
    (0..count).map(move |n| ((place(n) % columns) as u32, (place(n) / columns) as u32))
}
