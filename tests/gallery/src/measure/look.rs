use super::{Bytes, Sky};
use crate::{Parts, Step, camera};
use image::{Rgb, RgbImage};

/// A picture of a step, and what is known so far of the program that drew it.
pub(super) struct Look<'a> {
    pub yours: &'a RgbImage,
    pub step: Step,
    /// How its intensities became bytes.
    pub bytes: Bytes,
    /// What its sky tells; None where it has none.
    pub sky: Option<Sky>,
    /// Whether all of its sky is that of the right camera.
    pub is_right_camera: bool,
    /// Whether it has several rays a pixel, as its edges tell.
    pub is_smooth: bool,
    /// What draws the right picture.
    pub right: Parts,
    /// What draws this one, as far as it is known.
    pub theirs: Parts,
}

/// A pixel, and what is seen there by the parts that are known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub i: u32,
    pub j: u32,
    /// Whether the picture has the sky's colour here.
    pub is_sky: bool,
    /// Which object should be here.
    pub hit: Option<usize>,
}

impl<'a> Look<'a> {
    pub fn new(yours: &'a RgbImage, step: Step) -> Self {
        let (width, height) = yours.dimensions();
        let right = Parts::right(&camera(width, height));
        let bytes = Bytes::of(yours, step);
        let (sky, is_smooth, is_right_camera) = (None, false, false);
        let theirs = right.clone();
        let mut look = Self {
            yours,
            step,
            bytes,
            sky,
            is_right_camera,
            is_smooth,
            right,
            theirs,
        };
        look.sky = Sky::of(yours, &look.bytes);
        look.is_right_camera = look.has_right_sky();
        if let Some(sky) = look.sky.filter(|_| !look.is_right_camera) {
            look.theirs.camera.matrix = sky.matrix;
        }
        look.is_smooth = look.has_smooth_edges();
        look
    }

    /// Some 40,000 pixels, or all of them where that is not much more.
    pub fn pixels(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let (width, height) = self.yours.dimensions();
        let all = u64::from(width) * u64::from(height);
        let stride = (all / 260_000).isqrt() as usize + 1;
        let columns = move |j| (0..width).step_by(stride).map(move |i| (i, j));
        (0..height).step_by(stride).flat_map(columns)
    }

    /// Those pixels, and what is seen there.
    pub fn places(&self, parts: &Parts) -> Vec<Place> {
        let place = |(i, j)| {
            let hit = hit(parts, self.step, f64::from(i), f64::from(j));
            Place { i, j, is_sky: self.is_sky(parts, i, j), hit }
        };
        self.pixels().map(place).collect()
    }

    /// Whether a pixel has the colour that `parts` have for the sky there, or nearly.
    pub fn is_sky(&self, parts: &Parts, i: u32, j: u32) -> bool {
        near(self.yours.get_pixel(i, j), &self.sky_pixel(parts, i, j))
    }

    fn sky_pixel(&self, parts: &Parts, i: u32, j: u32) -> Rgb<u8> {
        let ray = (parts.ray)(parts.camera.ray(i.into(), j.into()));
        self.bytes.write((parts.miss)(&ray))
    }

    /// Whether what looks like the right sky is so to the last byte.
    fn has_right_sky(&self) -> bool {
        let (mut all, mut near, mut same) = (0, 0, 0);
        for (i, j) in self.pixels() {
            if hit(&self.right, self.step, i.into(), j.into()).is_none() {
                all += 1;
                let ours = self.sky_pixel(&self.right, i, j);
                let yours = self.yours.get_pixel(i, j);
                near += usize::from(self::near(yours, &ours));
                same += usize::from(*yours == ours);
            }
        }
        all < 3 * near && near - same <= near / 500
    }

    /// Whether one ray through this pixel may see something else than another.
    pub fn is_edge(&self, parts: &Parts, i: u32, j: u32) -> bool {
        let hit = |di: f64, dj: f64| {
            hit(parts, self.step, f64::from(i) + di, f64::from(j) + dj)
        };
        let middle = hit(0.0, 0.0);
        let corners = [(-0.6, -0.6), (0.6, -0.6), (-0.6, 0.6), (0.6, 0.6)];
        corners.iter().any(|&(di, dj)| hit(di, dj) != middle)
    }

    /// Whether the pixels along the outlines are mixed of two colours.
    fn has_smooth_edges(&self) -> bool {
        let (mut all, mut mixed) = (0, 0);
        for (i, j) in self.pixels().filter(|(_, j)| j % 4 == 0) {
            let is_sky = hit(&self.theirs, self.step, i.into(), j.into()).is_none();
            if is_sky && self.is_edge(&self.theirs, i, j) {
                all += 1;
                mixed += usize::from(!self.is_sky(&self.theirs, i, j));
            }
        }
        all < 4 * mixed
    }
}

/// The number of the object that `parts` see through a point of the picture.
pub(super) fn hit(parts: &Parts, step: Step, i: f64, j: f64) -> Option<usize> {
    let point = parts.seen(step, &(parts.ray)(parts.camera.ray(i, j)))?;
    let objects = parts.objects(step).iter();
    objects
        .map(|object| &object.material)
        .position(|m| std::ptr::eq(m, point.material))
}

/// Whether two pixels differ by one at most.
pub(super) fn near(a: &Rgb<u8>, b: &Rgb<u8>) -> bool {
    crate::difference::apart(a, b) <= 1
}
