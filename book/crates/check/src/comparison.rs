use crate::drawing::{Drawing, LineHit};
use crate::target::Target;
use image::RgbImage;
use std::cell::Cell;
use step01_rays::{Camera, Ray};

/// A reader's picture beside ours of the same size.
pub(crate) struct Comparison<'a> {
    /// What ours is drawn of; None of an exercise.
    pub drawing: Option<&'a Drawing>,
    /// The camera that draws ours.
    pub camera: Camera,
    pub ours: &'a RgbImage,
    /// All pixels, those that are wrong first, each part scattered over the picture, so that
    /// what doesn't give them fails soon.
    pub pixels: Vec<Pixel>,
}

/// A pixel of the reader's picture and of ours.
#[derive(Clone, Copy)]
pub(crate) struct Pixel {
    /// Column and row.
    pub place: (u32, u32),
    pub yours: [u8; 3],
    pub ours: [u8; 3],
    /// The hit that ours shows, None where it shows the sky.
    pub hit: Option<LineHit>,
    /// Whether each light is on the outer side there.
    pub lit: [bool; 2],
    /// Whether a light is so that its highlight, large or small, reaches there.
    pub in_highlight: bool,
    /// Whether a channel of ours is above 1 before it becomes a byte.
    pub is_above_1: bool,
}

impl Pixel {
    pub fn is_wrong(&self) -> bool {
        self.yours != self.ours
    }

    pub fn is_sky(&self) -> bool {
        self.hit.is_none()
    }

    /// The number of the object that ours shows.
    pub fn object(&self) -> Option<usize> {
        self.hit.map(|hit| hit.object)
    }

    /// How far the channel is apart that differs most.
    pub fn largest_difference(&self) -> u8 {
        (0..3).map(|k| self.yours[k].abs_diff(self.ours[k])).max().unwrap_or(0)
    }
}

impl<'a> Comparison<'a> {
    /// Compares a picture with a target of the same size.
    pub fn new(target: &'a Target, yours: &RgbImage) -> Self {
        let pixels = target.pixels().iter().map(|pixel| {
            let yours = yours.get_pixel(pixel.place.0, pixel.place.1).0;
            Pixel { yours, ..*pixel }
        });
        let (mut pixels, right): (Vec<_>, Vec<_>) = pixels.partition(Pixel::is_wrong);
        pixels.extend(right);
        let drawing = target.drawing.as_ref();
        Self { drawing, camera: target.camera, ours: &target.picture, pixels }
    }

    /// The pixels that are wrong.
    pub fn wrong_pixels(&self) -> &[Pixel] {
        let count = self.pixels.partition_point(Pixel::is_wrong);
        &self.pixels[..count]
    }

    /// The ray of our camera through a pixel.
    pub fn ray(&self, pixel: &Pixel) -> Ray {
        self.camera.ray(pixel.place.0.into(), pixel.place.1.into())
    }

    /// Whether a function from rays gives all pixels, by a camera and our bytes.
    pub fn is_given_by(&self, colour: impl Fn(&Pixel) -> [u8; 3], budget: &RayBudget) -> bool {
        self.pixels.iter().all(|pixel| budget.spend(1) && colour(pixel) == pixel.yours)
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

/// Rays that may still be computed for an answer: the bound of its time, the same on
/// every machine.
pub(crate) struct RayBudget(Cell<u32>);

impl RayBudget {
    pub fn new(rays: u32) -> Self {
        Self(Cell::new(rays))
    }

    /// Takes so many from it; false where fewer are left.
    pub fn spend(&self, rays: u32) -> bool {
        let rays_left = self.0.get().checked_sub(rays);
        self.0.set(rays_left.unwrap_or(0));
        rays_left.is_some()
    }
}
